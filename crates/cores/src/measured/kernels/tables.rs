//! Tables in flash, which belong to no tier but for the sky, in `poly`: the index that a word selects, or a point of the tabulated density.

use crate::measured::count::Entry;
use crate::measured::registry::{entry, ok};
use microwarp::Warp;
use microwarp::discrete::resampling::{rearrange, residual, stratified, systematic};
use microwarp::discrete::{
    Alias, AliasEntry, Binomial, Cdf, DiscreteGaussian, DiscreteLaplace, ExactSelection, Geometric,
    Hypergeometric, Mesh, MeshPoint, Mixture, NegativeBinomial, PiecewiseConstant1d,
    PiecewiseConstant2d, PiecewiseLinear1d, Poisson, SignedLinear1d, SumTree, filter,
};
use microwarp::poly::{CosineHemisphere, Interval, LatLongMap, Sphere};
use rand_core::Rng;

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

/// The same as integers.
pub(super) const fn integers<const N: usize>() -> [u32; N] {
    let (weights, mut integers, mut index) = (weights::<N>(), [0; N], 0);
    while index < N {
        integers[index] = weights[index] as u32;
        index += 1;
    }
    integers
}

/// Weights of a picture.
const fn picture() -> [[f32; 16]; 8] {
    let (flat, mut picture, mut index) = (weights::<128>(), [[0.0; 16]; 8], 0);
    while index < 128 {
        picture[index / 16][index % 16] = flat[index];
        index += 1;
    }
    picture
}

/// Two kernels and the table of both, which the compiler builds with no other function: by inputs from memory, and
/// drawn.
macro_rules! tables {
    ($(
        $name:literal $drawn:literal $table:ident: $type:ty = $value:expr,
        ($($input:ident: $number:ident),+) -> $out:ty = $body:expr, $rng:ident => $drawn_body:expr;
    )*) => {
        $(
            #[cfg(any(not(one_kernel), kernel = $name, kernel = $drawn))]
            static $table: $type = ok($value);
        )*

        /// Every entry; a measurement leaves one.
        pub static ENTRIES: &[Entry] = &[$(
            #[cfg(any(not(one_kernel), kernel = $name))]
            entry!(($name) ($($input: $number),+) -> $out = $body, {}),
            #[cfg(any(not(one_kernel), kernel = $drawn))]
            entry!(($drawn) ($rng) -> $out = $drawn_body, {}),
        )*];
    };
}

type AliasOf<const N: usize> = Alias<[AliasEntry<u32>; N]>;
pub(super) type Tree<const N: usize> = SumTree<[u32; N]>;
type CdfOf<const N: usize> = Cdf<[u32; N]>;
type Pieces<const N: usize> = PiecewiseConstant1d<[u32; N]>;
type Lines<const N: usize> = PiecewiseLinear1d<[u32; N], [f32; N]>;
type Sky<const U: usize, const V: usize> = LatLongMap<[u32; V], [[u32; U]; V]>;
type Picture<const U: usize, const V: usize> = PiecewiseConstant2d<[u32; V], [[u32; U]; V]>;

const UNIT: [f32; 2] = [0.0, 1.0];

const INTERVAL: Interval = ok(Interval::new(0.0, 1.0));

/// The areas of the faces of an octahedron.
static AREAS: [f32; 8] = [0.866_025_4; 8];

/// An octahedron of which everything lies in flash.
fn octahedron(table: &'static CdfOf<8>) -> Mesh<'static, u8, &'static [u32]> {
    static VERTICES: [[f32; 3]; 6] = [
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [-1.0, 0.0, 0.0],
        [0.0, -1.0, 0.0],
        [0.0, 0.0, 1.0],
        [0.0, 0.0, -1.0],
    ];
    static FACES: [[u8; 3]; 8] = [
        [0, 1, 4],
        [1, 2, 4],
        [2, 3, 4],
        [3, 0, 4],
        [1, 0, 5],
        [2, 1, 5],
        [3, 2, 5],
        [0, 3, 5],
    ];
    ok(Mesh::from_trusted_parts(
        &VERTICES,
        &FACES,
        &AREAS,
        table.view(),
    ))
}

tables! {
    "alias_8" "alias_8_pcg32" ALIAS_8: AliasOf<8> = AliasOf::<8>::new(&weights::<8>()),
        (word: u32) -> usize = ALIAS_8.index(word), rng => ALIAS_8.index(rng.next_u32());
    "alias_64" "alias_64_pcg32" ALIAS_64: AliasOf<64> = AliasOf::<64>::new(&weights::<64>()),
        (word: u32) -> usize = ALIAS_64.index(word), rng => ALIAS_64.index(rng.next_u32());
    "alias_1024" "alias_1024_pcg32" ALIAS_1024: AliasOf<1024> = AliasOf::<1024>::new(&weights::<1024>()),
        (word: u32) -> usize = ALIAS_1024.index(word), rng => ALIAS_1024.index(rng.next_u32());
    "cdf_8" "cdf_8_pcg32" CDF_8: CdfOf<8> = CdfOf::<8>::new(&weights()),
        (word: u32) -> usize = CDF_8.index(word), rng => CDF_8.index(rng.next_u32());
    "cdf_64" "cdf_64_pcg32" CDF_64: CdfOf<64> = CdfOf::<64>::new(&weights()),
        (word: u32) -> usize = CDF_64.index(word), rng => CDF_64.index(rng.next_u32());
    "cdf_64_exact" "cdf_64_exact_pcg32" CDF_64_EXACT: CdfOf<64> = CdfOf::<64>::new(&weights()),
        (word: u32) -> [u32; 4] = parts(CDF_64_EXACT.select_exact(word)),
        rng => parts(CDF_64_EXACT.draw_exact(rng));
    "cdf_1024" "cdf_1024_pcg32" CDF_1024: CdfOf<1024> = CdfOf::<1024>::new(&weights()),
        (word: u32) -> usize = CDF_1024.index(word), rng => CDF_1024.index(rng.next_u32());
    "geometric_100" "geometric_100_pcg32" GEOMETRIC_100: Geometric = Geometric::from_ratio(1, 100),
        (word: u32) -> u32 = GEOMETRIC_100.count(word), rng => GEOMETRIC_100.draw(rng);
    "binomial_100" "binomial_100_pcg32" BINOMIAL_100: Binomial = Binomial::from_ratio(100, 3, 10),
        (word: u32) -> u32 = BINOMIAL_100.count(word), rng => BINOMIAL_100.draw(rng);
    "negative_binomial_10" "negative_binomial_10_pcg32"
        NEGATIVE_BINOMIAL_10: NegativeBinomial = NegativeBinomial::from_ratio(10, 1, 2),
        (word: u32) -> u32 = NEGATIVE_BINOMIAL_10.count(word), rng => NEGATIVE_BINOMIAL_10.draw(rng);
    "hypergeometric_1000" "hypergeometric_1000_pcg32"
        HYPERGEOMETRIC_1000: Hypergeometric = Hypergeometric::new(1000, 300, 100),
        (word: u32) -> u32 = HYPERGEOMETRIC_1000.count(word), rng => HYPERGEOMETRIC_1000.draw(rng);
    "discrete_gaussian_3" "discrete_gaussian_3_pcg32"
        DISCRETE_GAUSSIAN_3: DiscreteGaussian = DiscreteGaussian::new(0.25, 3.0),
        (word: u32) -> i32 = DISCRETE_GAUSSIAN_3.integer(word), rng => DISCRETE_GAUSSIAN_3.draw(rng);
    "discrete_laplace_10" "discrete_laplace_10_pcg32"
        DISCRETE_LAPLACE_10: DiscreteLaplace = DiscreteLaplace::from_ratio(10, 1),
        (word: u32) -> i32 = DISCRETE_LAPLACE_10.integer(word), rng => DISCRETE_LAPLACE_10.draw(rng);
    "poisson_10" "poisson_10_pcg32" POISSON_10: Poisson = Poisson::from_ratio(10, 1),
        (word: u32) -> u32 = POISSON_10.count(word), rng => POISSON_10.draw(rng);
    "poisson_80" "poisson_80_pcg32" POISSON_80: Poisson = Poisson::from_ratio(80, 1),
        (word: u32) -> u32 = POISSON_80.count(word), rng => POISSON_80.draw(rng);
    "sum_tree_16" "sum_tree_16_pcg32" TREE_16: Tree<16> = Tree::<16>::new(integers()),
        (word: u32) -> usize = TREE_16.index(word).unwrap_or(0), rng => TREE_16.draw_index(rng).unwrap_or(0);
    "sum_tree_4096" "sum_tree_4096_pcg32" TREE_4096: Tree<4096> = Tree::<4096>::new(integers()),
        (word: u32) -> usize = TREE_4096.index(word).unwrap_or(0), rng => TREE_4096.draw_index(rng).unwrap_or(0);
    "mixture_8" "mixture_8_pcg32" MIXTURE_8: Mixture<[Interval; 8], 8> = Mixture::new([INTERVAL; 8], &weights()),
        (word: u32) -> [u32; 2] = picked(MIXTURE_8.choose(word)), rng => picked(MIXTURE_8.choose(rng.next_u32()));
    "poly_mixture_lobes" "poly_mixture_lobes_pcg32"
        LOBES: Mixture<(CosineHemisphere, Sphere), 2> = Mixture::new((CosineHemisphere::new(), Sphere::new()), &[2.0, 1.0]),
        (u: f32, v: f32) -> [f32; 3] = LOBES.sample([u, v]), rng => LOBES.draw(rng);
    "piecewise_constant_1d_64" "piecewise_constant_1d_64_pcg32"
        PIECES_64: Pieces<64> = Pieces::<64>::new(&weights(), 0.0, 1.0),
        (u: f32) -> f32 = PIECES_64.sample(u), rng => PIECES_64.draw(rng);
    "piecewise_constant_2d_16_8" "piecewise_constant_2d_16_8_pcg32"
        PICTURE_16_8: Picture<16, 8> = Picture::<16, 8>::new(&picture(), UNIT, UNIT),
        (u: f32, v: f32) -> [f32; 2] = PICTURE_16_8.sample([u, v]), rng => PICTURE_16_8.draw(rng);
    "piecewise_linear_1d_64" "piecewise_linear_1d_64_pcg32"
        LINES_64: Lines<64> = Lines::<64>::new(&weights(), 0.0, 1.0),
        (u: f32) -> f32 = LINES_64.sample(u), rng => LINES_64.draw(rng);
    "signed_linear_1d_65" "signed_linear_1d_65_pcg32"
        SIGNED_65: SignedLinear1d<65> = SignedLinear1d::new(&filter::lanczos(3), -3.0, 3.0),
        (u: f32) -> [f32; 2] = SIGNED_65.sample(u).into(), rng => SIGNED_65.draw(rng).into();
    "mesh_8" "mesh_8_pcg32" MESH_8: CdfOf<8> = CdfOf::<8>::new(&AREAS),
        (u: f32, v: f32) -> ([f32; 3], usize) = found(octahedron(&MESH_8).sample([u, v])),
        rng => found(octahedron(&MESH_8).draw(rng));
    "poly_lat_long_map_16_8" "poly_lat_long_map_16_8_pcg32"
        SKY_16_8: Sky<16, 8> = Sky::<16, 8>::new(&picture()),
        (u: f32, v: f32) -> [f32; 3] = SKY_16_8.sample([u, v]), rng => SKY_16_8.draw(rng);
}

/// What an exact selection says. No table here has an entry of all words.
fn parts(chosen: ExactSelection) -> [u32; 4] {
    [
        chosen.index as u32,
        chosen.numerator as u32,
        chosen.leftover,
        chosen.leftover_bits,
    ]
}

fn picked((part, rest): (usize, u32)) -> [u32; 2] {
    [part as u32, rest]
}

fn found(point: MeshPoint) -> ([f32; 3], usize) {
    (point.position, point.triangle)
}

/// A scheme that replaces 64 weights of 64 particles by counts, and moves the particles.
macro_rules! resampling {
    ($($name:literal $rng:ident => $counts:ident: $body:expr;)*) => {
        /// Every entry; a measurement leaves one.
        pub static RESAMPLING: &[Entry] = &[$(
            #[cfg(any(not(one_kernel), kernel = $name))]
            entry!(($name) ($rng) -> u32 = {
                let mut $counts: [u32; 64] = core::array::from_fn(|i| (i as u32 * 37 % 101 + 1) << 20);
                let mut particles: [u32; 64] = core::array::from_fn(|i| i as u32);
                let done = $body;
                let moved = rearrange(&mut $counts, &mut particles);
                u32::from(done.is_ok() && moved.is_ok()) + particles[63]
            }, {}),
        )*];
    };
}

resampling! {
    "resampling_systematic_64_pcg32" rng => counts: systematic(&mut counts, 64, rng.next_u32());
    "resampling_residual_64_pcg32" rng => counts: residual(&mut counts, 64, rng.next_u32());
    "resampling_stratified_64_pcg32" rng => counts: stratified(&mut counts, 64, rng);
}
