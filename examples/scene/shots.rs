//! The six scenes, with what is said of them and how they are developed.

use crate::render::{Render, Take};
use host::draw::colour::tone;
use microwarp_scene::scenes::{caustic, fog, room, sensor, slit, slivers};
use microwarp_scene::{Colour, Echo};

pub struct Shot {
    /// The name of its file.
    pub name: &'static str,
    pub title: &'static str,
    pub text: &'static str,
    pub scene: Box<dyn Render>,
    /// How many times the samples of the others its picture takes, to be as smooth.
    pub times: f64,
    /// A pixel as a colour from 0 to 255.
    pub develop: fn([f64; 3]) -> [f64; 3],
}

pub fn all() -> Vec<Shot> {
    vec![
        Shot {
            name: "room",
            title: "A matte room",
            text: "lamps by their solid angle",
            scene: Box::new(Take::<_, Colour>::new(room::SCENE, room::CAMERA)),
            times: 1.0,
            develop: |light| exposed(light, 1.0),
        },
        Shot {
            name: "fog",
            title: "Glossy balls in fog",
            text: "GGX, equi-angular",
            scene: Box::new(Take::<_, Colour>::new(fog::SCENE, fog::CAMERA)),
            times: 0.5,
            develop: |light| exposed(light, 1.0),
        },
        Shot {
            name: "slivers",
            title: "A sky over slivers",
            text: "a table of directions",
            scene: Box::new(Take::<_, Colour>::new(slivers::SCENE, slivers::CAMERA)),
            times: 0.5,
            develop: |light| exposed(light, 0.8),
        },
        Shot {
            name: "slit",
            title: "Light through a slit",
            text: "what paths find hard",
            scene: Box::new(Take::<_, Colour>::new(slit::SCENE, slit::CAMERA)),
            times: 1.0,
            develop: |light| exposed(light, 1.0),
        },
        Shot {
            name: "caustic",
            title: "A caustic",
            text: "a lamp in a pit, seen in a plate",
            scene: Box::new(Take::<_, Colour>::new(caustic::SCENE, caustic::CAMERA)),
            times: 4.0,
            develop: |light| exposed(light, 1.0),
        },
        Shot {
            name: "sensor",
            title: "A range sensor in fog",
            text: "near is yellow",
            scene: Box::new(Take::<_, Echo>::new(sensor::SCENE, sensor::CAMERA)),
            times: 0.5,
            develop: ranged,
        },
    ]
}

fn exposed(light: [f64; 3], gain: f64) -> [f64; 3] {
    tone(light.map(|c| c * gain))
}

/// The range that a sensor reports, in metres: half of the mean way, weighed by what comes back.
pub fn range([light, way, _]: [f64; 3]) -> f64 {
    if light > 0.0 { 0.5 * way / light } else { 0.0 }
}

/// Near is yellow, far is blue; so much is black.
const FARTHEST: f64 = 11.0;
const STOPS: [[f64; 3]; 5] = [
    [255.0, 240.0, 160.0],
    [244.0, 150.0, 66.0],
    [186.0, 58.0, 92.0],
    [72.0, 40.0, 116.0],
    [14.0, 16.0, 44.0],
];

fn ranged(echo: [f64; 3]) -> [f64; 3] {
    let place = (range(echo) / FARTHEST).clamp(0.0, 1.0) * (STOPS.len() - 1) as f64;
    let before = (place as usize).min(STOPS.len() - 2);
    let t = place - before as f64;
    std::array::from_fn(|k| STOPS[before][k] + t * (STOPS[before + 1][k] - STOPS[before][k]))
}
