//! The laws that hold for every warp: total, inside the domain, never of density 0, the same however
//! it is drawn. Each law of this file runs over the whole catalogue; its modules have what is particular to some.

mod any_parameters;
mod boxes;
mod composed;
mod constructors;
mod density;
mod generators;
mod geometry;
mod lamps;
mod lights;
mod masking;
mod monotone;
mod multivariate_errors;
mod multivariate_normal;
mod open_ends;
mod parameters;
mod power;
mod products;
mod reflection;
mod shapes;
mod surfaces;
mod truncated;
mod uniform_shapes;
mod visible_sphere;

use host::registry::{Domain, Ends, Entry, Point, Uniforms, entries};
use host::speed;

/// Every kind of f32 a caller can hand in as a uniform.
const ANY: [f32; 24] = [
    0.0,
    -0.0,
    1.0e-45,
    -1.0e-45,
    1.0e-40,
    f32::MIN_POSITIVE,
    1.0e-20,
    5.960_464_5e-8,
    1.0e-3,
    0.249_999_99,
    0.25,
    0.5,
    0.500_000_06,
    0.75,
    0.999_999_9,
    0.999_999_94,
    1.0,
    1.000_000_1,
    7.0,
    f32::MAX,
    f32::INFINITY,
    f32::NEG_INFINITY,
    f32::NAN,
    -f32::NAN,
];

fn for_any_uniforms(entry: &Entry, mut law: impl FnMut(Uniforms)) {
    for &a in &ANY {
        if entry.uniforms == 1 {
            law([a, 0.0, 0.0, 0.0]);
            continue;
        }
        for &b in &ANY {
            law([a, b, a, b]);
        }
    }
    // A coarse walk over the grid beside the special values.
    for k in 0..speed::of("points of each warp", 2_048_u32, 32_768) {
        let u = |m: u32| (k.wrapping_mul(m) >> 8) as f32 / 16_777_216.0;
        law([
            u(0x9e37_79b9),
            u(0x85eb_ca6b),
            u(0xc2b2_ae35),
            u(0x27d4_eb2f),
        ]);
    }
}

fn assert_inside(entry: &Entry, x: Point, u: Uniforms) {
    assert!(x.iter().all(|c| c.is_finite()), "{entry} at {u:?}: {x:?}");
    let point = x.map(f64::from);
    assert!((entry.inside)(point), "{entry} at {u:?}: {x:?}");
    if entry.domain == Domain::Line {
        let ends = [0.0, 1.0].map(|u| entry.truth.sample([u; 4])[0]);
        let (low, high) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        // The ends themselves come out of f64 logarithms; a step of f32 outside is 1e6 times this.
        let relative = match entry.ends {
            Ends::Bounds => 1e-13,
            Ends::Samples => 2e-7,
            Ends::None => return,
        };
        let rounding = relative * low.abs().max(high.abs()).min(f64::from(f32::MAX));
        assert!(
            point[0] >= low - rounding && point[0] <= high + rounding,
            "{entry} at {u:?}: {x:?} outside [{low}, {high}]"
        );
        return;
    }
    if matches!(entry.domain, Domain::Directions | Domain::World) {
        let norm = point.iter().map(|c| c * c).sum::<f64>().sqrt();
        assert!(
            (norm - 1.0).abs() <= 2e-7,
            "{entry} at {u:?}: length {norm}"
        );
    }
    let slack = entry.slack;
    let at = entry.truth.invert(point);
    for (i, c) in at[..entry.uniforms].iter().enumerate() {
        let inside = *c >= -slack && *c <= 1.0 + slack;
        // The azimuth of a point on the axis, or the share of two vertices at the third, is whatever it is.
        let lost = i > 0 && (at[0] <= slack || c.is_nan());
        assert!(inside || lost, "{entry} at {u:?}: {x:?} is at {c}");
    }
}

#[test]
fn any_uniform_gives_a_finite_point_of_the_domain() {
    for entry in entries() {
        for_any_uniforms(&entry, |u| assert_inside(&entry, entry.warp.sample(u), u));
    }
}

/// The whole rim of the disk, every second uniform there is at the largest radius.
#[test]
fn no_point_of_the_disk_lies_beyond_its_rim() {
    let last = microwarp::uniform::LARGEST;
    let mut walked = 0;
    for entry in entries() {
        for rim in entry.rims {
            walked += 1;
            let stride = speed::of("one point of the rim tried of every", 61, 1);
            for k in (0..1_u32 << 24).step_by(stride) {
                let u = rim(last, k as f32 / 16_777_216.0);
                let x = entry.warp.sample(u);
                let fine = (entry.inside)(x.map(f64::from)) && entry.warp.pdf(x) > 0.0;
                assert!(fine, "{entry} at {u:?}: {x:?}");
            }
        }
    }
    assert_eq!(walked, 2 * 5);
}

#[test]
fn a_sample_never_has_density_zero() {
    for entry in entries() {
        for_any_uniforms(&entry, |u| {
            let x = entry.warp.sample(u);
            let pdf = entry.warp.pdf(x);
            assert!(
                pdf > 0.0 && pdf <= f32::MAX,
                "{entry} at {u:?}: {x:?} has {pdf}"
            );
        });
    }
}

#[test]
fn inverses_are_uniforms_and_lead_back() {
    for entry in entries() {
        for_any_uniforms(&entry, |u| {
            let x = entry.warp.sample(u);
            let back = entry.warp.invert(x);
            for u in &back[..entry.uniforms] {
                assert!((0.0..1.0).contains(u), "{entry}: {x:?} comes from {back:?}");
            }
            if entry.resolved {
                let again = entry.warp.sample(back);
                assert!(
                    same_place(&entry, x, again),
                    "{entry}: {x:?} leads to {again:?}"
                );
            }
        });
    }
}

/// Whether two points have the same exact uniforms, as far as the rounding of both allows; on the line also whether they are
/// next to each other, which in a narrow law is farther in uniforms.
fn same_place(entry: &Entry, a: Point, b: Point) -> bool {
    if entry.domain == Domain::Line && a[0].to_bits().abs_diff(b[0].to_bits()) <= 1 {
        return true;
    }
    let [a, b] = [a, b].map(|x| entry.truth.invert(x.map(f64::from)));
    let tolerance = if entry.domain == Domain::Line {
        4e-6
    } else {
        2.0 * entry.slack
    };
    (0..entry.uniforms).all(|i| {
        let d = (a[i] - b[i]).abs();
        // The last uniform turns round, and is lost where one before is at an end.
        let lost = a[..i].iter().any(|u| *u <= 1e-5 || *u >= 1.0 - 1e-5);
        let seam = i > 0 && (d >= 1.0 - tolerance || lost);
        d <= tolerance || seam || d.is_nan()
    })
}

/// Coordinates of points that no warp returned.
const FAR: [f32; 12] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    -2.0,
    1.0e-45,
    1.0e30,
    f32::MAX,
    f32::INFINITY,
    f32::NEG_INFINITY,
    f32::NAN,
];

#[test]
fn density_and_inverse_are_total() {
    for entry in entries() {
        for x in FAR {
            for y in FAR {
                for z in FAR {
                    let point = [x, y, z];
                    let pdf = entry.warp.pdf(point);
                    let finite = (0.0..=f32::MAX).contains(&pdf);
                    assert!(
                        finite || entry.closures,
                        "{entry} has density {pdf} at {point:?}"
                    );
                    for u in &entry.warp.invert(point)[..entry.uniforms] {
                        assert!((0.0..1.0).contains(u), "{entry} at {point:?}: {u}");
                    }
                }
            }
        }
    }
}

#[test]
fn the_density_outside_the_domain_is_zero() {
    for entry in entries() {
        let outside = entry.outside;
        let outside = outside.unwrap_or_else(|| panic!("no point outside of {entry} is listed"));
        for &x in outside {
            let pdf = entry.warp.pdf(x);
            assert!(pdf == 0.0, "{entry} has density {pdf} at {x:?}");
        }
        if !entry.closures {
            let pdf = entry.warp.pdf([f32::NAN; 3]);
            assert!(pdf == 0.0, "{entry} has density {pdf} at NaN");
        }
    }
}

/// The exact counterparts hang together: the density is the derivative of the map, and the inverse
/// leads back. This is what makes them fit to judge the crate.
#[test]
fn every_truth_agrees_with_itself() {
    for entry in entries()
        .into_iter()
        .filter(|e| e.tier == "poly" && e.resolved)
    {
        if entry.folds {
            continue;
        }
        for k in 0..200 {
            let u = [
                0.013 + 0.004_86 * f64::from(k),
                0.37 + 0.003 * f64::from(k % 7),
                0.21 + 0.07 * f64::from(k % 9),
                0.0,
            ];
            let x = entry.truth.sample(u);
            let back = entry.truth.invert(x);
            for i in 0..entry.uniforms {
                assert!(
                    (back[i] - u[i]).abs() <= 1e-7,
                    "{entry}: {u:?} comes back as {back:?}"
                );
            }
            let volume = volume_element(&entry, u);
            let density = entry.truth.pdf(x);
            let of_uniforms = entry.truth.density(u) / density;
            assert!(
                (of_uniforms - 1.0).abs() <= 1e-7,
                "{entry} at {u:?}: {of_uniforms} of the density"
            );
            let product = density * volume;
            assert!((product - 1.0).abs() <= 1e-4, "{entry} at {u:?}: {product}");
        }
    }
}

/// Length, area or solid angle per unit of the uniforms, by central differences.
fn volume_element(entry: &Entry, u: [f64; 4]) -> f64 {
    let h = 1e-5;
    let slope = |axis: usize| -> [f64; 3] {
        let (mut up, mut down) = (u, u);
        up[axis] += h;
        down[axis] -= h;
        let (up, down) = (entry.truth.sample(up), entry.truth.sample(down));
        std::array::from_fn(|k| (up[k] - down[k]) / (2.0 * h))
    };
    if entry.uniforms == 1 {
        return slope(0)[0].abs();
    }
    let (p, q) = (slope(0), slope(1));
    if matches!(entry.domain, Domain::Solid | Domain::Rotations) {
        let volume = host::truth::dot(host::truth::cross(p, q), slope(2)).abs();
        // A piece of the half sphere of quaternions is larger than its shadow on w = 0.
        let [x, y, z] = entry.truth.sample(u);
        return match entry.domain {
            Domain::Rotations => volume / (1.0 - (x * x + y * y + z * z)).sqrt(),
            _ => volume,
        };
    }
    if entry.domain == Domain::Barycentric {
        return (p[0] * q[1] - p[1] * q[0]).abs();
    }
    let c = host::truth::cross(p, q);
    host::truth::dot(c, c).sqrt()
}
