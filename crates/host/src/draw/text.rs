//! Text: a font that is compiled in, its measures and the outlines of its letters.

use super::colour::{Colour, INK};
use tiny_skia::{Path, PathBuilder};
use ttf_parser::{Face, GlyphId, OutlineBuilder};

/// Where on a text its anchor point lies.
#[derive(Clone, Copy)]
pub enum Align {
    Left,
    Middle,
    Right,
}

/// How a text is set.
#[derive(Clone, Copy)]
pub struct Type {
    pub size: f32,
    pub bold: bool,
    pub colour: Colour,
}

impl Type {
    pub fn plain(size: f32, colour: Colour) -> Self {
        Self {
            size,
            bold: false,
            colour,
        }
    }

    pub fn bold(size: f32) -> Self {
        Self {
            size,
            bold: true,
            colour: INK,
        }
    }
}

/// 1000000 as "1 000 000".
pub fn thousands(n: usize) -> String {
    let digits = n.to_string();
    let mut text = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i) % 3 == 0 {
            text.push('\u{202f}');
        }
        text.push(digit);
    }
    text
}

/// A font that is compiled in: the gallery must look the same on a machine without any.
pub struct Fonts {
    regular: Face<'static>,
    bold: Face<'static>,
}

impl Default for Fonts {
    fn default() -> Self {
        let face = |data| Face::parse(data, 0).expect("the font is part of the program");
        Self {
            regular: face(dejavu::sans_condensed::regular()),
            bold: face(dejavu::sans_condensed::bold()),
        }
    }
}

impl Fonts {
    fn face(&self, style: Type) -> &Face<'static> {
        if style.bold {
            &self.bold
        } else {
            &self.regular
        }
    }

    pub fn width(&self, text: &str, style: Type) -> f32 {
        let face = self.face(style);
        let units: f32 = glyphs(face, text).map(|glyph| advance(face, glyph)).sum();
        units * style.size / f32::from(face.units_per_em())
    }

    /// The outlines of a text whose anchor lies on the base line.
    pub fn outline(&self, text: &str, anchor: [f32; 2], align: Align, style: Type) -> Option<Path> {
        let face = self.face(style);
        let width = self.width(text, style);
        let before = match align {
            Align::Left => 0.0,
            Align::Middle => 0.5 * width,
            Align::Right => width,
        };
        let mut outline = Outline {
            path: PathBuilder::new(),
            x: anchor[0] - before,
            y: anchor[1],
            scale: style.size / f32::from(face.units_per_em()),
        };
        for glyph in glyphs(face, text) {
            face.outline_glyph(glyph, &mut outline);
            outline.x += advance(face, glyph) * outline.scale;
        }
        outline.path.finish()
    }
}

fn glyphs<'a>(face: &'a Face<'_>, text: &'a str) -> impl Iterator<Item = GlyphId> + 'a {
    text.chars()
        .map(|c| face.glyph_index(c).unwrap_or(GlyphId(0)))
}

fn advance(face: &Face<'_>, glyph: GlyphId) -> f32 {
    f32::from(face.glyph_hor_advance(glyph).unwrap_or(0))
}

/// Carries the outline of a glyph over into a path.
struct Outline {
    path: PathBuilder,
    x: f32,
    y: f32,
    scale: f32,
}

impl Outline {
    fn at(&self, x: f32, y: f32) -> (f32, f32) {
        (self.x + x * self.scale, self.y - y * self.scale)
    }
}

impl OutlineBuilder for Outline {
    fn move_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.at(x, y);
        self.path.move_to(x, y);
    }
    fn line_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.at(x, y);
        self.path.line_to(x, y);
    }
    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let ((x1, y1), (x, y)) = (self.at(x1, y1), self.at(x, y));
        self.path.quad_to(x1, y1, x, y);
    }
    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let ((x1, y1), (x2, y2), (x, y)) = (self.at(x1, y1), self.at(x2, y2), self.at(x, y));
        self.path.cubic_to(x1, y1, x2, y2, x, y);
    }
    fn close(&mut self) {
        self.path.close();
    }
}
