// The package beside d3-random, @stdlib/random, pure-rand and Math.random, in one run: nanoseconds a number, a point or an
// index, of filled arrays. Fails where a filled array is not so many times faster than the fastest of the others.
// At last the package's module with vectors beside the one without.
//   node bench.mjs, in a project with these packages: see `run`

import * as microwarp from "microwarp";
import * as d3 from "d3-random";
import { createRequire } from "node:module";
import { xoroshiro128plus } from "pure-rand/generator/xoroshiro128plus";

// The package as an engine without vectors takes it: a copy, which asks whether there are any.
const { validate } = WebAssembly;
WebAssembly.validate = () => false;
const scalar = await import("./scalar/index.js");
WebAssembly.validate = validate;

const require = createRequire(import.meta.url);
const stdlib = (name) => require(`@stdlib/random/base/${name}`);
const LEAST = 3;
const COUNT = 1 << 16;
const ROUNDS = 15;

const pure = xoroshiro128plus(42);
const pure_uniform = () => (pure.next() >>> 0) * 2 ** -32;
const random = Math.random;

// Fills an array by calls.
const called = (draw) => (array) => {
  for (let i = 0; i < array.length; i += 1) array[i] = draw();
};
const box_muller = (uniform) => (array) => {
  for (let i = 0; i < array.length; i += 2) {
    const [r, phi] = [Math.sqrt(-2 * Math.log(1 - uniform())), 2 * Math.PI * uniform()];
    array[i] = r * Math.cos(phi);
    array[i + 1] = r * Math.sin(phi);
  }
};
const sphere = (uniform) => (array) => {
  for (let i = 0; i < array.length; i += 3) {
    const [z, phi] = [1 - 2 * uniform(), 2 * Math.PI * uniform()];
    const r = Math.sqrt(1 - z * z);
    array[i] = r * Math.cos(phi);
    array[i + 1] = r * Math.sin(phi);
    array[i + 2] = z;
  }
};
const by_normals = (normal) => (array) => {
  for (let i = 0; i < array.length; i += 3) {
    const [x, y, z] = [normal(), normal(), normal()];
    const length = Math.hypot(x, y, z);
    array[i] = x / length;
    array[i + 1] = y / length;
    array[i + 2] = z / length;
  }
};
const weights = Array.from({ length: 64 }, (_, i) => 1 + (i * 37) % 64);
const sums = weights.map((sum => (weight) => (sum += weight))(0));
const weighted = (uniform) => (array) => {
  for (let i = 0; i < array.length; i += 1) {
    const at = uniform() * sums[63];
    let [low, high] = [0, 63];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (sums[middle] > at) high = middle;
      else low = middle + 1;
    }
    array[i] = low;
  }
};
// Vose's alias method in JavaScript.
const alias = (uniform) => {
  const [n, share] = [64, weights.map((weight) => (weight * 64) / sums[63])];
  const [threshold, other] = [new Float64Array(n).fill(1), new Uint32Array(n)];
  const [small, large] = [[], []];
  share.forEach((s, i) => (s < 1 ? small : large).push(i));
  while (small.length && large.length) {
    const [s, l] = [small.pop(), large.pop()];
    threshold[s] = share[s];
    other[s] = l;
    share[l] -= 1 - share[s];
    (share[l] < 1 ? small : large).push(l);
  }
  return (array) => {
    for (let i = 0; i < array.length; i += 1) {
      const place = uniform() * n;
      const bin = place | 0;
      array[i] = place - bin < threshold[bin] ? bin : other[bin];
    }
  };
};

// It returns an array of its own.
const stdlib_sample = (() => {
  const draw = require("@stdlib/random/sample").factory(weights.map((_, i) => i), { seed: 42 });
  const probs = weights.map((weight) => weight / sums[63]);
  return (array) => draw({ size: array.length, probs, replace: true });
})();

const rng = new microwarp.Pcg32(42, 54);
const filled = (warp) => (array) => warp.fill(array, rng);
const drawn = (warp) => called(() => warp.draw(rng));
const sampled = (warp) => called(() => warp.sample(random()));
const normal = new microwarp.Normal(0, 1);
const pair = new microwarp.NormalPair([0, 0], 1);
const exponential = microwarp.Exponential.fromRate(1);
const randn = d3.randomNormal(0, 1);
const improved = stdlib("improved-ziggurat").factory({ seed: 42 });

// Numbers in an element, the array, ours, and the others.
const contests = [
  ["normals", 1, new Float32Array(COUNT), {
    "Normal.fill": filled(normal), "NormalPair.fill": filled(pair),
    "Normal.draw": drawn(normal), "Normal.sample": sampled(normal),
  }, {
    "d3-random": called(randn), "@stdlib (improved ziggurat)": called(improved),
    "@stdlib (randn)": called(stdlib("randn").factory({ seed: 42 })),
    "pure-rand, Box-Muller": box_muller(pure_uniform), "Math.random, Box-Muller": box_muller(random),
  }],
  ["exponentials", 1, new Float32Array(COUNT), {
    "Exponential.fill": filled(exponential), "Exponential.draw": drawn(exponential),
    "Exponential.sample": sampled(exponential),
  }, {
    "d3-random": called(d3.randomExponential(1)),
    "@stdlib": called(stdlib("exponential").factory(1, { seed: 42 })),
    "pure-rand, logarithm": called(() => -Math.log1p(-pure_uniform())), "Math.random, logarithm": called(() => -Math.log1p(-random())),
  }],
  ["sphere points", 3, new Float32Array(3 * COUNT), { "Sphere.fill": filled(new microwarp.Sphere()) }, {
    "d3-random, three normals": by_normals(randn), "@stdlib, three normals": by_normals(improved),
    "pure-rand": sphere(pure_uniform), "Math.random": sphere(random),
  }],
  ["weighted choice of 64", 1, new Uint32Array(COUNT), {
    "Alias.fill": filled(new microwarp.Alias(weights)), "Cdf.fill": filled(new microwarp.Cdf(weights)),
  }, {
    "@stdlib (random/sample)": stdlib_sample, "pure-rand, alias": alias(pure_uniform),
    "Math.random, alias": alias(random), "Math.random, bisection": weighted(random),
  }],
];

// The fastest of several rounds, in which all take their turns.
const nanoseconds = (runs, array, each) => {
  const best = runs.map(() => Infinity);
  for (let round = 0; round < ROUNDS; round += 1) {
    runs.forEach((run, i) => {
      const began = performance.now();
      run(array);
      best[i] = Math.min(best[i], performance.now() - began);
    });
  }
  return best.map((milliseconds) => (milliseconds * 1e6) / (array.length / each));
};

// A table in Markdown; the last column is how many times longer it takes than the fastest of ours.
const slow = [];
let text = "";
for (const [title, each, array, ours, others] of contests) {
  const names = [...Object.keys(ours), ...Object.keys(others)];
  const times = nanoseconds([...Object.values(ours), ...Object.values(others)], array, each);
  const count = Object.keys(ours).length;
  const mine = Math.min(...times.slice(0, count));
  text += `\n| ${title} | ns | times |\n|---|--:|--:|\n`;
  names.forEach((name, i) => (text += `| ${i < count ? `\`${name}\`` : name} | ${times[i].toFixed(1)} | ${(times[i] / mine).toFixed(1)} |\n`));
  const ratio = Math.min(...times.slice(count)) / mine;
  if (!(ratio >= LEAST)) slow.push(`${title}: ${ratio.toFixed(1)} times`);
}

// The same warps of both modules, which have the same bits; and the two words that a point takes, which vectors do not draw
// sooner.
const of_both = (make, dimensions, numbers) => {
  const runs = [scalar, microwarp].map((module) => {
    const [warp, source] = [make(module), new module.Pcg32(42, 54)];
    return (array) => warp.fill(array, source);
  });
  return nanoseconds(runs, new numbers(dimensions * COUNT), dimensions);
};
text += "\n| filled | ns without vectors | ns with vectors | times |\n|---|--:|--:|--:|\n";
for (const [name, dimensions, make, numbers = Float32Array] of [
  ["Pcg32.words", 2, () => ({ fill: (words, source) => source.words(words) }), Uint32Array],
  ["Disk", 2, (m) => new m.Disk()],
  ["Sphere", 3, (m) => new m.Sphere()],
  ["CosineHemisphere", 3, (m) => new m.CosineHemisphere()],
  ["PhongLobe", 3, (m) => new m.PhongLobe(50)],
  ["Exponential", 1, (m) => m.Exponential.fromRate(1)],
  ["NormalPair", 2, (m) => new m.NormalPair([0, 0], 1)],
]) {
  const [without, vectors] = of_both(make, dimensions, numbers);
  text += `| \`${name}\` | ${without.toFixed(1)} | ${vectors.toFixed(1)} | ${(without / vectors).toFixed(1)} |\n`;
}

// One call at a time, whose results are summed: beside plain JavaScript.
const summed = (call) => (array) => {
  let sum = 0;
  for (let i = 0; i < array.length; i += 1) sum += call();
  array[0] = sum;
};
const round = ([x, y]) => Math.exp(-0.5 * (x * x + y * y));
const chain = new microwarp.Chain(round, [0, 0], { normal: [2, 2] });
// A chain by hand: normal steps of width 2.
const plain = { state: [0, 0], density: 1 };
const plain_step = () => {
  const proposed = [plain.state[0] + 2 * randn(), plain.state[1] + 2 * randn()];
  const density = round(proposed);
  if (random() * plain.density < density) Object.assign(plain, { state: proposed, density });
  return plain.state[0];
};
const discs = new microwarp.Disk();
const die = new microwarp.Cdf(weights);
const singles = [
  ["`Exponential.draw`", summed(() => exponential.draw(rng)), "-Math.log(1 - Math.random())", summed(() => -Math.log(1 - random()))],
  ["`Normal.draw`", summed(() => normal.draw(rng)), "d3-random", summed(randn)],
  ["`Cdf.draw` of 64", summed(() => die.draw(rng)), "bisection, Math.random", ((one) => summed(() => (weighted(random)(one), one[0])))([0])],
  ["`Disk.draw`", summed(() => discs.draw(rng)[0]), "polar, Math.random", summed(() => {
    const [r, phi] = [Math.sqrt(random()), 2 * Math.PI * random()];
    return [r * Math.cos(phi), r * Math.sin(phi)][0];
  })],
  ["`Chain.step`, two coordinates", summed(() => chain.step(rng).acceptance), "a chain by hand, d3-random", summed(plain_step)],
];
const in_turn = nanoseconds(singles.flatMap(([, ours, , other]) => [ours, other]), new Float64Array(COUNT), 1);
text += "\n| one at a time | ns | beside it | ns | ratio |\n|---|--:|---|--:|--:|\n";
singles.forEach(([name, , other], i) => {
  const [ours, theirs] = in_turn.slice(2 * i, 2 * i + 2);
  text += `| ${name} | ${ours.toFixed(1)} | ${other} | ${theirs.toFixed(1)} | ${(ours / theirs).toFixed(2)} |\n`;
});
console.log(text);
if (slow.length > 0) throw new Error(`not ${LEAST} times faster than the fastest of the others: ${slow.join("; ")}`);
