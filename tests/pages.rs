//! What a newcomer reads: the README, the crate's page, the pages of the samplers, and the links between them.

use host::docs::Doc;
use microwarp_list::FLOAT_WARPS;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn read(path: &str) -> String {
    fs::read_to_string(root().join(path)).unwrap_or_else(|e| panic!("{path}: {e}"))
}

/// The text of the comments in front of a module's items.
fn head(code: &str) -> String {
    let lines = code.lines().filter_map(|line| line.strip_prefix("//!"));
    lines.fold(String::new(), |all, line| all + line.trim_start() + "\n")
}

/// The names of a room's `pub use` lines.
fn public(room: &str) -> Vec<&str> {
    let lists = room.split("\npub use ").skip(1);
    let names = lists.flat_map(|list| {
        let list = list.split(';').next().unwrap_or_default();
        let list = list.rsplit("::").next().unwrap_or_default();
        list.split(|c: char| !c.is_alphanumeric() && c != '_')
    });
    names.filter(|name| !name.is_empty()).collect()
}

/// What a room makes public beside its samplers: traits, results, and parts of others.
const BESIDE: [&str; 45] = [
    "Accepted",
    "AliasEntry",
    "Chance",
    "Coordinates",
    "Cursor",
    "Error06",
    "ExactSelection",
    "Failure",
    "FromFn",
    "Grid",
    "Halves",
    "HastingsCorrection",
    "HastingsCounts",
    "HastingsRatio",
    "LARGEST",
    "LargeSmall",
    "LogDensity",
    "MAX_DIMENSIONS",
    "MAX_STRATA",
    "MeshPoint",
    "Mutation",
    "Mutations",
    "Outcome",
    "OwnedStorage",
    "PixelSample",
    "Points",
    "Proposal",
    "Rejection",
    "SMALLEST",
    "SLACK",
    "Saved",
    "Selection",
    "StateSource",
    "Start",
    "StepLaw",
    "Storage",
    "Symmetric",
    "TargetDensity",
    "TargetValue",
    "Transition",
    "Word",
    "budget_for",
    "primary_density",
    "r_hat",
    "wrapping_add",
];

/// The names that a page does not show as code.
fn unlisted<'a>(names: &[&'a str], page: &str) -> Vec<&'a str> {
    let shown = |name: &&&str| page.contains(&format!("`{name}`"));
    names.iter().filter(|name| !shown(name)).copied().collect()
}

#[test]
fn the_crate_page_lists_every_sampler() {
    let page = head(&read("src/lib.rs"));
    let rooms = ["discrete", "rejection", "metropolis", "estimate", "uniform"];
    let rooms = rooms.map(|room| read(&format!("src/{room}.rs"))).concat();
    let mut names: Vec<_> = FLOAT_WARPS.iter().map(|warp| warp.name).collect();
    names.extend(public(&rooms));
    assert!(names.len() > 80, "{} names are seen", names.len());
    let beside: BTreeSet<_> = BESIDE.into_iter().collect();
    names.retain(|name| !beside.contains(name));
    assert_eq!(unlisted(&names, &page), [""; 0]);
    // What is spared must exist, and a name that is left out is noticed.
    let gone: Vec<_> = BESIDE
        .iter()
        .filter(|name| !rooms.contains(**name))
        .collect();
    assert!(gone.is_empty(), "{gone:?}");
    assert_eq!(unlisted(&["Disk", "Ring"], &page), ["Ring"]);
}

/// The page of a warp, in whichever room it is.
fn page_of(name: &str) -> Option<String> {
    let found = ["warp", "discrete"]
        .iter()
        .find_map(|room| Doc::find(room, name));
    found.map(|doc| doc.text())
}

/// Cells of tables that lose their stars where they are rendered: two outside of code are emphasis.
fn starred(page: &str) -> Vec<&str> {
    let lines = page.lines().map(|line| line.trim_start());
    let lines = lines.map(|line| line.trim_start_matches("///").trim_start_matches("//!"));
    let rows = lines
        .map(str::trim)
        .filter(|line| line.starts_with('|') && line.ends_with('|'));
    let bare = |cell: &&str| {
        cell.split('`')
            .step_by(2)
            .map(|text| text.matches('*').count())
            .sum()
    };
    let cells = rows.flat_map(|row| row.split('|'));
    cells
        .filter(|cell| {
            let stars: usize = bare(cell);
            stars > 1
        })
        .collect()
}

#[test]
fn no_cell_of_a_table_loses_its_stars() {
    let mut open = vec![
        root().join("src"),
        root().join("docs"),
        root().join("examples"),
    ];
    open.push(root().join("README.md"));
    let (mut pages, mut found) = (0, Vec::new());
    while let Some(path) = open.pop() {
        if path.is_dir() && !path.ends_with("target") {
            open.extend(
                fs::read_dir(path)
                    .unwrap()
                    .map(|entry| entry.unwrap().path()),
            );
        } else if path.extension().is_some_and(|e| e == "rs" || e == "md") {
            let mut text = fs::read_to_string(&path).unwrap();
            if path.extension().is_some_and(|e| e == "rs") {
                let comments = text
                    .lines()
                    .filter(|line| line.trim_start().starts_with("//"));
                text = comments.collect::<Vec<_>>().join("\n");
            }
            found.extend(
                starred(&text)
                    .into_iter()
                    .map(|cell| format!("{path:?}: {cell}")),
            );
            pages += 1;
        }
    }
    println!("{pages} files");
    assert!(pages > 200, "{pages}");
    assert!(found.is_empty(), "{found:#?}");
    // As GGX had it; one star, code and what is no table are whole.
    let row = "/// | pdf | 1e-6 + 5*s + 6e-7*q | 2*s | `a*b*c` |\n/// a * b * c";
    assert_eq!(starred(row), [" 1e-6 + 5*s + 6e-7*q "]);
}

/// What the page of a warp lacks.
fn lacks(page: &str) -> Vec<&'static str> {
    let needed = [
        "/// # Density",
        "/// # Domain",
        "/// # Accuracy",
        "/// # Examples",
        "/// # See also",
        "/pictures/",
    ];
    needed
        .into_iter()
        .filter(|part| !page.contains(part))
        .collect()
}

/// Without such a page, since they are no distributions.
const WITHOUT: [(&str, &str); 2] = [
    ("Frame", "no warp, but what `Oriented` is made of"),
    ("Spherical", "coordinates"),
];

#[test]
fn every_warp_has_a_page_with_its_density_domain_errors_example_siblings_and_picture() {
    let spared = |name: &str| WITHOUT.iter().any(|(without, _)| *without == name);
    let pages = FLOAT_WARPS.iter().filter(|warp| !spared(warp.name));
    let mut wanting = Vec::new();
    for warp in pages {
        let page = page_of(warp.name).unwrap_or_default();
        let lacks = lacks(&page);
        if !lacks.is_empty() {
            wanting.push((warp.name, lacks));
        }
    }
    assert!(wanting.is_empty(), "{wanting:#?}");
    let disk = page_of("Disk").unwrap();
    assert_eq!(
        lacks(&disk.replace("# Domain", "# Range")),
        ["/// # Domain"]
    );
    assert!(page_of("Dis").is_none());
}

/// The targets of a page's links and pictures that are files, relative to the page.
fn files(page: &str) -> Vec<&str> {
    let targets = page
        .split("](")
        .skip(1)
        .filter_map(|rest| rest.split(')').next());
    let targets = targets.map(|target| target.split('#').next().unwrap_or_default());
    targets
        .filter(|t| !t.is_empty() && !t.contains("://") && !t.contains(' '))
        .collect()
}

fn broken(page: &Path) -> Vec<PathBuf> {
    let text = fs::read_to_string(page).unwrap();
    let folder = page.parent().unwrap();
    let targets = files(&text).into_iter().map(|target| folder.join(target));
    targets.filter(|path| !path.exists()).collect()
}

#[test]
fn links_between_pages_lead_somewhere() {
    let mut pages: Vec<PathBuf> = Vec::new();
    for folder in [
        "",
        "docs",
        "examples",
        "examples/firmware",
        "examples/firmware-c",
        "examples/web",
    ] {
        let inside = fs::read_dir(root().join(folder))
            .unwrap()
            .map(|e| e.unwrap().path());
        pages.extend(inside.filter(|path| path.extension().is_some_and(|e| e == "md")));
    }
    assert!(pages.len() > 10);
    let broken: Vec<_> = pages.iter().flat_map(|page| broken(page)).collect();
    assert!(broken.is_empty(), "{broken:?}");
    assert_eq!(
        files("[a](docs/a.md#b), [c](https://d) ![e](f.png)"),
        ["docs/a.md", "f.png"]
    );
}

#[test]
fn the_readme_is_short_and_its_code_is_whole() {
    let text = read("README.md");
    assert!(text.len() <= 7000, "{} bytes", text.len());
    let blocks: Vec<_> = text
        .split("```rust\n")
        .skip(1)
        .filter_map(|rest| rest.split("```").next())
        .collect();
    assert!(blocks.len() >= 2);
    for block in blocks {
        assert!(block.contains("fn main()"), "{block}");
        assert!(!block.lines().any(|line| line.starts_with("# ")), "{block}");
    }
}
