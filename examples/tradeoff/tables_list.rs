//! The list of tables, ours and the peers'.

use crate::sampler::{Chance, Row, Way};
use crate::subject::{Name, indices};
use host::peers::{rejecting, textbook};
use host::registry::family::TABLE;
use microwarp::Error;
use microwarp::discrete::{Alias, AliasEntry, Cdf};
use std::sync::Arc;

const ENTRIES: usize = 1024;

/// Weights of a table, no two neighbours alike.
fn weights() -> Vec<f32> {
    (0..ENTRIES).map(|i| (i * 37 % 101 + 1) as f32).collect()
}

/// Memory that lives as long as the program.
fn leaked<W: Copy + Default>(entries: usize) -> &'static mut [W] {
    Box::leak(vec![W::default(); entries].into_boxed_slice())
}

/// The probability that an entry should have.
fn due(weights: &[f32]) -> Vec<f64> {
    let total: f64 = weights.iter().map(|w| f64::from(*w)).sum();
    weights.iter().map(|w| f64::from(*w) / total).collect()
}

/// Probabilities, realised and reported, beside what they should be.
fn beside(weights: &[f32], chances: impl Fn(usize) -> (f64, Option<f32>)) -> Way {
    let due = due(weights).into_iter().enumerate();
    let chance = |(i, due)| {
        let (realised, reported) = chances(i);
        Chance {
            due,
            realised,
            reported: reported.map(f64::from),
        }
    };
    Way::Table(due.map(chance).collect())
}

/// How many of the uniforms k 2⁻²⁴ select an entry below this one, where the selection rises.
fn below(index: &dyn Fn([f32; 1]) -> usize, entry: usize) -> u32 {
    let (mut low, mut high) = (0_u32, 1 << 24);
    while low < high {
        let middle = low.midpoint(high);
        if index([middle as f32 / 16_777_216.0]) < entry {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    low
}

pub fn add(rows: &mut Vec<Row>) -> Result<(), Error> {
    let weights = weights();
    let of_words = |words: u64| words as f64 / 4_294_967_296.0;
    let name = |name, tier, kernel: &str| Name::new(TABLE, name, tier, kernel);

    let cdf = Cdf::<&[u32]>::new_in(&weights, leaked(ENTRIES))?;
    let way = beside(&weights, |i| (of_words(cdf.numerator(i)), Some(cdf.pmf(i))));
    let cdf_name = name("Cdf<u32>", "table", "cdf_1024");
    rows.push(indices(
        cdf_name,
        true,
        move |rng| cdf.draw_index(rng),
        &weights,
        way,
    ));

    let alias = Alias::<&[AliasEntry<u32>]>::new_in(&weights, leaked(ENTRIES))?;
    let way = beside(&weights, |i| {
        (of_words(alias.numerator(i)), Some(alias.pmf(i)))
    });
    let alias_name = name("Alias<u32>", "table", "alias_1024");
    rows.push(indices(
        alias_name,
        true,
        move |rng| alias.draw_index(rng),
        &weights,
        way,
    ));

    let sums = Arc::new(textbook::Sums::new(&weights));
    let edge = |i| below(&|u| sums.index(u), i);
    let way = beside(&weights, |i| {
        (f64::from(edge(i + 1) - edge(i)) / 16_777_216.0, None)
    });
    let textbook_name = name("sums in f32", "plain libm", "peer_plain_libm_sums_1024");
    let selection = host::peers::drawn(move |u: [f32; 1]| sums.index(u));
    let selection = Arc::new(selection);
    rows.push(indices(
        textbook_name,
        false,
        move |rng| selection(rng),
        &weights,
        way,
    ));

    let peer = |peer, kernel: &str| name(peer, "rand_distr", kernel);
    let weighted = Arc::new(rejecting::cumulative(&weights));
    let weighted_name = peer("WeightedIndex", "peer_rand_distr_weighted_index_1024");
    rows.push(indices(
        weighted_name,
        false,
        move |rng| weighted(rng),
        &weights,
        Way::Opaque,
    ));
    let aliases = Arc::new(rejecting::aliases(&weights));
    let aliases_name = peer(
        "WeightedAliasIndex",
        "peer_rand_distr_weighted_alias_index_1024",
    );
    rows.push(indices(
        aliases_name,
        false,
        move |rng| aliases(rng),
        &weights,
        Way::Opaque,
    ));
    Ok(())
}
