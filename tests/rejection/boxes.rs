//! The box to propose from is a warp: sample, density and inverse, and what it refuses.

use microwarp::Aabb;
use microwarp::{Error, Warp};
use rand_pcg::Pcg32;

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
    assert_eq!(Aabb::new([0.0, 1.0], [1.0, 0.0]), Err(Error::Reversed));
    assert_eq!(Aabb::new([0.0, 1.0], [1.0, 1.0]), Err(Error::Empty));
    assert_eq!(Aabb::new([0.0], [f32::NAN]), Err(Error::NotFinite));
    assert_eq!(Aabb::new([0.0; 2], [1e-30; 2]), Err(Error::Empty));
    assert_eq!(Aabb::new([0.0; 2], [1e30; 2]), Err(Error::TooLarge));
    // Neither of these leaves f32 on the way.
    assert_eq!(
        Aabb::new([0.0; 2], [1e-30, 1e30]).unwrap().pdf([0.0; 2]),
        1.0
    );
}
