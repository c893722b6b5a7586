//! A picture of the example `scene`, in characters, with its hash and what it took.

use crate::board::{Stopwatch, exit, print, stack};
use core::fmt::{Error, Write};
use microwarp_scene::golden::{Shot, case};
use microwarp_scene::vector::Vector;
use microwarp_scene::{Hash, Kit, Random};

/// From dark to bright.
const INK: [char; 10] = [' ', '.', ':', '-', '=', '+', '*', '#', '%', '@'];

/// How bright a colour is, from 0 to 1.
pub fn brightness([red, green, blue]: Vector) -> f32 {
    let sum = red + green + blue;
    sum / (sum + 0.6)
}

/// How near what a range sensor sees is: 1 at the sensor, 0 from 11 metres on.
pub fn nearness([light, way, _]: Vector) -> f32 {
    1.0 - 0.5 * way / (11.0 * light)
}

fn ink(shade: f32) -> char {
    // Of what is no number there is no light.
    let step = (shade * INK.len() as f32) as usize;
    INK.get(step).copied().unwrap_or('@')
}

/// Renders a scene from random numbers, prints it, and ends.
pub fn run<C: Shot, K: Kit>(tier: &'static str, shade: fn(Vector) -> f32) -> ! {
    let drawn = render::<C, K>(tier, shade).is_ok();
    // Where the stack has run over, who knows what has been printed.
    let (used, of) = stack();
    exit(drawn && used < of)
}

fn render<C: Shot, K: Kit>(tier: &'static str, shade: fn(Vector) -> f32) -> Result<(), Error> {
    let case = case::<C, K, Random>(tier, "pcg32");
    let [width, height] = case.plan.size;
    let view = C::view::<K>(case.plan.size).map_err(|_| Error)?;
    let mut watch = Stopwatch::calibrated();
    let (mut hash, mut instructions) = (Hash::EMPTY, 0);
    for row in 0..height {
        let mut line = heapless::String::<64>::new();
        for column in 0..width {
            watch.start();
            let light = C::pixel::<K, Random>(&view, [column, row], &case.plan);
            instructions += watch.instructions();
            hash = hash.with(light);
            line.push(ink(shade(light))).map_err(|_| Error)?;
        }
        writeln!(line)?;
        print(&line);
    }
    let mut line = heapless::String::<128>::new();
    let paths = u64::from(width * height * case.plan.samples);
    writeln!(line, "instructions,{}", instructions / paths)?;
    writeln!(line, "stack,{}", stack().0)?;
    writeln!(line, "{case},{:08x}", hash.word())?;
    print(&line);
    Ok(())
}
