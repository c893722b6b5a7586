//! The table of rejection in docs/worst_case.md: what a try takes, how many there can be, and how likely that is.

use crate::host::{CORES, whole};
use crate::tables::rows;
use microwarp::rejection::{
    BallRejection, Beta, BinomialRejection, Dirichlet, DiskRejection, Gamma,
    HypergeometricRejection, PoissonRejection, Rejection, VonMises, ZigguratStandardExponential,
    ZigguratStandardNormal,
};
use microwarp::tier::Poly;
use microwarp_host::counts::Counts;
use microwarp_host::upkeep::Outcome;
use rand_pcg::Pcg32;

/// One row of the table.
struct Row {
    kernel: &'static str,
    efficiency: f64,
    budget: u32,
    /// Whether every try costs the same.
    alike: bool,
    /// How many numbers a point is made of, each of which has to be accepted.
    numbers: u32,
}

/// A region: a point is drawn until it lies inside.
fn region(kernel: &'static str, efficiency: f64, budget: u32) -> Row {
    Row {
        kernel,
        efficiency,
        budget,
        alike: true,
        numbers: 1,
    }
}

/// A law: some tries end early.
fn law(kernel: &'static str, efficiency: f64, budget: u32) -> Row {
    Row {
        alike: false,
        ..region(kernel, efficiency, budget)
    }
}

fn rejections() -> Outcome<[Row; 15]> {
    use microwarp::fixed as integer;
    let share = |bits: u32| f64::from(bits) / 4_294_967_296.0;
    Ok([
        region(
            "rejection_disk_pcg32",
            DiskRejection::EFFICIENCY.into(),
            DiskRejection::BUDGET,
        ),
        region(
            "rejection_ball_pcg32",
            BallRejection::EFFICIENCY.into(),
            BallRejection::BUDGET,
        ),
        region(
            "fixed_rejection_disk_pcg32",
            share(integer::DiskRejection::EFFICIENCY.to_bits()),
            integer::DiskRejection::BUDGET,
        ),
        region(
            "fixed_rejection_disk_16_pcg32",
            share(integer::DiskRejection16::EFFICIENCY.to_bits()),
            integer::DiskRejection16::BUDGET,
        ),
        law(
            "rejection_ziggurat_standard_normal_pcg32",
            ZigguratStandardNormal::EFFICIENCY.into(),
            ZigguratStandardNormal::BUDGET,
        ),
        law(
            "rejection_ziggurat_standard_exponential_pcg32",
            ZigguratStandardExponential::EFFICIENCY.into(),
            ZigguratStandardExponential::BUDGET,
        ),
        law(
            "poly_poisson_rejection_100_pcg32",
            poisson(100.0)?,
            PoissonRejection::<Poly>::BUDGET,
        ),
        law(
            "poly_poisson_rejection_65536_pcg32",
            poisson(65536.0)?,
            PoissonRejection::<Poly>::BUDGET,
        ),
        law(
            "poly_binomial_rejection_1000_pcg32",
            efficiency(&BinomialRejection::<Poly>::new(1000, 0.25).map_err(|e| e.to_string())?)?,
            BinomialRejection::<Poly>::BUDGET,
        ),
        law(
            "poly_hypergeometric_rejection_10000_pcg32",
            efficiency(&urn(10_000)?)?,
            HypergeometricRejection::<Poly>::BUDGET,
        ),
        law(
            "poly_von_mises_10_pcg32",
            efficiency(&VonMises::<Poly>::new(1.0, 10.0).map_err(|e| e.to_string())?)?,
            VonMises::<Poly>::BUDGET,
        ),
        law(
            "poly_gamma_25_pcg32",
            of_shapes(&[2.5])?,
            Gamma::<Poly>::BUDGET,
        ),
        law(
            "poly_gamma_5_pcg32",
            of_shapes(&[0.5])?,
            Gamma::<Poly>::BUDGET,
        ),
        Row {
            numbers: 2,
            ..law(
                "poly_beta_2_5_pcg32",
                of_shapes(&[2.0, 5.0])?,
                Beta::<Poly>::BUDGET,
            )
        },
        Row {
            numbers: 4,
            ..law(
                "poly_dirichlet_4_pcg32",
                of_shapes(&[0.5, 1.0, 2.0, 4.0])?,
                Dirichlet::<Poly, 4>::BUDGET,
            )
        },
    ])
}

/// The least efficiency of gamma numbers of these shapes.
fn of_shapes(shapes: &[f32]) -> Outcome<f64> {
    let mut least = 1.0_f64;
    for &shape in shapes {
        let law = Gamma::<Poly>::new(shape, 1.0).map_err(|e| e.to_string())?;
        least = least.min(efficiency(&law)?);
    }
    Ok(least)
}

/// The logarithm to base 2 of the probability that fewer than so many of independent tries are accepted.
fn spent(efficiency: f64, tries: u32, numbers: u32) -> f64 {
    // From none accepted on: each has the share of the one before times the odds and the ratio of binomial coefficients.
    let (mut each, mut sum) = (1.0, 0.0);
    for accepted in 0..numbers {
        sum += each;
        each *=
            efficiency / (1.0 - efficiency) * f64::from(tries - accepted) / f64::from(accepted + 1);
    }
    f64::from(tries) * (1.0 - efficiency).log2() + sum.log2()
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
    for row in rejections()? {
        let Row {
            kernel,
            efficiency,
            budget,
            alike,
            numbers,
        } = row;
        let tries = f64::from(budget);
        let power = spent(efficiency, budget, numbers);
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
