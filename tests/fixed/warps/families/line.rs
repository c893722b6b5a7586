//! Warps of one word: the tent and the exponentials.

use super::family::{
    Family, Subject, beyond, check, density_error, family, in_format, one, uniform,
};
use crate::raw::{OfWords, Raw, Words, accepted, raw};
use microwarp::fixed::warp::{
    Exponential, Laplace, Logistic, Rayleigh, StandardExponential, Tent, TruncatedExponential,
};

fn back_error(back: Words, w: u32) -> f64 {
    uniform(back[0]) - uniform(w)
}

/// In steps, of which `one` are 1; so are all lengths below.
fn tent(warp: Box<dyn Raw>, one: f64, radius: u32) -> Option<Subject> {
    let r = f64::from(radius);
    let peak = one / r;
    let density = move |x: f64| (r - x.abs()) / r * peak;
    Subject::new(vec![("n", r)], move |[w, other], errors| {
        let u = uniform(w);
        let due = if u < 0.5 {
            (2.0 * u).sqrt() - 1.0
        } else {
            1.0 - (2.0 - 2.0 * u).sqrt()
        };
        let x = warp.sample(&[w]);
        let steps = f64::from(x[0] as i32);
        check(steps.abs() < r, "outside")?;
        let got = warp.pdf(&x);
        check(got > 0, "no density at a sample")?;
        errors[0] = beyond(steps - due * r, 1.0) / r;
        errors[1] = density_error(got, density(steps), peak);
        errors[2] = back_error(warp.invert(&x), w);
        // Anywhere.
        let any = ((i64::from(other as i32) * i64::from(radius)) >> 31) as i32;
        let there = warp.pdf(&[any as u32]);
        if f64::from(any).abs() < r {
            errors[1] = errors[1].max(density_error(there, density(any.into()), peak));
        } else {
            check(there == 0, "density outside")?;
        }
        Ok(())
    })
}

fn standard(warp: Box<dyn Raw>) -> Option<Subject> {
    let length = |x: u32| f64::from(x) / 2_f64.powi(27);
    Subject::new(vec![], move |[w, other], errors| {
        let x = warp.sample(&[w]);
        check(length(x[0]) <= 22.19, "outside")?;
        check(warp.pdf(&x) > 0, "no density at a sample")?;
        errors[0] = length(x[0]) + (-uniform(w)).ln_1p();
        errors[2] = back_error(warp.invert(&x), w);
        for x in [x[0], other] {
            let error = density_error(warp.pdf(&[x]), (-length(x)).exp(), 1.0);
            errors[1] = errors[1].max(error);
        }
        Ok(())
    })
}

fn exponential(warp: Box<dyn Raw>, one: f64, mean: u32) -> Option<Subject> {
    let m = f64::from(mean);
    let peak = one / m;
    Subject::new(vec![("n", m)], move |[w, other], errors| {
        let x = warp.sample(&[w]);
        let steps = f64::from(x[0]);
        check(steps <= 22.19 * m, "outside")?;
        check(warp.pdf(&x) > 0, "no density at a sample")?;
        let due = -(-uniform(w)).ln_1p() * m;
        errors[0] = beyond(steps - due, 1.0) / m;
        errors[2] = back_error(warp.invert(&x), w);
        for x in [x[0], other] {
            let due = (-f64::from(x) / m).exp() * peak;
            errors[1] = errors[1].max(density_error(warp.pdf(&[x]), due, peak));
        }
        Ok(())
    })
}

fn truncated(warp: Box<dyn Raw>, one: f64, mean: u32, length: u32) -> Option<Subject> {
    let (m, l) = (f64::from(mean), f64::from(length));
    let z = l / m;
    // What the density is in means, at 0: one over this, which is in steps.
    let mass = -(-z).exp_m1() * m;
    let peak = one / mass;
    let truth = move |w: f64| -(w.clamp(0.0, 1.0) * (-z).exp_m1()).ln_1p() * m;
    Subject::new(vec![("n", mass)], move |[w, other], errors| {
        let x = warp.sample(&[w]);
        let steps = f64::from(x[0]);
        check(x[0] < length, "outside")?;
        check(warp.pdf(&x) > 0, "no density at a sample")?;
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
        errors[2] = back_error(warp.invert(&x), w);
        let any = ((u64::from(other) * u64::from(length)) >> 32) as u32;
        for x in [x[0], any] {
            let due = (-f64::from(x) / m).exp() * peak;
            errors[1] = errors[1].max(density_error(warp.pdf(&[x]), due, peak));
        }
        check(other < length || warp.pdf(&[other]) == 0, "density outside")
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
fn symmetric(warp: Box<dyn Raw>, one: f64, [a, s]: [u32; 2], half: Half) -> Option<Subject> {
    let [away, beyond_it, density] = half;
    let (location, scale) = (f64::from(a as i32), f64::from(s));
    let height = one / scale;
    let peak = density(0.0) * height;
    Subject::new(vec![("n", scale)], move |[w, other], errors| {
        let upper = w >> 31 == 1;
        let sign = if upper { 1.0 } else { -1.0 };
        let rank = if upper { !w } else { w };
        let tail = (f64::from(rank) + 0.5) * super::family::WORD;
        let x = warp.sample(&[w]);
        let off = f64::from(x[0] as i32) - location;
        check(off * sign >= 0.0, "on the other side")?;
        check(off.abs() <= 22.9 * scale, "outside")?;
        check(warp.pdf(&x) > 0, "no density at a sample")?;
        errors[0] = beyond(off * sign - away(tail) * scale, 1.0) / scale;
        errors[2] = back_error(warp.invert(&x), w);
        // Anywhere, and near.
        let near = (f64::from(other as i32) / 2_f64.powi(27) * scale) as i32;
        let near = (a as i32).saturating_add(near);
        for x in [x[0], other, near as u32] {
            let place = f64::from(x as i32);
            let m = (place - location).abs() / scale;
            let due = density(m) * height;
            errors[1] = errors[1].max(density_error(warp.pdf(&[x]), due, peak));
            let back = uniform(warp.invert(&[x])[0]);
            let part = if place > location { 1.0 - back } else { back };
            check((part - beyond_it(m)).abs() < 1e-4, "an inverse elsewhere")?;
        }
        Ok(())
    })
}

fn rayleigh(warp: Box<dyn Raw>, one: f64, sigma: u32) -> Option<Subject> {
    let s = f64::from(sigma);
    let height = one / s;
    Subject::new(vec![("n", s)], move |[w, other], errors| {
        let x = warp.sample(&[w]);
        let steps = f64::from(x[0]);
        check(steps <= 6.67 * s, "outside")?;
        check(warp.pdf(&x) > 0, "no density at a sample")?;
        let due = (-2.0 * (-uniform(w)).ln_1p()).sqrt() * s;
        errors[0] = beyond(steps - due, 1.0) / s;
        errors[2] = back_error(warp.invert(&x), w);
        let near = (f64::from(other) / 2_f64.powi(29) * s) as u32;
        for x in [x[0], other, near] {
            let r = f64::from(x) / s;
            let due = r * (-0.5 * r * r).exp() * height;
            errors[1] = errors[1].max(density_error(warp.pdf(&[x]), due, height));
        }
        Ok(())
    })
}

const ROWS: &[&str] = &["sample, max", "pdf", "round trip"];

pub(super) fn families(all: &mut Vec<Family>) {
    family!(all, "Tent", ROWS, 2, |p, G| {
        let warp = in_format!(p[0], F, accepted(Tent::<F, G>::new(OfWords::of(&p[1..]))));
        tent(warp?, one(p[0]), p[1])
    });
    family!(all, "StandardExponential", ROWS, 0, |_p, G| {
        standard(raw(StandardExponential::<G>::new()))
    });
    family!(all, "Exponential", ROWS, 2, |p, G| {
        let mean = &p[1..];
        let warp = in_format!(
            p[0],
            F,
            accepted(Exponential::<F, G>::from_mean(OfWords::of(mean)))
        );
        exponential(warp?, one(p[0]), p[1])
    });
    family!(all, "Laplace", ROWS, 3, |p, G| {
        let [a, s] = [&p[1..], &p[2..]];
        let warp = in_format!(
            p[0],
            F,
            accepted(Laplace::<F, G>::new(OfWords::of(a), OfWords::of(s)))
        );
        symmetric(warp?, one(p[0]), [p[1], p[2]], LAPLACE)
    });
    family!(all, "Logistic", ROWS, 3, |p, G| {
        let [a, s] = [&p[1..], &p[2..]];
        let warp = in_format!(
            p[0],
            F,
            accepted(Logistic::<F, G>::new(OfWords::of(a), OfWords::of(s)))
        );
        symmetric(warp?, one(p[0]), [p[1], p[2]], LOGISTIC)
    });
    family!(all, "Rayleigh", ROWS, 2, |p, G| {
        let warp = in_format!(
            p[0],
            F,
            accepted(Rayleigh::<F, G>::new(OfWords::of(&p[1..])))
        );
        rayleigh(warp?, one(p[0]), p[1])
    });
    family!(all, "TruncatedExponential", ROWS, 3, |p, G| {
        let [mean, length] = [&p[1..], &p[2..]];
        let warp = in_format!(p[0], F, {
            accepted(TruncatedExponential::<F, G>::from_mean(
                OfWords::of(mean),
                OfWords::of(length),
            ))
        });
        truncated(warp?, one(p[0]), p[1], p[2])
    });
}
