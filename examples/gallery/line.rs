//! The picture of a distribution on the line: histogram, density and a few samples as ticks.

use host::draw::canvas::{Area, Canvas};
use host::draw::colour::{ACCENT, BAR, HAIR, INK, MUTED, POINT, faded};
use host::draw::scale::{Scale, round_step};
use host::draw::text::{Align, Type};
use host::registry::Entry;
use host::registry::picture::Axes;
use microwarp::uniform;
use rand_pcg::Pcg32;

/// Samples in a histogram: few enough that the noise shows.
pub const SAMPLES: usize = 100_000;
/// Ticks for single samples.
const TICKS: usize = 70;

/// The density, which a user's closures may go on giving outside the domain.
fn density(entry: &Entry, x: f64) -> f64 {
    let [u, ..] = entry.truth.invert([x, 0.0, 0.0]);
    if (-1e-9..=1.0 + 1e-9).contains(&u) {
        f64::from(entry.warp.pdf([x as f32, 0.0, 0.0]))
    } else {
        0.0
    }
}

/// The histogram as (left edge, right edge, density).
fn histogram(axes: Axes, x: Scale, entry: &Entry, rng: &mut Pcg32) -> Vec<(f64, f64, f64)> {
    // Edges at round numbers, so that they meet the ends of the domain.
    let step = if axes.log_x {
        0.05
    } else {
        round_step((axes.to - axes.from) / 50.0)
    };
    let (low, high) = (x.even(axes.from), x.even(axes.to));
    let first = (low / step).floor();
    let mut counts = vec![0_usize; ((high - low) / step).ceil() as usize + 2];
    for [sample, ..] in entry.warp.fill(rng, SAMPLES) {
        let bin = (x.even(f64::from(sample)) / step).floor() - first;
        if let Some(count) = counts.get_mut(bin as usize).filter(|_| bin >= 0.0) {
            *count += 1;
        }
    }
    let edge = |i: usize| {
        let e = (first + i as f64) * step;
        if axes.log_x { 10f64.powf(e) } else { e }
    };
    let within = |left: f64, right: f64| {
        left >= axes.from * 0.999_999 - 1e-9 && right <= axes.to * 1.000_001 + 1e-9
    };
    (0..counts.len())
        .filter(|&i| within(edge(i), edge(i + 1)))
        .map(|i| {
            let (left, right) = domain(entry, edge(i), edge(i + 1));
            let share = counts[i] as f64 / SAMPLES as f64;
            (left, right, share / (right - left))
        })
        .collect()
}

/// The part of a bar in which there is a density: a domain may end in the middle of it.
fn domain(entry: &Entry, left: f64, right: f64) -> (f64, f64) {
    let hair = 1e-4 * (right - left);
    let inside = |x: f64| density(entry, x) > 0.0;
    let end = |mut within: f64, mut without: f64| {
        for _ in 0..30 {
            let middle = 0.5 * (within + without);
            *(if inside(middle) {
                &mut within
            } else {
                &mut without
            }) = middle;
        }
        within
    };
    match (inside(left + hair), inside(right - hair)) {
        (true, false) => (left, end(left + hair, right)),
        (false, true) => (end(right - hair, left), right),
        _ => (left, right),
    }
}

/// Draws the picture; `unit` scales text and line widths.
pub fn draw(
    canvas: &mut Canvas,
    area: Area,
    axes: Axes,
    entry: &Entry,
    rng: &mut Pcg32,
    unit: f32,
) {
    let density = |x: f64| density(entry, x);
    let x_scale = Scale {
        from: axes.from,
        to: axes.to,
        log: axes.log_x,
    };
    let curve: Vec<(f64, f64)> = (0..=800)
        .map(|i| {
            let t = f64::from(i) / 800.0;
            let even =
                x_scale.even(axes.from) + t * (x_scale.even(axes.to) - x_scale.even(axes.from));
            let x = if axes.log_x { 10f64.powf(even) } else { even };
            (x, density(x))
        })
        .collect();
    let log_y = axes.bottom > 0.0;
    let bars = histogram(axes, x_scale, entry, rng);
    let peak = curve.iter().map(|c| c.1).fold(0.0, f64::max);
    let top = if log_y { peak * 2.5 } else { peak * 1.12 }.min(axes.top);
    let y_scale = Scale {
        from: axes.bottom,
        to: top,
        log: log_y,
    };

    let plot = area.inside(40.0 * unit, 6.0 * unit, 8.0 * unit, 34.0 * unit);
    let floor = plot.y + plot.h;
    let px = |x: f64| plot.x + plot.w * x_scale.at(x) as f32;
    let py = |y: f64| floor - plot.h * y_scale.at(y.clamp(axes.bottom, top)) as f32;
    let label = Type::plain(14.5 * unit, MUTED);

    for y in y_scale.ticks(if log_y { 3.0 } else { 3.5 }) {
        canvas.segment(
            [plot.x, py(y)],
            [plot.x + plot.w, py(y)],
            0.8 * unit,
            faded(HAIR, 0.7),
        );
        let at = [plot.x - 5.0 * unit, py(y) + 5.0 * unit];
        canvas.text(&y_scale.label(y), at, Align::Right, label, 34.0 * unit);
    }
    for (left, right, height) in bars.into_iter().filter(|bar| bar.2 > axes.bottom) {
        let gap = 0.5 * unit;
        let bar = Area::new(
            px(left) + 0.5 * gap,
            py(height),
            px(right) - px(left) - gap,
            floor - py(height),
        );
        canvas.rectangle(bar, BAR);
    }
    // The density where there is one and where it fits.
    let shown = curve
        .iter()
        .map(|&(x, y)| (y > axes.bottom && y <= top).then(|| [px(x), py(y)]));
    canvas.line(shown, 1.8 * unit, ACCENT);

    // Single samples, the darker the larger their uniform: which end comes first is seen at once.
    for _ in 0..TICKS {
        let u = [(); 4].map(|()| uniform::grid(rng));
        let [x, ..] = entry.warp.sample(u);
        let at = px(f64::from(x));
        if (plot.x..=plot.x + plot.w).contains(&at) {
            let tick = faded(POINT, 0.12 + 0.8 * u[0]);
            canvas.segment(
                [at, floor + 3.0 * unit],
                [at, floor + 11.0 * unit],
                1.1 * unit,
                tick,
            );
        }
    }
    canvas.segment([plot.x, floor], [plot.x + plot.w, floor], 1.0 * unit, INK);
    for x in x_scale.ticks(6.5) {
        canvas.segment([px(x), floor], [px(x), floor + 3.0 * unit], 1.0 * unit, INK);
        canvas.text(
            &x_scale.label(x),
            [px(x), floor + 27.0 * unit],
            Align::Middle,
            label,
            60.0 * unit,
        );
    }
}
