//! The disks of the integer tier: every word there is, and for two words the whole rim, in exact arithmetic.

use ::fixed::types::{I2F30, U0F32};
use host::generators::Cycle;
use host::speed;
use microwarp::fixed::{DiskRejection, DiskRejection16};
use microwarp::rejection::Rejection;
use rand_core::Rng;
use rand_pcg::Pcg32;
use std::f64::consts::{FRAC_1_PI, FRAC_PI_4};

/// The radius of each grid: 2^16 and 2^30 units.
const SHORT: i64 = 1 << 16;
const LONG: i64 = 1 << 30;

/// The odd points of the disk of this radius, counted row by row.
fn lattice(radius: i64) -> u64 {
    let mut points = 0;
    let mut y = radius - 1;
    // The largest odd y goes down as x goes up.
    for x in (1..radius).step_by(2) {
        while y > 0 && x * x + y * y >= radius * radius {
            y -= 2;
        }
        points += (y as u64).div_ceil(2);
    }
    4 * points
}

#[test]
fn the_lattice_is_counted_right() {
    // By hand: within 2, (±1, ±1); within 4, also (±1, ±3) and (±3, ±1), but not (±3, ±3).
    assert_eq!([2, 4].map(lattice), [4, 12]);
    let all = |r: i64| (1 - r..r).step_by(2).collect::<Vec<_>>();
    for radius in [6, 8, 64, 1000] {
        let pairs = all(radius)
            .into_iter()
            .flat_map(|x| all(radius).into_iter().map(move |y| x * x + y * y));
        let inside = pairs.filter(|s| *s < radius * radius).count();
        assert_eq!(lattice(radius), inside as u64);
    }
}

/// All 2^32 words, in the quick speed one of every 61²: each is the point that its halves say, accepted where that lies
/// inside.
#[test]
fn every_word_of_the_disk_from_one_word_is_right() {
    let odd = |half: u32| 2 * i64::from(half as u16 as i16) + 1;
    let stride = speed::of("one half of a word tried of every", 61, 1);
    let count = |rows: std::ops::Range<u32>| {
        let disk = DiskRejection16::new();
        let mut quadrants = [0_u64; 4];
        for upper in rows.step_by(stride) {
            let x = odd(upper);
            for lower in (upper % stride as u32..1 << 16).step_by(stride) {
                let y = odd(lower);
                let inside = x * x + y * y < SHORT * SHORT;
                let point = disk.attempt(upper << 16 | lower);
                let due = inside.then_some([x, y].map(|m| I2F30::from_bits((m << 14) as i32)));
                assert!(point == due, "{upper:x} {lower:x}: {point:?} for {due:?}");
                quadrants[(upper >> 15 << 1 | lower >> 15) as usize] += u64::from(inside);
            }
        }
        quadrants
    };
    let halves = std::thread::scope(|scope| {
        let halves = [0..1 << 15, 1 << 15..1 << 16].map(|half| scope.spawn(|| count(half)));
        halves.map(|half| half.join().unwrap())
    });
    let quadrants: Vec<u64> = (0..4).map(|q| halves[0][q] + halves[1][q]).collect();
    let points: u64 = quadrants.iter().sum();
    println!("{quadrants:?}: {points} points");
    let inside = lattice(SHORT);
    if speed::full() {
        assert_eq!(points, inside);
        assert!(quadrants.iter().all(|q| 4 * q == points));
    }
    // The efficiency is that, exactly, and is stated.
    assert_eq!(u64::from(DiskRejection16::EFFICIENCY.to_bits()), inside);
    let less = FRAC_PI_4 - inside as f64 * 2_f64.powi(-32);
    assert!((4.1e-8..4.2e-8).contains(&less), "{less}");
}

/// Two words whose coordinates are x and y, with any of the bits that do not count.
fn uniforms(point: [i64; 2], rest: u32) -> [U0F32; 2] {
    point.map(|m| {
        assert!(m % 2 != 0 && m.abs() < LONG);
        // Modulo 2: the upper half of the uniforms is the left half of the disk.
        let u = (m - 1).rem_euclid(2 * LONG) as u32;
        U0F32::from_bits(u << 1 | rest & 3)
    })
}

fn inside([x, y]: [i64; 2]) -> bool {
    x * x + y * y < LONG * LONG
}

/// The decision that the first 16 bits alone would make.
fn by_halves(point: [i64; 2]) -> bool {
    let [x, y] = point.map(|m| (m >> 15 << 1) + 1);
    x * x + y * y < SHORT * SHORT
}

fn check(point: [i64; 2], rest: u32) -> bool {
    let got = DiskRejection::new().attempt(uniforms(point, rest));
    assert_eq!(got.is_some(), inside(point), "{point:?}");
    if let Some(got) = got {
        assert_eq!(got.map(|c| i64::from(c.to_bits())), point);
    }
    got.is_some()
}

/// The largest odd m with m² < `left`, if any.
fn rim(left: i64) -> Option<i64> {
    let mut m = (left as f64).sqrt() as i64 | 1;
    while m > 0 && m * m >= left {
        m -= 2;
    }
    while (m + 2) * (m + 2) < left {
        m += 2;
    }
    (m > 0).then_some(m)
}

/// The last points inside and the first outside, in half a million columns and all four quadrants; and where the
/// first 16 bits begin to decide.
#[test]
fn the_rim_of_the_disk_from_two_words_is_exact() {
    let mut rng = Pcg32::new(1, 1);
    let (mut walked, mut wrong) = (0, 0);
    for k in 0..500_000 {
        let x = match k {
            0..100 => 2 * k + 1,
            100..200 => LONG - 1 - 2 * (k - 100),
            _ => i64::from(rng.next_u32() >> 2) | 1,
        };
        let Some(y) = rim(LONG * LONG - x * x) else {
            continue;
        };
        let beyond = y + 2;
        for [sx, sy] in [[1, 1], [-1, 1], [1, -1], [-1, -1]] {
            assert!(check([sx * x, sy * y], rng.next_u32()));
            assert!(check([sy * y, sx * x], rng.next_u32()));
            assert!(beyond >= LONG || !check([sx * x, sy * beyond], rng.next_u32()));
        }
        wrong += u32::from(!by_halves([x, y]));
        // Where the first 16 bits begin to decide is some 2^22 places from here; and anywhere between.
        for _ in 0..4 {
            let away = i64::from(rng.next_u32() >> (rng.next_u32() % 20)) * 2;
            for near in [y - away, y + away] {
                if near > 0 && near < LONG {
                    assert_eq!(check([-x, near], 0), near <= y);
                }
            }
        }
        walked += 1;
    }
    println!("{walked} columns; the first 16 bits alone are wrong in {wrong} of them");
    // What the halves alone would get wrong is met all along.
    assert!(walked == 500_000 && wrong > 100_000);
}

#[test]
fn any_words_of_the_disk_from_two_words_are_right() {
    let mut rng = Pcg32::new(2, 2);
    let disk = DiskRejection::new();
    let n = speed::of("points of the disk from two words", 1_000_000, 20_000_000);
    let mut points = 0_u32;
    for _ in 0..n {
        let words = [rng.next_u32(), rng.next_u32()];
        let odd = |w: u32| 2 * i64::from(w as i32 >> 2) + 1;
        let due = words.map(odd);
        let got = disk.attempt(words.map(U0F32::from_bits));
        let bits = got.map(|p| p.map(|c| i64::from(c.to_bits())));
        assert_eq!(bits, inside(due).then_some(due));
        // Inverted words give the opposite point.
        let opposite = disk.attempt(words.map(|w| U0F32::from_bits(!w)));
        assert_eq!(opposite, got.map(|p| p.map(|c| -c)));
        points += u32::from(got.is_some());
    }
    // Seven standard errors.
    let (e, n) = (FRAC_PI_4, f64::from(n));
    let off = f64::from(points) / n - e;
    assert!(off.abs() <= 7.0 * (e * (1.0 - e) / n).sqrt(), "{off}");
    let stated = f64::from(DiskRejection::EFFICIENCY);
    assert!((stated - FRAC_PI_4).abs() <= 2_f64.powi(-32));
    // Corners, the middle, the ends of the axes.
    let at = |a: u32, b: u32| disk.attempt([a, b].map(U0F32::from_bits));
    let bits = |x: i32| I2F30::from_bits(x);
    let end = (LONG - 1) as i32;
    let half = 1 << 31;
    assert_eq!(at(half, half), None);
    assert_eq!(at(half - 1, half), None);
    assert_eq!(at(0, 0), Some([bits(1); 2]));
    assert_eq!(at(u32::MAX, 0), Some([bits(-1), bits(1)]));
    assert_eq!(at(half - 1, 0), Some([bits(end), bits(1)]));
    assert_eq!(at(0, half), Some([bits(1), bits(-end)]));
    // A coordinate is 2u, or that less 2.
    let u = |x: f64| U0F32::from_num(x);
    let [x, y] = disk.attempt([u(0.125), u(0.625)]).unwrap();
    assert_eq!((x - bits(1), y - bits(1)), (bits(1 << 28), bits(-3 << 28)));
}

#[test]
fn densities_are_one_over_pi_inside_and_nothing_outside() {
    let (long, short) = (DiskRejection::new(), DiskRejection16::new());
    let one = I2F30::ONE;
    let mut rng = Pcg32::new(3, 3);
    for _ in 0..10_000 {
        for point in [long.draw(&mut rng).unwrap(), short.draw(&mut rng).unwrap()] {
            let pdf = long.pdf(point.point);
            assert_eq!(pdf, short.pdf(point.point));
            assert!(
                ((pdf.to_bits() as f64) * 2_f64.powi(-32) - FRAC_1_PI).abs() <= 2_f64.powi(-33)
            );
        }
    }
    for on_the_rim in [[one, I2F30::ZERO], [I2F30::ZERO, -one]] {
        assert!(long.pdf(on_the_rim) > 0);
    }
    let step = I2F30::from_bits(1);
    for outside in [
        [one + step, I2F30::ZERO],
        [step, -one],
        [I2F30::MIN; 2],
        [I2F30::MAX, I2F30::MIN],
        [one, one],
    ] {
        assert_eq!((long.pdf(outside), short.pdf(outside)), Default::default());
    }
}

#[test]
fn a_try_is_one_with_the_words_drawn() {
    let (long, short) = (DiskRejection::new(), DiskRejection16::new());
    assert_eq!(DiskRejection::default().budget(), DiskRejection::BUDGET);
    assert_eq!(short.budget(), DiskRejection16::BUDGET);
    let mut rng = Pcg32::new(5, 5);
    for _ in 0..1000 {
        let words = [rng.next_u32(), rng.next_u32()];
        let due = long.attempt(words.map(U0F32::from_bits));
        assert_eq!(long.try_once(&mut Cycle::new(&words)), Ok(due));
        let due = short.attempt(words[0]);
        assert_eq!(short.try_once(&mut Cycle::new(&words)), Ok(due));
    }
}
