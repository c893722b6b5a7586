//! The registry of what is measured, one function a line.
#![allow(
    dead_code,
    unused_imports,
    reason = "a measurement compiles one line and leaves the others out"
)]

use crate::count::{Entry, empty};
use crate::words::{Input, Output};
use fixed::types::{I2F30, I5F27, I16F16, U0F32, U2F62, U5F27, U16F16, U32F32};
use microwarp::Warp;
use microwarp::discrete::{Alias, AliasEntry, Cdf};
use microwarp::fixed::{Coarse, Compact, Fine, Grade};
use microwarp::rejection::{BallRejection, DiskRejection, Rejection, ZigguratStandardExponential, ZigguratStandardNormal};
use microwarp::{fixed as integer, libm, poly};
use rand_core::Rng;
use rand_pcg::Pcg32;

/// `"name" (inputs) -> outputs = expression;`
///
/// Inputs are numbers of a word each, written `name: type` (`words.rs` says which types there are and which
/// numbers each gets), or `(rng)`, a generator in memory, whose cost is part of the kernel's. Outputs are one
/// such number, an array or a tuple of them.
macro_rules! kernels {
    ($($name:literal $inputs:tt -> $out:ty = $body:expr;)*) => {
        /// Every entry; a measurement leaves one.
        pub static REGISTRY: &[Entry] = &[
            $(#[cfg(any(not(one_kernel), kernel = $name))] entry!($name $inputs -> $out = $body),)*
        ];
    };
}

macro_rules! entry {
    ($name:literal ($($input:ident: $type:ty),+) -> $out:ty = $body:expr) => {{
        const INPUTS: usize = [$(stringify!($input)),+].len();
        #[unsafe(export_name = $name)]
        #[inline(never)]
        extern "C" fn kernel(at: *mut u32, to: *mut u32) {
            // SAFETY: the entry below says how many words there are.
            let [$($input),+] = core::array::from_fn(|index| at.wrapping_add(index));
            $(let $input = unsafe { $input.cast::<$type>().read_volatile() };)+
            let out: $out = $body;
            unsafe { out.store(to) }
        }
        Entry {
            kernel,
            empty: empty::<INPUTS, $out>,
            inputs: INPUTS,
            outputs: <$out>::WORDS,
            fill: |mut random, words| {
                for call in words.chunks_exact_mut(INPUTS) {
                    let mut word = call.iter_mut();
                    $(if let Some(word) = word.next() { *word = <$type>::bits(random.next_u32()) })+
                }
            },
        }
    }};
    ($name:literal ($rng:ident) -> $out:ty = $body:expr) => {{
        #[unsafe(export_name = $name)]
        #[inline(never)]
        extern "C" fn kernel(at: *mut u32, to: *mut u32) {
            // SAFETY: the entry below puts a generator there, and nobody else uses it.
            let $rng = unsafe { &mut *at.cast::<Pcg32>() };
            let out: $out = $body;
            unsafe { out.store(to) }
        }
        Entry {
            kernel,
            empty: empty::<0, $out>,
            inputs: 0,
            outputs: <$out>::WORDS,
            fill: |random, words| unsafe { words.as_mut_ptr().cast::<Pcg32>().write(random) },
        }
    }};
}

/// A parameter that was accepted, at compile time.
const fn ok<T: Copy>(result: Result<T, microwarp::Error>) -> T {
    match result {
        Ok(value) => value,
        Err(_) => panic!("refused"),
    }
}

/// Weights of a table, no two neighbours alike.
const fn weights<const N: usize>() -> [f32; N] {
    let mut weights = [0.0; N];
    let mut index = 0;
    while index < N {
        weights[index] = (index * 37 % 101 + 1) as f32;
        index += 1;
    }
    weights
}

/// The vertices of a triangle.
const FACET: [[I16F16; 2]; 3] = [
    [I16F16::from_bits(-90 << 16), I16F16::from_bits(10 << 16)],
    [I16F16::from_bits(300 << 16), I16F16::from_bits(-200 << 16)],
    [I16F16::from_bits(40 << 16), I16F16::from_bits(250 << 16)],
];

kernels! {
    // The generator alone, for those rows that contain it.
    "pcg32_word" (rng) -> u32 = rng.next_u32();
    "pcg32_two_words" (rng) -> [u32; 2] = [rng.next_u32(), rng.next_u32()];

    // The float tiers.
    "poly_disk" (u: f32, v: f32) -> [f32; 2] = poly::Disk::new().sample([u, v]);
    "poly_sphere" (u: f32, v: f32) -> [f32; 3] = poly::Sphere::new().sample([u, v]);
    "poly_cosine_hemisphere" (u: f32, v: f32) -> [f32; 3] = poly::CosineHemisphere::new().sample([u, v]);
    "poly_phong_lobe_50" (u: f32, v: f32) -> [f32; 3] = const { ok(poly::PhongLobe::new(50.0)) }.sample([u, v]);
    "poly_exponential_1" (u: f32) -> f32 = const { ok(poly::Exponential::new(1.0)) }.sample(u);
    "poly_normal_pair" (u: f32, v: f32) -> [f32; 2] = const { ok(poly::NormalPair::new([0.0; 2], 1.0)) }.sample([u, v]);
    "libm_disk" (u: f32, v: f32) -> [f32; 2] = libm::Disk::new().sample([u, v]);
    "libm_sphere" (u: f32, v: f32) -> [f32; 3] = libm::Sphere::new().sample([u, v]);
    "libm_cosine_hemisphere" (u: f32, v: f32) -> [f32; 3] = libm::CosineHemisphere::new().sample([u, v]);
    "libm_phong_lobe_50" (u: f32, v: f32) -> [f32; 3] = const { ok(libm::PhongLobe::new(50.0)) }.sample([u, v]);
    "libm_exponential_1" (u: f32) -> f32 = const { ok(libm::Exponential::new(1.0)) }.sample(u);
    "libm_normal_pair" (u: f32, v: f32) -> [f32; 2] = const { ok(libm::NormalPair::new([0.0; 2], 1.0)) }.sample([u, v]);

    // The functions under the integer tier, in each grade.
    "fine_sincos_turns" (t: U0F32) -> (I2F30, I2F30) = Fine::sincos_turns(t);
    "fine_atan2_turns" (y: I2F30, x: I2F30) -> U0F32 = Fine::atan2_turns(y, x);
    "fine_sqrt" (x: U0F32) -> U0F32 = Fine::sqrt(x);
    "fine_neg_ln_1m" (u: U0F32) -> U5F27 = Fine::neg_ln_1m(u);
    "fine_exp_neg" (x: U5F27) -> U0F32 = Fine::exp_neg(x);
    "fine_exp_m1_neg" (x: U5F27) -> U0F32 = Fine::exp_m1_neg(x);
    "fine_pow" (x: U0F32, y: U16F16) -> U0F32 = Fine::pow(x, y);
    "coarse_sincos_turns" (t: U0F32) -> (I2F30, I2F30) = Coarse::sincos_turns(t);
    "coarse_atan2_turns" (y: I2F30, x: I2F30) -> U0F32 = Coarse::atan2_turns(y, x);
    "coarse_sqrt" (x: U0F32) -> U0F32 = Coarse::sqrt(x);
    "coarse_neg_ln_1m" (u: U0F32) -> U5F27 = Coarse::neg_ln_1m(u);
    "coarse_exp_neg" (x: U5F27) -> U0F32 = Coarse::exp_neg(x);
    "coarse_exp_m1_neg" (x: U5F27) -> U0F32 = Coarse::exp_m1_neg(x);
    "coarse_pow" (x: U0F32, y: U16F16) -> U0F32 = Coarse::pow(x, y);
    "compact_sincos_turns" (t: U0F32) -> (I2F30, I2F30) = Compact::sincos_turns(t);
    "compact_atan2_turns" (y: I2F30, x: I2F30) -> U0F32 = Compact::atan2_turns(y, x);
    "compact_sqrt" (x: U0F32) -> U0F32 = Compact::sqrt(x);
    "compact_neg_ln_1m" (u: U0F32) -> U5F27 = Compact::neg_ln_1m(u);
    "compact_exp_neg" (x: U5F27) -> U0F32 = Compact::exp_neg(x);
    "compact_exp_m1_neg" (x: U5F27) -> U0F32 = Compact::exp_m1_neg(x);
    "compact_pow" (x: U0F32, y: U16F16) -> U0F32 = Compact::pow(x, y);

    // The integer tier.
    "fine_disk" (u: U0F32, v: U0F32) -> [I2F30; 2] = integer::Disk::new().sample([u, v]);
    "fine_disk_pcg32" (rng) -> [I2F30; 2] = integer::Disk::new().draw(rng);
    "coarse_disk" (u: U0F32, v: U0F32) -> [I2F30; 2] = integer::coarse::Disk::new().sample([u, v]);
    "compact_disk" (u: U0F32, v: U0F32) -> [I2F30; 2] = integer::compact::Disk::new().sample([u, v]);
    "fine_sphere" (u: U0F32, v: U0F32) -> [I2F30; 3] = integer::Sphere::new().sample([u, v]);
    "fine_hemisphere" (u: U0F32, v: U0F32) -> [I2F30; 3] = integer::Hemisphere::new().sample([u, v]);
    "fine_cosine_hemisphere" (u: U0F32, v: U0F32) -> [I2F30; 3] = integer::CosineHemisphere::new().sample([u, v]);
    "fine_cone" (u: U0F32, v: U0F32) -> [I2F30; 3] = const { ok(integer::Cone::from_one_minus_cos(U2F62::from_bits(1 << 60))) }.sample([u, v]);
    "fine_phong_lobe_50" (u: U0F32, v: U0F32) -> [I2F30; 3] = const { ok(integer::PhongLobe::new(U32F32::from_bits(50 << 32))) }.sample([u, v]);
    "coarse_sphere" (u: U0F32, v: U0F32) -> [I2F30; 3] = integer::coarse::Sphere::new().sample([u, v]);
    "coarse_hemisphere" (u: U0F32, v: U0F32) -> [I2F30; 3] = integer::coarse::Hemisphere::new().sample([u, v]);
    "coarse_cosine_hemisphere" (u: U0F32, v: U0F32) -> [I2F30; 3] = integer::coarse::CosineHemisphere::new().sample([u, v]);
    "coarse_cone" (u: U0F32, v: U0F32) -> [I2F30; 3] = const { ok(integer::coarse::Cone::from_one_minus_cos(U2F62::from_bits(1 << 60))) }.sample([u, v]);
    "coarse_phong_lobe_50" (u: U0F32, v: U0F32) -> [I2F30; 3] = const { ok(integer::coarse::PhongLobe::new(U32F32::from_bits(50 << 32))) }.sample([u, v]);
    "compact_sphere" (u: U0F32, v: U0F32) -> [I2F30; 3] = integer::compact::Sphere::new().sample([u, v]);
    "compact_hemisphere" (u: U0F32, v: U0F32) -> [I2F30; 3] = integer::compact::Hemisphere::new().sample([u, v]);
    "compact_cosine_hemisphere" (u: U0F32, v: U0F32) -> [I2F30; 3] = integer::compact::CosineHemisphere::new().sample([u, v]);
    "compact_cone" (u: U0F32, v: U0F32) -> [I2F30; 3] = const { ok(integer::compact::Cone::from_one_minus_cos(U2F62::from_bits(1 << 60))) }.sample([u, v]);
    "compact_phong_lobe_50" (u: U0F32, v: U0F32) -> [I2F30; 3] = const { ok(integer::compact::PhongLobe::new(U32F32::from_bits(50 << 32))) }.sample([u, v]);
    "fine_standard_exponential" (u: U0F32) -> U5F27 = integer::StandardExponential::new().sample(u);
    "fine_exponential_20" (u: U0F32) -> U16F16 = const { ok(integer::Exponential::new(U16F16::from_bits(20 << 16))) }.sample(u);
    "fine_truncated_exponential_10_20" (u: U0F32) -> U16F16 = const { ok(integer::TruncatedExponential::new(U16F16::from_bits(10 << 16), U16F16::from_bits(20 << 16))) }.sample(u);
    "fine_truncated_exponential_10_1" (u: U0F32) -> U16F16 = const { ok(integer::TruncatedExponential::new(U16F16::from_bits(10 << 16), U16F16::from_bits(1 << 16))) }.sample(u);
    "fine_standard_normal_pair" (u: U0F32, v: U0F32) -> [I5F27; 2] = integer::StandardNormalPair::new().sample([u, v]);
    "fine_normal_pair_100_5" (u: U0F32, v: U0F32) -> [I16F16; 2] = const { ok(integer::NormalPair::new([I16F16::from_bits(100 << 16); 2], I16F16::from_bits(5 << 16))) }.sample([u, v]);
    "fine_tent_2" (u: U0F32) -> I16F16 = const { ok(integer::Tent::new(I16F16::from_bits(2 << 16))) }.sample(u);
    "fine_triangle" (u: U0F32, v: U0F32) -> [I2F30; 3] = integer::Triangle::new().sample([u, v]);
    "fine_triangle_on" (u: U0F32, v: U0F32) -> [I16F16; 2] = const { ok(integer::TriangleOn::new(FACET)) }.sample([u, v]);
    "coarse_standard_exponential" (u: U0F32) -> U5F27 = integer::coarse::StandardExponential::new().sample(u);
    "coarse_exponential_20" (u: U0F32) -> U16F16 = const { ok(integer::coarse::Exponential::new(U16F16::from_bits(20 << 16))) }.sample(u);
    "coarse_truncated_exponential_10_20" (u: U0F32) -> U16F16 = const { ok(integer::coarse::TruncatedExponential::new(U16F16::from_bits(10 << 16), U16F16::from_bits(20 << 16))) }.sample(u);
    "coarse_truncated_exponential_10_1" (u: U0F32) -> U16F16 = const { ok(integer::coarse::TruncatedExponential::new(U16F16::from_bits(10 << 16), U16F16::from_bits(1 << 16))) }.sample(u);
    "coarse_standard_normal_pair" (u: U0F32, v: U0F32) -> [I5F27; 2] = integer::coarse::StandardNormalPair::new().sample([u, v]);
    "coarse_normal_pair_100_5" (u: U0F32, v: U0F32) -> [I16F16; 2] = const { ok(integer::coarse::NormalPair::new([I16F16::from_bits(100 << 16); 2], I16F16::from_bits(5 << 16))) }.sample([u, v]);
    "coarse_tent_2" (u: U0F32) -> I16F16 = const { ok(integer::coarse::Tent::new(I16F16::from_bits(2 << 16))) }.sample(u);
    "coarse_triangle" (u: U0F32, v: U0F32) -> [I2F30; 3] = integer::coarse::Triangle::new().sample([u, v]);
    "coarse_triangle_on" (u: U0F32, v: U0F32) -> [I16F16; 2] = const { ok(integer::coarse::TriangleOn::new(FACET)) }.sample([u, v]);
    "compact_standard_exponential" (u: U0F32) -> U5F27 = integer::compact::StandardExponential::new().sample(u);
    "compact_exponential_20" (u: U0F32) -> U16F16 = const { ok(integer::compact::Exponential::new(U16F16::from_bits(20 << 16))) }.sample(u);
    "compact_truncated_exponential_10_20" (u: U0F32) -> U16F16 = const { ok(integer::compact::TruncatedExponential::new(U16F16::from_bits(10 << 16), U16F16::from_bits(20 << 16))) }.sample(u);
    "compact_truncated_exponential_10_1" (u: U0F32) -> U16F16 = const { ok(integer::compact::TruncatedExponential::new(U16F16::from_bits(10 << 16), U16F16::from_bits(1 << 16))) }.sample(u);
    "compact_standard_normal_pair" (u: U0F32, v: U0F32) -> [I5F27; 2] = integer::compact::StandardNormalPair::new().sample([u, v]);
    "compact_normal_pair_100_5" (u: U0F32, v: U0F32) -> [I16F16; 2] = const { ok(integer::compact::NormalPair::new([I16F16::from_bits(100 << 16); 2], I16F16::from_bits(5 << 16))) }.sample([u, v]);
    "compact_tent_2" (u: U0F32) -> I16F16 = const { ok(integer::compact::Tent::new(I16F16::from_bits(2 << 16))) }.sample(u);
    "compact_triangle" (u: U0F32, v: U0F32) -> [I2F30; 3] = integer::compact::Triangle::new().sample([u, v]);
    "compact_triangle_on" (u: U0F32, v: U0F32) -> [I16F16; 2] = const { ok(integer::compact::TriangleOn::new(FACET)) }.sample([u, v]);
    "interval_1_6" (u: U0F32) -> i32 = const { ok(integer::Interval::<i32>::inclusive(1, 6)) }.sample(u);
    "fine_float_disk" (u: f32, v: f32) -> [f32; 2] = integer::Float::new(integer::Disk::new()).sample([u, v]);
    "fine_float_sphere" (u: f32, v: f32) -> [f32; 3] = integer::Float::new(integer::Sphere::new()).sample([u, v]);
    "fine_float_cosine_hemisphere" (u: f32, v: f32) -> [f32; 3] = integer::Float::new(integer::CosineHemisphere::new()).sample([u, v]);
    "fine_float_phong_lobe_50" (u: f32, v: f32) -> [f32; 3] = integer::Float::new(const { ok(integer::PhongLobe::new(U32F32::from_bits(50 << 32))) }).sample([u, v]);
    "fine_float_standard_exponential" (u: f32) -> f32 = integer::Float::new(integer::StandardExponential::new()).sample(u);
    "fine_float_standard_normal_pair" (u: f32, v: f32) -> [f32; 2] = integer::Float::new(integer::StandardNormalPair::new()).sample([u, v]);
    "coarse_float_disk" (u: f32, v: f32) -> [f32; 2] = integer::Float::new(integer::coarse::Disk::new()).sample([u, v]);
    "coarse_float_sphere" (u: f32, v: f32) -> [f32; 3] = integer::Float::new(integer::coarse::Sphere::new()).sample([u, v]);
    "coarse_float_cosine_hemisphere" (u: f32, v: f32) -> [f32; 3] = integer::Float::new(integer::coarse::CosineHemisphere::new()).sample([u, v]);
    "coarse_float_phong_lobe_50" (u: f32, v: f32) -> [f32; 3] = integer::Float::new(const { ok(integer::coarse::PhongLobe::new(U32F32::from_bits(50 << 32))) }).sample([u, v]);
    "coarse_float_standard_exponential" (u: f32) -> f32 = integer::Float::new(integer::coarse::StandardExponential::new()).sample(u);
    "coarse_float_standard_normal_pair" (u: f32, v: f32) -> [f32; 2] = integer::Float::new(integer::coarse::StandardNormalPair::new()).sample([u, v]);

    // Tables in flash, by a word.
    "alias_1024" (word: u32) -> usize = {
        static TABLE: Alias<[AliasEntry<u32>; 1024]> = ok(Alias::<[AliasEntry<u32>; 1024]>::new(&weights::<1024>()));
        TABLE.index(word)
    };
    "cdf_1024" (word: u32) -> usize = {
        static TABLE: Cdf<[u32; 1024]> = ok(Cdf::<[u32; 1024]>::new(&weights::<1024>()));
        TABLE.index(word)
    };

    // Rejection, with its generator.
    "rejection_disk_pcg32" (rng) -> [f32; 2] = DiskRejection::new().draw(rng).map_or([0.0; 2], |accepted| accepted.point);
    "rejection_ball_pcg32" (rng) -> [f32; 3] = BallRejection::new().draw(rng).map_or([0.0; 3], |accepted| accepted.point);
    "fixed_disk_rejection_pcg32" (rng) -> [I2F30; 2] = integer::DiskRejection::new().draw(rng).map_or([I2F30::ZERO; 2], |accepted| accepted.point);
    "fixed_disk_rejection16_pcg32" (rng) -> [I2F30; 2] = integer::DiskRejection16::new().draw(rng).map_or([I2F30::ZERO; 2], |accepted| accepted.point);
    "ziggurat_normal_pcg32" (rng) -> f32 = ZigguratStandardNormal::new().draw(rng).map_or(0.0, |accepted| accepted.point);
    "ziggurat_exponential_pcg32" (rng) -> f32 = ZigguratStandardExponential::new().draw(rng).map_or(0.0, |accepted| accepted.point);
}
