//! What is hard for a warp, as `crates/cores` sweeps it for the longest time: the parameters that the registry lists, and
//! the worst parameters and uniforms that searches have found. `crates/cores/run` has them written where `CORES_HARD` says.

use host::registry::{Registered, of_poly};
use std::fmt::Write as _;

const HEAD: &str = "\
# Hard parameters and uniforms of a warp: warp; constructor; parameters; uniforms (words in hex).
";

/// A constructor as programs call it, and its parameters. Those of some places of the registry are made of numbers that
/// describe something else; their worst cases are left out.
fn called(of: &Registered, numbers: &[f32]) -> Option<(&'static str, Vec<f32>)> {
    let mut numbers = numbers.to_vec();
    for &[low, high] in of.ordered {
        if numbers[low] > numbers[high] {
            numbers.swap(low, high);
        }
    }
    let constructor = match (of.name, of.constructor) {
        (_, "near" | "small") => return None,
        ("Power", "from 0") => {
            numbers.insert(1, 0.0);
            "new"
        }
        ("Exponential" | "ExponentialTail" | "TruncatedExponential", "") => "from_rate",
        ("SphericalPatch", "") => "from_turns",
        ("Power", "near n=-1") | ("TriangleOn" | "Aabb", _) | (_, "") => "new",
        (_, named) => named,
    };
    Some((constructor, numbers))
}

fn hex(words: impl Iterator<Item = u32>) -> String {
    let words: Vec<String> = words.map(|word| format!("{word:x}")).collect();
    words.join(" ")
}

/// The kept worst cases of a file: their families and the rows of theirs, as words.
fn kept(file: &str) -> Vec<(String, [String; 2])> {
    let text = std::fs::read_to_string(host::root().join("tests").join(file)).unwrap();
    let lines = text.lines().filter(|line| !line.starts_with('#'));
    let cells = lines.map(|line| line.split(';').map(String::from).collect::<Vec<_>>());
    cells
        .map(|mut cells| {
            let [label, _, parameters, uniforms] = cells.split_off(0).try_into().unwrap();
            (label, [parameters, uniforms])
        })
        .collect()
}

fn words(text: &str) -> Vec<u32> {
    let words = text.split_whitespace();
    words
        .map(|word| u32::from_str_radix(word, 16).unwrap())
        .collect()
}

/// Means and deviations in Q16, and correlations in Q30, of the integer tier: hardly any words are those of a law.
const CORRELATED: [&[i32]; 4] = [
    &[0, 7, 1 << 16, 1 << 25, 1 << 30, 1 << 29, 1 << 29, 1 << 30],
    &[-9, 0, 77, 5 << 16, 1 << 30, -1 << 30, -1 << 30, 1 << 30],
    &[
        0,
        1 << 20,
        -5,
        1 << 16,
        77,
        1 << 25,
        1 << 30,
        1 << 29,
        -1 << 28,
        1 << 29,
        1 << 30,
        1 << 27,
        -1 << 28,
        1 << 27,
        1 << 30,
    ],
    &[
        0,
        0,
        0,
        1 << 16,
        0,
        1 << 10,
        1 << 30,
        0,
        1 << 30,
        0,
        1 << 30,
        0,
        1 << 30,
        0,
        1 << 30,
    ],
];

/// Each line once.
fn table() -> String {
    let (mut lines, worst) = (Vec::new(), kept("accuracy/worst.csv"));
    let mut add = |line: String| {
        if !lines.contains(&line) {
            lines.push(line);
        }
    };
    for of in of_poly() {
        let line = |numbers: &[f32], uniforms: &str| {
            let (constructor, numbers) = called(&of, numbers)?;
            let parameters = match of.name {
                // A number of corners.
                "RegularPolygon" => hex(numbers.iter().map(|x| *x as u32)),
                _ => hex(numbers.iter().map(|x| x.to_bits())),
            };
            Some(format!("{};{constructor};{parameters};{uniforms}", of.name))
        };
        let cases = of.cases.iter().map(|(_, numbers, _)| numbers);
        for numbers in cases.chain(&of.seeds).filter(|numbers| !numbers.is_empty()) {
            line(numbers, "").map(&mut add);
        }
        let space = if of.constructor.is_empty() { "" } else { " " };
        for tier in ["libm", "poly"] {
            let label = format!("{}{space}{} {tier}", of.name, of.constructor);
            for (_, [parameters, uniforms]) in worst.iter().filter(|(of, _)| *of == label) {
                let numbers: Vec<f32> = words(parameters).into_iter().map(f32::from_bits).collect();
                line(&numbers, &hex(words(uniforms).into_iter())).map(&mut add);
            }
        }
    }
    // The parameters of those are no words of constructors.
    for (label, [_, uniforms]) in kept("fixed/worst.csv") {
        let name = label.split(' ').next().unwrap_or_default();
        add(format!(
            "fixed {name};;;{}",
            hex(words(&uniforms).into_iter())
        ));
    }
    for parameters in CORRELATED {
        let words = parameters.iter().map(|x| *x as u32);
        add(format!("fixed MultivariateNormal;new;{};", hex(words)));
    }
    let mut text = String::from(HEAD);
    for line in lines {
        let _ = writeln!(text, "{line}");
    }
    text
}

#[test]
fn sweeps_for_the_longest_time_take_the_hard_inputs() {
    let table = table();
    let has = |warp: &str| table.lines().any(|line| line.starts_with(warp));
    for of in of_poly().iter().filter(|of| !of.takes.is_empty()) {
        assert!(has(&format!("{};", of.name)), "{}", of.name);
    }
    assert!(has("fixed Disk;") && !has("Unheard"));
    if let Some(path) = std::env::var_os("CORES_HARD") {
        std::fs::write(path, table).unwrap();
    }
}
