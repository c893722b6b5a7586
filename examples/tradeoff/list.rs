//! The list of samplers: a line each. A new one is a line here, its family the heading it stands under.

use crate::args::Args;
use crate::family::*;
use crate::sampler::{Numbers, Row};
use crate::subject::{Name, law, rejection, warp};
use crate::{
    peer_list::{self, pair},
    tables_list,
};
use fixed::types::{I2F30, I16F16, U2F62, U4F28, U32F32};
use microwarp::fixed::{Coarse, Compact, Fine, Grade, warp as integer};
use microwarp::rejection::{
    BallRejection, DiskRejection, ZigguratStandardExponential, ZigguratStandardNormal,
};
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::warp::*;
use microwarp::{Error, Frame, fixed as fine};
use support::registry::Entry;
use support::truth::{self, Truth};

/// The rows that are asked for, by family; and what warps of the catalogue the list has forgotten.
pub fn rows(args: &Args) -> Result<(Vec<Row>, Vec<String>), Error> {
    let mut entries = support::registry::entries();
    let mut rows = Vec::new();
    floats::<Libm>(&mut rows, &mut entries)?;
    floats::<Poly>(&mut rows, &mut entries)?;
    integers::<Fine>(&mut rows)?;
    integers::<Coarse>(&mut rows)?;
    integers::<Compact>(&mut rows)?;
    others(&mut rows)?;
    tables_list::add(&mut rows)?;
    peer_list::add(&mut rows);
    let missing = missing(&rows, &entries);
    rows.retain(|row| args.wants(row.sampler.family, &row.sampler.label()));
    let mut families: Vec<&str> = PICTURED.to_vec();
    families.extend(rows.iter().map(|row| row.sampler.family));
    rows.sort_by_key(|row| {
        families
            .iter()
            .position(|family| *family == row.sampler.family)
    });
    Ok((rows, missing))
}

/// Warps of the catalogue of which no parameter set is listed in a tier.
fn missing(rows: &[Row], left: &[Entry]) -> Vec<String> {
    let mut missing: Vec<String> = left
        .iter()
        .filter(|entry| {
            let listed = |row: &Row| {
                let known = row.sampler.entry.as_ref();
                known.is_some_and(|e| e.name == entry.name && e.tier == entry.tier)
            };
            !rows.iter().any(listed)
        })
        .map(|entry| {
            format!(
                "{} {}: not in examples/tradeoff/list.rs",
                entry.name, entry.tier
            )
        })
        .collect();
    missing.dedup();
    missing
}

/// Takes an entry out of the catalogue.
fn take(entries: &mut Vec<Entry>, name: &str, parameters: &str, tier: &str) -> Entry {
    let same = |e: &Entry| e.name == name && e.parameters == parameters && e.tier == tier;
    let place = entries.iter().position(same);
    entries.swap_remove(place.unwrap_or_else(|| panic!("no {name} {parameters} in the catalogue")))
}

#[rustfmt::skip] // one line a sampler
fn floats<T: Tier>(rows: &mut Vec<Row>, entries: &mut Vec<Entry>) -> Result<(), Error> {
    // Family; name and parameters in the catalogue; name in costs.csv; the warp.
    macro_rules! list {
        ($($family:ident, $name:literal, $parameters:literal, $kernel:literal => $warp:expr;)*) => {$({
            let entry = take(entries, $name, $parameters, T::NAME);
            let space = if $parameters.is_empty() { "" } else { " " };
            let name = format!("{}{space}{}", $name, $parameters);
            let name = Name::new($family, &name, T::NAME, format!("{}_{}", T::NAME, $kernel));
            rows.push(warp(name, $warp, entry.truth.clone()).of(entry));
        })*};
    }
    let frame = Frame::new([1.0, 2.0, 3.0])?;
    let plane = [[0.0, 0.0], [4.0, 0.0], [1.0, 3.0]];
    let sine = |x: f32| T::sincos_turns(x * (1.0 / core::f32::consts::TAU)).0;
    let cosine = |x: f32| T::sincos_turns(x * (1.0 / core::f32::consts::TAU)).1;
    let arcsine = |y: f32| T::atan2_turns(y, T::sqrt((1.0 - y) * (1.0 + y))) * core::f32::consts::TAU;
    let unit = Interval::new(0.0, 1.0)?;
    let below = move |x: f32| Interval::new(0.0, x).unwrap_or(unit);
    list! {
        DISK, "Disk", "", "disk" => Disk::<T>::new();
        DISK, "DiskConcentric", "", "disk_concentric" => DiskConcentric::<T>::new();
        SPHERE, "Sphere", "", "sphere" => Sphere::<T>::new();
        HEMISPHERE, "Hemisphere", "", "hemisphere" => Hemisphere::<T>::new();
        COSINE, "CosineHemisphere", "", "cosine_hemisphere" => CosineHemisphere::<T>::new();
        COSINE, "MalleyHemisphere", "", "malley_hemisphere" => MalleyHemisphere::<T>::new();
        LOBE, "PhongLobe", "n=50", "phong_lobe_50" => PhongLobe::<T>::new(50.0)?;
        EXPONENTIAL, "Exponential", "a=1", "exponential_1" => Exponential::<T>::new(1.0)?;
        EXPONENTIAL, "ExponentialTail", "a=1", "exponential_tail_1" => ExponentialTail::<T>::new(1.0)?;
        NORMAL, "NormalPair", "0, 1", "normal_pair" => NormalPair::<T>::new([0.0; 2], 1.0)?;
        INTERVAL, "Interval", "[-3, 5]", "interval" => Interval::new(-3.0, 5.0)?;
        INTERVAL, "Interval decreasing", "[-3, 5]", "interval_decreasing" => Interval::decreasing(-3.0, 5.0)?;
        POWER, "Power", "n=2.5 [0, 1]", "power" => Power::<T>::new(2.5, 0.0, 1.0)?;
        POWER, "Power decreasing", "n=2.5 [0, 1]", "power_decreasing" => Power::<T>::decreasing(2.5, 0.0, 1.0)?;
        POWER, "PowerMax", "N=4", "power_max_4" => PowerMax::<4>::new();
        TRUNCATED, "TruncatedExponential", "c=2 X=3", "truncated_exponential_2_3" => TruncatedExponential::<T>::new(2.0, 3.0)?;
        LINE, "Tent", "r=1", "tent_2" => Tent::new(1.0)?;
        LINE, "Linear", "1 to 3", "linear_1_3" => Linear::new(1.0, 3.0)?;
        LINE, "Inversion", "p=1/2+x", "inversion" => Inversion::new(
            |u: f32| 4.0 * u / (1.0 + T::sqrt(1.0 + 8.0 * u)), |x: f32| 0.5 + x, |x: f32| 0.5 * x * (1.0 + x));
        LINE, "Transform", "y=sin x", "transform" => Transform::new(Linear::new(0.0, 1.0)?, sine, arcsine, cosine);
        LINE, "PiecewiseConstant1d", "2:0:4:1 on [0, 8]", "piecewise_1d" =>
            microwarp::discrete::PiecewiseConstant1d::<[u32; 4]>::from_weights(&[146.0, 0.0, 292.0, 73.0], 0.0, 8.0)?;
        TRIANGLE, "Triangle", "", "triangle" => Triangle::new();
        TRIANGLE, "TriangleOn", "plane", "triangle_on" => TriangleOn::new(plane)?;
        CAP, "Cone", "0.1 rad", "cone" => Cone::<T>::from_angle(0.1)?;
        CAP, "SphericalPatch", "octant", "spherical_patch" => SphericalPatch::<T>::new(0.0, 0.25, 0.0, 0.25)?;
        COMPOSED, "Oriented", "cosine about (1, 2, 3)", "oriented" => Oriented::new(CosineHemisphere::<T>::new(), frame);
        COMPOSED, "MarginalConditional", "0<y<x<1", "marginal_conditional" =>
            MarginalConditional::new(Linear::new(0.0, 1.0)?, below);
        COMPOSED, "Aabb", "[-1, 1] x [2, 2.5]", "aabb" => Aabb::new([-1.0, 2.0], [1.0, 2.5])?;
        COMPOSED, "PiecewiseConstant2d", "32 x 16 sky", "piecewise_2d" => tables_list::sky()?;
    }
    let entry = take(entries, "Normal", "0, 1", T::NAME);
    let name = Name::new(NORMAL, "Normal 0, 1", T::NAME, format!("{}_normal", T::NAME));
    rows.push(warp(name, Normal::<T>::new(0.0, 1.0)?, entry.truth.clone()).of(entry).twice());
    Ok(())
}

#[rustfmt::skip] // one line a sampler
fn integers<G: Grade>(rows: &mut Vec<Row>) -> Result<(), Error> {
    // Family, name, name in costs.csv, the warp, and what is exact.
    macro_rules! list {
        ($($family:ident, $name:literal, $kernel:literal => $warp:expr, $truth:expr;)*) => {$({
            let truth: Box<dyn Truth> = $truth;
            let name = Name::new($family, $name, G::NAME, format!("{}_{}", G::NAME, $kernel));
            rows.push(warp(name, $warp, truth.into()));
        })*};
    }
    let lobe = integer::PhongLobe::<G>::new(U32F32::from_num(50))?;
    let cone = integer::Cone::<G>::from_one_minus_cos(U2F62::from_num(0.25))?;
    let flat = [[-90, 10], [300, -200], [40, 250]];
    let on = integer::TriangleOn::<_, 2, G>::new(flat.map(|v| v.map(I16F16::from_num)))?;
    let truncated = integer::TruncatedExponential::<_, G>::new(U4F28::from_num(0.5), U4F28::from_num(3))?;
    list! {
        DISK, "Disk", "disk" => integer::Disk::<G>::new(), Box::new(truth::Disk);
        SPHERE, "Sphere", "sphere" => integer::Sphere::<G>::new(), truth::sphere();
        HEMISPHERE, "Hemisphere", "hemisphere" => integer::Hemisphere::<G>::new(), truth::hemisphere();
        COSINE, "CosineHemisphere", "cosine_hemisphere" => integer::CosineHemisphere::<G>::new(), truth::cosine_hemisphere();
        LOBE, "PhongLobe n=50", "phong_lobe_50" => lobe, truth::phong(50.0);
        EXPONENTIAL, "StandardExponential", "standard_exponential" => integer::StandardExponential::<G>::new(), truth::exponential(1.0);
        NORMAL, "StandardNormalPair", "standard_normal_pair" => integer::StandardNormalPair::<G>::new(), pair();
        TRUNCATED, "TruncatedExponential c=2 X=3", "truncated_exponential_10_20" => truncated, truth::truncated_exponential(2.0, 3.0);
        LINE, "Tent r=1", "tent_2" => integer::Tent::<_, G>::new(I2F30::ONE)?, truth::tent(1.0);
        TRIANGLE, "Triangle", "triangle" => integer::Triangle::<G>::new(), Box::new(truth::Barycentric);
        TRIANGLE, "TriangleOn", "triangle_on" => on,
            Box::new(truth::OnTriangle(flat.map(|[x, y]| [x, y, 0]).map(|v| v.map(f64::from))));
        CAP, "Cone 1-cos=0.25", "cone" => cone, truth::cone(0.25, 1.75);
    }
    // For users of f32, out of integers.
    macro_rules! floats {
        ($($family:ident, $name:literal, $kernel:literal => $warp:expr, $truth:expr;)*) => {$({
            let truth: Box<dyn Truth> = $truth;
            let tier = match G::NAME { "fine" => "fine, f32", "coarse" => "coarse, f32", _ => "compact, f32" };
            let name = Name::new($family, $name, tier, format!("{}_float_{}", G::NAME, $kernel));
            rows.push(warp(name, fine::Float::new($warp), truth.into()));
        })*};
    }
    floats! {
        DISK, "Disk", "disk" => integer::Disk::<G>::new(), Box::new(truth::Disk);
        SPHERE, "Sphere", "sphere" => integer::Sphere::<G>::new(), truth::sphere();
        COSINE, "CosineHemisphere", "cosine_hemisphere" => integer::CosineHemisphere::<G>::new(), truth::cosine_hemisphere();
        LOBE, "PhongLobe n=50", "phong_lobe_50" => lobe, truth::phong(50.0);
        EXPONENTIAL, "StandardExponential", "standard_exponential" => integer::StandardExponential::<G>::new(), truth::exponential(1.0);
        NORMAL, "StandardNormalPair", "standard_normal_pair" => integer::StandardNormalPair::<G>::new(), pair();
    }
    Ok(())
}

/// What has no tier.
#[rustfmt::skip] // one line a sampler
fn others(rows: &mut Vec<Row>) -> Result<(), Error> {
    let disk = || law(Box::new(truth::Disk), 2);
    let ball = || law(Box::new(peer_list::Ball), 3);
    rows.extend([
        rejection(Name::new(DISK, "DiskRejection", "rejection", "rejection_disk"), DiskRejection::new(), DiskRejection::pdf, disk(), Numbers::Floats),
        rejection(Name::new(DISK, "fixed::DiskRejection", "fixed rejection", "fixed_rejection_disk"),
            fine::DiskRejection::new(), fine::DiskRejection::pdf, disk(), Numbers::Steps(0.5_f64.powi(29))),
        rejection(Name::new(DISK, "fixed::DiskRejection16", "16-bit rejection", "fixed_rejection_disk_16"),
            fine::DiskRejection16::new(), fine::DiskRejection16::pdf, disk(), Numbers::Steps(0.5_f64.powi(15))),
        rejection(Name::new(EXPONENTIAL, "ZigguratStandardExponential", "ziggurat", "rejection_ziggurat_standard_exponential"),
            ZigguratStandardExponential::new(), ZigguratStandardExponential::pdf, law(truth::exponential(1.0), 1), Numbers::Floats),
        rejection(Name::new(NORMAL, "ZigguratStandardNormal", "ziggurat", "rejection_ziggurat_standard_normal"),
            ZigguratStandardNormal::new(), ZigguratStandardNormal::pdf, law(truth::normal(0.0, 1.0), 1), Numbers::Floats).twice(),
        rejection(Name::new(BALL, "BallRejection", "rejection", "rejection_ball"), BallRejection::new(), BallRejection::pdf, ball(), Numbers::Floats),
    ]);
    let interval = fine::Interval::<I16F16>::new(I16F16::from_num(-3), I16F16::from_num(5))?;
    let name = Name::new(INTERVAL, "Interval [-3, 5] in steps of 2^-16", "fixed", "interval_1_6");
    rows.push(warp(name, interval, truth::interval(-3.0, 5.0, true).into()));
    Ok(())
}
