//! Warps of one word: the tent and the exponentials.

use super::family::{Family, Subject, beyond, check, density_error, family, in_format, uniform};
use fixed::types::extra::LeEqU32;
use fixed::types::{U0F32, U5F27};
use fixed::{FixedI32, FixedU32};
use microwarp::fixed::Grade;
use microwarp::fixed::warp::{
    Exponential, Laplace, Logistic, Rayleigh, StandardExponential, Tent, TruncatedExponential,
};
use microwarp::{Invert, Warp};

/// Steps of a format in 1.
fn one<Frac: LeEqU32>() -> f64 {
    2_f64.powi(Frac::U32 as i32)
}

fn word(w: u32) -> U0F32 {
    U0F32::from_bits(w)
}

fn back_error(back: U0F32, w: u32) -> f64 {
    back.to_num::<f64>() - uniform(w)
}

fn tent<Frac: LeEqU32 + 'static, G: Grade>(radius: u32) -> Option<Subject> {
    let bits = FixedI32::<Frac>::from_bits;
    let warp = Tent::<Frac, G>::new(bits(radius as i32)).ok()?;
    let r = f64::from(radius);
    let peak = one::<Frac>() / r;
    let density = move |x: f64| (r - x.abs()) / r * peak;
    Subject::new(vec![("n", r)], move |[w, other], errors| {
        let u = uniform(w);
        let due = if u < 0.5 {
            (2.0 * u).sqrt() - 1.0
        } else {
            1.0 - (2.0 - 2.0 * u).sqrt()
        };
        let x = warp.sample(word(w));
        let steps = f64::from(x.to_bits());
        check(steps.abs() < r, "outside")?;
        let got = warp.pdf(x);
        check(got > 0, "no density at a sample")?;
        errors[0] = beyond(steps - due * r, 1.0) / r;
        errors[1] = density_error(got, density(steps), peak);
        errors[2] = back_error(warp.invert(x), w);
        // Anywhere.
        let any = ((i64::from(other as i32) * i64::from(radius)) >> 31) as i32;
        let there = warp.pdf(bits(any));
        if f64::from(any).abs() < r {
            errors[1] = errors[1].max(density_error(there, density(any.into()), peak));
        } else {
            check(there == 0, "density outside")?;
        }
        Ok(())
    })
}

fn standard<G: Grade>() -> Option<Subject> {
    let warp = StandardExponential::<G>::new();
    Subject::new(vec![], move |[w, other], errors| {
        let x = warp.sample(word(w));
        check(x <= 22.19, "outside")?;
        check(warp.pdf(x) > 0, "no density at a sample")?;
        errors[0] = x.to_num::<f64>() + (-uniform(w)).ln_1p();
        errors[2] = back_error(warp.invert(x), w);
        for x in [x, U5F27::from_bits(other)] {
            let error = density_error(warp.pdf(x), (-x.to_num::<f64>()).exp(), 1.0);
            errors[1] = errors[1].max(error);
        }
        Ok(())
    })
}

fn exponential<Frac: LeEqU32 + 'static, G: Grade>(mean: u32) -> Option<Subject> {
    let bits = FixedU32::<Frac>::from_bits;
    let warp = Exponential::<Frac, G>::from_mean(bits(mean)).ok()?;
    let m = f64::from(mean);
    let peak = one::<Frac>() / m;
    Subject::new(vec![("n", m)], move |[w, other], errors| {
        let x = warp.sample(word(w));
        let steps = f64::from(x.to_bits());
        check(steps <= 22.19 * m, "outside")?;
        check(warp.pdf(x) > 0, "no density at a sample")?;
        let due = -(-uniform(w)).ln_1p() * m;
        errors[0] = beyond(steps - due, 1.0) / m;
        errors[2] = back_error(warp.invert(x), w);
        for x in [x, bits(other)] {
            let due = (-f64::from(x.to_bits()) / m).exp() * peak;
            errors[1] = errors[1].max(density_error(warp.pdf(x), due, peak));
        }
        Ok(())
    })
}

fn truncated<Frac: LeEqU32 + 'static, G: Grade>(mean: u32, length: u32) -> Option<Subject> {
    let bits = FixedU32::<Frac>::from_bits;
    let warp = TruncatedExponential::<Frac, G>::from_mean(bits(mean), bits(length)).ok()?;
    let (m, l) = (f64::from(mean), f64::from(length));
    let z = l / m;
    // What the density is in means, at 0: one over this, which is in steps.
    let mass = -(-z).exp_m1() * m;
    let peak = one::<Frac>() / mass;
    let truth = move |w: f64| -(w.clamp(0.0, 1.0) * (-z).exp_m1()).ln_1p() * m;
    Subject::new(vec![("n", mass)], move |[w, other], errors| {
        let x = warp.sample(word(w));
        let steps = f64::from(x.to_bits());
        check(x.to_bits() < length, "outside")?;
        check(warp.pdf(x) > 0, "no density at a sample")?;
        // Beyond a word of the uniform to either side and a step below.
        let u = uniform(w);
        let (least, most) = (
            truth(u - super::family::WORD) - 1.0,
            truth(u + super::family::WORD),
        );
        let off = (least - steps).max(steps - most).max(0.0);
        errors[0] = if steps.is_nan() || least.is_nan() {
            f64::NAN
        } else {
            off
        } / m.min(l);
        errors[2] = back_error(warp.invert(x), w);
        let any = ((u64::from(other) * u64::from(length)) >> 32) as u32;
        for x in [x, bits(any)] {
            let due = (-f64::from(x.to_bits()) / m).exp() * peak;
            errors[1] = errors[1].max(density_error(warp.pdf(x), due, peak));
        }
        check(
            other < length || warp.pdf(bits(other)) == 0,
            "density outside",
        )
    })
}

/// Laplace's and the logistic distribution: -ln of the part beyond in scales, that part, and the density, at m scales
/// from the location.
type Half = [fn(f64) -> f64; 3];

const LAPLACE: Half = [
    |t| -(2.0 * t).ln(),
    |m| 0.5 * (-m).exp(),
    |m| 0.5 * (-m).exp(),
];
const LOGISTIC: Half = [
    |t| ((1.0 - t) / t).ln(),
    |m| (-m).exp() / (1.0 + (-m).exp()),
    |m| (-m).exp() / (1.0 + (-m).exp()).powi(2),
];

/// A warp of a location and a scale, over its sample, its density and its inverse.
fn symmetric<Frac: LeEqU32 + 'static, W>(warp: W, [a, s]: [u32; 2], half: Half) -> Option<Subject>
where
    W: Invert<Uniforms = U0F32, Point = FixedI32<Frac>, Density = microwarp::fixed::Density>
        + 'static,
{
    let [away, beyond_it, density] = half;
    let (location, scale) = (f64::from(a as i32), f64::from(s));
    let height = one::<Frac>() / scale;
    let peak = density(0.0) * height;
    Subject::new(vec![("n", scale)], move |[w, other], errors| {
        let upper = w >> 31 == 1;
        let sign = if upper { 1.0 } else { -1.0 };
        let rank = if upper { !w } else { w };
        let tail = (f64::from(rank) + 0.5) * super::family::WORD;
        let x = warp.sample(word(w));
        let off = f64::from(x.to_bits()) - location;
        check(off * sign >= 0.0, "on the other side")?;
        check(off.abs() <= 22.9 * scale, "outside")?;
        check(warp.pdf(x) > 0, "no density at a sample")?;
        errors[0] = beyond(off * sign - away(tail) * scale, 1.0) / scale;
        errors[2] = back_error(warp.invert(x), w);
        // Anywhere, and near.
        let near = (f64::from(other as i32) / 2_f64.powi(27) * scale) as i32;
        let near = (a as i32).saturating_add(near);
        for x in [
            x,
            FixedI32::from_bits(other as i32),
            FixedI32::from_bits(near),
        ] {
            let m = (f64::from(x.to_bits()) - location).abs() / scale;
            let due = density(m) * height;
            errors[1] = errors[1].max(density_error(warp.pdf(x), due, peak));
            let back = warp.invert(x).to_num::<f64>();
            let part = if f64::from(x.to_bits()) > location {
                1.0 - back
            } else {
                back
            };
            check((part - beyond_it(m)).abs() < 1e-4, "an inverse elsewhere")?;
        }
        Ok(())
    })
}

fn laplace<Frac: LeEqU32 + 'static, G: Grade>(a: u32, s: u32) -> Option<Subject> {
    let bits = |x: u32| FixedI32::<Frac>::from_bits(x as i32);
    symmetric(
        Laplace::<Frac, G>::new(bits(a), bits(s)).ok()?,
        [a, s],
        LAPLACE,
    )
}

fn logistic<Frac: LeEqU32 + 'static, G: Grade>(a: u32, s: u32) -> Option<Subject> {
    let bits = |x: u32| FixedI32::<Frac>::from_bits(x as i32);
    symmetric(
        Logistic::<Frac, G>::new(bits(a), bits(s)).ok()?,
        [a, s],
        LOGISTIC,
    )
}

fn rayleigh<Frac: LeEqU32 + 'static, G: Grade>(sigma: u32) -> Option<Subject> {
    let bits = FixedU32::<Frac>::from_bits;
    let warp = Rayleigh::<Frac, G>::new(bits(sigma)).ok()?;
    let s = f64::from(sigma);
    let height = one::<Frac>() / s;
    Subject::new(vec![("n", s)], move |[w, other], errors| {
        let x = warp.sample(word(w));
        let steps = f64::from(x.to_bits());
        check(steps <= 6.67 * s, "outside")?;
        check(warp.pdf(x) > 0, "no density at a sample")?;
        let due = (-2.0 * (-uniform(w)).ln_1p()).sqrt() * s;
        errors[0] = beyond(steps - due, 1.0) / s;
        errors[2] = back_error(warp.invert(x), w);
        let near = (f64::from(other) / 2_f64.powi(29) * s) as u32;
        for x in [x, bits(other), bits(near)] {
            let r = f64::from(x.to_bits()) / s;
            let due = r * (-0.5 * r * r).exp() * height;
            errors[1] = errors[1].max(density_error(warp.pdf(x), due, height));
        }
        Ok(())
    })
}

const ROWS: &[&str] = &["sample, max", "pdf", "round trip"];

pub(super) fn families(all: &mut Vec<Family>) {
    family!(all, "Tent", ROWS, 2, |p, G| in_format!(p[0], tent, G, p[1]));
    family!(all, "StandardExponential", ROWS, 0, |_p, G| standard::<G>());
    family!(all, "Exponential", ROWS, 2, |p, G| in_format!(
        p[0],
        exponential,
        G,
        p[1]
    ));
    family!(all, "Laplace", ROWS, 3, |p, G| in_format!(
        p[0], laplace, G, p[1], p[2]
    ));
    family!(all, "Logistic", ROWS, 3, |p, G| in_format!(
        p[0], logistic, G, p[1], p[2]
    ));
    family!(all, "Rayleigh", ROWS, 2, |p, G| in_format!(
        p[0], rayleigh, G, p[1]
    ));
    family!(all, "TruncatedExponential", ROWS, 3, |p, G| in_format!(
        p[0], truncated, G, p[1], p[2]
    ));
}
