//! The figure: the picture, its samples, and the difference.

use crate::controls::Control;
use crate::develop::{BLACK, FAR, developed, diverging};
use crate::picture::Picture;
use crate::report::p_text;
use crate::study::{Study, Truth};
use support::draw::canvas::{Area, Canvas};
use support::draw::colour::{Colour, INK, MUTED, faded};
use support::draw::panel::{HEAD, cells, head};
use support::draw::text::{Align, Type, thousands};
use support::draw::tone::tone;

/// Pixels along a texel of the picture, a whole number so that texels stay sharp.
const SCALE: usize = 3;
const MARGIN: f32 = 40.0;
const GAP: f32 = 36.0;
const TOP: f32 = 128.0;
const FOOT: f32 = 96.0;

/// Samples over the picture.
const SPARK: Colour = [255, 214, 84, 255];

pub struct Figure<'a> {
    pub picture: &'a Picture,
    pub small: &'a Picture,
    pub truth: &'a Truth,
    pub study: &'a Study,
    pub small_study: &'a Study,
    pub control: &'a Control,
    pub points: &'a [[f32; 2]],
    pub samples: usize,
}

impl Figure<'_> {
    pub fn draw(&self) -> Canvas {
        let [columns, rows] = self.picture.shape.map(|n| (n * SCALE) as f32);
        let width = 2.0 * MARGIN + 2.0 * columns + GAP;
        let height = TOP + 3.0 * (HEAD + rows + 14.0) + FOOT;
        let mut canvas = Canvas::new(width as u32, height as u32);
        let title = Type::bold(42.0);
        let text = "A picture as a distribution";
        canvas.text(text, [MARGIN, 62.0], Align::Left, title, width);
        let text = "PiecewiseConstant2d of an environment map: directions in proportion to the light \
                    that comes from them. Azimuth across, polar angle down.";
        let style = Type::plain(24.0, MUTED);
        canvas.text(
            text,
            [MARGIN, 100.0],
            Align::Left,
            style,
            width - 2.0 * MARGIN,
        );

        let place = |column: usize, row: usize| {
            Area::new(
                MARGIN + column as f32 * (columns + GAP),
                TOP + row as f32 * (HEAD + rows + 14.0),
                columns,
                rows + HEAD,
            )
        };
        self.picture_panel(&mut canvas, place(0, 0));
        self.points_panel(&mut canvas, place(1, 0));
        self.histogram_panel(&mut canvas, place(0, 1));
        self.small_panel(&mut canvas, place(1, 1));
        let rejected = format!(
            "p {}: rejected, as it must be",
            p_text(&self.control.outcome)
        );
        let p = format!("χ² p = {}", p_text(&self.study.outcome));
        let spread = self.spread();
        self.difference(
            &mut canvas,
            place(0, 2),
            ["Samples against picture", &format!("{p}; {spread}")],
            &self.study.histogram,
        );
        self.difference(
            &mut canvas,
            place(1, 2),
            ["The same, sin θ forgotten", &rejected],
            &self.control.histogram,
        );
        self.scale(&mut canvas, [MARGIN, height - FOOT + 14.0], width);
        canvas
    }

    fn picture_panel(&self, canvas: &mut Canvas, place: Area) {
        let luminance = self.picture.luminance();
        let brightest = luminance.iter().copied().fold(0.0, f64::max);
        let [columns, rows] = self.picture.shape;
        let text = format!(
            "{columns} × {rows} texels; the sun {} times the median of the sky",
            thousands((brightest / self.median(&luminance)).round() as usize),
        );
        let place = head(canvas, place, "The picture", &text);
        cells(canvas, place, self.picture.shape, |i| {
            tone(self.picture.texels[i].map(f64::from))
        });
    }

    /// The median of the pixels above the horizon that are not black.
    fn median(&self, luminance: &[f64]) -> f64 {
        let half = &luminance[..luminance.len() / 2];
        let mut sky: Vec<f64> = half.iter().copied().filter(|&l| l > 0.0).collect();
        sky.sort_by(f64::total_cmp);
        sky[sky.len() / 2]
    }

    fn points_panel(&self, canvas: &mut Canvas, place: Area) {
        let sun = self.truth.middle(self.truth.brightest());
        // Along both axes a texel is as large a part of a turn.
        let texels = self.picture.shape[0] as f32;
        let near = |point: &&[f32; 2]| {
            let [across, down] = [0, 1].map(|k| texels * (point[k] - sun[k]));
            across * across + down * down < 25.0
        };
        let sunny = self.points.iter().filter(near).count();
        let text = format!("{} of them within 5 texels of the sun", thousands(sunny));
        let title = format!("{} samples", thousands(self.points.len()));
        let place = head(canvas, place, &title, &text);
        cells(canvas, place, self.picture.shape, |i| {
            tone(self.picture.texels[i].map(f64::from)).map(|c| 12.0 + 0.38 * c)
        });
        for &[phi, theta] in self.points {
            let at = [place.x + phi * place.w, place.y + 2.0 * theta * place.h];
            canvas.disc(at, 1.9, faded(SPARK, 0.85));
        }
    }

    fn histogram_panel(&self, canvas: &mut Canvas, place: Area) {
        let title = format!("Histogram of {} samples", thousands(self.samples));
        let text = "over sin θ, toned alike";
        let place = head(canvas, place, &title, text);
        let seen = developed(self.picture, &self.study.histogram);
        cells(canvas, place, self.picture.shape, |i| tone(seen[i]));
    }

    fn small_panel(&self, canvas: &mut Canvas, place: Area) {
        let [columns, rows] = self.small_study.shape;
        let title = format!("From {columns} × {rows} cells");
        let text = format!(
            "a const, {} bytes, none of RAM; χ² p = {}",
            thousands(self.small_study.bytes[1]),
            p_text(&self.small_study.outcome)
        );
        let place = head(canvas, place, &title, &text);
        let histogram = &self.small_study.histogram;
        let seen = developed(self.small, histogram);
        cells(canvas, place, self.small.shape, |i| tone(seen[i]));
    }

    /// The share of cells that are more than two standard deviations off.
    fn spread(&self) -> String {
        let expected = self.truth.expected(self.samples);
        let pairs = self.study.histogram.iter().zip(&expected);
        let z: Vec<f64> = pairs
            .filter(|&(_, &e)| e >= 5.0)
            .map(|(&n, e)| (n as f64 - e) / e.sqrt())
            .collect();
        let beyond = z.iter().filter(|z| z.abs() > 2.0).count();
        let percent = 100.0 * beyond as f64 / z.len() as f64;
        format!("{percent:.1} % of cells beyond ±2σ")
    }

    fn difference(
        &self,
        canvas: &mut Canvas,
        place: Area,
        [title, text]: [&str; 2],
        histogram: &[u64],
    ) {
        let place = head(canvas, place, title, text);
        let expected = self.truth.expected(self.samples);
        cells(canvas, place, self.truth.shape, |i| {
            let deviations = (histogram[i] as f64 - expected[i]) / expected[i].sqrt();
            if expected[i] > 0.0 {
                diverging(deviations)
            } else {
                BLACK
            }
        });
    }

    fn scale(&self, canvas: &mut Canvas, [x, y]: [f32; 2], width: f32) {
        let bar = Area::new(x, y, 460.0, 18.0);
        canvas.shade(bar, |px, _| {
            Some(diverging(
                FAR * (2.0 * f64::from((px - bar.x) / bar.w) - 1.0),
            ))
        });
        let style = Type::plain(20.0, INK);
        for (i, label) in ["≤ −4", "−2", "0", "2", "≥ 4"].iter().enumerate() {
            let at = bar.x + bar.w * i as f32 / 4.0;
            canvas.segment([at, y + 19.0], [at, y + 25.0], 1.4, INK);
            let align = match i {
                0 => Align::Left,
                4 => Align::Right,
                _ => Align::Middle,
            };
            canvas.text(label, [at, y + 46.0], align, style, 100.0);
        }
        let after = bar.x + bar.w + 24.0;
        let text = "samples less expected, in standard deviations √expected";
        canvas.text(text, [after, y + 16.0], Align::Left, style, width);
        let dark = Area::new(after, y + 31.0, 26.0, 18.0);
        canvas.shade(dark, |_, _| Some(BLACK));
        let text = "black in the picture: never sampled";
        canvas.text(text, [after + 36.0, y + 46.0], Align::Left, style, width);
    }
}
