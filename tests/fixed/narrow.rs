//! The kernels as they are compiled for cores with products of 32 bits.

#![allow(dead_code, reason = "each test uses a part")]

pub(super) const NARROW: bool = true;

#[path = "../../src/fixed/kernel/angle.rs"]
pub(super) mod angle;
#[path = "../../src/fixed/kernel/exp.rs"]
pub(super) mod exp;
#[path = "../../src/fixed/kernel/float.rs"]
pub(super) mod float;
#[path = "../../src/fixed/kernel/log.rs"]
pub(super) mod log;
#[path = "../../src/fixed/kernel/product.rs"]
pub(super) mod product;
#[path = "../../src/fixed/kernel/root.rs"]
pub(super) mod root;
#[path = "../../src/fixed/kernel/sine.rs"]
pub(super) mod sine;
#[path = "../../src/fixed/kernel/tables.rs"]
pub(super) mod tables;
