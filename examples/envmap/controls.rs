//! Controls: tables with common mistakes, made on purpose. The test that the correct table passes must reject each.

use crate::study::{Memory, Truth};
use microwarp::{Error, Warp, poly as mw};
use rand_pcg::Pcg32;
use support::verdict::Outcome;

pub struct Control {
    pub name: &'static str,
    pub outcome: Outcome,
    pub histogram: Vec<u64>,
}

/// `luminance` is that of the picture behind `truth`, whose weights are `weights`.
pub fn all(
    truth: &Truth,
    weights: &[f32],
    luminance: &[f64],
    samples: usize,
    seed: u64,
) -> Result<Vec<Control>, Error> {
    let [columns, rows] = truth.shape;
    let mut memory = Memory::<u32>::new(truth.shape);
    let mut controls = Vec::new();
    let mut add = |name, histogram: Vec<u64>| {
        controls.push(Control {
            name,
            outcome: truth.test(&histogram),
            histogram,
        });
    };
    let mut of_weights = |weights: &[f32], stream| -> Result<Vec<u64>, Error> {
        let table = memory.build(weights, truth.shape)?;
        let mut points = vec![[0.0; 2]; samples];
        table.fill(&mut Pcg32::new(seed, stream), &mut points);
        Ok(truth.histogram(points))
    };

    let plain: Vec<f32> = luminance.iter().map(|&l| l as f32).collect();
    add("sin θ forgotten", of_weights(&plain, 10)?);

    // The sun as a picture with 8 bits per channel would hold it.
    let clipped = plain.iter().zip(weights).map(|(&l, &w)| w / l.max(1.0));
    let clipped: Vec<f32> = clipped.collect();
    add("radiance clipped at 1", of_weights(&clipped, 11)?);

    let turned: Vec<f32> = (0..rows * columns)
        .map(|i| weights[i % rows * columns + i / rows])
        .collect();
    add("rows taken for columns", of_weights(&turned, 12)?);

    let table = memory.build(weights, truth.shape)?;
    let anywhere = mw::Interval::new(0.0, 1.0)?;
    let mut rng = Pcg32::new(seed, 13);
    let points = (0..samples).map(|_| [anywhere.draw(&mut rng), table.marginal().draw(&mut rng)]);
    add("columns uniform in a row", truth.histogram(points));
    Ok(controls)
}
