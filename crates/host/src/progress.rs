//! What every run of an example begins with: a folder for the pictures, and a bar that shows how far it is.

use indicatif::{ProgressBar, ProgressStyle};
use std::error::Error;
use std::path::Path;

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
