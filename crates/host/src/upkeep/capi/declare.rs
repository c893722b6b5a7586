//! The declarations of a warp.

use super::bound::{Bound, Stored};
use super::form::Form;
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
