//! The box is a warp: sample, density and inverse, and what it refuses.

use microwarp::warp::Aabb;
use microwarp::{Error, Invert, Warp};
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;

#[test]
fn boxes_are_warps() {
    let room = Aabb::new([-1.0, 2.0, 0.0], [1.0, 2.5, 8.0]).unwrap();
    assert_eq!(room.sample([0.5, 0.5, 0.25]), [0.0, 2.25, 2.0]);
    assert_eq!(room.invert([0.0, 2.25, 2.0]), [0.5, 0.5, 0.25]);
    assert_eq!(room.pdf([0.0, 2.25, 2.0]), 0.125);
    for outside in [
        [1.5, 2.0, 0.0],
        [0.0, 1.9, 0.0],
        [0.0, 2.0, -1.0],
        [f32::NAN, 2.0, 0.0],
    ] {
        assert_eq!(room.pdf(outside), 0.0);
    }
    let mut rng = Pcg32::new(5, 5);
    for _ in 0..10_000 {
        let point = room.draw(&mut rng);
        assert_eq!(room.pdf(point), 0.125);
        assert!(point[1] >= 2.0 && point[1] < 2.5);
    }
    assert_eq!(room.sample([f32::NAN, 7.0, -1.0]), [-1.0, 2.499_999_8, 0.0]);
    assert_eq!(Aabb::new([0.0, 1.0], [1.0, 0.0]), Err(Error::Reversed(1)));
    assert_eq!(Aabb::new([0.0, 1.0], [1.0, 1.0]), Err(Error::Empty(1)));
    assert_eq!(Aabb::new([0.0], [f32::NAN]), Err(Error::NotFinite(1)));
    assert_eq!(Aabb::new([0.0; 2], [1e-30; 2]), Err(Error::Empty(1)));
    assert_eq!(Aabb::new([0.0; 2], [1e30; 2]), Err(Error::TooLarge(1)));
    // Neither of these leaves f32 on the way.
    assert_eq!(
        Aabb::new([0.0; 2], [1e-30, 1e30]).unwrap().pdf([0.0; 2]),
        1.0
    );
}

/// The density is that of the f64 product, however far the sides lie apart, or the box is refused.
#[test]
fn the_density_of_a_box_keeps_its_digits() {
    let mut rng = Pcg32::new(6, 6);
    let (mut accepted, mut plain_off) = (0, 0);
    for _ in 0..200_000 {
        let mut side = || {
            let power = (rng.next_u32() % 250) as i32 - 125;
            let digits = 1.0 + rng.next_u32() as f32 / 4_294_967_296.0;
            digits * 2_f32.powi(power)
        };
        let high = [side(), side(), side(), side()];
        let exact: f64 = high.iter().map(|&h| 1.0 / f64::from(h)).product();
        let off = |density: f32| (f64::from(density) / exact - 1.0).abs();
        match Aabb::new([0.0; 4], high) {
            Ok(room) => {
                accepted += 1;
                assert!(off(room.pdf([0.0; 4])) <= 6.2e-8, "{high:?}");
                let plain = high.iter().map(|h| 1.0 / h).product();
                let right = off(plain) <= 6.2e-8;
                plain_off += i32::from(!right);
            }
            Err(Error::Empty(1)) => assert!(exact > 3.402_8e38, "{high:?}"),
            Err(Error::TooLarge(1)) => assert!(exact < 1.175_5e-38, "{high:?}"),
            Err(other) => panic!("{other:?}"),
        }
    }
    println!("{accepted} accepted, {plain_off} of which a plain product gets wrong");
    assert!(accepted > 50_000 && plain_off > 1_000);
    let wide = Aabb::new([-2e38, 0.0], [2e38, 2e-38]).unwrap();
    assert!((wide.pdf([0.0; 2]) - 0.125).abs() <= 1e-7);
}
