//! Frames and spherical coordinates: no singular normal, no singular point, and the errors they state.

use host::errors::raise;
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::warp::{Cone, Spherical};
use microwarp::{
    Warp, uniform,
    warp::{Frame, Oriented},
};
use rand_pcg::Pcg32;
use std::f64::consts::TAU;

fn wide(x: [f32; 3]) -> [f64; 3] {
    x.map(f64::from)
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Normals everywhere, near and at every axis, and of every length.
fn normals() -> Vec<[f32; 3]> {
    let mut normals = vec![];
    let small = [
        0.0, -0.0, 1e-45, -1e-30, 1e-12, 1e-7, -6e-8, 1e-4, -1e-3, 0.1,
    ];
    for a in small {
        for b in small {
            for c in [1.0, -1.0] {
                normals.extend([[a, b, c], [c, a, b], [a, c, b]]);
            }
        }
    }
    let mut rng = Pcg32::new(5, 5);
    let mut number = || 2.0 * uniform::grid(&mut rng) - 1.0;
    for _ in 0..1_000_000 {
        normals.push([number(), number(), number()]);
    }
    for scale in [1e-45, 1e-38, 1e-20, 1e20, 3e38] {
        normals.push([0.3 * scale, -0.7 * scale, scale]);
    }
    normals.retain(|n| *n != [0.0; 3]);
    normals
}

/// The bounds that the documentation of `Frame` states: the lengths of the axes, their angles, the
/// direction of the third, and of directions turned into the world and back.
const FRAME_ERRORS: [(&str, f64); 6] = [
    ("length", 1.3e-7),
    ("orthogonal", 3.8e-7),
    ("normal", 1.4e-7),
    ("turned", 5.1e-7),
    ("turned, length", 3.9e-7),
    ("there and back", 7.4e-7),
];

/// The worst normals, and directions about them, that a search by steps of a few ulp has found.
const WORST: [[[f32; 3]; 2]; 6] = [
    [
        [-0.208_627_37, 0.133_775_6, 7.410_459_5e-5],
        [0.0, 0.0, 1.0],
    ],
    [
        [-0.047_246_91, 0.529_150_3, 0.000_510_729_8],
        [0.0, 0.0, 1.0],
    ],
    [
        [0.876_895_3, 0.886_993_7, 0.001_654_073_2],
        [-0.706_027_45, -0.305_316_06, 0.002_709_663_2],
    ],
    [
        [0.386_494_76, 0.392_713_3, -0.000_164_372_96],
        [0.711_865_5, -0.914_456_5, -0.849_297_76],
    ],
    [
        [0.936_351_4, 0.912_272_93, -0.001_792_424_8],
        [-0.187_273_79, 0.545_586_47, 0.816_854_95],
    ],
    [
        [-0.553_858_76, 0.887_518_7, 0.002_190_133],
        [-0.598_977_6, 0.299_184_86, -0.116_624_97],
    ],
];

/// The unit vector that the crate makes of one.
fn unit(direction: [f32; 3]) -> [f32; 3] {
    Frame::new(direction).unwrap().normal()
}

fn length(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}

fn apart(a: [f64; 3], b: [f64; 3]) -> f64 {
    length([0, 1, 2].map(|k| a[k] - b[k]))
}

/// The errors of three axes, given with the normal they should stand on.
fn axis_errors(axes: [[f64; 3]; 3], normal: [f32; 3]) -> [f64; 3] {
    let n = wide(normal);
    let exact = n.map(|c| c / length(n));
    let [t, b, axis] = axes;
    let right_handed = [
        t[1] * b[2] - t[2] * b[1],
        t[2] * b[0] - t[0] * b[2],
        t[0] * b[1] - t[1] * b[0],
    ];
    // Of three numbers or a NaN the largest, or NaN.
    let largest = |errors: [f64; 3]| {
        errors
            .into_iter()
            .fold(0.0, |m: f64, e| if e <= m { m } else { e })
    };
    assert!(dot(right_handed, axis) > 0.5, "{normal:?}: {axes:?}");
    [
        largest(axes.map(|a| (length(a) - 1.0).abs())),
        largest([(t, b), (t, axis), (b, axis)].map(|(p, q)| dot(p, q).abs())),
        apart(axis, exact),
    ]
}

#[test]
fn every_normal_has_an_orthonormal_frame() {
    let mut rng = Pcg32::new(8, 8);
    let mut worst = [0.0_f64; 6];
    // What a frame would show whose normal is divided by its length and no more.
    let mut unmended = [0.0_f64; 2];
    let random = normals().into_iter().map(|normal| {
        let n = [(); 3].map(|()| 2.0 * f64::from(uniform::grid(&mut rng)) - 1.0);
        (normal, n.map(|c| (c / length(n)) as f32))
    });
    let kept = WORST.map(|[normal, local]| (normal, unit(local)));
    for (normal, local) in random.chain(kept) {
        let frame = Frame::new(normal).unwrap_or_else(|e| panic!("{normal:?}: {e}"));
        let [tangent, bitangent] = frame.tangents().map(wide);
        let axes = [tangent, bitangent, wide(frame.normal())];
        let [lengths, angles, direction] = axis_errors(axes, normal);
        let world = frame.to_world(local);
        let exact = turned(wide(local), normal);
        let errors = [
            lengths,
            angles,
            direction,
            apart(wide(world), exact),
            (length(wide(world)) - length(wide(local))).abs(),
            apart(wide(frame.to_local(world)), wide(local)),
        ];
        for ((worst, error), (what, bound)) in worst.iter_mut().zip(errors).zip(FRAME_ERRORS) {
            assert!(error <= bound, "{normal:?}: {what} {error:.2e}");
            *worst = worst.max(error);
        }
        let [lengths, angles, _] =
            axis_errors(axes_of(plainly_normalised(normal)).map(wide), normal);
        unmended = [unmended[0].max(lengths), unmended[1].max(angles)];
    }
    println!("frames: {worst:?}, unmended {unmended:?}");
    for (worst, (what, bound)) in worst.iter().zip(FRAME_ERRORS) {
        assert!(bound <= 1.4 * worst, "stale: {what} {worst:.2e}");
    }
    assert!(unmended[0] > FRAME_ERRORS[0].1 && unmended[1] > worst[1]);
}

/// The normal divided by its rounded length.
fn plainly_normalised(normal: [f32; 3]) -> [f32; 3] {
    let largest = normal.iter().fold(0.0_f32, |m, c| m.max(c.abs()));
    let [x, y, z] = normal.map(|c| c / largest);
    let length = (x * x + y * y + z * z).sqrt();
    [x, y, z].map(|c| c / length)
}

/// The frame of Duff and others on a unit vector, in `f32`.
fn axes_of([x, y, z]: [f32; 3]) -> [[f32; 3]; 3] {
    let sign = 1.0_f32.copysign(z);
    let a = -1.0 / (sign + z);
    let b = x * y * a;
    [
        [1.0 + sign * x * x * a, sign * b, -sign * x],
        [b, sign + y * y * a, -y],
        [x, y, z],
    ]
}

/// A local direction turned by the exact frame.
fn turned(local: [f64; 3], normal: [f32; 3]) -> [f64; 3] {
    let n = wide(normal);
    let [x, y, z] = n.map(|c| c / length(n));
    let sign = 1f64.copysign(z);
    let a = -1.0 / (sign + z);
    let axes = [
        [1.0 + sign * x * x * a, sign * x * y * a, -sign * x],
        [x * y * a, sign + y * y * a, -y],
        [x, y, z],
    ];
    [0, 1, 2].map(|k| (0..3).map(|i| local[i] * axes[i][k]).sum())
}

#[test]
fn turning_there_and_back_is_the_identity() {
    let mut rng = Pcg32::new(6, 6);
    for normal in normals().into_iter().step_by(101) {
        let frame = Frame::new(normal).unwrap();
        let local = [(); 3].map(|()| 2.0 * uniform::grid(&mut rng) - 1.0);
        let back = frame.to_local(frame.to_world(local));
        for (a, b) in back.into_iter().zip(local) {
            assert!((a - b).abs() <= 8.0e-7, "{normal:?} {local:?} {back:?}");
        }
        // The z axis goes to the normal exactly.
        assert_eq!(frame.to_world([0.0, 0.0, 1.0]), frame.normal());
    }
}

/// Azimuths of every binade and sign, and next to every half turn that is one: `f64` reduces each exactly.
fn azimuths() -> impl Iterator<Item = f32> {
    let bits = (0..0x7f80_0000_u32).step_by(4_999);
    let halves = (0..24).map(|k| (1 << k) as f32 + 0.5);
    bits.map(f32::from_bits)
        .chain(halves)
        .flat_map(|phi| [phi, -phi])
}

/// The largest error of the two equatorial coordinates over all azimuths.
fn equatorial_error(point: impl Fn(f32) -> [f32; 2]) -> f64 {
    let mut worst = 0.0_f64;
    for phi in azimuths() {
        let (sin, cos) = (TAU * (f64::from(phi) % 1.0)).sin_cos();
        let [x, y] = point(phi).map(f64::from);
        let error = (x - cos).abs().max((y - sin).abs());
        raise(&mut worst, error);
    }
    worst
}

fn any_azimuth<T: Tier>() {
    let found = equatorial_error(|phi| {
        let [x, y, z] = Spherical::<T>::from_turns(1.0, 0.25, phi)
            .unwrap()
            .to_cartesian();
        assert_eq!(z, 0.0);
        [x, y]
    });
    assert!(found <= CARTESIAN_ERROR, "{}: {found:.2e}", T::NAME);
    // The reduction of few turns, which once stood here, fails the same examination.
    let few = equatorial_error(|phi| T::polar(1.0, phi).into());
    assert!(few > 1.0, "{}: {few:.2e}", T::NAME);
}

#[test]
fn any_number_of_turns_is_reduced_exactly() {
    any_azimuth::<Libm>();
    any_azimuth::<Poly>();
    let of = |phi| {
        Spherical::<Poly>::from_turns(1.0, 0.25, phi)
            .unwrap()
            .to_cartesian()
    };
    assert_eq!(of(1_048_576.5), [-1.0, 0.0, 0.0]);
    assert_eq!(of(-3.475_867e13), [1.0, 0.0, 0.0]);
}

/// A large z takes no digits from the azimuth.
#[test]
fn the_azimuth_beside_a_far_larger_z_is_kept() {
    let s = Spherical::<Poly>::from_cartesian([0.0, 1.0e-30, 1.0e30]);
    assert_eq!(
        (s.radius(), s.theta_turns(), s.phi_turns()),
        (1.0e30, 0.0, 0.25)
    );
}

/// The bounds that the documentation of `Spherical` states: the radius relative, coordinates relative to
/// the radius, and angles in turns.
const RADIUS_ERROR: f64 = 1.4e-7;
const CARTESIAN_ERROR: f64 = 1.5e-7;
const ANGLE_ERROR: f64 = 9.8e-8;

fn spherical_coordinates<T: Tier>() {
    let (mut worst_radius, mut worst_point, mut worst_angle) = (0.0_f64, 0.0_f64, 0.0_f64);
    for point in normals() {
        let s = Spherical::<T>::from_cartesian(point);
        let p = wide(point);
        let r = dot(p, p).sqrt();
        let theta = p[0].hypot(p[1]).atan2(p[2]) / TAU;
        // On the axis every azimuth is right, and 0 is what is given.
        let phi = if p[0] == 0.0 && p[1] == 0.0 {
            0.0
        } else {
            p[1].atan2(p[0]) / TAU
        };
        let relative = (f64::from(s.radius()) - r).abs() / r;
        if (1e-30..1e30).contains(&r) {
            assert!(relative <= RADIUS_ERROR, "{point:?}: {s:?}");
            worst_radius = worst_radius.max(relative);
        }
        let off = (f64::from(s.phi_turns()) - phi).rem_euclid(1.0);
        let angles = [
            (f64::from(s.theta_turns()) - theta).abs(),
            off.min(1.0 - off),
        ];
        for error in angles {
            assert!(error <= ANGLE_ERROR, "{point:?}: {s:?} {angles:?}");
            worst_angle = worst_angle.max(error);
        }
        if (1e-30..1e30).contains(&r) {
            for (a, b) in s.to_cartesian().into_iter().zip(p) {
                // Angles of 24 bits place a point to 2π 2^-25 of its radius at best.
                let error = (f64::from(a) - b).abs() / r;
                assert!(error <= 2.0 * TAU * ANGLE_ERROR, "{point:?}: {s:?}");
            }
        }
        let exact = {
            let (theta, phi) = (
                TAU * f64::from(s.theta_turns()),
                TAU * f64::from(s.phi_turns()),
            );
            [
                theta.sin() * phi.cos(),
                theta.sin() * phi.sin(),
                theta.cos(),
            ]
        };
        let radius = f64::from(s.radius());
        for (a, b) in s.to_cartesian().into_iter().zip(exact) {
            let error = (f64::from(a) / radius - b).abs();
            if radius > 1e-30 {
                assert!(error <= CARTESIAN_ERROR, "{s:?}");
                worst_point = worst_point.max(error);
            }
        }
        let sine = (TAU * f64::from(s.theta_turns())).sin();
        assert!((f64::from(s.solid_angle_jacobian()) - sine).abs() <= 1.0e-7);
    }
    for (worst, stated) in [(worst_radius, RADIUS_ERROR), (worst_point, CARTESIAN_ERROR)] {
        assert!(
            stated <= 1.25 * worst,
            "stale: {stated:.2e}, measured {worst:.2e}"
        );
    }
    println!(
        "{}: {worst_radius:.2e} {worst_point:.2e} {worst_angle:.2e}",
        T::NAME
    );
}

#[test]
fn spherical_coordinates_keep_their_stated_errors() {
    spherical_coordinates::<Libm>();
    spherical_coordinates::<Poly>();
}

#[test]
fn poles_and_origin_have_coordinates() {
    let of = Spherical::<Poly>::from_cartesian;
    let parts = |s: Spherical<Poly>| (s.radius(), s.theta_turns(), s.phi_turns());
    assert_eq!(parts(of([0.0, 0.0, 2.0])), (2.0, 0.0, 0.0));
    assert_eq!(parts(of([0.0, 0.0, -2.0])), (2.0, 0.5, 0.0));
    assert_eq!(parts(of([0.0, 0.0, 0.0])), (0.0, 0.0, 0.0));
    assert_eq!(parts(of([-1.0, 0.0, 0.0])), (1.0, 0.25, 0.5));
    assert_eq!(of([f32::NAN, 1.0, f32::INFINITY]).radius(), 1.0);
    let far = of([f32::MAX, f32::MAX, f32::MAX]);
    assert_eq!(far.radius(), f32::MAX);
    assert!(far.volume_jacobian() == f32::MAX);
}

/// Up to 5e-7 rad beyond where a cone ends, its turned copy has its density, and a little farther there is none.
#[test]
fn the_rim_of_a_turned_cone_is_as_wide_as_stated() {
    for k in [0.1, 0.4, 0.6, 2.0 / 3.0, 0.7, 0.9, 1.0, 1.5_f32] {
        let cone = Cone::<Poly>::from_one_minus_cos(k).unwrap();
        let rim = (1.0 - f64::from(k)).acos();
        for normal in [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.3, -0.9, -0.4]] {
            let turned_cone = Oriented::new(cone, Frame::new(normal).unwrap());
            for azimuth in 0..100 {
                let (sin, cos) = (f64::from(azimuth) / 100.0 * TAU).sin_cos();
                let local = |beyond: f64| {
                    let (radius, z) = (rim + beyond).sin_cos();
                    [radius * cos, radius * sin, z]
                };
                let density =
                    |beyond| turned_cone.pdf(turned(local(beyond), normal).map(|x| x as f32));
                let steps = (0..100).map(|n| 2e-8 * f64::from(n));
                let within = |beyond: &f64| cone.pdf(local(*beyond).map(|x| x as f32)) > 0.0;
                let end = steps.take_while(within).last().unwrap();
                assert!(density(end + 2.5e-7) == density(-1e-3), "{k} {normal:?}");
                assert!(density(end + 1e-6) == 0.0, "{k} {normal:?}");
            }
        }
    }
}
