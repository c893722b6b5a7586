//! Samples of segments by the operations that are examined: over any kind of number, and on `f32` the bits of the crate.

use crate::angles::{ANGLE, Links, from_the_diagonal};
use crate::laws::by_name;
use crate::number::Number;
use crate::programs::{DRAWS, between as any_between, uniform};
use crate::range::Range;
use crate::rounding::UNIT;
use crate::search::spread;
use crate::tape::{NEAR, Traced};
use microwarp::Warp;
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::warp::EquiAngular;
use std::f64::consts::TAU;
use std::fmt::Debug;

/// A uniform below which a way is in proportion to it.
pub const LINEAR: f64 = 1.0 / (1_u64 << 60) as f64;

/// What is known of numbers without being recorded.
pub trait Known: Number {
    /// Says that it is at least half of another, but for a 10⁻⁵th.
    fn at_least_half(self, of: Self) -> Self;
    /// The number, or 0 if it is negative; it is by a few roundings of another at most.
    fn or_0(self, of: Self) -> Self;
}

impl Known for f32 {
    fn at_least_half(self, _: Self) -> Self {
        self
    }
    fn or_0(self, _: Self) -> Self {
        self.max(0.0)
    }
}

impl Known for f64 {
    fn at_least_half(self, _: Self) -> Self {
        self
    }
    fn or_0(self, _: Self) -> Self {
        self.max(0.0)
    }
}

impl Known for Traced<'_> {
    fn at_least_half(self, of: Self) -> Self {
        self.at_least(0.5 * of.value().low * (1.0 - NEAR))
    }
    fn or_0(self, of: Self) -> Self {
        self.at_least(-16.0 * UNIT * of.value().high)
    }
}

/// The place between two others, measured from the one it is nearer to; the nearer one is left out where it is the foot.
fn between<N: Known>(near: Option<N>, [far, extent]: [N; 2], [to_far, to_near]: [N; 2]) -> N {
    let share = extent / (to_far + to_near);
    if to_near.below(to_far) {
        let way = to_near * share;
        near.map_or(way, |near| near + way)
    } else {
        (far - to_far * share).at_least_half(far)
    }
}

/// A place between the foot and the far end, and the sine it is made of: of the distance, the end and its own distance to the light;
/// its angle and that of the whole segment; and the part of that from the end.
pub fn across<N: Known>(
    [d, far, r]: [N; 3],
    [own, angle]: [N; 2],
    part: N,
    sines: impl Fn([N; 2]) -> [N; 2],
) -> [N; 2] {
    let beyond = part * angle;
    let within = (own - beyond).or_0(angle);
    let [x, y] = sines([beyond, within]);
    let place = between(None, [far, far], [r * x, d * y]);
    [place, within]
}

/// A place of a segment on one side of the foot: of its ends, its extent, and the distances of the ends to the light; its angle; and
/// the uniform from the near end, with what it leaves.
pub fn beside<N: Known>(
    near: Option<N>,
    far: [N; 2],
    [to_near, to_far]: [N; 2],
    angle: N,
    [w, rest]: [N; 2],
    sines: impl Fn([N; 2]) -> [N; 2],
) -> N {
    let [x, y] = sines([rest, w].map(|part| part * angle));
    between(near, far, [to_far * x, to_near * y])
}

/// The same from the near end, of uniforms below 2⁻⁶⁰.
pub fn next_to<N: Number>(
    [w, angle, turn]: [N; 3],
    extent: N,
    [to_near, to_far]: [N; 2],
    sine: N,
) -> N {
    let sum = to_far * sine;
    w * (to_near * angle * turn * (extent / sum))
}

/// What is kept of a side: its end, its distance to the light and its angle.
fn side(warp: &impl Debug, name: &str) -> [f32; 3] {
    let text = format!("{warp:?}");
    let (_, of) = text
        .split_once(&format!(" {name}: Side {{"))
        .expect("a side");
    let numbers = of
        .split(['}', ','])
        .map(|field| field.rsplit(' ').find(|word| !word.is_empty()));
    let numbers: Vec<f32> = numbers
        .take(3)
        .map(|word| word.expect("a number").parse().expect("a number"))
        .collect();
    [numbers[0], numbers[1], numbers[2]]
}

/// The number that is kept last under a name.
fn last(warp: &impl Debug, name: &str) -> f32 {
    let text = format!("{warp:?}");
    let (_, of) = text.rsplit_once(&format!(" {name}: ")).expect("a field");
    of.split([',', ' '])
        .next()
        .expect("its end")
        .parse()
        .expect("a number")
}

/// A sample by the operations that are examined, with angles that are so many ulp larger; nothing where it is made otherwise.
fn by_operations<T: Tier>(warp: &EquiAngular<T>, u: f32, ulps: u32) -> Option<f32> {
    let [low, high] = ["low", "high"].map(|name| side(warp, name));
    let more = |x: f32| f32::from_bits(x.to_bits() + ulps);
    let (angle, foot) = (more(last(warp, "angle")), last(warp, "foot"));
    let sines = |turns: [f32; 2]| turns.map(|t| T::sincos_turns(t).0);
    let v = 1.0 - u;
    let t = if foot >= 0.0 {
        let ([end, r, own], part) = if u < foot { (low, u) } else { (high, v) };
        across([warp.distance(), end, r], [more(own), angle], part, sines)[0]
    } else {
        let ([near, far], parts) = if low[0] >= 0.0 {
            ([low, high], [u, v])
        } else {
            ([high, low], [v, u])
        };
        let (extent, radii) = (far[0] - near[0], [near[1], far[1]]);
        if angle == f32::from_bits(ulps) {
            // Uniforms stand for sines.
            between(
                Some(near[0]),
                [far[0], extent],
                [radii[1] * parts[1], radii[0] * parts[0]],
            )
        } else if f64::from(parts[0]) < LINEAR {
            near[0]
                + next_to(
                    [parts[0], angle, TAU as f32],
                    extent,
                    radii,
                    sines([angle; 2])[0],
                )
        } else {
            beside(Some(near[0]), [far[0], extent], radii, angle, parts, sines)
        }
    };
    Some(t.clamp(low[0], high[0]))
}

/// A distance and the ends of a segment of any kind.
fn segment(k: u32) -> [f32; 3] {
    let [d, a] = [k, k + 1].map(|k| any_between(spread(k), 1e-6, 1e6));
    let b = match k % 4 {
        0 => a * any_between(spread(k + 2), 1.0001, 2.0),
        _ => a + any_between(spread(k + 2), 1e-6, 1e6),
    };
    match k % 3 {
        0 => [d, a, b],
        1 => [d, -b, -a],
        _ => [d, -a, b],
    }
}

fn samples_are_made_so<T: Tier>() {
    let links = Links::of::<T>(ANGLE, 0.0);
    let of = by_name("EquiAngular", T::NAME);
    let mut noticed = 0;
    for k in 0..*DRAWS {
        let [d, a, b] = segment(5 * k);
        let Ok(warp) = EquiAngular::<T>::new(d, a, b) else {
            continue;
        };
        let u = if k % 16 == 0 { 1e-19 } else { uniform(k) };
        let x = warp.sample(u);
        assert_eq!(
            Some(x),
            by_operations(&warp, u, 0),
            "{} {d} {a} {b} {u}",
            T::NAME
        );
        noticed += u32::from(Some(x) != by_operations(&warp, u, 1));
        // What is kept is as good as is said.
        let within = |is: f32, due: f64, units: f64| {
            (f64::from(is) / due - 1.0).abs() <= (units + 1e-4) * UNIT
        };
        let [p, q, e] = [d, a, b].map(f64::from);
        for (name, end) in [("low", q), ("high", e)] {
            let [_, r, _] = side(&warp, name);
            assert!(within(r, p.hypot(end), 1.5), "{d} {end} {r}");
        }
        let angle = last(&warp, "angle");
        let (due, quotient, inputs) = if a < 0.0 && b > 0.0 {
            continue;
        } else {
            let (y, x) = (p * (e - q), p * p + q * e);
            (y.atan2(x) / TAU, y / x, 2.0)
        };
        assert!(
            angle == 0.0 || within(angle, due, links.turns(Range::only(quotient), inputs)),
            "{d} {a} {b}"
        );
        // In real numbers it is the truth.
        let entry = (of.build)(&[d, a, b]).expect("a segment");
        let exact = |u: f64| {
            let [near, far] = if q >= 0.0 { [q, e] } else { [e, q] };
            let parts = if q >= 0.0 { [u, 1.0 - u] } else { [1.0 - u, u] };
            let sines = |turns: [f64; 2]| turns.map(|t| (TAU * t).sin());
            beside(
                Some(near),
                [far, far - near],
                [near, far].map(|end| p.hypot(end)),
                due,
                parts,
                sines,
            )
        };
        let (made, truth) = (
            exact(u.into()),
            entry.truth.sample([u.into(), 0.0, 0.0, 0.0])[0],
        );
        assert!(
            (made - truth).abs() <= 1e-10 * truth.abs().max(1e-20),
            "{d} {a} {b} {u}: {made} {truth}"
        );
    }
    assert!(noticed > *DRAWS / 8, "{noticed} bits differ");
}

#[test]
fn equi_angular_samples_are_quotients_of_sines() {
    samples_are_made_so::<Libm>();
    samples_are_made_so::<Poly>();
    // The angle about the diagonal is that of the crate, and a coefficient an ulp larger is noticed.
    let mut wrong = ANGLE;
    wrong[0] = f32::from_bits(wrong[0].to_bits() + 1);
    let mut noticed = 0;
    for k in 0..*DRAWS {
        let x = any_between(k, 1e-6, 1e6);
        let y = x * any_between(spread(k), 0.4143, 1.0);
        let z = (y - x) / (y + x);
        let angle = Poly::atan2_turns(y, x);
        assert_eq!(angle, from_the_diagonal(z, ANGLE));
        noticed += u32::from(angle != from_the_diagonal(z, wrong));
    }
    assert!(noticed > 0);
}
