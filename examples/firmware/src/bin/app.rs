//! The application: drive and listen, then search for the dock in bursts with a reset after each, then compare with
//! the truth. It ends with failure where an estimate is further off than stated, or where a control is not.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use defmt::{Format, error, info, warn};
use microwarp::Error;
use microwarp::rejection::Failure;
use microwarp_firmware::board::{exit, reset, stack};
use microwarp_firmware::dock::{self, Search};
use microwarp_firmware::journey::travel;
use microwarp_firmware::kept::{BURSTS, Kept};
use microwarp_firmware::world::{DOCK, World, distance};
use microwarp_firmware::{DOCK_BOUND, STEPS, TRACK_BOUND};
use rand_pcg::Pcg32;

const SEED: u64 = 42;

#[derive(Format)]
enum Fault {
    Parameters(Error),
    Start(Failure),
    /// An estimate, or a control, is not what it must be.
    Wrong,
    /// The stack has run over.
    Stack,
}

impl From<Error> for Fault {
    fn from(error: Error) -> Self {
        Self::Parameters(error)
    }
}

/// The generator of a burst: a stream of its own, so that it need not be kept.
fn generator(burst: usize) -> Pcg32 {
    Pcg32::new(SEED, 10 + burst as u64)
}

#[entry]
fn main() -> ! {
    let result = match Kept::load() {
        None => drive(),
        Some(kept) => go_on(kept),
    };
    let (used, of) = stack();
    info!("stack: {=usize} of {=usize} bytes", used, of);
    // All of it, and who knows what beyond.
    let result = if used < of { result } else { Err(Fault::Stack) };
    match result {
        Ok(kept) if kept.bursts() < BURSTS => {
            kept.store();
            reset()
        }
        Ok(_) => {
            Kept::forget();
            defmt::flush();
            exit(true)
        }
        Err(fault) => {
            Kept::forget();
            error!("{}", fault);
            defmt::flush();
            exit(false)
        }
    }
}

/// Drives over the lawn, and starts a chain from what the dock answered.
#[inline(never)]
fn drive() -> Result<Kept, Fault> {
    let world = World::new()?;
    info!("{}", world);
    let journey = travel(&world, SEED, false, |tick, range, error| {
        warn!(
            "tick {=usize}: no guess explains a range of {=f32} m: {}",
            tick, range, error
        );
    })?;
    info!(
        "tracker: off by {=f32} m, {=u32} ranges refused",
        journey.error, journey.refused
    );
    // The control: guesses that hear nothing lose the rover, and the same check says so.
    let deaf = travel(&world, SEED, true, |_, _, _| ())?;
    info!("without its ears: off by {=f32} m", deaf.error);
    require(journey.error <= TRACK_BOUND && deaf.error > TRACK_BOUND)?;

    let chain = dock::start(&journey.answers, &mut generator(0)).map_err(Fault::Start)?;
    info!("search: {} by {}", chain, dock::mutation()?);
    Ok(Kept::new(&chain, &journey.answers))
}

/// Takes up the chain where it was before the reset.
#[inline(never)]
fn go_on(mut kept: Kept) -> Result<Kept, Fault> {
    let mut chain = kept.chain()?;
    burst(&mut chain, &mut kept)?;
    info!("burst {=usize}: {}", kept.bursts(), chain);
    if kept.bursts() == BURSTS {
        arrive(&kept, &chain)?;
    }
    Ok(kept)
}

fn burst(chain: &mut Search, kept: &mut Kept) -> Result<(), Error> {
    let mut rng = generator(1 + kept.bursts());
    let mean = dock::advance(chain, &kept.answers(), STEPS, &mut rng)?;
    kept.push(chain, mean);
    Ok(())
}

/// Compares with the truth, and with a chain that was never interrupted.
#[inline(never)]
fn arrive(kept: &Kept, chain: &Search) -> Result<(), Fault> {
    let off = distance(kept.mean(), DOCK);
    info!("dock: at {}, off by {=f32} m", kept.mean(), off);
    info!("accepted: {}", chain.acceptance_rate());
    // The control: a chain that knows of no answer finds no dock.
    let mut lost = dock::start(&[], &mut generator(0)).map_err(Fault::Start)?;
    let nowhere = dock::advance(&mut lost, &[], STEPS, &mut generator(1))?;
    info!("without answers: off by {=f32} m", distance(nowhere, DOCK));
    require(off <= DOCK_BOUND && distance(nowhere, DOCK) > DOCK_BOUND)?;

    let answers = kept.answers();
    let mut again = dock::start(&answers, &mut generator(0)).map_err(Fault::Start)?;
    let mut whole = Kept::new(&again, &answers);
    for _ in 0..BURSTS {
        burst(&mut again, &mut whole)?;
    }
    info!("without a reset: {}", again);
    require(again == *chain && whole.mean() == kept.mean())
}

fn require(so: bool) -> Result<(), Fault> {
    if so { Ok(()) } else { Err(Fault::Wrong) }
}
