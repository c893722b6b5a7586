//! Draws a subject's points for a picture, or draws many and keeps none, for timing.

use crate::numbers::Numbers;
use crate::shared::{Refusal, Shared};
use crate::source::Words;
use microwarp::{Error, Warp};
use rand_core::Rng;
use rand_pcg::Pcg32;

/// Something that draws one point after another.
pub trait Draw {
    type Point: Numbers;

    /// Draws a point.
    fn draw<R: Rng>(&mut self, rng: &mut R) -> Result<Self::Point, Refusal>;

    /// The density that it reports at a point.
    fn density(&self, point: Self::Point) -> f64;

    /// Takes note of a point that was drawn for a picture; when only time counts, nobody does.
    fn watch(&mut self, _: Self::Point) {}

    /// What it reports after all points are drawn.
    fn report(&self, _: &mut [f64; 16]) {}
}

/// A warp draws its points.
pub struct Of<W>(W);

/// An accepted warp.
pub fn of<W>(warp: Result<W, Error>) -> Result<Of<W>, Error> {
    warp.map(Of)
}

impl<W> Draw for Of<W>
where
    W: Warp,
    W::Point: Numbers,
    W::Density: Numbers,
{
    type Point = W::Point;

    #[inline]
    fn draw<R: Rng>(&mut self, rng: &mut R) -> Result<W::Point, Refusal> {
        Ok(self.0.draw(rng))
    }

    fn density(&self, point: W::Point) -> f64 {
        let [density, ..] = self.0.pdf(point).wide();
        density
    }
}

/// Takes a subject whose type is known by now.
pub trait Visit {
    /// # Errors
    /// What the subject says when it draws.
    fn take<D: Draw>(&mut self, subject: D) -> Result<(), Refusal>;
}

/// Draws points into the shared memory.
pub struct Samples<'a> {
    words: Words,
    count: usize,
    points: &'a mut [[f64; 3]],
    densities: &'a mut [f64],
    used: &'a mut [[u32; 4]],
    report: &'a mut [f64; 16],
}

impl<'a> Samples<'a> {
    pub fn new(words: Words, count: u32, shared: &'a mut Shared) -> Self {
        Self {
            words,
            count: count as usize,
            points: &mut shared.points,
            densities: &mut shared.densities,
            used: &mut shared.words,
            report: &mut shared.report,
        }
    }
}

impl Visit for Samples<'_> {
    fn take<D: Draw>(&mut self, mut subject: D) -> Result<(), Refusal> {
        let places = self.points.iter_mut().zip(self.densities.iter_mut());
        let slots = places.zip(self.used.iter_mut());
        for ((place, density), words) in slots.take(self.count) {
            let point = subject.draw(&mut self.words)?;
            subject.watch(point);
            *place = point.wide();
            *density = subject.density(point);
            *words = self.words.last();
            self.words.advance();
        }
        subject.report(self.report);
        Ok(())
    }
}

/// Draws points from PCG32 and keeps nothing but a sum of their bits.
pub struct Timing {
    rng: Pcg32,
    count: u32,
    bits: u32,
}

impl Timing {
    pub fn new(count: u32, seed: u32) -> Self {
        Self {
            rng: Pcg32::new(seed.into(), 54),
            count,
            bits: 0,
        }
    }

    pub fn bits(&self) -> u32 {
        self.bits
    }
}

impl Visit for Timing {
    #[inline(never)]
    fn take<D: Draw>(&mut self, mut subject: D) -> Result<(), Refusal> {
        // In locals, so that the loop works in registers.
        let (mut rng, mut bits) = (self.rng.clone(), 0);
        for _ in 0..self.count {
            bits ^= subject.draw(&mut rng)?.bits();
        }
        self.bits = bits;
        Ok(())
    }
}

/// The exclusive or of so many words.
pub fn words(count: u32, seed: u32) -> u32 {
    let mut rng = Pcg32::new(seed.into(), 54);
    (0..count).fold(0, |bits, _| bits ^ rng.next_u32())
}
