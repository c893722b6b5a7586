// The package with its module as a file beside it, which a browser compiles while it arrives.

import { start } from "./core.js";
import { simd } from "./simd.js";

start(await WebAssembly.instantiateStreaming(fetch(
  simd ? new URL("./microwarp-simd.wasm", import.meta.url) : new URL("./microwarp.wasm", import.meta.url))), 2);

export * from "./lib.js";
