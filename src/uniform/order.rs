//! Orders of items: shuffles.

use super::infallible;
use crate::num::up_to;
use rand_core::{Rng, TryRng};

/// Puts items in a random order, by few words.
///
/// # Domain
/// - Items: any number up to 2³². Of more, the later ones are exchanged with one of the first 2³² alone.
/// - Words: a number that depends on the number of items alone. Two words make as many exchanges as have up to 2³² outcomes.
///
/// | items | words |
/// |--:|--:|
/// | 2 to 12 | 2 |
/// | 20 | 6 |
/// | 52 | 16 |
/// | 256 | 116 |
/// | 1,000 | 612 |
/// | 65,536 | 64,938 |
/// | one more | 2 more |
///
/// # Accuracy
/// The probability of each order is that of all others to a relative error of 2⁻³³ times the number of words: 1.9e-9 for 52 items.
///
/// # Examples
/// ```
/// use microwarp::uniform;
/// use rand_pcg::Pcg32;
/// let mut deck: [u8; 52] = core::array::from_fn(|card| card as u8);
/// uniform::shuffle(&mut deck, &mut Pcg32::new(1, 1));
/// assert_ne!(deck[..4], [0, 1, 2, 3]);
/// deck.sort();
/// assert_eq!(deck[..4], [0, 1, 2, 3]);
/// ```
///
/// # See also
/// - [`shuffle_each`]: fewer instructions on a core that multiplies slowly.
/// - [`choose`](super::choose): some items alone.
/// - [`Permutation`](super::Permutation): an order that needs no memory.
///
/// # Source
/// R. Durstenfeld, "Algorithm 235: Random permutation", 1964, <https://doi.org/10.1145/364520.364540>; several exchanges by a word:
/// N. Brackett-Rozinsky, D. Lemire, "Batched Ranged Random Integer Generation", 2024, <https://doi.org/10.1002/spe.3369>.
#[doc(alias = "permute")]
#[doc(alias = "Fisher-Yates")]
#[inline]
pub fn shuffle<T, R: Rng + ?Sized>(items: &mut [T], rng: &mut R) {
    infallible(try_shuffle(items, rng));
}

/// [`shuffle`], with a generator that can fail.
///
/// # Errors
/// The generator's own error. The items may be in another order then.
#[inline]
pub fn try_shuffle<T, R: TryRng + ?Sized>(items: &mut [T], rng: &mut R) -> Result<(), R::Error> {
    try_shuffle_with(items.len(), rng, |i, j| exchange(items, i, j))
}

/// [`shuffle`] of what is no slice: `swap(i, j)` exchanges items i and j, where i < j.
///
/// ```
/// use microwarp::uniform;
/// use rand_pcg::Pcg32;
/// let (mut names, mut ages) = (["Ada", "Emmy", "Sofia"], [36, 53, 41]);
/// uniform::shuffle_with(3, &mut Pcg32::new(2, 1), |i, j| {
///     names.swap(i, j);
///     ages.swap(i, j);
/// });
/// let emmy = names.iter().position(|name| *name == "Emmy");
/// assert_eq!(emmy.map(|place| ages[place]), Some(53));
/// ```
#[inline]
pub fn shuffle_with<R: Rng + ?Sized>(count: usize, rng: &mut R, swap: impl FnMut(usize, usize)) {
    infallible(try_shuffle_with(count, rng, swap));
}

/// [`shuffle_with`], with a generator that can fail.
///
/// # Errors
/// The generator's own error. Some items may have been exchanged then.
pub fn try_shuffle_with<R: TryRng + ?Sized>(
    count: usize,
    rng: &mut R,
    mut swap: impl FnMut(usize, usize),
) -> Result<(), R::Error> {
    const WORDS: u64 = 1 << 32;
    let size = |left: usize| (left as u64).min(WORDS);
    let mut left = count;
    while left > 1 {
        let mut words = joined(rng.try_next_u32()?, rng.try_next_u32()?);
        let mut outcomes = size(left);
        while left > 1 && outcomes <= WORDS {
            let place;
            (place, words) = whole_and_rest(words, size(left));
            left = left.wrapping_sub(1);
            if place < left {
                swap(place, left);
            }
            outcomes = outcomes.saturating_mul(size(left));
        }
    }
    Ok(())
}

/// Two words, in the form that a core multiplies by the fewest instructions.
#[cfg(target_pointer_width = "64")]
type Words = u64;
#[cfg(not(target_pointer_width = "64"))]
type Words = (u32, u32);

#[cfg(target_pointer_width = "64")]
#[inline]
fn joined(high: u32, low: u32) -> Words {
    u64::from(high) << 32 | u64::from(low)
}

#[cfg(not(target_pointer_width = "64"))]
#[inline]
fn joined(high: u32, low: u32) -> Words {
    (high, low)
}

/// The integer below a number of up to 2³² that two words give, and what they leave, which is uniform again.
#[cfg(target_pointer_width = "64")]
#[inline]
fn whole_and_rest(words: Words, number: u64) -> (usize, Words) {
    let product = u128::from(words).wrapping_mul(u128::from(number));
    ((product >> 64) as usize, product as u64)
}

#[cfg(not(target_pointer_width = "64"))]
#[inline]
fn whole_and_rest((high, low): Words, number: u64) -> (usize, Words) {
    let lower = u64::from(low).wrapping_mul(number);
    let upper = u64::from(high)
        .wrapping_mul(number)
        .wrapping_add(lower >> 32);
    ((upper >> 32) as usize, (upper as u32, lower as u32))
}

/// Puts items in a random order, by a word for each but the last: the form for firmware.
///
/// It takes fewer instructions than [`shuffle`], and more words. Its order is another.
///
/// # Domain
/// - Items: any number up to 2³². Of more, the first ones are exchanged with one of the next 2³² alone.
/// - Words: one less than there are items.
///
/// # Accuracy
/// The probability of each of the orders of n items is that of all others to a relative error of n(n + 1)·2⁻³³: 3.2e-7 for 52.
///
/// # Examples
/// ```
/// use microwarp::uniform;
/// use rand_pcg::Pcg32;
/// let mut channels = [1, 6, 11];
/// uniform::shuffle_each(&mut channels, &mut Pcg32::new(1, 1));
/// assert_eq!(channels.iter().sum::<u8>(), 18);
/// ```
///
/// # Source
/// R. Durstenfeld, "Algorithm 235: Random permutation", 1964, <https://doi.org/10.1145/364520.364540>.
#[inline]
pub fn shuffle_each<T, R: Rng + ?Sized>(items: &mut [T], rng: &mut R) {
    infallible(try_shuffle_each(items, rng));
}

/// [`shuffle_each`], with a generator that can fail.
///
/// # Errors
/// The generator's own error. The items may be in another order then.
#[inline]
pub fn try_shuffle_each<T, R: TryRng + ?Sized>(
    items: &mut [T],
    rng: &mut R,
) -> Result<(), R::Error> {
    let count = items.len();
    first_places(count, count.saturating_sub(1), rng, |i, j| {
        exchange(items, i, j);
    })
}

/// Fills the first places, each by one of the items from there on.
#[inline]
pub(super) fn first_places<R: TryRng + ?Sized>(
    count: usize,
    places: usize,
    rng: &mut R,
    mut swap: impl FnMut(usize, usize),
) -> Result<(), R::Error> {
    for (place, left) in (0..places).zip((0..count).rev()) {
        let last = u32::try_from(left).unwrap_or(u32::MAX);
        let steps = up_to(last, rng.try_next_u32()?) as usize;
        if steps > 0 {
            swap(place, place.wrapping_add(steps));
        }
    }
    Ok(())
}

/// Exchanges items i and j, where i < j.
#[inline]
pub(super) fn exchange<T>(items: &mut [T], i: usize, j: usize) {
    if let Some((before, [later, ..])) = items.split_at_mut_checked(j) {
        if let Some(earlier) = before.get_mut(i) {
            core::mem::swap(earlier, later);
        }
    }
}
