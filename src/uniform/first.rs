//! The first number of uniforms, by which something is chosen before the rest of it and the others are used.

use super::{Canonical, FromFn, Uniforms};
use crate::num::into_unit;
use rand_core::TryRng;

/// Uniforms of `f32`, whose first number is found.
pub trait First: Uniforms {
    /// The first number; none where there is no number.
    fn first(&mut self) -> Option<&mut f32>;
    /// The word of the first number.
    fn first_word(words: &mut Self::Words) -> Option<&mut u32>;
}

impl First for f32 {
    #[inline]
    fn first(&mut self) -> Option<&mut f32> {
        Some(self)
    }

    #[inline]
    fn first_word(word: &mut u32) -> Option<&mut u32> {
        Some(word)
    }
}

impl<U: First, const N: usize> First for [U; N] {
    #[inline]
    fn first(&mut self) -> Option<&mut f32> {
        self.first_mut().and_then(U::first)
    }

    #[inline]
    fn first_word(words: &mut [U::Words; N]) -> Option<&mut u32> {
        words.first_mut().and_then(U::first_word)
    }
}

impl<A: First, B: First> First for (A, B) {
    #[inline]
    fn first(&mut self) -> Option<&mut f32> {
        let (a, b) = self;
        a.first().or_else(|| b.first())
    }

    #[inline]
    fn first_word((a, b): &mut Self::Words) -> Option<&mut u32> {
        A::first_word(a).or_else(|| B::first_word(b))
    }
}

impl<U: First> Canonical<U> {
    /// The same uniforms with another first number, brought into [0, 1).
    #[inline]
    pub(crate) fn with_first(self, number: f32) -> Self {
        let Self(mut uniforms) = self;
        if let Some(first) = uniforms.first() {
            *first = into_unit(number);
        }
        Self(uniforms)
    }
}

/// A generator whose next word is already known.
pub(crate) struct Led<'a, R: ?Sized> {
    word: Option<u32>,
    then: &'a mut R,
}

impl<'a, R: TryRng + ?Sized> Led<'a, R> {
    /// The word, and those of a generator.
    #[inline]
    pub(crate) const fn new(word: u32, then: &'a mut R) -> Self {
        let word = Some(word);
        Self { word, then }
    }

    #[inline]
    fn next_word(&mut self) -> Result<u32, R::Error> {
        match self.word.take() {
            Some(word) => Ok(word),
            None => self.then.try_next_u32(),
        }
    }
}

impl<R: TryRng + ?Sized> TryRng for Led<'_, R> {
    type Error = R::Error;

    #[inline]
    fn try_next_u32(&mut self) -> Result<u32, R::Error> {
        self.next_word()
    }

    #[inline]
    fn try_next_u64(&mut self) -> Result<u64, R::Error> {
        FromFn(|| self.next_word()).try_next_u64()
    }

    #[inline]
    fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), R::Error> {
        FromFn(|| self.next_word()).try_fill_bytes(bytes)
    }
}
