//! How a line of the registry becomes a function that is measured.

use core::hint::black_box;
use microwarp::Error;

/// `"name" (inputs) -> outputs = expression;`
///
/// Inputs are numbers of a word each, written `name: type` (`words.rs` says which types there are and which
/// numbers each gets), or `(rng)`, a generator in memory, whose cost is part of the kernel's. Outputs are one
/// such number, an array or a tuple of them. After a comma there may be what is done once before, uncounted.
macro_rules! kernels {
    ($($name:literal $inputs:tt -> $out:ty = $body:expr $(, $prepare:expr)?;)*) => {
        /// Every entry; a measurement leaves one.
        pub static ENTRIES: &[$crate::count::Entry] = &[
            $(
                #[cfg(any(not(one_kernel), kernel = $name))]
                $crate::registry::entry!($name $inputs -> $out = $body, { $($prepare;)? }),
            )*
        ];
    };
}

/// `"poly_name" "poly_name_pcg32" "libm_name" "libm_name_pcg32" uniforms -> outputs = warp;`
///
/// The same warp in both float tiers, each from uniforms in memory and drawn with a generator. The uniforms are
/// named, one alone or several in brackets; the warp is an expression over the names of a tier.
macro_rules! float_warps {
    ($($poly:literal $poly_drawn:literal $libm:literal $libm_drawn:literal $u:tt -> $out:ty = $warp:expr;)*) => {
        /// Every entry; a measurement leaves one.
        pub static ENTRIES: &[$crate::count::Entry] = &[$(
            #[cfg(any(not(one_kernel), kernel = $poly))]
            $crate::registry::sampled!($poly f32 $u -> $out = (microwarp::poly) $warp),
            #[cfg(any(not(one_kernel), kernel = $poly_drawn))]
            $crate::registry::drawn!($poly_drawn -> $out = (microwarp::poly) $warp),
            #[cfg(any(not(one_kernel), kernel = $libm))]
            $crate::registry::sampled!($libm f32 $u -> $out = (microwarp::libm) $warp),
            #[cfg(any(not(one_kernel), kernel = $libm_drawn))]
            $crate::registry::drawn!($libm_drawn -> $out = (microwarp::libm) $warp),
        )*];
    };
}

/// The same for the three grades of the integer tier: `"fine_name" "fine_name_pcg32" "coarse_name" ...`.
macro_rules! integer_warps {
    ($(
        $fine:literal $fine_drawn:literal
        $coarse:literal $coarse_drawn:literal
        $compact:literal $compact_drawn:literal
        $u:tt: $number:ident -> $out:ty = $warp:expr;
    )*) => {
        /// Every entry; a measurement leaves one.
        pub static ENTRIES: &[$crate::count::Entry] = &[$(
            #[cfg(any(not(one_kernel), kernel = $fine))]
            $crate::registry::sampled!($fine $number $u -> $out = (microwarp::fixed) $warp),
            #[cfg(any(not(one_kernel), kernel = $fine_drawn))]
            $crate::registry::drawn!($fine_drawn -> $out = (microwarp::fixed) $warp),
            #[cfg(any(not(one_kernel), kernel = $coarse))]
            $crate::registry::sampled!($coarse $number $u -> $out = (microwarp::fixed::coarse) $warp),
            #[cfg(any(not(one_kernel), kernel = $coarse_drawn))]
            $crate::registry::drawn!($coarse_drawn -> $out = (microwarp::fixed::coarse) $warp),
            #[cfg(any(not(one_kernel), kernel = $compact))]
            $crate::registry::sampled!($compact $number $u -> $out = (microwarp::fixed::compact) $warp),
            #[cfg(any(not(one_kernel), kernel = $compact_drawn))]
            $crate::registry::drawn!($compact_drawn -> $out = (microwarp::fixed::compact) $warp),
        )*];
    };
}

/// A warp that takes its uniforms from memory.
macro_rules! sampled {
    ($name:literal $number:ident [$($u:ident),+] -> $out:ty = ($($module:ident)::+) $warp:expr) => {
        $crate::registry::entry!(
            $name ($($u: $number),+) -> $out =
                $crate::registry::with!(loaded ($($module)::+) $warp).sample([$($u),+]),
            _ = $crate::registry::with!(made ($($module)::+) $warp)
        )
    };
    ($name:literal $number:ident $u:ident -> $out:ty = ($($module:ident)::+) $warp:expr) => {
        $crate::registry::entry!(
            $name ($u: $number) -> $out = $crate::registry::with!(loaded ($($module)::+) $warp).sample($u),
            _ = $crate::registry::with!(made ($($module)::+) $warp)
        )
    };
}

/// A warp that draws its uniforms.
macro_rules! drawn {
    ($name:literal -> $out:ty = ($($module:ident)::+) $warp:expr) => {
        $crate::registry::entry!(
            $name (rng) -> $out = $crate::registry::with!(loaded ($($module)::+) $warp).draw(rng),
            _ = $crate::registry::with!(made ($($module)::+) $warp)
        )
    };
}

/// A warp over the names of a module. What it calls `stored` is made by the preparation and loaded by the kernel.
macro_rules! with {
    ($stored:ident ($($module:ident)::+) $warp:expr) => {{
        use $($module)::+::*;
        use $crate::registry::$stored as stored;
        $warp
    }};
}

/// One entry: its name, what goes in and out, what happens between, and what is done once before.
macro_rules! entry {
    ($name:literal ($($input:ident: $type:ty),+) -> $out:ty = $body:expr, $prepare:expr) => {{
        const INPUTS: usize = [$(stringify!($input)),+].len();
        #[unsafe(export_name = $name)]
        #[inline(never)]
        extern "C" fn kernel(at: *mut u32, to: *mut u32) {
            // SAFETY: the entry below says how many words there are.
            let [$($input),+] = core::array::from_fn(|index| at.wrapping_add(index));
            $(let $input = unsafe { $input.cast::<$type>().read_volatile() };)+
            let out: $out = $body;
            unsafe { $crate::words::Output::store(out, to) }
        }
        $crate::count::Entry {
            kernel,
            empty: $crate::count::empty::<INPUTS, $out>,
            inputs: INPUTS,
            outputs: <$out as $crate::words::Output>::WORDS,
            prepare: || $prepare,
            fill: |mut random, words| {
                for call in words.chunks_exact_mut(INPUTS) {
                    let mut word = call.iter_mut();
                    $(
                        if let Some(word) = word.next() {
                            *word = <$type as $crate::words::Input>::bits(rand_core::Rng::next_u32(&mut random));
                        }
                    )+
                }
            },
        }
    }};
    ($name:literal ($rng:ident) -> $out:ty = $body:expr, $prepare:expr) => {{
        #[unsafe(export_name = $name)]
        #[inline(never)]
        extern "C" fn kernel(at: *mut u32, to: *mut u32) {
            // SAFETY: the entry below puts a generator there, and nobody else uses it.
            let $rng = unsafe { &mut *at.cast::<rand_pcg::Pcg32>() };
            let out: $out = $body;
            unsafe { $crate::words::Output::store(out, to) }
        }
        $crate::count::Entry {
            kernel,
            empty: $crate::count::empty::<0, $out>,
            inputs: 0,
            outputs: <$out as $crate::words::Output>::WORDS,
            prepare: || $prepare,
            fill: |random, words| unsafe { words.as_mut_ptr().cast::<rand_pcg::Pcg32>().write(random) },
        }
    }};
}

pub(crate) use {drawn, entry, float_warps, integer_warps, kernels, sampled, with};

/// A parameter that was accepted; at compile time, where it stands in a `const`.
pub const fn ok<T: Copy>(result: Result<T, Error>) -> T {
    match result {
        Ok(value) => value,
        Err(_) => panic!("refused"),
    }
}

/// Memory for what a kernel finds ready: a warp whose constructor is no `const fn`, or the state of a chain.
static mut STORED: [u64; 32] = [0; 32];

/// What `made` has put into memory; the kernel's side of `stored`.
#[inline(always)]
pub fn loaded<T: Copy>(_: impl FnOnce() -> Result<T, Error>) -> &'static mut T {
    // SAFETY: the preparation of the same entry, which is the only one, has written the same type there; there is
    // one thread, and a kernel calls this once.
    unsafe { &mut *(&raw mut STORED).cast() }
}

/// Puts it there, in a way that the compiler cannot see through, so that the kernel really loads it.
pub fn made<T: Copy>(make: impl FnOnce() -> Result<T, Error>) -> &'static mut T {
    const {
        assert!(size_of::<T>() <= size_of::<[u64; 32]>() && align_of::<T>() <= align_of::<u64>());
    }
    let at = (&raw mut STORED).cast::<T>();
    // SAFETY: there is room, by the assertion, and one thread.
    unsafe {
        at.write(black_box(ok(make())));
        &mut *at
    }
}
