//! Tables that are warps: cells of an interval, of a rectangle and of the sphere, and the triangles of a mesh. Their words
//! lie in memory of the caller, their handles have what is computed from the bounds.

use crate::error::{Code, code};
use crate::generators::{Pcg32, Source};
use crate::value::Value;
use crate::warps::*;
use core_crate::discrete::{
    Cdf, Mesh, PiecewiseConstant1d, PiecewiseConstant2d, PiecewiseLinear1d, PixelSample,
};
use core_crate::{Error, Invert, Warp, poly};

type Words = &'static [u32];
type Cells = PiecewiseConstant1d<Words>;
type Curve = PiecewiseLinear1d<Words, &'static [f32]>;
type Picture = PiecewiseConstant2d<Words, Words>;
type Sky = poly::LatLongMap<Words, Words>;
type LongMesh = Mesh<'static, u32, Words>;
type ShortMesh = Mesh<'static, u16, Words>;

bound! { "" "piecewise_constant_1d" Cells {} }
bound! { "" "piecewise_linear_1d" Curve {} }
bound! { "" "piecewise_constant_2d" Picture {} }
bound! { "" "lat_long_map" Sky {} }
bound! { "" "mesh" LongMesh {} }
bound! { "" "mesh_u16" ShortMesh {} }

makers! {
    "piecewise_constant_1d_build" Cells,
    (weights: *const f32, entries: usize, low: f32, high: f32, words: *mut u32) {
        Cells::new_in(given(weights, entries), low, high, memory(words, entries))
    }
    "piecewise_constant_1d_init" Cells, (words: *const u32, entries: usize, low: f32, high: f32) {
        Cells::from_cdf(Cdf::from_words(given(words, entries))?, low, high)
    }
    "piecewise_constant_1d_init_trusted" Cells,
    (words: *const u32, entries: usize, low: f32, high: f32) {
        Cells::from_cdf(Cdf::from_trusted_words(given(words, entries))?, low, high)
    }

    "piecewise_linear_1d_build" Curve,
    (weights: *const f32, entries: usize, low: f32, high: f32, words: *mut u32) {
        Curve::new_in(given(weights, entries), low, high, memory(words, entries))
    }
    "piecewise_linear_1d_init" Curve,
    (words: *const u32, weights: *const f32, entries: usize, low: f32, high: f32) {
        Curve::from_cdf(
            Cdf::from_words(given(words, entries))?, given(weights, entries), low, high,
        )
    }

    "piecewise_constant_2d_build" Picture,
    (
        weights: *const f32, columns: usize, rows: usize, u: *const [f32; 2], v: *const [f32; 2],
        marginal: *mut u32, conditional: *mut u32
    ) {
        let (cells, [u, v]) = (product(columns, rows)?, [*u, *v]);
        let (marginal, conditional) = (memory(marginal, rows), memory(conditional, cells));
        Picture::new_in(given(weights, cells), [columns, rows], u, v, marginal, conditional)
    }
    "piecewise_constant_2d_init" Picture,
    (
        marginal: *const u32, conditional: *const u32, columns: usize, rows: usize,
        u: *const [f32; 2], v: *const [f32; 2]
    ) {
        let (cells, [u, v]) = (product(columns, rows)?, [*u, *v]);
        Picture::from_words(given(marginal, rows), given(conditional, cells), u, v)
    }
    "piecewise_constant_2d_init_trusted" Picture,
    (
        marginal: *const u32, conditional: *const u32, columns: usize, rows: usize,
        u: *const [f32; 2], v: *const [f32; 2]
    ) {
        let (cells, [u, v]) = (product(columns, rows)?, [*u, *v]);
        Picture::from_trusted_words(given(marginal, rows), given(conditional, cells), u, v)
    }

    "lat_long_map_build" Sky,
    (
        radiances: *const f32, columns: usize, rows: usize, marginal: *mut u32,
        conditional: *mut u32
    ) {
        let cells = product(columns, rows)?;
        let (marginal, conditional) = (memory(marginal, rows), memory(conditional, cells));
        Sky::new_in(given(radiances, cells), [columns, rows], marginal, conditional)
    }
    "lat_long_map_init" Sky,
    (marginal: *const u32, conditional: *const u32, columns: usize, rows: usize) {
        let cells = product(columns, rows)?;
        Sky::from_words(given(marginal, rows), given(conditional, cells))
    }
    "lat_long_map_init_trusted" Sky,
    (marginal: *const u32, conditional: *const u32, columns: usize, rows: usize) {
        let cells = product(columns, rows)?;
        Sky::from_trusted_words(given(marginal, rows), given(conditional, cells))
    }
}

macro_rules! meshes {
    ($($build:literal $init:literal $trusted:literal $mesh:ty, $index:ty;)*) => {$(
        makers! {
            $build $mesh,
            (
                vertices: *const [f32; 3], vertex_count: usize, faces: *const [$index; 3],
                face_count: usize, areas: *mut f32, words: *mut u32
            ) {
                let (vertices, faces) = (given(vertices, vertex_count), given(faces, face_count));
                <$mesh>::new_in(vertices, faces, memory(areas, face_count), memory(words, face_count))
            }
            $init $mesh,
            (
                vertices: *const [f32; 3], vertex_count: usize, faces: *const [$index; 3],
                face_count: usize, areas: *mut f32, words: *const u32
            ) {
                let (vertices, faces) = (given(vertices, vertex_count), given(faces, face_count));
                let table = Cdf::from_words(given(words, face_count))?;
                <$mesh>::from_table(vertices, faces, memory(areas, face_count), table)
            }
            $trusted $mesh,
            (
                vertices: *const [f32; 3], vertex_count: usize, faces: *const [$index; 3],
                face_count: usize, areas: *const f32, words: *const u32
            ) {
                let (vertices, faces) = (given(vertices, vertex_count), given(faces, face_count));
                let table = Cdf::from_trusted_words(given(words, face_count))?;
                <$mesh>::from_trusted_parts(vertices, faces, given(areas, face_count), table)
            }
        }
    )*};
}

meshes! {
    "mesh_build" "mesh_init" "mesh_init_trusted" LongMesh, u32;
    "mesh_u16_build" "mesh_u16_init" "mesh_u16_init_trusted" ShortMesh, u16;
}

fn product(columns: usize, rows: usize) -> Result<usize, Error> {
    columns.checked_mul(rows).ok_or(Error::TooManyWeights)
}

/// `mw_pixel_sample`
#[repr(C)]
struct Pixel {
    pixel: [usize; 2],
    direction: [f32; 3],
    pdf: f32,
}

impl From<PixelSample> for Pixel {
    fn from(sample: PixelSample) -> Self {
        Self {
            pixel: sample.pixel,
            direction: sample.direction,
            pdf: sample.pdf,
        }
    }
}

#[unsafe(export_name = "mw_lat_long_map_sample_pixel")]
unsafe extern "C" fn sample_pixel(warp: &Sky, u: *const [f32; 2]) -> Pixel {
    // SAFETY: the promise of the header.
    warp.sample_pixel(unsafe { u.read() }).into()
}

#[unsafe(export_name = "mw_lat_long_map_draw_pixel")]
extern "C" fn draw_pixel(warp: &Sky, rng: &mut Pcg32) -> Pixel {
    warp.draw_pixel(rng).into()
}

#[unsafe(export_name = "mw_lat_long_map_draw_pixel_from")]
unsafe extern "C" fn draw_pixel_from(warp: &Sky, source: &Source, drawn: *mut Pixel) -> Code {
    // SAFETY: the promise of the header.
    code(warp.try_draw_pixel(&mut { *source }), |pixel| unsafe {
        drawn.write(pixel.into())
    })
}
