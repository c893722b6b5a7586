//! Each rule of the tables, on loops counted by hand.

use microwarp_cores_counter::decode::{Decoder, Instruction, text};
use microwarp_cores_counter::timing::{Cycles, Past, Timing, row};

const M0: Timing = Timing::M0 { multiply: 1 };
const SLOW: Timing = Timing::M0 { multiply: 32 };
const ROUNDS: u32 = 10;

/// Instructions in memory, one behind the other: as they are written, and their halfwords.
type Code = [(&'static str, &'static [u16])];

fn decoded(code: &Code, mut at: u32) -> Vec<Instruction> {
    let mut decoder = Decoder::default();
    let one = |&(written, halves): &(&str, &[u16])| {
        let bytes: Vec<u8> = halves.iter().flat_map(|half| half.to_le_bytes()).collect();
        let (mnemonic, operands) = text(at, &bytes).expect("an instruction");
        assert_eq!(format!("{mnemonic} {operands}").trim(), written);
        let one = decoder
            .instruction(at, &bytes)
            .expect("an instruction that the tables have");
        at = one.end;
        one
    };
    code.iter().map(one).collect()
}

/// Ten rounds of `code`, `subs`, `bne`: the last does not branch.
fn looped(timing: Timing, code: &Code) -> Cycles {
    let tail: &Code = &[("subs r7, #1", &[0x3f01]), ("bne #0x1fe", &[0xd1fc])];
    let length: usize = code.iter().map(|(_, halves)| 2 * halves.len()).sum();
    let mut all = decoded(code, 0x200 - length as u32);
    all.extend(decoded(tail, 0x200));
    let rounds: Vec<_> = (0..ROUNDS).flat_map(|_| &all).collect();
    let mut past = Past::default();
    let cycles = row(timing, &mut past, rounds);
    let leaving = timing.arrive(&past, 0x204);
    assert_eq!(leaving, [0, 0], "the last branch is not taken");
    cycles
}

/// What ten rounds take by hand: `subs` is 1, `bne` 1, and `refill` more where it is taken.
fn by_hand(body: Cycles, refill: Cycles) -> Cycles {
    [0, 1].map(|end| ROUNDS * (body[end] + 2) + (ROUNDS - 1) * refill[end])
}

#[track_caller]
fn holds(timing: Timing, code: &Code, body: Cycles) {
    let refill = match timing {
        Timing::M0 { .. } => [2, 2],
        Timing::M0Plus => [1, 1],
        Timing::M3 | Timing::M4F => [1, 3],
    };
    assert_eq!(
        looped(timing, code),
        by_hand(body, refill),
        "{timing:?}: {code:?}"
    );
}

#[track_caller]
fn small(code: &Code, m0: u32, plus: u32) {
    holds(M0, code, [m0, m0]);
    holds(Timing::M0Plus, code, [plus, plus]);
}

#[track_caller]
fn large(code: &Code, m3: Cycles, m4f: Cycles) {
    holds(Timing::M3, code, m3);
    holds(Timing::M4F, code, m4f);
}

#[test]
fn a_loop_of_nothing() {
    // What the harness calibrates with: three nops. 9 rounds of 3 + 1 + 3, the last of 3 + 1 + 1.
    let code: &Code = &[("nop", &[0xbf00]), ("nop", &[0xbf00]), ("nop", &[0xbf00])];
    assert_eq!(looped(M0, code), [68, 68]);
    assert_eq!(looped(Timing::M0Plus, code), [59, 59]);
    assert_eq!(looped(Timing::M3, code), [59, 77]);
}

#[test]
fn multiplications_and_divisions() {
    let code: &Code = &[("muls r0, r1, r0", &[0x4348])];
    small(code, 1, 1);
    holds(SLOW, code, [32, 32]);
    large(code, [1, 1], [1, 1]);
    large(
        &[("umull r0, r1, r2, r3", &[0xfba2, 0x0103])],
        [3, 5],
        [1, 1],
    );
    large(
        &[("umlal r0, r1, r2, r3", &[0xfbe2, 0x0103])],
        [4, 7],
        [1, 1],
    );
    large(&[("mla r0, r1, r2, r3", &[0xfb01, 0x3002])], [2, 2], [1, 1]);
    large(&[("udiv r0, r1, r2", &[0xfbb1, 0xf0f2])], [2, 12], [2, 12]);
}

#[test]
fn memory_of_the_small_cores() {
    small(
        &[("ldr r0, [r1]", &[0x6808]), ("str r0, [r1, #4]", &[0x6048])],
        4,
        4,
    );
    small(
        &[
            ("ldm r1!, {r2, r3}", &[0xc90c]),
            ("stm r1!, {r2, r3}", &[0xc10c]),
        ],
        6,
        6,
    );
    small(
        &[("push {r4, lr}", &[0xb510]), ("pop {r4}", &[0xbc10])],
        5,
        5,
    );
    small(&[("mrs r0, apsr", &[0xf3ef, 0x8000])], 4, 3);
}

/// Not a loop: `bl` to the third instruction, which returns to the second.
fn called(timing: Timing, code: &Code) -> Cycles {
    let all = decoded(code, 0x200);
    let mut past = Past::default();
    row(timing, &mut past, [&all[0], &all[2], &all[1]])
}

#[test]
fn calls_and_returns() {
    let popping: &Code = &[
        ("bl #0x206", &[0xf000, 0xf801]),
        ("nop", &[0xbf00]),
        ("pop {r4, pc}", &[0xbd10]),
    ];
    // bl 4, 3 or 1 + P; pop of two 4 + 2, 3 + 2 or 1 + 2 + P; nop 1.
    assert_eq!(called(M0, popping), [11, 11]);
    assert_eq!(called(Timing::M0Plus, popping), [9, 9]);
    assert_eq!(called(Timing::M3, popping), [7, 11]);
    let jumping: &Code = &[
        ("bl #0x206", &[0xf000, 0xf801]),
        ("nop", &[0xbf00]),
        ("bx lr", &[0x4770]),
    ];
    assert_eq!(called(M0, jumping), [8, 8]);
    assert_eq!(called(Timing::M0Plus, jumping), [6, 6]);
    assert_eq!(called(Timing::M4F, jumping), [5, 9]);
    let table: &Code = &[
        ("tbb [pc, r0]", &[0xe8df, 0xf000]),
        ("nop", &[0xbf00]),
        ("nop", &[0xbf00]),
    ];
    // 2 + P by the table, at least 6 by the section; two nops, of which neither branches.
    assert_eq!(called(Timing::M3, table), [5, 8]);
}

#[test]
fn loads_that_pair() {
    let both = |code: &Code, cycles| large(code, cycles, cycles);
    // The four examples of the manuals: 3, 3, 3 and 4 cycles.
    both(
        &[("ldr r0, [r1]", &[0x6808]), ("ldr r1, [r2]", &[0x6811])],
        [3, 3],
    );
    both(
        &[
            ("ldr r0, [r1, r2]", &[0x5888]),
            ("str r0, [r3, #0x14]", &[0x6158]),
        ],
        [3, 3],
    );
    both(
        &[
            ("ldr r0, [r1, r2]", &[0x5888]),
            ("str r1, [r3, r2]", &[0x5099]),
        ],
        [3, 3],
    );
    both(
        &[
            ("ldr r0, [r1, r5]", &[0x5948]),
            ("ldr r1, [r2]", &[0x6811]),
            ("ldr r2, [r3, #4]", &[0x685a]),
        ],
        [4, 4],
    );
    // Not where the result is the address, nor behind a store.
    both(
        &[("ldr r0, [r1]", &[0x6808]), ("ldr r2, [r0]", &[0x6802])],
        [4, 4],
    );
    both(
        &[("str r1, [r3, r2]", &[0x5099]), ("ldr r0, [r1]", &[0x6808])],
        [4, 4],
    );
}

#[test]
fn other_memory_of_the_large_cores() {
    let both = |code: &Code, cycles| large(code, cycles, cycles);
    both(&[("str r0, [r3, #0x14]", &[0x6158])], [1, 2]);
    both(&[("ldr r0, [pc, #4]", &[0x4801])], [2, 3]);
    both(&[("ldr r0, [r1], #4", &[0xf851, 0x0b04])], [1, 2]);
    // An address that has just been computed costs one more.
    both(
        &[("adds r1, #4", &[0x3104]), ("ldr r0, [r1]", &[0x6808])],
        [4, 4],
    );
    both(
        &[("adds r1, #4", &[0x3104]), ("ldr r1, [r2]", &[0x6811])],
        [3, 3],
    );
    both(
        &[
            ("ldrd r0, r1, [r2]", &[0xe9d2, 0x0100]),
            ("strd r0, r1, [r2]", &[0xe9c2, 0x0100]),
        ],
        [6, 6],
    );
    both(
        &[
            ("ldm r1!, {r2, r3}", &[0xc90c]),
            ("push {r4, lr}", &[0xb510]),
        ],
        [6, 6],
    );
}

#[test]
fn conditions_within_the_row() {
    let both = |code: &Code, cycles| large(code, cycles, cycles);
    // Folded into 16 bits before it, or not; never into 32.
    both(
        &[
            ("nop", &[0xbf00]),
            ("it eq", &[0xbf08]),
            ("mov r0, r1", &[0x4608]),
        ],
        [2, 3],
    );
    both(
        &[
            ("add.w r0, r1, r2", &[0xeb01, 0x0002]),
            ("it eq", &[0xbf08]),
            ("mov r0, r1", &[0x4608]),
        ],
        [3, 3],
    );
    // A load that is skipped takes a cycle.
    both(
        &[
            ("add.w r0, r1, r2", &[0xeb01, 0x0002]),
            ("it eq", &[0xbf08]),
            ("ldr r0, [r1]", &[0x6808]),
        ],
        [3, 4],
    );
}

#[test]
fn floats() {
    let unit = |code: &Code, cycles| holds(Timing::M4F, code, cycles);
    let sum = ("vadd.f32 s0, s1, s2", &[0xee30, 0x0a81][..]);
    unit(&[sum], [1, 1]);
    // A result is a cycle late for the next instruction, but not as an addend.
    unit(&[sum, ("vmul.f32 s3, s4, s2", &[0xee62, 0x1a01])], [2, 2]);
    unit(&[sum, ("vmul.f32 s3, s0, s2", &[0xee60, 0x1a01])], [3, 3]);
    unit(&[sum, ("vmla.f32 s0, s1, s2", &[0xee00, 0x0a81])], [4, 4]);
    unit(&[sum, ("vmla.f32 s3, s0, s2", &[0xee40, 0x1a01])], [5, 5]);
    unit(
        &[
            ("vcvt.f32.u32 s0, s0", &[0xeeb8, 0x0a40]),
            ("vcmp.f32 s0, s1", &[0xeeb4, 0x0a60]),
        ],
        [3, 3],
    );
    unit(
        &[
            ("vldr s0, [r0]", &[0xed90, 0x0a00]),
            ("vstr s0, [r0]", &[0xed80, 0x0a00]),
        ],
        [4, 4],
    );
    unit(
        &[
            ("vldmia r0, {s0, s1, s2}", &[0xec90, 0x0a03]),
            ("vpush {d8}", &[0xed2d, 0x8b02]),
        ],
        [7, 7],
    );
    unit(&[("vmov r0, s0", &[0xee10, 0x0a10])], [1, 2]);
    unit(&[("vmov r0, r1, d0", &[0xec51, 0x0b10])], [2, 2]);
}

#[test]
fn divisions_beside_integers() {
    let unit = |code: &Code, cycles| holds(Timing::M4F, code, cycles);
    let (quotient, root) = (
        ("vdiv.f32 s0, s1, s2", &[0xee80, 0x0a81][..]),
        ("vsqrt.f32 s0, s1", &[0xeeb1, 0x0ae0][..]),
    );
    let (other, user) = (
        ("vmul.f32 s3, s4, s2", &[0xee62, 0x1a01][..]),
        ("vmul.f32 s3, s0, s2", &[0xee60, 0x1a01][..]),
    );
    let nop = ("nop", &[0xbf00][..]);
    // 14, and 1 for what waits for it; one more where that uses the result.
    unit(&[quotient, other], [15, 15]);
    unit(&[root, user], [16, 16]);
    // At best three nops run meanwhile.
    unit(&[quotient, nop, nop, nop, other], [15, 18]);
}
