//! What crosses the boundary: how each type of uniforms, points, densities and parameters looks in C.
//!
//! A number is handed over by value. Several are read or written through a pointer.

use core::array::from_fn;
use core_crate::Warp;
use core_crate::discrete::MeshPoint;
use core_crate::warp::SurfacePoint;
use fixed::types::extra::{LeEqU32, LeEqU64};
use fixed::{FixedI32, FixedU32, FixedU64};
use rand_core::TryRng;

/// The place of an out-parameter that C does not have, because the value is returned.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Returned;

/// A type of the crate with a form in C.
pub trait Value: Copy {
    /// In memory.
    type C: Copy;
    /// As an argument.
    type Given: Copy;
    /// As the last parameter of a function that yields it.
    type Place: Copy;
    /// As what such a function returns.
    type Result;

    fn to_c(self) -> Self::C;

    fn from_c(c: Self::C) -> Self;

    /// As the argument of a callback.
    fn given(c: &Self::C) -> Self::Given;

    /// # Safety
    /// A pointer must be valid for reads.
    unsafe fn read(given: Self::Given) -> Self;

    /// # Safety
    /// A pointer must be valid for writes.
    unsafe fn yielded(self, place: Self::Place) -> Self::Result;

    /// Fills memory of C, in order, up to where the generator fails.
    #[inline]
    fn fill<W: Warp<Point = Self>, R: TryRng>(
        warp: &W,
        rng: &mut R,
        points: &mut [Self::C],
    ) -> Result<(), R::Error> {
        for point in points {
            *point = warp.try_draw(rng)?.to_c();
        }
        Ok(())
    }
}

/// What has the same form on both sides, so that slices are filled in place.
macro_rules! same_in_c {
    () => {
        type C = Self;

        #[inline]
        fn to_c(self) -> Self {
            self
        }

        #[inline]
        fn from_c(c: Self) -> Self {
            c
        }

        #[inline]
        fn fill<W: Warp<Point = Self>, R: TryRng>(
            warp: &W,
            rng: &mut R,
            points: &mut [Self],
        ) -> Result<(), R::Error> {
            warp.try_fill(rng, points)
        }
    };
}

macro_rules! by_pointer {
    () => {
        by_pointer!(|given| Self::from_c(given.read()));
    };
    (|$given:ident| $read:expr) => {
        type Given = *const Self::C;
        type Place = *mut Self::C;
        type Result = ();

        #[inline]
        fn given(c: &Self::C) -> *const Self::C {
            c
        }

        #[inline]
        unsafe fn read($given: *const Self::C) -> Self {
            // SAFETY: the caller's promise.
            unsafe { $read }
        }

        #[inline]
        unsafe fn yielded(self, place: *mut Self::C) {
            // SAFETY: the caller's promise.
            unsafe { place.write(self.to_c()) }
        }
    };
}

/// One number.
pub trait Number: Copy {}

impl Number for f32 {}
impl Number for u16 {}
impl Number for u32 {}
impl Number for i32 {}
impl<F: LeEqU32> Number for FixedU32<F> {}
impl<F: LeEqU32> Number for FixedI32<F> {}
impl<F: LeEqU64> Number for FixedU64<F> {}

impl<T: Number> Value for T {
    same_in_c!();
    type Given = Self;
    type Place = Returned;
    type Result = Self;

    #[inline]
    fn given(c: &Self) -> Self {
        *c
    }

    #[inline]
    unsafe fn read(given: Self) -> Self {
        given
    }

    #[inline]
    unsafe fn yielded(self, _: Returned) -> Self {
        self
    }
}

/// Read number by number. A load of two numbers at once waits until both have left the processor's queue of stores, and
/// callers have often just stored them.
impl<T: Number, const N: usize> Value for [T; N] {
    same_in_c!();
    by_pointer!(|given| from_fn(|i| given.cast::<T>().add(i).read_volatile()));
}

impl<T: Number, const N: usize, const M: usize> Value for [[T; N]; M] {
    same_in_c!();
    by_pointer!();
}

/// A point of the simplex: the shares, and what remains of 1.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Shares<T, const N: usize> {
    shares: [T; N],
    rest: T,
}

impl<T: Number, const N: usize> Value for ([T; N], T) {
    type C = Shares<T, N>;
    by_pointer!();

    #[inline]
    fn to_c(self) -> Self::C {
        let (shares, rest) = self;
        Shares { shares, rest }
    }

    #[inline]
    fn from_c(c: Self::C) -> Self {
        (c.shares, c.rest)
    }
}

/// A point of a surface, with the normal there.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Surface {
    position: [f32; 3],
    normal: [f32; 3],
}

impl Value for SurfacePoint {
    type C = Surface;
    by_pointer!();

    #[inline]
    fn to_c(self) -> Surface {
        let Self { position, normal } = self;
        Surface { position, normal }
    }

    #[inline]
    fn from_c(Surface { position, normal }: Surface) -> Self {
        Self { position, normal }
    }
}

/// A point of a mesh, with the triangle it is on.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct OnMesh {
    position: [f32; 3],
    barycentrics: [f32; 3],
    triangle: usize,
}

impl Value for MeshPoint {
    type C = OnMesh;
    by_pointer!();

    #[inline]
    fn to_c(self) -> OnMesh {
        let Self {
            position,
            barycentrics,
            triangle,
        } = self;
        OnMesh {
            position,
            barycentrics,
            triangle,
        }
    }

    #[inline]
    fn from_c(
        OnMesh {
            position,
            barycentrics,
            triangle,
        }: OnMesh,
    ) -> Self {
        Self {
            position,
            barycentrics,
            triangle,
        }
    }
}
