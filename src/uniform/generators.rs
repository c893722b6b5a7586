//! Whatever yields words as a generator: closures, and the generators of older versions of `rand_core`.

use self::sealed::{Returned, Word};
use core::convert::Infallible;
use core::error::Error;
use rand_core::TryRng;

mod sealed {
    /// An integer of uniformly random bits.
    pub trait Word: Copy {
        fn bytes(self) -> impl Iterator<Item = u8>;

        fn try_u32<E>(next: impl FnMut() -> Result<Self, E>) -> Result<u32, E>;

        /// From two `u32`, the low half first.
        #[inline]
        fn try_u64<E>(mut next: impl FnMut() -> Result<Self, E>) -> Result<u64, E> {
            let low = Self::try_u32(&mut next)?;
            let high = Self::try_u32(next)?;
            Ok(u64::from(high) << 32 | u64::from(low))
        }
    }

    /// What a closure may return: a word, or the result of asking for one.
    pub trait Returned {
        type Word: Word;
        type Error: core::error::Error;
        fn result(self) -> Result<Self::Word, Self::Error>;
    }
}

impl Word for u8 {
    #[inline]
    fn bytes(self) -> impl Iterator<Item = u8> {
        core::iter::once(self)
    }

    #[inline]
    fn try_u32<E>(mut next: impl FnMut() -> Result<u8, E>) -> Result<u32, E> {
        Ok(u32::from_le_bytes([next()?, next()?, next()?, next()?]))
    }
}

impl Word for u32 {
    #[inline]
    fn bytes(self) -> impl Iterator<Item = u8> {
        self.to_le_bytes().into_iter()
    }

    #[inline]
    fn try_u32<E>(mut next: impl FnMut() -> Result<u32, E>) -> Result<u32, E> {
        next()
    }
}

impl Word for u64 {
    #[inline]
    fn bytes(self) -> impl Iterator<Item = u8> {
        self.to_le_bytes().into_iter()
    }

    #[inline]
    fn try_u32<E>(mut next: impl FnMut() -> Result<u64, E>) -> Result<u32, E> {
        Ok((next()? >> 32) as u32)
    }

    #[inline]
    fn try_u64<E>(mut next: impl FnMut() -> Result<u64, E>) -> Result<u64, E> {
        next()
    }
}

macro_rules! cannot_fail {
    ($($word:ty)*) => {$(
        impl Returned for $word {
            type Word = $word;
            type Error = Infallible;

            #[inline]
            fn result(self) -> Result<$word, Infallible> {
                Ok(self)
            }
        }
    )*};
}
cannot_fail!(u8 u32 u64);

impl<W: Word, E: Error> Returned for Result<W, E> {
    type Word = W;
    type Error = E;

    #[inline]
    fn result(self) -> Result<W, E> {
        self
    }
}

/// A closure as a generator.
///
/// The closure returns a `u32`, a `u64` or a `u8`, or a `Result` of one of these. A `u32` is taken as it is, from a `u64`
/// the upper half, and from bytes four, the lowest first.
///
/// # Examples
/// ```
/// use microwarp::{Warp, poly as mw, uniform::FromFn};
///
/// // A counter through a mixing function, here SplitMix64.
/// let mut count = 0_u64;
/// let mut rng = FromFn(|| {
///     count = count.wrapping_add(0x9e37_79b9_7f4a_7c15);
///     let z = (count ^ count >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
///     let z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
///     z ^ z >> 31
/// });
/// let point = mw::Disk::new().draw(&mut rng);
/// assert!(point[0].hypot(point[1]) <= 1.0);
///
/// // Words of a log, which ends.
/// let mut log = [0x4000_0000_u32, 0x8000_0000].into_iter();
/// let mut rng = FromFn(|| log.next().ok_or(core::fmt::Error));
/// assert!(mw::Disk::new().try_draw(&mut rng).is_ok());
/// assert!(mw::Disk::new().try_draw(&mut rng).is_err());
/// ```
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FromFn<F>(pub F);

impl<F: FnMut() -> T, T: Returned> TryRng for FromFn<F> {
    type Error = T::Error;

    #[inline]
    fn try_next_u32(&mut self) -> Result<u32, T::Error> {
        Word::try_u32(|| self.0().result())
    }

    #[inline]
    fn try_next_u64(&mut self) -> Result<u64, T::Error> {
        Word::try_u64(|| self.0().result())
    }

    #[inline]
    fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), T::Error> {
        for chunk in bytes.chunks_mut(size_of::<T::Word>()) {
            let word = self.0().result()?;
            chunk
                .iter_mut()
                .zip(word.bytes())
                .for_each(|(to, byte)| *to = byte);
        }
        Ok(())
    }
}

/// A generator of `rand_core` 0.6 as one of today's (feature `rand_core_06`).
///
/// It takes the generator or a `&mut` to it. Some generators of version 0.6 panic when they fail; [`TryRng06`] passes
/// the error on instead.
///
/// # Examples
/// ```
/// use microwarp::{Warp, poly as mw, uniform::Rng06};
/// # struct Trng;
/// # impl rand_core_06::RngCore for Trng {
/// #     fn next_u32(&mut self) -> u32 { 0x8000_0000 }
/// #     fn next_u64(&mut self) -> u64 { 0 }
/// #     fn fill_bytes(&mut self, bytes: &mut [u8]) { bytes.fill(0) }
/// #     fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), rand_core_06::Error> { Ok(bytes.fill(0)) }
/// # }
/// # let mut trng = Trng;
/// let point = mw::Disk::new().draw(&mut Rng06(&mut trng));
/// # assert!(point[0].hypot(point[1]) <= 1.0);
/// ```
#[cfg(feature = "rand_core_06")]
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Rng06<R>(pub R);

#[cfg(feature = "rand_core_06")]
impl<R: rand_core_06::RngCore> TryRng for Rng06<R> {
    type Error = Infallible;

    #[inline]
    fn try_next_u32(&mut self) -> Result<u32, Infallible> {
        Ok(self.0.next_u32())
    }

    #[inline]
    fn try_next_u64(&mut self) -> Result<u64, Infallible> {
        Ok(self.0.next_u64())
    }

    #[inline]
    fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), Infallible> {
        self.0.fill_bytes(bytes);
        Ok(())
    }
}

/// A generator of `rand_core` 0.6 that may fail (feature `rand_core_06`).
///
/// Its words come from `try_fill_bytes`, the only method of version 0.6 that returns an error.
#[cfg(feature = "rand_core_06")]
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TryRng06<R>(pub R);

#[cfg(feature = "rand_core_06")]
impl<R: rand_core_06::RngCore> TryRng for TryRng06<R> {
    type Error = Error06;

    #[inline]
    fn try_next_u32(&mut self) -> Result<u32, Error06> {
        let mut bytes = [0; 4];
        self.try_fill_bytes(&mut bytes)?;
        Ok(u32::from_le_bytes(bytes))
    }

    #[inline]
    fn try_next_u64(&mut self) -> Result<u64, Error06> {
        let mut bytes = [0; 8];
        self.try_fill_bytes(&mut bytes)?;
        Ok(u64::from_le_bytes(bytes))
    }

    #[inline]
    fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), Error06> {
        self.0.try_fill_bytes(bytes).map_err(Error06)
    }
}

/// The error of a [`TryRng06`]: that of `rand_core` 0.6, which without `std` does not implement [`Error`] itself.
#[cfg(feature = "rand_core_06")]
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Error06(#[cfg_attr(feature = "defmt", defmt(Debug2Format))] pub rand_core_06::Error);

#[cfg(feature = "rand_core_06")]
impl core::fmt::Display for Error06 {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        self.0.fmt(f)
    }
}

#[cfg(feature = "rand_core_06")]
impl Error for Error06 {}

/// A generator of `rand_core` 0.9 as one of today's (feature `rand_core_09`).
///
/// It takes the generator or a `&mut` to it. A generator that may fail (`TryRngCore`) passes its error on.
///
/// # Examples
/// ```
/// use microwarp::{Warp, poly as mw, uniform::Rng09};
/// # struct Oscillator;
/// # impl rand_core_09::RngCore for Oscillator {
/// #     fn next_u32(&mut self) -> u32 { 0x8000_0000 }
/// #     fn next_u64(&mut self) -> u64 { 0 }
/// #     fn fill_bytes(&mut self, bytes: &mut [u8]) { bytes.fill(0) }
/// # }
/// # let mut oscillator = Oscillator;
/// let point = mw::Disk::new().draw(&mut Rng09(&mut oscillator));
/// # assert!(point[0].hypot(point[1]) <= 1.0);
/// ```
#[cfg(feature = "rand_core_09")]
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Rng09<R>(pub R);

#[cfg(feature = "rand_core_09")]
impl<R: rand_core_09::TryRngCore<Error: Error>> TryRng for Rng09<R> {
    type Error = R::Error;

    #[inline]
    fn try_next_u32(&mut self) -> Result<u32, R::Error> {
        self.0.try_next_u32()
    }

    #[inline]
    fn try_next_u64(&mut self) -> Result<u64, R::Error> {
        self.0.try_next_u64()
    }

    #[inline]
    fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), R::Error> {
        self.0.try_fill_bytes(bytes)
    }
}
