// Runs the snippets of a page as they stand: each of `js` as a module, which must print; one of `js worker` as a worker would.
// Those of `html` are written to a file for a browser, and all others to `typed`, for tsc. A snippet that is spoiled must fail.

import { execFileSync } from "node:child_process";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";

const page = readFileSync(process.argv[2], "utf8");
const of = (kind) => Array.from(page.matchAll(new RegExp(`^\`\`\`${kind}\n(.*?)^\`\`\`$`, "gms")), ([, text]) => text);
const run = (text) => execFileSync(process.execPath, ["--input-type=module", "--eval", text], { encoding: "utf8", stdio: "pipe" });

const snippets = of("js");
if (snippets.length < 5) throw new Error(`only ${snippets.length} snippets`);
for (const text of snippets) {
  if (run(text).trim() === "") throw new Error(`prints nothing:\n${text}`);
  let passed = true;
  try {
    run(text.replace("microwarp", "microwarp-that-is-not"));
  } catch {
    passed = false;
  }
  if (passed) throw new Error("a snippet without its package passes");
}
const [worker] = of("js worker");
const asked = `globalThis.self = { postMessage: (points) => console.log(points.length) };\n${worker}\nself.onmessage({ data: 3 });`;
if (run(asked).trim() !== "1000") throw new Error("the worker does not answer");
mkdirSync("typed");
const typed = ["js", "js worker", "js page", "js config", "ts"].flatMap(of);
typed.forEach((text, i) => writeFileSync(`typed/snippet${i}.ts`, text));
writeFileSync("index.html", of("html")[0]);
mkdirSync("wrong");
writeFileSync("wrong/wrong.ts", `import { Chain, Disk, Exponential, GgxVisible, Integers, LightReservoir, Mixture, Normal, Pcg32, Reflected, SumTree, drawWithPdf, sampleWithPdf } from "microwarp";
new Normal("0", 1); // wrong
sampleWithPdf(new Disk(), 0.5); // wrong
drawWithPdf(Disk, new Pcg32()); // wrong
new Mixture([new Disk(), new Normal(0, 1)], [1, 1]); // wrong
new LightReservoir<string>().offer(1, 1, 1, new Pcg32()); // wrong
new GgxVisible([0, 0, 1], [1, 1]).reflect(0.5); // wrong
new Reflected(new Disk()); // wrong
new Exponential(1); // wrong
new Disk().sample(0.5); // wrong
new Disk().fill([0, 0], new Pcg32()); // wrong
new Chain((x) => x, 0, { normal: [1, 1] }); // wrong
new Chain(() => 1, [1, 1], { box: [1] }); // wrong
new Chain((x) => x, 0, {}); // wrong
new SumTree([1n, 2n]).set(0, 1); // wrong
new Integers(0n, 1); // wrong
export const name: string = new Normal(0, 1).draw(new Pcg32()); // wrong
`);
writeFileSync("typed/chains.ts", `import { Chain, Disk, Integers, type Lamp, LightReservoir, type LightSample, Mixture, Pcg32, type Sample, SphericalTriangle, VisibleSphere, type Warp, type Saved, roulette, SumTree, WeightedReservoir, drawWithPdf } from "microwarp";
const [rng, dimensions] = [new Pcg32(7), 20];
export const one: number = new Chain((x) => Math.exp(-x * x), 0, { normal: 1 }).step(rng).from;
const two = new Chain(([x, y]) => x * y, [1, 1], { box: [1, 1], cube: 0.25 });
const kept: Saved<[number, number]> = two.save();
export const sum: number = two.resume(kept).state[0] + two.step(rng).proposed[1];
const zeros: number[] = new Array<number>(dimensions).fill(0);
export const many: Chain<number[]> = new Chain((x) => x.length, zeros, { normal: zeros });
const tree: SumTree = new SumTree([3, 0, 5]);
export const before: number = tree.set(1, 8) + tree.weights()[0]! + new Integers(1, 6).draw(rng);
export const wide: bigint = new SumTree(BigUint64Array.of(3n)).total + new Integers(0n, 9n).drawWide(rng);
const words: SumTree<bigint> = new SumTree([3n]);
export const all: [BigUint64Array, Uint32Array] = [words.weights(), tree.weights()];
const reservoir = new WeightedReservoir<string>(2);
reservoir.offer("a", 1, rng);
export const names: string[] = reservoir.items();
export const seen: Sample<[number, number]> = drawWithPdf(new Disk(), rng);
const mixture = new Mixture([new Disk(), new Disk()], [1, 2]);
export const any: Warp<[number, number], [number, number]> = mixture;
const lamps: (Lamp & Warp<[number, number, number], [number, number]>)[] = [
  new VisibleSphere([0, 0, 0], [0, 0, 5], 1), new SphericalTriangle([0, 0, 0], [[0, 0, 1], [1, 0, 1], [0, 1, 1]]),
];
export const place: LightSample = lamps[0]!.drawLight(rng);
const lights = new LightReservoir<string>();
lights.offer("a", 1, place.pdf, rng);
export const light: string | undefined = lights.item;
export const on: number = roulette(0.5, rng) ?? lamps[1]!.density;
export const inverse: [number, number] = mixture.invert(mixture.draw(rng), rng.uniform());
`);
console.log(`${snippets.length} snippets run`);
