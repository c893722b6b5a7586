//! The warps of the integer tier, which `crates/list/src/fixed_warps.rs` lists; parameters in their formats.

use crate::run::of;
use crate::shared::Refusal;
use crate::subject::subjects;
use fixed::types::{I16F16, U0F32, U16F16, U32F32};
use microwarp::fixed::warp::*;
use microwarp::fixed::{Float, Grade};

macro_rules! warps {
    (
        in every grade { $($graded:tt)* }
        with floats { $($floats:tt)* }
        without grade { $($plain:tt)* }
    ) => {
        warps! { @ $($graded)* $($floats)* $($plain)* }
    };
    (@ $($type:ident {
        golden $golden:tt
        cost $cost:tt
        page { $($view:ident $words:literal: $name:ident $parameters:tt => $warp:expr,)* }
        bind $bind:tt
    })*) => {
        subjects! {
            WARPS visit[G: Grade,] "" "fine coarse compact":
            $($($type: $view $words: $name $parameters => of($warp),)*)*
        }
    };
}

microwarp_list::integer_warps!(warps);

/// A parameter in steps of 2⁻¹⁶, if the format holds it; what has more digits is cut.
fn signed(x: f32) -> Result<I16F16, Refusal> {
    if (-32_768.0..32_768.0).contains(&x) {
        Ok(I16F16::from_bits((x * 65_536.0) as i32))
    } else {
        Err(Refusal::Format("I16F16"))
    }
}

fn unsigned(x: f32) -> Result<U16F16, Refusal> {
    if (0.0..65_536.0).contains(&x) {
        Ok(U16F16::from_bits((x * 65_536.0) as u32))
    } else {
        Err(Refusal::Format("U16F16"))
    }
}

fn exponent(x: f32) -> Result<U32F32, Refusal> {
    if (0.0..4_294_967_296.0).contains(&x) {
        Ok(U32F32::from_bits((x * 4_294_967_296.0) as u64))
    } else {
        Err(Refusal::Format("U32F32"))
    }
}

fn turns(x: f32) -> Result<U0F32, Refusal> {
    if (0.0..1.0).contains(&x) {
        Ok(U0F32::from_bits((x * 4_294_967_296.0) as u32))
    } else {
        Err(Refusal::Format("U0F32"))
    }
}
