// The WASM module as functions. The memory that both sides share is laid out as `Shared` in src/shared.rs says.

export const MOST = 1 << 16;
const LAYOUT = [
  ["points", Float64Array, 3 * MOST],
  ["densities", Float64Array, MOST],
  ["report", Float64Array, 16],
  ["words", Uint32Array, 4 * MOST],
  ["golden", Uint32Array, 16],
  ["parameters", Float32Array, 16],
  ["text", Uint8Array, 256],
];
export const TIERS = ["libm", "poly", "fine", "coarse", "compact", "exact"];
export const SOURCES = ["random", "stratified", "low-discrepancy"];

export async function load(url) {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url}: ${response.status}. Build the module first: examples/web/build`);
  const binary = await response.arrayBuffer();
  const { module, instance } = await WebAssembly.instantiate(binary, {});
  return Object.assign(new Microwarp(module, instance.exports), { size: binary.byteLength });
}

class Microwarp {
  constructor(module, exports) {
    this.exports = exports;
    this.imports = WebAssembly.Module.imports(module).length;
    this.bytes = (address, length) => new Uint8Array(exports.memory.buffer, address, length);
    this.names = this.string("names").trim().split(" ");
    this.documented = JSON.parse(this.string("documented"));
    // The module never grows its memory, so that these views stay good.
    let address = exports.shared_memory();
    for (const [name, View, length] of LAYOUT) {
      this[name] = new View(exports.memory.buffer, address, length);
      address += this[name].byteLength;
    }
  }

  string(name) {
    return new TextDecoder().decode(this.bytes(this.exports[name](), this.exports[`${name}_length`]()));
  }

  // Draws points; gives views of the shared memory, good until the next call, or the typed error.
  sample({ subject, tier, source, dimensions, count, seed, parameters }) {
    this.parameters.fill(0);
    this.parameters.set(parameters);
    const refused = this.exports.sample(
      this.names.indexOf(subject), TIERS.indexOf(tier), SOURCES.indexOf(source), dimensions, count, seed);
    if (refused > 0) {
      const [name, meaning] = new TextDecoder().decode(this.text.slice(0, refused)).split("\n");
      return { refused: { name, meaning } };
    }
    const { points, densities, words, report } = this;
    return { count, points, densities, words, report };
  }

  // Nanoseconds a point, generator included, and a word of the generator alone.
  time({ subject, tier, seed, parameters }) {
    this.parameters.fill(0);
    this.parameters.set(parameters);
    const [number, which] = [this.names.indexOf(subject), TIERS.indexOf(tier)];
    const point = nanoseconds((count) => this.exports.time(number, which, count, seed));
    const word = nanoseconds((count) => this.exports.time_words(count, seed));
    return { point, word };
  }

  // The words of every golden case.
  golden_words() {
    return Array.from({ length: this.exports.golden_cases() }, (_, index) =>
      Array.from(this.golden.subarray(0, this.exports.golden_evaluate(index))));
  }
}

// The quickest of several runs, each of at least so many milliseconds: a browser's clock may tell tenths of one only.
const LONG_ENOUGH = 5;
function nanoseconds(run) {
  let count = 1 << 12;
  while (clocked(() => run(count)) < LONG_ENOUGH && count < 1 << 28) count *= 2;
  return (Math.min(...Array.from({ length: 5 }, () => clocked(() => run(count)))) * 1e6) / count;
}

function clocked(run) {
  const began = performance.now();
  run();
  return performance.now() - began;
}
