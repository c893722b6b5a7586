//! The normal distribution, two at a time.

use super::figures::{Figures, WORD, hold, over_pairs, sample_rows};
use crate::raw::{Raw, raw};
use core::f64::consts::TAU;
use fixed::FixedI32;
use fixed::types::extra::{LeEqU32, U0, U8, U16, U27, U30};
use fixed::types::{I5F27, I16F16, I32F0, U0F32};
use host::truth::{self, Truth};
use microwarp::fixed::warp::{NormalPair, StandardNormalPair};
use microwarp::fixed::{Coarse, Compact, Fine, Grade};
use microwarp::{Error, Invert, Warp};

const PAIRS: u64 = 1 << 21;

fn words(pair: [u32; 2]) -> [U0F32; 2] {
    pair.map(U0F32::from_bits)
}

/// Box and Muller's map, whose radius is exact near 0 too.
fn truth([u, v]: [u32; 2]) -> [f64; 2] {
    let standard = truth::NormalPair {
        mean: [0.0; 2],
        deviation: 1.0,
    };
    let [x, y, _] = standard.sample([f64::from(u) * WORD, f64::from(v) * WORD, 0.0, 0.0]);
    [x, y]
}

/// The distance, with the sign of the error of the radius, so that the mean is a bias.
fn sample_error<G: Grade>() -> Figures {
    let warp = StandardNormalPair::<G>::new();
    over_pairs(PAIRS, |pair, observe| {
        let got = warp.sample(words(pair)).map(|c| c.to_num::<f64>());
        let due = truth(pair);
        let distance = (got[0] - due[0]).hypot(got[1] - due[1]);
        let outwards = got[0].hypot(got[1]) - due[0].hypot(due[1]);
        observe(distance.copysign(outwards));
    })
}

fn pdf_error<G: Grade>() -> Figures {
    let warp = StandardNormalPair::<G>::new();
    over_pairs(PAIRS / 4, |pair, observe| {
        // Samples, and points anywhere in the square of the format.
        for point in [
            warp.sample(words(pair)),
            pair.map(|w| I5F27::from_bits(w as i32)),
        ] {
            let [x, y] = point.map(|c| c.to_num::<f64>());
            let due = (-0.5 * (x * x + y * y)).exp() / TAU;
            let got = warp.pdf(point);
            assert!(got > 0);
            // Of what is below a step, a step.
            observe(got.to_num::<f64>() - due.max(WORD));
        }
    })
}

fn around(difference: f64) -> f64 {
    difference - difference.round()
}

fn round_trip<G: Grade>() -> Figures {
    let warp = StandardNormalPair::<G>::new();
    over_pairs(PAIRS / 4, |pair, observe| {
        let back = warp.invert(warp.sample(words(pair)));
        let [u, v] = [0, 1].map(|i| (f64::from(back[i].to_bits()) - f64::from(pair[i])) * WORD);
        let [x, y] = truth(pair);
        observe(u);
        observe(around(v) * TAU * x.hypot(y).min(1.0));
    })
}

#[test]
fn the_standard_normal_pair_keeps_its_stated_errors() {
    let samples = [
        sample_error::<Fine>(),
        sample_error::<Coarse>(),
        sample_error::<Compact>(),
    ];
    let mut rows = sample_rows(samples).to_vec();
    let pdf = [
        pdf_error::<Fine>(),
        pdf_error::<Coarse>(),
        pdf_error::<Compact>(),
    ];
    rows.push(("pdf", pdf.map(|f| f.max)));
    let back = [
        round_trip::<Fine>(),
        round_trip::<Coarse>(),
        round_trip::<Compact>(),
    ];
    rows.push(("round trip", back.map(|f| f.max)));
    hold("StandardNormalPair", &rows);
}

/// What a sample is off beyond half a step of the format, in deviations.
fn scaled_error(warp: Box<dyn Raw>, mean: [i32; 2], deviation: i32, pairs: u64) -> f64 {
    let figures = over_pairs(pairs, |pair, observe| {
        let (got, due) = (warp.sample(&pair), truth(pair));
        assert!(warp.pdf(&got) > 0);
        let beyond = [0, 1].map(|i| {
            let due = f64::from(mean[i]) + due[i] * f64::from(deviation);
            let error = (f64::from(got[i] as i32) - due).abs();
            (error - 0.5).max(0.0) / f64::from(deviation)
        });
        observe(beyond[0].hypot(beyond[1]));
    });
    figures.max
}

/// Deviations from a step to the largest accepted, means to the ends of the format.
fn worst_scaled<G: Grade>() -> f64 {
    let far = i32::MAX - 1_000_000;
    let reach = |d: i32| i32::MAX - ((i64::from(d) * 427) >> 6) as i32 - 1;
    let largest = (1 << 27) - 1;
    fn new<Frac: LeEqU32 + Send + Sync + 'static, G: Grade>(m: [i32; 2], d: i32) -> Box<dyn Raw> {
        let bits = FixedI32::<Frac>::from_bits;
        raw(NormalPair::<Frac, G>::new(m.map(bits), bits(d)).unwrap())
    }
    type New = fn([i32; 2], i32) -> Box<dyn Raw>;
    let cases: [(New, [i32; 2], i32, u64); 5] = [
        (new::<U16, G>, [0, 0], 1, 64),
        (new::<U0, G>, [7, -7], 3, 64),
        (new::<U8, G>, [far, -far], 1000, 64),
        (new::<U27, G>, [0, 1 << 30], 0x0123_4567, 4),
        (new::<U27, G>, [reach(largest), -reach(largest)], largest, 4),
    ];
    let errors = cases.map(|(new, m, d, part)| scaled_error(new(m, d), m, d, PAIRS / part));
    errors.into_iter().fold(0.0, f64::max)
}

#[test]
fn a_normal_pair_is_the_standard_one_times_the_deviation_to_half_a_step() {
    let worst = [
        worst_scaled::<Fine>(),
        worst_scaled::<Coarse>(),
        worst_scaled::<Compact>(),
    ];
    hold("NormalPair", &[("sample, max", worst)]);
}

#[test]
fn the_first_word_gives_the_mean_and_the_last_one_6_66_deviations() {
    let warp = StandardNormalPair::<Fine>::new();
    for v in [0, 1, 1 << 30, u32::MAX] {
        assert_eq!(warp.sample(words([0, v])), [0, 0]);
    }
    for (quarter, due) in [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]]
        .into_iter()
        .enumerate()
    {
        let got = warp.sample(words([u32::MAX, (quarter as u32) << 30]));
        for (got, due) in got.into_iter().zip(due) {
            assert!((got.to_num::<f64>() - 6.660_437 * due).abs() < 1e-5);
        }
    }
    let mean = [I16F16::from_num(-3), I16F16::from_num(12.5)];
    let warp = NormalPair::<U16, Fine>::new(mean, I16F16::from_num(2)).unwrap();
    assert_eq!(warp.sample(words([0, 77])), mean);
    assert_eq!(warp.invert(mean), [0, 0]);
}

#[test]
fn the_density_of_a_normal_pair_is_right_to_the_grade_and_a_step() {
    for (deviation, fraction) in [(0x0123_4567, 27), (1 << 16, 16), (50_000, 30), (300, 0)] {
        let one = 2_f64.powi(fraction);
        let sigma = f64::from(deviation) / one;
        let peak = 1.0 / (TAU * sigma * sigma);
        for k in 0..1_u32 << 16 {
            let pair = [k << 16, k.wrapping_mul(0x9e37_79b9)];
            let [x, y] = truth(pair).map(|c| (c * f64::from(deviation)).round() as i32);
            let due =
                peak * (-0.5 * (f64::from(x).hypot(f64::from(y)) / one / sigma).powi(2)).exp();
            let got = match fraction {
                27 => density::<U27>(deviation, [x, y]),
                16 => density::<U16>(deviation, [x, y]),
                30 => density::<U30>(deviation, [x, y]),
                _ => density::<U0>(deviation, [x, y]),
            };
            assert!(got > 0.0);
            let error = (got - due).abs();
            assert!(
                error <= 1e-6 * peak + WORD,
                "{deviation} {x} {y}: {got} for {due}"
            );
        }
    }
}

fn density<Frac: LeEqU32>(deviation: i32, point: [i32; 2]) -> f64 {
    let bits = FixedI32::<Frac>::from_bits;
    let warp = NormalPair::<Frac, Fine>::new([bits(11), bits(-5)], bits(deviation)).unwrap();
    let [x, y] = point;
    warp.pdf([bits(x + 11), bits(y - 5)]).to_num()
}

#[test]
fn far_points_have_the_least_density_and_the_last_words() {
    let warp = NormalPair::<U0, Fine>::new([I32F0::MIN / 2; 2], I32F0::from_bits(1)).unwrap();
    for x in [I32F0::MIN, I32F0::MAX] {
        for y in [I32F0::MIN, I32F0::ZERO, I32F0::MAX] {
            assert_eq!(warp.pdf([x, y]).to_bits(), 1);
            assert_eq!(warp.invert([x, y])[0], U0F32::MAX);
        }
    }
}

#[test]
fn deviations_and_means_that_would_overflow_are_refused() {
    let bits = I16F16::from_bits;
    let new =
        |mean: [i32; 2], deviation| NormalPair::<U16, Fine>::new(mean.map(bits), bits(deviation));
    for deviation in [0, -1, i32::MIN] {
        assert_eq!(new([0, 0], deviation), Err(Error::NotPositive(1)));
    }
    for deviation in [1 << 27, 1 << 28, i32::MAX] {
        assert_eq!(new([0, 0], deviation), Err(Error::TooLarge(1)));
    }
    assert!(new([0, 0], (1 << 27) - 1).is_ok());
    for far in [i32::MIN, i32::MIN + 3000, i32::MAX - 6000, i32::MAX] {
        assert_eq!(new([0, far], 1000), Err(Error::TooLarge(1)));
        assert_eq!(new([far, 0], 1000), Err(Error::TooLarge(1)));
    }
    assert!(new([i32::MAX - 6700, -i32::MAX + 6700], 1000).is_ok());
    // The density overflows where 2πσ² is below 2⁻³².
    let narrow = |deviation| {
        let bits = FixedI32::<U30>::from_bits;
        NormalPair::<U30, Fine>::new([bits(0); 2], bits(deviation))
    };
    assert_eq!(narrow(6_530), Err(Error::Empty(1)));
    assert!(narrow(6_540).is_ok());
    const CHECKED: Result<NormalPair<U16, Fine>, Error> =
        NormalPair::new([I16F16::ZERO; 2], I16F16::from_bits(1 << 16));
    assert!(CHECKED.is_ok());
}
