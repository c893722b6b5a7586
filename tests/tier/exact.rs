//! What holds without an error: the correctly rounded root, quarter turns, and steps that never go back.

use host::parallel::{in_parallel, threads};
use host::speed;
use microwarp::Warp;
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::uniform::{FromFn, LARGEST, grid_from_word};
use microwarp::warp::Exponential;

/// Every f32 of two adjacent binades, in the quick speed every 13th, which stand for all others by scaling with powers of 4, and a
/// sample of those against f64, whose root rounds to the same f32.
#[test]
fn the_square_root_is_correctly_rounded() {
    let check = |bits: u32| {
        let x = f32::from_bits(bits);
        let exact = f64::from(x).sqrt() as f32;
        assert!(Poly::sqrt(x).to_bits() == exact.to_bits(), "√{x}");
        assert!(Libm::sqrt(x).to_bits() == exact.to_bits(), "√{x}");
    };
    let one = 1.0_f32.to_bits();
    let stride = speed::of("one root tried of every", 13, 1);
    let starts: Vec<u32> = (0..1 << 8).map(|chunk| one + (chunk << 16)).collect();
    in_parallel(threads(), &starts, |&start| {
        (start..start + (1 << 16)).step_by(stride).for_each(check);
    });
    (0..=f32::MAX.to_bits()).step_by(2047).for_each(check);
    (0..1 << 12).for_each(check);
}

fn quarter_turns_are_exact<T: Tier>() {
    let whole = [0.0, 1.0, 2.0, 1_000.0, 1_048_576.0, 4_194_304.0];
    for turns in whole {
        for (quarter, expected) in [(0.0, (0.0, 1.0)), (0.25, (1.0, 0.0)), (0.5, (0.0, -1.0))] {
            let t: f32 = turns + quarter;
            let exact = t - turns == quarter;
            assert!(!exact || T::sincos_turns(t) == expected, "{} {t}", T::NAME);
            let mirrored = (-expected.0, expected.1);
            assert!(
                !exact || T::sincos_turns(-t) == mirrored,
                "{} {}",
                T::NAME,
                -t
            );
        }
    }
    for huge in [
        8_388_607.0,
        8_388_608.0,
        3.0e30,
        f32::MAX,
        f32::INFINITY,
        f32::NAN,
    ] {
        assert_eq!(T::sincos_turns(huge), (0.0, 1.0), "{} {huge}", T::NAME);
        assert_eq!(T::sincos_turns(-huge), (0.0, 1.0), "{} -{huge}", T::NAME);
    }
    let eighth = [(1.0, 1.0, 0.125), (1.0, -1.0, 0.375), (-1.0, 1.0, -0.125)];
    let axes = [
        (0.0, 1.0, 0.0),
        (1.0, 0.0, 0.25),
        (0.0, -1.0, 0.5),
        (-1.0, 0.0, -0.25),
    ];
    for (y, x, turns) in eighth.into_iter().chain(axes) {
        for size in [1.0e-45, 1.0e-38, 1.0, f32::MAX, f32::INFINITY] {
            let scaled = |a: f32| if a == 0.0 { a } else { size * a };
            let angle = T::atan2_turns(scaled(y), scaled(x));
            assert_eq!(angle, turns, "{}: ({x}, {y}) times {size}", T::NAME);
        }
    }
}

#[test]
fn quarter_turns_are_exact_in_both_tiers() {
    quarter_turns_are_exact::<Libm>();
    quarter_turns_are_exact::<Poly>();
}

/// How often a function of the uniform steps back, over the inputs of the grid.
fn steps_back(function: impl Fn(f32) -> f32) -> u32 {
    let mut last = f32::NEG_INFINITY;
    let mut steps = 0;
    for k in speed::blocks("the grid", (1 << 24) + 1, 16).flatten() {
        let y = function(k as f32 / 16_777_216.0);
        // Not a number is no step forward either.
        steps += if y >= last { 0 } else { 1 };
        last = y;
    }
    steps
}

/// What the warps of one number rest on is as monotone as it is in mathematics.
#[test]
fn logarithms_exponentials_and_quantile_never_step_back() {
    type Rising = fn(f32) -> f32;
    let functions: [(&str, Rising); 9] = [
        ("ln", Poly::ln),
        ("ln_1p", |u| Poly::ln_1p(u - 1.0)),
        ("neg_ln_1m", |u| Poly::neg_ln_1m(u.min(LARGEST))),
        ("exp_neg_pair", |u| -Poly::exp_neg_pair(17.0 * u).0),
        ("exp_neg_pair, 1 - e^-x", |u| Poly::exp_neg_pair(17.0 * u).1),
        ("exp", |u| Poly::exp(u - 1.0)),
        ("exp_m1", |u| Poly::exp_m1(u - 1.0)),
        ("normal_cdf_lower", |u| {
            Poly::normal_cdf_lower(8.0 * u - 8.0)
        }),
        ("normal_quantile_lower", |u| {
            Poly::normal_quantile_lower(0.5 * u)
        }),
    ];
    in_parallel(threads(), &functions, |&(name, function)| {
        assert_eq!(steps_back(function), 0, "{name}");
    });
    // A sine of half a wave steps back, and so does what is not a number.
    assert!(steps_back(|u| Poly::sincos_turns(0.25 * u + 0.001).0) > 0);
    assert!(steps_back(|u| if u == 0.5 { f32::NAN } else { u }) > 0);
}

fn the_logarithm_of_a_word_is_that_of_its_uniform<T: Tier>() {
    let waiting = Exponential::<T>::from_rate(1.0).unwrap();
    for k in 0..1_u32 << 24 {
        let word = (k << 8) | (k & 0xff);
        let drawn = waiting.draw(&mut FromFn(|| word)).to_bits();
        let due = T::neg_ln_1m(grid_from_word(word)).to_bits();
        assert_eq!(drawn, due, "{} {word:#x}", T::NAME);
    }
}

/// Draws of one number take a way of their own to the logarithm. Over all uniforms of the grid.
#[test]
fn the_logarithm_of_a_drawn_word_has_the_same_bits() {
    the_logarithm_of_a_word_is_that_of_its_uniform::<Poly>();
    the_logarithm_of_a_word_is_that_of_its_uniform::<Libm>();
}

fn polar_is_the_radius_times_sine_and_cosine<T: Tier>() {
    for k in 0..1_u32 << 22 {
        // Of both signs, on the grid and off it.
        let turn = k as f32 * (std::f32::consts::SQRT_2 / 1_048_576.0) - 2.0;
        let radius = [1.0, 0.7, 1.0e-30, -0.3][k as usize % 4];
        let (s, c) = T::sincos_turns(turn);
        assert_eq!(
            T::polar(radius, turn),
            (radius * c, radius * s),
            "{} {radius} {turn}",
            T::NAME
        );
    }
}

#[test]
fn polar_is_the_radius_times_sine_and_cosine_in_both_tiers() {
    polar_is_the_radius_times_sine_and_cosine::<Libm>();
    polar_is_the_radius_times_sine_and_cosine::<Poly>();
}

/// The pair is one of the functions it is made of, so that neither has to be stated apart.
#[test]
fn the_pair_of_exponentials_has_the_bits_of_both() {
    for k in 0..1_u32 << 22 {
        let x = k as f32 * (17.0 / 4_194_304.0);
        let (power, rest) = Poly::exp_neg_pair(x);
        assert_eq!((power, rest), (Poly::exp(-x), -Poly::exp_m1(-x)), "{x}");
    }
}
