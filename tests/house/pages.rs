//! What a newcomer reads: the README, the crate's page, the pages of the samplers, and the links between them.

use crate::{code, files, missing, of_rooms, read, root};
use host::docs::Doc;
use microwarp_list::FLOAT_WARPS;
use std::collections::BTreeSet;
use std::path::Path;

/// The text of the comments in front of a module's items.
fn head(code: &str) -> String {
    let lines = code.lines().filter_map(|line| line.strip_prefix("//!"));
    lines.fold(String::new(), |all, line| all + line.trim_start() + "\n")
}

/// What a room makes public beside its samplers: results, and parts of others.
const BESIDE: &str = "AliasEntry Cursor Error06 ExactSelection Failure FromFn Halves HastingsCounts HastingsRatio \
    LogDensity MeshPoint Outcome PixelSample Proposal Saved ScreenPixel Selection Start Symmetric Transition choose_with \
    primary_density r_hat shuffle_with try_choose try_choose_with try_shuffle try_shuffle_each try_shuffle_with \
    try_up_to up_to_from_word wrapping_add";

/// The names that a page shows as code.
fn shown(page: &str) -> BTreeSet<&str> {
    page.split('`').skip(1).step_by(2).collect()
}

#[test]
fn the_crate_page_lists_every_sampler() {
    let page = head(&read("src/lib.rs"));
    let mut names = of_rooms(&code("src"));
    names.extend(FLOAT_WARPS.iter().map(|warp| warp.name.to_owned()));
    assert!(names.len() > 80, "{} names are seen", names.len());
    // What is spared must exist, and a name that is left out is noticed.
    let gone: Vec<_> = BESIDE
        .split(' ')
        .filter(|name| !names.remove(*name))
        .collect();
    assert_eq!(gone, [""; 0]);
    assert_eq!(missing(&names, &shown(&page)), [""; 0]);
    let two = BTreeSet::from(["Disk", "Ring"]);
    assert_eq!(missing(&two, &shown("a `Disk` is no Ring")), ["Ring"]);
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
    let (mut pages, mut found) = (0, Vec::new());
    for place in ["src", "docs", "examples", "README.md"] {
        for (path, mut text) in files(place, &[".rs", ".md"]) {
            if path.ends_with(".rs") {
                let comments = text
                    .lines()
                    .filter(|line| line.trim_start().starts_with("//"));
                text = comments.collect::<Vec<_>>().join("\n");
            }
            let cells = starred(&text).into_iter();
            found.extend(cells.map(|cell| format!("{path}: {cell}")));
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
fn targets(page: &str) -> Vec<&str> {
    let targets = page
        .split("](")
        .skip(1)
        .filter_map(|rest| rest.split(')').next());
    let targets = targets.map(|target| target.split('#').next().unwrap_or_default());
    targets
        .filter(|t| !t.is_empty() && !t.contains("://") && !t.contains(' '))
        .collect()
}

#[test]
fn links_between_pages_lead_somewhere() {
    let mut pages = Vec::new();
    for place in [
        "README.md",
        "ARCHITECTURE.md",
        "CONTRIBUTING.md",
        "CHANGELOG.md",
        "bindings/c/README.md",
        "crates/cores/README.md",
        "docs",
        "examples",
    ] {
        pages.extend(files(place, &[".md"]));
    }
    assert!(pages.len() > 16, "{} pages", pages.len());
    let mut broken = Vec::new();
    for (path, text) in &pages {
        let folder = root().join(Path::new(path).parent().unwrap());
        let targets = targets(text).into_iter();
        broken.extend(targets.filter(|target| !folder.join(target).exists()));
    }
    assert_eq!(broken, [""; 0]);
    assert_eq!(
        targets("[a](docs/a.md#b), [c](https://d) ![e](f.png)"),
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
