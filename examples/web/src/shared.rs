//! The memory that the page and the module share, and why a subject was refused.

use core::fmt::Write;
use microwarp::rejection::Failure;

/// The most points of one picture.
pub const MOST: usize = 1 << 16;

/// Both sides know this layout: it is of 8-byte numbers first, then of 4, then of bytes.
#[repr(C)]
pub struct Shared {
    /// Three coordinates per point; missing ones are 0.
    pub points: [[f64; 3]; MOST],
    /// The density that the module itself reports at each point.
    pub densities: [f64; MOST],
    /// Further reports of a subject: see `subject`.
    pub report: [f64; 16],
    /// The last four words that each point was drawn with, the latest last.
    pub words: [[u32; 4]; MOST],
    /// The words of a golden case.
    pub golden: [u32; 16],
    /// The subject's parameters.
    pub parameters: [f32; 16],
    /// Why a subject was refused: its name, a line feed, what it means.
    pub text: [u8; 256],
}

/// The one instance.
pub fn shared() -> &'static mut Shared {
    static mut SHARED: Shared = Shared {
        points: [[0.0; 3]; MOST],
        densities: [0.0; MOST],
        report: [0.0; 16],
        words: [[0; 4]; MOST],
        golden: [0; 16],
        parameters: [0.0; 16],
        text: [0; 256],
    };
    // SAFETY: a module instance has one thread, each export takes this once, and none calls another.
    unsafe { &mut *core::ptr::addr_of_mut!(SHARED) }
}

/// Why nothing, or not everything, was sampled.
#[derive(Clone, Copy)]
pub enum Refusal {
    /// A constructor refused its parameters.
    Parameters(microwarp::Error),
    /// A sampler found nothing.
    Sampling(Failure),
    /// A parameter is not a number of this format.
    Format(&'static str),
    /// There is no such subject in this tier.
    Unknown,
}

impl From<microwarp::Error> for Refusal {
    fn from(error: microwarp::Error) -> Self {
        Self::Parameters(error)
    }
}

impl From<Failure> for Refusal {
    fn from(failure: Failure) -> Self {
        Self::Sampling(failure)
    }
}

impl Refusal {
    /// Writes the typed error and its meaning; returns how many bytes that took.
    pub fn write(&self, text: &mut [u8]) -> usize {
        let mut text = Text { text, length: 0 };
        // Running out of text space is not an error.
        let _ = match self {
            Self::Parameters(error) => write!(text, "Error::{error:?}\n{error}"),
            Self::Sampling(failure) => write_failure(*failure, &mut text),
            Self::Format(format) => write!(
                text,
                "No number of {format}\nthe format of this tier does not hold it"
            ),
            Self::Unknown => text.write_str("Unknown\nthere is no such sampler in this tier"),
        };
        text.length
    }
}

/// By hand: writing an `f32` in full would bring in the one part of `core` here that can panic.
fn write_failure(failure: Failure, text: &mut Text) -> core::fmt::Result {
    match failure {
        Failure::BudgetSpent { tries } => write!(
            text,
            "Failure::BudgetSpent {{ tries: {tries} }}\nno point was accepted in {tries} tries"
        ),
        Failure::BoundExceeded { ratio } => {
            let whole = ratio as u32;
            let thousandths = ((ratio - whole as f32) * 1000.0) as u32;
            write!(
                text,
                "Failure::BoundExceeded {{ ratio: {whole}.{thousandths:03} }}\nthe density is above its bound"
            )
        }
        Failure::NotFinite => text.write_str("Failure::NotFinite\nthe density is NaN or infinite"),
        Failure::Negative => text.write_str("Failure::Negative\nthe density is negative"),
        _ => text.write_str("Failure::ProposalDensity\nthe proposal's density is no density"),
    }
}

/// Text in memory of fixed size; the rest is cut off.
struct Text<'a> {
    text: &'a mut [u8],
    length: usize,
}

impl Write for Text<'_> {
    fn write_str(&mut self, part: &str) -> core::fmt::Result {
        let room = self.text.iter_mut().skip(self.length);
        for (slot, byte) in room.zip(part.bytes()) {
            *slot = byte;
            self.length = self.length.wrapping_add(1);
        }
        Ok(())
    }
}
