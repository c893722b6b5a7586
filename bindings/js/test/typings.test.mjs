// What the typings and the page name is in the package: each `Class.member` in backticks, and each `new Class`.

import assert from "node:assert";
import { readFileSync, readdirSync } from "node:fs";
import test from "node:test";
import * as microwarp from "microwarp";

const folder = "node_modules/microwarp/";
const files = readdirSync(folder).filter((name) => name.endsWith(".d.ts")).map((name) => folder + name).concat("javascript.md");

// The names of a text that are not in the package.
function missing(text) {
  const named = Array.from(text.matchAll(/`(?:new )?([A-Z][A-Za-z0-9]+)(?:\.([a-z][A-Za-z0-9]*))?(?:\([^`]*)?`/g));
  const absent = ([, name, member]) => {
    const kind = microwarp[name] ?? globalThis[name];
    return kind === undefined || (member !== undefined && !(member in kind || member in kind.prototype));
  };
  // `dimensions` and the like are of the classes that extend Warp; those of objects are looked up there.
  return named.filter(absent).map(([code]) => code);
}

test("typings and page name what is there", () => {
  for (const file of files) assert.deepEqual(missing(readFileSync(file, "utf8")), [], file);
  assert.ok(files.length > 6);
});

test("a name that is not there is seen", () => {
  const wrong = "`Strata1d.draw`, `GgxVisible.reflectedPdfs`, `Oriented`, `new Frames`, `VisibleSphere.sampleSurface()`";
  assert.equal(missing(wrong).length, 5);
  assert.deepEqual(missing("`Exponential.fromRate`, `new Normal`, `Disk.dimensions`, `Warp.draw`, `Float32Array`"), []);
});
