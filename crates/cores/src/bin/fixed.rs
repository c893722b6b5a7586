//! Every warp of the integer tier in every grade, made at run time, sampled, drawn, inverted and asked for its
//! density; and the route of f32 over them. No floating-point routine may be linked, of either width.
#![no_std]
#![no_main]

use core::hint::black_box;
use fixed::types::{I2F30, I16F16, I32F0, U0F32, U16F16, U32F32};
use microwarp::fixed::warp::*;
use microwarp::fixed::{Coarse, Compact, Fine, Float, FloatPoint, FloatUniforms, Grade};
use microwarp::{Error, Invert};
use microwarp_cores::{input, output};
use microwarp_list::fixed::{Words, v, whole};
use microwarp_list::integer_warps;
use rand_pcg::Pcg32;

/// Anything whose bits can be handed out: the check wants them used, whatever they are.
fn used<T: Copy>(value: T) {
    black_box(value);
    output(core::mem::size_of::<T>() as u32);
}

fn all<W>(warp: Result<W, Error>, rng: &mut Pcg32)
where
    W: Invert,
    W::Uniforms: Words,
{
    let Ok(warp) = warp else { return output(1) };
    let point = warp.sample(W::Uniforms::from_words([input(7), input(8)]));
    used(point);
    used(warp.pdf(point));
    used(warp.invert(point));
    used(warp.draw(rng));
}

/// The warp itself, and over it the route of f32.
fn both<W>(warp: Result<W, Error>, rng: &mut Pcg32)
where
    W: Invert<Density = U32F32> + Copy,
    W::Uniforms: Words + FloatUniforms,
    W::Point: FloatPoint,
    <Float<W> as microwarp::Warp>::Uniforms: Words,
{
    all(warp, rng);
    all(warp.map(Float::new), rng);
}

/// Every warp of the list.
macro_rules! warps {
    (
        in every grade { $($graded:ident {
            golden { $($name:literal => $warp:expr,)* } cost $cost:tt bind $bind:tt
        })* }
        with floats { $($float:ident {
            golden { $($float_name:literal => $float_warp:expr,)* } cost $float_cost:tt bind $float_bind:tt
        })* }
        without grade { $($plain:ident {
            golden { $($plain_name:literal => $plain_warp:expr,)* } cost $plain_cost:tt bind $plain_bind:tt
        })* }
    ) => {
        fn grade<G: Grade>(rng: &mut Pcg32) {
            $($(both($warp, rng);)*)*
            $($(all($float_warp, rng);)*)*
            used(G::pow(v(input(7)), v(input(12))));
            used(G::exp_m1_neg(G::neg_ln_1m(v(input(7)))));
        }

        fn without_grade(rng: &mut Pcg32) {
            $($(both($plain_warp, rng);)*)*
        }
    };
}

integer_warps!(warps);

/// The name that the check looks for, so that it knows it has read the right file.
#[unsafe(no_mangle)]
#[inline(never)]
fn microwarp_fixed(rng: &mut Pcg32) {
    grade::<Fine>(rng);
    grade::<Coarse>(rng);
    grade::<Compact>(rng);
    without_grade(rng);
    // Of formats that the list has not.
    both(Interval::<u32>::inclusive(input(1), input(2)), rng);
    both(Interval::<U16F16>::new(v(input(1)), v(input(2))), rng);
}

#[unsafe(no_mangle)]
#[inline(never)]
extern "C" fn probe_main() {
    let mut rng = Pcg32::new(input(1).into(), input(2).into());
    for _ in 0..input(100) {
        microwarp_fixed(&mut rng);
    }
}
