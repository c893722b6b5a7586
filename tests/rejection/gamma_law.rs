//! `Gamma`: the law that all words of a try have together, its efficiency, and the law of what is drawn.

use host::errors::or_infinite;
use host::generators::{Counting, Cycle};
use host::words::first_without;
use host::{speed, stats};
use microwarp::poly;
use microwarp::rejection::{Failure, Rejection};
use rand_pcg::Pcg32;
use statrs::distribution::{Continuous, ContinuousCDF, InverseGamma};
use statrs::function::gamma::{gamma_lr, ln_gamma};

/// The largest distance of the law of all words from the gamma distribution of a shape, and the efficiency. First words are taken
/// from the middle of cells that shrink towards both ends, and the numbers between two cells separate their shares.
fn law(shape: f64, cells: u32, attempt: impl Fn([u32; 2]) -> Option<f32>) -> (f64, f64) {
    let start = |i: u32| {
        let s = f64::from(i) / f64::from(cells);
        (s * s * (3.0 - 2.0 * s) * 4_294_967_296.0) as u64
    };
    let (mut sum, mut sums) = (0.0, Vec::new());
    for i in 0..cells {
        let (from, to) = (start(i), start(i + 1));
        let middle = u64::midpoint(from, to) as u32;
        let accepted = first_without(0..1 << 32, |decision| {
            attempt([middle, decision as u32]).is_some()
        });
        sum += (to - from) as f64 * accepted as f64;
        sums.push((attempt([(to - 1) as u32, 0]), sum));
    }
    let distances = sums.iter().filter_map(|&(x, below)| {
        let exact = gamma_lr(shape, x?.into());
        Some(or_infinite((below / sum - exact).abs()))
    });
    let worst = distances.fold(0.0, f64::max);
    (worst, sum / 2_f64.powi(64))
}

/// Of the number before the root of a uniform is taken: the third word is the largest.
fn tried(shape: f32) -> impl Fn([u32; 2]) -> Option<f32> {
    let sampler = poly::Gamma::new(shape, 1.0).unwrap();
    move |[place, decision]| sampler.attempt([place, decision, u32::MAX])
}

/// The granted distance: the numbers are rounded, by so much of the width of a large shape's distribution.
fn bound(shape: f64) -> f64 {
    4e-7 + 2.5e-7 * shape.sqrt()
}

#[test]
fn all_words_have_the_law_together() {
    let cells = speed::of("cells of first words", 1 << 12, 1 << 16);
    let mut lowest = 1.0_f64;
    for shape in [
        1e-3, 0.1, 0.5, 0.9, 1.000_001, 1.2, 1.5, 2.0, 3.3, 10.0, 77.0, 1e3, 1e4, 1e6,
    ] {
        let base = if shape < 1.0 { shape + 1.0 } else { shape };
        let (worst, efficiency) = law(base.into(), cells, tried(shape));
        println!("shape {shape}: {worst:.2e}, efficiency {efficiency:.4}");
        assert!(worst <= bound(base.into()), "{shape}: {worst}");
        assert!(efficiency > 0.951 && efficiency <= 1.0);
        lowest = lowest.min(efficiency);
        let stated = [(2.0, 0.982), (10.0, 0.997)];
        for (_, stated) in stated.iter().filter(|(of, _)| *of == shape) {
            assert!((efficiency - stated).abs() < 6e-4);
        }
    }
    assert!((lowest - 0.952).abs() < 6e-4);
    // The default budgets.
    assert!((1.0 - lowest).powi(poly::Gamma::BUDGET as i32) < 2_f64.powi(-64));
}

/// Another shape, a try that accepts all, one that accepts by the squeeze alone, and the next decision are noticed.
#[test]
fn wrong_laws_are_noticed() {
    let right = tried(1.5);
    let squeezed = |[place, decision]: [u32; 2]| {
        let z = crate::gamma::normal(place);
        let accepted = f64::from(!decision) / 4_294_967_296.0 > 0.0331 * z.powi(4);
        accepted.then(|| right([place, 0])).flatten()
    };
    for (what, worst) in [
        ("shape", law(1.5 * 1.02, 1 << 12, &right).0),
        ("nearly its shape", law(1.5 * 1.000_1, 1 << 12, &right).0),
        (
            "accepts all",
            law(1.5, 1 << 12, |[place, _]| right([place, 0])).0,
        ),
        ("squeeze alone", law(1.5, 1 << 12, squeezed).0),
        (
            "twice the decision",
            law(1.5, 1 << 12, |[place, decision]| {
                right([place, decision / 2])
            })
            .0,
        ),
    ] {
        println!("{what}: {worst:.2e}");
        assert!(worst > 2.0 * bound(1.5), "{what}: {worst}");
    }
}

/// The probability below a number, by its logarithm.
fn below(shape: f64, ln: f64) -> f64 {
    if ln < -40.0 {
        (shape * ln - ln_gamma(shape + 1.0)).exp()
    } else {
        gamma_lr(shape, ln.exp())
    }
}

#[test]
fn what_is_drawn_has_the_law() {
    let number = speed::of("drawn gamma numbers", 20_000, 1_000_000);
    let threshold = stats::threshold(40);
    let more = speed::of("factor of a wrong shape", 1.08, 1.04);
    for (shape, seed) in [1e-4_f32, 0.01, 0.3, 0.999, 1.0, 1.5, 7.0, 500.0, 1e6]
        .into_iter()
        .zip(1..)
    {
        let scale = 3.0_f32;
        let (sampler, mut rng) = (
            poly::Gamma::new(shape, scale).unwrap(),
            Pcg32::new(seed, 35),
        );
        let drawn: Vec<f64> = (0..number)
            .map(|_| f64::from(sampler.draw_ln(&mut rng).unwrap().point) - f64::from(scale).ln())
            .collect();
        let p_value = |shape: f64| {
            let mut uniforms: Vec<_> = drawn.iter().map(|ln| below(shape, *ln)).collect();
            stats::p_value_of_uniforms(&mut uniforms)
        };
        let (a, name) = (f64::from(shape), format!("shape {shape}"));
        stats::assert_passes(&name, &[p_value(a)], threshold);
        // The numbers themselves are those of the same words.
        let mut again = Pcg32::new(seed, 35);
        let (mut sum, mut least) = (0.0, 0);
        for ln in &drawn {
            let x = sampler.draw(&mut again).unwrap().point;
            let exact = f64::from(scale) * ln.exp();
            let off = (f64::from(x) - exact).abs();
            assert!(
                off <= 1e-4 * exact || x == f32::from_bits(1) || exact < 1e-38,
                "{x} {exact}"
            );
            sum += f64::from(x) / f64::from(scale);
            least += u32::from(x == f32::from_bits(1));
        }
        assert_eq!(rng, again);
        let n = f64::from(number);
        let share = below(a, -149.0 * std::f64::consts::LN_2 - f64::from(scale).ln());
        let spread = (share * (1.0 - share) / n).sqrt();
        assert!((f64::from(least) / n - share).abs() <= 6.0 * spread + 1e-9);
        let z = (sum / n - a) / (a / n).sqrt();
        // Moments of small shapes are slow to settle.
        assert!(shape < 0.1 || z.abs() < 5.5, "{shape}: {z}");
        // The control: a shape that is a few percent larger.
        stats::assert_rejected(&name, &[p_value(more * a)], threshold);
    }
}

/// As the page says: the law of 1/x, by logarithms where `f32` does not hold it, and its density from that of x.
#[test]
fn the_reciprocal_is_inverse_gamma() {
    let number = speed::of("drawn inverse-gamma numbers", 20_000, 1_000_000);
    let threshold = stats::threshold(2);
    for (shape, scale, seed) in [(0.02_f32, 0.5_f32, 1), (3.0, 0.25, 2), (40.0, 7.0, 3)] {
        let law = poly::Gamma::new(shape, scale).unwrap();
        let exact = |scale: f64| InverseGamma::new(shape.into(), scale).unwrap();
        let right = exact(1.0 / f64::from(scale));
        let (mut rng, mut again) = (Pcg32::new(seed, 38), Pcg32::new(seed, 38));
        let (mut lns, mut worst, mut wrong, mut beyond) = (Vec::new(), 0.0_f64, 0.0_f64, 0);
        for _ in 0..number {
            let ln = -f64::from(law.draw_ln(&mut rng).unwrap().point);
            lns.push(ln);
            let x = law.draw(&mut again).unwrap().point;
            if x < 2_f32.powi(-128) {
                beyond += 1;
                assert!(1.0 / x == f32::INFINITY && ln > 88.7);
                continue;
            }
            // Where no factor leaves f32.
            if !(1e-12..1e12).contains(&x) {
                continue;
            }
            let density = right.pdf(1.0 / f64::from(x));
            let far = (f64::from(x) / (f64::from(shape) * f64::from(scale)))
                .ln()
                .abs();
            // That of the page, and two products.
            let bound = 3.5e-7 + 2e-10 * f64::from(shape) * far + 1.2e-7;
            let error = |density_here: f32| (f64::from(density_here) / density - 1.0).abs() / bound;
            worst = worst.max(or_infinite(error(law.pdf(x) * x * x)));
            wrong = wrong.max(error(law.pdf(x) * x));
        }
        println!("shape {shape}: {worst:.3} of the bound; {beyond} beyond f32");
        assert!(worst <= 1.0 && wrong > 100.0, "{shape}: {worst}, {wrong}");
        assert_eq!(beyond > 0, shape < 0.1);
        // The law of those of which a double holds the number.
        if shape < 0.1 {
            continue;
        }
        let p_value = |law: InverseGamma| {
            let mut uniforms: Vec<_> = lns.iter().map(|ln| law.cdf(ln.exp())).collect();
            stats::p_value_of_uniforms(&mut uniforms)
        };
        let name = format!("1/x of shape {shape}");
        stats::assert_passes(&name, &[p_value(right)], threshold);
        stats::assert_rejected(&name, &[p_value(exact(scale.into()))], threshold);
    }
}

#[test]
fn a_stuck_generator_spends_the_budget() {
    let sampler = poly::Gamma::new(1.5, 1.0).unwrap();
    let mut stuck = Counting::new(Cycle::new(&[0]));
    assert_eq!(
        sampler.draw(&mut stuck),
        Err(Failure::BudgetSpent { tries: 16 })
    );
    assert_eq!(stuck.words, 32);
    assert_eq!(
        sampler.with_budget(3).unwrap().draw_ln(&mut stuck),
        Err(Failure::BudgetSpent { tries: 3 })
    );
    assert_eq!(stuck.words, 38);
    // The first share takes one word and no second try.
    let shares = poly::Dirichlet::new([1.0, 1.5, 2.0]).unwrap();
    assert_eq!(
        shares.draw(&mut stuck),
        Err(Failure::BudgetSpent { tries: 48 })
    );
    assert_eq!(stuck.words, 38 + 1 + 2 * 47);
    assert_eq!(shares.try_once(&mut stuck), Ok::<_, Failure>(None));
    let pair = poly::Beta::new(1.5, 2.0).unwrap().with_budget(1).unwrap();
    assert_eq!(
        pair.draw(&mut stuck),
        Err(Failure::BudgetSpent { tries: 1 })
    );
}
