//! Tests of what is drawn: every panel has dots, shading and a frame, all inside its cell, and dots lie where shading is.

use crate::area::{Paper, outline};
use crate::{Subject, args, sheet, strata, subjects};
use host::draw::canvas::{Area, Canvas};
use host::parallel::{in_parallel, threads};
use host::registry::picture::{CORNER, View};
use host::registry::{Entry, Point, entries_of_each_tier};
use rand_pcg::Pcg32;

/// The cell of a panel, and the white around it that must stay white.
const CELL: Area = Area {
    x: 20.0,
    y: 20.0,
    w: 150.0,
    h: 132.0,
};
const SIZE: [u32; 2] = [190, 172];
const UNIT: f32 = 0.6;

/// What a drawn panel lacks.
fn lacks(canvas: &Canvas, view: View) -> Vec<&'static str> {
    let (mut dots, mut shade, mut lines, mut beyond) = (0, 0, 0, 0);
    for y in 0..SIZE[1] {
        for x in 0..SIZE[0] {
            let [r, g, b] = canvas.pixel(x, y).map(i32::from);
            dots += i32::from(r < 140 && b < 200);
            shade += i32::from(r > 145 && b > r + 2);
            lines += i32::from(r < 235 && (r - b).abs() < 40 && (r - g).abs() < 30);
            let [px, py] = [x, y].map(|n| n as f32 + 0.5);
            let inside =
                (CELL.x..CELL.x + CELL.w).contains(&px) && (CELL.y..CELL.y + CELL.h).contains(&py);
            beyond += i32::from(!inside && [r, g, b] != [255; 3]);
        }
    }
    let framed = match view {
        View::Line(_) | View::Strata1d | View::Strata2d => lines > 100,
        View::Sobol | View::Recurrence | View::ByPosition | View::Screen => lines > 100,
        // All along it something is drawn.
        view => outline(view, CELL, UNIT).iter().flatten().all(|[x, y]| {
            let near = [-1.0, 0.0, 1.0]
                .map(|d| [[x + d, *y], [*x, y + d]])
                .concat();
            let drawn = |[x, y]: [f32; 2]| canvas.pixel(x as u32, y as u32) != [255; 3];
            near.into_iter().any(drawn)
        }),
    };
    let found = [
        (dots < 60, "dots"),
        (shade < 400, "shading"),
        (!framed, "a frame"),
        (beyond > 0, "its place"),
    ];
    let lacking = found.into_iter().filter(|(lacks, _)| *lacks);
    lacking.map(|(_, what)| what).collect()
}

fn drawn(subject: &Subject, cell: Area) -> Canvas {
    let mut canvas = Canvas::new(SIZE[0], SIZE[1]);
    let args = args::Args {
        points: 200,
        ..args::Args::default()
    };
    sheet::panel(&mut canvas, cell, subject, 0, &args, UNIT);
    canvas
}

#[test]
fn every_panel_has_dots_shading_and_a_frame_inside_its_cell() {
    let entries = entries_of_each_tier();
    let subjects = subjects(&entries, &args::Args::default()).unwrap();
    assert!(subjects.len() >= 74, "{} panels", subjects.len());
    in_parallel(threads(), &subjects, |subject| {
        let canvas = drawn(subject, CELL);
        let lacking = lacks(&canvas, subject.picture.view);
        assert!(lacking.is_empty(), "{} lacks {lacking:?}", subject.name);
    });
    // What is drawn beside its cell is seen, and so is an empty page.
    let beside = Area {
        x: CELL.x + 6.0,
        ..CELL
    };
    let disk = subjects.iter().find(|s| s.name == "Interval").unwrap();
    let canvas = drawn(disk, beside);
    assert_eq!(lacks(&canvas, disk.picture.view), ["its place"]);
    let white = Canvas::new(SIZE[0], SIZE[1]);
    assert_eq!(
        lacks(&white, View::Sky(1.0)),
        ["dots", "shading", "a frame"]
    );
}

#[test]
fn the_banner_is_low_and_shows_a_dozen_warps_and_the_room() {
    let size = |path: &str| {
        let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
        let bytes = std::fs::read(root.join(path)).unwrap();
        // Of PNG, the header's first words: the width and the height.
        [16, 20].map(|at| u32::from_be_bytes(bytes[at..at + 4].try_into().unwrap()))
    };
    let low = |[_, height]: [u32; 2]| height <= 520;
    assert!(
        low(size("docs/banner.png")),
        "{:?}",
        size("docs/banner.png")
    );
    // What was README.md's picture until then is not.
    assert!(!low(size("docs/gallery.png")));
    let entries = entries_of_each_tier();
    let subjects = subjects(&entries, &args::Args::default()).unwrap();
    for name in crate::banner::SHOWN {
        assert!(subjects.iter().any(|s| s.name == name), "{name}");
    }
    let page = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/README.md")).unwrap();
    let pictures: Vec<&str> = page
        .match_indices("![")
        .map(|(at, _)| &page[at..])
        .collect();
    assert_eq!(pictures.len(), 1);
    assert!(pictures[0].contains("](docs/banner.png)"));
}

/// Cells along a side of the paper in which dots are looked for, and places along a side of a cell.
const CELLS: usize = 6;
const PLACES: usize = 10;

/// What is wrong with dots over a density: shares of dots beyond the paper and off the shading, and cells that are shaded and
/// have no dot.
fn wrong(entry: &Entry, view: View, density: &dyn Fn(&Paper, [f64; 2]) -> Option<f64>) -> String {
    const DOTS: usize = 3_000;
    let paper = Paper::new(view, entry);
    let middle = |cell: usize, place: usize| {
        let along = (place as f64 + 0.5) / PLACES as f64;
        2.0 * (cell as f64 + along) / CELLS as f64 - 1.0
    };
    let mut cells = vec![Vec::new(); CELLS * CELLS];
    for (k, cell) in cells.iter_mut().enumerate() {
        for i in 0..PLACES * PLACES {
            let at = [middle(k % CELLS, i % PLACES), middle(k / CELLS, i / PLACES)];
            cell.extend(density(&paper, at));
        }
    }
    let peak = cells.iter().flatten().copied().fold(0.0, f64::max);
    let (mut beyond, mut off, mut dots) = (0, 0, vec![0; CELLS * CELLS]);
    for point in entry.warp.fill(&mut Pcg32::new(7, 9), DOTS) {
        let at = paper.place(Point::map(point, f64::from));
        if !at.iter().all(|c| c.abs() <= 1.0) {
            beyond += 1;
            continue;
        }
        // Beside an edge the pixel decides.
        let near = [
            [0.0, 0.0],
            [0.01, 0.0],
            [-0.01, 0.0],
            [0.0, 0.01],
            [0.0, -0.01],
        ];
        let on = near.map(|d| density(&paper, [at[0] + d[0], at[1] + d[1]]).is_some());
        off += usize::from(on == [false; 5]);
        let [column, row] = at.map(|c| (((c + 1.0) * 0.5 * CELLS as f64) as usize).min(CELLS - 1));
        dots[row * CELLS + column] += 1;
    }
    let bare = cells.iter().zip(&dots).filter(|(places, dots)| {
        let dark = places.iter().filter(|density| **density > 0.25 * peak);
        dark.count() > PLACES * PLACES / 3 && **dots == 0
    });
    // A view of the upper faces shows half of a mesh, and a window on what has no end not all of it.
    let whole = if matches!(view, View::Faces(_)) {
        0.6
    } else {
        0.02
    };
    let mut found = Vec::new();
    if beyond as f64 > whole * DOTS as f64 {
        found.push(format!("{beyond} dots beyond the paper"));
    }
    if off as f64 > 0.004 * DOTS as f64 {
        found.push(format!("{off} dots off the shading"));
    }
    let bare = bare.count();
    if bare > 0 {
        found.push(format!("{bare} shaded cells without a dot"));
    }
    found.join(", ")
}

#[test]
fn dots_lie_where_shading_is() {
    let entries = entries_of_each_tier();
    let subjects = subjects(&entries, &args::Args::default()).unwrap();
    let mut seen = 0;
    let seen_density =
        |entry: &'_ Entry, view| wrong(entry, view, &|paper, at| paper.density(entry, at));
    for subject in &subjects {
        let Some(entry) = subject.entries.first() else {
            continue;
        };
        if matches!(subject.picture.view, View::Line(_)) {
            continue;
        }
        assert_eq!(
            seen_density(entry, subject.picture.view),
            "",
            "{}",
            subject.name
        );
        seen += 1;
    }
    assert!(seen >= 35, "{seen} pictures of areas");
    // As they once were: surfaces seen as triangles, and a density beyond the domain.
    let find = |name: &str| subjects.iter().find(|s| s.name == name).unwrap();
    for name in ["BoxSurface", "FrustumSurface", "CapsuleSurface"] {
        let wrong = seen_density(find(name).entries[0], CORNER);
        println!("control: {name} as a triangle: {wrong}");
        assert_ne!(wrong, "", "{name}");
    }
    let rotation = find("Rotation");
    let raw = |paper: &Paper, at| Some(rotation.entries[0].warp.pdf(paper.back(at)?).into());
    let wrong = wrong(rotation.entries[0], rotation.picture.view, &raw);
    println!("{seen} pictures; control: Rotation without its domain: {wrong}");
    assert_ne!(wrong, "");
}

#[test]
fn the_picture_of_a_screen_shows_what_it_does() {
    let size = |errors: &[f64]| {
        let squares: f64 = errors.iter().map(|error| error * error).sum();
        (squares / errors.len() as f64).sqrt()
    };
    let [each, all] = [false, true].map(strata::errors);
    let [before, after] = [
        size(&each) / size(&all),
        size(&strata::filtered(&each)) / size(&strata::filtered(&all)),
    ];
    println!("a set for each is off by {before:.3} of one for all, and filtered by {after:.3}");
    assert!((before - 1.0).abs() <= 0.05 && after >= 1.4);
    // In another order nothing cancels.
    let count = all.len();
    let stirred: Vec<f64> = (0..count).map(|k| all[k * 701 % count]).collect();
    let control = size(&strata::filtered(&each)) / size(&strata::filtered(&stirred));
    println!("control: stirred, by {control:.3}");
    assert!(control < 1.4);
}
