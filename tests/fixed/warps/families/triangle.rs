//! Triangles.

use super::family::{
    Family, STEP, Subject, beyond, check, density_error, family, in_format, one, uniform,
};
use crate::raw::{Raw, accepted, raw, signed, vertices_of_bits};
use crate::warps::triangle_on::{density, stated};
use microwarp::fixed::warp::{Triangle, TriangleOn};

/// Barycentric coordinates.
fn weights([u, v]: [u32; 2]) -> [f64; 3] {
    let (u, v) = (uniform(u), uniform(v));
    let s = u.sqrt();
    [(1.0 - u) / (1.0 + s), s * v, s * (1.0 - v)]
}

fn triangle(warp: Box<dyn Raw>) -> Option<Subject> {
    Subject::new(vec![], move |words, errors| {
        let sample = warp.sample(&words);
        let point: [f64; 3] = signed(sample, STEP);
        // Sums of so few digits are exact.
        check(
            point.iter().all(|c| *c >= 0.0) && point.iter().sum::<f64>() == 1.0,
            "outside",
        )?;
        check(warp.pdf(&sample) == 2, "no density at a sample")?;
        let due = weights(words);
        errors[0] = [0, 1, 2]
            .map(|i| (point[i] - due[i]).abs())
            .into_iter()
            .fold(0.0, f64::max);
        let back = warp.invert(&sample);
        let [u, v] = [0, 1].map(|i| uniform(back[i]) - uniform(words[i]));
        errors[1] = u.abs().max((v * uniform(words[0]).sqrt()).abs());
        Ok(())
    })
}

/// The error is that which the page states of a sample.
fn on<const D: usize>(
    warp: Box<dyn Raw>,
    one: f64,
    error: f64,
    vertices: [[i32; D]; 3],
) -> Option<Subject> {
    let density = density(vertices) * one * one;
    let [a, b, c] = vertices;
    let low: [i32; D] = std::array::from_fn(|k| a[k].min(b[k]).min(c[k]));
    let high: [i32; D] = std::array::from_fn(|k| a[k].max(b[k]).max(c[k]));
    Subject::new(vec![], move |words, errors| {
        let sample = warp.sample(&words);
        let [u, v, w] = weights(words);
        for k in 0..D {
            let x = sample[k] as i32;
            check((low[k]..=high[k]).contains(&x), "outside")?;
            // From the least coordinate, so that nothing far off is rounded.
            let from_low = |x: i32| f64::from(x) - f64::from(low[k]);
            let due = from_low(a[k]) * u + from_low(b[k]) * v + from_low(c[k]) * w;
            let extent = from_low(high[k]);
            let error = beyond(from_low(x) - due, 0.5);
            if extent > 0.0 {
                errors[0] = errors[0].max(error / extent);
            }
        }
        let got = warp.pdf(&sample);
        check(got > 0, "no density at a sample")?;
        errors[1] = density_error(got, density, density);
        let again = warp.sample(&warp.invert(&sample));
        check(warp.pdf(&again) > 0, "no density at a sample's inverse")?;
        // Four steps, and twice the error, of the extent.
        let most = |of: [i64; D]| of.into_iter().max().unwrap_or(0) as f64;
        let extent = most(std::array::from_fn(|k| {
            i64::from(high[k]) - i64::from(low[k])
        }));
        let off = std::array::from_fn(|k| i64::from(again[k] as i32) - i64::from(sample[k] as i32));
        check(
            most(off.map(i64::abs)) <= 4.0 + 2.0 * error * extent,
            "an inverse that leads elsewhere",
        )?;
        let any: [u32; D] = std::array::from_fn(|k| words[k % 2].rotate_left(k as u32));
        let _ = warp.pdf(&any);
        check(
            warp.pdf(&warp.sample(&warp.invert(&any))) > 0,
            "no density at an inverse",
        )
    })
}

/// Vertices of words: anywhere, near each other, or on a line but for little.
fn vertices<const D: usize>(p: &[u32]) -> [[i32; D]; 3] {
    let wide = |k: usize| p[2 + k] as i32 >> ((p[1] >> (k % 3 * 5)) & 31);
    let [mut a, mut b, mut c]: [[i32; D]; 3] =
        std::array::from_fn(|v| std::array::from_fn(|k| wide(v * D + k) >> 1));
    if p[1] >> 31 != 0 {
        // Far off the origin.
        for k in 0..D {
            let far = (p[2 + k] ^ p[3 + k]) as i32 >> 1;
            (a[k], b[k], c[k]) = (
                a[k].saturating_add(far),
                b[k].saturating_add(far),
                c[k].saturating_add(far),
            );
        }
    }
    if p[1] >> 30 & 1 != 0 {
        // The third next to the line of the others.
        for k in 0..D {
            let along = ((i64::from(b[k]) - i64::from(a[k])) * i64::from(p[2] >> 4)) >> 28;
            c[k] = (i64::from(a[k]) + along).clamp(i32::MIN.into(), i32::MAX.into()) as i32;
            c[k] = c[k].saturating_add((p[3 + k] % 5) as i32 - 2);
        }
    }
    [a, b, c]
}

pub(super) fn families(all: &mut Vec<Family>) {
    family!(
        all,
        "Triangle",
        &["sample, max", "round trip"],
        0,
        |_p, G| triangle(raw(Triangle::<G>::new()))
    );
    family!(all, "TriangleOn", &["sample, max", "pdf"], 12, |p, G| {
        macro_rules! on {
            ($dimensions:literal) => {{
                let vertices = vertices::<$dimensions>(p);
                let warp = in_format!(p[0], F, {
                    let vertices = vertices_of_bits(&vertices);
                    accepted(TriangleOn::<F, $dimensions, G>::new(vertices))
                });
                on(warp?, one(p[0]), stated::<G>(), vertices)
            }};
        }
        if p[0] & 8 == 0 { on!(2) } else { on!(3) }
    });
}
