//! The application of examples/firmware, and its pictures: what it may not link, and what it occupies, compared with its sizes.csv.
//!
//! examples/firmware/check has copied them to target/firmware/TARGET, the application once with each way to log.

use crate::forbidden::{self, Kind};
use crate::image::Image;
use crate::sizes::{self, compare};
use crate::target;
use microwarp_host::upkeep::{Outcome, read, write};

const RECORD: &str = "examples/firmware/sizes.csv";
const PROGRAMS: [&str; 8] = [
    "app_rtt",
    "app",
    "room_poly",
    "room_libm",
    "sensor_poly",
    "sensor_libm",
    "slit_poly",
    "slit_libm",
];
const TITLES: [&str; 2] = ["flash", "RAM"];

pub fn check(compiler: &str, writes: bool) -> Outcome {
    forbidden::control()?;
    sizes::control(TITLES)?;
    let mut rows = Vec::new();
    for target_name in ["thumbv6m-none-eabi", "thumbv7em-none-eabihf"] {
        for program in PROGRAMS {
            let file = target("firmware").join(target_name).join(program);
            // Its panics are those of the logger and of checked indices. The functions of `libm` take double precision.
            let kinds: &[Kind] = match program.ends_with("_libm") {
                true => &[Kind::Alloc],
                false => &[Kind::Alloc, Kind::F64],
            };
            forbidden::clean(&file, "main", kinds)?;
            let image = Image::read(&file)?;
            // `.defmt`, the strings of the log, stays on the host.
            rows.push((
                format!("{program},{target_name}"),
                [image.size().0, image.ram()],
            ));
        }
    }
    if writes {
        let mut text = format!("# {compiler}\nprogram,target,flash,ram\n");
        for (name, [flash, ram]) in &rows {
            text += &format!("{name},{flash},{ram}\n");
        }
        write(RECORD, &text)?;
    }
    let text = read(RECORD)?;
    let percent = if text.starts_with(&format!("# {compiler}\n")) {
        3
    } else {
        15
    };
    compare(&sizes::parse(&text)?, &rows, TITLES, percent, true)?;
    println!(
        "flash and RAM of {} programs are as recorded, to {percent} %",
        rows.len()
    );
    Ok(())
}
