//! The sum modulo 1: by the rule that is documented, worked out in integers, for any two numbers at all. So, with steps whose
//! negatives have as many words (`laws`), as many words lead in a wrapped walk from each grid point to each other as lead back.

use host::speed;
use microwarp::metropolis::{
    BoxStep, LogUniformStep, Mutation, NormalStep, StepLaw, WrappedWalk, wrapping_add,
};
use microwarp::tier::{Libm, Poly};
use microwarp::uniform::LARGEST;
use rand_core::Rng;
use rand_pcg::Pcg32;

const POINTS: u32 = 1 << 24;

/// A point of the grid.
fn point(place: u32) -> f32 {
    (f64::from(place) / f64::from(POINTS)) as f32
}

/// x·2²⁴ to the nearest integer modulo 2²⁴, halves away from 0, out of the bits of x; 0 if there is none.
fn steps(x: f32) -> u32 {
    let bits = x.to_bits();
    let exponent = (bits >> 23 & 0xff) as i32;
    let significand = u64::from(bits & 0x007f_ffff) | if exponent > 0 { 1 << 23 } else { 0 };
    // |x| 2²⁴ = significand · 2^power.
    let power = exponent.max(1) - 150 + 24;
    let size = match power {
        _ if exponent == 255 => 0,
        24.. => 0,
        0..24 => significand << power,
        // Half of the last place, added before the rest is dropped.
        -40..0 => (significand + (1 << (-power - 1))) >> -power,
        _ => 0,
    } as u32
        % POINTS;
    if bits >> 31 == 0 {
        size
    } else {
        (POINTS - size) % POINTS
    }
}

/// The leading 24 bits of a uniform, by the rule for those out of range.
fn place(u: f32) -> u32 {
    if u >= 1.0 {
        POINTS - 1
    } else if u > 0.0 {
        (f64::from(u) * f64::from(POINTS)) as u32
    } else {
        0
    }
}

fn expected(u: f32, s: f32) -> f32 {
    point((place(u) + steps(s)) % POINTS)
}

/// Whether a number is a point of the grid in [0, 1).
fn on_grid(x: f32) -> bool {
    (0.0..1.0).contains(&x) && (f64::from(x) * f64::from(POINTS)).fract() == 0.0
}

#[track_caller]
fn check(u: f32, s: f32) {
    let sum = wrapping_add(u, s);
    let bits = (u.to_bits(), s.to_bits());
    assert!(on_grid(sum), "{u:e} + {s:e} ({bits:x?}): {sum:e}");
    assert_eq!(sum, expected(u, s), "{u:e} + {s:e} ({bits:x?})");
}

/// The reference itself, on numbers whose place is known.
#[test]
fn the_rule_in_integers_is_the_documented_one() {
    let half = 2f32.powi(-25);
    for (x, k) in [
        (0.0, 0),
        (half, 1),
        (-half, POINTS - 1),
        (half.next_down(), 0),
        (half.next_up(), 1),
        (3.0 * half, 2),
        (5.0 * half, 3),
        (0.25, POINTS / 4),
        (-0.25, POINTS / 4 * 3),
        (1000.5, POINTS / 2),
        (-1.0, 0),
        (LARGEST, POINTS - 1),
        (1e-45, 0),
        (f32::MAX, 0),
        (f32::NAN, 0),
        (f32::NEG_INFINITY, 0),
        (8_388_607.5, POINTS / 2),
    ] {
        assert_eq!(steps(x), k, "{x:e}");
    }
    assert_eq!(
        [f32::NAN, -0.0, 1e-9, 0.5, LARGEST, 1.0, 7.0].map(place),
        [0, 0, 0, POINTS / 2, POINTS - 1, POINTS - 1, POINTS - 1]
    );
}

/// Every bit pattern of a range, and of the rest every 31st; in the quick form, fewer of both.
fn patterns(whole: std::ops::Range<u32>) -> impl Iterator<Item = u32> {
    let [inside, outside] = speed::of(
        "one bit pattern of, inside and outside",
        [101, 2003],
        [1, 31],
    );
    (0..whole.start)
        .step_by(outside)
        .chain(speed::sampled(whole.clone(), inside as u32))
        .chain((whole.end..=u32::MAX).step_by(outside))
}

#[test]
fn any_step_at_all_is_added_by_the_rule() {
    let uniforms = [0.0, LARGEST, 0.5, 2f32.powi(-24), 0.123_456_7];
    // Below 2⁻²⁶ a step is none, from 2²³ up it has no fraction: of both signs.
    let [low, high] = [2f32.powi(-26), 2f32.powi(23) + 10.0].map(f32::to_bits);
    for bits in patterns(low..high) {
        check(uniforms[bits as usize % 5], f32::from_bits(bits));
        check(uniforms[bits as usize % 5], -f32::from_bits(bits));
    }
}

#[test]
fn any_uniform_at_all_is_added_to_by_the_rule() {
    let steps = [
        0.0,
        -1e-10,
        2f32.powi(-25),
        -0.3,
        123.456,
        f32::NAN,
        -LARGEST,
    ];
    // Below 2⁻²⁵ a uniform counts as 0.
    for bits in patterns(2f32.powi(-25).to_bits()..1.1_f32.to_bits()) {
        check(f32::from_bits(bits), steps[bits as usize % 7]);
    }
}

/// All of the places where a sum that rounds would leave the range.
#[test]
fn nothing_near_the_ends_gives_1() {
    let steps: Vec<f32> = (0..POINTS)
        .step_by(speed::of("one step of", 16_381, 1021))
        .map(|k| f32::from_bits(k << 8))
        .chain((0..3000).flat_map(|k| {
            let bits = 2f32.powi(-25).to_bits() - 1500 + k;
            [f32::from_bits(bits), -f32::from_bits(bits)]
        }))
        .collect();
    for near in 0..speed::of("numbers near each end", 100, 400) {
        for u in [
            f32::from_bits(1.0_f32.to_bits() - near),
            f32::from_bits(1.0_f32.to_bits() + near),
            f32::from_bits(near),
            -f32::from_bits(near),
        ] {
            for &s in &steps {
                check(u, s);
                check(u, -s);
            }
        }
    }
    // What wraps by adding in f32 does give 1, and so the check would see it.
    let naive = |u: f32, s: f32| (u + s) - (u + s).floor();
    assert_eq!(naive(0.0, -1e-10), 1.0);
    assert!(!on_grid(naive(0.0, -1e-10)));
    let leaves = (0..1000).filter(|&k| !on_grid(naive(0.0, -f32::from_bits(k << 16))));
    assert!(leaves.count() > 500);
}

#[test]
fn a_step_and_its_negative_undo_each_other() {
    let mut rng = Pcg32::new(0x0a11, 54);
    let (mut undone, mut naive_undone) = (0, 0);
    let turns = speed::of("random pairs", 1_000_000, 20_000_000);
    for _ in 0..turns {
        let u = point(rng.next_u32() >> 8);
        let s = f32::from_bits(rng.next_u32());
        let back = wrapping_add(wrapping_add(u, s), -s);
        undone += u32::from(back.to_bits() == u.to_bits());
        let there = (u + s) - (u + s).floor();
        naive_undone += u32::from((there - s) - (there - s).floor() == u);
    }
    assert_eq!(undone, turns);
    println!("by adding in f32, {naive_undone} of {turns} come back");
    assert!(naive_undone < turns * 9 / 10);
    // Every uniform of the grid, with steps about half a place.
    let stride = speed::of("one place of", 61, 1);
    for place in speed::sampled(0..POINTS, stride) {
        let u = point(place);
        for s in [0.1, 2f32.powi(-25), 2f32.powi(-25).next_down(), 1.5] {
            assert_eq!(wrapping_add(wrapping_add(u, s), -s), u);
        }
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
