//! A point of a set that lies in memory, by its index, among the first 1,024 where the bits of the index count.

use crate::measured::registry::{kernels, loaded, made};
use microwarp::Error;
use microwarp::uniform::{ByPosition, LatinHypercube, Points, Recurrence, Screen, Sobol};

fn pixel() -> Result<ByPosition, Error> {
    Ok(ByPosition::new(7, 1))
}

fn screen() -> Result<Screen<Sobol<2>>, Error> {
    Screen::new(Sobol::new(7)?, [2048, 2048], 4, 7)
}

kernels! {
    "sobol_2d" (index: u32) -> [u32; 2] = loaded(|| Sobol::<2>::new(7)).words(index),
        _ = made(|| Sobol::<2>::new(7));
    "sobol_8d" (index: u32) -> u32 =
        loaded(|| Sobol::<8>::new(7)).words::<8>(index >> 22).into_iter().fold(0, |all, word| all ^ word),
        _ = made(|| Sobol::<8>::new(7));
    "recurrence_2d" (index: u32) -> [u32; 2] = loaded(|| Recurrence::<2>::new(7)).words(index),
        _ = made(|| Recurrence::<2>::new(7));
    "latin_hypercube_1000" (index: u32) -> [u32; 2] = loaded(|| LatinHypercube::new(1000, 7)).words(index >> 23),
        _ = made(|| LatinHypercube::new(1000, 7));
    "screen_sobol_2d" (place: u32) -> [u32; 2] = loaded(screen).pixel(place >> 21, place >> 10 & 0x7ff).words(place >> 6 & 15),
        _ = made(screen);
    "by_position_2" (index: u32) -> [u32; 2] = loaded(pixel).words(index), _ = made(pixel);
}
