//! The warps of the float tiers, which `crates/list/src/warps.rs` lists.

use crate::run::of;
use crate::subject::subjects;
use core::f32::consts::TAU;
use microwarp::tier::Tier;
use microwarp::warp::*;

macro_rules! warps {
    ($($type:ident {
        golden $golden:tt
        cost $cost:tt
        page { $($view:ident $words:literal: $name:ident $parameters:tt => $warp:expr,)* }
        bind $bind:tt
    })*) => {
        subjects! {
            WARPS visit[T: Tier,] "" "libm poly":
            $($($type: $view $words: $name $parameters => of($warp),)*)*
        }
    };
}

microwarp_list::float_warps!(warps);
