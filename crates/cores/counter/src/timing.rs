//! Cycles by the timing tables of Arm's Technical Reference Manuals, at zero wait states.
//!
//! - Cortex-M0, with a multiplier of 1 cycle or of 32: DDI 0432C, table 3-1.
//! - Cortex-M0+, with a multiplier of 1 cycle: DDI 0484C, table 3-1.
//! - Cortex-M3: DDI 0337I, table 3-1 and the section on load and store timings behind it.
//! - Cortex-M4 with its unit: DDI 0439D, table 3-1, the same section, and table 7-1.
//!
//! Where a manual leaves something open, there are two ends.

use crate::decode::{Class, Instruction};

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Timing {
    M0 { multiply: u32 },
    M0Plus,
    M3,
    M4F,
}

/// The fewest and the most.
pub type Cycles = [u32; 2];

/// What the past leaves behind: the last instruction, and for how long the unit still divides at best.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Past {
    pub last: Option<Instruction>,
    dividing: u32,
}

const fn exactly(cycles: u32) -> Cycles {
    [cycles, cycles]
}

impl Timing {
    /// Those of a core, by the name that `run` has for it.
    pub fn of(core: &str) -> Option<&'static [(&'static str, Self)]> {
        match core {
            "m0" => Some(&[
                ("m0", Self::M0 { multiply: 1 }),
                ("m0_slow", Self::M0 { multiply: 32 }),
                ("m0plus", Self::M0Plus),
            ]),
            "m3" => Some(&[("m3", Self::M3)]),
            "m4f" => Some(&[("m4f", Self::M4F)]),
            _ => None,
        }
    }

    /// What refilling the pipeline adds to an instruction that branches, now that the next address is known.
    pub fn arrive(self, past: &Past, at: u32) -> Cycles {
        let Some(last) = past.last.filter(Instruction::branches) else {
            return exactly(0);
        };
        let may_fall_through = last.predicated || last.class == Class::Branch { conditional: true };
        if may_fall_through && last.end == at {
            return exactly(0);
        }
        match (self, last.class) {
            // Beyond the cycle of a branch that is not taken, and the words of a list.
            (Self::M0 { .. }, Class::Call | Class::LoadWords { .. }) => exactly(3),
            (Self::M0 { .. }, _) => exactly(2),
            (Self::M0Plus, Class::Call | Class::LoadWords { .. }) => exactly(2),
            (Self::M0Plus, _) => exactly(1),
            // P is 1 to 3. By the section on loads these take at least 5 and 6 cycles, by the table 2 + P.
            (Self::M3 | Self::M4F, Class::LoadCounter) => [1, 3],
            (Self::M3 | Self::M4F, Class::TableBranch) => [1, 4],
            (Self::M3 | Self::M4F, _) => [1, 3],
        }
    }

    /// An instruction, besides refilling the pipeline.
    pub fn step(self, past: &mut Past, one: &Instruction) -> Cycles {
        let mut cycles = match self {
            Self::M0 { .. } | Self::M0Plus => exactly(self.small(one.class)),
            Self::M3 | Self::M4F => self.large(past.last.as_ref(), one),
        };
        if one.predicated {
            cycles[0] = cycles[0].min(1);
        }
        if self == Self::M4F {
            self.wait_for_division(past, one, &mut cycles);
        }
        past.last = Some(*one);
        cycles
    }

    /// Whether the operands of an instruction decide on its time.
    pub fn by_operands(self, one: &Instruction) -> bool {
        let long = matches!(one.class, Class::LongMultiply | Class::LongMultiplyAdd);
        let cost = self.step(
            &mut Past::default(),
            &Instruction {
                predicated: false,
                ..*one
            },
        );
        one.class == Class::Divide || (long && self == Self::M3) || (one.predicated && cost[1] > 1)
    }

    fn small(self, class: Class) -> u32 {
        let barrier = if self == Self::M0Plus { 3 } else { 4 };
        match (class, self) {
            (Class::Multiply, Self::M0 { multiply }) => multiply,
            (Class::Load { .. } | Class::Store { .. }, _) => 2,
            (Class::LoadWords { words, .. } | Class::StoreWords { words }, _) => 1 + words,
            (Class::Special | Class::Barrier, _) => barrier,
            _ => 1,
        }
    }

    fn large(self, last: Option<&Instruction>, one: &Instruction) -> Cycles {
        let m3 = self == Self::M3;
        let written = |test: fn(Class) -> bool| {
            last.filter(|last| test(last.class))
                .map_or(0, |last| last.writes)
        };
        // Behind a load whose result is not its address, the next access is a cycle shorter.
        let loading =
            last.is_some_and(|last| matches!(last.class, Class::Load { update: false, .. }));
        let paired = loading && last.is_some_and(|last| last.writes & one.address == 0);
        // An address that has just been computed is waited for.
        let waits = u32::from(written(computes) & one.address != 0);
        let cycles = match one.class {
            Class::MultiplyAdd if m3 => exactly(2),
            Class::LongMultiply if m3 => [3, 5],
            Class::LongMultiplyAdd if m3 => [4, 7],
            Class::Divide => [2, 12],
            Class::Load { update: true, .. } => [1, 2],
            // A literal may contend with the fetch of instructions.
            Class::Load { literal, .. } => [
                2 - u32::from(paired),
                2 - u32::from(paired) + u32::from(literal),
            ],
            // The section on loads and stores gives 1 cycle, the table 2.
            Class::Store { immediate: true } => [1, 2 - u32::from(paired)],
            Class::Store { .. } => exactly(2 - u32::from(paired)),
            Class::LoadWords { words, .. }
            | Class::StoreWords { words }
            | Class::FloatWords { words } => exactly(1 + words),
            Class::LoadCounter | Class::TableBranch => exactly(2),
            // Folded into an instruction of 16 bits before it.
            Class::IfThen if last.is_some_and(Instruction::half) => [0, 1],
            Class::Special => [1, 2],
            Class::Barrier => [1, 4],
            Class::FloatMultiplyAdd => exactly(3),
            Class::FloatDivide => exactly(14),
            // The table has a register of the core in two rows: of 1 cycle as half of a double, and of 2.
            Class::FloatMove { two: false } => [1, 2],
            Class::FloatMove { two: true } => exactly(2),
            _ => exactly(1),
        };
        // A result of the unit is a cycle late for the instruction behind it.
        let late = u32::from(written(rounds) & one.reads != 0);
        cycles.map(|cycles| cycles + waits + late)
    }

    /// A division takes a cycle where only integers follow, which go on beside it; at worst they do not.
    fn wait_for_division(self, past: &mut Past, one: &Instruction, cycles: &mut Cycles) {
        if is_float(one.class) {
            cycles[0] += past.dividing;
            past.dividing = 0;
        } else {
            past.dividing = past.dividing.saturating_sub(cycles[0]);
        }
        if one.class == Class::FloatDivide {
            cycles[0] = cycles[0].saturating_sub(13);
            past.dividing = 13;
        }
    }
}

fn is_float(class: Class) -> bool {
    matches!(
        class,
        Class::Float
            | Class::FloatSimple
            | Class::FloatMultiplyAdd
            | Class::FloatDivide
            | Class::FloatMove { .. }
            | Class::FloatWords { .. }
    )
}

/// Data processing of the core.
fn computes(class: Class) -> bool {
    matches!(
        class,
        Class::Simple
            | Class::Multiply
            | Class::MultiplyAdd
            | Class::LongMultiply
            | Class::LongMultiplyAdd
            | Class::Divide
    )
}

/// What the unit rounds.
fn rounds(class: Class) -> bool {
    matches!(
        class,
        Class::Float | Class::FloatMultiplyAdd | Class::FloatDivide
    )
}

/// Cycles of a row of instructions; before the first one nothing is known.
pub fn row<'a>(
    timing: Timing,
    past: &mut Past,
    row: impl IntoIterator<Item = &'a Instruction>,
) -> Cycles {
    let mut sum = [0; 2];
    for one in row {
        for part in [timing.arrive(past, one.at), timing.step(past, one)] {
            sum = [sum[0] + part[0], sum[1] + part[1]];
        }
    }
    sum
}
