//! The error of what each map makes of its first uniform, over all of them: the radius, and the height of a direction.
//!
//! The first uniform alone moves the point along an axis, where sine and cosine are exact. For the concentric maps
//! it is the larger of the two numbers of the square that does so.

use crate::inputs::{STRIDE, Uniforms, in_parallel};
use crate::range::Range;
use microwarp::Warp;
use microwarp::tier::Tier;
use microwarp::uniform::LARGEST;
use microwarp::warp::{
    CosineHemisphere, Disk, DiskConcentric, Hemisphere, MalleyHemisphere, NormalPair, Sphere,
};

/// Bins per unit of the radius.
const FINE: f64 = 64.0;

/// Uniforms that are worked out together.
const BLOCK: usize = 64;

/// Every `f32` from here to 1 is tried. What is below, and off the grid, is argued.
const FIRST: f32 = 1.0 / 32.0;

/// First uniforms whose points have about the same radius.
#[derive(Clone, Copy, Debug)]
pub struct Bin {
    pub uniforms: Range,
    /// The largest radius.
    pub r: f64,
    /// The errors of radius and height.
    pub off: Range,
    pub height: Range,
    /// How much longer than 1 both make a direction: the errors times the exact radius and height.
    pub longer: Range,
}

impl Bin {
    const NONE: Self = Self {
        uniforms: Range::NONE,
        r: 0.0,
        off: Range::NONE,
        height: Range::NONE,
        longer: Range::NONE,
    };

    /// What is argued: a radius up to `r`, and errors up to these.
    pub fn argued(r: f64, off: f64, height: f64, longer: f64) -> Self {
        Self {
            uniforms: Range {
                low: 0.0,
                high: f64::from(FIRST),
            },
            r,
            off: Range::both(off),
            height: Range::both(height),
            longer: Range::both(longer),
        }
    }

    pub fn join(&mut self, other: &Self) {
        self.r = self.r.max(other.r);
        self.uniforms.join(other.uniforms);
        self.off.join(other.off);
        self.height.join(other.height);
        self.longer.join(other.longer);
    }
}

/// All bins of a map, and the errors of sin θ and cos θ in ulp: as found, and bounds of what is not tried.
pub struct Radii {
    pub bins: Vec<Bin>,
    pub sine: f64,
    pub cosine: f64,
    pub argued: [f64; 2],
}

impl Radii {
    /// Bins alone.
    pub fn of(bins: Vec<Bin>) -> Self {
        Self {
            bins,
            sine: 0.0,
            cosine: 0.0,
            argued: [0.0; 2],
        }
    }

    fn none() -> Self {
        Self::of(vec![Bin::NONE; 400])
    }
}

/// The spacing of f32 at the magnitude of a normal number of f64, as a reciprocal.
fn per_ulp(x: f64) -> f64 {
    f64::from_bits((2046 + 23 - (x.abs().to_bits() >> 52)) << 52)
}

/// Measures `map`, which makes radius and height of a uniform, against `exact`.
fn sweep(
    uniforms: Uniforms,
    map: impl Fn(f32) -> (f32, f32) + Sync,
    exact: impl Fn(f64) -> (f64, f64) + Sync,
) -> Radii {
    let (uniform, count): (fn(u32) -> f32, _) = match uniforms {
        // At 0 points are exact, or at the end of the square.
        Uniforms::Grid => (|i| i.max(1) as f32 / 16_777_216.0, 1 << 24),
        Uniforms::Any => (
            |i| f32::from_bits(FIRST.to_bits() + i),
            1.0_f32.to_bits() - FIRST.to_bits(),
        ),
    };
    let block = |steps: std::ops::Range<u32>, stride: u32, radii: &mut Radii| {
        let [
            mut us,
            mut rs,
            mut off,
            mut height,
            mut longer,
            mut sine,
            mut cosine,
        ] = [[0.0; BLOCK]; 7];
        for j in 0..BLOCK {
            // What is left of a block is filled up with its last uniform.
            let u = uniform((steps.start + j as u32 * stride).min(steps.end - 1));
            let ((r, z), (exact_r, exact_z)) = (map(u), exact(f64::from(u)));
            (us[j], rs[j]) = (f64::from(u), f64::from(r));
            off[j] = rs[j] - exact_r;
            height[j] = f64::from(z) - exact_z;
            longer[j] = off[j] * exact_r + height[j] * exact_z;
            sine[j] = off[j].abs() * per_ulp(exact_r);
            cosine[j] = height[j].abs() * per_ulp(exact_z);
        }
        let r = Range::of(&rs).high;
        radii.sine = radii.sine.max(Range::of(&sine).high);
        radii.cosine = radii.cosine.max(Range::of(&cosine).high);
        radii.bins[(r * FINE) as usize].join(&Bin {
            uniforms: Range::of(&us),
            r,
            off: Range::of(&off),
            height: Range::of(&height),
            longer: Range::of(&longer),
        });
    };
    let share = 1 << 16;
    let parts = in_parallel(count / share, |i| {
        let mut part = Radii::none();
        // The last radii of a normal pair are far apart, and stand alone.
        let apart = if (i + 1) * share == count { 4096 } else { 0 };
        let (start, middle, end) = (i * share, (i + 1) * share - apart, (i + 1) * share);
        let reach = BLOCK as u32 * *STRIDE;
        for start in (start..middle).step_by(reach as usize) {
            block(start..(start + reach).min(middle), *STRIDE, &mut part);
        }
        for i in middle..end {
            block(i..i + 1, 1, &mut part);
        }
        part
    });
    let mut radii = Radii::none();
    for part in parts {
        radii.sine = radii.sine.max(part.sine);
        radii.cosine = radii.cosine.max(part.cosine);
        for (bin, of_part) in radii.bins.iter_mut().zip(&part.bins) {
            bin.join(of_part);
        }
    }
    radii.bins.retain(|bin| bin.off.low <= bin.off.high);
    radii
}

fn flat([x, y]: [f32; 2]) -> (f32, f32) {
    assert!(y == 0.0);
    (x.abs(), 0.0)
}

fn lifted([x, y, z]: [f32; 3]) -> (f32, f32) {
    assert!(y == 0.0);
    (x.abs(), z)
}

/// Measures the map of that name, with radii taken `wrong` steps of `f32` too large.
pub fn radii<T: Tier>(name: &str, uniforms: Uniforms, wrong: u32) -> Radii {
    let off = |(r, z): (f32, f32)| (f32::from_bits(r.to_bits() + wrong), z);
    let step = |k: i32| 2.0_f64.powi(k);
    // Of each map the sweep; then, for uniforms up to 2^-5, what is argued, sin θ and cos θ in ulp included. There
    // 1 - u is rounded by 2^-25, and a root halves relative errors before it is itself rounded.
    let (mut radii, below, sine, cosine) = match name {
        "Disk" => (
            sweep(
                uniforms,
                |u| off(flat(Disk::<T>::new().sample([u, 0.0]))),
                |u| (u.sqrt(), 0.0),
            ),
            Bin::argued(0.177, step(-27), 0.0, 0.0),
            0.5,
            0.0,
        ),
        "CosineHemisphere" => (
            sweep(
                uniforms,
                |u| off(lifted(CosineHemisphere::<T>::new().sample([u, 0.0]))),
                |u| (u.sqrt(), (1.0 - u).sqrt()),
            ),
            Bin::argued(0.177, step(-27), 0.76 * step(-24), 0.79 * step(-24)),
            0.5,
            0.76,
        ),
        // Two roundings, of 0.76·2^-24 of the root together, stand under the root.
        "Sphere" => (
            sweep(
                uniforms,
                |u| off(lifted(Sphere::<T>::new().sample([u, 0.0]))),
                |u| (2.0 * (u * (1.0 - u)).sqrt(), 1.0 - 2.0 * u),
            ),
            Bin::argued(0.35, 1.26 * step(-25), step(-25), 2.0 * step(-25)),
            1.26,
            0.0,
        ),
        // The square is rounded by 2^-25, and what 1 - u lacks counts 2u-fold; the height is the uniform itself.
        "Hemisphere" => (
            sweep(
                uniforms,
                |u| off(lifted(Hemisphere::<T>::new().sample([u, 0.0]))),
                |u| (((1.0 - u) * (1.0 + u)).sqrt(), u),
            ),
            Bin::argued(1.0, 0.77 * step(-24), 0.0, 0.77 * step(-24)),
            0.77,
            0.0,
        ),
        // The radius 1 - 2u is rounded by 2^-25.
        "DiskConcentric" => (
            sweep(
                uniforms,
                |u| off(flat(DiskConcentric::<T>::new().sample([u, 0.5]))),
                |u| ((1.0 - 2.0 * u).abs(), 0.0),
            ),
            Bin::argued(1.0, step(-25), 0.0, 0.0),
            0.0,
            0.0,
        ),
        "MalleyHemisphere" => (
            sweep(
                uniforms,
                |u| off(lifted(MalleyHemisphere::<T>::new().sample([u, 0.5]))),
                |u| ((1.0 - 2.0 * u).abs(), 2.0 * (u * (1.0 - u)).sqrt()),
            ),
            Bin::argued(1.0, step(-25), 1.26 * step(-25), 1.5 * step(-25)),
            0.0,
            0.0,
        ),
        // The radius is below 0.252; an error of 2^-20 of it would be far more than the roundings can make.
        "NormalPair" => {
            let normal = NormalPair::<T>::new([0.0; 2], 1.0).unwrap();
            (
                sweep(
                    uniforms,
                    |u| off(flat(normal.sample([u, 0.0]))),
                    |u| ((-2.0 * (-u).ln_1p()).sqrt(), 0.0),
                ),
                Bin::argued(0.252, 0.252 * step(-20), 0.0, 0.0),
                0.0,
                0.0,
            )
        }
        _ => panic!("no map {name}"),
    };
    if uniforms == Uniforms::Any {
        radii.bins.push(below);
        radii.argued = [sine, cosine];
    }
    radii
}

/// The ends of the square, where uniforms up to 2^-26 count as 0 and the radius is held at [`LARGEST`], not
/// 1 - 2u: of the kernel `rim`, which makes points of that radius at once.
pub fn end(uniforms: Uniforms) -> Radii {
    let held = match uniforms {
        Uniforms::Grid => 0.0,
        Uniforms::Any => 2.0_f64.powi(-25),
    };
    let mut radii = Radii::none();
    // The height is below 2^-12 and right to two ulp.
    let mut bin = Bin::argued(1.0, 0.0, 2.0_f64.powi(-34), 2.0_f64.powi(-46));
    bin.uniforms.high = 0.5 * held;
    bin.off.high += held;
    bin.longer.high += held;
    radii.bins = vec![bin];
    radii
}

/// The point of the largest radius at a phase.
pub fn rim(kernel: impl Fn(f32) -> (f32, f32)) -> impl Fn(f32) -> (f32, f32) {
    move |t| {
        let (s, c) = kernel(t);
        (LARGEST * s, LARGEST * c)
    }
}
