//! What direct lighting asks of a lamp.

/// A place on a lamp that is seen from a point: in which direction, how far away, with which density, and where on the lamp.
///
/// [`VisibleSphere`](super::VisibleSphere::sample_light), [`SphericalRectangle`](super::SphericalRectangle::sample_light) and
/// [`SphericalTriangle`](super::SphericalTriangle::sample_light) give it, so that a renderer has one way for all of its lamps.
///
/// The distance is that of the place itself. A distance by the plane, n·c/(n·w), loses its digits where the lamp is seen from
/// its edge. Both are rounded, and so is the ray: end a shadow ray a little before the lamp.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LightSample {
    /// The direction from the point to the place, a unit vector in world coordinates.
    pub direction: [f32; 3],
    /// The distance to the place in that direction.
    pub distance: f32,
    /// The density of the direction, per steradian.
    pub pdf: f32,
    /// The coordinates [s, t] of the place, corner + s ex + t ey of a rectangle. Of a triangle they are the barycentric
    /// coordinates of the second and the third vertex, which is the same by the edges from the first. Both are from 0 to 1. A
    /// sphere has none: [0, 0].
    pub place: [f32; 2],
}
