//! A point of a set that lies in memory, by its index, among the first 1,024 where the bits of the index count.

use crate::measured::registry::{kernels, loaded, made};
use microwarp::Error;
use microwarp::uniform::{ByPosition, LatinHypercube, Points, Recurrence, Sobol};

fn pixel() -> Result<ByPosition, Error> {
    Ok(ByPosition::new(7, 1))
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
    "by_position_2" (index: u32) -> [u32; 2] = loaded(pixel).words(index), _ = made(pixel);
}
