//! Mixtures of warps and tables by weight, in memory of the caller: a head, and behind it what each part is.
//!
//! The choice is the crate's own `Mixture`, of parts that only know their index.

use crate::buffers::Arrays;
use crate::flat::{Flat, get, put};
use crate::parts::linked;
use crate::tables;
use crate::warps::{
    DRAW, DRAW_WITH_PDF, INVERT, KINDS, PDF, RUN, SAMPLE, SAMPLE_WITH_PDF, refused_weight,
};
use core::ptr::null;
use microwarp::Warp;
use microwarp::discrete::{InvertParts, Mixture, Parts};
use microwarp::uniform::Canonical;
use microwarp::warp::{Content, Measured, Normals, Rotations, SolidAngle};
use rand_core::TryRng;

pub const MIXTURES: bool = linked("mixtures");

/// What is asked beside what a warp is: the probability of a part, by its index.
const PMF: u32 = 6;

/// So many parts at most; others have no weight.
const MOST: usize = 32;

/// The refusal of a part whose points or densities are of another kind than those of the first; no error has this code.
const OTHER_KIND: u32 = 30;

/// The JavaScript side has so many words for a head, and fills in all but the chooser.
const HEAD: usize = 256;

#[repr(C)]
pub struct Mixed {
    count: u32,
    dimensions: u32,
    parts: [Part; MOST],
    chooser: Mixture<Picked, MOST>,
}
const _: () = assert!(size_of::<Mixed>() <= 4 * HEAD && align_of::<Mixed>() <= 16);

/// A warp by its number, or a table by its kind, that lies so many bytes from the head on.
#[derive(Clone, Copy)]
#[repr(C)]
struct Part {
    number: u32,
    table: u32,
    offset: u32,
}

/// What may be mixed has one number: that of its measure, and of how its points lie.
pub const fn kind<W: Measured<Measure: Measure, Point: Flat>>() -> u8 {
    <W::Measure as Measure>::NUMBER | W::Point::LAYOUT << 4
}

pub trait Measure {
    const NUMBER: u8;
}
impl<const N: usize> Measure for Content<N> {
    const NUMBER: u8 = N as u8;
}
impl Measure for SolidAngle {
    const NUMBER: u8 = 13;
}
impl Measure for Normals {
    const NUMBER: u8 = 14;
}
impl Measure for Rotations {
    const NUMBER: u8 = 15;
}

/// Where a part is asked: for the density at a point, of which that of one part may be known. Of a sample it says which part was
/// picked, and its first uniform.
#[derive(Clone, Copy)]
struct At {
    mixed: *const Mixed,
    point: *const f32,
    part: usize,
    number: f32,
}

/// All parts, that of each index.
#[derive(Clone, Copy)]
struct Picked;

impl Picked {
    const fn part(part: usize, number: f32) -> At {
        At {
            mixed: null(),
            point: null(),
            part,
            number,
        }
    }
}

impl Parts<MOST> for Picked {
    /// The first one; the other is the index of the part of an inverse.
    type Uniforms = [f32; 2];
    type Point = At;
    type Measure = ();

    fn sample_by(&self, part: usize, u: Canonical<[f32; 2]>) -> At {
        let [first, _] = u.get();
        Self::part(part, first)
    }

    fn sample_words_by(&self, part: usize, _: [u32; 2]) -> At {
        Self::part(part, 0.0)
    }

    fn sample_with_pdf_by(&self, part: usize, u: Canonical<[f32; 2]>) -> (At, f32) {
        (self.sample_by(part, u), 0.0)
    }

    fn try_draw_by<R: TryRng + ?Sized>(&self, part: usize, _: &mut R) -> Result<At, R::Error> {
        Ok(Self::part(part, 0.0))
    }

    fn try_draw_with_pdf_by<R: TryRng + ?Sized>(
        &self,
        part: usize,
        _: &mut R,
    ) -> Result<(At, f32), R::Error> {
        Ok((Self::part(part, 0.0), 0.0))
    }

    fn pdf_by(&self, part: usize, at: At) -> f32 {
        if part == at.part {
            return at.number;
        }
        let mut density = 0.0;
        // SAFETY: `element` made it of a mixture and a point.
        unsafe { ask(at.mixed, part, PDF, at.point, &raw mut density) };
        density
    }
}

impl InvertParts<MOST> for Picked {
    fn invert_by(&self, part: usize, at: At) -> [f32; 2] {
        let mut uniforms = [0.0; 8];
        // SAFETY: `element` made it of a mixture and a point; no warp has more uniforms.
        unsafe { ask(at.mixed, part, INVERT, at.point, uniforms.as_mut_ptr()) };
        let [first, ..] = uniforms;
        [first, part as f32]
    }
}

/// Does one thing to one element by a part.
unsafe fn ask(mixed: *const Mixed, part: usize, what: u32, input: *const f32, output: *mut f32) {
    // SAFETY: the caller has put the parts where the head says.
    unsafe {
        let Some(part) = (*mixed).parts.get(part) else {
            return;
        };
        let arrays = Arrays {
            input,
            output,
            inputs: 8,
            outputs: (*mixed).dimensions as usize,
            count: 1,
        };
        let warp = mixed.byte_add(part.offset as usize);
        if part.table > 0 {
            tables::piece(part.number, what, warp.cast_mut().cast(), arrays);
        } else if let Some(run) = RUN.get(part.number as usize) {
            run(what, warp.cast(), &arrays);
        }
    }
}

/// Writes the chooser of a head whose parts lie behind it. 0, or the code of the refusal and an index times 32.
///
/// # Safety
/// The head is filled in, but for the chooser, and there are 32 weights.
pub unsafe fn made(mixed: *mut Mixed, weights: *const f32) -> u32 {
    // SAFETY: as the caller says.
    unsafe {
        let parts = &(*mixed).parts;
        let mut first = None;
        for (i, part) in parts.iter().take((*mixed).count as usize).enumerate() {
            let kind = if part.table > 0 {
                tables::kind_of(part.number)
            } else {
                KINDS.get(part.number as usize).copied()
            };
            if kind.is_none() || *first.get_or_insert(kind) != kind {
                return OTHER_KIND | (i as u32) << 5;
            }
        }
        match Mixture::new(Picked, &get::<[f32; MOST]>(weights)) {
            Ok(chooser) => {
                (&raw mut (*mixed).chooser).write(chooser);
                0
            }
            Err(refusal) => refused_weight(refusal),
        }
    }
}

/// Does to each element what `evaluate` does; of an inverse the uniform that picks a part may lie behind the point, and is ½ otherwise.
///
/// # Safety
/// `made` has written the chooser, and the elements have the numbers of the parts.
pub unsafe fn all(mixed: *const Mixed, what: u32, mut arrays: Arrays) {
    while arrays.count > 0 {
        // SAFETY: as the caller says.
        unsafe { element(mixed, what, &arrays) };
        arrays.next();
    }
}

unsafe fn element(mixed: *const Mixed, what: u32, arrays: &Arrays) {
    let Arrays {
        input,
        output,
        inputs,
        ..
    } = *arrays;
    // SAFETY: as the caller says.
    unsafe {
        let (chooser, dimensions) = (&(*mixed).chooser, (*mixed).dimensions as usize);
        let at = |point, part, number| At {
            mixed,
            point,
            part,
            number,
        };
        // No warp takes more uniforms, or words.
        let mut own = [0_u32; 8];
        let given = core::slice::from_raw_parts(input.cast::<u32>(), inputs);
        for (own, &given) in own.iter_mut().zip(given) {
            *own = given;
        }
        let [first, ..] = &mut own;
        let part = match what {
            PDF => return put(output, chooser.pdf(at(input, MOST, 0.0))),
            PMF => return put(output, chooser.pmf(*first as usize)),
            SAMPLE | SAMPLE_WITH_PDF => {
                let At { part, number, .. } = chooser.sample([f32::from_bits(*first), 0.0]);
                *first = number.to_bits();
                part
            }
            DRAW | DRAW_WITH_PDF => {
                let (part, rest) = chooser.choose(*first);
                *first = rest;
                part
            }
            _ => {
                let u = given.get(dimensions).map_or(0.5, |&u| f32::from_bits(u));
                let [first, part] = chooser.invert_with(at(input, MOST, 0.0), u);
                ask(mixed, part as usize, INVERT, input, output);
                return put(output, first);
            }
        };
        ask(mixed, part, what, own.as_ptr().cast(), output);
        if what == SAMPLE_WITH_PDF || what == DRAW_WITH_PDF {
            let density = output.add(dimensions);
            put(density, chooser.pdf(at(output, part, density.read())));
        }
    }
}
