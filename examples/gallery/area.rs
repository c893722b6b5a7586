//! The picture of a distribution over an area: points over the shaded density, in true proportion,
//! with the image of a grid of the unit square, which tells apart two maps onto one density.

use host::draw::canvas::{Area, Canvas};
use host::draw::colour::{ACCENT, HAIR, MUTED, POINT, WHITE, faded, ramp};
use host::draw::scale::ten_to;
use host::draw::text::{Align, Type};
use host::registry::picture::{Body, Face, View};
use host::registry::{Domain, Entry, Point};
use host::truth::{complements, dot};
use microwarp::uniform::LARGEST;
use rand_pcg::Pcg32;
use std::f64::consts::FRAC_1_SQRT_2;

/// Squares along a side of the grid of the unit square.
pub const GRID: u32 = 8;

/// A way from points to paper and back; the paper reaches from -1 to 1, y upwards.
pub enum Paper {
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
    Net(&'static [Face], f64),
    Solid {
        body: Body,
        centre: [f64; 2],
        half: f64,
    },
}

/// Where the eye is that sees a solid, and its paper's axes.
const EYE: [f64; 3] = [0.577_350, 0.577_350, 0.577_350];
const SEEN: [[f64; 3]; 2] = [
    [-FRAC_1_SQRT_2, FRAC_1_SQRT_2, 0.0],
    [-0.408_248, -0.408_248, 0.816_497],
];

fn apply(matrix: &[[f64; 3]; 2], p: [f64; 3]) -> [f64; 2] {
    matrix.map(|row| dot(row, p))
}

fn moved(p: [f64; 3], along: [f64; 3], way: f64) -> [f64; 3] {
    [0, 1, 2].map(|k| p[k] + way * along[k])
}

/// The middle of points on paper, and how far they reach from it.
fn span(points: &[[f64; 2]]) -> ([f64; 2], f64) {
    let ends = [0, 1].map(|k| {
        let all = || points.iter().map(|p| p[k]);
        let (low, high) = (
            all().fold(f64::INFINITY, f64::min),
            all().fold(f64::NEG_INFINITY, f64::max),
        );
        (0.5 * (low + high), 0.5 * (high - low))
    });
    (ends.map(|e| e.0), 1.03 * ends[0].1.max(ends[1].1))
}

/// The barycentric coordinates of a point of a triangle; nothing for a point outside.
fn shares(p: [f64; 2], [a, b, c]: [[f64; 2]; 3]) -> Option<[f64; 3]> {
    let cross = |p: [f64; 2], q: [f64; 2], r: [f64; 2]| {
        (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
    };
    let of = [cross(p, b, c), cross(a, p, c), cross(a, b, p)].map(|part| part / cross(a, b, c));
    of.iter().all(|share| *share >= 0.0).then_some(of)
}

/// The lengths of a face's sides.
fn lengths(face: &Face) -> [f64; 2] {
    face.sides.map(|side| dot(side, side).sqrt())
}

impl Paper {
    pub fn new(view: View, entry: &Entry) -> Self {
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
                let (centre, half) = span(&corners.map(|c| apply(&matrix, c)));
                Self::Triangle {
                    matrix,
                    corners,
                    centre,
                    half,
                }
            }
            View::Faces(faces) => Self::Faces(faces),
            View::Net(faces, half) => Self::Net(faces, half),
            View::Solid(body) => {
                let parts = || (0..=32).map(|i| f64::from(i) / 32.0);
                let all = parts().flat_map(|u| parts().map(move |v| [u, v, 0.0, 0.0]));
                let all: Vec<_> = all.map(|u| apply(&SEEN, entry.truth.sample(u))).collect();
                let (centre, half) = span(&all);
                Self::Solid { body, centre, half }
            }
            _ => unreachable!("drawn elsewhere"),
        }
    }

    pub fn place(&self, point: [f64; 3]) -> [f64; 2] {
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
            Self::Solid { centre, half, .. } => {
                let p = apply(&SEEN, point);
                [0, 1].map(|k| (p[k] - centre[k]) / half)
            }
            Self::Faces(faces) => {
                let Some([a, b, c]) = faces.get(point[0] as usize) else {
                    return [f64::NAN; 2]; // not to be seen
                };
                [0, 1].map(|k| a[k] + point[1] * (b[k] - a[k]) + point[2] * (c[k] - a[k]))
            }
            Self::Net(faces, half) => {
                let on = |face: &Face| {
                    let from = moved(point, face.corner, -1.0);
                    let parts = face.sides.map(|side| dot(from, side) / dot(side, side));
                    let left = moved(
                        moved(from, face.sides[0], -parts[0]),
                        face.sides[1],
                        -parts[1],
                    );
                    let lies = dot(left, left) < 1e-9
                        && parts.iter().all(|t| (t - 0.5).abs() < 0.5 + 1e-5);
                    let lengths = lengths(face);
                    lies.then(|| [0, 1].map(|k| (face.at[k] + parts[k] * lengths[k]) / half))
                };
                faces.iter().find_map(on).unwrap_or([f64::NAN; 2])
            }
        }
    }

    /// The cosine at which the eye sees the surface in a point; negative on the far side of a solid.
    pub fn facing(&self, point: [f64; 3]) -> f64 {
        match *self {
            Self::Solid { body, .. } => {
                const STEP: f64 = 1e-4;
                (body.distance(moved(point, EYE, STEP)) - body.distance(point)) / STEP
            }
            _ => 1.0,
        }
    }

    pub fn back(&self, paper: [f64; 2]) -> Option<Point> {
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
            Self::Net(faces, half) => {
                let on = |face: &Face| {
                    let lengths = lengths(face);
                    let parts = [0, 1].map(|k| (paper[k] * half - face.at[k]) / lengths[k]);
                    let point = moved(
                        moved(face.corner, face.sides[0], parts[0]),
                        face.sides[1],
                        parts[1],
                    );
                    parts
                        .iter()
                        .all(|t| (0.0..=1.0).contains(t))
                        .then_some(point)
                };
                faces.iter().find_map(on)?
            }
            Self::Solid { body, centre, half } => {
                let p = [0, 1].map(|k| centre[k] + half * paper[k]);
                // From before the solid towards its far side, as far as nothing can be nearer.
                let start = moved(moved([0.0; 3], SEEN[0], p[0]), SEEN[1], p[1]);
                let (mut way, mut left) = (8.0, f64::INFINITY);
                while left > 1e-9 && way > -8.0 {
                    left = body.distance(moved(start, EYE, way));
                    way -= left;
                }
                if left > 1e-9 {
                    return None;
                }
                // What lies on a disk lies on it exactly.
                moved(start, EYE, way).map(|c| (c * 1e7).round() / 1e7)
            }
        };
        Some(exact.map(|c| c as f32))
    }

    /// The density of what is seen at a place on paper; nothing outside the domain.
    pub fn density(&self, entry: &Entry, paper: [f64; 2]) -> Option<f64> {
        let point = self.back(paper)?;
        let density = f64::from(entry.warp.pdf(point));
        (density > 0.0 && (entry.inside)(point.map(f64::from))).then_some(density)
    }
}

/// How dark the faintest density is drawn, so that the domain is seen.
const FAINT: f64 = 0.07;

/// The square of the picture: points on its rim are inside the area as well.
fn within(area: Area, unit: f32) -> Area {
    let rim = 1.5 * unit;
    area.inside(rim, rim, rim, rim).square()
}

/// The frame of a picture in an area: the rim of directions, or a square.
pub fn outline(view: View, area: Area, unit: f32) -> Vec<Option<[f32; 2]>> {
    let area = within(area, unit);
    let half = 0.5 * area.w;
    let centre = [area.x + half, area.y + half];
    let round = matches!(view, View::Sky(_));
    let at = |k: usize| {
        let (s, c) = (k as f32 * std::f32::consts::TAU / 256.0).sin_cos();
        let stretch = if round {
            1.0
        } else {
            1.0 / s.abs().max(c.abs())
        };
        let r = (half - 0.5 * unit) * stretch;
        Some([centre[0] + r * c, centre[1] + r * s])
    };
    (0..=256).map(at).collect()
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
    let frame = outline(view, area, unit);
    let area = within(area, unit);
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
        let p = p.map(f64::from);
        let at = Some(paper.place(p)).filter(|at| inside(*at));
        at.map(|at| (to_pixel(at), paper.facing(p)))
    };

    let lattice = || (0..=80).map(|i| f64::from(i) / 40.0 - 1.0);
    let peak = lattice()
        .flat_map(|x| {
            lattice()
                .filter_map(|y| paper.density(entry, [x, y]))
                .collect::<Vec<_>>()
        })
        .fold(0.0, f64::max);
    let shade = |x: f32, y: f32| {
        let at = [(x - centre[0]) / half, (centre[1] - y) / half].map(f64::from);
        let density = Some(at).filter(|at| at.iter().all(|c| c.abs() <= 1.0));
        let density = density.and_then(|at| paper.density(entry, at))?;
        let light = 0.75 + 0.25 * paper.facing(paper.back(at)?.map(f64::from));
        Some(ramp(FAINT + (1.0 - FAINT) * density / peak).map(|c| c * light))
    };
    canvas.shade(area, shade);

    // The grid of the unit square, through the warp: a warp is a pure function of its uniforms.
    let place_u = |u: f64, v: f64| {
        let uniforms = [u, v, 0.0, 0.0].map(|u| (u as f32).min(LARGEST));
        let seen = place(entry.warp.sample(uniforms)).filter(|(_, facing)| *facing > 0.0);
        seen.map(|(at, _)| at)
    };
    // Where the azimuth closes, its two ends are one line; other borders are those of the domain.
    let closed = match (place_u(0.5, 0.0), place_u(0.5, 1.0)) {
        (Some([x, y]), Some([x1, y1])) => (x - x1).hypot(y - y1) < 0.1,
        _ => false,
    };
    // From face to face no line is drawn.
    let far = |a: Option<[f32; 2]>, b: Option<[f32; 2]>| match (a, b) {
        (Some([x0, y0]), Some([x, y])) => (x - x0).hypot(y - y0) > 0.1 * area.w,
        _ => false,
    };
    let line = |at: &dyn Fn(f64) -> Option<[f32; 2]>| {
        let places: Vec<_> = (0..=256).map(|i| at(f64::from(i) / 256.0)).collect();
        let mut line = places[..1].to_vec();
        for pair in places.windows(2) {
            line.extend(far(pair[0], pair[1]).then_some(None));
            line.push(pair[1]);
        }
        line
    };
    // Of more than two uniforms it would be a surface in space.
    for k in u32::from(!closed)..if entry.uniforms == 2 { GRID } else { 0 } {
        let fixed = f64::from(k) / f64::from(GRID);
        let white = faded(WHITE, 0.9);
        canvas.line(line(&|u| place_u(u, fixed)), 0.9 * unit, white);
        if k > 0 {
            canvas.line(line(&|v| place_u(fixed, v)), 0.9 * unit, white);
        }
    }
    if let View::Net(faces, half) = view {
        for face in faces {
            let [w, h] = lengths(face);
            let corners = [[0.0, 0.0], [w, 0.0], [w, h], [0.0, h], [0.0, 0.0]];
            let edge = corners.map(|c| Some(to_pixel([0, 1].map(|k| (face.at[k] + c[k]) / half))));
            canvas.line(edge, 0.9 * unit, faded(POINT, 0.6));
        }
    }

    for point in entry.warp.fill(rng, points) {
        if let Some((at, facing)) = place(point) {
            // What lies behind is paler.
            let opacity = if facing > 0.0 { 0.72 } else { 0.2 };
            canvas.disc(at, 1.35 * unit, faded(POINT, opacity));
        }
    }

    if let View::Sky(angle) = view {
        // The rim's angle, where the square leaves room for it.
        let text = match angle.to_degrees() {
            degrees if degrees >= 10.0 => format!("{degrees:.0}°"),
            degrees if degrees >= 0.1 => format!("{degrees:.1}°"),
            _ => format!("{} rad", ten_to(angle.log10().round() as i32)),
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
    canvas.line(frame, 0.9 * unit, HAIR);
    if entry.domain == Domain::World {
        // The first uniforms give the axis of the lobe.
        if let Some(at) = place_u(0.0, 0.0) {
            canvas.disc(at, 4.2 * unit, WHITE);
            canvas.disc(at, 3.0 * unit, ACCENT);
        }
    }
}
