// The module's memory, and how arrays of the caller pass through it in blocks. No view of the memory is handed out.

import { reasons } from "./reasons.js";

export let wasm;
let f32, u32;

// Two buffers of so many numbers, one for what goes in and one for what comes out; then the generator and parameters, and
// behind them whatever is loaded. Places are counted in numbers.
const BLOCK = 8192;
const SMALL = 64;
// Beside the largest thing there is room for so many numbers of small ones.
const SPARE = 1 << 16;
export let IN, OUT;
// The generator whose state lies in the memory; that of the others lies with them.
let current;
let rng_at, loaded_from, loaded_to, epoch = 0;

// Takes an instance, of one module or of one that has more than the one before; two at a time would have two memories.
let had = 0;
export const start = ({ instance }, has) => {
  if (has <= had) return;
  had = has;
  if (current) current = void stored(current);
  wasm = instance.exports;
  IN = (wasm.__heap_base.value + 15 >> 4) << 2;
  OUT = IN + BLOCK;
  rng_at = OUT + BLOCK;
  loaded_from = rng_at + SMALL;
  room(0);
};

// Memory for so many numbers at the place where things are loaded, which are forgotten. They know their own bits.
const room = (numbers) => {
  epoch += 1;
  loaded_to = loaded_from;
  const missing = Math.ceil((loaded_from + numbers + SPARE - wasm.memory.buffer.byteLength / 4) / 16384);
  if (missing > 0) wasm.memory.grow(missing);
  f32 = new Float32Array(wasm.memory.buffer);
  u32 = new Uint32Array(wasm.memory.buffer);
};

// The place of so many numbers more.
const reserved = (numbers) => {
  if (loaded_to + numbers > u32.length) room(numbers);
  return loaded_to;
};

// What lies in the memory while there is room, and is copied there again otherwise.
export class Loaded {
  constructor(bits) {
    this.bits = bits;
  }
  at(place) {
    this.epoch = epoch;
    this.place = place;
    loaded_to = place + ((this.bits.length + 3) & ~3);
    return this;
  }
  address() {
    if (this.epoch !== epoch) {
      this.at(reserved(this.bits.length));
      u32.set(this.bits, this.place);
    }
    return this.place * 4;
  }
}

// Has an export write so many words behind numbers, and keeps them. The export gets both addresses.
export const written = (words, head, numbers, write) => {
  const at = reserved(words + numbers.length);
  u32.set(head, at);
  f32.set(numbers, at + words);
  refuse(write(at * 4, (at + words) * 4));
  return new Loaded(u32.slice(at, at + words)).at(at);
};

// A refusal of the module: a code, and the index of a weight times 32.
export const refuse = (refusal) => {
  if (refusal === 0) return;
  const code = refusal & 31;
  const reason = reasons[code - 1]?.replace("#", refusal >>> 5) ?? "the module was built without this";
  throw Object.assign(new RangeError(reason), { code });
};

export const take = (at, count) => f32.subarray(at, at + count);
export const words_at = (at, count) => u32.subarray(at, at + count);

// One number or several, as an array of so many.
export const numbers = (value, count) => {
  const flat = flatten(value);
  if (flat.length !== count) throw new TypeError(`${count} numbers are expected, not ${flat.length}`);
  return flat;
};
const flatten = (value) => {
  if (typeof value === "number") return [value];
  if (typeof value !== "object" || value === null) throw new TypeError(`a number is expected, not ${typeof value}`);
  return Array.from(value).flatMap(flatten);
};
export const point = (at, count) => {
  if (count === 1) return f32[at];
  const numbers = [];
  for (let i = 0; i < count; i += 1) numbers.push(f32[at + i]);
  return numbers;
};
// Writes what `numbers` gives.
export const put = (at, value, count) => {
  if (count === 1 && typeof value === "number") f32[at] = value;
  else f32.set(numbers(value, count), at);
};

// How many elements of so many numbers an array has.
export const elements = (array, type, each) => {
  if (!(array instanceof type)) throw new TypeError(`a ${type.name} is expected`);
  // A detached array has no elements either.
  if (array.length === 0) new Uint8Array(array.buffer);
  if (array.length % each !== 0) throw new RangeError(`the length ${array.length} is no multiple of ${each}`);
  return array.length / each;
};

// Calls a function for blocks of so many elements: of `input`, from an array or a source, to `output`.
export const in_blocks = (count, input, inputs, output, outputs, run) => {
  const most = Math.floor(BLOCK / Math.max(inputs, outputs));
  for (let from = 0; from < count; from += most) {
    const n = Math.min(most, count - from);
    if (input instanceof Float32Array) f32.set(input.subarray(from * inputs, (from + n) * inputs), IN);
    else input._words(IN * 4, inputs, n);
    run(n);
    const memory = output instanceof Float32Array ? f32 : u32;
    output.set(memory.subarray(OUT, OUT + n * outputs), from * outputs);
  }
};

export const generator = (state) => {
  if (current !== state) {
    current?.set(u32.subarray(rng_at, rng_at + 4));
    u32.set(state, rng_at);
    current = state;
  }
  return rng_at * 4;
};
// Brings the bits of a generator up to date.
export const stored = (state) => {
  if (current === state) state.set(u32.subarray(rng_at, rng_at + 4));
  return state;
};
