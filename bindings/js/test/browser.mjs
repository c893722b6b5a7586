// The package in headless Chromium: the page of docs/javascript.md, both entries in the page, and in workers one, and one of
// the smaller module.
//   node browser.mjs WEB     WEB is examples/web, which has the driver and the server

import { symlinkSync, writeFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

const [web] = process.argv.slice(2);
const { launch } = await import(pathToFileURL(`${web}/test/browser.mjs`));
const { serve } = await import(pathToFileURL(`${web}/serve.mjs`));

symlinkSync("node_modules/microwarp", "microwarp");
const expected = JSON.parse((await import("node:fs")).readFileSync("expected.json", "utf8")).runs.Normal;
const normals = (entry) => `(async () => {
  const { Normal, Pcg32 } = await import(${JSON.stringify(entry)});
  const filled = new Normal(10, 2).fill(new Float32Array(19), new Pcg32(42, 54));
  return Array.from(new Uint32Array(filled.buffer));
})()`;
for (const entry of ["index", "common-streaming"]) writeFileSync(`${entry}-worker.js`, `postMessage(await ${normals(`./microwarp/${entry}.js`)});`);
const worker = (entry) => `new Promise((done, failed) => {
  const worker = new Worker("./${entry}-worker.js", { type: "module" });
  worker.onmessage = ({ data }) => done(data);
  worker.onerror = ({ message }) => failed(new Error(message));
})`;

// A browser asks for an icon by itself.
const server = await serve(process.cwd(), { instead: { "favicon.ico": "" } });
const browser = await launch();
try {
  const page = await browser.open(server.url, { width: 400, height: 300 });
  const runs = {
    streaming: normals("./microwarp/streaming.js"),
    inlined: `${normals("./microwarp/index.js?other")}`,
    worker: worker("index"),
    common: worker("common-streaming"),
  };
  await page.until('document.title === "in the disk"');
  for (const [name, run] of Object.entries(runs)) {
    const got = await page.evaluate(run);
    if (JSON.stringify(got) !== JSON.stringify(expected)) throw new Error(`${name}: ${got}`);
  }
  if (page.problems.length > 0) throw new Error(page.problems.join("\n"));
  console.log(`chromium: ${Object.keys(runs).join(", ")} give the host's bits`);
} finally {
  await browser.close();
  server.close();
}
