//! What every run begins with: a folder for the pictures, a bar that shows how far it is, and threads.

use indicatif::{ProgressBar, ProgressStyle};
use std::error::Error;
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Makes a folder where there is none.
pub fn folder(path: &Path) -> Result<(), String> {
    std::fs::create_dir_all(path).map_err(|e| format!("{}: {e}", path.display()))
}

/// A bar of this length; `count` is how the place on it is written.
pub fn progress(length: u64, count: &str) -> Result<ProgressBar, Box<dyn Error>> {
    let progress = ProgressBar::new(length);
    let template = format!("{{elapsed:>4}} [{{bar:40}}] {count} {{msg}}");
    progress.set_style(ProgressStyle::with_template(&template)?.progress_chars("=> "));
    Ok(progress)
}

/// Steps of work that take about as long as each other.
pub const STEPS: &str = "{pos}/{len}";

/// The results of `work` on each item, in order, by several threads.
pub fn in_parallel<T: Sync, R: Send>(
    threads: usize,
    items: &[T],
    work: impl Fn(&T) -> R + Sync,
) -> Vec<R> {
    let next = AtomicUsize::new(0);
    let results = Mutex::new(Vec::with_capacity(items.len()));
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                while let Some((i, item)) = {
                    let i = next.fetch_add(1, Ordering::Relaxed);
                    items.get(i).map(|item| (i, item))
                } {
                    let result = work(item);
                    results
                        .lock()
                        .expect("no thread has panicked")
                        .push((i, result));
                }
            });
        }
    });
    let mut results = results.into_inner().expect("no thread has panicked");
    results.sort_by_key(|(i, _)| *i);
    results.into_iter().map(|(_, result)| result).collect()
}
