//! The truncated exponential law, for all rates, lengths and uniforms. z is the rate times the length. Where that is small, a sample is
//! a series; elsewhere a logarithm over the rate, off by what the constructor's e^(-z) is off by, as the logarithm counts it.

use crate::cover::{binades, complements, given};
use crate::fisher::{LINKS, Links, rounded};
use crate::inputs::in_parallel;
use crate::kept::largest;
use crate::laws::by_name;
use crate::line::stated;
use crate::maps::Row;
use crate::number::Number;
use crate::programs::{DRAWS, between, kept, uniform};
use crate::range::Range;
use crate::rounding::{Lost, UNIT};
use crate::several::{Cells, Proven, complaint};
use crate::shapes::parts_of;
use crate::swept::{Swept, relative};
use crate::tape::each_way;
use host::errors::raise;
use microwarp::Warp;
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::uniform::{LARGEST, SMALLEST};
use microwarp::warp::TruncatedExponential;
use std::f64::consts::{LN_2, LOG2_E};

/// Where the series ends, where e^|z| counts in place of e^|z| - 1, and where samples of all uniforms count from the far end. e^(-z) of the
/// last is a fraction of what any uniform leaves of 1.
const SERIES: f64 = 0.5;
const STEEP: f64 = 80.0;
const STEEPEST: f64 = 175.0;
const ALL: f64 = 18.0;

/// By how much ranges overlap, relatively, so that what is rounded is in one of them.
const APART: f64 = 1e-6;

/// What counts beside errors relatively: their products, and what stands for the logarithm of 1 + x below 2⁻³⁰.
const BESIDE: f64 = 0.01;

/// 2¹⁰⁰.
const LIFT: f32 = 1_267_650_600_228_229_401_496_703_205_376.0;

/// A range of |z|, 1 - e^(-z) or what e^|z| is above 1, and what the constructor's number of that is off by relatively, in units of
/// 2⁻²⁴, and its e^(-z).
#[derive(Clone, Copy)]
struct Kept {
    z: Range,
    decay: Range,
    off: [f64; 2],
}

impl Kept {
    /// e^(-z) is 2^k(1 + rise). The product with log₂e of 36 digits is off by 2⁻³⁴ of itself at most, the rise by 2⁻⁴⁰ beside that.
    /// Kept are the sum of 2^k - 1 and 2^k·rise, and the one of 1 and the rise, each rounded once, without what the rise has been
    /// rounded by.
    fn of(rising: bool, z: Range) -> Self {
        let z = Range {
            low: z.low * (1.0 - APART),
            high: z.high * (1.0 + APART),
        };
        let sign = if rising { 1.0 } else { -1.0 };
        let decay = Range::of(&[z.low, z.high].map(|z| (sign * z).exp_m1().abs()).repeat(2));
        let exponent = z.times(sign);
        let nearest = |x: f64, by: f64| (x * LOG2_E + by).round();
        let mut off = [0.0; 2];
        let mut k = nearest(exponent.low, -APART);
        while k <= nearest(exponent.high, APART) {
            let rise = |x: f64| ((x * LOG2_E - k).clamp(-0.5, 0.5) * LN_2).exp_m1();
            let rise = Range {
                low: rise(exponent.low) - APART,
                high: rise(exponent.high) + APART,
            };
            let of_rise = Lost::of(rise).absolute + 1.5 * 2.0_f64.powi(-34) * z.high + 1e-12;
            let one = rise + Range::only(1.0);
            // 2^k - 1 has up to 24 digits, or is rounded to the larger of both.
            let of_one = if k.abs() > 24.0 {
                k.exp2().min(1.0)
            } else {
                0.0
            };
            let of_decay = Lost::of(decay).absolute + k.exp2() * of_rise + of_one;
            raise(&mut off[0], of_decay / decay.low / UNIT);
            let of_power = Lost::of(one).absolute + of_rise;
            raise(&mut off[1], of_power / one.low / UNIT);
            k += 1.0;
        }
        Self { z, decay, off }
    }

    /// All of one sign.
    fn all(rising: bool) -> Vec<Self> {
        let (to, parts) = if rising {
            (STEEPEST, 35_000)
        } else {
            (ALL, 4_000)
        };
        let mut all = parts_of(SERIES, to, parts);
        if !rising {
            // e^(-z) is nothing beyond.
            all.push(Range {
                low: ALL,
                high: 2.0 * ALL,
            });
        }
        all.into_iter().map(|z| Self::of(rising, z)).collect()
    }
}

/// Parts of what a logarithm of 1 + x or 1 - x is taken of. Numbers below the first are as good as it.
fn arguments(to: f64) -> Vec<Range> {
    binades(-30, to, 128).into_iter().skip(1).collect()
}

/// Where a sum is above 1/2 that would be below it without its roundings.
const NEXT_TO_HALF: Range = Range {
    low: 0.5,
    high: 0.5 + 4.0 * UNIT,
};

/// What its logarithm is off by there.
fn next_to_half<T: Tier>() -> f64 {
    let numbers = (0..=4).map(|k| 0.5 + k as f32 * f32::EPSILON / 2.0);
    let errors = numbers.map(|x| relative(T::ln(x), f64::from(x).ln()));
    errors.fold(0.0, f64::max)
}

/// What the logarithm is off by relatively, in units of 2⁻²⁴.
///
/// For z above 0 it is that of 1 - x, and its slope takes (e^L - 1)/L of what x is off by, up to 1/2; beyond, that of the sum of what the
/// uniform leaves of 1, which is exact there, and its product with e^(-z), each over L. That power is below 1/2 then, as 1 - e^(-z), which
/// is made of the same rise, is above it. For z below 0 the slope takes less than what x is off by: of the rise itself, or, where that
/// is steep, of e^(-z).
fn logarithm<T: Tier>(links: &Links, more: f64) -> f64 {
    let [below, share, above] = &links.0;
    let of_falling = Kept::all(false);
    let of_drops = |drop: Range| {
        let log = -(-drop.high).ln_1p();
        let kept = of_falling.iter().filter(|kept| kept.decay.high >= drop.low);
        let off = kept.map(|kept| kept.off[0]).fold(0.0, f64::max);
        log.exp_m1() / log * (off + more + rounded(drop)) + below.over(drop)
    };
    let of_shares = |left: Range, kernel: f64| {
        let log = Range {
            low: -left.high.ln(),
            high: -left.low.ln(),
        };
        let kept = of_falling.iter().filter(|kept| kept.z.high >= log.low);
        let sums = kept.map(|kept| {
            let least = log.low.max(LN_2) * (1.0 + 4.0 * APART);
            let kept = if kept.z.low < least {
                &Kept::of(
                    false,
                    Range {
                        low: least,
                        high: kept.z.high.max(least),
                    },
                )
            } else {
                kept
            };
            let uniform = |left: f64, decay: f64| ((1.0 - left) / decay).min(1.0);
            let product = Range {
                low: uniform(left.high, kept.decay.high) * (-kept.z.high).exp(),
                high: (uniform(left.low, kept.decay.low) * (-kept.z.low).exp()).min(left.high),
            };
            let off = kept.off[1] + more + rounded(product);
            (product.high / left.low).min(1.0 + APART) * off
        });
        (sums.fold(0.0, f64::max) + rounded(left)) / log.low + kernel
    };
    let of_rising = Kept::all(true);
    let of_rising = of_rising.iter().map(|kept| {
        let which = [kept.z.low < STEEP, kept.z.high > STEEP];
        let off = kept.off.iter().zip(which).filter(|(_, which)| *which);
        off.map(|(off, _)| *off).fold(0.0, f64::max)
    });
    let of_rising = of_rising.fold(0.0, f64::max);
    let of_rises = |rise: Range| {
        let log = rise.high.ln_1p();
        let slope = rise.high / (1.0 + rise.high) / log;
        let slope = slope.max(rise.low / (1.0 + rise.low) / rise.low.ln_1p());
        slope * (of_rising + more + rounded(rise)) + above.over(rise)
    };
    let largest = |ranges: &[Range], of: &(dyn Fn(Range) -> f64 + Sync)| {
        let all = in_parallel(ranges.len() as u32, |i| of(ranges[i as usize]));
        all.into_iter().fold(0.0, f64::max)
    };
    let shares = binades(-24, 0.5, 64);
    let falling = largest(&arguments(0.5), &of_drops);
    let falling = falling.max(largest(&shares[1..], &|left| {
        of_shares(left, share.over(left))
    }));
    let falling = falling.max(of_shares(NEXT_TO_HALF, next_to_half::<T>()));
    let logarithms = falling.max(largest(&arguments(STEEP.exp()), &of_rises));
    // A product below 2⁻¹²⁶ is lifted, and counts for its logarithm: the product is rounded, and what is led back where it is subnormal.
    let of_falling = of_falling.iter().map(|kept| kept.off[0]);
    let lifted = of_falling.fold(of_rising, f64::max) + more + 1.5;
    logarithms.max(lifted) + BESIDE
}

/// What a sample counted from the far end is off by, in ulp. The exact one is at least 100 ln 2 over the rate.
fn far<T: Tier>() -> f64 {
    // Any uniform that is neither 0 nor 1.
    let ln = Swept::kernel(
        [SMALLEST, 1.0],
        |x| T::ln(x.clamp(SMALLEST, LARGEST)),
        |x| x.clamp(SMALLEST.into(), LARGEST.into()).ln(),
    );
    let mut worst = 0.0;
    for exponent in 0..149 {
        let [high, low] = [0, 1].map(|more| 2.0_f64.powi(-exponent - more));
        let log = -low.ln();
        let sample = (100.0 * LN_2).max(STEEP + low.ln()) * (1.0 - APART);
        let back = log / sample;
        assert!(back < 2.0);
        // A way back that is longer than the sample may be rounded by twice as much, and the sum past a power of 2, too.
        let rounded = if back <= 1.0 { 0.5 } else { 1.0 };
        raise(
            &mut worst,
            back * ln.over(Range { low, high }) + rounded + 1.0,
        );
    }
    worst + BESIDE
}

/// By what part of itself a sample is less than the uniform times the length: a series of z, of the uniform and what it leaves of 1.
fn bend<N: Number>(z: N, u: N, left: N) -> N {
    let one = |x: f32| z.like(x);
    let (p, d) = (left * u, left - u);
    let ninth = d * (one(1.0) - p * (one(252.0) - p * (one(5040.0) - one(20160.0) * p)));
    let ninth = ninth * one(1.0 / 362_880.0);
    let eighth = one(1.0) - p * (one(126.0) - p * (one(1680.0) - one(5040.0) * p));
    let eighth = eighth * one(1.0 / 40_320.0) - z * ninth;
    let seventh =
        d * (one(1.0) - p * (one(60.0) - one(360.0) * p)) * one(1.0 / 5040.0) - z * eighth;
    let sixth = (one(1.0) - p * (one(30.0) - one(120.0) * p)) * one(1.0 / 720.0) - z * seventh;
    let fifth = d * (one(1.0) - one(12.0) * p) * one(1.0 / 120.0) - z * sixth;
    let fourth = (one(1.0) - one(6.0) * p) * one(1.0 / 24.0) - z * fifth;
    let rest = d * one(1.0 / 6.0) - z * fourth;
    z * left * (one(0.5) - z * rest)
}

/// What the series leaves out, and its rounded coefficients, in units of 2⁻²⁴ of a sample.
const LEFT_OUT: f64 = 0.2;

/// What samples by the series are off by, in ulp. Below 2⁻²⁶ uniforms are multiplied by the length first, which changes the order of
/// the roundings alone; any binade stands for all, and half a step, which a product may be rounded by where it is subnormal, is less than
/// what is counted of it.
fn of_series() -> f64 {
    let mut zs = binades(-6, SERIES * (1.0 + APART), 16);
    zs[0].low = 0.0;
    let smalls: Vec<_> = binades(-28, 0.5, 8).into_iter().skip(1).collect();
    let all = in_parallel(2 * zs.len() as u32, |i| {
        let (z, sign) = (zs[i as usize / 2], [-1.0, 1.0][i as usize % 2]);
        let mut worst = 0.0;
        for &small in &smalls {
            for first in given(small) {
                each_way(|tape| {
                    let [u, left] = complements(tape, small, first);
                    let z = tape.input(z.times(sign)).off(1.0);
                    let x = u - u * bend(z, u, left);
                    raise(&mut worst, tape.relative_error(x) / UNIT);
                });
            }
        }
        worst
    });
    all.into_iter().fold(0.0, f64::max) + LEFT_OUT + 1.0
}

/// What is proven of a tier. The quotient by the rate is rounded by an ulp at most.
fn bound<T: Tier>(links: &Links, more: f64) -> f64 {
    let logarithm = logarithm::<T>(links, more) + 1.0;
    let parts = [logarithm, far::<T>(), of_series()];
    println!("truncated exponential law: {parts:?}");
    parts.into_iter().fold(0.0, f64::max)
}

/// What is proven of it.
pub fn rows(_: &Cells) -> Vec<Proven> {
    let tiers = [bound::<Libm>(&LINKS[0], 0.0), bound::<Poly>(&LINKS[1], 0.0)];
    vec![("TruncatedExponential", "sample, ulp", tiers)]
}

/// A sample by the operations that are examined, with what is kept so many ulp larger than it is.
fn by_operations<T: Tier>(law: &TruncatedExponential<T>, u: f32, ulps: u32) -> f32 {
    let (rate, length) = (law.rate(), law.length());
    let [decay, power] =
        ["decay", "power"].map(|name| f32::from_bits(kept(law, name).to_bits() + ulps));
    let z = rate * length;
    let (drop, rise) = (u * decay, u * LIFT * power);
    let x = if z.abs() < 0.5 {
        let bend = bend(z, u, 1.0 - u);
        if u > f32::MIN_POSITIVE * LIFT {
            length * (u - u * bend)
        } else {
            length * u - length * u * bend
        }
    } else if z > -80.0 && drop < -0.5 {
        -T::ln((1.0 - u) + u * power) / rate
    } else if z > -80.0 && drop.abs() >= f32::MIN_POSITIVE {
        -T::ln_1p(drop) / rate
    } else if z > -80.0 {
        u * LIFT * decay / -rate / LIFT
    } else if rise <= LIFT {
        T::ln_1p(rise) / -rate
    } else {
        length + T::ln(u) / -rate
    };
    x.max(0.0).min(length)
}

/// Samples are made so, and what is kept is as good as is said.
fn samples_are_made_so<T: Tier>() {
    let of = by_name("TruncatedExponential", T::NAME);
    let mut noticed = 0;
    for k in 0..4 * *DRAWS {
        let length = between(k, 1e-30, 1e30);
        // z of all sizes, and such as are next to where one way ends.
        let z = [between(k + 1, 1e-3, 300.0), between(k + 1, 0.4, 2.0)][k as usize % 2];
        let rate = if k % 3 == 0 { z } else { -z } / length;
        let u = uniform(k + 2).max(SMALLEST);
        let law = TruncatedExponential::<T>::from_rate(rate, length).expect("a law");
        let x = law.sample(u);
        assert_eq!(
            x,
            by_operations(&law, u, 0),
            "{} {rate} {length} {u}",
            T::NAME
        );
        noticed += u32::from(x != by_operations(&law, u, 1));
        let z = f64::from(rate) * f64::from(length);
        if z.abs() < SERIES {
            // Without rounding the series is the truth.
            let entry = (of.build)(&[rate, length]).expect("a law");
            let exact = entry.truth.sample([u.into(), 0.0, 0.0, 0.0])[0] / f64::from(length);
            let u = f64::from(u);
            let made = u - u * bend(z, u, 1.0 - u);
            assert!((made - exact).abs() <= LEFT_OUT * UNIT * exact, "{z} {u}");
        } else if z.abs() < STEEP {
            let due = Kept::of(z < 0.0, Range::only(z.abs()));
            for (name, exact, off) in [
                ("decay", (-z).exp_m1(), due.off[0]),
                ("power", (-z).exp(), due.off[1]),
            ] {
                let apart = (f64::from(kept(&law, name)) - exact).abs();
                assert!(apart <= off * UNIT * exact.abs(), "{name} {z}: {apart:e}");
            }
        }
    }
    // An ulp more of what is kept changes bits.
    assert!(noticed > *DRAWS / 2, "{noticed} bits differ");
}

#[test]
fn truncated_exponential_samples_are_a_logarithm_or_a_series() {
    samples_are_made_so::<Libm>();
    samples_are_made_so::<Poly>();
}

/// A rounding more of what is kept is noticed.
#[test]
fn a_truncated_law_of_another_power_is_noticed() {
    let (_, [stated, _]) = stated("TruncatedExponential", "sample");
    let [found, _] = largest("TruncatedExponential", "sample");
    let judged = |more| {
        let proven = bound::<Libm>(&LINKS[0], more);
        complaint(stated, Row { proven, found })
    };
    assert_eq!(judged(0.0), None);
    assert!(judged(1.0).is_some());
}
