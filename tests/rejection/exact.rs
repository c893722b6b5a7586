//! Disk and ball are exact: on integers, every grid point of the inside and none of the outside.

use microwarp::rejection::{BallRejection, DiskRejection, Rejection};
use microwarp::uniform::{LARGEST, grid};
use rand_core::Rng;
use rand_pcg::Pcg32;
use std::f64::consts::PI;

const SIDE: i64 = 1 << 24;

/// The uniform whose coordinate is m 2^-24, for an odd m.
fn uniform(m: i64) -> f32 {
    assert!(m % 2 != 0 && m.abs() < SIDE);
    ((m + SIDE - 1) / 2) as f32 / SIDE as f32
}

/// The coordinate in units of 2^-24; it must be an odd integer.
fn units(x: f32) -> i64 {
    let m = f64::from(x) * SIDE as f64;
    assert!(m.fract() == 0.0 && (m as i64) % 2 != 0, "{x}");
    m as i64
}

/// Whether a grid point lies inside, in exact arithmetic.
fn inside(m: &[i64]) -> bool {
    m.iter().map(|m| i128::from(m * m)).sum::<i128>() <= i128::from(SIDE) * i128::from(SIDE)
}

fn check<const D: usize>(
    m: [i64; D],
    attempt: impl Fn([f32; D]) -> Option<[f32; D]>,
    pdf: impl Fn([f32; D]) -> f32,
) -> bool {
    let point = attempt(m.map(uniform));
    assert_eq!(point.is_some(), inside(&m), "{m:?}");
    if let Some(point) = point {
        assert_eq!(point.map(units), m);
        assert!(pdf(point) > 0.0, "{m:?} has density 0");
    }
    point.is_some()
}

fn check_disk(m: [i64; 2]) -> bool {
    let disk = DiskRejection::new();
    check(m, |u| disk.attempt(u), |x| disk.pdf(x))
}

fn check_ball(m: [i64; 3]) -> bool {
    let ball = BallRejection::new();
    check(m, |u| ball.attempt(u), |x| ball.pdf(x))
}

/// The largest odd m with m² ≤ `left`, if any.
fn rim(left: i64) -> Option<i64> {
    let mut m = (left as f64).sqrt() as i64 | 1;
    while m > 0 && m * m > left {
        m -= 2;
    }
    (m > 0).then_some(m)
}

/// The last points inside and the first outside, in every 33rd column and all four quadrants.
#[test]
fn the_rim_of_the_disk_is_exact() {
    let mut walked = 0;
    for x in (1..SIDE).step_by(66) {
        let Some(y) = rim(SIDE * SIDE - x * x) else {
            continue;
        };
        let beyond = y + 2;
        for [sx, sy] in [[1, 1], [-1, 1], [1, -1], [-1, -1]] {
            assert!(check_disk([sx * x, sy * y]));
            assert!(beyond >= SIDE || !check_disk([sx * x, sy * beyond]));
            assert!(check_disk([sx * y, sy * x]));
        }
        walked += 1;
    }
    assert!(walked > 250_000);
}

#[test]
fn the_rim_of_the_ball_is_exact() {
    let mut rng = Pcg32::new(1, 1);
    let mut walked = 0;
    for _ in 0..1_000_000 {
        let [x, y] = [0, 1].map(|_| 2 * i64::from(rng.next_u32() >> 9) + 1);
        let Some(z) = rim(SIDE * SIDE - x * x - y * y) else {
            continue;
        };
        let sign = if rng.next_u32() % 2 == 0 { 1 } else { -1 };
        assert!(check_ball([x, sign * y, -sign * z]));
        assert!(z + 2 >= SIDE || !check_ball([x, y, z + 2]));
        assert!(check_ball([sign * z, x, y]) && check_ball([y, z, x]));
        walked += 1;
    }
    assert!(walked > 700_000);
}

/// The very last points inside and the very first outside that there are: squares of 2^48 - 6 and 2^48 + 10 in
/// the disk, of 2^48 - 5 and 2^48 + 3 in the ball. `f32` holds 1 for any of them.
#[test]
fn the_points_next_to_the_rim_fall_on_their_side() {
    assert!(check_disk([2_647_575, 16_566_995]));
    assert!(!check_disk([2_660_371, 16_564_945]));
    assert!(check_ball([1_152_541, 9_948_921, 13_459_777]));
    assert!(!check_ball([3_143_153, 11_182_755, 12_105_435]));
}

/// A grid symmetric about 0: turning any uniform round turns the sign of its coordinate.
#[test]
fn the_grid_is_symmetric() {
    let mut rng = Pcg32::new(2, 2);
    let mut seen = 0;
    for _ in 0..100_000 {
        let u = [grid(&mut rng), grid(&mut rng), grid(&mut rng)];
        let turned = u.map(|u| LARGEST - u);
        let [ball, opposite] = [u, turned].map(|u| BallRejection::new().attempt(u));
        assert_eq!(ball.map(|p| p.map(|c| -c)), opposite);
        let [[a, b, _], [c, d, _]] = [u, turned];
        let disk = DiskRejection::new();
        let opposite = disk.attempt([c, d]).map(|p| p.map(|c| -c));
        assert_eq!(disk.attempt([a, b]), opposite);
        seen += usize::from(ball.is_some());
    }
    assert!(seen > 50_000);
    assert_eq!(
        DiskRejection::new().attempt([0.5, 0.5]),
        Some([2.0_f32.powi(-24); 2])
    );
}

/// Any f32 serves as a uniform; one between two grid points counts as the lower.
#[test]
fn any_uniform_will_do() {
    let disk = DiskRejection::new();
    let half = 0.5;
    for (u, same) in [
        (f32::NAN, 0.0),
        (-1.0, 0.0),
        (1e-30, 0.0),
        (1.0, LARGEST),
        (f32::INFINITY, LARGEST),
        (0.25 + 2.0_f32.powi(-26), 0.25),
    ] {
        assert_eq!(disk.attempt([u, half]), disk.attempt([same, half]), "{u}");
        assert_eq!(disk.attempt([half, u]), disk.attempt([half, same]), "{u}");
    }
    let [x, _] = disk.attempt([LARGEST, half]).unwrap();
    assert_eq!(x, LARGEST);
    assert_eq!(disk.attempt([0.0, half]).unwrap()[0], -LARGEST);
    assert_eq!(disk.attempt([LARGEST; 2]), None);
    assert_eq!(BallRejection::new().attempt([0.0; 3]), None);
}

#[test]
fn densities_are_the_reciprocal_measures() {
    let (disk, ball) = (DiskRejection::new(), BallRejection::new());
    let off = |pdf: f32, exact: f64| (f64::from(pdf) / exact - 1.0).abs();
    assert!(off(disk.pdf([0.3, -0.4]), 1.0 / PI) <= 4.5e-8);
    assert!(off(ball.pdf([0.3, -0.4, 0.5]), 0.75 / PI) <= 3e-8);
    for x in [
        1.1,
        -1.1,
        f32::MAX,
        f32::INFINITY,
        f32::NEG_INFINITY,
        f32::NAN,
    ] {
        assert_eq!(disk.pdf([x, 0.0]), 0.0);
        assert_eq!(disk.pdf([0.0, x]), 0.0);
        assert_eq!(ball.pdf([0.0, 0.0, x]), 0.0);
        assert_eq!(ball.pdf([x, 0.0, f32::NAN]), 0.0);
    }
    assert_eq!(disk.pdf([0.8, 0.7]), 0.0);
    assert_eq!(ball.pdf([0.6, 0.6, 0.6]), 0.0);
}

/// Drawn points obey all of it.
#[test]
fn drawn_points_lie_inside() {
    let mut rng = Pcg32::new(3, 3);
    for _ in 0..1_000_000 {
        let point = DiskRejection::new().draw(&mut rng).unwrap().point;
        assert!(inside(&point.map(units)) && DiskRejection::new().pdf(point) > 0.0);
        let point = BallRejection::new().draw(&mut rng).unwrap().point;
        assert!(inside(&point.map(units)) && BallRejection::new().pdf(point) > 0.0);
    }
}
