//! Counting and painting.
//!
//! The emulator moves its clock by 64 ns an instruction, and `SysTick` counts the processor's clock cycles
//! downwards; the host knows how many nanoseconds a cycle takes, and works out the rest. As WASM it is the host that
//! counts and paints, and calls `module.rs`.

use crate::measured::words::Output;
use core::hint::black_box;
use rand_core::Rng;
use rand_pcg::Pcg32;

/// Reads its inputs at the first address, writes its outputs at the second.
pub type Kernel = extern "C" fn(*mut u32, *mut u32);

/// One line of the registry.
pub struct Entry {
    /// The function that is measured.
    pub kernel: Kernel,
    /// One that takes the same words in and out and does nothing between.
    pub empty: Kernel,
    /// How each word of input is made of a random one; none where the input is a generator.
    pub inputs: &'static [fn(u32) -> u32],
    /// How many words of output.
    pub outputs: usize,
    /// Runs once before all calls.
    pub prepare: fn(),
    /// Its warp, as the list of what is hard calls it; nothing where it is no warp.
    #[cfg_attr(not(sweep), allow(dead_code, reason = "a sweep asks for it"))]
    pub warp: &'static str,
    /// How its warp is made of other parameters.
    #[cfg_attr(not(sweep), allow(dead_code, reason = "a sweep asks for it"))]
    pub vary: Option<Vary>,
}

/// How a warp that lies in memory is made of parameters.
#[cfg_attr(not(sweep), allow(dead_code, reason = "a sweep asks for it"))]
pub struct Vary {
    /// The constructors, by their names.
    pub constructors: &'static [&'static str],
    /// Calls one of them with parameters of words, of which there must be enough; nothing where it refuses them.
    pub make: fn(&str, &mut dyn Iterator<Item = u32>) -> Option<()>,
}

const MOST_INPUTS: usize = 4;
const MOST_OUTPUTS: usize = 6;

/// Loads `IN` words and stores as many as an `O` has, each by an instruction of its own as the kernels do.
pub extern "C" fn empty<const IN: usize, O: Output>(input: *mut u32, output: *mut u32) {
    const {
        assert!(IN <= MOST_INPUTS && O::WORDS <= MOST_OUTPUTS);
    }
    // Not a loop, which the compiler might keep at level s.
    macro_rules! each {
        ($bound:expr, $step:expr, $($index:literal)*) => {
            $(if $index < $bound { $step($index); })*
        };
    }
    let mut word = output.addr() as u32;
    // SAFETY: an entry says how many words there are.
    each!(IN, |i| word = unsafe { input.add(i).read_volatile() }, 0 1 2 3);
    // SAFETY: as above.
    each!(O::WORDS, |i| unsafe { output.add(i).write_volatile(word) }, 0 1 2 3 4 5);
}

/// Calls of a chunk, and how many chunks there are.
pub const CALLS: usize = 64;
pub const CHUNKS: u32 = 16;

/// Aligned as a generator must be.
#[repr(C, align(8))]
struct Buffers {
    inputs: [u32; CALLS * MOST_INPUTS],
    outputs: [u32; CALLS * MOST_OUTPUTS],
}

static mut BUFFERS: Buffers = Buffers {
    inputs: [0; CALLS * MOST_INPUTS],
    outputs: [0; CALLS * MOST_OUTPUTS],
};

fn inputs() -> *mut u32 {
    // SAFETY: there is one thread, and it holds no reference into them across a call.
    unsafe { (&raw mut BUFFERS.inputs).cast() }
}

fn outputs() -> *mut u32 {
    // SAFETY: there is one thread, and it holds no reference into them across a call.
    unsafe { (&raw mut BUFFERS.outputs).cast() }
}

const SYST_CSR: *mut u32 = 0xE000_E010 as *mut u32;
const SYST_RVR: *mut u32 = 0xE000_E014 as *mut u32;
const SYST_CVR: *mut u32 = 0xE000_E018 as *mut u32;

/// Makes `SysTick` count down from 2^24 - 1 repeatedly.
fn start_clock() {
    // SAFETY: registers of every Cortex-M.
    unsafe {
        SYST_RVR.write_volatile(0xff_ffff);
        SYST_CVR.write_volatile(0);
        SYST_CSR.write_volatile(5);
    }
}

#[cfg(target_arch = "arm")]
fn now() -> u32 {
    // SAFETY: a register of every Cortex-M.
    unsafe { SYST_CVR.read_volatile() }
}

#[cfg(not(target_arch = "arm"))]
fn now() -> u32 {
    0
}

/// Cycles since `then`, of which there must have been fewer than 2^24.
fn since(then: u32) -> u32 {
    then.wrapping_sub(now()) & 0xff_ffff
}

/// Cycles of a loop of so many rounds, of five instructions each.
#[inline(never)]
fn calibrate(rounds: u32) -> u32 {
    let then = now();
    #[cfg(target_arch = "arm")]
    // SAFETY: it counts a register down.
    unsafe {
        core::arch::asm!("2:", "nop", "nop", "nop", "subs {0}, {0}, #1", "bne 2b", inout(reg) rounds => _);
    }
    #[cfg(not(target_arch = "arm"))]
    let _ = rounds;
    since(then)
}

/// Cycles of `CALLS` calls, each on inputs of its own and of fewer than 2^24 cycles, and the stack pointer at the calls.
#[inline(never)]
pub fn run(entry: &Entry, kernel: Kernel) -> (u32, usize) {
    let (mut input, mut output) = (inputs(), outputs());
    let top = stack_pointer();
    let (mut cycles, mut then) = (0, now());
    for _ in 0..CALLS {
        kernel(input, output);
        input = input.wrapping_add(entry.inputs.len());
        output = output.wrapping_add(entry.outputs);
        // Paths of light take so long that the clock goes round between two of them, but not within one.
        let read = now();
        cycles += then.wrapping_sub(read) & 0xff_ffff;
        then = read;
    }
    (cycles, top)
}

const PAINT: u32 = 0xA5C3_96E1;
const DEPTH: usize = 8192;

#[cfg(target_arch = "arm")]
#[inline(always)]
fn stack_pointer() -> usize {
    let at;
    // SAFETY: it reads a register.
    unsafe {
        core::arch::asm!("mov {0}, sp", out(reg) at);
    }
    at
}

#[cfg(not(target_arch = "arm"))]
fn stack_pointer() -> usize {
    DEPTH
}

/// Bytes from the stack pointer at the calls down to the lowest word that one of them changed.
#[inline(never)]
fn stack(entry: &Entry, kernel: Kernel) -> u32 {
    let painted = stack_pointer();
    let bottom = painted - DEPTH;
    // Call nothing while painting: its frame would be painted over.
    let mut at = bottom;
    while at < painted {
        // SAFETY: free stack, of which the linker leaves more than this.
        unsafe { (at as *mut u32).write_volatile(PAINT) }
        at += 4;
    }
    let (_, top) = run(entry, kernel);
    let mut at = bottom;
    // SAFETY: as above.
    while at < top && unsafe { (at as *const u32).read_volatile() } == PAINT {
        at += 4;
    }
    (top - at) as u32
}

/// The generator of a chunk.
fn generator(chunk: u32) -> Pcg32 {
    Pcg32::new(0x9e37_79b9_7f4a_7c15_u64.wrapping_mul(chunk.into()), 54)
}

/// Makes the inputs of a chunk of calls, by the generator of the chunk and the number of the input.
pub fn fill(entry: &Entry, chunk: u32, mut bits: impl FnMut(&mut Pcg32, usize) -> u32) {
    let mut random = generator(chunk);
    if entry.inputs.is_empty() {
        // SAFETY: the buffer is aligned for a generator, and nothing else uses it while it is filled.
        unsafe { inputs().cast::<Pcg32>().write(random) }
        return;
    }
    for index in 0..CALLS * entry.inputs.len() {
        // SAFETY: within the buffer.
        unsafe { inputs().add(index).write_volatile(bits(&mut random, index)) }
    }
}

/// Makes the inputs of a chunk of calls, of random words.
pub fn refill(entry: &Entry, chunk: u32) {
    fill(entry, chunk, |random, index| {
        entry.inputs[index % entry.inputs.len()](random.next_u32())
    });
}

/// A hash of nothing.
pub const NO_HASH: u32 = 0x811c_9dc5;

/// Goes on with a hash over what the calls of a chunk wrote.
pub fn hashed(entry: &Entry, mut hash: u32) -> u32 {
    for index in 0..CALLS * entry.outputs {
        // SAFETY: within the buffer.
        let word = unsafe { outputs().add(index).read_volatile() };
        hash = (hash ^ word).wrapping_mul(0x0100_0193).rotate_left(5);
    }
    hash
}

/// How many calls were counted; the cycles of a loop of 50,000 instructions and of one of 25,000; the cycles of
/// the empty kernel and of the other; the stack of both; a hash of all that the kernel wrote.
pub fn measure(entry: &Entry) -> [u32; 8] {
    let entry = black_box(entry);
    (entry.prepare)();
    #[cfg(sweep)]
    crate::measured::sweep::prepare(entry);
    start_clock();
    let long = calibrate(black_box(10_000));
    let short = calibrate(black_box(5_000));
    let (mut cycles, mut deepest, mut hash) = ([0; 2], [0; 2], NO_HASH);
    for chunk in 0..CHUNKS {
        for (which, kernel) in [entry.empty, entry.kernel].into_iter().enumerate() {
            refill(entry, chunk);
            deepest[which] = stack(entry, kernel).max(deepest[which]);
            refill(entry, chunk);
            cycles[which] += run(entry, kernel).0;
        }
        hash = hashed(entry, hash);
    }
    #[cfg(sweep)]
    crate::measured::sweep::sweep(entry);
    [
        CALLS as u32 * CHUNKS,
        long,
        short,
        cycles[0],
        cycles[1],
        deepest[0],
        deepest[1],
        hash,
    ]
}
