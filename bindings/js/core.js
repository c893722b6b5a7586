// The module's memory, and how what a caller gives passes through it. No view of the memory is handed out. What a caller
// gives is checked here, in one place for each kind of thing, and goes to the buffers by `write` alone.

import { reasons } from "./reasons.js";

export let wasm;
let f32, u32;

// As src/buffers.rs has them: the generator, and two buffers of so many numbers, one for what goes in and one for what
// comes out. Behind them parameters and whatever is loaded. Places are counted in numbers, and BUFFERS in bytes.
export const BLOCK = 8192;
const SMALL = 64;
// Beside the largest thing there is room for so many numbers of small ones.
const SPARE = 1 << 16;
export let BUFFERS, IN, OUT;
// The generator whose state lies in the memory; that of the others lies with them.
let current;
let rng_at, loaded_from, loaded_to, epoch = 0;

// Takes an instance, of one module or of one that has more than the one before; two at a time would have two memories.
let had = 0;
// Until there is one, whatever asks for it gets an answer.
export const wait = (answer) => {
  wasm ??= f32 = u32 = answer;
};
export const start = ({ instance }, has) => {
  if (has <= had) return;
  had = has;
  if (current) current = void stored(current);
  // A copy, whose functions an engine calls at once.
  wasm = { ...instance.exports };
  BUFFERS = wasm.__heap_base.value + 15 & ~15;
  rng_at = BUFFERS >> 2;
  IN = rng_at + SMALL;
  OUT = IN + BLOCK;
  loaded_from = OUT + BLOCK;
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

// Has an export write at most so many words behind numbers, and keeps them. The export gets both addresses, and returns a
// refusal or how many words it wrote, as a negative number.
export const written = (words, head, numbers, write) => {
  const at = reserved(words + numbers.length);
  u32.set(head, at);
  f32.set(numbers, at + words);
  const result = write(at * 4, (at + words) * 4);
  if (result > 0) refuse(result);
  return new Loaded(u32.slice(at, at + (-result || words))).at(at);
};

// A refusal of the module: a code, and the index of a weight or the number of a parameter, from 1, times 32.
export const refuse = (refusal) => {
  if (refusal === 0) return;
  const [code, index] = [refusal & 31, refusal >>> 5];
  const reason = reasons[code - 1]?.replace("#", index) ?? "the module was built without this";
  const parameter = (code < 10 && index) - 1;
  throw Object.assign(new RangeError(parameter < 0 ? reason : reason.replace("a parameter", `parameter ${index}`)), { code, parameter });
};

// --- what a caller gives -------------------------------------------------------------------------------

const shown = (value) => (typeof value === "number" ? `${value}` : value === null ? "null" : `a value of type ${typeof value}`);
export const wrong = (expected, value) => new TypeError(`${expected} is expected, not ${shown(value)}`);

// Every parameter between two ends, an integer where nothing else is said.
export const integer = (name, value, least, most, kind = "an integer", is = Number.isInteger) => {
  if (is(value) && value >= least && value <= most) return value;
  const expected = `${name}: ${kind} from ${least} to ${most}`;
  if (typeof value !== "number") throw wrong(expected, value);
  throw new RangeError(`${expected} is expected, not ${value}`);
};
export const u32_of = (name, value) => integer(name, value, 0, 0xffffffff);
// Of 64 bits: those of a negative number are its complement's.
export const bits64 = (name, value) => {
  const expected = `${name}: an integer of 64 bits`;
  if (typeof value !== "number" && typeof value !== "bigint") throw wrong(expected, value);
  if (!(Number.isInteger(value) || typeof value === "bigint") || value >= 2 ** 64 || value < -(2 ** 63)) {
    throw new RangeError(`${expected} is expected, not ${value}`);
  }
  return BigInt.asUintN(64, BigInt(value));
};

// What typed arrays of any realm answer, whatever else they are told to say.
const typed = Object.getPrototypeOf(Uint8Array.prototype);
const [tag, buffer, offset, length] = [Symbol.toStringTag, "buffer", "byteOffset", "length"].map((key) => {
  const { get } = Object.getOwnPropertyDescriptor(typed, key);
  return (value) => get.call(value);
});
// A view of our own of an array, of elements of so many numbers.
export const view = (array, Type, each) => {
  if (tag(array) !== Type.name) throw wrong(`a ${Type.name}`, array);
  // Throws for a detached array, and for one whose buffer has shrunk.
  typed.at.call(array, 0);
  const own = new Type(buffer(array), offset(array), length(array));
  if (own.length % each !== 0) throw new RangeError(`the length ${own.length} is no multiple of ${each}`);
  return own;
};

// One number or several, as an array of so many.
export const numbers = (value, count) => {
  const flat = [];
  const add = (value) => {
    if (typeof value === "number") return flat.push(value);
    if (!Array.isArray(value) && !tag(value)) throw wrong("a number or an array of numbers", value);
    const all = value.length;
    if (!(all <= count)) throw new TypeError(`${count} numbers are expected, not ${all}`);
    for (let i = 0; i < all && flat.length <= count; i += 1) add(value[i]);
  };
  add(value);
  if (flat.length !== count) throw new TypeError(`${count} numbers are expected, not ${flat.length}`);
  return flat;
};
// The longest array of any kind.
const MOST = 1 << 26;
// A copy of the weights of a table.
export const weights_of = (weights) => {
  if (!Array.isArray(weights) && !tag(weights)) throw wrong("an array of weights", weights);
  const own = new Float32Array(integer("the number of weights", weights.length, 0, MOST));
  for (let i = 0; i < own.length; i += 1) {
    const weight = weights[i];
    if (typeof weight !== "number") throw wrong(`weight ${i}: a number`, weight);
    own[i] = weight;
  }
  return own;
};

// --- the buffers ---------------------------------------------------------------------------------------

// Writes numbers or words to a buffer, which holds as many as BLOCK.
const write = (at, numbers) => {
  if (numbers.length > BLOCK) throw new RangeError(`at most ${BLOCK} numbers are expected, not ${numbers.length}`);
  if (numbers instanceof Uint32Array) u32.set(numbers, at);
  else if (numbers instanceof Float32Array) f32.set(numbers, at);
  // Few numbers, for which `set` takes longer.
  else for (let i = 0; i < numbers.length; i += 1) f32[at + i] = numbers[i];
};
export const put = (value, count) => {
  if (count === 1 && typeof value === "number") f32[IN] = value;
  else write(IN, numbers(value, count));
};
export const put_words = (words) => write(IN, words);
// A chain changes its state where it comes out.
export const put_state = (state) => write(OUT, state);
export const index_at = () => u32[OUT];
export const point = (at, count) => {
  if (count === 1) return f32[at];
  const numbers = [];
  for (let i = 0; i < count; i += 1) numbers.push(f32[at + i]);
  return numbers;
};
// The last of the words that went in.
export const word_at = (i) => u32[IN + i];

// Calls a function for blocks of so many elements: of an input, to `output`, from the buffer for what comes out or `in_place`.
// It gets the number of elements, and how many words the module draws before.
export const in_blocks = (feed, inputs, output, outputs, run, in_place) => {
  const count = output.length / outputs;
  const most = Math.floor(BLOCK / Math.max(inputs, outputs));
  const memory = output instanceof Float32Array ? () => f32 : () => u32;
  for (let from = 0; from < count; from += most) {
    const n = Math.min(most, count - from);
    run(n, feed(from, n));
    const at = in_place ? IN : OUT;
    output.set(memory().subarray(at, at + n * outputs), from * outputs);
  }
};
// Inputs: a source, and an array, of elements of so many numbers.
export const from_source = (source, each) => (_, n) => ready(source, each, n);
export const from_array = (array, each) => (from, n) => {
  write(IN, array.subarray(from * each, (from + n) * each));
  return 0;
};

// --- where words come from -----------------------------------------------------------------------------

const FAR = Number.MAX_SAFE_INTEGER;
// ⌊word·n/2³²⌋, of up to 2³² integers: each product of a half has 48 bits.
export const scaled = (n, word) => Math.floor(((word >>> 16) * n + Math.floor((word & 0xffff) * n / 65536)) / 65536);
// Calls a function for the sizes from one on down whose product is up to 2³². Returns the next.
const batch = (size, place) => {
  for (let outcomes = size; size > 1 && outcomes <= 2 ** 32; outcomes *= size) {
    place(size);
    size -= 1;
  }
  return size;
};

// How a source is readied, by nobody but `ready`.
export const READY = Symbol("ready");

export class Source {
  words(words, dimensions = 1) {
    return this.#filled(words, Uint32Array, dimensions, () => {});
  }
  uniform() {
    const word = word_of(this);
    return deep && word < 1 << 23 ? (2 * word + 1) / 2 ** 33 : (word >>> 8 | deep) / 2 ** 24;
  }
  below(n) {
    return scaled(integer("n", n, 1, 2 ** 32), word_of(this));
  }
  range(low, high) {
    integer("low", low, -FAR, FAR);
    integer("high", high, low, Math.min(low + 2 ** 32 - 1, FAR));
    return low + scaled(high - low + 1, word_of(this));
  }
  chance(p) {
    integer("p", p, 0, 1, "a number", Number.isFinite);
    return word_of(this) < Math.ceil(Math.fround(p) * 2 ** 32);
  }
  uniforms(uniforms, dimensions = 1) {
    return this.#filled(uniforms, Float32Array, dimensions, (n, random) => {
      wasm.uniforms(BUFFERS, n * dimensions, random > 0 ? 0 : 1);
    });
  }
  // As `uniform::shuffle` in Rust: of each two words as many places as have up to 2³² outcomes, digit by digit.
  shuffle(array) {
    if (!Array.isArray(array) && !tag(array)) throw wrong("an array", array);
    let left = integer("length", array.length, 0, MOST);
    while (left > 1) {
      let count = 0;
      for (let size = left; size > 1 && count < BLOCK; count += 2) size = batch(size, () => {});
      const words = this.words(new Uint32Array(count), count);
      for (let at = 0; at < count; at += 2) {
        const [high, low] = [words[at], words[at + 1]];
        const digits = [low & 0xffff, low >>> 16, high & 0xffff, high >>> 16];
        left = batch(left, (size) => {
          let place = 0;
          for (let k = 0; k < 4; k += 1) {
            // Below 2⁴⁸, so that it is exact.
            const product = digits[k] * size + place;
            digits[k] = product & 0xffff;
            place = (product - digits[k]) / 0x10000;
          }
          [array[place], array[size - 1]] = [array[size - 1], array[place]];
        });
      }
    }
    return array;
  }
  #filled(array, Type, dimensions, then) {
    const own = view(array, Type, integer("dimensions", dimensions, 1, BLOCK));
    in_blocks(from_source(this, dimensions), dimensions, own, dimensions, (n, random) => {
      drawn(random);
      then(n, random);
    }, true);
    return array;
  }
}

// Readies a source for so many elements of so many words: returns how many the module has to draw.
export const ready = (source, each, count) => {
  if (!(source instanceof Source)) throw wrong("a generator such as new Pcg32(), or points", source);
  return source[READY](each, count);
};
// Draws what the module has to draw.
export const drawn = (random) => {
  if (random > 0) wasm.random(BUFFERS, random);
};
export const generator = (state) => {
  if (next < end) take_back();
  if (current !== state) {
    current?.set(u32.subarray(rng_at, rng_at + 4));
    u32.set(state, rng_at);
    current = state;
  }
};
// Brings the bits of a generator up to date.
export const stored = (state) => {
  if (next < end) take_back();
  if (current === state) state.set(u32.subarray(rng_at, rng_at + 4));
  return state;
};

// --- points drawn ahead --------------------------------------------------------------------------------

// Whoever draws from one generator again and again gets points of one call, twice as many each time, which are those of single
// calls. Where the generator is used for anything else, it goes back to where it is after what was handed out. Until then its
// state is the one in the memory.
const kept = new Float32Array(1024);
const kept_words = new Uint32Array(kept.buffer);
const before = new Uint32Array(4);
let who, from, many, each, words, next = 0, end = 0;

const take_back = () => {
  const used = next / each * words;
  who = undefined;
  next = end = 0;
  u32.set(before, rng_at);
  wasm.random(BUFFERS, used);
};

// The place of the next point of an owner, or -1.
export const place_ahead = (owner, source) => {
  if (who !== owner || from !== source || next >= end) return -1;
  next += each;
  return next - each;
};
// Readies a source for the next points of an owner: returns how many there shall be, and -1 for one that is not drawn.
export const plan = (owner, source, words_each, numbers) => {
  // Points of a set are drawn by no generator, and would leave what was drawn ahead to whoever asks next.
  if (next < end) take_back();
  const again = who === owner && from === source;
  const drawn = ready(source, words_each, 1) > 0;
  many = again && drawn ? Math.min(2 * many, kept.length / Math.max(numbers, words_each) | 0) : 1;
  [who, from, each, words] = [owner, source, numbers, words_each];
  if (many > 1) for (let i = 0; i < 4; i += 1) before[i] = u32[rng_at + i];
  return drawn ? many : -1;
};
// Keeps what has come out but the first point, which is to be handed out.
export const keep = (at = OUT) => {
  if (many === 1) return;
  [next, end] = [each, many * each];
  kept_words.set(u32.subarray(at, at + end));
};
export const kept_word = (at) => kept_words[at];
// The next word of a source, and with it 1 in `deep` where it is one of a set, whose uniforms keep their middles.
let deep;
const word_of = (source) => {
  const at = place_ahead(Source, source);
  if (at >= 0) return kept_words[at];
  const random = plan(Source, source, 1, 1);
  deep = random > 0 ? 0 : 1;
  drawn(random);
  keep(IN);
  return u32[IN];
};
export const kept_point = (at) => {
  if (each === 1) return kept[at];
  const numbers = [];
  for (let i = 0; i < each; i += 1) numbers.push(kept[at + i]);
  return numbers;
};
