//! The integer constants of the integer tier: what is fitted or computed, in which Q format, and that the sources
//! hold exactly this.

use crate::integer_targets::{Fit, Number, fits, numbers};
use crate::minimax::{Problem, points};
use crate::powers;
use crate::targets::Point;
use crate::words;

/// A constant: where it stands, its values in Q format, and the largest errors of a fit with and without rounding.
struct Derived {
    file: &'static str,
    before: &'static str,
    words: Vec<u64>,
    ideal: f64,
    rounded: f64,
}

impl Fit {
    fn derive(&self) -> Derived {
        let at = |x| {
            let Point { x, value, weight } = (self.target)(x);
            (powers(x, self.terms).collect(), value, weight)
        };
        let problem = Problem::new(points(self.interval).into_iter().map(at));
        let unit = 2_f64.powi(self.bits as i32);
        let coefficients =
            problem.solve_rounded(&vec![None; self.terms], |c| (c * unit).round() / unit);
        Derived {
            file: self.file,
            before: self.before,
            words: coefficients.iter().map(|c| (c * unit) as u64).collect(),
            ideal: problem.largest_error(&problem.solve()),
            rounded: problem.largest_error(&coefficients),
        }
    }
}

impl Number {
    fn derive(&self) -> Derived {
        let unit = 2_f64.powi(self.bits as i32);
        let words = self.values.iter().map(|value| (value * unit).round());
        let errors = self
            .values
            .iter()
            .map(|value| ((value * unit).round() / unit - value).abs());
        Derived {
            file: self.file,
            before: self.before,
            words: words.map(|word| word as u64).collect(),
            ideal: 0.0,
            rounded: errors.fold(0.0, f64::max),
        }
    }
}

fn derived() -> Vec<Derived> {
    let fits = fits();
    let numbers = numbers();
    fits.iter()
        .map(Fit::derive)
        .chain(numbers.iter().map(Number::derive))
        .collect()
}

#[test]
fn the_integer_sources_hold_the_derived_words() {
    let write = std::env::var_os("MICROWARP_WRITE").is_some();
    let mut wrong = Vec::new();
    let mut underived = words::long_literals();
    println!("{:64} {:>9} {:>9}", "", "minimax", "rounded");
    for Derived {
        file,
        before,
        words,
        ideal,
        rounded,
    } in derived()
    {
        println!("{file:16} {before:47} {ideal:9.1e} {rounded:9.1e}\n    {words:?}");
        if write {
            words::write(file, before, &words);
        }
        for word in &words {
            let literal = (file.to_owned(), words::literal(*word));
            underived.retain(|other| *other != literal);
        }
        if words::read(file, before) != Some(words) {
            wrong.push((file, before));
        }
    }
    assert!(
        wrong.is_empty(),
        "the sources differ from the derivation: {wrong:?}"
    );
    assert!(underived.is_empty(), "nothing derives {underived:?}");
}

/// Of fits and numbers that are off in their last place the comparison is not silent.
#[test]
fn words_off_by_one_are_noticed() {
    for Derived {
        file,
        before,
        words,
        ..
    } in derived()
    {
        let mut off = words.clone();
        off[0] += 1;
        assert_ne!(words::read(file, before), Some(off), "{file} {before}");
        assert_eq!(words::read(file, "const NOTHING: u32 = "), None);
    }
}
