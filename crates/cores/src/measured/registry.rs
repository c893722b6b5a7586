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
        pub static ENTRIES: &[$crate::measured::count::Entry] = &[
            $(
                #[cfg(any(not(one_kernel), kernel = $name))]
                $crate::measured::registry::entry!(($name) $inputs -> $out = $body, { $($prepare;)? }),
            )*
        ];
    };
}

/// `LIST "prefix_" module "room ", Type "name" uniforms number -> point = warp, ...`
///
/// Warps of one tier, whose names are in `module`, each from uniforms in memory and drawn with a generator. The names
/// of the kernels are `prefix_name` and `prefix_name_pcg32`. The uniforms are named, one alone or several in brackets.
macro_rules! warp_entries {
    (
        $list:ident $prefix:literal $module:ident $room:literal,
        $($type:ident $name:literal $u:tt $number:ident -> $out:ty = $warp:expr,)*
    ) => {
        /// Every entry; a measurement leaves one.
        pub static $list: &[$crate::measured::count::Entry] = &[$(
            #[cfg(any(not(one_kernel), all(prefix = $prefix, warp = $name, not(drawn), not(varied))))]
            $crate::measured::count::Entry {
                warp: concat!($room, stringify!($type)),
                ..$crate::measured::registry::sampled!((concat!($prefix, $name)) $number $u -> $out = $module $warp)
            },
            #[cfg(any(not(one_kernel), all(prefix = $prefix, warp = $name, drawn)))]
            $crate::measured::count::Entry {
                warp: concat!($room, stringify!($type)),
                ..$crate::measured::registry::drawn!((concat!($prefix, $name, "_pcg32")) -> $out = $module $warp)
            },
        )*];
    };
}

/// A warp that takes its uniforms from memory.
macro_rules! sampled {
    (($name:expr) $number:ident [$($u:ident),+] -> $out:ty = $module:ident $warp:expr) => {
        $crate::measured::registry::entry!(
            ($name) ($($u: $number),+) -> $out =
                $crate::measured::registry::with!(loaded $module $warp).sample([$($u),+]),
            _ = $crate::measured::registry::with!(made $module $warp)
        )
    };
    (($name:expr) $number:ident $u:ident -> $out:ty = $module:ident $warp:expr) => {
        $crate::measured::registry::entry!(
            ($name) ($u: $number) -> $out = $crate::measured::registry::with!(loaded $module $warp).sample($u),
            _ = $crate::measured::registry::with!(made $module $warp)
        )
    };
}

/// A warp that draws its uniforms.
macro_rules! drawn {
    (($name:expr) -> $out:ty = $module:ident $warp:expr) => {
        $crate::measured::registry::entry!(
            ($name) (rng) -> $out = $crate::measured::registry::with!(loaded $module $warp).draw(rng),
            _ = $crate::measured::registry::with!(made $module $warp)
        )
    };
}

/// A warp over the names of a module. What it calls `stored` is made by the preparation and loaded by the kernel.
macro_rules! with {
    ($stored:ident $module:ident $warp:expr) => {{
        use $crate::measured::registry::$stored as stored;
        use $module::*;
        $warp
    }};
}

/// One entry: its name, what goes in and out, what happens between, and what is done once before.
macro_rules! entry {
    (($name:expr) ($($input:ident: $type:ty),+) -> $out:ty = $body:expr, $prepare:expr) => {{
        const INPUTS: usize = [$(stringify!($input)),+].len();
        #[unsafe(export_name = $name)]
        #[inline(never)]
        extern "C" fn kernel(at: *mut u32, to: *mut u32) {
            // SAFETY: the entry below says how many words there are.
            let [$($input),+] = core::array::from_fn(|index| at.wrapping_add(index));
            $(let $input = unsafe { $input.cast::<$type>().read_volatile() };)+
            let out: $out = $body;
            unsafe { $crate::measured::words::Output::store(out, to) }
        }
        $crate::measured::count::Entry {
            kernel,
            empty: $crate::measured::count::empty::<INPUTS, $out>,
            inputs: &[$(<$type as $crate::measured::words::Input>::bits),+],
            outputs: <$out as $crate::measured::words::Output>::WORDS,
            prepare: || $prepare,
            warp: "",
            vary: None,
        }
    }};
    (($name:expr) ($rng:ident) -> $out:ty = $body:expr, $prepare:expr) => {{
        #[unsafe(export_name = $name)]
        #[inline(never)]
        extern "C" fn kernel(at: *mut u32, to: *mut u32) {
            // SAFETY: the entry below puts a generator there, and nobody else uses it.
            let $rng = unsafe { &mut *at.cast::<rand_pcg::Pcg32>() };
            let out: $out = $body;
            unsafe { $crate::measured::words::Output::store(out, to) }
        }
        $crate::measured::count::Entry {
            kernel,
            empty: $crate::measured::count::empty::<0, $out>,
            inputs: &[],
            outputs: <$out as $crate::measured::words::Output>::WORDS,
            prepare: || $prepare,
            warp: "",
            vary: None,
        }
    }};
}

pub(crate) use {drawn, entry, kernels, sampled, warp_entries, with};

/// A parameter that was accepted; at compile time, where it stands in a `const`.
pub const fn ok<T: Copy>(result: Result<T, Error>) -> T {
    match result {
        Ok(value) => value,
        Err(_) => panic!("refused"),
    }
}

/// Memory for what a kernel finds ready: a warp whose constructor is no `const fn`, or the state of a chain.
static mut STORED: [u64; 48] = [0; 48];

/// Where it lies.
#[inline(always)]
pub fn stored_at<T>() -> *mut T {
    (&raw mut STORED).cast()
}

/// What `made` has put into memory; the kernel's side of `stored`.
#[inline(always)]
pub fn loaded<T>(_: impl FnOnce() -> Result<T, Error>) -> &'static mut T {
    // SAFETY: the preparation of the same entry, which is the only one, has written the same type there; there is
    // one thread, and a kernel calls this once.
    unsafe { &mut *stored_at() }
}

/// Puts it there.
pub fn made<T>(make: impl FnOnce() -> Result<T, Error>) -> &'static mut T {
    let Ok(made) = make() else { panic!("refused") };
    store(made)
}

/// Puts it there, in a way that the compiler cannot see through, so that the kernel really loads it.
pub fn store<T>(made: T) -> &'static mut T {
    const {
        assert!(size_of::<T>() <= size_of::<[u64; 48]>() && align_of::<T>() <= align_of::<u64>());
    }
    let at = stored_at::<T>();
    // SAFETY: there is room, by the assertion, and one thread.
    unsafe {
        at.write(black_box(made));
        &mut *at
    }
}
