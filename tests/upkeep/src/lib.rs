//! What `regenerate` and `linked` share: the root of the repository, and a common end. And the C interface as text.

pub mod capi;

use std::path::PathBuf;
use std::process::ExitCode;

/// What a step or a check ends with; the text says what is wrong.
pub type Outcome<T = ()> = Result<T, String>;

/// The root of the repository.
pub fn root() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
}

/// The text of a file, by its path from the root.
pub fn read(path: &str) -> Outcome<String> {
    std::fs::read_to_string(root().join(path)).map_err(|e| format!("{path}: {e}"))
}

/// Writes a file, by its path from the root, where its text has changed.
pub fn write(path: &str, text: &str) -> Outcome {
    if read(path).is_ok_and(|before| before == text) {
        return Ok(());
    }
    std::fs::write(root().join(path), text).map_err(|e| format!("{path}: {e}"))?;
    println!("written: {path}");
    Ok(())
}

/// The process's end: what is wrong goes to standard error.
pub fn end(outcome: Outcome) -> ExitCode {
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("FAILED: {error}");
            ExitCode::FAILURE
        }
    }
}
