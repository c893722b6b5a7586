//! Equi-angular samples, for all distances, segments and uniforms: a quotient of sines of angles, by boxes of the distance, the two
//! ends and the uniform. In real numbers lengths are in units of a power of 2 next to the distance, which is from 1 to 2.

use crate::angles::{ANGLE, Links, SHORT, radius, rounded};
use crate::cover::binades;
use crate::inputs::in_parallel;
use crate::kept::largest;
use crate::line::stated;
use crate::maps::Row;
use crate::number::Number;
use crate::range::Range;
use crate::rounding::{Lost, UNIT};
use crate::segments::{LINEAR, across, beside, next_to};
use crate::several::{Cells, Proven, complaint};
use crate::tape::{NEAR, Tape, Traced, each_way};
use host::errors::{raise, ulp};
use host::speed;
use microwarp::tier::{Libm, Poly};
use std::f64::consts::TAU;

/// Boxes of larger errors are cut, in `libm` and in `poly`, and so often at most.
const FINE: [f64; 2] = [15.29, 14.97];
const DEPTH: u32 = 40;

/// Turns below which an angle counts as its sine.
const FLAT: f64 = 4.0e-5;

/// Ranges of the distance, of two lengths and of a uniform, and whether that is counted from the near end.
type Box4 = ([Range; 4], bool);

/// An error in units of an ulp of a number that is at least so large.
fn in_ulp(tape: &Tape, t: Traced, least: f64) -> f64 {
    let low = (t.value().low * (1.0 - NEAR)).max(least);
    let absolute = tape.error(&[(t, Range::only(1.0))]) / ulp(low);
    let relative = if t.value().low > 0.0 {
        tape.relative_error(t) / UNIT
    } else {
        f64::INFINITY
    };
    let error = absolute.min(relative);
    if error.is_nan() { f64::INFINITY } else { error }
}

/// What the sum with a place up to `near` is rounded by, in ulp of the sum: by half of one, and by one where errors or that take it past
/// a power of 2.
fn added_to(way: Range, near: f64) -> f64 {
    let power = |x: f64| x.to_bits() >> 52;
    let [low, high] = [way.low * (1.0 - NEAR), (way.high + near) * (1.0 + NEAR)];
    if power(low) == power(high) { 0.5 } else { 1.0 }
}

/// A uniform that is at most a half and what it leaves, whichever is first.
fn parts<'a>(tape: &'a Tape, small: Range, first: bool) -> [Traced<'a>; 2] {
    let x = tape.input(small);
    let rest = x.like(1.0) - x;
    if first { [x, rest] } else { [rest, x] }
}

/// The error of a place between the foot and an end, `far`, where the other end is `other`.
///
/// What is held between the foot and an end below 2⁻²⁴ of the length whose ulp counts is off by an ulp at most. Where both ends are
/// below 7.8e-5 of the distance, angles are products by a constant, and sines are, too: a distance twice as long halves them and changes
/// nothing else, so that larger angles stand for all.
///
/// The angle may be below 0 where what is rounded of the foot's uniform says that the place is on this side. The sample is the foot
/// then, or is off by no more than the record says.
fn of_across(links: &Links, ([d, far, other, small], first): &Box4) -> f64 {
    let least = d.low.min(far.low.max(other.low));
    if far.high < UNIT * d.low.min(other.low) || far.high.max(other.high) < 0.25 * SHORT {
        return 0.0;
    }
    let [q, to_other] = [far, other].map(|end| Range {
        low: end.low / d.high,
        high: end.high / d.low,
    });
    let angle = |q: Range| {
        Range {
            low: q.low.atan() / TAU,
            high: q.high.atan() / TAU,
        }
        .wider(0.0)
    };
    let mut worst = 0.0_f64;
    each_way(|tape| {
        let [own, beside] = [q, to_other].map(|q| {
            let range = angle(q);
            tape.input(range)
                .off_by(Lost::part(range, links.turns(q, 0.0)))
        });
        let whole = own + beside;
        let [part, _] = parts(tape, *small, *first);
        if own.value().high < 0.999 * part.value().low * whole.value().low {
            return;
        }
        let r = radius(tape, *d, *far);
        let lengths = [tape.input(*d), tape.input(*far), r];
        let [place, within] = across(lengths, [own, whole], part, |turns| {
            links.sines(tape, turns)
        });
        if tape.is_impossible() {
            return;
        }
        raise(&mut worst, in_ulp(tape, place, least));
        if within.value().low < 0.0 {
            // The product is at most what the uniform of the foot, the sum of the angles, 1 - u and the product itself are rounded by
            // above the own angle.
            let half = |x: f64| Lost::of(Range::only(x)).absolute;
            let [own, whole] = [own, whole].map(|x| x.value().high);
            let more = half(whole) + whole * 2.0 * half(0.999) + half(own);
            let off = tape.error(&[(within, Range::only(1.0))]) + more;
            raise(&mut worst, 1.001 * TAU * d.high * off / ulp(least));
        }
    });
    worst
}

/// The error of a place of a segment that begins at `near` and is as long as `extent`. A near end next to the foot, and uniforms below
/// 2⁻⁶⁰, of which any binade stands for all, count with the last sum alone.
fn of_beside(links: &Links, ([d, near, extent, small], first): &Box4) -> f64 {
    let far = *near + *extent;
    // The quotient of which the angle is made falls with the near end, and is largest where the distance is the root of both ends.
    let quotient = |d: f64, near: f64, extent: f64| extent / (d + near * (near + extent) / d);
    let peak = (near.low * (near.low + extent.high))
        .sqrt()
        .clamp(d.low, d.high);
    let ends = [d.low, d.high, peak, peak];
    let low = ends
        .map(|d| quotient(d, near.high, extent.low))
        .into_iter()
        .fold(f64::INFINITY, f64::min);
    let high = ends
        .map(|d| quotient(d, near.low, extent.high))
        .into_iter()
        .fold(0.0, f64::max);
    let flat = (TAU * FLAT).tan() * (1.0 - NEAR);
    if high < flat {
        return 0.0;
    }
    let q = Range {
        low: low.max(flat),
        high,
    }
    .wider(0.0);
    let inputs = rounded(*d * *extent) + rounded(*d * *d + *near * far);
    let range = Range {
        low: q.low.atan() / TAU,
        high: q.high.atan() / TAU,
    }
    .wider(0.0);
    let of_angle = links.turns(q, inputs);
    let short = near.low == 0.0;
    let linear = small.high <= LINEAR;
    let mut worst = 0.0_f64;
    each_way(|tape| {
        let angle = tape.input(range).off_by(Lost::part(range, of_angle));
        let length = tape
            .input(*extent)
            .off(if near.low >= extent.high { 0.0 } else { 1.0 });
        let radii = [*near, far].map(|end| radius(tape, *d, end));
        let uniforms = parts(tape, *small, *first);
        let sines = |turns| links.sines(tape, turns);
        let start = (!short).then(|| tape.input(*near));
        let place = if linear {
            let [middle, off] = links.of_sine(range);
            let turn = Range::only(TAU);
            let turn = tape.input(turn).off_by(Lost::part(turn, 0.5));
            let end = Links::sine(tape, angle, middle.abs() + off);
            next_to([uniforms[0], angle, turn], length, radii, end)
        } else {
            beside(
                start,
                [tape.input(far), length],
                radii,
                angle,
                uniforms,
                sines,
            )
        };
        let error = in_ulp(tape, place, 0.0);
        let added = if short || linear {
            added_to(place.value(), near.high)
        } else {
            0.0
        };
        raise(&mut worst, error + added);
    });
    worst
}

/// The error where the angle is below 2.5e-4, of which a sixth of the square is 0.18 units, and uniforms stand for sines.
///
/// Both weights are a product of a distance, off by 3/2, and of a uniform, of which one is rounded. From the near end, where the weight
/// of it is the smaller, they count once; then come their sum, the extent, the quotient and the product, and the last sum. From the
/// far end, where both weights are half of their sum, the way back is as long as that to the place.
fn of_flat() -> f64 {
    let weights: f64 = 2.0 * (1.5 + 1.0) + 1.0 + 0.18;
    (weights + 4.0).max(0.5 * weights + 4.0) + 1.0
}

/// Both halves of a range, in the middle of its binades where it has several.
fn halves(Range { low, high }: Range) -> [Range; 2] {
    let middle = if low > 0.0 && high > 4.0 * low {
        (low * high).sqrt()
    } else {
        0.5 * (low + high)
    };
    [(low, middle), (middle, high)].map(|(low, high)| Range { low, high })
}

/// Ranges about the foot, or on one side of it.
#[derive(Clone, Copy, PartialEq)]
enum Where {
    Across,
    Beside,
}

impl Where {
    fn error(self, links: &Links, of: &Box4) -> f64 {
        match self {
            Self::Across => of_across(links, of),
            Self::Beside => of_beside(links, of),
        }
    }

    /// Both halves of a box in that of its wide directions in which the error becomes smallest.
    fn cut(self, links: &Links, fine: f64, (ranges, first): &Box4) -> [(Box4, f64); 2] {
        // The other end, or the near one, counts less where it is small beside other lengths.
        let beside = match self {
            Self::Across => 0.1 * ranges[1].low.min(ranges[0].low),
            Self::Beside => 0.004,
        };
        let second = if self == Self::Across { 2 } else { 1 };
        let widths: [f64; 4] = std::array::from_fn(|i| {
            let Range { low, high } = ranges[i];
            (high - low) / (high + if i == second { beside } else { 0.0 })
        });
        let wide = 0.3 * widths.into_iter().fold(0.0, f64::max);
        let cuts = (0..4).filter(|&i| widths[i] >= wide).map(|i| {
            halves(ranges[i]).map(|half| {
                let mut ranges = *ranges;
                ranges[i] = half;
                let cut = (ranges, *first);
                (cut, self.error(links, &cut))
            })
        });
        let sum = |[a, b]: &[(Box4, f64); 2]| a.1.max(fine) + b.1.max(fine);
        cuts.min_by(|a, b| sum(a).total_cmp(&sum(b)))
            .expect("a direction")
    }

    /// The largest error over a box. Where it is above `fine` the box is cut, up to so often; nothing is proven where that is not enough.
    fn most(self, links: &Links, fine: f64, of: &Box4) -> f64 {
        let mut worst = 0.0_f64;
        let mut left = vec![(*of, self.error(links, of), DEPTH)];
        while let Some((of, error, depth)) = left.pop() {
            if error <= fine {
                raise(&mut worst, error);
            } else if depth == 0 {
                return f64::INFINITY;
            } else {
                left.extend(
                    self.cut(links, fine, &of)
                        .map(|(of, error)| (of, error, depth - 1)),
                );
            }
        }
        worst
    }

    /// Boxes of lengths, of which the ratios are 2⁸⁰ at most.
    fn boxes(self) -> Vec<Box4> {
        let smalls = binades(-110, 0.5, 1);
        let linear = Range {
            low: 0.5 * LINEAR,
            high: LINEAR,
        };
        let mut all = Vec::new();
        match self {
            Self::Across => {
                for far in powers(-40, 81) {
                    for other in down_to_0(-41, 81) {
                        let of = smalls
                            .iter()
                            .flat_map(|&small| [true, false].map(|first| (small, first)));
                        all.extend(
                            of.map(|(small, first)| ([ONE_TO_TWO, far, other, small], first)),
                        );
                    }
                }
            }
            // Angles that are not flat leave this of the near end and of the extent.
            Self::Beside => {
                for near in down_to_0(-14, 13) {
                    for extent in powers(-13, 81) {
                        let from_near = smalls
                            .iter()
                            .filter(|small| small.low >= LINEAR)
                            .chain([&linear]);
                        let of = from_near
                            .map(|small| (*small, true))
                            .chain(smalls.iter().map(|small| (*small, false)));
                        all.extend(
                            of.map(|(small, first)| ([ONE_TO_TWO, near, extent, small], first)),
                        );
                    }
                }
            }
        }
        all
    }
}

/// Binades from one power of 2 to another.
fn powers(from: i32, to: i32) -> Vec<Range> {
    let of = |k: i32| Range {
        low: 2.0_f64.powi(k),
        high: 2.0_f64.powi(k + 1),
    };
    (from..to).map(of).collect()
}

const ONE_TO_TWO: Range = Range {
    low: 1.0,
    high: 2.0,
};

fn down_to_0(from: i32, to: i32) -> Vec<Range> {
    let mut all = powers(from, to);
    all.insert(
        0,
        Range {
            low: 0.0,
            high: all[0].low,
        },
    );
    all
}

/// What is proven of a tier.
fn bound(links: &Links, fine: f64) -> f64 {
    let stride = speed::or_all(
        "one box of equi-angular samples tried of every",
        4001,
        61,
        1,
    );
    let of = |place: Where| {
        let boxes: Vec<_> = place.boxes().into_iter().step_by(stride).collect();
        let most = in_parallel(boxes.len() as u32, |i| {
            place.most(links, fine, &boxes[i as usize])
        });
        most.into_iter().fold(0.0, f64::max)
    };
    of(Where::Across).max(of(Where::Beside)).max(of_flat()) + 1e-4
}

/// What is proven of it.
pub fn rows(_: &Cells) -> Vec<Proven> {
    let tiers = [
        bound(&Links::of::<Libm>(ANGLE, 0.0), FINE[0]),
        bound(&Links::of::<Poly>(ANGLE, 0.0), FINE[1]),
    ];
    vec![("EquiAngular", TITLE, tiers)]
}

const TITLE: &str = "sample, ulp of itself or of a length";

/// Sines that are off by an ulp more are noticed, where errors are large.
#[test]
fn equi_angular_samples_of_another_sine_are_noticed() {
    let (_, [stated, _]) = stated("EquiAngular", "sample");
    let [found, _] = largest("EquiAngular", TITLE);
    let box4 = |near, extent, small| ([ONE_TO_TWO, near, extent, small], false);
    let range = |low, high| Range { low, high };
    let large = box4(range(0.0, SHORT), range(1024.0, 2048.0), range(0.25, 0.5));
    let judged = |more| {
        let proven = Where::Beside.most(&Links::of::<Libm>(ANGLE, more), FINE[0], &large);
        complaint(stated, Row { proven, found })
    };
    assert_eq!(judged(0.0), None);
    assert!(judged(2.0).is_some());
}
