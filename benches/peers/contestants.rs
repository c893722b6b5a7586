//! The names of contestants, the same in all contests.

/// The words that the map of the family takes, and nothing made of them.
pub const FLOOR: &str = "generator alone";
pub const LIBM: &str = "libm";
pub const POLY: &str = "poly";
pub const FINE: &str = "fixed, in f32";
pub const COARSE: &str = "fixed::coarse, in f32";
pub const COMPACT: &str = "fixed::compact, in f32";
pub const REJECTION: &str = "rejection";
pub const RAND_DISTR: &str = "rand_distr";
pub const MICROMATH: &str = "micromath";
pub const TEXTBOOK: &str = "plain libm";
/// The maps that renderers write by hand, in `f32` over std.
pub const PUBLISHED: &str = "published form";
/// Of normals, which the tiers draw in pairs: one at a time.
pub const LIBM_SINGLE: &str = "libm, one at a time";
pub const POLY_SINGLE: &str = "poly, one at a time";
/// Of slices, which the tiers fill: one point after the other.
pub const DRAWN: &str = "poly, one by one";
/// Of tables, which have no tier: the index alone, and the index with its probability and the leftover uniform.
pub const INDEX: &str = "index";
pub const SELECTION: &str = "index, pmf, leftover";
/// Of integers, by two words in place of one; of orders, by a word an item.
pub const WIDE: &str = "by two words";
pub const EACH: &str = "a word an item";
