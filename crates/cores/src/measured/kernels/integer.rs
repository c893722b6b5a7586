//! The warps of the integer tier in its three grades, which `crates/list/src/fixed_warps.rs` lists, and its interval,
//! which has none.

use crate::measured::registry::{ok, warp_entries};
use crate::measured::varied::varied_entries;
use fixed::types::extra::U16;
use fixed::types::{I2F30, I5F27, I16F16, U0F32, U2F62, U5F27, U16F16, U32F32};
use microwarp::Warp;
use microwarp::fixed::{self as fine, coarse, compact};

macro_rules! entries {
    (
        $tier:tt
        in every grade { $($graded:tt)* }
        with floats { $($floats:tt)* }
        without grade { $($plain:tt)* }
    ) => {
        entries! { @ $tier [$($graded)* $($floats)*] [$($plain)*] }
    };
    (@ (PLAIN $($tier:tt)*) $graded:tt $plain:tt) => { entries! { @ PLAIN ($($tier)* "fixed ") $plain } };
    (@ ($list:ident $($tier:tt)*) $graded:tt $plain:tt) => { entries! { @ $list ($($tier)* "fixed ") $graded } };
    (@ $list:ident ($varied:ident $($tier:tt)*) [$($type:ident {
        golden $golden:tt
        cost { $($name:literal $u:tt: $number:ident -> $out:ty = $warp:expr,)* $(none $reason:literal)? }
        bind $bind:tt
    })*]) => {
        entries! { @ list $list ($($tier)*) $($($type $name $u $number -> $out = $warp,)*)* }
        varied_entries! { $varied ($($tier)*) $($type $bind)* }
    };
    (@ list $list:ident ($($tier:tt)*) $($rest:tt)*) => {
        warp_entries! { $list $($tier)*, $($rest)* }
    };
}

microwarp_list::integer_warps!(entries(FINE FINE_VARIED "fine_" fine));
microwarp_list::integer_warps!(entries(COARSE COARSE_VARIED "coarse_" coarse));
microwarp_list::integer_warps!(entries(COMPACT COMPACT_VARIED "compact_" compact));
microwarp_list::integer_warps!(entries(PLAIN PLAIN_VARIED "" fine));
