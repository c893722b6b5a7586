//! The cosine-power lobe, for all exponents and pairs of uniforms: the logarithm of a uniform over m = n + 1, from which cosine and
//! sine come, and an azimuth.

use crate::bounds::Roundings;
use crate::inputs::in_parallel;
use crate::kept::largest;
use crate::kernels::{MARGIN, of_uniforms};
use crate::laws::by_name;
use crate::line::stated;
use crate::maps::Row;
use crate::radii::{Bin, Radii};
use crate::range::Range;
use crate::rounding::UNIT;
use crate::several::{CELLS, Cells, Proven, complaint};
use crate::unit::Unit;
use host::speed;
use microwarp::tier::{Libm, Poly, Tier};

/// By what part of itself the quotient is off: the logarithm, which is that of the standard exponential law, m and the quotient.
fn of_quotients<T: Tier>() -> f64 {
    let unit = Unit::new(&by_name("Exponential", T::NAME), &[1.0]);
    (of_uniforms(&unit, 0.0, 0, 1).most() + MARGIN + 2.0) * UNIT
}

/// Every quotient from here is tried, to the largest logarithm, which is below 17.
const FIRST: f32 = 1.0 / 1_073_741_824.0;
const LAST: f32 = 17.0;

/// The quotients of a sixteenth of a binade: what sine and cosine are off by there, and what they turn by when the quotient is off by
/// such a part of itself.
fn bin<T: Tier>(sixteenth: u32, quotient: f64) -> Bin {
    let stride = speed::or_all("one quotient of a lobe tried of every", 8009, 61, 1);
    let [mut off, mut height, mut longer] = [Range::NONE; 3];
    let (mut r, mut turned) = (0.0_f64, [0.0_f64; 2]);
    for bits in (sixteenth << 19..=(sixteenth + 1) << 19).step_by(stride as usize) {
        let x = f32::from_bits(bits);
        let (cos, rest) = T::exp_neg_pair(x);
        let sin = (rest * (1.0 + cos)).sqrt();
        let x = f64::from(x);
        let (cosine, sine) = ((-x).exp(), (-(-2.0 * x).exp_m1()).sqrt());
        let [s, c] = [f64::from(sin) - sine, f64::from(cos) - cosine];
        off.take_all(&[s; 4]);
        height.take_all(&[c; 4]);
        longer.take_all(&[s * sine + c * cosine; 4]);
        r = r.max(f64::from(sin)).max(sine);
        let by = x * cosine / sine;
        turned = [turned[0].max(by * cosine), turned[1].max(by * sine)];
    }
    let turned = turned.map(|by| 1.001 * by * quotient);
    Bin {
        off: off.wider(turned[0]),
        height: height.wider(turned[1]),
        longer,
        ..Bin::argued(r, 0.0, 0.0, 0.0)
    }
}

/// The error of a sample and of its length, of quotients off by so much. Those below the first make a cosine of 1, off by 1e-9 at
/// most, and a sine below 5e-5, off by a few parts in 2²⁴.
fn of_lobes<T: Tier>(cells: &[crate::phases::Cell], quotient: f64) -> [f64; 2] {
    for exponent in 31..149 {
        assert_eq!(T::exp_neg_pair(1.5 * 0.5_f32.powi(exponent)).0, 1.0);
    }
    let [first, last] = [FIRST, LAST].map(|x| x.to_bits() >> 19);
    let mut bins = in_parallel(last - first + 1, |i| bin::<T>(first + i, quotient));
    bins.push(Bin::argued(5e-5, 1e-10, 1e-9, 1e-9));
    let radii = Radii::of(bins);
    let plain = Roundings::PLAIN;
    [plain.sample(&radii, cells), plain.length(&radii, cells)].map(|worst| worst.bound)
}

/// What is proven of it.
pub fn rows([libm, poly]: &Cells) -> Vec<Proven> {
    let tiers = [
        of_lobes::<Libm>(libm, of_quotients::<Libm>()),
        of_lobes::<Poly>(poly, of_quotients::<Poly>()),
    ];
    let row = |i: usize| tiers.map(|bounds| bounds[i]);
    vec![
        ("PhongLobe", "sample", row(0)),
        ("PhongLobe", "unit length", row(1)),
    ]
}

/// Three roundings more of the logarithm are noticed.
#[test]
fn a_lobe_of_another_logarithm_is_noticed() {
    let [_, poly] = &*CELLS;
    let (_, [_, stated]) = stated("PhongLobe", "sample");
    let [_, found] = largest("PhongLobe", "sample");
    let judged = |quotient: f64| {
        let [proven, _] = of_lobes::<Poly>(poly, quotient);
        complaint(stated, Row { proven, found })
    };
    let right = of_quotients::<Poly>();
    assert_eq!(judged(right), None);
    assert!(judged(right + 3.0 * UNIT).is_some());
}
