//! Draws from the generators of published HALs, each by the line that `docs/generators.md` shows for it.
//!
//! Cargo.toml says which HAL is compiled for which target. On a host the page itself is tested, snippet by snippet.
#![no_std]

#[cfg(doctest)]
#[doc = include_str!("../../../docs/generators.md")]
mod page {}

/// `NAME(GENERATOR) => ADAPTED`: a function that draws a point from the adapted generator.
#[cfg(target_os = "none")]
macro_rules! draws {
    ($($name:ident($rng:ident: $generator:ty) => $adapted:expr;)*) => {$(
        pub fn $name($rng: &mut $generator) -> [f32; 2] {
            microwarp::Warp::draw(&microwarp::poly::Disk::new(), $adapted)
        }
    )*};
}

/// The same, and what the generator returns when it fails.
#[cfg(all(target_os = "none", target_abi = "eabihf"))]
macro_rules! try_draws {
    ($($name:ident($rng:ident: $generator:ty) => $adapted:expr, $error:ty;)*) => {$(
        pub fn $name($rng: &mut $generator) -> Result<[f32; 2], $error> {
            microwarp::Warp::try_draw(&microwarp::poly::Disk::new(), $adapted)
        }
    )*};
}

#[cfg(all(target_os = "none", target_arch = "arm", not(target_abi = "eabihf")))]
pub mod cortex_m0 {
    use microwarp::uniform::{Rng06, Rng09};
    use rp2040_hal::rosc::{Enabled, RingOscillator};

    draws! {
        rp2040_hal(rng: RingOscillator<Enabled>) => &mut Rng09(rng);
        embassy_rp(rng: embassy_rp::clocks::RoscRng) => &mut Rng09(rng);
        embassy_rp_06(rng: embassy_rp::clocks::RoscRng) => &mut Rng06(rng);
    }
}

#[cfg(all(target_os = "none", target_arch = "arm", target_abi = "eabihf"))]
pub mod cortex_m4f {
    use embassy_stm32::peripherals::RNG;
    use microwarp::uniform::{Error06, Rng06, Rng09, TryRng06};
    use stm32f4xx_hal::rng::Rng as F4;
    use stm32h7xx_hal::rng::Rng as H7;

    draws! {
        embassy_stm32(rng: embassy_stm32::rng::Rng<'_, RNG>) => &mut Rng09(rng);
        nrf52840_hal(rng: nrf52840_hal::Rng) => &mut Rng09(rng);
        stm32f4xx_hal(rng: F4) => &mut Rng09(rng);
        stm32h7xx_hal(rng: H7) => &mut Rng06(rng);
    }
    try_draws! {
        try_stm32f4xx_hal(rng: F4) => &mut TryRng06(rng), Error06;
        try_stm32h7xx_hal(rng: H7) => &mut TryRng06(rng), Error06;
    }
}

#[cfg(all(target_os = "none", target_arch = "riscv32"))]
pub mod risc_v {
    draws! {
        esp_hal(rng: esp_hal::rng::Rng) => rng;
    }
}
