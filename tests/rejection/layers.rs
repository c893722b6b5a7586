//! The layers of the ziggurats are those of an exact computation, and what is between them is decided by the curve. So numbers
//! have their law, the tails included; a ziggurat with any of the known flaws fails the very same checks.

use crate::curves::{CURVES, Curve, Geometry, LAYERS};
use host::errors::or_infinite;
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

/// A try of a ziggurat, or of one with a flaw.
type Try<'a> = &'a dyn Fn([u32; 3]) -> Option<f32>;

/// How many second words accept, which are the first ones.
fn accepting(first: u32, attempt: Try) -> u64 {
    first_without(0..1 << 32, |second| {
        attempt([first, second as u32, 0]).is_some()
    })
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
    for (curve, stated) in [
        (Curve::Normal, ZigguratStandardNormal::EFFICIENCY),
        (Curve::Exponential, ZigguratStandardExponential::EFFICIENCY),
    ] {
        let efficiency = curve.beyond(0.0) / (256.0 * curve.geometry().area);
        assert_eq!(stated, efficiency as f32);
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

/// How many numbers are not their place times the unit of their layer, rounded once; of the normal law on both sides, so that no
/// bit of the layer shows.
fn misplaced(curve: Curve, attempt: Try, words: u32) -> u32 {
    let mut rng = Pcg32::new(1, 1);
    let units: Vec<f32> = (0..LAYERS).map(|layer| unit(curve, layer)).collect();
    let wrong = (0..words).filter(|_| {
        let first = rng.next_u32();
        let layer = (first & 0xff) as usize;
        let place = match curve {
            Curve::Normal => i64::from(first as i32 >> 8) * 2 + 1,
            Curve::Exponential => i64::from(first >> 9) * 2 + 1,
        };
        let due = (place as f64 * f64::from(units[layer])) as f32;
        let got = attempt([first, 0, 0]);
        let tail = layer == 0 && f64::from(due.abs()) > curve.geometry_start();
        // The opposite place in the same layer.
        let opposite = attempt([first ^ 0xffff_ff00, 0, 0]).map(|x| -x);
        !tail && got != Some(due) || curve == Curve::Normal && opposite != got
    });
    wrong.count() as u32
}

#[test]
fn numbers_are_places_in_their_layers() {
    for curve in CURVES {
        let attempt = |words| attempt(curve, words);
        assert_eq!(misplaced(curve, &attempt, 1_000_000), 0);
        // Layer and place are read from the same end of the word.
        let shared = |[first, b, c]: [u32; 3]| attempt([first & !0xff | first >> 24, b, c]);
        assert!(misplaced(curve, &shared, 10_000) > 9_000);
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

/// The realised density at many places, by what is accepted there, against the curve: the largest error, the mean one, and how
/// many wedges were asked.
fn realised(curve: Curve, attempt: Try, places: u32) -> (f64, f64, u32) {
    let mut rng = Pcg32::new(2, 2);
    let Geometry { area, widths, .. } = curve.geometry();
    let units: Vec<f64> = (0..LAYERS)
        .map(|layer| f64::from(unit(curve, layer)))
        .collect();
    let (mut worst, mut mean, mut wedges) = (0.0_f64, 0.0, 0);
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
            let at = f64::from(place) * units[other];
            if other == 0 || at <= widths[other + 1] {
                // Accepted whatever the height, but for the steps that the test above grants.
                density += 1.0 / (units[other] * UNITS);
            } else {
                // The curve at the place itself, not at x.
                let accepted = accepting(word(curve, other, place), attempt);
                let chance = accepted as f64 / 4_294_967_296.0;
                let whole = curve.excess(widths[other], widths[other + 1]);
                let [due, here] = [at, x].map(|x| curve.excess(widths[other], x) / whole);
                density += (chance - due + here) / (units[other] * UNITS);
                wedges += 1;
            }
        }
        let error = density * area / curve.height(x) - 1.0;
        worst = worst.max(or_infinite(error.abs()));
        mean += error / f64::from(places);
    }
    (worst, mean, wedges)
}

#[test]
fn the_realised_density_is_the_curve() {
    for curve in CURVES {
        let attempt = |words| attempt(curve, words);
        let places = speed::of("places of each curve", 4_000, 40_000);
        let (worst, mean, wedges) = realised(curve, &attempt, places);
        println!("{curve:?}: {worst:.2e} at most, {mean:.1e} on average, {wedges} wedges");
        assert!(4 * wedges > 3 * places);
        assert!(worst <= 7e-7, "{curve:?}: {worst}");
        assert!(mean.abs() <= 3e-8, "{curve:?}: {mean}");
        // What lies beyond the inner part is handed out, or never.
        let no_wedge = |[first, _, c]: [u32; 3]| attempt([first, 0, c]);
        let inner_alone = |[first, _, c]: [u32; 3]| attempt([first, u32::MAX, c]);
        for flaw in [&no_wedge as Try, &inner_alone] {
            let (worst, mean, _) = realised(curve, flaw, 200);
            assert!(worst > 1e-3 && mean.abs() > 1e-3, "{worst} {mean}");
        }
    }
}

/// How far numbers of the tail are off its law; infinitely where there are none.
fn tail_off(curve: Curve, attempt: Try, words: u32) -> f64 {
    let (mut rng, start) = (Pcg32::new(3, 3), curve.geometry().start);
    let errors = (0..words).map(|k| {
        let (high, low) = (rng.next_u32() >> (k % 32), rng.next_u32());
        // Of 64 bits, less those that an f32 has no room for.
        let u = microwarp::uniform::full_from_words(high, low);
        assert!(u > 0.0);
        let x = attempt([word(curve, 0, (1 << 24) - 1), high, low]);
        let exact = inverse_tail(curve, start, f64::from(u));
        x.map_or(f64::INFINITY, |x| (f64::from(x) / exact - 1.0).abs())
    });
    errors.map(or_infinite).fold(0.0, f64::max)
}

/// The chance of the tail, which is a number of words, and the law in it.
#[test]
fn tails_have_their_mass_and_their_law() {
    for curve in CURVES {
        let attempt = |words| attempt(curve, words);
        let Geometry { start, area, .. } = curve.geometry();
        let first = first_place(|place| {
            let tries = [0, u32::MAX].map(|w| attempt([word(curve, 0, place), w, 1]));
            tries[0] != tries[1]
        });
        let places = (UNITS - f64::from(first - 1)) / UNITS;
        let off = places * area / curve.beyond(start) - 1.0;
        println!("{curve:?}: the tail's mass is off by {off:.1e}");
        assert!(off.abs() <= 1e-6, "{off}");
        let words = speed::of("words of each tail", 20_000, 200_000);
        let worst = tail_off(curve, &attempt, words);
        println!("{curve:?}: numbers of the tail are off by {worst:.1e}");
        assert!(worst <= 3e-7, "{worst}");
        // A tail that falls less steeply, and none.
        let begin = start as f32;
        let flat = |words| attempt(words).map(|x| begin + (x - begin) / 0.999);
        let none = |words| attempt(words).filter(|x| *x <= begin);
        assert!(tail_off(curve, &flat, 100) > 1e-4);
        assert_eq!(tail_off(curve, &none, 100), f64::INFINITY);
        // The farthest there are.
        let at = |[high, low]: [u32; 2]| {
            let place = word(curve, 0, (1 << 24) - 1);
            f64::from(attempt([place, high, low]).unwrap())
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
