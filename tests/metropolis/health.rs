//! The health figures against their definitions in f64.
