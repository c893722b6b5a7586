//! Von Mises and Fisher's law, for all concentrations and pairs of uniforms: the logarithm of a uniform over the concentration, from
//! which cosine and sine come, and an azimuth.

use crate::bounds::Roundings;
use crate::cover::{Piece, binades, bins, piece};
use crate::inputs::in_parallel;
use crate::kept::largest;
use crate::laws::by_name;
use crate::line::stated;
use crate::maps::{Row, mirrored};
use crate::number::Number;
use crate::phases::Cell;
use crate::programs::{DRAWS, between, kept, uniform};
use crate::range::Range;
use crate::rounding::{Lost, UNIT};
use crate::several::{CELLS, Cells, Proven, complaint};
use crate::shapes::parts_of;
use crate::swept::{Swept, relative};
use crate::tape::each_way;
use host::errors::raise;
use host::speed;
use microwarp::Warp;
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::warp::VonMisesFisher;
use std::f64::consts::LN_2;
use std::sync::LazyLock;

/// The concentrations: below the first all are the uniform sphere, from the second on no uniform leads behind the equator, from the
/// third on e^(-2κ) is 0.
const FLAT: f32 = 1.0 / 1_073_741_824.0;
const FRONT: f32 = 20.0;
const STEEP: f32 = 40.0;

/// Where sine and cosine are made otherwise, 2⁻⁹⁰.
const DEEP: f32 = 8.077_936e-28;

/// What is kept: 1 - e^(-2κ), e^(-2κ) and e^(2κ) - 1.
const FIELDS: [&str; 3] = ["decay", "power", "rise"];

/// How far these are off, in both tiers.
static KEPT: LazyLock<[Swept; 3]> = LazyLock::new(|| {
    let stride = speed::or_all("one concentration tried of every", 400_009, 2003, 1);
    Swept::of([FLAT, STEEP], stride, |kappa| {
        let k = f64::from(kappa);
        let law = VonMisesFisher::<Poly>::new(kappa).expect("a concentration");
        let exact = [-(-2.0 * k).exp_m1(), (-2.0 * k).exp(), (2.0 * k).exp_m1()];
        let counts = [true, kappa < STEEP, kappa < FRONT];
        std::array::from_fn(|i| {
            let error = relative(kept(&law, FIELDS[i]), exact[i]);
            if counts[i] { error } else { 0.0 }
        })
    })
});

/// How far the kernels are off: ln(1 - x), ln x and ln(1 + x).
pub struct Links(pub [Swept; 3]);

/// In both tiers.
pub static LINKS: LazyLock<[Links; 2]> =
    LazyLock::new(|| [Links::of::<Libm>(), Links::of::<Poly>()]);

impl Links {
    fn of<T: Tier>() -> Self {
        // A smaller argument is its own logarithm.
        for exponent in 31..149 {
            let x = 1.5 * 0.5_f32.powi(exponent);
            assert_eq!([T::ln_1p(x), T::ln_1p(-x)], [x, -x]);
        }
        Self([
            Swept::kernel([FLAT, 0.5], |x| T::ln_1p(-x), |x| (-x).ln_1p()),
            Swept::kernel([0.5 * f32::EPSILON, 0.5001], |x| T::ln(x), f64::ln),
            Swept::kernel([FLAT, 6e34], |x| T::ln_1p(x), f64::ln_1p),
        ])
    }

    /// By how much the quotient, 1 - cos θ or 1 + cos θ, is off relatively, in units of 2⁻²⁴, of a range of it and of concentrations.
    ///
    /// L is the quotient times κ. Uniforms leave at least 2⁻²⁴ of 1, so that it is below 16.7 in front and below 17.7 behind. In
    /// front, of a product up to a half, the logarithm's error is that of the product, (e^L - 1)/L times, and the kernel's. Of a
    /// larger one u is more than a half and 1 - u exact: the logarithm is off by what the sum is, over L. Behind, 1 - u is exact,
    /// too, and the product counts (1 - e^-L)/L times.
    fn quotient(&self, kappa: Range, small: Range) -> f64 {
        let [kappa, small] = [kappa, small].map(|Range { low, high }| Range {
            low: low * (1.0 - APART),
            high: high * (1.0 + APART),
        });
        let up_to = |most: f64| Range {
            low: kappa.low * small.low,
            high: (kappa.high * small.high).min(most),
        };
        let (log, behind) = (up_to(16.7), up_to(17.7));
        let [decay, power, rise] = KEPT.each_ref().map(|swept| swept.over(kappa));
        let mut worst = 0.0;
        if log.low < LN_2 + 1e-5 {
            let log = Range {
                high: log.high.min(LN_2 + 1e-5),
                ..log
            };
            let drop = Range {
                low: -(-log.low).exp_m1(),
                high: -(-log.high).exp_m1(),
            };
            let counts = log.high.exp_m1() / log.high * (1.0 + 1e-5);
            let kernel = self.0[0].over(Range {
                high: drop.high.min(0.5),
                ..drop
            });
            raise(&mut worst, counts * (decay + rounded(drop)) + kernel);
        }
        if log.high > LN_2 - 1e-5 && log.low < log.high {
            let log = Range {
                low: log.low.max(LN_2 - 1e-5),
                ..log
            };
            let share = Range {
                low: (-log.high).exp(),
                high: (-log.low).exp(),
            };
            let of_power = (log.high - 2.0 * kappa.low).exp().min(1.0);
            let sum = of_power * (power + 1.0) + rounded(share);
            raise(
                &mut worst,
                sum / log.low * (1.0 + 1e-5) + self.0[1].over(share),
            );
        }
        if kappa.low < f64::from(FRONT) && behind.low < behind.high {
            let product = Range {
                low: behind.low.exp_m1(),
                high: behind.high.exp_m1(),
            };
            let counts = -(-behind.low).exp_m1() / behind.low * (1.0 + 1e-5);
            let kernel = self.0[2].over(product);
            raise(&mut worst, counts * (rise + rounded(product)) + kernel);
        }
        (worst + rounded(small)) * (1.0 + 1e-5)
    }
}

/// How far numbers that are rounded may be from their ranges, many times over: ranges overlap by it, so that what crosses a power of 2
/// is counted with the larger numbers.
const APART: f64 = 1e-6;

/// By what part of itself a number of a range is rounded, in units of 2⁻²⁴.
pub fn rounded(range: Range) -> f64 {
    (Lost::of(range).absolute / range.low / UNIT).min(1.0)
}

/// sin θ and cos θ of 1 - cos θ, or of 1 + cos θ.
pub struct Halves;

impl Halves {
    pub fn place<N: Number>(small: N) -> [N; 2] {
        // 2 - s is rounded by 2⁻²⁴ at most, and not where s is 1 or more: the product is below 1 + 2⁻²⁴, and rounded to 1.
        let square = (small * (small.like(2.0) - small)).at_most(1.0);
        [square.sqrt(), small.like(1.0) - small]
    }

    /// Of a number of a range that is off relatively, in units of 2⁻²⁴.
    fn pieces(small: Range, off: f64) -> Vec<Piece> {
        let halves = off * UNIT * small.high / Lost::of(small).absolute;
        let mut pieces = Vec::new();
        each_way(|tape| {
            let place = Self::place(tape.input(small).off(halves));
            if !tape.is_impossible() {
                pieces.push(piece(tape, &place));
            }
        });
        pieces
    }
}

/// The numbers of which sine and cosine are made. The first uniform of the equator is off by 3·2⁻²⁵ at most, and leaves about e^(-κ)
/// of 1. So where κ is below 4 they are less than 21·2⁻²⁴ above 1. Elsewhere they are less than ln(5/2)/15.7 above it, since no uniform
/// leaves less than 2⁻²⁴.
fn smalls(parts: u32) -> Vec<Range> {
    let mut smalls = binades(-44, 1.0 + NEXT, parts);
    smalls[0].low = f64::from(DEEP);
    smalls.extend(parts_of(1.0 + NEXT, 1.06, parts));
    smalls
}

const NEXT: f64 = 32.0 * UNIT;

/// What is proven of all sines and cosines, where the quotient is off by so much more than it is.
fn all(links: &Links, more: f64) -> Vec<Piece> {
    let parts = speed::of("parts of a binade of concentrations", 8, 64);
    let mut kappas = binades(-12, 128.0, parts);
    kappas[0].low = f64::from(FLAT);
    kappas.push(Range {
        low: 128.0,
        high: 1e30,
    });
    let smalls = smalls(parts);
    let of = in_parallel(smalls.len() as u32, |i| {
        let small = smalls[i as usize];
        let kappas = kappas
            .iter()
            .filter(|kappa| small.low < 1.0 + NEXT || kappa.high > 4.0);
        let quotients = kappas.map(|&kappa| links.quotient(kappa, small));
        Halves::pieces(small, quotients.fold(0.0, f64::max) + more)
    });
    of.into_iter().flatten().collect()
}

/// The error of a sample. A concentration that counts as 2⁻³⁰ moves the height by half of that at most. Where sine and cosine are of
/// other roots, sines are below 2⁻⁴⁴.
fn samples(cells: &[Cell], links: &Links, more: f64) -> f64 {
    let radii = bins(&all(links, more));
    Roundings::PLAIN.sample(&radii, cells).bound + 0.5 * f64::from(FLAT) + 1e-12
}

/// The error of the length, whatever the number is off by of which sine and cosine are made.
fn length(cells: &[Cell]) -> f64 {
    let pieces: Vec<_> = smalls(512)
        .into_iter()
        .flat_map(|small| Halves::pieces(small, 0.0))
        .collect();
    Roundings::PLAIN.length(&bins(&pieces), cells).bound + 1e-12
}

/// What is proven of it.
pub fn rows([libm, poly]: &Cells) -> Vec<Proven> {
    let sample = [samples(libm, &LINKS[0], 0.0), samples(poly, &LINKS[1], 0.0)];
    let name = "VonMisesFisher";
    vec![
        (name, "sample", sample),
        (name, "unit length", [length(libm), length(poly)]),
    ]
}

/// A direction by the operations that are examined, with what is kept so many ulp larger than it is, and the exact 1 - cos θ.
fn by_operations<T: Tier>(law: &VonMisesFisher<T>, u: [f32; 2], ulps: u32) -> ([f32; 3], f64) {
    let kappa = law.concentration();
    let [decay, power, rise] = FIELDS.map(|name| f32::from_bits(kept(law, name).to_bits() + ulps));
    let behind = u[0] > kept(law, "equator");
    let drop = u[0] * decay;
    let log = if behind {
        T::ln_1p((1.0 - u[0]) * rise)
    } else if drop <= 0.5 {
        -T::ln_1p(-drop)
    } else {
        -T::ln((1.0 - u[0]) + u[0] * power)
    };
    let small = log / kappa;
    let [sin, cos] = Halves::place(small);
    let ((s, c), cos) = (mirrored::<T>(u[1]), if behind { -cos } else { cos });
    let k = f64::from(kappa);
    let exact = -(f64::from(u[0]) * (-2.0 * k).exp_m1()).ln_1p() / k;
    ([sin * c, sin * s, cos], exact)
}

fn directions_are_made_so<T: Tier>() {
    let of = by_name("VonMisesFisher", T::NAME);
    let mut noticed = 0;
    for k in 0..*DRAWS {
        let kappa = between(k, 1e-10, 1e10);
        let u = [k, k + *DRAWS].map(uniform);
        let law = VonMisesFisher::<T>::new(kappa).expect("a concentration");
        let (made, exact) = by_operations(&law, u, 0);
        let x = law.sample(u);
        if u[0] >= 1e-15 {
            assert_eq!(x, made, "{} {kappa} {u:?}", T::NAME);
            noticed += u32::from(x != by_operations(&law, u, 1).0);
        }
        let entry = (of.build)(&[kappa]).expect("a law");
        let z = entry.truth.sample([u[0].into(), 0.0, 0.0, 0.0])[2];
        assert!((1.0 - exact - z).abs() <= 1e-9, "{kappa} {u:?} {z} {exact}");
    }
    // An ulp more of what is kept changes bits.
    assert!(noticed > *DRAWS / 8, "{noticed} bits differ");
}

#[test]
fn directions_of_von_mises_and_fisher_are_a_logarithm_over_the_concentration() {
    directions_are_made_so::<Libm>();
    directions_are_made_so::<Poly>();
}

/// A rounding more of the quotient is noticed.
#[test]
fn a_law_of_von_mises_and_fisher_of_another_logarithm_is_noticed() {
    let [_, poly] = &*CELLS;
    let (_, [_, stated]) = stated("VonMisesFisher", "sample");
    let [_, found] = largest("VonMisesFisher", "sample");
    let judged = |more| {
        complaint(
            stated,
            Row {
                proven: samples(poly, &LINKS[1], more),
                found,
            },
        )
    };
    assert_eq!(judged(0.0), None);
    assert!(judged(1.0).is_some());
}
