//! Generators that count, fail, or are stuck: what the tests of draws are driven by.

use rand_core::TryRng;
use std::convert::Infallible;

/// Implements what is not asked of a generator here.
macro_rules! words_only {
    ($error:ty) => {
        fn try_next_u64(&mut self) -> Result<u64, $error> {
            unreachable!("draws are counted in u32")
        }
        fn try_fill_bytes(&mut self, _: &mut [u8]) -> Result<(), $error> {
            unreachable!("draws are counted in u32")
        }
    };
}

/// Counts the words it hands out.
pub struct Counting<R> {
    pub inner: R,
    pub words: u64,
}

impl<R> Counting<R> {
    pub fn new(inner: R) -> Self {
        Self { inner, words: 0 }
    }
}

impl<R: TryRng> TryRng for Counting<R> {
    type Error = R::Error;
    fn try_next_u32(&mut self) -> Result<u32, R::Error> {
        let word = self.inner.try_next_u32()?;
        self.words += 1;
        Ok(word)
    }
    words_only!(R::Error);
}

/// Yields some words again and again.
pub struct Cycle<'a> {
    words: &'a [u32],
    next: usize,
}

impl<'a> Cycle<'a> {
    pub fn new(words: &'a [u32]) -> Self {
        Self { words, next: 0 }
    }
}

impl TryRng for Cycle<'_> {
    type Error = Infallible;
    fn try_next_u32(&mut self) -> Result<u32, Infallible> {
        let word = self.words[self.next % self.words.len()];
        self.next += 1;
        Ok(word)
    }
    words_only!(Infallible);
}

/// Yields one word some times, then fails for ever.
pub struct Failing {
    pub word: u32,
    pub left: u64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Broken(pub u32);

impl std::fmt::Display for Broken {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "broken {}", self.0)
    }
}

impl std::error::Error for Broken {}

impl TryRng for Failing {
    type Error = Broken;
    fn try_next_u32(&mut self) -> Result<u32, Broken> {
        if self.left == 0 {
            return Err(Broken(17));
        }
        self.left -= 1;
        Ok(self.word)
    }
    words_only!(Broken);
}
