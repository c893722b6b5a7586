//! Budgets are kept to the word, and no generator makes a sampler hang.

use host::generators::{Broken, Counting, Cycle, Failing};
use microwarp::rejection::{
    Accepted, BallRejection, Bounded, DEFAULT_BUDGET, DiskRejection, Failure, Region, Rejection,
    budget_for,
};
use microwarp::uniform::grid_from_word;
use microwarp::warp::Aabb;
use microwarp::{Error, fixed, poly, warp::Interval};
use rand_core::Rng;
use rand_pcg::Pcg32;
use std::fmt::Debug;

const STUCK: [u32; 14] = [
    0,
    1,
    0xff,
    0x100,
    0x3fff_ffff,
    0x4000_0000,
    0x7fff_ffff,
    0x8000_0000,
    0x8000_00ff,
    0xaaaa_aaaa,
    0xc000_0000,
    0xffff_fe00,
    0xffff_feff,
    u32::MAX,
];

/// A sampler takes so many words a try, spends its budget to the word where a generator is stuck at a word that no try
/// accepts, and hands on what a generator fails with.
fn keeps<S: Rejection>(sampler: Result<S, Error>, words: u64, stuck: u32)
where
    S::Point: Debug + PartialEq,
{
    let sampler = sampler.unwrap();
    let (tries, all) = (sampler.budget(), words * u64::from(sampler.budget()));
    let spent = Failure::BudgetSpent { tries };
    let mut rng = Counting::new(Pcg32::new(2, 2));
    for _ in 0..1000 {
        let before = rng.words;
        match sampler.draw(&mut rng) {
            Ok(accepted) => assert_eq!(rng.words - before, words * u64::from(accepted.tries)),
            Err(failure) => assert_eq!((failure, rng.words - before), (spent, all)),
        }
    }
    let stuck = [stuck];
    let mut rng = Counting::new(Cycle::new(&stuck));
    assert_eq!((sampler.draw(&mut rng), rng.words), (Err(spent), all));
    for left in 0..=all {
        let word = stuck[0];
        let end = sampler.try_draw(&mut Failing { word, left });
        let due = match left < all {
            true => Failure::Generator(Broken(17)),
            false => Failure::BudgetSpent { tries },
        };
        assert_eq!(end, Err(due), "{left}");
    }
}

#[test]
fn budgets_are_kept_to_the_word() {
    let line = Interval::new(0.0, 1.0).unwrap();
    let tail = poly::ExponentialTail::from_rate(1.0).unwrap();
    let (square, cube) = (Aabb::new([0.0; 2], [1.0; 2]), Aabb::new([0.0; 3], [1.0; 3]));
    let (square, cube) = (square.unwrap(), cube.unwrap());
    let (long, short) = (fixed::DiskRejection::new(), fixed::DiskRejection16::new());
    let poisson = poly::PoissonRejection::new(30.0).unwrap();
    let on_line = Bounded::new(line, |_| 0.0, 1.0).unwrap();
    let on_tail = Bounded::new(tail, |_| 0.0, 1.0).unwrap();
    let in_cube = Bounded::new(cube, |_| -0.0, 1.0).unwrap();
    let rising = Bounded::new(square, |[x, y]: [f32; 2]| x * y, 1.0).unwrap();
    for budget in [1, 2, 7] {
        // Stuck in the corner of the box.
        keeps(DiskRejection::new().with_budget(budget), 2, u32::MAX);
        keeps(BallRejection::new().with_budget(budget), 3, u32::MAX);
        keeps(long.with_budget(budget), 2, 0x8000_8000);
        keeps(short.with_budget(budget), 1, 0x8000_8000);
        // Stuck beyond all counts.
        keeps(poisson.with_budget(budget), 2, 0);
        // Nothing is inside.
        keeps(Region::new(line, |_| false).with_budget(budget), 1, 0);
        keeps(Region::new(tail, |_| false).with_budget(budget), 2, 0);
        keeps(Region::new(cube, |_| false).with_budget(budget), 3, 0);
        // One word more for the decision.
        keeps(on_line.with_budget(budget), 2, 0);
        keeps(on_tail.with_budget(budget), 3, 0);
        keeps(in_cube.with_budget(budget), 4, 0);
        keeps(rising.with_budget(budget), 3, 0);
    }
    let failed = Failure::Generator(Broken(17));
    let source = std::error::Error::source(&failed).unwrap();
    assert_eq!(source.downcast_ref(), Some(&Broken(17)));
    assert_eq!(failed.to_string(), "the generator failed: broken 17");
}

#[test]
fn a_budget_of_nothing_is_refused() {
    let line = Interval::new(0.0, 1.0).unwrap();
    let none = Some(Error::NotPositive(0));
    assert_eq!(Region::new(line, |_| true).with_budget(0).err(), none);
    let bounded = Bounded::new(line, |_| 1.0, 1.0).unwrap();
    assert_eq!(bounded.with_budget(0).err(), none);
    assert_eq!(DiskRejection::new().with_budget(0).err(), none);
    assert_eq!(BallRejection::new().with_budget(0).err(), none);
    assert_eq!(fixed::DiskRejection::new().with_budget(0).err(), none);
    assert_eq!(fixed::DiskRejection16::new().with_budget(0).err(), none);
    const DISK: Result<DiskRejection, Error> = DiskRejection::new().with_budget(5);
    assert_eq!(DISK.unwrap().budget(), 5);
}

#[test]
fn samplers_say_what_they_were_built_with() {
    let square = Aabb::new([-1.0; 2], [1.0; 2]).unwrap();
    let half = Region::new(square, |[x, _]: [f32; 2]| x > 0.0);
    assert_eq!((*half.domain(), half.budget()), (square, DEFAULT_BUDGET));
    let bumped = Bounded::new(square, |_| 1.0, 4.5).unwrap();
    assert_eq!((*bumped.proposal(), bumped.bound()), (square, 4.5));
    assert_eq!(bumped.budget(), DEFAULT_BUDGET);
    assert_eq!(bumped.with_budget(3).unwrap().budget(), 3);
    // The default budget does for the efficiencies it is said to.
    assert!(budget_for(0.045).unwrap() <= DEFAULT_BUDGET);
    assert!(budget_for(0.044).unwrap() > DEFAULT_BUDGET);
}

/// Stuck at one value: a point at the first try, or an error when the budget is spent.
#[test]
fn a_stuck_generator_ends_at_once_or_with_the_budget() {
    fn ends<S: Rejection>(sampler: &S, word: u32) -> bool {
        let words = [word];
        let mut rng = Counting::new(Cycle::new(&words));
        match sampler.draw(&mut rng) {
            Ok(accepted) => {
                assert_eq!(accepted.tries, 1);
                true
            }
            Err(Failure::BudgetSpent { tries }) => {
                assert_eq!(tries, sampler.budget());
                false
            }
            Err(other) => panic!("{other:?}"),
        }
    }
    let line = Interval::new(0.0, 1.0).unwrap();
    let half = Region::new(line, |x| x > 0.5);
    let rising = Bounded::new(line, |x| x, 1.0).unwrap();
    let apart = Bounded::new(poly::Disk::new(), |[x, _]: [f32; 2]| x.abs(), 4.0).unwrap();
    let (mut points, mut errors) = (0, 0);
    for word in STUCK {
        let ended = [
            ends(&DiskRejection::new(), word),
            ends(&BallRejection::new(), word),
            ends(&half, word),
            ends(&rising, word),
            ends(&apart, word),
        ];
        points += ended.iter().filter(|e| **e).count();
        errors += ended.iter().filter(|e| !**e).count();
    }
    assert!(
        points > 10 && errors > 10,
        "{points} points, {errors} errors"
    );
    // What a dead peripheral reads as is a corner of the box, and so an error.
    for word in [0, u32::MAX] {
        assert!(!ends(&DiskRejection::new(), word) && !ends(&BallRejection::new(), word));
    }
}

#[test]
fn an_alternating_generator_ends_too() {
    for words in [
        &[0, u32::MAX][..],
        &[u32::MAX, 0],
        &[0, u32::MAX, 0x8000_0000, 5, 0],
    ] {
        let disk = DiskRejection::new().draw(&mut Cycle::new(words));
        let ball = BallRejection::new().draw(&mut Cycle::new(words));
        if words.len() == 2 {
            assert_eq!(disk, Err(Failure::BudgetSpent { tries: 32 }));
            assert_eq!(ball, Err(Failure::BudgetSpent { tries: 64 }));
        }
        assert!(disk.is_ok_and(|a| a.tries <= 5) || words.len() == 2);
    }
}

/// Drawing is attempting at the drawn words.
#[test]
fn drawing_is_attempting_at_the_drawn_uniforms() {
    let disk = DiskRejection::new();
    let f = |[x, y]: [f32; 2]| x * x + y * y;
    let square = Aabb::new([0.0; 2], [1.0; 2]).unwrap();
    let bounded = Bounded::new(square, f, 2.0).unwrap();
    let region = Region::new(square, |p| f(p) < 0.5);
    let poisson = poly::PoissonRejection::new(77.7).unwrap();
    let urn = poly::HypergeometricRejection::new(9000, 700, 500).unwrap();
    let (mut drawn, mut replayed) = (Pcg32::new(3, 3), Pcg32::new(3, 3));
    for _ in 0..1000 {
        let mut u = || grid_from_word(replayed.next_u32());
        let once: Result<_, Failure> = disk.try_once(&mut drawn);
        assert_eq!(once, Ok(disk.attempt([u(), u()])));
        let once: Result<_, Failure> = region.try_once(&mut drawn);
        assert_eq!(once, Ok(region.attempt([u(), u()])));
        let once: Result<_, Failure> = bounded.try_once(&mut drawn);
        let u = [u(), u()];
        assert_eq!(once, bounded.attempt(u, replayed.next_u32()));
        let once: Result<_, Failure> = poisson.try_once(&mut drawn);
        let words = [replayed.next_u32(), replayed.next_u32()];
        assert_eq!(once, Ok(poisson.attempt(words)));
        let once: Result<_, Failure> = urn.try_once(&mut drawn);
        let words = [replayed.next_u32(), replayed.next_u32()];
        assert_eq!(once, Ok(urn.attempt(words)));
    }
    assert_eq!(drawn, replayed);
}

#[test]
fn a_dyn_generator_will_do() {
    let mut rng = Pcg32::new(4, 4);
    let accepted: Accepted<[f32; 3]> = BallRejection::new().draw(&mut rng).unwrap();
    let mut again = Pcg32::new(4, 4);
    let erased: &mut dyn Rng = &mut again;
    assert_eq!(BallRejection::new().draw(erased), Ok(accepted));
}
