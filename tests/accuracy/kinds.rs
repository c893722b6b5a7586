//! Each row of a table of errors says of which kind its bounds are, and `docs/proofs.md` lists those that are not found.

use host::docs::{Kind, of_errors};
use host::root;
use std::collections::BTreeMap;

/// The rooms whose pages have tables of errors.
const ROOMS: [&str; 5] = ["warp", "discrete", "fixed", "estimate", "metropolis"];

/// The cells of a row in Markdown.
fn cells(line: &str) -> Vec<&str> {
    let cells = line.trim_matches('|').split('|');
    cells.map(str::trim).collect()
}

/// What stands under a heading of a page, up to the next.
fn section<'a>(page: &'a str, heading: &str) -> &'a str {
    let (_, from) = page.split_once(heading).expect("a heading");
    from.split("\n## ").next().unwrap_or_default()
}

/// Of a page such as `warp::Disk` and the title of a row, the kind that the list gives, and by what.
fn listed(page: &str) -> BTreeMap<(String, String), (Kind, String)> {
    let rows = section(page, "\n## Kinds\n").lines();
    let rows = rows.filter(|line| line.starts_with("| `")).map(cells);
    let mut all = BTreeMap::new();
    for row in rows {
        let [pages, titles, kind, by] = row[..] else {
            panic!("{row:?} is no row of the list");
        };
        let kind = Kind::parse(kind).expect("a kind");
        assert!(kind != Kind::Found, "what is found is not listed");
        for page in pages.split('`').skip(1).step_by(2) {
            for title in titles.split("; ") {
                let before = all.insert((page.into(), title.into()), (kind, by.into()));
                assert!(before.is_none(), "{page}: {title} is listed twice");
            }
        }
    }
    all
}

/// What is wrong with the kinds of rows, by a list.
fn complaints(
    stated: &[(String, String, Option<Kind>)],
    listed: &BTreeMap<(String, String), (Kind, String)>,
) -> Vec<String> {
    let mut complaints = Vec::new();
    for (page, title, kind) in stated {
        let due = listed.get(&(page.clone(), title.clone()));
        let due = due.map_or(Kind::Found, |(kind, _)| *kind);
        match kind {
            None => complaints.push(format!("{page}: {title} says no kind")),
            Some(kind) if *kind != due => complaints.push(format!(
                "{page}: {title} says {}, and docs/proofs.md {}",
                kind.name(),
                due.name()
            )),
            Some(_) => {}
        }
    }
    for (page, title) in listed.keys() {
        if !stated.iter().any(|(p, t, _)| (p, t) == (page, title)) {
            complaints.push(format!("no row {title} of {page}, which is listed"));
        }
    }
    complaints
}

#[test]
fn each_row_says_its_kind_and_no_more_than_is_shown() {
    let stated: Vec<_> = ROOMS
        .into_iter()
        .flat_map(|room| of_errors(room).into_iter().map(move |of| (room, of)))
        .flat_map(|(room, (item, rows))| {
            let page = format!("{room}::{item}");
            rows.into_iter()
                .map(move |row| (page.clone(), row.title, row.kind))
        })
        .collect();
    assert!(stated.len() > 350, "{} rows", stated.len());
    let page = std::fs::read_to_string(root().join("docs/proofs.md")).expect("a page");
    let listed = listed(&page);
    let wrong = complaints(&stated, &listed);
    assert!(wrong.is_empty(), "\n{}", wrong.join("\n"));

    // Those of `tests/proofs` are the rows of its tables, but for the pairs with parameters.
    let figures = section(&page, "\n## The figures\n").lines();
    let figures = figures.filter(|line| {
        let head = line.starts_with("| map") || line.starts_with("| warp");
        line.starts_with("| ") && !head
    });
    let mut proven: Vec<_> = figures
        .map(|line| {
            let title = match cells(line)[1] {
                "sample" => "sample, of the size",
                title => title,
            };
            let title = title.to_owned();
            (format!("warp::{}", cells(line)[0]), title)
        })
        .filter(|(page, _)| page != "warp::NormalPair")
        .collect();
    proven.sort();
    let by_proofs = listed.iter().filter(|(_, (_, by))| by == "`tests/proofs`");
    let by_proofs: Vec<_> = by_proofs.map(|(row, _)| row.clone()).collect();
    assert_eq!(by_proofs, proven);

    // A row without a kind is seen, one that says too much or too little, and one that has gone.
    let row = |k: usize| ("warp::Disk".to_owned(), stated[k].1.clone(), None);
    assert!(!complaints(&[row(0)], &BTreeMap::new()).is_empty());
    for (is, due) in [(Kind::Proven, None), (Kind::Found, Some(Kind::Proven))] {
        let (page, title, _) = row(0);
        let key = (page.clone(), title.clone());
        let list = due.map(|kind| (key, (kind, String::new())));
        let list = list.into_iter().collect();
        assert!(!complaints(&[(page, title, Some(is))], &list).is_empty());
    }
    assert!(!complaints(&[], &listed).is_empty());
}
