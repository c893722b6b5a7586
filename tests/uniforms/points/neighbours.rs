//! Words of neighbours are independent, in pairs and in triples: of samples, of pixels, of generators seeded by their number.

use host::speed;
use host::stats::{dependences, passes, threshold};
use microwarp::uniform::{ByPosition, Points};
use rand_pcg::Pcg32;
use rand_pcg::rand_core::{Rng, SeedableRng};

/// Three words of a neighbour, by its number.
type Words = fn(u32) -> [u32; 3];

/// How many neighbours there are.
const COUNT: u32 = 1 << 20;

fn three(mut rng: Pcg32) -> [u32; 3] {
    std::array::from_fn(|_| rng.next_u32())
}

/// As the documentation seeds many generators.
fn seeded(index: u32) -> [u32; 3] {
    three(Pcg32::from_rng(&mut ByPosition::new(42, index).at(0)))
}

fn dependences_of(words: Words) -> Vec<f64> {
    let shifts: &[u32] = speed::of("places of bits in words", &[0], &[0, 13, 26]);
    dependences(&(0..COUNT).map(words).collect::<Vec<_>>(), shifts)
}

#[test]
fn words_of_neighbours_are_independent_in_pairs_and_triples() {
    let samples = |sample| ByPosition::new(2026, 7).words(sample);
    let pixels = |pixel| ByPosition::new(2026, pixel).words(0);
    let subjects: [(&str, Words); 3] = [
        ("samples", samples),
        ("pixels", pixels),
        ("generators", seeded),
    ];
    for (name, words) in subjects {
        let found = dependences_of(words);
        let smallest = found.iter().copied().fold(1.0, f64::min);
        println!("{name}: {} tests, smallest p {smallest:.1e}", found.len());
        assert!(passes(&found, threshold(found.len())), "{name}");
    }
}

/// Neighbouring seeds and neighbouring streams of PCG32, which are anything but that.
#[test]
fn plain_neighbours_are_rejected() {
    let seeds = |i: u32| three(Pcg32::new(42 + u64::from(i), 54));
    let streams = |i: u32| three(Pcg32::new(42, i.into()));
    let controls: [(&str, Words); 2] = [("seeds", seeds), ("streams", streams)];
    for (name, words) in controls {
        let found = dependences_of(words);
        let limit = threshold(found.len());
        let refused = found.iter().filter(|p| **p < limit).count();
        println!("{name}: {refused} of {} tests object", found.len());
        assert!(!passes(&found, limit), "{name}");
    }
}

/// Known words, those of C and JavaScript too.
#[test]
fn a_seeded_generator_has_its_words() {
    let words: [[u32; 3]; 3] = [0, 1, u32::MAX].map(seeded);
    let known = [
        [0x93d8_a563, 0xb22c_b017, 0x9f11_4892],
        [0x998a_9383, 0xc042_68ab, 0x7b4f_30ef],
        [0xa765_a3a5, 0xe971_8413, 0xce78_1d5f],
    ];
    assert_eq!(words, known);
}
