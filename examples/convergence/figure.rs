//! The figure: a panel for each number of dimensions, errors over evaluations, and a legend with the slopes.

use crate::fit::{Line, Use};
use crate::method::DIMENSIONS;
use crate::plot::{LABELS, Scale, TEXT, dot};
use support::draw::canvas::{Area, Canvas};
use support::draw::colour::{INK, MUTED};
use support::draw::text::{Align, Type, signed};

const WIDTH: f32 = 1800.0;
const HEIGHT: f32 = 1076.0;
const MARGIN: f32 = 34.0;
const GAP: f32 = 44.0;
/// Where the plots begin and how high they are.
const TOP: f32 = 172.0;
const TALL: f32 = 540.0;
const ROW: f32 = 36.0;

pub fn draw(lines: &[Line], repetitions: u32) -> Canvas {
    let mut canvas = Canvas::new(WIDTH as u32, HEIGHT as u32);
    let inner = WIDTH - 2.0 * MARGIN;
    canvas.text(
        "How the error falls with the number of evaluations",
        [MARGIN, 52.0],
        Align::Left,
        Type::bold(36.0),
        inner,
    );
    let subtitle = format!(
        "∫ ∏ 2/(1 + xᵢ)² dx over the unit cube · random methods: root mean square of {repetitions} runs · \
         dashed: slope of theory · hollow: not fitted"
    );
    let style = Type::plain(TEXT, MUTED);
    canvas.text(&subtitle, [MARGIN, 92.0], Align::Left, style, inner);
    let panels = DIMENSIONS.len() as f32;
    let w = (inner - GAP * (panels - 1.0)) / panels;
    for (i, dimension) in DIMENSIONS.into_iter().enumerate() {
        let place = Area::new(MARGIN + i as f32 * (w + GAP), TOP, w, TALL);
        let plot = place.inside(LABELS, 0.0, 0.0, 0.0);
        let own: Vec<&Line> = lines.iter().filter(|l| l.dimension == dimension).collect();
        let word = if dimension == 1 {
            "dimension"
        } else {
            "dimensions"
        };
        canvas.text(
            &format!("{dimension} {word}"),
            [plot.x, TOP - 20.0],
            Align::Left,
            Type::bold(27.0),
            plot.w,
        );
        canvas.text(
            "error",
            [plot.x - 14.0, TOP - 20.0],
            Align::Right,
            style,
            LABELS,
        );
        let scale = Scale::new(plot, dimension);
        scale.grid(&mut canvas);
        for line in &own {
            scale.theory(&mut canvas, line);
        }
        for line in &own {
            scale.data(&mut canvas, line);
        }
        legend(
            &mut canvas,
            Area::new(place.x, TOP + TALL + 116.0, w, 0.0),
            &own,
        );
    }
    canvas
}

fn legend(canvas: &mut Canvas, place: Area, lines: &[&Line]) {
    let plain = Type::plain(TEXT, INK);
    let (slope, theory) = (place.x + place.w - 110.0, place.x + place.w - 8.0);
    let head = Type::plain(TEXT, MUTED);
    canvas.text("slope", [slope, place.y], Align::Right, head, 100.0);
    canvas.text("theory", [theory, place.y], Align::Right, head, 100.0);
    for (i, line) in lines.iter().enumerate() {
        let base = place.y + (i + 1) as f32 * ROW;
        let (middle, colour) = (base - 8.0, line.method.colour());
        canvas.segment(
            [place.x + 14.0, middle],
            [place.x + 62.0, middle],
            3.0,
            colour,
        );
        dot(canvas, [place.x + 38.0, middle], Use::Fitted, colour);
        canvas.text(
            line.method.name(),
            [place.x + LABELS, base],
            Align::Left,
            plain,
            240.0,
        );
        let fitted = signed(line.fit.slope, 2);
        canvas.text(
            &fitted,
            [slope, base],
            Align::Right,
            Type::bold(TEXT),
            100.0,
        );
        let rate = line.theory().to_string();
        canvas.text(&rate, [theory, base], Align::Right, plain, 100.0);
    }
}
