//! Integers of a range, coins, and one uniform.

use crate::error::{Code, code};
use crate::generators::{Pcg32, Source, forget_registers};
use core_crate::Error;
use core_crate::uniform::{Chance, Range, grid, try_grid, try_up_to, up_to};

#[unsafe(export_name = "mw_uniform")]
extern "C" fn uniform(rng: &mut Pcg32) -> f32 {
    forget_registers();
    grid(rng)
}

#[unsafe(export_name = "mw_uniform_from")]
extern "C" fn uniform_from(source: &Source, u: &mut f32) -> Code {
    forget_registers();
    code(try_grid(&mut { *source }), |drawn| *u = drawn)
}

#[unsafe(export_name = "mw_up_to")]
extern "C" fn integer(rng: &mut Pcg32, last: u32) -> u32 {
    up_to(last, rng)
}

#[unsafe(export_name = "mw_up_to_from")]
extern "C" fn integer_from(source: &Source, last: u32, value: &mut u32) -> Code {
    code(try_up_to(last, &mut { *source }), |drawn| *value = drawn)
}

macro_rules! drawn {
    ($($name:literal ($($parameter:ident: $type:ty),*) -> $value:ty = $made:expr, $draw:ident $try_draw:ident;)*) => {$(
        const _: () = {
            #[unsafe(export_name = concat!("mw_", $name))]
            extern "C" fn draw(rng: &mut Pcg32, $($parameter: $type,)* value: &mut $value) -> Code {
                code($made, |made| *value = made.$draw(rng))
            }

            #[unsafe(export_name = concat!("mw_", $name, "_from"))]
            extern "C" fn draw_from(source: &Source, $($parameter: $type,)* value: &mut $value) -> Code {
                match $made {
                    Ok(made) => code(made.$try_draw(&mut { *source }), |drawn| *value = drawn),
                    Err(error) => Error::into(error),
                }
            }
        };
    )*};
}

drawn! {
    "below" (n: u32) -> u32 = Range::below(n), draw try_draw;
    "below_wide" (n: u32) -> u32 = Range::below(n), draw_wide try_draw_wide;
    "range" (low: i32, high: i32) -> i32 = Range::signed(low, high), draw try_draw;
    "range_wide" (low: i32, high: i32) -> i32 = Range::signed(low, high), draw_wide try_draw_wide;
    "range_u64" (low: u64, high: u64) -> u64 = Range::of_u64(low, high), draw try_draw;
    "chance" (p: f32) -> bool = Chance::new(p), draw try_draw;
    "ratio" (part: u32, all: u32) -> bool = Chance::from_ratio(part, all), draw try_draw;
}

#[unsafe(export_name = "mw_below_select")]
extern "C" fn below_of(word: u32, n: u32, value: &mut u32, rest: &mut u32) -> Code {
    code(Range::below(n), |made| (*value, *rest) = made.select(word))
}

#[unsafe(export_name = "mw_range_select")]
extern "C" fn range_of(word: u32, low: i32, high: i32, value: &mut i32, rest: &mut u32) -> Code {
    code(Range::signed(low, high), |made| {
        (*value, *rest) = made.select(word)
    })
}

#[unsafe(export_name = "mw_below_numerator")]
extern "C" fn words_of_below(n: u32, value: u32, words: &mut u64) -> Code {
    code(Range::below(n), |made| *words = made.numerator(value))
}

#[unsafe(export_name = "mw_range_numerator")]
extern "C" fn words_of_range(low: i32, high: i32, value: i32, words: &mut u64) -> Code {
    code(Range::signed(low, high), |made| {
        *words = made.numerator(value)
    })
}

#[unsafe(export_name = "mw_chance_numerator")]
extern "C" fn words_of_chance(p: f32, words: &mut u64) -> Code {
    code(Chance::new(p), |chance| *words = chance.words())
}

#[unsafe(export_name = "mw_ratio_numerator")]
extern "C" fn words_of_ratio(part: u32, all: u32, words: &mut u64) -> Code {
    code(Chance::from_ratio(part, all), |chance| {
        *words = chance.words()
    })
}
