//! What runs on cores: the warps of every tier, listed once, and the golden bits.
//!
//! `warps.rs` and `fixed_warps.rs` list the warps. What is made of them elsewhere (costs, benches, bindings) takes the
//! lists alone, without the feature `cases`.
//!
//! The golden bits are every public function of microwarp evaluated on fixed inputs, on any target. The host, the WASM
//! module and firmware all run this very code and compare what it yields with `golden.csv`. A case is one subject (a
//! warp with its parameters, or an elementary function) at one input; it yields up to 16 words, the bits of `f32`s or
//! plain integers. What a NaN's bits are differs between machines, so every NaN yields the same word.
#![no_std]

mod errors;
#[macro_use]
mod warps;
#[macro_use]
mod fixed_warps;

#[cfg(feature = "cases")]
mod cases;
#[cfg(feature = "cases")]
mod chains;
#[cfg(feature = "cases")]
mod counts;
#[cfg(feature = "cases")]
pub mod fixed;
#[cfg(feature = "cases")]
mod gammas;
#[cfg(feature = "cases")]
mod integers;
#[cfg(feature = "cases")]
mod lamps;
#[cfg(feature = "cases")]
mod orders;
#[cfg(feature = "cases")]
mod subjects;

/// What becomes of a panic in a WASM module: an import, which stands in the module if and only if something in it can panic.
#[macro_export]
macro_rules! import_panic {
    () => {
        #[cfg(target_arch = "wasm32")]
        #[link(wasm_import_module = "host")]
        unsafe extern "C" {
            safe fn panicked() -> !;
        }

        #[panic_handler]
        fn panic(_: &core::panic::PanicInfo) -> ! {
            #[cfg(target_arch = "wasm32")]
            panicked();
            #[cfg(not(target_arch = "wasm32"))]
            loop {}
        }
    };
}

/// What the lists hold of a type, for those who look whether it is complete.
pub struct Listed {
    pub name: &'static str,
    /// Its golden subjects.
    pub golden: &'static [&'static str],
    /// Its cost kernels, without their tiers.
    pub kernels: &'static [&'static str],
    /// Why there are none.
    pub no_kernel: Option<&'static str>,
    /// The names in other languages, and the constructors.
    pub bound: &'static [(&'static str, &'static str)],
}

impl Listed {
    /// The names of what takes parameters, whose kernels `crates/cores` sweeps with any of them.
    pub fn varied(&self) -> impl Iterator<Item = &'static str> {
        let alone = ["new()", "new ()"];
        let takes = move |made: &str| !alone.iter().any(|new| made.starts_with(new));
        let varied = self.bound.iter().filter(move |(_, made)| takes(made));
        varied.map(|(name, _)| *name)
    }
}

macro_rules! listed {
    ($list:ident: $($type:ident {
        golden { $($($once:ident)? $golden:literal => $warp:expr,)* }
        cost {
            $($kernel:literal $u:tt $(: $number:ident)? -> $out:ty = $cost:expr,)*
            $(none $reason:literal)?
        }
        bind { $($bound:literal = $bound_type:ty { $($made:tt)* })* $(none $unbound:literal)? }
    })*) => {
        pub const $list: &[Listed] = &[$(Listed {
            name: stringify!($type),
            golden: &[$($golden),*],
            kernels: &[$($kernel),*],
            no_kernel: [$(Some($reason),)? None][0],
            bound: &[$(($bound, stringify!($($made)*)),)*],
        }),*];
    };
}

macro_rules! listed_floats {
    ($($blocks:tt)*) => { listed! { FLOAT_WARPS: $($blocks)* } };
}

macro_rules! listed_integers {
    (
        in every grade { $($graded:tt)* }
        with floats { $($floats:tt)* }
        without grade { $($plain:tt)* }
    ) => {
        listed! { GRADED_WARPS: $($graded)* $($floats)* }
        listed! { PLAIN_WARPS: $($plain)* }
    };
}

float_warps!(listed_floats);
integer_warps!(listed_integers);

#[cfg(feature = "cases")]
pub use cases::*;
#[cfg(feature = "cases")]
pub use subjects::{AREAS, FACES, INPUTS, Mixed, Out, UNIFORMS, VERTICES, weights};
