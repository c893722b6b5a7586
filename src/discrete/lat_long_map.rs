//! A picture of all directions by latitude and longitude, as a distribution of directions.

use super::piecewise2d::{PiecewiseConstant2d, try_words};
use super::selection::amount;
use super::storage::{Grid, OwnedStorage, Storage};
use super::word::Word;
use super::zones::{Zones, sine_of_quarters};
use crate::error::Error;
use crate::num::{clamp, into_unit, representable};
use crate::tier::{Tier, sqrt};
use crate::uniform::{Canonical, Uniforms, infallible};
use crate::warp::direction::{DEEP, around, azimuth, is_direction, one_minus_cos};
use crate::warp::{Invert, Warp};
use core::f32::consts::FRAC_1_PI;
use core::marker::PhantomData;
use rand_core::{Rng, TryRng};

/// Directions in proportion to a latitude-longitude map: an equirectangular environment map, such as a sky.
///
/// The weights are radiances, as the picture has them. The constructor multiplies each row by its solid angle, so no
/// sin θ is left to the caller, neither in the weights nor in the density. A row is selected, then a column; within a
/// pixel directions are uniform in solid angle.
///
#[cfg_attr(doc, doc = include_str!("../pictures/lat_long_map.html"))]
///
/// # Density
/// Per steradian: the probability of the pixel, as realised, over its solid angle
/// 2π(u₁ − u₀)(cos θ₀ − cos θ₁). One number in all of a pixel, at the poles too, and 0 in a pixel of weight zero.
///
/// # Domain
/// - Directions: unit vectors. Rows run from the zenith +z, θ = 0, to the nadir, with edges at equally spaced θ. Columns
///   run with the azimuth from +x towards +y, over one turn, with the edges u₀ and u₁ of
///   [`PiecewiseConstant1d`](super::PiecewiseConstant1d) on [0, 1). For another axis, as in pictures with y up, take
///   [`Oriented`](crate::warp::Oriented).
/// - Weights: row by row, finite, zero or positive, not all zero; at most [`MAX_ENTRIES`](super::MAX_ENTRIES) pixels and
///   2²⁰ columns or rows. Pictures of real skies often have negative pixels, which the filters of cameras leave: bring
///   them to 0 first, by `x.max(0.0)`.
/// - What is looked up: one colour in all of a pixel. A picture that is looked up *bilinearly* shines also in a pixel of
///   weight zero beside a bright one, where no direction is sampled, and more than half of an integral may be lost. Weigh
///   each pixel by the sum of itself and its eight neighbours then; columns go round, rows end at the poles.
/// - Uniforms: two, along a row and down the rows. A draw takes two words in this order, each one `u32` of the generator
///   for a table of `u32`, two for a table of `u64`.
/// - Storage: one word a row and one word a pixel, that of [`PiecewiseConstant2d`]. The words are the same in both tiers.
///
/// A direction keeps a distance from the borders of its pixel, 2⁻²³ turns of azimuth and 8e-7 radians of θ or less, so
/// that the pixel of the rounded direction is the one that was selected. Hence `pdf` of a sample is exactly its density,
/// and 0 at no sample, whatever the neighbours.
///
/// # Accuracy
/// Errors are against the probabilities of the table. Those differ from radiance times solid angle over the total by
/// less than 2⁻³¹ with `u32`, and by less than 2⁻⁵⁴ with `u64`; where pixels or rows are below a word of `u64`, each of
/// them takes up to one from the others. The sines of the rows are integers, right to 2⁻⁶⁰ of themselves. r is what an ulp
/// of sin θ and cos θ makes of the inverse, and m the largest probability that lies in the distance which directions keep
/// from an edge, of a column within its row or of a row.
///
/// | error | bound | kind |
/// |---|--:|---|
/// | sample, of the size | 1.6e-6 | found |
/// | unit length | 2.8e-7 | found |
/// | pdf, relative | 5.7e-7 | found |
/// | realised density, relative | 5.7e-7 | found |
/// | inverse | 3.5e-7 + 3.5*r | found |
/// | round trip | 2.4e-7 + 1.1·m + 2.4·r | found |
///
/// # Cost
/// That of two selections from a [`Cdf`](super::Cdf), of two sines with their cosines, and of a root. The density of a
/// sample costs little more; `pdf` of a given direction takes two arc tangents.
///
/// # Examples
/// Four columns and two rows; `Vec` in place of arrays takes pictures of any size.
/// ```
/// use microwarp::{Warp, poly as mw};
/// use rand_pcg::Pcg32;
/// let sky = mw::LatLongMap::new(&[[1.0, 1.0, 1.0, 9.0], [1.0, 0.0, 1.0, 1.0]])?;
/// let mut rng = Pcg32::new(42, 54);
/// let sample = sky.draw_pixel(&mut rng);
/// assert_eq!(sky.pixel(sample.direction), sample.pixel);
/// assert_eq!(sky.pdf(sample.direction), sample.pdf);
/// assert!((sky.pdf([0.5, -0.5, 0.7]) / sky.pdf([0.5, 0.5, 0.7]) - 9.0).abs() < 1e-5);
/// # Ok::<(), microwarp::Error>(())
/// ```
/// With +y up:
/// ```
/// use microwarp::{Warp, poly as mw};
/// let sky = mw::LatLongMap::new(&[[1.0, 2.0], [0.0, 0.0]])?;
/// let sky = mw::Oriented::new(sky, mw::Frame::new([0.0, 1.0, 0.0])?);
/// let (direction, density) = sky.sample_with_pdf([0.2, 0.3]);
/// assert!(direction[1] > 0.0 && density > 0.0);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`PiecewiseConstant2d`]: a picture in the plane.
/// - [`SphericalPatch`](crate::warp::SphericalPatch): one pixel.
///
/// # Source
/// M. Pharr, W. Jakob and G. Humphreys, *Physically Based Rendering*, 4th edition, 2023, section 12.5:
/// <https://pbr-book.org/4ed/Light_Sources/Infinite_Area_Lights>; with zones of equal solid angle here.
#[doc(alias = "environment_map")]
#[doc(alias = "equirectangular")]
#[doc(alias = "hdri")]
#[doc(alias = "importance_map")]
#[doc(alias = "infinite_light")]
#[doc(alias = "latitude")]
#[doc(alias = "longitude")]
#[doc(alias = "skybox")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LatLongMap<T, M, C> {
    /// Azimuth and polar angle over [0, 1). Of the rows only the selection is used.
    table: PiecewiseConstant2d<M, C>,
    /// The number of rows.
    rows: f32,
    /// The sine and the cosine of half a row's angle.
    half: [f32; 2],
    tier: PhantomData<T>,
}

/// A direction of a [`LatLongMap`], with the pixel that it was drawn from.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PixelSample {
    /// The column and the row of the pixel.
    pub pixel: [usize; 2],
    /// The direction.
    pub direction: [f32; 3],
    /// Its density per steradian.
    pub pdf: f32,
}

/// How many turns of azimuth directions keep from the borders of their pixels, 2⁻²³: twice as far as the azimuth of a
/// rounded direction has been seen to be off.
const BESIDE: f32 = 1.0 / 8_388_608.0;

/// How far they keep from an edge of q = 1 - |cos θ|: 1.6e-6 of it near a pole and half of that at the equator, again
/// more than rounding moves it.
#[inline]
fn inset(q: f32) -> f32 {
    q * (1.6e-6 - 0.8e-6 * q)
}

const UNIT: [f32; 2] = [0.0, 1.0];

/// A row as a zone about the pole it is nearer to.
#[derive(Clone, Copy)]
struct Zone {
    /// 1 - cos at the edge towards the pole.
    top: f32,
    /// How far the cosine falls.
    drop: f32,
}

/// The constructors that `const` code can call: there, code cannot be generic over the word.
macro_rules! arrays {
    ($($word:ident, $array:ident; $(#[$doc:meta])* $new:ident;)*) => {$(
        impl<T: Tier, const U: usize, const V: usize> LatLongMap<T, [$word; V], [[$word; U]; V]> {
            $(#[$doc])*
            pub const fn $new(radiances: &[[f32; U]; V]) -> Result<Self, Error> {
                match PiecewiseConstant2d::$array(radiances, [UNIT, UNIT], Zones::Sphere(V)) {
                    Ok(table) => Ok(Self {
                        table,
                        rows: V as f32,
                        half: half(V),
                        tier: PhantomData,
                    }),
                    Err(error) => Err(error.at(0)),
                }
            }
        }
    )*};
}

/// The sine and the cosine of half the angle of one of so many rows.
const fn half(rows: usize) -> [f32; 2] {
    [
        sine_of_quarters(1, rows),
        sine_of_quarters(rows.saturating_sub(1), rows),
    ]
}

arrays! {
    u32, array_u32;
    /// An array of rows of radiances, with words of 32 bits. `const`.
    ///
    /// # Errors
    /// Those of [`Cdf::new`](super::Cdf::new), where an index counts pixels row by row: [`Error::AllZero`] for a black
    /// picture, [`Error::NegativeWeight`], [`Error::NotFiniteWeight`] and [`Error::Unreachable`]. [`Error::Empty`] for more
    /// than 2²⁰ columns or rows.
    ///
    /// # Cost
    /// That of [`PiecewiseConstant2d::new`].
    ///
    /// # Examples
    /// Built by the compiler, and kept in flash:
    /// ```
    /// use microwarp::{Warp, constant, poly as mw};
    /// const SKY: mw::LatLongMap<[u32; 2], [[u32; 3]; 2]> =
    ///     constant!(mw::LatLongMap::new(&[[1.0, 0.0, 1.0], [0.0, 6.0, 0.0]]));
    /// assert_eq!(SKY.shape(), [3, 2]);
    /// ```
    new;
    u64, array_u64;
    /// An array of rows of radiances, with words of 64 bits: for radiances of very different size. `const`.
    ///
    /// # Errors
    /// Those of [`LatLongMap::new`], except [`Error::Unreachable`].
    new_u64;
}

impl<T: Tier, M, C> LatLongMap<T, M, C> {
    /// A slice of radiances, row by row, in storage of its own: see
    /// [`PiecewiseConstant2d::from_slice`]. The shape is the numbers of columns and of rows.
    ///
    /// # Errors
    /// Those of [`LatLongMap::new`]; [`Error::OutOfRange`] where the radiances are not columns times rows in number,
    /// [`Error::TooManyWeights`] also where the storage has no room for the tables.
    ///
    /// # Examples
    /// In a `Vec`, which needs feature `alloc`:
    /// ```
    /// # #[cfg(feature = "alloc")] {
    /// use microwarp::{Error, Warp, poly as mw};
    /// type Sky = mw::LatLongMap<Vec<u32>, Vec<u32>>;
    /// let sky = Sky::from_slice(&vec![1.0; 64 * 32], [64, 32])?;
    /// assert!((sky.pdf([0.0, 0.6, -0.8]) * 4.0 * core::f32::consts::PI - 1.0).abs() < 1e-6);
    /// let black = Sky::from_slice(&vec![0.0; 64 * 32], [64, 32]);
    /// assert_eq!(black, Err(Error::AllZero));
    /// # }
    /// # Ok::<(), microwarp::Error>(())
    /// ```
    pub fn from_slice(radiances: &[f32], shape: [usize; 2]) -> Result<Self, Error>
    where
        M: OwnedStorage<Item: Word>,
        C: OwnedStorage<Item = M::Item> + Grid<Item = M::Item>,
    {
        let zones = Zones::Sphere(shape[1]);
        PiecewiseConstant2d::owned(radiances, shape, [UNIT, UNIT], zones)
            .map(Self::of)
            .map_err(|error| error.at(1))
    }

    /// The environment map of a finished table.
    fn of<W>(table: PiecewiseConstant2d<M, C>) -> Self
    where
        W: Word,
        M: Storage<Item = W>,
        C: Grid<Item = W>,
    {
        let [_, rows] = table.shape();
        Self {
            table,
            rows: rows as f32,
            half: half(rows),
            tier: PhantomData,
        }
    }
}

impl<'a, T: Tier, W: Word> LatLongMap<T, &'a [W], &'a [W]> {
    /// A slice of radiances, row by row, with the tables at the beginning of borrowed memory: one word a row, and one
    /// word a pixel. The shape is the numbers of columns and of rows.
    ///
    /// # Errors
    /// Those of [`LatLongMap::new`]; [`Error::OutOfRange`] where the radiances are not columns times rows in number,
    /// [`Error::TooManyWeights`] also where the memory has no room for the tables. After [`Error::Unreachable`] the
    /// memory holds parts of tables.
    ///
    /// # Cost
    /// At most 2 KiB of stack, whatever the size of the picture; up to 8 KiB without optimisation.
    pub fn new_in(
        radiances: &[f32],
        shape: [usize; 2],
        marginal: &'a mut [W],
        conditional: &'a mut [W],
    ) -> Result<Self, Error> {
        let (ranges, zones) = ([UNIT, UNIT], Zones::Sphere(shape[1]));
        let table = PiecewiseConstant2d::<&[W], &[W]>::borrowed(
            radiances,
            shape,
            ranges,
            zones,
            marginal,
            conditional,
        );
        table.map(Self::of).map_err(|error| error.at(1))
    }
}

impl<T, W, M, C> LatLongMap<T, M, C>
where
    T: Tier,
    W: Word,
    M: Storage<Item = W>,
    C: Grid<Item = W>,
{
    /// An environment map from the words of finished tables, as [`PiecewiseConstant2d::as_words`] of [`LatLongMap::table`]
    /// gave them. All words are checked.
    ///
    /// # Errors
    /// Those of [`PiecewiseConstant2d::from_words`].
    pub fn from_words(marginal: M, conditional: C) -> Result<Self, Error> {
        PiecewiseConstant2d::from_words(marginal, conditional, UNIT, UNIT)
            .map(Self::of)
            .map_err(|error| error.at(1))
    }

    /// An environment map from the words of finished tables, in constant time: the words are not looked at. With wrong
    /// words the distribution is meaningless, but still of finite directions and densities.
    ///
    /// # Errors
    /// Those of [`PiecewiseConstant2d::from_trusted_words`].
    pub fn from_trusted_words(marginal: M, conditional: C) -> Result<Self, Error> {
        PiecewiseConstant2d::from_trusted_words(marginal, conditional, UNIT, UNIT)
            .map(Self::of)
            .map_err(|error| error.at(1))
    }

    /// The table that selects rows and columns: of radiances times solid angles, on the unit square.
    #[must_use]
    #[inline]
    pub const fn table(&self) -> &PiecewiseConstant2d<M, C> {
        &self.table
    }

    /// The numbers of columns and of rows.
    #[must_use]
    #[inline]
    pub fn shape(&self) -> [usize; 2] {
        self.table.shape()
    }

    /// The column and the row of the pixel that a direction points at.
    #[must_use]
    #[inline]
    pub fn pixel(&self, direction: [f32; 3]) -> [usize; 2] {
        let [x, y, z] = direction;
        let from_pole = T::atan2_turns(sqrt(x * x + y * y), z.abs());
        // At most the row at the equator, of which there is one or a pair.
        let [_, rows] = self.shape();
        let middle = rows.saturating_sub(1) >> 1;
        let near = (from_pole * (2.0 * self.rows)) as usize;
        let near = if near < middle { near } else { middle };
        let row = if z < 0.0 {
            rows.saturating_sub(1).saturating_sub(near)
        } else {
            near
        };
        [self.table.column(azimuth::<T>(x, y)), row]
    }

    /// A direction with the pixel it was drawn from and its density, of uniforms along a row and down the rows.
    #[must_use]
    #[inline]
    pub fn sample_pixel(&self, u: [f32; 2]) -> PixelSample {
        self.sample_at(u.canonical().each().map(W::from_uniform))
    }

    /// Draws a direction, with the pixel it was drawn from and its density.
    #[inline]
    pub fn draw_pixel<R: Rng + ?Sized>(&self, rng: &mut R) -> PixelSample {
        infallible(self.try_draw_pixel(rng))
    }

    /// Draws a direction, with the pixel it was drawn from and its density, from a generator that can fail.
    ///
    /// # Errors
    /// The generator's own error.
    #[inline]
    pub fn try_draw_pixel<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<PixelSample, R::Error> {
        Ok(self.sample_at(try_words(rng)?))
    }

    /// The row as a zone about its pole, whether that is the nadir, and its number from there. Of an odd number of rows
    /// the middle one has two halves.
    #[inline]
    fn zone(&self, row: usize, lower: bool) -> (Zone, bool) {
        let [_, rows] = self.shape();
        let opposite = rows.saturating_sub(1).saturating_sub(row);
        let south = row > opposite || (row == opposite && lower);
        let near = if south { opposite } else { row };
        // 1 - cos θ = 2 sin²(θ/2), and the sine of the zone's middle from those of its edge and of half its angle: sums
        // of positive numbers.
        let (sin, cos) = T::sincos_turns(near as f32 / (4.0 * self.rows));
        let [sin_half, cos_half] = self.half;
        let top = 2.0 * sin * sin;
        let middle = 2.0 * sin * cos * cos_half + (1.0 - top) * sin_half;
        let drop = 2.0 * middle * sin_half;
        (Zone { top, drop }, south)
    }

    /// The density in a pixel; nothing for a weight of zero.
    #[inline]
    fn density(&self, [column, row]: [usize; 2], zone: Zone) -> Option<f32> {
        let (_, down) = self.table.marginal().cdf().mass(row)?;
        let columns = self.table.conditional(row);
        let (_, along) = columns.cdf().mass(column)?;
        let (down, along) = (amount(down) * W::STEP, amount(along) * W::STEP);
        let beside = columns.cells().density(column, along);
        Some(representable(beside * down * (0.5 * FRAC_1_PI) / zone.drop))
    }

    #[inline]
    fn sample_at(&self, words: [(W, f32); 2]) -> PixelSample {
        let (pixel, direction, zone) = self.place(words);
        PixelSample {
            pixel,
            direction,
            // The words of another table may select what has no mass.
            pdf: self.density(pixel, zone).unwrap_or(f32::from_bits(1)),
        }
    }

    /// The pixel that words, and what lies below them, select; the direction, and the row as a zone.
    #[inline]
    fn place(&self, [along, (word, fraction)]: [(W, f32); 2]) -> ([usize; 2], [f32; 3], Zone) {
        let share = self.table.marginal().cdf().locate(word);
        let columns = self.table.conditional(share.index);
        let (column, turn) = columns.cell_and_place(along);
        let turn = columns.cells().inside(column, turn, BESIDE);
        let place = share.leftover(fraction);
        let (zone, south) = self.zone(share.index, place >= 0.5);
        let part = if south { share.rest(fraction) } else { place };
        let Zone { top, drop } = zone;
        let bottom = top + drop;
        let down = clamp(top + part * drop, top + inset(top), bottom - inset(bottom));
        // So that a pole keeps its azimuth.
        let down = if down > DEEP { down } else { DEEP };
        let cos = 1.0 - down;
        let mut direction = [0.0; 3];
        let sin = T::sqrt(down * (2.0 - down));
        around::<T>(sin, if south { -cos } else { cos }, turn, &mut direction);
        ([column, share.index], direction, zone)
    }
}

impl<T, W, M, C> Warp for LatLongMap<T, M, C>
where
    T: Tier,
    W: Word,
    M: Storage<Item = W>,
    C: Grid<Item = W>,
{
    type Uniforms = [f32; 2];
    type Point = [f32; 3];
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<[f32; 2]>) -> [f32; 3] {
        self.place(u.each().map(W::from_uniform)).1
    }

    #[inline]
    fn pdf(&self, direction: [f32; 3]) -> f32 {
        if !is_direction(direction) {
            return 0.0;
        }
        let [_, _, z] = direction;
        let pixel = self.pixel(direction);
        let (zone, _) = self.zone(pixel[1], z < 0.0);
        self.density(pixel, zone).unwrap_or(0.0)
    }

    #[inline]
    fn sample_words(&self, words: [u32; 2]) -> [f32; 3] {
        self.place(words.map(|word| (W::from_bits(word), 0.0))).1
    }

    #[inline]
    fn sample_canonical_with_pdf(&self, u: Canonical<[f32; 2]>) -> ([f32; 3], f32) {
        let sample = self.sample_at(u.each().map(W::from_uniform));
        (sample.direction, sample.pdf)
    }

    #[inline]
    fn try_draw<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<[f32; 3], R::Error> {
        Ok(self.place(try_words(rng)?).1)
    }

    #[inline]
    fn try_draw_with_pdf<R: TryRng + ?Sized>(
        &self,
        rng: &mut R,
    ) -> Result<([f32; 3], f32), R::Error> {
        let sample = self.try_draw_pixel(rng)?;
        Ok((sample.direction, sample.pdf))
    }
}

impl<T, W, M, C> Invert for LatLongMap<T, M, C>
where
    T: Tier,
    W: Word,
    M: Storage<Item = W>,
    C: Grid<Item = W>,
{
    #[inline]
    fn invert(&self, direction: [f32; 3]) -> [f32; 2] {
        let [x, y, z] = direction;
        let [_, row] = self.pixel(direction);
        let (Zone { top, drop }, south) = self.zone(row, z < 0.0);
        let part = clamp((one_minus_cos([x, y, z.abs()]) - top) / drop, 0.0, 1.0);
        let part = if south { 1.0 - part } else { part };
        let (start, count) = self.table.marginal().cdf().share(row);
        let count = match self.table.marginal().cdf().mass(row) {
            Some(_) => amount(count),
            None => 0.0,
        };
        [
            self.table.conditional(row).invert(azimuth::<T>(x, y)),
            into_unit((start.as_f32() + count * part) * W::STEP),
        ]
    }
}
