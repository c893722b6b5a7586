// All that the package exports.

export * from "./warps.js";
export { Warp } from "./warp.js";
export { Alias, Cdf, LatLongMap, PiecewiseConstant1d, PiecewiseConstant2d, PiecewiseLinear1d } from "./table.js";
export { ByPosition, Pcg32, Sobol, Strata } from "./source.js";
export { Chain } from "./chain.js";
