//! What the programs `regenerate` and `linked` share: files, the errors, and a common end.

pub use crate::root;
use microwarp::Error;
use std::process::ExitCode;

/// What a step or a check ends with; the text says what is wrong.
pub type Outcome<T = ()> = Result<T, String>;

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

macro_rules! listed {
    ($($error:expr,)*) => {
        const ERRORS: &[Error] = &[$($error),*];
    };
}
microwarp_list::errors!(listed);

/// Every reason for a refusal with its name, by the codes from 1 on; fails where the list lacks one.
pub fn errors() -> Outcome<Vec<(Error, String)>> {
    let source = read("src/error.rs")?;
    let messages = source
        .split_once("fn message(")
        .and_then(|(_, rest)| rest.split_once("\n    }\n"));
    let stated = messages.map_or(0, |(body, _)| body.matches("Self::").count());
    if stated != ERRORS.len() {
        return Err(format!("there are {stated} errors, not {}", ERRORS.len()));
    }
    let named = ERRORS.iter().zip(1..).map(|(&error, code)| {
        let whole = format!("{error:?}");
        let name = whole.split('(').next().unwrap_or(&whole).to_string();
        let numbered = error.code() == code;
        numbered
            .then_some((error, name))
            .ok_or(format!("{error:?} has not the code {code}"))
    });
    named.collect()
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

/// Text in lines of at most so many characters.
pub fn wrapped(text: &str, width: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in text.split_whitespace() {
        let last = lines.last_mut().unwrap();
        if !last.is_empty() && last.chars().count() + 1 + word.chars().count() > width {
            lines.push(word.into());
        } else {
            if !last.is_empty() {
                last.push(' ');
            }
            last.push_str(word);
        }
    }
    lines
}
