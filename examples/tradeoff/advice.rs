//! Conclusions from the figures: which tier to take when, and where a peer beats every one of our points.

use crate::front::{Trade, cheapest, is_outside};
use crate::report::cost_text;
use crate::study::{Study, TARGETS};
use host::registry::family::PICTURED;
use host::table;
use std::collections::BTreeMap;

/// Errors that a user may want to stay below.
const CLASSES: [f64; 4] = [1e-3, 1e-5, 1e-6, 5e-7];

/// The samplers of a family whose error and cost on a target are known.
pub fn traded<'a>(
    studies: &'a [Study],
    family: &str,
    target: usize,
    ours: bool,
) -> Vec<(&'a Study, Trade)> {
    let of_family = studies
        .iter()
        .filter(|s| s.sampler.family == family && s.sampler.ours == ours);
    of_family
        .filter_map(|s| Some((s, s.trade(target)?)))
        .collect()
}

fn families(studies: &[Study]) -> Vec<&'static str> {
    let mut families: Vec<&str> = studies.iter().map(|s| s.sampler.family).collect();
    families.dedup();
    families
}

/// The cheapest within each class of error, of the families that there is a picture of; on cores also by the longest.
pub fn which(studies: &[Study]) {
    println!(
        "Which tier to take: the cheapest whose largest error is within the bound, generator included. On the cores in \
         cycles: the\nmean, and the longest seen.\n"
    );
    for (target, title) in TARGETS.iter().enumerate() {
        let mean = |_: &Study, trade: Trade| Some(trade);
        let longest = |study: &Study, trade: Trade| {
            let cost = study.longest(target)?;
            Some(Trade { cost, ..trade })
        };
        println!("{title}:");
        of_target(studies, target, &mean);
        if studies.iter().any(|study| study.longest(target).is_some()) {
            println!("{title}, by the longest:");
            of_target(studies, target, &longest);
        }
    }
    println!();
}

/// By costs that are made of the means.
fn of_target(studies: &[Study], target: usize, cost: &dyn Fn(&Study, Trade) -> Option<Trade>) {
    for class in CLASSES {
        let mut chosen: BTreeMap<&str, Vec<String>> = BTreeMap::new();
        let mut none = Vec::new();
        for family in PICTURED {
            let ours: Vec<(&Study, Trade)> = traded(studies, family, target, true)
                .into_iter()
                .filter_map(|(study, trade)| Some((study, cost(study, trade)?)))
                .collect();
            let trades: Vec<Trade> = ours.iter().map(|(_, trade)| *trade).collect();
            match cheapest(&trades, class) {
                Some(i) => {
                    let cost = cost_text(Some(trades[i].cost));
                    let tier = ours[i].0.sampler.tier;
                    chosen
                        .entry(tier)
                        .or_default()
                        .push(format!("{family} {cost}"));
                }
                None if !trades.is_empty() => none.push(family),
                None => {}
            }
        }
        let mut parts: Vec<(&str, Vec<String>)> = chosen.into_iter().collect();
        parts.sort_by_key(|(_, families)| std::cmp::Reverse(families.len()));
        let mut text: Vec<String> = parts
            .iter()
            .map(|(tier, families)| format!("{tier} ({})", families.join(", ")))
            .collect();
        if !none.is_empty() {
            text.push(format!("none of ours ({})", none.join(", ")));
        }
        let text = if text.is_empty() {
            "not measured".into()
        } else {
            text.join("; ")
        };
        println!("  error to {class:.0e}: {text}");
    }
}

/// A peer's point that none of our points covers.
pub struct Outside {
    row: Vec<String>,
}

/// All of them, and how many points of peers there are on each target beside ours.
pub fn outside(studies: &[Study]) -> (Vec<Outside>, [usize; TARGETS.len()]) {
    let (mut all, mut peers) = (Vec::new(), [0; TARGETS.len()]);
    for (target, title) in TARGETS.iter().enumerate() {
        for family in families(studies) {
            let ours = traded(studies, family, target, true);
            let trades: Vec<Trade> = ours.iter().map(|(_, trade)| *trade).collect();
            if trades.is_empty() {
                // None of our samplers has been measured there, so nothing can be said about the peers.
                continue;
            }
            for (peer, trade) in traded(studies, family, target, false) {
                peers[target] += 1;
                if !is_outside(&trade, &trades) {
                    continue;
                }
                let best = cheapest(&trades, trade.error).map(|i| (i, trades[i].cost));
                let accurate = (0..trades.len())
                    .filter(|i| trades[*i].cost <= trade.cost)
                    .min_by(|a, b| trades[*a].error.total_cmp(&trades[*b].error));
                let named = |i: usize| ours[i].0.sampler.label();
                all.push(Outside {
                    row: vec![
                        (*title).into(),
                        family.into(),
                        peer.sampler.label(),
                        cost_text(Some(trade.cost)),
                        format!(
                            "{}{:.2e}",
                            if peer.sampler.errs_at_least() {
                                "≥ "
                            } else {
                                ""
                            },
                            trade.error
                        ),
                        best.map_or("none".into(), |(i, cost)| {
                            format!(
                                "{}: {} ({:.2} times)",
                                named(i),
                                cost_text(Some(cost)),
                                cost / trade.cost
                            )
                        }),
                        accurate.map_or("none".into(), |i| {
                            format!("{}: {}", named(i), format_args!("{:.2e}", trades[i].error))
                        }),
                    ],
                });
            }
        }
    }
    (all, peers)
}

pub fn print((outside, peers): &(Vec<Outside>, [usize; TARGETS.len()])) {
    let counts: Vec<String> = TARGETS
        .iter()
        .zip(peers)
        .map(|(target, peers)| {
            let out = outside.iter().filter(|o| o.row[0] == *target).count();
            match peers {
                0 => format!("{target}: none has been measured"),
                _ => format!("{target}: {out} of {peers}"),
            }
        })
        .collect();
    println!(
        "Points of peers on or outside our front, which none of ours covers by being as cheap and as accurate. {}.\n",
        counts.join("; ")
    );
    if !outside.is_empty() {
        let header = [
            "target",
            "family",
            "peer",
            "cost",
            "error",
            "our cheapest that is as accurate",
            "our most accurate that is as cheap",
        ];
        table::print(&header, outside.iter().map(|o| o.row.clone()).collect(), 3);
    }
}
