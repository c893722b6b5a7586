//! Prints and writes the standings.

use crate::args::*;
use crate::families::*;
use host::cli as table;
use host::contest::{Quartiles, Standings};
use std::fmt::Write;

pub type Results = [(Family, Standings)];

/// If a quarter of all ratios spread more than this, the machine was busy.
const NOISY: f64 = 0.05;

/// The median, and the quartiles in brackets.
fn text(quartiles: Option<Quartiles>) -> String {
    quartiles.map_or(
        String::new(),
        |Quartiles {
             lower,
             median,
             upper,
         }| { format!("{median:.2} [{lower:.2}, {upper:.2}]") },
    )
}

/// The median alone, of what there is.
fn median(quartiles: Option<Quartiles>) -> String {
    quartiles.map_or(String::new(), |q| format!("{:.2}", q.median))
}

fn of_kind(results: &Results, kind: Kind) -> impl Iterator<Item = &(Family, Standings)> {
    results
        .iter()
        .filter(move |(family, _)| family.kind == kind)
}

/// A table of each family.
pub fn tables(results: &Results, kind: Kind) {
    for (family, standings) in of_kind(results, kind) {
        let (peer, beside) = match kind {
            Kind::Weighed => (PUBLISHED, "the published form's"),
            _ => (RAND_DISTR, "rand_distr's"),
        };
        println!("{}; {peer} is {}", family.title(), family.peer);
        let rows = standings.names().map(|name| {
            vec![
                name.into(),
                text(standings.nanoseconds(name)),
                text(standings.ratio(name, peer)),
                text(standings.ratio(name, TEXTBOOK)),
            ]
        });
        let beside = format!("of {beside} time");
        let mut header = vec!["", "ns a sample", &beside, "of plain libm's time"];
        let mut rows: Vec<Vec<String>> = rows.collect();
        if standings.nanoseconds(TEXTBOOK).is_none() {
            header.pop();
            rows.iter_mut().for_each(|row| row.truncate(header.len()));
        }
        table::print(&header, rows, 1);
    }
}

/// A goal: one contestant takes at most this multiple of another's time.
struct Target<'a> {
    family: &'a Family,
    name: &'static str,
    other: &'static str,
    most: f64,
    ratio: Quartiles,
    floor: Option<Quartiles>,
}

impl<'a> Target<'a> {
    fn all(results: &'a Results) -> Vec<Self> {
        let asked = [
            (Kind::Draw, POLY, RAND_DISTR, 1.0),
            (Kind::Draw, POLY_SINGLE, RAND_DISTR, 1.0),
            (Kind::Draw, LIBM, TEXTBOOK, 1.0),
            (Kind::Draw, INDEX, RAND_DISTR, 1.0),
            (Kind::Fill, POLY, RAND_DISTR, 1.0 / 3.0),
            (Kind::Weighed, POLY, PUBLISHED, 1.0),
        ];
        let targets = results.iter().flat_map(|(family, standings)| {
            asked.iter().filter_map(move |&(kind, name, other, most)| {
                let ratio = standings.ratio(name, other)?;
                let floor = standings.ratio(FLOOR, other);
                (family.kind == kind).then_some(Target {
                    family,
                    name,
                    other,
                    most,
                    ratio,
                    floor,
                })
            })
        });
        targets.collect()
    }
}

/// The goals and whether they are reached, with quartiles. No sampler can fall below the generator's own share of the
/// other's time.
pub fn targets(results: &Results) {
    let rows = Target::all(results).into_iter().map(|target| {
        let ratio = target.ratio;
        let verdict = match target.most {
            most if ratio.upper <= most => "reached",
            most if ratio.median <= most => "reached, within the noise",
            most if ratio.lower <= most => "missed, within the noise",
            _ => "missed",
        };
        vec![
            target.family.title(),
            format!("{} of {}'s time", target.name, target.other),
            format!("{:.2}", target.most),
            text(Some(ratio)),
            median(target.floor),
            verdict.into(),
        ]
    });
    let header = ["", "", "at most", "measured", "generator alone", ""];
    table::print(&header, rows.collect(), 2);
}

/// One row per family, for the page.
pub fn summary(results: &Results) {
    let contests = of_kind(results, Kind::Draw).map(|(family, standings)| {
        let ns = |name: &str| median(standings.nanoseconds(name));
        let fill = of_kind(results, Kind::Fill).find(|(other, _)| other.name == family.name);
        let faster = fill.and_then(|(_, fill)| fill.ratio(RAND_DISTR, POLY));
        let ours = if standings.nanoseconds(POLY).is_some() {
            POLY
        } else {
            INDEX
        };
        vec![
            format!("{} (`{}`)", family.name, family.peer),
            ns(RAND_DISTR),
            ns(FLOOR),
            ns(ours),
            text(standings.ratio(ours, RAND_DISTR)),
            faster.map_or(String::new(), |q| format!("{:.2}", q.median)),
            ns(LIBM),
            text(standings.ratio(LIBM, TEXTBOOK)),
            ns(REJECTION),
            ns(FINE),
            ns(MICROMATH),
        ]
    });
    let header = [
        "",
        "rand_distr",
        "generator",
        "`poly`, or the index",
        "of rand_distr's time",
        "`fill`, times faster",
        "`libm`",
        "of the formula's time",
        "rejection",
        "`fixed` in `f32`",
        "micromath",
    ];
    table::print(&header, contests.collect(), 1);
}

/// One row per contest with densities, for the same page.
pub fn weighed(results: &Results) {
    let contests = of_kind(results, Kind::Weighed).map(|(family, standings)| {
        let ns = |name: &str| median(standings.nanoseconds(name));
        vec![
            format!("{} ({})", family.name, family.peer),
            ns(PUBLISHED),
            ns(FLOOR),
            ns(POLY),
            text(standings.ratio(POLY, PUBLISHED)),
            ns(LIBM),
            text(standings.ratio(LIBM, PUBLISHED)),
        ]
    });
    let header = [
        "with density",
        "published form",
        "generator",
        "`poly`",
        "of its time",
        "`libm`",
        "of its time",
    ];
    table::print(&header, contests.collect(), 1);
}

/// Warns if the machine was busy: on a quiet one, the ratio of two samplers hardly varies.
pub fn noise(results: &Results) {
    let spreads = results.iter().flat_map(|(_, standings)| {
        [RAND_DISTR, PUBLISHED].into_iter().flat_map(move |peer| {
            let others = standings.names().filter(move |&name| name != peer);
            others.filter_map(move |name| Some(standings.ratio(name, peer)?.spread()))
        })
    });
    let Quartiles { median, upper, .. } = Quartiles::of(spreads);
    let verdict = if upper <= NOISY {
        "quiet"
    } else {
        "NOT QUIET, measure again"
    };
    println!(
        "The quartiles of a ratio are {:.1} % of it apart in the median, {:.1} % and more in a quarter of all: {verdict}.",
        100.0 * median,
        100.0 * upper
    );
}

/// Every figure: nanoseconds a sample and ratios, each as lower quartile, median and upper quartile.
pub fn csv(results: &Results) -> String {
    let mut csv = String::from("family,kind,peer,contestant");
    for figure in ["ns", "of_rand_distr", "of_plain_libm", "of_published"] {
        let _ = write!(csv, ",{figure}_lower,{figure}_median,{figure}_upper");
    }
    csv.push('\n');
    for (family, standings) in results {
        let kind = match family.kind {
            Kind::Draw => "draw",
            Kind::Fill => "fill",
            Kind::Weighed => "weighed",
        };
        for name in standings.names() {
            let _ = write!(csv, "{},{kind},\"{}\",\"{name}\"", family.name, family.peer);
            let figures = [
                standings.nanoseconds(name),
                standings.ratio(name, RAND_DISTR),
                standings.ratio(name, TEXTBOOK),
                standings.ratio(name, PUBLISHED),
            ];
            for figure in figures {
                match figure {
                    Some(Quartiles {
                        lower,
                        median,
                        upper,
                    }) => {
                        let _ = write!(csv, ",{lower:.4},{median:.4},{upper:.4}");
                    }
                    None => csv.push_str(",,,"),
                }
            }
            csv.push('\n');
        }
    }
    csv
}
