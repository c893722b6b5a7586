//! A picture of the example `scene`, in characters, with its hash and what it took.

use crate::board::{Stopwatch, exit, print, stack};
use core::fmt::{Error, Write};
use microwarp_scene::golden::{Case, Grey, Shot, Slit, case, chain, slit, walk};
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
    end(render::<C, K>(tier, shade))
}

/// Renders the slit by Metropolis light transport, prints it, and ends.
pub fn run_chain<K: Kit>(tier: &'static str) -> ! {
    end(render_chain::<K>(tier))
}

fn end(drawn: Result<(), Error>) -> ! {
    // Where the stack has run over, who knows what has been printed.
    let (used, of) = stack();
    exit(drawn.is_ok() && used < of)
}

fn render<C: Shot, K: Kit>(tier: &'static str, shade: fn(Vector) -> f32) -> Result<(), Error> {
    let case = case::<C, K, Random>(tier, "pcg32");
    let [width, height] = case.plan.size;
    let view = C::view::<K>(case.plan.size).map_err(|_| Error)?;
    let mut watch = Stopwatch::calibrated();
    let (mut hash, mut instructions) = (Hash::EMPTY, 0);
    for row in 0..height {
        let shades = (0..width).map(|column| {
            watch.start();
            let light = C::pixel::<K, Random>(&view, [column, row], &case.plan);
            instructions += watch.instructions();
            hash = hash.with(light);
            shade(light)
        });
        print_row(shades)?;
    }
    let paths = u64::from(width * height * case.plan.samples);
    report(&case, instructions / paths, hash)
}

fn render_chain<K: Kit>(tier: &'static str) -> Result<(), Error> {
    let case = slit::<K>(tier);
    let [width, _] = case.plan.size;
    let mut grey: Grey = [0.0; 48 * 32];
    let mut watch = Stopwatch::calibrated();
    watch.start();
    let hash = chain::<Slit, K>(&case.plan, &mut grey).map_err(|_| Error)?;
    let instructions = watch.instructions() / u64::from(walk(&case.plan).paths());
    for row in grey.chunks(width as usize) {
        print_row(row.iter().map(|light| brightness([*light; 3])))?;
    }
    report(&case, instructions, hash)
}

fn print_row(shades: impl Iterator<Item = f32>) -> Result<(), Error> {
    let mut line = heapless::String::<64>::new();
    for shade in shades {
        line.push(ink(shade)).map_err(|_| Error)?;
    }
    writeln!(line)?;
    print(&line);
    Ok(())
}

fn report(case: &Case, instructions: u64, hash: Hash) -> Result<(), Error> {
    let mut line = heapless::String::<128>::new();
    writeln!(line, "instructions,{instructions}")?;
    writeln!(line, "stack,{}", stack().0)?;
    writeln!(line, "{case},{:08x}", hash.word())?;
    print(&line);
    Ok(())
}
