//! A triangle mesh: a point on a face that is chosen by its area, or by weights of the caller.

use super::cdf::Cdf;
use super::selection::amount;
use super::storage::Storage;
use super::weights::check_number;
use super::word::Word;
use crate::error::Error;
use crate::num::{into_unit, representable, two_sum};
use crate::uniform::{Canonical, grid_from_word};
use crate::warp::triangle_on::{Spanned, anchored, combined};
use crate::warp::{Invert, Triangle, Warp};
use rand_core::TryRng;

/// Uniform on the faces of a triangle mesh, or on each face with a weight of its own: an emitter of any shape.
///
/// A face is selected from a [`Cdf`] of areas; what the selection leaves of the first uniform and the second one place a
/// point on it. Vertices, faces, areas and the table are slices of the caller.
///
#[cfg_attr(doc, doc = include_str!("../pictures/mesh.html"))]
///
/// # Density
/// The probability of the face over its area, per unit area: 1/area of the mesh, as far as the words of the table hold
/// the areas. It is the density with which points are drawn, and [`Cdf`] says how far it is from uniform: 2⁻³² over the
/// probability of the face in a table of `u32`.
///
/// # Domain
/// - Point: a [`MeshPoint`]. Density and inverse read its triangle and its barycentric coordinates, not the position.
/// - Uniforms: two. The first one selects the face, in the order of the faces, so that few bits of it may be left for the
///   place: 24 + log₂ p of an `f32` and 32 + log₂ p of a drawn word, for a face of probability p. A table of `u64` draws
///   two words for it and leaves 64 + log₂ p bits: take it from some hundred faces on.
/// - Parameters: up to [`MAX_ENTRIES`](super::MAX_ENTRIES) faces of indices in `u8`, `u16` or `u32`, and an area of all
///   from 2⁻¹²⁶ to 2¹²⁶. A face counts as one without area, and is never selected, where its height over its longest side
///   is below 2⁻⁴⁰ of that side or its area below 2⁻¹²⁶.
/// - Both tiers share this code.
///
/// # Accuracy
/// *Sample* is the distance of the barycentric coordinates from the exact ones, *place on it* that of the position relative
/// to the size, the largest magnitude of a coordinate of the face. *Pdf* and *realised density* are relative to the
/// probability of the table over the exact area. *Inverse* and *round trip* are absolute errors of the uniforms. [What
/// each row means](crate::warp#stated-errors).
///
/// | error | bound | kind |
/// |---|--:|---|
/// | sample, of the size | 2.1e-7 | found |
/// | place on it | 5.5e-7 | found |
/// | pdf, relative | 4.2e-7 | found |
/// | realised density, relative | 4.2e-7 | found |
/// | inverse | 2.3e-7 | found |
/// | round trip | 3.3e-7 | found |
///
/// Areas and densities hold for every triangle accepted, however thin. The second uniform of a point on the first vertex
/// of its face is lost.
///
/// # Cost
/// That of a selection from a [`Cdf`] and of [`TriangleOn`](crate::warp::TriangleOn). Building takes some thousand
/// operations a face for exact areas.
///
/// # Examples
/// ```
/// use microwarp::{Warp, discrete::Mesh};
/// // A pyramid without its base.
/// let vertices = [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]];
/// let faces: [[u16; 3]; 4] = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1]];
/// let (mut areas, mut words) = ([0.0; 4], [0_u32; 4]);
/// let roof = Mesh::new_in(&vertices, &faces, &mut areas, &mut words)?;
/// assert!((roof.area() - 12_f32.sqrt()).abs() < 1e-6);
/// let there = roof.sample([0.6, 0.5]);
/// assert_eq!(there.triangle, 2);
/// let [x, y, z] = there.position;
/// assert!((z - x - y - 1.0).abs() < 1e-6);
/// assert!((roof.pdf(there) * roof.area() - 1.0).abs() < 1e-6);
/// assert!(roof.normal(2).is_some_and(|[x, y, z]| x < 0.0 && y < 0.0 && z > 0.0));
/// # Ok::<(), microwarp::Error>(())
/// ```
/// Some faces brighter than others, by area times radiance:
/// ```
/// use microwarp::{Warp, discrete::{Cdf, Mesh}};
/// let vertices = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
/// let faces = [[0_u32, 1, 2], [0, 2, 3]];
/// let mut areas = [0.0; 2];
/// let areas = Mesh::areas(&vertices, &faces, &mut areas)?;
/// let table = Cdf::new(&[3.0 * areas[0], 1.0 * areas[1]])?;
/// let mut memory = [0.0; 2];
/// let lamp = Mesh::from_table(&vertices, &faces, &mut memory, table)?;
/// assert_eq!([lamp.density(0), lamp.density(1)], [1.5, 0.5]);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`TriangleOn`](crate::warp::TriangleOn): one triangle.
/// - [`SphericalTriangle`](crate::warp::SphericalTriangle): one that is seen from a point, by solid angle.
///
/// # Source
/// G. Turk, "Generating Random Points in Triangles", Graphics Gems, 1990.
#[doc(alias = "area_light")]
#[doc(alias = "emitter")]
#[doc(alias = "surface")]
#[doc(alias = "triangles")]
#[doc(alias = "polygon")]
#[doc(alias = "uniform")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Mesh<'a, I, S> {
    vertices: &'a [[f32; 3]],
    faces: &'a [[I; 3]],
    areas: &'a [f32],
    table: Cdf<S>,
}

/// A point of a [`Mesh`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MeshPoint {
    /// The point in space.
    pub position: [f32; 3],
    /// The shares of the three vertices of the triangle, in their order.
    pub barycentrics: [f32; 3],
    /// The index of the triangle among the faces.
    pub triangle: usize,
}

/// The vertices of a face; nothing where it names one that there is not.
#[inline]
fn corners<I: Copy + Into<u32>>(vertices: &[[f32; 3]], face: [I; 3]) -> Option<[[f32; 3]; 3]> {
    let [a, b, c] = face.map(|index| vertices.get(index.into() as usize).copied());
    Some([a?, b?, c?])
}

/// The area of a triangle, 0 where it counts as none. Where its vertices or its area are not finite, neither is this.
fn area(vertices: [[f32; 3]; 3]) -> f32 {
    if !vertices.as_flattened().iter().all(|x| x.is_finite()) {
        return f32::INFINITY;
    }
    match Spanned::of(vertices) {
        // Powers of two scale exactly, as far as the result is normal.
        Some(Spanned { length, unit, .. }) => match 0.5 * length * unit * unit {
            area if area >= f32::MIN_POSITIVE => area,
            _ => 0.0,
        },
        None => 0.0,
    }
}

impl<'a, I: Copy + Into<u32>> Mesh<'a, I, &'a [u32]> {
    /// The area of each face, at the beginning of borrowed memory: 0 for one that counts as without area.
    ///
    /// # Errors
    /// [`Error::NoWeights`] without faces, [`Error::TooManyWeights`] for more than
    /// [`MAX_ENTRIES`](super::MAX_ENTRIES) or than the memory has room for, [`Error::OutOfRange`] for an index beyond the
    /// vertices, [`Error::NotFiniteWeight`] with the index of a face that has a vertex of NaN or infinity, or an area that
    /// overflows.
    pub fn areas<'m>(
        vertices: &[[f32; 3]],
        faces: &[[I; 3]],
        memory: &'m mut [f32],
    ) -> Result<&'m mut [f32], Error> {
        check_number(faces.len())?;
        let areas = memory.get_mut(..faces.len()).ok_or(Error::TooManyWeights)?;
        for (index, (&face, to)) in faces.iter().zip(areas.iter_mut()).enumerate() {
            *to = area(corners(vertices, face).ok_or(Error::OutOfRange(1))?);
            if !to.is_finite() {
                return Err(Error::NotFiniteWeight(index));
            }
        }
        Ok(areas)
    }
}

impl<'a, I: Copy + Into<u32>, W: Word> Mesh<'a, I, &'a [W]> {
    /// Uniform by area, with the areas and the table in borrowed memory: a number and a word a face.
    ///
    /// # Errors
    /// Those of [`Mesh::areas`] and of [`Cdf::new_in`]: [`Error::AllZero`] where no face has an area,
    /// [`Error::Unreachable`] for a table of `u32` that cannot hold all of very many tiny faces. [`Error::TooLarge`] where
    /// the area of all is above 2¹²⁶.
    pub fn new_in(
        vertices: &'a [[f32; 3]],
        faces: &'a [[I; 3]],
        areas: &'a mut [f32],
        words: &'a mut [W],
    ) -> Result<Self, Error> {
        let areas = Mesh::areas(vertices, faces, areas)?;
        let table = Cdf::new_in(areas, words)?;
        Self::of(vertices, faces, areas, table)
    }
}

impl<'a, I: Copy + Into<u32>, W: Word, S: Storage<Item = W>> Mesh<'a, I, S> {
    /// A mesh whose faces are selected from a table of the caller, of areas times radiances or any other weights.
    ///
    /// # Errors
    /// Those of [`Mesh::areas`]. [`Error::OutOfRange`] where the table has not as many entries as there are faces,
    /// [`Error::Empty`] where it selects one without area, [`Error::AllZero`] and [`Error::TooLarge`] as
    /// [`Mesh::new_in`].
    pub fn from_table(
        vertices: &'a [[f32; 3]],
        faces: &'a [[I; 3]],
        areas: &'a mut [f32],
        table: Cdf<S>,
    ) -> Result<Self, Error> {
        Self::of(vertices, faces, Mesh::areas(vertices, faces, areas)?, table)
    }

    fn of(
        vertices: &'a [[f32; 3]],
        faces: &'a [[I; 3]],
        areas: &'a [f32],
        table: Cdf<S>,
    ) -> Result<Self, Error> {
        let mesh = Self::from_trusted_parts(vertices, faces, areas, table)?;
        let mut with_index = areas.iter().enumerate();
        if with_index.any(|(index, area)| *area == 0.0 && mesh.table.mass(index).is_some()) {
            return Err(if areas.iter().all(|area| *area == 0.0) {
                Error::AllZero
            } else {
                Error::Empty(3)
            });
        }
        if 1.0 / mesh.area() >= f32::MIN_POSITIVE {
            Ok(mesh)
        } else {
            Err(Error::TooLarge(1))
        }
    }

    /// A mesh of finished parts, such as constants in flash, in constant time: nothing is looked at but how many there are.
    ///
    /// The areas must be those that [`Mesh::areas`] gives, and no face without area may be selected. With any other parts
    /// points and densities are meaningless, but finite where the vertices are, and nothing panics.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] where faces, areas and entries of the table are not as many.
    pub fn from_trusted_parts(
        vertices: &'a [[f32; 3]],
        faces: &'a [[I; 3]],
        areas: &'a [f32],
        table: Cdf<S>,
    ) -> Result<Self, Error> {
        if table.entries() != faces.len() || areas.len() != faces.len() {
            return Err(Error::OutOfRange(if areas.len() == faces.len() {
                3
            } else {
                2
            }));
        }
        Ok(Self {
            vertices,
            faces,
            areas,
            table,
        })
    }

    /// The vertices.
    #[must_use]
    #[inline]
    pub const fn vertices(&self) -> &'a [[f32; 3]] {
        self.vertices
    }

    /// The indices of the vertices of each face.
    #[must_use]
    #[inline]
    pub const fn faces(&self) -> &'a [[I; 3]] {
        self.faces
    }

    /// The table that selects a face.
    #[must_use]
    #[inline]
    pub const fn table(&self) -> &Cdf<S> {
        &self.table
    }

    /// The area of all faces, in a pass over them.
    #[must_use]
    pub fn area(&self) -> f32 {
        let (mut area, mut rest) = (0.0, 0.0);
        for &more in self.areas {
            let (sum, dropped) = two_sum(area, more);
            (area, rest) = (sum, rest + dropped);
        }
        if area.is_finite() { area + rest } else { area }
    }

    /// The probability with which a face is selected; 0 beyond the last.
    #[must_use]
    #[inline]
    pub fn probability(&self, triangle: usize) -> f32 {
        self.table.pmf(triangle)
    }

    /// The density on a face, per unit area: what a ray needs that has met it. 0 beyond the last.
    #[must_use]
    #[inline]
    pub fn density(&self, triangle: usize) -> f32 {
        match (self.table.mass(triangle), self.areas.get(triangle)) {
            (Some((_, count)), Some(area)) => representable(amount(count) * W::STEP / area),
            _ => 0.0,
        }
    }

    /// The unit normal of a face, towards whom its vertices run counterclockwise; nothing for one without area.
    #[must_use]
    pub fn normal(&self, triangle: usize) -> Option<[f32; 3]> {
        let face = self.faces.get(triangle)?;
        let Spanned { cross, length, .. } = Spanned::of(corners(self.vertices, *face)?)?;
        Some(cross.map(|x| x / length))
    }

    /// The point of a word and what lies below it, and of the second uniform.
    #[inline]
    fn place(&self, (word, fraction): (W, f32), second: f32) -> MeshPoint {
        let share = self.table.locate(word);
        let barycentrics = Triangle::new().sample([share.leftover(fraction), second]);
        let face = self.faces.get(share.index);
        let vertices = face.and_then(|face| corners(self.vertices, *face));
        let (anchor, offsets, _) = anchored(vertices.unwrap_or_default());
        MeshPoint {
            position: combined(anchor, offsets, barycentrics),
            barycentrics,
            triangle: share.index,
        }
    }
}

impl<I: Copy + Into<u32>, W: Word, S: Storage<Item = W>> Warp for Mesh<'_, I, S> {
    type Uniforms = [f32; 2];
    type Point = MeshPoint;
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<[f32; 2]>) -> MeshPoint {
        let [first, second] = u.each();
        self.place(W::from_uniform(first), second.get())
    }

    #[inline]
    fn pdf(&self, point: MeshPoint) -> f32 {
        if Triangle::new().pdf(point.barycentrics) > 0.0 {
            self.density(point.triangle)
        } else {
            0.0
        }
    }

    #[inline]
    fn sample_words(&self, [first, second]: [u32; 2]) -> MeshPoint {
        self.place((W::from_bits(first), 0.0), grid_from_word(second))
    }

    #[inline]
    fn try_draw<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<MeshPoint, R::Error> {
        let first = W::try_draw(rng)?;
        let second = grid_from_word(rng.try_next_u32()?);
        Ok(self.place((first, 0.0), second))
    }
}

impl<I: Copy + Into<u32>, W: Word, S: Storage<Item = W>> Invert for Mesh<'_, I, S> {
    #[inline]
    fn invert(&self, point: MeshPoint) -> [f32; 2] {
        let [part, second] = Triangle::new().invert(point.barycentrics);
        let first = match self.table.mass(point.triangle) {
            Some((start, count)) => (start.as_f32() + amount(count) * part) * W::STEP,
            None => 0.0,
        };
        [into_unit(first), second]
    }
}
