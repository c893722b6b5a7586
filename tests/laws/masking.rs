//! Masking and shadowing of GGX, and the distribution of its normals, beside Smith's Λ of the tangent in `f64`.

use host::errors::or_infinite;
use host::speed;
use microwarp::poly::{Ggx, GgxVisible};
use microwarp::{Error, uniform};
use rand_core::Rng;
use rand_pcg::Pcg32;

/// The errors that the documentation states: of G₁, of G₂/G₁, of visibility, of D, and of G₁ of a light.
const STATED: [f64; FIGURES] = [5.5e-7, 8.5e-7, 7e-7, 1.1e-6, 3.5e-7];
const NAMES: [&str; FIGURES] = ["G1", "G2/G1", "visibility", "D", "G1 of a light"];
const FIGURES: usize = 5;

/// A case: view and light above the surface, a normal, and the roughness.
#[derive(Clone, Copy)]
struct Case {
    view: [f32; 3],
    light: [f32; 3],
    normal: [f32; 3],
    alpha: [f32; 2],
}

/// A unit vector whose cosine is from 1 down to 1e-30.
fn direction(rng: &mut Pcg32) -> [f32; 3] {
    let z = match rng.next_u32() % 8 {
        0 => 1.0,
        1 => 1e-30,
        2 => f64::from(uniform::open(rng)),
        _ => 10f64.powf(-30.0 * f64::from(uniform::grid(rng))),
    };
    let turn = match rng.next_u32() % 4 {
        0 => 0.0,
        1 => 0.25,
        _ => f64::from(uniform::grid(rng)),
    };
    let (s, c) = (std::f64::consts::TAU * turn).sin_cos();
    let flat = (1.0 - z * z).sqrt();
    [flat * c, flat * s, z].map(|x| x as f32)
}

fn roughness(rng: &mut Pcg32) -> [f32; 2] {
    let mut one = || match rng.next_u32() % 4 {
        0 => 1e-4,
        1 => 1.0,
        _ => 10_f32.powf(-4.0 * uniform::grid(rng)).clamp(1e-4, 1.0),
    };
    let [x, y] = [one(), one()];
    if rng.next_u32() % 2 == 0 {
        [x, x]
    } else {
        [x, y]
    }
}

fn case(rng: &mut Pcg32) -> Case {
    Case {
        view: direction(rng),
        light: direction(rng),
        normal: direction(rng),
        alpha: roughness(rng),
    }
}

/// Λ of the slope that a direction has, measured in roughness.
fn lambda([ax, ay]: [f64; 2], [x, y, z]: [f64; 3]) -> f64 {
    let slope = ((ax * x).powi(2) + (ay * y).powi(2)) / (z * z);
    0.5 * ((1.0 + slope).sqrt() - 1.0)
}

fn unit(v: [f64; 3]) -> [f64; 3] {
    let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
    v.map(|x| x / length)
}

/// The figures by Λ, and D by the tangent and the cosine. The view is one of any length; light and normal are as they are.
fn exact(case: &Case) -> [f64; FIGURES] {
    let alpha = case.alpha.map(f64::from);
    let view = unit(case.view.map(f64::from));
    let [light, normal] = [case.light, case.normal].map(|v| v.map(f64::from));
    let (of_view, of_light) = (lambda(alpha, view), lambda(alpha, light));
    let both = 1.0 / (1.0 + of_view + of_light);
    let [x, y, z] = normal;
    let tangent = ((x / alpha[0]).powi(2) + (y / alpha[1]).powi(2)) / (z * z);
    let facets = std::f64::consts::PI * alpha[0] * alpha[1] * z.powi(4) * (1.0 + tangent).powi(2);
    [
        1.0 / (1.0 + of_view),
        both * (1.0 + of_view),
        both / (4.0 * view[2] * light[2]),
        1.0 / facets,
        1.0 / (1.0 + of_light),
    ]
}

fn ours(case: &Case) -> Result<[f32; FIGURES], Error> {
    let visible = GgxVisible::new(case.view, case.alpha)?;
    let surface = Ggx::new(case.alpha)?;
    Ok([
        visible.g1(),
        visible.unmasked(case.light),
        visible.visibility(case.light),
        surface.distribution(case.normal),
        surface.g1(case.light),
    ])
}

/// As most renderers write them: by the square of the tangent and Λ, and D by 1 − z².
fn by_tangents(case: &Case) -> [f32; FIGURES] {
    let alpha = case.alpha;
    let lambda = |[x, y, z]: [f32; 3]| {
        let square = z * z;
        let tangent = (1.0 - square) / square;
        let flat = (x * x + y * y).max(1e-30);
        let (c, s) = (x * x / flat, y * y / flat);
        let slope = (c * alpha[0] * alpha[0] + s * alpha[1] * alpha[1]) * tangent;
        0.5 * ((1.0 + slope).sqrt() - 1.0)
    };
    let (view, light) = (lambda(case.view), lambda(case.light));
    let both = 1.0 / (1.0 + view + light);
    let [x, y, z] = case.normal;
    let flat = (x * x + y * y).max(1e-30);
    let slopes = (x * x / (alpha[0] * alpha[0]) + y * y / (alpha[1] * alpha[1])) / flat;
    let sum = (1.0 - z * z) * slopes + z * z;
    let facets = std::f32::consts::PI * alpha[0] * alpha[1] * sum * sum;
    [
        1.0 / (1.0 + view),
        both * (1.0 + view),
        both / (4.0 * case.view[2] * case.light[2]),
        1.0 / facets,
        1.0 / (1.0 + light),
    ]
}

/// The relative errors of the figures; infinite for NaN.
fn errors(case: &Case, of: impl Fn(&Case) -> [f32; FIGURES]) -> [f64; FIGURES] {
    let (got, want) = (of(case), exact(case));
    std::array::from_fn(|i| or_infinite((f64::from(got[i]) / want[i] - 1.0).abs()))
}

/// The largest error of each figure over random cases, and where it is.
fn worst(cases: u32, of: impl Fn(&Case) -> [f32; FIGURES]) -> [(f64, Case); FIGURES] {
    let mut rng = Pcg32::new(2, 34);
    let mut worst = [(0.0, case(&mut rng)); FIGURES];
    for _ in 0..cases {
        let case = case(&mut rng);
        for (worst, error) in worst.iter_mut().zip(errors(&case, &of)) {
            if error > worst.0 {
                *worst = (error, case);
            }
        }
    }
    worst
}

/// A case near another one: one of its numbers changed by some of its digits. Light and normal stay of length 1.
fn near(case: &Case, rng: &mut Pcg32) -> Case {
    let mut near = *case;
    let change = 2_f32.powi(-((rng.next_u32() % 23) as i32)) * (2.0 * uniform::grid(rng) - 1.0);
    let (k, which) = ((rng.next_u32() % 3) as usize, rng.next_u32() % 4);
    let changed = match which {
        0 => &mut near.view[k],
        1 => &mut near.light[k],
        2 => &mut near.normal[k],
        _ => &mut near.alpha[k % 2],
    };
    *changed += *changed * change;
    near.alpha = near.alpha.map(|a| a.clamp(1e-4, 1.0));
    for v in [&mut near.light, &mut near.normal] {
        *v = unit(v.map(f64::from)).map(|x| x as f32);
    }
    let horizon = |v: [f32; 3]| unit(v.map(f64::from))[2] < 1e-30;
    // The view has any length, but does not wander to where a square leaves the range.
    let [x, y, z] = near.view.map(f64::from);
    let sized = (1e-6..1e6).contains(&(x * x + y * y + z * z));
    let mut all = [near.view, near.light, near.normal].into_iter();
    if !sized || all.any(horizon) {
        *case
    } else {
        near
    }
}

/// The largest error of a figure that steps from a case lead to.
fn climbed(mut case: Case, figure: usize, steps: u32) -> (f64, Case) {
    let mut rng = Pcg32::new(3, 34);
    let of = |case: &Case| errors(case, |case| ours(case).unwrap())[figure];
    let mut error = of(&case);
    for _ in 0..steps {
        let next = near(&case, &mut rng);
        let there = of(&next);
        if there >= error {
            (error, case) = (there, next);
        }
    }
    (error, case)
}

/// What earlier searches have found, in bits: view, light, normal and roughness.
const FOUND: [[u32; 11]; FIGURES] = [
    [
        3208615148,
        3207187730,
        981945979,
        0,
        0,
        0x3f80_0000,
        0,
        0,
        0x3f80_0000,
        1034622067,
        985659025,
    ],
    [
        1049201524,
        1064736489,
        898368992,
        3212284264,
        3196211954,
        849114653,
        0,
        0,
        0x3f80_0000,
        982155819,
        982155822,
    ],
    [
        1050903253,
        1061846286,
        1057331969,
        1061824113,
        1058869803,
        885448705,
        0,
        0,
        0x3f80_0000,
        1000586804,
        969707829,
    ],
    [
        0,
        0,
        0x3f80_0000,
        0,
        0,
        0x3f80_0000,
        3198086179,
        3209552094,
        1057079528,
        958286607,
        1040252191,
    ],
    [
        989942409,
        0,
        160768618,
        0,
        1065353174,
        991073470,
        0,
        0,
        0x3f80_0000,
        956722746,
        1049187943,
    ],
];

fn found() -> [Case; FIGURES] {
    FOUND.map(|bits| {
        let [a, b, c, d, e, f, g, h, i, x, y] = bits.map(f32::from_bits);
        Case {
            view: [a, b, c],
            light: [d, e, f],
            normal: [g, h, i],
            alpha: [x, y],
        }
    })
}

#[test]
fn masking_and_the_distribution_of_normals_keep_their_errors_down_to_the_horizon() {
    let cases = speed::of("views, lights and normals", 200_000, 20_000_000);
    let steps = speed::of("steps from the worst of them", 5_000, 500_000);
    let right = worst(cases, |case| ours(case).unwrap());
    let wrong = worst(10_000, by_tangents);
    let found = found();
    for (figure, (name, stated)) in NAMES.iter().zip(STATED).enumerate() {
        let starts = [right[figure].1, found[figure]];
        let (right, case) = starts
            .map(|case| climbed(case, figure, steps))
            .into_iter()
            .fold((0.0, starts[0]), |a, b| if b.0 > a.0 { b } else { a });
        let (wrong, _) = wrong[figure];
        println!("{name}: {right:.3e} of {stated:.1e}; by tangents {wrong:.1e}");
        let numbers = [case.view, case.light, case.normal].concat();
        let bits = numbers.into_iter().chain(case.alpha).map(f32::to_bits);
        println!("{:?}", bits.collect::<Vec<_>>());
        assert!(right <= stated, "{name}: {right:e}");
        assert!(
            right >= stated / 2.5,
            "{name}: {right:e} is far below {stated:e}"
        );
        assert!(wrong > stated, "the control passes for {name}: {wrong:e}");
    }
}

#[test]
fn masking_ends_where_it_should() {
    let edge = GgxVisible::new([1.0, 0.0, 0.0], [0.3, 0.3]).unwrap();
    let steep = GgxVisible::new([0.6, 0.0, 0.8], [0.3, 0.7]).unwrap();
    let surface = Ggx::new([0.3, 0.7]).unwrap();
    assert_eq!(edge.g1(), 0.0);
    for z in [1.0, 0.3, 1e-20, 1e-38, 1e-45] {
        assert_eq!(
            edge.unmasked([1.0, 0.0, z]),
            1.0,
            "a view on the horizon, {z:e}"
        );
        assert!(steep.unmasked([1.0, 0.0, z]) <= 1.0);
        for visible in [&edge, &steep] {
            let visibility = visible.visibility([1.0, 0.0, z]);
            assert!(
                visibility > 0.0 && visibility <= f32::MAX,
                "{z:e}: {visibility}"
            );
        }
    }
    let any = [
        0.0,
        -0.0,
        1.0,
        -1.0,
        1e-45,
        1e30,
        f32::MAX,
        f32::INFINITY,
        f32::NAN,
    ];
    for x in any {
        for z in any {
            for visible in [&edge, &steep] {
                let (part, visibility) = (
                    visible.unmasked([x, 0.0, z]),
                    visible.visibility([x, 0.0, z]),
                );
                assert!((0.0..=1.0).contains(&part), "{x} {z}: {part}");
                assert!(
                    (0.0..=f32::MAX).contains(&visibility),
                    "{x} {z}: {visibility}"
                );
                if z <= 0.0 || z.is_nan() {
                    assert_eq!([part, visibility], [0.0; 2], "{x} {z}");
                }
            }
            let d = surface.distribution([x, 0.0, z]);
            assert!((0.0..=f32::MAX).contains(&d), "{x} {z}: {d}");
            let g1 = surface.g1([x, 0.0, z]);
            assert!((0.0..=1.0).contains(&g1), "{x} {z}: {g1}");
        }
    }
    assert_eq!(surface.distribution([1.0, 0.0, 0.0]), 0.0);
    assert_eq!(surface.g1([1.0, 0.0, 0.0]), 0.0);
    assert_eq!(surface.g1([0.0, 0.0, 1.0]), 1.0);
    assert_eq!(
        GgxVisible::new([0.0, 0.0, 1.0], [0.3; 2]).unwrap().g1(),
        1.0
    );
}
