//! The warps of both float tiers, which `tests/golden/src/warps.rs` lists. Those of no tier are in both, too.

use crate::registry::{ok, warp_entries};
use microwarp::{Warp, libm, poly};

macro_rules! entries {
    ($tier:tt $($type:ident {
        golden $golden:tt
        cost { $($name:literal $u:tt -> $out:ty = $warp:expr,)* $(none $reason:literal)? }
        page $page:tt bind $bind:tt
    })*) => {
        entries! { @ $tier $($($name $u f32 -> $out = $warp,)*)* }
    };
    (@ ($($tier:tt)*) $($rest:tt)*) => {
        warp_entries! { $($tier)*, $($rest)* }
    };
}

microwarp_golden::float_warps!(entries(POLY "poly_" poly));
microwarp_golden::float_warps!(entries(LIBM "libm_" libm));
