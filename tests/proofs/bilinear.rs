//! Points of a bilinear density, for all weights and pairs of uniforms: two places of linear densities, y under the sums of the
//! rows and x under the weights at y, by boxes of the two weights and the uniform.

use crate::cover::{binades, complements, given};
use crate::laws::by_name;
use crate::number::Number;
use crate::programs::{DRAWS, between, uniform};
use crate::range::Range;
use crate::rounding::UNIT;
use crate::several::{Cells, Proven};
use crate::shapes::parts_of;
use crate::tape::Tape;
use host::speed;
use microwarp::Warp;
use microwarp::uniform::LARGEST;
use microwarp::warp::Bilinear;
use std::cmp::Ordering;
use std::collections::BinaryHeap;
use std::sync::LazyLock;

/// Where a density that is `a` at 0 and `b` at 1 has its share u[0] below, and what that leaves of 1, both times a power of 2. A
/// control rounds the root once more.
pub fn place<N: Number>([a, b]: [N; 2], u: [N; 2], lift: f32, once_more: bool) -> [N; 2] {
    let sum = (a + b) * a.like(lift);
    let root = (u[1] * (a * a) + u[0] * (b * b)).sqrt();
    let root = if once_more {
        root * a.like(3.0) / a.like(3.0)
    } else {
        root
    };
    [u[0] * sum / (a + root), u[1] * sum / (b + root)]
}

/// What is proven of the places of a box: the error, and the relative one of the quotient of both digits; and the square root of their
/// product.
#[derive(Default)]
struct Place {
    off: f64,
    apart: f64,
    mean: f64,
}

/// 2⁶⁰.
const LIFT: f32 = 1_152_921_504_606_846_976.0;

/// No place is beyond the root of its share, and it is rounded eight times.
const MOST: f64 = 1.0 + 64.0 * UNIT;

/// Weights that are off by so many halves of an ulp.
fn of_box(weights: [Range; 2], off: f64, (small, first): (Range, bool), more: bool) -> Place {
    let (tape, one) = (Tape::default(), Range::only(1.0));
    let weights = weights.map(|weight| tape.input(weight).off(off));
    let digits = place(weights, complements(&tape, small, first), LIFT, more);
    let [u, v] = if first {
        [small.high, 1.0]
    } else {
        [1.0, small.high]
    };
    let digits =
        [(0, u), (1, v)].map(|(i, u)| digits[i].at_most(MOST * u.sqrt() * f64::from(LIFT)));
    if tape.is_impossible() {
        return Place::default();
    }
    let quotient = tape.exactly(|| digits[0] / digits[1]);
    let [at, rest] = digits.map(|x| x.value().high / f64::from(LIFT));
    Place {
        off: tape.error(&[(digits[0], one)]) / f64::from(LIFT),
        apart: tape.relative_error(quotient),
        mean: (at * rest).min(0.25).sqrt(),
    }
}

/// Weights and a uniform, and whether it is that or its complement.
type Box3 = ([Range; 2], (Range, bool));

/// Weights of which the larger is from 2⁶⁰ to 2⁶¹, as they are kept, and any uniform that is at most a half or leaves that.
///
/// Smaller numbers do not count beside others: a weight at 0 that is 2⁻¹²⁰ of the other beside the root of any uniform, a weight at 1
/// that is 2⁻⁸⁰ of the other anywhere, and beside a larger weight at 0 a uniform of 2⁻⁸⁰.
fn boxes() -> Vec<Box3> {
    let mut boxes = Vec::new();
    for large in parts_of(1.0, 2.0, 4) {
        for rises in [true, false] {
            let down_to = |least: f64, high: f64| {
                let mut all = binades(-24, high, 1);
                all[0].low = least.max(all[0].low);
                all
            };
            let [weight, uniform] = if rises { [-120, -149] } else { [-80, -80] };
            for small in down_to(2.0_f64.powi(weight), large.high) {
                let [large, small] = [large, small].map(|x| x * Range::only(LIFT.into()));
                let weights = if rises {
                    [small, large]
                } else {
                    [large, small]
                };
                for u in down_to(2.0_f64.powi(uniform), 0.5) {
                    boxes.extend(given(u).map(|first| (weights, (u, first))));
                }
            }
        }
    }
    boxes
}

/// A box and what is made of its place, by which boxes are in order.
struct Cut(f64, Box3);

impl PartialEq for Cut {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Cut {}

impl PartialOrd for Cut {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Cut {
    fn cmp(&self, other: &Self) -> Ordering {
        self.0.total_cmp(&other.0)
    }
}

/// Both halves of a range, in the middle of its binades where it has several.
fn halves(Range { low, high }: Range) -> [Range; 2] {
    let middle = if high > 4.0 * low {
        (low * high).sqrt()
    } else {
        0.5 * (low + high)
    };
    [(low, middle), (middle, high)].map(|(low, high)| Range { low, high })
}

/// The largest of what is made of a place, over all boxes. The box of which it is the largest is cut, so many times.
fn most(off: f64, more: bool, of: impl Fn(&Place) -> f64) -> f64 {
    let cuts = speed::of("boxes of bilinear densities that are cut", 500, 40_000);
    let stride = speed::of("one box of bilinear densities tried of every", 211, 1);
    let cut =
        |(weights, uniform)| Cut(of(&of_box(weights, off, uniform, more)), (weights, uniform));
    let mut heap: BinaryHeap<_> = boxes().into_iter().step_by(stride).map(cut).collect();
    for _ in 0..cuts {
        let Cut(_, (weights, (small, given))) = heap.pop().expect("a box");
        let [first, second] = weights.map(halves);
        let small = halves(small);
        heap.extend(
            (0..8_usize).map(|i| cut(([first[i & 1], second[i >> 1 & 1]], (small[i >> 2], given)))),
        );
    }
    heap.peek().expect("a box").0
}

/// The error of a point.
///
/// The sums of rows are rounded once. Both weights at y are rounded by two roundings each, and by what y and its complement are off
/// by, relatively, in proportion to their shares: so the quotient of both is off by four roundings and by what the quotient of y and
/// its complement is off by. By a part of the quotient of the weights x changes ab x(1 - x)/((a + b)((1 - x)a + xb)) times, which is a
/// quarter of √(x(1 - x)) at most, since both sums are at least twice a geometric mean. What is subnormal, and what smaller uniforms
/// count as where a weight is 0, is below 1e-14.
static POINTS: LazyLock<[f64; 2]> = LazyLock::new(|| {
    let apart = most(1.0, false, |place| place.apart) + 4.0 * UNIT;
    let y = most(1.0, false, |place| place.off);
    let x = most(0.0, false, |place| {
        place.off + (0.25 * place.mean + 1e-3 * UNIT) * apart
    });
    [x, y]
});

/// What is proven of it.
pub fn rows(_: &Cells) -> Vec<Proven> {
    let [x, y] = *POINTS;
    vec![("Bilinear", "sample, of the size", [x.hypot(y) + 1e-13; 2])]
}

/// A rounding more of the root is noticed.
#[test]
fn a_rounding_more_of_bilinear_points_is_noticed() {
    let ([_, y], more) = (*POINTS, most(1.0, true, |place| place.off));
    assert!(more > y + 0.5 * UNIT, "{more:e} {y:e}");
}

/// A point by the operations that are examined, of numbers that are not near the smallest or the largest.
fn by_operations<N: Number>(weights: [[N; 2]; 2], [u, v]: [[N; 2]; 2]) -> [N; 2] {
    let half = u[0].like(0.5);
    let [y, rest] = place(weights.map(|[a, b]| half * a + half * b), v, 1.0, false);
    let [[a, b], [c, d]] = weights;
    let [x, _] = place([rest * a + y * c, rest * b + y * d], u, 1.0, false);
    [x, y]
}

/// On `f32` the bits are those of the crate, and on `f64` the point is the truth.
#[test]
fn bilinear_points_are_two_places() {
    let of = by_name("Bilinear", "poly");
    for k in 0..*DRAWS {
        let weights = [0, 1, 2, 3].map(|i| between(4 * k + i, 1e-6, 1e6));
        let [a, b, c, d] = weights;
        // Products of smaller ones are subnormal without the crate's powers of 2.
        let u = [k, k + *DRAWS].map(|k| uniform(k).max(1e-20));
        let made = by_operations([[a, b], [c, d]], u.map(|u| [u, 1.0 - u]));
        let density = Bilinear::new([[a, b], [c, d]]).expect("a density");
        assert_eq!(
            density.sample(u),
            made.map(|x| x.min(LARGEST)),
            "{weights:?} {u:?}"
        );
        let entry = (of.build)(&weights).expect("a density");
        let [u, v] = u.map(f64::from);
        let due = entry.truth.sample([u, v, 0.0, 0.0]);
        let [a, b, c, d] = weights.map(f64::from);
        let exact = by_operations([[a, b], [c, d]], [[u, 1.0 - u], [v, 1.0 - v]]);
        let apart = (exact[0] - due[0]).hypot(exact[1] - due[1]);
        assert!(apart <= 1e-10, "{weights:?} {u} {v}: {exact:?} {due:?}");
    }
}
