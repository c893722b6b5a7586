//! A warp of the integer tier as words in and words out, so that what judges it is compiled once for all formats and grades.

use fixed::types::extra::LeEqU32;
use fixed::{FixedI32, FixedU32};
use microwarp::fixed::Density;
use microwarp::{Error, Invert};

/// The uniforms or the numbers of a point, as their bits; those it does not have are 0.
pub type Words = [u32; 13];

pub trait Raw: Send + Sync {
    fn sample(&self, uniforms: &[u32]) -> Words;
    fn pdf(&self, point: &[u32]) -> Density;
    fn invert(&self, point: &[u32]) -> Words;
}

/// Erases the types of a warp.
pub fn raw<W>(warp: W) -> Box<dyn Raw>
where
    W: Invert<Density = Density> + Send + Sync + 'static,
    W::Uniforms: OfWords,
    W::Point: OfWords,
{
    Box::new(Wrapped(warp))
}

/// Likewise, where the constructor does not refuse.
pub fn accepted<W>(warp: Result<W, Error>) -> Option<Box<dyn Raw>>
where
    W: Invert<Density = Density> + Send + Sync + 'static,
    W::Uniforms: OfWords,
    W::Point: OfWords,
{
    warp.ok().map(raw)
}

struct Wrapped<W>(W);

impl<W> Raw for Wrapped<W>
where
    W: Invert<Density = Density> + Send + Sync,
    W::Uniforms: OfWords,
    W::Point: OfWords,
{
    fn sample(&self, uniforms: &[u32]) -> Words {
        self.0.sample(W::Uniforms::of(uniforms)).words()
    }
    fn pdf(&self, point: &[u32]) -> Density {
        self.0.pdf(W::Point::of(point))
    }
    fn invert(&self, point: &[u32]) -> Words {
        self.0.invert(W::Point::of(point)).words()
    }
}

/// What consists of numbers of 32 bits.
pub trait OfWords: Copy {
    const ZERO: Self;
    fn of(words: &[u32]) -> Self;
    fn words(self) -> Words;
}

fn alone(word: u32) -> Words {
    std::array::from_fn(|i| if i == 0 { word } else { 0 })
}

impl OfWords for u32 {
    const ZERO: Self = 0;
    fn of(words: &[u32]) -> Self {
        words[0]
    }
    fn words(self) -> Words {
        alone(self)
    }
}

impl OfWords for i32 {
    const ZERO: Self = 0;
    fn of(words: &[u32]) -> Self {
        words[0] as i32
    }
    fn words(self) -> Words {
        alone(self as u32)
    }
}

impl<Frac: LeEqU32> OfWords for FixedU32<Frac> {
    const ZERO: Self = Self::ZERO;
    fn of(words: &[u32]) -> Self {
        Self::from_bits(words[0])
    }
    fn words(self) -> Words {
        alone(self.to_bits())
    }
}

impl<Frac: LeEqU32> OfWords for FixedI32<Frac> {
    const ZERO: Self = Self::ZERO;
    fn of(words: &[u32]) -> Self {
        Self::from_bits(words[0] as i32)
    }
    fn words(self) -> Words {
        alone(self.to_bits() as u32)
    }
}

// By loops, since each call of `map` or `from_fn` is six functions to compile, of each type anew.
impl<T: OfWords, const N: usize> OfWords for [T; N] {
    const ZERO: Self = [T::ZERO; N];
    fn of(words: &[u32]) -> Self {
        let mut numbers = Self::ZERO;
        for (i, number) in numbers.iter_mut().enumerate() {
            *number = T::of(&words[i..]);
        }
        numbers
    }
    fn words(self) -> Words {
        let mut words = alone(0);
        for (i, number) in self.iter().enumerate() {
            words[i] = number.words()[0];
        }
        words
    }
}

/// Shares, and the rest after them.
impl<T: OfWords, const N: usize> OfWords for ([T; N], T) {
    const ZERO: Self = ([T::ZERO; N], T::ZERO);
    fn of(words: &[u32]) -> Self {
        (OfWords::of(words), T::of(&words[N..]))
    }
    fn words(self) -> Words {
        let mut words = self.0.words();
        words[N] = self.1.words()[0];
        words
    }
}

/// Numbers of a format from their bits.
pub fn of_bits<Frac: LeEqU32, const D: usize>(bits: &[i32]) -> [FixedI32<Frac>; D] {
    let mut numbers = [FixedI32::ZERO; D];
    for (i, number) in numbers.iter_mut().enumerate() {
        *number = FixedI32::from_bits(bits[i]);
    }
    numbers
}

/// Vertices likewise.
pub fn vertices_of_bits<Frac: LeEqU32, const D: usize>(
    [a, b, c]: &[[i32; D]; 3],
) -> [[FixedI32<Frac>; D]; 3] {
    [of_bits(a), of_bits(b), of_bits(c)]
}

/// The first numbers of a point, with a sign and in steps.
pub fn signed<const N: usize>(point: Words, step: f64) -> [f64; N] {
    std::array::from_fn(|i| f64::from(point[i] as i32) * step)
}
