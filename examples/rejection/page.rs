//! A page: accepted and rejected points on the left; radii, tries and the efficiency on the right.

use crate::args::Args;
use crate::measure::{BARS, FIRST, Measured, spread};
use crate::scenes::Scene;
use support::draw::canvas::{Area, Canvas};
use support::draw::colour::{ACCENT, BAR, HAIR, INK, MUTED, POINT, faded};
use support::draw::plot::Plot;
use support::draw::scale::{Scale, round_step};
use support::draw::text::{Align, Type, thousands};

const WIDTH: f32 = 1500.0;
const HEIGHT: f32 = 1010.0;
const MARGIN: f32 = 40.0;
/// The smallest share of points that the bars of tries show.
const RARE: f64 = 1e-6;

pub fn draw(scene: &Scene, measured: &Measured, args: &Args) -> Canvas {
    let mut canvas = Canvas::new(WIDTH as u32, HEIGHT as u32);
    let title = Type::bold(36.0);
    canvas.text(scene.name, [MARGIN, 58.0], Align::Left, title, WIDTH);
    let after = MARGIN + canvas.width(scene.name, title) + 24.0;
    let caption = Type::plain(24.0, MUTED);
    let rest = WIDTH - MARGIN - after;
    canvas.text(scene.caption, [after, 58.0], Align::Left, caption, rest);

    let side = 800.0;
    points(
        &mut canvas,
        Area::new(MARGIN, 88.0, side, HEIGHT - 88.0),
        scene,
        measured,
    );
    let left = MARGIN + side + 20.0;
    let right = |k: usize| Area::new(left, 88.0 + 288.0 * k as f32, WIDTH - MARGIN - left, 280.0);
    radii(&mut canvas, right(0), scene, measured);
    tries(&mut canvas, right(1), scene, measured);
    efficiency(&mut canvas, right(2), scene, measured);
    let foot = format!(
        "{} points in {} tries · Pcg32, seed {}",
        thousands(measured.points),
        thousands(measured.tries),
        args.seed
    );
    let small = Type::plain(17.0, MUTED);
    canvas.text(
        &foot,
        [WIDTH - MARGIN, HEIGHT - 20.0],
        Align::Right,
        small,
        700.0,
    );
    canvas
}

/// The proposals, the border of the region, two axes and the legend.
fn points(canvas: &mut Canvas, area: Area, scene: &Scene, measured: &Measured) {
    let frame = Area::new(area.x + 46.0, area.y + 6.0, area.w - 60.0, area.w - 60.0);
    let half = 0.5 * frame.w;
    let place = |x: f64, y: f64| {
        [
            frame.x + half + half * x as f32,
            frame.y + half - half * y as f32,
        ]
    };
    for (colour, accepted) in [(faded(ACCENT, 0.75), false), (faded(POINT, 0.8), true)] {
        for (point, _) in measured.shown.iter().filter(|p| p.1 == accepted) {
            canvas.disc(place(point[0], point[1]), 2.4, colour);
        }
    }
    let outline = (0..=720).map(|i| (scene.outline)(f64::from(i) / 720.0));
    canvas.line(outline.map(|[x, y]| Some(place(x, y))), 2.0, INK);
    let corners = [
        [-1.0, -1.0],
        [1.0, -1.0],
        [1.0, 1.0],
        [-1.0, 1.0],
        [-1.0, -1.0],
    ];
    canvas.line(corners.map(|[x, y]| Some(place(x, y))), 1.3, HAIR);

    let label = Type::plain(18.0, MUTED);
    for tick in [-1.0, -0.5, 0.0, 0.5, 1.0] {
        let text = format!("{tick}").replace('-', "−");
        let [x, y] = place(tick, -1.0);
        canvas.segment([x, y], [x, y + 6.0], 1.3, INK);
        canvas.text(&text, [x, y + 26.0], Align::Middle, label, 80.0);
        let [x, y] = place(-1.0, tick);
        canvas.segment([x - 6.0, y], [x, y], 1.3, INK);
        canvas.text(&text, [x - 11.0, y + 6.0], Align::Right, label, 40.0);
    }
    let [x, y] = place(0.25, -1.0);
    canvas.text("x", [x, y + 26.0], Align::Middle, label, 40.0);
    let [x, y] = place(-1.0, 0.25);
    canvas.text("y", [x - 11.0, y + 6.0], Align::Right, label, 40.0);

    let all = measured.shown.len();
    let accepted = measured.shown.iter().filter(|p| p.1).count();
    let style = Type::plain(21.0, INK);
    let mut at = [frame.x, frame.y + frame.h + 66.0];
    let mut dot = |canvas: &mut Canvas, text: String, colour| {
        canvas.disc([at[0] + 6.0, at[1] - 7.0], 5.0, colour);
        canvas.text(&text, [at[0] + 22.0, at[1]], Align::Left, style, 400.0);
        at[0] += 22.0 + canvas.width(&text, style) + 34.0;
    };
    dot(canvas, format!("{} accepted", thousands(accepted)), POINT);
    dot(
        canvas,
        format!("{} rejected", thousands(all - accepted)),
        ACCENT,
    );
    if let Some(slice) = scene.slice {
        let text = format!("of the proposals with |z| ≤ {slice}");
        canvas.text(&text, at, Align::Left, Type::plain(21.0, MUTED), 400.0);
    }
    // What the page is about.
    let lines = [
        (
            "exact efficiency",
            format!("{} = {:.3} %", scene.formula, 100.0 * scene.efficiency),
        ),
        (
            "measured efficiency",
            format!(
                "{:.3} %, off by {:+.2} standard errors",
                100.0 * measured.efficiency(),
                measured.deviation(scene)
            )
            .replace('-', "−"),
        ),
    ];
    for (k, (name, value)) in lines.into_iter().enumerate() {
        let y = frame.y + frame.h + 108.0 + 34.0 * k as f32;
        canvas.text(
            name,
            [frame.x, y],
            Align::Left,
            Type::plain(23.0, MUTED),
            300.0,
        );
        canvas.text(
            &value,
            [frame.x + 232.0, y],
            Align::Left,
            Type::bold(23.0),
            500.0,
        );
    }
}

fn linear(from: f64, to: f64) -> Scale {
    Scale {
        from,
        to,
        log: false,
    }
}

/// Names of marks, in a row that ends at the plot's upper right corner, above it.
fn legend(canvas: &mut Canvas, plot: &Plot, marks: &[(&str, [u8; 4])]) {
    let style = Type::plain(17.0, MUTED);
    let [mut x, y] = plot.corner();
    let y = y - 14.0;
    for (text, colour) in marks.iter().rev() {
        canvas.text(text, [x, y], Align::Right, style, 300.0);
        x -= canvas.width(text, style) + 26.0;
        canvas.rectangle(Area::new(x, y - 11.0, 18.0, 10.0), *colour);
        x -= 20.0;
    }
}

fn radii(canvas: &mut Canvas, area: Area, scene: &Scene, measured: &Measured) {
    let (bars, n) = (BARS as f64, measured.points as f64);
    let height = |count: usize| count as f64 / n * bars;
    let steps = (0..=400).map(|i| f64::from(i) / 400.0);
    let curve: Vec<[f64; 2]> = steps.map(|r| [r, (scene.radius_density)(r)]).collect();
    let peak = curve.iter().map(|p| p[1]).fold(0.0, f64::max);
    let plot = Plot::new(
        canvas,
        area,
        "Radius of the points",
        "radius",
        linear(0.0, 1.0),
        linear(0.0, 1.08 * peak),
    );
    for (i, count) in measured.radii.iter().enumerate() {
        let (from, to) = (i as f64 / bars, (i + 1) as f64 / bars);
        plot.bar(canvas, from, to, height(*count), BAR);
    }
    plot.curve(canvas, curve, 2.4, ACCENT);
    legend(
        canvas,
        &plot,
        &[("sampled", BAR), ("exact density", ACCENT)],
    );
}

fn tries(canvas: &mut Canvas, area: Area, scene: &Scene, measured: &Measured) {
    let e = scene.efficiency;
    let exact = |k: usize| e * (1.0 - e).powi(k as i32 - 1);
    let shown = (1..).take_while(|&k| exact(k) >= RARE).count();
    let plot = Plot::new(
        canvas,
        area,
        "Tries a point",
        "tries k (upwards: share of points)",
        linear(0.3, shown as f64 + 0.7),
        Scale {
            from: RARE,
            to: 1.0,
            log: true,
        },
    );
    for k in 1..=shown {
        let share =
            measured.histogram.get(k - 1).map_or(0.0, |n| *n as f64) / measured.points as f64;
        let x = k as f64;
        if share >= RARE {
            plot.bar(canvas, x - 0.42, x + 0.42, share, BAR);
        }
        plot.curve(
            canvas,
            [[x - 0.42, exact(k)], [x + 0.42, exact(k)]],
            2.6,
            ACCENT,
        );
    }
    legend(canvas, &plot, &[("sampled", BAR), ("e (1 − e)ᵏ⁻¹", ACCENT)]);
}

fn efficiency(canvas: &mut Canvas, area: Area, scene: &Scene, measured: &Measured) {
    let e = scene.efficiency;
    let last = measured.running.last().map_or(FIRST, |mark| mark.0);
    // Wide enough for the band from the first mark on.
    let reach = 2.2 * spread(e, FIRST);
    let step = round_step(reach / 2.0);
    let (low, high) = (
        ((e - reach) / step).floor() * step,
        ((e + reach) / step).ceil() * step,
    );
    let plot = Plot::new(
        canvas,
        area,
        "Efficiency",
        "tries",
        Scale {
            from: FIRST,
            to: last,
            log: true,
        },
        linear(low.max(0.0), high.min(1.0)),
    );
    let along = |sign: f64| {
        let marks = measured.running.iter();
        marks.map(move |(n, _)| [*n, e + 2.0 * sign * spread(e, *n)])
    };
    let band = faded(ACCENT, 0.45);
    for sign in [-1.0, 1.0] {
        plot.curve(canvas, along(sign), 1.4, band);
    }
    plot.curve(canvas, [[FIRST, e], [last, e]], 2.2, ACCENT);
    let running = measured.running.iter().map(|(n, share)| [*n, *share]);
    plot.curve(canvas, running, 2.4, POINT);
    let exact = format!("exact {:.1} %", 100.0 * e);
    legend(
        canvas,
        &plot,
        &[("measured", POINT), (&exact, ACCENT), ("± 2 σ", band)],
    );
}
