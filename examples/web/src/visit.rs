//! All lists of subjects, and the sampler for a number and a tier.

use crate::run::Visit;
use crate::shared::Refusal;
use crate::subject::Parameters;
use crate::{chains, float, integer, rejected, tables};
use microwarp::fixed::{Coarse, Compact, Fine};
use microwarp::tier::{Libm, Poly};

/// The descriptions for the page, list by list. Subjects are numbered from 0 in each list.
pub static LISTS: [&str; 7] = [
    float::WARPS,
    integer::WARPS,
    tables::TABLES,
    rejected::PLAIN,
    rejected::TIERED,
    chains::OF_DENSITY,
    chains::OF_INTEGERS,
];

/// Builds a subject of a list in a tier (0 `libm`, 1 `poly`, 2 to 4 the grades of the integer tier, 5 none) and hands
/// it to the visitor.
///
/// # Errors
/// What its constructor, or its drawing, says.
pub fn visit<V: Visit>(
    list: u32,
    subject: u32,
    tier: u32,
    p: &Parameters,
    visitor: &mut V,
) -> Result<(), Refusal> {
    match (list, tier) {
        (0, 0) => float::visit::<Libm, V>(subject, p, visitor),
        (0, 1) => float::visit::<Poly, V>(subject, p, visitor),
        (1, 2) => integer::visit::<Fine, V>(subject, p, visitor),
        (1, 3) => integer::visit::<Coarse, V>(subject, p, visitor),
        (1, 4) => integer::visit::<Compact, V>(subject, p, visitor),
        (2, 5) => tables::visit(subject, p, visitor),
        (3, 5) => rejected::plain(subject, p, visitor),
        (4, 0) => rejected::tiered::<Libm, V>(subject, p, visitor),
        (4, 1) => rejected::tiered::<Poly, V>(subject, p, visitor),
        (5, 0) => chains::of_density::<Libm, V>(subject, p, visitor),
        (5, 1) => chains::of_density::<Poly, V>(subject, p, visitor),
        (6, 5) => chains::of_integers(subject, p, visitor),
        _ => Err(Refusal::Unknown),
    }
}
