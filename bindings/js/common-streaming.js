// What most programs need, with the smaller module as a file beside it.

import { start } from "./core.js";
import { simd } from "./simd.js";

start(await WebAssembly.instantiateStreaming(fetch(
  simd ? new URL("./microwarp-common-simd.wasm", import.meta.url) : new URL("./microwarp-common.wasm", import.meta.url))), 1);

export * from "./common-lib.js";
