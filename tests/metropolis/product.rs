//! Products: each part as its own mutation proposes it, and the acceptance of all parts together, by exact numbers of words.

use crate::acceptance::nudged;
use crate::exact::Fraction;
use crate::own::given;
use host::generators::Cycle;
use host::mean::Mean;
use host::speed;
use microwarp::discrete::Cdf;
use microwarp::metropolis::{
    Chain, HastingsCorrection, HastingsCounts, HastingsRatio, Independence, Mutation, Product,
    StateSource, Symmetric, TransitionTable, UniformIndex, UniformStep, WrappedWalk,
};
use microwarp::{Warp, metropolis::BoxStep, poly as mw};
use num_bigint::BigUint;
use rand_core::{Rng, TryRng};
use rand_pcg::Pcg32;

#[test]
fn parts_are_proposed_in_order_by_their_own_mutations() {
    let step = mw::NormalStep::new([0.1, 1.0]).unwrap();
    let walk = WrappedWalk::new(BoxStep::new(0.2).unwrap());
    let far = Independence::new(mw::Exponential::from_rate(2.0).unwrap());
    let index = UniformIndex::new(5).unwrap();
    let (two, three) = (
        Product::new((step, walk)),
        Product::new((index, step, walk)),
    );
    let four = Product::new((walk, far, index, step));
    for seed in 0..1000 {
        let rng = Pcg32::new(seed, 3);
        let (mut a, mut b) = (rng.clone(), rng.clone());
        let Ok(both) = two.try_propose(([0.0, 1.0], 0.5), &mut a);
        let (Ok(x), Ok(y)) = (
            step.try_propose([0.0, 1.0], &mut b),
            walk.try_propose(0.5, &mut b),
        );
        assert_eq!((both.state, &a), ((x.state, y.state), &b));
        let Ok(all) = three.try_propose((4, [0.0, 1.0], 0.5), &mut a);
        let Ok(i) = index.try_propose(4, &mut b);
        let (Ok(x), Ok(y)) = (
            step.try_propose([0.0, 1.0], &mut b),
            walk.try_propose(0.5, &mut b),
        );
        assert_eq!((all.state, &a), ((i.state, x.state, y.state), &b));
        let Ok(all) = four.try_propose((0.5, 1.0, 4, [0.0, 1.0]), &mut a);
        let (Ok(y), Ok(z)) = (walk.try_propose(0.5, &mut b), far.try_propose(1.0, &mut b));
        let (Ok(i), Ok(x)) = (
            index.try_propose(4, &mut b),
            step.try_propose([0.0, 1.0], &mut b),
        );
        assert_eq!((all.state, &a), ((y.state, z.state, i.state, x.state), &b));
        assert_eq!((all.correction, all.kind), (z.correction, 0));
    }
    // Of parts that are symmetric nothing is multiplied.
    fn symmetric<X>(_: &impl Mutation<X, Correction = Symmetric>) {}
    symmetric::<([f32; 2], f32)>(&two);
    symmetric::<(usize, [f32; 2], f32)>(&three);
}

const ROWS: [[f32; 3]; 3] = [[4.0, 2.0, 2.0], [3.0, 2.0, 1.0], [1.0, 4.0, 3.0]];
const OTHER: [[f32; 2]; 2] = [[7.0, 2.0], [1.0, 5.0]];
const WEIGHTS: [[u32; 2]; 3] = [[1, 900_000_000], [77, 3], [u32::MAX, 12]];

/// Of all moves between states of two parts, those whose number of accepting words is not ⌈2³² f′T′/(fT)⌉, both parts counted;
/// or only those of the first.
fn wrong_moves(both: bool) -> usize {
    let first = ROWS.map(|row| Cdf::<[u32; 3]>::new(&row).unwrap());
    let second = OTHER.map(|row| Cdf::<[u32; 2]>::new(&row).unwrap());
    let tables = (
        TransitionTable::new(first).unwrap(),
        TransitionTable::new(second).unwrap(),
    );
    let mutation = Product::new(tables);
    let weight = |(i, j): (usize, usize)| WEIGHTS[i][j];
    let states = || (0..3).flat_map(|i| (0..2).map(move |j| (i, j)));
    let ways = |(i, j): (usize, usize), (k, l): (usize, usize)| {
        let [first, second] = [first[i].numerator(k), second[j].numerator(l)];
        BigUint::from(first) * BigUint::from(if both { second } else { 1 })
    };
    let mut wrong = 0;
    for from in states() {
        for to in states() {
            let words = [
                *first[from.0].words_of(to.0).unwrap().start(),
                *second[from.1].words_of(to.1).unwrap().end(),
                0,
            ];
            let mut chain = Chain::new(from, weight).unwrap();
            let step = chain.step(weight, &mutation, &mut Cycle::new(&words));
            assert_eq!(step.proposed, to);
            let part: BigUint = (ways(to, from) * weight(to)) << 32_u32;
            let whole = ways(from, to) * weight(from);
            let due: BigUint = (part + &whole - 1_u32) / whole;
            let due = due.min(BigUint::from(1_u64 << 32));
            wrong += usize::from(due != BigUint::from(step.acceptance.words()));
        }
    }
    wrong
}

#[test]
fn tables_of_both_parts_are_accepted_by_the_exact_number_of_words() {
    assert_eq!(wrong_moves(true), 0);
    // A product that forgets a part is seen.
    assert!(wrong_moves(false) > 5);
}

/// Stays, and states a ratio.
fn says<C: HastingsCorrection>(ratio: C) -> impl Mutation<u8, Correction = C> + Copy {
    given(0, ratio)
}

fn said(a: HastingsCounts, b: HastingsCounts) -> [u128; 2] {
    let product = Product::new((says(a), says(b)));
    let Ok(proposal) = product.try_propose((0, 0), &mut Pcg32::new(1, 1));
    [
        proposal.correction.forward(),
        proposal.correction.backward(),
    ]
}

#[test]
fn counts_are_multiplied_exactly_as_long_as_they_fit() {
    let counts = HastingsCounts::new;
    assert_eq!(said(counts(3, 5), counts(7, 11)), [21, 55]);
    let all = 1 << 32;
    assert_eq!(
        said(counts(all, all - 1), counts(all, all - 5)),
        [1 << 64, (all - 1) * (all - 5)]
    );
    // No way there, and no way back, stay so.
    assert_eq!(said(counts(0, 5), counts(1 << 64, 1 << 64))[0], 0);
    assert_eq!(said(counts(5, 1 << 64), counts(1 << 64, 0))[1], 0);
    assert!(said(counts(1 << 64, 1), counts(1 << 64, 1))[1] > 0);
}

/// How many words accept a step of a product of such parts, in this order.
fn words_of([a, b, c, d]: [HastingsCounts; 4], [from, to]: [u32; 2], nested: bool) -> u64 {
    fn accepted<X: Copy>(mutation: &impl Mutation<X>, state: X, [from, to]: [u32; 2]) -> u64 {
        let mut chain = Chain::new(state, |_| from).unwrap();
        let step = chain.step(|_| to, mutation, &mut Pcg32::new(1, 1));
        step.acceptance.words()
    }
    let [a, b, c, d] = [a, b, c, d].map(says);
    if nested {
        let inner = Product::new((c, d));
        let mutation = Product::new((a, Product::new((b, inner))));
        accepted(&mutation, (0, (0, (0, 0))), [from, to])
    } else {
        accepted(&Product::new((a, b, c, d)), (0, 0, 0, 0), [from, to])
    }
}

/// The fewest and the most words that a product of such parts may state: ⌈2³² a⌉ for an acceptance a that is off by 2⁻⁶³
/// for each part beyond the first.
fn due(parts: [[u128; 2]; 4], [from, to]: [u32; 2]) -> [u64; 2] {
    let product = |k: usize| {
        parts
            .iter()
            .map(|p| BigUint::from(p[k]))
            .product::<BigUint>()
    };
    let (part, whole) = (product(1) * to, product(0) * from);
    let words = |by: u64| {
        let (part, whole) = ((&part * by) << 32_u32, &whole << 63_u32);
        let words: BigUint = (part + &whole - 1_u32) / whole;
        u64::try_from(words.min(BigUint::from(1_u64 << 32))).unwrap()
    };
    [words((1 << 63) - 3), words((1 << 63) + 3)]
}

/// The counts of two parts multiplied and cut as they once were: both by the low bits that the larger one is too long by.
fn once([a, b]: [u128; 2], [c, d]: [u128; 2]) -> [u128; 2] {
    let (forward, backward) = (a.saturating_mul(c), b.saturating_mul(d));
    let by = 64_u32.saturating_sub((forward | backward).leading_zeros());
    if forward <= 1 << 64 && backward <= 1 << 64 {
        [forward, backward]
    } else {
        [forward, backward].map(|count| (count >> by).max(1))
    }
}

/// A count from 1 to 2⁶⁴, of any magnitude.
fn count(rng: &mut Pcg32) -> u128 {
    let word = u128::from(rng.next_u64() >> (rng.next_u32() % 64));
    match rng.next_u32() % 8 {
        0 => 1,
        1 => 1 << 64,
        2 => 1 << (rng.next_u32() % 65),
        3 => u64::MAX.into(),
        _ => word.max(1),
    }
}

#[test]
fn four_parts_in_any_order_have_their_acceptance() {
    let mut rng = Pcg32::new(11, 30);
    let (mut between, mut wrong) = (0, 0);
    let cases = speed::of("products of counts", 20_000, 1_000_000);
    for case in 0..cases {
        // Three tables with 2⁻⁶⁰ beside 1, which made .0667 of 9.25e-19; then any.
        let mut parts = [(); 4].map(|()| [count(&mut rng), count(&mut rng)]);
        let mut weights = [(); 2].map(|()| rng.next_u32() >> (rng.next_u32() % 32) | 1);
        if case == 0 {
            parts = [[1 << 60, 1], [1, 1 << 60], [(1 << 60) - 1, 1], [1, 1]];
            weights = [1, 1];
        } else if case % 2 == 0 {
            // The way back makes up for the way there, up to the last bits.
            parts[2] = [parts[0][1], parts[0][0]];
            parts[3] = [
                parts[1][1],
                parts[1][0]
                    .saturating_sub(u128::from(rng.next_u32() % 3))
                    .max(1),
            ];
        }
        let [low, high] = due(parts, weights);
        for order in [[0, 1, 2, 3], [2, 0, 3, 1], [3, 2, 1, 0], [1, 3, 0, 2]] {
            let parts = order.map(|k| parts[k]);
            let said = parts.map(|[forward, backward]| HastingsCounts::new(forward, backward));
            for nested in [false, true] {
                let words = words_of(said, weights, nested);
                assert!(
                    (low..=high).contains(&words),
                    "{parts:?} {weights:?}: {words}, {low} to {high}"
                );
            }
            let [forward, backward] = parts.into_iter().reduce(once).unwrap();
            let part = BigUint::from(backward * u128::from(weights[1])) << 32_u32;
            let whole = BigUint::from(forward * u128::from(weights[0]));
            let words: BigUint = (part + &whole - 1_u32) / whole;
            let words = u64::try_from(words.min(BigUint::from(1_u64 << 32))).unwrap();
            wrong += u32::from(!(low..=high).contains(&words));
        }
        between += u32::from(low > 1 && high < 1 << 32);
    }
    println!("{between} acceptances between 2^-32 and 1; {wrong} as they once were are wrong");
    assert!(between > cases / 10 && wrong > cases / 10);
}

/// How many ulp the acceptance of a product of ratios is off: of two densities and of the densities of each part.
fn ulps<const N: usize>([from, to]: [f32; 2], parts: [[f32; 2]; N]) -> f64 {
    fn accepted<X: Copy>(mutation: &impl Mutation<X>, state: X, [from, to]: [f32; 2]) -> f32 {
        let mut chain = Chain::new(state, |_| from).unwrap();
        chain
            .step(|_| to, mutation, &mut Pcg32::new(1, 1))
            .acceptance
    }
    let ways = parts.iter().flatten().all(|x| *x > 0.0 && x.is_finite());
    assert!(ways && from > 0.0 && to > 0.0);
    let said = parts.map(|[forward, backward]| says(HastingsRatio::new(forward, backward)));
    let got = match said.as_slice() {
        [a, b] => accepted(&Product::new((*a, *b)), (0, 0), [from, to]),
        [a, b, c] => accepted(&Product::new((*a, *b, *c)), (0, 0, 0), [from, to]),
        _ => panic!("two or three parts"),
    };
    let exact = parts.iter().fold(
        Fraction::of(to).over(&Fraction::of(from)),
        |exact, [there, back]| {
            exact
                .times(&Fraction::of(*back))
                .over(&Fraction::of(*there))
        },
    );
    exact.capped().ulps(got)
}

/// The worst that a climb from random numbers finds.
fn worst<const N: usize>(climbs: u32) -> f64 {
    let mut rng = Pcg32::new(12, N as u64);
    let mut worst = 0.0_f64;
    let mut near = || 1.0 + f32::EPSILON * (rng.next_u32() >> 9) as f32;
    let starts: Vec<_> = (0..climbs)
        .map(|_| ([4.0 * near(), near()], [(); N].map(|()| [near(), near()])))
        .collect();
    for (mut weights, mut parts) in starts {
        let mut most = ulps(weights, parts);
        for _ in 0..400 {
            let (mut other, mut moved) = (weights, parts);
            let k = rng.next_u32() as usize % (2 * N + 2);
            let place = other.iter_mut().chain(moved.as_flattened_mut()).nth(k);
            let place = place.unwrap();
            *place = nudged(*place, &mut rng);
            let off = ulps(other, moved);
            if off >= most {
                (most, weights, parts) = (off, other, moved);
            }
        }
        worst = worst.max(most);
    }
    worst
}

#[test]
fn each_ratio_adds_two_ulp_at_most() {
    let climbs = speed::of("climbs", 30, 1000);
    let (two, three) = (worst::<2>(climbs), worst::<3>(climbs));
    println!("two ratios: {two:.3} ulp; three: {three:.3}");
    assert!(two <= 4.5 && three <= 6.5, "{two} {three}");
    assert!(two > 4.5 / 2.5 && three > 6.5 / 2.5, "{two} {three}");
}

#[test]
fn ratios_are_multiplied_whatever_their_form() {
    let (ratio, counts) = (HastingsRatio::new(1e30, 3e-20), HastingsCounts::new(7, 3));
    let of = |a: HastingsRatio, b: HastingsCounts| {
        let Ok(one) = Product::new((says(a), says(b))).try_propose((0, 0), &mut Pcg32::new(1, 1));
        let Ok(two) = Product::new((says(b), says(a))).try_propose((0, 0), &mut Pcg32::new(1, 1));
        assert_eq!(one.correction, two.correction);
        one.correction
    };
    // 3e-50 · 3/7, which no f32 holds, beside a density that makes up for it.
    let product = Product::new((says(ratio), says(ratio), says(counts)));
    let back = says(HastingsRatio::new(3e-20, 1e30));
    let whole = Product::new((product, back, back));
    let Ok(proposal) = whole.try_propose(((0, 0, 0), 0, 0), &mut Pcg32::new(1, 1));
    let weight = |_: ((u8, u8, u8), u8, u8)| 1.0;
    let mut chain = Chain::new(((0, 0, 0), 0, 0), weight).unwrap();
    let step = chain.step(weight, &whole, &mut Pcg32::new(1, 1));
    println!("{proposal:?}, {}", step.acceptance);
    assert!((step.acceptance - 3.0 / 7.0).abs() <= 4.0 * f32::EPSILON);
    // What is not a ratio stays none.
    assert_ne!(of(ratio, counts), ratio);
    assert_eq!(
        of(HastingsRatio::new(0.0, 1.0), counts),
        of(HastingsRatio::new(f32::NAN, 1.0), counts)
    );
    assert_ne!(
        of(HastingsRatio::new(1.0, 0.0), counts),
        of(HastingsRatio::new(0.0, 1.0), counts)
    );
}

#[test]
fn a_product_of_sources_draws_its_parts_apart_and_starts_chains() {
    let (line, table) = (
        mw::Exponential::from_rate(2.0).unwrap(),
        Cdf::<[u32; 3]>::new(&[1.0, 2.0, 5.0]).unwrap(),
    );
    let source = Product::new((line, table));
    let mut rng = Pcg32::new(9, 1);
    for _ in 0..1000 {
        let mut twin = rng.clone();
        let Ok((x, i)) = source.try_draw_state(&mut rng);
        assert_eq!((x, i), (line.draw(&mut twin), table.draw_index(&mut twin)));
        assert_eq!(source.pdf_of_state((x, i)), line.pdf(x) * table.pmf(i));
    }
    // ∫ x·i over x, of e^-x: 3 in all.
    let f = |(x, i): (f32, usize)| (-x).exp() * x * i as f32;
    let runs = |source: &dyn Fn(&mut Pcg32) -> f64| {
        Mean::of((0..20_000).map(|run| source(&mut Pcg32::new(run, 5))))
    };
    let right = runs(&|rng| {
        let start = Chain::resample(f, &source, 8, rng);
        start.map_or(0.0, |start| start.weight.into())
    });
    let off = right.deviation(3.0).abs();
    println!("{} ± {}", right.mean, right.error);
    assert!(off <= 5.0, "{off} σ");
    // The same with a density that forgets the table.
    struct Half<S>(S);
    impl<S: StateSource<(f32, usize)>> StateSource<(f32, usize)> for Half<S> {
        type Correction = S::Correction;
        fn try_draw_state<R: TryRng + ?Sized>(
            &self,
            rng: &mut R,
        ) -> Result<(f32, usize), R::Error> {
            self.0.try_draw_state(rng)
        }
        fn pdf_of_state(&self, (x, i): (f32, usize)) -> f32 {
            self.0.pdf_of_state((x, i)) / [0.125, 0.25, 0.625][i]
        }
        fn ratio_of_states(&self, from: (f32, usize), to: (f32, usize)) -> S::Correction {
            self.0.ratio_of_states(from, to)
        }
    }
    let wrong = runs(&|rng| {
        let start = Chain::resample(f, &Half(source), 8, rng);
        start.map_or(0.0, |start| start.weight.into())
    });
    assert!(wrong.deviation(3.0).abs() > 10.0, "{}", wrong.mean);
    // Of the unit cube it is a mutation and a source.
    let cube = Product::new((UniformStep::new(), UniformStep::new()));
    assert_eq!(cube.pdf_of_state(([0.5_f32; 2], 0.25_f32)), 1.0);
    assert_eq!(cube.pdf_of_state(([0.5_f32, 1.5], 0.25_f32)), 0.0);
}
