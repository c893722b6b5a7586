//! The samplers that are compared: the warps of the float tiers from the registry, and those that are listed here, a line each.

use crate::args::Args;
use crate::sampler::{Numbers, Row};
use crate::subject::{Name, law, registered, rejection, warp};
use crate::{
    peer_list::{self, pair},
    tables_list,
};
use fixed::types::{I2F30, I16F16, U2F62, U4F28, U32F32};
use host::registry::family::*;
use host::registry::{Entry, entries_of_each_tier};
use host::truth::{self, Truth};
use microwarp::fixed::{Coarse, Compact, Fine, Grade, warp as integer};
use microwarp::rejection::{
    BallRejection, DiskRejection, ZigguratStandardExponential, ZigguratStandardNormal,
};
use microwarp::{Error, fixed as fine};

/// The rows that are asked for, by family; and which warps have no place in the comparison.
pub fn rows(args: &Args) -> Result<(Vec<Row>, Vec<String>), Error> {
    let (floats, left): (Vec<_>, Vec<_>) = entries_of_each_tier()
        .into_iter()
        .partition(|e| e.trade.is_some());
    let missing = missing(&floats, &left);
    let mut rows: Vec<Row> = floats.into_iter().map(registered).collect();
    integers::<Fine>(&mut rows)?;
    integers::<Coarse>(&mut rows)?;
    integers::<Compact>(&mut rows)?;
    others(&mut rows)?;
    tables_list::add(&mut rows)?;
    peer_list::add(&mut rows);
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

/// Warps none of whose parameter sets has a place in a tier.
fn missing(listed: &[Entry], left: &[Entry]) -> Vec<String> {
    let has = |entry: &&Entry| {
        let same = |e: &Entry| e.name == entry.name && e.tier == entry.tier;
        !listed.iter().any(same)
    };
    let complaint =
        |entry: &Entry| format!("{} {}: no place in comparisons", entry.name, entry.tier);
    let mut missing: Vec<String> = left.iter().filter(has).map(complaint).collect();
    missing.dedup();
    missing
}

#[rustfmt::skip] // one line a sampler
fn integers<G: Grade>(rows: &mut Vec<Row>) -> Result<(), Error> {
    // Family, name, name in counts.csv, the warp, and what is exact.
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
    let truncated = integer::TruncatedExponential::<_, G>::from_mean(U4F28::from_num(0.5), U4F28::from_num(3))?;
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
