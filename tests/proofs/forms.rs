//! Laws have the form that is examined, bit by bit.

use crate::inputs::in_parallel;
use crate::laws::{LAWS, Law, by_name};
use crate::powers::{log_of_uniform, log_of_word, times_exp2};
use crate::unit::Unit;
use host::adversary::words::{self, Kind};
use host::registry::{Entry, Registered};
use host::speed;
use rand_pcg::Pcg32;

/// Parameters that a constructor accepts, half of them with a location of the size of the scale.
fn parameters(of: &Registered, rng: &mut Pcg32) -> (Vec<f32>, Entry) {
    loop {
        let mut p: Vec<f32> = of
            .takes
            .iter()
            .map(|kind| f32::from_bits(kind.draw(rng)))
            .collect();
        if p.len() == 2 && words::below(rng, 2) == 0 {
            p[0] = (16.0 * words::unit(rng) - 8.0) as f32 * p[1];
        }
        if let Ok(entry) = of.of_drawn(&p) {
            return (p, entry);
        }
    }
}

/// A sample, a draw and a density are made of the kernel as it is examined.
fn has_its_form(law: &Law, of: &Registered) -> Option<String> {
    let number = speed::of("parameters whose form is checked", 1 << 9, 1 << 14);
    let mut rng = Pcg32::new(3, 3);
    let unit = Unit::new(of, law.sample.unit);
    let libm = law.registered("libm").filter(|_| law.shared);
    let density = law.density.as_ref();
    let density = density.map(|density| (density, Unit::new(of, density.unit)));
    for _ in 0..number {
        let (p, entry) = parameters(of, &mut rng);
        let at = Unit::of_entry(entry);
        let libm = libm.as_ref().map(|of| Unit::new(of, &p));
        for _ in 0..16 {
            let u = f32::from_bits(Kind::Uniform.draw(&mut rng));
            let word = Kind::Word.draw(&mut rng);
            let made = (law.sample.by)(&p, unit.sample(u));
            if at.sample(u).to_bits() & !(1 << 31) != made.to_bits() & !(1 << 31) {
                return Some(format!("{p:?} at {u}: {} and {made}", at.sample(u)));
            }
            let both = |unit: &Unit| (unit.sample(u), unit.drawn(word));
            if libm.as_ref().is_some_and(|libm| both(libm) != both(&at)) {
                return Some(format!("{p:?} at {u} and of {word:x} in libm"));
            }
            if unit.has_words() && at.drawn(word) != (law.sample.by)(&p, unit.drawn(word)) {
                return Some(format!("{p:?} of {word:x}"));
            }
            if let Some((density, unit)) = &density {
                let made = density.of(&p, unit.density(u));
                let normal = (f32::MIN_POSITIVE..=f32::MAX).contains(&made);
                if normal && at.density(u) != made {
                    return Some(format!(
                        "the density of {p:?} at {u}: {} and {made}",
                        at.density(u)
                    ));
                }
            }
        }
    }
    None
}

#[test]
fn laws_of_the_line_are_a_kernel_scaled_and_moved() {
    let jobs: Vec<_> = LAWS
        .iter()
        .flat_map(|law| ["libm", "poly"].map(|t| (law, t)))
        .collect();
    let wrong = in_parallel(jobs.len() as u32, |i| {
        let (law, tier) = jobs[i as usize];
        let of = law.registered(tier)?;
        has_its_form(law, &of).map(|wrong| format!("{} {tier}: {wrong}", law.name))
    });
    let wrong: Vec<_> = wrong.into_iter().flatten().collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
    // A location that is added before the scale counts, and a product in place of a quotient, are seen.
    for (name, by) in [
        (
            "Laplace",
            (|p, t| p[1] * (p[0] / p[1] + t)) as fn(&[f32], f32) -> f32,
        ),
        ("Exponential", |p, t| (1.0 / p[0]) * t),
    ] {
        let mut laws = LAWS.into_iter();
        let mut law = laws.find(|law| law.name == name).expect("a law");
        law.sample.by = by;
        assert!(has_its_form(&law, &law.registered("poly").expect("a law")).is_some());
    }
}

/// A sample of the line by what is examined; nothing outside the range where the product is normal for certain.
fn checked(significand: f32, exponent: i32, exact: f32, small: f32) -> Option<f32> {
    let (product, more) = times_exp2(significand, exact, small);
    let exponent = exponent + more;
    (-125..=125)
        .contains(&exponent)
        .then(|| product * 2.0_f32.powi(exponent))
}

/// A significand from 1 to 2, and the exponent of 2.
fn parts_of(x: f32) -> (f32, i32) {
    let exponent = (x.to_bits() >> 23) as i32 - 127;
    (x / 2.0_f32.powi(exponent), exponent)
}

/// The 12 leading digits.
fn head(x: f32) -> f32 {
    f32::from_bits(x.to_bits() & 0xffff_f000)
}

/// The samples of a Pareto law and what is made of the tables, of a uniform and of a word.
fn of_a_pareto(entry: Entry, p: &[f32], u: f32, word: u32) -> [(f32, Option<f32>); 2] {
    let (unit, inverse) = (Unit::of_entry(entry), 1.0 / p[1]);
    let lack = 1.0 - f64::from(inverse) * f64::from(p[1]);
    let rest = lack as f32 / p[1];
    let high = head(64.0 * inverse);
    let low = (64.0 * inverse - high) + 64.0 * rest;
    let (significand, exponent) = parts_of(p[0]);
    let by = |(whole, rest): (f32, f32)| {
        let small = rest * (high + low) + whole * low;
        checked(significand, exponent, whole * high, small)
    };
    [
        (unit.sample(u), by(log_of_uniform(u))),
        (unit.drawn(word), by(log_of_word(word))),
    ]
}

/// The same of a log-normal law; of a word, whose quantile is multiplied in another order, the nearest of a few exponents.
fn of_a_log_normal(
    entry: Entry,
    normal: &Unit,
    p: &[f32],
    u: f32,
    word: u32,
) -> [(f32, Option<f32>); 2] {
    let unit = Unit::of_entry(entry);
    let log2_e = (head(std::f32::consts::LOG2_E), std::f64::consts::LOG2_E);
    let (exact, low) = (
        f64::from(64.0 * p[1]) * f64::from(log2_e.0),
        (log2_e.1 - f64::from(log2_e.0)) as f32,
    );
    let step = exact as f32;
    let step = step + ((exact - f64::from(step)) as f32 + 64.0 * p[1] * low);
    let (significand, exponent) = parts_of(unit.sample(0.5));
    let by = |steps: f32| checked(significand, exponent, steps, -0.0);
    let (x, drawn) = (unit.sample(u), unit.drawn(word));
    let steps = step * normal.drawn(word);
    let near = (-4..=4).map(|k| by(f32::from_bits(steps.to_bits().wrapping_add_signed(k))));
    let same = near
        .into_iter()
        .find(|made| *made == Some(drawn))
        .unwrap_or_else(|| by(steps));
    [(x, by(step * normal.sample(u))), (drawn, same)]
}

#[test]
fn laws_by_tables_have_the_form_that_is_examined() {
    for tier in ["libm", "poly"] {
        let normal = Unit::new(&by_name("Normal", tier), &[0.0, 1.0]);
        for name in ["LogNormal", "Pareto"] {
            let (of, mut rng) = (by_name(name, tier), Pcg32::new(5, 5));
            let mut checked = 0;
            while checked < speed::of("numbers by tables whose form is checked", 1 << 14, 1 << 20) {
                let mut p: Vec<f32> = of
                    .takes
                    .iter()
                    .map(|kind| f32::from_bits(kind.draw(&mut rng)))
                    .collect();
                if name == "LogNormal" && checked % 2 == 0 {
                    p = vec![
                        (160.0 * words::unit(&mut rng) - 80.0) as f32,
                        (12.0 * words::unit(&mut rng)) as f32,
                    ];
                }
                let normal_number =
                    name == "LogNormal" && p[0] > -87.0 || p[0] >= f32::MIN_POSITIVE;
                let Some(entry) = of.of_drawn(&p).ok().filter(|_| normal_number) else {
                    continue;
                };
                let u = f32::from_bits(Kind::Uniform.draw(&mut rng));
                let word = Kind::Word.draw(&mut rng);
                let pairs = if name == "Pareto" {
                    of_a_pareto(entry, &p, u, word)
                } else {
                    of_a_log_normal(entry, &normal, &p, u, word)
                };
                for (x, made) in pairs {
                    if let Some(made) = made {
                        assert_eq!(x, made, "{name} {tier} {p:?} at {u} or of {word:x}");
                        checked += 1;
                    }
                }
            }
        }
    }
}
