//! A warp with a planted defect, which the search must find within its usual budget.

use super::directions;
use super::family::{Family, Subject};
use crate::raw::raw;
use fixed::types::{I2F30, U0F32, U2F62};
use host::adversary::search::{Budget, USUAL};
use host::adversary::{Family as Attacked, attack};
use microwarp::fixed::warp::Cone;
use microwarp::fixed::{Density, Fine, Grade, Uniform};
use microwarp::uniform::Canonical;
use microwarp::{Invert, Warp};

/// A cone whose sine is halved to its size before it is turned, so that what the product cuts counts in full.
#[derive(Clone, Copy)]
struct Halved {
    warp: Cone<Fine>,
    /// k/2 in Q64, its first bit set by so many doublings.
    half: u64,
    doublings: u32,
}

/// a·b/2³² from three products of 16 bits, each cut.
fn cut(a: u32, b: i32) -> i32 {
    let (head, low) = (b >> 16, (b & 0xffff) as u32);
    ((i64::from(a) * i64::from(head)) >> 16) as i32 + (((a >> 16) * low) >> 16) as i32
}

impl Warp for Halved {
    type Uniforms = [Uniform; 2];
    type Point = [I2F30; 3];
    type Density = Density;

    fn sample_canonical(&self, u: Canonical<[Uniform; 2]>) -> [I2F30; 3] {
        let [u1, u2] = u.get();
        let h = ((u128::from(self.half) * u128::from(u1.to_bits())) >> 64) as u32;
        // sin²/4 is h to all the digits there are.
        let sine = Fine::sqrt(U0F32::from_bits(h)).to_bits();
        let by = self.doublings - 2;
        let sine = if by % 2 == 0 {
            sine >> (by / 2)
        } else {
            Fine::sqrt(U0F32::from_bits(h >> 1)).to_bits() >> (by / 2)
        };
        let (s, c) = Fine::sincos_turns(u2);
        let [x, y] = [c, s].map(|c| I2F30::from_bits(cut(sine, c.to_bits())));
        [
            x,
            y,
            I2F30::ONE - I2F30::from_bits((h >> self.doublings.min(31) >> 1) as i32),
        ]
    }

    fn pdf(&self, point: [I2F30; 3]) -> Density {
        self.warp.pdf(point)
    }
}

impl Invert for Halved {
    fn invert(&self, point: [I2F30; 3]) -> [Uniform; 2] {
        self.warp.invert(point)
    }
}

/// Narrow cones only, which the defect is about.
fn halved(p: &[u32]) -> Option<Subject> {
    let k = (u64::from(p[1]) << 32 | u64::from(p[2])) >> (20 + p[0] % 13);
    let warp = Cone::<Fine>::from_one_minus_cos(U2F62::from_bits(k)).ok()?;
    let doublings = k.leading_zeros() - 1;
    let half = (k << 1) << doublings;
    let halved = Halved {
        warp,
        half,
        doublings,
    };
    directions::cone_of(raw(halved), k as f64 * 0.5_f64.powi(62))
}

#[test]
fn the_old_narrow_cone_is_found() {
    let family: Attacked = Family {
        name: "Cone",
        grade: 0,
        rows: directions::CONE,
        parameters: 3,
        words: 2,
        build: halved,
    }
    .stated();
    let found = attack(&[family], Budget::Points(USUAL));
    let sample = found[0][0].ratio;
    println!("{sample:.3} of what is stated");
    assert!(sample > 1.5);
}
