//! Boxes that cover all parameters and all first uniforms of a map, and what is proven of each.

use crate::inputs::in_parallel;
use crate::parametric::Form;
use crate::radii::{Bin, Radii};
use crate::range::Range;
use crate::rounding::UNIT;
use crate::tape::{Tape, Traced, each_way};
use host::errors::raise;
use host::speed;
use std::collections::BTreeMap;

/// The smallest `f32`.
const TINIEST: f64 = f32::from_bits(1) as f64;

/// A range cut up: what is above 0 and below 2^least, then each binade in so many parts.
pub fn binades(least: i32, to: f64, parts: u32) -> Vec<Range> {
    let bottom = 2.0_f64.powi(least);
    let mut cuts = vec![TINIEST, bottom];
    while cuts[cuts.len() - 1] < to {
        let last = cuts[cuts.len() - 1];
        let binade = 2.0_f64.powi(last.log2().floor() as i32);
        cuts.push((last + binade / f64::from(parts)).min(to));
    }
    let pairs = cuts.windows(2);
    pairs
        .map(|w| Range {
            low: w[0],
            high: w[1],
        })
        .collect()
}

/// What the record of one box says.
pub struct Piece {
    pub r: f64,
    /// Errors of radius and height, and of the length that both make.
    pub off: f64,
    pub height: f64,
    pub longer: f64,
    /// The error of the radius in its own units.
    pub sine: f64,
}

/// The uniform and 1 minus it, of a range of whichever is at most a half: it alone is given, and its complement is rounded
/// only if it is the larger.
pub fn complements<'a>(tape: &'a Tape, small: Range, first: bool) -> [Traced<'a>; 2] {
    use crate::number::Number;
    // A half is its own complement.
    let high = if first {
        small.high.min(0.5 - 0.5 * UNIT)
    } else {
        small.high
    };
    let x = tape.input(Range { high, ..small });
    let one = x.like(1.0);
    if first {
        [x, one - x]
    } else {
        [tape.exactly(|| one - x), x]
    }
}

/// Whether it is the uniform that is at most a half, or its complement, which is at least 2⁻²⁴: whatever may be.
pub fn given(small: Range) -> impl Iterator<Item = bool> {
    let complement = small.low >= UNIT;
    [true, false]
        .into_iter()
        .filter(move |first| *first || complement)
}

/// The fields of parameters from a box, off as the form says.
pub fn fields<'a, F: Form>(form: &F, tape: &'a Tape, parameters: &[Range]) -> Vec<Traced<'a>> {
    let exact = tape.exactly(|| {
        let inputs: Vec<_> = parameters.iter().map(|&range| tape.input(range)).collect();
        form.fields(&inputs)
    });
    let off = form.off(parameters).into_iter();
    exact
        .into_iter()
        .zip(off)
        .map(|(x, off)| x.off(off))
        .collect()
}

/// What is proven of a map of a radius and a height over the boxes. One whose errors are not below `fine` is cut in half each
/// way, up to `depth` times.
pub fn pieces<F: Form, const N: usize>(
    form: &F,
    parameters: &[[Range; N]],
    uniforms: &[Range],
    (fine, depth): (f64, u32),
) -> Vec<Piece> {
    let stride = speed::of("one range of parameters tried of every", 41, 1);
    let parameters: Vec<_> = parameters.iter().rev().step_by(stride).collect();
    let parts = in_parallel(parameters.len() as u32, |i| {
        let mut pieces = Vec::new();
        let mut boxes = Vec::new();
        for &small in uniforms {
            let given = given(small).map(|first| (*parameters[i as usize], small, first, depth));
            boxes.extend(given);
        }
        while let Some((parameter, small, first, depth)) = boxes.pop() {
            let of_box = of_box(form, &parameter, small, first);
            let is_fine = of_box.iter().all(|p| p.off.hypot(p.height) <= fine);
            if is_fine || depth == 0 {
                pieces.extend(of_box);
                continue;
            }
            for way in 0..1 << N {
                let cut = parameter.map(halves);
                let cut = std::array::from_fn(|i| cut[i][way >> i & 1]);
                boxes.extend(halves(small).map(|small| (cut, small, first, depth - 1)));
            }
        }
        pieces
    });
    parts.into_iter().flatten().collect()
}

pub fn halves(Range { low, high }: Range) -> [Range; 2] {
    let middle = 0.5 * (low + high);
    [(low, middle), (middle, high)].map(|(low, high)| Range { low, high })
}

fn of_box<F: Form>(form: &F, parameters: &[Range], small: Range, first: bool) -> Vec<Piece> {
    let mut pieces = Vec::new();
    each_way(|tape| {
        let fields = fields(form, tape, parameters);
        let uniforms = complements(tape, small, first);
        let place = form.place(&fields, &uniforms);
        if !tape.is_impossible() {
            pieces.push(piece(tape, &place));
        }
    });
    pieces
}

pub fn piece(tape: &Tape, place: &[Traced]) -> Piece {
    let [r, z] = [place[0], place[1]];
    let one = Range::only(1.0);
    let [off, height] = [r, z].map(|x| tape.error(&[(x, one)]));
    let values = [r, z].map(|x| x.value());
    // Relative, or over the ulp of the least radius there is.
    let relative = tape.relative_error(r) / UNIT;
    let ulp = 2.0_f64.powi((values[0].low / (1.0 + 1e-5)).log2().floor() as i32 - 23);
    let longer = tape.error(&[(r, values[0]), (z, values[1])]);
    assert!([off, height, longer].iter().all(|x| x.is_finite()) && !relative.is_nan());
    Piece {
        r: r.rounded().high,
        off,
        height,
        longer,
        sine: relative.min(off / ulp),
    }
}

/// Bins for the sum with an azimuth, of pieces that no other exceeds in radius and both errors.
pub fn bins(pieces: &[Piece]) -> Radii {
    let mut largest: BTreeMap<[u64; 3], Bin> = BTreeMap::new();
    for piece in pieces {
        let r = piece.r;
        let steps = [r * 64.0, piece.off / 2e-9, piece.height / 2e-9];
        let bin = Bin::argued(r, piece.off, piece.height, piece.longer);
        let entry = largest.entry(steps.map(|x| x.ceil() as u64));
        entry.and_modify(|known| known.join(&bin)).or_insert(bin);
    }
    Radii::of(largest.into_values().collect())
}

/// The same of forms of one number and no parameters.
pub fn alone<F: Form>(form: &F, numbers: &[Range]) -> Vec<Piece> {
    let mut pieces = Vec::new();
    for &range in numbers {
        each_way(|tape| {
            let x = tape.input(range);
            pieces.push(piece(tape, &form.place(&[], &[x])));
        });
    }
    pieces
}

/// The largest error of a point of two uniforms and of parameters from one box.
pub fn triangle<F: Form>(form: &F, parameters: &[Range], uniforms: &[Range]) -> f64 {
    let one = Range::only(1.0);
    let parts = in_parallel(uniforms.len() as u32, |i| {
        let mut worst = 0.0_f64;
        let a = uniforms[i as usize];
        for &b in uniforms {
            for (of_a, of_b) in given(a).flat_map(|of_a| given(b).map(move |of_b| (of_a, of_b))) {
                each_way(|tape| {
                    let [u, v] =
                        [(a, of_a), (b, of_b)].map(|(x, first)| complements(tape, x, first));
                    let uniforms: Vec<_> = u.into_iter().chain(v).collect();
                    let place = form.place(&fields(form, tape, parameters), &uniforms);
                    let errors = place.iter().map(|&x| tape.error(&[(x, one)]));
                    let error = errors.map(|e| e * e).sum::<f64>().sqrt();
                    raise(&mut worst, error);
                });
            }
        }
        worst
    });
    parts.into_iter().fold(0.0, f64::max)
}
