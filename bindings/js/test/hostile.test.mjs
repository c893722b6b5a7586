// What a caller may get wrong, or does in an order of its own: lengths, integers, arrays of other realms, targets that write.

import assert from "node:assert/strict";
import test from "node:test";
import vm from "node:vm";
import { readFileSync } from "node:fs";
import * as microwarp from "microwarp";

const { Alias, Binomial, BinomialRejection, ByPosition, Cdf, Chain, DiscreteGaussian, DiscreteLaplace, Disk, Exponential, Frame, Integers, LatinHypercube, LatLongMap, Normal, NormalPair, Pcg32, Permutation, PiecewiseConstant2d, Screen, Sobol, Strata, SumTree, WeightedReservoir } = microwarp;
const round = (x) => Math.exp(-x.reduce((sum, x) => sum + x * x, 0));

test("a chain has as many coordinates as its buffers hold, or is refused", () => {
  const [rng, table] = [new Pcg32(7, 7), new Cdf([1, 2, 3])];
  const due = [new Pcg32(7, 7).state, table.select(0.5).index];
  for (const n of [5461, 8190]) {
    const chain = new Chain(() => 1, Array(n).fill(0.5), { box: Array(n).fill(0.1) });
    const { proposed } = chain.step(new Pcg32(1));
    assert.equal(proposed.length, n);
    assert.ok(proposed.every((x) => x !== 0.5 && Math.abs(x - 0.5) <= 0.1));
  }
  for (const n of [8191, 16384, 100000]) {
    assert.throws(() => new Chain(() => 1, Array(n).fill(0.5), { box: Array(n).fill(0.1) }), /coordinates: an integer from 1 to 8190 is expected/);
  }
  assert.throws(() => new Chain(() => 1, [], { box: [] }), RangeError);
  assert.deepEqual([rng.state, table.select(0.5).index], due);
});

test("dimensions beyond a buffer, none, and parts of one are refused", () => {
  for (const d of [8193, 1e9, 0, -1, 0.5, NaN]) {
    assert.throws(() => new Pcg32(1).words(new Uint32Array(16), d), { name: "RangeError", message: /^dimensions: an integer from 1 to 8192 is expected, not / });
    assert.throws(() => new Sobol(1).uniforms(new Float32Array(16), d), RangeError);
  }
  assert.equal(new Sobol(1).words(new Uint32Array(2 * 8192), 8192).length, 16384);
});

// Every integer parameter: how it is given, by its name, and one number that it takes.
const integers = {
  "seed of Sobol": [(n) => new Sobol(n), 3], "seed of ByPosition": [(n) => new ByPosition(n, 1), 3], pixel: [(n) => new ByPosition(1, n), 3],
  "index of at": [(n) => new Sobol(1).at(n), 3], "dimension of at": [(n) => new Sobol(1).at(1, n), 3],
  "index of a set": [(n) => { new Sobol(1).index = n; }, 3], "dimension of a set": [(n) => { new Sobol(1).dimension = n; }, 3],
  columns: [(n) => new Strata(n), 3], rows: [(n) => new Strata(3, n), 3], "index of a stratum": [(n) => new Strata(3).place(n, 0.5), 3],
  from: [(n) => new Strata(3).uniforms(new Float32Array(3), new Pcg32(1), n), 3], "index of pmf": [(n) => new Cdf([1, 2]).pmf(n), 1],
  "index of pmf of Alias": [(n) => new Alias([1, 2]).pmf(n), 1], "columns of a table": [(n) => new PiecewiseConstant2d([1, 2, 3, 4], [n, 2], [0, 1], [0, 1]), 2],
  "rows of a sky": [(n) => new LatLongMap([1, 2, 3, 4], [2, n]), 2], "seed of at": [(n) => Pcg32.at(n, 1), 3], "index of Pcg32.at": [(n) => Pcg32.at(1, n), 3],
  n: [(n) => new Pcg32(1).below(n), 3], high: [(n) => new Sobol(1).range(0, n), 3],
  "high of Integers": [(n) => new Integers(0, n), 3],
  count: [(n) => new LatinHypercube(n), 3], "seed of LatinHypercube": [(n) => new LatinHypercube(3, n), 3],
  trials: [(n) => new Binomial(n, 0.5), 3], part: [(n) => Binomial.fromRatio(3, n, 4), 3], whole: [(n) => Binomial.fromRatio(3, 1, n), 3],
  word: [(n) => new Binomial(3, 0.5).count(n), 3], "count of pmf": [(n) => new BinomialRejection(100, 0.5).pmf(n), 3],
  "part of Laplace": [(n) => DiscreteLaplace.fromRatio(n, 3), 3], "whole of Laplace": [(n) => DiscreteLaplace.fromRatio(3, n), 3],
  "word of an integer": [(n) => new DiscreteGaussian(0, 3).integer(n), 3],
  limit: [(n) => new microwarp.LightReservoir().cap(n), 3], candidates: [(n) => new microwarp.LightReservoir().normalise(n), 3],
  "count of a technique": [(n) => microwarp.balanceHeuristic([1, n], [1, 1], 0), 3], own: [(n) => microwarp.powerHeuristic([1, 1], [1, 1], n), 1],
  "part of a mixture": [(n) => new microwarp.Mixture([new Disk()], [1]).pmf(n), 3],
  places: [(n) => new WeightedReservoir(n), 3], weight: [(n) => new WeightedReservoir(3).offer("a", n, new Pcg32(1)), 3],
  "weight of SumTree": [(n) => new SumTree([1, n]), 3], "index of SumTree": [(n) => new SumTree([1, 2, 3, 4]).get(n), 3],
  length: [(n) => new Permutation(n, 1), 3], "seed of Permutation": [(n) => new Permutation(3, n), 3],
  place: [(n) => new Permutation(4, 1).get(n), 3], number: [(n) => new Permutation(4, 1).indexOf(n), 3],
  width: [(n) => new Screen(n, 3, 0), 3], height: [(n) => new Screen(3, n, 0), 3], log2Samples: [(n) => new Screen(3, 3, n), 3],
  "seed of Screen": [(n) => new Screen(3, 3, 0, n), 3], x: [(n) => new Screen(4, 1, 0).pixel(n, 0), 3], y: [(n) => new Screen(1, 4, 0).pixel(0, n), 3],
  dimensions: [(n) => new Pcg32(1).words(new Uint32Array(4), n), 2],
  steps: [(n) => new Chain(() => 1, 0, { box: 1 }).resume({ state: 0, density: 1, steps: n, accepted: 0, refused: 0 }), 3],
};

test("a permutation has each number once, and a shuffle each item", () => {
  for (const n of [1, 2, 16, 17, 100]) {
    const order = new Permutation(n, 3);
    assert.deepEqual([...order].sort((a, b) => a - b), Array.from({ length: n }, (_, i) => i));
    for (let i = 0; i < n; i += 1) assert.equal(order.indexOf(order.get(i)), i);
  }
  for (const [length, seed] of [[0, 1], [2 ** 32, 1]]) assert.throws(() => new Permutation(length, seed), RangeError);
  assert.throws(() => new Permutation(4, 1).get(4), RangeError);
  // Also where the words of one buffer are not enough.
  const many = new Pcg32(1).shuffle(Int32Array.from({ length: 50000 }, (_, i) => i));
  assert.deepEqual(many.sort(), Int32Array.from({ length: 50000 }, (_, i) => i));
  assert.deepEqual([new Pcg32(1).shuffle([]), new Pcg32(1).shuffle(["a"])], [[], ["a"]]);
  for (const none of [undefined, null, 3, "abc", { length: 2 }]) assert.throws(() => new Pcg32(1).shuffle(none), /an array is expected/);
  assert.throws(() => new Pcg32(1).shuffle(Array(2 ** 32 - 1)), /length: an integer from 0 to 67108864 is expected/);
});

test("every integer parameter is checked, and refused by name", () => {
  for (const [name, [give, taken]] of Object.entries(integers)) {
    give(taken);
    for (const n of [taken + 0.5, NaN, Infinity, -1, 2 ** 53]) assert.throws(() => give(n), { name: "RangeError", message: /^[a-zA-Z0-9]+: an integer from \d+ to \d+ is expected, not / }, `${name}: ${n}`);
    for (const n of ["3", 7n, null, {}, [3], true]) assert.throws(() => give(n), { name: "TypeError" }, `${name}: ${typeof n}`);
  }
  for (const give of [(n) => new Pcg32(n), (n) => new Pcg32(1, n)]) {
    for (const n of [0.5, NaN, Infinity, 2 ** 64, 2n ** 64n, -(2n ** 63n) - 1n]) assert.throws(() => give(n), { name: "RangeError", message: /an integer of 64 bits is expected/ });
    for (const n of ["seed", null, {}, Symbol("x")]) assert.throws(() => give(n), { name: "TypeError", message: /an integer of 64 bits is expected/ });
  }
  assert.throws(() => new Strata(2 ** 23 + 1), /from 1 to 8388608/);
  assert.equal(new Cdf([1, 2]).pmf(2), 0);
  assert.equal(new Cdf([1, 2]).pmf(2 ** 32 - 1), 0);
});

test("arrays of another realm, shared and resizable ones serve like any other", () => {
  const other = vm.runInNewContext("({ f: new Float32Array(6), u: new Uint32Array(6), w: new Float32Array([1, 2, 3]), a: [0.25, 0.5] })");
  const disk = new Disk();
  const due = Array.from(disk.fill(new Float32Array(6), new Pcg32(3)));
  const shared = new Float32Array(new SharedArrayBuffer(24));
  const resizable = new Float32Array(new ArrayBuffer(24, { maxByteLength: 48 }));
  for (const array of [other.f, shared, resizable, Object.assign(new Float32Array(6), { subarray: null, set: null })]) {
    assert.equal(disk.fill(array, new Pcg32(3)), array);
    assert.deepEqual(Array.from(array), due);
  }
  assert.deepEqual(new Cdf(other.w).fill(other.u, new Pcg32(1)).length, 6);
  assert.deepEqual(disk.sample(other.a), disk.sample([0.25, 0.5]));
  for (const wrong of [new Uint32Array(6), new DataView(new ArrayBuffer(24)), { length: 6 }, Object.create(Float32Array.prototype)]) {
    assert.throws(() => disk.fill(wrong, new Pcg32(3)), { name: "TypeError", message: /^a Float32Array is expected/ });
  }
});

test("arrays that overlap give what arrays apart give", () => {
  const pair = new NormalPair([0, 0], 1);
  for (const [count, shift] of [[10, 2], [9001, 2], [9001, 0], [9001, -2], [20000, 8190]]) {
    const buffer = new Float32Array(2 * count + 2 * 8192);
    const from = 8192;
    const uniforms = buffer.subarray(from, from + 2 * count);
    new Sobol(3).uniforms(uniforms, 2);
    const due = pair.map(uniforms.slice(), new Float32Array(2 * count));
    assert.deepEqual(pair.map(uniforms, buffer.subarray(from + shift, from + shift + 2 * count)), due, `${count} ${shift}`);
  }
});

test("a chain of one coordinate in an array is one, and a target that writes changes nothing", () => {
  const gauss = (x) => Math.exp(-x * x);
  const [plain, array] = [new Chain(gauss, 0.5, { normal: 1 }), new Chain(([x]) => gauss(x), [0.5], { normal: [1] })];
  const [one, other] = [new Pcg32(4), new Pcg32(4)];
  for (let i = 0; i < 100; i += 1) assert.deepEqual([plain.step(one).proposed], array.step(other).proposed);
  assert.deepEqual([plain.state], array.state);

  const writing = (x) => [round(x), x.fill(99), x.splice(0, 1)][0];
  const [kind, wild] = [round, writing].map((target) => new Chain(target, [0.25, 0.5], { normal: [1, 1] }));
  const [a, b] = [new Pcg32(5), new Pcg32(5)];
  for (let i = 0; i < 100; i += 1) {
    const step = wild.step(b);
    assert.deepEqual(step, kind.step(a));
    step.from.fill(7);
    step.proposed.fill(7);
    wild.state.fill(7);
  }
  assert.deepEqual(wild.save(), kind.save());
});

test("a target may use the package, and its own generator, while the chain steps", () => {
  const rng = new Pcg32(6);
  const busy = (x) => {
    new Normal(0, 1).fill(new Float32Array(9000), new Pcg32(1));
    new Chain(() => 1, [0, 0, 0], { box: [1, 1, 1] }).step(new Sobol(1));
    new Alias([1, 2, 3]).draw(rng);
    return round(x);
  };
  const [busy_chain, chain] = [busy, round].map((target) => new Chain(target, [0.25, 0.5], { normal: [1, 1] }));
  const [a, b] = [new Pcg32(5), new Pcg32(5)];
  for (let i = 0; i < 50; i += 1) assert.deepEqual(busy_chain.step(a), chain.step(b));
});

test("a target that fails or returns no number leaves the chain as it was", () => {
  let failing = false;
  const target = (x) => {
    if (failing) throw new Error("mine");
    return Math.exp(-x * x);
  };
  const [chain, rng] = [new Chain(target, 0.5, { normal: 1 }), new Pcg32(1)];
  const before = chain.save();
  failing = true;
  assert.throws(() => chain.step(rng), /^Error: mine$/);
  assert.deepEqual(chain.save(), before);
  failing = false;
  chain.step(rng);
  for (const value of ["1", undefined, 1n]) assert.throws(() => new Chain(() => value, 0, { normal: 1 }), /a number from the target is expected/);
});

test("logarithms of densities do not underflow, and give the chain of the densities", () => {
  const [log, plain] = [new Chain((x) => -0.5 * x * x, 1, { normal: 2, logDensity: true }), new Chain((x) => Math.exp(-0.5 * x * x), 1, { normal: 2 })];
  const [a, b] = [new Pcg32(2), new Pcg32(2)];
  let apart = 0;
  for (let i = 0; i < 1000; i += 1) apart += log.step(a).proposed === plain.step(b).proposed ? 0 : 1;
  assert.ok(apart < 5, `${apart}`);
  // A thousand observations, whose likelihood is about e^-30000.
  const data = Array.from({ length: 1000 }, (_, i) => 5 + Math.sin(i));
  const likelihood = (mean) => data.reduce((sum, x) => sum - 0.5 * (x - mean) ** 2, -30000);
  const chain = new Chain(likelihood, 0, { normal: 0.1, logDensity: true });
  const rng = new Pcg32(3);
  for (let i = 0; i < 2000; i += 1) chain.step(rng);
  assert.ok(Math.abs(chain.state - 5) < 0.3, `${chain.state}`);
  assert.throws(() => new Chain((mean) => Math.exp(likelihood(mean)), 0, { normal: 0.1 }), /positive and finite at the start/);
  assert.throws(() => new Chain(() => -Infinity, 0, { normal: 1, logDensity: true }), /finite at the start/);
  assert.throws(() => new Chain(() => 0, 0, { normal: 1, logDensity: 1 }), /logDensity: a boolean is expected/);
  assert.equal(new Chain((x) => (x === 0 ? 0 : NaN), 0, { normal: 1, logDensity: true }).step(rng).outcome, "refused");
});

test("errors name what is expected", () => {
  const [normal, table] = [new Normal(0, 1), new Cdf([1, 2])];
  const generator = /^TypeError: a generator such as new Pcg32\(\), or points is expected, not /;
  for (const wrong of [undefined, null, Math.random, {}, "rng", new Float32Array(4)]) {
    for (const use of [() => normal.draw(wrong), () => normal.fill(new Float32Array(2), wrong), () => table.draw(wrong), () => table.fill(new Uint32Array(2), wrong)]) {
      assert.throws(use, (error) => generator.test(`${error}`), `${typeof wrong}`);
    }
  }
  for (const wrong of [1, new Map(), "12", undefined]) assert.throws(() => new Cdf(wrong), /^TypeError: an array of weights is expected, not /);
  assert.throws(() => new Cdf([1, "2"]), /weight 1: a number is expected/);
  assert.throws(() => new Chain(5, 0, { normal: 1 }), /a target: a function is expected/);
  for (const step of [undefined, null, {}, { normal: 1, box: 1 }]) assert.throws(() => new Chain(() => 1, 0, step), /a step such as \{ normal: 1 \}/);
  assert.throws(() => new Chain(() => 1, [0, 0], { normal: 1 }), /2 numbers are expected, not 1/);
  assert.throws(() => new microwarp.Warp(), /a class of a warp is expected/);
});

test("empty ranges, and probabilities that are none, are refused and draw nothing", () => {
  for (const source of [new Pcg32(3), new Sobol(3)]) {
    const before = source.state ?? source.index;
    for (const n of [0, -1, 2 ** 32 + 1, 0.5, NaN]) assert.throws(() => source.below(n), { name: "RangeError", message: /^n: an integer from 1 to 4294967296 is expected, not / });
    for (const [low, high] of [[1, 0], [0, 2 ** 32], [NaN, 1], [0.5, 1], [-(2 ** 53), 0], [2 ** 53 - 1, 2 ** 53]]) assert.throws(() => source.range(low, high), RangeError);
    for (const p of [-1e-300, 1 + 2 ** -52, NaN, Infinity]) assert.throws(() => source.chance(p), { name: "RangeError", message: /^p: a number from 0 to 1 is expected, not / });
    for (const wrong of ["3", 7n, null, undefined, [3], true]) {
      for (const use of ["below", "chance"]) assert.throws(() => source[use](wrong), TypeError);
      assert.throws(() => source.range(0, wrong), TypeError);
    }
    assert.equal(source.state ?? source.index, before);
  }
});

test("integers and coins reach their ends, and no further", () => {
  const rng = new Pcg32(9);
  const drawn = (draw, times) => [...new Set(Array.from({ length: times }, draw))].sort();
  assert.deepEqual(drawn(() => rng.range(1, 6), 1000), [1, 2, 3, 4, 5, 6]);
  const far = 2 ** 53 - 1;
  assert.deepEqual([rng.below(1), rng.range(-7, -7), rng.range(far, far), rng.range(-far, -far)], [0, -7, far, -far]);
  assert.deepEqual([...drawn(() => rng.chance(0), 1000), ...drawn(() => rng.chance(1), 1000)], [false, true]);
  const [one, same] = [new Pcg32(5), new Pcg32(5)];
  assert.deepEqual(Array.from({ length: 50 }, () => one.uniform()), Array.from(same.uniforms(new Float32Array(50))));
  const [set, other] = [new Sobol(5), new Sobol(5)];
  assert.deepEqual(Array.from({ length: 50 }, () => set.uniform()), Array.from(other.uniforms(new Float32Array(50))));
});

test("points drawn one by one are those drawn at once, whatever comes between", () => {
  const makers = [() => new Normal(0, 1), () => Exponential.fromRate(2), () => new Disk(), () => new Cdf([1, 2, 3, 4]), () => new Alias([1, 2, 3])];
  const words = [1, 1, 2, 1, 1];
  const [one, same] = [new Pcg32(11), new Pcg32(11)];
  let word = 0;
  for (let run = 0; run < 400; run += 1) {
    // Long and short runs of a few things, with words, states and other generators between.
    const which = run * 7 % makers.length;
    const [thing, fresh] = [makers[which](), makers[which]()];
    const times = [1, 2, 3, 60, 700][run % 5];
    const drawn = Array.from({ length: times }, () => thing.draw(one)).flat();
    const filled = fresh.fill(which > 2 ? new Uint32Array(times) : new Float32Array(times * (which === 2 ? 2 : 1)), same);
    assert.deepEqual(drawn, Array.from(filled), `${run}`);
    word += times * words[which];
    if (run % 7 === 2) for (let i = 0; i < times; i += 1) assert.equal(one.below(2 ** 32), same.words(new Uint32Array(1))[0]);
    if (run % 7 === 2) word += times;
    if (run % 3 === 0) assert.equal(one.state, same.state);
    if (run % 4 === 0) thing.draw(new Pcg32(1));
    if (run % 5 === 1) assert.deepEqual(one.words(new Uint32Array(3)), same.words(new Uint32Array(3)));
  }
  assert.equal(one.state, same.state);
  // A generator of another number of words is not where this one is.
  const far = new Pcg32(11);
  far.words(new Uint32Array(word));
  assert.notEqual(far.state, one.state);
});

test("an engine that compiles no bytes takes a compiled module", () => {
  const [bundle, module] = [readFileSync("all/module.js", "utf8"), new WebAssembly.Module(readFileSync("node_modules/microwarp/microwarp.wasm"))];
  const context = vm.createContext({ module, crypto, console }, { codeGeneration: { strings: false, wasm: false } });
  assert.throws(() => vm.runInContext("new WebAssembly.Module(Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0))", context), /CompileError/);
  vm.runInContext(bundle, context);
  assert.throws(() => vm.runInContext("new M.Disk()", context), /a module is expected first: call init\(module\)/);
  const other = new WebAssembly.Module(Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0));
  assert.throws(() => vm.runInContext("(module) => M.init(module)", context)(other), /the module of this package is expected/);
  const drawn = vm.runInContext("M.init(module); Array.from(new M.Normal(0, 1).fill(new Float32Array(5), new M.Pcg32(42, 54)))", context);
  assert.deepEqual(Array.from(drawn), Array.from(new Normal(0, 1).fill(new Float32Array(5), new Pcg32(42, 54))));
});

test("points of a set are its own, whoever has drawn from a generator before", () => {
  // Interleaved by a fixed seed: each draw is the next of what its source gives when it is asked alone.
  let seed = 1;
  const random = (n) => (seed = Math.imul(seed, 1664525) + 1013904223 >>> 0, Math.floor(seed / 2 ** 32 * n));
  const owners = [new Normal(0, 1), new Disk(), Exponential.fromRate(2), new Cdf([1, 2, 3, 4]), new Alias([1, 2, 3, 4])];
  const again = [new Normal(0, 1), new Disk(), Exponential.fromRate(2), new Cdf([1, 2, 3, 4]), new Alias([1, 2, 3, 4])];
  const sources = [new Pcg32(3, 3), new Pcg32(4, 4), new Sobol(5), new ByPosition(6, 7)];
  // A table's or warp's single draw as a filled array has it.
  const alone = [new Pcg32(3, 3), new Pcg32(4, 4), new Sobol(5), new ByPosition(6, 7)];
  const filled = (owner, source) => {
    const each = owner.dimensions ?? 1;
    const array = owner.fill(owner.dimensions ? new Float32Array(each) : new Uint32Array(1), source);
    return each === 1 ? array[0] : Array.from(array);
  };
  const runs = [];
  for (let run = 0; run < 3000; run += 1) {
    const [owner, source, draws] = [random(owners.length), random(sources.length), 1 + random(12)];
    runs.push([owner, source, Array.from({ length: draws }, () => owners[owner].draw(sources[source]))]);
  }
  // Afterwards, since to fill an array puts an end to what was drawn ahead.
  runs.forEach(([owner, source, got], run) => {
    assert.deepEqual(got, got.map(() => filled(again[owner], alone[source])), `run ${run}`);
  });
  assert.deepEqual(sources.map(({ state, index }) => state ?? index), alone.map(({ state, index }) => state ?? index));
});

test("arrays beyond what their buffer has left are refused, and two shared buffers of one memory are no trouble", () => {
  const shrunk = new ArrayBuffer(64, { maxByteLength: 128 });
  const array = new Float32Array(shrunk, 32, 8);
  shrunk.resize(16);
  assert.throws(() => new Normal(0, 1).fill(array, new Pcg32(1)), TypeError);
  const shared = new SharedArrayBuffer(4 * 40000);
  const from = new Float32Array(shared, 0, 30000);
  from.forEach((_, i) => { from[i] = i / 30000; });
  const uniform = new microwarp.Interval(0, 1);
  const due = uniform.map(from.slice(), new Float32Array(30000));
  const other = structuredClone(shared);
  assert.notEqual(other, shared);
  assert.deepEqual(Array.from(uniform.map(from, new Float32Array(other, 4 * 5000, 30000))), Array.from(due));
});

test("classes that others are made of take nothing that leads beyond", () => {
  class Mine extends microwarp.Warp {
    constructor() {
      super({ address: () => 1 << 17 }, 53, [1, 1, 1]);
    }
  }
  assert.throws(() => new Mine(), TypeError);
  const Indices = Object.getPrototypeOf(Cdf);
  const weights = new Float32Array(1000).fill(1);
  assert.equal(new Indices(7, weights, 0).select(0.4321).index, new Alias(weights).select(0.4321).index);
  assert.throws(() => new Indices(0, { length: 2 ** 31 }), TypeError);
});

test("what draws by rejection takes a point of a set a draw", () => {
  const laws = [new microwarp.Gamma(0.5, 1), new microwarp.VonMises(1, 2), new microwarp.Beta(2, 3), new microwarp.Dirichlet(Array(8).fill(1e-3))];
  for (const law of laws) {
    const [set, generator] = [new Sobol(3), new Pcg32(3)];
    for (let i = 0; i < 300; i += 1) for (const source of [set, generator]) assert.ok([law.draw(source)].flat().every((x) => Number.isFinite(x)) && law.pdf(law.draw(source)) > 0);
    assert.equal(set.index, 600);
    for (const wrong of [undefined, null, Math.random, {}, "rng"]) assert.throws(() => law.draw(wrong), { name: "TypeError", message: /a generator such as new Pcg32/ });
  }
  const [gamma, integers] = [new microwarp.Gamma(2, 3), new DiscreteLaplace(2)];
  for (const at of [-1, NaN, Infinity]) assert.equal(gamma.pdf(at), 0);
  for (const at of [0.5, NaN, 2 ** 31, -(2 ** 31) - 1]) assert.throws(() => integers.pmf(at), { name: "RangeError", message: /^integer: an integer from -2147483648 to 2147483647 is expected, not / });
  for (const wrong of [new Uint32Array(4), [1]]) assert.throws(() => integers.fill(wrong, new Pcg32(1)), TypeError);
});

test("a chain resumes from counts that do not contradict each other", () => {
  const chain = new Chain(() => 1, 0, { box: 1 });
  const saved = { state: 0, density: 1, steps: 3, accepted: 2, refused: 1 };
  assert.equal(chain.resume(saved).steps, 3);
  for (const wrong of [{ accepted: 4 }, { refused: 2 }, { steps: 2 }]) assert.throws(() => chain.resume({ ...saved, ...wrong }), { name: "RangeError", message: /^(accepted|refused): an integer from 0 to / });
  assert.throws(() => chain.resume(), { name: "TypeError", message: /density/ });
  assert.equal(chain.steps, 3);
});
