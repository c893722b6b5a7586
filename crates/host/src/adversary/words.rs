//! How parameters and uniforms are drawn and changed, as raw words.

use rand_core::Rng;
use rand_pcg::Pcg32;

/// What a word stands for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// Any `f32`.
    Any,
    /// An `f32` that is not negative.
    Positive,
    /// An `f32` between two ends.
    Within(f32, f32),
    /// A uniform in [0, 1), on the grid or off it.
    Uniform,
    /// All 32 bits, of a uniform or of a parameter in the integer tier.
    Word,
}

/// Numbers at which formulas change their form.
const SPECIAL: [f32; 16] = [
    0.0,
    1.0,
    0.5,
    2.0,
    4.0,
    0.25,
    0.75,
    10.0,
    f32::MIN_POSITIVE,
    1e-45,
    f32::MAX,
    1.0e-20,
    1.0e20,
    16_777_216.0,
    87.0,
    1.0e6,
];

/// A number from 0 to below `n`.
pub fn below(rng: &mut Pcg32, n: u32) -> u32 {
    ((u64::from(rng.next_u32()) * u64::from(n)) >> 32) as u32
}

/// A number in [0, 1) of 32 bits.
pub fn unit(rng: &mut Pcg32) -> f64 {
    f64::from(rng.next_u32()) / 4_294_967_296.0
}

fn log_uniform(rng: &mut Pcg32, low: f64, high: f64) -> f32 {
    (low.ln() + unit(rng) * (high.ln() - low.ln())).exp() as f32
}

/// A positive number of any kind.
fn magnitude(rng: &mut Pcg32) -> f32 {
    match below(rng, 8) {
        0 | 1 => f32::from_bits(rng.next_u32() & 0x7fff_ffff),
        2 | 3 => log_uniform(rng, 1e-45, f64::from(f32::MAX)),
        4 | 5 => log_uniform(rng, 1e-6, 1e6),
        6 => unit(rng) as f32,
        _ => SPECIAL[below(rng, 16) as usize],
    }
}

fn signed(rng: &mut Pcg32, x: f32) -> f32 {
    if rng.next_u32() & 1 == 0 { x } else { -x }
}

/// A uniform: mostly of the grid, often near an end or the middle.
fn uniform(rng: &mut Pcg32) -> f32 {
    const STEP: f32 = 1.0 / 16_777_216.0;
    let few = |rng: &mut Pcg32| below(rng, 64) as f32;
    match below(rng, 10) {
        0 => few(rng) * STEP,
        1 => 1.0 - (1.0 + few(rng)) * STEP,
        2 => 0.5 + (few(rng) - 32.0) * STEP,
        3 => log_uniform(rng, 6e-8, 1.0).min(1.0 - STEP),
        4 => (1.0 - log_uniform(rng, 6e-8, 1.0)).max(0.0),
        5 => f32::from_bits(below(rng, 0x3f80_0000)),
        _ => (rng.next_u32() >> 8) as f32 * STEP,
    }
}

/// A number between two ends, either of which it may be near to on a logarithmic scale.
fn within(rng: &mut Pcg32, low: f32, high: f32) -> f32 {
    let width = f64::from(high) - f64::from(low);
    let part = match below(rng, 6) {
        0 => f64::from(log_uniform(rng, 1e-30, 1.0)),
        1 => 1.0 - f64::from(log_uniform(rng, 1e-9, 1.0)),
        2 => f64::from(below(rng, 9)) / 8.0,
        _ => unit(rng),
    };
    ((f64::from(low) + part * width) as f32).clamp(low, high)
}

impl Kind {
    pub fn draw(self, rng: &mut Pcg32) -> u32 {
        match self {
            Self::Any => {
                let x = magnitude(rng);
                signed(rng, x).to_bits()
            }
            Self::Positive => magnitude(rng).to_bits(),
            Self::Within(low, high) => within(rng, low, high).to_bits(),
            Self::Uniform => uniform(rng).to_bits(),
            Self::Word => match below(rng, 4) {
                0 => (1_u32 << below(rng, 32))
                    .wrapping_add(below(rng, 65))
                    .wrapping_sub(32),
                1 => rng.next_u32() >> below(rng, 32),
                2 => !(rng.next_u32() >> below(rng, 32)),
                _ => rng.next_u32(),
            },
        }
    }

    /// A word of ordinary size, often near to where formulas have structure: a power of two, a small number, or one.
    pub fn ordinary(self, rng: &mut Pcg32) -> u32 {
        let power = 2_f32.powi(below(rng, 12) as i32 - 8);
        let size = match below(rng, 7) {
            0 => power,
            1 => power * (1.0 - log_uniform(rng, 1e-7, 1e-2)),
            2 => log_uniform(rng, 1e-4, 1e-2),
            3 => 1.0 - log_uniform(rng, 1e-7, 1e-1),
            4 => log_uniform(rng, 1e-3, 1e3),
            _ => unit(rng) as f32,
        };
        let x = match self {
            Self::Any => signed(rng, size),
            Self::Within(low, _) if low < 0.0 => signed(rng, size),
            _ => size,
        };
        let drawn = self.draw(rng);
        if self == Self::Word {
            drawn
        } else {
            self.confined(x.to_bits(), drawn)
        }
    }

    /// A word of up to 2^`far` steps beside this one; now and then one with another bit, as the sign.
    pub fn step(self, word: u32, far: f64, rng: &mut Pcg32) -> u32 {
        let most = (unit(rng) * far).exp2() as u32;
        let by = 1 + below(rng, most);
        let changed = match below(rng, 32) {
            0 => word ^ (1 << below(rng, 32)),
            k if k % 2 == 0 => word.wrapping_add(by),
            _ => word.wrapping_sub(by),
        };
        self.confined(changed, word)
    }

    /// The word itself where it is of this kind, otherwise the one before.
    fn confined(self, word: u32, before: u32) -> u32 {
        let x = f32::from_bits(word);
        let fits = match self {
            Self::Any => x.is_finite(),
            Self::Positive => x.is_finite() && x >= 0.0,
            Self::Within(low, high) => (low..=high).contains(&x),
            Self::Uniform => (0.0..1.0).contains(&x),
            Self::Word => true,
        };
        if fits { word } else { before }
    }

    /// A number beside another of the same sampler, where differences cancel.
    pub fn beside(self, other: u32, rng: &mut Pcg32) -> u32 {
        let by = 1_u32 << below(rng, 23);
        let near = match below(rng, 4) {
            0 => other,
            1 => other.wrapping_add(below(rng, by) + 1),
            2 => other.wrapping_sub(below(rng, by) + 1),
            _ => (f32::from_bits(other) * log_uniform(rng, 0.5, 8.0)).to_bits(),
        };
        let drawn = self.draw(rng);
        self.confined(near, drawn)
    }
}

/// What the first parameters that are accepted give.
///
/// # Panics
/// Where none of many is accepted: then the kinds of the parameters are wrong.
pub fn first_accepted<T>(kinds: &[Kind], build: impl Fn(&[u32]) -> Option<T>) -> T {
    let mut rng = Pcg32::new(1, 1);
    let drawn = (0..100_000).find_map(|_| {
        let words: Vec<u32> = kinds.iter().map(|kind| kind.draw(&mut rng)).collect();
        build(&words)
    });
    drawn.expect("no parameters were accepted")
}
