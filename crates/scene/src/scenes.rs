//! Six scenes. Each is a constant, so that a core keeps it in flash.

use crate::camera::Camera;
use crate::fog::{Clear, Haze};
use crate::light::{Choice, Lamp};
use crate::material::{Any, Glossy, Matte, Metal};
use crate::path::Scene;
use crate::shape::{Quad, Sphere};
use crate::sky::{COLUMNS, NoSky, ROWS, Sky, Table};
use crate::vector::{Vector, dot, plus, scaled};
use core::f32::consts::PI;
use core::marker::PhantomData;
use microwarp::constant;
use microwarp::discrete::{Cdf, LatLongMap};
use microwarp::tier::Tier;

/// A lamp that sends light down: its corner of smallest x and y, and its sides.
const fn lamp(corner: Vector, [x, y]: [f32; 2], radiance: Vector) -> Lamp<Quad> {
    let shape = Quad::new(corner, [[0.0, y, 0.0], [x, 0.0, 0.0]]);
    Lamp { shape, radiance }
}

const fn ball(centre: Vector, radius: f32) -> Sphere {
    Sphere { centre, radius }
}

/// The one light of a scene.
static ONE: Cdf<[u32; 1]> = constant!(Cdf::new(&[1.0]));

/// A matte room below a lamp.
pub mod room {
    use super::*;

    pub const CAMERA: Camera = Camera {
        eye: [0.0, -3.4, 1.0],
        target: [0.0, 1.0, 0.97],
        spread: 0.425,
        lens: 0.02,
        blades: 6,
        focus: 4.6,
    };

    static LAMPS: Cdf<[u32; 2]> = constant!(Cdf::new(&[3.0, 1.0]));

    pub const SCENE: Scene<'static, Matte, Lamp<Quad>, NoSky, Clear> = Scene {
        quads: &[
            (
                &[
                    Quad::new([-1.5, 0.0, 0.0], [[3.0, 0.0, 0.0], [0.0, 3.0, 0.0]]),
                    Quad::new([-1.5, 0.0, 2.0], [[3.0, 0.0, 0.0], [0.0, 3.0, 0.0]]),
                    Quad::new([-1.5, 3.0, 0.0], [[3.0, 0.0, 0.0], [0.0, 0.0, 2.0]]),
                ],
                Matte([0.76, 0.74, 0.70]),
            ),
            (
                &[Quad::new(
                    [-1.5, 0.0, 0.0],
                    [[0.0, 3.0, 0.0], [0.0, 0.0, 2.0]],
                )],
                Matte([0.70, 0.24, 0.12]),
            ),
            (
                &[Quad::new(
                    [1.5, 0.0, 0.0],
                    [[0.0, 3.0, 0.0], [0.0, 0.0, 2.0]],
                )],
                Matte([0.10, 0.36, 0.40]),
            ),
            (
                &Quad::cuboid([-0.62, 1.9, 0.0], [0.36, 0.13], 1.0, 1.15),
                Matte([0.58, 0.46, 0.60]),
            ),
            (
                &Quad::cuboid([0.62, 1.15, 0.0], [0.36, -0.12], 1.0, 0.5),
                Matte([0.78, 0.60, 0.24]),
            ),
        ],
        spheres: &[
            (ball([0.62, 1.15, 0.78], 0.28), Matte([0.80, 0.80, 0.80])),
            (ball([-0.42, 0.85, 0.22], 0.22), Matte([0.30, 0.44, 0.66])),
        ],
        lights: &[
            lamp([-0.55, 1.1, 1.995], [1.1, 0.7], [9.0, 8.2, 7.0]),
            // A window in the left wall.
            Lamp {
                shape: Quad::new([-1.495, 0.9, 0.95], [[0.0, 0.7, 0.0], [0.0, 0.0, 0.55]]),
                radiance: [4.0, 5.2, 7.0],
            },
        ],
        choice: Choice::of(LAMPS.view()),
        sky: NoSky,
        fog: Clear,
    };
}

/// Glossy balls in fog, with three lamps in it.
pub mod fog {
    use super::*;

    pub const CAMERA: Camera = Camera {
        eye: [0.0, -4.6, 1.35],
        target: [0.0, 0.0, 0.72],
        spread: 0.46,
        lens: 0.04,
        blades: 5,
        focus: 4.5,
    };

    static LAMPS: Cdf<[u32; 3]> = constant!(Cdf::new(&[3.0, 2.0, 2.0]));

    pub const SCENE: Scene<'static, Any, Lamp<Sphere>, NoSky, Haze> = Scene {
        quads: &[
            (
                &[Quad::new(
                    [-6.0, -6.0, 0.0],
                    [[12.0, 0.0, 0.0], [0.0, 12.0, 0.0]],
                )],
                Any::Glossy(Glossy {
                    ground: [0.10, 0.10, 0.11],
                    coat: 0.30,
                    exponent: 120.0,
                }),
            ),
            (
                &[Quad::new(
                    [-6.0, 4.0, 0.0],
                    [[12.0, 0.0, 0.0], [0.0, 0.0, 6.0]],
                )],
                Any::Matte(Matte([0.30, 0.32, 0.36])),
            ),
        ],
        spheres: &[
            (
                ball([-1.25, 0.2, 0.62], 0.62),
                Any::Metal(Metal {
                    colour: [1.0, 0.78, 0.34],
                    roughness: 0.22,
                }),
            ),
            (
                ball([0.05, -0.45, 0.42], 0.42),
                Any::Glossy(Glossy {
                    ground: [0.55, 0.05, 0.05],
                    coat: 0.25,
                    exponent: 300.0,
                }),
            ),
            (
                ball([1.25, 0.35, 0.55], 0.55),
                Any::Metal(Metal {
                    colour: [0.72, 0.80, 0.90],
                    roughness: 0.14,
                }),
            ),
        ],
        lights: &[
            Lamp {
                shape: ball([0.1, 1.5, 2.0], 0.20),
                radiance: [47.0, 39.0, 29.0],
            },
            Lamp {
                shape: ball([-2.4, -0.9, 1.5], 0.16),
                radiance: [11.0, 27.0, 47.0],
            },
            Lamp {
                shape: ball([2.5, -0.9, 1.3], 0.16),
                radiance: [47.0, 18.0, 9.4],
            },
        ],
        choice: Choice::of(LAMPS.view()),
        sky: NoSky,
        fog: Haze {
            density: 0.12,
            albedo: 0.96,
            asymmetry: 0.55,
        },
    };
}

/// An evening sky over slivers of brass.
pub mod slivers {
    use super::*;

    pub const CAMERA: Camera = Camera {
        eye: [0.3, -5.2, 1.25],
        target: [0.0, 0.0, 0.86],
        spread: 0.46,
        lens: 0.05,
        blades: 7,
        focus: 5.1,
    };

    /// A low sun behind the slivers, on the left; a unit vector.
    pub const SUN: Vector = [-0.60, 0.72, 0.348_711_9];
    /// Colours of the sky, above and at the horizon, of the glow about the sun and of its disc.
    pub const ZENITH: Vector = [0.16, 0.30, 0.62];
    pub const HORIZON: Vector = [1.05, 0.62, 0.34];
    pub const GLOW: Vector = [1.0, 0.62, 0.30];
    pub const DISC: Vector = [1.0, 0.74, 0.45];
    /// How bright the glow is and the middle of the disc, and 1 less the cosine of its radius, 4.5 degrees.
    pub const HALO: f32 = 0.9;
    pub const PEAK: f32 = 150.0;
    pub const WIDTH: f32 = 0.003;

    /// The evening: orange at the horizon, blue above, and a sun with a halo.
    #[derive(Clone, Copy, Debug)]
    pub struct Evening;

    /// Light from a direction.
    const fn radiance(direction: Vector) -> Vector {
        let [_, _, z] = direction;
        let height = if z > 0.0 { z } else { 0.0 };
        let low = (1.0 - height) * (1.0 - height);
        let low = low * low;
        let sky = plus(scaled(ZENITH, 1.0 - low), scaled(HORIZON, low));
        let cosine = dot(direction, SUN);
        let halo = if cosine > 0.0 { cosine * cosine } else { 0.0 };
        let halo = halo * halo * halo * halo;
        // Brightest in the middle, and dark beyond its width.
        let within = 1.0 - (1.0 - cosine) / WIDTH;
        let sun = if within > 0.0 { PEAK * within } else { 0.0 };
        let glow = scaled(GLOW, HALO * halo);
        plus(plus(sky, glow), scaled(DISC, sun))
    }

    /// sin(πx) for x from 0 to 1, by its series about the nearer end, to 4e-6: what the table needs of it.
    const fn sine(x: f32) -> f32 {
        let x = PI * if x < 0.5 { x } else { 1.0 - x };
        let s = x * x;
        x * (1.0 - s * (1.0 / 6.0 - s * (1.0 / 120.0 - s * (1.0 / 5040.0 - s * (1.0 / 362_880.0)))))
    }

    const fn sine_of_turn(t: f32) -> f32 {
        if t < 0.5 {
            sine(2.0 * t)
        } else {
            -sine(2.0 * t - 1.0)
        }
    }

    const fn quarter_on(t: f32) -> f32 {
        if t < 0.75 { t + 0.25 } else { t - 0.75 }
    }

    /// The mean brightness of a pixel, over four by four places.
    const fn weight(column: usize, row: usize) -> f32 {
        let (mut sum, mut k) = (0.0, 0_usize);
        while k < 16 {
            let (i, j) = (k & 3, k >> 2);
            let turn = (column as f32 + 0.25 * i as f32 + 0.125) / COLUMNS as f32;
            let down = (row as f32 + 0.25 * j as f32 + 0.125) / ROWS as f32;
            let flat = sine(down);
            let z = if down < 0.5 {
                sine(0.5 - down)
            } else {
                -sine(down - 0.5)
            };
            let direction = [
                flat * sine_of_turn(quarter_on(turn)),
                flat * sine_of_turn(turn),
                z,
            ];
            let [r, g, b] = radiance(direction);
            sum += r + g + b;
            k = k.wrapping_add(1);
        }
        sum
    }

    const WEIGHTS: [[f32; COLUMNS]; ROWS] = {
        let mut weights = [[0.0; COLUMNS]; ROWS];
        let (mut rows, mut row): (&mut [[f32; COLUMNS]], usize) = (&mut weights, 0);
        while let [first, others @ ..] = rows {
            let (mut pixels, mut column): (&mut [f32], usize) = (first, 0);
            while let [pixel, more @ ..] = pixels {
                *pixel = weight(column, row);
                column = column.wrapping_add(1);
                pixels = more;
            }
            row = row.wrapping_add(1);
            rows = others;
        }
        weights
    };

    struct Tables<T>(PhantomData<T>);

    impl<T: Tier> Tables<T> {
        const TABLE: Table<T> = constant!(LatLongMap::new(&WEIGHTS));
    }

    impl Sky for Evening {
        fn radiance(&self, direction: Vector) -> Vector {
            radiance(direction)
        }

        fn table<T: Tier>(&self) -> Option<&Table<T>> {
            Some(&Tables::<T>::TABLE)
        }
    }

    /// So many blades in a row that is bent, each leaning a little and of its own height.
    const fn blades<const N: usize>() -> [Quad; N] {
        let mut quads = [Quad::new([0.0; 3], [[0.0; 3]; 2]); N];
        let (mut rest, mut i): (&mut [Quad], u32) = (&mut quads, 0);
        while let [first, others @ ..] = rest {
            let x = i as f32 / (N as f32 - 1.0);
            // Numbers without an order, from 0 to 1.
            let a = (i.wrapping_mul(0x9e37_79b9) >> 16) as f32 / 65_536.0;
            let b = (i.wrapping_mul(0x85eb_ca6b) >> 16) as f32 / 65_536.0;
            let foot = [-2.5 + 5.0 * x, 1.5 - 1.7 * sine(x) + 0.5 * b, 0.0];
            let up = [
                0.34 * (a - 0.5),
                0.2 * (b - 0.5),
                1.0 + 0.55 * a + 0.35 * sine(x),
            ];
            *first = Quad::new(foot, [[0.028, 0.028 * (b - 0.5), 0.0], up]);
            rest = others;
            i = i.wrapping_add(1);
        }
        quads
    }

    pub const SCENE: Scene<'static, Any, Lamp<Quad>, Evening, Clear> = Scene {
        quads: &[
            (
                &[Quad::new(
                    [-40.0, -8.0, 0.0],
                    [[80.0, 0.0, 0.0], [0.0, 70.0, 0.0]],
                )],
                Any::Matte(Matte([0.36, 0.33, 0.30])),
            ),
            (
                &blades::<42>(),
                Any::Metal(Metal {
                    colour: [0.95, 0.68, 0.32],
                    roughness: 0.25,
                }),
            ),
        ],
        spheres: &[
            (
                ball([0.15, 0.7, 0.5], 0.5),
                Any::Metal(Metal {
                    colour: [0.90, 0.90, 0.92],
                    roughness: 0.05,
                }),
            ),
            (
                ball([-1.15, 0.9, 0.26], 0.26),
                Any::Matte(Matte([0.70, 0.28, 0.20])),
            ),
            (
                ball([1.35, 0.55, 0.34], 0.34),
                Any::Matte(Matte([0.24, 0.42, 0.46])),
            ),
        ],
        lights: &[],
        choice: Choice::of(ONE.view()),
        sky: Evening,
        fog: Clear,
    };
}

/// A dark room, lit through a slit in its wall.
pub mod slit {
    use super::*;

    pub const CAMERA: Camera = Camera {
        eye: [1.35, 0.25, 1.35],
        target: [-0.35, 3.6, 0.8],
        spread: 0.66,
        lens: 0.01,
        blades: 6,
        focus: 3.2,
    };

    const WHITE: Matte = Matte([0.78, 0.76, 0.72]);

    pub const SCENE: Scene<'static, Matte, Lamp<Quad>, NoSky, Clear> = Scene {
        quads: &[
            (
                &[
                    // Floor and ceiling of both rooms, and what is behind the camera.
                    Quad::new([-2.0, 0.0, 0.0], [[4.0, 0.0, 0.0], [0.0, 6.0, 0.0]]),
                    Quad::new([-2.0, 0.0, 2.4], [[4.0, 0.0, 0.0], [0.0, 6.0, 0.0]]),
                    Quad::new([-2.0, 0.0, 0.0], [[4.0, 0.0, 0.0], [0.0, 0.0, 2.4]]),
                    Quad::new([2.0, 0.0, 0.0], [[0.0, 6.0, 0.0], [0.0, 0.0, 2.4]]),
                    Quad::new([-2.0, 6.0, 0.0], [[4.0, 0.0, 0.0], [0.0, 0.0, 2.4]]),
                    // The wall with the slit.
                    Quad::new([-2.0, 4.0, 0.0], [[1.92, 0.0, 0.0], [0.0, 0.0, 2.4]]),
                    Quad::new([0.08, 4.0, 0.0], [[1.92, 0.0, 0.0], [0.0, 0.0, 2.4]]),
                    Quad::new([-0.08, 4.0, 2.0], [[0.16, 0.0, 0.0], [0.0, 0.0, 0.4]]),
                ],
                WHITE,
            ),
            (
                &[Quad::new(
                    [-2.0, 0.0, 0.0],
                    [[0.0, 6.0, 0.0], [0.0, 0.0, 2.4]],
                )],
                Matte([0.62, 0.30, 0.16]),
            ),
            (
                &Quad::cuboid([0.95, 3.25, 0.0], [0.32, 0.1], 1.0, 0.9),
                Matte([0.32, 0.46, 0.56]),
            ),
        ],
        spheres: &[
            (ball([-0.62, 2.75, 0.36], 0.36), Matte([0.82, 0.80, 0.76])),
            (ball([0.95, 3.25, 1.15], 0.25), Matte([0.76, 0.56, 0.20])),
        ],
        lights: &[Lamp {
            shape: Quad::new([0.4, 5.9, 1.5], [[0.9, 0.0, 0.0], [0.0, 0.0, 0.7]]),
            radiance: [330.0, 290.0, 230.0],
        }],
        choice: Choice::of(ONE.view()),
        sky: NoSky,
        fog: Clear,
    };
}

/// A range sensor, lamp and lens side by side, in a hall with fog: for those who do not render. Film: [`Echo`](crate::Echo).
pub mod sensor {
    use super::*;

    pub const CAMERA: Camera = Camera {
        eye: [0.0, 0.0, 1.1],
        target: [0.0, 6.0, 1.0],
        spread: 0.60,
        lens: 0.01,
        blades: 6,
        focus: 5.0,
    };

    pub const SCENE: Scene<'static, Matte, Lamp<Sphere>, NoSky, Haze> = Scene {
        quads: &[
            (
                &[
                    Quad::new([-5.0, -1.0, 0.0], [[10.0, 0.0, 0.0], [0.0, 13.0, 0.0]]),
                    Quad::new([-5.0, 12.0, 0.0], [[10.0, 0.0, 0.0], [0.0, 0.0, 5.0]]),
                    Quad::new([-5.0, -1.0, 0.0], [[0.0, 13.0, 0.0], [0.0, 0.0, 5.0]]),
                    Quad::new([5.0, -1.0, 0.0], [[0.0, 13.0, 0.0], [0.0, 0.0, 5.0]]),
                ],
                Matte([0.5; 3]),
            ),
            (
                &Quad::cuboid([-1.7, 3.2, 0.0], [0.2, 0.05], 1.0, 2.6),
                Matte([0.6; 3]),
            ),
            (
                &Quad::cuboid([-2.2, 6.2, 0.0], [0.25, 0.05], 1.0, 3.4),
                Matte([0.6; 3]),
            ),
            (
                &Quad::cuboid([2.3, 4.6, 0.0], [0.5, 0.3], 1.0, 0.9),
                Matte([0.3; 3]),
            ),
            // One who stands in the hall.
            (
                &Quad::cuboid([0.55, 3.6, 0.0], [0.22, 0.08], 0.5, 1.35),
                Matte([0.4; 3]),
            ),
        ],
        spheres: &[
            (ball([0.55, 3.6, 1.52], 0.15), Matte([0.6; 3])),
            (ball([-0.5, 5.2, 0.5], 0.5), Matte([0.7; 3])),
            (ball([2.3, 4.6, 1.25], 0.35), Matte([0.8; 3])),
        ],
        lights: &[Lamp {
            shape: ball([0.5, -0.4, 1.6], 0.20),
            radiance: [150.0; 3],
        }],
        choice: Choice::of(ONE.view()),
        sky: NoSky,
        fog: Haze {
            density: 0.04,
            albedo: 0.9,
            asymmetry: 0.7,
        },
    };
}

/// A lamp in a pit, whose light comes from a polished plate: a caustic. No ray to the lamp finds it.
pub mod caustic {
    use super::*;

    pub const CAMERA: Camera = Camera {
        eye: [0.5, -2.4, 1.5],
        target: [0.3, 1.3, 0.3],
        spread: 0.42,
        lens: 0.01,
        blades: 6,
        focus: 3.9,
    };

    const POLISHED: Any = Any::Metal(Metal {
        colour: [0.95, 0.94, 0.92],
        roughness: 0.08,
    });

    pub const SCENE: Scene<'static, Any, Lamp<Sphere>, NoSky, Clear> = Scene {
        quads: &[
            (
                &[
                    Quad::new([-3.0, -3.0, 0.0], [[6.0, 0.0, 0.0], [0.0, 5.6, 0.0]]),
                    Quad::new([-3.0, 2.6, 0.0], [[6.0, 0.0, 0.0], [0.0, 0.0, 3.0]]),
                ],
                Any::Matte(Matte([0.74, 0.72, 0.68])),
            ),
            (
                // The pit of the lamp.
                &[
                    Quad::new([-1.4, 1.0, 0.0], [[0.4, 0.0, 0.0], [0.0, 0.0, 0.6]]),
                    Quad::new([-1.4, 1.4, 0.0], [[0.4, 0.0, 0.0], [0.0, 0.0, 0.6]]),
                    Quad::new([-1.4, 1.0, 0.0], [[0.0, 0.4, 0.0], [0.0, 0.0, 0.6]]),
                    Quad::new([-1.0, 1.0, 0.0], [[0.0, 0.4, 0.0], [0.0, 0.0, 0.6]]),
                ],
                Any::Matte(Matte([0.10, 0.16, 0.20])),
            ),
            (
                // The plate that hangs above.
                &[Quad::new(
                    [-0.80, 0.75, 2.0],
                    [[0.8, 0.0, 0.0], [0.0, 0.8, 0.0]],
                )],
                POLISHED,
            ),
        ],
        spheres: &[
            (
                ball([0.15, 1.55, 0.22], 0.22),
                Any::Matte(Matte([0.30, 0.46, 0.66])),
            ),
            (
                ball([0.85, 1.10, 0.28], 0.28),
                Any::Metal(Metal {
                    colour: [1.0, 0.78, 0.34],
                    roughness: 0.15,
                }),
            ),
        ],
        lights: &[Lamp {
            shape: ball([-1.2, 1.2, 0.3], 0.08),
            radiance: [1500.0, 1300.0, 1000.0],
        }],
        choice: Choice::of(ONE.view()),
        sky: NoSky,
        fog: Clear,
    };
}
