//! Bounds of the programs beside those of Gappa, which has an interval arithmetic and rules of rounding of its own: a program
//! writes the script, once in real numbers and once rounded, by the operations that are recorded otherwise.
//!
//! S. Boldo and G. Melquiond, <https://gappa.gitlabpages.inria.fr>. Debian's package `gappa` is enough.

use crate::bilinear;
use crate::cover::complements;
use crate::fisher::Halves;
use crate::number::Number;
use crate::parametric::{Form, Triangle, Vertices};
use crate::range::Range;
use crate::script::Script;
use crate::shapes::parts_of;
use crate::tape::Tape;
use host::errors::raise;
use host::speed;
use std::process::Command;

/// A program of a uniform and of other numbers, of which the error of one result is asked for.
trait Program {
    const NAME: &'static str;
    /// How many times the recorded bound that of Gappa may be.
    const NEAR: f64;
    fn others() -> Vec<Range> {
        Vec::new()
    }
    fn run<N: Number>(others: &[N], uniforms: [N; 2]) -> N;
}

/// The first weight of a point of a triangle.
struct Weight;

impl Program for Weight {
    const NAME: &'static str = "Triangle";
    const NEAR: f64 = 1.1;
    fn run<N: Number>(_: &[N], [u, v]: [N; 2]) -> N {
        Triangle { once_more: false }.place(&[], &[u, v, u, v])[0]
    }
}

/// A coordinate of a point of a triangle.
struct Coordinate;

impl Program for Coordinate {
    const NAME: &'static str = "TriangleOn";
    const NEAR: f64 = 1.1;
    fn others() -> Vec<Range> {
        vec![
            Range {
                low: 1.0,
                high: 1.01
            };
            3
        ]
    }
    fn run<N: Number>(vertices: &[N], [u, v]: [N; 2]) -> N {
        Vertices { once_more: false }.place(vertices, &[u, v, u, v])[0]
    }
}

/// sin θ of s = 1 - cos θ. Gappa takes the product of s and 2 - s at the largest of each, which no s makes.
struct Sine;

impl Program for Sine {
    const NAME: &'static str = "VonMisesFisher";
    const NEAR: f64 = 1.4;
    fn run<N: Number>(_: &[N], [u, _]: [N; 2]) -> N {
        Halves::place(u)[0]
    }
}

/// A place of a linear density, by exact weights.
struct Place;

impl Program for Place {
    const NAME: &'static str = "Bilinear";
    const NEAR: f64 = 1.1;
    fn others() -> Vec<Range> {
        [(0.25, 0.251), (1.0, 1.01)]
            .map(|(low, high)| Range { low, high })
            .to_vec()
    }
    fn run<N: Number>(weights: &[N], uniforms: [N; 2]) -> N {
        bilinear::place([weights[0], weights[1]], uniforms, 1.0, false)[0]
    }
}

/// Of one range of the uniform, or of what it leaves: what the record proves.
fn recorded<P: Program>(small: Range, first: bool) -> f64 {
    let tape = Tape::default();
    let others = P::others().into_iter().map(|range| tape.input(range));
    let others: Vec<_> = others.collect();
    let made = P::run(&others, complements(&tape, small, first));
    tape.error(&[(made, Range::only(1.0))])
}

/// What Gappa proves of it.
fn by_gappa<P: Program>(small: Range, first: bool, flawed: bool) -> f64 {
    let script = Script::new(flawed);
    let others = P::others().into_iter().map(|range| script.input(range));
    let others: Vec<_> = others.collect();
    let written = P::run(&others, script.complements(small, first));
    script.bound(written).unwrap_or(f64::INFINITY)
}

/// Holds the bounds to each other, over ranges of the uniform; with a flaw, that of Gappa is far larger.
fn compare<P: Program>() {
    let mut most = [0.0; 3];
    let mut apart = Range::NONE;
    for small in parts_of(1.0 / 64.0, 0.5, 31) {
        for first in [true, false] {
            let recorded = recorded::<P>(small, first);
            let [gappa, flawed] = [false, true].map(|flaw| by_gappa::<P>(small, first, flaw));
            apart.take_all(&[gappa / recorded; 4]);
            for (most, bound) in most.iter_mut().zip([recorded, gappa, flawed]) {
                raise(most, bound);
            }
        }
    }
    let [recorded, gappa, flawed] = most;
    println!(
        "{}: {recorded:.4e} recorded, {gappa:.4e} by Gappa, {flawed:.4e} flawed, {apart:?}",
        P::NAME
    );
    assert!(
        apart.low >= 0.9 && apart.high <= P::NEAR,
        "{}: {apart:?}",
        P::NAME
    );
    assert!(flawed > 1.2 * gappa, "{}: {flawed:e} {gappa:e}", P::NAME);
}

/// Bounds are those of another prover, where it is installed; an ulp more in a constant is noticed by it.
#[test]
fn recorded_bounds_are_those_of_gappa() {
    let there = Command::new("gappa").arg("--version").output().is_ok();
    if !speed::full() || !there {
        eprintln!(
            "Gappa is not asked: installed: {there}, long tests: {}",
            speed::full()
        );
        return;
    }
    compare::<Weight>();
    compare::<Coordinate>();
    compare::<Sine>();
    compare::<Place>();
}
