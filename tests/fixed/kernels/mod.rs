//! Kernels are tried over one of every 16 of the 2³² words and at all edges, in the quick speed over one of every 2048;
//! with `MICROWARP_FULL=all` in the environment over every word there is, which takes half an hour. Beside them: laws,
//! distributions, and what of the warps follows from the errors of kernels.

mod cases;
mod composed;
mod controls;
mod distributions;
mod edges;
mod figures;
mod inputs;
mod laws;
mod measured;
mod rim;
mod rising;
mod shapes;
mod wrong_maps;
