//! Host time in nanoseconds per point of every warp in both tiers, next to the generator alone.
//!
//! `cargo bench --bench warps`. Each figure is for 1,024 points with PCG32, drawn one by one or filled, or mapped from
//! uniforms in memory, so that calls and clocks do not show; compare figures of one run only.
//!
//! `cargo bench --bench warps -- poly::map copied` shows `map` and what copying slices of the same types takes; with
//! `RUSTFLAGS="-C target-cpu=x86-64-v3"` on vectors of eight.

use divan::{Bencher, black_box};
use microwarp::uniform::{self, Uniforms};
use microwarp::{Error, Warp};
use microwarp_list::float_warps;
use rand_pcg::Pcg32;
use std::array;
use std::fmt::{self, Display, Formatter};

const POINTS: usize = 1_024;

fn main() {
    divan::main();
}

fn repeat<W: Warp>(bencher: Bencher, warp: &W, action: impl Fn(&W, &mut Pcg32, &mut [W::Point])) {
    let mut rng = Pcg32::new(1, 1);
    let mut points = vec![warp.draw(&mut rng); POINTS];
    bencher
        .counter(divan::counter::ItemsCount::new(POINTS))
        .bench_local(|| action(black_box(warp), &mut rng, black_box(&mut points)));
}

fn draw<W: Warp>(bencher: Bencher, warp: &W) {
    repeat(bencher, warp, |warp, rng, points| {
        for point in points {
            *point = warp.draw(rng);
        }
    });
}

/// The constructor as well for every point, as for a light that is seen from another point each time.
fn anew<W: Warp>(bencher: Bencher, make: impl Fn() -> W) {
    repeat(bencher, &make(), |_, rng, points| {
        for point in points {
            *point = make().draw(rng);
        }
    });
}

/// Whether a kernel is of that kind; it is drawn only, since nothing is finished that could fill or map.
fn is_anew(name: &str) -> bool {
    name.ends_with("_anew")
}

fn fill<W: Warp>(bencher: Bencher, warp: &W) {
    repeat(bencher, warp, |warp, rng, points| warp.fill(rng, points));
}

/// From uniforms in memory.
fn map<W: Warp<Uniforms: Random>>(bencher: Bencher, warp: &W) {
    let uniforms = random();
    let mut points = vec![warp.draw(&mut Pcg32::new(1, 1)); POINTS];
    bencher
        .counter(divan::counter::ItemsCount::new(POINTS))
        .bench_local(|| black_box(warp).map(black_box(&uniforms), black_box(&mut points)));
}

/// Uniforms of the grid.
trait Random: Uniforms {
    fn random(rng: &mut Pcg32) -> Self;
}

impl<U: Uniforms> Random for U {
    fn random(rng: &mut Pcg32) -> Self {
        let Ok(u) = Self::try_draw(rng);
        u.get()
    }
}

fn random<U: Random>() -> Vec<U> {
    let mut rng = Pcg32::new(1, 1);
    (0..POINTS).map(|_| U::random(&mut rng)).collect()
}

/// The floor: two words of the generator as uniforms, not used any further.
#[divan::bench]
fn a_floor_of_two_uniforms(bencher: Bencher) {
    let mut rng = Pcg32::new(1, 1);
    let mut points = vec![[0.0; 2]; POINTS];
    bencher
        .counter(divan::counter::ItemsCount::new(POINTS))
        .bench_local(|| {
            for point in black_box(&mut points) {
                *point = [uniform::grid(&mut rng), uniform::grid(&mut rng)];
            }
        });
}

/// The floor of `map`: uniforms are read, and points of so many dimensions are written.
#[divan::bench(consts = [2, 3])]
fn a_floor_of_copied_pairs<const D: usize>(bencher: Bencher) {
    copied(bencher, |&[a, b]: &[f32; 2]| {
        array::from_fn::<f32, D, _>(|i| if i == 1 { b } else { a })
    });
}

/// The same on the line.
#[divan::bench]
fn a_floor_of_copied_numbers(bencher: Bencher) {
    copied(bencher, |&u: &f32| u);
}

fn copied<U: Random, P: Copy>(bencher: Bencher, point: impl Fn(&U) -> P) {
    let uniforms = random::<U>();
    let mut points: Vec<P> = uniforms.iter().map(&point).collect();
    bencher
        .counter(divan::counter::ItemsCount::new(POINTS))
        .bench_local(|| {
            let uniforms = black_box(&uniforms);
            for (to, u) in black_box(&mut points).iter_mut().zip(uniforms) {
                *to = point(u);
            }
        });
}

/// A warp of the list, under the name of its cost kernel.
struct Timed {
    name: &'static str,
    draw: fn(Bencher),
    fill: fn(Bencher),
    map: fn(Bencher),
}

impl Display for Timed {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        f.write_str(self.name)
    }
}

/// Those that are made once.
fn finished(warps: &'static [Timed]) -> impl Iterator<Item = &'static Timed> {
    warps.iter().filter(|warp| !is_anew(warp.name))
}

/// Unwraps an accepted parameter.
const fn ok<W: Copy>(warp: Result<W, Error>) -> W {
    match warp {
        Ok(warp) => warp,
        Err(_) => panic!("refused"),
    }
}

/// A warp whose constructor is not a `const fn`.
fn stored<W>(make: impl FnOnce() -> Result<W, Error>) -> W {
    make().unwrap()
}

/// Every warp that has a cost kernel, in a tier.
macro_rules! benches {
    (($tier:ident) $($type:ident {
        golden $golden:tt
        cost { $($name:literal $u:tt -> $out:ty = $warp:expr,)* $(none $reason:literal)? }
        bind $bind:tt
    })*) => {
        mod $tier {
            use super::{Bencher, Timed, finished, ok, stored};
            use ::microwarp::$tier::*;

            const WARPS: &[Timed] = &[$($(Timed {
                name: $name,
                draw: |bencher| match super::is_anew($name) {
                    true => super::anew(bencher, || $warp),
                    false => super::draw(bencher, &$warp),
                },
                fill: |bencher| super::fill(bencher, &$warp),
                map: |bencher| super::map(bencher, &$warp),
            },)*)*];

            #[divan::bench(args = WARPS)]
            fn draw(bencher: Bencher, warp: &Timed) {
                (warp.draw)(bencher);
            }

            #[divan::bench(args = finished(WARPS))]
            fn fill(bencher: Bencher, warp: &Timed) {
                (warp.fill)(bencher);
            }

            #[divan::bench(args = finished(WARPS))]
            fn map(bencher: Bencher, warp: &Timed) {
                (warp.map)(bencher);
            }
        }
    };
}

float_warps!(benches(libm));
float_warps!(benches(poly));
