//! Triangles.

use super::family::{Family, Subject, beyond, check, density_error, family, in_format, uniform};
use fixed::FixedI32;
use fixed::types::U0F32;
use fixed::types::extra::LeEqU32;
use microwarp::fixed::Grade;
use microwarp::fixed::warp::{Triangle, TriangleOn};
use microwarp::{Invert, Warp};

/// Barycentric coordinates.
fn weights([u, v]: [u32; 2]) -> [f64; 3] {
    let (u, v) = (uniform(u), uniform(v));
    let s = u.sqrt();
    [(1.0 - u) / (1.0 + s), s * v, s * (1.0 - v)]
}

fn triangle<G: Grade>() -> Option<Subject> {
    let warp = Triangle::<G>::new();
    Subject::new(vec![], move |words, errors| {
        let sample = warp.sample(words.map(U0F32::from_bits));
        check(
            sample.iter().all(|c| *c >= 0) && sample[0] + sample[1] + sample[2] == 1,
            "outside",
        )?;
        check(warp.pdf(sample) == 2, "no density at a sample")?;
        let due = weights(words);
        errors[0] = [0, 1, 2]
            .map(|i| (sample[i].to_num::<f64>() - due[i]).abs())
            .into_iter()
            .fold(0.0, f64::max);
        let back = warp.invert(sample);
        let [u, v] = [0, 1].map(|i| back[i].to_num::<f64>() - uniform(words[i]));
        errors[1] = u.abs().max((v * uniform(words[0]).sqrt()).abs());
        Ok(())
    })
}

/// 1/area by exact minors, in steps.
fn density<const D: usize>([a, b, c]: [[i32; D]; 3]) -> f64 {
    let side = |v: [i32; D], k: usize| i128::from(v[k]) - i128::from(a[k]);
    let mut squares = 0.0;
    for i in 0..D {
        for j in 0..i {
            let minor = side(b, i) * side(c, j) - side(b, j) * side(c, i);
            squares += (minor as f64).powi(2);
        }
    }
    2.0 / squares.sqrt()
}

fn on<Frac: LeEqU32 + 'static, G: Grade, const D: usize>(
    vertices: [[i32; D]; 3],
) -> Option<Subject> {
    let bits = FixedI32::<Frac>::from_bits;
    let warp = TriangleOn::<Frac, D, G>::new(vertices.map(|v| v.map(bits))).ok()?;
    let density = density(vertices) * 4_f64.powi(Frac::U32 as i32);
    let [a, b, c] = vertices;
    let low: [i32; D] = std::array::from_fn(|k| a[k].min(b[k]).min(c[k]));
    let high: [i32; D] = std::array::from_fn(|k| a[k].max(b[k]).max(c[k]));
    Subject::new(vec![], move |words, errors| {
        let sample = warp.sample(words.map(U0F32::from_bits));
        let [u, v, w] = weights(words);
        for k in 0..D {
            let x = sample[k].to_bits();
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
        let got = warp.pdf(sample);
        check(got > 0, "no density at a sample")?;
        errors[1] = density_error(got, density, density);
        let again = warp.sample(warp.invert(sample));
        check(warp.pdf(again) > 0, "no density at a sample's inverse")?;
        // Four steps, and twice what the page states of a sample, of the extent.
        let error = match G::NAME {
            "fine" => 2.0e-7,
            "coarse" => 1.9e-5,
            _ => 6.2e-8,
        };
        let most = |of: [i64; D]| of.into_iter().max().unwrap_or(0) as f64;
        let extent = most(std::array::from_fn(|k| {
            i64::from(high[k]) - i64::from(low[k])
        }));
        let off =
            std::array::from_fn(|k| i64::from(again[k].to_bits()) - i64::from(sample[k].to_bits()));
        check(
            most(off.map(i64::abs)) <= 4.0 + 2.0 * error * extent,
            "an inverse that leads elsewhere",
        )?;
        let any = std::array::from_fn(|k| bits((words[k % 2].rotate_left(k as u32)) as i32));
        let _ = warp.pdf(any);
        check(
            warp.pdf(warp.sample(warp.invert(any))) > 0,
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

fn flat<Frac: LeEqU32 + 'static, G: Grade>(p: &[u32]) -> Option<Subject> {
    on::<Frac, G, 2>(vertices(p))
}

fn solid<Frac: LeEqU32 + 'static, G: Grade>(p: &[u32]) -> Option<Subject> {
    on::<Frac, G, 3>(vertices(p))
}

pub(super) fn families(all: &mut Vec<Family>) {
    family!(
        all,
        "Triangle",
        &["sample, max", "round trip"],
        0,
        |_p, G| triangle::<G>()
    );
    family!(all, "TriangleOn", &["sample, max", "pdf"], 12, |p, G| {
        if p[0] & 8 == 0 {
            in_format!(p[0], flat, G, p)
        } else {
            in_format!(p[0], solid, G, p)
        }
    });
}
