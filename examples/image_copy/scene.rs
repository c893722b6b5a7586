//! The picture that is copied, from formulas: three spheres on a chequered floor at dusk. It has smooth
//! gradients, detail finer than a pixel, highlights many times as bright as the rest, and black that is 0.

/// Columns, rows.
pub const SHAPE: [usize; 2] = [256, 192];
/// Rays along each side of a pixel.
const FINE: usize = 4;

type Vector = [f64; 3];

struct Sphere {
    centre: Vector,
    radius: f64,
    colour: Vector,
    /// How much of what is seen is a reflection.
    mirror: f64,
}

const SPHERES: [Sphere; 3] = [
    Sphere {
        centre: [-1.75, 1.0, 0.35],
        radius: 1.0,
        colour: [0.78, 0.10, 0.07],
        mirror: 0.12,
    },
    Sphere {
        centre: [0.55, 1.2, 1.5],
        radius: 1.2,
        colour: [0.10, 0.11, 0.12],
        mirror: 0.75,
    },
    Sphere {
        centre: [1.75, 0.62, -0.75],
        radius: 0.62,
        colour: [0.08, 0.42, 0.52],
        mirror: 0.14,
    },
];
const EYE: Vector = [0.0, 2.0, -6.6];
/// Where the middle of the picture looks, and how wide it is at a distance of 1.
const AIM: Vector = [0.12, 0.92, 0.6];
const FIELD: f64 = 0.98;
const LAMP: Vector = [-0.52, 0.70, -0.49];

/// The texels, row by row.
pub fn picture() -> Vec<[f32; 3]> {
    let [columns, rows] = SHAPE;
    let forward = unit(sub(AIM, EYE));
    let right = unit([forward[2], 0.0, -forward[0]]);
    let up = cross(forward, right);
    let mut texels = Vec::with_capacity(columns * rows);
    for row in 0..rows {
        for column in 0..columns {
            let mut sum = [0.0; 3];
            for k in 0..FINE * FINE {
                let fine = |place: usize, k: usize| place as f64 + (k as f64 + 0.5) / FINE as f64;
                let across = FIELD * (fine(column, k % FINE) / columns as f64 - 0.5);
                let down = FIELD * (fine(row, k / FINE) - 0.5 * rows as f64) / columns as f64;
                let ray = add(add(forward, scaled(right, across)), scaled(up, -down));
                sum = add(sum, light(EYE, unit(ray), 2));
            }
            texels.push(scaled(sum, 1.0 / (FINE * FINE) as f64).map(|c| c as f32));
        }
    }
    texels
}

/// What comes from a direction.
fn light(from: Vector, ray: Vector, reflections: u32) -> Vector {
    let nearest = SPHERES
        .iter()
        .filter_map(|sphere| Some((distance(sphere, from, ray)?, sphere)))
        .min_by(|a, b| a.0.total_cmp(&b.0));
    if let Some((t, sphere)) = nearest {
        let at = add(from, scaled(ray, t));
        return shaded(sphere, at, ray, reflections);
    }
    if ray[1] < 0.0 {
        return floor(add(from, scaled(ray, -from[1] / ray[1])));
    }
    sky(ray[1])
}

fn distance(sphere: &Sphere, from: Vector, ray: Vector) -> Option<f64> {
    let to = sub(sphere.centre, from);
    let along = dot(to, ray);
    let square = sphere.radius * sphere.radius - dot(to, to) + along * along;
    let near = along - square.max(0.0).sqrt();
    (square > 0.0 && near > 1e-6).then_some(near)
}

/// A gloss over a colour, with a highlight of the lamp.
fn shaded(sphere: &Sphere, at: Vector, ray: Vector, reflections: u32) -> Vector {
    let normal = scaled(sub(at, sphere.centre), 1.0 / sphere.radius);
    let lit = dot(normal, unit(LAMP)).max(0.0) * seen_by_lamp(at);
    let ambient = 0.10 * (1.0 + normal[1]);
    let bounced = sub(ray, scaled(normal, 2.0 * dot(ray, normal)));
    let mut sum = scaled(sphere.colour, ambient + 0.9 * lit);
    if reflections > 0 {
        let edge = (1.0 + dot(ray, normal)).powi(5);
        let mirror = sphere.mirror + (1.0 - sphere.mirror) * edge * 0.6;
        sum = add(sum, scaled(light(at, bounced, reflections - 1), mirror));
    }
    let highlight = dot(bounced, unit(LAMP)).max(0.0).powi(220);
    add(sum, scaled([1.0, 0.93, 0.80], 11.0 * highlight))
}

fn seen_by_lamp(at: Vector) -> f64 {
    let free = |sphere| distance(sphere, at, unit(LAMP)).is_none();
    if SPHERES.iter().all(free) { 1.0 } else { 0.0 }
}

/// Every other square is black; the others fade into a black distance.
fn floor(at: Vector) -> Vector {
    let even = (at[0].floor() + at[2].floor()).rem_euclid(2.0) < 0.5;
    let far = at[0].hypot(at[2] - 1.0);
    if even || far > 34.0 {
        return [0.0; 3];
    }
    let fade = (1.0 - far / 34.0).powi(2);
    let lamp = 0.14 + 0.86 * seen_by_lamp(at);
    scaled([0.86, 0.80, 0.70], 1.1 * fade * lamp)
}

/// From black above to the last of the daylight below.
fn sky(height: f64) -> Vector {
    let low = (1.0 - height / 0.42).clamp(0.0, 1.0);
    let blue = scaled([0.05, 0.13, 0.42], low);
    let glow = scaled([1.15, 0.48, 0.14], low.powi(7));
    add(blue, glow)
}

fn add(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|k| a[k] + b[k])
}

fn sub(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|k| a[k] - b[k])
}

fn scaled(a: Vector, by: f64) -> Vector {
    a.map(|c| by * c)
}

fn dot(a: Vector, b: Vector) -> f64 {
    (0..3).map(|k| a[k] * b[k]).sum()
}

fn cross(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|k| a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3])
}

fn unit(a: Vector) -> Vector {
    scaled(a, 1.0 / dot(a, a).sqrt())
}
