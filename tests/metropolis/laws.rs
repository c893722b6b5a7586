//! The laws of steps, over every word: each as likely as its negative, to the last bit, and a box step exactly. `step_errors`
//! measures the others against theirs.

use host::speed::{self, sampled};
use microwarp::metropolis::{BoxStep, LogUniformStep, NormalStep, StepLaw};
use microwarp::tier::{Libm, Poly, Tier};

/// The words that differ, as the upper 24 bits of one.
pub const WORDS: u32 = 1 << 24;
/// Those that give one of two steps that are each other's negatives.
pub const HALF: u32 = WORDS / 2;

/// A step law along one coordinate, its type erased.
pub struct Law {
    pub name: String,
    pub step: Box<dyn Fn(u32) -> f32>,
}

fn law(name: String, step: impl StepLaw<f32> + 'static) -> Law {
    let step = Box::new(move |word| step.displacement(0, word));
    Law { name, step }
}

pub fn boxed(width: f32) -> Law {
    law(format!("BoxStep {width:e}"), BoxStep::new(width).unwrap())
}

pub fn normal<T: Tier>(deviation: f32) -> Law {
    let step = NormalStep::<_, T>::new(deviation).unwrap();
    law(format!("{} NormalStep {deviation:e}", T::NAME), step)
}

pub fn exponential<T: Tier>(smallest: f32, largest: f32) -> Law {
    let step = LogUniformStep::<T>::new(smallest, largest).unwrap();
    let name = format!("{} LogUniformStep {smallest:e} {largest:e}", T::NAME);
    law(name, step)
}

/// Every law with parameters about 1 and at both ends of what is accepted.
fn laws() -> Vec<Law> {
    let tiny = f32::from_bits(1);
    let mut laws: Vec<_> = [0.1, 1.0, f32::MAX, f32::MIN_POSITIVE, 3.0 * tiny, tiny]
        .map(boxed)
        .into();
    for size in [1.0, 1e-38, 6e37, tiny] {
        laws.push(normal::<Libm>(size));
        laws.push(normal::<Poly>(size));
    }
    for (smallest, largest) in [
        (1.0 / 1024.0, 1.0 / 64.0),
        (1e-30, 1e30),
        (2.0, 2.0),
        (tiny, f32::MAX),
        (tiny, tiny),
        (f32::MAX, f32::MAX),
    ] {
        laws.push(exponential::<Libm>(smallest, largest));
        laws.push(exponential::<Poly>(smallest, largest));
    }
    laws
}

#[test]
fn the_inverted_word_gives_the_negative_step_to_the_bit() {
    let words = sampled(0..HALF, speed::of("one word of", 127, 1));
    for Law { name, step } in laws() {
        for high in words.clone() {
            let word = high << 8;
            let (there, back) = (step(word), step(!word));
            assert_eq!(back.to_bits(), (-there).to_bits(), "{name}: {word:x}");
            assert!(there.is_finite(), "{name}: {word:x}");
        }
    }
    // The same comparison of a law that has no such words.
    let naive = |word: u32| (word >> 8) as f32 * 2f32.powi(-24) - 0.5;
    let off = words.clone().filter(|high| {
        let word = high << 8;
        naive(!word).to_bits() != (-naive(word)).to_bits()
    });
    assert_eq!(off.count(), words.count());
}

#[test]
fn the_low_eight_bits_of_a_word_do_not_matter() {
    let laws = [
        boxed(0.1),
        normal::<Libm>(3.0),
        normal::<Poly>(3.0),
        exponential::<Libm>(1e-6, 1.0),
        exponential::<Poly>(1e-6, 1.0),
    ];
    let words = sampled(0..WORDS, speed::of("one word of", 61, 1));
    for Law { name, step } in laws {
        for high in words.clone() {
            let word = high << 8;
            let bits = step(word).to_bits();
            // Every low byte here and there, one of them everywhere.
            let bytes = if high % 4099 == 0 { 0..256 } else { 0..1 };
            for low in bytes.chain([high.wrapping_mul(0x9e37_79b1) >> 24]) {
                assert_eq!(step(word | low).to_bits(), bits, "{name}: {word:x} {low:x}");
            }
        }
    }
}

/// The steps are the odd multiples of the width times 2⁻²⁵, rounded once: each of one word of the 2²⁴.
#[test]
fn a_box_step_is_an_odd_multiple_of_its_width() {
    let tiny = f32::from_bits(1);
    let mut widths = vec![1.0, 0.1, 3.0, f32::MAX, f32::MIN_POSITIVE];
    widths.extend((1..40).map(|k| k as f32 * tiny));
    let words = sampled(0..HALF, speed::of("one word of", 127, 1));
    for width in widths {
        let law = boxed(width);
        let mut seen = vec![0_u32; HALF as usize / 32];
        for high in words.clone() {
            let got = (law.step)(high << 8);
            // Of a step that is not rounded away the multiple can be read off.
            let odd = (f64::from(high) * 2.0 + 1.0) * 2f64.powi(-25);
            let exact = odd * f64::from(width);
            assert_eq!(got, exact as f32, "{width:e}: {high:x}");
            assert!(f64::from(got) <= 0.5 * f64::from(width) + 1e-46);
            if width == 1.0 {
                let place = (f64::from(got) * 2f64.powi(24)).floor() as usize;
                seen[place / 32] |= 1 << (place % 32);
            }
        }
        let places: u32 = seen.iter().map(|bits| bits.count_ones()).sum();
        assert!(width != 1.0 || places as usize == words.clone().count());
    }
}
