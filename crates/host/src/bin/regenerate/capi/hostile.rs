//! Bad input for every warp, as C functions for `bindings/c/tests/hostile.c`.

use super::bound::Bound;
use super::comments::Comments;
use super::form::Form;
use super::header::{FIXED, POLY};
use microwarp_host::upkeep::Outcome;
use std::collections::BTreeSet;
use std::fmt::Write;

/// A function for each warp, and their list.
pub fn hostile() -> Outcome<String> {
    let mut text = "/* Written by `capi hostile`; included by hostile.c. */\n".to_owned();
    let mut list = String::new();
    for (blocks, sentences, folder, _) in [POLY].into_iter().chain(FIXED) {
        let comments = Comments::read(sentences, folder)?;
        for warp in blocks().into_iter().flat_map(|block| block.bound) {
            text.push_str(&of(&warp, &comments));
            writeln!(list, "    hostile_{}{},", warp.tier, warp.name).unwrap();
        }
    }
    Ok(format!(
        "{text}static void (*const hostile[])(void) = {{\n{list}}};\n"
    ))
}

/// Statements that give every number of a value something hostile.
fn filled(form: &Form, name: &str) -> String {
    let numbers = form.places(name);
    let set = numbers
        .iter()
        .map(|(place, base, _)| format!("        {place} = bad_{base}();\n"));
    set.collect()
}

fn of(warp: &Bound, comments: &Comments) -> String {
    let (symbol, uniforms, point) = (warp.symbol(), &warp.uniforms, &warp.point);
    let is_float = warp.tier.is_empty();
    let mut text = format!("static void hostile_{}{}(void)\n{{\n", warp.tier, warp.name);
    if warp.is_stored() {
        writeln!(text, "    struct {{ unsigned char before[64]; {symbol} warp; unsigned char after[64]; }} guarded, untouched;").unwrap();
    }
    writeln!(
        text,
        "    {};\n    {};",
        uniforms.declared("u"),
        point.declared("point")
    )
    .unwrap();
    let itself = if warp.is_stored() {
        "&guarded.warp, "
    } else {
        ""
    };
    let u = "u";
    let by = if point.is_struct() { "&" } else { "" };
    let place = if point.lengths.is_empty() { "&" } else { "" };
    let trials = [("init".to_owned(), &Vec::new(), BTreeSet::new())];
    let constructors = warp.constructors.iter().map(|c| {
        let name = match c.name {
            "new" => "init".to_owned(),
            name => format!("init_{name}"),
        };
        (
            name,
            &c.parameters,
            comments.codes(warp.type_name(), c.name),
        )
    });
    let constructors: Vec<_> = if warp.is_stored() {
        constructors.collect()
    } else {
        trials.into()
    };
    for (init, parameters, codes) in constructors {
        text.push_str("    for (int round = 0; round < ROUNDS; round++) {\n");
        if warp.is_stored() {
            let mut arguments = vec!["&guarded.warp".to_owned()];
            for (parameter, form) in parameters {
                let name = format!("given_{parameter}");
                writeln!(text, "        {};", form.declared(&name)).unwrap();
                arguments.push(name);
            }
            for (parameter, form) in parameters {
                text.push_str(&filled(form, &format!("given_{parameter}")));
            }
            text.push_str(
                "        memset(&guarded, 0xa5, sizeof guarded);\n        untouched = guarded;\n",
            );
            let arguments = arguments.iter().zip(
                [None]
                    .into_iter()
                    .chain(parameters.iter().map(|p| Some(&p.1))),
            );
            // What is an array of arrays is const in the header, which C does not add by itself.
            let arguments: Vec<_> = arguments
                .map(|(name, form)| match form {
                    Some(form) if form.lengths.len() > 1 => {
                        format!("(const {} (*)[{}]){name}", form.base, form.lengths[1])
                    }
                    _ => name.clone(),
                })
                .collect();
            writeln!(
                text,
                "        mw_error error = {symbol}_{init}({});",
                arguments.join(", ")
            )
            .unwrap();
            let stated: String = codes
                .iter()
                .map(|code| format!(" || error == {code}"))
                .collect();
            writeln!(
                text,
                "        if (error != MW_OK)\n            CHECK(false{stated});"
            )
            .unwrap();
            text.push_str(
                "        if (error != MW_OK) {\n            refusals++;\n            CHECK(is_refusal(error) && memcmp(&guarded, &untouched, sizeof guarded) == 0);\n            continue;\n        }\n        accepted++;\n        CHECK(memcmp(guarded.after, untouched.after, 64) == 0);\n",
            );
        }
        text.push_str(&filled(uniforms, "u"));
        writeln!(
            text,
            "        CHECK(good_{}({symbol}_sample_with_pdf({itself}{u}, {place}point)));",
            warp.density.base
        )
        .unwrap();
        for (number, base, _) in point.places("point") {
            if base == "float" {
                writeln!(text, "        CHECK(isfinite({number}));").unwrap();
            }
        }
        text.push_str(&filled(point, "point"));
        writeln!(
            text,
            "        CHECK(good_{}({symbol}_pdf({itself}{by}point)));",
            warp.density.base
        )
        .unwrap();
        if uniforms.is_number() {
            writeln!(text, "        u = {symbol}_invert({itself}{by}point);").unwrap();
        } else {
            writeln!(text, "        {symbol}_invert({itself}{by}point, u);").unwrap();
        }
        if is_float {
            for (number, ..) in uniforms.places("u") {
                writeln!(text, "        CHECK({number} >= 0.0f && {number} < 1.0f);").unwrap();
            }
        }
        text.push_str("    }\n");
    }
    text.push_str("}\n\n");
    text
}
