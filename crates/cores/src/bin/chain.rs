//! A chain in the unit square, with large and small steps: what it links is what it costs.
#![no_std]
#![no_main]

use microwarp::metropolis::{Chain, LargeSmall, LogUniformStep, Mixture, WrappedWalk};
use microwarp::poly as mw;
use microwarp::tier::Poly;
use microwarp_cores::{input, output};
use rand_pcg::Pcg32;

type Steps = LargeSmall<WrappedWalk<LogUniformStep<Poly>>>;

fn target([x, y]: [f32; 2]) -> f32 {
    (x - 0.5) * (x - 0.5) + y
}

#[unsafe(no_mangle)]
#[inline(never)]
fn microwarp_chain(chain: &mut Chain<[f32; 2]>, steps: &Steps, rng: &mut Pcg32) -> [f32; 2] {
    chain.step(target, steps, rng).state()
}

#[unsafe(no_mangle)]
#[inline(never)]
extern "C" fn probe_main() {
    let mut rng = Pcg32::new(input(1).into(), input(2).into());
    let small = mw::LogUniformStep::new(1.0 / 1024.0, 1.0 / 64.0).map(WrappedWalk::new);
    let steps = small.and_then(|small| Mixture::large_small(0.3, small));
    if let (Ok(steps), Ok(mut chain)) = (steps, Chain::new([0.1, 0.5], target)) {
        for _ in 0..input(100) {
            for coordinate in microwarp_chain(&mut chain, &steps, &mut rng) {
                output(coordinate.to_bits());
            }
        }
    }
}
