//! The subjects of gamma numbers and of shares.

use crate::Out;
use crate::subjects::{Put, failed, generator, v, with};
use microwarp::rejection::{Beta, Dirichlet, Gamma, Rejection};
use microwarp::tier::Tier;

/// Shapes of every size: what words give, a number of a generator, its logarithm and its density.
pub fn numbers<T: Tier>([a, b, c, d]: [f32; 4], input: usize, out: &mut Out) {
    let words = [a, b, c].map(|u| (u * 4_294_967_296.0) as u32);
    for (law, logarithm) in [
        (Gamma::<T>::new(a, b), true),
        (Gamma::new(1.0 + 9.0 * c, v(1.0)), true),
        (Gamma::new(v(1e6) * d, a), false),
        (Gamma::new(v(1e-3) * b, d), true),
        (Gamma::chi_squared(v(2.0)), false),
    ] {
        with(law, out, |law, out| {
            out.float(law.attempt(words).unwrap_or(0.0));
            match law.draw(&mut generator(input)) {
                Ok(drawn) => out.float(law.pdf(drawn.point)),
                Err(failure) => failed(failure, out),
            }
            if logarithm {
                let drawn = law.draw_ln(&mut generator(input));
                out.float(drawn.map_or(0.0, |drawn| drawn.point));
            }
        });
    }
}

/// Two shares, and four, with their densities.
pub fn shares<T: Tier>([a, b, c, d]: [f32; 4], input: usize, out: &mut Out) {
    with(Beta::<T>::new(a, b), out, |law, out| {
        out.float(law.pdf([c, 1.0 - c]));
    });
    with(Beta::<T>::new(1.0 + c, v(1e3) * d), out, |law, out| {
        drawn(&law, |point| law.pdf(point), input, out);
    });
    with(
        Dirichlet::<T, 4>::new([a, d, v(1e-3) * b, c]),
        out,
        |law, out| {
            drawn(&law, |point| law.pdf(point), input, out);
        },
    );
    with(
        Dirichlet::<T, 3>::new([1.0 + a, 1.0 + b, v(100.0) * c]),
        out,
        |law, out| {
            drawn(&law, |point| law.pdf(point), input, out);
        },
    );
}

fn drawn<P: Put>(
    law: &impl Rejection<Point = P>,
    pdf: impl Fn(P) -> f32,
    input: usize,
    out: &mut Out,
) {
    match law.draw(&mut generator(input)) {
        Ok(drawn) => {
            drawn.point.put(out);
            out.float(pdf(drawn.point));
        }
        Err(failure) => failed(failure, out),
    }
}
