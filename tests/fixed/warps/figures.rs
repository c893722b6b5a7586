//! How far a warp is from the truth, over how many words, and what its documentation says about it.

use host::docs::{self, Doc, Row, Statement, rounded_up, states};
use host::errors::Errors;
use host::parallel::in_parallel;
use host::speed;

/// 2⁻³².
pub const WORD: f64 = 1.0 / 4_294_967_296.0;

/// The errors of a sweep, and the words at which the largest was met.
pub type Figures = Errors<[u32; 2]>;

/// A mean smaller than this part of the rms is none.
const NONE: f64 = 1.0 / 128.0;

/// The mean with its sign; 0 where what words have been tried decides it.
fn mean(errors: &Figures) -> f64 {
    let mean = errors.mean();
    if mean.abs() < NONE * errors.rms() {
        0.0
    } else {
        mean
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

/// What two threads find together, of which one takes the even and the other the odd numbers below a count.
fn by_halves(count: u64, observe: &(dyn Fn(u64, &mut Figures) + Sync)) -> Figures {
    let halves = in_parallel(2, &[0, 1], |half| {
        let mut figures = Figures::default();
        for k in (*half..count).step_by(2) {
            observe(k, &mut figures);
        }
        figures
    });
    let mut total = Figures::default();
    for half in &halves {
        total.join(half);
    }
    total
}

/// Every so many words, an odd number, from 0 on, on two threads; and all words about the edges. In the quick speed
/// every 15th of those.
pub fn over_words(stride: u32, observe: impl Fn(u32, &mut dyn FnMut(f64)) + Sync) -> Figures {
    over_words_of(stride, &observe)
}

type OfWord<'a> = &'a (dyn Fn(u32, &mut dyn FnMut(f64)) + Sync);

fn over_words_of(stride: u32, observe: OfWord) -> Figures {
    let stride = speed::of("one word tried of every", 15 * stride, stride);
    assert_eq!(stride % 2, 1, "so that all low bits occur");
    let mut total = by_halves((1_u64 << 32) / u64::from(stride), &|k, figures| {
        let w = (k * u64::from(stride)) as u32;
        observe(w, &mut |error| figures.observe([w, 0], error));
    });
    for w in edges() {
        observe(w, &mut |error| total.observe_extreme([w, 0], error));
    }
    total
}

/// This many pairs of words, in the quick speed a 16th of them, in no step with each other; and all pairs of words next to powers of two.
pub fn over_pairs(count: u64, observe: impl Fn([u32; 2], &mut dyn FnMut(f64)) + Sync) -> Figures {
    over_pairs_of(count, &observe)
}

type OfPair<'a> = &'a (dyn Fn([u32; 2], &mut dyn FnMut(f64)) + Sync);

fn over_pairs_of(count: u64, observe: OfPair) -> Figures {
    let count = speed::of("pairs of words tried", count / 16, count);
    let mut total = by_halves(count, &|k, figures| {
        // A lattice of the plane: the plastic number's powers.
        let pair = [0xc13f_a9a9_02a6_328f, 0x91e1_0da5_c79e_7b1d]
            .map(|step: u64| (step.wrapping_mul(k + 1) >> 32) as u32);
        observe(pair, &mut |error| figures.observe(pair, error));
    });
    let near = || {
        (0..=32).flat_map(|k| {
            let power = (1_u64 << k) as u32;
            [power.wrapping_sub(1), power, power.wrapping_add(1)]
        })
    };
    for a in near() {
        for b in near() {
            observe([a, b], &mut |error| {
                total.observe_extreme([a, b], error);
            });
        }
    }
    total
}

/// The stated figure is this much above what is measured, as not every input is tried.
const MARGIN: f64 = 1.1;

/// What a warp states of the three grades.
pub fn statements(warp: &str, title: &str) -> [Statement; 3] {
    let row = Doc::of("fixed", warp).row(title);
    row.unwrap_or_else(|| panic!("{warp} states nothing of: {title}"))
        .statements()
}

/// Holds the rows of the table in the doc comment of a warp against what was measured on the listed sets.
///
/// A largest error is stated for all parameters and words, which the adversary attacks: here it must not be exceeded, where
/// it is a number. Rms and mean are those of the listed sets; `MICROWARP_WRITE=1` writes them anew.
pub fn hold(warp: &str, rows: &[(&str, [f64; 3])]) {
    let largest = |title: &str| !title.ends_with("rms") && !title.ends_with("mean");
    for (title, measured) in rows {
        println!(
            "{warp}: {title}: {}",
            measured.map(|x| format!("{x:.3e}")).join(" ")
        );
    }
    if std::env::var_os("MICROWARP_WRITE").is_some() {
        let mut table = Doc::of("fixed", warp).tables().swap_remove(0);
        for row in &mut table {
            let found = rows
                .iter()
                .find(|(title, _)| *title == row.title && !largest(title));
            if let Some((title, measured)) = found {
                let cells = measured.map(|x| written(rounded_up(x * MARGIN, 2)));
                let kind = row.kind;
                *row = Row {
                    kind,
                    ..Row::new(title, cells)
                };
            }
        }
        docs::write("fixed", warp, 0, &table);
    }
    for (title, measured) in rows {
        for (cell, measured) in statements(warp, title).iter().zip(measured) {
            let holds = match cell.number() {
                Some(stated) if largest(title) => *measured <= stated,
                Some(stated) => states(stated, *measured, 0.0),
                None => largest(title),
            };
            assert!(holds, "{warp}: {title}: stated {cell:?} for {measured:e}");
        }
    }
}

/// A figure as it stands in a table.
fn written(x: f64) -> String {
    if x == 0.0 {
        "0".to_owned()
    } else {
        format!("{x:.1e}")
    }
}

/// The three rows of a sample's figures.
pub fn sample_rows(figures: [Figures; 3]) -> [(&'static str, [f64; 3]); 3] {
    [
        ("sample, max", figures.map(|f| f.max)),
        ("sample, rms", figures.map(|f| f.rms())),
        ("sample, mean", figures.each_ref().map(mean)),
    ]
}
