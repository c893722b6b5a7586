// Calls the whole public surface with hostile numbers, lengths, arrays and orders, by a fixed seed. After each call a canary
// around the buffers, a generator, a table, a warp and a chain are what they were, and an error is one that names what is
// expected. MICROWARP_FULL=1 takes a minute.
//   node fuzz.mjs

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import vm from "node:vm";

// The memory of the module, which the package hands to nobody.
let memory;
const { instantiate } = WebAssembly;
WebAssembly.instantiate = async (...given) => {
  const made = await instantiate(...given);
  // Node compiles modules of its own.
  if (made.instance?.exports.look_up) {
    ({ memory } = made.instance.exports);
    memory.base = made.instance.exports.__heap_base.value + 15 & ~15;
  }
  return made;
};
const microwarp = await import("microwarp");
const { Cdf, Chain, Normal, Pcg32, Sobol, Warp } = microwarp;

const calls = process.env.MICROWARP_FULL ? 1_500_000 : 150_000;
let seed = 2026;
const random = (n) => {
  seed = seed + 0x6d2b79f5 | 0;
  let t = Math.imul(seed ^ seed >>> 15, 1 | seed);
  t = t + Math.imul(t ^ t >>> 7, 61 | t) ^ t;
  return ((t ^ t >>> 14) >>> 0) % n;
};
const one_of = (all) => all[random(all.length)];

// --- what must stay as it is -----------------------------------------------------------------------------

// Made first, so they lie right behind the buffers.
const watched = {
  table: new Cdf([1, 2, 3, 4]),
  normal: new Normal(3, 2),
  rng: new Pcg32(42, 54),
  chain: new Chain(([x, y]) => Math.exp(-x * x - y * y), [0.25, 0.5], { normal: [1, 1] }),
};
const shown = () => {
  const { table, normal, rng, chain } = watched;
  return [table.select(0.35).index, table.pmf(3), normal.sample(0.75), normal.pdf(2), rng.state, chain.state, chain.density, chain.steps];
};
const due = shown();
// What lies before the generator, which is the code's own, and between the generator and the buffers. Behind the buffers lies
// what is watched above.
const CANARY = 0x5eedcafe;
const STACK = 32768;
const before = () => Buffer.from(memory.buffer, STACK, memory.base - STACK);
const gap = () => new Uint32Array(memory.buffer, memory.base + 16, 60);
const kept = Buffer.from(before());
gap().fill(CANARY);
const intact = () => before().equals(kept) && gap().every((word) => word === CANARY);

// --- hostile and sensible arguments ----------------------------------------------------------------------

const foreign = vm.runInNewContext("({ f: (n) => new Float32Array(n), u: (n) => new Uint32Array(n), a: (n) => Array(n).fill(0.5) })");
const detached = () => {
  const gone = new Float32Array(8);
  structuredClone(gone.buffer, { transfer: [gone.buffer] });
  return gone;
};
const shrunk = () => {
  const buffer = new ArrayBuffer(64, { maxByteLength: 128 });
  const array = new Float32Array(buffer, 32);
  buffer.resize(16);
  return array;
};
const shared = new Float32Array(64);
const hostile = [
  () => NaN, () => Infinity, () => -Infinity, () => -0, () => 0.5, () => -1, () => 1e300, () => 2 ** 23 + 1, () => 2 ** 31, () => 2 ** 32,
  () => 2 ** 53, () => 7n, () => -(2n ** 70n), () => "3", () => "", () => null, () => undefined, () => true, () => Symbol("x"),
  () => ({}), () => ({ length: 3, 0: 1, 1: 1, 2: 1 }), () => ({ valueOf: () => 3 }), () => [], () => [[]], () => [NaN, "1"], () => [1, , 3],
  () => Array(5462).fill(0.5), () => Array(16385).fill(0), () => Array(2 ** 32 - 1), () => Object.freeze([1, 2]), () => new Map(), () => () => 1,
  () => new Proxy([1, 2, 3], {}), () => new Proxy([1, 2], { get: (of, key) => (key === "length" ? 2 ** 31 : of[key]) }),
  () => new Float64Array(4), () => new BigInt64Array(2), () => new DataView(new ArrayBuffer(8)), () => new ArrayBuffer(8),
  detached, shrunk, () => new Float32Array(new SharedArrayBuffer(32)), () => Object.assign(new Float32Array(4), { subarray: null, set: null, slice: null }),
  () => new Float32Array(0), () => new Uint32Array(0), () => shared.subarray(random(32), 32 + random(32)), () => Math.random,
  () => ({ normal: NaN }), () => ({ normal: [1e30, 0] }), () => ({ box: 1, cube: 7 }), () => ({ normal: 1, box: 1 }), () => "0".repeat(16) + "-" + "1".repeat(16),
];
const live = [];
const of_class = (Class) => live.filter((object) => object instanceof Class);
const source = () => one_of(of_class(microwarp.Pcg32).concat(of_class(Sobol), [new Pcg32(random(9))]));
const target = () => one_of([
  (x) => (typeof x === "number" ? Math.exp(-x * x) : Math.exp(-x[0] * x[0])), () => 1, () => NaN, () => "1", () => { throw new RangeError("the target's own"); },
  (x) => { if (Array.isArray(x)) x.fill(9), x.length = 1; return 1; },
  (x) => { new Cdf([1, 2]).draw(source()), new Normal(0, 1).fill(new Float32Array(9000), source()); return 1; },
]);
const sensible = [
  () => random(10), () => random(100) / 100, () => [random(100) / 100, 0.5], () => [0.1, 0.7, 0.2], () => Array.from({ length: 1 + random(9) }, () => random(5)),
  source, source, source, target, () => new Float32Array(6 * random(2000)), () => new Uint32Array(random(9000)), () => foreign.f(12), () => foreign.u(12), () => foreign.a(2),
  () => Array.from({ length: 1 + random(3) }, () => one_of(of_class(Warp))), () => Array(1 + random(3)).fill(one_of(of_class(Warp))),
  () => ({ normal: 1 }), () => ({ box: [1, 1] }), () => ({ normal: [1, 1], cube: 0.5, logDensity: true }), () => [4, 2], () => [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
];
// What a member of a warp takes, so that hostile arrays meet what is going on.
const due_of = (warp, key) => {
  const [n, into] = [random(3000), (each) => (n) => (random(3) ? new Float32Array(each * n) : shared.subarray(0, each * (n % 10)))];
  const [points, uniforms] = [into(warp.dimensions), into(warp.uniforms)];
  const numbers = (count) => (count === 1 ? random(100) / 100 : Array.from({ length: count }, () => random(100) / 100));
  return {
    draw: [source()], sample: [numbers(warp.uniforms)], pdf: [numbers(warp.dimensions)], invert: [numbers(warp.dimensions)],
    fill: [points(n), source()], map: [uniforms(n), points(n)], pdfs: [points(n), into(1)(n)], inverts: [points(n), uniforms(n)],
  }[key];
};
// And what a function takes, or a class that is hard to meet.
const due_of_function = (of) => {
  const [warp, n] = [one_of(of_class(Warp)), random(3000)];
  const array = (each) => new Float32Array(each * n);
  return {
    Mixture: [Array(1 + n % 3).fill(warp), Array.from({ length: 1 + n % 3 }, () => random(3))],
    balanceHeuristic: [Array(2).fill(random(9)), [random(9), NaN], random(2)], powerHeuristic: [[1, random(9)], new Float32Array(2), random(2)],
    roulette: [random(100) / 100, source()], LightReservoir: [], Reflected: [new microwarp.GgxVisible([0, 0, 1], [0.5, 0.5])],
    drawWithPdf: [warp, source()], sampleWithPdf: [warp, due_of(warp, "sample")[0]],
    fillWithPdf: [warp, array(warp.dimensions), array(1), source()], mapWithPdf: [warp, array(warp.uniforms), array(warp.dimensions), array(1)],
  }[of] ?? given();
};
// Parameters that constructors take.
const { golden } = JSON.parse(readFileSync(new URL("expected.json", import.meta.url)));
const given = () => Array.from({ length: random(6) }, () => (random(5) < 3 ? one_of(sensible) : one_of(hostile))());

// --- calls -------------------------------------------------------------------------------------------------

const classes = Object.entries(microwarp).filter(([, value]) => typeof value === "function");
const names = new Map(classes.map(([name, Class]) => [Class, name]));
const members = (object) => {
  const names = new Set();
  for (let at = Object.getPrototypeOf(object); at && at !== Object.prototype; at = Object.getPrototypeOf(at)) {
    for (const name of Object.getOwnPropertyNames(at)) if (name !== "constructor") names.add(name);
  }
  return [...names];
};
const OURS = /is expected|are expected|is made by|takes \d+ parameters|is no multiple of|no state of|not as many|the module was built|the target|weight|parameter|bound|domain|density|direction|entries|strata|detached|the target's own|Cannot construct a [A-Z]\w+32Array/i;
const INTERNAL = /Cannot read|is not a function|reading '|is not iterable|Cannot destructure|has no method|private (member|method)/;

let [thrown, returned] = [0, 0];
const reached = new Set();
const attempt = (name, run) => {
  try {
    const value = run();
    returned += 1;
    reached.add(name);
    return value;
  } catch (error) {
    thrown += 1;
    assert.ok(error instanceof RangeError || error instanceof TypeError, `${name}: ${error}`);
    assert.ok(!INTERNAL.test(error.message), `${name}: ${error.message}`);
  }
};

for (let call = 0; call < calls; call += 1) {
  const kind = random(10);
  let name;
  if (live.length < 20 || kind < 1) {
    const [, of, maker, parameters] = one_of(golden);
    name = `${of}.${maker}`;
    live.push(attempt(name, () => (maker === "new" ? new microwarp[of](...parameters) : microwarp[of][maker](...parameters))));
  } else if (kind < 3) {
    const [of, Class] = one_of(classes);
    const makers = Object.getOwnPropertyNames(Class).filter((key) => typeof Class[key] === "function");
    const maker = random(3) > 0 && makers.length > 0 ? one_of(makers) : undefined;
    name = `${of}.${maker ?? "new"}`;
    const parameters = given();
    // What has no prototype is a function.
    const plain = Class.prototype === undefined;
    if ((plain || ["Mixture", "LightReservoir", "Reflected"].includes(of)) && random(2)) parameters.splice(0, 9, ...due_of_function(of));
    const made = attempt(name, () => (maker ? Class[maker](...parameters) : plain ? Class(...parameters) : new Class(...parameters)));
    if (typeof made === "object" && !plain) live.push(made);
  } else {
    const object = one_of(live);
    const key = one_of(members(object));
    name = `${names.get(object.constructor)}.${key}`;
    const parameters = (random(2) && object instanceof Warp && due_of(object, key)) || given();
    if (typeof object[key] === "function") attempt(name, () => object[key](...parameters));
    else if (kind < 5) attempt(name, () => { object[key]; });
    // What is read-only may say so in the engine's words.
    else if (Object.getOwnPropertyDescriptor(Object.getPrototypeOf(Object.getPrototypeOf(object)) ?? {}, key)?.set) attempt(name, () => { object[key] = parameters[0]; });
  }
  if (live.length > 150) live.splice(random(100), 50);
  assert.ok(intact(), `${name} has written beyond its buffer`);
  assert.deepEqual(shown(), due, `${name} has changed what it does not know`);
}
console.log(`${calls} calls: ${returned} returned, ${thrown} refused; ${reached.size} members reached`);
// Of each warp nearly every member.
const warps = classes.filter(([, Class]) => Class.prototype instanceof Warp);
const members_of = ["draw", "sample", "pdf", "invert", "fill", "map", "pdfs", "inverts"];
const missed = warps.flatMap(([of]) => members_of.map((key) => `${of}.${key}`)).filter((name) => !reached.has(name));
const functions = classes.filter(([of, Class]) => Class.prototype === undefined && !reached.has(`${of}.new`));
assert.deepEqual(functions.map(([of]) => of), [], "functions not reached");
assert.ok(missed.length < warps.length * members_of.length / 10, `not reached: ${missed}`);

// What overwrites the canary, the table or the generator is noticed.
const spoil = (at) => {
  const words = new Uint32Array(memory.buffer);
  const word = words[at];
  words[at] ^= 1;
  const noticed = !intact() || JSON.stringify(shown()) !== JSON.stringify(due);
  words[at] = word;
  return noticed;
};
const behind = memory.base / 4 + 64 + 2 * 8192;
assert.ok(spoil(memory.base / 4 - 1) && spoil(memory.base / 4 + 4), "a canary that is gone is not noticed");
// Loaded anew, in this order.
for (let i = 0; i < 400; i += 1) new Cdf(new Float32Array(2 ** 12).fill(1));
shown();
const found = Array.from({ length: 1 << 20 }, (_, i) => behind + i).some((at) => spoil(at));
assert.ok(found, "a table that is spoiled is not noticed");
