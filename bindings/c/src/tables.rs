//! Tables of weights in memory of the caller: the CDF and the alias table. A handle is a pointer and a count.

use crate::error::{Code, code};
use crate::generators::{Pcg32, Source, forget_registers};
use crate::warps::{given, memory};
use core_crate::Error;
use core_crate::discrete::{self, Alias, AliasEntry, Cdf};

/// `mw_selection`
#[repr(C)]
#[derive(Default)]
pub struct Selection {
    index: usize,
    pmf: f32,
    leftover: f32,
    leftover_bits: u32,
}

impl From<discrete::Selection> for Selection {
    #[inline]
    fn from(chosen: discrete::Selection) -> Self {
        Self {
            index: chosen.index,
            pmf: chosen.pmf,
            leftover: chosen.leftover,
            leftover_bits: chosen.leftover_bits,
        }
    }
}

/// `mw_exact_selection`
#[repr(C)]
#[derive(Default)]
pub struct ExactSelection {
    numerator: u64,
    index: usize,
    leftover: u32,
    leftover_bits: u32,
}

impl From<discrete::ExactSelection> for ExactSelection {
    #[inline]
    fn from(chosen: discrete::ExactSelection) -> Self {
        Self {
            numerator: chosen.numerator,
            index: chosen.index,
            leftover: chosen.leftover,
            leftover_bits: chosen.leftover_bits,
        }
    }
}

/// `mw_cdf`
#[repr(C)]
#[derive(Clone, Copy)]
pub struct CdfHandle {
    words: *const u32,
    entries: usize,
}

impl CdfHandle {
    /// # Safety
    /// The words are valid for reads.
    #[inline]
    pub unsafe fn table(self) -> Result<Cdf<&'static [u32]>, Error> {
        // SAFETY: the caller's promise.
        Cdf::from_trusted_words(unsafe { given(self.words, self.entries) })
    }
}

/// `mw_alias`
#[repr(C)]
#[derive(Clone, Copy)]
struct AliasHandle {
    bins: *const AliasEntry<u32>,
    entries: usize,
}

/// In C a bin is these three words, in this order.
const _: () = {
    let bin = AliasEntry::<u32>::new(1, 2, 3);
    // SAFETY: any three words are an array of words.
    let words = unsafe { core::mem::transmute::<AliasEntry<u32>, [u32; 3]>(bin) };
    assert!(words[0] == 1 && words[1] == 2 && words[2] == 3);
};

/// How many bins so many entries take.
#[inline]
const fn bins(entries: usize) -> Result<usize, Error> {
    match (entries, entries.checked_next_power_of_two()) {
        (0, _) => Err(Error::NoWeights),
        (_, Some(bins)) => Ok(bins),
        (_, None) => Err(Error::TooManyWeights),
    }
}

impl AliasHandle {
    /// # Safety
    /// The bins are valid for reads.
    #[inline]
    unsafe fn table(self) -> Result<Alias<&'static [AliasEntry<u32>]>, Error> {
        // SAFETY: the caller's promise.
        Alias::from_trusted_bins(
            unsafe { given(self.bins, bins(self.entries)?) },
            self.entries,
        )
    }
}

#[unsafe(export_name = "mw_cdf_build")]
unsafe extern "C" fn cdf(weights: *const f32, entries: usize, words: *mut u32) -> Code {
    // SAFETY: the promise of the header.
    let (weights, words) = unsafe { (given(weights, entries), memory(words, entries)) };
    code(Cdf::new_in(weights, words), drop)
}

#[unsafe(export_name = "mw_cdf_build_integers")]
unsafe extern "C" fn cdf_of_integers(weights: *const u32, entries: usize, words: *mut u32) -> Code {
    // SAFETY: the promise of the header.
    let (weights, words) = unsafe { (given(weights, entries), memory(words, entries)) };
    code(Cdf::from_integers_in(weights, words), drop)
}

#[unsafe(export_name = "mw_cdf_init")]
unsafe extern "C" fn cdf_init(table: &mut CdfHandle, words: *const u32, entries: usize) -> Code {
    // SAFETY: the promise of the header.
    let checked = Cdf::from_words(unsafe { given(words, entries) });
    code(checked, |_| *table = CdfHandle { words, entries })
}

#[unsafe(export_name = "mw_alias_build")]
unsafe extern "C" fn alias(weights: *const f32, entries: usize, to: *mut AliasEntry<u32>) -> Code {
    let laid = bins(entries).and_then(|count| {
        // SAFETY: the promise of the header.
        let (weights, to) = unsafe { (given(weights, entries), memory(to, count)) };
        Alias::new_in(weights, to)
    });
    code(laid, drop)
}

#[unsafe(export_name = "mw_alias_build_integers")]
unsafe extern "C" fn alias_of_integers(
    weights: *const u32,
    entries: usize,
    to: *mut AliasEntry<u32>,
) -> Code {
    let laid = bins(entries).and_then(|count| {
        // SAFETY: the promise of the header.
        let (weights, to) = unsafe { (given(weights, entries), memory(to, count)) };
        Alias::from_integers_in(weights, to)
    });
    code(laid, drop)
}

#[unsafe(export_name = "mw_alias_init")]
unsafe extern "C" fn alias_init(
    table: &mut AliasHandle,
    from: *const AliasEntry<u32>,
    entries: usize,
) -> Code {
    // SAFETY: the promise of the header.
    let checked =
        bins(entries).and_then(|count| Alias::from_bins(unsafe { given(from, count) }, entries));
    code(checked, |_| {
        *table = AliasHandle {
            bins: from,
            entries,
        }
    })
}

/// What both tables do. A handle without entries, which no `init` makes, selects entry 0 with probability 0.
macro_rules! selections {
    ($($name:literal $handle:ty;)*) => {$(
        const _: () = {
            #[unsafe(export_name = concat!("mw_", $name, "_select"))]
            unsafe extern "C" fn select(table: &$handle, word: u32) -> Selection {
                forget_registers();
                // SAFETY: the promise of the header.
                let table = unsafe { table.table() };
                table.map(|table| table.select(word).into()).unwrap_or_default()
            }

            #[unsafe(export_name = concat!("mw_", $name, "_select_uniform"))]
            unsafe extern "C" fn select_uniform(table: &$handle, u: f32) -> Selection {
                // SAFETY: the promise of the header.
                let table = unsafe { table.table() };
                table.map(|table| table.select_uniform(u).into()).unwrap_or_default()
            }

            #[unsafe(export_name = concat!("mw_", $name, "_select_exact"))]
            unsafe extern "C" fn select_exact(table: &$handle, word: u32) -> ExactSelection {
                // SAFETY: the promise of the header.
                let table = unsafe { table.table() };
                table.map(|table| table.select_exact(word).into()).unwrap_or_default()
            }

            #[unsafe(export_name = concat!("mw_", $name, "_draw"))]
            unsafe extern "C" fn draw(table: &$handle, rng: &mut Pcg32) -> Selection {
                forget_registers();
                // SAFETY: the promise of the header.
                let table = unsafe { table.table() };
                table.map(|table| table.draw(rng).into()).unwrap_or_default()
            }

            #[unsafe(export_name = concat!("mw_", $name, "_draw_from"))]
            unsafe extern "C" fn draw_from(
                table: &$handle,
                source: &Source,
                chosen: *mut Selection,
            ) -> Code {
                forget_registers();
                // SAFETY: the promise of the header.
                match unsafe { table.table() } {
                    Ok(table) => code(table.try_draw(&mut { *source }), |drawn| {
                        // SAFETY: the promise of the header.
                        unsafe { chosen.write(drawn.into()) }
                    }),
                    Err(error) => error.into(),
                }
            }

            #[unsafe(export_name = concat!("mw_", $name, "_draw_index"))]
            unsafe extern "C" fn draw_index(table: &$handle, rng: &mut Pcg32) -> usize {
                // SAFETY: the promise of the header.
                let table = unsafe { table.table() };
                table.map_or(0, |table| table.draw_index(rng))
            }

            #[unsafe(export_name = concat!("mw_", $name, "_pmf"))]
            unsafe extern "C" fn pmf(table: &$handle, index: usize) -> f32 {
                // SAFETY: the promise of the header.
                let table = unsafe { table.table() };
                table.map_or(0.0, |table| table.pmf(index))
            }
        };
    )*};
}

selections! {
    "cdf" CdfHandle;
    "alias" AliasHandle;
}
