//! The subjects of the room of chains: a few steps of each kind, and what is read off them.

use crate::Out;
use crate::subjects::{Put as _, figure, generator, refusal, v, verdict, with};
use core::hint::black_box;
use core::num::NonZeroU32;
use microwarp::Warp;
use microwarp::discrete::{Alias, AliasEntry, Cdf};
use microwarp::metropolis::*;
use microwarp::rejection::Failure;
use microwarp::tier::Tier;
use microwarp::warp::{Hemisphere, NormalPair, PhongLobe};
use rand_core::Rng as _;

/// Steps a case takes, so that an error anywhere has spread by its end.
const STEPS: usize = 20;

/// Where a chain is and what it has counted.
fn counts<X: Copy, D: TargetDensity>(chain: &Chain<X, D>, out: &mut Out) {
    out.word(chain.steps() as u32);
    out.word(chain.accepted() as u32);
    out.word(chain.refused() as u32);
    out.word(chain.rejected_in_a_row());
}

/// Some steps of a chain, then where it is; of the last one its kind and acceptance.
fn walk<X, D, M>(
    start: X,
    target: impl Fn(X) -> D,
    mutation: &M,
    input: usize,
    out: &mut Out,
) -> Option<Chain<X, D>>
where
    X: Copy,
    D: TargetDensity,
    M: Mutation<X>,
{
    let mut chain = match Chain::new(start, &target) {
        Ok(chain) => chain,
        Err(e) => {
            out.word(refusal(e));
            return None;
        }
    };
    let mut rng = generator(input);
    let mut sum = 0.0;
    for _ in 0..STEPS {
        let step = chain.step(&target, mutation, &mut rng);
        sum += step.acceptance;
        sum += step.kind as f32;
    }
    out.float(sum);
    out.float(chain.acceptance_rate().unwrap_or(f32::NAN));
    out.word(chain.refused() as u32);
    Some(chain)
}

fn place<const N: usize, D: TargetDensity>(chain: Option<Chain<[f32; N], D>>, out: &mut Out) {
    if let Some(chain) = chain {
        chain.state().put(out);
    }
}

pub fn displacements<T: Tier>([a, b, c, d]: [f32; 4], _: usize, out: &mut Out) {
    let word = a.to_bits() ^ b.to_bits().rotate_left(13);
    with(BoxStep::new([c, v(1e30)]), out, |law, out| {
        out.float(law.displacement(0, word));
        out.float(law.displacement(1, !word));
    });
    with(NormalStep::<_, T>::new(v(2.5)), out, |law, out| {
        out.float(law.displacement(0, word));
        out.float(law.displacement(0, !word));
    });
    with(
        LogUniformStep::<T>::new(1e-30 * d, v(3e5)),
        out,
        |law, out| {
            out.float(StepLaw::<f32>::displacement(&law, 0, word));
        },
    );
    for step in [b - 0.5, 1e-7 * c, -1e6 * d, f32::from_bits(word)] {
        out.float(wrapping_add(a, step));
    }
}

pub fn acceptances<T: Tier>([a, b, c, d]: [f32; 4], _: usize, out: &mut Out) {
    /// A mutation that says what it is told.
    struct Told(HastingsRatio);
    impl Mutation<f32> for Told {
        type Correction = HastingsRatio;
        fn try_propose<R: rand_core::TryRng + ?Sized>(
            &self,
            from: f32,
            _: &mut R,
        ) -> Result<Proposal<f32, HastingsRatio>, R::Error> {
            Ok(Proposal::new(1.0 - from, self.0))
        }
    }
    let counts = (u128::from(a.to_bits()) << 32, u128::from(b.to_bits()));
    let ratios = [
        HastingsRatio::new(1e-38 * a, 3e38 * b),
        HastingsRatio::new(c - 0.5, d),
        HastingsRatio::from_counts(counts.0, counts.1),
        HastingsRatio::from_counts(1 << 64, counts.0),
    ];
    let mut rng = generator(0);
    for ratio in ratios {
        let f = |x: f32| if x < 0.5 { 1e-20 * a } else { 1e18 * d };
        with(Chain::new(0.0, f), out, |mut chain, out| {
            out.float(chain.step(f, &Told(ratio), &mut rng).acceptance);
        });
        let log = |x: f32| LogDensity::<T>::new(if x < 0.5 { 700.0 * b } else { 690.0 * c });
        with(Chain::new(0.0, log), out, |mut chain, out| {
            out.float(chain.step(log, &Told(ratio), &mut rng).acceptance);
        });
    }
}

pub fn cube<T: Tier>([a, b, c, d]: [f32; 4], input: usize, out: &mut Out) {
    let f = |[x, y, z]: [f32; 3]| (x - 0.5) * (x - 0.5) * (0.1 + y) * z;
    let small =
        |sizes: (f32, f32)| LogUniformStep::<T>::new(sizes.0, sizes.1).map(WrappedWalk::new);
    with(
        small((v(1.0 / 1024.0), v(1.0 / 64.0))),
        out,
        |small, out| {
            with(
                Mixture::large_small(0.5 * d, small),
                out,
                |mutation, out| {
                    let chain = walk([a, b, c], f, &mutation, input, out);
                    place(chain, out);
                },
            );
        },
    );
    with(BoxStep::new([a, b, c]), out, |law, out| {
        let chain = walk([0.9, 0.5, 0.1], f, &WrappedWalk::new(law), input, out);
        place(chain, out);
    });
}

pub fn plane<T: Tier>([a, b, c, d]: [f32; 4], input: usize, out: &mut Out) {
    let log = |[x, y]: [f32; 2]| LogDensity::<T>::new(-x * x - 10.0 * (y - x * x) * (y - x * x));
    let steps = || {
        let normal = NormalStep::<_, T>::new([v(0.5), v(0.1)])?;
        let one = OneCoordinate::new(LogUniformStep::<T>::new(v(0.001), v(1.0))?);
        let part = Subset::<_, 1, 2>::new(BoxStep::new([v(0.7)])?, [1])?;
        let far = Independence::new(NormalPair::<T>::new([v(0.0); 2], v(1.5))?);
        Mixture::new((normal, one, part, far), &[1.0, a, b, 0.5 + c])
    };
    with(steps(), out, |mutation, out| {
        let chain = walk([d, a], log, &mutation, input, out);
        place(chain, out);
    });
    with(NormalStep::<f32, T>::new(v(1.0)), out, |step, out| {
        // Not a number for some, and refused.
        let chain = walk(0.5 + a, |x: f32| T::sqrt(x - 0.2), &step, input, out);
        if let Some(chain) = chain {
            out.float(chain.state());
            out.float(chain.density());
        }
    });
}

pub fn indices([a, b, c, d]: [f32; 4], input: usize, out: &mut Out) {
    let any = [a, 0.5, 1e-6 * b, c, 0.25 + d, 2.0];
    let target = |i: usize| any.get(5_usize.wrapping_sub(i)).copied().unwrap_or(0.0);
    let mutation = || {
        let row = |i: usize| Cdf::new(&any.map(|x| x + 0.1 * i as f32));
        let table = TransitionTable::new([row(0)?, row(1)?, row(2)?, row(3)?, row(4)?, row(5)?])?;
        let cdf = Independence::new(Cdf::new_u64(&any)?);
        let alias = Independence::new(Alias::<[AliasEntry<u32>; 8]>::new(&any)?);
        Mixture::new(
            (UniformIndex::new(6)?, table, cdf, alias),
            &[1.0, 2.0, 1.0, 1.0],
        )
    };
    with(mutation(), out, |mutation, out| {
        if let Some(chain) = walk(0, target, &mutation, input, out) {
            out.word(chain.state() as u32);
        }
    });
    if let Ok(mutation) = UniformIndex::new(a.to_bits() | 1) {
        let Ok(proposal) = mutation.try_propose(0, &mut generator(input));
        out.word(proposal.state as u32);
    }
}

pub fn parts<T: Tier>([a, b, c, d]: [f32; 4], input: usize, out: &mut Out) {
    let lamps = [0.25 + a, b, 2.0 * c];
    let target = |(lamp, [x, y]): (usize, [f32; 2])| {
        let density = lamps.get(lamp).copied().unwrap_or(0.0) * x * (0.1 + y);
        WithPayload::new(density, x - d)
    };
    let mutation = || {
        let near = WrappedWalk::new(LogUniformStep::<T>::new(v(0.01), v(0.25))?);
        let (which, far) = (Independence::new(Cdf::new(&lamps)?), UniformStep::new());
        let steps = (
            Product::new((UniformIndex::new(3)?, near)),
            Product::new((which, far)),
        );
        Mixture::new(steps, &[3.0, 1.0])
    };
    with(mutation(), out, |mutation, out| {
        let mut rng = generator(input);
        with(Chain::new((0, [a, b]), target), out, |mut chain, out| {
            let mut sum = 0.0;
            for _ in 0..STEPS {
                let step = chain.step(target, &mutation, &mut rng);
                for (found, share) in step.recorded_values() {
                    sum += share * found.payload;
                }
            }
            let (lamp, place) = chain.state();
            out.word(lamp as u32);
            place.put(out);
            let WithPayload { density, payload } = chain.density();
            [density, payload, sum].put(out);
        });
    });
}

pub fn limits([a, b, ..]: [f32; 4], input: usize, out: &mut Out) {
    let peak = |x: f32| if x < 0.02 { 1e6 } else { 1.0 + a };
    let mut rng = generator(input);
    let (mutation, limit) = (UniformStep::new(), NonZeroU32::MIN.saturating_add(4));
    let mut forced = 0;
    with(Chain::new(0.01, peak), out, |mut chain, out| {
        for _ in 0..STEPS {
            let step = chain.step_limited(peak, &mutation, limit, &mut rng);
            forced += u32::from(step.outcome == Outcome::Forced);
        }
        out.word(forced);
        counts(&chain, out);
        chain.burn_in(peak, &mutation, 3, &mut rng);
        counts(&chain, out);
        // Saved, and gone on with.
        let saved = Saved {
            steps: 7,
            ..chain.save()
        };
        with(Chain::resume(saved), out, |mut chain, out| {
            let step = chain.step(peak, &mutation, &mut rng);
            [step.state(), step.density()].put(out);
            out.word(chain.steps() as u32);
        });
        verdict(
            Chain::resume(Saved {
                accepted: 9,
                ..saved
            }),
            out,
        );
        verdict(
            Chain::resume(Saved {
                density: b - 0.5,
                ..saved
            }),
            out,
        );
    });
}

fn failed<E>(failure: Failure<E>, out: &mut Out) {
    out.word(match failure {
        Failure::BudgetSpent { tries } => tries | 0xf100,
        Failure::ProposalDensity => 0xf5,
        _ => 0xff,
    });
}

pub fn starts<T: Tier>([a, b, c, _]: [f32; 4], input: usize, out: &mut Out) {
    let spot = |x: f32| if x < 0.3 * a { 1e30 * x } else { 0.0 };
    match Chain::search(spot, &UniformStep::new(), 4, &mut generator(input)) {
        Ok(chain) => [chain.state(), chain.density()].put(out),
        Err(failure) => failed(failure, out),
    }
    match Chain::resample(spot, &UniformStep::new(), 8, &mut generator(input)) {
        Ok(start) => {
            [start.chain.state(), start.weight].put(out);
            figure(start.relative_error, out);
            out.word(start.positive);
        }
        Err(failure) => failed(failure, out),
    }
    let log = |[x, y, z]: [f32; 3]| LogDensity::<T>::new(-3e4 * (x + b * y + c * z));
    match Chain::resample(log, &Hemisphere::<T>::new(), 8, &mut generator(input)) {
        Ok(start) => {
            start.chain.state().put(out);
            out.float(start.weight.get());
            figure(start.relative_error, out);
        }
        Err(failure) => failed(failure, out),
    }
}

pub fn primary<T: Tier>([a, b, c, _]: [f32; 4], input: usize, out: &mut Out) {
    let warps = || Ok((Hemisphere::<T>::new(), PhongLobe::<T>::new(20.0 * c)?));
    with(warps(), out, |(proposal, lobe), out| {
        let target = primary_density(proposal, |direction| lobe.pdf(direction));
        out.float(target([a, b]));
        let chain = walk([a, b], target, &UniformStep::new(), input, out);
        place(chain, out);
    });
}

pub fn health([a, b, c, d]: [f32; 4], input: usize, out: &mut Out) {
    let f = |x: f32| 1.0 / (1.0 + x * x * x * x);
    let mut rng = generator(input);
    let mut health = Autocorrelation::<8>::new();
    let mut runs = [Halves::new(15), Halves::new(14)];
    with(BoxStep::new(1.0 + 3.0 * a), out, |step, out| {
        with(Chain::new(b, f), out, |mut chain, _| {
            for i in 0..60 {
                let x = 1e3 * d + chain.step(f, &step, &mut rng).state();
                health.push(if i == 7 { black_box(f32::NAN) } else { x });
                if let Some(run) = runs.get_mut(i & 1) {
                    run.push(1e20 * c + x);
                }
            }
        });
        out.word(health.count() as u32);
        out.word(health.refused() as u32);
        for lag in [0, 1, 2, 8, 9] {
            figure(health.at_lag(lag), out);
        }
        figure(health.integrated_time(), out);
        figure(health.effective_sample_size(), out);
        figure(split_r_hat(&runs), out);
        figure(r_hat(runs.iter().map(|run| &run.parts()[0])), out);
    });
}

pub fn tuned<T: Tier>([a, b, c, d]: [f32; 4], input: usize, out: &mut Out) {
    let f = |[x, y]: [f32; 2]| LogDensity::<T>::new(-x * x - 3.0 * y * y);
    let mut rng = generator(input);
    let tuning = || {
        let step = NormalStep::<_, T>::new([1e3 * a, 2.0 * b])?;
        Tuning::new(Chain::new([c, d], f)?, step, 0.1 + 0.5 * c)
    };
    with(tuning(), out, |mut tuning, out| {
        for _ in 0..STEPS {
            tuning.step(f, &mut rng);
        }
        out.float(tuning.scale());
        out.word(tuning.steps() as u32);
        let (mut chain, step) = tuning.freeze();
        step.std_devs().put(out);
        out.word(chain.steps() as u32);
        chain.step(f, &step, &mut rng).state().put(out);
    });
    let scaled = || {
        let sizes = LogUniformStep::<T>::new(v(0.01), v(0.5))?.scaled(10.0 * d);
        let box_step = BoxStep::new([a, v(0.0), v(3e38)])?.scaled(0.5 + b);
        Ok((sizes, box_step))
    };
    with(scaled(), out, |(sizes, box_step), out| {
        [sizes.smallest(), sizes.largest()].put(out);
        box_step.widths().put(out);
    });
    let goal = 1.5 * d - 0.2;
    let chain = Chain::new(a, |x| 0.5 + x);
    verdict(
        chain.and_then(|chain| Tuning::new(chain, BoxStep::new(b)?, goal)),
        out,
    );
}

/// Nine draws of three chains each, of which some are equal.
pub fn judged([a, b, c, d]: [f32; 4], input: usize, out: &mut Out) {
    let mut rng = generator(input);
    let mut chains = [[0.0; 9]; 3];
    let mut x = a;
    for chain in &mut chains {
        for draw in chain {
            let word = rng.next_u32();
            x = 0.5 * x + b * ((word >> 24) as f32 - 128.0);
            *draw = 1e3 * c + if word & 3 == 0 { d } else { x };
        }
    }
    let mut scratch = [0.0; 54];
    with(Draws::new(&chains, &mut scratch), out, |mut draws, out| {
        figure(draws.split_r_hat(), out);
        figure(draws.r_hat(), out);
        figure(draws.folded_r_hat(), out);
        out.float(draws.effective_sample_size());
        out.float(draws.bulk_effective_sample_size());
        out.float(draws.tail_effective_sample_size());
        out.float(draws.standard_error());
    });
    verdict(
        Draws::new(&[[b; 9], [black_box(f32::NAN); 9]], &mut scratch),
        out,
    );
}

pub fn verdicts<T: Tier>([a, b, c, d]: [f32; 4], _: usize, out: &mut Out) {
    verdict(BoxStep::new([a - 0.5, b]), out);
    verdict(NormalStep::<f32, T>::new(b - 0.1), out);
    verdict(LogUniformStep::<T>::new(a, b), out);
    verdict(UniformIndex::new((3.0 * c) as u32), out);
    verdict(Mixture::large_small(1.5 * d, UniformStep::new()), out);
    verdict(Mixture::new([UniformStep::new(); 2], &[a - 0.3, b]), out);
    verdict(
        Subset::<_, 2, 3>::new(UniformStep::new(), [(4.0 * a) as usize, (4.0 * b) as usize]),
        out,
    );
    verdict(
        Cdf::new(&[c]).and_then(|row| TransitionTable::new([row; 2])),
        out,
    );
    verdict(Chain::new(a, |x| x - 0.5), out);
    verdict(Chain::new(b, |x| LogDensity::<T>::new(T::ln(x - 0.5))), out);
}
