//! Walks in the unit cube: as many words lead from each grid point to each other as lead back.

use crate::laws::{HALF, Law, WORDS, boxed, exponential, normal};
use host::speed;
use microwarp::metropolis::{
    BoxStep, LogUniformStep, Mutation, NormalStep, StepLaw, WrappedWalk, wrapping_add,
};
use microwarp::tier::{Libm, Poly};
use microwarp::uniform::{LARGEST, grid_from_word};
use rand_core::Rng;
use rand_pcg::Pcg32;

/// Laws whose steps are below a grid spacing, about one, as long as the line, and many times as long.
fn laws() -> [Law; 8] {
    [
        boxed(1e-7),
        normal::<Libm>(1e-6),
        boxed(1.7),
        normal::<Poly>(50.0),
        exponential::<Poly>(1.0 / 1024.0, 1.0 / 64.0),
        exponential::<Libm>(1.0 / 1024.0, 1.0 / 64.0),
        exponential::<Poly>(1e-9, 1e-5),
        exponential::<Libm>(1e-8, 1e4),
    ]
}

/// One word of every `stride` and with each its inverse, whose step is the negative one.
fn words(stride: u32) -> impl Iterator<Item = u32> + Clone {
    speed::sampled(0..HALF, stride).flat_map(|high| [high, WORDS - 1 - high])
}

/// What the words of a law lead to from 0.
struct Distances {
    /// How many distances have not as many words as their negatives.
    uneven: usize,
    /// How many words lead out of the range, and how many to 0.
    outside: usize,
    still: u32,
}

fn distances(law: &Law, stride: u32, add: fn(f32, f32) -> f32) -> Distances {
    let mut counts = vec![0_u32; WORDS as usize];
    let mut outside = 0;
    for high in words(stride) {
        let to = add(0.0, (law.step)(high << 8));
        let place = (f64::from(to) * f64::from(WORDS)) as usize;
        match counts.get_mut(place) {
            Some(count) => *count += 1,
            None => outside += 1,
        }
    }
    let uneven = |k: &usize| counts[*k] != counts[WORDS as usize - k];
    Distances {
        uneven: (1..HALF as usize).filter(uneven).count(),
        outside,
        still: counts[0],
    }
}

/// The whole law: the number of words of each of the 2²⁴ distances is that of its negative. So as many words lead from each
/// grid point to each other as lead back.
#[test]
fn every_distance_has_the_words_of_its_negative() {
    let (stride, turns) = speed::of("one word of, random words", (32, 20_000), (1, 200_000));
    for law in laws() {
        let found = distances(&law, stride, wrapping_add);
        assert_eq!([found.uneven, found.outside], [0, 0], "{}", law.name);
        assert!(
            (found.still as usize) < words(stride).count(),
            "{} leads nowhere",
            law.name
        );
        // And it is the same everywhere.
        let mut rng = Pcg32::new(0xd157, 54);
        for _ in 0..turns {
            let [from, word] = [rng.next_u32() >> 8, rng.next_u32()];
            let step = (law.step)(word);
            let to = wrapping_add(grid_from_word(from << 8), step);
            let turned = (f64::from(wrapping_add(0.0, step)) * f64::from(WORDS)) as u32;
            assert_eq!(to, grid_from_word((from + turned) << 8), "{}", law.name);
        }
    }
    // The same counts see a sum in f32 that rounds.
    for law in laws().into_iter().take(2) {
        let rounding = |x, s| (x + s) - f32::floor(x + s);
        let naive = distances(&law, stride, rounding).uneven;
        println!(
            "{}: {naive} distances are uneven by adding in f32",
            law.name
        );
        assert!(naive > 0, "{}: {naive}", law.name);
    }
}

/// A law that is asked by the mutation and by the test.
struct Borrowed<'a, L>(&'a L);

impl<L: StepLaw<[f32; 3]>> StepLaw<[f32; 3]> for Borrowed<'_, L> {
    fn displacement(&self, axis: usize, word: u32) -> f32 {
        self.0.displacement(axis, word)
    }
}

/// By the mutation: from anywhere, even from what is no point of the cube, to the sum modulo 1.
fn walks<L: StepLaw<[f32; 3]>>(law: L) {
    let mutation = WrappedWalk::new(Borrowed(&law));
    let any = [
        f32::NAN,
        7.0,
        -1.0,
        f32::INFINITY,
        f32::NEG_INFINITY,
        1.0,
        LARGEST,
        0.3,
    ];
    let mut words = Pcg32::new(0x3a1c, 54);
    let mut rng = words.clone();
    for turn in 0..20_000 {
        let from: [f32; 3] = std::array::from_fn(|axis| any[(turn * 3 + axis) % any.len()]);
        let Ok(proposal) = mutation.try_propose(from, &mut rng);
        assert_eq!(proposal.kind, 0);
        for (axis, (before, to)) in from.into_iter().zip(proposal.state).enumerate() {
            let step = law.displacement(axis, words.next_u32());
            assert_eq!(to, wrapping_add(before, step));
            assert!((0.0..1.0).contains(&to), "{before} to {to}");
        }
    }
}

#[test]
fn a_state_out_of_range_is_brought_in() {
    walks(BoxStep::new([0.1, 0.0, 1000.0]).unwrap());
    walks(NormalStep::<_, Libm>::new([0.1, 0.0, 6e37]).unwrap());
    walks(NormalStep::<_, Poly>::new([1e-30, 1e-7, 1.0]).unwrap());
    walks(LogUniformStep::<Libm>::new(1e-45, f32::MAX).unwrap());
    walks(LogUniformStep::<Poly>::new(1.0 / 1024.0, 1.0 / 64.0).unwrap());
}
