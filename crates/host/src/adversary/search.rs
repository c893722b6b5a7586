//! The search: fresh points, and from the worst of them chains of small steps, which cool down.
//!
//! A chain changes parameters and uniforms together, for one row. At first it takes steps to worse points as well and steps of
//! up to 2^22 numbers of `f32`, at its end hardly any and steps of a few: simulated annealing.

use super::words::{below, unit};
use super::{Case, Family, Uniforms};
use crate::docs;
use crate::errors::or_infinite;
use crate::speed;
use rand_pcg::Pcg32;
use std::time::{Duration, Instant};

/// How long a family is attacked, and from where.
#[derive(Clone, Copy, Debug)]
pub enum Budget {
    /// So many points.
    Points(u32),
    /// For so long, from a seed and from the worst cases known.
    Time(Duration, u64),
}

/// Points of about half a second. A search by so many comes within some third of the worst cases known where there are two or
/// three parameters, and of five to about half of them.
pub const USUAL: u32 = 320_000;

impl Budget {
    /// `MICROWARP_SEARCH="seconds seed"` for each family, where the seed may be left out; otherwise a quarter of
    /// the usual budget, or less in the quick speed.
    pub fn of_environment() -> Self {
        let Ok(asked) = std::env::var("MICROWARP_SEARCH") else {
            let what = "points of the search a family";
            return Self::Points(speed::of(what, USUAL / 100, USUAL / 4));
        };
        let mut words = asked.split_whitespace();
        let seconds = words.next().and_then(|s| s.parse().ok());
        let seed = words.next().map_or(Some(0), |s| s.parse().ok());
        let (Some(seconds), Some(seed)) = (seconds, seed) else {
            panic!("MICROWARP_SEARCH is seconds and perhaps a seed, not {asked:?}");
        };
        Self::Time(Duration::from_secs_f64(seconds), seed)
    }
}

/// The largest part of a bound that an error has reached, and where.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Worst {
    pub ratio: f64,
    pub error: f64,
    pub bound: f64,
    pub parameters: Vec<u32>,
    pub uniforms: Uniforms,
}

impl Worst {
    pub fn describe(&self, family: &Family) -> String {
        use super::words::Kind;
        let say = |kind: &Kind, word: &u32| match kind {
            Kind::Word => format!("{word:#010x}"),
            _ => format!("{:e}", f32::from_bits(*word)),
        };
        let list = |kinds: &[Kind], words: &[u32]| {
            let said: Vec<_> = kinds.iter().zip(words).map(|(k, w)| say(k, w)).collect();
            said.join(", ")
        };
        format!(
            "{:.4} times the bound: {:e} where {:e} is stated, at ({}) of ({})",
            self.ratio,
            self.error,
            self.bound,
            list(&family.uniforms, &self.uniforms),
            list(&family.parameters, &self.parameters),
        )
    }
}

/// Judges one point and raises the worst of each row.
pub fn raise(case: &dyn Case, parameters: &[u32], uniforms: Uniforms, worst: &mut [Worst]) -> bool {
    let mut raised = false;
    case.judge(uniforms, &mut |row, error, bound| {
        let error = or_infinite(error);
        // An error of 0 keeps a bound of 0.
        let ratio = if error == 0.0 {
            0.0
        } else {
            or_infinite(error / bound)
        };
        if ratio > worst[row].ratio {
            raised = true;
            worst[row] = Worst {
                ratio,
                error,
                bound,
                parameters: parameters.to_vec(),
                uniforms,
            };
        }
    });
    raised
}

/// How many ends of chains are kept a row, from which others start.
const ENDS: usize = 6;

/// The lengths of chains, in steps: from round to round twice as long.
const LENGTHS: [u32; 2] = [100, 12_800];

/// Nothing where the constructor refuses.
type Built = Option<Box<dyn Case>>;

struct Search<'a> {
    family: &'a Family,
    budget: Budget,
    began: Instant,
    rng: Pcg32,
    points: u32,
    worst: Vec<Worst>,
    ends: Vec<Vec<Worst>>,
    /// The last parameters and their case: that of a table takes longer to build than all else.
    built: Option<(Vec<u32>, Built)>,
}

impl Search<'_> {
    fn spent(&self) -> bool {
        match self.budget {
            Budget::Points(points) => self.points >= points,
            Budget::Time(time, _) => self.began.elapsed() >= time,
        }
    }

    /// Parameters of any kind, or of ordinary size.
    fn fresh(&mut self) -> Vec<u32> {
        let seeds = &self.family.seeds;
        if !seeds.is_empty() && below(&mut self.rng, 16) == 0 {
            return seeds[below(&mut self.rng, seeds.len() as u32) as usize].clone();
        }
        let ordinary = below(&mut self.rng, 2) == 0;
        let mut parameters: Vec<u32> = Vec::new();
        for kind in &self.family.parameters {
            let related = !parameters.is_empty() && below(&mut self.rng, 5) == 0;
            let word = if related {
                let other = parameters[below(&mut self.rng, parameters.len() as u32) as usize];
                kind.beside(other, &mut self.rng)
            } else if ordinary {
                kind.ordinary(&mut self.rng)
            } else {
                kind.draw(&mut self.rng)
            };
            parameters.push(word);
        }
        parameters
    }

    fn fresh_uniforms(&mut self) -> Uniforms {
        let mut u = [0; 4];
        for (u, kind) in u.iter_mut().zip(&self.family.uniforms) {
            *u = if below(&mut self.rng, 4) == 0 {
                kind.ordinary(&mut self.rng)
            } else {
                kind.draw(&mut self.rng)
            };
        }
        u
    }

    /// One or two words of a point, or all of them, each changed by up to 2^`far` steps.
    fn changed(&mut self, from: &Worst, far: f64) -> (Vec<u32>, Uniforms) {
        let (mut parameters, mut uniforms) = (from.parameters.clone(), from.uniforms);
        let kinds = self.family.parameters.iter().chain(&self.family.uniforms);
        let words = parameters.iter_mut().chain(&mut uniforms);
        let many = (self.family.parameters.len() + self.family.uniforms.len()) as u32;
        let all = below(&mut self.rng, 4) == 0;
        let [one, other] = [(); 2].map(|()| below(&mut self.rng, many) as usize);
        for (i, (kind, word)) in kinds.zip(words).enumerate() {
            if all || i == one || i == other && one % 2 == 0 {
                *word = kind.step(*word, far, &mut self.rng);
            }
        }
        (parameters, uniforms)
    }

    /// What a point shows of each row; nothing where its parameters are refused.
    fn judge(&mut self, parameters: &[u32], uniforms: Uniforms) -> Option<Vec<Worst>> {
        self.points = self.points.saturating_add(1);
        let known = self.built.take().filter(|(of, _)| of == parameters);
        let build = || (parameters.to_vec(), (self.family.build)(parameters));
        let (_, case) = self.built.insert(known.unwrap_or_else(build));
        let mut here = vec![Worst::default(); self.worst.len()];
        raise(case.as_deref()?, parameters, uniforms, &mut here);
        raise_each(&mut self.worst, &here);
        Some(here)
    }

    /// A chain of so many steps for one row, at first so hot and with steps so far.
    fn chain(&mut self, row: usize, start: Worst, steps: u32, [hot, far]: [f64; 2]) {
        let mut best = start.clone();
        let mut here = start;
        for step in 0..steps {
            if self.spent() {
                break;
            }
            if step % (steps / 8) == 0 {
                here = best.clone();
            }
            let left = 1.0 - f64::from(step) / f64::from(steps);
            let heat = hot * left * left + 0.001;
            let (parameters, uniforms) = self.changed(&here, 2.0 + (far - 2.0) * left);
            let Some(mut all) = self.judge(&parameters, uniforms) else {
                continue;
            };
            let next = all.swap_remove(row);
            let chance = ((next.ratio - here.ratio) / heat).exp();
            if next.ratio >= here.ratio || next.ratio > 0.0 && unit(&mut self.rng) < chance {
                here = next;
            }
            if here.ratio > best.ratio {
                best = here.clone();
            }
        }
        let ends = &mut self.ends[row];
        if !ends.contains(&best) {
            ends.push(best);
        }
        ends.sort_by(|a, b| b.ratio.total_cmp(&a.ratio));
        ends.truncate(ENDS);
    }

    /// Fresh points, then for each of the rows a chain from the worst of them and a cooler one from an end.
    fn round(&mut self, rows: &[usize], steps: u32) {
        let mut fresh = vec![Worst::default(); self.worst.len()];
        for _ in 0..steps / 2 {
            if self.spent() {
                return;
            }
            let parameters = self.fresh();
            for _ in 0..8 {
                let uniforms = self.fresh_uniforms();
                let Some(here) = self.judge(&parameters, uniforms) else {
                    break;
                };
                raise_each(&mut fresh, &here);
            }
        }
        for &row in rows {
            if fresh[row].ratio > 0.0 {
                self.chain(row, fresh[row].clone(), steps, [0.08, 22.0]);
            }
            let ends = &self.ends[row];
            if !ends.is_empty() {
                let start = ends[below(&mut self.rng, ends.len() as u32) as usize].clone();
                let far = f64::from(6 + below(&mut self.rng, 17));
                self.chain(row, start, steps / 2, [0.03, far]);
            }
        }
    }
}

fn raise_each(worst: &mut [Worst], here: &[Worst]) {
    for (worst, here) in worst.iter_mut().zip(here) {
        if here.ratio > worst.ratio {
            worst.clone_from(here);
        }
    }
}

/// The worst of each row of a family. A search by time starts from the worst cases known as well, and spends it on the rows
/// whose bounds are found.
pub fn worst(family: &Family, budget: Budget, known: &[Worst]) -> Vec<Worst> {
    let name = family
        .label
        .bytes()
        .fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
        });
    let mut rows: Vec<usize> = (0..family.rows.len()).collect();
    let mut search = Search {
        family,
        budget,
        began: Instant::now(),
        rng: Pcg32::new(name, name),
        points: 0,
        worst: vec![Worst::default(); rows.len()],
        ends: vec![Vec::new(); rows.len()],
        built: None,
    };
    if let Budget::Time(_, seed) = budget {
        search.rng = Pcg32::new(name ^ seed, name);
        rows.retain(|row| family.kinds[*row] == docs::Kind::Found);
        raise_each(&mut search.worst, known);
        for (ends, known) in search.ends.iter_mut().zip(known) {
            ends.extend((known.ratio > 0.0).then(|| known.clone()));
        }
    }
    let mut steps = LENGTHS[0];
    while !search.spent() {
        search.round(&rows, steps);
        steps = LENGTHS[1].min(2 * steps);
    }
    search.worst
}
