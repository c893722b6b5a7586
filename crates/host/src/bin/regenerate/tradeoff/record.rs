//! The record of errors, and of times on the host: what it must have, and what a few points say of it.

use super::of_core;
use microwarp_host::counts::Counts;
use microwarp_host::trade::{COLUMNS, samplers};
use microwarp_host::upkeep::{self, Outcome};

pub const FILE: &str = "docs/measured/tradeoff.csv";

/// A row of the record.
#[derive(Clone)]
pub struct Row {
    pub key: String,
    pub family: String,
    pub name: String,
    pub tier: String,
    pub kernel: String,
    pub calls: f64,
    pub error: f64,
    pub ns: f64,
}

impl Row {
    fn of(line: &str) -> Option<Self> {
        let cells: Vec<&str> = line.split(',').collect();
        let [family, name, tier, kernel, calls, error, ns] = cells[..] else {
            return None;
        };
        Some(Self {
            key: cells[..5].join(","),
            family: family.into(),
            name: name.into(),
            tier: tier.into(),
            kernel: kernel.into(),
            calls: calls.parse().ok()?,
            error: error.parse().ok()?,
            ns: ns.parse().ok()?,
        })
    }
}

pub fn read() -> Outcome<Vec<Row>> {
    let text = upkeep::read(FILE)?;
    let lines: Vec<_> = text.lines().filter(|line| !line.starts_with('#')).collect();
    let (head, lines) = lines.split_first().ok_or("tradeoff.csv is empty")?;
    let rows = lines
        .iter()
        .map(|line| Row::of(line).ok_or_else(|| format!("{FILE}: {line}")));
    let rows = rows.collect::<Outcome<Vec<_>>>()?;
    if *head == COLUMNS {
        Ok(rows)
    } else {
        Err(format!("{FILE}: {head}"))
    }
}

/// So many points show an error to within this factor, of samplers that reject near an edge as well.
const FEW: u64 = 2_000;
const WITHIN: f64 = 100.0;

/// The record has every sampler and none that is gone, each with an error that a look at it does not exceed and nearly
/// reaches, and with a kernel that has been counted.
pub fn check() -> Outcome {
    let (rows, counts) = (read()?, Counts::read()?);
    let samplers = samplers();
    let seen: Vec<f64> = samplers
        .iter()
        .map(|sampler| (sampler.error)(FEW))
        .collect();
    let keys: Vec<String> = samplers.iter().map(|sampler| sampler.key()).collect();
    let complaints = |rows: &[Row]| {
        let mut wrong = String::new();
        if rows.len() != keys.len() {
            wrong += &format!("{} rows for {} samplers\n", rows.len(), keys.len());
        }
        for ((row, key), seen) in rows.iter().zip(&keys).zip(&seen) {
            // To the digits of the record.
            let numbers = row.error.is_finite() && row.ns > 0.0;
            let holds = numbers && *seen <= row.error * 1.005 && row.error <= seen * WITHIN;
            let counted = row.kernel.is_empty() || of_core(&counts, &row.kernel, "m0").is_some();
            if row.key != *key || !holds || !counted {
                wrong += &format!(
                    "{} {:.2e}, and there is {key} {seen:.2e}\n",
                    row.key, row.error
                );
            }
        }
        wrong
    };
    let spoilt: [fn(&mut Vec<Row>); 6] = [
        |rows| drop(rows.pop()),
        |rows| rows[0].error /= 2.0,
        |rows| rows[0].error *= 2.0 * WITHIN,
        |rows| rows[0].error = f64::INFINITY,
        |rows| rows[0].ns = 0.0,
        |rows| rows[0].kernel = "disc".into(),
    ];
    for spoil in spoilt {
        let mut rows = rows.clone();
        spoil(&mut rows);
        if complaints(&rows).is_empty() {
            return Err(format!("control: a wrong row of {FILE} passes"));
        }
    }
    match complaints(&rows) {
        wrong if wrong.is_empty() => Ok(()),
        wrong => Err(format!("{FILE}, which --host writes:\n{wrong}")),
    }
}
