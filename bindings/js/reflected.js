// Directions into which the microfacets of a rough surface reflect a view: a table whose entries are the normals.

import { wrong } from "./core.js";
import { Warp, described, inside } from "./warp.js";
import { GgxVisible } from "./warps.js";

// As src/tables.rs has it.
const REFLECTED = 7;

export const Reflected = /*#__PURE__*/ described(class Reflected extends Warp {
  constructor(normals) {
    if (!(normals instanceof GgxVisible)) throw wrong("a GgxVisible", normals);
    super(inside(normals)[0], REFLECTED, [2, 3, 2], true);
    // Asked so that a module without reflections refuses them.
    normals.reflectedPdf([0, 0, 1]);
  }
}, 2, 3);
