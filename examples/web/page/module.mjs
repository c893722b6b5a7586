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

const text_of = (exports, name, ...of) => new TextDecoder().decode(
  new Uint8Array(exports.memory.buffer, exports[name](...of), exports[`${name}_length`](...of)));

// What the module tells of its subjects, list by list: { name, type, family, view, words, parameters, tiers, place }.
// `place` is the number of the list and the number within it. There is a comma behind the last of several.
export function* lists_of(exports) {
  for (let list = 0; exports.subjects_length(list) > 0; list += 1) {
    const { family, tiers, subjects } = JSON.parse(text_of(exports, "subjects", list).replace(/,(?=[\]}])/g, ""));
    yield subjects.map((subject, number) => ({ ...subject, family, tiers: tiers.split(" "), place: [list, number] }));
  }
}

export class Microwarp {
  constructor(module, exports) {
    this.exports = exports;
    this.imports = WebAssembly.Module.imports(module).length;
    this.subjects = Array.from(lists_of(exports)).flat();
    this.documented = JSON.parse(text_of(exports, "documented"));
    // The module never grows its memory, so these views stay valid.
    let address = exports.shared_memory();
    for (const [name, View, length] of LAYOUT) {
      this[name] = new View(exports.memory.buffer, address, length);
      address += this[name].byteLength;
    }
  }

  // Draws points. Returns views of the shared memory, valid until the next call, or the typed error.
  sample({ place: [list, number], tier, source, dimensions, count, seed, parameters }) {
    this.parameters.fill(0);
    this.parameters.set(parameters);
    const refused = this.exports.sample(
      list, number, TIERS.indexOf(tier), SOURCES.indexOf(source), dimensions, count, seed);
    if (refused > 0) {
      const [name, meaning] = new TextDecoder().decode(this.text.slice(0, refused)).split("\n");
      return { refused: { name, meaning } };
    }
    const { points, densities, words, report } = this;
    return { count, points, densities, words, report };
  }

  // Nanoseconds a point, generator included, and a word of the generator alone.
  time({ place: [list, number], tier, seed, parameters }) {
    this.parameters.fill(0);
    this.parameters.set(parameters);
    const which = TIERS.indexOf(tier);
    const point = nanoseconds((count) => this.exports.time(list, number, which, count, seed));
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
