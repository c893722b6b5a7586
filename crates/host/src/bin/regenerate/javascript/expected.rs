//! What the package's tests compare with, computed by the crate on the host: bits as integers.

use super::{Class, Golden};
use microwarp::discrete::{
    self as mw, Alias, AliasEntry, Binomial, Cdf, DiscreteGaussian, DiscreteLaplace, InvertParts,
    LatLongMap, LightReservoir, PiecewiseConstant1d, PiecewiseConstant2d, PiecewiseLinear1d,
    SumTree, WeightedReservoir,
};
use microwarp::estimate::{balance_heuristic_of, power_heuristic_of, roulette};
use microwarp::metropolis::{
    BoxStep, Chain, Mixture, Mutation, NormalStep, RandomWalk, WrappedWalk,
};
use microwarp::rejection::Rejection;
use microwarp::uniform::{
    ByPosition, Chance, LatinHypercube, Permutation, Points, Range, Screen, Sobol, Strata1d,
    Strata2d, grid, shuffle, up_to,
};
use microwarp::warp::{Frame, LightSample, Reflected, SurfacePoint};
use microwarp::{Error, Invert, Warp, poly, tier::Poly};
use microwarp_host::upkeep::Outcome;
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;

/// Weights with zeros and decades.
const WEIGHTS: [f32; 6] = [0.0, 1.0, 1e-6, 37.0, 0.3, 0.0];
const CELLS: [[f32; 3]; 2] = [[1.0, 0.0, 4.0], [2.5, 1e-3, 0.5]];

/// One number or several, as bits.
pub trait Bits: Copy {
    fn bits(self) -> Vec<u32>;
}
impl Bits for f32 {
    fn bits(self) -> Vec<u32> {
        vec![self.to_bits()]
    }
}
impl<const N: usize> Bits for [f32; N] {
    fn bits(self) -> Vec<u32> {
        self.map(f32::to_bits).into()
    }
}

impl<const N: usize> Bits for ([f32; N], f32) {
    fn bits(self) -> Vec<u32> {
        [self.0.bits(), self.1.bits()].concat()
    }
}
impl Bits for SurfacePoint {
    fn bits(self) -> Vec<u32> {
        [self.position.bits(), self.normal.bits()].concat()
    }
}

fn rng() -> Pcg32 {
    Pcg32::new(42, 54)
}

fn list(bits: impl IntoIterator<Item = u32>) -> String {
    let bits: Vec<String> = bits.into_iter().map(|bits| bits.to_string()).collect();
    format!("[{}]", bits.join(","))
}

/// So many points by `fill`, more than a block of them.
fn filled<W: Warp<Point: Bits + Default>>(warp: &W) -> String {
    let mut points = vec![W::Point::default(); 19];
    warp.fill(&mut rng(), &mut points);
    list(points.into_iter().flat_map(Bits::bits))
}

/// Drawn points with their densities and inverses.
fn triples<W>(warp: &W) -> String
where
    W: Invert<Density = f32, Point: Bits, Uniforms: Bits>,
{
    let mut rng = rng();
    let triples = (0..8).flat_map(|_| {
        let point = warp.draw(&mut rng);
        [
            point.bits(),
            warp.pdf(point).bits(),
            warp.invert(point).bits(),
        ]
        .concat()
    });
    list(triples)
}

/// Two points and their densities: drawn, and by the uniforms of these.
pub fn with_densities<W>(warp: Result<W, Error>) -> Vec<u32>
where
    W: Invert<Density = f32, Point: Bits>,
{
    let (warp, mut rng) = (warp.expect("a golden subject"), rng());
    let found = (0..2).flat_map(|_| {
        let drawn = warp.draw_with_pdf(&mut rng);
        [drawn, warp.sample_with_pdf(warp.invert(drawn.0))]
    });
    found
        .flat_map(|(point, pdf)| [point.bits(), pdf.bits()].concat())
        .collect()
}

/// Of a mixture a point of each generator with its density and the inverse by a uniform, and both points with their densities;
/// and the probabilities of the first parts.
fn mixed<P: InvertParts<N> + Copy, const N: usize>(parts: P, weights: [f32; N]) -> Vec<u32>
where
    P::Point: Bits,
    P::Uniforms: Bits,
{
    let mixture = mw::Mixture::new(parts, &weights).expect("accepted weights");
    let points = (0..16_u16).flat_map(|i| {
        let (rng, u) = (|| Pcg32::new((42 + i).into(), 54), f32::from(i) / 16.0);
        let x = mixture.draw(&mut rng());
        let inverse = mixture.invert_with(x, u);
        let both = [
            mixture.draw_with_pdf(&mut rng()),
            mixture.sample_with_pdf(inverse),
        ];
        let both = both
            .map(|(x, pdf)| [x.bits(), pdf.bits()].concat())
            .concat();
        [x.bits(), mixture.pdf(x).bits(), inverse.bits(), both].concat()
    });
    let pmfs = (0..3).map(|part| mixture.pmf(part).to_bits());
    points.chain(pmfs).collect()
}

/// Parts of one type and of two, with as many words and not, alone and as many as there may be; warps and tables.
fn mixtures() -> String {
    let ok = "accepted parameters";
    let normal = |mean, deviation| poly::Normal::new(mean, deviation).expect(ok);
    let peaks = [normal(0.0, 1.0), normal(9.0, 0.1), normal(-3.0, 2.0)];
    let tail = poly::ExponentialTail::from_rate(1.5).expect(ok);
    let steps: [f32; 32] = std::array::from_fn(|i| i as f32);
    let intervals = steps.map(|low| poly::Interval::new(low, 40.0).expect(ok));
    let ramp = PiecewiseLinear1d::<[u32; 6], _>::new(&WEIGHTS, -3.0, 5.0).expect(ok);
    let sky = LatLongMap::<Poly, [u32; 2], [[u32; 3]; 2]>::new(&CELLS).expect(ok);
    let box_of = |low| poly::BoxSurface::new([low; 3], [1.0, 2.0, 3.0]).expect(ok);
    let disk = [poly::Disk::new()];
    let directions = (poly::Sphere::new(), poly::CosineHemisphere::new());
    let shares = [poly::Simplex::<2>::new(), poly::Simplex::new()];
    list(
        [
            mixed(peaks, [0.3, 0.0, 1e-7]),
            mixed(disk, [7.0]),
            mixed(directions, [1.0, 2.0]),
            mixed(
                (tail, poly::Exponential::from_rate(0.5).expect(ok)),
                [3.0, 1.0],
            ),
            mixed(intervals, steps.map(|i| (i * 5.0) % 7.0)),
            mixed((ramp, normal(1.0, 1.0)), [1.0, 1.0]),
            mixed((poly::Hemisphere::new(), sky), [1.0, 5.0]),
            mixed([box_of(0.0), box_of(0.9)], [1e-3, 1.0]),
            mixed(shares, [1.0, 2.0]),
        ]
        .concat(),
    )
}

/// What a reservoir of lights says.
fn held(of: &LightReservoir<u32>) -> [u32; 4] {
    let item = of.item().copied().unwrap_or(u32::MAX);
    let [target, contribution] = [of.target(), of.contribution()].map(f32::to_bits);
    [item, of.count(), target, contribution]
}

/// Two streams of candidates, one capped, normalised and merged into the other.
fn lights() -> String {
    let (mut rng, mut found) = (rng(), Vec::new());
    let [mut one, mut two] = [LightReservoir::new(); 2];
    for i in 0..60_u16 {
        let scale = [1.0, 1e30, 1e-30][usize::from(i / 7 % 3)];
        let target = f32::from(i * 7 % 11) * scale;
        let density = [0.5, 1e-20, 3e5][usize::from(i % 3)];
        let of = if i % 4 == 0 { &mut two } else { &mut one };
        let taken = of.offer(i.into(), target, density, &mut rng);
        found.push(taken.expect("accepted numbers").into());
        found.extend(held(of));
    }
    for limit in [7, 1_000_000_000, 0] {
        let taken = two.absorb(one, 0.25, &mut rng);
        found.push(taken.expect("an accepted target").into());
        found.extend(held(&two));
        two.normalise(5);
        found.extend(held(&two));
        one.cap(limit);
        found.extend(held(&one));
    }
    list(found)
}

/// Uniforms in range and out of it.
const PAIRS: [[f32; 2]; 4] = [[0.25, 0.5], [0.0, 0.0], [0.9, 0.999], [f32::NAN, 2.0]];

fn lamps() -> String {
    let ok = "an accepted lamp";
    let seen = |lamp: LightSample| {
        let ends = [lamp.distance, lamp.pdf, lamp.place[0], lamp.place[1]];
        [lamp.direction.bits(), ends.bits()].concat()
    };
    let mut found = Vec::new();
    macro_rules! lamp {
        ($lamp:expr) => {{
            let (lamp, mut rng) = ($lamp.expect(ok), rng());
            found.extend(lamp.density().bits());
            found.extend((0..4).flat_map(|_| seen(lamp.draw_light(&mut rng))));
            found.extend(PAIRS.into_iter().flat_map(|u| seen(lamp.sample_light(u))));
        }};
    }
    let corners = [[-0.6, -0.5, 0.8], [0.7, -0.4, 0.9], [0.1, 0.8, 0.6]];
    let edges = [[1.2, 0.1, 0.1], [-0.1, 1.0, 0.2]];
    lamp!(poly::VisibleSphere::new([0.0; 3], [0.0, 3.0, 4.0], 0.5));
    lamp!(poly::VisibleSphere::new(
        [1.0, 2.0, -2.0],
        [0.1, 0.0, 0.0],
        3.0
    ));
    lamp!(poly::SphericalTriangle::new([0.0; 3], corners));
    lamp!(poly::SphericalRectangle::new([0.0; 3], corners[0], edges));
    list(found)
}

fn reflections() -> String {
    let (ok, alpha) = ("an accepted surface", [0.05, 0.8]);
    let surface = poly::Ggx::new(alpha).expect(ok);
    let glosses = [
        poly::GgxVisible::new([0.6, 0.0, 0.8], alpha).expect(ok),
        poly::GgxVisible::bounded([0.5, -0.7, 0.1], alpha).expect(ok),
    ];
    let found = glosses.into_iter().flat_map(|gloss| {
        let mut rng = rng();
        let mut bounces: Vec<_> = (0..4).map(|_| gloss.draw_reflection(&mut rng)).collect();
        bounces.extend(PAIRS.map(|u| gloss.reflect(u)));
        let of = bounces.into_iter().flat_map(|bounce| {
            let (m, l) = (bounce.normal, bounce.direction);
            let figures = [
                bounce.pdf,
                gloss.reflected_pdf(m),
                gloss.unmasked(l),
                gloss.visibility(l),
                surface.distribution(m),
                surface.g1(l),
            ];
            [m.bits(), l.bits(), figures.bits()].concat()
        });
        let mut of: Vec<u32> = of.collect();
        of.extend(gloss.g1().bits());
        of.extend(with_densities(Ok(Reflected::new(gloss))));
        of
    });
    list(found)
}

/// Weights of three techniques, and what goes on by any chance.
fn techniques() -> String {
    let (mut rng, mut found) = (rng(), Vec::new());
    let counts = [1, 1 << 20, 7];
    for densities in [
        [1.0, 3.0, 0.25],
        [3e38, 1e30, 1e38],
        [1e-38, 1e-44, 0.0],
        [f32::NAN, f32::INFINITY, 1.0],
        [-1.0, 0.0, 0.0],
    ] {
        for own in 0..3 {
            found.extend(balance_heuristic_of(&counts, &densities, own).bits());
            found.extend(power_heuristic_of(&counts, &densities, own).bits());
        }
    }
    for _ in 0..8 {
        for chance in [0.25, 1e-5, 0.95, 1.0, 2.0, f32::NAN, -1.0, 0.0] {
            found.extend(roulette(chance, rng.next_u32()).unwrap_or(0.0).bits());
        }
    }
    list(found)
}

/// Indices drawn, and selections by uniforms.
macro_rules! selections {
    ($table:expr) => {{
        let (table, mut rng) = ($table, rng());
        let drawn: Vec<u32> = (0..64).map(|_| table.draw_index(&mut rng) as u32).collect();
        let selected = [0.0, 0.3, 0.999].map(|u| table.select_uniform(u));
        let selected = selected.map(|s| [s.index as u32, s.pmf.to_bits(), s.leftover.to_bits()]);
        list(drawn.into_iter().chain(selected.concat()))
    }};
}

/// The first items of shuffles, and the word behind those that were drawn.
fn shuffles() -> String {
    let shuffles = [2, 12, 13, 52, 1000].map(|count| {
        let (mut items, mut rng) = ((0..count).collect::<Vec<u32>>(), rng());
        shuffle(&mut items, &mut rng);
        items.truncate(20);
        items.push(rng.next_u32());
        items
    });
    list(shuffles.concat())
}

/// Numbers at places and places of numbers.
fn permutations() -> String {
    let orders = [1, 16, 17, 1000, (1 << 31) + 1, u32::MAX].map(|count| {
        let order = Permutation::new(count, 7).expect("there are numbers");
        [0, count - 1, (count - 1) / 2]
            .map(|i| [order.get(i), order.index_of(i)].map(|found| found.expect("it is below")))
    });
    list(orders.concat().concat())
}

/// Indices drawn from weights that change, some without replacement, and the weights at the end.
fn changing() -> String {
    let (mut weights, mut rng) = ([3_u32, 0, 5, 1 << 31, 7, 1 << 30], rng());
    let mut tree = SumTree::new_in(&mut weights).expect("weights");
    let mut found = Vec::new();
    for k in 0..32_u32 {
        let index = tree.draw_index(&mut rng).expect("one is positive");
        let before = tree.set(index, k.wrapping_mul(0x9e37_79b9) >> (k & 7) >> 5);
        found.extend([index as u32, before.expect("it fits")]);
    }
    let mut places = [(0, 0); 4];
    let drawn = tree.draw_distinct(&mut places, &mut rng);
    found.extend(drawn.iter().map(|(index, _)| *index as u32));
    found.extend((0..6).map(|index| tree.pmf(index).to_bits()));
    found.push(tree.total());
    found.extend(*tree.into_weights());
    list(found)
}

fn halves(x: u64) -> [u32; 2] {
    [(x >> 32) as u32, x as u32]
}

/// The same of 64 bits.
fn changing_wide() -> String {
    let weights = [3, 0, 5 << 40, 1 << 62, 7, 1 << 60];
    let (mut tree, mut rng) = (SumTree::new_u64(weights).expect("weights"), rng());
    let mut found = Vec::new();
    for k in 0..32_u64 {
        let index = tree.draw_index(&mut rng).expect("one is positive");
        let weight = k.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> (k & 7) >> 5;
        found.push(index as u32);
        found.extend(halves(tree.set(index, weight).expect("it fits")));
    }
    let mut places = [(0, 0); 4];
    let drawn = tree.draw_distinct(&mut places, &mut rng);
    found.extend(drawn.iter().map(|(index, _)| *index as u32));
    found.extend((0..6).map(|index| tree.pmf(index).to_bits()));
    found.extend(halves(tree.total()));
    found.extend(tree.into_weights().into_iter().flat_map(halves));
    list(found)
}

/// What is held of a stream, and of its parts together.
fn streams() -> String {
    let mut rng = rng();
    let [mut whole, mut even, mut odd] = [WeightedReservoir::<u32, 5>::new(); 3];
    for i in 0..200_u32 {
        let weight = i.wrapping_mul(0x9e37_79b9) >> (i % 20);
        let word = rng.next_u32();
        whole.offer_with(i, weight, word);
        if i % 2 == 0 { &mut even } else { &mut odd }.offer_with(i, weight, word);
    }
    let parts = [even, odd].map(|part| part.items().copied().collect::<Vec<u32>>());
    even.merge(odd);
    assert_eq!(even, whole, "parts hold what the whole does");
    list(parts.concat().into_iter().chain(whole.items().copied()))
}

/// Counts, and probabilities of some.
fn successes() -> String {
    let ok = "accepted parameters";
    let mut rng = rng();
    let mut found = Vec::new();
    for law in [
        Binomial::new(100, 0.3).expect(ok),
        Binomial::from_ratio(1000, 1, 20).expect(ok),
    ] {
        found.extend((0..40).map(|_| law.draw(&mut rng)));
        found.extend([0, 30, 99, 1001].map(|count| law.pmf(count).to_bits()));
        found.push(law.count(1 << 31));
    }
    list(found)
}

fn rejected() -> String {
    let law = poly::BinomialRejection::new(1_000_000, 0.3).expect("accepted parameters");
    let mut rng = rng();
    let drawn = (0..40).map(|_| law.draw(&mut rng).expect("within the budget").point);
    let drawn: Vec<u32> = drawn.collect();
    let pmf = [300_000, 0, 299_000].map(|count| law.pmf(count).to_bits());
    list(drawn.into_iter().chain(pmf))
}

/// Integers about a centre and about 0, with probabilities of some.
fn around() -> String {
    let ok = "accepted parameters";
    let mut rng = rng();
    let mut found = Vec::new();
    for (centre, scale) in [(0.25, 3.0), (-1e6 - 0.5, 20.0)] {
        let law = DiscreteGaussian::new(centre, scale).expect(ok);
        found.extend((0..40).map(|_| law.draw(&mut rng) as u32));
        found.extend([0, -1_000_001].map(|integer| law.pmf(integer).to_bits()));
        found.extend([0, 1 << 31, u32::MAX].map(|word| law.integer(word) as u32));
    }
    for law in [DiscreteLaplace::new(1e6), DiscreteLaplace::from_ratio(5, 2)] {
        let law = law.expect(ok);
        found.extend((0..40).map(|_| law.draw(&mut rng) as u32));
        found.extend([0, -3, i32::MIN].map(|integer| law.pmf(integer).to_bits()));
        found.extend([0, 1 << 31, u32::MAX].map(|word| law.integer(word) as u32));
    }
    list(found)
}

/// Points by rejection with their densities.
fn accepted<P: Bits>(law: &impl Rejection<Point = P>, pdf: impl Fn(P) -> f32) -> Vec<u32> {
    let mut rng = rng();
    let drawn = (0..40).map(|_| law.draw(&mut rng).expect("within the budget").point);
    drawn
        .flat_map(|point| [point.bits(), vec![pdf(point).to_bits()]].concat())
        .collect()
}

fn gammas() -> String {
    let ok = "accepted parameters";
    let laws = [
        poly::Gamma::new(2.5, 4.0),
        poly::Gamma::new(1e-3, 1.0),
        poly::Gamma::new(1.0, 0.5),
        poly::Gamma::chi_squared(3.0),
    ];
    list(laws.into_iter().flat_map(|law| {
        let law = law.expect(ok);
        let mut rng = rng();
        let lns = (0..40).map(|_| law.draw_ln(&mut rng).expect("within the budget").point);
        let lns: Vec<u32> = lns.map(f32::to_bits).collect();
        [accepted(&law, |x| law.pdf(x)), lns].concat()
    }))
}

fn shares<const N: usize>(shapes: [f32; N]) -> Vec<u32> {
    let law = poly::Dirichlet::new(shapes).expect("accepted parameters");
    accepted(&law, |shares| law.pdf(shares))
}

/// Each number of shares.
fn dirichlets() -> String {
    list(
        [
            shares([1.0, 0.1]),
            shares([4.0, 2.0, 0.5]),
            shares([1.0, 1e-3, 1e-3, 7.0]),
            shares([100.0, 2.0, 3.0, 1e6, 1.0]),
            shares([0.5; 6]),
            shares([1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]),
            shares([1e-20; 8]),
        ]
        .concat(),
    )
}

fn angles() -> String {
    let laws = [(1.0, 10.0), (-6.0, 1e-20), (3.0, 1e6), (0.0, 0.0)];
    list(laws.into_iter().flat_map(|(mean, concentration)| {
        let law = poly::VonMises::new(mean, concentration).expect("accepted parameters");
        accepted(&law, |x| law.pdf(x))
    }))
}

/// By a generator, and by a set of points of which some are rejected first.
fn beta() -> String {
    let ok = "accepted parameters";
    let (law, set) = (
        poly::Beta::new(2.0, 5e-3).expect(ok),
        Sobol::<8>::new(7).expect(ok),
    );
    let of_points = (0..100).flat_map(|index| {
        let drawn = law.draw(&mut set.at(index)).expect("within the budget");
        drawn.point.bits()
    });
    let of_points: Vec<u32> = of_points.collect();
    list([accepted(&law, |shares| law.pdf(shares)), of_points].concat())
}

/// Integers by two words.
fn wide_integers() -> String {
    let ok = "accepted parameters";
    let (mut rng, mut drawn) = (rng(), Vec::new());
    for n in [1, 2, 6, 52, 1000, 65_537, 3 << 29, u32::MAX] {
        let half = (n / 2) as i32;
        drawn.push(Range::below(n).expect(ok).draw_wide(&mut rng));
        let range = Range::signed(-half, half).expect(ok);
        drawn.push(range.draw_wide(&mut rng) as u32);
        drawn.push(range.draw(&mut rng) as u32);
    }
    for (low, high) in [
        (0, 5),
        (7, 1 << 40),
        (0, u64::MAX),
        (u64::MAX - 3, u64::MAX),
    ] {
        let range = Range::of_u64(low, high).expect(ok);
        drawn.extend((0..10).flat_map(|_| halves(range.draw(&mut rng))));
    }
    let all = Range::of_u64(0, u64::MAX).expect(ok);
    drawn.extend(halves(all.draw(&mut Sobol::<8>::new(7).expect(ok).at(3))));
    list(drawn)
}

/// A target that floats of one precision compute exactly alike.
fn target([x, y]: [f32; 2]) -> f32 {
    1.0 / (1.0 + (x * x + y * y))
}

/// The states of a chain.
fn chain(mutation: impl Mutation<[f32; 2]>) -> String {
    let mut chain = Chain::new([0.25, 0.5], target).expect("the target is positive there");
    let mut rng = rng();
    let states = (0..32).flat_map(|_| {
        let step = chain.step(target, &mutation, &mut rng);
        [step.state().bits(), step.acceptance.bits()].concat()
    });
    list(states)
}

/// What a constructor is called with: its arguments in JSON, out of `Name::<..>::new(..)`, perhaps within `Ok(..)`.
fn arguments(text: &str) -> Outcome<(Option<usize>, &str, String)> {
    let wrong = || format!("no constructor in {text}");
    let (path, rest) = text
        .trim_start_matches("Ok(")
        .split_once('(')
        .ok_or_else(wrong)?;
    let (kind, new) = path.rsplit_once("::").ok_or_else(wrong)?;
    let digits: String = kind.chars().filter(char::is_ascii_digit).collect();
    // Rust's writing of numbers, and the function that hides a parameter.
    let mut json = rest.trim_end_matches(')').replace(['_', '\n'], "");
    for hidden in ["v(", "blackbox(", "("] {
        json = json.replace(hidden, "");
    }
    json = json.replace([')', ' '], "");
    while let Some((before, after)) = json.clone().split_once(';') {
        let (count, after) = after.split_once(']').ok_or_else(wrong)?;
        let (before, item) = before.rsplit_once('[').ok_or_else(wrong)?;
        let items = vec![item; count.parse().map_err(|_| wrong())?];
        json = format!("{before}[{}]{after}", items.join(","));
    }
    for (rust, here) in [(",]", "]"), (".,", ".0,"), (".]", ".0]")] {
        json = json.replace(rust, here);
    }
    Ok((
        digits.parse().ok(),
        new.trim(),
        format!("[{}]", json.trim_end_matches(',')),
    ))
}

/// The golden subjects with the class, the constructor and the arguments of each.
fn golden(classes: &[Class], goldens: &[(&str, Golden)]) -> Outcome<String> {
    let mut lines = Vec::new();
    for (block, subjects) in goldens {
        for (name, text) in subjects {
            let (size, new, arguments) = arguments(text)?;
            let numbers = arguments.split([',', '[', ']']);
            let numbers = numbers.filter(|number| !number.is_empty()).count();
            let class = classes.iter().find(|class| {
                let constructor = class.constructors.iter().find(|c| c.rust == new);
                class.block == *block
                    && (size.is_none() || size == class.size)
                    && constructor.is_some_and(|c| c.lengths().iter().sum::<usize>() == numbers)
            });
            let class = class.ok_or_else(|| format!("no class for {name}"))?;
            lines.push(format!(
                "    [{name:?}, {:?}, {:?}, {arguments}]",
                class.name,
                super::camel(new, false)
            ));
        }
    }
    Ok(lines.join(",\n"))
}

/// Integers, coins and uniforms, in turns, so that each starts anew where another has ended; then of one kind in a row.
fn screen() -> Vec<u32> {
    let ok = "accepted parameters";
    let set = Sobol::<8>::new(7).expect(ok);
    let screen = Screen::new(set, [640, 480], 4, 7).expect(ok);
    let pixels = [[0, 0], [7, 100], [639, 479]].map(|[x, y]| screen.pixel(x, y));
    let samples = pixels.map(|pixel| [0, 1, 15, 16, 100].map(|sample| pixel.words::<4>(sample)));
    samples.into_iter().flatten().flatten().collect()
}

fn frames() -> Vec<u32> {
    let normals = [
        [0.0, 0.0, 1.0],
        [0.6, -3.0, 0.1],
        [0.0, 0.0, -1e-30],
        [1e30, 2e30, -3e30],
    ];
    let turned = normals.map(|normal| {
        let frame = Frame::new(normal).expect("a normal");
        let direction = [0.36, -0.48, 0.8];
        [frame.to_world(direction), frame.to_local(direction)]
    });
    turned
        .into_iter()
        .flatten()
        .flatten()
        .map(f32::to_bits)
        .collect()
}

fn integers() -> Vec<u32> {
    let ok = "accepted parameters";
    let (mut rng, mut drawn) = (Pcg32::new(42, 54), Vec::new());
    for n in [1, 2, 6, 52, 1000, 65_537, 3 << 29, u32::MAX] {
        let half = (n / 2) as i32;
        drawn.push(Range::below(n).expect(ok).draw(&mut rng));
        drawn.push(up_to(u32::MAX, &mut rng));
        let range = Range::signed(-half, half).expect(ok);
        drawn.push(range.draw(&mut rng) as u32);
        let p = 1.0 / n as f32;
        drawn.push(Chance::new(p).expect(ok).draw(&mut rng).into());
        drawn.push(grid(&mut rng).to_bits());
    }
    let (die, coin) = (Range::new(1, 6).expect(ok), Chance::new(0.1).expect(ok));
    drawn.extend((0..200).map(|_| die.draw(&mut rng)));
    drawn.extend((0..200).map(|_| u32::from(coin.draw(&mut rng))));
    drawn.extend(Sobol::<8>::new(7).expect(ok).words::<1>(3));
    drawn
}

pub fn json(
    classes: &[Class],
    goldens: &[(&str, Golden)],
    densities: &[(&str, Vec<u32>)],
) -> Outcome<String> {
    let ok = "accepted parameters";
    let cells = |u, v| PiecewiseConstant2d::<_, [[u32; 3]; 2]>::new(&CELLS, u, v).expect(ok);
    let points = |words: [[u32; 4]; 6]| list(words.into_iter().flatten());
    let strata: Vec<u32> = (0..6)
        .flat_map(|k| {
            let [x, y] = Strata2d::new(3, 2).expect(ok).point(k, [0.25, 0.75]);
            [x, y, Strata1d::new(6).expect(ok).point(k, 0.25)].bits()
        })
        .collect();
    let mut order: [u32; 30] = std::array::from_fn(|item| item as u32);
    shuffle(&mut order, &mut Sobol::<8>::new(7).expect(ok).at(3));
    let runs = [
        ("Normal", filled(&poly::Normal::new(10.0, 2.0).expect(ok))),
        (
            "NormalPair",
            filled(&poly::NormalPair::new([1.0, -1.0], 0.5).expect(ok)),
        ),
        (
            "Exponential",
            filled(&poly::Exponential::from_rate(1.5).expect(ok)),
        ),
        (
            "ExponentialTail",
            filled(&poly::ExponentialTail::from_rate(1.5).expect(ok)),
        ),
        ("Sphere", filled(&poly::Sphere::new())),
        ("Disk", filled(&poly::Disk::new())),
        (
            "Cdf",
            selections!(Cdf::<[u32; 6]>::new(&WEIGHTS).expect(ok)),
        ),
        (
            "Alias",
            selections!(Alias::<[AliasEntry<u32>; 8]>::new(&WEIGHTS).expect(ok)),
        ),
        ("Mixture", mixtures()),
        ("SumTree", changing()),
        ("SumTree of 64 bits", changing_wide()),
        ("WeightedReservoir", streams()),
        ("LightReservoir", lights()),
        ("lamps", lamps()),
        ("reflections", reflections()),
        ("techniques", techniques()),
        ("Binomial", successes()),
        ("BinomialRejection", rejected()),
        ("discrete laws", around()),
        ("Gamma", gammas()),
        ("Beta", beta()),
        ("Dirichlet", dirichlets()),
        ("VonMises", angles()),
        (
            "PiecewiseConstant1d",
            triples(&PiecewiseConstant1d::<[u32; 6]>::new(&WEIGHTS, -3.0, 5.0).expect(ok)),
        ),
        (
            "PiecewiseLinear1d",
            triples(&PiecewiseLinear1d::<[u32; 6], _>::new(&WEIGHTS, -3.0, 5.0).expect(ok)),
        ),
        (
            "PiecewiseConstant2d",
            triples(&cells([0.0, 6.0], [-1.0, 1.0])),
        ),
        (
            "LatLongMap",
            triples(&LatLongMap::<Poly, [u32; 2], [[u32; 3]; 2]>::new(&CELLS).expect(ok)),
        ),
        (
            "densities of tables",
            list(
                [
                    with_densities(PiecewiseConstant1d::<[u32; 6]>::new(&WEIGHTS, -3.0, 5.0)),
                    with_densities(PiecewiseLinear1d::<[u32; 6], _>::new(&WEIGHTS, -3.0, 5.0)),
                    with_densities(Ok(cells([0.0, 6.0], [-1.0, 1.0]))),
                    with_densities(LatLongMap::<Poly, [u32; 2], [[u32; 3]; 2]>::new(&CELLS)),
                ]
                .concat(),
            ),
        ),
        (
            "Sobol",
            points([0, 1, 2, 3, 100, 101].map(|i| Sobol::<8>::new(7).expect(ok).words(i))),
        ),
        (
            "ByPosition",
            points([0, 1, 2, 3, 100, 101].map(|i| ByPosition::new(7, 9).words(i))),
        ),
        (
            "LatinHypercube",
            points([0, 1, 2, 3, 58, 101].map(|i| LatinHypercube::new(59, 7).expect(ok).words(i))),
        ),
        ("Screen", list(screen())),
        ("Frame", list(frames())),
        ("Strata", list(strata)),
        ("Integers", wide_integers()),
        ("integers", list(integers())),
        ("shuffle", shuffles()),
        ("shuffle by points", list(order)),
        ("Permutation", permutations()),
        (
            "normal chain",
            chain(RandomWalk::new(
                NormalStep::<[f32; 2], Poly>::new([0.5, 1.0]).expect(ok),
            )),
        ),
        (
            "box chain",
            chain(RandomWalk::new(BoxStep::new([0.5, 0.0]).expect(ok))),
        ),
        (
            "cube chain",
            chain(
                Mixture::large_small(0.25, WrappedWalk::new(BoxStep::new([0.1, 0.2]).expect(ok)))
                    .expect(ok),
            ),
        ),
    ];
    let runs: Vec<String> = runs
        .iter()
        .map(|(name, bits)| format!("    {name:?}: {bits}"))
        .collect();
    let densities = densities.iter();
    let densities: Vec<String> = densities
        .map(|(name, bits)| format!("    {name:?}: {}", list(bits.iter().copied())))
        .collect();
    let uniforms =
        microwarp_list::UNIFORMS.map(|uniforms| format!("    {}", list(uniforms.bits())));
    Ok(format!(
        "{{\n  \"golden\": [\n{}\n  ],\n  \"uniforms\": [\n{}\n  ],\n  \"runs\": {{\n{}\n  }},\n  \"densities\": {{\n{}\n  }}\n}}\n",
        golden(classes, goldens)?,
        uniforms.join(",\n"),
        runs.join(",\n"),
        densities.join(",\n"),
    ))
}
