//! Reflections off microfacets: their directions mirror the view, and their densities are those of the directions.

use host::speed;
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::warp::{GgxVisible, Reflection};
use microwarp::{Warp, uniform};
use rand_core::Rng;
use rand_pcg::Pcg32;
use std::f64::consts::{PI, TAU};

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn edge(rng: &mut Pcg32) -> f32 {
    match rng.next_u32() % 4 {
        0 => 0.0,
        1 => uniform::LARGEST,
        _ => uniform::grid(rng),
    }
}

/// A view at any height, every second one near the horizon, and roughnesses of all sizes.
fn scene(rng: &mut Pcg32) -> ([f32; 3], [f32; 2]) {
    let (s, c) = (TAU as f32 * uniform::grid(rng)).sin_cos();
    let height = match rng.next_u32() % 4 {
        0 => 0.0,
        1 => (-30.0 * uniform::grid(rng)).exp2(),
        _ => 2.0 * uniform::grid(rng),
    };
    let mut alpha = || (1e-4_f32.ln() * uniform::grid(rng)).exp().max(1e-4);
    let alpha = match height {
        0.0 => [1e-4, 1e-4],
        _ => [alpha(), alpha()],
    };
    ([c, s, height], alpha)
}

fn mirrors<T: Tier>() {
    let n = speed::of("reflections", 100_000, 3_000_000);
    let mut rng = Pcg32::new(31, 7);
    let mut worst = [0.0_f64; 3];
    for k in 0..n {
        let (view, alpha) = scene(&mut rng);
        let warp = match k % 2 {
            0 => GgxVisible::<T>::new(view, alpha),
            _ => GgxVisible::<T>::bounded(view, alpha),
        }
        .unwrap();
        let u = [edge(&mut rng), edge(&mut rng)];
        let Reflection {
            normal,
            direction,
            pdf,
        } = warp.reflect(u);
        let here = || format!("{view:?} {alpha:?} at {u:?}: {normal:?} {direction:?} {pdf}");
        assert_eq!(normal, warp.sample(u), "{}", here());
        assert_eq!(pdf, warp.reflected_pdf(normal), "{}", here());
        assert!(pdf > 0.0 && pdf <= f32::MAX, "{}", here());
        let [w, m, d] = [warp.view(), normal, direction].map(|v| v.map(f64::from));
        let mirrored = [0, 1, 2].map(|i| 2.0 * dot(w, m) * m[i] - w[i] - d[i]);
        let length = (dot(d, d).sqrt() - 1.0).abs();
        worst[0] = worst[0].max(length);
        worst[1] = worst[1].max(dot(mirrored, mirrored).sqrt());
        assert!(length <= 1e-6, "{}", here());
        assert!(dot(mirrored, mirrored).sqrt() <= 2e-6, "{}", here());
        // The Jacobian of the reflection, where the bare normal says w·m.
        let seen = dot(w, m);
        if seen > 1e-3 {
            let of_normal = f64::from(warp.pdf(normal));
            let relative = (f64::from(pdf) * 4.0 * seen / of_normal - 1.0).abs();
            worst[2] = worst[2].max(relative * seen);
            assert!(relative <= 1e-6 / seen, "{relative:e}: {}", here());
        }
    }
    println!("{}: length, mirror, density {worst:?}", T::NAME);
}

#[test]
fn a_reflection_mirrors_the_view_with_the_density_of_its_direction() {
    mirrors::<Libm>();
    mirrors::<Poly>();
}

/// A view has its normals whatever its length, to the bit: hosts take a shorter way for ordinary lengths.
#[test]
fn a_view_of_any_length_has_the_same_normals() {
    let mut rng = Pcg32::new(43, 7);
    let mut other = 0;
    for _ in 0..20_000 {
        let (view, alpha) = scene(&mut rng);
        let of = |by: f32| GgxVisible::<Poly>::new(view.map(|c| c * by), alpha).unwrap();
        let ordinary = of(1.0);
        for by in [-40.0, 40.0, 90.0] {
            assert_eq!(ordinary, of(f32::exp2(by)), "{view:?} {alpha:?} by 2^{by}");
        }
        // Lengths that are no powers of two round otherwise.
        other += usize::from(of(1.1) != ordinary);
    }
    assert!(other > 1_000, "{other}");
}

/// The integral of a density over all directions, those below the surface too, and the part of the reflections above it.
fn integral(warp: &GgxVisible<Poly>, density: impl Fn([f32; 3]) -> f32) -> f64 {
    let (rows, turns) = (600, 600);
    let w = warp.view().map(f64::from);
    let mut sum = 0.0;
    for i in 0..rows {
        let z = -1.0 + (f64::from(i) + 0.5) * 2.0 / f64::from(rows);
        for j in 0..turns {
            let (s, c) = (TAU * (f64::from(j) + 0.5) / f64::from(turns)).sin_cos();
            let sine = (1.0 - z * z).sqrt();
            let half = [sine * c + w[0], sine * s + w[1], z + w[2]];
            let length = dot(half, half).sqrt();
            let value = density(half.map(|x| (x / length) as f32));
            sum += f64::from(value);
        }
    }
    sum * 4.0 * PI / f64::from(rows * turns)
}

#[test]
fn the_density_of_reflections_adds_up_to_one_and_that_of_normals_does_not() {
    for (view, alpha) in [
        ([0.6, 0.0, 0.8], [0.5, 0.5]),
        ([0.5, -0.7, 0.2], [0.3, 0.8]),
        ([1.0, 0.0, 0.0], [1.0, 1.0]),
    ] {
        for warp in [
            GgxVisible::<Poly>::new(view, alpha),
            GgxVisible::<Poly>::bounded(view, alpha),
        ] {
            let warp = warp.unwrap();
            let right = integral(&warp, |m| warp.reflected_pdf(m));
            let without_jacobian = integral(&warp, |m| warp.pdf(m));
            println!("{view:?} {alpha:?}: {right}, {without_jacobian} without the Jacobian");
            assert!((right - 1.0).abs() <= 5e-3);
            assert!((without_jacobian - 1.0).abs() > 0.5);
        }
    }
}

/// The part of the reflections above the surface, and the integral of cos θ over the directions there that they estimate.
fn shares(warp: &GgxVisible<Poly>) -> (f64, f64) {
    let n = speed::of("reflections of each kind", 50_000, 2_000_000);
    let mut rng = Pcg32::new(5, 11);
    let (mut above, mut sum) = (0, 0.0);
    for _ in 0..n {
        let bounce = warp.reflect([uniform::grid(&mut rng), uniform::grid(&mut rng)]);
        if bounce.direction[2] > 0.0 {
            above += 1;
            sum += f64::from(bounce.direction[2] / bounce.pdf);
        }
    }
    (f64::from(above) / f64::from(n), sum / f64::from(n))
}

#[test]
fn the_bounded_cap_wastes_fewer_reflections_and_keeps_their_law() {
    for (view, alpha) in [
        ([0.5, 0.0, 0.866], [0.5, 0.5]),
        ([0.0, 0.0, 1.0], [1.0, 1.0]),
        ([0.7, 0.3, 0.4], [0.6, 0.9]),
    ] {
        let plain = GgxVisible::<Poly>::new(view, alpha).unwrap();
        let bounded = GgxVisible::<Poly>::bounded(view, alpha).unwrap();
        let ([few, whole], [more, cut]) = {
            let ((a, b), (c, d)) = (shares(&plain), shares(&bounded));
            ([a, b], [c, d])
        };
        println!(
            "{view:?} {alpha:?}: above {few:.4} and {more:.4}, irradiance {whole:.4} and {cut:.4}"
        );
        assert!(more > few + 0.005);
        // What both say of the same integral: of cos θ over all directions above, π.
        for said in [whole, cut] {
            assert!((said / PI - 1.0).abs() <= 0.05, "{said}");
        }
        // Where both have a density, it is the same law but for one factor.
        let u = [[0.1, 0.3], [0.4, 0.8], [0.7, 0.05]];
        let factor = |u| {
            let m = bounded.sample(u);
            f64::from(bounded.reflected_pdf(m)) / f64::from(plain.reflected_pdf(m))
        };
        let factors = u.map(factor);
        assert!(
            factors
                .iter()
                .all(|f| *f > 1.0 && (f / factors[0] - 1.0).abs() <= 1e-6)
        );
    }
}
