//! A picture, pixel by pixel, and one word that tells two pictures apart.

use crate::camera::View;
use crate::film::Film;
use crate::fog::Fog;
use crate::kit::Kit;
use crate::light::Light;
use crate::material::Material;
use crate::path::{Heuristic, Scene};
use crate::sky::Sky;
use crate::source::Source;
use crate::vector::{Vector, plus, scaled};

/// How a picture is taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Plan {
    /// Columns and rows.
    pub size: [u32; 2],
    /// Samples a pixel.
    pub samples: u32,
    pub seed: u32,
}

impl Plan {
    /// The number of a pixel, which is given by column and row: row by row.
    #[must_use]
    #[inline]
    pub const fn index(&self, [column, row]: [u32; 2]) -> u32 {
        let [width, _] = self.size;
        row.wrapping_mul(width).wrapping_add(column)
    }
}

impl<M: Material, L: Light, E: Sky, F: Fog> Scene<'_, M, L, E, F> {
    /// The mean of the samples of a pixel, which is given by column and row; black where no sample is asked for.
    pub fn pixel<K: Kit, H: Heuristic, P: Film, S: Source>(
        &self,
        view: &View<K>,
        pixel: [u32; 2],
        plan: &Plan,
    ) -> Vector {
        let mut source = S::of_pixel(plan, pixel);
        let mut sum = [0.0; 3];
        for sample in 0..plan.samples {
            source.begin(sample);
            sum = plus(sum, self.sample::<K, H, P>(view, pixel, &mut source));
        }
        scaled(sum, 1.0 / plan.samples.max(1) as f32)
    }
}

/// A hash of colours, to compare pictures across machines: 32-bit FNV-1a of the bits of the channels, lowest byte first.
/// <https://doi.org/10.17487/RFC9923>
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Hash(u32);

impl Hash {
    /// That of no colour.
    pub const EMPTY: Self = Self(0x811C_9DC5);

    #[must_use]
    pub fn with(self, colour: Vector) -> Self {
        let bytes = colour.map(|channel| channel.to_bits().to_le_bytes());
        let mix = |hash: u32, byte: &u8| (hash ^ u32::from(*byte)).wrapping_mul(0x0100_0193);
        Self(bytes.as_flattened().iter().fold(self.0, mix))
    }

    #[must_use]
    pub const fn word(self) -> u32 {
        self.0
    }
}
