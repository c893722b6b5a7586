//! Bias and noise against samples a pixel, scene by scene.

use crate::accuracy::{KITS, Scene};
use host::draw::canvas::{Area, Canvas};
use host::draw::colour::{ACCENT, Colour, INK, MUTED, faded};
use host::draw::plot::Plot;
use host::draw::scale::Scale;
use host::draw::text::{Align, Type};

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

/// The columns of plots, and of entries of the legend below them.
const COLUMNS: usize = 3;
const LEGEND: f32 = 124.0;

/// What the legend says of a line.
struct Key {
    text: String,
    colour: Colour,
    width: f32,
    /// Where the line begins and the text's base is.
    at: [f32; 2],
}

const LINE: f32 = 50.0;
const STYLE: Type = Type {
    size: 21.0,
    bold: false,
    colour: INK,
};

fn rows(scenes: usize) -> f32 {
    scenes.div_ceil(COLUMNS) as f32
}

/// Columns and rows of pixels for so many scenes.
fn size(scenes: usize) -> [f32; 2] {
    let width = 2.0 * MARGIN + COLUMNS as f32 * WIDE;
    [width, TOP + rows(scenes) * HIGH + LEGEND + MARGIN]
}

/// The legend below so many scenes.
fn legend(scenes: usize) -> Vec<Key> {
    let key = |text: &str, colour, width| (text.to_owned(), colour, width);
    let mut keys = vec![
        key("noise of a pixel", INK, 3.0),
        key("a tenth of it", INK, 1.5),
        key("paler: the bias is below this", faded(INK, 0.45), 2.5),
    ];
    let kits = KITS.iter().zip(COLOURS);
    keys.extend(kits.map(|(kit, colour)| key(&format!("bias, {}", kit.name()), colour, 2.5)));
    let top = TOP + rows(scenes) * HIGH + 30.0;
    let placed = keys
        .into_iter()
        .enumerate()
        .map(|(i, (text, colour, width))| {
            let (column, row) = ((i % COLUMNS) as f32, (i / COLUMNS) as f32);
            let at = [MARGIN + 62.0 + column * WIDE, top + 36.0 * row];
            Key {
                text,
                colour,
                width,
                at,
            }
        });
    placed.collect()
}

pub fn draw(scenes: &[Scene]) -> Canvas {
    let [width, height] = size(scenes.len());
    let mut canvas = Canvas::new(width as u32, height as u32);
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
        let (column, row) = ((i % COLUMNS) as f32, (i / COLUMNS) as f32);
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
    for key in legend(scenes.len()) {
        let [x, y] = key.at;
        let line = y - 0.3 * STYLE.size;
        canvas.segment([x, line], [x + LINE, line], key.width, key.colour);
        let at = [x + LINE + 16.0, y];
        canvas.text(&key.text, at, Align::Left, STYLE, WIDE - LINE - 100.0);
    }
    canvas
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The boxes of the legend's entries, with their lines.
    fn boxes(canvas: &Canvas, keys: &[Key]) -> Vec<Area> {
        let of = |key: &Key| {
            let wide = LINE + 16.0 + canvas.width(&key.text, STYLE);
            Area::new(key.at[0], key.at[1] - STYLE.size, wide, 1.3 * STYLE.size)
        };
        keys.iter().map(of).collect()
    }

    /// The entries that are not wholly on a canvas, or not clear of plots and of each other.
    fn lost(scenes: usize, keys: &[Key], [width, height]: [f32; 2]) -> usize {
        let plots = Area::new(0.0, 0.0, width, TOP + rows(scenes) * HIGH - 10.0);
        let boxes = boxes(&Canvas::new(1, 1), keys);
        let mut taken = vec![plots];
        let mut lost = 0;
        for area in boxes {
            let fits = area.x + area.w <= width && area.y + area.h <= height;
            let free = taken.iter().all(|other| area.overlap(*other) == 0.0);
            lost += usize::from(!fits || !free);
            taken.push(area);
        }
        lost
    }

    #[test]
    fn the_legend_lies_on_the_canvas() {
        for scenes in 1..=13 {
            let keys = legend(scenes);
            assert_eq!(keys.len(), KITS.len() + 3);
            assert_eq!(lost(scenes, &keys, size(scenes)), 0, "{scenes} scenes");
        }
        // As it once was: below six plots, where there was no canvas.
        let [width, height] = size(6);
        let short = [width, height - LEGEND];
        assert_eq!(lost(6, &legend(6), short), KITS.len() + 3);
        assert!(lost(6, &legend(5), size(6)) == 0 && lost(6, &legend(3), size(6)) > 0);
    }
}
