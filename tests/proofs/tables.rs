//! Laws whose samples are a number times a power of 2 that comes by a table: log-normal and Pareto numbers, in both tiers.
//!
//! The bound is the sum of what each link of the chain is off by, relatively and in units of 2⁻²⁴: the number, the power's
//! table and series, and the exponent. What the exponent is off by counts in proportion to σ, or to 1/α.

use crate::inputs::in_parts;
use crate::kernels::MARGIN;
use crate::laws::by_name;
use crate::maps::Row;
use crate::powers::{log_of_uniform, log_of_word, power};
use crate::reached::reached;
use crate::report::{Line, complaint_of_half};
use crate::rounding::UNIT;
use crate::unit::{Unit, middle};
use host::adversary::words;
use host::docs::{self, Statement};
use host::errors::raise;
use host::figures::{Exact, Figures, sample_error};
use host::registry::Registered;
use host::speed;
use microwarp::uniform::LARGEST;
use rand_pcg::Pcg32;
use std::f64::consts::LN_2;

/// The largest of the numbers of inputs 0 to `last`, of which one of so many is tried.
fn largest(last: u32, stride: u32, of: impl Fn(u32) -> f64 + Sync) -> f64 {
    largest_of_two(last, stride, |i| [of(i), 0.0])[0]
}

/// The same of two numbers of each input.
fn largest_of_two(last: u32, stride: u32, of: impl Fn(u32) -> [f64; 2] + Sync) -> [f64; 2] {
    let parts = in_parts(last, stride, |most: &mut [f64; 2], i| {
        let numbers = of(i);
        raise(&mut most[0], numbers[0]);
        raise(&mut most[1], numbers[1]);
    });
    [0, 1].map(|k| parts.iter().map(|most| most[k]).fold(0.0, f64::max))
}

fn stride(quick: u32, full: u32) -> u32 {
    speed::or_all("one input of a table tried of every", quick, full, 1)
}

/// What a power is off by at most, of every cell and of every r from -0.51 to 0.51 that is a multiple of 2⁻²⁵; and in the first
/// cell of every other down to 2⁻³⁰, below which the power is 1.
fn of_powers(power: fn(usize, f32) -> f32, [each, small]: [u32; 2]) -> f64 {
    let error = |i: usize, r: f32| {
        let exact = ((i as f64 + f64::from(r)) / 64.0).exp2();
        (f64::from(power(i, r)) - exact).abs() / exact / UNIT
    };
    let reach = (0.51 * 33_554_432.0) as i32;
    let of_cells = (0..64).map(|i| {
        largest(2 * reach as u32, each, |k| {
            error(i, (k as i32 - reach) as f32 / 33_554_432.0)
        })
    });
    let least = 0.5_f32.powi(30).to_bits();
    let of_first = largest(0.5_f32.to_bits() - least, small, |k| {
        let r = f32::from_bits(least + k);
        error(0, r).max(error(0, -r))
    });
    of_cells.fold(of_first, f64::max)
}

/// What e^μ is off by at most, of every μ of which it is a normal number.
fn of_medians(of: &Registered) -> f64 {
    let error = |mean: f32| {
        // Of deviations with which neither samples nor densities overflow.
        let deviation = if mean > 0.0 { 1.0e-6 } else { 0.5 };
        let Ok(entry) = (of.build)(&[mean, deviation]) else {
            assert!(!(-88.0..88.49).contains(&mean), "{mean} is refused");
            return 0.0;
        };
        let exact = f64::from(mean).exp();
        let x = f64::from(Unit::of_entry(entry).sample(0.5));
        let normal = exact > f64::from(f32::MIN_POSITIVE);
        if normal {
            (x - exact).abs() / exact / UNIT
        } else {
            0.0
        }
    };
    // Below 2⁻³⁰ it is 1.
    let least = 0.5_f32.powi(30).to_bits();
    largest(88.5_f32.to_bits() - least, stride(40_009, 257), |k| {
        let mean = f32::from_bits(least + k);
        error(mean).max(error(-mean))
    })
}

/// The constant part of a bound, in ulp, and what is in proportion to σ or to 1/α.
#[derive(Clone, Copy, Debug)]
pub struct Parts([f64; 2]);

/// What a sum of relative errors is in ulp at most: the last product is rounded, by as much as one where it passes a power of 2,
/// and squares of errors, which are below 1e-4, count, too.
fn in_ulp(constant: f64, rising: f64) -> Parts {
    Parts([constant + 1.0 + MARGIN, rising * (1.0 + 1e-4) + MARGIN])
}

/// What exponents of log-normal numbers are off by at most in both tiers, in proportion to σ. An exponent is a rounded step times the
/// normal quantile, rounded again; of a word it is rounded twice more, since its factors are another. Of two words that are as far from
/// the median the quantile is one number, which is worked out once.
fn of_quantiles(normals: &[Unit; 2]) -> [f64; 2] {
    let link = |x: f32, exact: f64, roundings: f64| {
        (f64::from(x) - exact).abs() / UNIT + exact.abs() * (roundings + 1e-3)
    };
    let of_uniforms = largest_of_two(1.0_f32.to_bits() - 1, stride(8009, 61), |bits| {
        let u = f32::from_bits(bits);
        let samples = normals.each_ref().map(|normal| normal.sample(u));
        let exact = normals[0].exact(u.into(), samples[0]);
        samples.map(|x| link(x, exact, 2.0))
    });
    let of_words = largest_of_two(u32::MAX >> 1, stride(40_009, 257), |word| {
        let near = normals[0].drawn(word);
        let exact = normals[0].exact(middle(word), near);
        let off = |normal: &Unit| {
            let either = [normal.drawn(word), -normal.drawn(!word)];
            let [one, other] = either.map(|x| link(x, exact, 4.0));
            one.max(other)
        };
        normals.each_ref().map(off)
    });
    [0, 1].map(|tier| of_uniforms[tier].max(of_words[tier]))
}

/// What is proven of Pareto numbers. The exponent is (whole + rest)/α in units of 1/64: 1/α is good to 2⁻³⁶, its head times the whole
/// number is exact, the rest's product and the sum of both are rounded thrice, and so is the sum with what is left of the head.
fn of_pareto(powers: f64) -> Parts {
    let link = |(whole, rest): (f32, f32), above: f64| {
        let exact = -above.log2() - f64::from(whole);
        let off = (f64::from(rest) - exact).abs() / UNIT;
        let low = f64::from(whole) * 0.5_f64.powi(11);
        off + 3.0 * exact.abs() + 2.0 * low + f64::from(whole) * 0.5_f64.powi(12)
    };
    let of_uniforms = largest(1.0_f32.to_bits() - 1, stride(8009, 61), |bits| {
        let u = f32::from_bits(bits);
        link(log_of_uniform(u), 1.0 - f64::from(u))
    });
    let of_words = largest(u32::MAX, stride(40_009, 257), |word| {
        link(log_of_word(word), 1.0 - middle(word))
    });
    in_ulp(powers + LN_2 / 128.0, LN_2 * of_uniforms.max(of_words))
}

/// Of both laws in the tiers that have samples of their own: what is proven and found, as parts of what is stated.
pub fn lines() -> Vec<Line> {
    if !["LogNormal", "Pareto"].into_iter().any(speed::wants) {
        return Vec::new();
    }
    let powers = of_powers(power, [stride(4001, 61), stride(40_009, 61)]);
    let line = |name, parts: Vec<Parts>, tiers: &[Registered]| {
        println!("{name}: {parts:?}");
        Line::of_samples(name, |stated| {
            let rows = parts.iter().zip(tiers).map(|(parts, of)| Row {
                proven: parts.of(stated),
                found: reached(of, stated),
            });
            rows.collect()
        })
    };
    let mut lines = Vec::new();
    if speed::wants("LogNormal") {
        let tiers = ["libm", "poly"].map(|tier| by_name("LogNormal", tier));
        let normals = tiers.each_ref().map(|of| {
            let normal = by_name("Normal", of.tier);
            Unit::new(&normal, &[0.0, 1.0])
        });
        let rising = of_quantiles(&normals);
        let parts = [0, 1].map(|tier| in_ulp(powers + of_medians(&tiers[tier]), rising[tier]));
        lines.push(line("LogNormal", parts.to_vec(), &tiers));
    }
    if speed::wants("Pareto") {
        let of = [by_name("Pareto", "poly")];
        lines.push(line("Pareto", vec![of_pareto(powers)], &of));
    }
    lines
}

impl Parts {
    /// The largest quotient by a formula of the same two parts, whose variable is `d` or, where it divides, `k`.
    fn of(&self, stated: &Statement) -> f64 {
        let at = |x: f64| stated.eval(&[if stated.names() == ["k"] { 1.0 / x } else { x }]);
        let constant = at(1.0e-30);
        let rising = (at(1.0e30) - constant) / 1.0e30;
        (self.0[0] / constant).max(self.0[1] / rising)
    }
}

/// A coefficient of the series that is off by a thousandth, a table that is off by an ulp, and the last rounding left out are
/// noticed where the exponent's error does not count, in steep Pareto laws.
#[test]
fn a_broken_link_of_laws_by_tables_is_noticed() {
    let proven = |power| {
        let Parts([constant, _]) = in_ulp(of_powers(power, [4001, 40_009]) + LN_2 / 128.0, 0.0);
        constant
    };
    let (of, row) = (
        by_name("Pareto", "poly"),
        docs::of_floats("Pareto").swap_remove(0),
    );
    let stated = row.1[0].eval(&[1.0e30]);
    let (mut figures, mut rng) = (Figures::default(), Pcg32::new(13, 13));
    for _ in 0..1 << 19 {
        let minimum = 1.0 + words::unit(&mut rng);
        let shape = 64.0 + 4096.0 * words::unit(&mut rng);
        let entry = of.of_drawn(&[minimum as f32, shape as f32]).expect("a law");
        let u = [words::unit(&mut rng) as f32, 0.0, 0.0, 0.0].map(|u| u.min(LARGEST));
        let exact = Exact::of(&entry, u, false);
        sample_error(&entry, &exact, entry.warp.sample(u), &mut figures);
    }
    let judged = |proven| {
        complaint_of_half(
            Row {
                proven,
                found: figures.sample,
            },
            stated,
        )
    };
    let right = proven(power);
    assert_eq!(judged(right), None);
    assert!(judged(proven(|i, r| power(i, r * 1.001))).is_some());
    assert!(judged(proven(|i, r| f32::from_bits(power(i, r).to_bits() + 1))).is_some());
    let left_out = right - 1.0;
    assert!(
        figures.sample > left_out,
        "{left_out} found {}",
        figures.sample
    );
}
