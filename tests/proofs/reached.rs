//! How near to what is stated samples are known to come, where that is a formula.

use crate::kept;
use host::adversary::words::Kind;
use host::docs::Statement;
use host::errors::raise;
use host::figures::{Exact, Figures, draw_error, sample_error};
use host::registry::Registered;
use host::speed;
use rand_pcg::Pcg32;

/// The largest part of what is stated that a sample or a draw reaches: at the worst cases of earlier searches, and at others.
pub fn reached(of: &Registered, stated: &Statement) -> f64 {
    let mut most = 0.0;
    let mut at = |p: &[f32], u: [f32; 4]| {
        if let Ok(entry) = of.of_drawn(p) {
            let mut figures = Figures::default();
            let exact = Exact::of(&entry, u, false);
            sample_error(&entry, &exact, entry.warp.sample(u), &mut figures);
            draw_error(&entry, u[0], &mut figures);
            let values = stated.names().iter().map(|name| entry.variable(name));
            let values: Option<Vec<_>> = values.collect();
            let values = values.expect("a value for each name");
            raise(&mut most, figures.sample / stated.eval(&values));
        }
    };
    for (p, u) in kept::cases(of) {
        at(&p, u);
    }
    let mut rng = Pcg32::new(11, 11);
    for _ in 0..speed::of("samples beside a formula tried", 1 << 14, 1 << 20) {
        let mut draw = |kind: &Kind| f32::from_bits(kind.draw(&mut rng));
        let p: Vec<f32> = of.takes.iter().map(&mut draw).collect();
        at(&p, [(); 4].map(|()| draw(&Kind::Uniform)));
    }
    most
}
