//! What a law makes of one input, and the exact number.

use host::adversary::kept;
use host::registry::{Entry, Registered};
use host::truth::precisely;

/// What a law makes of a uniform or a word under some parameters, and the exact number.
pub struct Unit {
    entry: Entry,
    normal: bool,
}

impl Unit {
    pub fn new(of: &Registered, parameters: &[f32]) -> Self {
        let entry = (of.build)(parameters).expect("accepted parameters");
        Self {
            normal: of.name == "Normal",
            ..Self::of_entry(entry)
        }
    }

    pub fn of_entry(entry: Entry) -> Self {
        Self {
            entry,
            normal: false,
        }
    }

    /// The same with exact numbers of 237 bits.
    pub fn precise(of: &Registered, parameters: &[f32]) -> Self {
        let (entry, made) = precisely(|| (of.build)(parameters));
        assert!(made > 0);
        Self::of_entry(entry.expect("accepted parameters"))
    }

    /// The uniforms of the worst cases that searches have kept.
    pub fn kept(&self) -> Vec<f32> {
        let of_either = kept::cases("accuracy/worst.csv").into_iter();
        let own = of_either.filter(|(label, ..)| label.split(' ').next() == Some(self.entry.name));
        own.map(|(.., [u, _, _, _])| f32::from_bits(u)).collect()
    }

    /// Whether a draw keeps the bound at the exact middle of its word.
    pub fn has_words(&self) -> bool {
        self.entry.middle
    }

    pub fn sample(&self, u: f32) -> f32 {
        self.entry.warp.sample([u, 0.0, 0.0, 0.0])[0]
    }

    pub fn drawn(&self, word: u32) -> f32 {
        self.entry.warp.drawn(word)[0]
    }

    pub fn density(&self, u: f32) -> f32 {
        self.entry.warp.sample_with_pdf([u, 0.0, 0.0, 0.0]).1
    }

    /// What a uniform of 0 counts as.
    fn counted(&self, u: f64) -> f64 {
        let smallest = f64::from(f32::from_bits(1));
        if u == 0.0 && self.entry.open {
            smallest
        } else {
            u
        }
    }

    /// The exact sample of a uniform, which may be the middle of a word. That of a normal law, under its unit, is found from
    /// a number close to it.
    pub fn exact(&self, u: f64, near: f32) -> f64 {
        let u = self.counted(u);
        if self.normal {
            normal_quantile(u.max(f64::from(f32::from_bits(1))), near.into())
        } else {
            self.entry.truth.sample([u, 0.0, 0.0, 0.0])[0]
        }
    }

    /// The exact density of a uniform.
    pub fn exact_density(&self, u: f64) -> f64 {
        self.entry.truth.density([self.counted(u), 0.0, 0.0, 0.0])
    }
}

/// The middle of the cell of a word.
pub fn middle(word: u32) -> f64 {
    (f64::from(word) + 0.5) / 4_294_967_296.0
}

/// The standard normal quantile by one step of Newton's method, and what its square adds, from a number that is off by no more
/// than 1e-6 of itself: 1e-17 of it is left. About the median the probability counts from there, so that nothing cancels.
fn normal_quantile(u: f64, near: f64) -> f64 {
    let z = near.abs();
    // The tail beyond -z less that of u, and the same from the median.
    let over = if z < 0.7 {
        (0.5 - u).abs() - 0.5 * host::truth::erf(z * std::f64::consts::FRAC_1_SQRT_2)
    } else {
        host::truth::normal_cdf(-z) - u.min(1.0 - u)
    };
    let step = over * (0.5 * z * z).exp() * std::f64::consts::TAU.sqrt();
    let exact = z + step * (1.0 + 0.5 * z * step);
    if u < 0.5 { -exact } else { exact }
}
