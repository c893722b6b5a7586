//! The ends of the warps: no sample without a density, no inverse at the wrong end, no parameter refused in vain.

use fixed::FixedI32;
use fixed::types::extra::U0;
use fixed::types::{I0F32, I2F30, I16F16, U0F32, U2F62, U32F32};
use microwarp::fixed::{Coarse, Compact, Fine, Float, Grade, warp};
use microwarp::{Error, Invert, Warp};
use rand_core::Rng;
use rand_pcg::Pcg32;

/// Words that are seldom drawn: next to both ends and to the powers of two.
fn edges() -> Vec<u32> {
    let powers = (0..32).flat_map(|bit| [1 << bit, (1_u32 << bit).wrapping_neg()]);
    let near = |word: u32| (0..5).map(move |by| word.wrapping_add(by).wrapping_sub(2));
    powers.flat_map(near).collect()
}

fn words(first: u32, second: u32) -> [U0F32; 2] {
    [first, second].map(U0F32::from_bits)
}

fn lobes_end_above_the_horizon<G: Grade>() {
    let exponents = [0, 1, 2, 3, 7, 1 << 20, 1 << 31, 1 << 32, 50 << 32];
    let mut rng = Pcg32::new(1, 1);
    for exponent in exponents.map(U32F32::from_bits) {
        let lobe = warp::PhongLobe::<G>::new(exponent).unwrap();
        for u1 in edges() {
            let point = lobe.sample(words(u1, rng.next_u32()));
            assert!(point[2] > 0, "{} {exponent} {u1}: {point:?}", G::NAME);
            assert!(lobe.pdf(point) > 0, "{} {exponent} {u1}", G::NAME);
        }
    }
}

#[test]
fn lobes_of_any_exponent_end_above_the_horizon() {
    lobes_end_above_the_horizon::<Fine>();
    lobes_end_above_the_horizon::<Coarse>();
    lobes_end_above_the_horizon::<Compact>();
}

/// How many samples next to the rim have density 0, and whether one well outside of it has any.
fn rims<G: Grade>() {
    let mut rng = Pcg32::new(2, 1);
    for shift in 0..35 {
        for _ in 0..2000 {
            let k = (rng.next_u64() | 1 << 63) >> shift;
            let Ok(cone) = warp::Cone::<G>::from_one_minus_cos(U2F62::from_bits(k)) else {
                continue;
            };
            let u1 = !(rng.next_u32() >> (rng.next_u32() & 31));
            let point = cone.sample(words(u1, rng.next_u32()));
            assert!(cone.pdf(point) > 0, "{} {cone:?} {u1}: {point:?}", G::NAME);
            let route = Float::new(cone);
            let point = route.sample([1.0, 0.37]);
            assert!(route.pdf(point) > 0.0, "{} {cone:?}", G::NAME);
            // By 2⁻¹² of k, and where steps are wider, by ten of them.
            let sin = (k as f64 / (1_u64 << 61) as f64).sqrt();
            if k < 1 << 60 {
                let beyond = sin * (1.0 + 1.0 / 4096.0) + 10.0 / (1 << 30) as f64;
                let outside = [I2F30::from_num(beyond), I2F30::ZERO, I2F30::ONE];
                assert_eq!(cone.pdf(outside), 0, "{} {cone:?}", G::NAME);
            }
        }
    }
}

#[test]
fn cones_have_a_density_up_to_their_rim_and_none_beyond() {
    rims::<Fine>();
    rims::<Coarse>();
    rims::<Compact>();
}

#[test]
fn cones_of_an_angle_are_accepted_as_those_of_a_cosine_are() {
    /// A turn in words.
    const TURN: f64 = 4_294_967_296.0;
    let least = (2.0_f64.powi(-17).asin() / std::f64::consts::PI * TURN).ceil() as u32;
    let cone = |words| warp::Cone::<Fine>::from_turns(U0F32::from_bits(words));
    assert!(cone(least + 2).is_ok());
    assert_eq!(cone(least - 2), Err(Error::Empty(0)));
    assert!(f64::from(least) / TURN < 2.43e-6 && f64::from(least) / TURN > 2.42e-6);
}

fn tents_are_inverted_at_their_own_end<G: Grade>() {
    for radius in [1, 2, 35, 1 << 16, i32::MAX - 1, i32::MAX] {
        let tent = warp::Tent::<U0, G>::new(FixedI32::from_bits(radius)).unwrap();
        for u in edges() {
            let x = tent.sample(U0F32::from_bits(u));
            let again = tent.sample(tent.invert(x));
            let off = again.to_bits().abs_diff(x.to_bits());
            assert!(
                off <= 2 + (radius as u32 >> 13),
                "{} {radius} {u}: {x} {again}",
                G::NAME
            );
        }
        let [below, above] =
            [i32::MIN, i32::MAX].map(|x| tent.sample(tent.invert(FixedI32::from_bits(x))));
        assert!(
            below <= 0 && above >= 0,
            "{} {radius}: {below} {above}",
            G::NAME
        );
    }
}

#[test]
fn tents_are_inverted_at_their_own_end_in_all_grades() {
    tents_are_inverted_at_their_own_end::<Fine>();
    tents_are_inverted_at_their_own_end::<Coarse>();
    tents_are_inverted_at_their_own_end::<Compact>();
}

#[test]
fn triangles_have_a_density_at_their_points_cut_to_f32() {
    let triangle = Float::new(warp::Triangle::<Fine>::new());
    let mut rng = Pcg32::new(3, 1);
    for _ in 0..1_000_000 {
        let point = triangle.draw(&mut rng);
        assert_eq!(triangle.pdf(point), 2.0, "{point:?}");
    }
    assert_eq!(triangle.pdf([0.5, 0.25, 0.249_999]), 0.0);
}

#[test]
fn normals_are_refused_only_where_their_density_overflows() {
    let least = (1.0 / (2.0 * std::f64::consts::PI)).sqrt() * 2.0_f64.powi(-16);
    let noise = |deviation: f64| {
        warp::NormalPair::<_, Fine>::new([I0F32::ZERO; 2], I0F32::from_num(deviation))
    };
    assert!(noise(least * 1.001).is_ok());
    assert_eq!(noise(least * 0.999), Err(Error::Empty(1)));
    let finest = noise(least * 1.001).unwrap();
    let peak = finest.pdf([I0F32::ZERO; 2]).to_num::<f64>();
    let truth = 1.0 / (2.0 * std::f64::consts::PI) / finest_deviation(least * 1.001).powi(2);
    assert!((peak / truth - 1.0).abs() < 1e-6, "{peak} {truth}");
    assert!(warp::NormalPair::<_, Fine>::new([I16F16::ZERO; 2], I16F16::DELTA).is_ok());
}

/// The deviation as its format holds it.
fn finest_deviation(deviation: f64) -> f64 {
    I0F32::from_num(deviation).to_num()
}
