// A package that was built with the parts `exponential` and `disk` alone.

import assert from "node:assert/strict";
import { readFileSync, statSync } from "node:fs";
import { Cdf, Chain, Disk, Exponential, LightReservoir, Mixture, Pcg32, Sphere, roulette, sampleWithPdf } from "./smaller/index.js";

const { runs } = JSON.parse(readFileSync("expected.json"));
const filled = (warp) => Array.from(new Uint32Array(warp.fill(new Float32Array(19 * warp.dimensions), new Pcg32(42, 54)).buffer));
assert.deepEqual(filled(Exponential.fromRate(1.5)), runs.Exponential);
assert.deepEqual(filled(new Disk()), runs.Disk);
for (const made of [() => new Sphere(), () => new Cdf([1, 1]), () => new Chain((x) => 1, 0, { box: 1 }), () => sampleWithPdf(new Disk(), [0.5, 0.5]), () => new Mixture([new Disk()], [1]), () => new LightReservoir(), () => roulette(0.5, new Pcg32(1))]) {
  assert.throws(made, { name: "RangeError", message: "the module was built without this" });
}
const size = (folder) => statSync(`${folder}/microwarp-simd.wasm`).size;
assert.ok(size("smaller") * 8 < size("node_modules/microwarp"), `${size("smaller")} bytes`);
