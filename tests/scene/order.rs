//! One set of points for all pixels of a picture, in the picture's order: the errors of neighbours cancel, and those of pixels
//! stay. Pixels that are in another order have errors of their own.

use crate::light::{PANEL, lit_by};
use host::mean::{mean_and_variance, over_neighbours};
use host::parallel::{in_parallel, threads};
use host::speed;
use microwarp::tier::Poly;
use microwarp::uniform::{Permutation, Points};
use microwarp_scene::source::{OfPixel, Owen, Shared};
use microwarp_scene::{Camera, Colour, Lamp, Plan, Power, Set, Source, View};

/// The side of the picture: a part of a floor, lit by a panel that it does not show, as of a picture that is much larger.
const SIDE: u32 = 32;
const CAMERA: Camera = Camera {
    eye: [2.4, -0.4, 1.5],
    target: [1.5, 0.5, 0.0],
    spread: 0.05,
    lens: 0.02,
    blades: 6,
    focus: 1.9,
};

/// The points that the pixels of another picture have, which has the same pixels in an order of its own.
#[derive(Clone, Copy)]
struct Elsewhere(Shared);

impl OfPixel for Elsewhere {
    fn of_pixel(plan: &Plan, pixel: [u32; 2]) -> Self {
        let order = Permutation::new(SIDE * SIDE, 1).unwrap();
        let other = order.get(plan.index(pixel)).unwrap();
        Self(Shared::of_pixel(plan, [other % SIDE, other / SIDE]))
    }
}

impl Points for Elsewhere {
    fn word(self, index: u32, dimension: u32) -> u32 {
        self.0.word(index, dimension)
    }
}

/// The light of each pixel.
fn picture<S: Source>(samples: u32, seed: u32) -> Vec<f64> {
    let plan = Plan {
        size: [SIDE; 2],
        samples,
        seed,
    };
    let view = View::<Poly>::new(CAMERA, plan.size).unwrap();
    let lights = [Lamp {
        shape: PANEL,
        radiance: [1.0; 3],
    }];
    let scene = lit_by(&lights);
    let pixels = (0..SIDE * SIDE).map(|k| [k % SIDE, k / SIDE]);
    let light = |pixel| {
        let [light, _, _] = scene.pixel::<Poly, Power, Colour, S>(&view, pixel, &plan);
        f64::from(light)
    };
    pixels.map(light).collect()
}

/// The deviation of a pixel from its mean over the pictures.
fn deviation(pictures: &[Vec<f64>]) -> f64 {
    let pixels = 0..pictures[0].len();
    let variance = |k: usize| mean_and_variance(pictures.iter().map(|picture| picture[k])).1;
    (pixels.clone().map(variance).sum::<f64>() / pixels.len() as f64).sqrt()
}

/// The errors of pixels, and of means over their neighbours. Every picture has the same mean, so that they are the deviations.
fn errors<S: Source>(samples: u32, seeds: u32) -> [f64; 2] {
    let seeds: Vec<u32> = (0..seeds).collect();
    let pictures = in_parallel(threads(), &seeds, |seed| picture::<S>(samples, *seed));
    let smooth = pictures.iter();
    let smooth: Vec<_> = smooth
        .map(|picture| over_neighbours(picture, SIDE as usize))
        .collect();
    [pictures, smooth].map(|pictures| deviation(&pictures))
}

/// A mean over neighbours has an error at least 1.25 times smaller than by a set of its own for each pixel, and that of a pixel
/// stays, to 6 %.
#[test]
fn a_mean_over_neighbours_has_less_error_by_one_set_in_order() {
    let seeds = speed::of("seeds of pictures", 48, 400);
    for samples in [1, 4, 16] {
        let own = errors::<Set<Owen>>(samples, seeds);
        let gains = |errors: [f64; 2]| [own[0] / errors[0], own[1] / errors[1]];
        let holds = |[pixel, mean]: [f64; 2]| (pixel - 1.0).abs() <= 0.06 && mean >= 1.25;
        let shared = gains(errors::<Set<Shared>>(samples, seeds));
        let control = gains(errors::<Set<Elsewhere>>(samples, seeds));
        println!("{samples} samples: {shared:.3?}; control, in another order: {control:.3?}");
        assert!(holds(shared), "{samples} samples: {shared:?}");
        assert!(
            !holds(control) && control[1] < 1.06,
            "{samples} samples: {control:?}"
        );
    }
}
