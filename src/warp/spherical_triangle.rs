//! The uniform distribution over the directions of a triangle, seen from a point.

use super::contract::drawn_by;
use super::direction::length;
use super::planar::{PlanarMap, planar};
use super::seen::{self, Half};
use super::{Invert, LightSample, Warp};
use crate::error::Error;
use crate::num::vector::copied;
use crate::num::{into_unit, vector};
use crate::tier::{Tier, sqrt};
use crate::uniform::Uniforms;
use core::f32::consts::PI;
use core::marker::PhantomData;

/// Uniform over the directions from a point to a triangle: an area light, sampled by its solid angle.
///
#[cfg_attr(doc, doc = include_str!("../pictures/spherical_triangle.html"))]
///
/// The second uniform divides the solid angle by an arc from the first vertex, as in Arvo's map, and the first one goes
/// along the arc. With H half of the solid angle, the side b-c across from the first vertex a is divided in the ratio
/// of sin(u₂H)·√(2(1 + ab)) to sin((1 − u₂)H)·√((1 + bc)(1 + ca)). A direction is the sum of the directions of the
/// vertices times weights, which are products and sums of positive numbers. Nothing cancels, however small, thin or
/// near the triangle, and the barycentric coordinates are the weights over the distances.
///
/// # Density
/// 1/Ω per steradian inside and 0 outside, farther than the rounding of samples: 2.4e-6·q rad from a side, and farther beyond
/// a sharp corner. A world direction is rounded to 6e-8 rad, so that it cannot tell inside from outside in a triangle a few
/// times wider than that. [`Oriented`](super::Oriented) says more. Hence:
///
/// - `pdf(w) > 0` is no hit test. Take [`density`](SphericalTriangle::density) for directions that meet the triangle, or the
///   one that comes with the sample. The density of a triangle of 1e-3 rad integrates over all directions to 1.02, that of
///   1e-6 rad (4e-13 sr) to about 80.
/// - [`locate`](SphericalTriangle::locate) gives the place on the triangle in barycentric coordinates, which keep their
///   digits at any size: trace a ray to it rather than along the direction where the triangle is narrower than about
///   1e-4 rad.
///
/// Close to the triangle the density is as constant as far away, and right; the directions lose digits with q.
///
/// # Domain
/// - Point: unit vectors in world space. The triangle is seen from both sides.
/// - Uniforms: two. The first vertex is at u₁ = 0; from the second to the third, u₂ grows.
/// - Parameters: vertices with edges and distances of at most 2⁶⁰ (1e18), not all of them below 2⁻⁶⁰, that are seen under
///   1e-18 sr or more. Seen from their edge, or of a sharp first corner, they have g of at least 2⁻²⁸. With L the distance of
///   the first vertex and E the longer edge from there, g is the determinant of the three vertices, taken from the point,
///   over L E².
/// - A point from which a side is seen under nearly half a turn, 1 + cos being below 2⁻²¹, or the solid angle is within
///   0.002 sr of 2π, counts as one on the triangle.
/// - q, the nearness, is 1 over the distance of the point from the plane triangle of three unit vectors, those to the
///   vertices. It is 1 for small triangles, 2 for an octant, and about half the size over the height close to a
///   triangle.
///
/// # Accuracy
/// *Sample* is the distance from the exact direction, *unit length* the error of the length, *place on it* that of the
/// barycentric coordinates. *Pdf*, which holds for [`density_of`](Self::density_of) as well, and *realised density* are relative,
/// *inverse* and *round trip* are absolute errors of the uniforms. [What each row means](crate::warp#stated-errors).
///
/// | error | `libm` | `poly` | kind |
/// |---|--:|--:|---|
/// | sample, of the size | 1.4e-6*q | 1.3e-6*q | found |
/// | unit length | 2e-7 | 2e-7 | found |
/// | place on it | 6.5e-7 + (3.9 + 1.9·q)·p | 6.5e-7 + (3.9 + 1.9·q)·p | found |
/// | pdf, relative | 1.1e-6 + 5.5e-7*q + 1e-14/g | 1.1e-6 + 5.5e-7*q + 1e-14/g | found |
/// | realised density, relative | 1.1e-6 + 5.5e-7*q + 1e-14/g | 1.1e-6 + 5.5e-7*q + 1e-14/g | found |
/// | pdf with the sample, relative | 1.1e-6 + 5.5e-7*q + 1e-14/g | 1.1e-6 + 5.5e-7*q + 1e-14/g | found |
/// | inverse | min(1, 5.5e-6 + 5.5e-6·q + (110 + 7.4·q)·r + 1.5e-6/h + 8e-8/g) | min(1, 5.5e-6 + 5.5e-6·q + (110 + 7.4·q)·r + 1.5e-6/h + 8e-8/g) | found |
/// | round trip | min(1, 5.5e-6 + 5.5e-6·q + (110 + 7.4·q)·r + 1.5e-6/h + 8e-8/g) | min(1, 5.5e-6 + 5.5e-6·q + (110 + 7.4·q)·r + 1.5e-6/h + 8e-8/g) | found |
///
/// These hold for every triangle accepted. p is the change of the place when each uniform and each coordinate of the
/// direction moves by 2⁻²⁴, r the change of the uniforms when each coordinate of the direction does. h is the sine of the
/// smallest height: the second uniform of a direction within rounding of the first vertex, where √u₁ h is below 2⁻²⁰, is
/// lost.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost SphericalTriangle -->174 instructions and 776 bytes of code on an M4F, 9,859 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Warp, poly as mw};
/// let (lamp, spot) = ([[-1.0, -1.0, 3.0], [1.0, -1.0, 3.0], [0.0, 1.0, 3.0]], [0.0, 0.0, 0.0]);
/// let light = mw::SphericalTriangle::new(spot, lamp)?;
/// let there = light.locate([0.3, 0.8]);
/// assert!((there.pdf * light.solid_angle() - 1.0).abs() < 1e-6);
/// assert!((there.barycentric.iter().sum::<f32>() - 1.0).abs() < 1e-6);
/// assert_eq!(there.direction, light.sample([0.3, 0.8]));
///
/// // With the distance, as a shadow ray needs it.
/// let seen = light.sample_light([0.3, 0.8]);
/// assert_eq!(seen.place, there.barycentric[1..]);
/// assert!((seen.direction[2] * seen.distance - 3.0).abs() < 1e-5);
/// assert_eq!(light.pdf([0.0, 0.0, -1.0]), 0.0);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// In a renderer, no refusal is worth ending a picture: edge-on, or on the lamp, `new` returns an error. Take `.ok()`.
/// A lamp that is refused gives no light by this technique; what else hits it counts with density 0, so with weight 1.
///
/// # See also
/// - [`SphericalRectangle`](super::SphericalRectangle): four corners.
/// - [`TriangleOn`](super::TriangleOn): uniform on the triangle itself, whatever sees it.
/// - [`Cone`](super::Cone): the directions to a sphere.
///
/// # Source
/// J. Arvo, "Stratified Sampling of Spherical Triangles", SIGGRAPH 1995, <https://doi.org/10.1145/218380.218500>, and
/// A. Van Oosterom and J. Strackee, "The Solid Angle of a Plane Triangle", 1983,
/// <https://doi.org/10.1109/TBME.1983.325207>, rearranged here.
#[doc(alias = "solid_angle")]
#[doc(alias = "area_light")]
#[doc(alias = "arvo")]
#[doc(alias = "uniform")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SphericalTriangle<T> {
    /// The directions of the vertices, and the reciprocals of their distances in a unit of length.
    corners: [[f32; 3]; 3],
    inverses: [f32; 3],
    /// The unit, as a power of two by which lengths are multiplied.
    unit: f32,
    /// The edges in that unit, from each vertex to the next but the last, which leads from the first; and the sign of the
    /// volume.
    edges: [[f32; 3]; 3],
    sign: f32,
    map: Half,
    /// Half the solid angle, in turns.
    half: f32,
    density: f32,
    tier: PhantomData<T>,
}

/// A place on a triangle: its direction, its barycentric coordinates, and the density of the direction.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct OnTriangle {
    /// The direction from the point, a unit vector.
    pub direction: [f32; 3],
    /// The barycentric coordinates of the place, in the order of the vertices: at least 0, with the sum 1.
    pub barycentric: [f32; 3],
    /// The density of the direction, per steradian.
    pub pdf: f32,
}

impl<T: Tier> SphericalTriangle<T> {
    /// The directions from `point` to the triangle with these vertices, from either side.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::TooLarge`] for distances beyond about 2⁶⁰, [`Error::Empty`] for
    /// coincident vertices and for a triangle that is too small, too thin or seen too much from its edge,
    /// [`Error::NotNormalizable`] for a point on the triangle. The section on the domain says where these begin.
    #[allow(clippy::inline_always, reason = "what is not used is not computed")]
    #[inline(always)]
    pub fn new(point: [f32; 3], vertices: [[f32; 3]; 3]) -> Result<Self, Error> {
        let [a, b, c] = vertices;
        let [mut p, mut q, mut r] = vertices.map(|vertex| vector::minus(vertex, point));
        // The edge across is no difference of the others: it may be far shorter.
        let [mut x, mut across, mut y] =
            [(b, a), (c, b), (c, a)].map(|(to, from)| vector::minus(to, from));
        let mut unit = 1.0;
        let size = vector::span(p) + vector::span(x) + vector::span(y);
        if !seen::is_plain(size) {
            unit = seen::unit(size, [point, a, b, c].map(copied), 1)?;
            [p, q, r, x, across, y] = [p, q, r, x, across, y].map(|way| vector::times(way, unit));
        }
        let [la, lb, lc] = [p, q, r].map(|way| sqrt(vector::dot(way, way)));
        let (ia, ib, ic) = (1.0 / la, 1.0 / lb, 1.0 / lc);
        let (a, b, c) = (
            vector::times(p, ia),
            vector::times(q, ib),
            vector::times(r, ic),
        );
        let cosines = [vector::dot(a, b), vector::dot(b, c), vector::dot(c, a)];
        let [sum, rise, near] = seen::sums(a, b, c, cosines);
        let normal = vector::cross(x, y);
        let spread = vector::span(normal);
        let mut volume = vector::dot(a, normal);
        // Edge-on, and in slivers, few digits are left. They do not count in front of the light, but for close to a corner.
        let nearest = seen::least(lb, lc);
        let even = la < seen::UNEVEN * nearest;
        let sharp = seen::SHARP * spread <= vector::span(x) * vector::span(y);
        let edge_on = seen::EDGE_ON * volume.abs() <= spread;
        if sharp || (edge_on && !(sum < 0.0 && even)) {
            volume = ia * seen::triangle_volume(copied(point), vertices.map(copied), unit);
        }
        let sign = if volume < 0.0 { -1.0 } else { 1.0 };
        let volume = volume.abs() * ib * ic;
        let (nearest, size) = (seen::least(la, nearest), unit * size);
        if !seen::is_seen(volume, sum, nearest, size) {
            return Err(seen::refusal(sum, nearest, size, 1));
        }
        let half = T::atan2_turns(volume, sum);
        Ok(Self {
            corners: [a, b, c],
            inverses: [ia, ib, ic],
            unit,
            edges: [x, across, y],
            sign,
            map: Half {
                volume,
                sum,
                rise,
                near,
            },
            half,
            density: 1.0 / (4.0 * PI) / half,
            tier: PhantomData,
        })
    }

    /// The density of every direction from `point` to the triangle, per steradian, as `new` and [`density`](Self::density) give it
    /// but for rounding: for a direction that another technique has found, at a point where no sample is drawn. What only a sample
    /// needs is left out.
    ///
    /// # Errors
    /// Those of [`new`](Self::new).
    ///
    /// # Examples
    /// ```
    /// use microwarp::poly as mw;
    /// let (eye, lamp) = ([0.0; 3], [[-1.0, 0.0, 3.0], [1.0, 0.0, 3.0], [0.0, 1.0, 3.0]]);
    /// let seen = mw::SphericalTriangle::new(eye, lamp)?;
    /// let alone = mw::SphericalTriangle::density_of(eye, lamp)?;
    /// assert!((alone / seen.density() - 1.0).abs() < 1e-6);
    /// # Ok::<(), microwarp::Error>(())
    /// ```
    #[inline]
    pub fn density_of(point: [f32; 3], vertices: [[f32; 3]; 3]) -> Result<f32, Error> {
        let [a, b, c] = vertices;
        let ways @ [way, ..] = vertices.map(|vertex| vector::minus(vertex, point));
        let (x, y) = (vector::minus(b, a), vector::minus(c, a));
        let lengths @ [first, second, third] = ways.map(length);
        let [sum, rise] = seen::long_sum(ways, lengths);
        let normal = vector::cross(x, y);
        let (volume, spread) = (vector::dot(way, normal).abs(), vector::span(normal));
        let size = vector::span(way) + vector::span(x) + vector::span(y);
        let nearest = seen::least(first, seen::least(second, third));
        let blunt = seen::SHARP * spread > vector::span(x) * vector::span(y);
        let ahead = seen::EDGE_ON * volume > spread * first;
        let half = [volume, sum, first * second * third];
        if rise >= 0.0 && blunt && ahead && seen::is_simple(half, nearest, size) {
            Ok(1.0 / (4.0 * PI) / T::atan2_turns(volume, sum))
        } else {
            Self::density_made(copied(point), vertices.map(copied))
        }
    }

    /// The same by all that a sample needs, where few digits are left.
    #[cold]
    #[inline(never)]
    fn density_made(point: [f32; 3], vertices: [[f32; 3]; 3]) -> Result<f32, Error> {
        Self::new(point, vertices).map(|light| light.density)
    }

    /// The solid angle of the triangle, in steradians.
    #[must_use]
    pub const fn solid_angle(&self) -> f32 {
        4.0 * PI * self.half
    }

    /// The density of every direction that meets the triangle, per steradian: for one that another technique has found, as
    /// multiple importance sampling needs it. `pdf` tells such directions from others, which takes longer.
    #[must_use]
    #[inline]
    pub const fn density(&self) -> f32 {
        self.density
    }

    /// The weights that a bilinear density on the unit square takes in order to follow the cosine to `normal`, of any
    /// length: `weights[row][column]`, where u₂ is 0 and 1 in the rows and u₁ is 0 and 1 in the columns.
    ///
    /// They are the cosines of the vertices, 0 below the horizon; the first vertex is both corners of the first column.
    ///
    /// # Errors
    /// [`Error::AllZero`] for a triangle below the horizon, [`Error::NotFinite`] for a normal with NaN
    /// or infinity, [`Error::ZeroLength`] for a zero normal.
    pub fn cosine_weights(&self, normal: [f32; 3]) -> Result<[[f32; 2]; 2], Error> {
        let [a, b, c] = seen::cosines(self.corners, normal)?;
        if a > 0.0 || b > 0.0 || c > 0.0 {
            Ok([[a, b], [a, c]])
        } else {
            Err(Error::AllZero)
        }
    }

    /// The direction, the place on the triangle and the density of two uniforms. They are brought into range as
    /// [`Warp::sample`] does.
    #[must_use]
    #[inline]
    pub fn locate(&self, u: [f32; 2]) -> OnTriangle {
        let [u1, u2] = u.canonical().get();
        let weights = self.weights(u1, u2);
        let (barycentric, _) = self.place(weights);
        OnTriangle {
            direction: seen::direction(self.corners, weights),
            barycentric,
            pdf: self.density,
        }
    }

    drawn_by! {
        /// Draws a direction to the triangle with its distance: [`sample_light`](Self::sample_light) of a generator.
        draw_light, try_draw_light, sample_light -> LightSample
    }

    drawn_by! {
        /// Draws a place on the triangle: [`locate`](Self::locate) of a generator.
        draw_place, try_draw_place, locate -> OnTriangle
    }

    /// The same with the distance, as all lamps give it.
    ///
    /// The distance is that of the place on the triangle to 4e-7 of the reach, the distance of the first vertex and the lengths
    /// of the edges from there, and direction times distance leads to the place to 4.8e-7 of it.
    #[must_use]
    #[inline]
    pub fn sample_light(&self, u: [f32; 2]) -> LightSample {
        let [u1, u2] = u.canonical().get();
        let weights = self.weights(u1, u2);
        let ([_, second, third], sum) = self.place(weights);
        let (direction, length) = seen::direction_and_length(self.corners, weights);
        LightSample {
            direction,
            distance: length / (sum * self.unit),
            pdf: self.density,
            place: [second, third],
        }
    }

    /// The barycentric coordinates, and the sum of the weights over the distances of their vertices.
    #[inline]
    fn place(&self, [p, q, r]: [f32; 3]) -> ([f32; 3], f32) {
        let [i, j, k] = self.inverses;
        let (p, q, r) = (p * i, q * j, r * k);
        let sum = p + q + r;
        ([p / sum, q / sum, r / sum], sum)
    }

    #[inline]
    fn weights(&self, u1: f32, u2: f32) -> [f32; 3] {
        let (cos, sin) = T::polar(1.0, u2 * self.half);
        self.map.weights(u1, sin, cos, 1.0)
    }

    /// The edge from each vertex to the next.
    #[inline]
    fn sides(&self) -> [[f32; 3]; 3] {
        let [x, across, y] = self.edges;
        [x, across, vector::times(y, -1.0)]
    }
}

impl<T: Tier> PlanarMap<3> for SphericalTriangle<T> {
    #[inline]
    fn map_to(&self, u1: f32, u2: f32, to: &mut [f32; 3]) {
        *to = seen::direction(self.corners, self.weights(u1, u2));
    }

    #[inline]
    fn put(&self, u1: f32, u2: f32, to: &mut [f32; 3]) -> f32 {
        self.map_to(u1, u2, to);
        self.density
    }
}

impl<T: Tier> Warp for SphericalTriangle<T> {
    planar!(3, with its density, where T::VECTORS);

    #[inline]
    fn pdf(&self, direction: [f32; 3]) -> f32 {
        let wide = seen::is_wide(self.map.volume, self.half);
        let ([x, _, y], sides) = (self.edges, self.sides());
        if seen::holds(direction, self.corners, sides, [x, y], self.sign, wide) {
            self.density
        } else {
            0.0
        }
    }
}

impl<T: Tier> Invert for SphericalTriangle<T> {
    #[inline]
    fn invert(&self, direction: [f32; 3]) -> [f32; 2] {
        let (corners, inverses, sign) = (self.corners, self.inverses, self.sign);
        let ([a, b, c], [i, j, k], [x, y, z]) = (corners, inverses, self.sides());
        let direction = seen::carried_back(direction, corners, inverses, self.sides(), sign);
        // In units of all three distances.
        let over = |corners, inverses, edge| {
            let (corner, inverse) = seen::end(direction, corners, inverses);
            sign * seen::height(direction, corner, edge) / inverse
        };
        let weights = [
            over([b, c], [j, k], y) / i,
            over([a, c], [i, k], z) / j,
            over([a, b], [i, j], x) / k,
        ];
        let [out, angle] = self.map.uniforms::<T>(weights);
        [out, angle / self.half].map(into_unit)
    }
}
