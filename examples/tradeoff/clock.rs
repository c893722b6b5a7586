//! Nanoseconds per sample, with all samplers in one contest.

use crate::sampler::Block;
use host::contest::{BLOCKS, Contest, POINTS, Quartiles};
use std::collections::BTreeMap;

/// The unit of all other times: drawing two words as uniforms and doing nothing with them.
pub const FLOOR: &str = "two uniforms";

/// The times of a sampler.
#[derive(Clone, Copy, Debug, Default)]
pub struct Times {
    /// Drawn one by one.
    pub draw: Option<f64>,
    /// Filling a slice.
    pub fill: Option<f64>,
}

/// Runs all blocks in turn, for this many rounds. Each time is divided by the floor's time in the same round, so that
/// all are taken under the same load; the median quotient times the median floor is the result.
///
/// Also returns how far apart the quartiles of those quotients lie for most, relative to the median.
pub fn run(
    blocks: Vec<(String, Block)>,
    rounds: usize,
    after_round: impl FnMut(),
) -> (BTreeMap<String, f64>, f64) {
    // Every block has memory of its own, as points differ in size.
    let mut contest = Contest::of_blocks((), POINTS, BLOCKS);
    let mut names = vec![FLOOR.to_owned()];
    contest = contest.block(FLOOR, floor());
    for (name, mut block) in blocks {
        contest = contest.block(&name, move |_: &mut [()]| block());
        names.push(name);
    }
    let standings = contest.run(rounds, after_round);
    let floor = standings.nanoseconds(FLOOR).map_or(f64::NAN, |q| q.median);
    let time = |name: &String| standings.ratio(name, FLOOR).map(|q| q.median * floor);
    let spreads = names
        .iter()
        .filter_map(|name| Some(standings.ratio(name, FLOOR)?.spread()));
    let spread = Quartiles::of(spreads).median;
    let times = names
        .iter()
        .filter_map(|name| Some((name.clone(), time(name)?)));
    (times.collect(), spread)
}

fn floor() -> impl FnMut(&mut [()]) {
    let mut kept = host::contest::generator();
    let mut points = vec![[0.0_f32; 2]; POINTS];
    move |_| {
        let mut rng = kept.clone();
        for point in std::hint::black_box(&mut points) {
            *point = [
                host::peers::uniform(&mut rng),
                host::peers::uniform(&mut rng),
            ];
        }
        kept = rng;
        std::hint::black_box(&points);
    }
}
