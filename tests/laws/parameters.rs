//! Bad parameters get a typed error from the constructor, and nothing is built; the extremes that are accepted are total.

use host::registry::{Registered, of_libm, of_poly, registered};
use microwarp::uniform::{MAX_STRATA, Strata1d, Strata2d};
use microwarp::{Error, Warp as _, libm, poly};
use rand_core::Rng;
use rand_pcg::Pcg32;

#[test]
fn impossible_parameters_are_refused_by_name() {
    let mut refusals = 0;
    for of in registered() {
        for (parameters, error) in &of.refused {
            let found = (of.build)(parameters).err();
            assert_eq!(
                found,
                Some(*error),
                "{} {} {parameters:?}",
                of.name,
                of.constructor
            );
            refusals += 1;
        }
    }
    println!("{refusals} refusals of both tiers");
    // A constructor that takes numbers refuses some, all but those of ranges within another one's.
    let silent: Vec<_> = registered()
        .iter()
        .filter(|of| !of.takes.is_empty() && !of.cases.is_empty() && of.refused.is_empty())
        .map(|of| format!("{} {}", of.name, of.constructor))
        .collect();
    assert!(silent.is_empty(), "{silent:?} refuse nothing");
}

/// Numbers that are bad or special at many places; drawn for all places, they coincide often.
const DRAWN: [f32; 12] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    3.0,
    1.0e-45,
    1.0e-30,
    1.0e30,
    f32::MAX,
    f32::NAN,
    f32::NEG_INFINITY,
];

/// What NaN and infinities at each number of a constructor are not refused for by the place of their parameter, and how many there
/// are. Tables name the weight.
fn misplaced(of: &Registered) -> (Vec<String>, usize) {
    let (mut wrong, mut tried) = (Vec::new(), 0);
    if of.name.starts_with("Piecewise") || ["LatLongMap", "Mesh"].contains(&of.name) {
        return (wrong, tried);
    }
    let accepted = of.cases.iter().map(|(_, numbers, _)| numbers);
    for numbers in accepted.chain(&of.seeds) {
        for number in 0..numbers.len() {
            let due = Some(Error::NotFinite(of.parameter(number)));
            for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
                let mut numbers = numbers.clone();
                numbers[number] = bad;
                let found = (of.build)(&numbers).err();
                if found != due || found.and_then(Error::parameter) != Some(of.parameter(number)) {
                    let (name, constructor) = (of.name, of.constructor);
                    wrong.push(format!("{name} {constructor} {numbers:?}: {found:?}"));
                }
                tried += 1;
            }
        }
    }
    (wrong, tried)
}

/// NaN and infinity are refused at every place of every constructor, by the place of the parameter to which the number belongs.
#[test]
fn numbers_that_are_not_finite_are_refused_by_their_place() {
    let mut tried = 0;
    for of in registered() {
        let (wrong, more) = misplaced(&of);
        assert!(wrong.is_empty(), "{wrong:#?}");
        tried += more;
    }
    println!("{tried} bad numbers at their places");
    assert!(tried > 1000);
    // A constructor that hands its parameters on in another order and does not say so.
    let exchanged = |p: &[f32]| (of_poly()[0].build)(&[p[1], p[0]]);
    let wrong = Registered::new("Interval", "exchanged", of_poly()[0].takes, exchanged);
    let wrong = Registered {
        seeds: vec![vec![1.0, 0.0]],
        ..wrong
    };
    assert_eq!(misplaced(&wrong).0.len(), 6);
    // One whose numbers are not grouped as its parameters are.
    for mut of in of_poly() {
        if of
            .parameters
            .iter()
            .zip(0..)
            .any(|(&place, own)| place != own)
        {
            of.parameters = &[];
            let (wrong, tried) = misplaced(&of);
            assert!(tried == 0 || !wrong.is_empty(), "{}", of.name);
        }
    }
}

/// Both tiers refuse the same for the same reason. What they accept is total.
#[test]
fn both_tiers_refuse_the_same_numbers() {
    let mut drawn = 0;
    let mut rng = Pcg32::new(7, 3);
    for (libm, poly) in of_libm().iter().zip(&of_poly()) {
        let verdicts = |numbers: &[f32]| {
            let verdict = |of: &Registered| (of.build)(numbers).map(|e| e.warp.sample([0.5; 4]));
            let (one, other) = (verdict(libm), verdict(poly));
            let label = format!("{} {} {numbers:?}", libm.name, libm.constructor);
            assert_eq!(one.as_ref().err(), other.as_ref().err(), "{label}");
            for point in [one, other].into_iter().flatten() {
                assert!(point.iter().all(|x| x.is_finite()), "{label}: {point:?}");
            }
        };
        for _ in 0..if libm.takes.is_empty() { 0 } else { 2_000 } {
            let any = |_| DRAWN[(rng.next_u32() % 12) as usize];
            verdicts(&(0..libm.takes.len()).map(any).collect::<Vec<_>>());
            drawn += 1;
        }
    }
    println!("{drawn} drawn");
    assert!(drawn > 50_000);
}

/// What is no warp.
#[test]
fn impossible_parts_are_refused_by_name() {
    macro_rules! refused {
        ($($name:ident :: $constructor:ident ( $($argument:expr),* ) => $error:expr;)*) => {$(
            assert_eq!(libm::$name::$constructor($($argument),*).err(), Some($error));
            assert_eq!(poly::$name::$constructor($($argument),*).err(), Some($error));
        )*};
    }
    refused! {
        Spherical::from_turns(-1.0, 0.1, 0.0) => Error::Negative(0);
        Spherical::from_turns(1.0, 0.6, 0.0) => Error::OutOfRange(1);
        Spherical::from_turns(1.0, 0.1, f32::INFINITY) => Error::NotFinite(2);
        Frame::new([0.0, 0.0, 0.0]) => Error::ZeroLength(0);
        Frame::new([0.0, f32::NAN, 0.0]) => Error::NotFinite(0);
    }
    assert_eq!(Strata1d::new(0), Err(Error::Empty(0)));
    assert_eq!(Strata1d::new(MAX_STRATA + 1), Err(Error::TooLarge(0)));
    assert_eq!(Strata2d::new(0, 3), Err(Error::Empty(0)));
    assert_eq!(
        Strata2d::new(MAX_STRATA, MAX_STRATA),
        Err(Error::TooLarge(1))
    );
}

const EDGE: [f32; 4] = [0.0, 1.0e-45, 0.5, 0.999_999_94];

/// Parameters at the very edge of what is accepted still give finite samples of finite density.
#[test]
fn accepted_extremes_are_total() {
    for of in registered() {
        for parameters in &of.seeds {
            let label = format!("{} {} {parameters:?}", of.name, of.constructor);
            let entry = of.of_drawn(parameters);
            let entry = entry.unwrap_or_else(|error| panic!("{label}: {error:?}"));
            for u in EDGE {
                let x = entry.warp.sample([u; 4]);
                let pdf = entry.warp.pdf(x);
                let finite = x.iter().all(|c| c.is_finite());
                assert!(
                    finite && pdf > 0.0 && pdf <= f32::MAX,
                    "{label} at {u}: {x:?}, {pdf}"
                );
            }
        }
    }
    // The product of a quotient and its divisor may be rounded beyond the largest float.
    for start in (0..1000_u16).map(|i| 1.0 + f32::from(i) * 0.001_7) {
        let warp = poly::Power::new(-1.0, start, f32::MAX).unwrap();
        for u in EDGE {
            let x = warp.sample(u);
            let pdf = warp.pdf(x);
            assert!(
                x.is_finite() && pdf > 0.0 && pdf <= f32::MAX,
                "power from {start} to the largest float at {u}: {x}, {pdf}"
            );
        }
    }
}
