//! The subjects of the integer tier, in every grade, on inputs of their own. The warps stand in `fixed_warps.rs`.
//! There is not a floating-point operation in it.

use crate::Out;
use crate::subjects::{generator, refusal, with};
use core::hint::black_box;
use fixed::types::extra::{LeEqU32, Unsigned};
use fixed::types::{I2F30, I16F16, I32F0, U0F32, U2F62, U5F27, U16F16, U32F32};
use fixed::{FixedI32, FixedU32, FixedU64};
use microwarp::fixed::warp::*;
use microwarp::fixed::{Coarse, Compact, Fine, Float, Grade};
use microwarp::{Error, Invert};

/// Words where integer maps break: the ends, the borders of quarters and of table cells, and some in between.
pub const WORDS: [[u32; 2]; 12] = [
    [0, 0],
    [u32::MAX, u32::MAX],
    [0, u32::MAX],
    [u32::MAX, 0],
    [1 << 31, 1 << 30],
    [(1 << 31) - 1, (1 << 30) - 1],
    [1 << 30, 3 << 30],
    [1, 1 << 31],
    [u32::MAX - 1, (1 << 31) - 1],
    [1 << 24, 1 << 29],
    [(1 << 24) - 1, (1 << 29) + 1],
    [0x2bad_cafe, 0xbabe_face],
];

/// How many inputs each subject is evaluated on: the words, then draws from a generator.
pub const INPUTS: usize = WORDS.len() + 4;

/// Numbers that are made of words, and put out as words.
pub trait Words: Copy {
    fn from_words(words: [u32; 2]) -> Self;
    fn put(self, out: &mut Out);
}

impl Words for i32 {
    fn from_words([word, _]: [u32; 2]) -> Self {
        word as i32
    }
    fn put(self, out: &mut Out) {
        out.word(self as u32);
    }
}

impl Words for f32 {
    /// From 0 to below 2, by its bits.
    fn from_words([word, _]: [u32; 2]) -> Self {
        f32::from_bits(word >> 2)
    }
    fn put(self, out: &mut Out) {
        // Asking for NaN would be an operation.
        out.word(self.to_bits());
    }
}

impl<Frac: LeEqU32> Words for FixedU32<Frac> {
    fn from_words([word, _]: [u32; 2]) -> Self {
        Self::from_bits(word)
    }
    fn put(self, out: &mut Out) {
        out.word(self.to_bits());
    }
}

impl<Frac: LeEqU32> Words for FixedI32<Frac> {
    fn from_words([word, _]: [u32; 2]) -> Self {
        Self::from_bits(word as i32)
    }
    fn put(self, out: &mut Out) {
        out.word(self.to_bits() as u32);
    }
}

impl<Frac: Unsigned> Words for FixedU64<Frac> {
    fn from_words([high, low]: [u32; 2]) -> Self {
        Self::from_bits(u64::from(high) << 32 | u64::from(low))
    }
    fn put(self, out: &mut Out) {
        out.word((self.to_bits() >> 32) as u32);
        out.word(self.to_bits() as u32);
    }
}

impl<T: Words, const N: usize> Words for [T; N] {
    fn from_words([first, second]: [u32; 2]) -> Self {
        core::array::from_fn(|i| T::from_words([if i == 0 { first } else { second }; 2]))
    }
    fn put(self, out: &mut Out) {
        for x in self {
            x.put(out);
        }
    }
}

impl<A: Words, B: Words> Words for (A, B) {
    fn from_words(words: [u32; 2]) -> Self {
        (A::from_words(words), B::from_words(words))
    }
    fn put(self, out: &mut Out) {
        let (a, b) = self;
        a.put(out);
        b.put(out);
    }
}

/// Sample, density and inverse at fixed words or at a drawn point; then density and inverse at a point of words,
/// which may lie anywhere.
fn triple<W>(warp: Result<W, Error>, input: usize, out: &mut Out)
where
    W: Invert,
    W::Uniforms: Words,
    W::Point: Words,
    W::Density: Words,
{
    with(warp, out, |warp, out| {
        let words = WORDS.get(input).map(|words| words.map(black_box));
        let point = match words {
            Some(words) => warp.sample(W::Uniforms::from_words(words)),
            None => warp.draw(&mut generator(input)),
        };
        point.put(out);
        for point in [
            point,
            W::Point::from_words(words.unwrap_or([0x2000_0000; 2])),
        ] {
            warp.pdf(point).put(out);
            warp.invert(point).put(out);
        }
    });
}

/// A parameter the compiler cannot see.
pub fn v<T: Words>(word: u32) -> T {
    T::from_words([black_box(word), 0])
}

/// In Q16.
pub fn whole<T: Words>(number: u32) -> T {
    v(number << 16)
}

/// The words of an input, for what is no warp.
fn words(input: usize) -> [u32; 2] {
    use rand_core::Rng;
    let drawn = || {
        let mut rng = generator(input);
        [rng.next_u32(), rng.next_u32()]
    };
    WORDS
        .get(input)
        .map_or_else(drawn, |words| words.map(black_box))
}

/// What a constructor says of any parameters.
fn verdict<W>(result: Result<W, Error>, out: &mut Out) {
    out.word(match result {
        Ok(_) => 0,
        Err(e) => refusal(e).saturating_add(1),
    });
}

fn functions<G: Grade>(input: usize, out: &mut Out) {
    let [a, b] = words(input);
    let (phase, x) = (U0F32::from_bits(a), U5F27::from_bits(a));
    let (sin, cos) = G::sincos_turns(phase);
    [sin, cos].put(out);
    G::sqrt(phase).put(out);
    G::neg_ln_1m(phase).put(out);
    G::exp_neg(x).put(out);
    G::exp_m1_neg(x).put(out);
    G::exp_m1_neg(U5F27::from_bits(a >> 8)).put(out);
    for y in [b, b >> 16, 1 << 15, 0] {
        G::pow(phase, U16F16::from_bits(y)).put(out);
    }
    let [y, x] = [a, b].map(|word| I2F30::from_bits(word as i32));
    G::atan2_turns(y, x).put(out);
}

fn verdicts<G: Grade>(input: usize, out: &mut Out) {
    let [a, b] = words(input);
    let wide = u64::from(a) << 32 | u64::from(b);
    verdict(Cone::<G>::from_one_minus_cos(U2F62::from_bits(wide)), out);
    verdict(Cone::<G>::from_turns(U0F32::from_bits(b)), out);
    verdict(PhongLobe::<G>::new(U32F32::from_bits(wide)), out);
    verdict(Exponential::<_, G>::from_mean(U16F16::from_bits(b)), out);
    verdict(Tent::<_, G>::new(I16F16::from_bits(a as i32)), out);
    let [mean, deviation] = [a, b >> 3].map(|word| I16F16::from_bits(word as i32));
    verdict(NormalPair::<_, G>::new([mean; 2], deviation), out);
    let [a, b] = [a, b].map(U16F16::from_bits);
    verdict(TruncatedExponential::<_, G>::from_mean(a, b), out);
    verdict(Interval::<U16F16>::new(a, b), out);
    verdict(Interval::<U16F16>::inclusive(a, b), out);
}

fn facets<G: Grade>(input: usize, out: &mut Out) {
    let [a, b] = words(input);
    let verdict_of = |facet: [[u32; 2]; 3], out: &mut Out| {
        let facet = facet.map(|v| v.map(|word| I16F16::from_bits(word as i32)));
        verdict(TriangleOn::<_, 2, G>::new(facet), out);
    };
    verdict_of([[a, b], [b, a], [a ^ b, 7]], out);
    verdict_of([[a >> 2, b >> 2], [b >> 2, 0], [0, 7]], out);
}

/// The names and the constructors of the warps, and behind those with grades the functions.
macro_rules! subjects {
    (
        in every grade { $($graded:ident {
            golden { $($name:literal => $warp:expr,)* } cost $cost:tt bind $bind:tt
        })* }
        with floats { $($float:ident {
            golden { $($float_name:literal => $float_warp:expr,)* } cost $float_cost:tt bind $float_bind:tt
        })* }
        without grade { $($plain:ident {
            golden { $($plain_name:literal => $plain_warp:expr,)* } cost $plain_cost:tt bind $plain_bind:tt
        })* }
    ) => {
        const GRADED: &[&str] = &[$($($name,)*)* $($($float_name,)*)* "functions", "verdicts", "verdicts of facets"];
        const PLAIN: &[&str] = &[$($($plain_name,)*)*];

        fn of_grade<G: Grade>(subject: usize, input: usize, out: &mut Out) {
            let mut index = 0;
            $($(
                if subject == index {
                    return triple($warp, input, out);
                }
                index += 1;
            )*)*
            $($(
                if subject == index {
                    return triple($float_warp, input, out);
                }
                index += 1;
            )*)*
            if subject == index {
                return functions::<G>(input, out);
            }
            index += 1;
            if subject == index {
                return verdicts::<G>(input, out);
            }
            index += 1;
            if subject == index {
                facets::<G>(input, out);
            }
        }

        fn without_grade(subject: usize, input: usize, out: &mut Out) {
            let mut index = 0;
            $($(
                if subject == index {
                    return triple($plain_warp, input, out);
                }
                index += 1;
            )*)*
            let _ = index;
        }
    };
}

integer_warps!(subjects);

/// The grades by name; what has none is named after the tier.
const GRADES: [&str; 4] = [Fine::NAME, Coarse::NAME, Compact::NAME, "fixed"];

/// How many cases there are.
pub fn cases() -> usize {
    let subjects = GRADED.len().saturating_mul(3).saturating_add(PLAIN.len());
    subjects.saturating_mul(INPUTS)
}

/// The grade and the subject of a case.
fn place(index: usize) -> (usize, usize) {
    let (grade, subject) = (index / INPUTS / GRADED.len(), index / INPUTS % GRADED.len());
    (grade, subject)
}

/// Evaluates one case into `out`.
pub fn evaluate(index: usize, out: &mut Out) {
    let ((grade, subject), input) = (place(index), index % INPUTS);
    match grade {
        0 => of_grade::<Fine>(subject, input, out),
        1 => of_grade::<Coarse>(subject, input, out),
        2 => of_grade::<Compact>(subject, input, out),
        _ => without_grade(subject, input, out),
    }
}

/// The subject, the input and the grade of a case.
pub fn describe(index: usize) -> (&'static str, usize, &'static str) {
    let (grade, subject) = place(index);
    let names = if grade < 3 { GRADED } else { PLAIN };
    let name = names.get(subject).copied().unwrap_or("");
    (
        name,
        index % INPUTS,
        GRADES.get(grade).copied().unwrap_or(""),
    )
}
