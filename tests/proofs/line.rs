//! Bounds on the errors of laws of the line, over all parameters and uniforms: a kernel's largest error, which a sweep finds,
//! and what scaling and moving its number rounds.

use crate::direct;
use crate::kept;
use crate::kernels::{self, By, FEWER, MARGIN, Reach, rounded, rounded_relatively};
use crate::laws::{LAWS, Law};
use crate::maps::Row;
use crate::report::{self, Line, complaint_of_half};
use crate::rounding::UNIT;
use crate::search::spread;
use crate::tables;
use crate::unit::{Unit, middle};
use host::docs;
use host::errors::raise;
use host::figures::{Exact, Figures, density_with_sample_error, draw_error, sample_error};
use host::registry::Registered;
use host::speed;

/// The rows of a law, as its table calls them.
const SAMPLE: &str = "sample";
const WITH_SAMPLE: &str = "pdf with the sample, relative";

/// What is proven of samples, from the kernel's errors of uniforms and of words.
fn proven(law: &Law, of: &[Reach]) -> f64 {
    let bounds = of.iter().map(|reach| rounded(reach, law.form));
    bounds.fold(0.0, f64::max)
}

/// The largest errors of samples and densities that are found: near the worst inputs, with parameters for which they count
/// most, and at the worst cases that earlier searches have kept.
fn found(of: &Registered, inputs: &[u32], densities: &[u32]) -> Figures {
    let mut figures = Figures::default();
    let at = |p: &[f32], u: f32, figures: &mut Figures| {
        if let Ok(entry) = of.of_drawn(p) {
            let u = [u, 0.0, 0.0, 0.0];
            let exact = Exact::of(&entry, u, true);
            sample_error(&entry, &exact, entry.warp.sample(u), figures);
            draw_error(&entry, u[0], figures);
            density_with_sample_error(&entry, &exact, u, figures);
        }
    };
    let located = of.takes.len() == 2;
    let unit = Unit::new(of, if located { &[0.0, 1.0] } else { &[1.0] });
    for bits in inputs {
        let u = f32::from_bits(*bits);
        let size = unit.exact(u.into(), unit.sample(u)).abs();
        // Just below 4, and a location next to it on the same side.
        let [scale, rate] = [4.0 / size, size / 4.0].map(|x| x as f32);
        for step in -8..=8_i32 {
            let near = |x: f32| f32::from_bits(x.to_bits().wrapping_add_signed(step));
            if located {
                for back in 1..5 {
                    let location = f32::from_bits(4.0_f32.to_bits() - back);
                    let sign = unit.sample(u).signum();
                    at(&[sign * location, near(scale)], u, &mut figures);
                }
            } else {
                at(&[near(scale)], u, &mut figures);
                at(&[near(rate)], u, &mut figures);
            }
        }
    }
    for (i, bits) in densities.iter().enumerate() {
        for k in 0..256 {
            let significand = spread(256 * i as u32 + k) >> 9;
            let scale = f32::from_bits(1.0_f32.to_bits() | significand);
            let p = if located {
                vec![0.0, scale]
            } else {
                vec![scale]
            };
            at(&p, f32::from_bits(*bits), &mut figures);
        }
    }
    for (p, [u, ..]) in kept::cases(of) {
        at(&p, u, &mut figures);
    }
    figures
}

/// The rows of a law in a tier.
fn outcome(law: &Law, of: &Registered) -> Vec<(&'static str, Row)> {
    let of_samples = kernels::of_samples(&Unit::new(of, law.sample.unit), law.least(), 0, 1);
    let of_densities = law.density.as_ref().map(|density| {
        let reach = kernels::of_densities(&Unit::new(of, density.unit));
        let proven = rounded_relatively(&reach, density.roundings);
        (reach, proven)
    });
    let densities = of_densities.iter().flat_map(|(reach, _)| &reach.inputs);
    let densities: Vec<_> = densities.copied().collect();
    let found = found(of, &of_samples[0].inputs, &densities);
    let mut rows = vec![(
        SAMPLE,
        Row {
            proven: proven(law, &of_samples),
            found: found.sample,
        },
    )];
    rows.extend(of_densities.map(|(_, proven)| {
        (
            WITH_SAMPLE,
            Row {
                proven,
                found: found.with_sample,
            },
        )
    }));
    rows
}

/// What a law states of a row in both tiers, and how it calls it.
pub fn stated(name: &str, title: &str) -> (String, [f64; 2]) {
    let rows = docs::of_floats(name).into_iter();
    let mut rows = rows.filter(|(t, _)| t.starts_with(title));
    let (title, cells) = rows.next().expect("a row");
    (
        title,
        cells
            .each_ref()
            .map(|cell| cell.number().expect("a number")),
    )
}

#[test]
fn stated_errors_are_proven_on_the_line() {
    let mut lines = direct::lines();
    lines.extend(tables::lines());
    for law in LAWS.iter().filter(|law| speed::wants(law.name)) {
        let tiers = law.of_tiers();
        let outcomes: Vec<_> = tiers.iter().map(|of| outcome(law, of)).collect();
        println!("{}: {outcomes:?}", law.name);
        for (k, (row, _)) in outcomes[0].iter().enumerate() {
            let (title, stated) = stated(law.name, row);
            let rows = outcomes.iter().map(|rows| rows[k].1).collect();
            let stated = stated[2 - tiers.len()..].to_vec();
            lines.push(Line {
                name: law.name,
                title,
                stated,
                rows,
                formula: None,
            });
        }
    }
    report::check_line(&lines);
}

/// A kernel that is off by an ulp, and a rounding that is left out, are noticed.
#[test]
fn a_broken_link_of_the_argument_on_the_line_is_noticed() {
    for law in &LAWS {
        let of = law.registered("poly").expect("a law");
        let (_, [_, stated]) = stated(law.name, SAMPLE);
        let unit = Unit::new(&of, law.sample.unit);
        let [right, wrong] =
            [0, 1].map(|wrong| kernels::of_samples(&unit, law.least(), wrong, *FEWER));
        let found = found(&of, &right[0].inputs, &[]).sample;
        let judged = |proven| complaint_of_half(Row { proven, found }, stated);
        assert_eq!(judged(proven(law, &right)), None, "{}", law.name);
        assert!(judged(proven(law, &wrong)).is_some(), "{}", law.name);
        let left_out = match law.form {
            By::ProductAndSum => right.each_ref().map(|reach| rounded(reach, By::Product)),
            _ => right.each_ref().map(Reach::most),
        };
        let left_out = left_out[0].max(left_out[1]);
        assert!(
            judged(left_out).is_some(),
            "{}: {left_out} found {found}",
            law.name
        );
    }
}

/// The numbers of f64 that kernels are compared with are those of 237 bits, to a tenth of the margin.
#[test]
fn exact_kernels_are_those_of_237_bits() {
    let number = speed::of("uniforms of a kernel beside 237 bits", 64, 1024);
    for law in &LAWS {
        let of = law.registered("poly").expect("a law");
        let mut most = 0.0;
        let mut compare = |one: f64, other: f64, least: f64| {
            raise(
                &mut most,
                (one - other).abs() / other.abs().max(least) / UNIT,
            );
        };
        let pair = |p| [Unit::new(&of, p), Unit::precise(&of, p)];
        let [unit, precise] = pair(law.sample.unit);
        for k in 0..number {
            let word = spread(k);
            let u = f64::from(f32::from_bits(word % 1.0_f32.to_bits()));
            for u in [u, middle(word)] {
                let x = unit.sample(u as f32);
                compare(
                    unit.exact(u, x),
                    precise.exact(u, x),
                    law.least().max(f64::MIN_POSITIVE),
                );
            }
            if let Some(density) = &law.density {
                let [unit, precise] = pair(density.unit);
                compare(
                    unit.exact_density(u),
                    precise.exact_density(u),
                    f64::MIN_POSITIVE,
                );
            }
        }
        assert!(most <= 0.1 * MARGIN, "{}: {most:e} ulp", law.name);
    }
}
