//! The headings under which samplers of one law are compared.

pub const DISK: &str = "disk";
pub const SPHERE: &str = "sphere";
pub const HEMISPHERE: &str = "hemisphere";
pub const COSINE: &str = "cosine hemisphere";
pub const LOBE: &str = "lobe n = 50";
pub const EXPONENTIAL: &str = "exponential";
pub const NORMAL: &str = "two normals";

/// All, in the order of the picture.
pub const PICTURED: [&str; 7] = [DISK, SPHERE, HEMISPHERE, COSINE, LOBE, EXPONENTIAL, NORMAL];
