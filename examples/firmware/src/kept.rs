//! State that survives a reset: plain bytes in RAM that the start-up code does not touch.

use crate::dock::{Answer, Search};
use crate::journey::ANSWERS;
use crate::world::Place;
use core::mem::MaybeUninit;
use core::ptr::{read_volatile, write_volatile};
use crc::{CRC_32_ISO_HDLC, Crc, NoTable};
use microwarp::metropolis::{Chain, Saved};
use microwarp::{Error, poly as mw};
use zerocopy::{FromBytes, FromZeros, Immutable, IntoBytes};

/// How many bursts of steps the chain takes, with a reset after each but the last.
pub const BURSTS: usize = 4;

/// Neither cleared nor filled by the start-up code. Read and written by volatile operations only, since the compiler
/// knows nothing of a reset.
#[cfg_attr(target_os = "none", unsafe(link_section = ".uninit.kept"))]
static mut MEMORY: MaybeUninit<Kept> = MaybeUninit::uninit();

/// The chain, number by number, and what it needs to go on. Without padding, so that every byte counts in the check
/// sum, and of numbers alone, so that whatever RAM holds when the power comes on is a value.
#[derive(Clone, Copy, FromBytes, IntoBytes, Immutable)]
#[repr(C)]
pub struct Kept {
    steps: u64,
    accepted: u64,
    refused: u64,
    rejected_in_a_row: u32,
    density: f32,
    state: Place,
    answers: [[f32; 3]; ANSWERS],
    /// The mean place of every burst so far.
    means: [Place; BURSTS],
    bursts: u32,
    sum: u32,
}

impl Kept {
    /// A chain that has not taken a step.
    pub fn new(chain: &Search, answers: &[Answer; ANSWERS]) -> Self {
        let mut kept = Self {
            steps: 0,
            accepted: 0,
            refused: 0,
            rejected_in_a_row: 0,
            density: 0.0,
            state: [0.0; 2],
            answers: answers.map(|([x, y], range)| [x, y, range]),
            means: [[0.0; 2]; BURSTS],
            bursts: 0,
            sum: 0,
        };
        kept.put(chain);
        kept
    }

    /// Takes in a chain as it is after a burst, with the mean of that burst.
    pub fn push(&mut self, chain: &Search, mean: Place) {
        let burst = self.bursts();
        if let Some(slot) = self.means.get_mut(burst) {
            *slot = mean;
            self.bursts += 1;
        }
        self.put(chain);
    }

    fn put(&mut self, chain: &Search) {
        let saved = chain.save();
        self.steps = saved.steps;
        self.accepted = saved.accepted;
        self.refused = saved.refused;
        self.rejected_in_a_row = saved.rejected_in_a_row;
        self.density = saved.density.get();
        self.state = saved.state;
        self.sum = self.check_sum();
    }

    /// The chain again.
    ///
    /// # Errors
    /// Those of [`Chain::resume`], for numbers that no chain has.
    pub fn chain(&self) -> Result<Search, Error> {
        Chain::resume(Saved {
            state: self.state,
            density: mw::LogDensity::new(self.density),
            steps: self.steps,
            accepted: self.accepted,
            refused: self.refused,
            rejected_in_a_row: self.rejected_in_a_row,
        })
    }

    /// What the dock answered.
    pub fn answers(&self) -> [Answer; ANSWERS] {
        self.answers.map(|[x, y, range]| ([x, y], range))
    }

    /// How many bursts the chain has taken.
    pub fn bursts(&self) -> usize {
        self.bursts as usize
    }

    /// The mean place over all bursts, once they are all taken.
    pub fn mean(&self) -> Place {
        let [x, y] = self
            .means
            .iter()
            .fold([0.0; 2], |[x, y], [u, v]| [x + u, y + v]);
        [x, y].map(|sum| sum / BURSTS as f32)
    }

    fn check_sum(&self) -> u32 {
        let bytes = Self { sum: 0, ..*self };
        Crc::<u32, NoTable>::new(&CRC_32_ISO_HDLC).checksum(bytes.as_bytes())
    }

    /// Whether this was kept, and is not the random content of RAM.
    pub fn is_sound(&self) -> bool {
        self.sum == self.check_sum()
    }

    /// The state kept before a reset, if any.
    pub fn load() -> Option<Self> {
        // SAFETY: RAM of its size and alignment, in which every pattern of bits is a value.
        let kept = unsafe { read_volatile((&raw const MEMORY).cast::<Self>()) };
        kept.is_sound().then_some(kept)
    }

    /// Keeps it across a reset.
    pub fn store(&self) {
        // SAFETY: RAM of its size and alignment; there is one thread, and nobody holds a reference.
        unsafe { write_volatile((&raw mut MEMORY).cast(), *self) }
    }

    /// Forgets the kept state, so that the next start begins anew.
    pub fn forget() {
        // Zeros have another check sum than 0.
        Self::new_zeroed().store();
    }
}
