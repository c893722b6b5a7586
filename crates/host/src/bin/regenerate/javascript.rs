//! The generated part of the npm package: the table of its classes, their typings, and what its tests compare with.

mod docs;
mod expected;
mod scripts;

use microwarp::uniform::Uniforms;
use microwarp::warp::*;
use microwarp::{Error, Warp, poly, tier::Poly};
use microwarp_host::upkeep::{Outcome, read, write};
use rand_core::TryRng;
use std::convert::Infallible;
use std::hint::black_box;

/// A class of JavaScript: a bound warp.
pub struct Class {
    /// The block of the list that it stands in, whose type is the Rust type.
    block: &'static str,
    name: String,
    /// The Rust type's `const` parameter.
    size: Option<usize>,
    uniforms: usize,
    /// The numbers of a point.
    numbers: usize,
    /// The words of a draw.
    words: usize,
    constructors: Vec<Constructor>,
}

pub struct Constructor {
    rust: &'static str,
    parameters: Vec<(&'static str, &'static str)>,
}

/// A block's golden subjects: name, and the constructor as it is written.
pub type Golden = Vec<(&'static str, &'static str)>;

/// Counts the words that are drawn.
struct Counted(usize);

impl TryRng for Counted {
    type Error = Infallible;
    fn try_next_u32(&mut self) -> Result<u32, Infallible> {
        self.0 += 1;
        Ok(1 << 31)
    }
    fn try_next_u64(&mut self) -> Result<u64, Infallible> {
        self.0 += 2;
        Ok(1 << 63)
    }
    fn try_fill_bytes(&mut self, _: &mut [u8]) -> Result<(), Infallible> {
        unreachable!("warps draw words")
    }
}

/// How many words a draw takes beyond one for each uniform.
fn more_words<W: Warp>(warp: Result<W, Error>) -> usize {
    let mut words = Counted(0);
    let warp = warp.unwrap_or_else(|e| panic!("a golden subject is refused: {e}"));
    black_box(warp.draw(&mut words));
    words.0 - W::Uniforms::COUNT
}

fn shape<W: Warp>() -> (usize, usize) {
    (W::Uniforms::COUNT, size_of::<W::Point>() / size_of::<f32>())
}

/// A parameter whose bits are fixed; here they may be known.
fn v(x: f32) -> f32 {
    x
}

macro_rules! classes {
    ($($type:ident {
        golden { $($($once:ident)? $golden:literal => $warp:expr,)* }
        cost $cost:tt
        bind {
            $($name:literal = $bound:ident $(<$n:literal>)? { $($new:ident($($p:ident: $ty:ty),*),)* })*
            $(none $why:literal)?
        }
    })*) => {
        /// The classes in the order of their numbers.
        fn classes() -> Vec<Class> {
            type T = Poly;
            let mut classes = Vec::new();
            $(
                bound!(classes $type [$($warp),*] $({ $name $bound [$($n)?] $(<$n>)? $($new($($p: $ty),*))* })*);
            )*
            classes
        }

        /// The golden subjects of the blocks that are bound.
        fn goldens() -> Vec<(&'static str, Golden)> {
            let mut goldens: Vec<(&'static str, Golden)> = Vec::new();
            $(
                let bound: &[&str] = &[$($name),*];
                if !bound.is_empty() {
                    goldens.push((stringify!($type), vec![$(($golden, stringify!($warp))),*]));
                }
            )*
            goldens
        }

        /// Points with their densities, of the same subjects.
        fn densities() -> Vec<(&'static str, Vec<u32>)> {
            type T = Poly;
            let mut densities = Vec::new();
            $(
                dense!(densities [$($golden => $warp),*] $($name)*);
            )*
            densities
        }
    };
}

/// Nothing of a block without bound warps.
macro_rules! dense {
    ($densities:ident $golden:tt) => {};
    ($densities:ident [$($golden:literal => $warp:expr),*] $($name:literal)+) => {
        $densities.extend([$(($golden, expected::with_densities($warp))),*]);
    };
}

/// Nothing of a block without bound warps: its warps need not be evaluated.
macro_rules! bound {
    ($classes:ident $type:ident $golden:tt) => {};
    ($classes:ident $type:ident [$first:expr $(, $rest:expr)*] $({
        $name:literal $bound:ident $size:tt $(<$n:literal>)? $($new:ident($($p:ident: $ty:ty),*))*
    })*) => {
        let more = { let made: Result<_, Error> = $first; more_words(made) };
        $({
            let (uniforms, numbers) = shape::<poly::$bound $(<$n>)?>();
            $classes.push(Class {
                block: stringify!($type),
                name: camel($name, true),
                size: { let size: &[usize] = &$size; size.first().copied() },
                uniforms,
                numbers,
                words: uniforms + more,
                constructors: vec![$(Constructor {
                    rust: stringify!($new),
                    parameters: vec![$((stringify!($p), stringify!($ty))),*],
                }),*],
            });
        })*
    };
}
microwarp_list::float_warps!(classes);

/// `from_rate` as `fromRate`, and `aabb_2d` as `Aabb2d`.
fn camel(name: &str, class: bool) -> String {
    let words = name.split('_').enumerate();
    let words = words.map(|(i, word)| match word.chars().next() {
        Some(first) if i > 0 || class => first.to_ascii_uppercase().to_string() + &word[1..],
        _ => word.into(),
    });
    words.collect()
}

impl Constructor {
    fn name(&self) -> String {
        camel(self.rust, false)
    }

    /// How many numbers each parameter has.
    fn lengths(&self) -> Vec<usize> {
        let length = |of: &str| -> usize {
            let numbers = of.split(|c: char| !c.is_ascii_digit() && c != 'f' && c != 'u');
            numbers.filter_map(|n| n.parse::<usize>().ok()).product()
        };
        let lengths = self.parameters.iter().map(|(_, of)| length(of));
        lengths.collect()
    }
}

/// Writes the files, or compares them.
pub fn step(check: bool) -> Outcome {
    let classes = classes();
    let files = [
        ("bindings/js/warps.js", scripts::table(&classes)),
        ("bindings/js/reasons.js", scripts::reasons()?),
        ("bindings/js/warps.d.ts", scripts::typings(&classes)?),
        (
            "bindings/js/test/expected.json",
            expected::json(&classes, &goldens(), &densities())?,
        ),
    ];
    for (path, text) in files {
        if !check {
            write(path, &text)?;
            continue;
        }
        let there = read(path)?;
        if there != text {
            let lines = crate::pages::difference(&there, &text);
            return Err(format!("{path} is not what the sources say\n{lines}"));
        }
        // A digit that is changed would be seen.
        if there.replacen('1', "2", 1) == text {
            return Err(format!("control: a wrong digit passes in {path}"));
        }
    }
    println!("javascript: {} classes", classes.len());
    Ok(())
}
