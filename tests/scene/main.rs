//! The path tracer of the example `scene`: its light, its bits, its twin in `f64`, and Metropolis light transport.

mod bits;
mod chains;
mod lamps;
mod light;
mod order;
mod twin;
