//! The way from a subject and a tier to a sampler.

use crate::run::Visit;
use crate::shared::Refusal;
use crate::subject::{Parameters, Subject};
use crate::{chains, float, integer, rejected, tables};
use microwarp::fixed::{Coarse, Compact, Fine};
use microwarp::tier::{Libm, Poly};

/// Builds a subject in a tier (0 `libm`, 1 `poly`, 2 to 4 the grades of the integer tier, 5 none) and hands it to
/// the visitor.
///
/// # Errors
/// What its constructor, or its drawing, says.
pub fn visit<V: Visit>(
    subject: Option<Subject>,
    tier: u32,
    p: &Parameters,
    visitor: &mut V,
) -> Result<(), Refusal> {
    let subject = subject.ok_or(Refusal::Unknown)?;
    match tier {
        0 => float::visit::<Libm, V>(subject, p, visitor),
        1 => float::visit::<Poly, V>(subject, p, visitor),
        2 => integer::visit::<Fine, V>(subject, p, visitor),
        3 => integer::visit::<Coarse, V>(subject, p, visitor),
        4 => integer::visit::<Compact, V>(subject, p, visitor),
        5 => match subject {
            Subject::IntegerChain => chains::of_integers(p, visitor),
            Subject::Cdf
            | Subject::Alias
            | Subject::PiecewiseConstant1d
            | Subject::PiecewiseConstant2d
            | Subject::SelectOnce
            | Subject::Reservoir => tables::visit(subject, p, visitor),
            _ => rejected::visit(subject, p, visitor),
        },
        _ => Err(Refusal::Unknown),
    }
}
