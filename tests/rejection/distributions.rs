//! Accepted points have the stated law, in their whole domain and whatever the number of tries.

use crate::examination::{FAMILY, p_values_of_points};
use crate::subjects::{self, MORE, run};
use host::speed;
use microwarp::rejection::{Bounded, DiskRejection, Failure, Region, Rejection};
use microwarp::uniform::{Canonical, Uniforms};
use microwarp::warp::Aabb;
use microwarp::{
    Invert, Warp, libm, poly,
    warp::{Interval, Triangle},
};
use rand_core::TryRng;
use std::f32::consts::{FRAC_1_PI, PI};

#[test]
fn accepted_points_have_the_stated_law() {
    for (subject, outcome) in subjects::all().iter().zip(subjects::outcomes()) {
        FAMILY.assert_passes(subject.name, &outcome.points);
    }
}

/// A disk with r = u, as one of the source documents nearly has it, which claims the density 1/π.
struct WrongDisk;

impl Warp for WrongDisk {
    type Uniforms = [f32; 2];
    type Point = [f32; 2];
    type Density = f32;
    fn sample_canonical(&self, u: Canonical<[f32; 2]>) -> [f32; 2] {
        let [r, turns] = u.get();
        let (s, c) = (2.0 * PI * turns).sin_cos();
        [r * c, r * s]
    }
    fn pdf(&self, _: [f32; 2]) -> f32 {
        FRAC_1_PI
    }
}

impl Invert for WrongDisk {
    fn invert(&self, _: [f32; 2]) -> [f32; 2] {
        unreachable!("rejection needs no inverse")
    }
}

/// Acceptance by the six leading bits of the word alone, or five in the quick speed.
struct CoarseCoin<W, F>(Bounded<W, F>, u32);

impl<W, F> Rejection for CoarseCoin<W, F>
where
    W: Warp<Density = f32>,
    F: Fn(W::Point) -> f32,
{
    type Point = W::Point;
    fn budget(&self) -> u32 {
        600
    }
    fn try_once<R: TryRng + ?Sized>(
        &self,
        rng: &mut R,
    ) -> Result<Option<W::Point>, Failure<R::Error>> {
        let u = W::Uniforms::try_draw(rng).map_err(Failure::Generator)?;
        let word = rng.try_next_u32().map_err(Failure::Generator)?;
        Ok(self.0.attempt(u.get(), word & self.1).unwrap())
    }
}

fn p_values<S: Rejection, const D: usize>(
    sampler: &S,
    uniform: impl Fn(S::Point) -> [f64; D],
) -> Vec<f64> {
    // The same points and the same threshold as the real runs.
    p_values_of_points(&run(sampler, uniform, 99).uniforms)
}

#[test]
fn regions_that_are_slightly_off_are_rejected() {
    let square = Aabb::new([-1.0; 2], [1.0; 2]).unwrap();
    let more = *MORE as f32;
    let narrow = |[x, y]: [f32; 2]| x * x + y * y <= 1.0 - 0.005 * more;
    let narrow = Region::new(square, narrow);
    FAMILY.assert_rejected("narrow disk", &p_values(&narrow, subjects::disk));
    let oval = |[x, y]: [f32; 2]| x * x + (1.0 + 0.01 * more) * y * y <= 1.0;
    let oval = Region::new(square, oval);
    FAMILY.assert_rejected("oval", &p_values(&oval, subjects::disk));
    let cap = Region::new(libm::Hemisphere::new(), |n: [f32; 3]| {
        n[2] > 0.5 + 0.005 * more
    });
    FAMILY.assert_rejected("small cap", &p_values(&cap, subjects::cap));
    let triangle = |b: [f32; 3]| b[0] < (1.0 - 0.01 * more) * b[1];
    let triangle = Region::new(Triangle::new(), triangle);
    FAMILY.assert_rejected("triangle", &p_values(&triangle, subjects::half_triangle));
    // A disk at the centre of which a little hole has been left.
    let ring = |[x, y]: [f32; 2]| (4e-3 * more..=1.0).contains(&(x * x + y * y));
    let ring = Region::new(square, ring);
    FAMILY.assert_rejected("punctured disk", &p_values(&ring, subjects::disk));
}

#[test]
fn densities_that_are_slightly_off_are_rejected() {
    let disk = poly::Disk::new();
    let more = *MORE as f32;
    let peak = 1.0 - 0.1 * more;
    let clamped = |x| subjects::bump_density(x).min(peak);
    let clamped = Bounded::new(disk, clamped, peak * PI).unwrap();
    FAMILY.assert_rejected("a clamped peak", &p_values(&clamped, subjects::bump));
    let wrong = Bounded::new(WrongDisk, subjects::bump_density, PI).unwrap();
    FAMILY.assert_rejected("proposals r = u", &p_values(&wrong, subjects::bump));
    let line = Interval::new(0.0, PI).unwrap();
    let by = 0.03 * more;
    let raised = Bounded::new(line, |x: f32| by + x.sin(), (1.0 + by) * PI).unwrap();
    FAMILY.assert_rejected(
        "sin + 0.03 or more",
        &p_values(&raised, subjects::half_sine),
    );
    let coarse = Bounded::new(line, f32::sin, PI).unwrap();
    let bits = u32::MAX << speed::of("bits that the coarse coin lacks", 27, 26);
    let coarse = p_values(&CoarseCoin(coarse, bits), subjects::half_sine);
    FAMILY.assert_rejected("a coin of few bits", &coarse);
    // Dividing by c alone where c p is meant: as if f were f p.
    let lobe = poly::CosineHemisphere::new();
    let forgetful = move |n: [f32; 3]| n[2] * n[2] * lobe.pdf(n);
    let forgetful = Bounded::new(lobe, forgetful, 1.0).unwrap();
    let forgetful = p_values(&forgetful, subjects::squared_cosine);
    FAMILY.assert_rejected("the proposal's density forgotten", &forgetful);
}

/// The disk's own law is not that of 1/(1 + r²), and conversely.
#[test]
fn laws_are_told_apart() {
    let disk = DiskRejection::new();
    FAMILY.assert_rejected("disk for bump", &p_values(&disk, subjects::bump));
    let bump = Bounded::new(poly::Disk::new(), subjects::bump_density, PI).unwrap();
    FAMILY.assert_rejected("bump for disk", &p_values(&bump, subjects::disk));
}
