//! The uniform distribution on the simplex of any dimension.

use super::{Invert, Warp};
use crate::num::into_unit;
use crate::tier::Tier;
use crate::uniform::Canonical;
use core::marker::PhantomData;

/// Uniform on the simplex of N dimensions: N shares and the rest, none negative, with sum 1.
///
/// Each share is taken from what the earlier ones leave: xⱼ = rest · (1 − (1 − uⱼ)^(1/m)) with m = N, N − 1, …, 1, and the
/// rest keeps the other part. Both parts come from one exponential that is accurate at either end, so that every share
/// has a small relative error, however small it is.
///
#[cfg_attr(doc, doc = include_str!("../pictures/simplex.html"))]
///
/// The shares are barycentric coordinates of a segment, a triangle, a tetrahedron and so on, or the weights of a
/// mixture, or the lengths into which N uniform points divide [0, 1].
///
/// # Density
/// N! with respect to the N shares, where neither they nor the rest are negative and their sum is 1 to rounding; else 0.
///
/// # Domain
/// - Point: the N shares, and the rest.
/// - Uniforms: N. Each share increases with its own.
/// - N from 1 to 34, the largest whose density `f32` can hold. Others do not compile.
///
/// # Accuracy
/// *Sample* is the distance from the exact point, relative to the size 1. *Pdf* and *realised density* are
/// relative, *inverse* and *round trip* are absolute errors of the uniforms. [What each row
/// means](crate::warp#stated-errors).
///
/// | error | bound | kind |
/// |---|--:|---|
/// | sample, of the size | 1e-7 + 5.5e-8*n | found |
/// | pdf, relative | 6e-8 | exhaustive |
/// | realised density, relative | 6e-8 | exhaustive |
/// | inverse | 1.6e-7 + 5.5e-8*n | found |
/// | round trip | min(9e-8 + 1e-7·n, 2.5e-7 + 5.5e-8·n) | found |
///
/// n is the number of dimensions. The relative error of the jth share is at most j·3.5e-7, and that of the rest (n + 1)·3.5e-7,
/// unless it is subnormal. Their sum is 1 to 1e-7 + 5.5e-8·n.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost Simplex -->50 instructions and 244 bytes of code on an M4F, 1,678 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// let segment = mw::Simplex::<1>::new();
/// assert_eq!(segment.sample([0.25]), ([0.25], 0.75));
/// let tetrahedron = mw::Simplex::<3>::new();
/// let ([a, b, c], d) = tetrahedron.sample([0.3, 0.6, 0.9]);
/// assert!((a + b + c + d - 1.0).abs() < 1e-6);
/// assert_eq!(tetrahedron.pdf(([a, b, c], d)), 6.0);
/// ```
///
/// # See also
/// - [`Triangle`](super::Triangle): two dimensions, without a logarithm.
/// - [`Aabb`](super::Aabb): the box.
/// - `fixed::Simplex`, with feature `fixed`: on integers.
///
/// # Source
/// L. Devroye, "Non-Uniform Random Variate Generation", 1986, <https://doi.org/10.1007/978-1-4613-8643-8>.
#[doc(alias = "barycentric")]
#[doc(alias = "tetrahedron")]
#[doc(alias = "dirichlet")]
#[doc(alias = "spacings")]
#[doc(alias = "uniform")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Simplex<T, const N: usize>(PhantomData<T>);

impl<T: Tier, const N: usize> Simplex<T, N> {
    /// N!, which is exact up to 2⁵³ as a double and then rounded to far less than a step of `f32`.
    const DENSITY: f32 = {
        let (mut product, mut n) = (1.0_f64, 1.0_f64);
        while n <= N as f64 {
            product *= n;
            n += 1.0;
        }
        product as f32
    };

    /// The simplex of N dimensions, with N + 1 corners.
    #[must_use]
    pub const fn new() -> Self {
        const { assert!(N > 0 && N < 35, "a simplex has 1 to 34 dimensions here") };
        Self(PhantomData)
    }
}

impl<T: Tier, const N: usize> Default for Simplex<T, N> {
    fn default() -> Self {
        Self::new()
    }
}

/// (1 − (1 − u)^(1/m), (1 − u)^(1/m)), both accurate where they are small.
#[inline]
fn parts<T: Tier>(u: f32, m: usize) -> (f32, f32) {
    match m {
        1 => (u, 1.0 - u),
        2 => {
            let root = T::sqrt(1.0 - u);
            (u / (1.0 + root), root)
        }
        _ => {
            let (left, taken) = T::exp_neg_pair(T::neg_ln_1m(u) / m as f32);
            (taken, left)
        }
    }
}

impl<T: Tier, const N: usize> Warp for Simplex<T, N> {
    type Uniforms = [f32; N];
    type Point = ([f32; N], f32);
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<[f32; N]>) -> ([f32; N], f32) {
        let (mut shares, mut rest) = (u.get(), 1.0);
        for (share, m) in shares.iter_mut().zip((1..=N).rev()) {
            let (taken, left) = parts::<T>(*share, m);
            *share = rest * taken;
            rest *= left;
        }
        (shares, rest)
    }

    #[inline]
    fn pdf(&self, (shares, rest): ([f32; N], f32)) -> f32 {
        let sum = shares.iter().fold(rest, |sum, x| sum + x);
        let whole = (sum - 1.0).abs() <= (N as f32 + 2.0) * f32::EPSILON;
        if whole && rest >= 0.0 && shares.iter().all(|x| *x >= 0.0) {
            Self::DENSITY
        } else {
            0.0
        }
    }
}

impl<T: Tier, const N: usize> Invert for Simplex<T, N> {
    #[inline]
    fn invert(&self, (shares, rest): ([f32; N], f32)) -> [f32; N] {
        // From the last share back, so that what was left before each is a sum of positive numbers.
        let (mut uniforms, mut left) = (shares, rest);
        for (u, m) in uniforms.iter_mut().rev().zip(1..=N) {
            let before = left + *u;
            let (taken, kept) = (*u / before, left / before);
            // 1 − kept^m as taken · (1 + kept + kept² + …), a sum of positive numbers again.
            let mut sum = 1.0;
            for _ in 1..m {
                sum = 1.0 + kept * sum;
            }
            *u = into_unit(taken * sum);
            left = before;
        }
        uniforms
    }
}
