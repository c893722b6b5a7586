//! Integers of a range: each has exactly the words that are its share, what is left over is a word, and the wrong ways to draw one
//! fail the same tests.

use host::generators::{Broken, Cycle, Failing};
use host::speed;
use microwarp::uniform::{Chance, Range, try_up_to, up_to, up_to_from_word};
use microwarp::{Error, constant};
use rand_core::Rng;
use rand_pcg::Pcg32;

const ALL: u64 = 1 << 32;

/// The first word of an integer: words increase with the integers.
fn first(k: u64, n: u64) -> u64 {
    ((u128::from(k) << 32).div_ceil(u128::from(n))) as u64
}

/// Whether a form gives integer k of n to the words from its first one to that of the next, by both ends; 1 and n are 2³² at most.
fn fair(form: &impl Fn(u32, u64) -> u64, n: u64, k: u64) -> bool {
    let [from, to] = [k, k + 1].map(|k| first(k, n));
    form(from as u32, n) == k && form((to - 1) as u32, n) == k
}

/// Pairs of a number of integers and one of them: all of few, and of any number the ends and some others.
fn cases() -> impl Iterator<Item = (u64, u64)> {
    let few = (1..=speed::of("all integers of as many as", 300, 3_000))
        .flat_map(|n| (0..n).map(move |k| (n, k)));
    let mut rng = Pcg32::new(3, 3);
    let rounds = speed::of("numbers of integers", 20_000, 3_000_000);
    let any = (0..rounds).flat_map(move |_| {
        let n = 1 + (u64::from(rng.next_u32()) >> (rng.next_u32() % 32));
        [0, n - 1, n / 2, rng.next_u64() % n].map(|k| (n, k))
    });
    let ends = [ALL, ALL - 1, ALL / 2, ALL / 2 + 1, (1 << 16) + 1, 1 << 16];
    let ends = ends
        .into_iter()
        .flat_map(|n| [0, 1, n / 3, n - 2, n - 1].map(|k| (n, k)));
    few.chain(any).chain(ends)
}

#[test]
fn each_integer_has_exactly_its_share_of_the_words() {
    let unfair = |form: &dyn Fn(u32, u64) -> u64| cases().find(|(n, k)| !fair(&form, *n, *k));
    let ours = |word: u32, n: u64| u64::from(up_to_from_word((n - 1) as u32, word));
    assert_eq!(unfair(&ours), None);
    // The remainder, a uniform of 24 bits and one that is rounded.
    assert!(unfair(&|word, n| u64::from(word) % n).is_some());
    assert!(unfair(&|word, n| (u64::from(word >> 8) * n) >> 24).is_some());
    assert!(unfair(&|word, n| ((u64::from(word) * n + ALL / 2) >> 32).min(n - 1)).is_some());
    assert!(unfair(&|word, n| (word as f32 / ALL as f32 * n as f32) as u64).is_some());
}

#[test]
fn a_range_says_how_many_words_select_each_integer() {
    for (n, k) in cases() {
        let (last, k) = ((n - 1) as u32, k as u32);
        let words = first(u64::from(k) + 1, n) - first(k.into(), n);
        assert!(words == ALL / n || words == ALL / n + 1);
        let range = Range::new(0, last).unwrap();
        assert_eq!(range.numerator(k), words, "{k} of {n}");
        assert_eq!(
            f64::from(range.pmf(k)),
            f64::from(words as f32) / ALL as f64
        );
        // Wherever the range lies, and with a sign.
        let low = k.wrapping_mul(0x9e37_79b9) % (u32::MAX - last).max(1);
        let moved = Range::new(low, low + last).unwrap();
        assert_eq!(moved.numerator(low + k), words);
        let signed = Range::signed(
            i32::MIN.wrapping_add_unsigned(low),
            i32::MIN.wrapping_add_unsigned(low + last),
        );
        let integer = i32::MIN.wrapping_add_unsigned(low + k);
        assert_eq!(signed.unwrap().numerator(integer), words);
        let word = first(k.into(), n) as u32;
        assert_eq!(moved.select(word).0, low + k);
        assert_eq!(signed.unwrap().select(word).0, integer);
    }
    let die = Range::new(1, 6).unwrap();
    let sum: u64 = (0..=9).map(|face| die.numerator(face)).sum();
    assert_eq!((sum, die.numerator(0), die.numerator(7)), (ALL, 0, 0));
    let level = Range::signed(-3, 3).unwrap();
    assert_eq!(
        (level.numerator(-4), level.pmf(4), level.low(), level.high()),
        (0, 0.0, -3, 3)
    );
    let whole = Range::signed(i32::MIN, i32::MAX).unwrap();
    assert_eq!(
        (
            whole.numerator(0),
            whole.select(0).0,
            whole.select(u32::MAX).0
        ),
        (1, i32::MIN, i32::MAX)
    );
}

/// The total variation distance from uniform is r(n − r)/(n·2³²) of the 2³² mod n = r integers with a word more.
#[test]
fn the_distance_from_uniform_is_at_most_a_quarter_of_the_integers_in_words() {
    for n in 1..=speed::of("numbers of integers", 300, 3_000) {
        let range = Range::below(n).unwrap();
        let n = u64::from(n);
        let away: u64 = (0..n)
            .map(|k| (range.numerator(k as u32) * n).abs_diff(ALL))
            .sum();
        let rest = ALL % n;
        assert_eq!(away, 2 * rest * (n - rest));
        assert!(away <= n * n / 2);
    }
}

#[test]
fn what_is_left_selects_as_one_of_the_product() {
    let law = |select: fn(Range, u32) -> (u32, u32)| {
        let mut rng = Pcg32::new(9, 9);
        let rounds = speed::of("pairs of ranges", 200_000, 2_000_000);
        (0..rounds).all(|_| {
            let word = rng.next_u32();
            let [n, m] = [(); 2].map(|()| 1 + (rng.next_u32() >> 16 >> (rng.next_u32() % 16)));
            let (first, rest) = select(Range::below(n).unwrap(), word);
            let (second, _) = Range::below(m).unwrap().select(rest);
            first * m + second == up_to_from_word(n * m - 1, word)
        })
    };
    assert!(law(Range::<u32>::select));
    // The word itself is no rest, nor is the remainder of a division.
    assert!(!law(|range, word| (range.select(word).0, word)));
    assert!(!law(|range, word| (
        range.select(word).0,
        word % (range.high() + 1)
    )));
    assert_eq!(
        Range::new(0, u32::MAX).unwrap().select(0xdead_beef),
        (0xdead_beef, 0)
    );
}

#[test]
fn two_words_are_one_fraction() {
    let mut rng = Pcg32::new(4, 4);
    let (mut other, rounds) = (0, speed::of("draws", 200_000, 2_000_000));
    for _ in 0..rounds {
        let last = rng.next_u32() >> (rng.next_u32() % 32);
        let words = [rng.next_u32(), rng.next_u32()];
        let fraction = u128::from(words[0]) << 32 | u128::from(words[1]);
        let exact = ((fraction * (u128::from(last) + 1)) >> 64) as u32;
        let range = Range::new(0, last).unwrap();
        assert_eq!(range.draw_wide(&mut Cycle::new(&words)), exact);
        let low = i32::MIN.wrapping_add_unsigned(u32::MAX - last);
        let signed = Range::signed(low, i32::MAX).unwrap();
        assert_eq!(
            signed.draw_wide(&mut Cycle::new(&words)),
            low.wrapping_add_unsigned(exact)
        );
        let single = range.draw(&mut Cycle::new(&words));
        assert!(exact - single <= 1);
        other += u32::from(exact > single);
        // The same of 64 bits.
        let [from, to] = [u64::from(low as u32), u64::MAX - u64::from(words[0])];
        let range = Range::of_u64(from, to).unwrap();
        let word = u128::from(words[0]) << 32 | u128::from(words[1]);
        let product = word * u128::from(to - from + 1);
        let drawn = range.draw(&mut Cycle::new(&words));
        assert_eq!(drawn, from + (product >> 64) as u64);
        assert_eq!(range.select(word as u64), (drawn, product as u64));
    }
    println!("{other} of {rounds} differ from those of one word");
    assert!(other > 0 && other < rounds / 10);
}

#[test]
fn ranges_of_64_bits_have_their_words_too() {
    let all = 1_u128 << 64;
    let whole = Range::of_u64(0, u64::MAX).unwrap();
    assert_eq!((whole.select(77), whole.numerator(77)), ((77, 0), 1));
    let mut rng = Pcg32::new(6, 6);
    for _ in 0..speed::of("ranges", 2_000, 100_000) {
        let last = rng.next_u64() >> (rng.next_u32() % 64);
        let low = rng.next_u64() % (u64::MAX - last).max(1);
        let range = Range::of_u64(low, low + last).unwrap();
        let n = u128::from(last) + 1;
        let k = rng.next_u64() % n.min(u128::from(u64::MAX)) as u64;
        // ⌈k·2⁶⁴/n⌉ by two divisions, since the product has too many bits.
        let start = |k: u128| {
            let (whole, rest) = ((k << 32) / n, (k << 32) % n);
            (whole << 32) + (rest << 32).div_ceil(n)
        };
        let [from, to] = [k.into(), u128::from(k) + 1].map(start);
        assert!(to <= all);
        assert_eq!(range.numerator(low + k), to - from);
        assert_eq!(range.select(from as u64).0, low + k);
        assert_eq!(range.select((to - 1) as u64).0, low + k);
        assert_eq!(
            f64::from(range.pmf(low + k)),
            f64::from((to - from) as f32) * 2f64.powi(-64)
        );
    }
    assert_eq!(Range::of_u64(5, 9).unwrap().numerator(4), 0);
}

#[test]
fn draws_take_their_words_and_pass_errors_on() {
    const DIE: Range = constant!(Range::new(1, 6));
    let mut rng = Cycle::new(&[0, u32::MAX, 1 << 31]);
    assert_eq!(
        [DIE.draw(&mut rng), DIE.draw(&mut rng), DIE.draw(&mut rng)],
        [1, 6, 4]
    );
    assert_eq!((up_to(9, &mut rng), try_up_to(9, &mut rng)), (0, Ok(9)));
    assert_eq!(Range::signed(-8, 7).unwrap().try_draw(&mut rng), Ok(0));
    assert_eq!(DIE.try_draw_wide(&mut rng), Ok(1));
    assert_eq!(
        Range::of_u64(1, 1 << 60).unwrap().try_draw(&mut rng),
        Ok((1 << 59) + 1)
    );
}

/// Whether a draw takes so many words, and hands on the error of a generator that fails at each of them.
fn takes<T>(words: u64, draw: impl Fn(&mut Failing) -> Result<T, Broken>) -> bool {
    let mut enough = Failing {
        word: 1 << 31,
        left: words,
    };
    draw(&mut enough).is_ok()
        && enough.left == 0
        && (0..words).all(|left| draw(&mut Failing { word: 7, left }).err() == Some(Broken(17)))
}

#[test]
fn every_draw_takes_the_words_stated() {
    let (die, coin) = (Range::new(1, 6).unwrap(), Chance::new(0.1).unwrap());
    let level = Range::signed(-3, 3).unwrap();
    let long = Range::of_u64(0, u64::MAX).unwrap();
    assert!(takes(1, |rng| die.try_draw(rng)));
    assert!(takes(2, |rng| die.try_draw_wide(rng)));
    assert!(takes(1, |rng| level.try_draw(rng)));
    assert!(takes(2, |rng| level.try_draw_wide(rng)));
    assert!(takes(2, |rng| long.try_draw(rng)));
    assert!(takes(1, |rng| try_up_to(5, rng)));
    assert!(takes(1, |rng| coin.try_draw(rng)));
    assert!(!takes(1, |rng| die.try_draw_wide(rng)));
    assert!(!takes(2, |rng| die.try_draw(rng)));
}

#[test]
fn empty_ranges_are_refused() {
    assert_eq!(Range::below(0), Err(Error::Empty(0)));
    assert_eq!(Range::new(2, 1), Err(Error::Empty(1)));
    assert_eq!(Range::signed(0, -1), Err(Error::Empty(1)));
    assert_eq!(Range::of_u64(u64::MAX, 0), Err(Error::Empty(1)));
    assert_eq!(Range::below(1).unwrap().select(u32::MAX), (0, u32::MAX));
}
