//! The same sky in 32 × 16 cells, for a device: a table that the compiler builds and flash holds.

use crate::picture::Picture;
use crate::small_weights::WEIGHTS;
use microwarp::discrete::PiecewiseConstant2d;
use std::fmt::Write;

pub const SHAPE: [usize; 2] = [32, 16];

pub type Table = PiecewiseConstant2d<[u32; 16], [[u32; 32]; 16]>;

/// Azimuth in [0, 1) and polar angle in [0, ½), in turns as `Spherical` has them.
pub static SKY: Table = match Table::new(&WEIGHTS, [0.0, 1.0], [0.0, 0.5]) {
    Ok(table) => table,
    Err(_) => panic!("bad weights"),
};

/// What every byte of the table is: the words, and the numbers that say what they mean.
pub const WORDS: usize = 4 * (16 + 512);
const _: () = assert!(size_of::<Table>() == WORDS + 44);

/// Where the system has put the table, in the words of its own list of mappings: memory that may not be
/// written to is that of the program file, and no RAM of the program's own. `None` where it cannot say.
pub fn mapping() -> Option<String> {
    let address = (&raw const SKY).addr();
    let maps = std::fs::read_to_string("/proc/self/maps").ok()?;
    maps.lines().find_map(|line| {
        let (range, rest) = line.split_once(' ')?;
        let (from, to) = range.split_once('-')?;
        let [from, to] = [from, to].map(|hex| usize::from_str_radix(hex, 16));
        let permissions = rest.split(' ').next()?;
        (from.ok()? <= address && address < to.ok()?).then(|| permissions.to_string())
    })
}

/// The picture in cells of the table's size.
pub fn picture(of: &Picture) -> Picture {
    of.shrunk(of.shape[0] / SHAPE[0])
}

/// `small_weights.rs`. Five digits are enough, and the decimal text of a float says the same on every
/// machine.
pub fn source(of: &Picture) -> String {
    let mut text = String::from(
        "//! Generated from sky.png by `--make-picture`: luminance times sin θ in 32 × 16 cells.\n\n\
         #[rustfmt::skip]\n\
         pub const WEIGHTS: [[f32; 32]; 16] = [\n",
    );
    for row in picture(of).weights().chunks(SHAPE[0]) {
        text.push_str("    [");
        for (i, weight) in row.iter().enumerate() {
            let gap = match i {
                0 => "",
                _ if i % 8 == 0 => ",\n     ",
                _ => ", ",
            };
            write!(text, "{gap}{weight:.4e}").expect("a string takes any text");
        }
        text.push_str("],\n");
    }
    text + "];\n"
}
