//! Laws of the line of a few operations each: the rounding of each is at most half an ulp of its result.

use crate::line::stated;
use crate::linear;
use crate::maps::Row;
use crate::reached::reached;
use crate::report::{Line, complaint_of_half};
use crate::rounding::UNIT;
use crate::search::spread;
use host::errors::{raise, relative, ulp};
use host::registry::registered;
use host::speed;
use microwarp::Warp;
use microwarp::uniform::{LARGEST, SMALLEST};
use microwarp::warp::{Aabb, Interval, PowerMax};

/// What the roundings of a sample of an interval add to its error, in ulp of the larger bound, which lies below 2ᵏ.
///
/// Where both bounds are of one sign, a sample is start + t(end − start): the difference, the product and the sum are each below
/// 2ᵏ. Where they are not, it is (1 − t)start + t end. 1 − t is rounded by 2⁻²⁵, and its product with the start is as much as
/// half an ulp. One product at most reaches 2ᵏ⁻¹, since together they are below 2ᵏ: the other is rounded by a quarter. Where all
/// numbers are subnormal, products are rounded by a half each, and nothing else is. A sample that rounds to the end becomes
/// the number before it, which is on the side of the exact one or less than an ulp before it.
const ONE_SIGN: [f64; 3] = [0.5, 0.5, 0.5];
const BOTH_SIGNS: [f64; 3] = [0.5, 0.75, 0.5];

fn sum(roundings: [f64; 3]) -> f64 {
    roundings.iter().sum()
}

/// The number next to the end, on the side of the start.
fn before(end: f32, start: f32) -> f32 {
    if end == 0.0 {
        return SMALLEST.copysign(start);
    }
    let outward = (start > end) == (end > 0.0);
    f32::from_bits(
        end.to_bits()
            .wrapping_add_signed(if outward { 1 } else { -1 }),
    )
}

/// A sample by the operations that are examined.
fn by_operations(start: f32, end: f32, t: f32) -> f32 {
    let one_sign = start * end.signum() > 0.0;
    let x = if one_sign {
        start + t * (end - start)
    } else {
        (1.0 - t) * start + t * end
    };
    if x == end { before(end, start) } else { x }
}

/// An interval from a number just below a power of 2 to a smaller one, or the other way, and a uniform.
fn tried(k: u32) -> ([f32; 2], f32) {
    let [a, b, c] = [0, 1, 2].map(|i| spread(3 * k + i));
    let large = f32::from_bits(1.0_f32.to_bits() - 1 - a % 512);
    let small = f32::from_bits((1.0_f32.to_bits() - (b >> 6)) | 1);
    let small = if b & 1 == 0 { small } else { -small };
    let sign = if b & 2 == 0 { 1.0 } else { -1.0 };
    let ends = if b & 4 == 0 {
        [large, small]
    } else {
        [small, large]
    };
    // Near either end, and anywhere.
    let t = match b >> 3 & 3 {
        0 => 1.0 - f32::from_bits(0x3380_0000 + (c >> 5)),
        1 => f32::from_bits(0x3f00_0000 - (c >> 7)),
        _ => f32::from_bits(c % 1.0_f32.to_bits()),
    };
    (ends.map(|x| sign * x), t.clamp(0.0, LARGEST))
}

/// The largest errors of samples that are met: of bounds of one sign, and of both.
fn of_intervals() -> [f64; 2] {
    let mut most = [0.0; 2];
    for k in 0..speed::of("intervals tried", 1 << 20, 1 << 24) {
        let ([start, end], t) = tried(k);
        if start == end {
            continue;
        }
        let made = if start < end {
            Interval::new(start, end)
        } else {
            Interval::decreasing(end, start)
        };
        let x = made.expect("an interval").sample(t);
        assert_eq!(
            x,
            by_operations(start, end, t),
            "from {start} to {end} at {t}"
        );
        let [s, e, t] = [start, end, t].map(f64::from);
        let error = (f64::from(x) - (s + t * (e - s))).abs() / ulp(s.abs().max(e.abs()));
        raise(&mut most[usize::from(start * end < 0.0)], error);
    }
    most
}

/// The largest relative error of a density that is met. Two numbers are rounded, the length and its reciprocal.
fn of_densities() -> f64 {
    let mut most = 0.0;
    for k in 0..1 << 20 {
        let ([start, end], _) = tried(k);
        let (low, high) = (start.min(end), start.max(end));
        if let Ok(interval) = Interval::new(low, high) {
            let exact = 1.0 / (f64::from(high) - f64::from(low));
            raise(&mut most, relative(interval.pdf(low).into(), exact));
        }
    }
    most
}

/// The largest of several uniforms is one of them; of 0 it is the smallest number, an ulp away.
fn of_the_largest<const N: usize>() {
    for k in 0..1 << 16 {
        let u: [f32; N] = std::array::from_fn(|i| {
            let word = spread(k * N as u32 + i as u32);
            f32::from_bits((word >> (word & 31)) % 1.0_f32.to_bits())
        });
        let largest = u.iter().copied().fold(0.0, f32::max);
        assert_eq!(PowerMax::<N>::new().sample(u), largest.max(SMALLEST));
    }
}

/// A coordinate of a box is a sample of its interval.
fn of_a_box<const N: usize>() {
    for k in 0..1 << 14 {
        let sides: [_; N] = std::array::from_fn(|i| tried(k * N as u32 + i as u32));
        let [low, high] = [f32::min, f32::max].map(|of| sides.map(|([a, b], _)| of(a, b)));
        if let Ok(all) = Aabb::new(low, high) {
            let x = all.sample(sides.map(|(_, t)| t));
            for (i, x) in x.into_iter().enumerate() {
                let side = Interval::new(low[i], high[i]).expect("an interval");
                assert_eq!(x, side.sample(sides[i].1));
            }
        }
    }
}

/// What is proven of a box, as a part of what is stated. A number of so many ulp is 2⁻²³ of the size at most, and where that
/// is subnormal, samples are within 1.5 of the smallest number. Coordinates are at right angles.
fn of_boxes(ulps: f64) -> Line {
    of_a_box::<1>();
    of_a_box::<2>();
    of_a_box::<3>();
    Line::of_samples("Aabb", |stated| {
        let at = |size: f64| {
            let names = stated.names().iter();
            let values: Vec<_> = names
                .map(|name| if name == "m" { size } else { 1.0 })
                .collect();
            stated.eval(&values)
        };
        let (smallest, large) = (f64::from(SMALLEST), 1.0);
        let proven = (ulps * 2.0 * UNIT / at(large)).max(1.5 / at(smallest));
        let boxes = registered().into_iter().filter(|of| of.name == "Aabb");
        let found = boxes.map(|of| reached(&of, stated)).fold(0.0, f64::max);
        vec![Row { proven, found }]
    })
}

/// The rows of these laws.
pub fn lines() -> Vec<Line> {
    if !["Interval", "PowerMax", "Aabb", "Linear"]
        .into_iter()
        .all(speed::wants)
    {
        return Vec::new();
    }
    let line = |name, title, proven, found| {
        let (title, [_, stated]) = stated(name, title);
        Line {
            name,
            title,
            stated: vec![stated],
            rows: vec![Row { proven, found }],
            formula: None,
        }
    };
    let [one, both] = of_intervals();
    let density = (1.0 + UNIT).powi(2) - 1.0;
    let of_density = of_densities();
    of_the_largest::<1>();
    of_the_largest::<2>();
    of_the_largest::<3>();
    of_the_largest::<7>();
    let bound = sum(ONE_SIGN).max(sum(BOTH_SIGNS));
    vec![
        line("Interval", "sample", bound, one.max(both)),
        line("Interval", "pdf, relative", density, of_density),
        line(
            "Interval",
            "realised density, relative",
            density,
            of_density,
        ),
        line(
            "PowerMax",
            "sample",
            1.0,
            f64::from(PowerMax::<1>::new().sample([0.0])) / ulp(0.0),
        ),
        of_boxes(bound),
        linear::line(),
    ]
}

/// A rounding that is left out is noticed.
#[test]
fn a_rounding_of_an_interval_left_out_is_noticed() {
    let found = of_intervals();
    let (_, [_, stated]) = stated("Interval", "sample");
    println!("{found:?}");
    for (found, roundings) in found.into_iter().zip([ONE_SIGN, BOTH_SIGNS]) {
        let row = |proven| Row { proven, found };
        assert_eq!(complaint_of_half(row(sum(roundings)), stated), None);
        for left_out in 0..3 {
            let mut fewer = roundings;
            fewer[left_out] = 0.0;
            assert!(
                complaint_of_half(row(sum(fewer)), stated).is_some(),
                "{left_out}: {found}"
            );
        }
    }
}
