//! Puts a counter of executed operators into a module.
//!
//! A straight run of operators, which is always executed whole, adds their number to a global of 64 bits before its
//! last one. What only marks structure (`block`, `loop`, `else`, `end`), what leaves (`return`, `unreachable`), `nop`
//! and `drop` count nothing, as in wasmtime's fuel; all others count one, a call besides what it calls.

use crate::Failure;
use wasm_encoder::reencode::{Error, Reencode, utils};
use wasm_encoder::{
    CodeSection, ConstExpr, ExportKind, ExportSection, GlobalSection, GlobalType, Instruction,
    Module, ValType,
};
use wasmparser::{ExportSectionReader, FunctionBody, GlobalSectionReader, Operator, Parser};

/// The name under which the counter is exported.
pub const COUNTER: &str = "executed_operators";

/// The module with the counter. It must have a global and an export of its own, as every image has.
pub fn instrument(module: &[u8]) -> Result<Vec<u8>, Failure> {
    let mut writer = Counting::default();
    let mut written = Module::new();
    writer.parse_core_module(&mut written, Parser::new(0), module)?;
    if !writer.exported {
        return Err("a module without globals or exports cannot be counted".into());
    }
    Ok(written.finish())
}

#[derive(Default)]
struct Counting {
    /// The index of the counter, known when the globals have been read.
    counter: Option<u32>,
    exported: bool,
}

/// What an operator counts.
fn cost(operator: &Operator) -> i64 {
    use Operator::{Block, Drop, Else, End, Loop, Nop, Return, Unreachable};
    i64::from(!matches!(
        operator,
        Block { .. } | Loop { .. } | Else | End | Return | Unreachable | Nop | Drop
    ))
}

/// Whether a run of operators that are executed together ends here: what follows may be skipped, or reached from
/// elsewhere.
fn ends_run(operator: &Operator) -> bool {
    use Operator::{Br, BrIf, BrTable, Else, End, If, Loop, Return, Unreachable};
    matches!(
        operator,
        Br { .. }
            | BrIf { .. }
            | BrTable { .. }
            | Else
            | End
            | If { .. }
            | Loop { .. }
            | Return
            | Unreachable
    )
}

impl Reencode for Counting {
    type Error = std::convert::Infallible;

    fn parse_global_section(
        &mut self,
        globals: &mut GlobalSection,
        section: GlobalSectionReader<'_>,
    ) -> Result<(), Error<Self::Error>> {
        utils::parse_global_section(self, globals, section)?;
        // The images import nothing, so this is its index among all globals.
        self.counter = Some(globals.len());
        let kind = GlobalType {
            val_type: ValType::I64,
            mutable: true,
            shared: false,
        };
        globals.global(kind, &ConstExpr::i64_const(0));
        Ok(())
    }

    fn parse_export_section(
        &mut self,
        exports: &mut ExportSection,
        section: ExportSectionReader<'_>,
    ) -> Result<(), Error<Self::Error>> {
        utils::parse_export_section(self, exports, section)?;
        if let Some(counter) = self.counter {
            exports.export(COUNTER, ExportKind::Global, counter);
            self.exported = true;
        }
        Ok(())
    }

    fn parse_function_body(
        &mut self,
        code: &mut CodeSection,
        body: FunctionBody<'_>,
    ) -> Result<(), Error<Self::Error>> {
        let mut function = self.new_function_with_parsed_locals(&body)?;
        let mut operators = body.get_operators_reader()?;
        let mut run = 0;
        while !operators.eof() {
            let operator = operators.read()?;
            run += cost(&operator);
            if ends_run(&operator) && run > 0 {
                if let Some(counter) = self.counter {
                    function
                        .instruction(&Instruction::GlobalGet(counter))
                        .instruction(&Instruction::I64Const(run))
                        .instruction(&Instruction::I64Add)
                        .instruction(&Instruction::GlobalSet(counter));
                }
                run = 0;
            }
            function.instruction(&self.instruction(operator)?);
        }
        code.function(&function);
        Ok(())
    }
}
