//! Every warp of the integer tier in every grade, made at run time, sampled, drawn, inverted and asked for its
//! density; and the route of f32 over them. No floating-point routine may be linked, of either width.
#![no_std]
#![no_main]

use fixed::types::{I16F16, U0F32, U2F62, U16F16, U32F32};
use microwarp::fixed::{
    Coarse, Compact, Fine, Float, FloatPoint, FloatUniforms, Grade, Interval, warp,
};
use microwarp::{Error, Warp};
use microwarp_probe::{input, output};
use rand_pcg::Pcg32;

fn word() -> U0F32 {
    U0F32::from_bits(input(7))
}

/// Anything whose bits can be handed out: the check wants them used, whatever they are.
fn used<T: Copy>(value: T) {
    core::hint::black_box(value);
    output(core::mem::size_of::<T>() as u32);
}

fn all<W: Warp>(warp: Result<W, Error>, u: W::Uniforms, rng: &mut Pcg32) {
    let Ok(warp) = warp else { return output(1) };
    let point = warp.sample(u);
    used(point);
    used(warp.pdf(point));
    used(warp.invert(point));
    used(warp.draw(rng));
}

/// The warp itself, and over it the route of f32.
fn both<W>(warp: Result<W, Error>, u: W::Uniforms, rng: &mut Pcg32)
where
    W: Warp<Density = U32F32> + Copy,
    W::Uniforms: FloatUniforms,
    W::Point: FloatPoint,
{
    all(warp, u, rng);
    all(warp.map(Float::new), u.floats(), rng);
}

fn grade<G: Grade>(rng: &mut Pcg32) {
    let short = |bits| I16F16::from_bits(bits as i32);
    let (mean, length) = (U16F16::from_bits(input(3)), U16F16::from_bits(input(4)));
    both(Ok(warp::Disk::<G>::new()), [word(), word()], rng);
    both(Ok(warp::Sphere::<G>::new()), [word(), word()], rng);
    both(Ok(warp::Hemisphere::<G>::new()), [word(), word()], rng);
    both(
        Ok(warp::CosineHemisphere::<G>::new()),
        [word(), word()],
        rng,
    );
    let k = U2F62::from_bits(u64::from(input(5)) << 32);
    both(
        warp::Cone::<G>::from_one_minus_cos(k),
        [word(), word()],
        rng,
    );
    both(warp::Cone::<G>::from_angle(word()), [word(), word()], rng);
    let n = U32F32::from_bits(u64::from(input(6)) << 32);
    both(warp::PhongLobe::<G>::new(n), [word(), word()], rng);
    both(Ok(warp::Triangle::<G>::new()), [word(), word()], rng);
    both(Ok(warp::StandardExponential::<G>::new()), word(), rng);
    both(warp::Exponential::<_, G>::new(mean), word(), rng);
    both(
        warp::TruncatedExponential::<_, G>::new(mean, length),
        word(),
        rng,
    );
    both(
        Ok(warp::StandardNormalPair::<G>::new()),
        [word(), word()],
        rng,
    );
    let centre = [short(input(8)), short(input(9))];
    both(
        warp::NormalPair::<_, G>::new(centre, short(input(10))),
        [word(), word()],
        rng,
    );
    both(warp::Tent::<_, G>::new(short(input(11))), word(), rng);
    let vertex = |i| [short(input(i)), short(input(i + 1)), short(input(i + 2))];
    let vertices = [vertex(13), vertex(16), vertex(19)];
    both(
        warp::TriangleOn::<_, 3, G>::new(vertices),
        [word(), word()],
        rng,
    );
    let vertices = vertices.map(|[x, y, _]| [x, y]);
    both(
        warp::TriangleOn::<_, 2, G>::new(vertices),
        [word(), word()],
        rng,
    );
    used(G::pow(word(), U16F16::from_bits(input(12))));
    used(G::exp_m1_neg(G::neg_ln_1m(word())));
}

/// The name that the check looks for, so that it knows it has read the right file.
#[unsafe(no_mangle)]
#[inline(never)]
fn microwarp_fixed(rng: &mut Pcg32) {
    grade::<Fine>(rng);
    grade::<Coarse>(rng);
    grade::<Compact>(rng);
    both(
        Interval::<i32>::new(input(1) as i32, input(2) as i32),
        word(),
        rng,
    );
    both(Interval::<u32>::inclusive(input(1), input(2)), word(), rng);
    let ends = [input(1), input(2)].map(U16F16::from_bits);
    both(Interval::<U16F16>::new(ends[0], ends[1]), word(), rng);
}

#[unsafe(no_mangle)]
#[inline(never)]
extern "C" fn probe_main() {
    let mut rng = Pcg32::new(input(1).into(), input(2).into());
    for _ in 0..input(100) {
        microwarp_fixed(&mut rng);
    }
}
