//! The inverse by a uniform: uniform again, and it leads back.

use super::steps;
use host::speed;
use microwarp::discrete::Mixture;
use microwarp::poly as mw;
use microwarp::uniform::{Points as _, Sobol, grid, grid_from_word};
use microwarp::{Invert as _, Warp};
use rand_pcg::Pcg32;

/// How uneven the first numbers of inverses are in 16 × 16 cells with the words that picked: the largest part by which a cell is off.
fn unevenness(points: u32, inverse: impl Fn(f32, f32) -> f32, sample: impl Fn(f32) -> f32) -> f64 {
    let mut cells = [[0_u32; 16]; 16];
    let set = Sobol::<2>::new(5).unwrap();
    for index in 0..points {
        let [u, v] = [0, 1].map(|d| grid_from_word(set.word(index, d)));
        let back = inverse(sample(u), v);
        cells[(back * 16.0) as usize][(v * 16.0) as usize] += 1;
    }
    let due = f64::from(points) / 256.0;
    // Uniform is the first number; that the pair is not independent is what picks the part.
    let rows = cells.map(|row| f64::from(row.iter().sum::<u32>()));
    rows.into_iter()
        .map(|row| (row / (16.0 * due) - 1.0).abs())
        .fold(0.0, f64::max)
}

#[test]
fn inverses_of_points_are_uniform() {
    let parts = [(0.0, 1.0), (1.0, 1.0), (-1.0, 0.3)].map(|(m, s)| mw::Normal::new(m, s).unwrap());
    let mixture = Mixture::new(parts, &[2.0, 1.0, 1.5]).unwrap();
    let points = speed::of("inverses", 1 << 14, 1 << 20);
    let right = unevenness(
        points,
        |x, v| mixture.invert_with(x, v),
        |u| mixture.sample(u),
    );
    // A part by its weight, whatever the point.
    let by_weight = |x: f32, v: f32| {
        let (part, _) = mixture.choose((v * 4_294_967_296.0) as u32);
        let before: f32 = (0..part).map(|i| mixture.pmf(i)).sum();
        (before + mixture.pmf(part) * parts[part].invert(x)).min(0.999_999)
    };
    let wrong = unevenness(points, by_weight, |u| mixture.sample(u));
    println!("rows off by {right:.1e}, by weight alone {wrong:.1e}");
    assert!(right <= 0.03, "{right}");
    assert!(wrong > 0.2, "{wrong}");
}

#[test]
fn an_inverse_leads_back() {
    let lobes = (
        mw::CosineHemisphere::new(),
        mw::PhongLobe::new(30.0).unwrap(),
    );
    let lobe = Mixture::new(lobes, &[1.0, 3.0]).unwrap();
    let mut rng = Pcg32::new(6, 7);
    let mut worst = 0.0_f32;
    for _ in 0..speed::of("round trips", 20_000, 1_000_000) {
        let x = lobe.sample([grid(&mut rng), grid(&mut rng)]);
        let u = lobe.invert_with(x, grid(&mut rng));
        let again = lobe.sample(u);
        let off = [0, 1, 2].map(|i| (x[i] - again[i]).abs());
        assert!(off.iter().all(|off| off.is_finite()), "{x:?} {again:?}");
        worst = off.into_iter().fold(worst, f32::max);
    }
    println!("points off by {worst:.1e}");
    // The square root of a step of the grid, next to the pole.
    assert!(worst <= 5e-4, "{worst}");
}

/// Points far out in the tail of the first part, whose uniforms are far below a word, lead back as well.
#[test]
fn an_inverse_keeps_the_tail_of_the_first_part() {
    let parts = [0.0, 3.0].map(|mean| mw::Normal::new(mean, 1.0).unwrap());
    let mixture = Mixture::new(parts, &[1.0, 1.0]).unwrap();
    let alone = Mixture::new([mw::ExponentialTail::from_rate(1.0).unwrap()], &[1.0]).unwrap();
    for word in [0, 1, 2, 100, 1 << 20] {
        let x = mixture.sample_words(word);
        let again = mixture.sample(mixture.invert_with(x, 0.0));
        assert!((again - x).abs() <= 1e-5, "{x} {again}");
    }
    for x in [1e-3, 1.0, 22.5, 40.0] {
        let again = alone.sample(alone.invert_with(x, 0.5));
        assert!((again - x).abs() <= 1e-7 + 1e-5 * x, "{x} {again}");
    }
}

/// The uniform of a part lies in the share of the part, also where it has few numbers.
#[test]
fn an_inverse_picks_the_part_it_came_of() {
    for weights in [
        [1.0, 4.0, 3.0],
        [1.0, 1e-5, 1.0],
        [1e-6, 1.0, 1e-6],
        [0.0, 1.0, 2e-7],
    ] {
        let mixture = steps(weights);
        let mut rng = Pcg32::new(9, 9);
        for part in 0..3 {
            if mixture.numerator(part) == 0 {
                continue;
            }
            let ends = [3e-7, 1e-6, 0.5, 0.999_999_9];
            let between = (0..1000).map(|_| grid(&mut rng));
            for t in ends.into_iter().chain(between).collect::<Vec<_>>() {
                // A whole number is the end of two intervals.
                let x = part as f32 + t.max(3e-7) * 0.999_999;
                let u = mixture.invert_with(x, grid(&mut rng));
                assert!((0.0..1.0).contains(&u));
                let (picked, _) = mixture.choose((u * 4_294_967_296.0) as u32);
                assert_eq!(picked, x as usize, "{weights:?} at {x}: {u}");
            }
        }
    }
}

#[test]
fn any_point_and_any_uniform_have_an_inverse() {
    let mixture = steps([0.0, 4.0, 3.0]);
    let any = [
        f32::NAN,
        -1.0,
        0.0,
        0.5,
        1.0,
        7.0,
        f32::INFINITY,
        f32::NEG_INFINITY,
    ];
    for x in [
        f32::NAN,
        -1e30,
        -0.5,
        0.5,
        1.0,
        1.5,
        3.0,
        1e30,
        f32::INFINITY,
    ] {
        for u in any {
            let back = mixture.invert_with(x, u);
            assert!((0.0..1.0).contains(&back), "{x} {u}: {back}");
        }
    }
    // Densities whose sum overflows, and densities that vanish beside their chance.
    #[derive(Clone, Copy, Debug)]
    struct Steep(f32);
    impl Warp for Steep {
        type Uniforms = f32;
        type Point = f32;
        type Density = f32;
        fn sample_canonical(&self, u: microwarp::uniform::Canonical<f32>) -> f32 {
            u.get()
        }
        fn pdf(&self, _: f32) -> f32 {
            self.0
        }
    }
    impl microwarp::Invert for Steep {
        fn invert(&self, x: f32) -> f32 {
            x
        }
    }
    impl microwarp::warp::Measured for Steep {
        type Measure = microwarp::warp::Length;
    }
    for density in [f32::MAX, f32::INFINITY, 1e-45] {
        let mixture = Mixture::new([Steep(density); 4], &[1.0; 4]).unwrap();
        let picked = [0.1, 0.3, 0.6, 0.9].map(|v| (mixture.invert_with(0.5, v) * 4.0) as u32);
        assert_eq!(picked, [0, 1, 2, 3], "{density}");
    }
}
