//! The acceptance: as exact as stated, from densities and ratios of any magnitude.

use super::exact::Fraction;
use super::own::given;
use host::generators::Cycle;
use host::speed;
use microwarp::metropolis::{
    Chain, HastingsCorrection, HastingsRatio, Outcome, Symmetric, TargetDensity, Transition,
};
use rand_core::Rng as _;
use rand_pcg::Pcg32;

/// The step of a chain at a state of density `from` to which one of density `to` is proposed.
pub fn step<D: TargetDensity, C: HastingsCorrection>(
    from: D,
    to: D,
    correction: C,
    word: u32,
) -> Transition<usize, D> {
    let target = |state: usize| if state == 0 { from } else { to };
    let mut chain = Chain::new(0, target).expect("a density to start from");
    let step = chain.step(target, &given(1, correction), &mut Cycle::new(&[word]));
    assert_eq!(chain.state(), step.state());
    assert_eq!(chain.accepted(), u64::from(step.is_accepted()));
    assert_eq!(chain.refused(), u64::from(step.outcome == Outcome::Refused));
    assert!(
        (0.0..=1.0).contains(&step.acceptance),
        "{}",
        step.acceptance
    );
    step
}

pub fn acceptance<D: TargetDensity, C: HastingsCorrection>(from: D, to: D, correction: C) -> f32 {
    step(from, to, correction, 0).acceptance
}

/// Any positive finite number, each bit pattern as likely as the next.
pub fn positive(rng: &mut Pcg32) -> f32 {
    f32::from_bits(1 + rng.next_u32() % (f32::INFINITY.to_bits() - 1))
}

fn significand(rng: &mut Pcg32) -> f32 {
    f32::from_bits(1.0_f32.to_bits() | rng.next_u32() >> 9)
}

/// A number with this exponent; subnormal below -126, which may cost digits but never all.
fn scaled(significand: f32, exponent: i32) -> f32 {
    (f64::from(significand) * 2_f64.powi(exponent)) as f32
}

/// A number up to 2¹⁹ steps away.
pub fn nudged(x: f32, rng: &mut Pcg32) -> f32 {
    let by = 1_u32 << (rng.next_u32() % 20);
    let bits = x.to_bits();
    f32::from_bits(match rng.next_u32() % 2 {
        0 => bits + by,
        _ => bits - by,
    })
}

fn between(rng: &mut Pcg32, low: i32, high: i32) -> i32 {
    low + (rng.next_u32() % (high - low + 1) as u32) as i32
}

#[test]
fn a_symmetric_acceptance_is_correctly_rounded() {
    let mut rng = Pcg32::new(1, 1);
    let (mut worst, mut subnormal, mut below) = (0.0_f64, 0, 0);
    let rounds = speed::of("rounds", 100_000, 1_000_000);
    for round in 0..rounds {
        let from = positive(&mut rng);
        let to = match round % 4 {
            0 => positive(&mut rng),
            // Near each other, and so far apart that the quotient is subnormal.
            1 => scaled(from, -between(&mut rng, 0, 3)) * significand(&mut rng),
            _ => scaled(from, -between(&mut rng, 120, 151)) * significand(&mut rng),
        };
        if !(to > 0.0 && to <= f32::MAX) {
            continue;
        }
        let exact = Fraction::of(to).over(&Fraction::of(from)).capped();
        let a = acceptance(from, to, Symmetric);
        let off = exact.ulps(a);
        assert!(off <= 0.5, "{from:e} -> {to:e}: {a:e} is {off} ulp off");
        worst = worst.max(off);
        subnormal += u32::from(a > 0.0 && a < f32::MIN_POSITIVE);
        below += u32::from(a < 1.0);
    }
    println!("symmetric: {worst:.4} ulp; {below} below 1, {subnormal} subnormal");
    assert!(worst > 0.49 && below > rounds / 2 && subnormal > rounds / 20);
}

/// Four numbers whose acceptance is likely to be neither 1 nor 0.
fn four(rng: &mut Pcg32) -> Option<[f32; 4]> {
    let exponents = [(); 3].map(|()| between(rng, -149, 127));
    let [to, backward, forward] = exponents;
    let from = to + backward - forward + between(rng, -1, 152);
    let numbers = [from, to, forward, backward].map(|e| scaled(significand(rng), e));
    numbers
        .iter()
        .all(|x| *x > 0.0 && *x <= f32::MAX)
        .then_some(numbers)
}

fn with_a_ratio([from, to, forward, backward]: [f32; 4]) -> f64 {
    let [f, t, there, back] = [from, to, forward, backward].map(Fraction::of);
    let exact = t.times(&back).over(&f.times(&there)).capped();
    exact.ulps(acceptance(from, to, HastingsRatio::new(forward, backward)))
}

#[test]
fn an_acceptance_with_a_ratio_is_within_2_and_a_half_ulp() {
    let mut rng = Pcg32::new(2, 2);
    let (mut worst, mut cases) = (0.0_f64, 0);
    let mut try_one = |numbers: [f32; 4]| {
        let off = with_a_ratio(numbers);
        assert!(off <= 2.5, "{numbers:?}: {off} ulp off");
        worst = worst.max(off);
        // Of all bit patterns, most are 0 or 1.
        cases += u32::from(off > 0.0);
        off
    };
    let rounds = speed::of("rounds", 100_000, 1_000_000);
    for _ in 0..rounds {
        if let Some(numbers) = four(&mut rng) {
            try_one(numbers);
        }
    }
    for _ in 0..rounds / 3 {
        try_one([(); 4].map(|()| positive(&mut rng)));
    }
    // A search for the worst: a quotient just above a power of two loses most, in proportion, and a product
    // just below one counts it most.
    for _ in 0..speed::of("searches", 30, 200) {
        let near = |rng: &mut Pcg32| 1.0 + f32::EPSILON * (rng.next_u32() >> 20) as f32;
        let mut best = [near(&mut rng), near(&mut rng), 1.0, 1.0];
        best[0] *= 2.0;
        (best[2], best[3]) = (significand(&mut rng), significand(&mut rng) * 0.999);
        let mut most = try_one(best);
        for _ in 0..500 {
            let mut next = best;
            let which = rng.next_u32() as usize % 4;
            next[which] = nudged(next[which], &mut rng);
            let off = try_one(next);
            if off >= most {
                (most, best) = (off, next);
            }
        }
    }
    println!("with a ratio: {worst:.4} ulp; {cases} acceptances are rounded");
    assert!(worst > 1.75 && cases > rounds / 2);
}

/// The value of a ratio, through the acceptance of two densities whose quotient is a power of two, which
/// brings it below 1 and not below 2^-66.
fn value(forward: u128, backward: u128) -> (f32, Fraction) {
    let ratio = HastingsRatio::from_counts(forward, backward);
    let exact = Fraction::of_count(backward).over(&Fraction::of_count(forward));
    let from = if backward < forward {
        1.0
    } else {
        2_f32.powi(66)
    };
    let a = acceptance(from, 1.0, ratio);
    (a, exact.over(&Fraction::of(from)))
}

#[test]
fn a_ratio_of_counts_is_correctly_rounded_but_next_to_the_middle() {
    let mut rng = Pcg32::new(3, 3);
    let (mut worst, mut wrong) = (0.0_f64, 0);
    let mut check = |forward: u128, backward: u128| {
        let (a, exact) = value(forward, backward);
        let off = exact.ulps(a);
        assert!(off <= 0.5 + 1e-6, "{backward}/{forward}: {off} ulp off");
        worst = worst.max(off);
        wrong += u32::from(off > 0.5);
    };
    let any = |rng: &mut Pcg32| u128::from(rng.next_u64() >> (rng.next_u32() % 64)).max(1);
    let rounds = speed::of("rounds", 100_000, 1_000_000);
    for _ in 0..rounds {
        check(any(&mut rng), any(&mut rng));
    }
    const ALL: u128 = 1 << 64;
    let edges = [
        1,
        2,
        3,
        ALL - 1,
        ALL,
        ALL / 2,
        ALL / 2 + 1,
        (1 << 24) + 1,
        (1 << 48) - 1,
    ];
    for forward in edges {
        for backward in edges {
            check(forward, backward);
        }
    }
    // Next to the middle of two f32: the middle has 25 bits, and the count is off by a few parts in 2^48.
    for _ in 0..rounds {
        let forward = u128::from(rng.next_u64() | 1 << 63);
        let middle = u128::from(rng.next_u32() >> 8 | 1 << 23) * 2 + 1;
        let exact = (forward * middle) >> 25;
        let around = u128::from(rng.next_u32()) >> (rng.next_u32() % 16);
        let backward = match rng.next_u32() % 2 {
            0 => exact + around,
            _ => exact - around,
        };
        check(forward, backward);
    }
    println!(
        "ratio of counts: 0.5 + {:.2e} ulp; {wrong} roundings to the other side",
        worst - 0.5
    );
    assert!(
        wrong > 0,
        "the search does not come near enough to the middle"
    );
}

#[test]
fn counts_beyond_2_to_the_64_count_as_that() {
    let all = 1_u128 << 64;
    for count in [all + 1, all * 2, u128::MAX] {
        assert_eq!(
            HastingsRatio::from_counts(3, count),
            HastingsRatio::from_counts(3, all)
        );
        assert_eq!(
            HastingsRatio::from_counts(count, 3),
            HastingsRatio::from_counts(all, 3)
        );
        assert_eq!(HastingsRatio::from_counts(count, all), HastingsRatio::ONE);
    }
}
