//! Warps that are exact, against long integers, and the route of `f32`.

use super::family::{Family, Subject, WORD, check, family};
use crate::raw::{OfWords, Raw, accepted};
use fixed::types::extra::{U0, U16};
use fixed::types::{I0F32, I16F16, I32F0, U2F62, U16F16, U32F32};
use fixed::{FixedI32, FixedU32};
use microwarp::fixed::warp::{
    Cone, Disk, NormalPair, PhongLobe, StandardNormalPair, Tent, Triangle, TruncatedExponential,
};
use microwarp::fixed::{Density, Float, FloatPoint, FloatUniforms, Grade, Interval};
use microwarp::{Invert, Warp};

/// All values from the first on, in words, against exact shares.
fn interval(warp: Box<dyn Raw>, first: u32, count: u64, fraction: u32) -> Option<Subject> {
    // 1/length in steps is this over the count.
    let whole = 1_i128 << (32 + fraction);
    let most = i128::from(u64::MAX) * i128::from(count);
    let due = whole.clamp(i128::from(count), most);
    Subject::new(vec![], move |[w, other], errors| {
        let steps = (u64::from(w) * count) >> 32;
        let x = first.wrapping_add(steps as u32);
        check(warp.sample(&[w])[0] == x, "not the value of the word")?;
        // The first word of a value.
        let word = (u128::from(steps) << 32).div_ceil(u128::from(count));
        check(
            u128::from(warp.invert(&[x])[0]) == word,
            "not the first word",
        )?;
        let got = warp.pdf(&[x]);
        check(got > 0, "no density at a sample")?;
        let off = i128::from(got.to_bits()) * i128::from(count) - due;
        errors[0] = off as f64 / count as f64 * WORD;
        let inside = u64::from(other.wrapping_sub(first)) < count;
        check((warp.pdf(&[other]) > 0) == inside, "density outside")
    })
}

fn any_interval(p: &[u32]) -> Option<Subject> {
    let [a, b] = [p[1], p[2]];
    let (unsigned, signed) = (
        (i64::from(b) - i64::from(a)) as u64,
        (i64::from(b as i32) - i64::from(a as i32)) as u64,
    );
    macro_rules! of {
        ($of:ty, $new:ident) => {
            accepted(Interval::<$of>::$new(OfWords::of(&[a]), OfWords::of(&[b])))?
        };
    }
    match p[0] % 6 {
        0 => interval(of!(u32, new), a, unsigned, 0),
        1 => interval(of!(i32, new), a, signed, 0),
        2 => interval(of!(i32, inclusive), a, signed + 1, 0),
        3 => interval(of!(U16F16, new), a, unsigned, 16),
        4 => interval(of!(I0F32, new), a, signed, 32),
        _ => interval(of!(I16F16, inclusive), a, signed + 1, 16),
    }
}

/// Numbers of an array or one.
trait Numbers {
    fn numbers(&self) -> Vec<f64>;
}

impl Numbers for f32 {
    fn numbers(&self) -> Vec<f64> {
        vec![f64::from(*self)]
    }
}

impl<const N: usize> Numbers for [f32; N] {
    fn numbers(&self) -> Vec<f64> {
        self.map(f64::from).to_vec()
    }
}

/// A warp beside its route of `f32`: uniforms of any bits.
fn route<W>(
    warp: W,
    uniforms: fn([f32; 2]) -> <W::Uniforms as FloatUniforms>::Float,
    exact: fn(W::Point) -> Vec<f64>,
) -> Option<Subject>
where
    W: Invert<Density = Density> + Copy + 'static,
    W::Uniforms: FloatUniforms,
    W::Point: FloatPoint,
    <W::Uniforms as FloatUniforms>::Float: Numbers,
    <W::Point as FloatPoint>::Float: Numbers,
{
    let float = Float::new(warp);
    Subject::new(vec![], move |words, errors| {
        let u = uniforms(words.map(f32::from_bits));
        let point = float.sample(u);
        let due = exact(warp.sample(W::Uniforms::words(u)));
        for (got, due) in point.numbers().into_iter().zip(due) {
            if due != 0.0 {
                let error = (got / due - 1.0).abs();
                errors[0] = if error <= errors[0] { errors[0] } else { error };
            }
        }
        let density = float.pdf(point);
        check(
            density > 0.0 && density.is_finite(),
            "no density at a sample",
        )?;
        let back = float.invert(point).numbers();
        check(
            back.into_iter().all(|u| (0.0..1.0).contains(&u)),
            "an inverse out of range",
        )
    })
}

fn any_route<G: Grade>(p: &[u32]) -> Option<Subject> {
    fn pair<Frac: fixed::types::extra::LeEqU32>(point: [FixedI32<Frac>; 2]) -> Vec<f64> {
        point.map(|c| c.to_num()).to_vec()
    }
    fn triple(point: [fixed::types::I2F30; 3]) -> Vec<f64> {
        point.map(|c| c.to_num()).to_vec()
    }
    let [a, b] = [p[1], p[2]];
    let wide = u64::from(a) << 32 | u64::from(b);
    match p[0] % 8 {
        0 => route(Disk::<G>::new(), |u| u, pair),
        1 => route(StandardNormalPair::<G>::new(), |u| u, pair),
        2 => route(Triangle::<G>::new(), |u| u, triple),
        3 => route(
            Cone::<G>::from_one_minus_cos(U2F62::from_bits(wide >> ((p[0] >> 3) % 32))).ok()?,
            |u| u,
            triple,
        ),
        4 => route(
            PhongLobe::<G>::new(U32F32::from_bits(wide >> ((p[0] >> 3) % 64))).ok()?,
            |u| u,
            triple,
        ),
        5 => {
            let deviation = FixedI32::<U16>::from_bits((b >> 5) as i32);
            let means = [a, a.rotate_left(16)].map(|m| FixedI32::from_bits(m as i32 >> 2));
            route(
                NormalPair::<U16, G>::new(means, deviation).ok()?,
                |u| u,
                pair,
            )
        }
        6 => {
            let radius = I32F0::from_bits(a as i32);
            route(
                Tent::<U0, G>::new(radius).ok()?,
                |[u, _]| u,
                |x| vec![x.to_num()],
            )
        }
        _ => {
            let [mean, length] = [a, b].map(FixedU32::<U16>::from_bits);
            let warp = TruncatedExponential::<U16, G>::from_mean(mean, length).ok()?;
            route(warp, |[u, _]| u, |x| vec![x.to_num()])
        }
    }
}

pub(super) fn families(all: &mut Vec<Family>) {
    all.push(Family {
        name: "Interval",
        grade: 0,
        rows: &["pdf, to 1.1642e-10"],
        parameters: 3,
        words: 2,
        build: any_interval,
    });
    family!(
        all,
        "Float",
        &["sample, of the coordinate 1.2e-7"],
        3,
        |p, G| any_route::<G>(p)
    );
}
