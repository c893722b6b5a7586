//! The application's parts in many worlds: what one journey on a board shows is not luck.

use crate::dock::{advance, start};
use crate::journey::travel;
use crate::kept::{BURSTS, Kept};
use crate::world::{DOCK, Place, World, distance};
use crate::{DOCK_BOUND, STEPS, TRACK_BOUND};
use rand_pcg::Pcg32;
use zerocopy::{FromBytes, FromZeros, IntoBytes};

const WORLDS: u64 = 100;

/// Where the chain of a journey thinks the dock is.
fn found(answers: &[(Place, f32)], seed: u64) -> Place {
    let mut rng = Pcg32::new(seed, 10);
    let mut chain = start(answers, &mut rng).unwrap();
    advance(&mut chain, answers, BURSTS as u16 * STEPS, &mut rng).unwrap()
}

/// In how many worlds the tracker, and the chain, are within their bounds.
fn within(deaf: bool) -> (usize, usize) {
    let world = World::new().unwrap();
    let (mut tracked, mut docked) = (0, 0);
    for seed in 0..WORLDS {
        let journey = travel(&world, seed, deaf, |_, _, _| ()).unwrap();
        tracked += usize::from(journey.error <= TRACK_BOUND);
        docked += usize::from(distance(found(&journey.answers, seed), DOCK) <= DOCK_BOUND);
    }
    println!("deaf: {deaf}; of {WORLDS} worlds, tracked in {tracked}, docked in {docked}");
    (tracked, docked)
}

#[test]
fn nine_of_ten_rovers_are_tracked_and_seven_of_ten_docks_found() {
    let (tracked, docked) = within(false);
    assert!(tracked >= 90 && docked >= 70);
}

/// The control of both: guesses that hear nothing.
#[test]
fn a_deaf_rover_is_not_tracked_and_finds_no_dock() {
    let (tracked, docked) = within(true);
    assert!(tracked <= 1 && docked <= 5);
}

#[test]
fn a_range_that_no_guess_explains_is_refused_once_a_journey() {
    let world = World::new().unwrap();
    let heard = |_, range: f32, error| assert_eq!((range, error), (0.0, microwarp::Error::AllZero));
    assert_eq!(travel(&world, 42, false, heard).unwrap().refused, 1);
}

fn kept() -> Kept {
    let journey = travel(&World::new().unwrap(), 42, false, |_, _, _| ()).unwrap();
    let mut rng = Pcg32::new(42, 10);
    let mut chain = start(&journey.answers, &mut rng).unwrap();
    let mut kept = Kept::new(&chain, &journey.answers);
    let mean = advance(&mut chain, &journey.answers, STEPS, &mut rng).unwrap();
    kept.push(&chain, mean);
    assert_eq!(kept.chain(), Ok(chain));
    assert_eq!((kept.answers(), kept.bursts()), (journey.answers, 1));
    kept
}

/// Also what RAM holds by chance: nothing, or anything.
#[test]
fn a_changed_bit_of_what_was_kept_is_noticed() {
    let kept = kept();
    assert!(kept.is_sound());
    assert!(!Kept::new_zeroed().is_sound());
    let bytes = kept.as_bytes();
    for bit in 0..8 * bytes.len() {
        let mut changed = bytes.to_vec();
        changed[bit / 8] ^= 1 << (bit % 8);
        assert!(
            !Kept::read_from_bytes(&changed).unwrap().is_sound(),
            "bit {bit}"
        );
    }
}
