//! How far a warp is from the truth, over how many words, and what its documentation says about it.

use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use support::adversary::statement::Statement;
use support::speed;

/// 2⁻³².
pub const WORD: f64 = 1.0 / 4_294_967_296.0;

/// Errors, signed: the largest magnitude, and what the root of the mean square and the mean are made of.
#[derive(Clone, Copy, Debug, Default)]
pub struct Figures {
    pub largest: f64,
    /// Where it was met.
    pub at: [u32; 2],
    squares: f64,
    sum: f64,
    count: f64,
}

impl Figures {
    /// An error that counts for all figures. What is not a number is infinitely wrong.
    pub fn observe(&mut self, error: f64, at: [u32; 2]) {
        self.observe_extreme(error, at);
        self.squares += error * error;
        self.sum += error;
        self.count += 1.0;
    }

    /// An error that counts for the largest alone, for words that are tried for their place.
    pub fn observe_extreme(&mut self, error: f64, at: [u32; 2]) {
        let size = if error.is_nan() {
            f64::INFINITY
        } else {
            error.abs()
        };
        if size > self.largest {
            (self.largest, self.at) = (size, at);
        }
    }

    pub fn join(&mut self, other: &Self) {
        self.observe_extreme(other.largest, other.at);
        self.squares += other.squares;
        self.sum += other.sum;
        self.count += other.count;
    }

    pub fn rms(&self) -> f64 {
        (self.squares / self.count).sqrt()
    }

    /// With its sign; 0 where what words have been tried decides it.
    pub fn mean(&self) -> f64 {
        let mean = self.sum / self.count;
        if mean.abs() < NONE * self.rms() {
            0.0
        } else {
            mean
        }
    }
}

/// The words at which maps change their form, and their neighbours.
fn edges() -> impl Iterator<Item = u32> {
    (0..=32)
        .flat_map(|k| {
            let power = (1_u64 << k) as u32;
            (0..256_u32).flat_map(move |d| [power.wrapping_add(d), power.wrapping_sub(d)])
        })
        .chain((0..64).flat_map(|k| {
            let cell = (k as u32) << 26;
            (0..64_u32).flat_map(move |d| [cell.wrapping_add(d), cell.wrapping_sub(d)])
        }))
}

/// Every so many words, an odd number, from 0 on, on two threads; and all words about the edges. In the quick speed
/// every 15th of those.
pub fn over_words(stride: u32, observe: impl Fn(u32, &mut dyn FnMut(f64)) + Sync) -> Figures {
    let stride = speed::of("one word tried of every", 15 * stride, stride);
    assert_eq!(stride % 2, 1, "so that all low bits occur");
    let total = Mutex::new(Figures::default());
    std::thread::scope(|scope| {
        for half in 0..2 {
            let (total, observe) = (&total, &observe);
            scope.spawn(move || {
                let mut figures = Figures::default();
                for k in (half..(1_u64 << 32) / u64::from(stride)).step_by(2) {
                    let w = (k * u64::from(stride)) as u32;
                    observe(w, &mut |error| figures.observe(error, [w, 0]));
                }
                total.lock().unwrap().join(&figures);
            });
        }
    });
    let mut total = total.into_inner().unwrap();
    for w in edges() {
        observe(w, &mut |error| total.observe_extreme(error, [w, 0]));
    }
    total
}

/// This many pairs of words, in the quick speed a 16th of them, in no step with each other; and all pairs of words next to powers of two.
pub fn over_pairs(count: u64, observe: impl Fn([u32; 2], &mut dyn FnMut(f64)) + Sync) -> Figures {
    let count = speed::of("pairs of words tried", count / 16, count);
    let total = Mutex::new(Figures::default());
    std::thread::scope(|scope| {
        for half in 0..2 {
            let (total, observe) = (&total, &observe);
            scope.spawn(move || {
                let mut figures = Figures::default();
                for k in (half..count).step_by(2) {
                    // A lattice of the plane: the plastic number's powers.
                    let pair = [0xc13f_a9a9_02a6_328f, 0x91e1_0da5_c79e_7b1d]
                        .map(|step: u64| (step.wrapping_mul(k + 1) >> 32) as u32);
                    observe(pair, &mut |error| figures.observe(error, pair));
                }
                total.lock().unwrap().join(&figures);
            });
        }
    });
    let mut total = total.into_inner().unwrap();
    let near = || {
        (0..=32).flat_map(|k| {
            let power = (1_u64 << k) as u32;
            [power.wrapping_sub(1), power, power.wrapping_add(1)]
        })
    };
    for a in near() {
        for b in near() {
            observe([a, b], &mut |error| {
                total.observe_extreme(error, [a, b]);
            });
        }
    }
    total
}

/// The stated figure is this much above what is measured, as not every input is tried, and no more than so much.
const MARGIN: f64 = 1.1;
const STALE: f64 = 1.25;
/// A mean smaller than this part of the rms is none.
const NONE: f64 = 1.0 / 128.0;

/// Two significant digits, away from 0.
fn rounded_up(x: f64) -> String {
    if x == 0.0 {
        return "0".to_owned();
    }
    let digit = 10_f64.powi(x.abs().log10().floor() as i32 - 1);
    let digits = (x.abs() / digit * (1.0 - 1e-12)).ceil();
    format!("{:.1e}", (digits * digit).copysign(x))
}

/// Whether a stated figure is one of what was measured: of its sign, no smaller, and not stale.
fn states(stated: f64, measured: f64) -> bool {
    stated.signum() * measured.signum() > 0.0
        && measured.abs() <= stated.abs()
        && stated.abs() <= STALE * measured.abs()
        || stated == 0.0 && measured == 0.0
}

fn source(file: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("src/fixed")
        .join(file)
}

/// The lines of a file, and among them those of a warp's doc comment.
fn doc_comment(file: &str, warp: &str) -> (Vec<String>, Range<usize>) {
    let text = fs::read_to_string(source(file)).unwrap();
    let lines: Vec<String> = text.lines().map(Into::into).collect();
    let end = lines
        .iter()
        .position(|l| l.starts_with(&format!("pub struct {warp}<")))
        .unwrap_or_else(|| panic!("{file} has no {warp}"));
    let start = lines[..end]
        .iter()
        .rposition(|l| !l.starts_with("///") && !l.starts_with("#["))
        .unwrap();
    (lines, start..end)
}

fn row_of(lines: &[String], mut range: Range<usize>, warp: &str, title: &str) -> usize {
    range
        .find(|&i| lines[i].starts_with(&format!("/// | {title} |")))
        .unwrap_or_else(|| panic!("{warp} states nothing of: {title}"))
}

/// The cells of a row of the form `| title | fine | coarse | compact |`.
pub fn cells(file: &str, warp: &str, title: &str) -> [String; 3] {
    let (lines, range) = doc_comment(file, warp);
    let row = lines[row_of(&lines, range, warp, title)].trim_end_matches('|');
    let cells = row.split('|').skip(2).map(|cell| cell.trim().to_owned());
    cells.collect::<Vec<_>>().try_into().expect("three cells")
}

/// Holds the rows of the table in the doc comment of a warp against what was measured on the listed sets.
///
/// A largest error is stated for all parameters and words, which the adversary attacks: here it must not be exceeded, where
/// it is a number. Rms and mean are those of the listed sets; `MICROWARP_WRITE=1` writes them anew.
pub fn hold(file: &str, warp: &str, rows: &[(&str, [f64; 3])]) {
    for (title, measured) in rows {
        println!(
            "{warp}: {title}: {}",
            measured.map(|x| format!("{x:.3e}")).join(" ")
        );
    }
    // The tests of one file may run at once.
    static FILES: Mutex<()> = Mutex::new(());
    let _one = FILES
        .lock()
        .unwrap_or_else(std::sync::PoisonError::into_inner);
    let write = std::env::var_os("MICROWARP_WRITE").is_some();
    for (title, measured) in rows {
        let largest = !title.ends_with("rms") && !title.ends_with("mean");
        if write && !largest {
            let (mut lines, range) = doc_comment(file, warp);
            let row = row_of(&lines, range, warp, title);
            let cells = measured.map(|x| rounded_up(x * MARGIN)).join(" | ");
            lines[row] = format!("/// | {title} | {cells} |");
            fs::write(source(file), lines.join("\n") + "\n").unwrap();
        }
        for (cell, measured) in cells(file, warp, title).iter().zip(measured) {
            let stated = Statement::parse(cell).unwrap_or_else(|| panic!("{warp}: {cell}"));
            let holds = match stated.number() {
                Some(stated) if largest => *measured <= stated,
                Some(stated) => states(stated, *measured),
                None => largest,
            };
            assert!(holds, "{warp}: {title}: stated {cell} for {measured:e}");
        }
    }
}

/// The three rows of a sample's figures.
pub fn sample_rows(figures: [Figures; 3]) -> [(&'static str, [f64; 3]); 3] {
    [
        ("sample, max", figures.map(|f| f.largest)),
        ("sample, rms", figures.map(|f| f.rms())),
        ("sample, mean", figures.map(|f| f.mean())),
    ]
}

#[test]
fn a_stated_figure_that_is_too_small_or_stale_or_of_the_other_sign_is_refused() {
    assert!(states(1.1e-6, 1e-6) && states(-1.1e-6, -1e-6) && states(0.0, 0.0));
    for (stated, measured) in [
        (0.9e-6, 1e-6),
        (1.3e-6, 1e-6),
        (-1.1e-6, 1e-6),
        (0.0, 1e-9),
        (1e-9, 0.0),
        (1e-6, f64::NAN),
        (1e-6, f64::INFINITY),
    ] {
        assert!(!states(stated, measured), "{stated} {measured}");
    }
    assert_eq!(rounded_up(1.01e-6), "1.1e-6");
    assert_eq!(rounded_up(-2.30e-7), "-2.3e-7");
}
