//! The programs of crates/cores: what may not be linked into each, and what must be found in those that are wrong on
//! purpose.

use crate::forbidden::{self, Kind, Kind::*};
use crate::image::Image;
use microwarp_host::upkeep::Outcome;
use std::path::Path;

/// A program, the function that it must hold, and what it may not link.
const PROGRAMS: [(&str, &str, &[Kind]); 8] = [
    ("all", "microwarp_evaluate", &[Panic, Alloc]),
    ("poly", "microwarp_evaluate_poly", &[Panic, Alloc, F64]),
    ("disk", "microwarp_disk", &[Panic, Alloc, F64]),
    ("table", "microwarp_table", &[Panic, Alloc, F64]),
    ("chain", "microwarp_chain", &[Panic, Alloc, F64]),
    ("fixed", "microwarp_fixed", &[Panic, Alloc, F64, F32]),
    (
        "fixed_disk",
        "microwarp_fixed_disk",
        &[Panic, Alloc, F64, F32],
    ),
    ("integers", "microwarp_integers", &[Panic, Alloc, F64, F32]),
];

const CONTROLS: [(&str, Kind); 4] = [
    ("control_panic", Panic),
    ("control_alloc", Alloc),
    ("control_f64", F64),
    ("control_f32", F32),
];

/// One directory a target. What is found is printed for all of them.
pub fn check(directories: &[&str]) -> Outcome {
    forbidden::control()?;
    let mut unclean = Vec::new();
    for directory in directories {
        let directory = Path::new(directory);
        for (control, kind) in CONTROLS {
            // Where there is a unit for f32, its instructions are no symbols.
            let unit = directory
                .iter()
                .any(|part| part.to_string_lossy().ends_with("hf"));
            if kind != F32 || !unit {
                forbidden::caught(&directory.join(control), "probe_main", kind)?;
            }
        }
        for program in ["all", "poly", "fixed"] {
            forbidden::calls_the_library(&directory.join(program), "probe_main")?;
        }
        no_ram(directory)?;
        for (program, anchor, kinds) in PROGRAMS {
            let path = directory.join(program);
            unclean.extend(forbidden::clean(&path, anchor, kinds).err());
            let (flash, _) = Image::read(&path)?.size();
            println!("    {flash} bytes of flash");
        }
    }
    if unclean.is_empty() {
        Ok(())
    } else {
        Err(unclean.join("\n"))
    }
}

/// A table that the compiler built lies in flash alone, so the program that holds one needs no more RAM than one that
/// holds none.
fn no_ram(directory: &Path) -> Outcome {
    let ram = |program| Image::read(&directory.join(program)).map(|image| image.ram());
    let (have, due, control) = (ram("table")?, ram("disk")?, ram("control_ram")?);
    let place = directory.display();
    if have > due {
        return Err(format!(
            "{place}: table takes {have} bytes of RAM, and disk {due}"
        ));
    }
    if control <= due {
        return Err(format!(
            "{place}: the check does not see the RAM of control_ram"
        ));
    }
    println!("{place}: no RAM for its table ({have} bytes; control_ram has {control})");
    Ok(())
}
