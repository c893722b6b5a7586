//! Whatever parameters a constructor accepts, the warp is total: finite samples of positive, finite
//! density, inverses in [0, 1). Parameters are random bits, ordinary and special numbers.

use host::registry::{Registered, of_libm, of_poly};
use host::speed;
use rand_core::Rng;
use rand_pcg::Pcg32;
use std::sync::LazyLock;

static ROUNDS: LazyLock<u32> =
    LazyLock::new(|| speed::of("parameters of each constructor", 1_200, 6_000));

/// Uniforms at which maps break, and some between.
const UNIFORMS: [[f32; 4]; 10] = [
    [0.0; 4],
    [1.0; 4],
    [f32::NAN; 4],
    [0.0, 0.999_999_94, 0.5, 0.5],
    [0.999_999_94, 0.0, 0.5, 0.5],
    [1e-45, 0.5, 1e-45, 0.5],
    [5.960_464_5e-8, 0.123, 0.7, 0.2],
    [0.5, 0.25, 0.75, 0.125],
    [0.3, 0.898, 0.4, 0.6],
    [0.82, 0.374_9, 0.9, 0.1],
];

/// A float of any kind: any bits, any magnitude, or a small comfortable number.
pub fn any(rng: &mut Pcg32) -> f32 {
    let word = rng.next_u32();
    match word % 4 {
        0 => f32::from_bits(rng.next_u32()),
        1 => {
            (1.0 + (rng.next_u32() >> 9) as f32 * f32::EPSILON)
                * 2f32.powi((word >> 8) as i32 % 127)
        }
        2 => ((rng.next_u32() >> 8) as f32 / 16_777_216.0 - 0.5) * 4.0,
        _ => (rng.next_u32() >> 8) as f32 / 16_777_216.0,
    }
}

fn total(of: &Registered, rng: &mut Pcg32) {
    let mut accepted = 0;
    for _ in 0..*ROUNDS {
        let parameters: Vec<f32> = of
            .takes
            .iter()
            .map(|kind| f32::from_bits(kind.draw(rng)))
            .collect();
        let Ok(entry) = of.of_drawn(&parameters) else {
            continue;
        };
        accepted += 1;
        for u in UNIFORMS {
            let x = entry.warp.sample(u);
            let pdf = entry.warp.pdf(x);
            let back = entry.warp.invert(x);
            let label = format!("{} {} {parameters:?} at {u:?}", of.name, of.constructor);
            assert!(
                x.iter().all(|c| c.is_finite()) && pdf > 0.0 && pdf <= f32::MAX,
                "{label}: {x:?} has {pdf}"
            );
            assert!(
                back.iter().all(|u| (0.0..1.0).contains(u)),
                "{label}: {x:?} comes from {back:?}"
            );
        }
    }
    let name = format!("{} {}", of.name, of.constructor);
    println!("{name}: {accepted} of {} accepted", *ROUNDS);
    assert!(accepted >= *ROUNDS / 100, "{name} accepted only {accepted}");
}

fn every_constructor(all: &[Registered]) {
    let mut rng = Pcg32::new(2_026, 11);
    for of in all.iter().filter(|of| !of.takes.is_empty()) {
        total(of, &mut rng);
    }
}

#[test]
fn accepted_parameters_are_total_in_libm() {
    every_constructor(&of_libm());
}

#[test]
fn accepted_parameters_are_total_in_poly() {
    every_constructor(&of_poly());
}
