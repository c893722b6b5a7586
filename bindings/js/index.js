// The package with its module within: nothing else is fetched but one of two files of it.

import { start } from "./core.js";
import { simd } from "./simd.js";

const { packed } = await (simd ? import("./inlined-simd.js") : import("./inlined.js"));
const bytes = new Blob([Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0))]);
const unpacked = new Response(bytes.stream().pipeThrough(new DecompressionStream("gzip")));
start(await WebAssembly.instantiate(await unpacked.arrayBuffer()));

export * from "./lib.js";
