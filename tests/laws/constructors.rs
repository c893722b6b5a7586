//! Constructors in constants, the parameters that getters give back, and the numbers of errors.

use host::registry::{Registered, of_poly, registered};
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::warp::{
    Aabb, Annulus, Cone, Exponential, ExponentialTail, FrustumSurface, HenyeyGreenstein, Interval,
    Linear, Normal, Power, Spherical, SphericalPatch, Tent, TriangleOn, TruncatedExponential,
    TruncatedNormal,
};
use microwarp::{Error, constant};
use std::collections::BTreeSet;
use std::hint::black_box;

/// Every reason, and its number. A number that is in use is never given to another reason.
const CODES: [(Error, u16); 16] = [
    (Error::NotFinite(1), 1),
    (Error::Reversed(1), 2),
    (Error::Empty(1), 3),
    (Error::TooLarge(1), 4),
    (Error::NotPositive(1), 5),
    (Error::Negative(1), 6),
    (Error::OutOfRange(1), 7),
    (Error::NotNormalizable(1), 8),
    (Error::ZeroLength(1), 9),
    (Error::NoWeights, 10),
    (Error::TooManyWeights, 11),
    (Error::NotFiniteWeight(3), 12),
    (Error::NegativeWeight(3), 13),
    (Error::AllZero, 14),
    (Error::Unreachable(3), 15),
    (Error::NotATable, 16),
];

#[test]
fn the_numbers_of_errors_never_change() {
    let mut messages = BTreeSet::new();
    for (error, code) in CODES {
        assert_eq!(error.code(), code, "{error:?}");
        let (of_weight, of_parameter) = (matches!(code, 12 | 13 | 15), code < 10);
        assert_eq!(error.index(), of_weight.then_some(3), "{error:?}");
        assert_eq!(error.parameter(), of_parameter.then_some(1), "{error:?}");
        let text = error.to_string();
        assert_eq!(text.contains('3'), of_weight, "{text}");
        let named = text.starts_with("the second parameter ");
        assert_eq!(named, of_parameter, "{text}");
        let plain = !of_weight && !of_parameter;
        assert_eq!(text == error.message(), plain, "{text}");
        messages.insert(error.message());
    }
    assert_eq!(messages.len(), CODES.len(), "two reasons read alike");
    // Every reason that the enum declares stands in the table.
    let source = include_str!("../../src/error.rs");
    let (_, body) = source.split_once("pub enum Error {").unwrap();
    let (body, _) = body.split_once("\n}").unwrap();
    let reasons = body.lines().map(str::trim);
    let reasons = reasons.filter(|line| !line.starts_with("//") && line.ends_with(','));
    assert_eq!(reasons.count(), CODES.len());
}

/// Words for as many parameters as any constructor has; the message alone where the reason lies in no single one.
#[test]
fn places_are_told_in_words() {
    let words = ["first", "second", "third", "fourth", "fifth", "sixth"];
    for (place, word) in words.into_iter().enumerate() {
        let text = Error::NotPositive(place).to_string();
        assert_eq!(text, format!("the {word} parameter must be positive"));
    }
    let of: [fn(usize) -> Error; 9] = [
        Error::NotFinite,
        Error::Reversed,
        Error::Empty,
        Error::TooLarge,
        Error::NotPositive,
        Error::Negative,
        Error::OutOfRange,
        Error::NotNormalizable,
        Error::ZeroLength,
    ];
    for make in of {
        let all = make(Error::NO_PLACE);
        assert_eq!(all.parameter(), None, "{all:?}");
        assert_eq!(all.to_string(), all.message());
        assert_eq!(make(254).to_string(), all.message());
        assert_eq!(make(254).parameter(), Some(254));
        assert_eq!(make(0).code(), all.code());
    }
    let most = registered().iter().flat_map(|of| of.parameters).max();
    assert!(*most.unwrap() < words.len());
}

#[test]
fn a_constant_has_the_bits_of_what_is_made_at_run_time() {
    let mut seen = 0;
    for of in registered() {
        for [at_run_time, constant] in &of.constants {
            assert!(at_run_time.starts_with("Ok("), "{}: {at_run_time}", of.name);
            assert_eq!(at_run_time, constant, "{}", of.name);
            seen += 1;
        }
    }
    assert!(seen > 60, "{seen}");
    // In a constant, in a static and in place.
    const NOISE: Normal<Poly> = constant!(Normal::new(10.0, 2.0));
    static BOX: Aabb<2> = constant!(Aabb::new([0.0; 2], [1.0, 2.0]));
    let tent = constant!(Tent::new(2.0));
    assert_eq!(Ok(NOISE), Normal::new(black_box(10.0), 2.0));
    assert_eq!(Ok(BOX), Aabb::new([black_box(0.0); 2], [1.0, 2.0]));
    assert_eq!(Ok(tent), Tent::new(black_box(2.0)));
    const BY_LIBM: Spherical<Libm> = constant!(Spherical::from_turns(1.0, 0.1, 0.3));
    assert_eq!(Ok(BY_LIBM), Spherical::from_turns(1.0, black_box(0.1), 0.3));
    const BY_POLY: Spherical<Poly> = constant!(Spherical::from_turns(1.0, 0.1, 0.3));
    assert_eq!(Ok(BY_POLY), Spherical::from_turns(1.0, black_box(0.1), 0.3));
}

/// Of every case and every hard set of parameters.
#[test]
fn getters_give_back_what_was_given() {
    let mut seen = 0;
    for of in registered() {
        let Some(getters) = of.given_back else {
            continue;
        };
        let before = seen;
        let cases = of.cases.iter().map(|(_, parameters, _)| parameters);
        for given in cases.chain(&of.seeds) {
            assert_eq!(getters(given).as_deref(), Ok(&**given), "{}", of.name);
            seen += 1;
        }
        assert!(seen > before, "{}: nothing is given", of.name);
    }
    assert!(seen > 200, "{seen}");
}

/// What is made of others has their parameters, and tables have theirs in `tests/tables`.
const MADE_OF_OTHERS: [&str; 10] = [
    "Composed",
    "Each",
    "LatLongMap",
    "Mesh",
    "Mixture",
    "Oriented",
    "PiecewiseConstant1d",
    "PiecewiseConstant2d",
    "PiecewiseLinear1d",
    "Product",
];

/// What the blocks of one struct leave out and do not account for: `picture`, `control`, `moment`, `peer`, `refusal`,
/// `constant`, `getters`.
fn lacks(blocks: &[&Registered]) -> Vec<&'static str> {
    let entries: Vec<_> = blocks.iter().flat_map(|of| of.entries()).collect();
    let given = |what| match what {
        "picture" => entries.iter().any(|entry| entry.picture.is_some()),
        "control" => blocks.iter().any(|of| !of.controls.is_empty()),
        "moment" => blocks.iter().any(|of| !of.moments.is_empty()),
        "peer" => blocks.iter().any(|of| !of.peers.is_empty()),
        "refusal" => blocks.iter().any(|of| !of.refused.is_empty()),
        "constant" => blocks.iter().any(|of| !of.constants.is_empty()),
        _ => blocks.iter().any(|of| of.given_back.is_some()),
    };
    // Without parameters nothing is refused, nothing can differ, and nothing is given back.
    let takes = blocks.iter().any(|of| !of.takes.is_empty());
    let takes = takes && !MADE_OF_OTHERS.contains(&blocks[0].name);
    let mut due = vec!["picture", "control"];
    // Of draws that read more of a word than the grid does, as those of the laws do that rand_distr may have.
    if entries.iter().any(|entry| entry.deep) {
        due.extend(["moment", "peer"]);
    }
    if takes {
        due.extend(["refusal", "constant", "getters"]);
    }
    let accounted = |what: &&'static str| {
        let mut without = blocks.iter().flat_map(|of| &of.without);
        without.any(|(left_out, why)| left_out == what && !why.is_empty())
    };
    for what in due.iter().copied().filter(|what| accounted(what)) {
        assert!(
            !given(what),
            "{}: {what} is accounted for, and given",
            blocks[0].name
        );
    }
    due.retain(|what| !given(what) && !accounted(what));
    due
}

#[test]
fn the_blocks_of_every_struct_have_all_that_is_known_of_it() {
    let all = of_poly();
    let names: BTreeSet<&str> = all.iter().map(|of| of.name).collect();
    let of = |name: &str| -> Vec<&Registered> { all.iter().filter(|of| of.name == name).collect() };
    let lacking = names.into_iter().filter_map(|name| {
        let lacks = lacks(&of(name));
        (!lacks.is_empty()).then_some((name, lacks))
    });
    let lacking: Vec<_> = lacking.collect();
    assert!(lacking.is_empty(), "{lacking:#?}");
    assert!(MADE_OF_OTHERS.iter().all(|name| !of(name).is_empty()));
    // What is left out is noticed.
    let gumbel = all.iter().find(|of| of.name == "Gumbel").unwrap();
    let bare = |change: fn(&mut Registered)| {
        let mut all = of_poly();
        let bare = all.iter_mut().find(|of| of.name == gumbel.name).unwrap();
        change(bare);
        lacks(&[bare])
    };
    assert_eq!(bare(|of| of.cases.clear()), ["picture"]);
    assert_eq!(bare(|of| of.controls.clear()), ["control"]);
    assert_eq!(bare(|of| of.moments.clear()), ["moment"]);
    assert_eq!(bare(|of| of.peers.clear()), ["peer"]);
    assert_eq!(bare(|of| of.refused.clear()), ["refusal"]);
    assert_eq!(bare(|of| of.constants.clear()), ["constant"]);
    assert_eq!(bare(|of| of.given_back = None), ["getters"]);
    let silent = |of: &mut Registered| {
        of.given_back = None;
        of.without.push(("getters", ""));
    };
    assert_eq!(bare(silent), ["getters"]);
    assert!(bare(|_| {}).is_empty());
}

#[test]
fn getters_of_other_constructors_give_their_parameters_back() {
    fn of_tier<T: Tier>() {
        let power = Power::<T>::decreasing(-2.5, 0.5, 7.0).unwrap();
        assert_eq!(
            (power.exponent(), power.low(), power.high()),
            (-2.5, 0.5, 7.0)
        );
        let from_zero = Power::<T>::new(2.5, 0.0, 1.0).unwrap();
        assert_eq!(from_zero.low(), microwarp::uniform::SMALLEST);
        assert_eq!(Power::<T>::new(0.0, 0.0, 1.0).unwrap().low(), 0.0);
        assert_eq!(
            HenyeyGreenstein::<T>::new(-0.25).unwrap().asymmetry(),
            -0.25
        );
        let needle = HenyeyGreenstein::<T>::from_one_plus_g(1e-9).unwrap();
        assert_eq!((needle.asymmetry(), needle.one_minus_abs_g()), (-1.0, 1e-9));
        let above = TruncatedNormal::<T>::above(0.3, 0.7, 0.1).unwrap();
        assert_eq!((above.low(), above.high()), (0.1, f32::INFINITY));
        let below = TruncatedNormal::<T>::below(0.3, 0.7, 0.1).unwrap();
        assert_eq!((below.low(), below.high()), (f32::NEG_INFINITY, 0.1));
        let patch = SphericalPatch::<T>::from_turns(0.125, 0.25, -0.25, 0.5).unwrap();
        assert_eq!(patch.theta_turns(), [0.125, 0.25]);
        assert_eq!(patch.phi_turns(), [-0.25, 0.5]);
        // Their sum and difference are not of f32.
        for phi in [[0.1, 0.7], [-0.3, 0.1], [0.9, 1.3], [-1e-9, 0.7]] {
            let patch = SphericalPatch::<T>::from_turns(0.0, 0.25, phi[0], phi[1]);
            assert_eq!(patch.unwrap().phi_turns(), phi);
        }
        for radii in [[0.3, 0.7], [0.0, 3.3], [1e-45, 1e-18], [1e-35, 1e18]] {
            let sector = Annulus::<T>::sector(radii[0], radii[1], -0.3, 0.1).unwrap();
            assert_eq!([sector.inner(), sector.outer()], radii);
            assert_eq!(sector.phi_turns(), [-0.3, 0.1]);
            let tube = FrustumSurface::<T>::tube(radii, 0.3).unwrap();
            assert_eq!((tube.radii(), tube.height()), (radii, 0.3));
        }
        assert_eq!(
            Cone::<T>::from_one_minus_cos(0.3).unwrap().one_minus_cos(),
            0.3
        );
    }
    of_tier::<Libm>();
    of_tier::<Poly>();
    for (low, high) in [(-3.0, 5.0), (0.1, 0.7), (-7.0, -0.3), (-0.3, 0.0)] {
        let interval = Interval::decreasing(low, high).unwrap();
        assert_eq!((interval.low(), interval.high()), (low, high));
    }
    let room = Aabb::new([0.1, -3.0], [0.7, -1.0]).unwrap();
    assert_eq!((room.low(), room.high()), ([0.1, -3.0], [0.7, -1.0]));
    assert_eq!(Linear::new(1.0, 3.0).unwrap().ends(), [0.5, 1.5]);
    assert_eq!(Linear::new(0.0, 0.3).unwrap().ends(), [0.0, 2.0]);
    for vertices in [
        [[0.1, 0.7], [4.0, -0.3], [0.3, 2.0]],
        [[1e6 + 0.5, 0.1], [1e6 + 1.0, 0.3], [1e6 + 7.0, 0.2]],
    ] {
        assert_eq!(TriangleOn::new(vertices).unwrap().vertices(), vertices);
    }
}

#[test]
fn a_mean_is_the_rate_that_is_its_reciprocal() {
    fn of_tier<T: Tier>() {
        for mean in [3e-39, 1e-30, 0.3, 1.0, 250.0, 3.2e36] {
            let rate = 1.0 / mean;
            let (by_mean, by_rate) = (
                Exponential::<T>::from_mean(mean),
                Exponential::from_rate(rate),
            );
            assert!(by_mean.is_ok(), "{mean}");
            assert_eq!(by_mean, by_rate);
            assert_eq!(by_mean.unwrap().rate(), rate);
            assert_eq!(by_mean.unwrap().mean(), 1.0 / rate);
            let tail = ExponentialTail::<T>::from_mean(mean);
            assert!(tail.is_ok(), "{mean}");
            assert_eq!(tail, ExponentialTail::from_rate(rate));
            assert_eq!(
                (tail.unwrap().rate(), tail.unwrap().mean()),
                (rate, 1.0 / rate)
            );
            let segment = TruncatedExponential::<T>::from_mean(mean, 1.0);
            assert!(segment.is_ok(), "{mean}");
            assert_eq!(segment, TruncatedExponential::from_rate(rate, 1.0));
        }
        let refused = [
            (f32::NAN, Error::NotFinite(0)),
            (f32::INFINITY, Error::NotFinite(0)),
            (0.0, Error::NotPositive(0)),
            (-1.0, Error::NotPositive(0)),
            (2.9e-39, Error::Empty(0)),
            (3.3e36, Error::TooLarge(0)),
        ];
        for (mean, error) in refused {
            assert_eq!(
                Exponential::<T>::from_mean(mean).err(),
                Some(error),
                "{mean}"
            );
            assert_eq!(
                ExponentialTail::<T>::from_mean(mean).err(),
                Some(error),
                "{mean}"
            );
            let truncated = TruncatedExponential::<T>::from_mean(mean, 1.0).err();
            // An interval ends the tail, which cannot overflow then.
            let due = Some(error).filter(|error| *error != Error::TooLarge(0));
            assert_eq!(truncated, due, "{mean}");
        }
        let mean = TruncatedExponential::<T>::from_mean;
        assert_eq!(mean(1.0, 0.0).err(), Some(Error::NotPositive(1)));
        assert_eq!(mean(1e-45, f32::NAN).err(), Some(Error::NotFinite(1)));
        assert_eq!(mean(1.0, 1e-45).err(), Some(Error::Empty(1)));
    }
    of_tier::<Libm>();
    of_tier::<Poly>();
}
