//! Tables and figures between marks in the pages:
//!
//! ```text
//! <!-- generated: NAME -->        a table, on lines of their own
//! <!-- end -->
//! <!-- figure: WORDS -->1,234<!-- --> a figure in a sentence
//! ```
//!
//! In the documentation of `src` there are figures alone, but for the lists of warps on the crate's page.

use crate::sources::Sources;
use crate::tables::{block, figure};
use microwarp_host::upkeep::{Outcome, read, write};

const PAGES: [&str; 9] = [
    "README.md",
    "src/lib.rs",
    "docs/c.md",
    "docs/costs.md",
    "docs/peers.md",
    "docs/promises.md",
    "docs/worst_case.md",
    "examples/README.md",
    "examples/firmware/README.md",
];
/// How a mark begins, how it ends, and the mark behind what is generated.
const BLOCK: [&str; 3] = ["<!-- generated: ", " -->\n", "<!-- end -->"];
const FIGURE: [&str; 3] = ["<!-- figure: ", " -->", "<!-- -->"];

/// A page with what stands between marks of a kind replaced, and how many there were.
fn replace(
    page: &str,
    [open, close, end]: [&str; 3],
    with: &dyn Fn(&str) -> Outcome<String>,
) -> Outcome<(String, usize)> {
    let (mut text, mut rest, mut count) = (String::new(), page, 0);
    while let Some((before, after)) = rest.split_once(open) {
        let parts = after
            .split_once(close)
            .and_then(|(name, after)| after.split_once(end).map(|(_, after)| (name, after)));
        let (name, after) = parts.ok_or_else(|| format!("a mark has no end: {open}{after:.30}"))?;
        text += &[before, open, name, close, &with(name)?, end].concat();
        (rest, count) = (after, count + 1);
    }
    Ok((text + rest, count))
}

fn generated(page: &str, sources: &Sources) -> Outcome<(String, usize)> {
    if let Some((_, line)) = page.split_once(&format!("\n{}", FIGURE[0])) {
        // Markdown would end the paragraph there.
        return Err(format!(
            "a line begins with the mark of a figure: {line:.30}"
        ));
    }
    let (page, blocks) = replace(page, BLOCK, &|name| block(name, sources))?;
    let (page, figures) = replace(&page, FIGURE, &|words| figure(words, sources))?;
    Ok((page, blocks + figures))
}

/// The lines that differ, old before new.
pub fn difference(old: &str, new: &str) -> String {
    let (old, new): (Vec<_>, Vec<_>) = (old.lines().collect(), new.lines().collect());
    let lines = |sign, from: &[&str], other: &[&str]| -> String {
        let only = from.iter().filter(|line| !other.contains(line));
        only.map(|line| format!("{sign} {line}\n")).collect()
    };
    lines('-', &old, &new) + &lines('+', &new, &old)
}

/// A digit that is changed, or a letter where there is none, in any table and any sentence would be seen.
fn control(page: &str, sources: &Sources) -> Outcome {
    let mut seen = 0;
    for [open, close, end] in [BLOCK, FIGURE] {
        for (at, _) in page.match_indices(open) {
            let start = at + page[at..].find(close).unwrap_or(0) + close.len();
            let stop = start + page[start..].find(end).unwrap_or(0);
            let digit = page[start..stop].rfind(|c: char| c.is_ascii_digit());
            let digit = digit.or_else(|| page[start..stop].rfind(|c: char| c.is_alphanumeric()));
            let digit = start + digit.ok_or("control: a block with nothing in it")?;
            let other = if &page[digit..=digit] == "7" {
                "8"
            } else {
                "7"
            };
            let tampered = [&page[..digit], other, &page[digit + 1..]].concat();
            if generated(&tampered, sources)?.0 == tampered {
                return Err(format!(
                    "control: a wrong figure passes: {}",
                    &page[at..start]
                ));
            }
            seen += 1;
        }
    }
    if seen > 0 {
        Ok(())
    } else {
        Err("control: a page without a mark".into())
    }
}

/// Lines of the documentation in `src` that state a time which nothing generates: it goes stale unseen.
fn copied_times(code: &str) -> Outcome<Vec<String>> {
    let (bare, _) = replace(code, FIGURE, &|_| Ok(String::new()))?;
    // A time may be parted from its unit by the end of a line.
    let comments = bare.lines().map(str::trim_start);
    let comments = comments.filter_map(|line| line.strip_prefix("//"));
    let text: Vec<&str> = comments
        .map(|line| line.trim_start_matches(['/', '!']))
        .collect();
    let text = text.join(" ");
    let words: Vec<&str> = text.split_whitespace().collect();
    let unit = |word: &str| {
        let word = word.trim_end_matches(|c: char| !c.is_alphanumeric());
        matches!(word, "ns" | "nanosecond" | "nanoseconds")
    };
    let number = |word: &str| word.ends_with(|c: char| c.is_ascii_digit());
    let joined = |word: &&str| {
        let word = word.trim_end_matches(|c: char| !c.is_alphanumeric());
        word.strip_suffix("ns").is_some_and(number)
    };
    let parted = words.windows(2).filter(|w| number(w[0]) && unit(w[1]));
    let mut found: Vec<String> = parted.map(|words| words.join(" ")).collect();
    found.extend(words.iter().copied().filter(joined).map(String::from));
    Ok(found)
}

/// No time is copied by hand into `src`.
fn no_copied_times(sources: &Sources) -> Outcome {
    let control = "/// the fastest: 1.7 ns a\n/// number, against 2.2\n/// ns; 3ns. Columns, 5 spins.\n\
                   /// <!-- figure: x -->4 ns<!-- -->\nlet x = 2;";
    let seen = copied_times(control)?;
    if seen != ["1.7 ns", "2.2 ns;", "3ns."] {
        return Err(format!("control: of three copied times {seen:?} are seen"));
    }
    let mut wrong = String::new();
    for (path, text) in &sources.code {
        for time in copied_times(text)? {
            wrong += &format!("{path}: {time:?} is copied by hand\n");
        }
    }
    if wrong.is_empty() { Ok(()) } else { Err(wrong) }
}

pub fn step(check: bool) -> Outcome {
    let sources = Sources::read()?;
    no_copied_times(&sources)?;
    let mut stale = String::new();
    let commented = sources
        .code
        .iter()
        .filter(|(_, text)| text.contains(FIGURE[0]));
    let pages = PAGES.map(String::from).into_iter();
    for path in pages.chain(commented.map(|(path, _)| path.clone())) {
        let path = path.as_str();
        let old = read(path)?;
        let (new, count) = generated(&old, &sources)?;
        control(&new, &sources)?;
        if !check {
            write(path, &new)?;
        } else if new == old {
            println!("{path}: {count} generated tables and figures, as checked in");
        } else {
            stale += &format!("{path}:\n{}", difference(&old, &new));
        }
    }
    if stale.is_empty() { Ok(()) } else { Err(stale) }
}
