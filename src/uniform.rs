//! Uniforms in [0, 1), integers of a range, coins and orders: how they are drawn; the rule that brings any `f32` into range,
//! jittered strata, and points.
//!
//! ```
//! use microwarp::{constant, uniform};
//! use microwarp::uniform::{Chance, Range};
//! use rand_pcg::Pcg32;
//!
//! let mut rng = Pcg32::new(42, 54);
//! let index = Range::below(10)?.draw(&mut rng);              // 0 to 9; an empty range is an error
//! let face = 1 + uniform::up_to(5, &mut rng);                // 1 to 6, without an error to handle
//! let lost = constant!(Chance::new(0.1)).draw(&mut rng);     // true once in ten times
//! let u = uniform::grid(&mut rng);                           // a number in [0, 1)
//! # assert!(index < 10 && (1..=6).contains(&face) && (0.0..1.0).contains(&u));
//! # let _ = lost;
//! # Ok::<(), microwarp::Error>(())
//! ```
//!
//! [`Range`] and [`Chance`] are exact: they say how many of the 2³² words give each outcome. One word decides, whatever it is.
//!
//! A [`Warp`](crate::Warp) draws its own uniforms. Take these functions for uniforms that go elsewhere, or that
//! you change first.
//!
//! | function | values | smallest | largest | words (`u32`) a number |
//! |---|---|---|---|---|
//! | [`grid`] | k·2⁻²⁴, equally likely | 0 | 1 − 2⁻²⁴ | 1 |
//! | [`open`] | (k + ½)·2⁻²³, equally likely | 2⁻²⁴ | 1 − 2⁻²⁴ | 1 |
//! | [`deep_from_word`] | (k + ½)·2⁻²³; (k + ½)·2⁻³² below 2⁻⁹ | 2⁻³³ | 1 − 2⁻²⁴ | 1 |
//! | [`full`] | every `f32` a 64-bit fraction truncates to | 0, then 2⁻⁶⁴ | 1 − 2⁻²⁴ | 2 |
//!
//! A uniform of the integer tier is the word itself, as a number of 32 fractional bits.
//!
//! Whatever takes a generator also takes a point of a set ([`Points`]), whose words are a function of indices:
//!
//! | set | errors of N points fall as | best for | table |
//! |---|---|---|--:|
//! | [`Sobol`] | N^−1.45 where the integrand is smooth, N^−0.75 at edges | 2ᵐ points, up to 8 dimensions | 0 or 768 bytes |
//! | [`Recurrence`] | N^−0.9, N^−0.75 | any N, 1 to 3 dimensions, the cheapest | 0 |
//! | [`LatinHypercube`] | N^−1.5 where coordinates act apart, N^−0.5 | few points in many dimensions, N known | 0 |
//! | [`ByPosition`] | N^−0.5 | random numbers without a state, any dimensions | 0 |
//!
//! [`Screen`] orders a set over the pixels of a picture, so that the errors of neighbours cancel.
//!
//! Orders and choices, in integers, by a number of words that depends on the numbers of items alone:
//!
//! | | what | words |
//! |---|---|---|
//! | [`shuffle`] | items in a random order | 2 for 12 items, 16 for 52, 612 for 1,000 |
//! | [`shuffle_each`] | the same, in fewer instructions | one less than items |
//! | [`choose`] | k of n items, in random order | k |
//! | [`ChoiceInOrder`] | k of n items, where they are | n |
//! | [`ChoiceOfStream`] | k items of a stream of any length | one an item |
//! | [`Permutation`] | the numbers below n in the order of a seed, one by one, and back | none |
//!
//! # Many generators
//! Generators of neighbouring seeds or streams may yield words that depend on each other, and those of PCG32 do. Seed them from
//! [`ByPosition`], whose numbers may be neighbours: of threads, pixels, particles, frames.
//! ```
//! use microwarp::uniform::{ByPosition, Points};
//! use rand_pcg::{Pcg32, rand_core::SeedableRng};
//!
//! let of = |index| Pcg32::from_rng(&mut ByPosition::new(42, index).at(0));
//! let mut threads = [0, 1, 2, 3].map(of);
//! # use rand_pcg::rand_core::Rng;
//! # assert_eq!(threads[1].next_u32(), 0x998a_9383);
//! ```
//! `mw_pcg32_init_at` in C and `Pcg32.at` in JavaScript make the same generators.

mod chance;
mod choice;
mod first;
mod generators;
mod order;
mod permutation;
mod points;
mod range;
mod strata;
mod stream;

pub use self::chance::Chance;
pub use self::choice::{ChoiceInOrder, choose, choose_with, try_choose, try_choose_with};
pub(crate) use self::first::{First, Led};
pub use self::generators::FromFn;
#[cfg(feature = "rand_core_09")]
pub use self::generators::Rng09;
#[cfg(feature = "rand_core_06")]
pub use self::generators::{Error06, Rng06, TryRng06};
pub use self::order::{
    shuffle, shuffle_each, shuffle_with, try_shuffle, try_shuffle_each, try_shuffle_with,
};
pub use self::permutation::Permutation;
pub use self::points::{
    ByPosition, Cursor, LatinHypercube, MAX_DIMENSIONS, Points, Recurrence, Screen, ScreenPixel,
    Sobol,
};
pub use self::range::{Range, try_up_to, up_to, up_to_from_word};
pub use self::strata::{MAX_STRATA, Strata1d, Strata2d};
pub use self::stream::ChoiceOfStream;
pub use crate::num::{LARGEST, SMALLEST};

use crate::num::into_unit;
use core::convert::Infallible;
use rand_core::{Rng, TryRng};

/// The spacing of the 24-bit grid, 2⁻²⁴.
const STEP: f32 = f32::EPSILON / 2.0;

/// Uniforms that are known to lie in [0, 1).
///
/// [`Uniforms::canonical`] makes them from any `f32`. [`Uniforms::try_draw`] draws them from a generator, without a check.
/// A warp of your own gets them in [`Warp::sample_canonical`](crate::Warp::sample_canonical).
///
/// ```
/// use microwarp::uniform::Uniforms;
/// assert_eq!(0.25.canonical().get(), 0.25);
/// assert_eq!((-7.0).canonical().get(), 0.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Canonical<U>(U);

impl<U: Copy> Canonical<U> {
    /// The uniforms themselves.
    #[must_use]
    #[inline]
    pub const fn get(self) -> U {
        self.0
    }
}

impl<U: Copy, const N: usize> Canonical<[U; N]> {
    /// The uniforms one by one, each still known to lie in [0, 1).
    #[must_use]
    #[inline]
    pub fn each(self) -> [Canonical<U>; N] {
        self.0.map(Canonical)
    }
}

impl<A: Copy, B: Copy> Canonical<(A, B)> {
    /// The uniforms of either half, each still known to lie in [0, 1).
    #[must_use]
    #[inline]
    pub const fn split(self) -> (Canonical<A>, Canonical<B>) {
        let (a, b) = self.0;
        (Canonical(a), Canonical(b))
    }
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for f32 {}
    #[cfg(feature = "fixed")]
    impl Sealed for fixed::types::U0F32 {}
    impl<U: Sealed, const N: usize> Sealed for [U; N] {}
    impl<A: Sealed, B: Sealed> Sealed for (A, B) {}
}

/// The uniforms of one sample: an `f32`, in the integer tier a `U0F32`; an array of uniforms, or a pair.
///
/// The trait is sealed. The type [`Warp::Uniforms`](crate::Warp::Uniforms) says how many uniforms a warp takes.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be the uniforms of a warp",
    note = "uniforms are an `f32`, an array such as `[f32; N]`, or a pair; with feature `fixed` also a `U0F32` in place of an `f32`"
)]
pub trait Uniforms: sealed::Sealed + Copy {
    /// The number of uniforms.
    const COUNT: usize;

    /// The words they are drawn from, one `u32` for each number.
    type Words: Copy;

    /// Words that are all 0.
    const ZERO_WORDS: Self::Words;

    /// Brings every number into [0, 1): NaN and numbers below 0 become 0, numbers from 1 up become [`LARGEST`].
    ///
    /// ```
    /// use microwarp::uniform::{LARGEST, Uniforms};
    /// assert_eq!([f32::NAN, 7.0].canonical().get(), [0.0, LARGEST]);
    /// ```
    #[must_use]
    fn canonical(self) -> Canonical<Self>;

    /// Draws the words of these uniforms, in order.
    ///
    /// # Errors
    /// The generator's own error. Words drawn before it failed are lost.
    fn try_words<R: TryRng + ?Sized>(rng: &mut R) -> Result<Self::Words, R::Error>;

    /// The uniforms of these words: by [`grid_from_word`], or in the integer tier the words themselves.
    fn from_words(words: Self::Words) -> Canonical<Self>;

    /// Draws these uniforms from the 24-bit [`grid`], one `u32` for each, in order.
    ///
    /// # Errors
    /// The generator's own error. Numbers drawn before it failed are lost.
    #[inline]
    fn try_draw<R: TryRng + ?Sized>(rng: &mut R) -> Result<Canonical<Self>, R::Error> {
        Self::try_words(rng).map(Self::from_words)
    }
}

impl Uniforms for f32 {
    const COUNT: usize = 1;
    type Words = u32;
    const ZERO_WORDS: u32 = 0;

    #[inline]
    fn canonical(self) -> Canonical<Self> {
        Canonical(into_unit(self))
    }

    #[inline]
    fn try_words<R: TryRng + ?Sized>(rng: &mut R) -> Result<u32, R::Error> {
        rng.try_next_u32()
    }

    #[inline]
    fn from_words(word: u32) -> Canonical<Self> {
        Canonical(grid_from_word(word))
    }
}

/// Each of the 2³² words is a uniform k·2⁻³² in [0, 1), so that none is out of range.
#[cfg(feature = "fixed")]
impl Uniforms for fixed::types::U0F32 {
    const COUNT: usize = 1;
    type Words = u32;
    const ZERO_WORDS: u32 = 0;

    #[inline]
    fn canonical(self) -> Canonical<Self> {
        Canonical(self)
    }

    #[inline]
    fn try_words<R: TryRng + ?Sized>(rng: &mut R) -> Result<u32, R::Error> {
        rng.try_next_u32()
    }

    #[inline]
    fn from_words(word: u32) -> Canonical<Self> {
        Canonical(Self::from_bits(word))
    }
}

impl<U: Uniforms, const N: usize> Uniforms for [U; N] {
    const COUNT: usize = N.wrapping_mul(U::COUNT);
    type Words = [U::Words; N];
    const ZERO_WORDS: [U::Words; N] = [U::ZERO_WORDS; N];

    #[inline]
    fn canonical(self) -> Canonical<Self> {
        Canonical(self.map(|u| u.canonical().get()))
    }

    #[inline]
    fn try_words<R: TryRng + ?Sized>(rng: &mut R) -> Result<[U::Words; N], R::Error> {
        let mut words = Self::ZERO_WORDS;
        for word in &mut words {
            *word = U::try_words(rng)?;
        }
        Ok(words)
    }

    #[inline]
    fn from_words(words: [U::Words; N]) -> Canonical<Self> {
        Canonical(words.map(|word| U::from_words(word).get()))
    }
}

impl<A: Uniforms, B: Uniforms> Uniforms for (A, B) {
    const COUNT: usize = A::COUNT.wrapping_add(B::COUNT);
    type Words = (A::Words, B::Words);
    const ZERO_WORDS: (A::Words, B::Words) = (A::ZERO_WORDS, B::ZERO_WORDS);

    #[inline]
    fn canonical(self) -> Canonical<Self> {
        let (a, b) = self;
        Canonical((a.canonical().get(), b.canonical().get()))
    }

    #[inline]
    fn try_words<R: TryRng + ?Sized>(rng: &mut R) -> Result<Self::Words, R::Error> {
        Ok((A::try_words(rng)?, B::try_words(rng)?))
    }

    #[inline]
    fn from_words((a, b): Self::Words) -> Canonical<Self> {
        Canonical((A::from_words(a).get(), B::from_words(b).get()))
    }
}

/// Unwraps the result of a generator that cannot fail.
#[inline]
pub(crate) fn infallible<T>(result: Result<T, Infallible>) -> T {
    match result {
        Ok(value) => value,
        Err(never) => match never {},
    }
}

/// The upper 24 bits of a word as a multiple of 2⁻²⁴ in [0, 1).
///
/// Exactly 256 words give each of the 2²⁴ values. Nothing is rounded.
///
/// ```
/// use microwarp::uniform;
/// assert_eq!(uniform::grid_from_word(0), 0.0);
/// assert_eq!(uniform::grid_from_word(u32::MAX), uniform::LARGEST);
/// ```
#[must_use]
#[inline]
pub const fn grid_from_word(word: u32) -> f32 {
    (word >> 8) as f32 * STEP
}

/// The upper 23 bits of a word as the middle of one of 2²³ equal cells: in [2⁻²⁴, 1 − 2⁻²⁴].
///
/// Exactly 512 words give each of the 2²³ values. Nothing is rounded.
///
/// ```
/// use microwarp::uniform;
/// assert_eq!(uniform::open_from_word(0), 2.0_f32.powi(-24));
/// assert_eq!(uniform::open_from_word(u32::MAX), uniform::LARGEST);
/// ```
#[must_use]
#[inline]
pub const fn open_from_word(word: u32) -> f32 {
    // The low bit is the half step; 24 significant bits fit an f32 exactly.
    (((word >> 9) << 1) | 1) as f32 * STEP
}

/// The word as the middle of its cell: of the cells of [`open_from_word`], and below 2⁻⁹ of the cell of the single word.
///
/// The end at 0 is open and as fine as 32 bits allow, at the cost of the ordinary grid. With this uniform a tail that
/// starts at 0 has the right moments.
///
/// ```
/// use microwarp::uniform;
/// assert_eq!(uniform::deep_from_word(0), 2.0_f32.powi(-33));
/// assert_eq!(uniform::deep_from_word(1), 3.0 * 2.0_f32.powi(-33));
/// assert_eq!(uniform::deep_from_word(u32::MAX), uniform::LARGEST);
/// ```
#[must_use]
#[inline]
pub const fn deep_from_word(word: u32) -> f32 {
    // The low bit is the half step, and 24 significant bits fit an f32 exactly.
    let (place, unit) = if word < 1 << 23 {
        (word, 1.0 / 512.0)
    } else {
        (word >> 9, 1.0)
    };
    if cfg!(target_arch = "x86_64") {
        // Exactly the same. A conversion there waits for what its register held, often the draw before.
        (f32::from_bits(1.0_f32.to_bits() | place) - LARGEST) * unit
    } else {
        ((place << 1) | 1) as f32 * (STEP * unit)
    }
}

/// [`deep_from_word`], as a canonical uniform.
#[inline]
pub(crate) const fn deep(word: u32) -> Canonical<f32> {
    Canonical(deep_from_word(word))
}

/// A 64-bit fraction, truncated to the nearest `f32` below: small values keep their precision.
///
/// `high` holds the leading 32 bits. Every value from 2⁻⁴⁰ up has 24 significant bits. The smallest value above 0 is 2⁻⁶⁴,
/// and one pair of words in 2⁶⁴ gives 0.
///
/// ```
/// use microwarp::uniform;
/// assert_eq!(uniform::full_from_words(0, 1), 2.0_f32.powi(-64));
/// assert_eq!(uniform::full_from_words(u32::MAX, u32::MAX), uniform::LARGEST);
/// ```
#[must_use]
#[inline]
pub const fn full_from_words(high: u32, low: u32) -> f32 {
    // Built from bits: a conversion could round up to 1.0, and is a call on soft float.
    let zeros = high.leading_zeros();
    let (window, zeros) = if zeros < 32 {
        // `low >> 1 >> (31 - zeros)` is `low >> (32 - zeros)` without the shift by 32.
        let below = (low >> 1).wrapping_shr(31_u32.wrapping_sub(zeros));
        (high.wrapping_shl(zeros) | below, zeros)
    } else {
        let more = low.leading_zeros();
        if more == 32 {
            return 0.0;
        }
        (low.wrapping_shl(more), more.wrapping_add(32))
    };
    // `window` has its leading bit set and stands for window · 2^-(32 + zeros).
    let exponent = 126_u32.wrapping_sub(zeros);
    f32::from_bits((exponent << 23) | ((window >> 8) & 0x007f_ffff))
}

/// Draws one number of the 24-bit grid in [0, 1) from a generator that can fail. One word.
///
/// # Errors
/// The generator's own error.
#[inline]
pub fn try_grid<R: TryRng + ?Sized>(rng: &mut R) -> Result<f32, R::Error> {
    rng.try_next_u32().map(grid_from_word)
}

/// Draws one number of the 24-bit grid in [0, 1). One word.
///
/// ```
/// use microwarp::uniform;
/// use rand_pcg::Pcg32;
/// let u = uniform::grid(&mut Pcg32::new(1, 1));
/// assert!((0.0..1.0).contains(&u));
/// ```
#[inline]
pub fn grid<R: Rng + ?Sized>(rng: &mut R) -> f32 {
    infallible(try_grid(rng))
}

/// Draws one number of the open interval (0, 1) from a generator that can fail. One word.
///
/// # Errors
/// The generator's own error.
#[inline]
pub fn try_open<R: TryRng + ?Sized>(rng: &mut R) -> Result<f32, R::Error> {
    rng.try_next_u32().map(open_from_word)
}

/// Draws one number of the open interval (0, 1). One word.
///
/// ```
/// use microwarp::uniform;
/// use rand_pcg::Pcg32;
/// let u = uniform::open(&mut Pcg32::new(1, 1));
/// assert!(u > 0.0 && u < 1.0);
/// ```
#[inline]
pub fn open<R: Rng + ?Sized>(rng: &mut R) -> f32 {
    infallible(try_open(rng))
}

/// Draws one full-resolution number in [0, 1) from a generator that can fail. Two words, the leading one first.
///
/// # Errors
/// The generator's own error.
#[inline]
pub fn try_full<R: TryRng + ?Sized>(rng: &mut R) -> Result<f32, R::Error> {
    let high = rng.try_next_u32()?;
    let low = rng.try_next_u32()?;
    Ok(full_from_words(high, low))
}

/// Draws one full-resolution number in [0, 1). Two words, the leading one first.
///
/// `-ln` of it reaches 44.36, where the 24-bit grid ends at 16.64.
///
/// ```
/// use microwarp::uniform;
/// use rand_pcg::Pcg32;
/// let u = uniform::full(&mut Pcg32::new(1, 1));
/// assert!((0.0..1.0).contains(&u));
/// ```
#[inline]
pub fn full<R: Rng + ?Sized>(rng: &mut R) -> f32 {
    infallible(try_full(rng))
}

/// [`full_from_words`] as a canonical uniform, where 0 counts as the middle of its cell, 2⁻⁶⁵.
#[inline]
pub(crate) const fn open_full(high: u32, low: u32) -> Canonical<f32> {
    let u = full_from_words(high, low);
    Canonical(if u > 0.0 {
        u
    } else {
        STEP * STEP * (STEP * 128.0)
    })
}
