//! The choice of one of several parts by weight: a mixture whose parts only know which they are.

use crate::error::{Code, code};
use crate::warps::{as_declared, given};
use core::array::from_fn;
use core_crate::discrete::{Mixture, Parts};
use core_crate::uniform::{Canonical, Uniforms};
use core_crate::{Error, Warp};
use rand_core::TryRng;

/// So many parts at most; others have no weight.
const MOST: usize = 32;

/// `mw_chooser`
type Chooser = Mixture<Indices, MOST>;

const _: () = as_declared::<Chooser>(&["mw_chooser"]);

/// The point of each part is its index and the uniform that is left for it.
#[derive(Clone, Copy)]
struct Indices;

impl Parts<MOST> for Indices {
    type Uniforms = f32;
    type Point = (usize, f32);
    type Measure = ();

    #[inline]
    fn sample_by(&self, index: usize, u: Canonical<f32>) -> Self::Point {
        (index, u.get())
    }

    fn sample_words_by(&self, index: usize, word: u32) -> Self::Point {
        self.sample_by(index, f32::from_words(word))
    }

    fn sample_with_pdf_by(&self, index: usize, u: Canonical<f32>) -> (Self::Point, f32) {
        (self.sample_by(index, u), 0.0)
    }

    fn try_draw_by<R: TryRng + ?Sized>(
        &self,
        index: usize,
        rng: &mut R,
    ) -> Result<Self::Point, R::Error> {
        Ok(self.sample_words_by(index, rng.try_next_u32()?))
    }

    fn try_draw_with_pdf_by<R: TryRng + ?Sized>(
        &self,
        index: usize,
        rng: &mut R,
    ) -> Result<(Self::Point, f32), R::Error> {
        Ok((self.try_draw_by(index, rng)?, 0.0))
    }

    /// It has none: the caller has those of the parts.
    fn pdf_by(&self, _: usize, _: Self::Point) -> f32 {
        0.0
    }
}

#[unsafe(export_name = "mw_chooser_init")]
unsafe extern "C" fn init(chooser: *mut Chooser, weights: *const f32, parts: usize) -> Code {
    if parts == 0 {
        return Error::NoWeights.into();
    }
    if parts > MOST {
        return Error::TooManyWeights.into();
    }
    let mut all = [0.0; MOST];
    // SAFETY: the promise of the header.
    let weights = unsafe { given(weights, parts) };
    for (place, &weight) in all.iter_mut().zip(weights) {
        *place = weight;
    }
    // SAFETY: the promise of the header.
    code(Mixture::new(Indices, &all), |made| unsafe {
        chooser.write(made)
    })
}

#[unsafe(export_name = "mw_chooser_choose")]
extern "C" fn choose(chooser: &Chooser, word: u32, rest: &mut u32) -> usize {
    let (part, left) = chooser.choose(word);
    *rest = left;
    part
}

#[unsafe(export_name = "mw_chooser_choose_uniform")]
extern "C" fn choose_uniform(chooser: &Chooser, u: f32, rest: &mut f32) -> usize {
    let (part, left) = chooser.sample(u);
    *rest = left;
    part
}

#[unsafe(export_name = "mw_chooser_numerator")]
extern "C" fn numerator(chooser: &Chooser, part: usize) -> u64 {
    chooser.numerator(part)
}

#[unsafe(export_name = "mw_chooser_pmf")]
extern "C" fn pmf(chooser: &Chooser, part: usize) -> f32 {
    chooser.pmf(part)
}

#[unsafe(export_name = "mw_chooser_pdf")]
unsafe extern "C" fn pdf(chooser: &Chooser, densities: *const f32) -> f32 {
    chooser.pdf_of(from_fn(|part| {
        if chooser.pmf(part) > 0.0 {
            // SAFETY: the promise of the header: there is one of each part that has a weight.
            unsafe { densities.add(part).read() }
        } else {
            0.0
        }
    }))
}
