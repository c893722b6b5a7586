//! The rim of the disk: as wide as the sines and products of a grade allow, and not a word wider.
//!
//! `MICROWARP_WRITE=1 MICROWARP_FULL=all cargo test --test fixed rim` writes it anew.

use super::inputs::{Words, edges};
use fixed::types::{I2F30, U0F32};
use host::speed;
use microwarp::Warp;
use microwarp::fixed::{Coarse, Compact, Fine, Grade, warp::Disk};
use rand_core::{Rng, SeedableRng};
use rand_pcg::Pcg32;
use std::path::Path;

type Sincos = fn(u32) -> (i32, i32);
type Scaled = fn(u32, i32) -> i32;

/// The product of a length and a sine, from all digits but the lowest of the sine.
fn near_signed(length: u32, by: i32) -> i32 {
    let (high, low) = (by >> 16, by & 0xffff);
    let exact = (i64::from(length) * i64::from(high)) >> 16;
    exact as i32 + ((u64::from(length >> 16) * low as u64) >> 16) as i32
}

/// From the first 15 digits of the length and 17 of the sine.
fn rough_signed(length: u32, by: i32) -> i32 {
    ((length >> 17) as i32 * (by >> 14)) >> 1
}

fn sincos<G: Grade>(phase: u32) -> (i32, i32) {
    let (s, c) = G::sincos_turns(U0F32::from_bits(phase));
    (s.to_bits(), c.to_bits())
}

/// What the source says of a grade: its rim, and the product that scales by a sine. Replaces the rim where one is
/// given.
fn rim_and_product(kernel: &str, new: Option<u32>) -> (u32, Scaled) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/fixed/grade.rs");
    let mut text = std::fs::read_to_string(&path).unwrap();
    let start = text.find(&format!("kernels: {kernel},")).unwrap();
    let value = |name: &str| {
        let from = start + text[start..].find(name).unwrap() + name.len();
        from..from + text[from..].find(',').unwrap()
    };
    let (rim, scaled) = (value(" rim: "), &text[value(" product: ")]);
    let scaled = match scaled {
        "near_signed" => near_signed,
        "rough_signed" => rough_signed,
        other => panic!("{other}"),
    };
    if let Some(new) = new {
        let word = format!("{:#x}_{:04x}", new >> 16, new & 0xffff);
        text.replace_range(rim, &word);
        std::fs::write(&path, text).unwrap();
        return (new, scaled);
    }
    let digits = text[rim].trim_start_matches("0x").replace('_', "");
    (u32::from_str_radix(&digits, 16).unwrap(), scaled)
}

fn inside(x: i32, y: i32) -> bool {
    let (x, y) = (i64::from(x), i64::from(y));
    x * x + y * y <= 1 << 60
}

/// The largest radius with which no phase leads out of the disk.
///
/// A radius with fewer leading half words is too small by far to leave it; with the same one, products do not grow
/// as the radius falls.
fn widest(name: &str, sincos: Sincos, scaled: Scaled) -> u32 {
    let states = Words::every(2048, 64).fold(
        name,
        &edges(),
        || u32::MAX,
        |radius: &mut u32, phase| {
            let (s, c) = sincos(phase);
            while !inside(scaled(*radius, c), scaled(*radius, s)) {
                *radius -= 1;
            }
        },
    );
    states.into_iter().min().unwrap()
}

#[test]
fn the_rim_is_the_widest() {
    let grades: [(&str, Sincos); 3] = [
        (Fine::NAME, sincos::<Fine>),
        (Coarse::NAME, sincos::<Coarse>),
        (Compact::NAME, sincos::<Compact>),
    ];
    for (name, sincos) in grades {
        let (_, scaled) = rim_and_product(name, None);
        let widest = widest(name, sincos, scaled);
        let write = speed::all() && std::env::var_os("MICROWARP_WRITE").is_some();
        let (rim, _) = rim_and_product(name, write.then_some(widest));
        println!("{name}: rim {rim:#x}, widest {widest:#x}");
        if speed::all() {
            assert_eq!(rim, widest, "{name}");
        } else {
            // Some of the phases allow no less than all of them.
            assert!(
                rim <= widest && widest - rim <= 64,
                "{name}: {rim:#x}, {widest:#x}"
            );
        }
    }
    // A wider one is noticed: sines on the unit circle without its margin, that is, of length 1 and a bit more.
    let too_long = |phase| {
        let (s, c) = sincos::<Fine>(phase);
        (s + (s >> 18), c + (c >> 18))
    };
    let (rim, scaled) = rim_and_product("fine", None);
    assert!(widest("control", too_long, scaled) < rim);
}

fn points_lie_inside<G: Grade>() {
    let disk = Disk::<G>::new();
    let bits = |[x, y]: [I2F30; 2]| (x.to_bits(), y.to_bits());
    let states = Words::every(2048, 64).fold(
        G::NAME,
        &edges(),
        || 0_u64,
        |outside, phase| {
            let (x, y) = bits(disk.sample([U0F32::MAX, U0F32::from_bits(phase)]));
            *outside += u64::from(!inside(x, y));
        },
    );
    assert_eq!(states.iter().sum::<u64>(), 0, "{}", G::NAME);
    // At random, and next to the rim at all scales; each the product of the radius and a sine that the rim is made for.
    let (rim, scaled) = rim_and_product(G::NAME, None);
    let mut rng = Pcg32::seed_from_u64(5);
    for i in 0..speed::of("points next to the rim", 1_u32 << 20, 1 << 22) {
        let u1 = !(rng.next_u32() >> (i & 31));
        let u2 = rng.next_u32();
        let (x, y) = bits(disk.sample([u1, u2].map(U0F32::from_bits)));
        assert!(inside(x, y), "{}: {u1:#x}, {u2:#x}", G::NAME);
        let radius = G::sqrt(U0F32::from_bits(u1)).to_bits().min(rim);
        let (s, c) = sincos::<G>(u2);
        assert_eq!(
            (x, y),
            (scaled(radius, c), scaled(radius, s)),
            "{u1:#x}, {u2:#x}"
        );
    }
}

#[test]
fn the_disk_is_inside_the_unit_circle() {
    points_lie_inside::<Fine>();
    points_lie_inside::<Coarse>();
    points_lie_inside::<Compact>();
}
