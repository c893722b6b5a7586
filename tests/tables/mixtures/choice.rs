//! The part that a word picks, how many words pick it, and what they leave.

use super::{Known, known, steps};
use crate::{Given, draw};
use host::generators::{Counting, Failing};
use microwarp::discrete::{Cdf, Mixture, Parts};
use microwarp::poly as mw;
use microwarp::uniform::{Canonical, grid_from_word};
use microwarp::warp::{Length, Measured};
use microwarp::{Error, Warp, constant};
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;

/// A mixture of so many parts that all are the same.
fn of<const N: usize>(weights: [f32; N]) -> Mixture<[Known; N], N>
where
    [Known; N]: Parts<N>,
{
    Mixture::new([known(1.0); N], &weights).unwrap()
}

/// Where words lie in the share of their part, by whole numbers: the middle of word `o` of `c`, in steps of 2⁻³².
fn middle(o: u64, c: u64) -> u64 {
    let twice = (2 * u128::from(o) + 1) << 32;
    (twice / (2 * u128::from(c))) as u64
}

/// How far the rests of a mixture are from the middles at most, over ends of shares and words between; of a rule for the rest.
fn farthest<P: Parts<N>, const N: usize>(
    mixture: &Mixture<P, N>,
    weights: &[f32; N],
    rule: impl Fn(u32, u64, u64) -> u32,
) -> u64 {
    let table = Cdf::<[u32; N]>::new(weights).unwrap();
    let mut rng = Pcg32::new(3, 4);
    let mut worst = 0;
    for part in 0..N {
        let Some(words) = table.words_of(part) else {
            assert_eq!((mixture.numerator(part), mixture.pmf(part)), (0, 0.0));
            continue;
        };
        let (first, count) = (u64::from(*words.start()), mixture.numerator(part));
        assert_eq!(u64::from(*words.end()) - first + 1, count);
        assert_eq!(mixture.pmf(part), (count as f64 / 2.0_f64.powi(32)) as f32);
        let between = (0..2000).map(|_| (u64::from(rng.next_u32()) * count) >> 32);
        for o in [0, 1, count / 2, count - 1].into_iter().chain(between) {
            let o = o.min(count - 1);
            let word = (first + o) as u32;
            assert_eq!(mixture.choose(word).0, part);
            worst = worst.max(u64::from(rule(word, o, count)).abs_diff(middle(o, count)));
        }
    }
    worst
}

#[test]
fn the_rest_is_the_middle_of_a_word_within_a_step() {
    fn check<const N: usize>(weights: [f32; N]) -> u64
    where
        [Known; N]: Parts<N>,
    {
        let mixture = of(weights);
        let worst = farthest(&mixture, &weights, |word, _, _| mixture.choose(word).1);
        assert!(worst <= 1, "{weights:?}: {worst}");
        // The word itself, and the place in the share as it is, are no rests; but for one part that has all words.
        if weights.iter().filter(|w| **w > 0.0).count() > 1 {
            assert!(farthest(&mixture, &weights, |word, _, _| word) > 1 << 28);
            assert!(farthest(&mixture, &weights, |_, o, _| o as u32) > 1 << 28);
        }
        worst
    }
    let worst = [
        check([1.0]),
        check([0.0, 2.0]),
        check([3.0, 0.0]),
        check([1.0, 1.0]),
        check([1.0, 2.0, 4.0, 0.0, 9.0]),
        check([1e-9, 1.0]),
        check([1.0, 3e-10, 1e-3]),
        check([0.1, 0.2, 0.3, 0.15, 0.05, 0.0, 0.2, 1e-7]),
        check(std::array::from_fn::<f32, 32, _>(|i| (i * i) as f32)),
    ];
    println!("off by {worst:?} steps");
    // One word of all, and all words.
    let one = of([1.0, 4_294_967_295.0]);
    assert_eq!((one.numerator(0), one.choose(0)), (1, (0, 1 << 31)));
    for word in [0, 1, 0x1234_5678, u32::MAX] {
        assert_eq!(of([1.0]).choose(word), (0, word));
    }
}

/// Of every word of two parts of some 100,000: as many rests in each of 1,000 bins as is due, but for one.
#[test]
fn part_and_rest_are_independent() {
    let weights = [3.0, 5.0, 65_528.0];
    let (mixture, table) = (of(weights), Cdf::<[u32; 3]>::new(&weights).unwrap());
    let unevenness = |rest: &dyn Fn(u32) -> u32| {
        let mut worst = 0.0_f64;
        for part in 0..2 {
            let mut bins = [0_u32; 1000];
            let words = table.words_of(part).unwrap();
            let count = mixture.numerator(part) as f64;
            for word in words {
                bins[((u64::from(rest(word)) * 1000) >> 32) as usize] += 1;
            }
            let off = bins.map(|bin| (f64::from(bin) - count / 1000.0).abs());
            worst = off.into_iter().fold(worst, f64::max);
        }
        worst
    };
    let right = unevenness(&|word| mixture.choose(word).1);
    // By the shift that would fit a share of 2¹⁸ words, and by a reciprocal that lacks its last digits.
    let shifted = unevenness(&|word| word << 14);
    let coarse = unevenness(&|word| {
        let o = u64::from(word - table.words_of(mixture.choose(word).0).unwrap().start());
        let count = mixture.numerator(mixture.choose(word).0);
        (o * ((1_u64 << 32) / count)).min(u64::from(u32::MAX)) as u32
    });
    println!("rests a bin off by {right}, shifted {shifted}, coarse {coarse}");
    assert!(right <= 1.0, "{right}");
    assert!(shifted > 20.0 && coarse > 4.0, "{shifted} {coarse}");
}

/// 65,536 words of equal spacing: so many points in each 64th of each interval.
fn bins(sample: impl Fn(u32) -> f32) -> Vec<u32> {
    let mut bins = vec![0; 3 * 64];
    for k in 0..1_u32 << 16 {
        bins[(sample(k << 16 | 0x8000) * 64.0) as usize] += 1;
    }
    bins
}

#[test]
fn points_are_spread_over_each_part() {
    let mixture = steps([1.0, 4.0, 3.0]);
    let due: Vec<u32> = [128, 512, 384].into_iter().flat_map(|n| [n; 64]).collect();
    let by_word = |word| mixture.sample_words(word);
    assert_eq!(bins(by_word), due);
    assert_eq!(bins(|word| draw(&mixture, &[word])), due);
    assert_eq!(bins(|word| mixture.sample(grid_from_word(word))), due);
    assert_eq!(
        bins(|word| mixture.sample_with_pdf(grid_from_word(word)).0),
        due
    );
    // The chosen part on the word that chose it.
    let reused = |word| {
        let (part, _) = mixture.choose(word);
        mixture.parts()[part].sample_words(word)
    };
    assert_ne!(bins(reused), due);
}

/// The sum over the parts of (words that pick it)/(2³² · its chance), which is their number.
#[test]
fn a_chance_is_the_one_that_is_reported() {
    for small in [1e-3_f32, 1e-5, 3e-7, 1e-9] {
        let mixture = of([small, 1.0]);
        let share = |part| mixture.numerator(part) as f64 / 2.0_f64.powi(32);
        let sum: f64 = (0..2).map(|i| share(i) / f64::from(mixture.pmf(i))).sum();
        assert!((sum - 2.0).abs() <= 2e-7, "{small}: {sum}");
        // What is written by hand: 24 bits decide, and the chance weighs as it was.
        let chance = small / (small + 1.0);
        let words = (f64::from(chance) * 2.0_f64.powi(24)).ceil() / 2.0_f64.powi(24);
        let by_hand = words / f64::from(chance) + (1.0 - words) / f64::from(1.0 - chance);
        println!("{small:e}: {sum}, by hand {by_hand}");
        assert!((by_hand - 2.0).abs() > 2e-6, "{small}: {by_hand}");
    }
}

#[test]
fn one_part_is_the_part_itself() {
    let normal = mw::Normal::new(1.0, 2.0).unwrap();
    let alone = Mixture::new([normal], &[0.7]).unwrap();
    let beside_nothing = Mixture::new((known(9.0), known(2.0)), &[0.0, 1.0]).unwrap();
    let mut rng = Pcg32::new(1, 1);
    for _ in 0..10_000 {
        let word = rng.next_u32();
        let u = grid_from_word(word) * grid_from_word(rng.next_u32());
        assert_eq!(alone.sample(u), normal.sample(u));
        assert_eq!(alone.sample_with_pdf(u), normal.sample_with_pdf(u));
        assert_eq!(alone.sample_words(word), normal.sample_words(word));
        assert_eq!(beside_nothing.sample(u), u);
    }
}

#[test]
fn a_draw_takes_the_words_of_the_part() {
    let tail = mw::ExponentialTail::from_rate(1.0).unwrap();
    let tails = Mixture::new(
        (tail, mw::Exponential::from_rate(1.0).unwrap()),
        &[1.0, 0.0],
    )
    .unwrap();
    let lobe = mw::CosineHemisphere::new();
    let lobes = Mixture::new((lobe, mw::Sphere::new()), &[1.0, 1.0]).unwrap();
    let nested = Mixture::new((lobes, lobe), &[2.0, 1.0]).unwrap();
    let mut counted = Counting::new(Pcg32::new(8, 8));
    tails.draw(&mut counted);
    nested.draw(&mut counted);
    nested.draw_with_pdf(&mut counted);
    assert_eq!(counted.words, 6);
    let mut rng = Pcg32::new(5, 5);
    for _ in 0..2000 {
        let words = [rng.next_u32(), rng.next_u32()];
        let x = nested.sample_words(words);
        assert_eq!(draw(&nested, &words), x);
        let (point, density) = nested.draw_with_pdf(&mut Given(&words));
        assert_eq!(point, x);
        assert!((density / nested.pdf(x) - 1.0).abs() <= 1e-6);
        // The first word of the part is the rest.
        let (_, rest) = tails.choose(words[0]);
        assert_eq!(draw(&tails, &words), draw(&tail, &[rest, words[1]]));
    }
    let mut failing = Failing { word: 7, left: 1 };
    assert!(lobes.try_draw(&mut failing).is_err());
    assert!(lobes.try_draw_with_pdf(&mut failing).is_err());
}

#[test]
fn what_cannot_be_picked_from_is_refused() {
    let refused = |weights: [f32; 2]| Mixture::new([known(1.0); 2], &weights).unwrap_err();
    assert_eq!(refused([0.0, 0.0]), Error::AllZero);
    assert_eq!(refused([0.0, -0.0]), Error::AllZero);
    assert_eq!(refused([1.0, f32::NAN]), Error::NotFiniteWeight(1));
    assert_eq!(refused([f32::INFINITY, 1.0]), Error::NotFiniteWeight(0));
    assert_eq!(refused([1.0, -1.0]), Error::NegativeWeight(1));
    // The largest and the smallest: one word of all is left for it.
    let far = of([f32::MAX, 1e-45]);
    assert_eq!((far.numerator(1), far.pmf(1)), (1, 2.0_f32.powi(-32)));
    assert_eq!((far.numerator(2), far.pmf(2)), (0, 0.0));
    // No uniform, nothing to pick by.
    let none = Mixture::new([Still; 2], &[1.0, 1.0]);
    assert_eq!(none.unwrap_err(), Error::Empty(0));
    const CONSTANT: Mixture<[mw::Normal; 2], 2> = constant!(Mixture::new(
        [
            constant!(mw::Normal::new(-3.0, 0.5)),
            constant!(mw::Normal::new(2.0, 1.0))
        ],
        &[1.0, 3.0]
    ));
    let parts = *CONSTANT.parts();
    assert_eq!(
        Ok(CONSTANT),
        Mixture::new(parts, &std::hint::black_box([1.0, 3.0]))
    );
}

/// A point without a uniform.
#[derive(Clone, Copy, Debug)]
struct Still;

impl Warp for Still {
    type Uniforms = [f32; 0];
    type Point = f32;
    type Density = f32;
    fn sample_canonical(&self, _: Canonical<[f32; 0]>) -> f32 {
        0.0
    }
    fn pdf(&self, _: f32) -> f32 {
        1.0
    }
}

impl Measured for Still {
    type Measure = Length;
}
