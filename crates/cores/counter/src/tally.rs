//! Sums over the calls of a kernel.
//!
//! `count::run` of the harness calls the empty kernel and the other through a pointer, 64 times each. A call begins
//! where a row ends in `run` with that jump, and ends where `run` goes on.

use crate::decode::{Decoder, Instruction};
use crate::timing::{Cycles, Past, Timing, row};
use object::{Object, ObjectSymbol};
use std::collections::HashMap;

/// A row as QEMU translates it.
pub struct Row {
    at: u32,
    /// Those outside of calls need not be understood.
    code: Result<Vec<Instruction>, String>,
    length: u64,
    decides: bool,
    by_operands: Vec<bool>,
    /// By what came before: what it takes by each timing, and what it leaves behind.
    known: Vec<(usize, Vec<Cycles>, usize)>,
}

/// What one call took.
#[derive(Clone)]
struct Call {
    instructions: u64,
    cycles: Vec<[u64; 2]>,
    /// A hash of all rows in their order.
    path: u64,
    decides: bool,
    by_operands: Vec<bool>,
}

/// Over many calls.
#[derive(Default)]
struct Calls {
    count: u64,
    sum: u64,
    fewest: u64,
    most: u64,
    /// By each timing: the sums, the least, the longest.
    cycles: Vec<([u64; 2], u64, u64)>,
    path: u64,
    many_paths: bool,
    decides: bool,
    by_operands: Vec<bool>,
}

/// The harness first paints and then counts, in each chunk: the empty kernel, and the other. Then it sweeps.
const CHUNKS: u64 = 16;

pub struct Tally {
    timings: &'static [(&'static str, Timing)],
    decoder: Decoder,
    /// Where `run` lies.
    run: std::ops::Range<u32>,
    pasts: Vec<Vec<Past>>,
    numbers: HashMap<Vec<Past>, usize>,
    past: usize,
    call: Option<Call>,
    /// The last row in `run` ended in a jump by a register.
    leaves: bool,
    batches: u64,
    empty: Calls,
    counted: Calls,
    all: Calls,
}

impl Tally {
    pub fn new(core: &str, image: &str) -> Result<Self, String> {
        let bytes = std::fs::read(image).map_err(|e| format!("{image}: {e}"))?;
        let file = object::File::parse(&*bytes).map_err(|e| format!("{image}: {e}"))?;
        let mut symbols = file.symbols();
        let run = symbols.find(|symbol| {
            symbol
                .name()
                .is_ok_and(|name| name.contains("microwarp_cores8measured5count3run"))
        });
        let run = run.ok_or_else(|| format!("{image}: no count::run"))?;
        // The lowest bit says that it is Thumb code.
        let start = run.address() as u32 & !1;
        let mut tally = Self {
            timings: Timing::of(core).ok_or_else(|| format!("no table for {core}"))?,
            decoder: Decoder::default(),
            run: start..start + run.size() as u32,
            pasts: Vec::new(),
            numbers: HashMap::new(),
            past: 0,
            call: None,
            leaves: false,
            batches: 0,
            empty: Calls::default(),
            counted: Calls::default(),
            all: Calls::default(),
        };
        tally.number(vec![Past::default(); tally.timings.len()]);
        Ok(tally)
    }

    fn number(&mut self, past: Vec<Past>) -> usize {
        if let Some(&number) = self.numbers.get(&past) {
            return number;
        }
        self.pasts.push(past.clone());
        self.numbers.insert(past, self.pasts.len() - 1);
        self.pasts.len() - 1
    }

    /// What a row consists of.
    pub fn read(&mut self, code: &[(u32, &[u8])]) -> Row {
        let at = code.first().map_or(0, |one| one.0);
        let read: Result<Vec<_>, _> = code
            .iter()
            .map(|&(at, bytes)| self.decoder.instruction(at, bytes))
            .collect();
        let of = |test: &dyn Fn(&Instruction) -> bool| {
            read.as_ref().is_ok_and(|code| code.iter().any(test))
        };
        Row {
            at,
            length: code.len() as u64,
            decides: of(&Instruction::decides),
            by_operands: self
                .timings
                .iter()
                .map(|(_, timing)| of(&|one| timing.by_operands(one)))
                .collect(),
            code: read,
            known: Vec::new(),
        }
    }

    pub fn execute(&mut self, row: &mut Row) -> Result<(), String> {
        if self.run.contains(&row.at) {
            if let Some(call) = self.call.take() {
                self.end(call, row.at);
            }
            if row.at == self.run.start {
                self.batches += 1;
            }
            let last = row.code.as_ref().ok().and_then(|code| code.last());
            self.leaves = last.is_some_and(|last| {
                matches!(last.class, crate::decode::Class::Jump { back: false })
            });
            return Ok(());
        }
        if std::mem::take(&mut self.leaves) {
            self.past = 0;
            let none = vec![[0; 2]; self.timings.len()];
            let by_operands = vec![false; self.timings.len()];
            self.call = Some(Call {
                instructions: 0,
                cycles: none,
                path: 0,
                decides: false,
                by_operands,
            });
        }
        let Some(mut call) = self.call.take() else {
            return Ok(());
        };
        let place = match row.known.iter().position(|known| known.0 == self.past) {
            Some(place) => place,
            None => self.learn(row)?,
        };
        let (_, cycles, past) = &row.known[place];
        self.past = *past;
        call.instructions += row.length;
        for (sum, part) in call.cycles.iter_mut().zip(cycles) {
            *sum = [sum[0] + u64::from(part[0]), sum[1] + u64::from(part[1])];
        }
        call.path = (call.path ^ u64::from(row.at))
            .wrapping_mul(0x0000_0100_0000_01b3)
            .rotate_left(17);
        call.decides |= row.decides;
        for (any, one) in call.by_operands.iter_mut().zip(&row.by_operands) {
            *any |= one;
        }
        self.call = Some(call);
        Ok(())
    }

    fn learn(&mut self, known: &mut Row) -> Result<usize, String> {
        let code = known.code.as_ref().map_err(String::clone)?;
        let mut pasts = self.pasts[self.past].clone();
        let timed = self.timings.iter().zip(&mut pasts);
        let cycles = timed
            .map(|((_, timing), past)| row(*timing, past, code))
            .collect();
        let after = self.number(pasts);
        known.known.push((self.past, cycles, after));
        Ok(known.known.len() - 1)
    }

    fn end(&mut self, mut call: Call, at: u32) {
        for (i, (_, timing)) in self.timings.iter().enumerate() {
            let part = timing.arrive(&self.pasts[self.past][i], at);
            call.cycles[i] = [
                call.cycles[i][0] + u64::from(part[0]),
                call.cycles[i][1] + u64::from(part[1]),
            ];
        }
        let batch = self.batches - 1;
        match (batch < 4 * CHUNKS, batch % 4) {
            (true, 0) => {}
            (true, 1) => self.empty.add(&call),
            (counting, place) => {
                if counting && place == 3 {
                    self.counted.add(&call);
                }
                self.all.add(&call);
            }
        }
    }

    /// A line for each timing: instructions (mean of the calls that are counted, fewest and most of all), how many calls, what
    /// decides about them; cycles (mean, lowest and highest; least; longest). Less those of the empty kernel.
    pub fn report(&self) -> Result<String, String> {
        let (empty, counted, all) = (&self.empty, &self.counted, &self.all);
        if self.batches < 4 * CHUNKS
            || empty.count != counted.count
            || empty.many_paths
            || empty.count == 0
        {
            return Err(format!(
                "{} batches, {} and {} calls",
                self.batches, empty.count, counted.count
            ));
        }
        let less = |figure: u64, empty: u64| figure as i64 - empty as i64;
        let mean =
            |sum: u64, empty: u64| format!("{:.1}", less(sum, empty) as f64 / counted.count as f64);
        let mut text = String::new();
        for (i, (name, _)) in self.timings.iter().enumerate() {
            let path = match (all.many_paths, all.decides, all.by_operands[i]) {
                (true, _, _) => "varies",
                (false, true, _) => "same",
                (false, false, true) => "operands",
                (false, false, false) => "constant",
            };
            let (_, least, longest) = all.cycles[i];
            let (none, empty_least, empty_longest) = empty.cycles[i];
            let sums = counted.cycles[i].0;
            let columns = [
                (*name).to_string(),
                all.count.to_string(),
                path.to_string(),
                mean(counted.sum, empty.sum),
                less(all.fewest, empty.fewest).to_string(),
                less(all.most, empty.most).to_string(),
                mean(sums[0], none[0]),
                mean(sums[1], none[1]),
                less(least, empty_least).to_string(),
                less(longest, empty_longest).to_string(),
            ];
            text += &(columns.join(",") + "\n");
        }
        Ok(text)
    }
}

impl Calls {
    fn add(&mut self, call: &Call) {
        if self.count == 0 {
            let first = call
                .cycles
                .iter()
                .map(|cycles| ([0; 2], cycles[0], cycles[1]));
            self.cycles = first.collect();
            (self.fewest, self.most, self.path) = (call.instructions, call.instructions, call.path);
            self.by_operands = vec![false; call.cycles.len()];
        }
        self.count += 1;
        self.sum += call.instructions;
        self.fewest = self.fewest.min(call.instructions);
        self.most = self.most.max(call.instructions);
        for ((sum, least, longest), cycles) in self.cycles.iter_mut().zip(&call.cycles) {
            *sum = [sum[0] + cycles[0], sum[1] + cycles[1]];
            *least = (*least).min(cycles[0]);
            *longest = (*longest).max(cycles[1]);
        }
        self.many_paths |= self.path != call.path;
        self.decides |= call.decides;
        for (any, one) in self.by_operands.iter_mut().zip(&call.by_operands) {
            *any |= one;
        }
    }
}
