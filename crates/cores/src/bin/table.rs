//! A two-dimensional table that the compiler built: 32 columns by 16 rows in flash, and not a byte of RAM.
#![no_std]
#![no_main]

use microwarp::discrete::PiecewiseConstant2d;
use microwarp::{Warp, constant};
use microwarp_cores::{input, output};
use rand_pcg::Pcg32;

type Table = PiecewiseConstant2d<[u32; 16], [[u32; 32]; 16]>;

/// A bright spot over a dim gradient, with a dark row.
const fn weights() -> [[f32; 32]; 16] {
    let mut weights = [[0.0; 32]; 16];
    let mut v = 1;
    while v < 16 {
        let mut u = 0;
        while u < 32 {
            weights[v][u] = if u == 20 && v == 5 {
                1e4
            } else {
                (u + v) as f32
            };
            u += 1;
        }
        v += 1;
    }
    weights
}

static SKY: Table = constant!(Table::new(&weights(), [0.0, 1.0], [0.0, 1.0]));

#[unsafe(no_mangle)]
#[inline(never)]
fn microwarp_table(rng: &mut Pcg32) -> ([f32; 2], f32) {
    let point = SKY.draw(rng);
    (point, SKY.pdf(point))
}

#[unsafe(no_mangle)]
#[inline(never)]
extern "C" fn probe_main() {
    let mut rng = Pcg32::new(input(1).into(), input(2).into());
    for _ in 0..input(100) {
        let ([u, v], pdf) = microwarp_table(&mut rng);
        for number in [u, v, pdf] {
            output(number.to_bits());
        }
    }
}
