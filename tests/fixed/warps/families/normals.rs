//! Correlated normals of one to four dimensions.

use super::family::{
    Family, STEP, Subject, beyond, check, density_error, family, in_format, one, uniform,
};
use crate::raw::Raw;
use crate::warps::multivariate_normal::{Exact, law, of_partials, partial};

/// The distance of a point from its means in the furthest coordinate that a law allows.
fn reach(d: usize, deviation: u32) -> i64 {
    let pairs = d.div_ceil(2) as f64;
    (6.671 * pairs.sqrt() * f64::from(deviation)) as i64 + 2
}

fn normals(warp: Box<dyn Raw>, one: f64, of: Exact) -> Option<Subject> {
    let d = of.dimensions();
    let [k, n] = of.smallest();
    let peak = of.peak(one);
    let free = |i: usize, of: &Exact| of.order.contains(&i);
    let variables = vec![("d", d as f64), ("n", n), ("k", k)];
    Subject::of_four(variables, move |words, errors| {
        let words = &words[..d.next_multiple_of(2)];
        let sample = warp.sample(words);
        let point: Vec<i32> = sample[..d].iter().map(|x| *x as i32).collect();
        let z = of.normals(words);
        for (i, off) in of.offset(&z).into_iter().enumerate() {
            let error = beyond(f64::from(point[i]) - f64::from(of.means[i]) - off, 0.5);
            let deviation = f64::from(of.deviations[i]);
            check(deviation > 0.0 || error == 0.0, "off what does not vary")?;
            if deviation > 0.0 {
                errors[0] = errors[0].max(error / deviation);
            }
        }
        check(warp.pdf(&sample) > 0, "no density at a sample")?;
        errors[1] = density_error(warp.pdf(&sample), of.pdf(&point, one), peak);
        let any: Vec<i32> = (0..d)
            .map(|i| {
                let word = words[i % words.len()].rotate_left(7 * i as u32) as i32;
                let off = (i64::from(word) * i64::from(of.deviations[i])) >> 29;
                (i64::from(of.means[i]) + off).clamp(i32::MIN.into(), i32::MAX.into()) as i32
            })
            .collect();
        let bits: Vec<u32> = any.iter().map(|x| *x as u32).collect();
        let (got, _) = (warp.pdf(&bits), warp.invert(&bits));
        if of.order.len() == d {
            errors[1] = errors[1].max(density_error(got, of.pdf(&any, one), peak));
        }
        let back = warp.invert(&sample);
        for (pair, words) in words.chunks(2).enumerate() {
            // Both normals of two are to be found.
            if [2 * pair, 2 * pair + 1].iter().all(|i| free(*i, &of)) {
                let first = uniform(back[2 * pair]) - uniform(words[0]);
                let radius = (-2.0 * (-uniform(words[0])).ln_1p()).sqrt().min(1.0);
                let turns =
                    f64::from(back[2 * pair + 1].wrapping_sub(words[1]) as i32) * STEP / 4.0;
                let second = turns * std::f64::consts::TAU * radius;
                errors[2] = errors[2].max(first.abs()).max(second.abs());
            }
        }
        Ok(())
    })
}

pub(super) fn families(all: &mut Vec<Family>) {
    const ROWS: &[&str] = &["sample, max", "pdf", "round trip"];
    family!(all, "MultivariateNormal", ROWS, 16, words 4, |p, G| {
        let d = 1 + (p[0] >> 3 & 3) as usize;
        // Of all magnitudes, and now and then 0.
        let deviation = |i: usize| match p[1] >> (4 * i) & 15 {
            0 => 0,
            kind => (p[2 + i] >> 6 >> (if kind < 8 { 0 } else { p[2 + i] & 31 })) as i32,
        };
        let deviations: Vec<i32> = (0..d).map(deviation).collect();
        let mean = |i: usize| {
            let room = (i64::from(i32::MAX) - reach(d, deviations[i] as u32)).max(0);
            ((i64::from(p[6 + i] as i32) * room) >> 31) as i32
        };
        let means: Vec<i32> = (0..d).map(mean).collect();
        let mut next = 0;
        let matrix = of_partials(d, || {
            next += 1;
            partial(p[0] >> (5 + 3 * next), p[9 + next])
        });
        let of = Exact::new(&means, &deviations, &matrix)?;
        let warp = in_format!(p[0], F, law::<F, G>(&means, &deviations, &matrix).ok());
        normals(warp?, one(p[0]), of)
    });
}
