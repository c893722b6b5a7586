//! Prints the hash of every picture that the page compares with the host's: a row each, as tests/golden/golden.csv has them.

use microwarp_scene::numbered::{HALVES, HOST, POINTS, Request, SCENES, TIERS, row};
use microwarp_scene::{Hash, Plan};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

fn hash(request: &Request) -> u32 {
    let [width, height] = request.plan.size;
    let mut colours = vec![[0.0; 3]; width as usize];
    let mut hash = Hash::EMPTY;
    for y in 0..height {
        row(request, y, &mut colours).expect("every request in the list is one");
        hash = colours.iter().fold(hash, |hash, &colour| hash.with(colour));
    }
    hash.word()
}

/// The line of a picture: its name, which says what is requested, and its hash.
fn line(request: &Request) -> String {
    let [scene, tier, points] = [
        SCENES[request.scene as usize],
        TIERS[request.tier as usize],
        POINTS[request.points as usize],
    ];
    let Plan {
        size: [width, height],
        samples,
        seed,
    } = request.plan;
    let hash = hash(request);
    format!("{scene} {tier} {points} {width}x{height} {samples} {seed},{hash:08x}")
}

/// Every scene in every tier by every point set, both halves.
fn requests() -> Vec<Request> {
    let mut requests = Vec::new();
    for scene in 0..SCENES.len() as u32 {
        for tier in 0..TIERS.len() as u32 {
            for points in 0..POINTS.len() as u32 {
                requests.extend((0..HALVES).map(|half| Request {
                    scene,
                    tier,
                    points,
                    plan: Plan {
                        seed: HOST.seed + half,
                        ..HOST
                    },
                }));
            }
        }
    }
    requests
}

fn main() {
    let requests = requests();
    let lines: Vec<_> = requests.iter().map(|_| OnceLock::new()).collect();
    let next = AtomicUsize::new(0);
    let work = || {
        let numbers = std::iter::from_fn(|| Some(next.fetch_add(1, Ordering::Relaxed)));
        for k in numbers.take_while(|&k| k < requests.len()) {
            lines[k].get_or_init(|| line(&requests[k]));
        }
    };
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| (0..threads).for_each(|_| drop(scope.spawn(work))));
    println!("# scene, tier, points, size, samples a pixel, seed; the hash of the picture");
    for line in lines {
        println!("{}", line.into_inner().expect("every number was taken"));
    }
}
