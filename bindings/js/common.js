// What most programs need, with the smaller module within.

import { start } from "./core.js";
import { simd } from "./simd.js";
import { unpacked } from "./unpack.js";

const { packed } = await (simd ? import("./inlined-common-simd.js") : import("./inlined-common.js"));
start(await unpacked(packed), 1);

export * from "./common-lib.js";
