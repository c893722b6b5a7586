//! The layers of the ziggurats are those of an exact computation, and what is between them is decided by the curve.

use crate::curves::{CURVES, Curve, Geometry, LAYERS};
use host::speed;
use host::words::first_without;
use microwarp::rejection::{ZigguratStandardExponential, ZigguratStandardNormal};
use rand_core::Rng;
use rand_pcg::Pcg32;

/// 2²⁴, the width of a layer in units of its grid.
const UNITS: f64 = 16_777_216.0;

/// A try of a standard ziggurat.
pub fn attempt(curve: Curve, words: [u32; 3]) -> Option<f32> {
    match curve {
        Curve::Normal => ZigguratStandardNormal::new().attempt(words),
        Curve::Exponential => ZigguratStandardExponential::new().attempt(words),
    }
}

/// The word of a layer and of a place in it, an odd number below 2²⁴ and positive.
pub fn word(curve: Curve, layer: usize, place: u32) -> u32 {
    assert!(place % 2 == 1 && place < 1 << 24 && layer < LAYERS);
    let place = match curve {
        // After a sign.
        Curve::Normal => place >> 1 << 8,
        Curve::Exponential => place >> 1 << 9,
    };
    place | layer as u32
}

/// The unit of a layer's grid, from its smallest number.
pub fn unit(curve: Curve, layer: usize) -> f32 {
    attempt(curve, [word(curve, layer, 1), 0, 0]).unwrap()
}

/// How many second words accept, which are the first ones.
fn accepting(curve: Curve, layer: usize, place: u32) -> u64 {
    let accepts =
        |second: u64| attempt(curve, [word(curve, layer, place), second as u32, 0]).is_some();
    first_without(0..1 << 32, accepts)
}

/// The first place of a layer at which something holds that holds from there on.
fn first_place(holds: impl Fn(u32) -> bool) -> u32 {
    2 * first_without(0..1 << 23, |half| !holds(2 * half as u32 + 1)) as u32 + 1
}

/// A number in the source of a law.
fn constant(curve: Curve, name: &str) -> f64 {
    let text = match curve {
        Curve::Normal => include_str!("../../src/rejection/ziggurat/normal.rs"),
        Curve::Exponential => include_str!("../../src/rejection/ziggurat/exponential.rs"),
    };
    let (_, value) = text.split_once(&format!("const {name}: ")).unwrap();
    let (_, value) = value.split_once("= ").unwrap();
    let (value, _) = value.split_once(';').unwrap();
    value.replace('_', "").parse().unwrap()
}

#[test]
fn the_constants_of_the_sources_are_derived() {
    for curve in CURVES {
        let Geometry { start, area, .. } = curve.geometry();
        for (name, value) in [("START", start), ("AREA", area)] {
            let stated = constant(curve, name);
            assert!((stated / value - 1.0).abs() <= 1e-14, "{name}: {value}");
        }
    }
    let beyond = Curve::Normal.cdf(-Curve::Normal.geometry().start) as f32;
    assert_eq!(constant(Curve::Normal, "BEYOND") as f32, beyond);
}

#[test]
fn every_width_is_the_nearest_number_to_the_exact_one() {
    for curve in CURVES {
        let widths = curve.geometry().widths;
        let units: Vec<f32> = (0..LAYERS).map(|layer| unit(curve, layer)).collect();
        for (layer, unit) in units.iter().enumerate() {
            assert_eq!(*unit, (widths[layer] / UNITS) as f32, "{curve:?} {layer}");
        }
        assert!(units.windows(2).all(|pair| pair[0] > pair[1]));
    }
}

/// A number is its place times the unit, rounded once, on both sides for the normal law; no bit of the layer shows.
#[test]
fn numbers_are_places_in_their_layers() {
    let mut rng = Pcg32::new(1, 1);
    for curve in CURVES {
        let units: Vec<f32> = (0..LAYERS).map(|layer| unit(curve, layer)).collect();
        for _ in 0..1_000_000 {
            let first = rng.next_u32();
            let layer = (first & 0xff) as usize;
            let place = match curve {
                Curve::Normal => i64::from(first as i32 >> 8) * 2 + 1,
                Curve::Exponential => i64::from(first >> 9) * 2 + 1,
            };
            let due = (place as f64 * f64::from(units[layer])) as f32;
            let got = attempt(curve, [first, 0, 0]).unwrap();
            let tail = layer == 0 && f64::from(due.abs()) > curve.geometry_start();
            assert!(tail || got == due, "{first:x}: {got} for {due}");
            if curve == Curve::Normal {
                // The opposite place in the same layer.
                let opposite = attempt(curve, [first ^ 0xffff_ff00, 0, 0]).unwrap();
                assert_eq!(opposite, -got);
            }
        }
    }
}

impl Curve {
    fn geometry_start(self) -> f64 {
        constant(self, "START")
    }
}

/// Where a layer's inner part ends: there the largest second word begins to be rejected, or the tail begins.
#[test]
fn inner_parts_end_where_the_layer_above_does() {
    for curve in CURVES {
        let widths = curve.geometry().widths;
        for layer in 0..LAYERS {
            let exact = widths[layer + 1] / widths[layer] * UNITS;
            let end = first_place(|place| {
                let words = [word(curve, layer, place), u32::MAX, u32::MAX];
                match attempt(curve, words) {
                    // In the lowest layer other words give another number.
                    Some(x) if layer == 0 => attempt(curve, [words[0], 0, 1]) != Some(x),
                    other => other.is_none(),
                }
            });
            let late = f64::from(end) - exact;
            assert!(late >= -2.0, "{curve:?} {layer}: {late}");
            if layer == 0 {
                // To a step of the grid.
                assert!(late <= 2.0, "{curve:?}: {late}");
            } else {
                // A chance just below 1 counts as 1, for some steps, or for long where the curve is flat.
                let at = f64::from(end) / UNITS * widths[layer];
                let [curve_at, whole] =
                    [at, widths[layer + 1]].map(|x| curve.excess(widths[layer], x));
                let chance = curve_at / whole;
                assert!(
                    late <= 8.0 || chance >= 1.0 - 4e-7,
                    "{curve:?} {layer}: {late}, {chance}"
                );
            }
        }
    }
}

/// The realised density at many places, by what the code accepts there, against the curve.
#[test]
fn the_realised_density_is_the_curve() {
    let mut rng = Pcg32::new(2, 2);
    for curve in CURVES {
        let Geometry { area, widths, .. } = curve.geometry();
        let units: Vec<f64> = (0..LAYERS)
            .map(|layer| f64::from(unit(curve, layer)))
            .collect();
        let (mut worst, mut mean, mut wedges) = (0.0_f64, 0.0, 0);
        let places = speed::of("places of each curve", 4_000, 40_000);
        for k in 0..places {
            // A place in a layer, its wedge mostly; then all the layers that reach as far.
            let layer = 1 + (rng.next_u32() % 255) as usize;
            let share = f64::from(rng.next_u32()) / 4_294_967_296.0;
            let inner = if k % 8 == 0 { 0.0 } else { widths[layer + 1] };
            let x = inner + share * (widths[layer] - inner);
            let mut density = 0.0;
            for other in 0..LAYERS {
                let place = (x / units[other]) as u32 | 1;
                if f64::from(place) >= UNITS {
                    break;
                }
                let beyond = f64::from(place) * units[other] > widths[other + 1];
                if other == 0 || !beyond {
                    // Accepted whatever the height, but for the steps that the test above grants.
                    density += 1.0 / (units[other] * UNITS);
                } else {
                    // The curve at the place itself, not at x.
                    let at = f64::from(place) * units[other];
                    let chance = accepting(curve, other, place) as f64 / 4_294_967_296.0;
                    let due = curve.excess(widths[other], at)
                        / curve.excess(widths[other], widths[other + 1]);
                    let here = curve.excess(widths[other], x)
                        / curve.excess(widths[other], widths[other + 1]);
                    density += (chance - due + here) / (units[other] * UNITS);
                    wedges += 1;
                }
            }
            let error = density * area / curve.height(x) - 1.0;
            worst = worst.max(error.abs());
            mean += error / f64::from(places);
        }
        println!("{curve:?}: {worst:.2e} at most, {mean:.1e} on average, {wedges} wedges");
        assert!(4 * wedges > 3 * places);
        assert!(worst <= 7e-7, "{curve:?}: {worst}");
        assert!(mean.abs() <= 3e-8, "{curve:?}: {mean}");
    }
}

/// The chance of the tail, which is a number of words, and the law in it.
#[test]
fn tails_have_their_mass_and_their_law() {
    let mut rng = Pcg32::new(3, 3);
    for curve in CURVES {
        let Geometry { start, area, .. } = curve.geometry();
        let first = first_place(|place| {
            let tries = [0, u32::MAX].map(|w| attempt(curve, [word(curve, 0, place), w, 1]));
            tries[0] != tries[1]
        });
        let places = (UNITS - f64::from(first - 1)) / UNITS;
        let off = places * area / curve.beyond(start) - 1.0;
        println!("{curve:?}: the tail's mass is off by {off:.1e}");
        assert!(off.abs() <= 1e-6, "{off}");
        let mut worst = 0.0_f64;
        for k in 0..speed::of("words of each tail", 20_000, 200_000) {
            let (high, low) = (rng.next_u32() >> (k % 32), rng.next_u32());
            let x = attempt(curve, [word(curve, 0, (1 << 24) - 1), high, low]).unwrap();
            // Of 64 bits, less those that an f32 has no room for.
            let u = microwarp::uniform::full_from_words(high, low);
            assert!(u > 0.0);
            let exact = inverse_tail(curve, start, f64::from(u));
            worst = worst.max((f64::from(x) / exact - 1.0).abs());
        }
        println!("{curve:?}: numbers of the tail are off by {worst:.1e}");
        assert!(worst <= 3e-7, "{worst}");
        // The farthest there are.
        let at = |words: [u32; 2]| {
            let place = word(curve, 0, (1 << 24) - 1);
            f64::from(attempt(curve, [place, words[0], words[1]]).unwrap())
        };
        let (least, none) = (at([0, 1]), at([0, 0]));
        let stated = match curve {
            Curve::Normal => [10.01, 10.08],
            Curve::Exponential => [52.06, 52.76],
        };
        for (far, stated) in [least, none].into_iter().zip(stated) {
            assert!(far <= stated && far >= stated - 0.01, "{far}");
        }
    }
}

/// The place beyond which the share u of the tail lies, by bisection.
fn inverse_tail(curve: Curve, start: f64, u: f64) -> f64 {
    let (mut low, mut high) = (start, 80.0);
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        if curve.beyond(middle) > u * curve.beyond(start) {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}
