//! The chains under test: every mutation, over targets of all kinds.

use crate::densities::*;
use crate::own::multiply;
use crate::targets::{Outcome, Plan, Seen, Walk, plan, run};
use host::speed;
use microwarp::metropolis::{
    BoxStep, Chain, Independence, Mixture, Mutation, OneCoordinate, Subset, TargetDensity,
    Transition, UniformStep, WrappedWalk, primary_density,
};
use microwarp::{Warp, libm, poly};
use rand_pcg::Pcg32;
use std::rc::Rc;

type Runner = Box<dyn Fn(&Plan, u64) -> Outcome>;

/// A chain with its types erased.
pub struct Subject {
    pub name: &'static str,
    pub plan: Plan,
    run: Runner,
}

impl Subject {
    pub fn run(&self, seed: u64) -> Outcome {
        self.run_by(&self.plan, seed)
    }

    pub fn run_by(&self, plan: &Plan, seed: u64) -> Outcome {
        (self.run)(plan, seed)
    }

    pub fn planned(self, plan: Plan) -> Self {
        Self { plan, ..self }
    }
}

/// A subject of any stepping.
pub fn walking<X, D, W>(
    name: &'static str,
    cells: Cells<X>,
    start: impl Fn(&mut Pcg32) -> W + 'static,
) -> Subject
where
    X: Copy + 'static,
    D: Copy + 'static,
    W: FnMut(&mut Pcg32) -> Transition<X, D> + 'static,
{
    let start = move |rng: &mut Pcg32| -> Walk<X> {
        let mut walk = start(rng);
        Box::new(move |rng| Seen::of(&walk(rng)))
    };
    Subject {
        name,
        plan: plan(),
        run: Box::new(move |plan, seed| run(plan, &cells, &start, seed)),
    }
}

/// A subject that is a chain, started where the target is small.
pub fn chain<X, D, M>(
    name: &'static str,
    cells: Cells<X>,
    start: X,
    target: impl Fn(X) -> D + 'static,
    mutation: M,
) -> Subject
where
    X: Copy + 'static,
    D: TargetDensity + 'static,
    M: Mutation<X> + 'static,
{
    let shared = Rc::new((target, mutation));
    walking(name, cells, move |_| {
        let shared = Rc::clone(&shared);
        let mut chain = Chain::new(start, &shared.0).unwrap();
        move |rng: &mut Pcg32| chain.step(&shared.0, &shared.1, rng)
    })
}

/// Small steps nine times out of ten, large ones otherwise.
pub fn nine_to_one() -> impl Mutation<f32> + Copy {
    let small = WrappedWalk::new(BoxStep::new(0.1_f32).unwrap());
    Mixture::new((small, UniformStep::new()), &[0.9, 0.1]).unwrap()
}

/// Half of the steps by factors, half by sums.
fn over_decades() -> impl Mutation<f32> {
    let sum = poly::LogUniformStep::new(1e-15, 1e15).unwrap();
    Mixture::new((multiply(35.0), sum), &[1.0, 1.0]).unwrap()
}

/// A step across the parabola that never crosses its valley in time, so that each batch starts on the target.
fn slow() -> Plan {
    Plan {
        batches: if speed::full() { 2048 } else { 1024 },
        steps: 1000,
        burn_in: 0,
    }
}

pub fn slow_box(name: &'static str, mutation: impl Mutation<f32> + Copy + 'static) -> Subject {
    walking(name, parabola_cells(), move |rng| {
        let mut chain = Chain::new(on_parabola(rng), parabola).unwrap();
        move |rng: &mut Pcg32| chain.step(parabola, &mutation, rng)
    })
    .planned(slow())
}

fn on_the_line() -> Vec<Subject> {
    let narrow = BoxStep::new(0.1_f32).unwrap();
    let parabolic = |name, mutation| chain(name, parabola_cells(), 0.45, parabola, mutation);
    let kelemen = |largest| {
        let step = WrappedWalk::new(poly::LogUniformStep::new(1e-4, largest).unwrap());
        Mixture::large_small(0.2, step).unwrap()
    };
    let log_law = |x| poly::LogDensity::new(log_power(x) as f32);
    let log_drop = |x| libm::LogDensity::new(log_cliff(x) as f32);
    let wide = poly::LogUniformStep::new(0.01, 1e6).unwrap();
    let source = poly::Exponential::from_rate(0.4).unwrap();
    let long = Plan {
        steps: if speed::full() { 50_000 } else { 10_000 },
        burn_in: 20_000,
        batches: 128,
    };
    let linear = |x| log_power(x).exp() as f32;
    let falling = |u| log_cliff(u).exp() as f32;
    let (uniform, wrapped) = (UniformStep::new(), WrappedWalk::new(narrow));
    let factors = multiply(1.5);
    vec![
        chain(
            "parabola, uniform",
            parabola_cells(),
            0.45,
            parabola,
            uniform,
        ),
        slow_box("parabola, box", narrow),
        chain(
            "parabola, wrapped box",
            parabola_cells(),
            0.45,
            parabola,
            wrapped,
        )
        .planned(long),
        parabolic("parabola, nine to one", nine_to_one()),
        chain("cauchy, exponential", cauchy_cells(), 50.0, cauchy, wide),
        chain(
            "thirty decades, f32",
            power_cells(),
            1e15,
            linear,
            over_decades(),
        ),
        chain(
            "thirty decades, logarithms",
            power_cells(),
            1e15,
            log_law,
            over_decades(),
        ),
        chain("cliff, f32", cliff_cells(), 0.999, falling, kelemen(0.1)),
        chain(
            "cliff, logarithms",
            cliff_cells(),
            0.999,
            log_drop,
            kelemen(0.1),
        ),
        chain("gamma, factors", gamma_cells(), 40.0, gamma, factors),
        chain(
            "gamma, independence",
            gamma_cells(),
            40.0,
            gamma,
            Independence::new(source),
        ),
        chain("no density below 0.2", gap_cells(), 0.45, gap, gap_steps()),
    ]
}

pub fn gap_steps() -> impl Mutation<f32> {
    let near = BoxStep::new(0.2_f32).unwrap();
    Mixture::new((near, UniformStep::new()), &[0.5, 0.5]).unwrap()
}

/// A lobe in the uniforms of a warp of another shape.
fn lobe<W>(name: &'static str, warp: W, z: fn(f64) -> f64) -> Subject
where
    W: Warp<Uniforms = [f32; 2], Point = [f32; 3], Density = f32> + Copy + 'static,
{
    let shine = libm::PhongLobe::new(SHINE).unwrap();
    let target = primary_density(warp, move |w: [f32; 3]| shine.pdf(w));
    let step = poly::LogUniformStep::new(1.0 / 1024.0, 1.0 / 64.0).unwrap();
    let mutation = Mixture::large_small(0.2, WrappedWalk::new(step)).unwrap();
    chain(name, lobe_cells(z), [0.9, 0.1], target, mutation)
}

fn in_the_plane() -> Vec<Subject> {
    let wide = BoxStep::new([4.0_f32; 2]).unwrap();
    let normal = poly::NormalStep::new([1.2; 2]).unwrap();
    let reference = libm::NormalStep::new([1.2; 2]).unwrap();
    let pair = Independence::new(poly::NormalPair::new([0.5, 0.0], 1.6).unwrap());
    let mixed = Mixture::new((reference, pair, wide), &[2.0, 1.0, 1.0]).unwrap();
    let across = Subset::<_, 1, 2>::new(BoxStep::new([4.0_f32]).unwrap(), [0]).unwrap();
    let along = Subset::<_, 1, 2>::new(poly::NormalStep::new([1.2]).unwrap(), [1]).unwrap();
    let turns = Mixture::new((across, along), &[1.0, 1.0]).unwrap();
    let one = OneCoordinate::new(libm::NormalStep::new(2.0).unwrap());
    let start = [6.0, 6.0];
    vec![
        chain("blobs, box", blobs_cells(), start, blobs, wide),
        chain("blobs, normal, poly", blobs_cells(), start, blobs, normal),
        chain(
            "blobs, normal, libm",
            blobs_cells(),
            start,
            blobs,
            reference,
        ),
        chain("blobs, independence", blobs_cells(), start, blobs, pair),
        chain("blobs, mixture", blobs_cells(), start, blobs, mixed),
        chain("blobs, subsets", blobs_cells(), start, blobs, turns),
        chain("blobs, one coordinate", blobs_cells(), start, blobs, one),
        // Their documentation has z = u, and z² = 1 − u.
        lobe("lobe in a hemisphere", poly::Hemisphere::new(), |u| u),
        lobe(
            "lobe in a cosine lobe",
            poly::PhongLobe::new(1.0).unwrap(),
            |u| (1.0 - u).sqrt(),
        ),
    ]
}

pub fn all() -> Vec<Subject> {
    [on_the_line(), in_the_plane()]
        .into_iter()
        .flatten()
        .collect()
}
