// What the package promises besides bits: errors, arrays, generators, chains, and what its modules import.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import test from "node:test";
import * as microwarp from "microwarp";

const { Alias, Binomial, BinomialRejection, Cdf, Chain, Disk, Exponential, Frame, Integers, LatinHypercube, LightReservoir, Mixture, Normal, Pcg32, Screen, Sobol, Strata, SumTree, Warp, WeightedReservoir, balanceHeuristic, drawWithPdf, fillWithPdf, mapWithPdf, powerHeuristic, roulette, sampleWithPdf } = microwarp;
const classes = Object.values(microwarp).filter((value) => value.prototype instanceof Warp);
const { golden } = JSON.parse(readFileSync(new URL("expected.json", import.meta.url)));
const made = (name, maker, given) => (maker === "new" ? new microwarp[name](...given) : microwarp[name][maker](...given));
const refused = (code) => (error) => error instanceof RangeError && error.code === code && error.message.length > 10;

test("every constructor refuses NaN, and what are not its numbers", () => {
  let tried = 0;
  for (const [, name, maker, given] of golden) {
    const spoiled = JSON.stringify(given).replace(/-?[\d.e+-]+/, '"NaN"');
    if (given.length > 0) {
      const parameters = JSON.parse(spoiled, (_, value) => (value === "NaN" ? NaN : value));
      assert.throws(() => made(name, maker, parameters), RangeError, `${name}.${maker}(${spoiled})`);
      assert.throws(() => made(name, maker, JSON.parse(spoiled)), TypeError, `${name}.${maker}(${spoiled})`);
      assert.throws(() => made(name, maker, given.slice(1)), TypeError);
      tried += 1;
    }
    assert.throws(() => made(name, maker, [...given, 1]), TypeError, name);
  }
  console.log(`${tried} sets of parameters spoiled`);
});

test("a refusal is a RangeError with the words and the code of the crate", () => {
  assert.throws(() => new Normal(0, -1), { name: "RangeError", message: "parameter 2 must be positive", code: 5, parameter: 1 });
  assert.throws(() => Exponential.fromRate(Infinity), refused(1));
  assert.throws(() => new microwarp.Interval(2, 1), { message: "parameter 2 is below its lower bound", code: 2, parameter: 1 });
  assert.throws(() => new Cdf([1, 2, -3]), { message: "weight 2 is negative", code: 13 });
  assert.throws(() => new Alias([0, 0]), refused(14));
  assert.throws(() => new Cdf([]), refused(10));
  assert.throws(() => new SumTree(new Uint32Array(0)), refused(10));
  const large = Uint32Array.of(2 ** 31, 1, 2 ** 31);
  assert.throws(() => new SumTree(large), refused(4));
  assert.deepEqual([...large], [2 ** 31, 1, 2 ** 31]);
  const tree = new SumTree(Uint32Array.of(2 ** 32 - 6, 2, 0));
  assert.throws(() => tree.set(2, 4), refused(4));
  for (const index of [3, -1, 0.5]) assert.throws(() => tree.set(index, 1), RangeError);
  assert.throws(() => tree.set(0, -1), RangeError);
  assert.throws(() => new SumTree([1, "2"]), TypeError);
  assert.throws(() => new SumTree([1n, 2]), TypeError);
  assert.throws(() => new SumTree([1, 2n]), TypeError);
  assert.throws(() => new SumTree({ length: 1 }), TypeError);
  assert.throws(() => new SumTree([1n << 63n, 1n << 63n]), refused(4));
  assert.throws(() => new SumTree([-1]), RangeError);
  assert.deepEqual([tree.total, tree.get(0), tree.index(2 ** 32 - 1)], [2 ** 32 - 4, 2 ** 32 - 6, 1]);
  assert.deepEqual([...tree.weights()], [2 ** 32 - 6, 2, 0]);
  assert.equal(new SumTree(new Uint32Array(3)).draw(new Pcg32(1)), undefined);
  assert.throws(() => new microwarp.PiecewiseConstant2d([1, 2, 3], [2, 2], [0, 1], [0, 1]), RangeError);
  assert.throws(() => new microwarp.RegularPolygon(4.5), refused(7));
  assert.throws(() => new Strata(0), RangeError);
  assert.throws(() => new Exponential(1), /Exponential.fromRate or Exponential.fromMean/);
});

test("nobody but the tree writes to its weights", () => {
  for (const weights of [Uint32Array.of(3, 0, 5), [3, 0, 5], BigUint64Array.of(3n, 0n, 5n)]) {
    const [tree, largest] = [new SumTree(weights), typeof weights[0] === "bigint" ? 2n ** 64n - 1n : 2 ** 32 - 1];
    weights.fill(largest);
    tree.weights().fill(largest);
    for (let i = 0; i < 1000; i += 1) assert.ok([0, 2].includes(tree.draw(new Pcg32(i))));
    assert.equal(tree.index(largest), 2);
    assert.deepEqual([...tree.weights()].map(Number), [3, 0, 5]);
  }
});

test("integers, counts and reservoirs refuse what Rust refuses, and draw nothing", () => {
  const rng = new Pcg32(3);
  const before = rng.state;
  for (const [low, high] of [[1, 0], [0, 2 ** 32], [1n, 0n], [0n, 2n ** 64n], [-1n, 0n]]) assert.throws(() => new Integers(low, high), RangeError);
  for (const [low, high] of [[0, 1n], [0n, 1], ["0", 1], [0n]]) assert.throws(() => new Integers(low, high), TypeError);
  assert.throws(() => new Integers(0, 1).draw({}), TypeError);
  assert.deepEqual([new Integers(-3, 5).low, new Integers(-3n + 4n, 5n).high], [-3, 5n]);
  assert.throws(() => new Binomial(1000, 0.5), refused(4));
  assert.throws(() => new Binomial(10, 1.5), RangeError);
  assert.throws(() => new Binomial(10, NaN), refused(1));
  assert.throws(() => Binomial.fromRatio(10, 3, 2), RangeError);
  assert.throws(() => Binomial.fromRatio(10, 0, 0), refused(5));
  assert.throws(() => new BinomialRejection(10, 0.5), RangeError);
  assert.throws(() => new BinomialRejection(1000), TypeError);
  const { Beta, Dirichlet, DiscreteGaussian, DiscreteLaplace, Gamma, VonMises } = microwarp;
  assert.throws(() => new Gamma(NaN, 1), refused(1));
  assert.throws(() => new Gamma(1, 1e-38), refused(3));
  assert.throws(() => new Gamma(1e6, 1e38), refused(4));
  assert.throws(() => new Gamma(1, 0), refused(5));
  assert.throws(() => new Gamma(2e6, 1), refused(7));
  assert.throws(() => Gamma.chiSquared(0), refused(5));
  assert.throws(() => new Gamma(1), TypeError);
  assert.throws(() => new Beta(1e-31, 1), refused(7));
  assert.throws(() => new Dirichlet([1, -1, 1]), refused(5));
  for (const shapes of [[], [1], Array(9).fill(1)]) assert.throws(() => new Dirichlet(shapes), { name: "RangeError", message: /the number of shapes: an integer from 2 to 8/ });
  for (const shapes of [undefined, 3, { length: 3 }, ["1", "2"]]) assert.throws(() => new Dirichlet(shapes), TypeError);
  assert.throws(() => new Dirichlet([1, 2, 3]).pdf([0.5, 0.5]), TypeError);
  assert.throws(() => new VonMises(0, -1), refused(6));
  assert.throws(() => new VonMises(7, 1), refused(7));
  assert.throws(() => new DiscreteGaussian(0, 21), refused(4));
  assert.throws(() => new DiscreteGaussian(2e9, 1), refused(7));
  assert.throws(() => new DiscreteLaplace(0), refused(5));
  assert.throws(() => new DiscreteLaplace(1e8), refused(4));
  assert.throws(() => DiscreteLaplace.fromRatio(1, 0), refused(5));
  assert.throws(() => new WeightedReservoir(0), RangeError);
  assert.throws(() => new WeightedReservoir(3).offer("a", -1, rng), RangeError);
  assert.throws(() => new WeightedReservoir(3).merge({}), TypeError);
  assert.throws(() => new LatinHypercube(0), RangeError);
  // Of a picture of 2^16 a side a pixel has one sample.
  for (const [width, height, log2, good] of [[65536, 1, 0, true], [65536, 65536, 1, false], [1, 1, 32, true], [1, 1, 33, false], [257, 3, 15, false]]) {
    if (good) assert.equal(new Screen(width, height, log2).pixel(0, 0).at(2 ** 32 - 1).words(new Uint32Array(1)).length, 1);
    else assert.throws(() => new Screen(width, height, log2), { name: "RangeError", message: /log2Samples/ });
  }
  for (const [normal, code] of [[[0, 0, 0], 9], [[NaN, 0, 1], 1], [[0, Infinity, 1], 1]]) assert.throws(() => new Frame(normal), refused(code));
  for (const normal of [undefined, 3, [1, 2], [1, 2, 3, 4], ["0", 0, 1]]) assert.throws(() => new Frame(normal), TypeError);
  assert.throws(() => new Frame([0, 0, 1]).toWorld([1, 2]), TypeError);
  assert.equal(rng.state, before);
  // A word an item, of whatever weight; none is held of weight 0.
  const kept = new WeightedReservoir(2);
  assert.deepEqual([kept.offer("a", 0, rng), kept.offer("b", 1, rng), kept.offer("c", 1, rng)], [false, true, true]);
  assert.deepEqual(kept.items().sort(), ["b", "c"]);
  kept.merge(kept);
  assert.deepEqual(kept.items().sort(), ["b", "c"]);
  const same = Pcg32.resume(before);
  same.words(new Uint32Array(3));
  assert.equal(rng.state, same.state);
});

test("a hypercube has a point a stratum", () => {
  const uniforms = new LatinHypercube(50, 3).uniforms(new Float32Array(100), 2);
  for (const d of [0, 1]) {
    const strata = Array.from({ length: 50 }, (_, i) => Math.floor(uniforms[2 * i + d] * 50));
    assert.deepEqual(strata.sort((a, b) => a - b), Array.from({ length: 50 }, (_, i) => i));
  }
});

test("arrays of a wrong type or length, and detached ones, are refused", () => {
  const [disk, rng] = [new Disk(), new Pcg32(1)];
  assert.throws(() => disk.fill(new Float64Array(2), rng), TypeError);
  assert.throws(() => disk.fill([0, 0], rng), TypeError);
  assert.throws(() => disk.fill(new Float32Array(3), rng), RangeError);
  assert.throws(() => disk.map(new Float32Array(4), new Float32Array(6)), RangeError);
  assert.throws(() => disk.pdfs(new Float32Array(4), new Float32Array(1)), RangeError);
  assert.throws(() => disk.sample([0.5]), TypeError);
  assert.throws(() => disk.sample(0.5), TypeError);
  const gone = new Float32Array(4);
  structuredClone(gone.buffer, { transfer: [gone.buffer] });
  assert.throws(() => disk.fill(gone, rng), TypeError);
  assert.throws(() => new Cdf([1, 1]).fill(new Float32Array(2), rng), TypeError);
  assert.equal(disk.fill(new Float32Array(0), rng).length, 0);
});

test("arrays hold what single calls give, over the ends of blocks", () => {
  for (const Class of classes) {
    const subject = golden.find(([, name]) => name === Class.name);
    if (!subject) continue;
    const [, name, maker, given] = subject;
    const warp = made(name, maker, given);
    const count = 9001;
    assert.equal(Class.dimensions, warp.dimensions);
    const points = warp.fill(new Float32Array(count * warp.dimensions), new Pcg32(3, 4));
    const densities = warp.pdfs(points, new Float32Array(count));
    const inverses = warp.inverts(points, new Float32Array(count * warp.uniforms));
    const again = warp.map(inverses, new Float32Array(points.length));
    const rng = new Pcg32(3, 4);
    const at = (array, each, i) => (each === 1 ? array[i] : Array.from(array.subarray(i * each, (i + 1) * each)));
    for (let i = 0; i < count; i += 1) {
      const point = warp.draw(rng);
      if (i % 750 !== 0 && i + 1 !== count) continue;
      assert.deepEqual(point, at(points, warp.dimensions, i), `${name} ${i}`);
      assert.deepEqual(warp.pdf(point), densities[i], `${name} ${i}`);
      const uniforms = warp.invert(point);
      assert.deepEqual(uniforms, at(inverses, warp.uniforms, i), `${name} ${i}`);
      assert.deepEqual(warp.sample(uniforms), at(again, warp.dimensions, i), `${name} ${i}`);
    }
  }
});

test("densities come with the points, over the ends of blocks, and refusals change nothing", () => {
  for (const Class of classes) {
    const subject = golden.find(([, name]) => name === Class.name);
    if (!subject) continue;
    const [, name, maker, given] = subject;
    const [warp, count] = [made(name, maker, given), 5001];
    const { dimensions, uniforms } = warp;
    const [points, densities] = [new Float32Array(count * dimensions), new Float32Array(count)];
    assert.equal(fillWithPdf(warp, points, densities, new Pcg32(3, 4)), points);
    assert.deepEqual(points, warp.fill(new Float32Array(count * dimensions), new Pcg32(3, 4)), name);
    const single = new Pcg32(3, 4);
    for (let i = 0; i < count; i += 1) {
      const { point, pdf } = drawWithPdf(warp, single);
      if (i % 750 === 0 || i + 1 === count) assert.deepEqual([point, pdf].flat(), [...points.subarray(i * dimensions, (i + 1) * dimensions), densities[i]], `${name} ${i}`);
    }
    const own = new Sobol(5).uniforms(new Float32Array(count * uniforms), uniforms);
    assert.deepEqual(mapWithPdf(warp, own, points, densities), warp.map(own, new Float32Array(count * dimensions)), name);
    const last = uniforms === 1 ? own.at(-1) : Array.from(own.subarray(-uniforms));
    assert.equal(sampleWithPdf(warp, last).pdf, densities.at(-1), name);
  }
  const [disk, set, rng] = [new Disk(), new Sobol(1), new Pcg32(1)];
  const before = rng.state;
  assert.deepEqual(drawWithPdf(disk, set).point, disk.draw(new Sobol(1)));
  assert.equal(set.index, 1);
  for (const wrong of [undefined, null, 3, {}, Disk, new Cdf([1])]) {
    for (const use of [() => drawWithPdf(wrong, rng), () => sampleWithPdf(wrong, 0.5), () => fillWithPdf(wrong, new Float32Array(2), new Float32Array(1), rng), () => mapWithPdf(wrong, new Float32Array(2), new Float32Array(2), new Float32Array(1))]) {
      assert.throws(use, { name: "TypeError", message: /^a warp is expected, not / });
    }
  }
  const points = new Float32Array(4).fill(7);
  for (const densities of [new Float32Array(1), new Float32Array(3), new Float32Array(0)]) assert.throws(() => fillWithPdf(disk, points, densities, rng), { name: "RangeError", message: /not as many/ });
  for (const densities of [new Float64Array(2), [1, 2]]) assert.throws(() => fillWithPdf(disk, points, densities, rng), TypeError);
  assert.throws(() => fillWithPdf(disk, points, new Float32Array(2), {}), TypeError);
  assert.throws(() => mapWithPdf(disk, new Float32Array(2), points, new Float32Array(2)), RangeError);
  assert.throws(() => drawWithPdf(disk, {}), TypeError);
  assert.throws(() => sampleWithPdf(disk, 0.5), TypeError);
  assert.deepEqual([rng.state, ...points], [before, 7, 7, 7, 7]);
});

test("warps mix where their points are of one kind and their densities by one measure", () => {
  const of = (name) => made(...golden.find(([, other]) => other === name).slice(1));
  const groups = [
    ["Interval", "Normal", "ExponentialTail", "Weibull"], ["PowerMax2", "StudentT"], ["Disk", "NormalPair", "Aabb2d", "RegularPolygon"],
    ["Triangle", "TriangleOn3d"], ["Sphere", "CosineHemisphere", "VisibleSphere", "Cone"], ["Ggx", "GgxVisible"], ["Simplex2"],
    ["MultivariateNormal3", "Ball"], ["Rotation"], ["Simplex3"], ["BoxSurface", "CapsuleSurface"],
  ];
  const warps = groups.flatMap((names, group) => names.filter((name) => golden.some(([, other]) => other === name)).map((name) => [of(name), group, name]));
  assert.ok(warps.length >= 20, `${warps.length}`);
  for (const [one, group, name] of warps) {
    for (const [other, its, its_name] of warps) {
      if (group === its) {
        const mixture = new Mixture([one, other], [1, 3]);
        assert.deepEqual([mixture.dimensions, mixture.uniforms], [one.dimensions, one.uniforms]);
        assert.ok(drawWithPdf(mixture, new Pcg32(1)).pdf > 0, `${name} ${its_name}`);
      } else assert.throws(() => new Mixture([one, other], [1, 1]), { name: "TypeError", message: /^parts of one kind are expected: part 1 has / }, `${name} ${its_name}`);
    }
  }
  assert.throws(() => new Mixture([new Disk(), new Disk(), new microwarp.LatLongMap([1, 1], [2, 1])], [1, 1, 1]), /part 2 has/);
});

test("a mixture fills as it draws, and refuses what is none", () => {
  const [low, high] = [new microwarp.Interval(0, 1), new microwarp.Interval(2, 3)];
  const mixture = new Mixture([low, high], [1, 3]);
  const [points, rng] = [mixture.fill(new Float32Array(9000), new Pcg32(5)), new Pcg32(5)];
  for (let i = 0; i < 9000; i += 1) assert.equal(mixture.draw(rng), points[i]);
  assert.deepEqual([mixture.pmf(0), mixture.pmf(1), mixture.pmf(2), mixture.pmf(2 ** 32 - 1)], [0.25, 0.75, 0, 0]);
  assert.deepEqual([mixture.pdf(0.5), mixture.pdf(2.5), mixture.pdf(1.5), mixture.pdf(NaN)], [0.25, 0.75, 0, 0]);
  const own = new Sobol(2).uniforms(new Float32Array(9000));
  assert.deepEqual(mixture.inverts(mixture.map(own, new Float32Array(9000)), new Float32Array(9000)).length, 9000);
  own.forEach((u, i) => assert.ok(Math.abs(mixture.invert(mixture.sample(u)) - u) < 2e-7, `${i}`));
  // What lies about in the memory is no part of it.
  for (let i = 0; i < 3000; i += 1) new Cdf(new Float32Array(1000).fill(1));
  assert.equal(mixture.draw(new Pcg32(5)), points[0]);

  for (const parts of [undefined, null, 3, {}, "ab", new Float32Array(2), [1, 2], [low, undefined], [low, , high], [low, Disk]]) assert.throws(() => new Mixture(parts, [1, 1]), { name: "TypeError", message: /is expected, not / });
  assert.throws(() => new Mixture([mixture, low], [1, 1]), { name: "TypeError", message: /a part that is no mixture is expected/ });
  for (const parts of [[], Array(33).fill(low)]) assert.throws(() => new Mixture(parts, parts.map(() => 1)), { name: "RangeError", message: /the number of parts: an integer from 1 to 32/ });
  for (const weights of [[1], [1, 2, 3], []]) assert.throws(() => new Mixture([low, high], weights), { name: "RangeError", message: /^2 weights are expected, not / });
  for (const [weights, code] of [[[1, NaN], 12], [[1, -1], 13], [[0, 0], 14]]) assert.throws(() => new Mixture([low, high], weights), refused(code));
  assert.throws(() => new Mixture([low, high], [1, -1]), /weight 1 is negative/);
  for (const weights of [undefined, 3, ["1", 1]]) assert.throws(() => new Mixture([low, high], weights), TypeError);
  assert.throws(() => mixture.invert(0.5, "1"), TypeError);
  assert.throws(() => mixture.invert([0.5, 1]), TypeError);
  assert.throws(() => mixture.pmf(0.5), RangeError);
  // A class made of one may say what it likes.
  class Wide extends microwarp.Interval {
    get dimensions() {
      return 4000;
    }
  }
  assert.deepEqual(drawWithPdf(new Mixture([new Wide(0, 1)], [1]), new Pcg32(5)).pdf, 1);
});

test("what is wrong of lights is refused, and draws and changes nothing", () => {
  const [rng, held, other] = [new Pcg32(3), new LightReservoir(), new LightReservoir()];
  held.offer("a", 2, 0.5, rng);
  other.offer("b", 1, 1, rng);
  const shown = (of) => [of.item, of.count, of.target, of.contribution];
  const [before, due] = [rng.state, [shown(held), shown(other)]];
  assert.deepEqual(due, [["a", 1, 2, 2], ["b", 1, 1, 1]]);
  for (const [target, density, code] of [[NaN, 1, 1], [Infinity, 1, 1], [1e39, 1, 1], [-1, 1, 6], [1, 0, 5], [1, -1, 5], [1, NaN, 1], [1, 1e-50, 5]]) {
    assert.throws(() => held.offer("c", target, density, rng), refused(code), `${target} ${density}`);
  }
  for (const [target, code] of [[NaN, 1], [-1, 6]]) assert.throws(() => held.absorb(other, target, rng), refused(code));
  for (const wrong of ["1", undefined, null, 7n, {}]) {
    assert.throws(() => held.offer("c", wrong, 1, rng), TypeError);
    assert.throws(() => held.offer("c", 1, wrong, rng), TypeError);
    assert.throws(() => held.absorb(other, wrong, rng), TypeError);
    assert.throws(() => held.absorb(wrong, 1, rng), { name: "TypeError", message: /^a LightReservoir is expected, not / });
    assert.throws(() => held.offer("c", 1, 1, wrong), { name: "TypeError", message: /a generator such as/ });
    assert.throws(() => held.absorb(other, 1, wrong), TypeError);
    assert.throws(() => held.cap(wrong), TypeError);
    assert.throws(() => roulette(wrong, rng), TypeError);
    assert.throws(() => roulette(0.5, wrong), TypeError);
  }
  for (const own of [-1, 2, 0.5]) assert.throws(() => balanceHeuristic([1, 1], [1, 1], own), { name: "RangeError", message: /^own: / });
  for (const counts of [[], Array(4097).fill(1), [1, -1], [0.5, 1], [1, 2 ** 32]]) assert.throws(() => powerHeuristic(counts, counts, 0), RangeError);
  for (const densities of [undefined, [1], [1, 2, 3], ["1", 2], 1]) assert.throws(() => balanceHeuristic([1, 1], densities, 0), TypeError);
  assert.deepEqual([rng.state, shown(held), shown(other)], [before, ...due]);
  assert.equal(held.offer("d", 0, 1, rng), false);
  held.absorb(held, held.target, rng);
  assert.deepEqual(shown(held), ["a", 4, 2, 1]);
  held.cap(0);
  assert.deepEqual(shown(held), [undefined, 0, 0, 0]);

  const [lamp, gloss, disk] = [new microwarp.VisibleSphere([0, 0, 0], [0, 0, 5], 1), new microwarp.GgxVisible([0, 0, 1], [0.2, 0.2]), new Disk()];
  assert.deepEqual(lamp.sampleLight([0.25, 0.5]).direction, lamp.sample([0.25, 0.5]));
  assert.deepEqual(lamp.drawLight(new Sobol(4)).direction, lamp.sample([...new Sobol(4).words(new Uint32Array(2), 2)].map((word) => (word >>> 8) / 2 ** 24)));
  for (const wrong of [0.5, [0.5], [0, 0, 0], ["0", 0], undefined]) {
    for (const use of [() => lamp.sampleLight(wrong), () => gloss.reflect(wrong)]) assert.throws(use, TypeError);
  }
  for (const use of [() => lamp.drawLight({}), () => gloss.drawReflection(), () => gloss.reflectedPdf([1, 0]), () => gloss.unmasked(1), () => gloss.visibility("abc"), () => new microwarp.Ggx([0.2, 0.2]).distribution([])]) assert.throws(use, TypeError);
  // Members of one class are no members of another.
  const { drawLight } = lamp;
  for (const value of [disk, gloss, {}, new microwarp.SphericalRectangle([0, 0, 0], [0, 0, 1], [[1, 0, 0], [0, 1, 0]])]) assert.throws(() => drawLight.call(value, new Pcg32(1)), { name: "TypeError", message: /^a VisibleSphere is expected, not / });
  for (const value of [undefined, lamp, {}]) assert.throws(() => new microwarp.Reflected(value), { name: "TypeError", message: /^a GgxVisible is expected, not / });
  assert.equal(microwarp.GgxVisible.name, "GgxVisible");
});

test("a generator goes on where it was, and two do not disturb each other", () => {
  const [normal, first, second] = [new Normal(0, 1), new Pcg32(7, 1), new Pcg32(8n, 1n)];
  const alone = Array.from(normal.fill(new Float32Array(4), new Pcg32(7, 1)));
  const mixed = alone.map(() => [normal.draw(first), normal.draw(second)][0]);
  assert.deepEqual(mixed, alone);
  const kept = first.state;
  assert.match(kept, /^[0-9a-f]{16}-[0-9a-f]{16}$/);
  const next = normal.draw(first);
  assert.equal(normal.draw(Pcg32.resume(kept)), next);
  assert.notEqual(first.state, kept);
  for (const wrong of ["", "12", kept.slice(1), kept.slice(0, -1) + "0", kept + "0"]) assert.throws(() => Pcg32.resume(wrong), RangeError);
  assert.throws(() => new Pcg32(0.5), RangeError);
  assert.notEqual(new Pcg32().state, new Pcg32().state);
});

test("tables larger than the memory was, and many of them, keep their weights", () => {
  const many = Array.from({ length: 40 }, (_, i) => new Cdf(Float32Array.from({ length: 1 << 14 }, (_, j) => Number(j === i))));
  const large = new Alias(new Float32Array(1 << 20).fill(1));
  const rng = new Pcg32(1);
  many.forEach((table, i) => assert.equal(table.draw(rng), i));
  assert.equal(large.pmf(77), 2 ** -20);
  assert.ok(Math.max(...large.fill(new Uint32Array(100), rng)) > 1 << 16);
  assert.deepEqual(many.map((table) => table.select(0.5).index), many.map((_, i) => i));
  // More small things than fit beside them come and go.
  for (let i = 0; i < 2000; i += 1) assert.equal(new microwarp.Interval(i, i + 1).sample(0), i);
  assert.deepEqual(many.map((table) => table.draw(rng)), many.map((_, i) => i));
  assert.equal(large.pmf(77), 2 ** -20);
});

test("points of a set go on from index to index, in the dimensions asked for", () => {
  const [disk, sobol] = [new Disk(), new Sobol(7)];
  const points = disk.fill(new Float32Array(8), sobol);
  assert.equal(sobol.index, 4);
  assert.deepEqual(disk.draw(sobol.at(2)), Array.from(points.subarray(4, 6)));
  const [uniforms, all] = [sobol.at(5, 3).uniforms(new Float32Array(1)), sobol.at(5).uniforms(new Float32Array(4), 4)];
  assert.equal(uniforms[0], all[3]);
  const strata = new Strata(4, 2).uniforms(new Float32Array(16), new Pcg32(1));
  for (let k = 0; k < 8; k += 1) {
    assert.deepEqual([Math.floor(strata[2 * k] * 4), Math.floor(strata[2 * k + 1] * 2)], [k % 4, Math.floor(k / 4)]);
  }
});

test("a chain goes on where it was, and refuses what is none", () => {
  const target = (x) => Math.exp(-0.5 * (x - 3) ** 2);
  const [chain, rng] = [new Chain(target, 3, { normal: 2.4 }), new Pcg32(5, 5)];
  for (let i = 0; i < 100; i += 1) chain.step(rng);
  assert.ok(chain.steps === 100 && chain.acceptanceRate === chain.accepted / 100);
  assert.equal(chain.reset().steps, 0);
  const [saved, kept] = [chain.save(), rng.state];
  const other = new Chain(target, 0, { normal: 2.4 }).resume(saved);
  assert.deepEqual(other.step(Pcg32.resume(kept)), chain.step(rng));
  assert.throws(() => new Chain(() => 0, 0, { normal: 1 }), RangeError);
  assert.throws(() => new Chain(target, 0, { normal: -1 }), RangeError);
  assert.throws(() => new Chain(target, 0, { box: 0 }), RangeError);
  assert.throws(() => new Chain(target, 0.5, { box: 0.1, cube: 2 }), RangeError);
  assert.equal(new Chain((x) => (x === 3 ? 1 : NaN), 3, { normal: 1 }).step(rng).outcome, "refused");
});

// Prints the bits of all classes in arrays, with or without vectors.
const digest = `
import * as microwarp from "microwarp";
import { createHash } from "node:crypto";
import { readFileSync } from "node:fs";
const hash = createHash("sha256");
for (const [, name, maker, given] of JSON.parse(readFileSync("expected.json")).golden) {
  const warp = maker === "new" ? new microwarp[name](...given) : microwarp[name][maker](...given);
  const points = warp.fill(new Float32Array(5000 * warp.dimensions), new microwarp.Pcg32(9, 9));
  hash.update(points).update(warp.pdfs(points, new Float32Array(5000))).update(warp.inverts(points, new Float32Array(5000 * warp.uniforms)));
}
console.log(hash.digest("hex"));`;

test("both modules give the same bits, and import nothing", () => {
  const arguments_ = ["--input-type=module", "--eval", digest];
  const run = (...options) => execFileSync(process.execPath, [...options, ...arguments_], { encoding: "utf8" });
  const without = "data:text/javascript,WebAssembly.validate = () => false;";
  assert.equal(run("--import", without), run());
  const module = (name) => new WebAssembly.Module(readFileSync(new URL(import.meta.resolve(`microwarp/${name}`))));
  for (const name of ["microwarp.wasm", "microwarp-simd.wasm"]) assert.deepEqual(WebAssembly.Module.imports(module(name)), []);
  // What can panic has an import, or else finding none would mean nothing.
  const panics = new WebAssembly.Module(readFileSync(process.env.MICROWARP_PANICS));
  assert.equal(WebAssembly.Module.imports(panics).length, 1);
});
