// The package against the crate, bit by bit: every golden line of its classes, and runs that the host computed. The tests are
// run in a project in which the packed package is installed; see `check`.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test from "node:test";
import { isDeepStrictEqual } from "node:util";
import * as microwarp from "microwarp";
import { bits, differing, hex, lines, made as made_of } from "./lines.mjs";

const { golden, uniforms, runs, densities } = JSON.parse(readFileSync(new URL("expected.json", import.meta.url)));
const { Alias, Binomial, BinomialRejection, ByPosition, Cdf, Chain, Frame, Integers, LatinHypercube, Pcg32, Permutation, Screen, Sobol, Strata, SumTree, WeightedReservoir, drawWithPdf, sampleWithPdf } = microwarp;

const made = (...of) => made_of(microwarp, ...of);
const table = readFileSync(new URL("golden.csv", import.meta.url), "utf8");
const wrong = (table) => differing(microwarp, { golden, uniforms }, table).wrong;

test("every class gives the bits of the golden table", () => {
  assert.deepEqual(wrong(table), []);
  const names = new Set(golden.map(([, name]) => name));
  assert.ok(names.size >= 45, `${names.size} classes`);
  console.log(`${16 * golden.length} cases of ${names.size} classes`);
});

// How many lines of a subject that is made of other warps are not those of the table.
const composed = (name, warp) => lines(microwarp, uniforms, name, warp, 0.25).filter((line) => !table.includes(`${line}\n`)).length;

test("mixtures and reflections give the bits of the golden table, and not those of others", () => {
  const { CosineHemisphere, GgxVisible, Interval, Mixture, Reflected } = microwarp;
  const parts = [new Interval(0, 1), new Interval(0.5, 2), new Interval(-1e30, 1e30)];
  assert.equal(composed("Mixture of three", new Mixture(parts, [0.3, 0, 1e-7])), 0);
  assert.ok(composed("Mixture of three", new Mixture(parts, [0.3, 0, 2e-7])) > 5);
  const gloss = new Reflected(new GgxVisible([0.6, 0, 0.8], [0.3, 0.3]));
  const bounded = GgxVisible.bounded([0.6, -0.7, 0.1], [0.05, 1]);
  assert.deepEqual([composed("Reflected 0.3", gloss), composed("Reflected bounded", new Reflected(bounded))], [0, 0]);
  assert.ok(composed("Reflected bounded", new Reflected(new GgxVisible([0.6, -0.7, 0.1], [0.05, 1]))) > 5);
  assert.equal(composed("Mixture lobes", new Mixture([new CosineHemisphere(), gloss], [1, 2])), 0);
});

test("a table in which one bit is changed is rejected", () => {
  const at = table.indexOf("poly Disk #5,") + "poly Disk #5,".length;
  const changed = table.slice(0, at) + hex(parseInt(table.slice(at, at + 8), 16) ^ 1) + table.slice(at + 8);
  assert.deepEqual(wrong(changed), ["Disk #5"]);
});

const rng = () => new Pcg32(42, 54);
// Two points and their densities: drawn, and by the uniforms of these.
const with_densities = (warp) => {
  const words = rng();
  return Array.from({ length: 2 }, () => {
    const drawn = drawWithPdf(warp, words);
    return [drawn, sampleWithPdf(warp, warp.invert(drawn.point))].map(({ point, pdf }) => bits([point, pdf]));
  }).flat(2);
};
const other_densities = (due) => golden.filter(([name, ...of]) => !isDeepStrictEqual(with_densities(made(...of)), due[name])).map(([name]) => name);

test("every class hands over the densities of the host, and of a changed one it is seen", () => {
  assert.deepEqual(Object.keys(densities), golden.map(([name]) => name));
  assert.deepEqual(other_densities(densities), []);
  const changed = densities.Normal.with(3, densities.Normal[3] ^ 1);
  assert.deepEqual(other_densities({ ...densities, Normal: changed }), ["Normal"]);
});

const weights = [0, 1, 1e-6, 37, 0.3, 0];
const cells = [1, 0, 4, 2.5, 1e-3, 0.5];
const filled = (warp) => bits(Array.from(warp.fill(new Float32Array(19 * warp.dimensions), rng())));
const triples = (warp) => {
  const words = rng();
  return Array.from({ length: 8 }, () => {
    const point = warp.draw(words);
    return bits([point, warp.pdf(point), warp.invert(point)]);
  }).flat();
};
const selections = (table) => {
  const selected = [0, 0.3, 0.999].map((u) => table.select(u)).map(({ index, pmf, leftover }) => [index, ...bits([pmf, leftover])]);
  return [...table.fill(new Uint32Array(64), rng()), ...selected.flat()];
};
const changing = () => {
  const [tree, words, found] = [new SumTree(Uint32Array.of(3, 0, 5, 2 ** 31, 7, 2 ** 30)), rng(), []];
  for (let k = 0; k < 32; k += 1) {
    const index = tree.draw(words);
    found.push(index, tree.set(index, Math.imul(k, 0x9e3779b9) >>> (k & 7) >>> 5));
  }
  found.push(...tree.drawDistinct(4, words));
  for (let index = 0; index < 6; index += 1) found.push(...bits(tree.pmf(index)));
  return [...found, tree.total, ...tree.weights()];
};
const halves = (word) => [Number(word >> 32n), Number(word & 0xffffffffn)];
const changing_wide = () => {
  const [tree, words, found] = [new SumTree(BigUint64Array.of(3n, 0n, 5n << 40n, 1n << 62n, 7n, 1n << 60n)), rng(), []];
  for (let k = 0n; k < 32n; k += 1n) {
    const index = tree.draw(words);
    const weight = BigInt.asUintN(64, k * 0x9e3779b97f4a7c15n) >> (k & 7n) >> 5n;
    found.push(index, ...halves(tree.set(index, weight)));
  }
  found.push(...tree.drawDistinct(4, words));
  for (let index = 0; index < 6; index += 1) found.push(...bits(tree.pmf(index)));
  return [...found, ...halves(tree.total), ...Array.from(tree.weights(), halves).flat()];
};
const streams = () => {
  const [words, [whole, even, odd]] = [rng(), [5, 5, 5].map((places) => new WeightedReservoir(places))];
  for (let i = 0; i < 200; i += 1) {
    const [weight, state] = [Math.imul(i, 0x9e3779b9) >>> i % 20, words.state];
    whole.offer(i, weight, words);
    (i % 2 === 0 ? even : odd).offer(i, weight, Pcg32.resume(state));
  }
  const parts = [...even.items(), ...odd.items()];
  even.merge(odd);
  assert.deepEqual(even.items(), whole.items());
  return [...parts, ...whole.items()];
};
const lights = () => {
  const [words, found, [one, two]] = [rng(), [], [0, 1].map(() => new microwarp.LightReservoir())];
  const held = (of) => found.push(of.item ?? 2 ** 32 - 1, of.count, ...bits([of.target, of.contribution]));
  for (let i = 0; i < 60; i += 1) {
    const target = i * 7 % 11 * Math.fround([1, 1e30, 1e-30][Math.floor(i / 7) % 3]);
    const of = i % 4 === 0 ? two : one;
    found.push(Number(of.offer(i, target, [0.5, 1e-20, 3e5][i % 3], words)));
    held(of);
  }
  for (const limit of [7, 1_000_000_000, 0]) {
    found.push(Number(two.absorb(one, 0.25, words)));
    held(two);
    two.normalise(5);
    held(two);
    one.cap(limit);
    held(one);
  }
  return found;
};
// Uniforms in range and out of it.
const PAIRS = [[0.25, 0.5], [0, 0], [0.9, 0.999], [NaN, 2]];
const successes = () => {
  const words = rng();
  return [new Binomial(100, 0.3), Binomial.fromRatio(1000, 1, 20)].flatMap((law) => [
    ...Array.from({ length: 20 }, () => law.draw(words)), ...law.fill(new Uint32Array(20), words),
    ...[0, 30, 99, 1001].flatMap((count) => bits(law.pmf(count))), law.count(2 ** 31),
  ]);
};
const accepted = (law) => {
  const words = rng();
  return Array.from({ length: 40 }, () => law.draw(words)).flatMap((point) => bits([point, law.pdf(point)]));
};
// Rounded at each step, as the host computes it.
const target = ([x, y]) => {
  const f = Math.fround;
  return f(1 / f(1 + f(f(x * x) + f(y * y))));
};
const chain = (step) => {
  const [states, words, moving] = [[], rng(), new Chain(target, [0.25, 0.5], step)];
  for (let i = 0; i < 32; i += 1) {
    const { acceptance } = moving.step(words);
    states.push(moving.state, acceptance);
  }
  return bits(states);
};
const points = (set) => [0, 1, 2, 3, 100, 101].flatMap((index) => Array.from(set.at(index).words(new Uint32Array(4), 4)));
const actual = {
  Normal: () => filled(new microwarp.Normal(10, 2)),
  NormalPair: () => filled(new microwarp.NormalPair([1, -1], 0.5)),
  Exponential: () => filled(microwarp.Exponential.fromRate(1.5)),
  ExponentialTail: () => filled(microwarp.ExponentialTail.fromRate(1.5)),
  Sphere: () => filled(new microwarp.Sphere()),
  Disk: () => filled(new microwarp.Disk()),
  Cdf: () => selections(new Cdf(weights)),
  Alias: () => selections(new Alias(weights)),
  Mixture: () => [
    [[[0, 1], [9, 0.1], [-3, 2]].map((of) => new microwarp.Normal(...of)), [0.3, 0, 1e-7]],
    [[new microwarp.Disk()], [7]],
    [[new microwarp.Sphere(), new microwarp.CosineHemisphere()], [1, 2]],
    [[microwarp.ExponentialTail.fromRate(1.5), microwarp.Exponential.fromRate(0.5)], [3, 1]],
    [Array.from({ length: 32 }, (_, i) => new microwarp.Interval(i, 40)), Float32Array.from({ length: 32 }, (_, i) => i * 5 % 7)],
    [[new microwarp.PiecewiseLinear1d(weights, -3, 5), new microwarp.Normal(1, 1)], [1, 1]],
    [[new microwarp.Hemisphere(), new microwarp.LatLongMap(cells, [3, 2])], [1, 5]],
    [[0, 0.9].map((low) => new microwarp.BoxSurface([low, low, low], [1, 2, 3])), [1e-3, 1]],
    [[new microwarp.Simplex2(), new microwarp.Simplex2()], [1, 2]],
  ].flatMap(([parts, weights]) => {
    const mixture = new microwarp.Mixture(parts, weights);
    const found = Array.from({ length: 16 }, (_, i) => {
      const x = mixture.draw(new Pcg32(42 + i, 54));
      const inverse = mixture.invert(x, i / 16);
      const [drawn, sampled] = [drawWithPdf(mixture, new Pcg32(42 + i, 54)), sampleWithPdf(mixture, inverse)];
      return bits([x, mixture.pdf(x), inverse, drawn.point, drawn.pdf, sampled.point, sampled.pdf]);
    });
    return [...found, [0, 1, 2].flatMap((part) => bits(mixture.pmf(part)))].flat();
  }),
  SumTree: changing,
  "SumTree of 64 bits": changing_wide,
  WeightedReservoir: streams,
  LightReservoir: lights,
  lamps: () => {
    const corners = [[-0.6, -0.5, 0.8], [0.7, -0.4, 0.9], [0.1, 0.8, 0.6]];
    return [
      new microwarp.VisibleSphere([0, 0, 0], [0, 3, 4], 0.5), new microwarp.VisibleSphere([1, 2, -2], [0.1, 0, 0], 3),
      new microwarp.SphericalTriangle([0, 0, 0], corners), new microwarp.SphericalRectangle([0, 0, 0], corners[0], [[1.2, 0.1, 0.1], [-0.1, 1, 0.2]]),
    ].flatMap((lamp) => {
      const words = rng();
      const seen = [...Array.from({ length: 4 }, () => lamp.drawLight(words)), ...PAIRS.map((u) => lamp.sampleLight(u))];
      return bits([lamp.density, ...seen.map(({ direction, distance, pdf, place }) => [direction, distance, pdf, place])]);
    });
  },
  reflections: () => {
    const alpha = [0.05, 0.8];
    const surface = new microwarp.Ggx(alpha);
    return [new microwarp.GgxVisible([0.6, 0, 0.8], alpha), microwarp.GgxVisible.bounded([0.5, -0.7, 0.1], alpha)].flatMap((gloss) => {
      const words = rng();
      const bounces = [...Array.from({ length: 4 }, () => gloss.drawReflection(words)), ...PAIRS.map((u) => gloss.reflect(u))];
      const figures = ({ normal, direction, pdf }) => [
        normal, direction, pdf, gloss.reflectedPdf(normal), gloss.unmasked(direction), gloss.visibility(direction), surface.distribution(normal),
        surface.g1(direction),
      ];
      return [...bits([...bounces.map(figures), gloss.g1]), ...with_densities(new microwarp.Reflected(gloss))];
    });
  },
  techniques: () => {
    const [words, counts, found] = [rng(), [1, 2 ** 20, 7], []];
    for (const densities of [[1, 3, 0.25], [3e38, 1e30, 1e38], [1e-38, 1e-44, 0], [NaN, Infinity, 1], [-1, 0, 0]]) {
      for (const own of [0, 1, 2]) found.push(microwarp.balanceHeuristic(counts, densities, own), microwarp.powerHeuristic(Uint32Array.from(counts), Float32Array.from(densities), own));
    }
    for (let i = 0; i < 8; i += 1) for (const chance of [0.25, 1e-5, 0.95, 1, 2, NaN, -1, 0]) found.push(microwarp.roulette(chance, words) ?? 0);
    return bits(found);
  },
  Binomial: successes,
  BinomialRejection: () => {
    const [law, words] = [new BinomialRejection(1_000_000, 0.3), rng()];
    return [...Array.from({ length: 40 }, () => law.draw(words)), ...[300_000, 0, 299_000].flatMap((count) => bits(law.pmf(count)))];
  },
  "discrete laws": () => {
    const [words, found] = [rng(), []];
    const draws = (law) => [...Array.from({ length: 20 }, () => law.draw(words)), ...law.fill(new Int32Array(20), words)].map((integer) => integer >>> 0);
    const ends = (law) => [0, 2 ** 31, 2 ** 32 - 1].map((word) => law.integer(word) >>> 0);
    for (const [centre, scale] of [[0.25, 3], [-1e6 - 0.5, 20]]) {
      const law = new microwarp.DiscreteGaussian(centre, scale);
      found.push(...draws(law), ...[0, -1_000_001].flatMap((integer) => bits(law.pmf(integer))), ...ends(law));
    }
    for (const law of [new microwarp.DiscreteLaplace(1e6), microwarp.DiscreteLaplace.fromRatio(5, 2)]) {
      found.push(...draws(law), ...[0, -3, -(2 ** 31)].flatMap((integer) => bits(law.pmf(integer))), ...ends(law));
    }
    return found;
  },
  Gamma: () => [new microwarp.Gamma(2.5, 4), new microwarp.Gamma(1e-3, 1), new microwarp.Gamma(1, 0.5), microwarp.Gamma.chiSquared(3)].flatMap((law) => {
    const words = rng();
    return [...accepted(law), ...Array.from({ length: 40 }, () => law.drawLn(words)).flatMap(bits)];
  }),
  Beta: () => {
    const [law, set] = [new microwarp.Beta(2, 5e-3), new Sobol(7)];
    return [...accepted(law), ...Array.from({ length: 100 }, () => law.draw(set)).flatMap(bits)];
  },
  Dirichlet: () => [
    [1, 0.1], [4, 2, 0.5], [1, 1e-3, 1e-3, 7], [100, 2, 3, 1e6, 1], Array(6).fill(0.5), Float32Array.of(1, 2, 3, 4, 5, 6, 7), Array(8).fill(1e-20),
  ].flatMap((shapes) => accepted(new microwarp.Dirichlet(shapes))),
  VonMises: () => [[1, 10], [-6, 1e-20], [3, 1e6], [0, 0]].flatMap((given) => accepted(new microwarp.VonMises(...given))),
  PiecewiseConstant1d: () => triples(new microwarp.PiecewiseConstant1d(weights, -3, 5)),
  PiecewiseLinear1d: () => triples(new microwarp.PiecewiseLinear1d(weights, -3, 5)),
  PiecewiseConstant2d: () => triples(new microwarp.PiecewiseConstant2d(cells, [3, 2], [0, 6], [-1, 1])),
  LatLongMap: () => triples(new microwarp.LatLongMap(cells, [3, 2])),
  "densities of tables": () => [
    new microwarp.PiecewiseConstant1d(weights, -3, 5), new microwarp.PiecewiseLinear1d(weights, -3, 5),
    new microwarp.PiecewiseConstant2d(cells, [3, 2], [0, 6], [-1, 1]), new microwarp.LatLongMap(cells, [3, 2]),
  ].flatMap(with_densities),
  Sobol: () => points(new Sobol(7)),
  ByPosition: () => points(new ByPosition(7, 9)),
  Strata: () => Array.from({ length: 6 }, (_, k) => [
    ...new Strata(3, 2).place(k, [0.25, 0.75]), new Strata(6).place(k, 0.25),
  ]).flatMap(bits),
  LatinHypercube: () => [0, 1, 2, 3, 58, 101].flatMap((index) => Array.from(new LatinHypercube(59, 7).at(index).words(new Uint32Array(4), 4))),
  Screen: () => [[0, 0], [7, 100], [639, 479]].flatMap(([x, y]) => {
    const pixel = new Screen(640, 480, 4, 7).pixel(x, y);
    return [0, 1, 15, 16, 100].flatMap((sample) => Array.from(pixel.at(sample).words(new Uint32Array(4), 4)));
  }),
  Frame: () => [[0, 0, 1], [0.6, -3, 0.1], [0, 0, -1e-30], [1e30, 2e30, -3e30]].flatMap((normal) => {
    const frame = new Frame(normal);
    return bits([...frame.toWorld([0.36, -0.48, 0.8]), ...frame.toLocal([0.36, -0.48, 0.8])]);
  }),
  Integers: () => {
    const [words, drawn] = [rng(), []];
    for (const n of [1, 2, 6, 52, 1000, 65537, 3 * 2 ** 29, 2 ** 32 - 1]) {
      const range = new Integers(-Math.floor(n / 2), Math.floor(n / 2));
      drawn.push(new Integers(0, n - 1).drawWide(words), range.drawWide(words) >>> 0, range.draw(words) >>> 0);
    }
    const most = 2n ** 64n - 1n;
    for (const [low, high] of [[0n, 5n], [7n, 1n << 40n], [0n, most], [most - 3n, most]]) {
      const range = new Integers(low, high);
      for (let i = 0; i < 10; i += 1) drawn.push(...halves(range.draw(words)));
    }
    return [...drawn, ...halves(new Integers(0n, most).draw(new Sobol(7).at(3)))];
  },
  integers: () => {
    const [words, drawn] = [rng(), []];
    for (const n of [1, 2, 6, 52, 1000, 65537, 3 * 2 ** 29, 2 ** 32 - 1]) {
      const half = Math.floor(n / 2);
      drawn.push(words.below(n), words.below(2 ** 32), words.range(-half, half) >>> 0, Number(words.chance(1 / n)), ...bits(words.uniform()));
    }
    drawn.push(...Array.from({ length: 200 }, () => words.range(1, 6)), ...Array.from({ length: 200 }, () => Number(words.chance(0.1))));
    return [...drawn, new Sobol(7).at(3).below(2 ** 32)];
  },
  // The first items, and the word behind those that were drawn.
  shuffle: () => [2, 12, 13, 52, 1000].flatMap((n) => {
    const words = rng();
    const order = words.shuffle(Array.from({ length: n }, (_, i) => i));
    return [...order.slice(0, 20), ...words.words(new Uint32Array(1))];
  }),
  "shuffle by points": () => [...new Sobol(7).at(3).shuffle(Uint8Array.from({ length: 30 }, (_, i) => i))],
  Permutation: () => [1, 16, 17, 1000, 2 ** 31 + 1, 2 ** 32 - 1].flatMap((n) => {
    const [order, last] = [new Permutation(n, 7), n - 1];
    return [0, last, Math.floor(last / 2)].flatMap((i) => [order.get(i), order.indexOf(i)]);
  }),
  "normal chain": () => chain({ normal: [0.5, 1] }),
  "box chain": () => chain({ box: [0.5, 0] }),
  "cube chain": () => chain({ box: [0.1, 0.2], cube: 0.25 }),
};
for (const [name, run] of Object.entries(runs)) {
  test(`${name} runs as on the host`, () => assert.deepEqual(actual[name](), run));
}
