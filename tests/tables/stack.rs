//! Making a table takes no more of the stack than the documentation says.

use crate::storage::{UNIT, weights};
use microwarp::Warp;
use microwarp::discrete::{Alias, AliasEntry, Cdf, PiecewiseConstant1d, PiecewiseConstant2d};
use std::thread;

const KIB: usize = 1024;
/// What a thread takes of its stack before it calls anything.
const THREAD: usize = 16 * KIB;

/// Runs a function with so much of the stack. An overflow ends the process.
fn with_stack<T: Send>(bytes: usize, run: impl FnOnce() -> T + Send) -> T {
    thread::scope(|scope| {
        let thread = thread::Builder::new().stack_size(THREAD + bytes);
        let running = thread.spawn_scoped(scope, run).unwrap();
        running.join().unwrap()
    })
}

/// The map that by value is larger than the stack of a main thread allows.
const SHAPE: [usize; 2] = [1024, 512];
const ROWS: usize = 128;
type Array = PiecewiseConstant2d<[u32; ROWS], [[u32; 256]; ROWS]>;
static PICTURE: [[f32; 256]; ROWS] = [[1.5; 256]; ROWS];

fn array_map() -> f32 {
    let map = PiecewiseConstant2d::new(&PICTURE, UNIT, UNIT).unwrap();
    std::hint::black_box(&map).pdf([0.5, 0.5])
}

#[test]
fn making_a_table_takes_the_stated_stack() {
    let (cells, rows) = (SHAPE[0] * SHAPE[1], SHAPE[1]);
    let picture = weights(cells);
    // 2 KiB in borrowed memory and on the heap.
    let on_heap = with_stack(2 * KIB, || {
        type Map = PiecewiseConstant2d<Vec<u32>, Box<[u32]>>;
        Map::from_slice(&picture, SHAPE, UNIT, UNIT).unwrap()
    });
    let (mut marginal, mut conditional) = (vec![0; rows], vec![0; cells]);
    with_stack(2 * KIB, || {
        let (marginal, conditional) = (&mut marginal, &mut conditional);
        let map = PiecewiseConstant2d::new_in(&picture, SHAPE, UNIT, UNIT, marginal, conditional);
        assert_eq!(map.unwrap().as_words(), on_heap.as_words());
    });
    let mut bins = vec![AliasEntry::<u32>::EMPTY; cells];
    let numerator = with_stack(2 * KIB, || {
        Alias::new_in(&picture, &mut bins).unwrap().numerator(7)
    });
    let cdf = with_stack(2 * KIB, || Cdf::<Vec<u32>>::from_slice(&picture).unwrap());
    assert_eq!(cdf.numerator(7), numerator);
    let alias = with_stack(2 * KIB, || Alias::<Vec<_>>::from_slice(&picture).unwrap());
    let alias: Alias<Vec<AliasEntry<u32>>> = alias;
    assert_eq!(alias.numerator(7), numerator);
    // Four times the table and 2 KiB as an array, and 16 bytes a row.
    let stated = |table: usize| 4 * table + 2 * KIB;
    let pdf = with_stack(stated(size_of::<Array>()) + 16 * ROWS, array_map);
    assert_eq!(pdf, 1.0);
    static WEIGHTS: [f32; 16_384] = [2.0; 16_384];
    let entries = with_stack(stated(4 * WEIGHTS.len()), || {
        std::hint::black_box(&Cdf::new(&WEIGHTS).unwrap()).entries()
    });
    assert_eq!(entries, WEIGHTS.len());
    let entries = with_stack(stated(12 * WEIGHTS.len()), || {
        std::hint::black_box(&Alias::<[_; 16_384]>::new(&WEIGHTS).unwrap()).entries()
    });
    assert_eq!(entries, WEIGHTS.len());
    let high = with_stack(stated(4 * WEIGHTS.len() + 20), || {
        std::hint::black_box(&PiecewiseConstant1d::new(&WEIGHTS, 0.0, 9.0).unwrap()).high()
    });
    assert_eq!(high, 9.0);
}

const OVERFLOW: &str = "MICROWARP_OVERFLOW";

/// A stack that holds the table not even once ends the process that builds it.
#[test]
fn too_small_a_stack_is_noticed() {
    if std::env::var_os(OVERFLOW).is_some() {
        with_stack(size_of::<Array>() / 2, array_map);
        return;
    }
    let mut test = std::process::Command::new(std::env::current_exe().unwrap());
    test.args(["--exact", "stack::too_small_a_stack_is_noticed"]);
    let ended = test.env(OVERFLOW, "1").output().unwrap();
    assert!(!ended.status.success());
}
