//! Canonical uniforms: every value of a grid is reachable and equally likely, and nothing leaves [0, 1).

use host::speed;
use microwarp::uniform::{
    LARGEST, SMALLEST, Uniforms, deep_from_word, full_from_words, grid_from_word, open_from_word,
};
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;

/// All 2^32 words, in the quick speed one of every 1021, a thread for each half.
fn for_all_words(law: impl Fn(u32) + Sync) {
    let stride = speed::of("one word tried of every", 61, 1);
    std::thread::scope(|scope| {
        for half in 0..2_u32 {
            let law = &law;
            scope.spawn(move || {
                for rest in (0..1_u32 << 31).step_by(stride) {
                    law(half << 31 | rest);
                }
            });
        }
    });
}

#[test]
fn each_value_of_the_grid_comes_from_256_words() {
    for_all_words(|word| {
        let exact = f64::from(word >> 8) / f64::from(1_u32 << 24);
        assert!(f64::from(grid_from_word(word)) == exact, "{word:#x}");
    });
}

#[test]
fn each_value_of_the_open_grid_comes_from_512_words() {
    for_all_words(|word| {
        let exact = (f64::from(word >> 9) + 0.5) / f64::from(1_u32 << 23);
        assert!(f64::from(open_from_word(word)) == exact, "{word:#x}");
    });
    assert!(open_from_word(0) > 0.0 && open_from_word(u32::MAX) < 1.0);
}

#[test]
fn the_deep_grid_has_the_middles_of_words_near_0_and_of_cells_above() {
    let check = |word: u32| {
        let middle =
            |bits: u32| (f64::from(word >> bits) + 0.5) / f64::from(1_u32 << (31 - bits)) / 2.0;
        let exact = middle(if word < 1 << 23 { 0 } else { 9 });
        assert!(f64::from(deep_from_word(word)) == exact, "{word:#x}");
    };
    let mut rng = Pcg32::new(23, 54);
    for _ in 0..100_000 {
        let word = rng.next_u32();
        check(word >> (word % 32));
    }
    for word in [0, 1, (1 << 23) - 1, 1 << 23, (1 << 23) + 511, u32::MAX] {
        check(word);
    }
}

/// The 64-bit fraction truncated to 24 significant bits, in integers alone.
fn truncated(bits: u64) -> f64 {
    let extra = (40_u32).saturating_sub(bits.leading_zeros());
    ((bits >> extra) << extra) as f64 * 2f64.powi(-64)
}

#[test]
fn full_resolution_truncates_the_fraction() {
    let mut rng = Pcg32::new(11, 54);
    let check = |bits: u64| {
        let u = full_from_words((bits >> 32) as u32, bits as u32);
        assert!(f64::from(u) == truncated(bits), "{bits:#x}: {u}");
        assert!((0.0..1.0).contains(&u), "{bits:#x}: {u}");
    };
    for _ in 0..1_000_000 {
        // Every number of leading zeros, many times over.
        let bits = u64::from(rng.next_u32()) << 32 | u64::from(rng.next_u32());
        check(bits >> (rng.next_u32() % 64));
    }
    for shift in 0..64 {
        for bits in [
            u64::MAX >> shift,
            1 << shift,
            (1 << shift) - 1,
            (1 << shift) + 1,
        ] {
            check(bits);
        }
    }
    check(0);
    assert_eq!(full_from_words(u32::MAX, u32::MAX), LARGEST);
}

#[test]
fn full_resolution_is_monotone_and_reaches_far_below_the_grid() {
    let mut last = -1.0;
    for k in 0..64_u32 {
        let bits = 1_u64 << k;
        let u = full_from_words((bits >> 32) as u32, bits as u32);
        assert!(u > last);
        last = u;
    }
    assert_eq!(full_from_words(0, 1), 2f32.powi(-64));
    // The tail of -ln u: 16.64 on the grid, 44.36 here.
    let tail = |u: f32| -f64::from(u).ln();
    assert!((tail(grid_from_word(256)) - 16.64).abs() < 0.01);
    assert!((tail(full_from_words(0, 1)) - 44.36).abs() < 0.01);
}

#[test]
fn any_f32_is_brought_into_the_unit_interval() {
    // Bit patterns of f32 in the order of their bits.
    let stride = speed::of("one f32 tried of every", 1_009, 97);
    for bits in (0..=u32::MAX).step_by(stride) {
        let x = f32::from_bits(bits);
        let u = x.canonical().get();
        let expected = if x.is_nan() || x <= 0.0 {
            0.0
        } else if x >= 1.0 {
            LARGEST
        } else {
            x
        };
        assert!(u == expected && u.is_sign_positive(), "{x} becomes {u}");
    }
    assert_eq!(LARGEST, 1.0_f32.next_down());
    assert_eq!(SMALLEST, 0.0_f32.next_up());
}

#[test]
fn arrays_are_brought_in_and_drawn_number_by_number() {
    let u = [f32::NAN, -3.0, 0.25, 9.0].canonical();
    assert_eq!(u.get(), [0.0, 0.0, 0.25, LARGEST]);
    assert_eq!(u.each().map(|u| u.get()), u.get());
    assert_eq!(<[f32; 4]>::COUNT, 4);
    let (mut array, mut single) = (Pcg32::new(2, 2), Pcg32::new(2, 2));
    let drawn = <[f32; 4]>::try_draw(&mut array).unwrap().get();
    assert_eq!(
        drawn,
        [(); 4].map(|()| f32::try_draw(&mut single).unwrap().get())
    );
}
