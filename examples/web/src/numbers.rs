//! A point as the page sees it: as `f64`, which holds every number of every tier exactly, and as bits, for timing.

use fixed::types::U32F32;
use fixed::types::extra::LeEqU32;
use fixed::{FixedI32, FixedU32};
use microwarp::warp::SurfacePoint;

/// Points and densities of any tier.
pub trait Numbers: Copy {
    /// The first three numbers; missing ones are 0.
    fn wide(self) -> [f64; 3];
    /// Some function of all bits.
    fn bits(self) -> u32;
}

impl Numbers for f32 {
    fn wide(self) -> [f64; 3] {
        [self.into(), 0.0, 0.0]
    }
    fn bits(self) -> u32 {
        self.to_bits()
    }
}

impl Numbers for usize {
    fn wide(self) -> [f64; 3] {
        [self as f64, 0.0, 0.0]
    }
    fn bits(self) -> u32 {
        self as u32
    }
}

impl Numbers for U32F32 {
    fn wide(self) -> [f64; 3] {
        [self.to_bits() as f64 / 4_294_967_296.0, 0.0, 0.0]
    }
    fn bits(self) -> u32 {
        self.to_bits() as u32
    }
}

/// One step of a format of so many fraction bits.
fn step(fraction_bits: u32) -> f64 {
    1.0 / (1_u64.wrapping_shl(fraction_bits)) as f64
}

impl<Frac: LeEqU32> Numbers for FixedI32<Frac> {
    fn wide(self) -> [f64; 3] {
        [f64::from(self.to_bits()) * step(Frac::U32), 0.0, 0.0]
    }
    fn bits(self) -> u32 {
        self.to_bits() as u32
    }
}

impl<Frac: LeEqU32> Numbers for FixedU32<Frac> {
    fn wide(self) -> [f64; 3] {
        [f64::from(self.to_bits()) * step(Frac::U32), 0.0, 0.0]
    }
    fn bits(self) -> u32 {
        self.to_bits()
    }
}

impl<N: Numbers> Numbers for [N; 2] {
    fn wide(self) -> [f64; 3] {
        let [[x, ..], [y, ..]] = self.map(N::wide);
        [x, y, 0.0]
    }
    fn bits(self) -> u32 {
        let [x, y] = self.map(N::bits);
        x ^ y.rotate_left(9)
    }
}

impl<N: Numbers> Numbers for [N; 3] {
    fn wide(self) -> [f64; 3] {
        self.map(|number| {
            let [number, ..] = number.wide();
            number
        })
    }
    fn bits(self) -> u32 {
        let [x, y, z] = self.map(N::bits);
        x ^ y.rotate_left(9) ^ z.rotate_left(19)
    }
}

impl Numbers for [f32; 4] {
    fn wide(self) -> [f64; 3] {
        let [x, y, z, _] = self;
        [x, y, z].wide()
    }
    fn bits(self) -> u32 {
        let [x, y, z, w] = self;
        ([x, y, z], w).bits()
    }
}

/// A point of a simplex and what is left.
impl<N: Numbers> Numbers for (N, f32) {
    fn wide(self) -> [f64; 3] {
        self.0.wide()
    }
    fn bits(self) -> u32 {
        self.0.bits() ^ self.1.to_bits().rotate_left(5)
    }
}

impl Numbers for SurfacePoint {
    fn wide(self) -> [f64; 3] {
        self.position.wide()
    }
    fn bits(self) -> u32 {
        self.position.bits() ^ self.normal.bits().rotate_left(5)
    }
}
