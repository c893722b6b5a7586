//! The figure: for each mutation a short run and a long one, each a histogram over its chain.

use crate::report::{steps_text, time_text};
use crate::run::{Run, variation};
use crate::study::{Pair, Study};
use crate::target::BINS;
use crate::target::density;
use support::draw::canvas::{Area, Canvas};
use support::draw::colour::{ACCENT, BAR, HAIR, INK, MUTED, POINT, faded};
use support::draw::plot::Plot;
use support::draw::scale::Scale;
use support::draw::text::{Align, Type, signed, thousands};

const WIDTH: f32 = 1760.0;
const MARGIN: f32 = 36.0;
const GAP: f32 = 40.0;
const TOP: f32 = 146.0;
/// Of a panel: caption, histogram with its axis, chain.
const CAPTION: f32 = 78.0;
const HISTOGRAM: f32 = 300.0;
const CHAIN: f32 = 120.0;
const BETWEEN: f32 = 34.0;
const FOOT: f32 = 62.0;
/// Text beside an axis.
const LABEL: f32 = 23.0;

pub fn draw(studies: &[Study]) -> Canvas {
    let tall = CAPTION + HISTOGRAM + CHAIN + BETWEEN;
    let height = TOP + studies.len() as f32 * tall + FOOT;
    let mut canvas = Canvas::new(WIDTH as u32, height as u32);
    let inner = WIDTH - 2.0 * MARGIN;
    let title = "Three mutations, one target";
    canvas.text(title, [MARGIN, 60.0], Align::Left, Type::bold(44.0), inner);
    let text = "f(x) = (x − ½)² on [0, 1]. Every chain starts at 0.1; below each histogram its states, steps \
                downwards. τ: integrated autocorrelation time of x.";
    let style = Type::plain(27.0, MUTED);
    canvas.text(text, [MARGIN, 104.0], Align::Left, style, inner);
    let wide = (inner - GAP) / 2.0;
    for (row, study) in studies.iter().enumerate() {
        for (column, pair) in study.pairs.iter().enumerate() {
            let x = MARGIN + column as f32 * (wide + GAP);
            let y = TOP + row as f32 * tall;
            panel(
                &mut canvas,
                Area::new(x, y, wide, tall - BETWEEN),
                study,
                pair,
            );
        }
    }
    legend(&mut canvas, height - 24.0);
    canvas
}

fn panel(canvas: &mut Canvas, area: Area, study: &Study, pair: &Pair) {
    let run = &pair.runs[0];
    let heading = Type::bold(30.0);
    let name = format!(
        "{}, {} steps",
        study.rule.name(),
        thousands(pair.steps as usize)
    );
    let base = area.y + 30.0;
    canvas.text(&name, [area.x, base], Align::Left, heading, area.w);
    let after = area.x + canvas.width(&name, heading) + 18.0;
    let style = Type::plain(25.0, MUTED);
    let right = area.x + area.w;
    canvas.text(
        study.rule.caption(),
        [after, base],
        Align::Left,
        style,
        right - after,
    );
    let text = format!(
        "total variation {}  ·  τ measured {}, true {}  ·  split R̂ {}",
        signed(variation(&run.plain), 3),
        time_text(&run.x),
        steps_text(study.truth.times[0]),
        signed(pair.r_hat, 3),
    );
    let style = Type::plain(26.0, INK);
    canvas.text(&text, [area.x, base + 38.0], Align::Left, style, area.w);

    let linear = |from, to| Scale {
        from,
        to,
        log: false,
    };
    // As high as the highest of the row, whose histograms share a scale.
    let peak = study.pairs.iter().flat_map(|pair| &pair.runs[0].plain);
    let peak = peak.fold(0.0, |peak: f64, share| peak.max(share * BINS as f64));
    let place = Area::new(area.x, area.y + CAPTION - 34.0, area.w, HISTOGRAM + 34.0);
    let x = linear(0.0, 1.0);
    let plot = Plot::sized(canvas, place, LABEL, ["", ""], x, linear(0.0, 1.08 * peak));
    histogram(canvas, &plot, run);
    let inside = plot.inside();
    let top = inside.y + inside.h + 42.0;
    chain(
        canvas,
        Area::new(inside.x, top, inside.w, area.y + area.h - top),
        run,
    );
}

fn histogram(canvas: &mut Canvas, plot: &Plot, run: &Run) {
    let bins = BINS as f64;
    for (i, share) in run.plain.iter().enumerate() {
        let (from, to) = (i as f64 / bins, (i + 1) as f64 / bins);
        plot.bar(canvas, from, to, share * bins, BAR);
    }
    let weighted = run
        .expected
        .iter()
        .enumerate()
        .flat_map(|(i, share)| [i, i + 1].map(|k| [k as f64 / bins, share * bins]));
    plot.curve(canvas, weighted, 2.0, POINT);
    let curve = (0..=200).map(|i| f64::from(i) / 200.0);
    plot.curve(canvas, curve.map(|x| [x, density(x)]), 3.4, ACCENT);
}

/// The states in order from top to bottom, below where they are in the histogram.
fn chain(canvas: &mut Canvas, area: Area, run: &Run) {
    canvas.rectangle(area, faded(HAIR, 0.22));
    let middle = area.x + 0.5 * area.w;
    canvas.segment([middle, area.y], [middle, area.y + area.h], 1.2, HAIR);
    let last = run.trace.len() as f32;
    for (k, x) in run.trace.iter().enumerate() {
        let at = [
            area.x + area.w * x,
            area.y + 3.0 + (area.h - 6.0) * k as f32 / last,
        ];
        canvas.disc(at, 1.7, faded(POINT, 0.6));
    }
}

fn legend(canvas: &mut Canvas, base: f32) {
    let style = Type::plain(25.0, INK);
    let mut x = MARGIN;
    let marks = [
        ("states, recorded plainly", BAR, 16.0),
        ("both states of each step, weights 1 − a and a", POINT, 3.0),
        ("density 12 (x − ½)²", ACCENT, 4.0),
    ];
    for (text, colour, thick) in marks {
        canvas.rectangle(Area::new(x, base - 8.0 - 0.5 * thick, 34.0, thick), colour);
        x += 46.0;
        canvas.text(text, [x, base], Align::Left, style, 700.0);
        x += canvas.width(text, style) + 46.0;
    }
}
