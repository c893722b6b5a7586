//! Repeated copies: their errors and slopes, and what theory says about both.

use crate::copy::{Errors, RECORDINGS, Recording, Run, Snapshot, errors};
use crate::theory::Theory;
use microwarp::rejection::Failure;
use rand_pcg::Pcg32;
use support::mean::Mean;
use support::slope::Fit;
use support::verdict::ALARM;

/// Slopes are fitted from here on; earlier, most pixels have been visited only a few times.
pub const FITTED_FROM: u64 = 8;
/// The counts whose copies are drawn.
pub const DRAWN: [u64; 3] = [1, 8, 256];

/// What one repetition measures after this many mutations per pixel, for each recording.
pub struct Seen {
    errors: [Errors; 4],
    acceptance: f64,
    mean: f64,
}

pub struct Study {
    /// Each pixel's share of the picture.
    pub exact: Vec<f64>,
    pub mean: f64,
    pub theory: Theory,
    /// Mutations a pixel.
    pub counts: Vec<u64>,
    /// By repetition and count.
    seen: Vec<Vec<Seen>>,
    /// Of the first repetition: the counts that are drawn.
    pub drawn: Vec<Snapshot>,
    /// For the start of each repetition: the mean brightness it estimates, and the standard error it states.
    pub starts: Vec<[f64; 2]>,
    /// How many pixels are black, and how many of their copies are not, in all correct recordings together.
    pub black: [usize; 2],
    pub nanoseconds: f64,
}

impl Study {
    pub fn new(
        luminance: &[f32],
        most: u64,
        repetitions: u64,
        seed: u64,
        mut tick: impl FnMut(),
    ) -> Result<Self, Failure> {
        let sum: f64 = luminance.iter().map(|&l| f64::from(l)).sum();
        let pixels = luminance.len() as u64;
        let mut this = Self {
            exact: luminance.iter().map(|&l| f64::from(l) / sum).collect(),
            mean: sum / pixels as f64,
            theory: Theory::of(luminance),
            counts: (0..).map(|k| 1 << k).take_while(|&n| n <= most).collect(),
            seen: Vec::new(),
            drawn: Vec::new(),
            starts: Vec::new(),
            black: [luminance.iter().filter(|&&l| l == 0.0).count(), 0],
            nanoseconds: 0.0,
        };
        let begin = std::time::Instant::now();
        for repetition in 0..repetitions {
            let mut run = Run::new(luminance, Pcg32::new(seed, repetition))?;
            let weight = f64::from(run.start.weight) / pixels as f64;
            let claimed = run.start.relative_error.map_or(f64::NAN, f64::from);
            this.starts.push([weight, claimed * weight]);
            let mut seen = Vec::new();
            for k in 0..this.counts.len() {
                let count = this.counts[k];
                run.advance_to(count * pixels);
                let snapshot = run.snapshot();
                seen.push(this.look(&snapshot));
                if repetition == 0 && DRAWN.contains(&count) {
                    this.drawn.push(snapshot);
                }
            }
            this.black[1] += this.lit(&run.snapshot());
            this.seen.push(seen);
            tick();
        }
        let steps = (repetitions * most * pixels) as f64;
        this.nanoseconds = begin.elapsed().as_secs_f64() * 1e9 / steps;
        Ok(this)
    }

    fn look(&self, snapshot: &Snapshot) -> Seen {
        Seen {
            errors: snapshot
                .shares
                .each_ref()
                .map(|shares| errors(shares, &self.exact)),
            acceptance: snapshot.acceptance,
            mean: snapshot.mean,
        }
    }

    /// Copies of black pixels that are not black.
    fn lit(&self, snapshot: &Snapshot) -> usize {
        let lit = |shares: &Vec<f64>| {
            let pairs = shares.iter().zip(&self.exact);
            pairs
                .filter(|&(&share, &p)| p == 0.0 && share != 0.0)
                .count()
        };
        snapshot.shares[..2].iter().map(lit).sum()
    }

    pub fn repetitions(&self) -> usize {
        self.seen.len()
    }

    /// A figure of all repetitions at the k-th count.
    fn at(&self, k: usize, of: impl Fn(&Seen) -> f64) -> Mean {
        Mean::of(self.seen.iter().map(|seen| of(&seen[k])))
    }

    /// Root mean square of the repetitions' RMSE.
    pub fn rmse(&self, k: usize, recording: Recording) -> f64 {
        self.at(k, |seen| seen.errors[recording as usize].rmse.powi(2))
            .mean
            .sqrt()
    }

    pub fn variation(&self, k: usize, recording: Recording) -> f64 {
        self.at(k, |seen| seen.errors[recording as usize].variation)
            .mean
    }

    pub fn acceptance(&self, k: usize) -> Mean {
        self.at(k, |seen| seen.acceptance)
    }

    pub fn normalisation(&self, k: usize) -> Mean {
        self.at(k, |seen| seen.mean)
    }

    /// The RMSE that theory expects of a recording at the k-th count, if that recording is right.
    pub fn expected(&self, k: usize, recording: Recording) -> f64 {
        let right = usize::from(recording == Recording::Weighted);
        self.theory.error[right] / (self.counts[k] as f64).sqrt()
    }

    /// The mean square error over that of theory.
    pub fn excess(&self, k: usize, recording: Recording) -> Mean {
        let expected = self.expected(k, recording).powi(2);
        self.at(k, |seen| {
            seen.errors[recording as usize].rmse.powi(2) / expected
        })
    }

    /// The mean square error of the weighted recording over that of the plain one of the same chain.
    pub fn gain(&self, k: usize) -> Mean {
        let square = |seen: &Seen, recording| seen.errors[recording as usize].rmse.powi(2);
        self.at(k, |seen| {
            square(seen, Recording::Weighted) / square(seen, Recording::Plain)
        })
    }

    /// The slopes of the repetitions.
    pub fn slope(&self, recording: Recording) -> Mean {
        Mean::of(self.seen.iter().map(|seen| {
            let points = self.counts.iter().zip(seen);
            let fitted = points.filter(|(count, _)| **count >= FITTED_FROM);
            let point = |(count, seen): (&u64, &Seen)| {
                [*count as f64, seen.errors[recording as usize].rmse]
            };
            Fit::of_logarithms(fitted.map(point)).slope
        }))
    }

    /// Whether a recording's errors agree with theory, both in size after the most mutations and in slope.
    pub fn is_right(&self, recording: Recording) -> bool {
        let last = self.counts.len() - 1;
        let drawn = self.counts.iter().position(|&count| count == DRAWN[2]);
        let as_large = drawn.into_iter().chain([last]);
        let mut p = as_large.map(|k| self.excess(k, recording).p(1.0));
        p.all(|p| p >= ALARM) && self.slope(recording).p(-0.5) >= ALARM
    }

    pub fn complaints(&self) -> Vec<String> {
        let mut complaints = Vec::new();
        let mut hold = |right: bool, what: String| {
            if !right {
                complaints.push(what);
            }
        };
        let last = self.counts.len() - 1;
        for recording in RECORDINGS {
            let (name, slope) = (recording.name(), self.slope(recording).mean);
            let excess = self.excess(last, recording).mean;
            match recording {
                Recording::Plain | Recording::Weighted => hold(
                    self.is_right(recording),
                    format!(
                        "{name}: slope {slope:.4}, {excess:.4} times the square error of theory"
                    ),
                ),
                Recording::AcceptedOnly | Recording::EveryProposal => {
                    hold(
                        !self.is_right(recording),
                        format!("{name} passes for right"),
                    );
                }
            }
        }
        let (gain, theory) = (self.gain(last), self.theory.error[1] / self.theory.error[0]);
        hold(
            gain.p(theory * theory) >= ALARM && gain.mean <= 1.0 + 6.0 * gain.error,
            format!("weighted over plain: {:.4} in square error", gain.mean),
        );
        let means = [
            ("acceptance", self.acceptance(last), self.theory.acceptance),
            (
                "mean brightness by proposals",
                self.normalisation(last),
                self.mean,
            ),
            (
                "mean brightness by starts",
                Mean::of(self.starts.iter().map(|s| s[0])),
                self.mean,
            ),
        ];
        for (what, mean, exact) in means {
            let off = mean.deviation(exact);
            hold(
                mean.p(exact) >= ALARM,
                format!("{what} off by {off:+.1} standard errors"),
            );
        }
        let [black, lit] = self.black;
        hold(
            black > 0 && lit == 0,
            format!("{lit} copies of {black} black pixels are not black"),
        );
        complaints
    }
}
