//! The tuned scale: it gives the acceptance asked for, stays in range whatever the target returns, and what is frozen is an
//! ordinary mutation.

use host::generators::{Broken, Failing};
use host::speed;
use microwarp::Error;
use microwarp::metropolis::{
    BoxStep, Chain, Coordinates, LogDensity, LogUniformStep, Mutation, NormalStep, OneCoordinate,
    RandomWalk, Scalable, Subset, Tuning, WrappedWalk,
};
use microwarp::tier::Poly;
use rand_pcg::Pcg32;

fn normal<X: Coordinates>(x: X) -> LogDensity<Poly> {
    LogDensity::new(x.as_slice().iter().map(|x| -0.5 * x * x).sum())
}

/// The acceptance of a chain after it was tuned for so many steps, from a mutation that is off.
fn tuned<X, M>(mutation: M, goal: f32, steps: u32, from: X, seed: u64) -> f32
where
    X: Coordinates,
    M: Mutation<X> + Scalable,
{
    let mut rng = Pcg32::new(seed, 54);
    let chain = Chain::new(from, normal).unwrap();
    let mut tuning = Tuning::new(chain, mutation, goal).unwrap();
    for _ in 0..steps {
        tuning.step(normal, &mut rng);
    }
    let (mut chain, step) = tuning.freeze();
    assert_eq!(chain.steps(), 0);
    for _ in 0..20_000 {
        chain.step(normal, &step, &mut rng);
    }
    chain.acceptance_rate().unwrap()
}

#[test]
fn the_acceptance_is_the_one_asked_for() {
    let seeds = speed::of("seeds", 2, 30);
    for seed in 0..seeds {
        for width in [1e-6, 1.0, 1e4] {
            let normal = NormalStep::<_, Poly>::new(width).unwrap();
            let (many, start) = (NormalStep::<_, Poly>::new([width; 10]).unwrap(), [0.5; 10]);
            let sizes = LogUniformStep::<Poly>::new(0.1 * width, width).unwrap();
            let rates = [
                (0.44, tuned(normal, 0.44, 1000, 0.5, seed)),
                (
                    0.44,
                    tuned(BoxStep::new(width).unwrap(), 0.44, 1000, 0.5, seed),
                ),
                (0.44, tuned(RandomWalk::new(sizes), 0.44, 1000, 0.5, seed)),
                (0.234, tuned(many, 0.234, 1000, start, seed)),
                (
                    0.44,
                    tuned(OneCoordinate::new(normal), 0.44, 1000, start, seed),
                ),
            ];
            for (goal, rate) in rates {
                assert!(
                    (rate - goal).abs() <= 0.1,
                    "{rate} for {goal} from {width:e}, seed {seed}"
                );
            }
            // Without steps to tune by, the start is kept, and noticed.
            let off = tuned(normal, 0.44, 0, 0.5, seed);
            assert!((off - 0.44).abs() > 0.1, "{off}");
        }
    }
}

/// Flat targets, and such as have no density but at the start, for longer than the scale takes to its bounds.
#[test]
fn the_scale_stays_in_range() {
    let bounds = [2f32.powi(-64), 2f32.powi(64)];
    type Target = fn(f32) -> f32;
    let targets: [(Target, f32); 5] = [
        (|_| 1.0, bounds[1]),
        (|x| if x == 1.0 { 1.0 } else { 0.0 }, bounds[0]),
        (|x| if x == 1.0 { 1.0 } else { f32::NAN }, bounds[0]),
        (|x| if x == 1.0 { 1.0 } else { f32::INFINITY }, bounds[0]),
        (|x| if x == 1.0 { 1.0 } else { -1.0 }, bounds[0]),
    ];
    for (target, bound) in targets {
        for width in [f32::from_bits(1), 1e-30, 1.0, 6e37] {
            for goal in [f32::from_bits(1), 1e-6, 0.44, 1.0 - f32::EPSILON] {
                let (mut rng, chain) = (Pcg32::new(1, 54), Chain::new(1.0, target).unwrap());
                let step = NormalStep::<_, Poly>::new(width).unwrap();
                let mut tuning = Tuning::new(chain, step, goal).unwrap();
                for _ in 0..3000 {
                    tuning.step(target, &mut rng);
                    assert!(
                        (bounds[0]..=bounds[1]).contains(&tuning.scale()),
                        "{tuning:?}"
                    );
                }
                // A step that is lost beside the state proposes it again, and is accepted.
                if goal == 0.44 && width == 1.0 {
                    let near = if bound < 1.0 { 1e-6 } else { 1e15 };
                    assert!((tuning.scale() > 1.0) == (bound > 1.0), "{tuning:?}");
                    assert!((tuning.scale() < near) == (near < 1.0), "{tuning:?}");
                }
                let (chain, step) = tuning.freeze();
                assert!(step.std_devs() > 0.0 && step.std_devs() <= 6e37);
                assert!(chain.state().is_finite());
            }
        }
    }
}

#[test]
fn what_is_frozen_is_an_ordinary_mutation() {
    let mut rng = Pcg32::new(3, 54);
    let step = NormalStep::<_, Poly>::new([2.0, 0.0, 0.25]).unwrap();
    let mut chain = Chain::new([0.5; 3], normal).unwrap();
    chain.burn_in(normal, &step, 10, &mut rng);
    let mut tuning = Tuning::new(chain, step, 0.3).unwrap();
    assert_eq!(
        (tuning.steps(), tuning.scale(), tuning.goal()),
        (0, 1.0, 0.3)
    );
    assert_eq!(tuning.freeze(), (chain, step));
    for _ in 0..100 {
        tuning.step(normal, &mut rng);
    }
    let (scale, steps) = (tuning.scale(), tuning.steps());
    let (mut chain, frozen) = tuning.freeze();
    assert_eq!((steps, chain.steps()), (100, 0));
    assert!(scale != 1.0 && chain.state()[1] == 0.5);
    let plain = NormalStep::new([2.0 * scale, 0.0, 0.25 * scale]).unwrap();
    assert_eq!(frozen, plain);
    let mut same = (Chain::resume(chain.save()).unwrap(), rng.clone());
    for _ in 0..100 {
        let step = chain.step(normal, &frozen, &mut rng);
        assert_eq!(step, same.0.step(normal, &plain, &mut same.1));
    }
    for (goal, error) in [
        (0.0, Error::NotPositive(2)),
        (-0.5, Error::NotPositive(2)),
        (1.0, Error::OutOfRange(2)),
        (2.0, Error::OutOfRange(2)),
        (f32::NAN, Error::NotFinite(2)),
        (f32::INFINITY, Error::NotFinite(2)),
    ] {
        assert_eq!(
            Tuning::new(chain, frozen, goal).err(),
            Some(error),
            "{goal}"
        );
    }
}

#[test]
fn a_generator_that_fails_changes_nothing() {
    let step = BoxStep::new([1.0, 1.0]).unwrap();
    let mut tuning = Tuning::new(Chain::new([0.5; 2], normal).unwrap(), step, 0.4).unwrap();
    let mut few = Failing {
        word: 1 << 30,
        left: 17,
    };
    for _ in 0..5 {
        tuning.try_step(normal, &mut few).unwrap();
    }
    let before = tuning;
    for left in [2, 1, 0] {
        few.left = left;
        assert_eq!(tuning.try_step(normal, &mut few), Err(Broken(17)));
        assert_eq!(tuning, before);
    }
}

#[test]
fn scaled_steps_stay_within_what_their_constructors_accept() {
    let tiny = f32::from_bits(1);
    let step = BoxStep::new([0.0, tiny, 1.5, f32::MAX]).unwrap();
    assert_eq!(
        step.scaled(0.25).widths(),
        [0.0, tiny, 0.375, f32::MAX / 4.0]
    );
    assert_eq!(step.scaled(4.0).widths(), [0.0, 4.0 * tiny, 6.0, f32::MAX]);
    let normal = NormalStep::<_, Poly>::new([0.0, 5e37]).unwrap();
    assert_eq!(normal.scaled(1e30).std_devs(), [0.0, 6e37]);
    let sizes = LogUniformStep::<Poly>::new(tiny, 2.0).unwrap();
    assert_eq!(sizes.scaled(0.5), LogUniformStep::new(tiny, 1.0).unwrap());
    assert_eq!(
        sizes.scaled(f32::MAX),
        LogUniformStep::new(tiny * f32::MAX, f32::MAX).unwrap()
    );
    let part = Subset::<_, 1, 3>::new(BoxStep::new([1.0]).unwrap(), [2]).unwrap();
    assert_eq!(part.scaled(3.0).mutation().widths(), [3.0]);
    assert_eq!(part.scaled(3.0).axes(), &[2]);
    let walk = WrappedWalk::new(Own);
    assert_eq!(walk.scaled(2.0), walk);
    for factor in [0.0, -1.0, f32::NAN, f32::INFINITY, 1.0] {
        assert_eq!(step.scaled(factor), step);
        assert_eq!(normal.scaled(factor), normal);
        assert_eq!(sizes.scaled(factor), sizes);
    }
}

/// A law of the user's own, with a scale of its own.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Own;

impl Scalable for Own {
    fn scaled(&self, _: f32) -> Self {
        *self
    }
}
