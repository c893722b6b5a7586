//! The picture of a distribution over an area: points over the shaded density, in true proportion,
//! with the image of a grid of the unit square, which tells apart two maps onto one density.

use microwarp::uniform::LARGEST;
use rand_pcg::Pcg32;
use support::draw::canvas::{Area, Canvas};
use support::draw::colour::{ACCENT, HAIR, MUTED, POINT, WHITE, faded, ramp};
use support::draw::text::{Align, Type};
use support::registry::picture::View;
use support::registry::{Domain, Entry, Point};
use support::truth::complements;

/// Squares along a side of the grid of the unit square.
pub const GRID: u32 = 8;

/// A way from points to paper and back; the paper reaches from -1 to 1, y upwards.
enum Paper {
    Plane {
        centre: [f64; 2],
        half: f64,
    },
    /// Lambert's projection, the rim at 2 sin(θ/2) = `rim`.
    Sky {
        rim: f64,
    },
    Triangle {
        matrix: [[f64; 3]; 2],
        corners: [[f64; 3]; 3],
        centre: [f64; 2],
        half: f64,
    },
    Faces(&'static [[[f64; 2]; 3]]),
}

fn apply(matrix: &[[f64; 3]; 2], p: [f64; 3]) -> [f64; 2] {
    matrix.map(|row| (0..3).map(|k| row[k] * p[k]).sum())
}

/// The barycentric coordinates of a point of a triangle; nothing for a point outside.
fn shares(p: [f64; 2], [a, b, c]: [[f64; 2]; 3]) -> Option<[f64; 3]> {
    let cross = |p: [f64; 2], q: [f64; 2], r: [f64; 2]| {
        (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
    };
    let of = [cross(p, b, c), cross(a, p, c), cross(a, b, p)].map(|part| part / cross(a, b, c));
    of.iter().all(|share| *share >= 0.0).then_some(of)
}

impl Paper {
    fn new(view: View, entry: &Entry) -> Self {
        match view {
            View::Plane { centre, half } => Self::Plane { centre, half },
            View::Sky(angle) => Self::Sky {
                rim: 2.0 * (0.5 * angle).sin(),
            },
            View::Triangle(matrix) => {
                // The corners of the unit square that are corners of the triangle: two of the four are the same one.
                let corner = |u, v| entry.truth.sample([u, v, 0.0, 0.0]);
                let [a, b] = [corner(0.0, 0.0), corner(1.0, 1.0)];
                let c = corner(1.0, 0.0);
                let corners = [a, b, if c == b { corner(0.0, 1.0) } else { c }];
                let flat = corners.map(|c| apply(&matrix, c));
                let span = [0, 1].map(|k| {
                    let low = flat.iter().map(|p| p[k]).fold(f64::INFINITY, f64::min);
                    let high = flat.iter().map(|p| p[k]).fold(f64::NEG_INFINITY, f64::max);
                    (0.5 * (low + high), 0.5 * (high - low))
                });
                let half = 1.03 * span[0].1.max(span[1].1);
                Self::Triangle {
                    matrix,
                    corners,
                    centre: span.map(|s| s.0),
                    half,
                }
            }
            View::Faces(faces) => Self::Faces(faces),
            _ => unreachable!("drawn elsewhere"),
        }
    }

    fn place(&self, point: [f64; 3]) -> [f64; 2] {
        match *self {
            Self::Plane { centre, half } => [0, 1].map(|k| (point[k] - centre[k]) / half),
            Self::Sky { rim } => {
                let (down, _) = complements(point);
                let sine = point[0].hypot(point[1]);
                let r = (2.0 * down).sqrt() / rim;
                if sine > 0.0 {
                    [point[0] / sine * r, point[1] / sine * r]
                } else {
                    [r, 0.0]
                }
            }
            Self::Triangle {
                ref matrix,
                centre,
                half,
                ..
            } => {
                let p = apply(matrix, point);
                [0, 1].map(|k| (p[k] - centre[k]) / half)
            }
            Self::Faces(faces) => {
                let Some([a, b, c]) = faces.get(point[0] as usize) else {
                    return [f64::NAN; 2]; // not to be seen
                };
                [0, 1].map(|k| a[k] + point[1] * (b[k] - a[k]) + point[2] * (c[k] - a[k]))
            }
        }
    }

    fn back(&self, paper: [f64; 2]) -> Option<Point> {
        let exact = match *self {
            Self::Plane { centre, half } => [
                centre[0] + half * paper[0],
                centre[1] + half * paper[1],
                0.0,
            ],
            Self::Sky { rim } => {
                let [x, y] = paper.map(|c| c * rim);
                let square = x * x + y * y;
                if square > rim * rim {
                    return None;
                }
                let stretch = (1.0 - 0.25 * square).sqrt();
                [x * stretch, y * stretch, 1.0 - 0.5 * square]
            }
            Self::Triangle {
                ref matrix,
                corners,
                centre,
                half,
            } => {
                let p = [0, 1].map(|k| centre[k] + half * paper[k]);
                let weights = shares(p, corners.map(|c| apply(matrix, c)))?;
                std::array::from_fn(|k| (0..3).map(|i| weights[i] * corners[i][k]).sum())
            }
            Self::Faces(faces) => {
                let found = |(k, face): (usize, &_)| Some((k, shares(paper, *face)?));
                let (k, [_, v, w]) = faces.iter().enumerate().find_map(found)?;
                [k as f64, v, w]
            }
        };
        Some(exact.map(|c| c as f32))
    }
}

/// Draws the picture in the middle of `area`; `unit` scales text and line widths.
pub fn draw(
    canvas: &mut Canvas,
    area: Area,
    view: View,
    entry: &Entry,
    rng: &mut Pcg32,
    points: usize,
    unit: f32,
) {
    let area = area.square();
    let paper = Paper::new(view, entry);
    let half = 0.5 * area.w;
    let centre = [area.x + half, area.y + half];
    let to_pixel = |p: [f64; 2]| {
        [
            centre[0] + half * p[0] as f32,
            centre[1] - half * p[1] as f32,
        ]
    };
    // A little more than the paper: rounding must not lose a line along the rim.
    let inside = |p: [f64; 2]| p.iter().all(|c| c.abs() <= 1.003);
    let place = |p: Point| {
        Some(paper.place(p.map(f64::from)))
            .filter(|p| inside(*p))
            .map(to_pixel)
    };

    let density = |x: f64, y: f64| paper.back([x, y]).map(|p| f64::from(entry.warp.pdf(p)));
    let lattice = || (0..=80).map(|i| f64::from(i) / 40.0 - 1.0);
    let peak = lattice()
        .flat_map(|x| lattice().filter_map(move |y| density(x, y)))
        .fold(0.0, f64::max);
    canvas.shade(area, |x, y| {
        let (x, y) = (
            f64::from((x - centre[0]) / half),
            f64::from((centre[1] - y) / half),
        );
        if x.abs() > 1.0 || y.abs() > 1.0 {
            return None;
        }
        density(x, y).filter(|d| *d > 0.0).map(|d| ramp(d / peak))
    });

    // The grid of the unit square, through the warp: a warp is a pure function of its uniforms.
    let place_u = |u: f64, v: f64| {
        let uniforms = [u, v, 0.0, 0.0].map(|u| (u as f32).min(LARGEST));
        place(entry.warp.sample(uniforms))
    };
    // Where the azimuth closes, its two ends are one line; other borders are those of the domain.
    let closed = match (place_u(0.5, 0.0), place_u(0.5, 1.0)) {
        (Some([x, y]), Some([x1, y1])) => (x - x1).hypot(y - y1) < 0.1,
        _ => false,
    };
    let steps = || (0..=256).map(|i| f64::from(i) / 256.0);
    for k in u32::from(!closed)..GRID {
        let fixed = f64::from(k) / f64::from(GRID);
        let white = faded(WHITE, 0.9);
        canvas.line(steps().map(|u| place_u(u, fixed)), 0.9 * unit, white);
        if k > 0 {
            canvas.line(steps().map(|v| place_u(fixed, v)), 0.9 * unit, white);
        }
    }

    for point in entry.warp.fill(rng, points) {
        if let Some(at) = place(point) {
            canvas.disc(at, 1.35 * unit, faded(POINT, 0.72));
        }
    }

    if let View::Sky(angle) = view {
        canvas.ring(centre, half - 0.5 * unit, 0.9 * unit, HAIR);
        // The rim's angle, where the square leaves room for it.
        let text = match angle.to_degrees() {
            degrees if degrees >= 10.0 => format!("{degrees:.0}°"),
            degrees if degrees >= 0.1 => format!("{degrees:.1}°"),
            _ => format!("{angle:.0e} rad").replace('-', "−"),
        };
        let at = [area.x + area.w, area.y + area.h - 2.0 * unit];
        canvas.text(
            &text,
            at,
            Align::Right,
            Type::plain(14.0 * unit, MUTED),
            half,
        );
    }
    if entry.domain == Domain::World {
        // The first uniforms give the axis of the lobe.
        if let Some(at) = place_u(0.0, 0.0) {
            canvas.disc(at, 4.2 * unit, WHITE);
            canvas.disc(at, 3.0 * unit, ACCENT);
        }
    }
}
