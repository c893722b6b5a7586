//! The tables of what the scenes of `examples/scene` take on cores.

use crate::sources::{Sources, grouped};
use crate::tables::{of_firmware, rows};
use microwarp_host::upkeep::{Outcome, read};

/// What the pictures of examples/firmware occupy, and what the emulator counted.
pub fn pictures() -> Outcome<String> {
    let ((compiler, sizes), (of, counts)) = (of_firmware("sizes.csv")?, of_firmware("scenes.csv")?);
    if of != compiler {
        return Err(format!("scenes.csv is of {of}, sizes.csv of {compiler}"));
    }
    let mut text = format!(
        "Instructions on the emulated core, bytes; {compiler}:\n\n\
         | program | target | instructions a path | flash | RAM | stack |\n|---|---|--:|--:|--:|--:|\n"
    );
    for [program, target, instructions, stack] in counts {
        let size = sizes
            .iter()
            .find(|row| row[0] == program && row[1] == target);
        let [_, _, flash, ram] = size.ok_or_else(|| format!("sizes.csv has no {program}"))?;
        let instructions = instructions
            .parse()
            .map_err(|_| format!("{program}: {instructions}"))?;
        text += &rows(&[vec![
            format!("`{program}`"),
            format!("`{target}`"),
            grouped(instructions),
            flash.clone(),
            ram.clone(),
            stack,
        ]]);
    }
    Ok(text)
}

/// What the example `scene` has measured of accuracy, as it printed it.
pub fn accuracy() -> Outcome<String> {
    let text = read("docs/measured/scene.md")?;
    let (_, tables) = text
        .split_once("\n\n")
        .ok_or("docs/measured/scene.md has no tables")?;
    Ok(tables.to_owned())
}

/// The scenes, and their kernels.
const SCENES: [&str; 5] = ["room", "fog", "slivers", "slit", "sensor"];

/// What an ingredient is, and the kernel that has it.
const INGREDIENTS: [(&str, &str); 8] = [
    ("a camera with a polygon lens", "with_lens"),
    ("a round lamp in place of a rectangle", "with_sphere"),
    ("glossy in place of matte", "with_glossy"),
    ("GGX in place of matte", "with_ggx"),
    ("fog", "with_fog"),
    ("a sky, with its table of 32 × 16", "with_sky"),
    ("Sobol' points in place of PCG32", "with_sobol"),
    (
        "Metropolis light transport, and such a camera",
        "with_metropolis",
    ),
];

const CORES: [&str; 3] = ["m0", "m4f", "wasm"];

/// What a path of each scene occupies alone, and takes.
pub fn paths(sources: &Sources) -> Outcome<String> {
    let mut text = String::from(
        "| a path, in `poly` | flash: M0 | M4F | bytes: WASM | instructions: M0 | M4F | WASM |\n\
         |---|--:|--:|--:|--:|--:|--:|\n",
    );
    for scene in SCENES {
        let kernel = format!("poly_path_{scene}");
        let mut row = vec![format!("`{scene}`")];
        for core in CORES {
            row.push(grouped(sources.flash(core, &kernel)?));
        }
        for core in CORES {
            row.push(grouped(sources.instructions(core, &kernel)?));
        }
        text += &rows(&[row]);
    }
    Ok(text)
}

/// What each ingredient adds to the path of a scene that has none of them.
pub fn ingredients(sources: &Sources) -> Outcome<String> {
    let flash = |core, kernel| sources.flash(core, &format!("poly_path_{kernel}"));
    let mut text =
        String::from("| bytes | M0 | M4F | WASM |\n|---|--:|--:|--:|\n| none of these |");
    for core in CORES {
        text += &format!(" {} |", grouped(flash(core, "plain")?));
    }
    text.push('\n');
    for (label, kernel) in INGREDIENTS {
        text += &format!("| {label} |");
        for core in CORES {
            let (now, before) = (flash(core, kernel)?, flash(core, "plain")?);
            let sign = if now < before { '−' } else { '+' };
            text += &format!(" {sign}{} |", grouped(now.abs_diff(before)));
        }
        text.push('\n');
    }
    Ok(text)
}
