// What a user downloads, in bytes: as it is, by gzip -9 and by brotli. Fails where something has grown by more than 3 %.
//   node sizes.mjs sizes.csv [--write]

import { readdirSync, readFileSync, statSync, writeFileSync } from "node:fs";
import { brotliCompressSync, gzipSync } from "node:zlib";

const [table, write] = process.argv.slice(2);
const folder = "node_modules/microwarp/";
const of = (...names) => {
  const files = names.map((name) => readFileSync(folder + name));
  const sum = (size) => files.reduce((total, file) => total + size(file), 0);
  return [sum((file) => file.length), sum((file) => gzipSync(file, { level: 9 }).length), sum((file) => brotliCompressSync(file).length)];
};
// The scripts that an entry loads, file by file as a server sends them.
const scripts = (...names) => {
  const more = names.flatMap((name) => Array.from(readFileSync(folder + name, "utf8").matchAll(/from ?"\.\/(.*?\.js)"/g), ([, file]) => file));
  return more.every((name) => names.includes(name)) ? names : scripts(...new Set([...names, ...more]));
};
const tarball = readdirSync(".").find((name) => name.endsWith(".tgz"));
const rows = {
  "module": of("microwarp.wasm"),
  "module with vectors": of("microwarp-simd.wasm"),
  "scripts": of(...scripts("streaming.js")),
  "streaming, without vectors": of(...scripts("streaming.js"), "microwarp.wasm"),
  "streaming, with vectors": of(...scripts("streaming.js"), "microwarp-simd.wasm"),
  "inlined, without vectors": of(...scripts("index.js"), "inlined.js"),
  "inlined, with vectors": of(...scripts("index.js"), "inlined-simd.js"),
  "common: module": of("microwarp-common.wasm"),
  "common: module with vectors": of("microwarp-common-simd.wasm"),
  "common: scripts": of(...scripts("common-streaming.js")),
  "common: streaming, without vectors": of(...scripts("common-streaming.js"), "microwarp-common.wasm"),
  "common: streaming, with vectors": of(...scripts("common-streaming.js"), "microwarp-common-simd.wasm"),
  "common: inlined, without vectors": of(...scripts("common.js"), "inlined-common.js"),
  "typings": of(...readdirSync(folder).filter((name) => name.endsWith(".d.ts"))),
};
const text = "what,bytes,gzip,brotli\n" + Object.entries(rows).map(([name, sizes]) => `"${name}",${sizes.join(",")}\n`).join("");
console.log(`${text}tarball: ${statSync(tarball).size} bytes`);
if (write === "--write") writeFileSync(table, text);

const recorded = readFileSync(table, "utf8").trim().split("\n").slice(1).map((row) => row.match(/^"(.*)",(\d+),(\d+),(\d+)$/).slice(1));
const grown = (factor) => recorded.filter(([name, ...sizes]) => sizes.some((size, i) => !(rows[name][i] * factor <= size * 1.03)));
if (recorded.length !== Object.keys(rows).length) throw new Error("sizes.csv has other rows");
if (grown(1).length > 0) throw new Error(`grown: ${grown(1).join("; ")}`);
// The check sees growth.
if (grown(1.1).length !== recorded.length) throw new Error("growth passes");
