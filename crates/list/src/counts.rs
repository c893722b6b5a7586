//! The subjects of counts by one word.

use crate::Out;
use crate::integers::stirred;
use crate::subjects::{generator, with};
use core::ops::RangeInclusive;
use microwarp::discrete::{
    Binomial, DiscreteGaussian, DiscreteLaplace, Geometric, Hypergeometric, NegativeBinomial,
    Poisson,
};
use microwarp::uniform::up_to_from_word;

/// The count of a word with its probability and the last of its words, and a count of a generator.
fn seen(count: u32, drawn: u32, pmf: f32, words: Option<RangeInclusive<u32>>, out: &mut Out) {
    out.word(count);
    out.word(drawn);
    out.float(pmf);
    out.word(words.map_or(0, |words| *words.end()));
}

/// Counts by ratios of integers, and by numbers.
pub fn counts(u: [f32; 4], input: usize, out: &mut Out) {
    let [a, b, c, d] = stirred(u);
    let mut rng = generator(input);
    with(
        Geometric::from_ratio(a >> (b & 31), b | 1),
        out,
        |law, out| {
            let count = law.count(c);
            seen(
                count,
                law.draw(&mut rng),
                law.pmf(count),
                law.words_of(count),
                out,
            );
        },
    );
    with(Geometric::new(u[1]), out, |law, out| {
        out.word(law.sample(u[0]));
        out.float(law.pmf(d >> 20));
    });
    let events = (a >> 8).wrapping_mul(81);
    with(
        Poisson::from_ratio(events >> 8, 1 << 16),
        out,
        |law, out| {
            let count = law.count(d);
            seen(
                count,
                law.draw(&mut rng),
                law.pmf(count),
                law.words_of(count),
                out,
            );
        },
    );
    with(Poisson::new(90.0 * u[2]), out, |law, out| {
        out.word(law.sample(u[3]));
        out.float(law.pmf(c >> 24));
    });
}

/// Successes of a number of trials, by a ratio of integers and by a number.
pub fn successes(u: [f32; 4], input: usize, out: &mut Out) {
    let [a, b, c, d] = stirred(u);
    let mut rng = generator(input);
    let (trials, whole) = (a >> (22 + (b & 7)), b | 1);
    let part = ((c as u64).wrapping_mul(whole as u64) >> 32) as u32;
    with(
        Binomial::from_ratio(trials, part, whole),
        out,
        |law, out| {
            let count = law.count(d);
            seen(
                count,
                law.draw(&mut rng),
                law.pmf(count),
                law.words_of(count),
                out,
            );
        },
    );
    // A probability near 0 or 1.
    let p = 1e-7 * u[0];
    with(
        Binomial::new(c, if d & 1 == 0 { p } else { 1.0 - p }),
        out,
        |law, out| {
            let count = law.sample(u[3]);
            out.word(count);
            out.float(law.pmf(count ^ 1));
        },
    );
}

/// Failures before so many successes, by a ratio of integers and by numbers.
pub fn failures(u: [f32; 4], input: usize, out: &mut Out) {
    let [a, b, c, d] = stirred(u);
    let mut rng = generator(input);
    let whole = b | 1;
    let law = NegativeBinomial::from_ratio(a >> (24 + (b & 7)), up_to_from_word(whole, c), whole);
    with(law, out, |law, out| {
        let count = law.count(d);
        seen(
            count,
            law.draw(&mut rng),
            law.pmf(count),
            law.words_of(count),
            out,
        );
    });
    let real = (c >> 8) as f32 * 1e-6;
    with(
        NegativeBinomial::new(real, 0.1 + 0.95 * u[0]),
        out,
        |law, out| {
            out.word(law.sample(u[3]));
            out.float(law.pmf(d >> 24));
        },
    );
}

/// Marked items among those drawn, of populations of any size.
pub fn urns(u: [f32; 4], input: usize, out: &mut Out) {
    let [a, b, c, d] = stirred(u);
    let mut rng = generator(input);
    let population = a >> (b & 31);
    let [marked, drawn] = [c, d].map(|word| up_to_from_word(population, word));
    for (marked, drawn) in [
        (marked, drawn),
        (population.wrapping_sub(marked), drawn >> (c & 31)),
    ] {
        with(
            Hypergeometric::new(population, marked, drawn),
            out,
            |law, out| {
                let count = law.count(d);
                seen(
                    count,
                    law.draw(&mut rng),
                    law.pmf(count),
                    law.words_of(count),
                    out,
                );
            },
        );
    }
    with(Hypergeometric::new(c, c >> 1, d >> 23), out, |law, out| {
        out.word(law.sample(u[3]));
        out.float(law.pmf(d >> 24));
    });
}

/// Integers about a centre and about 0, by numbers and by a ratio of integers.
pub fn around(u: [f32; 4], input: usize, out: &mut Out) {
    let [a, b, c, d] = stirred(u);
    let mut rng = generator(input);
    let centre = (a as f32 - 2_147_483_648.0) * (0.001 * u[1]);
    with(
        DiscreteGaussian::new(centre, 20.0 * u[0]),
        out,
        |law, out| {
            let integer = law.integer(d);
            seen(
                integer as u32,
                law.draw(&mut rng) as u32,
                law.pmf(integer),
                law.words_of(integer),
                out,
            );
        },
    );
    with(
        DiscreteLaplace::from_ratio(b >> (c & 31), a | 1),
        out,
        |law, out| {
            let integer = law.integer(d);
            seen(
                integer as u32,
                law.draw(&mut rng) as u32,
                law.pmf(integer),
                law.words_of(integer),
                out,
            );
        },
    );
    with(DiscreteLaplace::new(1e4 * u[2]), out, |law, out| {
        out.word(law.sample(u[3]) as u32);
        out.float(law.pmf((d >> 20) as i32));
    });
}
