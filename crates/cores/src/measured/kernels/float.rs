//! The warps of both float tiers, which `crates/list/src/warps.rs` lists. Those of no tier are in both, too.

use crate::measured::registry::{ok, warp_entries};
use crate::measured::varied::varied_entries;
use microwarp::{Warp, libm, poly};

macro_rules! entries {
    (($list:ident $varied:ident $($tier:tt)*) $($type:ident {
        golden $golden:tt
        cost { $($name:literal $u:tt -> $out:ty = $warp:expr,)* $(none $reason:literal)? }
        bind $bind:tt
    })*) => {
        entries! { @ $list ($($tier)* "") $($($type $name $u f32 -> $out = $warp,)*)* }
        varied_entries! { $varied ($($tier)* "") $($type $bind)* }
    };
    (@ $list:ident ($($tier:tt)*) $($rest:tt)*) => {
        warp_entries! { $list $($tier)*, $($rest)* }
    };
}

microwarp_list::float_warps!(entries(POLY POLY_VARIED "poly_" poly));
microwarp_list::float_warps!(entries(LIBM LIBM_VARIED "libm_" libm));
