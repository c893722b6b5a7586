//! Pictures of all directions: every pixel is found again from its own samples, its density is its probability over its
//! solid angle, rows weigh what their zones do, and what is no sky is refused.

use crate::halves;
use host::speed;
use microwarp::Error::{
    AllZero, Empty, NegativeWeight, NoWeights, NotFiniteWeight, OutOfRange, TooManyWeights,
    Unreachable,
};
use microwarp::discrete::{LatLongMap, Word};
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::uniform::{LARGEST, grid_from_word};
use microwarp::{Error, Invert, Warp, constant};
use num_bigint::BigUint;
use rand_core::Rng;
use rand_pcg::Pcg32;
use std::f64::consts::{PI, TAU};

type Narrow<'a, T> = LatLongMap<T, &'a [u32], &'a [u32]>;

/// The solid angle of a row of one column, over 2π.
fn drop(row: usize, rows: usize) -> f64 {
    let angle = |j: f64| PI * j / rows as f64;
    2.0 * angle(row as f64 + 0.5).sin() * angle(0.5).sin()
}

/// Weights of which every second is zero, so that a neighbour across an edge or a corner is another one.
fn checked([columns, rows]: [usize; 2]) -> Vec<f32> {
    let pixels = (0..rows).flat_map(|v| (0..columns).map(move |u| (u + v) % 2));
    pixels.map(|odd| 1.0 - odd as f32).collect()
}

/// Walks over the first and the last words of pixels; the largest relative error of a density.
fn walk<T: Tier>(map: &Narrow<T>, skip: usize) -> f64 {
    let table = map.table();
    let shape = table.shape();
    let [columns, rows] = shape;
    let mut worst = 0.0_f64;
    for row in (0..rows).filter(|row| row % skip == 0 || *row < 40 || row + 40 > rows) {
        let Some(down) = table.marginal().cdf().words_of(row) else {
            continue;
        };
        let line = table.conditional(row);
        let lit = (0..columns).filter(|c| c % skip == 0 || *c < 5 || c + 5 > columns);
        for column in lit {
            let Some(along) = line.cdf().words_of(column) else {
                assert_eq!(map.pdf(middle([column, row], shape)), 0.0);
                continue;
            };
            let mass = line.cdf().pmf(column) as f64 * table.marginal().cdf().pmf(row) as f64;
            let width = f64::from((column + 1) as f32 / columns as f32)
                - f64::from(column as f32 / columns as f32);
            let exact = mass / (TAU * width * drop(row, rows));
            for words in [
                [*along.start(), *down.start()],
                [*along.end(), *down.end()],
                [*along.start(), *down.end()],
                [*along.end(), *down.start()],
                [
                    along.start() + (along.end() - along.start()) / 2,
                    down.start() + (down.end() - down.start()) / 2,
                ],
            ] {
                let sample = map.draw_pixel(&mut crate::Given(&words));
                let seen = format!("{} {shape:?} {column} {row} {words:?}", T::NAME);
                assert_eq!(sample.pixel, [column, row], "{seen}");
                assert_eq!(map.pixel(sample.direction), [column, row], "{seen}");
                let pdf = map.pdf(sample.direction);
                assert_eq!(pdf.to_bits(), sample.pdf.to_bits(), "{seen}");
                worst = worst.max((f64::from(pdf) / exact - 1.0).abs());
                assert_eq!(map.sample_words(words), sample.direction, "{seen}");
                let u = map.invert(sample.direction);
                assert!(u.iter().all(|u| (0.0..=LARGEST).contains(u)), "{seen}");
            }
        }
    }
    worst
}

/// Of a sky of zeros and ones in both tiers: the largest relative error of a density. Large tables are made once for both.
fn in_both_tiers(shape: [usize; 2], skip: usize) -> f64 {
    let weights = checked(shape);
    let (mut marginal, mut conditional) = (vec![0; shape[1]], vec![0; weights.len()]);
    let map = Narrow::<Poly>::new_in(&weights, shape, &mut marginal, &mut conditional).unwrap();
    let (rows, cells) = map.table().as_words();
    let other = Narrow::<Libm>::from_trusted_words(rows, cells).unwrap();
    if weights.len() < 5_000 {
        let (mut marginal, mut conditional) = (vec![0; shape[1]], vec![0; weights.len()]);
        let own = Narrow::<Libm>::new_in(&weights, shape, &mut marginal, &mut conditional);
        assert_eq!(own.unwrap(), other);
    }
    walk(&map, skip).max(walk(&other, skip))
}

/// The direction in the middle of a pixel.
fn middle([column, row]: [usize; 2], [columns, rows]: [usize; 2]) -> [f32; 3] {
    let phi = TAU * (column as f64 + 0.5) / columns as f64;
    let theta = PI * (row as f64 + 0.5) / rows as f64;
    [
        theta.sin() * phi.cos(),
        theta.sin() * phi.sin(),
        theta.cos(),
    ]
    .map(|c| c as f32)
}

#[test]
fn the_pixel_of_a_sample_is_the_one_that_was_selected() {
    let most = speed::of("rows and columns of small skies", 12, 40);
    let mut worst = 0.0_f64;
    for rows in 1..=most {
        for columns in 1..=most {
            worst = worst.max(in_both_tiers([columns, rows], 1));
        }
    }
    let large = [
        [360, 181],
        [1000, 500],
        [2048, 1024],
        [3, 8192],
        [16_384, 3],
        [4096, 2048],
        [5000, 2501],
        [1, 1 << 20],
        [1 << 20, 1],
    ];
    let most = speed::of("pixels of the largest sky", 1 << 21, 1 << 24);
    for shape in large
        .into_iter()
        .filter(|[columns, rows]| columns * rows <= most)
    {
        let skip = speed::of("pixels passed over in large skies", 211, 13);
        worst = worst.max(in_both_tiers(shape, skip));
    }
    println!("densities off by {worst:.2e} at most");
    assert!(worst <= 5e-7, "{worst:e}");
}

/// Points of the pixel's own edge, which a direction would reach without the distance that it keeps, are often taken for
/// the neighbour's.
#[test]
fn a_direction_on_the_edge_may_be_the_neighbours() {
    let shape = [48, 24];
    let weights = checked(shape);
    let (mut marginal, mut conditional) = (vec![0; 24], vec![0; 48 * 24]);
    let map = Narrow::<Poly>::new_in(&weights, shape, &mut marginal, &mut conditional).unwrap();
    let mut strayed = 0;
    for row in 0..24 {
        for column in (0..48).filter(|c| weights[row * 48 + c] > 0.0) {
            let phi = TAU * column as f64 / 48.0;
            let theta = PI * (row as f64 + 0.5) / 24.0;
            let direction = [
                theta.sin() * phi.cos(),
                theta.sin() * phi.sin(),
                theta.cos(),
            ];
            strayed += u32::from(map.pdf(direction.map(|c| c as f32)) == 0.0);
        }
    }
    println!("{strayed} of 576 on an edge");
    assert!(strayed > 50, "{strayed}");
}

/// Radiances in, and solid angles are not forgotten: the exact share of every pixel of a small sky.
#[test]
fn a_pixel_has_its_radiance_times_its_solid_angle() {
    let shape = [5, 9];
    let weights: Vec<f32> = (0..45).map(|k| (k * 7 % 11) as f32).collect();
    let total: f64 = (0..45)
        .map(|k| f64::from(weights[k]) * drop(k / 5, 9))
        .sum();
    let (mut marginal, mut conditional) = (vec![0_u64; 9], vec![0_u64; 45]);
    let map = LatLongMap::<Poly, &[u64], &[u64]>::new_in(
        &weights,
        shape,
        &mut marginal,
        &mut conditional,
    );
    let map = map.unwrap();
    let (mut worst, mut forgotten) = (0.0_f64, 0.0_f64);
    let flat: f32 = weights.iter().sum();
    for (k, weight) in weights.iter().enumerate() {
        let rows = map.table().marginal().cdf().numerator(k / 5) as f64;
        let columns = map.table().conditional(k / 5);
        let share = rows * columns.cdf().numerator(k % 5) as f64 / 2f64.powi(128);
        let exact = f64::from(*weight) * drop(k / 5, 9) / total;
        let without = f64::from(*weight) / f64::from(flat);
        worst = worst.max((share - exact).abs() / exact.max(1e-9));
        forgotten = forgotten.max((without - exact).abs() / exact.max(1e-9));
    }
    println!("off by {worst:.1e} of itself; without sines by {forgotten:.1e}");
    assert!(worst <= 5e-9, "{worst:e}");
    assert!(forgotten > 0.1);
}

/// Fraction bits of exact sines.
const DEEP: u32 = 256;

/// atan(1/n), from its series.
fn atan_of(n: u32) -> BigUint {
    let (mut power, mut sum) = ((BigUint::from(1_u32) << DEEP) / n, BigUint::ZERO);
    for k in 0..60_u32 {
        sum += &power / (4 * k + 1);
        power /= n * n;
        sum -= &power / (4 * k + 3);
        power /= n * n;
    }
    sum
}

/// The sine of k/n quarters of a turn in steps of 2⁻²⁵⁶, with π by J. Machin's formula.
fn exact_sine(k: usize, n: usize, pi: &BigUint) -> BigUint {
    let x = pi * k / (2 * n);
    let square = (&x * &x) >> DEEP;
    let (mut term, mut sum) = (x.clone(), x);
    for j in 1..40_u32 {
        term = ((&term * &square) >> DEEP) / (2 * j * (2 * j + 1));
        sum = if j % 2 == 1 { sum - &term } else { sum + &term };
    }
    sum
}

/// By how much the probabilities of rows and pixels are off, in terms of 2⁻³¹ for words of `u32` and 2⁻⁵⁴ for `u64`, at
/// most. Where `astray` is not 0, the sines of odd rows are too large by this part.
fn off(radiances: &[f32], [columns, rows]: [usize; 2], astray: f64) -> [f64; 2] {
    let pi = (atan_of(5) * 16_u32) - (atan_of(239) * 4_u32);
    let part = BigUint::from((1_u64 << 62) + (astray * 2f64.powi(62)) as u64);
    // In steps of 2⁻¹⁴⁹, times the sine of the zone's middle.
    let weights: Vec<BigUint> = (0..rows * columns)
        .map(|i| {
            let (row, bits) = (i / columns, radiances[i].to_bits());
            let middle = 2 * row + 1;
            let sine = exact_sine(middle.min(2 * rows - middle), rows, &pi);
            let (field, fraction) = (bits >> 23, bits & 0x7f_ffff);
            let integer = match field {
                0 => BigUint::from(fraction),
                _ => BigUint::from(fraction | 0x80_0000) << (field - 1),
            };
            let factor = if row % 2 == 1 {
                part.clone()
            } else {
                BigUint::from(1_u64 << 62)
            };
            integer * sine * factor
        })
        .collect();
    let total: BigUint = weights.iter().sum();
    // With 130 bits.
    let share = |weight: &BigUint| (weight << 130_u32) / &total;
    let far = |found: BigUint, due: BigUint| {
        let far = if found > due {
            found - due
        } else {
            due - found
        };
        u128::try_from(far).unwrap_or(u128::MAX) as f64 * 2f64.powi(-130)
    };
    fn worst<W: Word>(
        radiances: &[f32],
        shape: [usize; 2],
        zero: W,
        due: &mut dyn FnMut(usize, BigUint, u32) -> f64,
    ) -> f64
    where
        BigUint: From<W::Count>,
    {
        let (mut marginal, mut conditional) = (vec![zero; shape[1]], vec![zero; radiances.len()]);
        let map = LatLongMap::<Poly, &[W], &[W]>::new_in(
            radiances,
            shape,
            &mut marginal,
            &mut conditional,
        );
        let map = map.unwrap();
        let bits = 8 * size_of::<W>() as u32;
        let pixels = (0..radiances.len()).map(|i| {
            let row = map.table().marginal().cdf().numerator(i / shape[0]);
            let column = map
                .table()
                .conditional(i / shape[0])
                .cdf()
                .numerator(i % shape[0]);
            due(i, BigUint::from(row) * BigUint::from(column), 2 * bits)
        });
        pixels.fold(0.0, f64::max)
    }
    let mut due =
        |i: usize, found: BigUint, bits: u32| far((found << 130_u32) >> bits, share(&weights[i]));
    let shape = [columns, rows];
    [
        worst(radiances, shape, 0_u32, &mut due) * 2f64.powi(31),
        worst(radiances, shape, 0_u64, &mut due) * 2f64.powi(54),
    ]
}

/// The exact probabilities of skies of all sizes: those of two rows that share the light, where an error of the sines
/// counts most, and those of random radiances.
#[test]
fn probabilities_are_right_to_the_stated_bits() {
    let mut rng = Pcg32::new(30, 12);
    let (mut most, mut least_astray) = ([0.0_f64; 2], [f64::MAX; 2]);
    for case in 0..speed::of("skies", 60, 3000) {
        let rows = match case {
            0 => 244,
            _ => 2 + rng.next_u32() as usize % (1 << (1 + case % 11)),
        };
        let columns = if rows > 500 { 1 } else { 1 + case % 3 };
        let two = case % 2 == 0;
        let other = if case == 0 {
            0
        } else {
            rng.next_u32() as usize % rows
        };
        let one = if case == 0 { 60 } else { (other + 1) % rows };
        let radiances: Vec<f32> = (0..rows * columns)
            .map(|i| match i / columns {
                row if row == one && two => 1.0,
                row if row == other && two => (drop(one, rows) / drop(other, rows)) as f32,
                _ if two => 0.0,
                _ => rng.next_u32() as f32,
            })
            .collect();
        let found = off(&radiances, [columns, rows], 0.0);
        most = [0, 1].map(|k| most[k].max(found[k]));
        if two && columns == 1 && (one + other) % 2 == 1 {
            let found = off(&radiances, [columns, rows], 4e-9);
            least_astray = [0, 1].map(|k| least_astray[k].min(found[k]));
        }
    }
    println!("{most:?} of what is stated; with sines as once, {least_astray:?}");
    assert!(most.iter().all(|most| *most <= 1.0), "{most:?}");
    assert!(
        least_astray.iter().all(|least| *least > 1.0),
        "{least_astray:?}"
    );
}

/// What one constructor makes, all make; and tables that the compiler made.
#[test]
fn a_sky_is_the_same_wherever_it_is_kept() {
    const ROWS: [[f32; 4]; 3] = [[1.0, 0.0, 2.0, 5.0], [0.0; 4], [7.0, 1.0, 1.0, 0.5]];
    static SKY: microwarp::poly::LatLongMap<[u32; 3], [[u32; 4]; 3]> =
        constant!(LatLongMap::new(&ROWS));
    let (rows, cells) = SKY.table().as_words();
    let flat = ROWS.as_flattened();
    type Bounded = microwarp::poly::LatLongMap<heapless::Vec<u32, 4>, heapless::Vec<u32, 12>>;
    let bounded = Bounded::from_slice(flat, [4, 3]).unwrap();
    assert_eq!(bounded.table().as_words(), (rows, cells));
    let (mut marginal, mut conditional) = ([0; 9], [0; 20]);
    let lent = Narrow::<Libm>::new_in(flat, [4, 3], &mut marginal, &mut conditional).unwrap();
    assert_eq!(lent.table().as_words(), (rows, cells));
    let again = Narrow::<Poly>::from_words(rows, cells).unwrap();
    let trusted = Narrow::<Poly>::from_trusted_words(rows, cells).unwrap();
    assert_eq!(again, trusted);
    assert_eq!(size_of_val(&SKY), 4 * (3 + 12) + 56);
    for k in 0..1000_u32 {
        let words = [k.wrapping_mul(0x9e37_79b9), k.wrapping_mul(0x85eb_ca6b)];
        let x = SKY.sample_words(words);
        assert_eq!(x, bounded.sample_words(words));
        assert_eq!(x, again.sample_words(words));
        let u = words.map(grid_from_word);
        let sample = SKY.sample_pixel(u);
        assert_eq!((sample.direction, sample.pdf), SKY.sample_with_pdf(u));
        assert_eq!(sample.direction, SKY.sample(u));
    }
    let wide = microwarp::libm::LatLongMap::new_u64(&ROWS).unwrap();
    let words = halves(1 << 63);
    let drawn = wide.draw(&mut crate::Given(&[words, words].concat()));
    assert!(wide.pdf(drawn) > 0.0);
    assert_eq!(<u64 as Word>::BITS, 64);
}

#[test]
fn what_is_no_sky_is_refused() {
    let refused = |weights: &[f32], shape: [usize; 2]| {
        let (mut rows, mut cells) = (vec![0; 40], vec![0; 40]);
        Narrow::<Poly>::new_in(weights, shape, &mut rows, &mut cells).err()
    };
    let with = |index: usize, weight: f32| {
        let mut weights = [1.0; 6];
        weights[index] = weight;
        refused(&weights, [3, 2])
    };
    assert_eq!(refused(&[1.0; 6], [3, 2]), None);
    assert_eq!(refused(&[0.0; 6], [3, 2]), Some(AllZero));
    assert_eq!(with(4, f32::NAN), Some(NotFiniteWeight(4)));
    assert_eq!(with(2, f32::INFINITY), Some(NotFiniteWeight(2)));
    assert_eq!(with(5, -1e-30), Some(NegativeWeight(5)));
    assert_eq!(with(0, f32::MAX), Some(Unreachable(1)));
    assert_eq!(refused(&[1.0; 6], [2, 2]), Some(OutOfRange(1)));
    assert_eq!(refused(&[], [0, 0]), Some(NoWeights));
    assert_eq!(refused(&[1.0; 80], [10, 8]), Some(TooManyWeights));
    let mut rows = vec![0; (1 << 20) + 1];
    let mut cells = rows.clone();
    let many = vec![1.0; (1 << 20) + 1];
    for shape in [[1, many.len()], [many.len(), 1]] {
        let sky = Narrow::<Poly>::new_in(&many, shape, &mut rows, &mut cells);
        assert_eq!(sky.err(), Some(Empty(1)));
    }
    let black: Result<_, Error> = microwarp::poly::LatLongMap::new(&[[0.0; 4]; 2]);
    assert_eq!(black.err(), Some(AllZero));
}
