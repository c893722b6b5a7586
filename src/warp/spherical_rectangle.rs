//! The uniform distribution over the directions of a rectangle, seen from a point.

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

/// Uniform over the directions from a point to a rectangle, or any parallelogram: an area light, sampled by its solid
/// angle.
///
#[cfg_attr(doc, doc = include_str!("../pictures/spherical_rectangle.html"))]
///
/// Two spherical triangles about the corner, on both sides of the diagonal, each with the map of
/// [`SphericalTriangle`](super::SphericalTriangle): u₂ sweeps the solid angle from the first edge to the second, and the
/// map has no seam at the diagonal.
///
/// # Density
/// 1/Ω per steradian inside and 0 outside, farther than the rounding of samples, 2.4e-6·q rad. What
/// [`SphericalTriangle`](super::SphericalTriangle#density) says of small triangles, of close points and of `pdf(w) > 0` holds here,
/// too.
///
/// # Domain
/// - Point: unit vectors in world space. The rectangle is seen from both sides.
/// - Uniforms: two. The corner is at u₁ = 0; from the first edge to the second, u₂ grows.
/// - Parameters: those of [`SphericalTriangle`](super::SphericalTriangle#domain) for both halves, g being taken with the two
///   edges and q the larger nearness of the two. The edges are taken as they are given, so that a small one
///   keeps its digits far from 0.
///
/// # Accuracy
/// *Sample* is the distance from the exact direction, *unit length* the error of the length, *place on it* that of the
/// coordinates along the edges. *Pdf*, which holds for [`density_of`](Self::density_of) as well, and *realised density* are
/// relative, *inverse* and *round trip* are absolute errors of the uniforms. [What each row means](crate::warp#stated-errors).
///
/// | error | bound | kind |
/// |---|--:|---|
/// | sample, of the size | 9.7e-7*q | found |
/// | unit length | 2e-7 | found |
/// | place on it | 7.8e-7 + (2.6 + 0.79·q)·p | found |
/// | pdf, relative | 9.6e-7 + 4.8e-7*q + 7.6e-15/g | found |
/// | realised density, relative | 9.6e-7 + 4.8e-7*q + 7.6e-15/g | found |
/// | pdf with the sample, relative | 9.6e-7 + 4.8e-7*q + 7.6e-15/g | found |
/// | inverse | min(1, 2.5e-6 + 2.5e-6·q + (54 + 2·q)·r + 8e-7/h + 8e-8/g) | found |
/// | round trip | min(1, 2.5e-6 + 2.5e-6·q + (54 + 2·q)·r + 8e-7/h + 8e-8/g) | found |
///
/// These hold for every rectangle accepted. p is the change of the place when each uniform and each coordinate of the
/// direction moves by 2⁻²⁴, r the change of the uniforms when each coordinate of the direction does. h is the sine of the
/// smallest height of both halves: the second uniform of a direction within rounding of the corner, where √u₁ h is below
/// 2⁻²⁰, is lost.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost SphericalRectangle -->214 instructions and 956 bytes of code on an M4F, 10,500 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Warp, poly as mw};
/// let spot = [0.0, 0.0, 0.0];
/// let panel = mw::SphericalRectangle::new(spot, [-1.0, -0.5, 3.0], [[2.0, 0.0, 0.0], [0.0, 1.0, 0.0]])?;
/// let there = panel.locate([0.3, 0.8]);
/// assert!((there.pdf * panel.solid_angle() - 1.0).abs() < 1e-6);
/// let [s, t] = there.st;
/// assert!(s > 0.0 && s < 1.0 && t > 0.0 && t < 1.0);
/// assert_eq!(there.direction, panel.sample([0.3, 0.8]));
///
/// // With the distance, as a shadow ray needs it.
/// let seen = panel.sample_light([0.3, 0.8]);
/// assert_eq!(seen.place, there.st);
/// assert!((seen.direction[2] * seen.distance - 3.0).abs() < 1e-5);
/// assert_eq!(panel.pdf([0.0, 0.0, -1.0]), 0.0);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// In a renderer, no refusal is worth ending a picture: edge-on, or on the lamp, `new` returns an error. Take `.ok()`.
/// A lamp that is refused gives no light by this technique; what else hits it counts with density 0, so with weight 1.
///
/// # See also
/// - [`SphericalTriangle`](super::SphericalTriangle): three corners, and a fan of them for any polygon.
/// - [`Aabb`](super::Aabb): uniform on the rectangle itself, whatever sees it.
/// - [`SphericalPatch`](super::SphericalPatch): between two latitudes and two longitudes.
///
/// # Source
/// C. Ureña, M. Fajardo and A. King, "An Area-Preserving Parametrization for Spherical Rectangles", 2013,
/// <https://doi.org/10.1111/cgf.12151>, for the problem; the map is that of
/// [`SphericalTriangle`](super::SphericalTriangle#source).
#[doc(alias = "solid_angle")]
#[doc(alias = "area_light")]
#[doc(alias = "quad")]
#[doc(alias = "parallelogram")]
#[doc(alias = "uniform")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SphericalRectangle<T> {
    /// The directions of the corner, the ends of the first edge, of the diagonal and of the second edge, and the reciprocals
    /// of their distances in a unit of length.
    corners: [[f32; 3]; 4],
    inverses: [f32; 4],
    /// The unit, as a power of two by which lengths are multiplied.
    unit: f32,
    /// The edges in that unit, and the sign of the volume.
    edges: [[f32; 3]; 2],
    sign: f32,
    /// The triangle of the first edge and the diagonal, and that of the second edge and the diagonal, both from their edge.
    halves: [Half; 2],
    /// The sine and the cosine of half the solid angle times a number, and the square of that.
    sine: f32,
    cosine: f32,
    square: f32,
    /// Half the solid angle, in turns.
    half: f32,
    density: f32,
    tier: PhantomData<T>,
}

/// A place on a rectangle: its direction, its coordinates along the edges, and the density of the direction.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct OnRectangle {
    /// The direction from the point, a unit vector.
    pub direction: [f32; 3],
    /// The coordinates [s, t] of the place corner + s ex + t ey, from 0 to 1.
    pub st: [f32; 2],
    /// The density of the direction, per steradian.
    pub pdf: f32,
}

/// The square of the distance of the nearest corner beside that of the first one, below which the rounding of the way to that
/// one shows.
const FAR_NEARER: f32 = 0.0625;

impl<T: Tier> SphericalRectangle<T> {
    /// The directions from `point` to the rectangle of `corner` and two edges, from either side. The edges need not be
    /// at right angles.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::TooLarge`] for distances and edges beyond about 2⁶⁰,
    /// [`Error::ZeroLength`] for an edge of length 0, [`Error::Empty`] for a rectangle that is too small, too thin or seen
    /// too much from its edge, [`Error::NotNormalizable`] for a point on the rectangle. The section on the domain says where
    /// these begin.
    #[allow(clippy::inline_always, reason = "what is not used is not computed")]
    #[inline(always)]
    pub fn new(point: [f32; 3], corner: [f32; 3], edges: [[f32; 3]; 2]) -> Result<Self, Error> {
        let [mut x, mut y] = edges;
        let mut p = vector::minus(corner, point);
        let mut unit = 1.0;
        let size = vector::span(p) + vector::span(x) + vector::span(y);
        if !seen::is_plain(size) {
            unit = seen::rectangle_unit(size, copied(point), copied(corner), [x, y])?;
            [p, x, y] = [p, x, y].map(|way| vector::times(way, unit));
        }
        let (mut q, mut r, mut s) = (
            vector::plus(p, x),
            vector::plus(p, vector::plus(x, y)),
            vector::plus(p, y),
        );
        let (p2, mut q2, mut r2, mut s2) = (
            vector::dot(p, p),
            vector::dot(q, q),
            vector::dot(r, r),
            vector::dot(s, s),
        );
        if seen::least(q2, seen::least(r2, s2)) < FAR_NEARER * p2 {
            [q, r, s] = seen::other_corners(copied(point), copied(corner), [x, y], unit);
            [q2, r2, s2] = [q, r, s].map(|way| vector::dot(way, way));
        }
        let (lp, lq, lr, ls) = (sqrt(p2), sqrt(q2), sqrt(r2), sqrt(s2));
        let (ip, iq, ir, is) = (1.0 / lp, 1.0 / lq, 1.0 / lr, 1.0 / ls);
        let (a, b, c, d) = (
            vector::times(p, ip),
            vector::times(q, iq),
            vector::times(r, ir),
            vector::times(s, is),
        );
        let diagonal = vector::dot(a, c);
        let [sum0, rise0, near0] =
            seen::sums(a, b, c, [vector::dot(a, b), vector::dot(b, c), diagonal]);
        let [sum1, rise1, near1] =
            seen::sums(a, d, c, [vector::dot(a, d), vector::dot(d, c), diagonal]);
        let normal = vector::cross(x, y);
        let spread = vector::span(normal);
        let mut volume = vector::dot(a, normal);
        // Edge-on, and between edges of about one direction, few digits are left. They do not count in front of the light,
        // but for close to a corner.
        let nearest = seen::least(lq, seen::least(lr, ls));
        let even = lp < seen::UNEVEN * nearest;
        let before = seen::least(sum0, sum1) < 0.0;
        let sharp = seen::SHARP * spread <= vector::span(x) * vector::span(y);
        let edge_on = seen::EDGE_ON * volume.abs() <= spread;
        if sharp || (edge_on && !(before && even)) {
            volume = ip * seen::rectangle_volume(copied(point), copied(corner), [x, y], unit);
        }
        let sign = if volume < 0.0 { -1.0 } else { 1.0 };
        let part = volume.abs() * ir;
        let (volume0, volume1) = (part * iq, part * is);
        // The product of both halves as complex numbers.
        let (sine, cosine) = (
            volume0 * sum1 + volume1 * sum0,
            sum0 * sum1 - volume0 * volume1,
        );
        let (nearest, size) = (seen::least(lp, nearest), unit * size);
        if !seen::is_seen(sine, cosine, nearest, size) {
            return Err(if edges.contains(&[0.0; 3]) {
                Error::ZeroLength(2)
            } else {
                seen::refusal(cosine, nearest, size, Error::NO_PLACE)
            });
        }
        let half = T::atan2_turns(sine, cosine);
        Ok(Self {
            corners: [a, b, c, d],
            inverses: [ip, iq, ir, is],
            unit,
            edges: [x, y],
            sign,
            halves: [
                Half {
                    volume: volume0,
                    sum: sum0,
                    rise: rise0,
                    near: near0,
                },
                Half {
                    volume: volume1,
                    sum: sum1,
                    rise: rise1,
                    near: near1,
                },
            ],
            sine,
            cosine,
            square: sine * sine + cosine * cosine,
            half,
            density: 1.0 / (4.0 * PI) / half,
            tier: PhantomData,
        })
    }

    /// The density of every direction from `point` to the rectangle, per steradian, as `new` and [`density`](Self::density) give it
    /// but for rounding: for a direction that another technique has found, at a point where no sample is drawn. What only a sample
    /// needs is left out.
    ///
    /// # Errors
    /// Those of [`new`](Self::new).
    ///
    /// # Examples
    /// ```
    /// use microwarp::poly as mw;
    /// let (eye, corner, edges) = ([0.0; 3], [-1.0, -0.5, 3.0], [[2.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
    /// let seen = mw::SphericalRectangle::new(eye, corner, edges)?;
    /// let alone = mw::SphericalRectangle::density_of(eye, corner, edges)?;
    /// assert!((alone / seen.density() - 1.0).abs() < 1e-6);
    /// # Ok::<(), microwarp::Error>(())
    /// ```
    #[inline]
    pub fn density_of(
        point: [f32; 3],
        corner: [f32; 3],
        edges: [[f32; 3]; 2],
    ) -> Result<f32, Error> {
        let [x, y] = edges;
        let p = vector::minus(corner, point);
        let (q, r, s) = (
            vector::plus(p, x),
            vector::plus(p, vector::plus(x, y)),
            vector::plus(p, y),
        );
        let [lp, lq, lr, ls] = [p, q, r, s].map(length);
        let [sum0, rise0] = seen::long_sum([p, q, r], [lp, lq, lr]);
        let [sum1, rise1] = seen::long_sum([p, s, r], [lp, ls, lr]);
        let normal = vector::cross(x, y);
        let (volume, spread) = (vector::dot(p, normal).abs(), vector::span(normal));
        // The product of both halves as complex numbers.
        let (sine, cosine) = (volume * (sum0 + sum1), sum0 * sum1 - volume * volume);
        let size = vector::span(p) + vector::span(x) + vector::span(y);
        let others = seen::least(lq, seen::least(lr, ls));
        let nearest = seen::least(lp, others);
        let blunt = seen::SHARP * spread > vector::span(x) * vector::span(y);
        let ahead = seen::EDGE_ON * volume > spread * lp;
        let plain = seen::least(rise0, rise1) >= 0.0 && others * others >= FAR_NEARER * (lp * lp);
        let half = [sine, cosine, (lp * lq * lr) * (lp * ls * lr)];
        if plain && blunt && ahead && seen::is_simple(half, nearest, size) {
            Ok(1.0 / (4.0 * PI) / T::atan2_turns(sine, cosine))
        } else {
            Self::density_made(copied(point), copied(corner), edges.map(copied))
        }
    }

    /// The same by all that a sample needs, where few digits are left.
    #[cold]
    #[inline(never)]
    fn density_made(point: [f32; 3], corner: [f32; 3], edges: [[f32; 3]; 2]) -> Result<f32, Error> {
        Self::new(point, corner, edges).map(|light| light.density)
    }

    /// The solid angle of the rectangle, in steradians.
    #[must_use]
    pub const fn solid_angle(&self) -> f32 {
        4.0 * PI * self.half
    }

    /// The density of every direction that meets the rectangle, per steradian: for one that another technique has found, as
    /// multiple importance sampling needs it. `pdf` tells such directions from others, which takes longer.
    #[must_use]
    #[inline]
    pub const fn density(&self) -> f32 {
        self.density
    }

    /// The weights that a bilinear density on the unit square takes in order to follow the cosine to `normal`, of any
    /// length: `weights[row][column]`, where u₂ is 0 and 1 in the rows and u₁ is 0 and 1 in the columns.
    ///
    /// They are the cosines of corner, corner + ex, corner and corner + ey, 0 below the horizon. Where only the fourth
    /// corner is above it, its cosine stands for both corners of the second column, between which it lies.
    ///
    /// # Errors
    /// [`Error::AllZero`] for a rectangle below the horizon, [`Error::NotFinite`] for a normal with NaN
    /// or infinity, [`Error::ZeroLength`] for a zero normal.
    pub fn cosine_weights(&self, normal: [f32; 3]) -> Result<[[f32; 2]; 2], Error> {
        let [corner, x, far, y] = seen::cosines(self.corners, normal)?;
        if corner > 0.0 || x > 0.0 || y > 0.0 {
            Ok([[corner, x], [corner, y]])
        } else if far > 0.0 {
            Ok([[0.0, far], [0.0, far]])
        } else {
            Err(Error::AllZero)
        }
    }

    /// The direction, the place on the rectangle and the density of two uniforms. They are brought into range as
    /// [`Warp::sample`] does.
    #[must_use]
    #[inline]
    pub fn locate(&self, u: [f32; 2]) -> OnRectangle {
        let [u1, u2] = u.canonical().get();
        let (in_second, weights, corners) = self.weights(u1, u2);
        let (st, _) = self.place(in_second, weights);
        OnRectangle {
            direction: seen::direction(corners, weights),
            st,
            pdf: self.density,
        }
    }

    /// The same with the distance, as all lamps give it.
    ///
    /// The distance is that of the place on the rectangle to 4e-7 of the reach, |corner − point| + |ex| + |ey|, and direction
    /// times distance leads to the place to 4.8e-7 of it.
    #[must_use]
    #[inline]
    pub fn sample_light(&self, u: [f32; 2]) -> LightSample {
        let [u1, u2] = u.canonical().get();
        let (in_second, weights, corners) = self.weights(u1, u2);
        let (place, sum) = self.place(in_second, weights);
        let (direction, length) = seen::direction_and_length(corners, weights);
        LightSample {
            direction,
            distance: length / (sum * self.unit),
            pdf: self.density,
            place,
        }
    }

    /// The coordinates along the edges, and the sum of the weights over the distances of their corners.
    #[inline]
    fn place(&self, in_second: bool, [p, q, r]: [f32; 3]) -> ([f32; 2], f32) {
        let [ip, iq, ir, is] = self.inverses;
        let (p, q, r) = (p * ip, q * if in_second { is } else { iq }, r * ir);
        let sum = p + q + r;
        let (along, beside) = ((q + r) / sum, r / sum);
        let place = if in_second {
            [beside, along]
        } else {
            [along, beside]
        };
        (place, sum)
    }

    drawn_by! {
        /// Draws a direction to the rectangle with its distance: [`sample_light`](Self::sample_light) of a generator.
        draw_light, try_draw_light, sample_light -> LightSample
    }

    drawn_by! {
        /// Draws a place on the rectangle: [`locate`](Self::locate) of a generator.
        draw_place, try_draw_place, locate -> OnRectangle
    }

    /// Whether two uniforms lead to the half of the second edge; the weights there, and the corners of the half.
    #[inline]
    fn weights(&self, u1: f32, u2: f32) -> (bool, [f32; 3], [[f32; 3]; 3]) {
        let ([first, second], [a, b, c, d]) = (self.halves, self.corners);
        // From the nearer edge, where the half beside it may be a small part of the whole.
        let from_second = u2 > 0.5;
        let (near, turn) = if from_second {
            (second, 1.0 - u2)
        } else {
            (first, u2)
        };
        let (cos, sin) = T::polar(1.0, turn * self.half);
        let beyond = near.volume * cos < near.sum * sin;
        // From the other edge: the rest of half the solid angle.
        let (sine, cosine) = (self.sine, self.cosine);
        let (sin, cos, square) = if beyond {
            (
                sine * cos - cosine * sin,
                cosine * cos + sine * sin,
                self.square,
            )
        } else {
            (sin, cos, 1.0)
        };
        let in_second = from_second != beyond;
        let (half, side) = if in_second { (second, d) } else { (first, b) };
        (in_second, half.weights(u1, sin, cos, square), [a, side, c])
    }

    /// The edge from each corner to the next.
    #[inline]
    fn sides(&self) -> [[f32; 3]; 4] {
        let [x, y] = self.edges;
        [x, y, vector::times(x, -1.0), vector::times(y, -1.0)]
    }
}

impl<T: Tier> PlanarMap<3> for SphericalRectangle<T> {
    #[inline]
    fn map_to(&self, u1: f32, u2: f32, to: &mut [f32; 3]) {
        let (_, weights, corners) = self.weights(u1, u2);
        *to = seen::direction(corners, weights);
    }

    #[inline]
    fn put(&self, u1: f32, u2: f32, to: &mut [f32; 3]) -> f32 {
        self.map_to(u1, u2, to);
        self.density
    }
}

impl<T: Tier> Warp for SphericalRectangle<T> {
    planar!(3, with its density, where T::VECTORS);

    #[inline]
    fn pdf(&self, direction: [f32; 3]) -> f32 {
        let wide = seen::is_wide(self.sine, self.half);
        let sides = self.sides();
        if seen::holds(direction, self.corners, sides, self.edges, self.sign, wide) {
            self.density
        } else {
            0.0
        }
    }
}

impl<T: Tier> Invert for SphericalRectangle<T> {
    #[inline]
    fn invert(&self, direction: [f32; 3]) -> [f32; 2] {
        let ([a, b, c, d], [x, y]) = (self.corners, self.edges);
        let ([ip, iq, ir, is], [first, second]) = (self.inverses, &self.halves);
        let (sides, sign) = (self.sides(), self.sign);
        let direction = seen::carried_back(direction, self.corners, self.inverses, sides, sign);
        let over = |corners, inverses, edge| {
            let (corner, inverse) = seen::end(direction, corners, inverses);
            let height = sign * seen::height(direction, corner, edge) / inverse;
            if height > 0.0 { height } else { 0.0 }
        };
        // The coordinates along the edges and what they lack of 1, times a number.
        let [_, _, back_x, back_y] = sides;
        let (t, s) = (over([a, b], [ip, iq], x), over([a, d], [ip, is], back_y));
        let rest_s = over([b, c], [iq, ir], y);
        let rest_t = over([d, c], [is, ir], back_x);
        // From the corner at which they have the smaller error.
        let from_first = seen::off(direction, a) * ir * ir < seen::off(direction, c) * ip * ip;
        let apart = if from_first { s - t } else { rest_t - rest_s };
        if apart > 0.0 {
            let [out, angle] = first.uniforms::<T>([rest_s / ip, apart / iq, t / ir]);
            [out, angle / self.half].map(into_unit)
        } else {
            let [out, angle] = second.uniforms::<T>([rest_t / ip, -apart / is, s / ir]);
            [out, 1.0 - angle / self.half].map(into_unit)
        }
    }
}
