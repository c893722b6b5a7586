//! The golden subjects as C functions, for `bindings/c/tests/golden.c`.

use super::bound::{self, Block};
use super::call::call;
use super::form::Form;
use super::made::{Made, made, tables};
use microwarp_list::fixed::WORDS;
use microwarp_list::{AREAS, UNIFORMS};
use std::collections::BTreeSet;
use std::fmt::Write;

type Tier = (&'static str, fn() -> Vec<Block>);

const TIERS: [Tier; 5] = [
    ("poly", bound::poly),
    ("fine", bound::fine),
    ("coarse", bound::coarse),
    ("compact", bound::compact),
    ("fixed", bound::plain),
];

/// The tables of inputs, a function for each subject, and the lists of subjects: those that C has, and the others with
/// the reason.
pub fn golden() -> String {
    let mut text = "/* Written by `capi golden`; included by golden.c. */\n".to_owned();
    table(
        &mut text,
        "uniforms",
        &UNIFORMS.map(|four| four.map(f32::to_bits)),
    );
    table(&mut text, "words", &WORDS);
    table(&mut text, "areas", &AREAS.map(|area| [area.to_bits()]));
    let handles = bound::tables();
    let tables = tables(&handles);
    let (mut subjects, mut others) = (String::new(), String::new());
    let mut warps = BTreeSet::new();
    for (tier, blocks) in TIERS {
        for block in blocks() {
            for (i, (subject, rust)) in block.golden.iter().enumerate() {
                warps.insert((tier, *subject));
                let made = match tables.iter().find(|(name, _)| name == subject) {
                    Some((_, made)) => Ok(made.clone()),
                    None => call(&block, rust).map(|call| made(&call)),
                };
                match made {
                    Ok(made) => {
                        let function = format!("{tier}_{}_{i}", block.type_name);
                        writeln!(text, "{}", subject_in_c(&function, tier == "poly", &made))
                            .unwrap();
                        writeln!(subjects, "    {{\"{tier} {subject}\", {function}}},").unwrap();
                    }
                    Err(reason) => {
                        writeln!(others, "    {{\"{tier} {subject}\", \"{reason}\"}},").unwrap();
                    }
                }
            }
        }
    }
    for (subject, _, tier) in (0..microwarp_list::cases()).map(microwarp_list::describe) {
        let tier = if tier == "libm" { continue } else { tier };
        if warps.insert((tier, subject)) {
            writeln!(others, "    {{\"{tier} {subject}\", \"it is no warp\"}},").unwrap();
        }
    }
    format!(
        "{text}static const struct subject subjects[] = {{\n{subjects}}};\n\n\
         static const struct other others[] = {{\n{others}}};\n"
    )
}

fn table<const N: usize>(text: &mut String, name: &str, rows: &[[u32; N]]) {
    let rows = rows.iter().map(|row| {
        let row = row.map(|word| format!("0x{word:08x}"));
        format!("    {{{}}},\n", row.join(", "))
    });
    let rows: Vec<String> = rows.collect();
    let (count, rows) = (rows.len(), rows.concat());
    writeln!(
        text,
        "static const uint32_t {name}[{count}][{N}] = {{\n{rows}}};\n"
    )
    .unwrap();
}

/// The calls of one warp, written down.
struct Function<'a> {
    text: String,
    /// `mw_disk_`, and what every call begins with.
    symbol: String,
    itself: &'a str,
}

impl Function<'_> {
    fn line(&mut self, line: &str) {
        self.text.push_str("    ");
        self.text.push_str(line);
        self.text.push('\n');
    }

    fn call(&self, name: &str, arguments: &str) -> String {
        format!("{}{name}({}{arguments})", self.symbol, self.itself)
    }

    /// What yields a value through the last argument, or returns it.
    fn yields(&mut self, to: &str, form: &Form, name: &str, arguments: &str) {
        let line = if form.is_number() {
            format!("{to} = {};", self.call(name, arguments))
        } else {
            let place = if form.is_struct() { "&" } else { "" };
            format!("{};", self.call(name, &format!("{arguments}, {place}{to}")))
        };
        self.line(&line);
    }

    fn puts(&mut self, form: &Form, name: &str) {
        for (place, base, _) in form.places(name) {
            self.line(&format!("put_{base}(out, {place});"));
        }
    }
}

/// Sample, density and inverse, as the golden cases of Rust put them out; and every other way to the same point.
fn subject_in_c(name: &str, is_float: bool, made: &Made) -> String {
    let warp = made.warp;
    let (uniforms, point) = (&warp.uniforms, &warp.point);
    let mut f = Function {
        text: format!("static void {name}(int input, struct out *out)\n{{\n"),
        symbol: format!("{}_", warp.symbol()),
        itself: if warp.is_stored() { "&warp, " } else { "" },
    };
    if warp.is_stored() {
        f.line(&format!("{} warp;", warp.symbol()));
        for line in &made.lines {
            f.line(line);
        }
        let init = f.call(&made.init, &made.arguments);
        // The table has no words of a float warp that is refused, and the refusal of one of integers.
        let refused = if is_float {
            "refused"
        } else {
            "refused_with_word"
        };
        f.line(&format!("if ({refused}(out, {init})) return;"));
    }
    f.line(&format!("{};", uniforms.declared("u")));
    f.line(&format!("{};", point.declared("point")));
    f.line(&format!("{};", point.declared("other")));
    f.line(&format!("{};", point.array("many", 3)));
    let by = if point.is_struct() { "&" } else { "" };
    let place = if point.lengths.is_empty() { "&" } else { "" };
    f.line(&format!(
        "if (input < {}) {{",
        if is_float { "UNIFORMS" } else { "WORDS" }
    ));
    for (place, base, i) in uniforms.places("u") {
        f.line(&format!("{place} = given_{base}(input, {i});"));
    }
    f.yields("point", point, "sample", "u");
    let density = f.call("sample_with_pdf", &format!("u, {place}other"));
    f.line(&format!("expect_density(out, (double){density});"));
    f.line("expect_same(out, &point, &other, sizeof point);");
    f.line("} else {");
    f.line("mw_pcg32 rng = generator(input);");
    f.line("mw_source source = {from_pcg32, &rng}, dry = {fails, NULL};");
    f.yields("point", point, "draw", "&rng");
    for (function, arguments, fills) in [
        ("draw_from", format!("&source, {place}other"), false),
        ("fill", "&rng, many, 2".into(), true),
        ("fill_from", "&source, many, 2".into(), true),
    ] {
        f.line("rng = generator(input);");
        f.line("memset(&many[2], 0xa5, sizeof many[2]);");
        let call = f.call(function, &arguments);
        f.line(&if function == "fill" {
            format!("{call};")
        } else {
            format!("expect_error(out, MW_OK, {call});")
        });
        let drawn = if fills { "&many[0]" } else { "&other" };
        f.line(&format!("expect_same(out, &point, {drawn}, sizeof point);"));
        f.line("expect_untouched(out, &many[2], sizeof many[2]);");
    }
    for (function, arguments) in [
        ("draw_from", format!("&dry, {place}other")),
        ("fill_from", "&dry, many, 3".into()),
    ] {
        let call = f.call(function, &arguments);
        f.line(&format!("expect_error(out, MW_SOURCE_FAILED, {call});"));
    }
    f.line("expect_same(out, &point, &other, sizeof point);");
    let none = f.call("fill_from", "&dry, NULL, 0");
    f.line(&format!("expect_error(out, MW_OK, {none});"));
    f.line("}");
    f.puts(point, "point");
    for anywhere in [false, true] {
        if anywhere && is_float {
            break;
        }
        if anywhere {
            for (place, base, i) in point.places("point") {
                f.line(&format!("{place} = anywhere_{base}(input, {i});"));
            }
        }
        let density = f.call("pdf", &format!("{by}point"));
        f.line(&format!("put_{}(out, {density});", warp.density.base));
        f.yields("u", uniforms, "invert", &format!("{by}point"));
        f.puts(uniforms, "u");
    }
    f.text.push_str("}\n");
    f.text
}
