//! Work on several threads: jobs that are handed out one by one.

use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// As many threads as the machine runs at once.
pub fn threads() -> usize {
    std::thread::available_parallelism().map_or(2, usize::from)
}

/// The results of `job` on each item, in order, by several threads.
pub fn in_parallel<T: Sync, R: Send>(
    threads: usize,
    items: &[T],
    job: impl Fn(&T) -> R + Sync,
) -> Vec<R> {
    let results: Vec<Mutex<Option<R>>> = items.iter().map(|_| Mutex::new(None)).collect();
    on_threads(threads, items.len(), &|i| {
        let result = job(&items[i]);
        *results[i].lock().expect("nobody else writes there") = Some(result);
    });
    let done = |result: Mutex<Option<R>>| result.into_inner().ok().flatten();
    let results = results.into_iter().map(done);
    results.map(|of| of.expect("no job is left out")).collect()
}

/// What is the same for items and results of any type, and so compiled once.
fn on_threads(threads: usize, count: usize, job: &(dyn Fn(usize) + Sync)) {
    let next = AtomicUsize::new(0);
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                loop {
                    match next.fetch_add(1, Ordering::Relaxed) {
                        i if i < count => job(i),
                        _ => break,
                    }
                }
            });
        }
    });
}
