//! A picture of all directions with a high dynamic range: its file, its luminance, and the weights of
//! its texels as a distribution.
//!
//! The file is a PNG of 8 bits a channel whose four channels are not red, green, blue and opacity but
//! Ward's RGBE: three mantissas and a common exponent, a channel being mantissa · 2^(E − 136), and black
//! where E is 0. That is 2 in 1000 of the brightest channel over 76 decades, in four bytes.

use std::error::Error;
use std::f64::consts::PI;
use std::io::Cursor;
use std::path::Path;
use support::draw::tone::luminance;

/// Directions in rows of equal polar angle θ, from the zenith down, and columns of equal azimuth φ.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Columns, rows.
    pub shape: [usize; 2],
    pub texels: Vec<[f32; 3]>,
}

/// The channels of a texel as four bytes.
fn encode([r, g, b]: [f32; 3]) -> [u8; 4] {
    let largest = r.max(g).max(b);
    if largest <= 0.0 {
        return [0; 4];
    }
    // The exponent field of a float is Ward's exponent but for a constant, 127 against 128 − 1, and
    // adding half a step of the mantissa first carries 255.5 into the next exponent.
    let exponent = ((largest * (1.0 + 1.0 / 512.0)).to_bits() >> 23) + 2;
    let step = step(exponent as u8);
    let [r, g, b] = [r, g, b].map(|c| (c / step).round().min(255.0) as u8);
    [r, g, b, exponent as u8]
}

/// 2^(E − 136).
fn step(exponent: u8) -> f32 {
    2f32.powi(i32::from(exponent) - 136)
}

fn decode([r, g, b, exponent]: [u8; 4]) -> [f32; 3] {
    if exponent == 0 {
        [0.0; 3]
    } else {
        [r, g, b].map(|mantissa| f32::from(mantissa) * step(exponent))
    }
}

impl Picture {
    /// Reads the four bytes a texel of a PNG as RGBE.
    pub fn read(file: &[u8]) -> Result<Self, Box<dyn Error>> {
        let mut reader = png::Decoder::new(Cursor::new(file)).read_info()?;
        let mut bytes = vec![
            0;
            reader
                .output_buffer_size()
                .ok_or("the picture is too large")?
        ];
        let frame = reader.next_frame(&mut bytes)?;
        if (frame.color_type, frame.bit_depth) != (png::ColorType::Rgba, png::BitDepth::Eight) {
            return Err("the picture has not four channels of 8 bits".into());
        }
        let texels = bytes[..frame.buffer_size()].chunks_exact(4);
        Ok(Self {
            shape: [frame.width as usize, frame.height as usize],
            texels: texels.map(|t| decode([t[0], t[1], t[2], t[3]])).collect(),
        })
    }

    pub fn write(&self, path: &Path) -> Result<(), Box<dyn Error>> {
        let bytes: Vec<u8> = self.texels.iter().flat_map(|&t| encode(t)).collect();
        let [width, height] = self.shape.map(|n| n as u32);
        let mut encoder = png::Encoder::new(std::fs::File::create(path)?, width, height);
        encoder.set_color(png::ColorType::Rgba);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_compression(png::Compression::High);
        let note =
            "Ward's RGBE: a channel is its byte times 2^(alpha - 136); black where alpha is 0";
        encoder.add_text_chunk("Comment".into(), note.into())?;
        encoder.write_header()?.write_image_data(&bytes)?;
        Ok(())
    }

    /// The picture as its file holds it: rounded to RGBE.
    pub fn rounded(mut self) -> Self {
        for texel in &mut self.texels {
            *texel = decode(encode(*texel));
        }
        self
    }

    pub fn luminance(&self) -> Vec<f64> {
        self.texels.iter().map(|&t| luminance(t)).collect()
    }

    /// Luminance times solid angle, but for a constant: rows shrink towards the poles as sin θ, and
    /// without that factor the poles would draw most of the samples.
    pub fn weights(&self) -> Vec<f32> {
        let [columns, rows] = self.shape;
        let luminance = self.luminance();
        let pairs = luminance.iter().enumerate();
        pairs
            .map(|(i, l)| (l * sin_of_row(i / columns, rows)) as f32)
            .collect()
    }

    /// The picture in texels `factor` times as wide and high.
    pub fn shrunk(&self, factor: usize) -> Self {
        let [columns, rows] = self.shape;
        let shape = [columns / factor, rows / factor];
        let mut texels = vec![[0.0; 3]; shape[0] * shape[1]];
        for (i, texel) in self.texels.iter().enumerate() {
            let (column, row) = (i % columns, i / columns);
            let sine = sin_of_row(row, rows) / sin_of_row(row / factor, shape[1]);
            let share = sine / (factor * factor) as f64;
            let into = &mut texels[row / factor * shape[0] + column / factor];
            (0..3).for_each(|k| into[k] += (f64::from(texel[k]) * share) as f32);
        }
        Self { shape, texels }
    }
}

/// The sine in the middle of a row. It is more than an approximation: the solid angle of a row of equal
/// angles, 2π (cos θ₀ − cos θ₁), is exactly 4π sin((θ₁ − θ₀)/2) times it.
pub fn sin_of_row(row: usize, rows: usize) -> f64 {
    (PI * (row as f64 + 0.5) / rows as f64).sin()
}
