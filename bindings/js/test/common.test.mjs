// `microwarp/common`: a smaller module, which gives way to the one with everything where both are loaded.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test from "node:test";
import * as common from "microwarp/common";

const { runs } = JSON.parse(readFileSync(new URL("expected.json", import.meta.url)));
const { Alias, Cdf, Disk, Exponential, Normal, NormalPair, Pcg32, Sphere, Warp } = common;
const made = {
  Disk: () => new Disk(), Exponential: () => Exponential.fromRate(1.5),
  Interval: () => new common.Interval(-3, 5), Normal: () => new Normal(10, 2),
  NormalPair: () => new NormalPair([1, -1], 0.5), Sphere: () => new Sphere(), Triangle: () => new common.Triangle(),
};
const filled = (warp) => Array.from(new Uint32Array(warp.fill(new Float32Array(19 * warp.dimensions), new Pcg32(42, 54)).buffer));
// Of those that the host has run.
const runs_of = () => Object.fromEntries(Object.keys(made).filter((name) => name in runs).map((name) => [name, filled(made[name]())]));
const due = Object.fromEntries(Object.entries(runs).filter(([name]) => name in made));

test("every class has what it needs in the smaller module", () => {
  const classes = Object.entries(common).filter(([, value]) => value.prototype instanceof Warp);
  assert.deepEqual(classes.map(([name]) => name).sort(), Object.keys(made).sort());
  for (const [name, make] of Object.entries(made)) assert.ok(make().draw(new Pcg32(1)) !== undefined, name);
  assert.deepEqual(runs_of(), due);
});

test("one of many generators has its words, as in Rust and C", () => {
  // tests/uniforms/points/neighbours.rs
  const known = [
    [0x93d8a563, 0xb22cb017, 0x9f114892], [0x998a9383, 0xc04268ab, 0x7b4f30ef], [0xa765a3a5, 0xe9718413, 0xce781d5f],
  ];
  assert.deepEqual([0, 1, 2 ** 32 - 1].map((index) => [...Pcg32.at(42, index).words(new Uint32Array(3))]), known);
});

test("what is loaded goes on with the larger module, with the same bits", async () => {
  const sources = () => [new Pcg32(7, 1), new Pcg32(8, 1)];
  const [normal, disk, table, bins] = [new Normal(20, 0.5), new Disk(), new Cdf([1, 2, 3]), new Alias([1, 2, 3])];
  const drawn = ([one, other]) => [normal.draw(one), disk.draw(other), table.draw(other), bins.draw(one), normal.pdf(20), table.pmf(1)];
  const going = sources();
  const before = drawn(going);
  const everything = await import("microwarp");
  const after = drawn(going);
  const again = sources();
  assert.deepEqual([drawn(again), drawn(again)], [before, after]);
  assert.equal(everything.Normal, Normal);
  assert.equal(everything.SphericalPatch.fromTurns(0, 0.1, 0, 0.1).sample([0.5, 0.5]).length, 3);
  assert.deepEqual(runs_of(), due);
});
