//! The drawing surface: anti-aliased lines, shapes and shading on pixels, saved as PNG.
//!
//! What is drawn where is not said here.

use super::colour::{ACCENT, Colour, HAIR, INK, WHITE};
use super::text::{Align, Fonts, Type};
use base64::Engine;
use color_quant::NeuQuant;
use std::path::Path;
use tiny_skia::{
    Color, FillRule, LineCap, LineJoin, Paint, PathBuilder, Pixmap, Rect, Stroke, Transform,
};

/// Colours with a place of their own in a file's palette: the page must be white to the last bit, a colour
/// used sparingly must not drift, and none may bend those of a picture that come near it.
const FIXED: [Colour; 4] = [WHITE, INK, HAIR, ACCENT];

/// A rectangle of the surface, in pixels, y downwards.
#[derive(Clone, Copy, Debug)]
pub struct Area {
    pub x: f32,
    pub y: f32,
    pub w: f32,
    pub h: f32,
}

impl Area {
    pub fn new(x: f32, y: f32, w: f32, h: f32) -> Self {
        Self { x, y, w, h }
    }

    /// What is left after margins of the given widths.
    pub fn inside(self, left: f32, top: f32, right: f32, bottom: f32) -> Self {
        Self::new(
            self.x + left,
            self.y + top,
            self.w - left - right,
            self.h - top - bottom,
        )
    }

    /// How much of it lies on another one.
    pub fn overlap(self, other: Self) -> f32 {
        let side =
            |from: f32, to: f32, start: f32, end: f32| (to.min(end) - from.max(start)).max(0.0);
        side(self.x, self.x + self.w, other.x, other.x + other.w)
            * side(self.y, self.y + self.h, other.y, other.y + other.h)
    }

    /// The largest square in the middle.
    pub fn square(self) -> Self {
        let side = self.w.min(self.h);
        Self::new(
            self.x + 0.5 * (self.w - side),
            self.y + 0.5 * (self.h - side),
            side,
            side,
        )
    }
}

pub struct Canvas {
    pixels: Pixmap,
    fonts: Fonts,
}

impl Canvas {
    pub fn new(width: u32, height: u32) -> Self {
        let mut pixels = Pixmap::new(width, height).expect("a picture has a size");
        pixels.fill(Color::WHITE);
        Self {
            pixels,
            fonts: Fonts::default(),
        }
    }

    pub fn rectangle(&mut self, area: Area, colour: Colour) {
        if let Some(rect) = Rect::from_xywh(area.x, area.y, area.w, area.h) {
            self.pixels
                .fill_rect(rect, &paint(colour), Transform::identity(), None);
        }
    }

    pub fn disc(&mut self, centre: [f32; 2], radius: f32, colour: Colour) {
        if let Some(path) = PathBuilder::from_circle(centre[0], centre[1], radius) {
            self.fill(&path, colour);
        }
    }

    /// Red, green and blue of a pixel.
    pub fn pixel(&self, x: u32, y: u32) -> [u8; 3] {
        let first = 4 * (y * self.pixels.width() + x) as usize;
        std::array::from_fn(|k| self.pixels.data()[first + k])
    }

    /// A line through points; `None` lifts the pen.
    pub fn line(
        &mut self,
        points: impl IntoIterator<Item = Option<[f32; 2]>>,
        width: f32,
        colour: Colour,
    ) {
        let (mut path, mut down) = (PathBuilder::new(), false);
        for point in points {
            match point {
                Some([x, y]) if down => path.line_to(x, y),
                Some([x, y]) => path.move_to(x, y),
                None => {}
            }
            down = point.is_some();
        }
        if let Some(path) = path.finish() {
            self.stroke(&path, width, colour);
        }
    }

    pub fn segment(&mut self, from: [f32; 2], to: [f32; 2], width: f32, colour: Colour) {
        self.line([Some(from), Some(to)], width, colour);
    }

    /// Colours every pixel of an area as `colour` says for its position, averaged over four places in
    /// the pixel so that edges are smooth; `None` leaves what is there.
    pub fn shade(&mut self, area: Area, colour: impl Fn(f32, f32) -> Option<[f64; 3]>) {
        let width = self.pixels.width();
        let (x0, y0) = (area.x.floor() as u32, area.y.floor() as u32);
        let (x1, y1) = (
            (area.x + area.w).ceil() as u32,
            (area.y + area.h).ceil() as u32,
        );
        for y in y0..y1.min(self.pixels.height()) {
            for x in x0..x1.min(width) {
                let (mut sum, mut hits) = ([0.0; 3], 0.0);
                for (dx, dy) in [(0.25, 0.25), (0.75, 0.25), (0.25, 0.75), (0.75, 0.75)] {
                    if let Some(c) = colour(x as f32 + dx, y as f32 + dy) {
                        hits += 0.25;
                        (0..3).for_each(|k| sum[k] += 0.25 * c[k]);
                    }
                }
                if hits > 0.0 {
                    let pixel = &mut self.pixels.data_mut()[4 * (y * width + x) as usize..][..3];
                    for (byte, sum) in pixel.iter_mut().zip(sum) {
                        *byte = (sum + (1.0 - hits) * f64::from(*byte)).round() as u8;
                    }
                }
            }
        }
    }

    /// Writes a text at its anchor on the base line, smaller where it would be wider than `fit`.
    pub fn text(&mut self, text: &str, anchor: [f32; 2], align: Align, style: Type, fit: f32) {
        let natural = self.fonts.width(text, style);
        let style = Type {
            size: style.size * (fit / natural).min(1.0),
            ..style
        };
        if let Some(path) = self.fonts.outline(text, anchor, align, style) {
            self.fill(&path, style.colour);
        }
    }

    pub fn width(&self, text: &str, style: Type) -> f32 {
        self.fonts.width(text, style)
    }

    /// Saves as PNG in the 256 colours that fit best: a third of the size of one in full colour.
    pub fn save(&self, path: &Path) -> Result<(), String> {
        let bytes = self.png(png::BitDepth::Eight).map_err(|e| e.to_string());
        let written = bytes.and_then(|b| std::fs::write(path, b).map_err(|e| e.to_string()));
        written.map_err(|e| format!("{}: {e}", path.display()))
    }

    /// Saves as PNG in all colours: for photographs, whose shades are more than a palette holds.
    pub fn save_in_full_colour(&self, path: &Path) -> Result<(), String> {
        let rgb: Vec<u8> = self
            .pixels
            .data()
            .chunks_exact(4)
            .flat_map(|pixel| &pixel[..3])
            .copied()
            .collect();
        save_rgb(path, [self.pixels.width(), self.pixels.height()], &rgb)
    }

    /// The picture as an address that holds it, in 16 colours, for a page that can have no files beside it.
    pub fn data_address(&self) -> Result<String, String> {
        let bytes = self.png(png::BitDepth::Four).map_err(|e| e.to_string())?;
        let text = base64::engine::general_purpose::STANDARD.encode(bytes);
        Ok(format!("data:image/png;base64,{text}"))
    }

    /// In as many colours as have a number of these bits, 4 or 8.
    fn png(&self, depth: png::BitDepth) -> Result<Vec<u8>, png::EncodingError> {
        let bits = depth as usize;
        let colours = 1 << bits;
        let rgba = self.pixels.data();
        let others: Vec<u8> = rgba
            .chunks_exact(4)
            .filter(|pixel| !FIXED.iter().any(|colour| colour == pixel))
            .flatten()
            .copied()
            .collect();
        let fitted = NeuQuant::new(3, colours - FIXED.len(), &others);
        let mut palette: Vec<u8> = FIXED.iter().flat_map(|c| &c[..3]).copied().collect();
        palette.extend(fitted.color_map_rgb());
        let find = |pixel: &[u8]| {
            let fixed = FIXED.iter().position(|colour| colour == pixel);
            fixed.unwrap_or_else(|| FIXED.len() + fitted.index_of(pixel)) as u8
        };
        // Neighbouring pixels are mostly equal, and finding a colour takes time.
        let (mut last, mut index) = (WHITE, find(&WHITE));
        let indices: Vec<u8> = rgba
            .chunks_exact(4)
            .map(|pixel| {
                if pixel != last {
                    last.copy_from_slice(pixel);
                    index = find(pixel);
                }
                index
            })
            .collect();
        // As many as fit into a byte, the first on top; a row begins with a byte.
        let join = |together: &[u8]| {
            let places = (0..8 / bits).rev().map(|place| place * bits);
            places
                .zip(together)
                .map(|(place, index)| index << place)
                .sum()
        };
        let rows = indices.chunks_exact(self.pixels.width() as usize);
        let packed: Vec<u8> = rows
            .flat_map(|row| row.chunks(8 / bits).map(join))
            .collect();
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, self.pixels.width(), self.pixels.height());
        encoder.set_color(png::ColorType::Indexed);
        encoder.set_depth(depth);
        encoder.set_palette(palette);
        encoder.set_compression(png::Compression::High);
        encoder.set_filter(png::Filter::NoFilter);
        encoder.write_header()?.write_image_data(&packed)?;
        Ok(bytes)
    }

    fn fill(&mut self, path: &tiny_skia::Path, colour: Colour) {
        self.pixels.fill_path(
            path,
            &paint(colour),
            FillRule::Winding,
            Transform::identity(),
            None,
        );
    }

    fn stroke(&mut self, path: &tiny_skia::Path, width: f32, colour: Colour) {
        let stroke = Stroke {
            width,
            line_cap: LineCap::Butt,
            line_join: LineJoin::Round,
            ..Stroke::default()
        };
        self.pixels
            .stroke_path(path, &paint(colour), &stroke, Transform::identity(), None);
    }
}

/// Saves bytes of red, green and blue, row by row, as PNG.
pub fn save_rgb(path: &Path, [width, height]: [u32; 2], rgb: &[u8]) -> Result<(), String> {
    let write = || -> Result<(), Box<dyn std::error::Error>> {
        let file = std::io::BufWriter::new(std::fs::File::create(path)?);
        let mut encoder = png::Encoder::new(file, width, height);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_compression(png::Compression::High);
        encoder.write_header()?.write_image_data(rgb)?;
        Ok(())
    };
    write().map_err(|e| format!("{}: {e}", path.display()))
}

/// Reads a PNG as [`save_rgb`] writes it: its size, and bytes of red, green and blue.
pub fn read_rgb(path: &Path) -> Result<([u32; 2], Vec<u8>), String> {
    let read = || -> Result<_, Box<dyn std::error::Error>> {
        let file = std::io::BufReader::new(std::fs::File::open(path)?);
        let mut reader = png::Decoder::new(file).read_info()?;
        let mut bytes = vec![0; reader.output_buffer_size().ok_or("too large")?];
        let info = reader.next_frame(&mut bytes)?;
        if (info.color_type, info.bit_depth) != (png::ColorType::Rgb, png::BitDepth::Eight) {
            return Err("no bytes of red, green and blue".into());
        }
        Ok(([info.width, info.height], bytes))
    };
    read().map_err(|e| format!("{}: {e}", path.display()))
}

fn paint([r, g, b, a]: Colour) -> Paint<'static> {
    let mut paint = Paint::default();
    paint.set_color_rgba8(r, g, b, a);
    paint.anti_alias = true;
    paint
}
