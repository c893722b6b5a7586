//! Whether an event happens: exactly the words that a probability or a ratio says, and the wrong ways to decide fail the same tests.

use host::generators::Cycle;
use host::parallel::{in_parallel, threads};
use host::speed;
use microwarp::uniform::{Chance, grid_from_word};
use microwarp::{Error, constant};
use rand_core::Rng;
use rand_pcg::Pcg32;

const ALL: u64 = 1 << 32;
const ONE: u32 = 1.0_f32.to_bits();

/// Whether the words below `words` accept, and no others: by the ends, since acceptance falls with the word.
fn accepts_below(accepts: impl Fn(u32) -> bool, words: u64) -> bool {
    let last = words == 0 || accepts((words - 1) as u32);
    let next = words == ALL || !accepts(words as u32);
    last && next && (words == 0) != accepts(0) && (words == ALL) == accepts(u32::MAX)
}

/// A way to decide by a probability: how many words accept.
fn stated(p: f32) -> u64 {
    Chance::new(p).unwrap().words()
}

/// The first of the bit patterns from 0 to 1 for which this is not ⌈2³²p⌉, which is exact in `f64`; one of every so many.
fn wrong(words: impl Fn(f32) -> u64 + Sync, stride: usize) -> Option<f32> {
    let parts: Vec<_> = (0..threads() as u32).collect();
    let found = in_parallel(parts.len(), &parts, |part| {
        let mut patterns = (*part * stride as u32..=ONE).step_by(stride * parts.len());
        patterns.find(|bits| {
            let p = f32::from_bits(*bits);
            words(p) as f64 != (f64::from(p) * ALL as f64).ceil()
        })
    });
    found.into_iter().flatten().min().map(f32::from_bits)
}

#[test]
fn a_probability_is_rounded_up_to_whole_words() {
    let stride = speed::of("one probability of every", 509, 1);
    assert_eq!(wrong(stated, stride), None);
    // To the nearest, which makes small ones impossible, and by a uniform of 24 bits.
    assert!(wrong(|p| (f64::from(p) * ALL as f64).round() as u64, stride).is_some());
    assert!(
        wrong(
            |p| ((f64::from(p) * 16_777_216.0).ceil() as u64) << 8,
            stride
        )
        .is_some()
    );
    for p in [0.0, -0.0] {
        assert_eq!(stated(p), 0);
    }
    assert_eq!(stated(f32::from_bits(1)), 1);
    assert_eq!(stated(1.0), ALL);
    assert_eq!(stated(1.0_f32.next_down()), ALL - 256);
}

#[test]
fn the_words_below_are_those_that_accept() {
    let mut rng = Pcg32::new(1, 1);
    let ours = |p: f32, word: u32| Chance::new(p).unwrap().accepts(word);
    let by_24_bits = |p: f32, word: u32| grid_from_word(word) < p;
    let mut failed = 0;
    for _ in 0..speed::of("probabilities", 100_000, 10_000_000) {
        let p = f32::from_bits(rng.next_u32() % (ONE + 1));
        let words = stated(p);
        assert!(accepts_below(|word| ours(p, word), words), "{p}");
        failed += u32::from(!accepts_below(|word| by_24_bits(p, word), words));
        let realised = Chance::new(p).unwrap().probability();
        assert_eq!(f64::from(realised), f64::from(words as f32) / ALL as f64);
        assert!(realised >= p && f64::from(realised) - f64::from(p) <= 1.0 / ALL as f64);
    }
    assert!(
        failed > 1_000,
        "a uniform of 24 bits decides otherwise: {failed}"
    );
}

/// Of so many in so many by the same product as a range of as many, without a division.
#[test]
fn a_ratio_has_exactly_its_words() {
    let law = |form: &dyn Fn(u32, u32, u32) -> bool| {
        let few = (1..=100).flat_map(|all| (0..=all).map(move |part| (part, all)));
        let mut rng = Pcg32::new(2, 2);
        let any = (0..speed::of("ratios", 100_000, 10_000_000)).map(|_| {
            let all = (rng.next_u32() >> (rng.next_u32() % 32)).max(1);
            (rng.next_u64() % (u64::from(all) + 1), all)
        });
        let any = any.map(|(part, all)| (part as u32, all));
        let ends = [u32::MAX, u32::MAX - 1, 1 << 31, (1 << 16) + 1];
        let ends = ends
            .into_iter()
            .flat_map(|all| [0, 1, 2, all / 2, all - 1, all].map(|part| (part, all)));
        few.chain(any).chain(ends).find(|(part, all)| {
            let words = (u128::from(*part) << 32).div_ceil(u128::from(*all)) as u64;
            !accepts_below(|word| form(*part, *all, word), words)
        })
    };
    let ours = |part, all, word| {
        let chance = Chance::from_ratio(part, all).unwrap();
        chance.accepts(word)
    };
    assert_eq!(law(&ours), None);
    assert!(law(&|part, all, word| word % all < part).is_some());
    assert!(law(&|part, all, word| grid_from_word(word) < part as f32 / all as f32).is_some());
    let mut rng = Pcg32::new(3, 3);
    for _ in 0..speed::of("counts", 100_000, 10_000_000) {
        let all = (rng.next_u32() >> (rng.next_u32() % 32)).max(1);
        let part = (rng.next_u64() % (u64::from(all) + 1)) as u32;
        let words = (u128::from(part) << 32).div_ceil(u128::from(all)) as u64;
        assert_eq!(
            Chance::from_ratio(part, all).unwrap().words(),
            words,
            "{part} in {all}"
        );
    }
}

/// An analogue of words of 16 bits: of every ratio of so many, all words are asked.
#[test]
fn a_comparison_of_products_counts_as_a_division_does() {
    let unequal = |form: &dyn Fn(u32, u32) -> u32, step: usize| {
        (1..=1_u32 << 15).step_by(step).find(|all| {
            // How many words give a product below so many: the words of each ratio of them.
            let mut words = vec![0_u32; *all as usize + 1];
            (0..1_u32 << 16).for_each(|word| words[form(word, *all) as usize + 1] += 1);
            let mut sum = 0;
            words.iter().zip(0..).any(|(more, part): (_, u32)| {
                sum += more;
                sum != (part << 16).div_ceil(*all)
            })
        })
    };
    let step = speed::of("one whole of every", 101, 1);
    assert_eq!(unequal(&|word, all| (word * all) >> 16, step), None);
    assert!(unequal(&|word, all| word % all, 1).is_some());
    assert!(unequal(&|word, all| ((word >> 4) * all) >> 12, 1).is_some());
}

#[test]
fn a_draw_takes_one_word_and_equal_chances_are_equal() {
    const SIX: Chance = constant!(Chance::from_ratio(1, 6));
    const HALF: Chance = constant!(Chance::new(0.5));
    let mut rng = Cycle::new(&[0x2aaa_aaaa, 0x2aaa_aaab, 0x7fff_ffff, 1 << 31]);
    assert_eq!([SIX.draw(&mut rng), SIX.draw(&mut rng)], [true, false]);
    assert_eq!(
        (HALF.draw(&mut rng), HALF.try_draw(&mut rng)),
        (true, Ok(false))
    );
    assert_eq!(HALF, Chance::from_ratio(3, 6).unwrap());
    assert_ne!(SIX, Chance::from_ratio(1, 7).unwrap());
}

#[test]
fn bad_chances_are_refused() {
    for (p, error) in [
        (f32::NAN, Error::NotFinite(0)),
        (f32::INFINITY, Error::NotFinite(0)),
        (-f32::MIN_POSITIVE, Error::Negative(0)),
        (1.0_f32.next_up(), Error::OutOfRange(0)),
    ] {
        assert_eq!(Chance::new(p), Err(error), "{p}");
    }
    assert_eq!(Chance::from_ratio(0, 0), Err(Error::NotPositive(1)));
    assert_eq!(Chance::from_ratio(3, 2), Err(Error::OutOfRange(1)));
}
