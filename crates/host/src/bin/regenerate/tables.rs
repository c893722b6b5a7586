//! The tables of the pages: which rows each has, and which figures stand in a row.

use crate::sources::{Sources, grouped};
use crate::{host, rejection, scene, tradeoff};
use microwarp_host::docs::Doc;
use microwarp_host::registry::{Domain, Registered, of_poly};
use microwarp_host::upkeep::{Outcome, read, wrapped};
use microwarp_list::{FLOAT_WARPS, GRADED_WARPS, Listed};

/// The generated blocks, by the names in their marks.
pub fn block(name: &str, sources: &Sources) -> Outcome<String> {
    match name {
        "warps" => warps(sources),
        "names" => names(),
        "listed Line" => listed(Group::Line),
        "listed Plane" => listed(Group::Plane),
        "listed Directions" => listed(Group::Directions),
        "selections" => beside(
            sources,
            "selections",
            "| | ns, PCG32 included | Cortex-M4F, PCG32 included | Cortex-M0, PCG32 included |",
        ),
        "chains" => beside(sources, "chains", "| | ns | Cortex-M4F | Cortex-M0 |"),
        "generators" => beside(
            sources,
            "generators",
            "| a word; `fixed::Disk::draw` | ns | Cortex-M4F | Cortex-M0 |",
        ),
        "integers" => integers(sources),
        "cheapest" => tradeoff::cheapest(&sources.counts),
        "peers" => Ok(rows(&sources.peers)),
        "renderers" => Ok(rows(&sources.renderers)),
        "firmware" => firmware(),
        "c" => c(sources),
        "pictures" => scene::pictures(),
        "paths" => scene::paths(sources),
        "ingredients" => scene::ingredients(sources),
        "scene" => scene::accuracy(),
        "six" => six(sources),
        "constant" => host::constant(&sources.counts),
        "extremes" => host::extremes(&sources.counts),
        "rejection cycles" => rejection::table(&sources.counts),
        _ => Err(format!("no table is called {name}")),
    }
}

/// One figure in a sentence, by the words in its mark.
pub fn figure(expression: &str, sources: &Sources) -> Outcome<String> {
    let words: Vec<&str> = expression.split_whitespace().collect();
    let number = match words[..] {
        ["instructions", core, kernel] => sources.instructions(core, kernel)?,
        ["about", core, kernel] => hundreds(sources.instructions(core, kernel)?),
        ["flash", core, name] => sources.flash(core, name)?,
        ["golden", "words"] => sources.golden().0,
        ["golden", "cases"] => sources.golden().1,
        ["cycles", core, kernel] => sources.whole(core, kernel, "cycles_high")?,
        ["slow", kernel] => sources.whole("m0", kernel, "cycles_slow")?,
        ["longest", core, kernel] => sources.whole(core, kernel, "longest")?,
        ["cost", "fixed", name] => return cost(GRADED_WARPS, "fine", name, sources),
        ["cost", name] => return cost(FLOAT_WARPS, "poly", name, sources),
        ["point", kernel] => return price(["m4f", "m0"], kernel, sources),
        ["ns", bench, name] => return sources.nanoseconds(bench, name),
        _ => return Err(format!("no figure is called {expression:?}")),
    };
    Ok(grouped(number))
}

/// To the nearest hundred.
fn hundreds(number: u64) -> u64 {
    (number + 50) / 100 * 100
}

/// Rows of a Markdown table; a cell of dashes and colons says how its column is aligned.
pub fn rows(rows: &[Vec<String>]) -> String {
    let cell = |cell: &String| match cell.trim_matches([':', '-']) {
        _ if cell.is_empty() => " ".into(),
        "" => cell.clone(),
        _ => format!(" {cell} "),
    };
    let row = |cells: &Vec<String>| {
        let cells: Vec<String> = cells.iter().map(cell).collect();
        format!("|{}|\n", cells.join("|"))
    };
    rows.iter().map(row).collect()
}

/// What the warps are grouped by where all are listed.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Group {
    Line,
    Plane,
    Directions,
}

/// The warps of a group, by the domains of their entries, each with its documentation; in the order of `crates/list`.
fn members(group: Group) -> impl Iterator<Item = (&'static str, Doc)> {
    let all = of_poly();
    let group_of = move |name: &str| {
        let of = all.iter().filter(|of| of.name == name);
        let entry = of.flat_map(Registered::entries).next()?;
        Some(match entry.domain {
            Domain::Line => Group::Line,
            Domain::Directions | Domain::World | Domain::Rotations => Group::Directions,
            _ => Group::Plane,
        })
    };
    let members = FLOAT_WARPS.iter().map(|warp| warp.name);
    let members = members.filter(move |name| group_of(name) == Some(group));
    members.filter_map(|name| Some((name, Doc::find("warp", name)?)))
}

/// The names of all warps, for the README.
fn names() -> Outcome<String> {
    let groups = [Group::Line, Group::Plane, Group::Directions].map(|group| {
        let names: Vec<String> = members(group)
            .map(|(name, _)| format!("`{name}`"))
            .collect();
        let lines = wrapped(&format!("- **{group:?}**: {}", names.join(", ")), 120);
        lines.join("\n  ") + "\n"
    });
    Ok(groups.concat())
}

/// The warps of a group with the sentences that their pages begin with, for the page of the crate.
fn listed(group: Group) -> Outcome<String> {
    let lines = members(group).flat_map(|(name, doc)| {
        let sentence = doc.sentence();
        let text = format!("- [`{name}`](warp::{name}): {sentence}");
        let lines = wrapped(&text, 116).into_iter().enumerate();
        lines.map(|(i, line)| format!("//! {}{line}\n", if i > 0 { "  " } else { "" }))
    });
    Ok(lines.collect::<String>() + "//! ")
}

/// A row of a table.
struct Row {
    label: &'static str,
    /// The benches on the host; or a type, and the row of its table of errors.
    of: &'static str,
    kernels: Vec<&'static str>,
}

impl Row {
    /// Those of a table.
    fn all(table: &str) -> impl Iterator<Item = Self> {
        let lines = include_str!("rows.txt").lines();
        lines.filter_map(move |line| {
            let mut cells = line.split('|').map(str::trim);
            (cells.next() == Some(table)).then(|| {
                let mut cell = || cells.next().unwrap_or_default();
                Self {
                    label: cell(),
                    of: cell(),
                    kernels: cell().split(", ").collect(),
                }
            })
        })
    }

    /// A type, the row of its errors, and a kernel.
    fn stated(&self) -> (&'static str, &'static str, &'static str) {
        let (name, error) = self.of.split_once(": ").unwrap_or_default();
        (name, error, self.kernels[0])
    }
}

/// The rows of the README's table.
const SIX: [&str; 6] = [
    "Disk",
    "CosineHemisphere",
    "PhongLobe",
    "Exponential",
    "NormalPair",
    "Triangle",
];

fn six(sources: &Sources) -> Outcome<String> {
    let mut text = String::from(
        "| in `poly` | largest error | ns, PC | Cortex-M4F | Cortex-M0 | M0, `fixed` | flash, M4F |\n\
         |---|--:|--:|--:|--:|--:|--:|\n",
    );
    for name in SIX {
        let mut warps = Row::all("warps").map(|row| row.stated());
        let warp = warps.find(|(warp, ..)| *warp == name);
        let (_, error, kernel) = warp.ok_or_else(|| format!("no warp {name}"))?;
        let integer = GRADED_WARPS.iter().find(|warp| warp.name == name);
        let integer = integer.and_then(|warp| warp.kernels.first());
        let integer = integer.ok_or_else(|| format!("no integer warp beside {name}"))?;
        let nanoseconds = sources.nanoseconds("warps", &format!("poly::draw::{kernel}"))?;
        let kernel = format!("poly_{kernel}_pcg32");
        let unit = if error.contains("ulp") { " ulp" } else { "" };
        text += &rows(&[vec![
            format!("`{name}`"),
            sources.stated(name, error, "poly")? + unit,
            nanoseconds,
            grouped(sources.instructions("m4f", &kernel)?),
            grouped(sources.instructions("m0", &kernel)?),
            grouped(sources.instructions("m0", &format!("fine_{integer}_pcg32"))?),
            grouped(sources.code_at_s("m4f", &kernel)?),
        ]]);
    }
    Ok(text)
}

/// What a draw of a warp costs, for its documentation: in `poly` with a floating-point unit first, in `fine` without one.
fn cost(list: &[Listed], tier: &str, name: &str, sources: &Sources) -> Outcome<String> {
    let warp = list.iter().find(|warp| warp.name == name);
    let kernel = warp.and_then(|warp| warp.kernels.first());
    let kernel = kernel.ok_or_else(|| format!("{name} has no cost kernel"))?;
    let kernel = format!("{tier}_{kernel}_pcg32");
    match tier {
        "poly" => price(["m4f", "m0"], &kernel, sources),
        _ => price(["m0", "m3"], &kernel, sources),
    }
}

/// What a kernel costs on two cores, and its code on the first.
fn price(cores: [&str; 2], kernel: &str, sources: &Sources) -> Outcome<String> {
    let on =
        |core: &str| Ok::<_, String>((sources.instructions(core, kernel)?, core.to_uppercase()));
    let [(first, here), (second, there)] = [on(cores[0])?, on(cores[1])?];
    let [first, second] = [first, second].map(grouped);
    let flash = grouped(sources.code_at_s(cores[0], kernel)?);
    Ok(format!(
        "{first} instructions and {flash} bytes of code on an {here}, {second} instructions on an {there}"
    ))
}

fn warps(sources: &Sources) -> Outcome<String> {
    let mut text = String::from(
        "| warp | error, `libm` | error, `poly` | ns, `libm` | ns, `poly` | ns filled, `poly` | Cortex-M4F, `poly` | Cortex-M0, `poly` | WASM, `poly` | flash on M4F |\n\
         |---|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n",
    );
    for row in Row::all("warps") {
        let (name, error, kernel) = row.stated();
        let drawn = format!("poly_{kernel}_pcg32");
        let unit = if error.contains("ulp") { " ulp" } else { "" };
        let mut cells = vec![row.label.to_string()];
        for tier in ["libm", "poly"] {
            cells.push(sources.stated(name, error, tier)? + unit);
        }
        for action in ["libm::draw::", "poly::draw::", "poly::fill::"] {
            cells.push(sources.nanoseconds("warps", &format!("{action}{kernel}"))?);
        }
        for core in ["m4f", "m0", "wasm"] {
            cells.push(grouped(sources.instructions(core, &drawn)?));
        }
        cells.push(grouped(sources.code_at_s("m4f", &drawn)?));
        text += &rows(&[cells]);
    }
    Ok(text)
}

/// Nanoseconds, and instructions on an M4F and an M0.
fn beside(sources: &Sources, table: &str, header: &str) -> Outcome<String> {
    let mut text = format!("{header}\n|---|--:|--:|--:|\n");
    for line in Row::all(table) {
        let benches = line.of.split(", ").filter(|bench| !bench.is_empty());
        let nanoseconds = |bench: &str| match bench.split_once(' ') {
            Some(("peers", family)) => rejection(sources, family),
            Some((bench, name)) => sources.nanoseconds(bench, name),
            None => Err(format!("no bench {bench}")),
        };
        let on = |core| {
            line.kernels
                .iter()
                .map(|kernel| Ok(grouped(sources.instructions(core, kernel)?)))
                .collect()
        };
        let cells: [Outcome<Vec<String>>; 3] =
            [benches.map(nanoseconds).collect(), on("m4f"), on("m0")];
        let mut row = vec![line.label.to_string()];
        for cell in cells {
            row.push(cell?.join(", "));
        }
        text += &rows(&[row]);
    }
    Ok(text)
}

/// What rejection took beside the peers, to a tenth.
fn rejection(sources: &Sources, family: &str) -> Outcome<String> {
    let cell = sources.peer(family, "rejection")?;
    let value: f64 = cell
        .parse()
        .map_err(|_| format!("peers.md: {family}: {cell}"))?;
    Ok(format!("{value:.1}"))
}

/// The first number of a statement: of several, or of a formula whose first is the factor or the most.
fn first_number(statement: &str) -> &str {
    let start = statement.find(|c: char| c.is_ascii_digit()).unwrap_or(0);
    let rest = &statement[start..];
    let end = rest.find(|c: char| !(c.is_ascii_digit() || ".e-".contains(c)));
    &rest[..end.unwrap_or(rest.len())]
}

fn integers(sources: &Sources) -> Outcome<String> {
    let mut text = String::from(
        "| | error, fine, coarse | M0: fine | coarse | compact | `f32` over fine | `poly` | `libm` | M3: fine | coarse | `poly` | flash on M0, fine | stack |\n\
         |---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n",
    );
    for line in Row::all("integers") {
        let (name, title, kernel) = line.stated();
        let float = line.kernels.get(1).copied();
        let grades: &[&str] = if name == "Grade" {
            &["[`Fine`]", "[`Coarse`]"]
        } else {
            &["fine", "coarse"]
        };
        let mut errors = Vec::new();
        for grade in grades {
            errors.push(first_number(&sources.stated(name, title, grade)?).to_string());
        }
        let mut row = vec![line.label.to_string(), errors.join(", ")];
        let columns = [
            ("m0", "fine", Some(kernel)),
            ("m0", "coarse", Some(kernel)),
            ("m0", "compact", Some(kernel)),
            ("m0", "fine_float", Some(kernel)),
            ("m0", "poly", float),
            ("m0", "libm", float),
            ("m3", "fine", Some(kernel)),
            ("m3", "coarse", Some(kernel)),
            ("m3", "poly", float),
        ];
        for (core, tier, kernel) in columns {
            let kernel = kernel.map(|kernel| format!("{tier}_{kernel}"));
            // Not every warp has a kernel with floats outside.
            let kernel = kernel.filter(|kernel| tier != "fine_float" || sources.has_kernel(kernel));
            let cell = kernel
                .map(|kernel| sources.instructions(core, &kernel))
                .transpose()?;
            row.push(cell.map_or(String::new(), grouped));
        }
        let fine = format!("fine_{kernel}");
        row.push(grouped(sources.code_at_s("m0", &fine)?));
        row.push(grouped(sources.stack("m0", &fine)?));
        text += &rows(&[row]);
    }
    Ok(text)
}

/// The rows of a table of examples/firmware, and by which compiler.
pub fn of_firmware(file: &str) -> Outcome<(String, Vec<[String; 4]>)> {
    let path = format!("examples/firmware/{file}");
    let text = read(&path)?;
    let compiler = text.lines().next().unwrap_or_default();
    let row = |row: &str| {
        let cells: Vec<String> = row.split(',').map(String::from).collect();
        cells.try_into().map_err(|_| format!("{path}: {row}"))
    };
    let rows = text.lines().skip(2).map(row).collect::<Outcome<_>>()?;
    Ok((compiler.trim_start_matches("# ").into(), rows))
}

/// What the application of examples/firmware occupies.
fn firmware() -> Outcome<String> {
    let (compiler, sizes) = of_firmware("sizes.csv")?;
    let mut text = format!(
        "Bytes of the linked image, {compiler}:\n\n| program | target | flash | RAM |\n|---|---|--:|--:|\n"
    );
    for [program, target, flash, ram] in sizes {
        let name = match &*program {
            "app" => "`app`",
            "app_rtt" => "`app`, log by RTT",
            _ => continue,
        };
        text += &rows(&[vec![name.into(), format!("`{target}`"), flash, ram]]);
    }
    Ok(text)
}

/// Functions that draw in C beside those in Rust, and a whole program in C, on both cores.
fn c(sources: &Sources) -> Outcome<String> {
    const CORES: [(&str, &str); 2] = [
        ("m0", "thumbv6m-none-eabi"),
        ("m4f", "thumbv7em-none-eabihf"),
    ];
    const IN_RUST: [(&str, &str); 6] = [
        ("disk", "poly_disk_pcg32"),
        ("exponential", "poly_exponential_1_pcg32"),
        ("normal_pair", "poly_normal_pair_pcg32"),
        ("phong_lobe", "poly_phong_lobe_50_pcg32"),
        ("fixed_disk", "fine_disk_pcg32"),
        ("fixed_exponential", "fine_exponential_20_pcg32"),
    ];
    let in_c = read("bindings/c/tests/sizes/sizes.csv")?;
    let figures = |name: &str, target: &str| {
        let named = format!("{name},{target},");
        let mut lines = in_c.lines();
        let found = lines.find_map(|line| line.strip_prefix(&named)?.split_once(','));
        found
            .map(|(first, second)| [first.to_owned(), second.to_owned()])
            .ok_or(format!("no sizes of {name} on {target}"))
    };
    let mut text =
        "| bytes of flash | M0: C | Rust | program | M4F: C | Rust | program |\n|---|--:|--:|--:|--:|--:|--:|\n"
            .to_owned();
    for (name, kernel) in IN_RUST {
        let mut row = vec![format!("`mw_{name}_draw`")];
        for (core, target) in CORES {
            let [alone, program] = figures(name, target)?;
            let in_rust = sources.flash(core, kernel)?.to_string();
            row.extend([alone, in_rust, program]);
        }
        text += &rows(&[row]);
    }
    Ok(text)
}
