//! The pictures of the example `scene` have the same bits everywhere: their hashes on this machine are those of
//! `tests/golden/scene.csv`. Firmware and WASM are held to the same table. `cargo regenerate` adds the lines of new pictures;
//! it changes others only where they are named.

use host::parallel::{in_parallel, threads};
use microwarp_scene::golden::{Case, Room, cases, hash};
use microwarp_scene::{Plan, Random};
use std::path::Path;

/// One row a picture.
fn rows() -> Vec<String> {
    let cases: Vec<Case> = cases().collect();
    in_parallel(threads(), &cases, |case| {
        let hash = (case.hash)(&case.plan).expect("the cameras see something");
        format!("{case},{:08x}", hash.word())
    })
}

/// The first row in which a table differs, counting a missing one as different.
fn first_difference(table: &str, rows: &[String]) -> Option<usize> {
    let mut golden = table.lines().filter(|line| !line.starts_with('#'));
    let differs = rows
        .iter()
        .position(|row| golden.next() != Some(row.as_str()));
    differs.or_else(|| golden.next().map(|_| rows.len()))
}

/// And a flipped bit, a missing row, one too many and an empty table do not pass.
#[test]
fn pictures_have_the_golden_hashes() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden/scene.csv");
    let table = std::fs::read_to_string(path).expect("the table is checked in");
    let rows = rows();
    assert_eq!(rows.len(), 42);
    if let Some(row) = first_difference(&table, &rows) {
        panic!("row {row}: now {:?}", rows.get(row));
    }
    println!("{} pictures, none differs", rows.len());

    let flipped: Vec<String> = table.lines().map(String::from).collect();
    for at in 1..flipped.len() {
        let mut flipped = flipped.clone();
        let digit = flipped[at].pop().and_then(|digit| digit.to_digit(16));
        flipped[at] += &format!("{:x}", digit.expect("a hash") ^ 1);
        assert_eq!(first_difference(&flipped.join("\n"), &rows), Some(at - 1));
    }
    let short = table.trim_end().rsplit_once('\n').unwrap().0;
    assert_eq!(first_difference(short, &rows), Some(41));
    let long = format!("{table}{}\n", rows[0]);
    assert_eq!(first_difference(&long, &rows), Some(42));
    assert_eq!(first_difference("", &rows), Some(0));
}

/// Whatever a picture depends on changes its hash: scene, tier, points, size, samples and seed.
#[test]
fn another_picture_has_another_hash() {
    let rows = rows();
    let mut hashes: Vec<&str> = rows
        .iter()
        .map(|row| row.rsplit_once(',').unwrap().1)
        .collect();
    hashes.sort_unstable();
    hashes.dedup();
    assert_eq!(hashes.len(), rows.len());
    let plan = Plan {
        size: [12, 8],
        samples: 2,
        seed: 1,
    };
    let of = |plan: Plan| hash::<Room, microwarp::tier::Poly, Random>(&plan).unwrap();
    assert_eq!(of(plan), of(plan));
    for other in [
        Plan {
            size: [8, 12],
            ..plan
        },
        Plan { samples: 3, ..plan },
        Plan { seed: 2, ..plan },
    ] {
        assert_ne!(of(other), of(plan));
    }
}
