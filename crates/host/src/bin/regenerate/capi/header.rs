//! The text of the headers, and of the sizes that `bindings/c` holds every target to.

use super::bound::{self, Block, Bound};
use super::comments::Comments;
use super::declare::index;
use super::declare::{WIDTH, declare, structure};
use microwarp_host::upkeep::{Outcome, errors, read, wrapped};
use std::collections::BTreeSet;
use std::fmt::Write;

/// Where they stand, from the root.
pub const LAYOUT: &str = "bindings/c/src/layout.rs";
/// The headers, each with its template: what is no warp and no error is declared there. In the place of `@name@` comes what
/// is generated. The second includes the first.
pub const HEADERS: [(&str, &str); 2] = [
    (
        "bindings/c/include/microwarp_integers.h",
        "bindings/c/template_integers.h",
    ),
    ("bindings/c/include/microwarp.h", "bindings/c/template.h"),
];

/// The tiers: the warps, the list that describes them, their folder, and the column of their errors.
pub type Section = (fn() -> Vec<Block>, &'static str, &'static str, &'static str);
pub const POLY: Section = (bound::poly, "src/warp.rs", "src/warp", "poly");
pub const FIXED: [Section; 4] = [
    (bound::fine, "src/fixed.rs", "src/fixed", "fine"),
    (bound::plain, "src/fixed.rs", "src/fixed", "fine"),
    (bound::coarse, "src/fixed.rs", "src/fixed", "coarse"),
    (bound::compact, "src/fixed.rs", "src/fixed", "compact"),
];

/// The whole headers, in their order.
pub fn headers() -> Outcome<[String; 2]> {
    let mut texts = [String::new(), String::new()];
    for ((_, template), text) in HEADERS.iter().zip(&mut texts) {
        *text = expanded(template, &read(template)?)?;
    }
    // The template has these.
    let mut structs = BTreeSet::from(["mw_surface_point", "mw_mesh_point"].map(String::from));
    let poly = section(&POLY, &mut structs)?;
    let fixed: Outcome<String> = FIXED
        .iter()
        .map(|tier| section(tier, &mut structs))
        .collect();
    let mut generated = vec![
        ("errors".to_owned(), reasons()?),
        ("poly".to_owned(), poly),
        ("fixed".to_owned(), fixed?),
    ];
    for table in bound::tables() {
        let mut functions = String::new();
        declare(&mut functions, &table, &mut structs);
        generated.push((format!("warp {}", table.symbol()), functions));
    }
    for (symbol, stored) in bound::structs() {
        generated.push((format!("struct {symbol}"), structure(symbol, stored)));
    }
    for (place, generated) in &generated {
        put(&mut texts, place, generated)?;
    }
    let indices = [index(&texts[0]), index(&texts[1])];
    put(&mut texts, "index of microwarp_integers.h", &indices[0])?;
    for (text, own) in texts.iter_mut().zip(&indices) {
        put(std::slice::from_mut(text), "own index", own)?;
    }
    for ((path, template), text) in HEADERS.iter().zip(&texts) {
        if let Some(place) = text.lines().find(|line| line.starts_with('@')) {
            return Err(format!("{template}: nothing is made for {place}"));
        }
        // Of the documentation only what the comments know in ASCII.
        if let Some(c) = text.chars().find(|c| !c.is_ascii()) {
            return Err(format!("{path} has a {c}"));
        }
    }
    Ok(texts)
}

/// Puts what is generated in its place, which one of the texts has once.
fn put(texts: &mut [String], place: &str, generated: &str) -> Outcome {
    let place = format!("@{place}@");
    if texts.concat().matches(&place).count() != 1 {
        return Err(format!("the templates have not one {place}"));
    }
    for text in texts {
        *text = text.replace(&place, generated.trim_end());
    }
    Ok(())
}

/// The template with what stands between `@each a,b c,d@` and `@end@` repeated: once with `a` for `{}` and `b` for `{1}`,
/// and once with the others; `~` is a space.
fn expanded(path: &str, template: &str) -> Outcome<String> {
    let mut text = String::new();
    let mut rest = template;
    while let Some((before, each)) = rest.split_once("@each ") {
        let parts = each.split_once("@\n").and_then(|(values, block)| {
            let (block, after) = block.split_once("@end@\n")?;
            Some((values, block, after))
        });
        let (values, block, after) =
            parts.ok_or_else(|| format!("{path}: an @each@ without an @end@"))?;
        text.push_str(before);
        for value in values.split(' ') {
            let mut once = block.to_owned();
            for (i, part) in value.split(',').enumerate() {
                let place = if i == 0 {
                    "{}".into()
                } else {
                    format!("{{{i}}}")
                };
                once = once.replace(&place, &part.replace('~', " "));
            }
            text.push_str(&once);
        }
        rest = after;
    }
    Ok(text + rest)
}

/// The sizes and alignments of all structs of warps.
pub fn layout() -> String {
    let warps = bound::every().into_iter().filter(Bound::is_stored);
    let warps = warps.map(|warp| (warp.symbol(), warp.stored));
    let structs = bound::structs()
        .into_iter()
        .map(|(symbol, stored)| (symbol.into(), stored));
    let rows = warps.chain(structs).map(|(symbol, stored)| {
        format!(
            "    (\"{symbol}\", {}, {}, {}),\n",
            stored.pointers, stored.bytes, stored.align
        )
    });
    format!(
        "//! What every struct of the header has room for: pointers, bytes and their alignment. Written by `cargo\n\
         //! regenerate`.\n\n\
         pub const LAYOUT: &[(&str, usize, usize, usize)] = &[\n{}];\n",
        rows.collect::<String>()
    )
}

/// The reasons of `Error` with their numbers.
fn reasons() -> Outcome<String> {
    let mut text = String::new();
    for (error, name) in errors()? {
        let (name, code, message) = (upper_case(&name), error.code(), error.message());
        writeln!(text, "    MW_{name} = {code}, /* {message} */").unwrap();
    }
    Ok(text)
}

/// `NotFinite` as `NOT_FINITE`.
pub fn upper_case(name: &str) -> String {
    let mut text = String::new();
    for (i, c) in name.chars().enumerate() {
        if c.is_uppercase() && i > 0 {
            text.push('_');
        }
        text.extend(c.to_uppercase());
    }
    text
}

fn section(
    &(blocks, list, folder, column): &Section,
    structs: &mut BTreeSet<String>,
) -> Outcome<String> {
    let comments = Comments::read(list, folder)?;
    let mut text = String::new();
    for warp in blocks().into_iter().flat_map(|block| block.bound) {
        comment(&mut text, &warp, &comments, column)?;
        declare(&mut text, &warp, structs);
        text.push('\n');
    }
    Ok(text)
}

fn comment(text: &mut String, warp: &Bound, comments: &Comments, column: &str) -> Outcome {
    let name = warp.type_name();
    let sentence = match (name, warp.tier) {
        ("Interval", "fixed_") => {
            "Uniform on an interval of numbers, none of them favoured; one word"
        }
        _ => comments.sentence(name)?,
    };
    let arguments = warp.of.split(|c: char| !c.is_ascii_digit());
    let size = arguments.filter_map(|n| n.parse::<u8>().ok()).next_back();
    let sized = |text: &str| match size {
        Some(n) => text.replace("N ", &format!("{n} ")),
        None => text.to_owned(),
    };
    let sentence = sized(sentence);
    let mut said = vec![format!("{sentence}.")];
    let errors = comments.errors(name, column);
    if !errors.is_empty() {
        said.push(format!("Largest errors: {}.", errors.join("; ")));
    }
    let mut formats: Vec<String> = Vec::new();
    if warp.point.format.is_some()
        || warp
            .constructors
            .iter()
            .any(|c| c.parameters.iter().any(|p| p.1.format.is_some()))
    {
        let mut of = |what: &str, format: &Option<String>| {
            if let Some(format) = format {
                let one = format!("{what} {format}");
                if !formats.contains(&one) {
                    formats.push(one);
                }
            }
        };
        for constructor in &warp.constructors {
            for (parameter, form) in &constructor.parameters {
                of(parameter, &form.format);
            }
        }
        of("point", &warp.point.format);
    }
    if !formats.is_empty() {
        said.push(format!("Formats: {}.", formats.join(", ")));
    }
    let point = comments.point(name, &warp.symbol())?;
    said.push(format!("Point: {}.", sized(&point)));
    if warp.is_stored() {
        for constructor in &warp.constructors {
            let refusals = comments.refusals(name, constructor.name, &warp.symbol())?;
            let of = match constructor.name {
                "new" => "init".to_owned(),
                of => format!("init_{of}"),
            };
            said.push(format!("Errors of {of}: {refusals}"));
        }
    }
    let mut lines = Vec::new();
    for paragraph in said {
        lines.extend(wrapped(&paragraph, WIDTH - 3));
    }
    writeln!(text, "/**\n * {}\n */", lines.join("\n * ")).unwrap();
    Ok(())
}
