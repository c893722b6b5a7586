//! What a renderer needs beside warps: reservoirs of lights, places on lamps, reflections and their masking, weights of several
//! techniques, roulette. All of it passes through the buffers.

use crate::buffers::Buffers;
use crate::flat::{get, put};
use crate::parts::linked;
use microwarp::Error;
use microwarp::discrete::LightReservoir;
use microwarp::estimate::{balance_heuristic_of, power_heuristic_of, roulette};
use microwarp::poly::{Ggx, GgxVisible, SphericalRectangle, SphericalTriangle, VisibleSphere};
use microwarp::warp::LightSample;
use microwarp_js_hot::Words;

pub const LIGHTS: bool = linked("lights");

/// The kinds, from which on the lamps are counted.
const RESERVOIR: u32 = 32;
const LAMP: u32 = 33;
const GLOSS: u32 = 36;
const SURFACE: u32 = 37;
const TECHNIQUES: u32 = 38;

/// What is asked of a lamp and of a reflection: a draw, a sample, or more.
const DRAW: u32 = 0;
const SAMPLE: u32 = 1;

/// Codes of refusals are returned more than this. An answer is 1, or 2 for yes; what is not linked is 0.
const REFUSED: u32 = 32;

/// A reservoir without its item, which the caller keeps; the JavaScript side has room for so many words.
type Reservoir = LightReservoir<()>;
const ROOM: usize = 8;
const _: () = assert!(size_of::<Reservoir>() <= 4 * ROOM);

fn answer(said: Result<bool, Error>) -> u32 {
    match said {
        Ok(yes) => 1 + u32::from(yes),
        Err(refusal) => REFUSED + u32::from(refusal.code()),
    }
}

/// Answers by kind. `number` is that of techniques, or how many words are drawn first, and `own` one of the techniques.
///
/// # Safety
/// The lamp or the surface lies there, as `construct` has written it; a reservoir is one that this has put out.
pub unsafe fn asked(
    kind: u32,
    what: u32,
    of: *const u32,
    buffers: &mut Buffers,
    number: usize,
    own: usize,
) -> u32 {
    // SAFETY: as the caller says; the buffers have room for all of it.
    unsafe {
        match kind {
            RESERVOIR => return answer(reservoir(what, buffers)),
            TECHNIQUES => techniques(what, buffers, number, own),
            ..TECHNIQUES => {
                buffers.random(own);
                seen(kind, what, of, buffers);
            }
            _ => {
                let [chance, word, ..] = buffers.input;
                let by = roulette(f32::from_bits(chance), word);
                put(to(buffers), by.unwrap_or(0.0));
                return 1 + u32::from(by.is_some());
            }
        }
    }
    1
}

fn to(buffers: &mut Buffers) -> *mut f32 {
    buffers.output.as_mut_ptr().cast()
}

/// Does something to the reservoir in the input: begins it (0), offers (1), absorbs the one behind it (2), caps (3), normalises (4); or
/// puts out its count, target and contribution. Behind both lie target or number, density, and words.
unsafe fn reservoir(what: u32, buffers: &mut Buffers) -> Result<bool, Error> {
    let input = buffers.input.as_mut_ptr();
    let mut taken = false;
    // SAFETY: as the caller says.
    unsafe {
        let held = input.cast::<Reservoir>();
        if what == 0 {
            held.write_unaligned(Reservoir::new());
            return Ok(false);
        }
        let mut own = held.read_unaligned();
        let given = input.add(2 * ROOM);
        let [target, density] = get(given.cast());
        let mut words = Words::new(given.add(2));
        match what {
            1 => taken = own.offer((), target, density, &mut words)?,
            2 => {
                let other = input.add(ROOM).cast::<Reservoir>().read_unaligned();
                taken = own.absorb(other, target, &mut words)?;
            }
            3 => own.cap(*given),
            4 => own.normalise(*given),
            _ => put(
                to(buffers),
                [
                    f32::from_bits(own.count()),
                    own.target(),
                    own.contribution(),
                ],
            ),
        }
        held.write_unaligned(own);
    }
    Ok(taken)
}

/// The weight of a technique, by the counts of all in the input and their densities behind these.
fn techniques(what: u32, buffers: &mut Buffers, count: usize, own: usize) {
    let (counts, rest) = buffers
        .input
        .split_at_mut_checked(count)
        .unwrap_or_default();
    let densities: &[f32] = match rest.get(..count) {
        // SAFETY: any bits are a number.
        Some(densities) => unsafe {
            core::slice::from_raw_parts(densities.as_ptr().cast(), densities.len())
        },
        None => &[],
    };
    let weight = match what {
        0 => balance_heuristic_of(counts, densities, own),
        _ => power_heuristic_of(counts, densities, own),
    };
    // SAFETY: there is room for a number.
    unsafe { put(to(buffers), weight) };
}

/// A place on a lamp, or the density of any direction to it.
///
/// # Safety
/// A uniform lies in the input, and there is room for a place.
unsafe fn lit<L>(
    lamp: &L,
    what: u32,
    (from, to): (*const f32, *mut f32),
    words: &mut Words,
    draw: impl Fn(&L, &mut Words) -> LightSample,
    sample: impl Fn(&L, [f32; 2]) -> LightSample,
    density: impl Fn(&L) -> f32,
) {
    // SAFETY: as the caller says.
    unsafe {
        let place = match what {
            DRAW => draw(lamp, words),
            SAMPLE => sample(lamp, get(from)),
            _ => return put(to, density(lamp)),
        };
        put(to, place.direction);
        put(to.add(3), [place.distance, place.pdf]);
        put(to.add(5), place.place);
    }
}

/// A place on a lamp, and of any direction to it the density; a reflection, and its kin.
unsafe fn seen(kind: u32, what: u32, of: *const u32, buffers: &mut Buffers) {
    let input = buffers.input.as_ptr();
    let (from, to) = (input.cast::<f32>(), to(buffers));
    // SAFETY: as the caller says.
    unsafe {
        let mut words = Words::new(input);
        match kind {
            LAMP => lit(
                &*of.cast(),
                what,
                (from, to),
                &mut words,
                VisibleSphere::draw_light,
                VisibleSphere::sample_light,
                VisibleSphere::density,
            ),
            34 => lit(
                &*of.cast(),
                what,
                (from, to),
                &mut words,
                SphericalTriangle::draw_light,
                SphericalTriangle::sample_light,
                SphericalTriangle::density,
            ),
            35 => lit(
                &*of.cast(),
                what,
                (from, to),
                &mut words,
                SphericalRectangle::draw_light,
                SphericalRectangle::sample_light,
                SphericalRectangle::density,
            ),
            GLOSS => {
                let gloss = &*of.cast::<GgxVisible>();
                let bounce = match what {
                    DRAW => gloss.draw_reflection(&mut words),
                    SAMPLE => gloss.reflect(get(from)),
                    2 => return put(to, gloss.reflected_pdf(get(from))),
                    3 => return put(to, gloss.g1()),
                    4 => return put(to, gloss.unmasked(get(from))),
                    _ => return put(to, gloss.visibility(get(from))),
                };
                put(to, bounce.normal);
                put(to.add(3), bounce.direction);
                put(to.add(6), bounce.pdf);
            }
            SURFACE => {
                let surface = &*of.cast::<Ggx>();
                let figure = match what {
                    0 => surface.distribution(get(from)),
                    _ => surface.g1(get(from)),
                };
                put(to, figure);
            }
            _ => {}
        }
    }
}
