//! Programs of one sampler each, the same as in `programs.c`; a feature picks one.
#![no_std]

use core::ptr::{read_volatile, write_volatile};
use microwarp::discrete::Cdf;
use microwarp::{Error, Warp, fixed as integers, poly};
use rand_pcg::Pcg32;

static mut SEED: u32 = 42;
static mut PARAMETER: f32 = 50.0;
static mut WHOLE: u32 = 20 << 16;
static mut OUT: [f32; 3] = [0.0; 3];
static mut WORDS: [u32; 2] = [0; 2];

macro_rules! volatile {
    ($name:ident) => {
        // SAFETY: nothing else runs.
        unsafe { read_volatile(&raw const $name) }
    };
    ($name:ident[$i:literal] = $value:expr) => {
        // SAFETY: nothing else runs.
        unsafe { write_volatile(&raw mut $name[$i], $value) }
    };
}

fn generator() -> Pcg32 {
    Pcg32::new(volatile!(SEED).into(), 54)
}

fn disk() -> Result<(), Error> {
    let [x, y] = poly::Disk::new().draw(&mut generator());
    volatile!(OUT[0] = x);
    volatile!(OUT[1] = y);
    Ok(())
}

fn exponential() -> Result<(), Error> {
    let mut rng = generator();
    let warp = poly::Exponential::from_mean(volatile!(PARAMETER))?;
    volatile!(OUT[0] = warp.draw(&mut rng));
    Ok(())
}

fn normal_pair() -> Result<(), Error> {
    let mut rng = generator();
    let mean = [volatile!(PARAMETER), volatile!(PARAMETER)];
    let [x, y] = poly::NormalPair::new(mean, volatile!(PARAMETER))?.draw(&mut rng);
    volatile!(OUT[0] = x);
    volatile!(OUT[1] = y);
    Ok(())
}

fn phong_lobe() -> Result<(), Error> {
    let mut rng = generator();
    let [x, y, z] = poly::PhongLobe::new(volatile!(PARAMETER))?.draw(&mut rng);
    volatile!(OUT[0] = x);
    volatile!(OUT[1] = y);
    volatile!(OUT[2] = z);
    Ok(())
}

/// A table that the compiler builds.
static TABLE: Cdf<[u32; 4]> = match Cdf::new(&[1.0, 2.0, 3.0, 4.0]) {
    Ok(table) => table,
    Err(_) => panic!("weights"),
};

fn cdf() -> Result<(), Error> {
    volatile!(WORDS[0] = TABLE.draw_index(&mut generator()) as u32);
    Ok(())
}

fn fixed_disk() -> Result<(), Error> {
    let [x, y] = integers::Disk::new().draw(&mut generator());
    volatile!(WORDS[0] = x.to_bits() as u32);
    volatile!(WORDS[1] = y.to_bits() as u32);
    Ok(())
}

fn fixed_exponential() -> Result<(), Error> {
    let mut rng = generator();
    let mean = fixed::types::U16F16::from_bits(volatile!(WHOLE));
    let warp = integers::Exponential::<fixed::types::extra::U16>::from_mean(mean)?;
    volatile!(WORDS[0] = warp.draw(&mut rng).to_bits());
    Ok(())
}

macro_rules! main_of {
    ($($feature:literal $program:ident,)*) => {
        #[unsafe(no_mangle)]
        extern "C" fn main() -> i32 {
            $(if cfg!(feature = $feature) {
                return $program().map_or_else(|error| error.code().into(), |()| 0);
            })*
            0
        }
    };
}

main_of! {
    "disk" disk,
    "exponential" exponential,
    "normal_pair" normal_pair,
    "phong_lobe" phong_lobe,
    "cdf" cdf,
    "fixed_disk" fixed_disk,
    "fixed_exponential" fixed_exponential,
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    loop {
        core::hint::spin_loop();
    }
}
