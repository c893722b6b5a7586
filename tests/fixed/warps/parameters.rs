//! Warps give back the parameters they were built with, and a rate builds the warp of the mean nearest to its reciprocal.

use fixed::types::extra::{LeEqU32, U0, U16, U31, U32};
use fixed::types::{I16F16, U0F32, U2F62, U16F16, U32F32};
use fixed::{FixedI32, FixedU32};
use microwarp::fixed::Fine;
use microwarp::fixed::warp::{
    Cone, Exponential, Interval, NormalPair, PhongLobe, Tent, TriangleOn, TruncatedExponential,
};
use microwarp::{Error, fixed as mw};
use rand_core::{Rng, SeedableRng};
use rand_pcg::Pcg32;

/// Rates of all magnitudes.
fn rates() -> impl Iterator<Item = u64> {
    let mut rng = Pcg32::seed_from_u64(15);
    let random = (0..100_000).map(move |_| rng.next_u64() >> (rng.next_u32() & 63));
    let edges = (0..64).flat_map(|bit| [(1_u64 << bit) - 1, 1 << bit, (1 << bit) + 1]);
    random.chain(edges).chain([u64::MAX])
}

/// The steps of the mean nearest to 1/rate, halves upwards, or why there is no such mean.
fn nearest_mean(rate: u64, fraction: u32) -> Result<u32, Error> {
    if rate == 0 {
        return Err(Error::NotPositive(0));
    }
    let wide = u128::from(rate);
    let steps = ((1_u128 << (32 + fraction)) + wide / 2) / wide;
    // Half a rate that is odd is cut, but then no quotient lies half way.
    match u32::try_from(steps) {
        _ if rate > 1 << 63 => Err(Error::Empty(0)),
        Ok(0) => Err(Error::Empty(0)),
        Ok(steps) => Ok(steps),
        Err(_) => Err(Error::TooLarge(0)),
    }
}

fn is_the_law_of_its_mean<Frac: LeEqU32 + core::fmt::Debug + PartialEq>() {
    let [mut built, mut refused] = [0; 2];
    for rate in rates() {
        let due = nearest_mean(rate, Frac::U32).map(FixedU32::<Frac>::from_bits);
        let rate = U32F32::from_bits(rate);
        let warp = Exponential::<Frac, Fine>::from_rate(rate);
        assert_eq!(warp, due.and_then(Exponential::from_mean), "{rate}");
        let length = FixedU32::from_bits(1000);
        let truncated = TruncatedExponential::<Frac, Fine>::from_rate(rate, length);
        let of_mean = due.and_then(|mean| TruncatedExponential::from_mean(mean, length));
        assert_eq!(truncated, of_mean, "{rate}");
        match truncated {
            Ok(truncated) => {
                assert_eq!(truncated.mean(), due.unwrap());
                assert_eq!(truncated.length(), length);
                built += 1;
            }
            Err(_) => refused += 1,
        }
    }
    println!(
        "{} fraction bits: {built} rates, {refused} refused",
        Frac::U32
    );
    assert!(built > 10_000 && refused > 10_000);
}

#[test]
fn a_rate_is_the_mean_nearest_to_its_reciprocal() {
    is_the_law_of_its_mean::<U0>();
    is_the_law_of_its_mean::<U16>();
    is_the_law_of_its_mean::<U31>();
    is_the_law_of_its_mean::<U32>();
    // A mean that is cut and not rounded is seen.
    let cut = U16F16::from_bits(((1_u64 << 48) / 0x1_8000_0000) as u32);
    let rounded = Exponential::<U16, Fine>::from_rate(U32F32::from_num(1.5)).unwrap();
    assert_ne!(rounded.mean(), cut);
}

#[test]
fn a_rate_without_a_mean_in_the_format_is_refused_by_name() {
    type Delay = Exponential<U16, Fine>;
    let of = |rate: f64| Delay::from_rate(U32F32::from_num(rate)).err();
    assert_eq!(of(0.0), Some(Error::NotPositive(0)));
    assert_eq!(of(131_072.0), None);
    assert_eq!(of(131_073.0), Some(Error::Empty(0)));
    assert_eq!(of(4e9), Some(Error::Empty(0)));
    // A mean of 2953.4 is the longest of which 22.19 fit.
    assert_eq!(of(1.0 / 2953.0), None);
    assert_eq!(of(1.0 / 2954.0), Some(Error::TooLarge(0)));
    type Path = TruncatedExponential<U16, Fine>;
    let length = U16F16::ONE;
    let of = |rate: f64, length| Path::from_rate(U32F32::from_num(rate), length).err();
    assert_eq!(of(0.0, length), Some(Error::NotPositive(0)));
    assert_eq!(of(1.0, U16F16::ZERO), Some(Error::NotPositive(1)));
    assert_eq!(of(1.0 / 65_535.0, length), None);
    assert_eq!(of(1.0 / 65_537.0, length), Some(Error::TooLarge(0)));
    assert_eq!(of(131_073.0, length), Some(Error::Empty(0)));
    const CHECKED: Result<Delay, Error> = Delay::from_rate(U32F32::lit("0.05"));
    assert_eq!(CHECKED.unwrap().mean(), 20);
}

#[test]
fn the_rate_is_the_nearest_to_the_reciprocal_of_the_mean() {
    for bits in [
        1_u32,
        2,
        3,
        5,
        1000,
        0xffff,
        0x1_0000,
        0x1_0001,
        193_554_181,
    ] {
        let mean = U16F16::from_bits(bits);
        let rate = Exponential::<U16, Fine>::from_mean(mean).unwrap().rate();
        let off = rate.to_num::<f64>() - 65_536.0 / f64::from(bits);
        assert!(
            off.abs() <= 0.5 / 4_294_967_296.0 * (1.0 + 1e-6),
            "{bits}: {off:e}"
        );
        let truncated = TruncatedExponential::<U16, Fine>::from_mean(mean, U16F16::ONE);
        assert_eq!(truncated.unwrap().rate(), rate);
    }
    // 2³², which no density is.
    let shortest = Exponential::<U32, Fine>::from_mean(U0F32::DELTA).unwrap();
    assert_eq!(shortest.rate(), U32F32::MAX);
}

#[test]
fn parameters_come_back_as_they_were_given() {
    let mut rng = Pcg32::seed_from_u64(16);
    for _ in 0..10_000 {
        let word = rng.next_u32();
        let [a, b, c] = [(); 3].map(|()| I16F16::from_bits(rng.next_u32() as i32 >> 8));
        if let Ok(noise) = NormalPair::<_, Fine>::new([a, b], c.abs()) {
            assert_eq!((noise.mean(), noise.std_dev()), ([a, b], c.abs()));
        }
        if let Ok(tent) = Tent::<_, Fine>::new(c.abs()) {
            assert_eq!(tent.radius(), c.abs());
        }
        let vertices = [[a, b, c], [c, c, a], [b, a, a]];
        if let Ok(facet) = TriangleOn::<_, 3, Fine>::new(vertices) {
            assert_eq!(facet.vertices(), vertices);
        }
        let mean = U16F16::from_bits(word >> 5 | 1);
        let waiting = Exponential::<_, Fine>::from_mean(mean).unwrap();
        assert_eq!(waiting.mean(), mean);
        // Exponents and cones keep as many digits as they say.
        let n = U32F32::from_bits(u64::from(word) << (word & 15));
        assert_eq!(PhongLobe::<Fine>::new(n).unwrap().exponent(), n);
        let k = U2F62::from_bits(u64::from(word >> 1 | 1 << 30) << (word & 31));
        assert_eq!(
            Cone::<Fine>::from_one_minus_cos(k).unwrap().one_minus_cos(),
            k
        );
    }
    for k in [1 << 29, (1 << 63) - (1 << 33), 1 << 63] {
        let k = U2F62::from_bits(k);
        assert_eq!(
            Cone::<Fine>::from_one_minus_cos(k).unwrap().one_minus_cos(),
            k
        );
    }
    assert_eq!(PhongLobe::<Fine>::new(U32F32::ZERO).unwrap().exponent(), 0);
    assert_eq!(*mw::Float::new(mw::Disk::new()).warp(), mw::Disk::new());
}

/// The cone towards a sphere is that of its radius and distance, whatever the unit.
#[test]
fn a_sphere_is_seen_in_its_cone() {
    type Wide = FixedU32<U32>;
    let towards = |d, r| Cone::<Fine>::towards_sphere(Wide::from_bits(d), Wide::from_bits(r));
    let mut rng = Pcg32::seed_from_u64(17);
    let (mut worst, mut seen) = (0.0_f64, [0; 3]);
    for i in 0..300_000 {
        let d = rng.next_u32() >> (rng.next_u32() & 31);
        let r = match i % 3 {
            0 => d.saturating_sub(rng.next_u32() >> (rng.next_u32() & 31)),
            1 => d.wrapping_sub(rng.next_u32() & 3).wrapping_add(1),
            _ => d >> (rng.next_u32() & 31),
        };
        let cone = towards(d, r);
        let [wide, narrow] = [d, r].map(f64::from);
        let ratio = narrow / wide;
        let exact = ratio * ratio / (1.0 + ((wide - narrow) * (wide + narrow)).sqrt() / wide);
        match cone {
            Err(Error::NotPositive(1)) => assert_eq!(r, 0),
            Err(error) => {
                assert!(
                    error == Error::Empty(1) && exact < 1.2e-10,
                    "{d} {r}: {error:?}"
                );
                seen[0] += 1;
            }
            Ok(cone) if r > d => {
                assert_eq!(cone.one_minus_cos(), 2, "{d} {r}");
                seen[1] += 1;
            }
            Ok(cone) => {
                let k = cone.one_minus_cos().to_num::<f64>();
                // The getter cuts to 62 binary places.
                let error = ((k - exact).abs() - 0.5_f64.powi(62)) / exact;
                worst = worst.max(error);
                assert!(error <= 0.5_f64.powi(30), "{d} {r}: {k}");
                assert!(r < d || k == 1.0, "{d} {r}: {k}");
                seen[2] += 1;
                if r > d / 4 * 3 && i % 2 == 0 {
                    let [d, r] = [d, r].map(|x| FixedU32::<U0>::from_bits(x >> 2 << 2));
                    let [half, quarter] =
                        [d, r].map(|x| FixedU32::<U16>::from_bits(x.to_bits() >> 2));
                    let whole = Cone::<Fine>::towards_sphere(d, r);
                    assert_eq!(whole, Cone::towards_sphere(half, quarter));
                }
            }
        }
    }
    println!(
        "a sphere's k is off by {:.2} of a 31st digit; {seen:?}",
        worst * 2_f64.powi(31)
    );
    assert!(seen.iter().all(|n| *n > 3_000), "{seen:?}");
}

#[test]
fn an_interval_says_its_lowest_and_its_last_value() {
    fn holds<T: mw::Number + PartialEq + core::fmt::Debug>(of: [T; 2], due: [T; 2]) {
        assert_eq!(of, due);
    }
    let of = |low: i32, high: i32| Interval::<i32>::new(low, high).unwrap();
    for (low, high) in [
        (-3, 5),
        (i32::MIN, i32::MAX),
        (0, 1),
        (i32::MIN, 0),
        (-1, 0),
    ] {
        let interval = of(low, high);
        holds([interval.low(), interval.last()], [low, high - 1]);
    }
    let all = Interval::<u32>::inclusive(0, u32::MAX).unwrap();
    holds([all.low(), all.last()], [0, u32::MAX]);
    let [low, last] = [-3, 5].map(FixedI32::<U16>::from_num);
    let numbers = Interval::<I16F16>::inclusive(low, last).unwrap();
    holds([numbers.low(), numbers.last()], [low, last]);
    let [low, high] = [3, 5].map(U16F16::from_num);
    let below = high - U16F16::DELTA;
    let numbers = Interval::<U16F16>::new(low, high).unwrap();
    holds([numbers.low(), numbers.last()], [low, below]);
}

/// Location, scale and sigma come back; a scale that is not positive, and points beyond the format, are refused.
#[test]
fn laplace_logistic_and_rayleigh_refuse_what_does_not_fit() {
    use microwarp::fixed::warp::{Laplace, Logistic, Rayleigh};
    use microwarp::{Invert, Warp};
    let (i, u) = (FixedI32::<U16>::from_bits, FixedU32::<U16>::from_bits);
    macro_rules! refuse {
        ($name:ident, $reach:literal) => {
            type Of = $name<U16, Fine>;
            for scale in [0, -1, i32::MIN] {
                assert_eq!(Of::new(i(0), i(scale)), Err(Error::NotPositive(1)));
            }
            // The largest scale about 0, and about a location that leaves room for one step.
            let most = (f64::from(i32::MAX) / $reach) as i32;
            assert!(Of::new(i(0), i(most - 2)).is_ok());
            assert_eq!(Of::new(i(0), i(most + 2)), Err(Error::TooLarge(1)));
            assert_eq!(Of::new(i(i32::MIN), i(1)), Err(Error::TooLarge(1)));
            assert_eq!(Of::new(i(i32::MAX - 22), i(1)), Err(Error::TooLarge(1)));
            for location in [i32::MAX - 23, 23 - i32::MAX] {
                let law = Of::new(i(location), i(1)).unwrap();
                assert_eq!((law.location(), law.scale()), (i(location), i(1)));
                let ends = [0, u32::MAX].map(|w| law.sample(U0F32::from_bits(w)));
                assert_eq!(ends, [i(location - 22), i(location + 22)]);
            }
            // The largest points fit, and the median is the location.
            let law = Of::new(i(0), i(most - 2)).unwrap();
            for (w, sign) in [(0, -1), (u32::MAX, 1)] {
                assert_eq!(law.sample(U0F32::from_bits(w)).to_bits().signum(), sign);
            }
            for w in [(1 << 31) - 1, 1 << 31] {
                assert_eq!(law.sample(U0F32::from_bits(w)).to_bits() / most, 0);
            }
            assert_eq!(law.invert(i(i32::MIN)), 0);
            assert_eq!(law.invert(i(i32::MAX)), U0F32::MAX);
        };
    }
    {
        refuse!(Laplace, 22.195_312_5);
    }
    {
        refuse!(Logistic, 22.882_812_5);
    }
    type Of = Rayleigh<U16, Fine>;
    assert_eq!(Of::new(u(0)), Err(Error::NotPositive(0)));
    let most = (f64::from(u32::MAX) / 6.67) as u32;
    assert_eq!(Of::new(u(most + 1)), Err(Error::TooLarge(0)));
    let law = Of::new(u(most)).unwrap();
    assert_eq!(law.sigma(), u(most));
    assert_eq!(law.sample(U0F32::ZERO), 0);
    assert!(law.sample(U0F32::MAX).to_bits() > most / 2 * 13);
    assert_eq!(law.invert(u(0)), 0);
}

/// Radii, sides and corners come back; what has no area, is too large or too dense is refused.
#[test]
fn rings_and_polygons_refuse_what_does_not_fit() {
    use fixed::types::I0F32;
    use microwarp::Warp;
    use microwarp::fixed::warp::{Annulus, RegularPolygon};
    type Of = Annulus<U16, Fine>;
    let q = FixedI32::<U16>::from_bits;
    let new = |inner, outer| Of::new(q(inner), q(outer));
    assert_eq!(new(-1, 5), Err(Error::Negative(0)));
    assert_eq!(new(i32::MIN, -1), Err(Error::Negative(0)));
    assert_eq!(new(6, 5), Err(Error::Reversed(1)));
    assert_eq!(new(1000, 1000), Err(Error::Empty(1)));
    assert_eq!(new(0, 0), Err(Error::Empty(1)));
    assert_eq!(new(0, (1 << 30) + 1), Err(Error::TooLarge(1)));
    // A disk of one step, of density 2^32/pi, and of one in a format with more digits, whose density overflows.
    assert!(new(0, 1).is_ok());
    assert_eq!(
        Annulus::<U32, Fine>::new(I0F32::ZERO, I0F32::DELTA),
        Err(Error::Empty(1))
    );
    let sector = |sides: [u32; 2]| Of::sector(q(0), q(1 << 30), sides.map(U0F32::from_bits));
    assert_eq!(sector([7, 7]), Err(Error::Empty(2)));
    for (inner, outer) in [(0, 2), (1, 2), ((1 << 30) - 1, 1 << 30), (77, 1 << 20)] {
        let ring = new(inner, outer).unwrap();
        assert_eq!(
            (ring.radii(), ring.sides()),
            ([q(inner), q(outer)], [U0F32::ZERO; 2])
        );
        let sides = [0xf000_0000, 1 << 28].map(U0F32::from_bits);
        let fan = Of::sector(q(inner), q(outer), sides).unwrap();
        assert_eq!((fan.radii(), fan.sides()), (ring.radii(), sides));
        // An eighth of a turn, with eight times the density.
        let point = ring.sample([U0F32::ZERO; 2]);
        let [ring, fan] = [ring.pdf(point), fan.pdf(point)].map(|p| p.to_num::<f64>());
        assert!(
            (fan / ring - 8.0).abs() < 1e-6 || ring < 1e-3,
            "{fan} {ring}"
        );
    }
    const RING: Result<Of, Error> = Of::new(I16F16::ZERO, I16F16::ONE);
    assert!(RING.is_ok());
    for corners in [0, 1, 2] {
        assert_eq!(
            RegularPolygon::<Fine>::new(corners),
            Err(Error::OutOfRange(0))
        );
    }
    for corners in [3, 4, 1000, u16::MAX] {
        assert_eq!(
            RegularPolygon::<Fine>::new(corners).unwrap().corners(),
            corners
        );
    }
}
