//! The errors and times of the picture of error against cost, as `docs/measured/tradeoff.csv` records them: all samplers in
//! one contest, drawn one point after the other.

use host::contest::{BLOCKS, Contest, POINTS, Quartiles, block_of};
use host::peers::uniform;
use host::trade::{COLUMNS, samplers};
use std::hint::black_box;

/// Drawing two uniforms and doing nothing with them: each time is taken in units of it, within a round.
const FLOOR: &str = "two uniforms";

fn main() {
    // Under `cargo test --benches` there is no time for more than a look.
    let benching = std::env::args().any(|argument| argument == "--bench");
    let (points, rounds) = if benching { (800_000, 200) } else { (100, 2) };
    // Each block has memory of its own, as points differ in size.
    let mut contest = Contest::of_blocks((), POINTS, BLOCKS);
    let mut floor = block_of(|rng| [uniform(rng), uniform(rng)]);
    let mut pairs = [[0.0; 2]; POINTS];
    contest = contest.block(FLOOR, move |_| {
        floor(black_box(&mut pairs));
        black_box(&pairs);
    });
    let mut rows = Vec::new();
    for sampler in samplers() {
        let (key, error) = (sampler.key(), (sampler.error)(points));
        let mut block = sampler.block;
        contest = contest.block(&key, move |_| block());
        rows.push((key, sampler.calls, error));
    }
    let standings = contest.run(rounds, || ());
    let median = |of: Option<Quartiles>| of.map_or(f64::NAN, |quartiles| quartiles.median);
    let unit = median(standings.nanoseconds(FLOOR));
    println!("{COLUMNS}");
    for (key, calls, error) in rows {
        let ns = median(standings.ratio(&key, FLOOR)) * unit * calls;
        println!("{key},{error:.2e},{ns:.1}");
    }
}
