//! The route of f32: conversions bit by bit, and the same points as the warps under it.

use fixed::types::extra::{LeEqU32, U0, U1, U16, U27, U30, U31, U32};
use fixed::types::{I16F16, U0F32, U32F32};
use fixed::{FixedI32, FixedU32};
use microwarp::fixed::{FloatPoint, FloatUniforms};
use microwarp::uniform::{LARGEST, Uniforms};
use microwarp::{Invert, Warp, fixed as mw};
use rand_core::{Rng, TryRng};
use rand_pcg::Pcg32;

/// Bits of f32 at which conversions change: every exponent with the least and the largest fractions and one between,
/// of both signs: zeros, subnormals, infinities and NaN of both kinds among them.
fn patterns() -> impl Iterator<Item = f32> {
    (0..512_u32).flat_map(|head| {
        [
            0, 1, 2, 3, 0x155_5555, 0x2a_aaaa, 0x40_0000, 0x7f_fffd, 0x7f_fffe, 0x7f_ffff,
        ]
        .map(|fraction| f32::from_bits(head << 23 | fraction & 0x7f_ffff))
    })
}

#[test]
fn any_f32_becomes_the_word_of_its_canonical_uniform() {
    for u in patterns().chain([0.5, 1.0, LARGEST, f32::NAN, -f32::NAN]) {
        let canonical = f64::from(u.canonical().get());
        let due = (canonical * 4_294_967_296.0) as u32;
        assert_eq!(U0F32::words(u).to_bits(), due, "{u}");
        let [first, second] = <[U0F32; 2]>::words([u, 0.25]);
        assert_eq!((first.to_bits(), second.to_bits()), (due, 1 << 30));
    }
    // On the grid of 24 bits the way there and back is exact.
    for k in (0..1_u32 << 24).step_by(7) {
        let u = k as f32 / 16_777_216.0;
        let word = U0F32::words(u);
        assert_eq!(word.to_bits(), k << 8);
        assert_eq!(word.floats(), u);
    }
    assert_eq!(U0F32::MAX.floats(), LARGEST);
}

/// A number of magnitude below 2³³, cut to 24 digits, as f64 holds it.
fn cut(x: f64) -> f64 {
    f64::from_bits(x.to_bits() & !((1 << 29) - 1))
}

fn there<Frac: LeEqU32>(word: u32) {
    let one = 2_f64.powi(Frac::U32 as i32);
    let unsigned = FixedU32::<Frac>::from_bits(word);
    assert_eq!(
        f64::from(FloatPoint::to_float(unsigned)),
        cut(f64::from(word) / one)
    );
    let signed = FixedI32::<Frac>::from_bits(word as i32);
    assert_eq!(
        f64::from(FloatPoint::to_float(signed)),
        cut(f64::from(word as i32) / one)
    );
}

fn back<Frac: LeEqU32>(x: f32) {
    // Casts of floats to integers saturate, cut towards 0, and make 0 of NaN.
    let scaled = f64::from(x) * 2_f64.powi(Frac::U32 as i32);
    let unsigned: FixedU32<Frac> = FloatPoint::from_float(x);
    assert_eq!(unsigned.to_bits(), scaled as u32, "{x:e}");
    let signed: FixedI32<Frac> = FloatPoint::from_float(x);
    assert_eq!(signed.to_bits(), scaled as i32, "{x:e}");
}

#[test]
fn numbers_are_cut_to_24_digits_in_every_format() {
    let powers = (0..32).flat_map(|k| [(1_u32 << k) - 1, 1 << k, (1 << k) + 1, 0xffff_ffff << k]);
    let spread = (0..200_000_u32).map(|k| k.wrapping_mul(0x9e37_79b9) >> (k % 32));
    for word in powers.chain(spread).flat_map(|w| [w, w.wrapping_neg()]) {
        there::<U0>(word);
        there::<U1>(word);
        there::<U16>(word);
        there::<U27>(word);
        there::<U30>(word);
        there::<U31>(word);
        there::<U32>(word);
        assert_eq!(f64::from(FloatPoint::to_float(word)), cut(f64::from(word)));
        assert_eq!(
            f64::from(FloatPoint::to_float(word as i32)),
            cut(f64::from(word as i32))
        );
    }
}

#[test]
fn any_f32_becomes_the_nearest_number_towards_0() {
    let random = |k: u32| f32::from_bits(k.wrapping_mul(0x9e37_79b9));
    for x in patterns().chain((0..200_000).map(random)) {
        back::<U0>(x);
        back::<U1>(x);
        back::<U16>(x);
        back::<U27>(x);
        back::<U30>(x);
        back::<U31>(x);
        back::<U32>(x);
        assert_eq!(<i32 as FloatPoint>::from_float(x), x as i32);
        assert_eq!(<u32 as FloatPoint>::from_float(x), x as u32);
    }
}

/// Points, densities and inverses are those of the warp under it, converted.
fn agrees<W>(warp: W)
where
    W: Invert<Density = U32F32> + Copy,
    W::Uniforms: FloatUniforms,
    W::Point: FloatPoint,
    <W::Point as FloatPoint>::Float: core::fmt::Debug + PartialEq,
    <W::Uniforms as FloatUniforms>::Float: core::fmt::Debug + PartialEq,
{
    let float = mw::Float::new(warp);
    let mut random = Pcg32::new(7, 11);
    for _ in 0..100_000 {
        let canonical = <<W::Uniforms as FloatUniforms>::Float as Uniforms>::try_draw(&mut random);
        let Ok(canonical) = canonical;
        let u = canonical.get();
        let point = warp.sample(W::Uniforms::words(u));
        let got = float.sample(u);
        assert_eq!(got, point.to_float());
        assert_eq!(float.sample_canonical(canonical), got);
        let near = W::Point::from_float(got);
        let due = warp.pdf(near);
        let density = float.pdf(got);
        assert!(density > 0.0, "{got:?}");
        assert_eq!(f64::from(density), cut(due.to_num()));
        assert_eq!(float.invert(got), warp.invert(near).floats());
    }
    // Drawing takes the words themselves, all of their bits.
    let (mut one, mut other) = (Pcg32::new(1, 2), Pcg32::new(1, 2));
    for _ in 0..1000 {
        assert_eq!(float.draw(&mut one), warp.draw(&mut other).to_float());
    }
    assert_eq!(one.next_u32(), other.next_u32());
}

#[test]
fn points_are_those_of_the_warp_itself() {
    let number = I16F16::from_num::<f64>;
    agrees(mw::Disk::new());
    agrees(mw::coarse::Disk::new());
    agrees(mw::Sphere::new());
    agrees(mw::Hemisphere::new());
    agrees(mw::CosineHemisphere::new());
    agrees(mw::Cone::from_turns(U0F32::from_num(0.01)).unwrap());
    agrees(mw::Cone::from_turns(U0F32::from_num(0.4)).unwrap());
    agrees(mw::PhongLobe::new(U32F32::from_num(50)).unwrap());
    agrees(mw::Triangle::new());
    agrees(mw::StandardExponential::new());
    agrees(mw::StandardNormalPair::new());
    agrees(mw::NormalPair::new([number(3.5), number(-100.0)], number(2.25)).unwrap());
    agrees(mw::Tent::new(number(1.5)).unwrap());
    agrees(mw::Interval::<I16F16>::new(number(-3.25), number(5.0)).unwrap());
    agrees(mw::Interval::<i32>::inclusive(-7, 7).unwrap());
    let mean = FixedU32::<U16>::from_num(10);
    agrees(mw::Exponential::from_mean(mean).unwrap());
    agrees(mw::TruncatedExponential::from_mean(mean, FixedU32::from_num(3)).unwrap());
}

#[test]
fn any_f32_serves_as_a_uniform_or_a_point() {
    let disk = mw::Float::new(mw::Disk::new());
    for a in patterns() {
        for b in [0.0, 0.75, f32::NAN, f32::INFINITY, -1.0, 1.0] {
            let [x, y] = disk.sample([a, b]);
            assert_eq!([x, y], disk.sample_canonical([a, b].canonical()));
            assert!(f64::from(x).powi(2) + f64::from(y).powi(2) <= 1.0);
            for density in [disk.pdf([a, b]), disk.pdf([b, a])] {
                assert!(density == 0.0 || (density - core::f32::consts::FRAC_1_PI).abs() < 1e-7);
            }
            for u in disk.invert([a, b]) {
                assert!((0.0..1.0).contains(&u));
            }
        }
    }
    assert_eq!(disk.pdf([f32::INFINITY, 0.0]), 0.0);
    assert_eq!(disk.pdf([f32::NAN, 0.0]), disk.pdf([0.0, 0.0]));
}

/// A generator that fails.
#[derive(Debug)]
struct Broken;

impl TryRng for Broken {
    type Error = core::fmt::Error;

    fn try_next_u32(&mut self) -> Result<u32, Self::Error> {
        Err(core::fmt::Error)
    }

    fn try_next_u64(&mut self) -> Result<u64, Self::Error> {
        Err(core::fmt::Error)
    }

    fn try_fill_bytes(&mut self, _: &mut [u8]) -> Result<(), Self::Error> {
        Err(core::fmt::Error)
    }
}

#[test]
fn a_failing_generator_s_error_is_handed_on() {
    let disk = mw::Float::new(mw::Disk::new());
    assert_eq!(disk.try_draw(&mut Broken), Err(core::fmt::Error));
}
