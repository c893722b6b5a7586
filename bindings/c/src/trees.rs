//! Weights that change: trees of sums in place of them, in memory of the caller. A handle is a pointer and a count.

use crate::error::{Code, code};
use crate::generators::{Pcg32, Source, forget_registers};
use crate::tables::{ExactSelection, Selection};
use crate::warps::{given, memory};
use core_crate::Error;
use core_crate::discrete::{Storage, SumTree, Word};
use rand_core::Rng;

/// `mw_sum_tree` of `u32`, `mw_sum_tree_64` of `u64`
#[repr(C)]
#[derive(Clone, Copy)]
struct Handle<W> {
    sums: *mut W,
    entries: usize,
}

impl<W: Word + 'static> Handle<W>
where
    &'static [W]: Storage<Item = W>,
    &'static mut [W]: Storage<Item = W>,
{
    /// # Safety
    /// The sums are valid for reads.
    #[inline]
    unsafe fn tree(self) -> Option<SumTree<&'static [W]>> {
        // SAFETY: the caller's promise.
        SumTree::from_trusted_sums(unsafe { given(self.sums, self.entries) }).ok()
    }

    /// # Safety
    /// The sums are valid for reads and writes, and for nobody else as long as the tree lives.
    #[inline]
    unsafe fn changing(self) -> Result<SumTree<&'static mut [W]>, Error> {
        // SAFETY: the caller's promise.
        SumTree::from_trusted_sums(unsafe { memory(self.sums, self.entries) })
    }
}

/// Writes what there is.
#[inline]
fn found<T, C: From<T>>(result: Option<T>, to: &mut C) -> bool {
    let some = result.is_some();
    if let Some(value) = result {
        *to = value.into();
    }
    some
}

/// Draws entries one after the other, each from those that are left, and puts the weights back. Returns how many it drew.
#[inline]
fn distinct<W: Word, R: Rng>(
    mut tree: SumTree<&mut [W]>,
    rng: &mut R,
    indices: &mut [usize],
    weights: &mut [W],
    zero: W,
) -> usize
where
    for<'a> &'a mut [W]: Storage<Item = W>,
{
    let mut drawn = 0;
    for place in indices.iter_mut().zip(weights.iter_mut()) {
        if let Some(index) = tree.draw_index(rng) {
            if let Ok(weight) = tree.set(index, zero) {
                (*place.0, *place.1) = (index, weight);
                drawn += 1;
            }
        }
    }
    for (&mut index, &mut weight) in indices.iter_mut().zip(weights).take(drawn) {
        // It had that weight before.
        let _ = tree.set(index, weight);
    }
    drawn
}

/// What the tree selects by a word or with a generator.
macro_rules! selections {
    ($tree:literal $word:ty; $($name:literal ($by:ident: $type:ty) -> $to:ty = $method:ident;)*) => {$(
        const _: () = {
            #[unsafe(export_name = concat!($tree, $name))]
            unsafe extern "C" fn select(tree: &Handle<$word>, $by: $type, to: &mut $to) -> bool {
                forget_registers();
                // SAFETY: the promise of the header.
                let tree = unsafe { tree.tree() };
                found(tree.and_then(|tree| tree.$method($by)), to)
            }
        };
    )*};
}

macro_rules! trees {
    ($($name:literal $word:ty;)*) => {$(
        const _: () = {
            type Tree = Handle<$word>;

            #[unsafe(export_name = concat!($name, "_init"))]
            unsafe extern "C" fn init(tree: &mut Tree, weights: *mut $word, entries: usize) -> Code {
                // SAFETY: the promise of the header.
                let made = SumTree::new_in(unsafe { memory(weights, entries) });
                code(made, |_| *tree = Handle { sums: weights, entries })
            }

            #[unsafe(export_name = concat!($name, "_into_weights"))]
            unsafe extern "C" fn into_weights(tree: &mut Tree) {
                // SAFETY: the promise of the header.
                if let Ok(tree) = unsafe { tree.changing() } {
                    let _ = tree.into_weights();
                }
            }

            #[unsafe(export_name = concat!($name, "_set"))]
            unsafe extern "C" fn set(tree: &mut Tree, index: usize, weight: $word) -> Code {
                // SAFETY: the promise of the header.
                let tree = unsafe { tree.changing() };
                code(tree.and_then(|mut tree| tree.set(index, weight)), drop)
            }

            #[unsafe(export_name = concat!($name, "_get"))]
            unsafe extern "C" fn get(tree: &Tree, index: usize) -> $word {
                // SAFETY: the promise of the header.
                let tree = unsafe { tree.tree() };
                tree.and_then(|tree| tree.get(index)).unwrap_or(0)
            }

            #[unsafe(export_name = concat!($name, "_total"))]
            unsafe extern "C" fn total(tree: &Tree) -> $word {
                // SAFETY: the promise of the header.
                unsafe { tree.tree() }.map_or(0, |tree| tree.total())
            }

            #[unsafe(export_name = concat!($name, "_pmf"))]
            unsafe extern "C" fn pmf(tree: &Tree, index: usize) -> f32 {
                // SAFETY: the promise of the header.
                unsafe { tree.tree() }.map_or(0.0, |tree| tree.pmf(index))
            }

            selections! {
                $name $word;
                "_select" (word: $word) -> Selection = select_word;
                "_index" (word: $word) -> usize = index;
                "_draw" (rng: &mut Pcg32) -> Selection = draw;
                "_draw_index" (rng: &mut Pcg32) -> usize = draw_index;
            }

            #[unsafe(export_name = concat!($name, "_draw_from"))]
            unsafe extern "C" fn draw_from(tree: &Tree, source: &Source, chosen: &mut Selection) -> Code {
                forget_registers();
                // SAFETY: the promise of the header.
                let Some(tree) = (unsafe { tree.tree() }) else {
                    return Error::NoWeights.into();
                };
                match tree.try_draw(&mut { *source }) {
                    Ok(drawn) => code(drawn.ok_or(Error::AllZero), |drawn| *chosen = drawn.into()),
                    Err(failed) => failed.into(),
                }
            }

            #[unsafe(export_name = concat!($name, "_draw_distinct"))]
            unsafe extern "C" fn draw_distinct(
                tree: &mut Tree, rng: &mut Pcg32, indices: *mut usize, weights: *mut $word, count: usize,
            ) -> usize {
                // SAFETY: the promise of the header.
                let (indices, weights) = unsafe { (memory(indices, count), memory(weights, count)) };
                // SAFETY: the promise of the header.
                unsafe { tree.changing() }.map_or(0, |tree| distinct(tree, rng, indices, weights, 0))
            }
        };
    )*};
}

trees! {
    "mw_sum_tree" u32;
    "mw_sum_tree_64" u64;
}

// Of 64 bits these counts do not fit an integer of C.
selections! {
    "mw_sum_tree" u32;
    "_select_exact" (word: u32) -> ExactSelection = select_exact;
}

#[unsafe(export_name = "mw_sum_tree_numerator")]
unsafe extern "C" fn numerator(tree: &Handle<u32>, index: usize) -> u64 {
    // SAFETY: the promise of the header.
    unsafe { tree.tree() }.map_or(0, |tree| tree.numerator(index))
}
