//! Rejection samplers. Each reports how many tries its points took.

use crate::numbers::Numbers;
use crate::run::Draw;
use crate::shared::Refusal;
use crate::subject::subjects;
use microwarp::fixed as integers;
use microwarp::rejection::{BallRejection, Bounded, DiskRejection, Region, Rejection};
use microwarp::tier::Tier;
use microwarp::warp::Disk;
use microwarp::{Error, warp::Aabb};
use rand_core::Rng;

subjects! {
    PLAIN plain[] "rejection" "exact":
    DiskRejection: plane 2: DiskRejection(budget_in_tries: 32 in 0..128 by 1)
        => DiskRejection::new().with_budget(budget_in_tries as u32)
            .map(|disk| Tried::new(disk, move |point| disk.pdf(point).into())),
    BallRejection: sphere 3: BallRejection(budget_in_tries: 64 in 0..128 by 1)
        => BallRejection::new().with_budget(budget_in_tries as u32)
            .map(|ball| Tried::new(ball, move |point| ball.pdf(point).into())),
    DiskRejection: plane 2: IntegerDiskRejection(budget_in_tries: 32 in 0..128 by 1)
        => integers::DiskRejection::new().with_budget(budget_in_tries as u32)
            .map(|disk| Tried::new(disk, move |point| only(disk.pdf(point)))),
    DiskRejection16: plane 1: IntegerDiskRejection16(budget_in_tries: 32 in 0..128 by 1)
        => integers::DiskRejection16::new().with_budget(budget_in_tries as u32)
            .map(|disk| Tried::new(disk, move |point| only(disk.pdf(point)))),
    // What a region's density is without its normalisation: that of the box.
    Region: plane 2: Region(inner_radius: 0.5 in 0..1, outer_radius: 1 in 0..1.4, budget_in_tries: 100 in 0..128 by 1)
        => ring(inner_radius, outer_radius, budget_in_tries as u32).map(|ring| Tried::new(ring, |_| 0.25)),
}

subjects! {
    TIERED tiered[T: Tier,] "rejection" "libm poly":
    Bounded: plane 3: Bounded(sharpness: 8 in 0..50 by 0.1, bound: 3.15 in 0..10, budget_in_tries: 100 in 0..128 by 1)
        => {
            // f = 1/(1 + s(x² + y²)) over points of the disk, with a bound on f/p and a budget.
            let density = move |[x, y]: [f32; 2]| 1.0 / (1.0 + sharpness * (x * x + y * y));
            Bounded::new(Disk::<T>::new(), density, bound).and_then(|sampler| sampler.with_budget(budget_in_tries as u32))
                .map(|bump| Tried::new(bump, move |point| density(point).into()))
        },
}

/// Between two radii, in a square.
fn ring(
    inner: f32,
    outer: f32,
    budget: u32,
) -> Result<Region<Aabb<2>, impl Fn([f32; 2]) -> bool>, Error> {
    let ring = move |[x, y]: [f32; 2]| {
        let square = x * x + y * y;
        inner * inner <= square && square <= outer * outer
    };
    Region::new(Aabb::new([-1.0; 2], [1.0; 2])?, ring).with_budget(budget)
}

fn only(number: impl Numbers) -> f64 {
    let [number, ..] = number.wide();
    number
}

/// A rejection sampler that counts.
struct Tried<S, D> {
    sampler: S,
    density: D,
    accepted: f64,
    tries: f64,
}

impl<S, D> Tried<S, D> {
    fn new(sampler: S, density: D) -> Self {
        Self {
            sampler,
            density,
            accepted: 0.0,
            tries: 0.0,
        }
    }
}

impl<S, D> Draw for Tried<S, D>
where
    S: Rejection,
    S::Point: Numbers,
    D: Fn(S::Point) -> f64,
{
    type Point = S::Point;

    #[inline]
    fn draw<R: Rng>(&mut self, rng: &mut R) -> Result<S::Point, Refusal> {
        let accepted = self.sampler.draw(rng)?;
        self.accepted += 1.0;
        self.tries += f64::from(accepted.tries);
        Ok(accepted.point)
    }

    fn density(&self, point: S::Point) -> f64 {
        (self.density)(point)
    }

    /// The points accepted, and the tries they took.
    fn report(&self, report: &mut [f64; 16]) {
        let [accepted, tries, ..] = report;
        (*accepted, *tries) = (self.accepted, self.tries);
    }
}
