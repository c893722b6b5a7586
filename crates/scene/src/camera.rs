//! The camera: a thin lens behind an aperture of straight blades.

use crate::kit::Kit;
use crate::shape::Ray;
use crate::source::Source;
use crate::vector::{Vector, minus, plus, scaled, unit};
use microwarp::warp::{Frame, RegularPolygon};
use microwarp::{Error, Warp};

#[derive(Clone, Copy, Debug)]
pub struct Camera {
    pub eye: Vector,
    pub target: Vector,
    /// Half of the width of the picture at a distance of 1.
    pub spread: f32,
    /// The radius of the lens; 0 for a pinhole.
    pub lens: f32,
    pub blades: u16,
    /// The distance that is sharp.
    pub focus: f32,
}

/// The dimensions of a path that the camera takes: two of the pixel, two of the lens.
pub const DIMENSIONS: u32 = 4;

/// A camera with the samplers of a kit, for pictures of one size.
pub struct View<K: Kit> {
    camera: Camera,
    across: Vector,
    up: Vector,
    ahead: Vector,
    /// The size of a pixel at a distance of 1, and half the numbers of pixels.
    pixel: f32,
    half: [f32; 2],
    filter: K::Filter,
    aperture: RegularPolygon<K::Tier>,
}

impl<K: Kit> View<K> {
    /// A picture of so many columns and rows.
    ///
    /// # Errors
    /// [`Error::ZeroLength`] for a camera that looks straight up, straight down or at itself, [`Error::Empty`] for a picture
    /// without pixels, [`Error::OutOfRange`] for fewer than three blades.
    pub fn new(camera: Camera, [width, height]: [u32; 2]) -> Result<Self, Error> {
        if width == 0 || height == 0 {
            return Err(Error::Empty(1));
        }
        let ahead = unit(minus(camera.target, camera.eye));
        let [x, y, _] = ahead;
        // The library's frame has tangents of its own choice; a picture has its up.
        let across = Frame::new([y, -x, 0.0])?.normal();
        let (width, height) = (width as f32, height as f32);
        Ok(Self {
            camera,
            across,
            up: crate::vector::cross(across, ahead),
            ahead,
            pixel: 2.0 * camera.spread / width,
            half: [0.5 * width, 0.5 * height],
            filter: K::filter(1.0)?,
            aperture: RegularPolygon::new(camera.blades)?,
        })
    }

    /// A ray of a pixel, counted from the left and from the top.
    pub fn ray(&self, [column, row]: [u32; 2], source: &mut impl Source) -> Ray {
        source.skip_to(0);
        let [across, down] = [column, row].map(|i| i as f32 + 0.5 + self.filter.draw(source));
        let [x, y] = self.aperture.draw(source).map(|c| c * self.camera.lens);
        let [half_width, half_height] = self.half;
        let place = |right: f32, up: f32, ahead: f32| {
            let flat = plus(scaled(self.across, right), scaled(self.up, up));
            plus(flat, scaled(self.ahead, ahead))
        };
        let size = self.pixel * self.camera.focus;
        let sharp = place(
            (across - half_width) * size,
            (half_height - down) * size,
            self.camera.focus,
        );
        let lens = place(x, y, 0.0);
        Ray {
            origin: plus(self.camera.eye, lens),
            direction: unit(minus(sharp, lens)),
        }
    }
}
