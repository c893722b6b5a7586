//! The declarations of a warp.

use super::bound::{Bound, Stored};
use super::form::Form;
use microwarp_host::upkeep::wrapped;
use std::collections::BTreeSet;
use std::fmt::Write;

/// How long a line may be.
pub const WIDTH: usize = 100;

/// The struct, the constructors and the functions of a warp.
pub fn declare(text: &mut String, warp: &Bound, structs: &mut BTreeSet<String>) {
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
    let yielding = |form: &Form, name: &str, mut before: Vec<String>| {
        if form.is_number() {
            (form.base.clone(), before)
        } else {
            before.push(form.place(name));
            ("void".to_owned(), before)
        }
    };
    let rng = || "mw_pcg32 *rng".to_owned();
    let source = || "const mw_source *source".to_owned();
    let given =
        |form: &Form, one: &str, many: &str| form.given(if form.is_number() { one } else { many });
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

/// The struct itself.
pub fn structure(symbol: &str, stored: Stored) -> String {
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

// The index at the top of a header: what each section declares, by the names without `mw_`.

/// The grades of the integer tier: a sampler of all is named once.
const GRADES: [&str; 3] = ["fixed_", "coarse_", "compact_"];

/// The lines of the comment, section by section.
pub fn index(header: &str) -> String {
    let mut text = String::new();
    for section in header.split("/* ---- ").skip(1) {
        let title = section.split(" --").next().unwrap_or_default();
        let names = names(section);
        let (graded, others) = graded(&names);
        writeln!(text, " *   {title}").unwrap();
        if !graded.is_empty() {
            writeln!(
                text,
                " *     in three grades, {}_NAME:",
                GRADES
                    .map(|grade| grade.trim_end_matches('_'))
                    .join("_NAME, ")
            )
            .unwrap();
            listed(&mut text, "       ", &graded);
        }
        if !graded.is_empty() && !others.is_empty() {
            writeln!(text, " *     and").unwrap();
        }
        listed(&mut text, "     ", &others);
    }
    text
}

fn listed(text: &mut String, indent: &str, names: &[String]) {
    if names.is_empty() {
        return;
    }
    for line in wrapped(&names.join(", "), WIDTH - 3 - indent.len()) {
        writeln!(text, " *{indent}{line}").unwrap();
    }
}

/// What functions are named after: the structs, and samplers without one. The longest come first.
fn stems(section: &str) -> Vec<String> {
    let structs = section.split("typedef struct ").skip(1);
    let structs = structs.filter_map(|rest| rest.split([' ', ';']).next());
    let samplers = functions(section).into_iter();
    let samplers = samplers.filter_map(|name| name.strip_suffix("_sample"));
    let mut stems: Vec<String> = structs.chain(samplers).map(Into::into).collect();
    stems.sort_by_key(|stem| std::cmp::Reverse(stem.len()));
    stems
}

/// The functions that a text declares, in order.
fn functions(text: &str) -> Vec<&str> {
    let code = text
        .lines()
        .filter(|line| line.starts_with(|c: char| c.is_ascii_lowercase()));
    let calls = code
        .filter_map(|line| line.split_once('('))
        .map(|(before, _)| before);
    let names = calls.filter_map(|before| before.rsplit([' ', '*']).next());
    names.filter(|name| name.starts_with("mw_")).collect()
}

/// What the functions of a section belong to, each once, without `mw_`.
fn names(section: &str) -> Vec<String> {
    let (stems, functions) = (stems(section), functions(section));
    let mut names: Vec<String> = Vec::new();
    for name in &functions {
        let of = |stem: &&String| {
            name.strip_prefix(stem.as_str())
                .is_some_and(|rest| rest.starts_with('_'))
        };
        let owner = stems.iter().find(of).map_or(*name, |stem| stem.as_str());
        // The same function from a source is not named beside it.
        let again = owner
            .strip_suffix("_from")
            .is_some_and(|with| functions.contains(&with));
        let owner = owner.trim_start_matches("mw_").to_owned();
        if !again && !names.contains(&owner) {
            names.push(owner);
        }
    }
    names
}

/// Those of all grades without the grade, and the others.
fn graded(names: &[String]) -> (Vec<String>, Vec<String>) {
    let every = |name: &str| {
        GRADES
            .iter()
            .all(|grade| names.contains(&format!("{grade}{name}")))
    };
    let of = |name: &String| {
        let bare = GRADES.iter().find_map(|grade| name.strip_prefix(grade))?;
        every(bare).then(|| bare.to_owned())
    };
    let mut graded: Vec<String> = names.iter().filter_map(of).collect();
    graded.sort();
    graded.dedup();
    let others = names
        .iter()
        .filter(|name| of(name).is_none())
        .cloned()
        .collect();
    (graded, others)
}
