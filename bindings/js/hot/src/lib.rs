//! The loops that are compiled for speed: words of the generator, and the few warps and tables that fill arrays most often.
//! What other loops compute is the same, by smaller code.
#![no_std]

use core::any::TypeId;
use core::convert::Infallible;
use core::hint::black_box;
use microwarp::discrete::{Alias, AliasEntry, Cdf};
use microwarp::poly::{CosineHemisphere, Disk, Exponential, Normal, NormalPair, PhongLobe, Sphere};
use microwarp::{Warp, uniform};
use rand_core::TryRng;

/// Words drawn before, one after the other.
pub struct Words(*const u32);

impl Words {
    /// The words that lie from here on.
    ///
    /// # Safety
    /// No more words are taken than lie there.
    #[must_use]
    pub const unsafe fn new(words: *const u32) -> Self {
        Self(words)
    }
}

impl TryRng for Words {
    type Error = Infallible;

    #[inline]
    fn try_next_u32(&mut self) -> Result<u32, Infallible> {
        // SAFETY: as the caller of `new` says.
        let word = unsafe { self.0.read() };
        self.0 = self.0.wrapping_add(1);
        Ok(word)
    }

    fn try_next_u64(&mut self) -> Result<u64, Infallible> {
        uniform::FromFn(|| self.try_next_u32()).try_next_u64()
    }

    fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), Infallible> {
        uniform::FromFn(|| self.try_next_u32()).try_fill_bytes(bytes)
    }
}

/// The generator PCG32 (PCG XSH RR 64/32) by its two words of state, so that a caller can keep them.
pub struct Pcg32 {
    pub state: u64,
    pub increment: u64,
}

const FACTOR: u64 = 6_364_136_223_846_793_005;

impl Pcg32 {
    /// Of a seed and one of 2⁶³ streams, as the authors seed it.
    #[must_use]
    pub const fn new(seed: u64, stream: u64) -> Self {
        let increment = stream << 1 | 1;
        let state = seed.wrapping_add(increment);
        let mut this = Self { state, increment };
        this.step();
        this
    }

    const fn step(&mut self) {
        self.state = self.state.wrapping_mul(FACTOR).wrapping_add(self.increment);
    }

    const fn word(&self) -> u32 {
        let state = self.state;
        let mixed = (((state >> 18) ^ state) >> 27) as u32;
        mixed.rotate_right((state >> 59) as u32)
    }

    /// Draws words, in pairs of which neither waits for the other's product.
    #[inline(never)]
    pub fn fill(&mut self, words: &mut [u32]) {
        // In locals, so that the loop works in registers. Two steps in one are such a step too.
        let Self { state, increment } = *self;
        let (mut even, mut odd) = (Self { state, increment }, Self { state, increment });
        odd.step();
        let (factor, increment) = (
            FACTOR.wrapping_mul(FACTOR),
            FACTOR.wrapping_mul(increment).wrapping_add(increment),
        );
        let mut pairs = words.chunks_exact_mut(2);
        for pair in &mut pairs {
            if let [first, second] = pair {
                (*first, *second) = (even.word(), odd.word());
            }
            even.state = even.state.wrapping_mul(factor).wrapping_add(increment);
            odd.state = odd.state.wrapping_mul(factor).wrapping_add(increment);
        }
        if let [last] = pairs.into_remainder() {
            *last = even.word();
            even.step();
        }
        *self = even;
    }
}

/// Word by word, for what does not know how many it takes.
impl TryRng for Pcg32 {
    type Error = Infallible;

    #[inline(never)]
    fn try_next_u32(&mut self) -> Result<u32, Infallible> {
        let word = self.word();
        self.step();
        Ok(word)
    }

    fn try_next_u64(&mut self) -> Result<u64, Infallible> {
        uniform::FromFn(|| self.try_next_u32()).try_next_u64()
    }

    fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), Infallible> {
        uniform::FromFn(|| self.try_next_u32()).try_fill_bytes(bytes)
    }
}

/// A type that has a loop of its own, as that type.
fn same<A: 'static, B: 'static>(a: &A) -> Option<&B> {
    let same = TypeId::of::<A>() == TypeId::of::<B>();
    // SAFETY: the two types are one.
    same.then(|| unsafe { &*(&raw const *a).cast::<B>() })
}

/// How a loop computes its points. Not by functions: only in the function whose parameter the slice is does the compiler know
/// that nothing else lies there, and use vectors.
macro_rules! points {
    // One after the other, since all words are there: as fast as in blocks, and much smaller.
    (one_by_one, $warp:ident, $words:ident, $points:ident) => {
        // SAFETY: there is a word for each uniform of each point.
        let words = unsafe { core::slice::from_raw_parts($words.as_ptr().cast(), $points.len()) };
        for (point, &words) in $points.iter_mut().zip(words) {
            *point = $warp.sample_words(words);
        }
    };
    // As the warp fills a slice, for one whose blocks are computed in another way than a point.
    (in_blocks, $warp:ident, $words:ident, $points:ident) => {
        // SAFETY: there is a word for each uniform of each point.
        $warp.fill(&mut unsafe { Words::new($words.as_ptr()) }, $points);
    };
}

macro_rules! loops {
    ($($fill:ident: $warp:ident $per_point:literal $point:ty, $how:ident;)*) => {
        $(
            #[inline(never)]
            fn $fill(warp: &$warp, words: &[u32], points: &mut [$point]) {
                points!($how, warp, words, points);
            }
        )*

        /// Fills a slice by the loop of this type of warp; `false` where it has none.
        #[inline]
        pub fn fill<W: Warp + 'static>(warp: &W, words: &[u32], numbers: &mut [f32]) -> bool {
            $(
                if let Some(warp) = same::<W, $warp>(warp) {
                    // SAFETY: the point is an array of so many numbers, without padding.
                    let points = unsafe {
                        core::slice::from_raw_parts_mut(numbers.as_mut_ptr().cast(), numbers.len() / $per_point)
                    };
                    $fill(warp, words, points);
                    return true;
                }
            )*
            false
        }
    };
}

loops! {
    normal: Normal 1 f32, in_blocks;
    normal_pair: NormalPair 2 [f32; 2], one_by_one;
    exponential: Exponential 1 f32, one_by_one;
    disk: Disk 2 [f32; 2], one_by_one;
    sphere: Sphere 3 [f32; 3], one_by_one;
    cosine_hemisphere: CosineHemisphere 3 [f32; 3], one_by_one;
    phong_lobe: PhongLobe 3 [f32; 3], one_by_one;
}

/// Draws indices by cumulated weights.
#[inline(never)]
pub fn by_cdf(table: Cdf<&[u32]>, words: &[u32], indices: &mut [u32]) {
    for (index, &word) in indices.iter_mut().zip(words) {
        *index = table.index(word) as u32;
    }
}

/// Draws indices by bins, as [`Alias::index`] does. Which of the two indices of a bin is taken cannot be foretold, so it is
/// computed without a branch; the compiler must not know that the factor is 0 or 1, or it makes one.
#[inline(never)]
pub fn by_alias(table: Alias<&[AliasEntry<u32>]>, words: &[u32], indices: &mut [u32]) {
    let bins = table.as_bins();
    let bits = bins.len().trailing_zeros();
    for (index, &word) in indices.iter_mut().zip(words) {
        // In two steps, because a shift by all the bits would be none.
        let bin = (word >> 1).wrapping_shr(31_u32.wrapping_sub(bits));
        let Some(entry) = bins.get(bin as usize) else {
            continue;
        };
        let rest = word.wrapping_shl(bits).wrapping_shr(bits);
        let beyond = black_box(u32::from(rest >= entry.threshold()));
        *index = bin.wrapping_add(entry.alias().wrapping_sub(bin).wrapping_mul(beyond));
    }
}
