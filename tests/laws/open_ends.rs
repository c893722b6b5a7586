//! What is open at an end is drawn so that the moments of all that can be drawn are those of the law.
//!
//! Every moment here is the exact mean over the 2³² words of a generator (or over all pairs of them): those next to both
//! ends one by one, the others by so many in every octave of the distance from the nearer end. The old rule, which took
//! the grid's 0 for 2⁻¹⁴⁹ or an end for a point, is the control in each test: the same bounds reject it.

use ::fixed::types::extra::U30;
use ::fixed::types::{I2F30, U0F32};
use host::errors::ulp;
use host::generators::Cycle;
use host::parallel::{in_parallel, threads};
use host::registry::{Point, registered};
use host::speed;
use microwarp::uniform::{Strata1d, Uniforms, deep_from_word, grid_from_word};
use microwarp::{Warp, fixed, libm, poly, warp::Inversion};
use std::sync::LazyLock;

/// Words and the share of all words that each stands for.
fn words(per_octave: u32) -> Vec<(u32, f64)> {
    let mut all: Vec<(u32, f64)> = (0..per_octave).map(|word| (word, 1.0)).collect();
    let mut octave = u64::from(per_octave);
    while octave < 1 << 31 {
        let stride = octave / u64::from(per_octave);
        // The middle of a stride: of an even number the lower one of two, alternating with the upper one.
        all.extend((0..u64::from(per_octave)).map(|i| {
            let middle = octave + i * stride + (stride - (i & 1)) / 2;
            (middle as u32, stride as f64)
        }));
        octave *= 2;
    }
    let above: Vec<_> = all.iter().map(|&(word, n)| (!word, n)).collect();
    all.extend(above);
    assert!(all.iter().map(|(_, n)| n).sum::<f64>() == 2f64.powi(32));
    all.into_iter()
        .map(|(word, n)| (word, n * 2f64.powi(-32)))
        .collect()
}

/// Enough of all words for a mean.
static WORDS: LazyLock<Vec<(u32, f64)>> = LazyLock::new(|| words(4096));

/// The mean of f over all words.
fn mean(f: impl Fn(u32) -> f64) -> f64 {
    WORDS.iter().map(|&(word, share)| share * f(word)).sum()
}

/// The old rule: a draw is the sample of the grid's uniform.
fn old<W: Warp>(warp: &W, words: <W::Uniforms as Uniforms>::Words) -> W::Point {
    warp.sample(W::Uniforms::from_words(words).get())
}

#[test]
fn a_mean_over_all_words_is_exact() {
    let u = |word: u32| (f64::from(word) + 0.5) * 2f64.powi(-32);
    assert!((mean(|_| 1.0) - 1.0).abs() <= 1e-14);
    assert!((mean(|word| u(word).powi(7)) - 0.125).abs() <= 1e-8);
    // The midpoint rule over all words is off by ζ(1/2, 1/2)/2¹⁷ of its own.
    assert!(
        (mean(|word| 0.5 / u(word).sqrt()) - 1.0 + 0.604_898_643 / 2f64.powi(17)).abs() <= 1e-8
    );
}

macro_rules! both_tiers {
    (|$warps:ident| $body:block) => {{
        {
            use libm as $warps;
            $body
        }
        {
            use poly as $warps;
            $body
        }
    }};
}

#[test]
fn what_is_drawn_deeply_has_the_moments_of_its_law() {
    let all = registered();
    let moments: Vec<_> = all
        .iter()
        .flat_map(|of| of.moments.iter().map(move |moment| (of, moment)))
        .collect();
    assert!(moments.len() > 60, "{}", moments.len());
    let off = in_parallel(threads(), &moments, |(of, moment)| {
        let warp = (of.build)(&moment.parameters).expect("accepted").warp;
        let off = |at: &dyn Fn(u32) -> Point| {
            let average = |x: Point| (moment.of)(x[0].into(), &|| warp.pdf(x).into());
            mean(|word| average(at(word))) / moment.due - 1.0
        };
        let by_grid = |word| warp.sample([grid_from_word(word), 0.0, 0.0, 0.0]);
        [off(&|word| warp.drawn(word)), off(&by_grid)]
    });
    let mut wrong = Vec::new();
    for ((of, moment), [drawn, before]) in moments.iter().zip(off) {
        let (parameters, name) = (&moment.parameters, moment.name);
        let what = format!("{} {} {parameters:?}, {name}", of.name, of.tier);
        let what = format!("{what}: off by {drawn:.1e}, by the old rule {before:.1e}");
        println!("{what}");
        // Each written so that NaN fails.
        let holds = drawn.abs() <= moment.bound;
        let rejected = before.abs() > moment.bound;
        if !holds || !rejected {
            wrong.push(what);
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn a_normal_deviate_is_symmetric_and_increasing() {
    both_tiers!(|mw| {
        let normal = mw::Normal::new(0.0, 1.0).unwrap();
        let mut last = f32::NEG_INFINITY;
        let mut rising = words(4096);
        rising.sort_unstable_by_key(|(word, _)| *word);
        for (word, _) in rising {
            let z = normal.sample_words(word);
            assert_eq!(z, -normal.sample_words(!word), "{word:#x}");
            assert!(z >= last, "{word:#x}");
            last = z;
        }
        assert!(last > 6.33 && last < 6.35);
    });
}

/// Pareto of minimum and shape 1 is 1/(1 − u): 2³³ over an odd number.
#[test]
fn a_logarithm_has_all_digits_of_every_word() {
    // The proofs try the same words for all shapes.
    let stride = speed::or_all("one word tried of every", 1021, 61, 1);
    let chunk = 1_u32 << 26;
    let law = poly::Pareto::new(1.0, 1.0).unwrap();
    let error = |word: u32, x: f32| {
        let due = 2f64.powi(33) / (2.0 * f64::from(!word) + 1.0);
        (f64::from(x) - due).abs() / ulp(due)
    };
    let starts: Vec<u32> = (0..64).map(|k| k * chunk).collect();
    let ends = words(4096).into_iter().map(|(word, _)| word);
    in_parallel(threads(), &starts, |&start| {
        for word in (0..chunk).step_by(stride).map(|k| start + k) {
            let error = error(word, law.sample_words(word));
            assert!(error <= 2.0, "{word:#x}: {error} ulp");
        }
    });
    let mut by_grid: f64 = 0.0;
    for word in ends {
        let drawn = error(word, law.sample_words(word));
        assert!(drawn <= 2.0, "{word:#x}: {drawn} ulp");
        by_grid = by_grid.max(error(word, old(&law, word)));
    }
    assert!(by_grid > 2.0, "the old rule passes: {by_grid} ulp");
}

/// Two logarithms, one of the other, which is near 0 at both ends of the octaves and near 1 in between.
#[test]
fn a_logarithm_of_a_logarithm_has_the_digits_of_every_word() {
    let law = poly::Gumbel::new(0.0, 1.0).unwrap();
    let error = |word: u32, x: f32| {
        let left = (f64::from(!word) + 0.5) * 2f64.powi(-32);
        let due = -(-(-left).ln_1p()).ln();
        (f64::from(x) - due).abs() / ulp(due.abs().max(1.0))
    };
    let mut by_grid: f64 = 0.0;
    for (word, _) in words(4096) {
        let drawn = error(word, law.sample_words(word));
        assert!(drawn <= 3.0, "{word:#x}: {drawn} ulp");
        by_grid = by_grid.max(error(word, old(&law, word)));
    }
    assert!(by_grid > 3.0, "the old rule passes: {by_grid} ulp");
}

/// The mean over all pairs of words.
fn mean_of_pairs(f: impl Fn([u32; 2]) -> f64) -> f64 {
    let words = words(64);
    let along = |first: u32| -> f64 { words.iter().map(|&(word, s)| s * f([first, word])).sum() };
    words.iter().map(|&(word, share)| share * along(word)).sum()
}

#[test]
fn the_largest_of_two_weighs_its_whole_width() {
    let largest = poly::PowerMax::<2>::new();
    let width = |x: f32| 1.0 / f64::from(largest.pdf(x));
    let drawn = mean_of_pairs(|pair| width(largest.sample_words(pair)));
    let before = mean_of_pairs(|pair| width(old(&largest, pair)));
    println!("PowerMax of 2, 1/p: {drawn}, by the old rule {before}");
    assert!((drawn - 1.0).abs() <= 1e-3, "{drawn}");
    assert!((before - 1.0).abs() > 1e-3, "{before}");
}

#[test]
fn the_horizon_of_malleys_hemisphere_has_its_own_share() {
    both_tiers!(|mw| {
        let lambert = mw::MalleyHemisphere::new();
        let width = |w: [f32; 3]| 1.0 / f64::from(lambert.pdf(w));
        let due = std::f64::consts::TAU;
        let drawn = mean_of_pairs(|pair| width(lambert.sample_words(pair))) / due - 1.0;
        let before = mean_of_pairs(|pair| width(old(&lambert, pair))) / due - 1.0;
        println!("MalleyHemisphere, 1/p: off by {drawn:.1e}, by the old rule {before:.1e}");
        assert!(drawn.abs() <= 1e-3, "{drawn}");
        assert!(before.abs() > 1e-3, "{before}");
    });
}

#[test]
fn an_inverse_cdf_is_not_asked_for_its_end() {
    // The logistic law, infinite at both ends, whose variance is π²/3.
    let logistic = Inversion::new(
        |u: f32| (f64::from(u) / (1.0 - f64::from(u))).ln() as f32,
        |x: f32| 1.0 / (2.0 + 2.0 * x.cosh()),
        |x: f32| 1.0 / (1.0 + (-x).exp()),
    );
    let due = std::f64::consts::PI.powi(2) / 3.0;
    let square = |x: f32| f64::from(x).powi(2) / due;
    let drawn = mean(|word| square(logistic.sample_words(word))) - 1.0;
    let before = mean(|word| square(old(&logistic, word))) - 1.0;
    println!("Inversion, x^2: off by {drawn:.1e}, by the old rule {before:.1e}");
    assert!(drawn.abs() <= 1e-5, "{drawn}");
    assert!(before.abs() > 1e-5, "the old rule passes: {before}");
}

/// Composed, a word means what it means to the warp within.
#[test]
fn compositions_draw_as_what_they_are_made_of() {
    let normal = poly::Normal::new(0.0, 1.0).unwrap();
    let malley = poly::MalleyHemisphere::new();
    let frame = poly::Frame::new([0.3, -0.2, 0.6]).unwrap();
    let turned = poly::Oriented::new(malley, frame);
    let nested = poly::MarginalConditional::new(&normal, |x| {
        poly::Transform::new(normal, move |y| x + y, move |y: f32| y - x, |_| 1.0)
    });
    for word in [0, 1, 255, 0x7fff_ffff, 0x8000_0000, 0x1234_5678, !0] {
        let words = [word];
        let mut rng = Cycle::new(&words);
        let (z, up) = (normal.draw(&mut rng), malley.draw(&mut rng));
        assert_eq!(z, normal.sample_words(word));
        assert_eq!(nested.draw(&mut rng), [z, z + z]);
        assert_eq!(nested.sample_words([word; 2]), [z, z + z]);
        assert_eq!(turned.draw(&mut rng), frame.to_world(up));
        assert_eq!(turned.sample_words([word; 2]), frame.to_world(up));
        let mut filled = [[0.0; 3]; 9];
        turned.fill(&mut rng, &mut filled);
        assert_eq!(filled, [frame.to_world(up); 9]);
    }
    // Which the grid's uniforms would not have been.
    assert!(normal.sample(0.0) != normal.sample_words(0));
    assert!(malley.sample([0.0; 2]) != malley.sample_words([0; 2]));
}

/// One word reaches as deep as it can into a tail that a draw takes two for.
#[test]
fn a_tail_of_one_word_ends_at_the_deepest_uniform() {
    let tail = poly::ExponentialTail::from_rate(2.0).unwrap();
    for word in [0, 1, 255, 0x7fff_ffff, 0x8000_0000, 0x1234_5678, !0] {
        assert_eq!(tail.sample_words(word), tail.sample(deep_from_word(word)));
    }
    assert!((2.0 * tail.sample_words(0) - 22.873_9).abs() < 1e-3);
}

/// A draw in the first of many strata: the moments of a normal deviate in the tail that it covers.
#[test]
fn a_stratum_at_an_end_has_its_own_share() {
    both_tiers!(|mw| {
        let strata = Strata1d::new(4096).unwrap();
        let (normal, ramp) = (
            mw::Normal::new(0.0, 1.0).unwrap(),
            mw::Linear::new(0.0, 1.0).unwrap(),
        );
        let by_word = |word: u32| strata.draw(0, &mut Cycle::new(&[word]));
        // What came before: a jitter of the grid, and the sum cut to it.
        let by_grid = |word: u32| strata.point(0, grid_from_word(word));
        // 1/p = 1/(2√u) has the mean √n there.
        let width = |u: f32| 1.0 / f64::from(ramp.pdf(ramp.sample(u))) / 64.0;
        // The tail's sixth moment, by Simpson's rule from −40 to its end, which Φ⁻¹(1/4096) is.
        let end = -3.487_104_104;
        let step = (40.0 + end) / 20_000.0;
        let sixth: f64 = (0..=20_000)
            .map(|k| {
                let weight = if k % 20_000 == 0 {
                    1.0
                } else {
                    2.0 + 2.0 * f64::from(k % 2)
                };
                let z = -40.0 + f64::from(k) * step;
                weight * z.powi(6) * (-0.5 * z * z).exp()
            })
            .sum();
        let due = sixth * step / 3.0 / std::f64::consts::TAU.sqrt() * 4096.0;
        let power = |u: f32| f64::from(normal.sample(u)).powi(6) / due;
        for (what, f) in [("z^6", &power as &dyn Fn(f32) -> f64), ("1/p", &width)] {
            let drawn = mean(|word| f(by_word(word))) - 1.0;
            let before = mean(|word| f(by_grid(word))) - 1.0;
            println!(
                "first of 4096 strata, {what}: off by {drawn:.1e}, by the old rule {before:.1e}"
            );
            assert!(drawn.abs() <= 5e-4, "{what}: {drawn}");
            assert!(before.abs() > 5e-4, "{what}: {before}");
        }
    });
}

#[test]
fn an_integer_tent_weighs_its_whole_width() {
    let tent = fixed::Tent::<U30>::new(I2F30::ONE).unwrap();
    let width = |x: I2F30| 1.0 / tent.pdf(x).to_num::<f64>();
    let drawn = mean(|word| width(tent.sample_words(word))) / 2.0 - 1.0;
    let before = mean(|word| width(tent.sample(U0F32::from_bits(word)))) / 2.0 - 1.0;
    println!("fixed::Tent, 1/p: off by {drawn:.1e}, by the old rule {before:.1e}");
    assert!(drawn.abs() <= 1e-4, "{drawn}");
    assert!(before.abs() > 1e-4, "{before}");
    for word in [0, 1, 255, 0x7fff_ffff, 0x8000_0000, !0] {
        let mirrored = -tent.sample_words(!word);
        assert_eq!(tent.sample_words(word), mirrored, "{word:#x}");
        assert_eq!(tent.draw(&mut Cycle::new(&[word])), mirrored);
        let x = fixed::Float::new(tent).draw(&mut Cycle::new(&[word]));
        assert_eq!(x, fixed::Float::new(tent).sample_words(word));
    }
}
