//! A composition keeps the density of its samples where the weight is 0 next to them.

use microwarp::discrete::PiecewiseConstant2d;
use microwarp::{Invert, Warp, poly as mw};

/// How often the weight at the rounded inverse of a sample is 0. The composition's density is never, and is that of the
/// sample, to rounding.
fn strays<W: Invert<Uniforms = [f32; 2], Density = f32> + Copy>(then: W) -> u32
where
    W::Point: core::fmt::Debug,
{
    // Two cells of four are dark.
    let table = PiecewiseConstant2d::new(&[[0.0, 1.0], [1.0, 0.0]], [0.0, 1.0], [0.0, 1.0]);
    let table = table.unwrap();
    let warp = mw::Composed::new(&table, then);
    let mut strays = 0;
    // Along the borders of the cells.
    for k in 0..1_u32 << 16 {
        let near = |bits: u32| 0.5 + (bits & 15) as f32 / 16_777_216.0;
        // Not where all second uniforms give one point.
        let any = 0.05 + 0.9 * ((k.wrapping_mul(0x9e37_79b9) >> 8) as f32 / 16_777_216.0);
        for u in [[near(k), any], [any, near(k)], [near(k >> 4), near(k)]] {
            let (x, density) = warp.sample_with_pdf(u);
            let inverse = warp.pdf(x);
            assert!(
                (inverse / density - 1.0).abs() <= 1e-5,
                "{u:?}, {x:?}: {inverse} for {density}"
            );
            strays += u32::from(table.pdf(then.invert(x)) == 0.0);
        }
    }
    strays
}

#[test]
fn a_composition_never_has_density_zero_at_its_samples() {
    let of = [
        ("triangle", strays(mw::Triangle::new())),
        ("cosine", strays(mw::CosineHemisphere::new())),
        (
            "patch",
            strays(mw::SphericalPatch::from_turns(0.1, 0.2, 0.0, 0.1).unwrap()),
        ),
    ];
    println!("inverses in the dark: {of:?}");
    // Otherwise nothing is tried. The inverses of the others happen to be exact beside a half.
    assert!(of.iter().any(|(_, strays)| *strays > 1000));
}

#[test]
fn a_composition_is_the_second_warp_at_the_points_of_the_first() {
    let weights = mw::Bilinear::new([[0.0, 1.0], [2.0, 3.0]]).unwrap();
    let warp = mw::Composed::new(weights, mw::Sphere::new());
    for k in 1..1000_u32 {
        let u = [0x9e37_79b9_u32, 0x85eb_ca6b].map(|m| k.wrapping_mul(m) as f32 / 4_294_967_296.0);
        let (point, density) = warp.sample_with_pdf(u);
        let (place, weight) = weights.sample_with_pdf(u);
        assert_eq!(point, warp.then().sample(place));
        let due = weight * warp.then().pdf(point);
        assert!((density / due - 1.0).abs() <= 2e-7, "{density} for {due}");
        assert_eq!(
            warp.invert(point),
            weights.invert(warp.then().invert(point))
        );
    }
    // Outside the domain of the second there is none.
    let triangle = mw::Composed::new(*warp.first(), mw::Triangle::new());
    assert_eq!(triangle.pdf([0.5, 0.5, 0.5]), 0.0);
    assert_eq!(triangle.pdf([f32::NAN; 3]), 0.0);
}

/// y is 0 there, not the smallest number above it, whose row is the other one.
#[test]
fn at_a_second_uniform_of_zero_the_first_row_counts() {
    let at_zero = |row: [f32; 2]| {
        mw::Bilinear::new([row, [1.0, 0.0]])
            .unwrap()
            .sample([0.5, 0.0])
    };
    for tiny in [1e-3, 1e-25, 1e-40] {
        let [x, y] = at_zero([0.0, tiny]);
        let off = (x - std::f32::consts::FRAC_1_SQRT_2).abs();
        assert!(off <= 4e-7 && y == 0.0, "{tiny}: {x}, {y}");
    }
    // A row of no weight is no place, and the second one counts.
    let [x, y] = at_zero([0.0, 0.0]);
    assert!(
        (x - (1.0 - std::f32::consts::FRAC_1_SQRT_2)).abs() <= 4e-7 && y > 0.0,
        "{x}, {y}"
    );
}
