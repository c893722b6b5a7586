//! What runs on integers alone: a chain of integer weights, tables that the compiler and the program built,
//! exact selections, the rejection disks, points. No floating-point routine may be linked, of either width.
#![no_std]
#![no_main]

use microwarp::constant;
use microwarp::discrete::{
    Alias, AliasEntry, Binomial, Cdf, ExactSelection, Geometric, Hypergeometric, NegativeBinomial,
    Poisson, SumTree, WeightedReservoir,
};
use microwarp::fixed as mw;
use microwarp::metropolis::{
    Chain, HastingsCounts, Independence, Mixture, Mutation, Proposal, TransitionTable, UniformIndex,
};
use microwarp::rejection::Rejection;
use microwarp::uniform::{
    ByPosition, Chance, ChoiceInOrder, ChoiceOfStream, LatinHypercube, Permutation, Points, Range,
    Recurrence, Screen, Sobol, choose, shuffle, shuffle_each, up_to,
};
use microwarp_cores::{input, output};
use rand_core::TryRng;
use rand_pcg::Pcg32;

const WEIGHTS: [u32; 4] = [9, 1, 0, 30];

static FLASH: Cdf<[u32; 4]> = constant!(Cdf::from_integers(&WEIGHTS));
static BINS: Alias<[AliasEntry<u32>; 4]> =
    constant!(Alias::<[AliasEntry<u32>; 4]>::from_integers(&WEIGHTS));
const PICK: Cdf<[u32; 3]> = constant!(Cdf::from_integers(&[2, 1, 1]));

/// Up in three cases out of four, in a circle.
struct Upwards;

impl Mutation<usize> for Upwards {
    type Correction = HastingsCounts;

    fn try_propose<R: TryRng + ?Sized>(
        &self,
        from: usize,
        rng: &mut R,
    ) -> Result<Proposal<usize, HastingsCounts>, R::Error> {
        Ok(if rng.try_next_u32()? >> 30 > 0 {
            Proposal::new(from.wrapping_add(1) & 3, HastingsCounts::new(3, 1))
        } else {
            Proposal::new(from.wrapping_add(3) & 3, HastingsCounts::new(1, 3))
        })
    }
}

fn selected(chosen: ExactSelection) {
    output(chosen.index as u32);
    output(chosen.numerator as u32);
    output(chosen.leftover);
    output(chosen.leftover_bits);
}

fn walked<M: Mutation<usize>>(chain: &mut Chain<usize, u32>, mutation: &M, rng: &mut Pcg32) {
    let weight = |i: usize| WEIGHTS.get(i).copied().unwrap_or(0);
    for _ in 0..input(100) {
        for (state, words) in chain.step(weight, mutation, rng).recorded() {
            output(state as u32);
            output(words as u32);
        }
    }
    chain.burn_in(weight, mutation, input(10), rng);
    output(chain.state() as u32);
}

/// The name that the check looks for, so that it knows it has read the right file.
#[unsafe(no_mangle)]
#[inline(never)]
fn microwarp_integers(rng: &mut Pcg32) -> Result<(), microwarp::Error> {
    // Weights the compiler cannot see.
    let run_time = [input(5), input(1), input(7), input(3)];
    let table = Cdf::<heapless::Vec<u32, 4>>::from_integer_slice(&run_time)?;
    let alias = Alias::<heapless::Vec<AliasEntry<u32>, 4>>::from_integer_slice(&run_time)?;
    selected(FLASH.select_exact(input(6)));
    selected(BINS.draw_exact(rng));
    selected(table.draw_exact(rng));
    selected(alias.select_exact_word(input(8)));
    output(table.draw_index(rng) as u32);

    let mut tree = SumTree::new(run_time)?;
    tree.set(input(1) as usize, input(2))?;
    tree.draw_exact(rng).into_iter().for_each(selected);
    for (index, weight) in tree.draw_distinct(&mut [(0, 0); 2], rng) {
        output(*index as u32);
        output(*weight);
    }
    let mut kept = WeightedReservoir::<u32, 2>::new();
    for item in tree.into_weights() {
        kept.offer(item, item, rng);
    }
    kept.items().for_each(|item| output(*item));

    let mut chain = Chain::new(0, |_| input(9))?;
    let any = UniformIndex::new(input(4))?;
    let row = |weights| Cdf::from_integers(weights);
    let rows = [
        row(&run_time)?,
        row(&[1; 4])?,
        row(&run_time)?,
        row(&[1, 2, 3, 4])?,
    ];
    let rows = TransitionTable::new(rows)?;
    walked(&mut chain, &any, rng);
    walked(&mut chain, &Upwards, rng);
    walked(&mut chain, &Independence::new(alias), rng);
    walked(
        &mut chain,
        &Mixture::from_table((any, &rows, &Upwards), PICK),
        rng,
    );
    chain = Chain::resume(chain.save())?;
    if let Ok(found) = Chain::search(|i: usize| i as u32 & 1, &any, input(9), rng) {
        output(found.state() as u32);
    }
    output(chain.accepted() as u32);

    output(up_to(input(5), rng));
    let (index, wide) = (Range::below(input(9))?, Range::of_u64(1, input(8).into())?);
    output(index.draw(rng) ^ index.draw_wide(rng));
    output(Range::signed(-3, input(3) as i32)?.draw(rng) as u32);
    output(wide.draw(rng) as u32 ^ index.numerator(1) as u32);
    let coins = [
        Chance::new(f32::from_bits(input(7)))?,
        Chance::from_ratio(input(1), input(6))?,
    ];
    for coin in coins {
        output(u32::from(coin.draw(rng)) ^ coin.words() as u32);
    }

    let failures = Geometric::from_ratio(input(1), input(9))?;
    output(failures.draw(rng));
    let events = Poisson::from_ratio(input(9), input(4))?;
    output(events.draw(rng));
    let successes = Binomial::from_ratio(input(3), input(1), input(9))?;
    output(successes.draw(rng));
    let losses = NegativeBinomial::from_ratio(input(3), input(1), input(2))?;
    output(losses.draw(rng));
    let marked = Hypergeometric::new(input(9), input(4), input(3))?;
    output(marked.draw(rng));
    for words in [
        failures.words_of(input(2)),
        events.words_of(input(3)),
        successes.words_of(input(1)),
        losses.words_of(input(2)),
        marked.words_of(input(1)),
    ]
    .into_iter()
    .flatten()
    {
        output(*words.start());
    }

    let (fine, short) = (mw::DiskRejection::new(), mw::DiskRejection16::new());
    for point in [fine.draw(rng), short.draw(rng)].into_iter().flatten() {
        for coordinate in point.point {
            output(coordinate.to_bits() as u32);
        }
        output(fine.pdf(point.point).to_bits() as u32);
    }

    let pixel = ByPosition::new(input(1), input(2));
    let (pairs, eight) = (
        Sobol::<2>::new(input(3))?,
        Sobol::<8>::new(pixel.word(0, 0))?,
    );
    let recurrence = Recurrence::<2>::new(input(3))?;
    let (cube, order) = (
        LatinHypercube::new(input(8), input(3))?,
        Permutation::new(input(100), input(3))?,
    );
    let picture = Screen::new(eight, [input(9), input(7)], input(2), input(3))?;
    let mut items = run_time;
    shuffle(&mut items, rng);
    shuffle_each(&mut items, rng);
    output(choose(&mut items, input(2) as usize, rng)?.0.len() as u32);
    let (mut few, mut kept) = (
        ChoiceInOrder::new(input(1), input(9))?,
        ChoiceOfStream::new(input(2))?,
    );
    for index in 0..input(9) {
        for word in pairs.words::<4>(index) {
            output(word);
        }
        for word in eight.words::<8>(index) {
            output(word);
        }
        for word in recurrence.words::<3>(index) {
            output(word);
        }
        output(cube.word(index, 1));
        output(picture.pixel(index, input(3)).word(input(1), 2));
        output(
            order
                .get(index)
                .and_then(|at| order.index_of(at))
                .unwrap_or(0),
        );
        output(u32::from(few.draw(rng)));
        output(kept.draw(rng).unwrap_or(0));
        for point in fine.draw(&mut pairs.at(index)).into_iter() {
            output(point.tries);
        }
    }
    Ok(())
}

#[unsafe(no_mangle)]
#[inline(never)]
extern "C" fn probe_main() {
    let mut rng = Pcg32::new(input(1).into(), input(2).into());
    for _ in 0..input(100) {
        output(u32::from(microwarp_integers(&mut rng).is_err()));
    }
}
