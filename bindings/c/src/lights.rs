//! What a renderer asks of lamps and of a rough surface beside what is a warp: distances, masking and reflections.

use crate::error::{Code, code};
use crate::generators::{Pcg32, Source, forget_registers};
use crate::value::Value;
use core_crate::poly::{Ggx, GgxVisible, SphericalRectangle, SphericalTriangle, VisibleSphere};
use core_crate::warp;

type Direction = [f32; 3];

/// `mw_light_sample`
#[repr(C)]
struct LightSample {
    direction: Direction,
    distance: f32,
    pdf: f32,
    place: [f32; 2],
}

impl From<warp::LightSample> for LightSample {
    #[inline]
    fn from(seen: warp::LightSample) -> Self {
        Self {
            direction: seen.direction,
            distance: seen.distance,
            pdf: seen.pdf,
            place: seen.place,
        }
    }
}

/// `mw_reflection`
#[repr(C)]
struct Reflection {
    normal: Direction,
    direction: Direction,
    pdf: f32,
}

impl From<warp::Reflection> for Reflection {
    #[inline]
    fn from(bounce: warp::Reflection) -> Self {
        Self {
            normal: bounce.normal,
            direction: bounce.direction,
            pdf: bounce.pdf,
        }
    }
}

/// A method of two uniforms, and the same of a generator and of a source.
macro_rules! of_two_uniforms {
    ($($of:ty, $out:ty: $sample:ident $by_uniforms:literal, $draw:ident $try_draw:ident $by_words:literal;)*) => {$(
        const _: () = {
            #[unsafe(export_name = $by_uniforms)]
            unsafe extern "C" fn sample(of: &$of, u: *const [f32; 2], to: *mut $out) {
                // SAFETY: the promise of the header.
                unsafe { to.write(of.$sample(Value::read(u)).into()) }
            }

            #[unsafe(export_name = $by_words)]
            unsafe extern "C" fn draw(of: &$of, rng: &mut Pcg32, to: *mut $out) {
                forget_registers();
                // SAFETY: the promise of the header.
                unsafe { to.write(of.$draw(rng).into()) }
            }

            #[unsafe(export_name = concat!($by_words, "_from"))]
            unsafe extern "C" fn draw_from(of: &$of, source: &Source, to: *mut $out) -> Code {
                forget_registers();
                // SAFETY: the promise of the header.
                code(of.$try_draw(&mut { *source }), |drawn| unsafe { to.write(drawn.into()) })
            }
        };
    )*};
}

of_two_uniforms! {
    VisibleSphere, LightSample:
        sample_light "mw_visible_sphere_sample_light",
        draw_light try_draw_light "mw_visible_sphere_draw_light";
    SphericalRectangle, LightSample:
        sample_light "mw_spherical_rectangle_sample_light",
        draw_light try_draw_light "mw_spherical_rectangle_draw_light";
    SphericalTriangle, LightSample:
        sample_light "mw_spherical_triangle_sample_light",
        draw_light try_draw_light "mw_spherical_triangle_draw_light";
    GgxVisible, Reflection:
        reflect "mw_ggx_visible_reflect",
        draw_reflection try_draw_reflection "mw_ggx_visible_draw_reflection";
}

#[unsafe(export_name = "mw_visible_sphere_density")]
extern "C" fn of_sphere(lamp: &VisibleSphere) -> f32 {
    lamp.density()
}

#[unsafe(export_name = "mw_spherical_rectangle_density")]
extern "C" fn of_rectangle(lamp: &SphericalRectangle) -> f32 {
    lamp.density()
}

#[unsafe(export_name = "mw_spherical_triangle_density")]
extern "C" fn of_triangle(lamp: &SphericalTriangle) -> f32 {
    lamp.density()
}

#[unsafe(export_name = "mw_ggx_distribution")]
unsafe extern "C" fn distribution(surface: &Ggx, normal: *const Direction) -> f32 {
    // SAFETY: the promise of the header.
    surface.distribution(unsafe { Value::read(normal) })
}

#[unsafe(export_name = "mw_ggx_g1")]
unsafe extern "C" fn masked(surface: &Ggx, direction: *const Direction) -> f32 {
    // SAFETY: the promise of the header.
    surface.g1(unsafe { Value::read(direction) })
}

#[unsafe(export_name = "mw_ggx_visible_g1")]
extern "C" fn masking(gloss: &GgxVisible) -> f32 {
    gloss.g1()
}

#[unsafe(export_name = "mw_ggx_visible_unmasked")]
unsafe extern "C" fn unmasked(gloss: &GgxVisible, direction: *const Direction) -> f32 {
    // SAFETY: the promise of the header.
    gloss.unmasked(unsafe { Value::read(direction) })
}

#[unsafe(export_name = "mw_ggx_visible_visibility")]
unsafe extern "C" fn visibility(gloss: &GgxVisible, direction: *const Direction) -> f32 {
    // SAFETY: the promise of the header.
    gloss.visibility(unsafe { Value::read(direction) })
}

#[unsafe(export_name = "mw_ggx_visible_reflected_pdf")]
unsafe extern "C" fn reflected_pdf(gloss: &GgxVisible, normal: *const Direction) -> f32 {
    // SAFETY: the promise of the header.
    gloss.reflected_pdf(unsafe { Value::read(normal) })
}
