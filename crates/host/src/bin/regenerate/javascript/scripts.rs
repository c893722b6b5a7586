//! The scripts and the typings of the classes.

use super::docs::{Docs, Names};
use super::{Class, Constructor, camel};
use microwarp_host::upkeep::{Outcome, errors};

/// The reasons in words, by their codes from 1 on.
pub fn reasons() -> Outcome<String> {
    let mut lines = String::from(
        "// Why a constructor refuses its parameters, by `cargo regenerate` from src/error.rs: the codes from 1 on. `#` is the\n\
         // index of a weight; `a parameter` is the one that is refused.\nexport const reasons = [\n",
    );
    for (error, _) in errors()? {
        let text = error.to_string().replace("weight 0", "weight #");
        lines += &format!(
            "  {:?},\n",
            text.replace("the first parameter", "a parameter")
        );
    }
    Ok(lines + "];\n")
}

const HEAD: &str =
    "by `cargo regenerate` from crates/list/src/warps.rs and the documentation in src.";

/// The classes that have more than a warp has: by which function of `lamps.js` they are made, with what in front, and of which
/// interface in `lamps.d.ts` they are.
fn more(class: &Class) -> Option<(&'static str, &'static str, &'static str)> {
    Some(match class.name.as_str() {
        "VisibleSphere" => ("lamp", "33, ", "Lamp"),
        "SphericalTriangle" => ("lamp", "34, ", "Lamp"),
        "SphericalRectangle" => ("lamp", "35, ", "Lamp"),
        "GgxVisible" => ("gloss", "", "Gloss"),
        "Ggx" => ("surface", "", "Surface"),
        _ => return None,
    })
}

/// The table of the classes: number of the class and of its first constructor; uniforms, numbers of a point, words of a
/// draw; and the constructors with the numbers of their parameters.
pub fn table(classes: &[Class]) -> String {
    let mut text = format!(
        "// The warps, {HEAD}\nimport {{ gloss, lamp, surface }} from \"./lamps.js\";\nimport {{ warp }} from \"./warp.js\";\n\n"
    );
    let mut first = 0;
    for (class, number) in classes.iter().zip(0..) {
        let constructors = class.constructors.iter().map(|constructor| {
            let lengths = constructor.lengths();
            let lengths: Vec<String> = lengths.iter().map(ToString::to_string).collect();
            constructor.name() + &lengths.concat()
        });
        let constructors: Vec<String> = constructors.collect();
        text += &format!(
            "export const {0} = /*#__PURE__*/ {5}\"{0} {1}\", {number}, {first}, {2}, {3}, {4});\n",
            class.name,
            constructors.join(" "),
            class.uniforms,
            class.numbers,
            class.words,
            more(class).map_or("warp(".into(), |(made, kind, _)| format!("{made}({kind}")),
        );
        first += class.constructors.len();
    }
    text
}

fn type_of(rust: &str) -> &'static str {
    match rust {
        "f32" | "u16" => "number",
        "[f32; 2]" => "Vector2",
        "[f32; 3]" => "Vector3",
        "[[f32; 2]; 2]" => "readonly [Vector2, Vector2]",
        "[[f32; 3]; 2]" => "readonly [Vector3, Vector3]",
        "[[f32; 2]; 3]" => "readonly [Vector2, Vector2, Vector2]",
        "[[f32; 3]; 3]" => "readonly [Vector3, Vector3, Vector3]",
        _ => panic!("no type of TypeScript for {rust}"),
    }
}

fn numbers(count: usize) -> String {
    match count {
        1 => "number".into(),
        _ => format!("[{}]", vec!["number"; count].join(", ")),
    }
}

fn signature(constructor: &Constructor) -> String {
    let parameters = constructor.parameters.iter();
    let parameters =
        parameters.map(|(name, of)| format!("{}: {}", camel(name, false), type_of(of)));
    parameters.collect::<Vec<_>>().join(", ")
}

pub fn typings(classes: &[Class]) -> Outcome<String> {
    let mut text = format!(
        "// The warps, {HEAD}\nimport {{ Gloss, Lamp, Surface }} from \"./lamps.js\";\nimport {{ Vector2, Vector3, Warp }} from \"./warp.js\";\n"
    );
    for class in classes {
        let (docs, names) = (Docs::of(class.block)?, Names::of(class, classes));
        names.control()?;
        let (point, uniforms) = (numbers(class.numbers), numbers(class.uniforms));
        let more = more(class).map_or(String::new(), |(_, _, of)| {
            format!("\nexport interface {} extends {of} {{}}\n", class.name)
        });
        text += &format!(
            "{more}\n{}export declare class {} extends Warp<{point}, {uniforms}> {{\n",
            docs.class(&names)?,
            class.name
        );
        if class
            .constructors
            .iter()
            .all(|constructor| constructor.rust != "new")
        {
            text += "  private constructor();\n";
        }
        for constructor in &class.constructors {
            text += &docs.constructor(constructor.rust, &names)?;
            text += &match constructor.rust {
                "new" => format!("  constructor({});\n", signature(constructor)),
                _ => format!(
                    "  static {}({}): {};\n",
                    constructor.name(),
                    signature(constructor),
                    class.name
                ),
            };
        }
        text += "}\n";
    }
    Ok(text)
}
