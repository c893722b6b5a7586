//! The integer kernels: raw words in and out.
