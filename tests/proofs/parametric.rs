//! The maps with parameters, written once more: over any kind of number.
//!
//! Each is run on `f32`, where its bits have to be those of the crate; on `f64`, where it has to be the truth; and recorded,
//! which bounds the difference of the two.

use crate::number::Number;
use crate::range::Range;
use crate::rounding::UNIT;
use crate::sweeps::{Halves, of_size};

/// A program: what a constructor keeps, and what is made of it and of the first uniform.
pub trait Form: Sync {
    /// What the constructor keeps, exactly, of parameters as the boxes have them.
    fn fields<N: Number>(&self, parameters: &[N]) -> Vec<N>;

    /// By how many halves of an ulp each is off.
    fn off(&self, parameters: &[Range]) -> Vec<f64>;

    /// The radius and the height of u = uniforms[0], of which 1 - u is uniforms[1]; or the point of all.
    fn place<N: Number>(&self, fields: &[N], uniforms: &[N]) -> Vec<N>;
}

/// Barycentric coordinates of two uniforms. A control rounds the root once more.
pub struct Triangle {
    pub once_more: bool,
}

impl Form for Triangle {
    fn fields<N: Number>(&self, _: &[N]) -> Vec<N> {
        Vec::new()
    }

    fn off(&self, _: &[Range]) -> Vec<f64> {
        Vec::new()
    }

    fn place<N: Number>(&self, _: &[N], u: &[N]) -> Vec<N> {
        let one = u[0].like(1.0);
        let s = u[0].sqrt();
        let s = if self.once_more {
            s * u[0].like(3.0) / u[0].like(3.0)
        } else {
            s
        };
        vec![u[1] / (one + s), s * u[2], s * u[3]]
    }
}

/// A coordinate of a point of a triangle, of those of the vertices. Of the control see [`Triangle`].
pub struct Vertices {
    pub once_more: bool,
}

impl Form for Vertices {
    fn fields<N: Number>(&self, vertices: &[N]) -> Vec<N> {
        vertices.to_vec()
    }

    fn off(&self, _: &[Range]) -> Vec<f64> {
        vec![0.0; 3]
    }

    fn place<N: Number>(&self, of: &[N], u: &[N]) -> Vec<N> {
        let Self { once_more } = *self;
        let w = Triangle { once_more }.place(&[], u);
        vec![w[0] * of[0] + w[1] * of[1] + w[2] * of[2]]
    }
}

/// The radius of a point of a ring, of its inner radius as a part of the outer one, and of that.
pub struct Ring;

impl Form for Ring {
    fn fields<N: Number>(&self, ring: &[N]) -> Vec<N> {
        let (part, high, one) = (ring[0], ring[1], ring[0].like(1.0));
        vec![part * high, high * high * ((one - part) * (one + part))]
    }

    fn off(&self, _: &[Range]) -> Vec<f64> {
        vec![0.0, ONCE]
    }

    fn place<N: Number>(&self, fields: &[N], u: &[N]) -> Vec<N> {
        let [low, area] = [fields[0], fields[1]];
        let (gain, square) = (u[0] * area, low * low);
        let root = (square + gain).sqrt();
        let r = if gain.below(square) {
            low + gain / (low + root)
        } else {
            root
        };
        vec![r, low.like(0.0)]
    }
}

/// sin θ and cos θ of 1 - cos θ, or of 1 + cos θ, whichever is the smaller.
fn polar<N: Number>(small: N, lifted: N, root: f32, ahead: bool) -> Vec<N> {
    // Where both are next to 1 in real numbers, what is rounded may choose either.
    let small = small.at_most(1.0 + 64.0 * UNIT);
    let cos = small.like(1.0) - small;
    // 2 - s is rounded by 2^-24 at most, and not where s is 1 or more: the product is below 1 + 2^-24, and rounded to 1.
    let square = lifted * (small.like(2.0) - small);
    let sin = square.at_most(f64::from(root).powi(-2)).sqrt() * small.like(root);
    vec![sin, if ahead { cos } else { small - small.like(1.0) }]
}

/// 2¹²⁶, which a cone lifts by, and 2⁻⁶³, the root of its reciprocal.
const LIFT: f32 = 8.507_059e37;
const UNLIFT_ROOT: f32 = 1.084_202_2e-19;

/// sin θ and cos θ of one number alone, for the length that they make whatever the number is off by.
pub struct Polar;

impl Form for Polar {
    fn fields<N: Number>(&self, _: &[N]) -> Vec<N> {
        Vec::new()
    }

    fn off(&self, _: &[Range]) -> Vec<f64> {
        Vec::new()
    }

    fn place<N: Number>(&self, _: &[N], u: &[N]) -> Vec<N> {
        polar(u[0], u[0] * u[0].like(LIFT), UNLIFT_ROOT, true)
    }
}

/// A cone of k = 1 - cos θmax, or where it is above 1 of 2 - k; both are off by so many halves of an ulp.
pub struct Cone {
    pub wide: bool,
    pub off: [Halves; 2],
}

impl Form for Cone {
    fn fields<N: Number>(&self, k: &[N]) -> Vec<N> {
        let rest = k[0].like(2.0) - k[0];
        let [k, rest] = if self.wide {
            [rest, k[0]]
        } else {
            [k[0], rest]
        };
        vec![k * k.like(LIFT), rest]
    }

    fn off(&self, parameters: &[Range]) -> Vec<f64> {
        // A box is within a quarter of a binade.
        let size = of_size(0.5 * (parameters[0].low + parameters[0].high));
        let [k, rest] = self.off;
        // Of a narrow cone 2 - k does not count.
        if self.wide {
            vec![k[13..].iter().copied().fold(0.0, f64::max), rest[size]]
        } else {
            vec![k[size], 0.0]
        }
    }

    fn place<N: Number>(&self, fields: &[N], u: &[N]) -> Vec<N> {
        let [k, rest] = [fields[0], fields[1]];
        let [lift, unlift] = [LIFT, 1.0 / LIFT].map(|x| k.like(x));
        let lifted = u[0] * k;
        let down = lifted * unlift;
        let up = rest + u[1] * (k * unlift);
        let ahead = down.below(k.like(1.0));
        let (small, lifted) = if ahead {
            (down, lifted)
        } else {
            (up, up * lift)
        };
        polar(small, lifted, UNLIFT_ROOT, ahead)
    }
}

/// 2¹²⁴, by which Henyey and Greenstein's law lifts, and 2⁻⁶², the root of its reciprocal.
const FOG_LIFT: f32 = 2.126_764_8e37;
const FOG_UNLIFT_ROOT: f32 = 2.168_404_3e-19;

/// Henyey and Greenstein's law of 1 - |g|.
pub struct Fog {
    pub backward: bool,
    pub of: Given,
}

/// Which number a constructor is given.
#[derive(Clone, Copy, Debug)]
pub enum Given {
    G,
    OneMinusG,
}

impl Form for Fog {
    fn fields<N: Number>(&self, d: &[N]) -> Vec<N> {
        let (d, lift) = (d[0], d[0].like(FOG_LIFT));
        let (h, far) = (d.like(1.0) - d, d.like(2.0) - d);
        let [near, far] = [d * d * lift, far * far * lift];
        let [ahead, behind] = if self.backward {
            [far, near]
        } else {
            [near, far]
        };
        vec![h, d, ahead, behind]
    }

    fn off(&self, d: &[Range]) -> Vec<f64> {
        // The complement is exact where the number that is given is at least a half.
        let [h, least] = match self.of {
            Given::G if d[0].high > 0.5 => [0.0, 1.0],
            Given::OneMinusG if d[0].low < 0.5 => [1.0, 0.0],
            _ => [0.0, 0.0],
        };
        vec![h, least, ONCE, ONCE]
    }

    fn place<N: Number>(&self, fields: &[N], u: &[N]) -> Vec<N> {
        let [h, least, ahead, behind] = [0, 1, 2, 3].map(|k| fields[k]);
        let number = |x: f32| h.like(x);
        let (from_down, from_up) = if self.backward {
            (least, number(1.0))
        } else {
            (number(1.0), least)
        };
        let rise = h * if self.backward { u[0] } else { u[1] };
        let c = least + number(2.0) * rise;
        let square = number(0.5) * (c * c);
        let down = u[0] * (ahead * (from_down + rise));
        let up = u[1] * (behind * (from_up + rise));
        let before = !up.below(down);
        let lifted = if before { down } else { up } / square;
        polar(
            lifted * number(1.0 / FOG_LIFT),
            lifted,
            FOG_UNLIFT_ROOT,
            before,
        )
    }
}

/// A product of sums of two is rounded once; what else is lost is a 2⁻²²nd of that.
const ONCE: f64 = 1.001;
