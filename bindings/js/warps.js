// The warps and the reasons for refusals, by `cargo regenerate` from tests/golden/src/warps.rs and the documentation in src.
import { warp } from "./warp.js";

export const reasons = [
  "a parameter is NaN or infinite",
  "the lower bound is above the upper bound",
  "the domain has no extent, or too little for a finite density",
  "the domain is too large, or samples overflow their number format",
  "a parameter that must be positive is not",
  "a parameter that must not be negative is",
  "a parameter is outside its stated range",
  "the density has no finite integral over the domain",
  "a direction has no length",
  "there are no weights",
  "there are more weights than the table holds",
  "weight # is NaN or infinite",
  "weight # is negative",
  "every weight is zero",
  "weight # is too small beside the others to be reached",
  "the entries do not form a table",
];

export const Interval = /*#__PURE__*/ warp("Interval new11 decreasing11", 0, 0, 1, 1, 1);
export const Power = /*#__PURE__*/ warp("Power new111 decreasing111", 1, 2, 1, 1, 1);
export const PowerMax2 = /*#__PURE__*/ warp("PowerMax2 new", 2, 4, 2, 1, 2);
export const PowerMax3 = /*#__PURE__*/ warp("PowerMax3 new", 3, 5, 3, 1, 3);
export const PowerMax4 = /*#__PURE__*/ warp("PowerMax4 new", 4, 6, 4, 1, 4);
export const Exponential = /*#__PURE__*/ warp("Exponential fromRate1 fromMean1", 5, 7, 1, 1, 1);
export const ExponentialTail = /*#__PURE__*/ warp("ExponentialTail fromRate1 fromMean1", 6, 9, 1, 1, 2);
export const TruncatedExponential = /*#__PURE__*/ warp("TruncatedExponential fromRate11 fromMean11", 7, 11, 1, 1, 1);
export const EquiAngular = /*#__PURE__*/ warp("EquiAngular new111", 8, 13, 1, 1, 1);
export const Tent = /*#__PURE__*/ warp("Tent new1", 9, 14, 1, 1, 1);
export const Linear = /*#__PURE__*/ warp("Linear new11", 10, 15, 1, 1, 1);
export const Normal = /*#__PURE__*/ warp("Normal new11", 11, 16, 1, 1, 1);
export const NormalPair = /*#__PURE__*/ warp("NormalPair new21", 12, 17, 2, 2, 2);
export const TruncatedNormal = /*#__PURE__*/ warp("TruncatedNormal new1111 above111 below111", 13, 18, 1, 1, 1);
export const Cauchy = /*#__PURE__*/ warp("Cauchy new11", 14, 21, 1, 1, 1);
export const Laplace = /*#__PURE__*/ warp("Laplace new11", 15, 22, 1, 1, 1);
export const Logistic = /*#__PURE__*/ warp("Logistic new11", 16, 23, 1, 1, 1);
export const Gumbel = /*#__PURE__*/ warp("Gumbel new11", 17, 24, 1, 1, 1);
export const Rayleigh = /*#__PURE__*/ warp("Rayleigh new1", 18, 25, 1, 1, 1);
export const Weibull = /*#__PURE__*/ warp("Weibull new11", 19, 26, 1, 1, 1);
export const Pareto = /*#__PURE__*/ warp("Pareto new11", 20, 27, 1, 1, 1);
export const LogNormal = /*#__PURE__*/ warp("LogNormal new11", 21, 28, 1, 1, 1);
export const Disk = /*#__PURE__*/ warp("Disk new", 22, 29, 2, 2, 2);
export const DiskConcentric = /*#__PURE__*/ warp("DiskConcentric new", 23, 30, 2, 2, 2);
export const Triangle = /*#__PURE__*/ warp("Triangle new", 24, 31, 2, 3, 2);
export const TriangleOn2d = /*#__PURE__*/ warp("TriangleOn2d new6", 25, 32, 2, 2, 2);
export const TriangleOn3d = /*#__PURE__*/ warp("TriangleOn3d new9", 26, 33, 2, 3, 2);
export const Bilinear = /*#__PURE__*/ warp("Bilinear new4", 27, 34, 2, 2, 2);
export const Sphere = /*#__PURE__*/ warp("Sphere new", 28, 35, 2, 3, 2);
export const Hemisphere = /*#__PURE__*/ warp("Hemisphere new", 29, 36, 2, 3, 2);
export const CosineHemisphere = /*#__PURE__*/ warp("CosineHemisphere new", 30, 37, 2, 3, 2);
export const MalleyHemisphere = /*#__PURE__*/ warp("MalleyHemisphere new", 31, 38, 2, 3, 2);
export const PhongLobe = /*#__PURE__*/ warp("PhongLobe new1", 32, 39, 2, 3, 2);
export const HenyeyGreenstein = /*#__PURE__*/ warp("HenyeyGreenstein new1 fromOneMinusG1 fromOnePlusG1", 33, 40, 2, 3, 2);
export const VonMisesFisher = /*#__PURE__*/ warp("VonMisesFisher new1", 34, 43, 2, 3, 2);
export const Ggx = /*#__PURE__*/ warp("Ggx new2", 35, 44, 2, 3, 2);
export const GgxVisible = /*#__PURE__*/ warp("GgxVisible new32 bounded32", 36, 45, 2, 3, 2);
export const Cone = /*#__PURE__*/ warp("Cone fromOneMinusCos1 fromRadians1 fromSine1", 37, 47, 2, 3, 2);
export const VisibleSphere = /*#__PURE__*/ warp("VisibleSphere new331", 38, 50, 2, 3, 2);
export const SphericalPatch = /*#__PURE__*/ warp("SphericalPatch fromTurns1111", 39, 51, 2, 3, 2);
export const SphericalTriangle = /*#__PURE__*/ warp("SphericalTriangle new39", 40, 52, 2, 3, 2);
export const SphericalRectangle = /*#__PURE__*/ warp("SphericalRectangle new336", 41, 53, 2, 3, 2);
export const Aabb2d = /*#__PURE__*/ warp("Aabb2d new22", 42, 54, 2, 2, 2);
export const Aabb3d = /*#__PURE__*/ warp("Aabb3d new33", 43, 55, 3, 3, 3);
export const Annulus = /*#__PURE__*/ warp("Annulus new11 sector1111", 44, 56, 2, 2, 2);
export const Ball = /*#__PURE__*/ warp("Ball new", 45, 58, 3, 3, 3);
export const Rotation = /*#__PURE__*/ warp("Rotation new", 46, 59, 3, 4, 3);
export const RegularPolygon = /*#__PURE__*/ warp("RegularPolygon new1", 47, 60, 2, 2, 2);
export const Simplex2 = /*#__PURE__*/ warp("Simplex2 new", 48, 61, 2, 3, 2);
export const Simplex3 = /*#__PURE__*/ warp("Simplex3 new", 49, 62, 3, 4, 3);
export const Simplex4 = /*#__PURE__*/ warp("Simplex4 new", 50, 63, 4, 5, 4);
export const BoxSurface = /*#__PURE__*/ warp("BoxSurface new33", 51, 64, 2, 6, 2);
export const FrustumSurface = /*#__PURE__*/ warp("FrustumSurface new21 tube21", 52, 65, 2, 6, 2);
export const CapsuleSurface = /*#__PURE__*/ warp("CapsuleSurface new11", 53, 67, 2, 6, 2);
