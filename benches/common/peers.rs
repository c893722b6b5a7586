//! The peers: what a user of rand_distr, of micromath or of the formulas in books over libm would write in place of
//! a warp, each as a plain function.
//!
//! Maps take their uniforms explicitly, so that their errors can be measured beside ours; [`drawn`] puts a generator
//! before them. What rejects takes the generator itself. Everything is in `f32`, as far as the peer lets it be, and
//! marked to be inlined, as the generic functions of the peers and our own are wherever they are used.

#![allow(dead_code, reason = "each bench and example uses a part")]

use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;

/// A uniform as `rand` and everyone else makes it: the upper 24 bits of a word.
#[inline]
pub fn uniform(rng: &mut Pcg32) -> f32 {
    (rng.next_u32() >> 8) as f32 * (1.0 / 16_777_216.0)
}

/// Draws the uniforms of a map, in order.
#[inline]
pub fn drawn<const N: usize, P>(map: impl Fn([f32; N]) -> P) -> impl Fn(&mut Pcg32) -> P {
    move |rng| map(std::array::from_fn(|_| uniform(rng)))
}

/// The formulas as they stand in books, over the functions of the `libm` crate.
pub mod textbook {
    use libm::{cbrtf, logf, powf, sincosf, sqrtf};
    use std::f32::consts::TAU;

    /// The unit disk: radius √u₁, angle 2πu₂.
    #[inline]
    pub fn disk([u1, u2]: [f32; 2]) -> [f32; 2] {
        let r = sqrtf(u1);
        let (s, c) = sincosf(TAU * u2);
        [r * c, r * s]
    }

    /// The unit circle: angle 2πu.
    #[inline]
    pub fn circle([u]: [f32; 1]) -> [f32; 2] {
        let (s, c) = sincosf(TAU * u);
        [c, s]
    }

    /// The direction of height z, 2πu about the axis.
    #[inline]
    fn at_height(z: f32, u: f32) -> [f32; 3] {
        let r = sqrtf(1.0 - z * z);
        let (s, c) = sincosf(TAU * u);
        [r * c, r * s, z]
    }

    /// The unit sphere: z = 1 − 2u₁.
    #[inline]
    pub fn sphere([u1, u2]: [f32; 2]) -> [f32; 3] {
        at_height(1.0 - 2.0 * u1, u2)
    }

    /// The upper half of it: z = u₁.
    #[inline]
    pub fn hemisphere([u1, u2]: [f32; 2]) -> [f32; 3] {
        at_height(u1, u2)
    }

    /// In proportion to the cosine: a point of the disk, lifted to √(1 − u₁).
    #[inline]
    pub fn cosine_hemisphere([u1, u2]: [f32; 2]) -> [f32; 3] {
        let [x, y] = disk([u1, u2]);
        [x, y, sqrtf(1.0 - u1)]
    }

    /// In proportion to the nth power of the cosine, of `exponent` 1/(n + 1): z = u₁^(1/(n + 1)).
    #[inline]
    pub fn lobe(exponent: f32, [u1, u2]: [f32; 2]) -> [f32; 3] {
        at_height(powf(u1, exponent), u2)
    }

    /// The exponential distribution of mean 1: −ln(1 − u).
    #[inline]
    pub fn exponential([u]: [f32; 1]) -> f32 {
        -logf(1.0 - u)
    }

    /// The exponential distribution of a rate: −ln(1 − u)/rate.
    #[inline]
    pub fn exponential_of_rate(rate: f32, [u]: [f32; 1]) -> f32 {
        -logf(1.0 - u) / rate
    }

    /// Two standard normals, by Box and Muller.
    #[inline]
    pub fn normal_pair([u1, u2]: [f32; 2]) -> [f32; 2] {
        let r = sqrtf(-2.0 * logf(1.0 - u1));
        let (s, c) = sincosf(TAU * u2);
        [r * c, r * s]
    }

    /// The unit ball: a direction times the cube root of a uniform.
    #[inline]
    pub fn ball([u1, u2, u3]: [f32; 3]) -> [f32; 3] {
        let r = cbrtf(u3);
        sphere([u1, u2]).map(|x| r * x)
    }

    /// The distribution over indices as running sums in `f32`, searched by halving.
    pub struct Sums(Vec<f32>);

    impl Sums {
        pub fn new(weights: &[f32]) -> Self {
            let running = weights.iter().scan(0.0, |sum, weight| {
                *sum += weight;
                Some(*sum)
            });
            Self(running.collect())
        }

        #[inline]
        pub fn index(&self, [u]: [f32; 1]) -> usize {
            let (total, sums) = self.0.split_last().expect("weights");
            let target = u * total;
            sums.partition_point(|&sum| sum <= target)
        }
    }
}

/// The same formulas over the functions of micromath.
pub mod micro {
    use micromath::F32;
    use std::f32::consts::TAU;

    #[inline]
    fn sqrt(x: f32) -> f32 {
        F32(x).sqrt().0
    }

    #[inline]
    fn sin_cos(x: f32) -> (f32, f32) {
        let (s, c) = F32(x).sin_cos();
        (s.0, c.0)
    }

    /// The unit disk: radius √u₁, angle 2πu₂.
    #[inline]
    pub fn disk([u1, u2]: [f32; 2]) -> [f32; 2] {
        let r = sqrt(u1);
        let (s, c) = sin_cos(TAU * u2);
        [r * c, r * s]
    }

    /// The unit circle: angle 2πu.
    #[inline]
    pub fn circle([u]: [f32; 1]) -> [f32; 2] {
        let (s, c) = sin_cos(TAU * u);
        [c, s]
    }

    /// The direction of height z, 2πu about the axis.
    #[inline]
    fn at_height(z: f32, u: f32) -> [f32; 3] {
        let r = sqrt(1.0 - z * z);
        let (s, c) = sin_cos(TAU * u);
        [r * c, r * s, z]
    }

    /// The unit sphere: z = 1 − 2u₁.
    #[inline]
    pub fn sphere([u1, u2]: [f32; 2]) -> [f32; 3] {
        at_height(1.0 - 2.0 * u1, u2)
    }

    /// The upper half of it: z = u₁.
    #[inline]
    pub fn hemisphere([u1, u2]: [f32; 2]) -> [f32; 3] {
        at_height(u1, u2)
    }

    /// In proportion to the cosine: a point of the disk, lifted to √(1 − u₁).
    #[inline]
    pub fn cosine_hemisphere([u1, u2]: [f32; 2]) -> [f32; 3] {
        let [x, y] = disk([u1, u2]);
        [x, y, sqrt(1.0 - u1)]
    }

    /// In proportion to the nth power of the cosine, of `exponent` 1/(n + 1): z = u₁^(1/(n + 1)).
    #[inline]
    pub fn lobe(exponent: f32, [u1, u2]: [f32; 2]) -> [f32; 3] {
        at_height(F32(u1).powf(F32(exponent)).0, u2)
    }

    /// The exponential distribution of mean 1: −ln(1 − u).
    #[inline]
    pub fn exponential([u]: [f32; 1]) -> f32 {
        -F32(1.0 - u).ln().0
    }

    /// Two standard normals, by Box and Muller.
    #[inline]
    pub fn normal_pair([u1, u2]: [f32; 2]) -> [f32; 2] {
        let r = sqrt(-2.0 * F32(1.0 - u1).ln().0);
        let (s, c) = sin_cos(TAU * u2);
        [r * c, r * s]
    }
}

/// The samplers of rand_distr, and what its users put together from them where it has none. They reject, so that
/// the number of words they draw is random.
pub mod rejecting {
    use super::uniform;
    use rand_distr::weighted::{WeightedAliasIndex, WeightedIndex};
    use rand_distr::{Distribution, Exp1, StandardNormal};
    use rand_distr::{UnitBall, UnitCircle, UnitDisc, UnitSphere};
    use rand_pcg::Pcg32;

    /// The unit disk: `UnitDisc`.
    #[inline]
    pub fn disk(rng: &mut Pcg32) -> [f32; 2] {
        UnitDisc.sample(rng)
    }

    /// The unit circle: `UnitCircle`.
    #[inline]
    pub fn circle(rng: &mut Pcg32) -> [f32; 2] {
        UnitCircle.sample(rng)
    }

    /// The unit sphere: `UnitSphere`.
    #[inline]
    pub fn sphere(rng: &mut Pcg32) -> [f32; 3] {
        UnitSphere.sample(rng)
    }

    /// The upper half of it: `UnitSphere`, folded.
    #[inline]
    pub fn hemisphere(rng: &mut Pcg32) -> [f32; 3] {
        let [x, y, z] = sphere(rng);
        [x, y, z.abs()]
    }

    /// In proportion to the cosine: `UnitDisc`, lifted.
    #[inline]
    pub fn cosine_hemisphere(rng: &mut Pcg32) -> [f32; 3] {
        let [x, y] = disk(rng);
        [x, y, (1.0 - (x * x + y * y)).max(0.0).sqrt()]
    }

    /// In proportion to the nth power of the cosine, of `exponent` 1/(n + 1): `UnitCircle` at a height that is a
    /// power of a uniform.
    #[inline]
    pub fn lobe(exponent: f32, rng: &mut Pcg32) -> [f32; 3] {
        let z = uniform(rng).powf(exponent);
        let r = (1.0 - z * z).sqrt();
        let [x, y] = circle(rng);
        [r * x, r * y, z]
    }

    /// The exponential distribution of mean 1: `Exp1`.
    #[inline]
    pub fn exponential(rng: &mut Pcg32) -> f32 {
        Exp1.sample(rng)
    }

    /// One standard normal: `StandardNormal`.
    #[inline]
    pub fn normal(rng: &mut Pcg32) -> f32 {
        StandardNormal.sample(rng)
    }

    /// The unit ball: `UnitBall`.
    #[inline]
    pub fn ball(rng: &mut Pcg32) -> [f32; 3] {
        UnitBall.sample(rng)
    }

    /// Indices by running sums: `WeightedIndex<f32>`.
    pub fn cumulative(weights: &[f32]) -> impl Fn(&mut Pcg32) -> usize + use<> {
        let table = WeightedIndex::new(weights.iter().copied()).expect("weights");
        move |rng| table.sample(rng)
    }

    /// Indices by Walker's aliases: `WeightedAliasIndex<f32>`.
    pub fn aliases(weights: &[f32]) -> impl Fn(&mut Pcg32) -> usize + use<> {
        let table = WeightedAliasIndex::new(weights.to_vec()).expect("weights");
        move |rng| table.sample(rng)
    }
}
