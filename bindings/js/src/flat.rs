//! How points, uniforms and parameters lie in the module's memory: number after number.

use microwarp::warp::SurfacePoint;

/// A value that lies in memory as numbers of 32 bits, in an order that a caller can rely on.
pub trait Flat: Copy {
    /// As it lies there.
    type Raw: Copy;
    /// Its kind among those of as many numbers: plain ones, shares and the rest, or a position and its normal.
    const LAYOUT: u8 = 0;
    fn raw(self) -> Self::Raw;
    fn of(raw: Self::Raw) -> Self;
}

/// Two parts, one behind the other.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct Both<A, B>(pub A, pub B);

/// What lies there as it is.
pub trait Plain: Copy {}
impl Plain for f32 {}
impl Plain for u32 {}
impl<const N: usize> Plain for [f32; N] {}
impl<const N: usize> Plain for [[f32; 2]; N] {}
impl<const N: usize> Plain for [[f32; 3]; N] {}

impl<T: Plain> Flat for T {
    type Raw = Self;
    fn raw(self) -> Self {
        self
    }
    fn of(raw: Self) -> Self {
        raw
    }
}

/// A count; what is none becomes 0, which no constructor takes.
impl Flat for u16 {
    type Raw = f32;
    fn raw(self) -> f32 {
        self.into()
    }
    fn of(raw: f32) -> Self {
        let count = raw as Self;
        if f32::from(count) == raw { count } else { 0 }
    }
}

/// Shares and the rest.
impl<const N: usize> Flat for ([f32; N], f32) {
    type Raw = Both<[f32; N], f32>;
    const LAYOUT: u8 = 1;
    fn raw(self) -> Self::Raw {
        Both(self.0, self.1)
    }
    fn of(Both(shares, rest): Self::Raw) -> Self {
        (shares, rest)
    }
}

impl Flat for SurfacePoint {
    type Raw = Both<[f32; 3], [f32; 3]>;
    const LAYOUT: u8 = 2;
    fn raw(self) -> Self::Raw {
        Both(self.position, self.normal)
    }
    fn of(Both(position, normal): Self::Raw) -> Self {
        Self { position, normal }
    }
}

/// Reads a value.
///
/// # Safety
/// It lies there.
pub unsafe fn get<P: Flat>(from: *const f32) -> P {
    // SAFETY: as the caller says.
    P::of(unsafe { from.cast::<P::Raw>().read_unaligned() })
}

/// Writes a value.
///
/// # Safety
/// There is room for it.
pub unsafe fn put<P: Flat>(to: *mut f32, value: P) {
    // SAFETY: as the caller says.
    unsafe { to.cast::<P::Raw>().write_unaligned(value.raw()) }
}
