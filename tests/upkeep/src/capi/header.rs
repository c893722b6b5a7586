//! The text of the header, and of the sizes that `bindings/c` holds every target to.

use super::bound::{self, Block, Bound, Stored};
use super::comments::Comments;
use crate::{Outcome, read};
use std::collections::BTreeSet;
use std::fmt::Write;

/// Where they stand, from the root.
pub const HEADER: &str = "bindings/c/include/microwarp.h";
pub const LAYOUT: &str = "bindings/c/src/layout.rs";
/// What is no warp and no error is declared here. In the place of `@name@` comes what is generated.
const TEMPLATE: &str = "bindings/c/template.h";

const WIDTH: usize = 100;

/// The tiers: the warps, the list that describes them, their folder, and the column of their errors.
type Section = (fn() -> Vec<Block>, &'static str, &'static str, &'static str);
const POLY: Section = (bound::poly, "src/warp.rs", "src/warp", "poly");
const FIXED: [Section; 4] = [
    (bound::fine, "src/fixed.rs", "src/fixed", "fine"),
    (bound::plain, "src/fixed.rs", "src/fixed", "fine"),
    (bound::coarse, "src/fixed.rs", "src/fixed", "coarse"),
    (bound::compact, "src/fixed.rs", "src/fixed", "compact"),
];

/// The whole header.
pub fn header() -> Outcome<String> {
    let mut text = expanded(&read(TEMPLATE)?)?;
    // The template has these.
    let mut structs = BTreeSet::from(["mw_surface_point", "mw_mesh_point"].map(String::from));
    let poly = section(&POLY, &mut structs)?;
    let fixed: Outcome<String> = FIXED
        .iter()
        .map(|tier| section(tier, &mut structs))
        .collect();
    let mut generated = vec![
        ("errors".to_owned(), errors()?),
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
    for (place, generated) in generated {
        let place = format!("@{place}@");
        if text.matches(&place).count() != 1 {
            return Err(format!("{TEMPLATE} has not one {place}"));
        }
        text = text.replace(&place, generated.trim_end());
    }
    if let Some(place) = text.lines().find(|line| line.starts_with('@')) {
        return Err(format!("{TEMPLATE}: nothing is made for {place}"));
    }
    Ok(text)
}

/// The template with what stands between `@each a,b c,d@` and `@end@` repeated: once with `a` for `{}` and `b` for `{1}`,
/// and once with the others; `~` is a space.
fn expanded(template: &str) -> Outcome<String> {
    let mut text = String::new();
    let mut rest = template;
    while let Some((before, each)) = rest.split_once("@each ") {
        let parts = each.split_once("@\n").and_then(|(values, block)| {
            let (block, after) = block.split_once("@end@\n")?;
            Some((values, block, after))
        });
        let (values, block, after) =
            parts.ok_or_else(|| format!("{TEMPLATE}: an @each@ without an @end@"))?;
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

/// The variants of `Error` with their numbers, from its source.
fn errors() -> Outcome<String> {
    let source = read("src/error.rs")?;
    let mut text = String::new();
    for line in source.lines() {
        let arm = line
            .trim()
            .strip_prefix("Self::")
            .and_then(|arm| arm.split_once(" => "));
        let Some((variant, number)) = arm else {
            continue;
        };
        let Some(number) = number.strip_suffix(',').and_then(|n| n.parse::<u16>().ok()) else {
            continue;
        };
        let variant = variant.trim_end_matches("(_)");
        let says = format!("Self::{variant}");
        let mut messages = source.lines().filter_map(|line| {
            let (arm, message) = line.trim().strip_prefix(&says)?.split_once(" => \"")?;
            (arm.is_empty() || arm == "(_)").then(|| message.trim_end_matches("\","))
        });
        let message = messages
            .next()
            .ok_or_else(|| format!("no message of {variant}"))?;
        let name = upper_case(variant);
        writeln!(text, "    MW_{name} = {number}, /* {message} */").unwrap();
    }
    Ok(text)
}

fn upper_case(name: &str) -> String {
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
    let sentence = match arguments.filter_map(|n| n.parse::<u8>().ok()).next_back() {
        Some(n) => sentence.replace("N ", &format!("{n} ")),
        None => sentence.to_owned(),
    };
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
    let mut lines = Vec::new();
    for paragraph in said {
        lines.extend(wrapped(&paragraph, WIDTH - 3));
    }
    writeln!(text, "/**\n * {}\n */", lines.join("\n * ")).unwrap();
    Ok(())
}

fn wrapped(text: &str, width: usize) -> Vec<String> {
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

fn declare(text: &mut String, warp: &Bound, structs: &mut BTreeSet<String>) {
    let (symbol, point, uniforms) = (warp.symbol(), &warp.point, &warp.uniforms);
    let density = &warp.density.base;
    if point.is_struct() && structs.insert(point.base.clone()) {
        let fields = point.fields.iter();
        let fields: String = fields
            .map(|(name, form)| format!("    {};\n", form.declared(name)))
            .collect();
        writeln!(text, "typedef struct {0} {{\n{fields}}} {0};", point.base).unwrap();
    }
    if warp.is_stored() {
        text.push_str(&structure(&symbol, warp.stored));
    }
    if warp.is_stored() {
        for constructor in &warp.constructors {
            let name = match constructor.name {
                "new" => format!("{symbol}_init"),
                name => format!("{symbol}_init_{name}"),
            };
            let parameters = constructor
                .parameters
                .iter()
                .map(|(name, form)| form.given(name));
            let arguments = [format!("{symbol} *warp")].into_iter().chain(parameters);
            prototype(text, "mw_error", &name, arguments.collect());
        }
    }
    let itself = warp.is_stored().then(|| format!("const {symbol} *warp"));
    let mut function = |returned: &str, name: &str, arguments: Vec<String>| {
        let arguments = itself.iter().cloned().chain(arguments);
        prototype(
            text,
            returned,
            &format!("{symbol}_{name}"),
            arguments.collect(),
        );
    };
    let yielding = |form: &super::form::Form, name: &str, mut before: Vec<String>| {
        if form.is_number() {
            (form.base.clone(), before)
        } else {
            before.push(form.place(name));
            ("void".to_owned(), before)
        }
    };
    let rng = || "mw_pcg32 *rng".to_owned();
    let source = || "const mw_source *source".to_owned();
    let given = |form: &super::form::Form, one: &str, many: &str| {
        form.given(if form.is_number() { one } else { many })
    };
    let u = given(uniforms, "u", "u");
    let (returned, arguments) = yielding(point, "point", vec![u.clone()]);
    function(&returned, "sample", arguments);
    function(density, "sample_with_pdf", vec![u, point.place("point")]);
    let (returned, arguments) = yielding(point, "point", vec![rng()]);
    function(&returned, "draw", arguments);
    function(
        "mw_error",
        "draw_from",
        vec![source(), point.place("point")],
    );
    let many = || vec![point.many("points"), "size_t count".to_owned()];
    function("void", "fill", [vec![rng()], many()].concat());
    function("mw_error", "fill_from", [vec![source()], many()].concat());
    function(density, "pdf", vec![point.given("point")]);
    let (returned, arguments) = yielding(uniforms, "u", vec![point.given("point")]);
    function(&returned, "invert", arguments);
}

fn structure(symbol: &str, stored: Stored) -> String {
    let (word, align) = match (stored.pointers, stored.align) {
        (0, 8) => ("uint64_t", 8),
        _ => ("uint32_t", 4),
    };
    let words = format!("{word} words[{}];", stored.bytes.div_ceil(align));
    match stored.pointers {
        0 => format!("typedef struct {symbol} {{ {words} }} {symbol};\n"),
        n => {
            let words = if stored.bytes > 0 {
                format!("    {words}\n")
            } else {
                String::new()
            };
            format!(
                "typedef struct {symbol} {{\n    const void *pointers[{n}];\n{words}}} {symbol};\n"
            )
        }
    }
}

/// A declaration, in lines that are not too long.
fn prototype(text: &mut String, returned: &str, name: &str, arguments: Vec<String>) {
    let start = format!("{returned} {name}(");
    let mut line = start.clone();
    let indent = " ".repeat(8);
    for (i, argument) in arguments.iter().enumerate() {
        let end = if i + 1 == arguments.len() { ");" } else { "," };
        let gap = usize::from(i > 0);
        if line.len() + gap + argument.len() + end.len() > WIDTH {
            text.push_str(&line);
            text.push('\n');
            line = indent.clone();
        } else if i > 0 {
            line.push(' ');
        }
        line.push_str(argument);
        line.push_str(end);
    }
    text.push_str(&line);
    text.push('\n');
}
