//! The acceptance: as exact as stated, from densities and ratios of any magnitude.
