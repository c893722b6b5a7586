//! What the manuals' tables distinguish about an instruction, read from its disassembly.

use capstone::prelude::*;

/// The rows of the tables, as far as compiled code reaches them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Class {
    /// Moves, sums, logic, shifts, bit fields, comparisons, and what else takes one cycle everywhere.
    Simple,
    Multiply,
    MultiplyAdd,
    LongMultiply,
    LongMultiplyAdd,
    Divide,
    /// Of a word or less. A literal lies beside the code; a base update leaves the address in its register.
    Load {
        literal: bool,
        update: bool,
    },
    Store {
        immediate: bool,
    },
    /// So many words by one instruction: `ldm`, `pop`, `ldrd`; the program counter among them or not.
    LoadWords {
        words: u32,
        counter: bool,
    },
    StoreWords {
        words: u32,
    },
    /// `ldr` into the program counter.
    LoadCounter,
    Branch {
        conditional: bool,
    },
    /// `bl`.
    Call,
    /// By a register: `bx`, `blx`, `mov pc`. A return goes to the caller.
    Jump {
        back: bool,
    },
    /// `tbb`, `tbh`.
    TableBranch,
    /// `it`, which makes what follows conditional.
    IfThen,
    /// `mrs`, `msr`.
    Special,
    Barrier,
    /// Sums, products and conversions.
    Float,
    /// What has no rounding to do: moves, signs, comparisons.
    FloatSimple,
    FloatMultiplyAdd,
    /// Quotients and square roots.
    FloatDivide,
    /// Between a register of the core, or two, and those of the unit.
    FloatMove {
        two: bool,
    },
    /// Words to or from memory.
    FloatWords {
        words: u32,
    },
}

/// Registers as bits: r0 to r15, then s0 to s31.
pub type Registers = u64;

const COUNTER: Registers = 1 << 15;
const LINK: Registers = 1 << 14;
const STACK: Registers = 1 << 13;
const CORE: Registers = 0xffff;
const FLOATS: Registers = !0 << 16;

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Instruction {
    pub at: u32,
    /// Where the next one lies.
    pub end: u32,
    pub class: Class,
    /// Only under the condition of an `it`.
    pub predicated: bool,
    /// What it computes or loads.
    pub writes: Registers,
    /// What an address is made of.
    pub address: Registers,
    /// What it computes from. Not the addend of a multiplication, which is wanted a cycle later.
    pub reads: Registers,
}

impl Instruction {
    /// Where it goes on is decided here, and is no return.
    pub fn decides(&self) -> bool {
        match self.class {
            Class::Branch { conditional } => conditional || self.predicated,
            Class::Jump { back } => !back || self.predicated,
            Class::LoadWords { counter, .. } => counter && self.predicated,
            Class::TableBranch | Class::LoadCounter => true,
            _ => false,
        }
    }

    /// It leaves the row unless its condition fails.
    pub fn branches(&self) -> bool {
        matches!(
            self.class,
            Class::Branch { .. }
                | Class::Call
                | Class::Jump { .. }
                | Class::TableBranch
                | Class::LoadCounter
        ) || matches!(self.class, Class::LoadWords { counter: true, .. })
    }

    pub fn half(&self) -> bool {
        self.end - self.at == 2
    }
}

/// How an instruction would be written: its mnemonic and its operands.
pub fn text(at: u32, bytes: &[u8]) -> Option<(String, String)> {
    let builder = Capstone::new().arm().mode(arch::arm::ArchMode::Thumb);
    let capstone = builder
        .extra_mode([arch::arm::ArchExtraMode::MClass].into_iter())
        .build()
        .ok()?;
    let decoded = capstone.disasm_count(bytes, at.into(), 1).ok()?;
    let one = decoded
        .iter()
        .next()
        .filter(|one| one.len() == bytes.len())?;
    Some((
        one.mnemonic()?.into(),
        one.op_str().unwrap_or_default().into(),
    ))
}

#[derive(Default)]
pub struct Decoder {
    /// Where an `it` still governs, and how many instructions.
    governed: (u32, usize),
}

impl Decoder {
    /// An instruction, which must follow the one before in memory where that is `it`.
    pub fn instruction(&mut self, at: u32, bytes: &[u8]) -> Result<Instruction, String> {
        // Near the end of a page QEMU looks ahead, and hands out what it saw.
        let length = if bytes[1] >> 3 >= 0b11101 { 4 } else { 2 };
        let bytes = &bytes[..length.min(bytes.len())];
        let (mnemonic, operands) =
            text(at, bytes).ok_or_else(|| format!("{at:#x}: {bytes:02x?} is unknown"))?;
        let end = at + bytes.len() as u32;
        let predicated = self.governed.0 == at && self.governed.1 > 0;
        if predicated {
            self.governed = (end, self.governed.1 - 1);
        }
        let name = mnemonic.split('.').next().unwrap_or_default();
        let operands = Operands::read(&operands);
        let class =
            class(name, &operands).ok_or_else(|| format!("{at:#x}: no row for {mnemonic}"))?;
        if class == Class::IfThen {
            self.governed = (end, name.len() - 1);
        }
        let (writes, reads) = operands.flow(class, name);
        let address = match name {
            "push" | "pop" | "vpush" | "vpop" => STACK,
            _ if operands.memory
                || !matches!(
                    class,
                    Class::LoadWords { .. } | Class::StoreWords { .. } | Class::FloatWords { .. }
                ) =>
            {
                operands.address
            }
            _ => operands.first(),
        };
        Ok(Instruction {
            at,
            end,
            class,
            predicated,
            writes,
            address,
            reads: reads & FLOATS,
        })
    }
}

/// The registers of an instruction in the order in which they are written.
struct Operands {
    plain: Vec<Registers>,
    /// Those in brackets.
    address: Registers,
    memory: bool,
    immediate: bool,
    update: bool,
}

impl Operands {
    fn read(text: &str) -> Self {
        let (plain, rest) = text.split_once('[').unwrap_or((text, ""));
        let (inside, behind) = rest.split_once(']').unwrap_or((rest, ""));
        let all = |text: &str| registers(text).into_iter().fold(0, |all, one| all | one);
        Self {
            plain: registers(plain),
            address: all(inside) | all(behind),
            memory: text.contains('['),
            immediate: registers(inside).len() < 2,
            update: !behind.is_empty(),
        }
    }

    fn all(&self) -> Registers {
        self.plain.iter().fold(0, |all, one| all | one)
    }

    /// How many words are in a list, of which a double has two.
    fn words(&self, list: &[Registers]) -> u32 {
        list.iter().map(|one| one.count_ones()).sum()
    }

    fn first(&self) -> Registers {
        self.plain.first().copied().unwrap_or(0)
    }

    /// What is written, and what of the floats is read: the result comes first.
    fn flow(&self, class: Class, name: &str) -> (Registers, Registers) {
        let (all, first) = (self.all(), self.first());
        let rest = self.plain.iter().skip(1).fold(0, |all, one| all | one);
        match class {
            Class::Simple | Class::FloatSimple
                if matches!(
                    name,
                    "cmp" | "cmn" | "tst" | "teq" | "vcmp" | "vcmpe" | "vmsr"
                ) =>
            {
                (0, all)
            }
            Class::FloatMove { two: true } if first & CORE != 0 => (all & CORE, all & FLOATS),
            Class::FloatMove { two: true } => (all & FLOATS, all & CORE),
            Class::FloatWords { .. } if name.starts_with("vs") || name == "vpush" => (0, all),
            Class::Store { .. } | Class::StoreWords { .. } => (0, all),
            Class::LongMultiply
            | Class::LongMultiplyAdd
            | Class::FloatWords { .. }
            | Class::LoadWords { .. } => (all, rest),
            _ => (first, rest),
        }
    }
}

/// The registers of a text, one by one.
fn registers(text: &str) -> Vec<Registers> {
    text.split(|c: char| !c.is_ascii_alphanumeric())
        .filter_map(register)
        .collect()
}

fn register(name: &str) -> Option<Registers> {
    let index = |from: usize| name.get(from..)?.parse::<u32>().ok();
    match name {
        "sb" => Some(1 << 9),
        "sl" => Some(1 << 10),
        "fp" => Some(1 << 11),
        "ip" => Some(1 << 12),
        "sp" => Some(STACK),
        "lr" => Some(LINK),
        "pc" => Some(COUNTER),
        _ if name.starts_with('r') => index(1).filter(|&i| i < 16).map(|i| 1 << i),
        _ if name.starts_with('s') => index(1).filter(|&i| i < 32).map(|i| 1 << (16 + i)),
        _ if name.starts_with('d') => index(1).filter(|&i| i < 16).map(|i| 3 << (16 + 2 * i)),
        _ => None,
    }
}

const CONDITIONS: &str = "eq ne hs lo cs cc mi pl vs vc hi ls ge lt gt le";
const SIMPLE: &str = "mov movs movw movt mvn mvns add adds addw adc adcs sub subs subw sbc sbcs rsb rsbs neg and ands orr \
    orrs orn orns eor eors bic bics tst teq cmp cmn lsl lsls lsr lsrs asr asrs ror rors rrx rrxs adr nop \
    sxth sxtb uxth uxtb sxtb16 uxtb16 sxtab16 uxtab16 sxtah sxtab uxtah uxtab ubfx sbfx bfi bfc clz rbit rev rev16 revsh ssat usat \
    smulbb smulbt smultb smultt smulwb smulwt smlabb smlabt smlatb smlatt smlawb smlawt smmul smmulr smmla smmlar \
    smmls smmlsr smuad smusd umaal uadd8 uadd16 usub8 usub16 sadd16 ssub16 sel pkhbt pkhtb qadd qsub";

fn class(name: &str, operands: &Operands) -> Option<Class> {
    let listed = |list: &str| list.split_whitespace().any(|one| one == name);
    let counter = operands.all() & COUNTER != 0;
    Some(match name {
        "mul" | "muls" => Class::Multiply,
        "mla" | "mls" => Class::MultiplyAdd,
        "umull" | "smull" => Class::LongMultiply,
        "umlal" | "smlal" => Class::LongMultiplyAdd,
        "udiv" | "sdiv" => Class::Divide,
        "ldr" | "ldrb" | "ldrh" | "ldrsb" | "ldrsh" if counter => Class::LoadCounter,
        "ldr" | "ldrb" | "ldrh" | "ldrsb" | "ldrsh" => Class::Load {
            literal: operands.address == COUNTER,
            update: operands.update,
        },
        "str" | "strb" | "strh" => Class::Store {
            immediate: operands.immediate,
        },
        "pop" | "ldrd" => Class::LoadWords {
            words: operands.words(&operands.plain),
            counter,
        },
        "push" | "strd" => Class::StoreWords {
            words: operands.words(&operands.plain),
        },
        // The first is the base.
        "ldm" | "ldmdb" => Class::LoadWords {
            words: operands.words(&operands.plain[1..]),
            counter,
        },
        "stm" | "stmdb" => Class::StoreWords {
            words: operands.words(&operands.plain[1..]),
        },
        "b" => Class::Branch { conditional: false },
        "cbz" | "cbnz" => Class::Branch { conditional: true },
        "bl" => Class::Call,
        "bx" => Class::Jump {
            back: operands.all() == LINK,
        },
        "blx" => Class::Jump { back: false },
        "mov" | "add" if operands.first() == COUNTER => Class::Jump {
            back: operands.all() == COUNTER | LINK,
        },
        "tbb" | "tbh" => Class::TableBranch,
        "mrs" | "msr" => Class::Special,
        "dmb" | "dsb" | "isb" => Class::Barrier,
        "vdiv" | "vsqrt" => Class::FloatDivide,
        "vadd" | "vsub" | "vmul" | "vnmul" | "vcvt" | "vcvtr" | "vcvtb" | "vcvtt" => Class::Float,
        "vmla" | "vmls" | "vnmla" | "vnmls" | "vfma" | "vfms" | "vfnma" | "vfnms" => {
            Class::FloatMultiplyAdd
        }
        "vabs" | "vneg" | "vcmp" | "vcmpe" | "vmrs" | "vmsr" => Class::FloatSimple,
        "vmov" => match (operands.all() & CORE).count_ones() {
            0 => Class::FloatSimple,
            of => Class::FloatMove { two: of == 2 },
        },
        "vldr" | "vstr" | "vpush" | "vpop" => Class::FloatWords {
            words: operands.words(&operands.plain),
        },
        "vldmia" | "vstmia" | "vldmdb" | "vstmdb" => Class::FloatWords {
            words: operands.words(&operands.plain[1..]),
        },
        _ if name
            .strip_prefix('b')
            .is_some_and(|rest| CONDITIONS.split(' ').any(|one| one == rest)) =>
        {
            Class::Branch { conditional: true }
        }
        _ if name.starts_with("it") && name[1..].bytes().all(|c| c == b't' || c == b'e') => {
            Class::IfThen
        }
        _ if listed(SIMPLE) && !(operands.memory && name != "adr") => Class::Simple,
        _ => return None,
    })
}
