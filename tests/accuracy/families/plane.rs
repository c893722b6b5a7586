//! The constructors of the warps of the plane and of triangles in space.

use super::Constructor;
use microwarp::tier::Tier;

pub(super) fn constructors<T: Tier>() -> Vec<Constructor> {
    let _ = T::NAME;
    Vec::new()
}
