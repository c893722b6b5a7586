//! Uniform intervals, exactly.

use fixed::types::extra::{U16, U32};
use fixed::types::{I0F32, I16F16, U0F32, U16F16};
use fixed::{FixedI32, FixedU32};
use host::speed;
use microwarp::fixed::{Interval, Number};
use microwarp::{Error, Invert, Warp};

fn word(w: u128) -> U0F32 {
    U0F32::from_bits(u32::try_from(w).unwrap())
}

/// Every value has the words from ⌈2³²k/n⌉ to before ⌈2³²(k + 1)/n⌉, of which there are ⌊2³²/n⌋ or one more.
fn words_are_shared_exactly<T: Number + PartialEq + core::fmt::Debug>(
    warp: &Interval<T>,
    n: u64,
    nth: impl Fn(u64) -> T,
) {
    assert_eq!(warp.count(), n);
    let first = |k: u64| (u128::from(k) << 32).div_ceil(u128::from(n));
    let step = (n / 5000).max(1);
    let values = (0..n)
        .step_by(step as usize)
        .chain(n.saturating_sub(50)..n)
        .chain(0..50.min(n));
    for k in values {
        let (from, to) = (first(k), first(k + 1));
        let share = (1 << 32) / n;
        assert!((to - from) as u64 == share || (to - from) as u64 == share + 1);
        assert_eq!(warp.sample(word(from)), nth(k));
        assert_eq!(warp.sample(word(to - 1)), nth(k));
        assert_eq!(warp.invert(nth(k)), word(from));
        assert!(warp.pdf(nth(k)) > 0);
    }
    assert_eq!(warp.sample(word(u128::from(u32::MAX))), nth(n - 1));
}

const LENGTHS: [u64; 14] = [
    1,
    2,
    3,
    5,
    6,
    7,
    255,
    1000,
    65_536,
    65_537,
    1_000_003,
    0x7fff_ffff,
    0x8000_0000,
    0xffff_ffff,
];

#[test]
fn every_value_of_an_interval_has_its_share_of_words() {
    for n in LENGTHS {
        for a in [i64::from(i32::MIN), -70_000, -1, 0, 5] {
            let b = a + n as i64;
            if let (Ok(low), Ok(high)) = (i32::try_from(a), i32::try_from(b)) {
                let nth = |k| i32::try_from(a + k as i64).unwrap();
                words_are_shared_exactly(&Interval::<i32>::new(low, high).unwrap(), n, nth);
                let bits = FixedI32::<U16>::from_bits;
                let format = Interval::<I16F16>::new(bits(low), bits(high)).unwrap();
                words_are_shared_exactly(&format, n, |k| bits(nth(k)));
                let last = Interval::<i32>::inclusive(low, high - 1).unwrap();
                assert_eq!(last, Interval::<i32>::new(low, high).unwrap());
            }
            if let (Ok(low), Ok(high)) = (u32::try_from(a), u32::try_from(b)) {
                let nth = |k: u64| low + k as u32;
                words_are_shared_exactly(&Interval::<u32>::new(low, high).unwrap(), n, nth);
                let bits = FixedU32::<U16>::from_bits;
                let format = Interval::<U16F16>::new(bits(low), bits(high)).unwrap();
                words_are_shared_exactly(&format, n, |k| bits(nth(k)));
            }
        }
    }
}

#[test]
fn all_values_may_be_drawn() {
    let all = Interval::<i32>::inclusive(i32::MIN, i32::MAX).unwrap();
    let nth = |k: u64| (i64::from(i32::MIN) + k as i64) as i32;
    words_are_shared_exactly(&all, 1 << 32, nth);
    assert_eq!(all.pdf(7).to_bits(), 1);
    let all = Interval::<u32>::inclusive(0, u32::MAX).unwrap();
    words_are_shared_exactly(&all, 1 << 32, |k| k as u32);
}

#[test]
fn no_word_leaves_an_interval() {
    // The product is the same whatever the length; three of them.
    let stride = speed::of("one word of an interval tried of every", 1021, 16);
    for (a, b) in [(-3, 4), (i32::MIN, i32::MAX), (1_000_000, 3_000_017)] {
        let warp = Interval::<i32>::new(a, b).unwrap();
        let mut last = a;
        for w in (0..=u32::MAX).step_by(stride) {
            let x = warp.sample(U0F32::from_bits(w));
            assert!(last <= x && x < b, "{w:#x}: {x}");
            last = x;
        }
    }
}

#[test]
fn a_density_is_the_reciprocal_length_to_half_a_step() {
    for n in LENGTHS {
        for fraction in [0_u32, 16, 31, 32] {
            let one = 1_u128 << (32 + fraction);
            let n = u128::from(n);
            // To the nearest, halves upwards; at least a step, at most the largest.
            let due = ((2 * one + n) / (2 * n)).clamp(1, u128::from(u64::MAX)) as u64;
            let end = n as u32;
            let got = match fraction {
                0 => Interval::<u32>::new(0, end).unwrap().pdf(0),
                16 => Interval::<U16F16>::new(FixedU32::ZERO, FixedU32::from_bits(end))
                    .unwrap()
                    .pdf(FixedU32::ZERO),
                31 => {
                    type Half = FixedU32<fixed::types::extra::U31>;
                    let warp = Interval::<Half>::new(Half::ZERO, Half::from_bits(end));
                    warp.unwrap().pdf(Half::ZERO)
                }
                _ => Interval::<FixedU32<U32>>::new(FixedU32::ZERO, FixedU32::from_bits(end))
                    .unwrap()
                    .pdf(FixedU32::ZERO),
            };
            assert_eq!(got.to_bits(), due, "{n} in {fraction}");
        }
    }
}

#[test]
fn outside_there_is_no_density_and_the_nearest_value_s_word() {
    let warp = Interval::<i32>::new(-3, 5).unwrap();
    for x in [i32::MIN, -4, 5, 6, i32::MAX] {
        assert_eq!(warp.pdf(x), 0);
        let due = if x < 0 { -3 } else { 4 };
        assert_eq!(warp.sample(warp.invert(x)), due);
    }
    let warp = Interval::<u32>::new(7, 9).unwrap();
    assert_eq!(
        (warp.invert(0).to_bits(), warp.invert(u32::MAX)),
        (0, warp.invert(8))
    );
}

#[test]
fn bounds_in_the_wrong_order_are_refused() {
    assert_eq!(Interval::<i32>::new(1, 0), Err(Error::Reversed(1)));
    assert_eq!(Interval::<i32>::new(0, 0), Err(Error::Empty(1)));
    assert_eq!(Interval::<i32>::inclusive(0, -1), Err(Error::Reversed(1)));
    assert_eq!(
        Interval::<i32>::new(i32::MAX, i32::MIN),
        Err(Error::Reversed(1))
    );
    // Bits that are larger as words, but of a smaller number.
    assert!(Interval::<i32>::new(-1, 0).is_ok());
    assert!(Interval::<I0F32>::new(I0F32::MIN, I0F32::MAX).is_ok());
    assert_eq!(Interval::<u32>::new(u32::MAX, 0), Err(Error::Reversed(1)));
    const DICE: Result<Interval<i32>, Error> = Interval::<i32>::inclusive(1, 6);
    assert_eq!(DICE.unwrap().sample(U0F32::MAX), 6);
}
