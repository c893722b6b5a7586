//! Where the random words of a path come from.

use crate::path::NUMBERS;
use crate::picture::Plan;
use core::convert::Infallible;
use microwarp::uniform::{
    ByPosition, Cursor, FromFn, Permutation, Points, Screen, ScreenPixel, Sobol, Strata2d,
    grid_from_word,
};
use rand_core::{Rng, TryRng};
use rand_pcg::Pcg32;

/// The words of the paths of one pixel. Each decision of a path has a dimension of its own, so that sets of points can be
/// even in it.
pub trait Source: Rng {
    /// The words of a pixel, which is given by column and row, of a picture.
    fn of_pixel(plan: &Plan, pixel: [u32; 2]) -> Self;
    /// Goes on to a sample.
    fn begin(&mut self, sample: u32);
    /// The next word is that of this dimension.
    fn skip_to(&mut self, dimension: u32);
}

/// The two fallible methods and `bytes` of a source, handed to what it is made of.
macro_rules! words_of {
    ($field:tt) => {
        type Error = Infallible;

        #[inline]
        fn try_next_u32(&mut self) -> Result<u32, Infallible> {
            self.$field.try_next_u32()
        }

        #[inline]
        fn try_next_u64(&mut self) -> Result<u64, Infallible> {
            self.$field.try_next_u64()
        }

        #[inline]
        fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), Infallible> {
            self.$field.try_fill_bytes(bytes)
        }
    };
}

/// A generator for each pixel, which knows no dimensions.
#[derive(Clone, Debug)]
pub struct Random(Pcg32);

impl TryRng for Random {
    words_of!(0);
}

impl Source for Random {
    fn of_pixel(plan: &Plan, pixel: [u32; 2]) -> Self {
        // Neighbouring pixels get states and streams that are not neighbours.
        let word = |d| u64::from(ByPosition::of_pixel(plan, pixel).word(0, d));
        Self(Pcg32::new(word(0) << 32 | word(1), word(2) << 32 | word(3)))
    }

    #[inline]
    fn begin(&mut self, _: u32) {}

    #[inline]
    fn skip_to(&mut self, _: u32) {}
}

/// A set of points for each pixel.
#[derive(Clone, Copy, Debug)]
pub struct Set<P> {
    points: P,
    cursor: Cursor<P>,
}

/// Sets of points that a pixel can have.
pub trait OfPixel: Points {
    fn of_pixel(plan: &Plan, pixel: [u32; 2]) -> Self;
}

impl<P: Points> TryRng for Set<P> {
    words_of!(cursor);
}

impl<P: OfPixel> Source for Set<P> {
    fn of_pixel(plan: &Plan, pixel: [u32; 2]) -> Self {
        let points = P::of_pixel(plan, pixel);
        Self {
            points,
            cursor: points.at(0),
        }
    }

    #[inline]
    fn begin(&mut self, sample: u32) {
        self.cursor = self.points.at(sample);
    }

    #[inline]
    fn skip_to(&mut self, dimension: u32) {
        self.cursor = self.cursor.skip_to(dimension);
    }
}

impl OfPixel for ByPosition {
    #[inline]
    fn of_pixel(plan: &Plan, pixel: [u32; 2]) -> Self {
        Self::new(plan.seed, plan.index(pixel))
    }
}

/// Owen-scrambled Sobol' points in groups of eight dimensions.
pub type Owen = Sobol<8>;

impl OfPixel for Owen {
    fn of_pixel(plan: &Plan, pixel: [u32; 2]) -> Self {
        Self::new(ByPosition::of_pixel(plan, pixel).word(0, 0)).unwrap_or(FIRST)
    }
}

/// The points of one seed, checked by the compiler.
const FIRST: Owen = microwarp::constant!(Sobol::new(0));

/// One set of Sobol' points for all pixels, in an order by which the errors of neighbours cancel. The number of samples should be
/// a power of two.
pub type Shared = ScreenPixel<Owen>;

impl OfPixel for Shared {
    fn of_pixel(plan: &Plan, [column, row]: [u32; 2]) -> Self {
        let points = Owen::new(plan.seed).unwrap_or(FIRST);
        let size = plan.size.map(|n| n.clamp(1, 1 << 16));
        let bits = 32_u32.wrapping_sub(plan.samples.saturating_sub(1).leading_zeros());
        // Of more samples than the set has points for, some are of further sets.
        let screen = (0..=bits)
            .rev()
            .find_map(|bits| Screen::new(points, size, bits, plan.seed).ok());
        screen.unwrap_or(SCREEN).pixel(column, row)
    }
}

/// The largest picture's.
const SCREEN: Screen<Owen> = microwarp::constant!(Screen::new(FIRST, [1 << 16; 2], 0, 0));

/// Jittered strata in each pair of dimensions, as square as the number of samples allows. Each pair goes through its strata
/// in an order of its own, so that pairs are independent. Every stratum is met once.
#[derive(Clone, Copy, Debug)]
pub struct Strata {
    strata: Strata2d,
    jitter: ByPosition,
}

const ONE: Strata2d = microwarp::constant!(Strata2d::new(1, 1));

impl OfPixel for Strata {
    fn of_pixel(plan: &Plan, pixel: [u32; 2]) -> Self {
        let samples = plan.samples;
        // The divisor of the number next below its root.
        let divides = |d: &u32| samples.checked_rem(*d) == Some(0);
        let columns = (1..=samples.isqrt()).rev().find(divides).unwrap_or(1);
        let rows = samples.checked_div(columns).unwrap_or(1);
        Self {
            strata: Strata2d::new(columns, rows).unwrap_or(ONE),
            jitter: ByPosition::of_pixel(plan, pixel),
        }
    }
}

impl Points for Strata {
    #[inline]
    fn word(self, index: u32, dimension: u32) -> u32 {
        let pair = dimension >> 1;
        // A word of the jitter that no sample takes.
        let order = Permutation::new(self.strata.count(), self.jitter.word(u32::MAX, pair));
        let stratum = order.ok().and_then(|order| order.get(index));
        let mut jitter = self.jitter.at(index).skip_to(pair << 1);
        let [x, y] = self.strata.draw(stratum.unwrap_or(index), &mut jitter);
        word_of(if dimension & 1 == 0 { x } else { y })
    }
}

/// The middle of a step of the grid, as 32 bits.
#[inline]
fn word_of(u: f32) -> u32 {
    ((u * 16_777_216.0) as u32) << 8 | 0x80
}

/// The numbers of one path, from 0 to 1: what a chain in primary sample space moves. A pixel's own are those of
/// [`ByPosition`], cut to 24 bits.
#[derive(Clone, Copy, Debug)]
pub struct Numbers {
    path: [f32; NUMBERS],
    next: u32,
    points: ByPosition,
}

impl Numbers {
    pub const fn new(path: [f32; NUMBERS]) -> Self {
        Self {
            path,
            next: 0,
            points: ByPosition::new(0, 0),
        }
    }

    /// That of the middle of the whole interval beyond the last number.
    fn next_word(&mut self) -> u32 {
        let number = self.path.get(self.next as usize).copied().unwrap_or(0.5);
        self.next = self.next.wrapping_add(1);
        word_of(number)
    }
}

impl TryRng for Numbers {
    type Error = Infallible;

    #[inline]
    fn try_next_u32(&mut self) -> Result<u32, Infallible> {
        Ok(self.next_word())
    }

    #[inline]
    fn try_next_u64(&mut self) -> Result<u64, Infallible> {
        FromFn(|| self.next_word()).try_next_u64()
    }

    #[inline]
    fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), Infallible> {
        FromFn(|| self.next_word()).try_fill_bytes(bytes)
    }
}

impl Source for Numbers {
    fn of_pixel(plan: &Plan, pixel: [u32; 2]) -> Self {
        let points = ByPosition::of_pixel(plan, pixel);
        let path = [0.0; NUMBERS];
        Self {
            path,
            next: 0,
            points,
        }
    }

    fn begin(&mut self, sample: u32) {
        for (number, dimension) in self.path.iter_mut().zip(0..) {
            *number = grid_from_word(self.points.word(sample, dimension));
        }
        self.next = 0;
    }

    #[inline]
    fn skip_to(&mut self, dimension: u32) {
        self.next = dimension;
    }
}
