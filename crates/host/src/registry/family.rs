//! The headings under which samplers of one law are compared.

pub const DISK: &str = "disk";
pub const SPHERE: &str = "sphere";
pub const HEMISPHERE: &str = "hemisphere";
pub const COSINE: &str = "cosine hemisphere";
pub const LOBE: &str = "lobe n = 50";
pub const EXPONENTIAL: &str = "exponential";
pub const NORMAL: &str = "two normals";
pub const INTERVAL: &str = "interval";
pub const POWER: &str = "power law";
pub const TRUNCATED: &str = "truncated exponential";
pub const LINE: &str = "tent, line, inversion";
pub const LAW: &str = "law of the line";
pub const TRIANGLE: &str = "triangle";
pub const CAP: &str = "cone, patch";
pub const COMPOSED: &str = "composed";
pub const BALL: &str = "ball";
pub const TABLE: &str = "table of 1024 weights";

/// Those of which there is a picture.
pub const PICTURED: [&str; 7] = [DISK, SPHERE, HEMISPHERE, COSINE, LOBE, EXPONENTIAL, NORMAL];
