//! Generators meet warps in one place: what a draw consumes, what a failing or a stuck generator does.

use host::generators::{Broken, Counting, Failing};
use microwarp::discrete::{PiecewiseConstant1d, PiecewiseConstant2d};
use microwarp::uniform::{self, Canonical, FromFn, Rng06, Rng09, TryRng06, Uniforms as _};
use microwarp::warp::Transform;
use microwarp::{Invert, Warp, libm, poly};
use rand_core::{Rng, TryRng};
use rand_pcg::Pcg32;
use std::convert::Infallible;

/// Fails after some words.
fn failing(left: u64) -> Failing {
    Failing {
        word: 0x8000_0000,
        left,
    }
}

/// Yields one word for ever.
#[derive(Clone)]
struct Stuck(u32);

impl TryRng for Stuck {
    type Error = Infallible;
    fn try_next_u32(&mut self) -> Result<u32, Infallible> {
        Ok(self.0)
    }
    fn try_next_u64(&mut self) -> Result<u64, Infallible> {
        Ok(u64::from(self.0) << 32 | u64::from(self.0))
    }
    fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), Infallible> {
        bytes.fill(self.0 as u8);
        Ok(())
    }
}

fn consumes<W: Warp>(warp: &W, words: u64) {
    let mut rng = Counting::new(Pcg32::new(1, 1));
    warp.draw(&mut rng);
    assert_eq!(rng.words, words);
    let mut points = [warp.draw(&mut Pcg32::new(1, 1)); 10];
    warp.fill(&mut rng, &mut points);
    assert_eq!(rng.words, 11 * words);
}

#[test]
fn a_draw_consumes_the_documented_number_of_words() {
    consumes(&poly::Interval::new(0.0, 1.0).unwrap(), 1);
    consumes(&poly::Power::new(2.0, 0.0, 1.0).unwrap(), 1);
    consumes(&poly::PowerMax::<5>::new(), 5);
    consumes(&poly::Exponential::from_rate(1.0).unwrap(), 1);
    consumes(&poly::ExponentialTail::from_rate(1.0).unwrap(), 2);
    consumes(&poly::TruncatedExponential::from_rate(1.0, 1.0).unwrap(), 1);
    consumes(&poly::Normal::new(0.0, 1.0).unwrap(), 1);
    consumes(&poly::NormalPair::new([0.0; 2], 1.0).unwrap(), 2);
    consumes(&poly::Disk::new(), 2);
    consumes(&poly::Triangle::new(), 2);
    consumes(&libm::Sphere::new(), 2);
    consumes(&libm::CapsuleSurface::new(1.0, 1.0).unwrap(), 2);
    consumes(&libm::PhongLobe::new(5.0).unwrap(), 2);
    // A composition consumes what its parts do.
    let frame = poly::Frame::new([0.0, 1.0, 0.0]).unwrap();
    consumes(&poly::Oriented::new(poly::Hemisphere::new(), frame), 2);
    let tail = poly::ExponentialTail::from_rate(1.0).unwrap();
    consumes(
        &poly::Transform::new(tail, |x| 2.0 * x, |y: f32| 0.5 * y, |_| 2.0),
        2,
    );
    consumes(&&tail, 2);
    let either = poly::MarginalConditional::new(tail, |_| poly::Interval::new(0.0, 1.0).unwrap());
    consumes(&either, 3);
    let sky = PiecewiseConstant2d::new_u64(&[[1.0, 2.0]], [0.0, 1.0], [0.0, 1.0]).unwrap();
    consumes(&poly::Composed::new(sky, poly::Sphere::new()), 4);
}

/// Over the whole registry, which knows the number: as many words as uniforms, but twice as many for the
/// tail and for tables of `u64`.
#[test]
fn every_warp_consumes_as_many_words_as_the_catalogue_says() {
    for entry in host::registry::entries() {
        let (mut drawn, mut stepped) = (Pcg32::new(8, 8), Pcg32::new(8, 8));
        entry.warp.fill(&mut drawn, 10);
        for _ in 0..10 * entry.words {
            stepped.next_u32();
        }
        assert_eq!(drawn, stepped, "{entry}");
    }
}

/// Over the whole registry: blocks of points, where they are filled so, and what is left of them.
#[test]
fn filling_is_drawing_one_by_one() {
    for entry in host::registry::entries() {
        for count in [1, 7, 8, 9, 31] {
            let (mut filled, mut drawn) = (Pcg32::new(8, 8), Pcg32::new(8, 8));
            let points = entry.warp.fill(&mut filled, count);
            for (i, point) in points.into_iter().enumerate() {
                let one = entry.warp.fill(&mut drawn, 1)[0];
                assert_eq!(
                    point.map(f32::to_bits),
                    one.map(f32::to_bits),
                    "{entry}: {i} of {count}"
                );
            }
            assert_eq!(filled, drawn, "{entry}");
        }
    }
}

/// Uniforms of any kind, more than fit into blocks: on the grid and between, tiny, out of range and not numbers.
fn hostile() -> Vec<[f32; 4]> {
    let edges = [
        0.0,
        -0.0,
        1e-45,
        1e-30,
        0.5,
        1.0 - 2.0_f32.powi(-24),
        1.0,
        7.0,
        -1.0,
    ];
    let edges = edges
        .into_iter()
        .chain([f32::NAN, f32::INFINITY, f32::NEG_INFINITY]);
    let mut rng = Pcg32::new(8, 8);
    let numbers = edges.chain((0..139).map(|_| rng.next_u32() as f32 / 4_294_967_296.0));
    let numbers: Vec<f32> = numbers.collect();
    let at = |i: usize| numbers[i % numbers.len()];
    (0..numbers.len())
        .map(|i| [at(i), at(5 * i + 1), at(7 * i + 2), at(11 * i + 3)])
        .collect()
}

/// Whether `Warp::map` and `Warp::map_with_pdf` give what single calls give, bit for bit.
fn maps(warp: &dyn host::registry::Erased) -> bool {
    let u = hostile();
    let (points, with_densities) = warp.map(&u);
    assert_eq!((points.len(), with_densities.len()), (u.len(), u.len()));
    u.iter()
        .zip(points)
        .zip(with_densities)
        .all(|((&u, point), (same, density))| {
            let bits = |point: [f32; 3]| point.map(f32::to_bits);
            let (due, of_due) = warp.sample_with_pdf(u);
            bits(point) == bits(warp.sample(u))
                && bits(same) == bits(due)
                && density.to_bits() == of_due.to_bits()
        })
}

/// Over the whole registry, and a warp whose slices are wrong in one place.
#[test]
fn mapping_a_slice_is_sampling_one_by_one() {
    for entry in host::registry::entries() {
        assert!(maps(&*entry.warp), "{entry}");
    }
    assert!(maps(&*host::registry::erased(Off::<false>)));
    assert!(!maps(&*host::registry::erased(Off::<true>)));
}

/// The uniform itself; the tenth of a slice comes out wrong.
struct Off<const WRONG: bool>;

impl<const WRONG: bool> Warp for Off<WRONG> {
    type Uniforms = f32;
    type Point = f32;
    type Density = f32;

    fn sample_canonical(&self, u: Canonical<f32>) -> f32 {
        u.get()
    }
    fn pdf(&self, _: f32) -> f32 {
        1.0
    }
    fn map(&self, uniforms: &[f32], points: &mut [f32]) {
        for (i, (point, &u)) in points.iter_mut().zip(uniforms).enumerate() {
            *point = self.sample(if WRONG && i == 20 { 1.0 - u } else { u });
        }
    }
}

impl<const WRONG: bool> Invert for Off<WRONG> {
    fn invert(&self, x: f32) -> f32 {
        x
    }
}

/// The shortest slice counts, and the rest is untouched.
#[test]
fn a_mapped_slice_ends_with_the_shortest() {
    let disk = poly::Disk::new();
    let uniforms = [[0.25, 0.5]; 20];
    let due = disk.sample(uniforms[0]);
    let mut points = [[9.0; 2]; 20];
    disk.map(&uniforms[..10], &mut points);
    assert!(points[..10].iter().all(|&point| point == due));
    assert_eq!(points[10..], [[9.0; 2]; 10]);
    disk.map(&uniforms, &mut points[..12]);
    assert_eq!(points[11..13], [due, [9.0; 2]]);
    let mut densities = [7.0; 3];
    disk.map_with_pdf(&uniforms, &mut points, &mut densities);
    assert_eq!(densities, [disk.pdf(due); 3]);
    assert_eq!(points[12], [9.0; 2]);
    disk.map(&[], &mut []);
}

/// Over the whole registry: by whichever way a point is drawn, it is the same. Where a draw takes more words than there
/// are uniforms, those of one number alone make another.
#[test]
fn every_way_to_draw_gives_the_same_point() {
    for entry in host::registry::entries() {
        for seed in 0..20 {
            let ways = entry.warp.ways(&Pcg32::new(seed, 8));
            assert_eq!(ways.len(), 4);
            let due = ways[0].1.map(f32::to_bits);
            for (way, point) in ways {
                if entry.words == entry.uniforms || way != "of words" {
                    assert_eq!(point.map(f32::to_bits), due, "{entry}: {way}");
                }
            }
        }
    }
}

/// What a warp yields by each of its methods that take uniforms or a generator, as text, which tells all numbers apart.
fn all_that_is_drawn<W: Warp>(warp: &W, seed: u64) -> String
where
    W::Point: std::fmt::Debug,
    W::Density: std::fmt::Debug,
{
    let rng = || Pcg32::new(seed, 8);
    let words = W::Uniforms::try_words(&mut rng()).unwrap();
    let u = W::Uniforms::from_words(words);
    let mut points = [warp.draw(&mut rng()); 9];
    let mut both = [warp.draw_with_pdf(&mut rng()); 9];
    let drawn = (points[0], both[0]);
    warp.fill(&mut rng(), &mut points);
    warp.fill_with_pdf(&mut rng(), &mut both);
    let sampled = (
        warp.sample_canonical(u),
        warp.sample_canonical_with_pdf(u),
        warp.sample_words(words),
    );
    format!("{:?}", (drawn, points, both, sampled))
}

/// A reference and a change of variables that changes nothing take every way that the warp takes.
fn are_drawn_alike<W: Warp<Density = f32>>(warp: &W)
where
    W::Point: std::fmt::Debug,
{
    let same = Transform::new(warp, |x| x, |x| x, |_| 1.0);
    for seed in 0..50 {
        let due = all_that_is_drawn(warp, seed);
        assert_eq!(all_that_is_drawn(&warp, seed), due);
        assert_eq!(all_that_is_drawn(&same, seed), due);
    }
}

/// Laws that draw deeply, that read words, whose density comes with the sample, that fill slices their own way, and plain ones.
#[test]
fn what_holds_a_warp_draws_as_it_does() {
    are_drawn_alike(&poly::Exponential::from_rate(2.0).unwrap());
    are_drawn_alike(&poly::Weibull::new(1.0, 0.2).unwrap());
    are_drawn_alike(&poly::Power::new(-0.5, 0.0, 4.0).unwrap());
    are_drawn_alike(&poly::LogNormal::new(0.0, 1.0).unwrap());
    are_drawn_alike(&poly::Normal::new(0.0, 1.0).unwrap());
    are_drawn_alike(&poly::Tent::new(1.5).unwrap());
    are_drawn_alike(&poly::PowerMax::<5>::new());
    are_drawn_alike(&poly::HenyeyGreenstein::new(0.7).unwrap());
    are_drawn_alike(&poly::Bilinear::new([[1.0, 2.0], [0.5, 3.0]]).unwrap());
    are_drawn_alike(&poly::Disk::new());
    are_drawn_alike(&PiecewiseConstant1d::new(&[2.0, 0.0, 4.0, 1.0], 0.0, 8.0).unwrap());
}

/// A deep draw, read through a wrapper as a plain one, is another point.
#[test]
fn a_wrapper_that_reads_the_grid_is_noticed() {
    struct Plain<W>(W);
    impl<W: Warp> Warp for Plain<W> {
        type Uniforms = W::Uniforms;
        type Point = W::Point;
        type Density = W::Density;
        fn sample_canonical(&self, u: Canonical<W::Uniforms>) -> W::Point {
            self.0.sample_canonical(u)
        }
        fn pdf(&self, x: W::Point) -> W::Density {
            self.0.pdf(x)
        }
    }
    let warp = poly::Weibull::new(1.0, 0.2).unwrap();
    let differs = |seed| all_that_is_drawn(&Plain(warp), seed) != all_that_is_drawn(&warp, seed);
    assert!((0..50).any(differs));
}

/// A generator of so many words.
struct Ending {
    rng: Pcg32,
    left: usize,
}

impl Ending {
    fn after(left: usize) -> Self {
        let rng = Pcg32::new(5, 5);
        Self { rng, left }
    }
}

impl TryRng for Ending {
    type Error = Broken;
    fn try_next_u32(&mut self) -> Result<u32, Broken> {
        self.left = self.left.checked_sub(1).ok_or(Broken(17))?;
        Ok(self.rng.next_u32())
    }
    fn try_next_u64(&mut self) -> Result<u64, Broken> {
        unreachable!("draws are counted in u32")
    }
    fn try_fill_bytes(&mut self, _: &mut [u8]) -> Result<(), Broken> {
        unreachable!("draws are counted in u32")
    }
}

/// Of a generator that fails after so many words the points before are those of a sound one.
fn fills_until_the_failure<W: Warp>(warp: &W, words: usize, blank: W::Point)
where
    W::Point: PartialEq + std::fmt::Debug,
{
    /// More than the longest block, and no multiple of any.
    const LENGTH: usize = 71;
    for good in 0..LENGTH * words {
        let mut points = [blank; LENGTH];
        let result = warp.try_fill(&mut Ending::after(good), &mut points);
        assert_eq!(result, Err(Broken(17)));
        let mut sound = Ending::after(usize::MAX);
        for (i, point) in points.into_iter().enumerate() {
            let due = if i < good / words {
                warp.try_draw(&mut sound).unwrap()
            } else {
                blank
            };
            assert_eq!(point, due, "{i} after {good} words");
        }
    }
    let mut points = [blank; LENGTH];
    assert!(
        warp.try_fill(&mut Ending::after(LENGTH * words), &mut points)
            .is_ok()
    );
}

#[test]
fn the_points_before_a_failure_are_in_place() {
    fills_until_the_failure(&poly::Disk::new(), 2, [9.0; 2]);
    fills_until_the_failure(&poly::Sphere::new(), 2, [9.0; 3]);
    fills_until_the_failure(&poly::Triangle::new(), 2, [9.0; 3]);
    fills_until_the_failure(&poly::Exponential::from_rate(1.0).unwrap(), 1, -1.0);
    fills_until_the_failure(&poly::Normal::new(1.0, 2.0).unwrap(), 1, -1.0);
    fills_until_the_failure(&poly::ExponentialTail::from_rate(1.0).unwrap(), 2, -1.0);
    fills_until_the_failure(&&libm::Hemisphere::new(), 2, [9.0; 3]);
}

/// How many points of slices differ from those one by one, over words and over uniforms of the same bits: every so many,
/// from 0 to the last.
fn differing(slices: &poly::Normal, single: &poly::Normal, step: usize) -> usize {
    const BLOCK: usize = 1 << 12;
    let differ = |points: &[f32], words: &[u32], one: &dyn Fn(u32) -> f32| {
        let pairs = points.iter().zip(words);
        let bits = pairs.map(|(point, &word)| (point.to_bits(), one(word).to_bits()));
        bits.filter(|(a, b)| a != b).count()
    };
    let mut all = (0..=u32::MAX).step_by(step);
    let mut found = 0;
    loop {
        let words: Vec<u32> = all.by_ref().take(BLOCK).collect();
        if words.is_empty() {
            return found;
        }
        let mut points = vec![0.0; words.len()];
        let mut next = words.iter();
        slices.fill(&mut FromFn(|| next.next().copied().unwrap()), &mut points);
        found += differ(&points, &words, &|word| single.sample_words(word));
        let uniforms: Vec<f32> = words.iter().map(|&word| f32::from_bits(word)).collect();
        slices.map(&uniforms, &mut points);
        found += differ(&points, &words, &|word| single.sample(f32::from_bits(word)));
    }
}

/// Slices of normals are computed without branches, and so in another way than one number.
#[test]
fn slices_of_normals_have_the_bits_of_single_ones() {
    let normal = poly::Normal::new(0.0, 1.0).unwrap();
    let step = if host::speed::full() { 101 } else { 65_521 };
    assert_eq!(differing(&normal, &normal, step), 0);
    let wider = poly::Normal::new(0.0, 1.0_f32.next_up()).unwrap();
    assert!(differing(&normal, &wider, 65_521) > 1_000);
}

#[test]
fn drawing_is_sampling_at_the_drawn_uniforms() {
    let disk = poly::Disk::new();
    let mut points = [[0.0; 2]; 100];
    disk.fill(&mut Pcg32::new(9, 9), &mut points);
    let (mut drawn, mut explicit) = (Pcg32::new(9, 9), Pcg32::new(9, 9));
    for point in points {
        assert_eq!(point, disk.draw(&mut drawn));
        let u = [uniform::grid(&mut explicit), uniform::grid(&mut explicit)];
        assert_eq!(point, disk.sample(u));
    }
    let tail = libm::ExponentialTail::from_rate(1.0).unwrap();
    let (mut drawn, mut explicit) = (Pcg32::new(9, 9), Pcg32::new(9, 9));
    for _ in 0..100 {
        assert_eq!(
            tail.draw(&mut drawn),
            tail.sample(uniform::full(&mut explicit))
        );
    }
}

/// A table draws from words and not from the grid: w of the 2³² words is the place w/2³² of the whole, and
/// the same as the grid's where the grid has it.
#[test]
fn drawing_from_a_table_is_the_exact_place_of_the_word() {
    let narrow = PiecewiseConstant1d::new(&[1.0, 0.0, 2.0, 1.0], 0.0, 8.0);
    let wide = PiecewiseConstant1d::new_u64(&[1.0, 0.0, 2.0, 1.0], 0.0, 8.0);
    let plane = PiecewiseConstant2d::new(&[[1.0, 3.0], [0.0, 4.0]], [0.0, 4.0], [0.0, 2.0]);
    let (narrow, wide, plane) = (narrow.unwrap(), wide.unwrap(), plane.unwrap());
    // Cells of [0, 8) with a quarter, nothing, a half and a quarter of the words.
    let place = |u: f64| match u {
        u if u < 0.25 => 8.0 * u,
        u if u < 0.75 => 4.0 + 4.0 * (u - 0.25),
        u => 6.0 + 8.0 * (u - 0.75),
    };
    let words = [
        0,
        1,
        255,
        0x3fff_ffff,
        0x4000_0000,
        0x4000_0001,
        0xbfff_ffff,
        0xc000_0000,
        !0,
    ];
    for word in words
        .into_iter()
        .chain((0..1000).map(|k: u32| k.wrapping_mul(0x9e37_79b9)))
    {
        let mut rng = Stuck(word);
        let u = f64::from(word) / 4_294_967_296.0;
        let x = narrow.draw(&mut rng);
        assert!((f64::from(x) - place(u)).abs() <= 4.8e-7, "{word:#x}: {x}");
        // The same word twice are 64 bits.
        let x = wide.draw(&mut rng);
        let u = u + f64::from(word) / 4_294_967_296.0 / 4_294_967_296.0;
        assert!((f64::from(x) - place(u)).abs() <= 4.8e-7, "{word:#x}: {x}");
        let mut coarse = Stuck(word & !0xff);
        let u = uniform::grid_from_word(word);
        assert_eq!(narrow.draw(&mut coarse), narrow.sample(u));
        assert_eq!(plane.draw(&mut coarse), plane.sample([u, u]));
    }
    // Below the grid, words still tell points apart.
    assert_eq!(
        [1, 2, 3].map(|w| narrow.draw(&mut Stuck(w))),
        [1.0, 2.0, 3.0].map(|w| w * 2f32.powi(-29))
    );
    // Along u first, then along v.
    let mut rng = Pcg32::new(4, 4);
    let drawn = plane.draw(&mut rng.clone());
    let (first, second) = (rng.next_u32(), rng.next_u32());
    let row = plane.marginal().draw(&mut Stuck(second));
    assert_eq!(drawn[1], row);
    let conditional = plane.conditional(plane.marginal().cell(row));
    assert_eq!(drawn[0], conditional.draw(&mut Stuck(first)));
}

#[test]
fn a_failing_generator_passes_its_error_on() {
    let disk = poly::Disk::new();
    assert_eq!(disk.try_draw(&mut failing(0)), Err(Broken(17)));
    assert_eq!(disk.try_draw(&mut failing(1)), Err(Broken(17)));
    assert!(disk.try_draw(&mut failing(2)).is_ok());
    let mut points = [[9.0; 2]; 4];
    assert_eq!(disk.try_fill(&mut failing(5), &mut points), Err(Broken(17)));
    assert!(points[1] != [9.0; 2] && points[2] == [9.0; 2]);
    assert_eq!(
        poly::ExponentialTail::from_rate(1.0)
            .unwrap()
            .try_draw(&mut failing(1)),
        Err(Broken(17))
    );
    let plane = |words| {
        PiecewiseConstant2d::new_u64(&[[1.0]], [0.0, 1.0], [0.0, 1.0])
            .unwrap()
            .try_draw(&mut failing(words))
    };
    assert_eq!(plane(3), Err(Broken(17)));
    assert_eq!(plane(4), Ok([0.5, 0.5]));
    assert_eq!(uniform::try_grid(&mut failing(0)), Err(Broken(17)));
    assert_eq!(uniform::try_open(&mut failing(0)), Err(Broken(17)));
    assert_eq!(uniform::try_full(&mut failing(1)), Err(Broken(17)));
    assert!(<[f32; 3]>::try_draw(&mut failing(2)).is_err());
    let strata = uniform::Strata2d::new(2, 2).unwrap();
    assert_eq!(strata.try_draw(0, &mut failing(1)), Err(Broken(17)));
}

#[test]
fn a_stuck_generator_draws_finite_points() {
    for word in [0, 1, 0x7fff_ffff, 0x8000_0000, u32::MAX] {
        let mut rng = Stuck(word);
        assert!(
            poly::Normal::new(0.0, 1.0)
                .unwrap()
                .draw(&mut rng)
                .is_finite()
        );
        assert!(
            poly::ExponentialTail::from_rate(1.0)
                .unwrap()
                .draw(&mut rng)
                .is_finite()
        );
        assert!(
            poly::PhongLobe::new(1e8)
                .unwrap()
                .draw(&mut rng)
                .iter()
                .all(|c| c.is_finite())
        );
        assert!(
            poly::NormalPair::new([0.0; 2], 1.0)
                .unwrap()
                .draw(&mut rng)
                .iter()
                .all(|c| c.is_finite())
        );
    }
}

#[test]
fn a_dyn_generator_will_do() {
    let mut pcg = Pcg32::new(3, 3);
    let rng: &mut dyn Rng = &mut pcg;
    assert!(poly::Disk::new().draw(rng)[0].abs() <= 1.0);
}

#[test]
fn a_closure_is_a_generator() {
    let mut count = 0_u32;
    let mut words = FromFn(|| {
        count += 1;
        count
    });
    assert_eq!(words.next_u32(), 1);
    assert_eq!(words.next_u64(), 0x0000_0003_0000_0002);
    let mut bytes = [0; 6];
    words.fill_bytes(&mut bytes);
    assert_eq!(bytes, [4, 0, 0, 0, 5, 0]);
    assert_eq!(count, 5);

    let mut wide = FromFn(|| 0x0123_4567_89ab_cdef_u64);
    assert_eq!(wide.next_u32(), 0x0123_4567);
    assert_eq!(wide.next_u64(), 0x0123_4567_89ab_cdef);
    let mut bytes = [0; 9];
    wide.fill_bytes(&mut bytes);
    assert_eq!(
        bytes,
        [0xef, 0xcd, 0xab, 0x89, 0x67, 0x45, 0x23, 0x01, 0xef]
    );

    let mut next = 0_u8;
    let mut narrow = FromFn(|| {
        next += 1;
        next
    });
    assert_eq!(narrow.next_u32(), 0x0403_0201);
    assert_eq!(narrow.next_u64(), 0x0c0b_0a09_0807_0605);
    let mut bytes = [0; 2];
    narrow.fill_bytes(&mut bytes);
    assert_eq!(bytes, [13, 14]);
}

/// Through a closure, a generator gives the points it gives by itself; a `&mut` to a closure serves as well.
#[test]
fn a_closure_changes_no_point() {
    let (mut rng, mut own) = (Pcg32::new(1, 1), Pcg32::new(1, 1));
    let mut closure = FromFn(|| own.next_u32());
    for _ in 0..100 {
        let expected = poly::Sphere::new().draw(&mut rng);
        assert_eq!(poly::Sphere::new().draw(&mut &mut closure), expected);
    }
}

#[test]
fn the_error_of_a_closure_is_passed_on() {
    let mut log = [1_u32, 2, 3].into_iter();
    let mut rng = FromFn(|| log.next().ok_or(Broken(1)));
    assert!(poly::Disk::new().try_draw(&mut rng).is_ok());
    assert_eq!(poly::Disk::new().try_draw(&mut rng), Err(Broken(1)));
    assert_eq!(rng.try_next_u64(), Err(Broken(1)));
    assert_eq!(rng.try_fill_bytes(&mut [0; 3]), Err(Broken(1)));
}

/// A PCG of other versions of `rand_core`; in version 0.6 it also fails, after some requests of bytes.
struct Older(Pcg32, u32);

impl rand_core_06::RngCore for Older {
    fn next_u32(&mut self) -> u32 {
        self.0.next_u32()
    }
    fn next_u64(&mut self) -> u64 {
        self.0.next_u64()
    }
    fn fill_bytes(&mut self, bytes: &mut [u8]) {
        self.0.fill_bytes(bytes);
    }
    fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), rand_core_06::Error> {
        let broken = std::num::NonZeroU32::new(rand_core_06::Error::CUSTOM_START + 7).unwrap();
        self.1 = self.1.checked_sub(1).ok_or(broken)?;
        self.0.fill_bytes(bytes);
        Ok(())
    }
}

impl rand_core_09::TryRngCore for Older {
    type Error = Broken;
    fn try_next_u32(&mut self) -> Result<u32, Broken> {
        self.1 = self.1.checked_sub(1).ok_or(Broken(1))?;
        Ok(self.0.next_u32())
    }
    fn try_next_u64(&mut self) -> Result<u64, Broken> {
        Ok(self.0.next_u64())
    }
    fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), Broken> {
        self.0.fill_bytes(bytes);
        Ok(())
    }
}

#[test]
fn generators_of_older_versions_give_the_same_points_and_their_errors() {
    let older = || Older(Pcg32::new(1, 1), 3);
    let disk = poly::Disk::new();
    let expected = disk.draw(&mut Pcg32::new(1, 1));
    assert_eq!(disk.draw(&mut Rng06(&mut older())), expected);

    let mut rng = TryRng06(older());
    assert_eq!(disk.try_draw(&mut rng).unwrap(), expected);
    let error = disk.try_draw(&mut rng).unwrap_err();
    assert_eq!(error.0.code().unwrap().get() & 0xff, 7);
    assert!(!error.to_string().is_empty());

    let mut rng = Rng09(older());
    assert_eq!(disk.try_draw(&mut rng), Ok(expected));
    assert_eq!(disk.try_draw(&mut rng), Err(Broken(1)));
    // In whole, each asks for what it is asked for.
    let mut plain = Pcg32::new(1, 1);
    let (mut six, mut nine) = (Rng06(older()), Rng09(older()));
    assert_eq!(plain.next_u64(), six.next_u64());
    let mut bytes = [[0; 5]; 2];
    plain.fill_bytes(&mut bytes[0]);
    six.fill_bytes(&mut bytes[1]);
    assert_eq!(bytes[0], bytes[1]);
    let mut plain = Pcg32::new(1, 1);
    assert_eq!(nine.try_next_u64(), Ok(plain.next_u64()));
    assert_eq!(nine.try_fill_bytes(&mut bytes[1]), Ok(()));
    plain.fill_bytes(&mut bytes[0]);
    assert_eq!(bytes[0], bytes[1]);
}
