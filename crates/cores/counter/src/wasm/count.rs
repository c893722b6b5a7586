//! Runs the harness of an image, as `count.rs` beside it does on a Cortex-M.

use crate::Failure;
use crate::instrument::{COUNTER, instrument};
use wasm_encoder::{
    BlockType, CodeSection, ConstExpr, ExportKind, ExportSection, Function, FunctionSection,
    GlobalSection, GlobalType, TypeSection, ValType,
};
use wasmi::{Engine, Global, Instance, Linker, Memory, Module, Store, Val};

/// What free stack is filled with.
const PAINT: u8 = 0xA5;

/// A module that counts what it executes.
struct Counted {
    store: Store<()>,
    instance: Instance,
    counter: Global,
}

impl Counted {
    fn new(module: &[u8]) -> Result<Self, Failure> {
        let engine = Engine::default();
        let module = Module::new(&engine, instrument(module)?)?;
        let mut store = Store::new(&engine, ());
        let instance = Linker::new(&engine)
            .instantiate(&mut store, &module)?
            .start(&mut store)?;
        let counter = instance
            .get_global(&store, COUNTER)
            .ok_or("no counter in it")?;
        Ok(Self {
            store,
            instance,
            counter,
        })
    }

    fn executed(&self) -> Result<i64, Failure> {
        match self.counter.get(&self.store) {
            Val::I64(executed) => Ok(executed),
            _ => Err("a counter of another type".into()),
        }
    }

    /// Calls an export of one argument and no result; how many operators it executed.
    fn run(&mut self, name: &str, argument: u32) -> Result<i64, Failure> {
        let before = self.executed()?;
        self.instance
            .get_typed_func::<u32, ()>(&self.store, name)?
            .call(&mut self.store, argument)?;
        Ok(self.executed()? - before)
    }

    /// Calls an export of no argument and one result.
    fn ask(&mut self, name: &str) -> Result<u32, Failure> {
        let function = self.instance.get_typed_func::<(), u32>(&self.store, name)?;
        Ok(function.call(&mut self.store, ())?)
    }

    fn stack(&self) -> Result<(Memory, usize), Failure> {
        let memory = self.instance.get_memory(&self.store, "memory");
        let pointer = self.instance.get_global(&self.store, "__stack_pointer");
        match (memory, pointer.map(|pointer| pointer.get(&self.store))) {
            (Some(memory), Some(Val::I32(top))) => Ok((memory, usize::try_from(top)?)),
            _ => Err("no memory or no stack pointer is exported".into()),
        }
    }

    /// Bytes from the stack pointer down to the lowest that a chunk of calls changed. The linker puts the stack at
    /// the start of memory.
    fn deepest(&mut self, which: u32) -> Result<usize, Failure> {
        let (memory, top) = self.stack()?;
        let free = |data: &mut [u8]| data.get_mut(..top).map(|free| free.fill(PAINT));
        free(memory.data_mut(&mut self.store)).ok_or("a stack outside of memory")?;
        self.run("cores_run", which)?;
        let data = memory.data(&self.store);
        let untouched = data.iter().take(top).take_while(|&&byte| byte == PAINT);
        Ok(top - untouched.count())
    }
}

/// Operators of a loop of so many rounds, of five operators each.
fn calibrate(rounds: u32) -> Result<i64, Failure> {
    let mut types = TypeSection::new();
    types.ty().function([ValType::I32], []);
    let mut functions = FunctionSection::new();
    functions.function(0);
    let mut globals = GlobalSection::new();
    let kind = GlobalType {
        val_type: ValType::I32,
        mutable: false,
        shared: false,
    };
    globals.global(kind, &ConstExpr::i32_const(0));
    let mut exports = ExportSection::new();
    exports.export("count_down", ExportKind::Func, 0);
    let mut body = Function::new([]);
    body.instructions()
        .loop_(BlockType::Empty)
        .local_get(0)
        .i32_const(1)
        .i32_sub()
        .local_tee(0)
        .br_if(0)
        .end()
        .end();
    let mut code = CodeSection::new();
    code.function(&body);
    let mut module = wasm_encoder::Module::new();
    module
        .section(&types)
        .section(&functions)
        .section(&globals)
        .section(&exports)
        .section(&code);
    Counted::new(&module.finish())?.run("count_down", rounds)
}

/// The eight words that `count::measure` gives on a Cortex-M, in the same order and writing.
pub fn measure(image: &[u8]) -> Result<String, Failure> {
    let mut image = Counted::new(image)?;
    let (chunks, calls) = (image.ask("cores_chunks")?, image.ask("cores_calls")?);
    let prepare = image
        .instance
        .get_typed_func::<(), ()>(&image.store, "cores_prepare")?;
    prepare.call(&mut image.store, ())?;
    let (mut executed, mut deepest, mut hash) = ([0; 2], [0; 2], 0);
    for chunk in 0..chunks {
        for (index, which) in [(0, 0), (1, 1)] {
            image.run("cores_refill", chunk)?;
            deepest[index] = image.deepest(which)?.max(deepest[index]);
            image.run("cores_refill", chunk)?;
            executed[index] += image.run("cores_run", which)?;
        }
        hash = image
            .instance
            .get_typed_func::<u32, u32>(&image.store, "cores_hash")?
            .call(&mut image.store, hash)?;
    }
    let words = [
        i64::from(chunks * calls),
        calibrate(10_000)?,
        calibrate(5_000)?,
        executed[0],
        executed[1],
        i64::try_from(deepest[0])?,
        i64::try_from(deepest[1])?,
        i64::from(hash),
    ];
    words
        .iter()
        .map(|&word| Ok(format!("{:08x} ", u32::try_from(word)?)))
        .collect()
}
