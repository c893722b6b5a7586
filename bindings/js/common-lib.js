// What `microwarp/common` exports: what most programs need, with a smaller module. `build` makes that module of this list.

export { Disk, Exponential, Interval, Normal, NormalPair, Sphere, Triangle } from "./common-warps.js";
export { Warp } from "./warp.js";
export { Alias, Cdf } from "./table.js";
export { Pcg32 } from "./source.js";
