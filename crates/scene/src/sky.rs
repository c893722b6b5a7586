//! What rays see that hit nothing.

use crate::vector::Vector;
use microwarp::discrete::LatLongMap;
use microwarp::tier::Tier;

/// The pixels of a sky's table.
pub const COLUMNS: usize = 32;
pub const ROWS: usize = 16;

/// The table that a sky is sampled by.
pub type Table<T> = LatLongMap<T, [u32; ROWS], [[u32; COLUMNS]; ROWS]>;

/// The light from far away. The table says where to look for it, roughly; the radiance is what is there. Where the table
/// has a weight of 0, the sky is black.
pub trait Sky: Copy {
    fn radiance(&self, direction: Vector) -> Vector;
    /// None for a black sky.
    fn table<T: Tier>(&self) -> Option<&Table<T>>;
}

/// A black one.
#[derive(Clone, Copy, Debug)]
pub struct NoSky;

impl Sky for NoSky {
    #[inline]
    fn radiance(&self, _: Vector) -> Vector {
        [0.0; 3]
    }

    #[inline]
    fn table<T: Tier>(&self) -> Option<&Table<T>> {
        None
    }
}
