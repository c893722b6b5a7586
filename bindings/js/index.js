// The package with its module within: nothing else is fetched but one of two files of it.

import { start } from "./core.js";
import { simd } from "./simd.js";
import { unpacked } from "./unpack.js";

const { packed } = await (simd ? import("./inlined-simd.js") : import("./inlined.js"));
start(await unpacked(packed), 2);

export * from "./lib.js";
