//! Each warp keeps the error bounds that its documentation states, whatever its parameters.
//!
//! The bounds are read out of the documentation itself: the table in each warp's doc comment holds numbers and
//! formulas. Two ways attack them. Listed parameter sets are swept, exhaustively where a sample takes one uniform;
//! what they show stands in `docs/accuracy.md`, set by set. An adversary searches all parameters that a constructor
//! accepts, and fails for a bound that is exceeded and for one that is too large. In the quick speed the page's figures
//! are upper bounds, and the adversary knows the worst cases by those that earlier searches have found.
//! `MICROWARP_WRITE=1 cargo test --test accuracy` writes the page and the worst cases anew.

mod families;
mod hard;
mod inputs;
mod kinds;
mod oracle;
mod page;

use host::adversary::search::{Budget, USUAL};
use host::figures::{
    Exact, Figures, density_and_inverse_error, density_with_sample_error, draw_error, place_error,
    polar_error, sample_error,
};
use host::parallel::{in_parallel, threads};
use host::registry::{Entry, Uniforms, entries, entries_of_each_tier};
use host::speed;
use page::Measured;

const GRID: u32 = 1 << 24;
const STEP: f32 = 1.0 / 16_777_216.0;

/// Uniforms at which maps break: the ends, the middle, and values off the grid.
const EDGES: [f32; 16] = [
    0.0,
    1.0e-45,
    1.0e-40,
    f32::MIN_POSITIVE,
    1.0e-20,
    STEP,
    2.0 * STEP,
    1.0e-3,
    0.25,
    0.5 - STEP,
    0.5,
    0.5 + STEP,
    0.75,
    1.0 - 2.0 * STEP,
    1.0 - STEP,
    0.333_333_34,
];

/// One warp with one parameter set: in `libm` and `poly`, or alone where it has no tier.
type Tiers = Vec<Entry>;

fn in_each_tier() -> Vec<Tiers> {
    let (libm, poly): (Vec<_>, Vec<_>) = entries_of_each_tier()
        .into_iter()
        .partition(|e| e.tier == "libm");
    assert_eq!(libm.len(), poly.len());
    libm.into_iter()
        .zip(poly)
        .map(|(libm, poly)| {
            assert_eq!((libm.name, libm.parameters), (poly.name, poly.parameters));
            if poly.tiered {
                vec![libm, poly]
            } else {
                vec![poly]
            }
        })
        .collect()
}

/// Four uniforms of the grid for a counter: a hash of it, so that no two of them are in step.
fn spread(k: u32) -> Uniforms {
    [0x9e37_79b9_u32, 0x85eb_ca6b, 0xc2b2_ae35, 0x27d4_eb2f].map(|m| {
        let mixed = (k.wrapping_add(1)).wrapping_mul(m);
        let mixed = (mixed ^ (mixed >> 15)).wrapping_mul(m | 1);
        ((mixed ^ (mixed >> 13)) >> 8) as f32 * STEP
    })
}

/// Measures one warp in each tier that it has, in the full speed over one of five grid inputs where the input is one number, over
/// 2^19 points of the grid where it is several, always with all edges. Draws, densities and inverses, which cost most to judge,
/// are measured at every 7th or 8th of them. Further parameter sets of the same warp get fewer. Strides are odd, and so visit
/// every residue of a power of two. The quick speed takes longer strides everywhere, multiples of these. All inputs of one number
/// are tried by `inputs`, with `MICROWARP_FULL=all`.
fn measure(tiers: &[Entry], thorough: bool) -> Vec<Figures> {
    let [first, ..] = tiers else {
        panic!("no entry");
    };
    let stride = match thorough {
        true => speed::of("one grid input tried of every", 255, 5),
        false => speed::of("one grid input tried of every, further sets", 8125, 325),
    };
    let fewer = speed::of("one pair of uniforms tried of every", 20, 1);
    let points = if thorough { GRID / 32 } else { GRID / 128 } / fewer;
    let mut figures = vec![Figures::default(); tiers.len()];
    let mut at = |u: Uniforms, deep: bool, polar: bool| {
        let exact = Exact::of(first, u, deep);
        for (entry, figures) in tiers.iter().zip(&mut figures) {
            let x = entry.warp.sample(u);
            if polar {
                polar_error(entry, &exact, x, figures);
            }
            sample_error(entry, &exact, x, figures);
            if deep {
                draw_error(entry, u[0], figures);
                density_and_inverse_error(entry, &exact, x, figures);
                density_with_sample_error(entry, &exact, u, figures);
                place_error(entry, u, figures);
            }
        }
    };
    match first.uniforms {
        1 => {
            for k in (0..GRID).step_by(stride) {
                at([k as f32 * STEP, 0.0, 0.0, 0.0], k % 7 == 0, false);
            }
            for u in EDGES {
                // Generators yield nothing between 0 and 2^-64; samples hold there all the same.
                at([u, 0.0, 0.0, 0.0], u == 0.0 || u >= 5.0e-20, false);
            }
        }
        2 => {
            if first.polar {
                for k in (0..GRID).step_by(stride) {
                    at([k as f32 * STEP, 0.0, 0.0, 0.0], false, true);
                }
            }
            // Pairs of the grid spread over the square by multiplication.
            for k in 0..points {
                let [u1, u2, ..] = spread(k);
                at([u1, u2, 0.0, 0.0], k % 8 == 0, false);
            }
            let axis: Vec<f32> = (0..48)
                .map(|i| ((i * 349_525 + 11) % GRID) as f32 * STEP)
                .chain(EDGES)
                .collect();
            for &u1 in &axis {
                for &u2 in &axis {
                    at([u1, u2, 0.0, 0.0], true, false);
                }
            }
        }
        n => {
            for k in 0..points {
                let u = spread(k);
                let u = std::array::from_fn(|i| if i < n { u[i] } else { 0.0 });
                at(u, true, false);
            }
            for u in EDGES {
                at([u; 4], true, false);
            }
        }
    }
    figures
}

#[test]
fn every_warp_keeps_its_stated_error() {
    let all = in_each_tier();
    let warp = |tiers: &Tiers| tiers[0].name.split(' ').next();
    let jobs: Vec<usize> = (0..all.len()).collect();
    let measured = in_parallel(threads(), &jobs, |&i| {
        let tiers = &all[i];
        let first = !all[..i].iter().any(|before| warp(before) == warp(tiers));
        measure(tiers, first && !tiers[0].composed)
    });
    let rows: Vec<_> = all
        .iter()
        .zip(measured)
        .map(|(tiers, figures)| Measured {
            name: tiers[0].name,
            parameters: tiers[0].parameters,
            measure: tiers[0].measure,
            figures,
        })
        .collect();
    if std::env::var_os("MICROWARP_WRITE").is_some() {
        page::write(&rows);
    }
    page::check(&rows);
}

/// No parameters that a constructor accepts, and no uniforms, exceed what is stated.
#[test]
fn the_statements_hold_for_every_parameter() {
    let mut families = families::families();
    families.retain(|family| speed::wants(&family.label));
    host::adversary::hold(&families, "accuracy/worst.csv");
}

/// What was found is stated with its margin over the cases that searches have left; what is proven needs none.
#[test]
fn kept_cases_leave_bounds_their_margin() {
    host::adversary::hold_margins(&families::families(), "accuracy/worst.csv");
}

/// The old branch of the power law, whose exponential overflows alone, is found within the usual budget.
#[test]
fn a_branch_that_overflows_alone_is_found() {
    let flawed = families::flawed();
    let found = host::adversary::attack(&flawed, Budget::Points(USUAL));
    for (family, worst) in flawed.iter().zip(found) {
        // A wrong branch, not a digit too few: the sample is the wrong end of the interval.
        let sample = &worst[0];
        assert!(sample.ratio > 1e3, "{}", sample.describe(family));
    }
}

/// A bound a fifth below the worst error known is exceeded within the usual budget, by a search that knows no case.
#[test]
fn a_bound_that_is_short_by_a_fifth_is_exceeded() {
    const SHORT: [(&str, &str); 4] = [
        ("Weibull libm", "inverse"),
        ("Power new libm", "realised density, relative"),
        ("GgxVisible poly", "unit length"),
        ("Gumbel libm", "sample, ulp of location or distance"),
    ];
    let mut families = families::families();
    families.retain(|family| SHORT.iter().any(|(label, _)| *label == family.label));
    assert_eq!(families.len(), SHORT.len());
    let known = host::adversary::kept::read("accuracy/worst.csv", &families);
    let found = host::adversary::attack(&families, Budget::Points(USUAL));
    for ((family, found), known) in families.iter().zip(found).zip(known) {
        let (_, title) = SHORT
            .iter()
            .find(|(label, _)| *label == family.label)
            .unwrap();
        let row = family.rows.iter().position(|row| row == title).unwrap();
        let short = 0.8 * known[row].ratio;
        let worst = found[row].describe(family);
        println!("{}; {title}: {worst}, short: {short:.3}", family.label);
        assert!(found[row].ratio > short && short > 0.4, "{worst}");
    }
}

/// The measurement itself notices an error of the size it is there to find.
#[test]
fn a_wrong_warp_is_noticed() {
    let poly: Vec<_> = entries().into_iter().filter(|e| e.tier == "poly").collect();
    let find = |name: &str| poly.iter().find(|e| e.name == name).unwrap();
    let (disk, exponential) = (find("Disk"), find("Exponential"));
    let u = [0.3, 0.7, 0.0, 0.0];
    let exact = Exact::of(disk, u, true);
    let mut figures = Figures::default();
    sample_error(
        disk,
        &exact,
        [0.3 * -0.309_017, 0.3 * -0.951_056_5, 0.0],
        &mut figures,
    );
    assert!(
        figures.sample > 0.2,
        "the disk with r = u passes: {figures:?}"
    );
    let rotation = find("Rotation");
    let mut exact = Exact::of(rotation, u, true);
    exact.fourth = exact.fourth.map(|w| w + 1e-6);
    let mut figures = Figures::default();
    sample_error(rotation, &exact, rotation.warp.sample(u), &mut figures);
    assert!(figures.sample > 0.8e-6, "w off by 1e-6 passes: {figures:?}");
    let exact = Exact::of(exponential, u, true);
    let x = exponential.warp.sample(u);
    let off = f32::from_bits(x[0].to_bits() + 4);
    let mut figures = Figures::default();
    sample_error(exponential, &exact, [off, 0.0, 0.0], &mut figures);
    assert!(figures.sample > 3.0, "four steps off pass: {figures:?}");
    let mut figures = Figures::default();
    sample_error(exponential, &exact, [f32::NAN, 0.0, 0.0], &mut figures);
    assert!(figures.sample == f64::INFINITY, "NaN passes: {figures:?}");
}
