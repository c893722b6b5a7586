//! Correlated normals, against a factor, densities and moments in `f64`.

use super::families::plane::around;
use crate::raw::{Raw, of_bits, raw};
use core::f64::consts::TAU;
use fixed::FixedI32;
use fixed::types::extra::{LeEqU32, U0, U16, U30};
use fixed::types::{I2F30, I16F16};
use host::speed;
use microwarp::fixed::warp::MultivariateNormal;
use microwarp::fixed::{Coarse, Compact, Fine, Grade};
use microwarp::{Error, Invert, Warp};
use rand_core::{Rng, SeedableRng};
use rand_pcg::Pcg32;

/// 2⁻³², and the step of a correlation.
const WORD: f64 = 1.0 / 4_294_967_296.0;
const STEP: f64 = 4.0 * WORD;
/// What is left of a variance and is equal to something is so to this, at the least.
const CLEAR: f64 = 1e-13;

/// The parameters of a law in steps, and what follows from them in `f64`.
pub struct Exact {
    pub means: Vec<i32>,
    pub deviations: Vec<i32>,
    pub factor: Vec<Vec<f64>>,
    /// The free coordinates in the order of elimination.
    pub order: Vec<usize>,
}

impl Exact {
    /// Nothing where `f64` cannot tell in which order the coordinates are eliminated.
    pub fn new(means: &[i32], deviations: &[i32], correlations: &[Vec<i32>]) -> Option<Self> {
        let d = means.len();
        let mut left: Vec<Vec<f64>> = correlations
            .iter()
            .map(|row| row.iter().map(|c| f64::from(*c) * STEP).collect())
            .collect();
        let mut open: Vec<usize> = (0..d).filter(|i| deviations[*i] > 0).collect();
        let (mut factor, mut order) = (vec![vec![0.0; d]; d], Vec::new());
        loop {
            let (mut most, mut pivot) = (d as f64 * 0.5_f64.powi(29), None);
            for &i in &open {
                if (left[i][i] - most).abs() < CLEAR {
                    return None;
                }
                if left[i][i] > most {
                    (most, pivot) = (left[i][i] + 0.5_f64.powi(40), Some(i));
                }
            }
            let Some(p) = pivot else { break };
            open.retain(|i| *i != p);
            order.push(p);
            let root = left[p][p].sqrt();
            factor[p][p] = root;
            for &i in &open {
                factor[i][p] = left[i][p] / root;
            }
            for &i in &open {
                for &j in &open {
                    left[i][j] -= factor[i][p] * factor[j][p];
                }
            }
        }
        Some(Self {
            means: means.to_vec(),
            deviations: deviations.to_vec(),
            factor,
            order,
        })
    }

    pub fn dimensions(&self) -> usize {
        self.means.len()
    }

    /// The smallest root of what the others leave of a variance, and the smallest deviation in steps, of free coordinates.
    pub fn smallest(&self) -> [f64; 2] {
        let own = |i: &usize| [self.factor[*i][*i], f64::from(self.deviations[*i])];
        let all = self.order.iter().map(own);
        all.fold([1.0, f64::MAX], |[k, n], [a, b]| [k.min(a), n.min(b)])
    }

    /// The normals of words, each for its coordinate.
    pub fn normals(&self, words: &[u32]) -> Vec<f64> {
        let pairs = words.chunks(2).flat_map(|pair| {
            let u = f64::from(pair[0]) * WORD;
            around((-2.0 * (-u).ln_1p()).sqrt(), pair[1])
        });
        pairs.take(self.dimensions()).collect()
    }

    /// The distance of a point from the means, in steps.
    pub fn offset(&self, z: &[f64]) -> Vec<f64> {
        let rows = self.factor.iter().zip(&self.deviations);
        rows.map(|(row, deviation)| {
            let products = row.iter().zip(z).map(|(a, z)| a * z);
            products.sum::<f64>() * f64::from(*deviation)
        })
        .collect()
    }

    /// The normals of a point in steps.
    pub fn whitened(&self, point: &[i32]) -> Vec<f64> {
        let mut z = vec![0.0; self.dimensions()];
        for &i in &self.order {
            let off = f64::from(point[i]) - f64::from(self.means[i]);
            let said: f64 = self.factor[i].iter().zip(&z).map(|(a, z)| a * z).sum();
            z[i] = (off / f64::from(self.deviations[i]) - said) / self.factor[i][i];
        }
        z
    }

    /// The density at the means, where so many steps are 1.
    pub fn peak(&self, one: f64) -> f64 {
        let own = |i: &usize| one / (f64::from(self.deviations[*i]) * self.factor[*i][*i]);
        self.order.iter().map(|i| own(i) / TAU.sqrt()).product()
    }

    pub fn pdf(&self, point: &[i32], one: f64) -> f64 {
        let square: f64 = self.whitened(point).iter().map(|z| z * z).sum();
        self.peak(one) * (-0.5 * square).exp()
    }
}

/// A matrix of correlations from its bits.
fn matrix<const D: usize>(bits: &[Vec<i32>]) -> [[I2F30; D]; D] {
    let mut matrix = [[I2F30::ZERO; D]; D];
    for (i, row) in matrix.iter_mut().enumerate() {
        *row = of_bits(&bits[i]);
    }
    matrix
}

/// A law of words, of one of so many dimensions.
macro_rules! law_of {
    ($format:ty, $grade:ty, $means:ident, $deviations:ident, $correlations:ident; $($d:literal)*) => {
        match $means.len() {
            $($d => {
                let (means, deviations) = (of_bits($means), of_bits($deviations));
                let law = MultivariateNormal::<$format, $d, $grade>::new(means, deviations, matrix($correlations));
                law.map(raw)
            })*
            _ => unreachable!(),
        }
    };
}

/// A law of words of few dimensions, since each is compiled for each format that is asked for.
pub fn law<Frac: LeEqU32 + Send + Sync + 'static, G: Grade>(
    means: &[i32],
    deviations: &[i32],
    correlations: &[Vec<i32>],
) -> Result<Box<dyn Raw>, Error> {
    law_of!(Frac, G, means, deviations, correlations; 1 2 3 4)
}

/// A law of words in one format.
fn law_of_any_dimension(
    means: &[i32],
    deviations: &[i32],
    correlations: &[Vec<i32>],
) -> Result<Box<dyn Raw>, Error> {
    law_of!(U16, Fine, means, deviations, correlations; 2 3 4 5 6 7)
}

/// A matrix of correlations from partial ones, each given those before it: any of those make one that is semi-definite.
pub fn of_partials(d: usize, mut partial: impl FnMut() -> f64) -> Vec<Vec<i32>> {
    // The factor, row by row: what is left of a row after its first parts is a root.
    let row = |i: usize| {
        let (mut left, mut row) = (1.0_f64, Vec::new());
        for _ in 0..i {
            let part = partial();
            row.push(left * part);
            left *= ((1.0 - part) * (1.0 + part)).sqrt();
        }
        row.push(left);
        row
    };
    let factor: Vec<Vec<f64>> = (0..d).map(row).collect();
    let entry = |i: usize, j: usize| {
        let sum: f64 = factor[i].iter().zip(&factor[j]).map(|(a, b)| a * b).sum();
        let bits = if i == j {
            1 << 30
        } else {
            (sum / STEP).round() as i32
        };
        bits.clamp(-(1 << 30), 1 << 30)
    };
    (0..d)
        .map(|i| (0..d).map(|j| entry(i, j)).collect())
        .collect()
}

/// Partial correlations of all kinds: anywhere, near ±1, and exactly 0 or ±1.
pub fn partial(kind: u32, word: u32) -> f64 {
    let any = f64::from(word as i32) / 2_147_483_648.0;
    match kind % 8 {
        0..4 => any,
        4 | 5 => (1.0 - any.abs() * 0.5_f64.powi((word & 31) as i32)).copysign(any),
        6 => 1.0_f64.copysign(any),
        _ => 0.0,
    }
}

fn random(rng: &mut Pcg32, d: usize) -> Vec<Vec<i32>> {
    of_partials(d, || partial(rng.next_u32(), rng.next_u32()))
}

/// The largest entry of L Lᵀ - C in steps of 2⁻³⁰, of the coordinates that vary.
fn off<const D: usize>(factor: [[I2F30; D]; D], correlations: &[Vec<i32>]) -> f64 {
    let mut worst = 0.0_f64;
    for i in 0..D {
        for j in 0..D {
            let product = |k: usize| factor[i][k].to_num::<f64>() * factor[j][k].to_num::<f64>();
            let sum: f64 = (0..D).map(product).sum();
            worst = worst.max((sum / STEP - f64::from(correlations[i][j])).abs());
        }
    }
    worst
}

fn factors<const D: usize>(
    rng: &mut Pcg32,
    make: impl Fn([FixedI32<U16>; D], [[I2F30; D]; D]) -> Result<[[I2F30; D]; D], Error>,
) -> [f64; 2] {
    let mut worst = [0.0_f64; 2];
    for _ in 0..speed::of("matrices of each dimension", 2_000, 20_000) {
        let matrix = random(rng, D);
        let mut deviations = [FixedI32::ZERO; D];
        for deviation in &mut deviations {
            *deviation = FixedI32::from_bits((rng.next_u32() >> 7).max(1) as i32);
        }
        let factor =
            make(deviations, self::matrix(&matrix)).unwrap_or_else(|e| panic!("{e}: {matrix:?}"));
        worst[0] = worst[0].max(off(factor, &matrix));
        // One sign of one correlation, where that is to be seen.
        let mut wrong = matrix;
        if D > 1 && wrong[1][0].abs() > 100 {
            (wrong[1][0], wrong[0][1]) = (-wrong[1][0], -wrong[0][1]);
            assert!(off(factor, &wrong) > 100.0);
        }
        let all = factor.as_flattened().iter().map(|x| x.to_bits().abs());
        worst[1] = worst[1].max(all.fold(0, i32::max).into());
    }
    worst
}

/// What is left of a variance and counts as 0 is D·2⁻²⁹, two steps for each dimension; beyond that it is off by two.
#[test]
fn the_factor_times_its_transpose_is_the_matrix() {
    let mut rng = Pcg32::seed_from_u64(21);
    macro_rules! of {
        ($($d:literal)*) => {$(
            let [worst, largest] = factors::<$d>(&mut rng, |deviations, matrix| {
                MultivariateNormal::<U16, $d, Fine>::new([FixedI32::ZERO; $d], deviations, matrix).map(|law| law.factor())
            });
            println!("{} dimensions: {worst:.2} steps of 2^-30", $d);
            assert!(worst <= 2.0 * f64::from($d) + 2.0 && largest <= f64::from(1 << 30), "{worst} {largest}");
        )*};
    }
    of!(1 2 3 4 6 9 16);
}

/// Sums of products of the coordinates of samples, in units of their deviations, beside the exact ones: by how many standard errors
/// the worst is off.
fn worst_moment(law: &dyn Raw, of: &Exact, count: u32) -> f64 {
    let d = of.dimensions();
    let mut rng = Pcg32::new(5, 7);
    let mut sums = vec![vec![0.0; d]; d];
    let mut means = vec![0.0; d];
    for _ in 0..count {
        let words: Vec<u32> = (0..8).map(|_| rng.next_u32()).collect();
        let point = law.sample(&words);
        let x: Vec<f64> = (0..d)
            .map(|i| {
                let off = f64::from(point[i] as i32) - f64::from(of.means[i]);
                off / f64::from(of.deviations[i])
            })
            .collect();
        for i in 0..d {
            means[i] += x[i];
            for j in 0..d {
                sums[i][j] += x[i] * x[j];
            }
        }
    }
    let n = f64::from(count);
    let mut worst = 0.0_f64;
    for (i, row) in sums.iter().enumerate() {
        // The variance of a coordinate is 1, and that of a product 1 + c².
        worst = worst.max((means[i] / n.sqrt()).abs());
        for (sum, other) in row.iter().zip(&of.factor) {
            let c: f64 = of.factor[i].iter().zip(other).map(|(a, b)| a * b).sum();
            worst = worst.max((sum / n - c).abs() / ((1.0 + c * c) / n).sqrt());
        }
    }
    worst
}

#[test]
fn moments_are_those_of_the_parameters_and_a_wrong_sign_of_one_correlation_is_seen() {
    let count = speed::of("samples of moments", 1 << 18, 1 << 22);
    let c = |x: f64| (x / STEP) as i32;
    let one = 1 << 30;
    let regular = vec![
        vec![one, c(0.5), c(-0.3), c(0.1)],
        vec![c(0.5), one, c(0.25), c(0.0)],
        vec![c(-0.3), c(0.25), one, c(0.05)],
        vec![c(0.1), c(0.0), c(0.05), one],
    ];
    let singular = vec![
        vec![one, c(0.6), -one],
        vec![c(0.6), one, c(-0.6)],
        vec![-one, c(-0.6), one],
    ];
    let (means, deviations) = ([0, 70_000, -5, 1 << 20], [30_000, 10_000, 200_000, 1 << 22]);
    for matrix in [regular, singular] {
        let d = matrix.len();
        let exact = |matrix| Exact::new(&means[..d], &deviations[..d], matrix).unwrap();
        let of = exact(&matrix);
        let worst = [
            law::<U16, Fine>(&means[..d], &deviations[..d], &matrix),
            law::<U16, Coarse>(&means[..d], &deviations[..d], &matrix),
            law::<U16, Compact>(&means[..d], &deviations[..d], &matrix),
        ]
        .map(|law| worst_moment(&*law.unwrap(), &of, count));
        println!("{d} dimensions: off by {worst:.2?} standard errors");
        assert!(worst.iter().all(|worst| *worst <= 4.5), "{worst:?}");
        // The smallest correlation that is not 0, turned.
        let mut wrong = matrix.clone();
        let (i, j) = if d == 4 { (3, 2) } else { (1, 0) };
        (wrong[i][j], wrong[j][i]) = (-wrong[i][j], -wrong[j][i]);
        if d == 3 {
            // The third is the opposite of the first, whichever sign the second has.
            (wrong[2][1], wrong[1][2]) = (-wrong[2][1], -wrong[1][2]);
        }
        let law = law::<U16, Fine>(&means[..d], &deviations[..d], &wrong).unwrap();
        let worst = worst_moment(&*law, &of, count);
        println!("with a wrong sign: {worst:.1}");
        assert!(worst > 20.0, "{worst}");
    }
}

/// Points that the free coordinates place are of positive density; of one step more than rounding explains in a coordinate that is
/// not free, of none. `invert` leads back to either.
#[test]
fn a_singular_law_is_on_its_subspace_alone() {
    let one = I2F30::ONE;
    let part = |x: f64| I2F30::from_num(x);
    // y follows x, z is the sum of x and w in their units, and v has no deviation.
    let matrix = [
        [one, one, part(0.6), I2F30::ZERO, I2F30::ZERO],
        [one, one, part(0.6), I2F30::ZERO, I2F30::ZERO],
        [part(0.6), part(0.6), one, part(0.8), part(0.1)],
        [I2F30::ZERO, I2F30::ZERO, part(0.8), one, I2F30::ZERO],
        [I2F30::ZERO, I2F30::ZERO, part(0.1), I2F30::ZERO, one],
    ];
    let q = |x: [i32; 5]| x.map(I16F16::from_num);
    let (means, deviations) = (q([1, 2, 3, 4, 5]), q([3, 6, 5, 4, 0]));
    let law = MultivariateNormal::<U16, 5, Fine>::new(means, deviations, matrix).unwrap();
    assert_eq!(
        (law.rank(), law.free()),
        (2, [true, false, false, true, false])
    );
    assert_eq!((law.means(), law.deviations()), (means, deviations));
    let mut rng = Pcg32::seed_from_u64(22);
    let (mut worst, mut far) = ([0.0_f64; 2], 0);
    for _ in 0..10_000 {
        let point = law.draw(&mut rng);
        let [x, y, z, w, v] = std::array::from_fn(|i| (point[i] - means[i]).to_num::<f64>());
        assert!(v == 0.0 && law.pdf(point) > 0);
        worst[0] = worst[0].max((y - 2.0 * x).abs());
        worst[1] = worst[1].max((z - x - w).abs());
        for (i, steps) in [(1, 8), (2, 8), (4, 1)] {
            let mut off = point;
            off[i] += I16F16::from_bits(if far % 2 == 0 { steps } else { -steps });
            assert_eq!(law.pdf(off), 0, "{i} {steps}");
            far += 1;
        }
        let [a, _, _, b, _] = law.whiten(point).map(|z| z.to_num::<f64>());
        assert!(
            (a - x / 3.0).abs() < 2e-5 && (b - w / 4.0).abs() < 2e-5,
            "{a} {b} {point:?}"
        );
        // In the tails a word resolves no more.
        let close = a * a + b * b < 9.0;
        let again = law.sample(law.invert(point));
        let apart = (0..5).map(|i| (again[i] - point[i]).to_num::<f64>().abs());
        assert!(
            !close || apart.fold(0.0, f64::max) < 1e-3,
            "{point:?} {again:?}"
        );
    }
    println!(
        "off the subspace by {:.2?} steps",
        worst.map(|x| x * 65_536.0)
    );
    // Half a step of each, and that of x twice.
    assert!(worst.iter().all(|worst| *worst < 2.0 / 65_536.0));
    // Of deviations of 0 alone there is one point.
    let at = MultivariateNormal::<U16, 5, Fine>::new(means, q([0; 5]), matrix).unwrap();
    assert_eq!((at.rank(), at.draw(&mut rng)), (0, means));
    assert!(at.pdf(means) > 0 && at.pdf(q([1, 2, 3, 4, 6])) == 0);
}

/// The whitened numbers of a sample are the normals of its words, and words of 0 give the means.
#[test]
fn whitening_finds_the_normals_of_the_words() {
    let mut rng = Pcg32::seed_from_u64(23);
    let c = |x: f64| I2F30::from_num(x);
    let one = I2F30::ONE;
    let matrix = [
        [one, c(0.5), c(-0.25)],
        [c(0.5), one, c(0.125)],
        [c(-0.25), c(0.125), one],
    ];
    let bits = FixedI32::<U30>::from_bits;
    let means = [7, -(1 << 29), 1 << 28].map(bits);
    let deviations = [(1 << 26) - 1, 1 << 25, 1 << 24].map(bits);
    let law = MultivariateNormal::<U30, 3, Fine>::new(means, deviations, matrix).unwrap();
    assert_eq!(law.sample([fixed::types::U0F32::ZERO; 4]), means);
    let mut seen = 0.0_f64;
    for _ in 0..10_000 {
        let words = [(); 4].map(|()| rng.next_u32());
        let point = law.sample(words.map(fixed::types::U0F32::from_bits));
        let mut due = around(
            (-2.0 * (-f64::from(words[0]) * WORD).ln_1p()).sqrt(),
            words[1],
        )
        .to_vec();
        due.extend(around(
            (-2.0 * (-f64::from(words[2]) * WORD).ln_1p()).sqrt(),
            words[3],
        ));
        let z = law.whiten(point).map(|z| z.to_num::<f64>());
        for (z, due) in z.iter().zip(&due) {
            assert!((z - due).abs() < 1e-5, "{z} {due}");
            seen = seen.max(z.abs());
        }
    }
    assert!(seen > 3.5, "{seen}");
    // Far off the means all is at its end: nothing overflows.
    for end in [FixedI32::MIN, FixedI32::MAX] {
        let z = law.whiten([end; 3]);
        assert!(z.iter().any(|z| z.to_num::<f64>().abs() > 15.0), "{z:?}");
        assert_eq!(law.pdf([end; 3]).to_bits(), 1);
    }
}

#[test]
fn what_is_no_law_is_refused_by_name() {
    let one = I2F30::ONE;
    let bits = I16F16::from_bits;
    let c = |x: f64| I2F30::from_num(x);
    let new = |deviations: [i32; 2], matrix| {
        MultivariateNormal::<U16, 2, Fine>::new([bits(0); 2], deviations.map(bits), matrix).err()
    };
    let pair = |a: I2F30| [[one, a], [a, one]];
    let some = pair(c(0.5));
    assert_eq!(new([1, 1], some), None);
    for wrong in [-1, i32::MIN] {
        assert_eq!(new([5, wrong], some), Some(Error::Negative(1)));
        assert_eq!(new([wrong, 5], some), Some(Error::Negative(1)));
    }
    assert_eq!(new([1 << 26, 1], some), Some(Error::TooLarge(1)));
    assert_eq!(new([(1 << 26) - 1, 0], some), None);
    let step = I2F30::DELTA;
    for edge in [one, -one] {
        assert_eq!(new([5, 5], pair(edge)), None);
    }
    for wrong in [one + step, -one - step, I2F30::MAX, I2F30::MIN] {
        assert_eq!(new([5, 5], pair(wrong)), Some(Error::OutOfRange(2)));
    }
    for wrong in [one - step, one + step, I2F30::ZERO, -one] {
        assert_eq!(
            new([5, 5], [[one, c(0.5)], [c(0.5), wrong]]),
            Some(Error::OutOfRange(2))
        );
        assert_eq!(
            new([5, 5], [[wrong, c(0.5)], [c(0.5), one]]),
            Some(Error::OutOfRange(2))
        );
    }
    assert_eq!(
        new([5, 5], [[one, c(0.5)], [c(0.5) + step, one]]),
        Some(Error::OutOfRange(2))
    );
    // Means to the ends of the format.
    let far = |mean: i32, deviation: i32| {
        let means = [bits(3), bits(mean)];
        MultivariateNormal::<U16, 2, Fine>::new(means, [bits(1), bits(deviation)], some).err()
    };
    assert_eq!(far(i32::MIN, 0), None);
    assert_eq!(far(i32::MAX - 7, 1), None);
    assert_eq!(far(6 - i32::MAX, 1), Some(Error::TooLarge(1)));
    assert_eq!(
        far(i32::MAX - 6_600_000, 1_000_000),
        Some(Error::TooLarge(1))
    );
    assert_eq!(far(6_700_000 - i32::MAX, 1_000_000), None);
    // Three that all lean from each other: the limit is -1/2.
    let three = |a: I2F30, deviations: [i32; 3]| {
        let matrix = [[one, a, a], [a, one, a], [a, a, one]];
        MultivariateNormal::<U16, 3, Fine>::new([bits(0); 3], deviations.map(bits), matrix)
    };
    let flat = three(c(-0.5), [9; 3]).unwrap();
    assert_eq!((flat.rank(), flat.free()), (2, [true, true, false]));
    assert_eq!(
        three(c(-0.5) - I2F30::from_bits(3), [9; 3]).unwrap().rank(),
        2
    );
    assert_eq!(
        three(c(-0.5) + I2F30::from_bits(3), [9; 3]).unwrap().rank(),
        3
    );
    assert_eq!(
        three(c(-0.5) - I2F30::from_bits(40), [9; 3]),
        Err(Error::NotNormalizable(2))
    );
    assert_eq!(three(-one, [9; 3]), Err(Error::NotNormalizable(2)));
    assert_eq!(three(c(-0.9), [9; 3]), Err(Error::NotNormalizable(2)));
    // Those of what does not vary do nothing.
    assert_eq!(
        three(c(-0.9), [9, 9, 0]).unwrap().free(),
        [true, true, false]
    );
    assert_eq!(
        MultivariateNormal::<U16, 0, Fine>::new([], [], []),
        Err(Error::Empty(Error::NO_PLACE))
    );
    const CHECKED: Result<MultivariateNormal<U0, 1, Fine>, Error> =
        MultivariateNormal::new([FixedI32::ZERO], [FixedI32::ONE], [[I2F30::ONE]]);
    assert!(CHECKED.is_ok());
}

/// Matrices at random are accepted or refused, never anything else: overflow checks are on.
#[test]
fn any_matrix_has_a_verdict() {
    let mut rng = Pcg32::seed_from_u64(24);
    let mut verdicts = [0; 3];
    for round in 0..speed::of("matrices at random", 20_000, 400_000) {
        let d = 2 + (round % 6) as usize;
        let mut matrix = vec![vec![1 << 30; d]; d];
        let right = rng.next_u32() % 31;
        for (i, j) in (0..d).flat_map(|i| (0..i).map(move |j| (i, j))) {
            let word = rng.next_u32();
            let ends = [1 << 30, -(1 << 30), 0, (1 << 30) - 1];
            let entry = match word & 7 {
                0 => ends[(word >> 3 & 3) as usize],
                _ => (word as i32 >> 1) >> right,
            };
            (matrix[i][j], matrix[j][i]) = (entry, entry);
        }
        let deviations: Vec<i32> = (0..d)
            .map(|_| (rng.next_u32() >> 6 >> (rng.next_u32() & 31)) as i32)
            .collect();
        let words: Vec<u32> = (0..8)
            .map(|_| rng.next_u32() | if round % 7 == 0 { 0xffff_ff00 } else { 0 })
            .collect();
        match law_of_any_dimension(&vec![0; d], &deviations, &matrix) {
            Ok(law) => {
                let point = law.sample(&words);
                assert!(law.pdf(&point) > 0, "{matrix:?} {deviations:?} {words:?}");
                let _ = (law.invert(&point), law.pdf(&words), law.invert(&words));
                verdicts[0] += 1;
            }
            Err(Error::NotNormalizable(2)) => verdicts[1] += 1,
            Err(Error::TooLarge(1)) => verdicts[2] += 1,
            Err(other) => panic!("{other}: {matrix:?} {deviations:?}"),
        }
    }
    println!("accepted, refused, too large: {verdicts:?}");
    assert!(verdicts[0] > 100 && verdicts[1] > 100, "{verdicts:?}");
}
