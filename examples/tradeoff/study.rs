//! Everything measured for one sampler, in order.

use crate::args::Args;
use crate::bias::{self, Bias, Shows};
use crate::bounds;
use crate::clock::Times;
use crate::costs::{CORES, Cost, Costs};
use crate::error::{self, Errors};
use crate::front::Trade;
use crate::sampler::{Sampler, Way};
use crate::shape::{self, Shape};
use rand_pcg::Pcg32;

/// How many points have their errors measured.
const POINTS: usize = 800_000;
/// Of these, points that are held to the documented bounds once more, in its units.
const HELD: usize = 100_000;
/// Uniforms that are tried for a bias, about.
const TRIED: usize = 1_000_000;

/// Where costs are measured: the host, then the cores.
pub const TARGETS: [&str; 4] = ["host, ns", "Cortex-M0", "Cortex-M4F", "WASM"];

pub struct Study {
    pub sampler: Sampler,
    pub errors: Errors,
    pub shape: Shape,
    /// What is known of its bias; nothing where its uniforms cannot be chosen.
    pub bias: Option<Bias>,
    /// After how many samples it shows: by what the map is, or by what samples have shown.
    pub shows: Shows,
    pub times: Times,
    pub costs: [Cost; CORES.len()],
    /// Where it exceeds its documented errors.
    pub complaints: Vec<String>,
}

/// The generator of one purpose for one sampler, so that a row keeps its numbers when another is added above it.
pub fn generator(seed: u64, label: &str, purpose: u64) -> Pcg32 {
    // FNV-1a
    let hash = |hash: u64, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    let stream = label.bytes().fold(0xcbf2_9ce4_8422_2325, hash);
    Pcg32::new(seed, stream ^ purpose)
}

impl Study {
    pub fn new(sampler: Sampler, costs: &Costs, args: &Args) -> Self {
        let label = sampler.label();
        let points = args.share(POINTS) as u64;
        let errors = error::measure(&sampler, points);
        let rng = &mut generator(args.seed, &label, 0);
        let shape = shape::examine(&sampler.fill, &sampler.law, args.samples, rng);
        let rng = &mut generator(args.seed, &label, 1);
        let costs = CORES.map(|(core, _)| costs.of(&sampler.kernel, core, sampler.calls));
        let bias = bias(&sampler, args.share(TRIED), rng);
        Self {
            shows: bias.map_or_else(|| shape.bound(), |bias| bias.shows()),
            bias,
            complaints: bounds::complaints(&sampler, &errors, args.share(HELD) as u64),
            errors,
            shape,
            times: Times::default(),
            costs,
            sampler,
        }
    }

    /// What a sample costs on a target, generator included: nanoseconds, cycles, or instructions of WASM.
    pub fn cost(&self, target: usize) -> Option<f64> {
        match target.checked_sub(1) {
            None => self.times.draw,
            Some(core) => self.costs[core].whole(CORES[core].0),
        }
    }

    /// The longest that a sample has been seen to take, where that is known.
    pub fn longest(&self, target: usize) -> Option<f64> {
        let cycles = self.costs[target.checked_sub(1)?].cycles;
        cycles.map(|cycles| cycles.longest)
    }

    /// Cost and error on a target, if both are known.
    pub fn trade(&self, target: usize) -> Option<Trade> {
        let error = self
            .errors
            .point
            .is_known()
            .then_some(self.errors.point.max)?;
        Some(Trade {
            cost: self.cost(target)?,
            error,
        })
    }
}

/// The bias of maps of one or two uniforms, and of tables. Other maps would need too many uniforms.
fn bias(sampler: &Sampler, tried: usize, rng: &mut Pcg32) -> Option<Bias> {
    match &sampler.way {
        Way::Table(entries) => Some(Bias::exact(entries)),
        Way::Map(map) if sampler.law.axes <= 2 && sampler.law.inverts() => {
            let borders = bias::borders(sampler.law.axes);
            Some(bias::estimate(
                map,
                &sampler.law,
                tried.div_ceil(borders),
                rng,
            ))
        }
        _ => None,
    }
}
