//! Rejection samplers. Each reports how many tries its points took.

use crate::numbers::Numbers;
use crate::run::{Draw, Visit};
use crate::shared::Refusal;
use crate::subject::{Parameters, Subject};
use microwarp::Aabb;
use microwarp::fixed as integers;
use microwarp::rejection::{BallRejection, Bounded, DiskRejection, Region, Rejection};
use microwarp::tier::Tier;
use microwarp::warp::Disk;
use rand_core::Rng;

/// Builds a subject and hands it on.
pub fn visit<V: Visit>(subject: Subject, p: &Parameters, v: &mut V) -> Result<(), Refusal> {
    let &[inner, outer, budget, ..] = p;
    match subject {
        Subject::DiskRejection => {
            let disk = DiskRejection::with_budget(inner as u32)?;
            v.take(Tried::new(disk, |point| disk.pdf(point).into()))
        }
        Subject::BallRejection => {
            let ball = BallRejection::with_budget(inner as u32)?;
            v.take(Tried::new(ball, |point| ball.pdf(point).into()))
        }
        Subject::IntegerDiskRejection => {
            let disk = integers::DiskRejection::with_budget(inner as u32)?;
            v.take(Tried::new(disk, |point| only(disk.pdf(point))))
        }
        Subject::IntegerDiskRejection16 => {
            let disk = integers::DiskRejection16::with_budget(inner as u32)?;
            v.take(Tried::new(disk, |point| only(disk.pdf(point))))
        }
        Subject::Region => {
            let square = Aabb::new([-1.0; 2], [1.0; 2])?;
            let ring = move |[x, y]: [f32; 2]| {
                let square = x * x + y * y;
                inner * inner <= square && square <= outer * outer
            };
            // What a region's density is without its normalisation: that of the box.
            let region = Region::new(square, ring, budget as u32)?;
            v.take(Tried::new(region, |_| 0.25))
        }
        _ => Err(Refusal::Unknown),
    }
}

/// f = 1/(1 + s(x² + y²)) over points of the disk, with a bound on f/p and a budget.
pub fn bump<T: Tier, V: Visit>(p: &Parameters, v: &mut V) -> Result<(), Refusal> {
    let &[sharpness, bound, budget, ..] = p;
    let density = move |[x, y]: [f32; 2]| 1.0 / (1.0 + sharpness * (x * x + y * y));
    let bumped = Bounded::new(Disk::<T>::new(), density, bound, budget as u32)?;
    v.take(Tried::new(bumped, move |point| density(point).into()))
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
