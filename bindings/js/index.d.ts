export * from "./warps.js";
export { Warp } from "./warp.js";
export type { Vector2, Vector3 } from "./warp.js";
export { ByPosition, Pcg32, Permutation, Sobol, Strata } from "./source.js";
export type { Items, Points, Source } from "./source.js";
export { Alias, Cdf, LatLongMap, PiecewiseConstant1d, PiecewiseConstant2d, PiecewiseLinear1d } from "./table.js";
export type { Indices, Selection } from "./table.js";
export { Chain } from "./chain.js";
export type { Saved, Step, Transition } from "./chain.js";
