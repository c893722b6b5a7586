//! Products of warps, and the directions of reflections: what they are made of, at every magnitude.

use host::generators::{Counting, Failing};
use host::speed;
use microwarp::tier::Poly;
use microwarp::uniform::{LARGEST, grid};
use microwarp::warp::{Aabb, Each, GgxVisible, Interval, Product, Reflected, Tent};
use microwarp::{Invert, Warp, poly as mw};
use rand_core::Rng;
use rand_pcg::Pcg32;

#[test]
fn a_product_is_its_parts_side_by_side() {
    let (disk, tail) = (
        mw::Disk::new(),
        mw::ExponentialTail::from_rate(2.0).unwrap(),
    );
    let pair = Product::new(disk, tail);
    let sides = [(-1.0, 2.0), (0.0, 0.25), (3.0, 7.0)].map(|(a, b)| Interval::new(a, b).unwrap());
    let (each, cuboid) = (
        Each::new(sides),
        Aabb::new([-1.0, 0.0, 3.0], [2.0, 0.25, 7.0]).unwrap(),
    );
    let tails = Each::new([tail; 3]);
    let mut rng = Pcg32::new(4, 5);
    for _ in 0..speed::of("products", 5_000, 200_000) {
        let u = [0; 3].map(|_: u32| grid(&mut rng));
        let ((x, y), (same, density)) = (
            pair.sample(([u[0], u[1]], u[2])),
            pair.sample_with_pdf(([u[0], u[1]], u[2])),
        );
        assert_eq!((x, y), (disk.sample([u[0], u[1]]), tail.sample(u[2])));
        assert_eq!(same, (x, y));
        let (_, [a, b]) = ((), [disk.pdf(x), tail.sample_with_pdf(u[2]).1]);
        assert_eq!(density, a * b);
        assert_eq!(pair.pdf((x, y)), disk.pdf(x) * tail.pdf(y));
        assert_eq!(pair.invert((x, y)), (disk.invert(x), tail.invert(y)));
        assert_eq!(each.sample(u), cuboid.sample(u));
        assert_eq!(each.invert(each.sample(u)), cuboid.invert(cuboid.sample(u)));
        assert!((each.pdf(each.sample(u)) / cuboid.pdf(cuboid.sample(u)) - 1.0).abs() <= 3e-7);
        let words = [0; 3].map(|_: u32| rng.next_u32());
        let word = |i: usize| tail.sample_words(words[i]);
        assert_eq!(tails.sample_words(words), [word(0), word(1), word(2)]);
        assert_eq!(
            pair.sample_words(([words[0], words[1]], words[2])),
            (disk.sample_words([words[0], words[1]]), word(2))
        );
    }
    // A draw takes the words of its parts, two each of these, and the same in both ways.
    let (mut one, mut other) = (Pcg32::new(1, 1), Counting::new(Pcg32::new(1, 1)));
    let apart = [0; 3].map(|_: u32| tail.draw(&mut one));
    assert_eq!((tails.draw(&mut other), other.words), (apart, 6));
    let (points, density) = tails.draw_with_pdf(&mut Pcg32::new(1, 1));
    let product = apart.map(|x| tail.pdf(x)).iter().product::<f32>();
    assert!(points == apart && (density / product - 1.0).abs() <= 1e-6);
    for left in 0..6 {
        let mut rng = Failing { word: 7, left };
        assert!(tails.try_draw(&mut rng).is_err());
        assert_eq!(rng.left, 0, "words are drawn after a failure");
    }
}

#[test]
fn no_product_of_densities_leaves_the_range_on_the_way() {
    let of = |width: f32| Interval::new(0.0, width).unwrap();
    let (narrow, wide) = (of(1e-30), of(1e30));
    let due = narrow.pdf(0.0);
    for parts in [
        [narrow, narrow, wide],
        [narrow, wide, narrow],
        [wide, narrow, narrow],
    ] {
        let each = Each::new(parts);
        assert!((each.pdf([0.0; 3]) / due - 1.0).abs() <= 2e-7);
        assert!((each.sample_with_pdf([0.5; 3]).1 / due - 1.0).abs() <= 2e-7);
        let plain: f32 = parts.iter().map(|part| part.pdf(0.0)).product();
        // As it would be without the scale.
        assert_eq!(plain.is_finite(), parts[1] == wide || parts[0] == wide);
    }
    let small = Each::new([wide, wide, narrow]);
    assert!((small.pdf([0.0; 3]) / wide.pdf(0.0) - 1.0).abs() <= 2e-7);
    assert_eq!(Each::new([narrow; 2]).pdf([0.0; 2]), f32::MAX);
    assert_eq!(Each::new([wide; 2]).pdf([0.0; 2]), f32::from_bits(1));
    // 0 is 0 beside what overflows.
    assert_eq!(Each::new([narrow; 3]).pdf([0.0, 0.0, 1.0]), 0.0);
    assert_eq!(Each::new([narrow; 3]).pdf([0.0, 0.0, f32::NAN]), 0.0);
    assert_eq!(Each::new([narrow; 0]).pdf([]), 1.0);
    assert_eq!(Product::new(narrow, narrow).pdf((0.0, 0.0)), f32::MAX);
    assert_eq!(Product::new(wide, wide).pdf((0.0, 0.0)), f32::from_bits(1));
    assert_eq!(Product::new(narrow, narrow).pdf((0.0, 1.0)), 0.0);
    assert_eq!(Product::new(narrow, narrow).pdf((f32::NAN, 0.0)), 0.0);
    let any = [f32::NAN, -1.0, 0.0, 0.5, LARGEST, 1.0, f32::INFINITY];
    for (a, b) in any.into_iter().flat_map(|a| any.map(|b| (a, b))) {
        let (x, y) = Product::new(of(1.0), Tent::new(1.0).unwrap()).sample((a, b));
        assert!((0.0..=1.0).contains(&x) && y.abs() <= 1.0);
    }
}

/// A view at any height, every fourth one at the horizon, and roughnesses from some least one.
fn surface(rng: &mut Pcg32, least: f32) -> GgxVisible<Poly> {
    let (s, c) = (core::f32::consts::TAU * grid(rng)).sin_cos();
    let height = [0.0, (-30.0 * grid(rng)).exp2(), grid(rng), 2.0 * grid(rng)];
    let height = height[(rng.next_u32() % 4) as usize];
    let mut alpha = || (least.ln() * grid(rng)).exp().clamp(least, 1.0);
    let alpha = [alpha(), alpha()];
    let made = match rng.next_u32() % 2 {
        0 => GgxVisible::new([c, s, height], alpha),
        _ => GgxVisible::bounded([c, s, height], alpha),
    };
    made.unwrap()
}

#[test]
fn no_reflection_has_density_zero() {
    let mut rng = Pcg32::new(31, 8);
    let (mut worst, mut of_normals) = (0.0_f32, 0.0_f32);
    for k in 0..speed::of("reflections", 50_000, 3_000_000) {
        let rough = k % 2 == 0;
        let normals = surface(&mut rng, if rough { 0.3 } else { 1e-4 });
        let lobe = Reflected::new(normals);
        let ends = [0.0, LARGEST, grid(&mut rng), grid(&mut rng)];
        let u = [(); 2].map(|()| ends[(rng.next_u32() % 4) as usize]);
        let bounce = normals.reflect(u);
        let (direction, density) = lobe.sample_with_pdf(u);
        for (x, of) in direction.into_iter().zip(bounce.direction) {
            assert!((x - of).abs() <= 1e-6);
        }
        assert_eq!((lobe.sample(u), density), (direction, bounce.pdf));
        let pdf = lobe.pdf(direction);
        let here = || format!("{normals:?} at {u:?}: {direction:?}, {pdf} for {density}");
        assert!(pdf > 0.0 && pdf <= f32::MAX, "{}", here());
        assert!(
            lobe.invert(direction)
                .iter()
                .all(|u| (0.0..1.0).contains(u))
        );
        let [x, y, z] = bounce.normal;
        let [a, b, c] = normals.view();
        let seen = x * a + y * b + z * c;
        if rough && seen > 0.1 {
            worst = worst.max((pdf / density - 1.0).abs());
            let wrong = normals.pdf(bounce.normal);
            of_normals = of_normals.max((wrong / density - 1.0).abs());
        }
    }
    println!("density by the direction {worst:.1e}, of the normals instead {of_normals:.1e}");
    assert!(worst <= 5e-5, "{worst}");
    assert!(of_normals > 0.5, "{of_normals}");
    let lobe = Reflected::<Poly>::new(GgxVisible::new([0.6, 0.0, 0.8], [0.3; 2]).unwrap());
    for direction in [[f32::NAN; 3], [f32::INFINITY; 3], [0.0, 0.0, -1.0]] {
        assert_eq!(lobe.pdf(direction), 0.0, "{direction:?}");
        assert!(
            lobe.invert(direction)
                .iter()
                .all(|u| (0.0..1.0).contains(u))
        );
    }
}
