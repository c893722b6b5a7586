// All that the package exports.

export * from "./warps.js";
export { Warp } from "./warp.js";
export { drawWithPdf, fillWithPdf, mapWithPdf, sampleWithPdf } from "./density.js";
export { Alias, Cdf } from "./table.js";
export { Binomial, BinomialRejection, DiscreteGaussian, DiscreteLaplace } from "./counts.js";
export { Beta, Dirichlet, Gamma, VonMises } from "./rejection.js";
export { Integers } from "./integers.js";
export { Mixture } from "./mixture.js";
export { SumTree } from "./tree.js";
export { WeightedReservoir } from "./reservoir.js";
export { LightReservoir, balanceHeuristic, powerHeuristic, roulette } from "./lights.js";
export { Reflected } from "./reflected.js";
export { LatLongMap, PiecewiseConstant1d, PiecewiseConstant2d, PiecewiseLinear1d } from "./pieces.js";
export { Pcg32 } from "./source.js";
export { ByPosition, LatinHypercube, Permutation, Screen, Sobol, Strata } from "./sets.js";
export { Frame } from "./frame.js";
export { Chain } from "./chain.js";
