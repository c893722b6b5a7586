//! Directions to a sphere that is seen from a point: 1 - cos θ, which is a part of that of the rim, an azimuth, and the frame about the
//! direction of the centre, written over any kind of number. On `f32` the bits are those of the crate, and on `f64` it is the truth.

use crate::fisher::Halves;
use crate::laws::by_name;
use crate::maps::mirrored;
use crate::number::Number;
use crate::programs::{DRAWS, between, kept, uniform};
use crate::rounding::UNIT;
use host::truth::SeenSphere;
use microwarp::Warp;
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::warp::VisibleSphere;
use std::f64::consts::TAU;

/// k, which is 1 - cos θ of the rim, of the square of the distance and of the radius.
pub fn of_rim<N: Number>(square: N, radius: N) -> N {
    let r2 = radius * radius;
    let (distance, rim) = (square.sqrt(), (square - r2).sqrt());
    r2 / (square + distance * rim)
}

/// A unit vector after the step that corrects its length.
fn corrected<N: Number>([x, y, z]: [N; 3]) -> [N; 3] {
    let excess = (z * z - x.like(1.0)) + (x * x + y * y);
    [x, y, z].map(|c| c - c * (x.like(0.5) * excess))
}

/// A direction turned by the frame of Duff and others about a normal with a z of this sign.
pub fn turned<N: Number>([x, y, z]: [N; 3], local: [N; 3], sign: f32) -> [N; 3] {
    let (one, sign) = (x.like(1.0), x.like(sign));
    let minus = |x: N| x * x.like(-1.0);
    let a = minus(one) / (sign + z);
    let b = x * y * a;
    let tangent = [one + sign * x * x * a, sign * b, minus(sign * x)];
    let bitangent = [b, sign + y * y * a, minus(y)];
    let ([p, q, r], normal) = (local, [x, y, z]);
    [0, 1, 2].map(|i| p * tangent[i] + q * bitangent[i] + r * normal[i])
}

/// How far k is off where it is not made plainly, relatively. In sums of two numbers d² - r² keeps 2⁻⁸ of what it is rounded by, and so
/// cos θmax is off by 5/4 roundings and by 1 of its root and half of 1 of the quotient below that, k by less than half of that and by 1.
pub const CLOSE: f64 = 2.5 * UNIT;

/// A direction by the operations that are examined, with k so many ulp larger than it is.
fn by_operations<T: Tier>(sphere: &VisibleSphere<T>, u: [f32; 2], ulps: u32) -> [f32; 3] {
    let (point, centre, radius) = (sphere.point(), sphere.centre(), sphere.radius());
    let sides: [f32; 3] = std::array::from_fn(|i| centre[i] - point[i]);
    let [x, y, z] = sides;
    let square = x * x + y * y + z * z;
    let plain = square - radius * radius >= 0.25 * square;
    let (k, normal) = if plain {
        let inverse = 1.0 / square.sqrt();
        (of_rim(square, radius), sides.map(|x| x * inverse))
    } else {
        let distance = square.sqrt();
        (sphere.one_minus_cos(), sides.map(|x| x / distance))
    };
    let k = f32::from_bits(k.to_bits() + ulps);
    let ([sin, cos], (s, c)) = (Halves::place(u[0] * k), mirrored::<T>(u[1]));
    let sign = 1.0_f32.copysign(z);
    turned(corrected(normal), [sin * c, sin * s, cos], sign)
}

fn directions_are_made_so<T: Tier>() {
    let of = by_name("VisibleSphere", T::NAME);
    let mut noticed = 0;
    for i in 0..*DRAWS {
        let number = |j: u32| 4.0 * uniform(7 * i + j + *DRAWS) - 2.0;
        let ([a, b, c], [d, e, f]) = ([0, 1, 2].map(number), [3, 4, 5].map(number));
        let exact = SeenSphere::new([a, b, c], [d, e, f], 1.0).distance;
        if exact == 0.0 {
            continue;
        }
        // Of all sizes, next to the surface and inside.
        let part = match i % 4 {
            0 => 1.0 - between(i, 1e-7, 0.9),
            1 => 1.0 + between(i, 1e-7, 1.0),
            _ => between(i, 1e-6, 0.9),
        };
        let parameters = [a, b, c, d, e, f, part * exact as f32];
        let sphere = VisibleSphere::<T>::new([a, b, c], [d, e, f], parameters[6]);
        let sphere = sphere.expect("a sphere");
        let u = [i, i + *DRAWS].map(uniform);
        let made = by_operations(&sphere, u, 0);
        assert_eq!(sphere.sample(u), made, "{} {parameters:?} {u:?}", T::NAME);
        noticed += u32::from(made != by_operations(&sphere, u, 1));

        let exact = SeenSphere::new([a, b, c], [d, e, f], parameters[6]);
        let off = f64::from(sphere.one_minus_cos()) / exact.k() - 1.0;
        let plain = kept(&sphere, "gap") >= 0.25 * kept(&sphere, "distance").powi(2);
        assert!(
            off.abs() <= if plain { 14.0 * UNIT } else { CLOSE },
            "{off}"
        );
        let u = u.map(f64::from);
        let [sin, cos] = Halves::place(u[0] * exact.k());
        let (s, c) = (TAU * u[1]).sin_cos();
        let normal = exact.axis.map(|x| x / exact.distance);
        let sign = 1.0_f32.copysign(normal[2] as f32);
        let point = turned(normal, [sin * c, sin * s, cos], sign);
        let entry = (of.build)(&parameters).expect("a sphere");
        let due = entry.truth.sample([u[0], u[1], 0.0, 0.0]);
        assert!(
            (0..3).all(|i| (point[i] - due[i]).abs() <= 1e-10),
            "{parameters:?} {u:?}: {point:?} {due:?}"
        );
    }
    // An ulp more of k changes bits.
    assert!(noticed > *DRAWS / 8, "{noticed} bits differ");
}

#[test]
fn directions_to_spheres_are_a_part_of_k_and_a_frame() {
    directions_are_made_so::<Libm>();
    directions_are_made_so::<Poly>();
}
