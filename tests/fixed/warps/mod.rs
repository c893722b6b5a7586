//! Each warp by its words, pair by pair; its errors for all parameters, by an adversary; and its inverse and its density.

mod bilinear;
mod directions;
mod exponential;
mod families;
mod figures;
mod float;
mod interval;
mod multivariate_normal;
mod normal;
mod parameters;
mod tent;
mod triangle;
mod triangle_on;
mod truncated;
