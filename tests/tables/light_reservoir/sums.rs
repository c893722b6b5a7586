//! The expectation of estimates over all candidates and all decisions.

use host::generators::Cycle;
use microwarp::discrete::{LightReservoir, Normaliser};
use num_rational::Ratio;

/// What does not fit 128 bits panics.
type Fraction = Ratio<u128>;

const ZERO: Fraction = Ratio::new_raw(0, 1);
const ONE: Fraction = Ratio::new_raw(1, 1);

fn over(n: u128, d: u128) -> Fraction {
    Ratio::new(n, d)
}

fn whole(n: u32) -> Fraction {
    Ratio::from_integer(n.into())
}

/// ⌊2⁶⁴ times this⌋ of a fraction of at most 1.
fn words(fraction: Fraction) -> u128 {
    (fraction.numer() << 64) / fraction.denom()
}

fn value(fraction: Fraction) -> f64 {
    *fraction.numer() as f64 / *fraction.denom() as f64
}

/// What each of the three items has of something.
type Items = [u32; 3];

/// The densities by which candidates are drawn are 1 over these.
const RARITIES: Items = [2, 4, 4];

/// A reservoir, and what it should be.
#[derive(Clone, Copy, Debug, PartialEq)]
struct State {
    real: LightReservoir<usize>,
    held: Option<usize>,
    /// The contribution times target and count.
    sum: Fraction,
    target: u32,
    count: u32,
}

impl State {
    const EMPTY: Self = Self {
        real: LightReservoir::new(),
        held: None,
        sum: ZERO,
        target: 0,
        count: 0,
    };

    fn contribution(&self) -> Fraction {
        match self.held {
            Some(_) => self.sum / whole(self.target) / whole(self.count),
            None => ZERO,
        }
    }

    /// The contribution times what the item held has.
    fn estimate(&self, of: Items) -> Fraction {
        self.held.map_or(ZERO, |i| whole(of[i])) * self.contribution()
    }

    /// With the reservoir that came of the decisions on both sides, which is what it should be.
    fn found(self, [real, other]: [LightReservoir<usize>; 2]) -> Self {
        assert_eq!(real, other);
        let (has, should) = (f64::from(real.contribution()), value(self.contribution()));
        assert!((has - should).abs() <= SLACK * should, "{has} {should}");
        assert_eq!(
            (real.item().copied(), real.count()),
            (self.held, self.count)
        );
        assert_eq!(real.target(), self.target as f32);
        Self { real, ..self }
    }
}

/// How far rounding may move a border, as a part of all words, and a contribution.
const SLACK: f64 = 1e-6;

/// The same where a sum was cut to 64 bits; whole numbers are exact.
const CUT: f64 = 1e-17;

/// Each state with its probability.
type Law = Vec<(Fraction, State)>;

/// The law where equal states are one.
fn gathered(states: impl IntoIterator<Item = (Fraction, State)>) -> Law {
    let mut law = Law::new();
    for (p, state) in states {
        match law.iter_mut().find(|(_, other)| *other == state) {
            Some((sum, _)) => *sum += p,
            None => law.push((p, state)),
        }
    }
    law
}

fn expectation(law: &Law, estimate: impl Fn(&State) -> Fraction) -> Fraction {
    law.iter().map(|(p, state)| *p * estimate(state)).sum()
}

/// The expectation of the estimate of the sum of f, over that sum.
fn found(law: &Law, f: Items) -> Fraction {
    expectation(law, |state| state.estimate(f)) / whole(f.iter().sum())
}

/// The outcomes of a decision on a part of a sum: the probability, the uniforms at both ends, and whether the part is taken.
fn outcomes(sum: Fraction, part: Fraction, slack: f64) -> Vec<(Fraction, [u64; 2], bool)> {
    if part == ZERO {
        return vec![(ONE, [0, u64::MAX], false)];
    }
    let p = part / (sum + part);
    if p == ONE {
        return vec![(ONE, [0, u64::MAX], true)];
    }
    let (border, off) = (words(p) as u64, (slack * 2_f64.powi(64)) as u64);
    vec![
        (p, [0, border - 1 - off], true),
        (sum / (sum + part), [border + off, u64::MAX], false),
    ]
}

/// One decision: to hold an item of this target, which adds this part to the sum and this number to the count.
fn decided(
    old: State,
    (item, target, part, count): (Option<usize>, u32, Fraction, u32),
    slack: f64,
    act: impl Fn(&mut LightReservoir<usize>, u64),
) -> Law {
    let law = outcomes(old.sum, part, slack)
        .into_iter()
        .map(|(p, ends, taken)| {
            let (held, target) = if taken {
                (item, target)
            } else {
                (old.held, old.target)
            };
            let new = State {
                held,
                target,
                sum: old.sum + part,
                count: old.count + count,
                ..old
            };
            let real = ends.map(|bits| {
                let mut real = old.real;
                act(&mut real, bits);
                real
            });
            (p, new.found(real))
        });
    law.collect()
}

fn one_after(law: &Law, next: impl Fn(State) -> Law) -> Law {
    gathered(law.iter().flat_map(|&(p, state)| {
        let next = next(state).into_iter();
        next.map(move |(q, state)| (p * q, state))
    }))
}

/// The law after so many candidates, of which `offered` says which are offered at all.
fn stream(candidates: u32, targets: Items, offered: impl Fn(usize) -> bool + Copy) -> Law {
    (0..candidates).fold(vec![(ONE, State::EMPTY)], |law, _| {
        one_after(&law, |old| {
            let each = (0..3).flat_map(|item| {
                let rarity = RARITIES[item];
                let part = whole(targets[item] * rarity);
                let act = |real: &mut LightReservoir<_>, bits| {
                    let density = 1.0 / rarity as f32;
                    real.offer_with(item, targets[item] as f32, density, bits)
                        .unwrap();
                };
                let law = if offered(item) {
                    decided(old, (Some(item), targets[item], part, 1), 0.0, act)
                } else {
                    vec![(ONE, old)]
                };
                let p = over(1, rarity.into());
                law.into_iter().map(move |(q, state)| (p * q, state))
            });
            gathered(each)
        })
    })
}

fn all(_: usize) -> bool {
    true
}

/// The law of a reservoir that has absorbed another one, with these targets of the other's items.
fn absorbed(law: &Law, other: &Law, targets: Items) -> Law {
    one_after(law, |old| {
        one_after(other, |other| {
            let target = other.held.map_or(0, |item| targets[item]);
            let part = other.contribution() * whole(target * other.count);
            decided(
                old,
                (other.held, target, part, other.count),
                CUT,
                |real, bits| {
                    real.absorb_with(other.real, target as f32, bits).unwrap();
                },
            )
        })
    })
}

/// The law where something happens to each reservoir.
fn changed(law: &Law, change: impl Fn(&mut State)) -> Law {
    gathered(law.iter().map(|&(p, mut state)| {
        change(&mut state);
        (p, state.found([state.real; 2]))
    }))
}

fn capped(law: &Law, limit: u32) -> Law {
    changed(law, |state| {
        if state.count > limit {
            state.sum = state.sum * whole(limit) / whole(state.count);
            state.count = limit;
            state.real.cap(limit);
        }
    })
}

/// The law where a reservoir is divided by so many.
fn normalised(law: &Law, by: impl Fn(&State) -> u32) -> Law {
    changed(law, |state| {
        let n = by(state);
        if state.held.is_some() {
            state.sum = state.sum * whole(state.count) / whole(n);
        }
        state.real.normalise(n);
    })
}

#[test]
fn candidates_of_target_0_count() {
    let targets = [3, 0, 1];
    let wrong = [ONE, over(5, 4), over(21, 16)];
    for (candidates, wrong) in (1..).zip(wrong) {
        assert_eq!(found(&stream(candidates, [1, 2, 5], all), [3, 4, 2]), ONE);
        let right = stream(candidates, targets, all);
        assert_eq!(found(&right, targets), ONE);
        // Not offered, and so not counted.
        let uncounted = stream(candidates, targets, |item| item != 1);
        assert_eq!(found(&uncounted, targets), wrong);
    }
}

#[test]
fn parts_of_a_stream_are_the_stream() {
    let targets = [2, 0, 3];
    let [one, two, three] = [1, 2, 3].map(|n| stream(n, targets, all));
    let merged = absorbed(&two, &one, targets);
    for item in 0..3 {
        // Probability and mean contribution of each item, not only of the estimate.
        let of = |law: &Law, by: &dyn Fn(&State) -> Fraction| {
            expectation(law, |state| {
                if state.held == Some(item) {
                    by(state)
                } else {
                    ZERO
                }
            })
        };
        assert_eq!(of(&merged, &|_| ONE), of(&three, &|_| ONE));
        assert_eq!(
            of(&merged, &State::contribution),
            of(&three, &State::contribution)
        );
    }
}

#[test]
fn a_history_is_capped_with_its_contribution() {
    let f = [1, 2, 1];
    let (history, new) = (stream(3, f, all), stream(1, f, all));
    let right = absorbed(&new, &capped(&history, 2), f);
    assert!(right.iter().all(|(_, state)| state.count == 3));
    assert_eq!(found(&right, f), ONE);
    // The count alone is capped: the sum is that of four candidates.
    let uncapped = normalised(&absorbed(&new, &history, f), |_| 3);
    assert_eq!(found(&uncapped, f), over(4, 3));
}

#[test]
fn a_target_is_the_same_where_it_chooses_and_where_it_divides() {
    let (stale, fresh) = ([2, 1, 1], [1, 1, 1]);
    let new = stream(1, fresh, all);
    assert_eq!(
        found(&absorbed(&new, &stream(1, stale, all), fresh), fresh),
        ONE
    );
    // Stale in both is unbiased too.
    let law = absorbed(&new, &stream(1, stale, all), stale);
    assert_eq!(found(&law, fresh), ONE);
    let mixed = expectation(&law, |state| {
        let fresh_there = state.held.map_or(1, |item| fresh[item]);
        state.estimate(fresh) * whole(state.target) / whole(fresh_there)
    });
    assert_eq!(mixed / whole(fresh.iter().sum()), over(7, 6));
}

/// The share of a source in the sum of all, which has no rule of its own in `Support`.
fn share(by: Normaliser, here: usize, source: usize, counts: &[u32], seen: &[u32]) -> Fraction {
    let [all, own] = [counts.iter().sum(), counts.get(here).copied().unwrap_or(0)];
    let balance = |a: u32, b: u32| {
        if a == 0 {
            ZERO
        } else {
            whole(a) / whole(a + b)
        }
    };
    match by {
        Normaliser::Support => whole(counts[source]),
        Normaliser::Pairwise if own > 0 => {
            let ours = own * seen[here];
            let theirs = |k: usize| (all - own) * seen[k];
            if source == here {
                let others = (0..counts.len()).filter(|k| *k != here);
                let part = |k: usize| whole(counts[k]) * balance(ours, theirs(k));
                whole(own) + others.map(part).sum::<Fraction>()
            } else {
                whole(counts[source]) * balance(theirs(source), ours)
            }
        }
        _ => {
            let mine = counts[source] * seen[source];
            let sum: u32 = (0..counts.len()).map(|k| counts[k] * seen[k]).sum();
            whole(all) * balance(mine, sum - mine)
        }
    }
}

/// The law of the combination of several reservoirs. The targets are those of the sources, and then of the place, if it has none.
fn combined(laws: &[Law], targets: &[Items], here: usize, by: Normaliser) -> Law {
    let mut products = vec![(ONE, vec![])];
    for law in laws {
        products = products
            .iter()
            .flat_map(|(p, states)| {
                law.iter()
                    .map(|(q, state)| (*p * *q, [&states[..], &[*state]].concat()))
            })
            .collect();
    }
    gathered(products.into_iter().flat_map(|(p, sources)| {
        combination(&sources, targets, here, by)
            .into_iter()
            .map(move |(q, state)| (p * q, state))
    }))
}

fn combination(sources: &[State], targets: &[Items], here: usize, by: Normaliser) -> Law {
    let counts: Vec<_> = sources.iter().map(|source| source.count).collect();
    let could = |item: usize| (0..sources.len()).filter(move |k| targets[*k][item] > 0);
    let count = counts.iter().sum();
    let mut paths = vec![(
        ONE,
        State {
            count,
            ..State::EMPTY
        },
        vec![],
    )];
    for (k, source) in sources.iter().enumerate() {
        let (target, part) = source.held.map_or((0, ZERO), |item| {
            let seen: Vec<_> = targets.iter().map(|targets| targets[item]).collect();
            let share = share(by, here, k, &counts, &seen);
            (
                seen[here],
                share * whole(seen[here]) * source.contribution(),
            )
        });
        let decided = paths.iter().flat_map(|(p, old, ends)| {
            outcomes(old.sum, part, SLACK)
                .into_iter()
                .map(move |(q, end, taken)| {
                    let (held, target) = if taken {
                        (source.held, target)
                    } else {
                        (old.held, old.target)
                    };
                    let sum = old.sum + part;
                    (
                        *p * q,
                        State {
                            held,
                            target,
                            sum,
                            ..*old
                        },
                        [&ends[..], &[end]].concat(),
                    )
                })
        });
        paths = decided.collect();
    }
    let run = |ends: &[[u64; 2]], side: usize| {
        let words: Vec<_> = ends
            .iter()
            .flat_map(|end| [(end[side] >> 32) as u32, end[side] as u32])
            .collect();
        let reals: Vec<_> = sources.iter().map(|source| source.real).collect();
        let seen = |k: usize, item: &usize| targets[k][*item] as f32;
        LightReservoir::combine(&reals, here, by, seen, &mut Cycle::new(&words))
    };
    let law = paths.into_iter().map(|(p, mut state, ends)| {
        if let (Normaliser::Support, Some(item)) = (by, state.held) {
            let able = could(item).map(|k| counts[k]).sum();
            state.sum = state.sum * whole(count) / whole(able);
        }
        (p, state.found([run(&ends, 0), run(&ends, 1)]))
    });
    law.collect()
}

const RULES: [Normaliser; 3] = [
    Normaliser::Support,
    Normaliser::Balance,
    Normaliser::Pairwise,
];

#[test]
fn places_that_are_blind_to_some_items_do_not_darken_others() {
    // The first place sees all; each of the others is blind to two fifths of the light.
    let (f, blind) = ([1, 2, 2], [[1, 0, 2], [1, 2, 0]]);
    let targets = [f, blind[0], blind[1]];
    let laws = targets.map(|targets| stream(2, targets, all));
    for by in RULES {
        assert_eq!(found(&combined(&laws, &targets, 0, by), f), ONE, "{by:?}");
        let mut uneven = laws.clone();
        uneven[1] = capped(&uneven[1], 1);
        assert_eq!(
            found(&combined(&uneven, &targets, 0, by), f),
            ONE,
            "{by:?}, capped"
        );
    }
    // All candidates counted, and those of the sources that hold something.
    let merged = |first: &Law| absorbed(&absorbed(first, &laws[1], f), &laws[2], f);
    assert_eq!(found(&merged(&laws[0]), f), over(11, 15));
    let mut by_holders = ZERO;
    for (p, one) in &laws[1] {
        for (q, two) in &laws[2] {
            let holding = 2 + [one, two]
                .map(|state| u32::from(state.held.is_some()) * 2)
                .iter()
                .sum::<u32>();
            let law = absorbed(
                &absorbed(&laws[0], &vec![(ONE, *one)], f),
                &vec![(ONE, *two)],
                f,
            );
            by_holders += *p * *q * found(&normalised(&law, |_| holding), f);
        }
    }
    assert_eq!(by_holders, over(983, 1280));
}

#[test]
fn combinations_are_unbiased_for_any_targets() {
    // Of the last, no source has all items; the place has none of its own.
    for (candidates, targets, here) in [
        ([1, 2], vec![[3, 1, 2], [1, 4, 0]], 0),
        ([2, 1], vec![[0, 1, 2], [1, 4, 3]], 1),
        ([1, 2], vec![[3, 0, 2], [1, 4, 0], [5, 1, 1]], 2),
    ] {
        let laws = [0, 1].map(|k| stream(candidates[k], targets[k], all));
        for by in RULES {
            let law = combined(&laws, &targets, here, by);
            assert_eq!(found(&law, targets[here]), ONE, "{by:?} {targets:?}");
        }
    }
}
