//! The integer tier before the adversary: every warp in every grade, made of raw words and judged on raw words.

mod directions;
mod exact;
mod family;
mod flawed;
mod line;
mod plane;
mod triangle;

use family::Family;
use support::adversary;

fn families() -> Vec<adversary::Family> {
    let mut all = Vec::new();
    line::families(&mut all);
    plane::families(&mut all);
    triangle::families(&mut all);
    directions::families(&mut all);
    exact::families(&mut all);
    all.into_iter().map(Family::stated).collect()
}

#[test]
fn statements_hold_for_all_parameters_and_words() {
    adversary::hold(&families(), "fixed_warps/worst.csv");
}
