//! The table of rejection in docs/worst_case.md: what a try takes, how many there can be, and how likely that is.

use crate::cycles::{CORES, whole};
use crate::tables::rows;
use microwarp::rejection::{
    BallRejection, BinomialRejection, DiskRejection, HypergeometricRejection, PoissonRejection,
    Rejection, VonMises, ZigguratStandardExponential, ZigguratStandardNormal,
};
use microwarp::tier::Poly;
use microwarp_host::counts::Counts;
use microwarp_host::upkeep::Outcome;
use rand_pcg::Pcg32;

/// Rejection: its kernel, its efficiency, its budget, and whether every try costs the same.
fn rejections() -> Outcome<[(&'static str, f64, u32, bool); 11]> {
    use microwarp::fixed as integer;
    let share = |bits: u32| f64::from(bits) / 4_294_967_296.0;
    Ok([
        (
            "rejection_disk_pcg32",
            DiskRejection::EFFICIENCY.into(),
            DiskRejection::BUDGET,
            true,
        ),
        (
            "rejection_ball_pcg32",
            BallRejection::EFFICIENCY.into(),
            BallRejection::BUDGET,
            true,
        ),
        (
            "fixed_rejection_disk_pcg32",
            share(integer::DiskRejection::EFFICIENCY.to_bits()),
            integer::DiskRejection::BUDGET,
            true,
        ),
        (
            "fixed_rejection_disk_16_pcg32",
            share(integer::DiskRejection16::EFFICIENCY.to_bits()),
            integer::DiskRejection16::BUDGET,
            true,
        ),
        (
            "rejection_ziggurat_standard_normal_pcg32",
            ZigguratStandardNormal::EFFICIENCY.into(),
            ZigguratStandardNormal::BUDGET,
            false,
        ),
        (
            "rejection_ziggurat_standard_exponential_pcg32",
            ZigguratStandardExponential::EFFICIENCY.into(),
            ZigguratStandardExponential::BUDGET,
            false,
        ),
        (
            "poly_poisson_rejection_100_pcg32",
            poisson(100.0)?,
            PoissonRejection::<Poly>::BUDGET,
            false,
        ),
        (
            "poly_poisson_rejection_65536_pcg32",
            poisson(65536.0)?,
            PoissonRejection::<Poly>::BUDGET,
            false,
        ),
        (
            "poly_binomial_rejection_1000_pcg32",
            efficiency(&BinomialRejection::<Poly>::new(1000, 0.25).map_err(|e| e.to_string())?)?,
            BinomialRejection::<Poly>::BUDGET,
            false,
        ),
        (
            "poly_hypergeometric_rejection_10000_pcg32",
            efficiency(&urn(10_000)?)?,
            HypergeometricRejection::<Poly>::BUDGET,
            false,
        ),
        (
            "poly_von_mises_10_pcg32",
            efficiency(&VonMises::<Poly>::new(1.0, 10.0).map_err(|e| e.to_string())?)?,
            VonMises::<Poly>::BUDGET,
            false,
        ),
    ])
}

fn poisson(mean: f32) -> Outcome<f64> {
    efficiency(&PoissonRejection::<Poly>::new(mean).map_err(|e| e.to_string())?)
}

fn urn(population: u32) -> Outcome<HypergeometricRejection<Poly>> {
    HypergeometricRejection::new(population, population / 2, population / 4)
        .map_err(|e| e.to_string())
}

/// Counts over tries.
fn efficiency(sampler: &impl Rejection) -> Outcome<f64> {
    const COUNTS: u32 = 1 << 20;
    let (mut rng, mut tries) = (Pcg32::new(1, 1), 0);
    for _ in 0..COUNTS {
        tries += sampler.draw(&mut rng).map_err(|e| e.to_string())?.tries;
    }
    Ok(f64::from(COUNTS) / f64::from(tries))
}

/// Upper ends throughout. A further try of a region takes what the mean exceeds the least by, over the tries beyond the first.
pub fn table(counts: &Counts) -> Outcome<String> {
    let head = [
        "",
        "efficiency",
        "budget",
        "spent with probability",
        "core",
        "mean",
        "longest seen",
        "a further try",
        "all tries",
    ];
    let line = [
        "---", "--:", "--:", "--:", "---", "--:", "--:", "--:", "--:",
    ];
    let mut table = vec![head.map(String::from).into(), line.map(String::from).into()];
    for (kernel, efficiency, budget, alike) in rejections()? {
        let tries = f64::from(budget);
        let power = tries * (1.0 - efficiency).log2();
        let mut first = vec![
            format!("`{kernel}`"),
            format!("{efficiency:.3}"),
            budget.to_string(),
            format!("2^{power:.0}"),
        ];
        for (title, core) in CORES {
            let of = |column| counts.figure(kernel, core, column);
            let (mean, least, longest) = (of("cycles_high")?, of("least")?, of("longest")?);
            let further = (mean - least) / (1.0 / efficiency - 1.0);
            let (each, most) = if alike {
                (whole(further), least + (tries - 1.0) * further)
            } else {
                (String::new(), tries * longest)
            };
            let mut cells = std::mem::replace(&mut first, vec![String::new(); 4]);
            cells.push(title.into());
            cells.extend([whole(mean), whole(longest), each, whole(most)]);
            table.push(cells);
        }
    }
    Ok(rows(&table))
}
