//! The subjects that run on integers alone: chains of integer weights, exact selections, fixed-point disks.

use crate::Out;
use crate::subjects::{failed, generator, refusal, verdict, with};
use core::hint::black_box;
use core::num::NonZeroU32;
use fixed::types::{I2F30, U0F32};
use microwarp::discrete::resampling::{rearrange, residual, stratified, systematic, to_integers};
use microwarp::discrete::{Alias, AliasEntry, Cdf, ExactSelection, SumTree, WeightedReservoir};
use microwarp::fixed::{DiskRejection, DiskRejection16};
use microwarp::metropolis::*;
use microwarp::rejection::{Accepted, Failure, Rejection};
use microwarp::uniform::{Chance, Range, up_to, up_to_from_word};

/// Steps a case takes, so that an error anywhere has spread by its end.
const STEPS: usize = 20;

/// Four words of the inputs: the bits of the uniforms, stirred.
pub(crate) fn stirred(u: [f32; 4]) -> [u32; 4] {
    let mut rest = 0x9e37_79b9_u32;
    u.map(|u| {
        rest = (rest ^ u.to_bits())
            .wrapping_mul(0x85eb_ca6b)
            .rotate_left(13);
        rest
    })
}

fn wide(x: u64, out: &mut Out) {
    out.word((x >> 32) as u32);
    out.word(x as u32);
}

/// Some steps of a chain, then what has been recorded, where it is and what it has counted.
fn walk<M: Mutation<usize>>(weights: &[u32; 6], mutation: &M, input: usize, out: &mut Out) {
    let weight = |i: usize| weights.get(i).copied().unwrap_or(0);
    with(Chain::new(1, weight), out, |mut chain, out| {
        let mut rng = generator(input);
        let (mut all, mut kinds) = (0, 0);
        for k in 0..STEPS {
            let step = if k % 5 == 4 {
                chain.step_limited(weight, mutation, NonZeroU32::MIN, &mut rng)
            } else {
                chain.step(weight, mutation, &mut rng)
            };
            for (state, words) in step.recorded() {
                all += words * (state as u64 + 1);
            }
            kinds += step.kind;
        }
        wide(all, out);
        out.word(kinds);
        out.word(chain.state() as u32);
        out.word(chain.accepted() as u32);
        out.word(chain.density());
    });
}

pub fn chains(u: [f32; 4], input: usize, out: &mut Out) {
    let [a, b, c, d] = stirred(u);
    let weights = [a >> (b & 31), c | 1, 0, d, u32::MAX, 1];
    let rows = || {
        let row = |k: usize| {
            let mut row = [d >> 8, 1000, b >> 12, 3, c, 77];
            row.rotate_left(k);
            Cdf::from_integers_u64(&row)
        };
        TransitionTable::new([row(0)?, row(1)?, row(2)?, row(3)?, row(4)?, row(5)?])
    };
    with(UniformIndex::new(black_box(6)), out, |any, out| {
        walk(&weights, &any, input, out);
        let table = || {
            let cdf = Independence::new(Cdf::from_integers(&[1, 9, 2, 8, 3, 7])?);
            let pick = Cdf::from_integers(&[1, 2, 1])?;
            Ok(Mixture::from_table((any, cdf, rows()?), pick))
        };
        with(table(), out, |mixture, out| {
            walk(&weights, &mixture, input, out);
        });
    });
}

/// How many words accept, of weights and ratios of any magnitude.
pub fn chances(u: [f32; 4], input: usize, out: &mut Out) {
    /// A mutation that says what it is told.
    struct Told<C>(C);
    impl<C: HastingsCorrection> Mutation<u32> for Told<C> {
        type Correction = C;
        fn try_propose<R: rand_core::TryRng + ?Sized>(
            &self,
            from: u32,
            _: &mut R,
        ) -> Result<Proposal<u32, C>, R::Error> {
            Ok(Proposal::new(!from, self.0))
        }
    }
    fn step<C: HastingsCorrection>(from: u32, to: u32, told: C, input: usize, out: &mut Out) {
        let weight = |x: u32| if x == 0 { from } else { to };
        match Chain::new(0, weight) {
            Ok(mut chain) => {
                let step = chain.step(weight, &Told(told), &mut generator(input));
                wide(step.acceptance.words(), out);
            }
            Err(e) => out.word(refusal(e)),
        }
    }
    let [a, b, c, d] = stirred(u);
    let all = 1_u128 << 64;
    step(a, b, Symmetric, input, out);
    step(u32::MAX, c >> (d & 31), Symmetric, input, out);
    step(
        a,
        b,
        HastingsCounts::new((c | 1).into(), d.into()),
        input,
        out,
    );
    let large = HastingsCounts::new(all, u128::from(c) << 31);
    step(a >> 16, b, large, input, out);
    step(
        a,
        b,
        HastingsRatio::from_counts(d.into(), c.into()),
        input,
        out,
    );
    step(
        u32::MAX,
        b,
        HastingsRatio::new(black_box(3.0), u[3] + 1e-3),
        input,
        out,
    );
    step(a & 1, b, Symmetric, input, out);
}

fn selected<C: Into<u128>>(chosen: ExactSelection<C>, out: &mut Out) {
    out.word(chosen.index as u32);
    wide_half(chosen.numerator.into(), out);
    out.word(chosen.leftover);
    out.word(chosen.leftover_bits);
}

/// Known to the compiler, in flash.
static FLASH: Cdf<[u32; 6]> = match Cdf::from_integers(&[0, 5, 1, 37, 9, 0]) {
    Ok(table) => table,
    Err(_) => panic!("refused"),
};
static BINS: Alias<[AliasEntry<u32>; 8]> =
    match Alias::<[AliasEntry<u32>; 8]>::from_integers(&[0, 5, 1, 37, 9, 0]) {
        Ok(table) => table,
        Err(_) => panic!("refused"),
    };

pub fn selections(u: [f32; 4], input: usize, out: &mut Out) {
    let [.., d] = stirred(u);
    selected(FLASH.select_exact(d), out);
    selected(BINS.select_exact(d), out);
    selected(FLASH.draw_exact(&mut generator(input)), out);
}

pub fn wide_selections(u: [f32; 4], input: usize, out: &mut Out) {
    let [a, b, c, d] = stirred(u);
    let weights = [d, 0, c >> 20, 1, u32::MAX];
    with(
        Cdf::<heapless::Vec<u64, 5>>::from_integer_slice(&weights),
        out,
        |table, out| {
            selected(table.select_exact(b), out);
            let word = u64::from(a) << 32 | u64::from(b);
            selected(table.select_exact_word(word), out);
        },
    );
    with(
        Alias::<heapless::Vec<AliasEntry<u64>, 8>>::from_integer_slice(&weights),
        out,
        |table, out| selected(table.draw_exact(&mut generator(input)), out),
    );
}

fn put([x, y]: [I2F30; 2], out: &mut Out) {
    out.word(x.to_bits() as u32);
    out.word(y.to_bits() as u32);
}

fn drawn<E>(result: Result<Accepted<[I2F30; 2]>, Failure<E>>, out: &mut Out) {
    match result {
        Ok(Accepted { point, tries }) => {
            out.word(tries);
            put(point, out);
        }
        Err(failure) => failed(failure, out),
    }
}

pub fn disks(u: [f32; 4], input: usize, out: &mut Out) {
    let [a, b, c, d] = stirred(u);
    let (fine, short) = (DiskRejection::new(), DiskRejection16::new());
    for point in [fine.attempt([a, b].map(U0F32::from_bits)), short.attempt(c)] {
        out.word(u32::from(point.is_some()));
        if let Some(point) = point {
            put(point, out);
        }
    }
    drawn(fine.draw(&mut generator(input)), out);
    drawn(short.draw(&mut generator(input)), out);
    let point = [a, d].map(|x| I2F30::from_bits(x as i32));
    wide(fine.pdf(point).to_bits(), out);
    verdict(DiskRejection::new().with_budget(d & 1), out);
}

pub fn resampled(u: [f32; 4], input: usize, out: &mut Out) {
    let [a, b, c, d] = stirred(u);
    let weights = [a, 0, b >> (a & 31), c, 1, d >> 8];
    let counted = |result, counts: &mut [u32; 6], out: &mut Out| {
        verdict(result, out);
        let digits = |sum: u32, number: &u32| sum << 4 | number;
        let mut particles = [0_u32, 1, 2, 3, 4, 5];
        out.word(counts.iter().fold(0, digits));
        verdict(rearrange(counts, &mut particles), out);
        out.word(particles.iter().fold(0, digits));
    };
    let mut counts = weights;
    counted(systematic(&mut counts, 6, d), &mut counts, out);
    counts = weights;
    counted(residual(&mut counts, 6, d), &mut counts, out);
    counts = weights;
    let drawn = stratified(&mut counts, 6, &mut generator(input));
    counted(drawn, &mut counts, out);
    counts = [9; 6];
    verdict(
        to_integers(&[u[0], u[1], 0.5, 1e-20, u[2], u[3]], &mut counts),
        out,
    );
    out.word(
        counts
            .iter()
            .fold(0, |sum: u32, number| sum.rotate_left(7) ^ number),
    );
}

/// Integers of ranges, by one word and by two, with what is left over.
pub fn ranges(u: [f32; 4], input: usize, out: &mut Out) {
    let [a, b, c, d] = stirred(u);
    let mut rng = generator(input);
    let last = a >> (b & 31);
    out.word(up_to_from_word(last, c));
    out.word(up_to(last, &mut rng));
    with(Range::below(last), out, |range, out| {
        let (integer, rest) = range.select(c);
        out.word(integer);
        out.word(rest);
        wide(range.numerator(integer), out);
        out.word(range.draw_wide(&mut rng));
        out.float(range.pmf(d >> (b & 31)));
    });
    let [low, high] = [c, d].map(|word| word as i32 >> (b >> 5 & 31));
    with(Range::signed(low, high), out, |range, out| {
        out.word(range.draw(&mut rng) as u32);
        out.word(range.draw_wide(&mut rng) as u32);
    });
    let [from, to] = [[a, c], [d, b]].map(|[high, low]| u64::from(high) << 32 | u64::from(low));
    with(Range::of_u64(from >> (b & 63), to), out, |range, out| {
        wide(range.draw(&mut rng), out);
        out.float(range.pmf(to));
    });
}

/// Events of a probability, and of a ratio.
pub fn coins(u: [f32; 4], input: usize, out: &mut Out) {
    let [a, b, c, d] = stirred(u);
    let mut rng = generator(input);
    let mut said = |chance: Chance, out: &mut Out| {
        wide(chance.words(), out);
        out.float(chance.probability());
        out.word(u32::from(chance.accepts(d)) | u32::from(chance.draw(&mut rng)) << 1);
    };
    for p in [u[0], f32::from_bits(a >> 2)] {
        with(Chance::new(p), out, &mut said);
    }
    with(Chance::from_ratio(c >> (b & 31), b), out, said);
}

/// Weights that change, and what is drawn without replacement.
pub fn trees(u: [f32; 4], input: usize, out: &mut Out) {
    let [a, b, c, d] = stirred(u);
    let mut rng = generator(input);
    let mut weights = [a >> 3, b >> 5, 0, c >> (a & 31) >> 3, 1, d >> 4];
    with(SumTree::new_in(&mut weights), out, |mut tree, out| {
        out.word(tree.set(2, d >> 3).unwrap_or(u32::MAX));
        verdict(tree.set(4, u32::MAX).map(drop), out);
        if let Some(chosen) = tree.select_exact(d) {
            out.word(chosen.index as u32);
            out.word(chosen.numerator as u32);
            out.word(chosen.leftover);
        }
        out.word(tree.draw_index(&mut rng).map_or(9, |index| index as u32));
        out.float(tree.pmf(1));
        let mut places = [(0, 0); 3];
        let drawn = tree.draw_distinct(&mut places, &mut rng);
        out.word(drawn.iter().fold(0, |all, (at, _)| all << 4 | *at as u32));
        let sums = tree.into_weights().iter();
        out.word(sums.fold(0, |all: u32, weight| all.rotate_left(7) ^ weight));
    });
    let wide = [a, 0, b, c].map(|weight| u64::from(weight) << 29);
    with(SumTree::new_u64(wide), out, |tree, out| {
        let word = u64::from(d) << 32 | u64::from(a);
        if let Some(chosen) = tree.select_exact_word(word) {
            out.word(chosen.index as u32);
            wide_half(chosen.numerator, out);
        }
    });
    let mut kept = WeightedReservoir::<u32, 3>::new();
    for (item, weight) in (0..).zip([a, b, c >> 20, d, 0, a >> (b & 31)]) {
        kept.offer(item, weight, &mut rng);
    }
    out.word(kept.items().fold(0, |all, item| all << 4 | item));
}

/// Half of a number of words, since it may be that of all.
fn wide_half(numerator: u128, out: &mut Out) {
    wide((numerator >> 1) as u64, out);
}
