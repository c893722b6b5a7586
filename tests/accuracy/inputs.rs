//! Samples of one uniform, for all listed parameters, over all inputs there are: the whole grid, and all words where a
//! draw reads its word more deeply.
//!
//! `MICROWARP_FULL=all cargo test --test accuracy inputs::grid` tries the whole grid, in some minutes, and `inputs::words` every
//! word, in minutes for each entry and days for all; with `MICROWARP_FAMILY=Normal` those of one law. Otherwise a sample
//! of them is tried.

use crate::{GRID, STEP};
use host::docs::row_of;
use host::figures::{Exact, Figures, sample_error};
use host::parallel::{in_parallel, threads};
use host::registry::{Entry, Measure, entries};
use host::speed;

/// What is tried of an entry by one thread.
#[derive(Clone, Copy, PartialEq)]
enum Part {
    Grid,
    /// One of so many equal parts of all words.
    Words(u32),
}

const PARTS: u32 = 64;

/// The error that the documentation states for the samples of an entry; none for what is made of other warps.
fn stated(entry: &Entry) -> Option<f64> {
    let bound = row_of(entry.name.split(' ').next()?, entry.tier, "sample")?;
    let value = |name: &String| entry.variable(name).expect("a parameter of the entry");
    Some(bound.eval(&bound.names().iter().map(value).collect::<Vec<_>>()))
}

/// The largest error of a part, where each point is so many numbers of `f32` beside what is sampled.
fn worst(entry: &Entry, part: Part, beside: i32) -> f64 {
    let mut figures = Figures::default();
    let mut judge = |exact: &Exact, x: [f32; 3]| {
        let bits = x[0].to_bits().wrapping_add_signed(beside);
        sample_error(
            entry,
            exact,
            [f32::from_bits(bits), x[1], x[2]],
            &mut figures,
        );
    };
    match part {
        Part::Grid => {
            let stride = speed::or_all("one grid input of each set tried of every", 16_381, 509, 1);
            for k in (0..GRID).step_by(stride) {
                let u = [k as f32 * STEP, 0.0, 0.0, 0.0];
                judge(&Exact::of(entry, u, false), entry.warp.sample(u));
            }
        }
        Part::Words(part) => {
            let stride = speed::or_all("one word of each set tried of every", 1 << 22, 65_537, 1);
            let length = u32::MAX / PARTS + 1;
            for k in (0..length).step_by(stride) {
                let word = part * length + k;
                judge(&Exact::drawn(entry, word), entry.warp.drawn(word));
            }
        }
    }
    figures.sample
}

/// The entries of one uniform that have such parts and state an error, and by how many times the worst input exceeds it.
fn ratios(parts: &[Part], beside: i32) -> Vec<(Entry, f64)> {
    let all: Vec<(Entry, f64)> = entries()
        .into_iter()
        .filter(|entry| entry.uniforms == 1 && speed::wants(entry.name))
        .filter(|entry| entry.middle || parts == [Part::Grid])
        .filter_map(|entry| stated(&entry).map(|bound| (entry, bound)))
        .collect();
    let jobs: Vec<(usize, Part)> = (0..all.len())
        .flat_map(|i| parts.iter().map(move |&part| (i, part)))
        .collect();
    let found = in_parallel(threads(), &jobs, |&(i, part)| {
        worst(&all[i].0, part, beside) / all[i].1
    });
    let mut most = vec![0.0; all.len()];
    for ((i, _), found) in jobs.iter().zip(found) {
        host::errors::raise(&mut most[*i], found);
    }
    let entries = all.into_iter().map(|(entry, _)| entry);
    entries.zip(most).collect()
}

/// All words where a draw reads its word more deeply than to the grid.
fn words() -> Vec<Part> {
    (0..PARTS).map(Part::Words).collect()
}

fn holds(parts: &[Part]) {
    let found = ratios(parts, 0);
    for (entry, ratio) in &found {
        println!("{entry}: {ratio:.3} of what is stated");
        assert!(*ratio <= 1.0, "{entry}: {ratio} of what is stated");
    }
    assert!(found.len() > 60 || speed::is_narrowed());
}

#[test]
fn grid_inputs_do_not_exceed_what_is_stated() {
    holds(&[Part::Grid]);
}

#[test]
fn words_do_not_exceed_what_is_stated() {
    holds(&words());
}

/// Of every law that states less than seven ulp of its samples, points that lie eight numbers beside are too far off.
#[test]
fn points_beside_are_noticed() {
    let mut seen = [0, 0];
    for (parts, seen) in [vec![Part::Grid], words()].iter().zip(&mut seen) {
        for (entry, ratio) in ratios(parts, 8) {
            if matches!(entry.measure, Measure::Ulp) && stated(&entry).is_some_and(|ulp| ulp < 7.0)
            {
                assert!(ratio > 1.0, "{entry}: {ratio}");
                *seen += 1;
            }
        }
    }
    let [grid, words] = seen;
    assert!(
        (grid > 60 && words > 15) || speed::is_narrowed(),
        "{grid}, {words}"
    );
}
