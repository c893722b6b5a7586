//! Bias and noise against samples a pixel, scene by scene.

use crate::accuracy::{KITS, Scene};
use support::draw::canvas::{Area, Canvas};
use support::draw::colour::{ACCENT, Colour, INK, MUTED, faded};
use support::draw::plot::Plot;
use support::draw::scale::Scale;
use support::draw::text::{Align, Type};

const WIDE: f32 = 640.0;
const HIGH: f32 = 420.0;
const TOP: f32 = 130.0;
const MARGIN: f32 = 30.0;

/// One for each kit.
const COLOURS: [Colour; KITS.len()] = [
    [18, 52, 88, 255],
    [46, 134, 171, 255],
    [38, 128, 84, 255],
    [196, 140, 20, 255],
    [140, 80, 160, 255],
    ACCENT,
];

pub fn draw(scenes: &[Scene]) -> Canvas {
    let width = 2.0 * MARGIN + 3.0 * WIDE;
    let mut canvas = Canvas::new(width as u32, (TOP + 2.0 * HIGH + MARGIN) as u32);
    let fit = width - 2.0 * MARGIN;
    let title = "How much accuracy a scene needs";
    canvas.text(title, [MARGIN, 62.0], Align::Left, Type::bold(40.0), fit);
    let text = "Bias of the picture by its samplers, and the noise of a pixel that hides it";
    canvas.text(
        text,
        [MARGIN, 100.0],
        Align::Left,
        Type::plain(24.0, MUTED),
        fit,
    );
    let place = |i: usize| {
        let (column, row) = ((i % 3) as f32, (i / 3) as f32);
        Area::new(
            MARGIN + column * WIDE,
            TOP + row * HIGH,
            WIDE - 20.0,
            HIGH - 10.0,
        )
    };
    let [x, y] = [(1.0, 1e10), (1e-7, 10.0)].map(|(from, to)| Scale {
        from,
        to,
        log: true,
    });
    for (i, scene) in scenes.iter().enumerate() {
        let name = "samples a pixel";
        let plot = Plot::new(&mut canvas, place(i), scene.shot.title, name, x, y);
        let noise = |part: f64| {
            let at = move |k: i32| 10f64.powf(0.1 * f64::from(k));
            (0..=100).map(move |k| [at(k), part * scene.noise / at(k).sqrt()])
        };
        plot.curve(&mut canvas, noise(1.0), 3.0, INK);
        plot.curve(&mut canvas, noise(0.1), 1.5, INK);
        for (found, colour) in scene.kits.iter().zip(COLOURS) {
            let opacity = if found.bias.measured { 1.0 } else { 0.45 };
            let level = found.bias.value;
            plot.curve(
                &mut canvas,
                [[x.from, level], [x.to, level]],
                2.5,
                faded(colour, opacity),
            );
        }
    }
    let legend = place(scenes.len());
    let mut line = legend.y + 50.0;
    let mut entry = |text: &str, colour, thick| {
        canvas.segment(
            [legend.x + 60.0, line],
            [legend.x + 110.0, line],
            thick,
            colour,
        );
        let at = [legend.x + 126.0, line + 7.0];
        canvas.text(
            text,
            at,
            Align::Left,
            Type::plain(20.0, INK),
            legend.w - 126.0,
        );
        line += 34.0;
    };
    entry("noise of a pixel", INK, 3.0);
    entry("a tenth of it", INK, 1.5);
    for (kit, colour) in KITS.iter().zip(COLOURS) {
        entry(&format!("bias, {}", kit.name()), colour, 2.5);
    }
    entry("paler: the bias is below this", faded(INK, 0.45), 2.5);
    canvas
}
