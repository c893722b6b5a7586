export { Disk, Exponential, Interval, Normal, NormalPair, Sphere, Triangle } from "./warps.js";
export { Warp } from "./warp.js";
export type { Vector2, Vector3 } from "./warp.js";
export { Pcg32 } from "./source.js";
export type { Items, Source } from "./source.js";
export { Alias, Cdf } from "./table.js";
export type { Indices, Selection } from "./table.js";
