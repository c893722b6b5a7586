// What the page shows: for each way to make something of the package a line with its parameters, `name: start in least..most
// by step`, and a function of them where they are not what the constructor takes. The test holds the list to the classes of the
// package.

const location = "location: 0 in -10..10, scale: 1 in 0..5";
const normal = "mean: 0 in -10..10, std dev: 1 in 0..5";
const ends = "low: -1 in -20..20, high: 2 in -20..20";
const weights = [3, 1, 0, 5, 2, 4].map((weight, k) => `weight ${k}: ${weight} in 0..10 by 0.1`).join(", ");
const place = "x: 0 in -2..2, y: 0 in -2..2, height: 1 in 0.01..5";
const frustum = "lower: 1 in 0..5, upper: 0.5 in 0..5, height: 2 in 0..10";
const together = (...values) => [values];
const about = (...values) => [values.slice(0, 2), ...values.slice(2)];
const view = (turns, roughness) => [[Math.sin(2 * Math.PI * turns), 0, Math.cos(2 * Math.PI * turns)], [roughness, roughness]];
const viewed = "view in turns: 0.15 in 0..0.25, roughness: 0.3 in 0.001..1";

// e^(3 (cos 2π(x + y) + cos 2π(x − 2y) − 2)), whose period is 1 in both coordinates.
const hills = ([x, y]) => Math.exp(3 * (Math.cos(2 * Math.PI * (x + y)) + Math.cos(2 * Math.PI * (x - 2 * y)) - 2));
// Clouds of a brightness with a sun among them, and a dark column.
const sky = (c, sun) => [[1, c, 1, 0, c, 1, c, c, 1, 0, sun, 1, 1, c, c, 0, 1, 1, 1, 1, c, 0, c, c], [6, 4]];

const FAMILIES = {
  line: ["Line", [
    ["Interval", "from: -3 in -10..10, to: 5 in -10..10"],
    ["Interval.decreasing", "from: -3 in -10..10, to: 5 in -10..10"],
    ["Power", "exponent: 2.5 in -6..10, from: 0 in 0..10, to: 1 in 0..10"],
    ["Power.decreasing", "exponent: -1 in -6..10, from: 1 in 0..10, to: 10 in 0..10"],
    ["PowerMax2"], ["PowerMax3"], ["PowerMax4"],
    ["Exponential.fromRate", "rate: 1 in 0..10"],
    ["ExponentialTail.fromRate", "rate: 1 in 0..10"],
    ["TruncatedExponential.fromRate", "rate: 2 in -20..20, length: 3 in 0..10"],
    ["EquiAngular", "distance: 2 in 0..10 by 0.1, low: -5 in -20..20, high: 15 in -20..20"],
    ["Tent", "radius: 1 in 0..5"],
    ["Linear", "density at 0: 1 in 0..10, density at 1: 3 in 0..10"],
    ["Normal", normal],
    ["TruncatedNormal", `${normal}, ${ends}`],
    ["StudentT", `degrees: 5 in 0.3..50, ${location}`],
    ["Cauchy", location], ["Laplace", location], ["Logistic", location],
    ["TruncatedLogistic", `${location}, ${ends}`],
    ["Gumbel", location],
    ["Rayleigh", "scale: 1 in 0..5"],
    ["Weibull", "scale: 1 in 0..5, shape: 1.5 in 0..10"],
    ["Pareto", "minimum: 1 in 0..5, shape: 2 in 0..10"],
    ["LogNormal", "mean of log: 0 in -5..5, std dev of log: 0.5 in 0..5"],
    ["Gamma", "shape: 2.5 in 0..10, scale: 1 in 0..5"],
    ["VonMises", "mean: 1 in -6..6, concentration: 5 in 0..50"],
    ["Mixture", "first mean: -2 in -10..10, second mean: 2 in -10..10, first weight: 1 in 0..10, second weight: 2 in 0..10",
      (a, b, ...shares) => ({ Normal }) => [[new Normal(a, 1), new Normal(b, 1)], shares]],
  ]],
  plane: ["Plane", [
    ["Disk"], ["DiskConcentric"], ["Triangle"], ["Simplex2"],
    ["NormalPair", "mean x: 0 in -10..10, mean y: 0 in -10..10, std dev: 1 in 0..5", about],
    ["StudentPair", "degrees: 3 in 0.3..50, x: 0 in -10..10, y: 0 in -10..10, scale: 1 in 0..5", (n, x, y, s) => [n, [x, y], s]],
    ["MultivariateNormal2", "deviation x: 2 in 0..4, deviation y: 1 in 0..4, correlation: 0.8 in -1..1",
      (x, y, c) => [[0, 0], [[x * x, c * x * y], [c * x * y, y * y]]]],
    ["TriangleOn2d", "a x: 0 in -4..4, a y: 0 in -4..4, b x: 4 in -4..4, b y: 0 in -4..4, c x: 1 in -4..4, c y: 3 in -4..4", together],
    ["Bilinear", "at 00: 1 in 0..4, at 10: 3 in 0..4, at 01: 2 in 0..4, at 11: 0 in 0..4", together],
    ["Aabb2d", "left: -1 in -10..10, bottom: 2 in -10..10, right: 1 in -10..10, top: 2.5 in -10..10", (a, b, c, d) => [[a, b], [c, d]]],
    ["Annulus.sector", "inner: 1 in 0..10, outer: 2 in 0..10, from in turns: 0 in -1..1, to in turns: 1 in -1..2"],
    ["RegularPolygon", "corners: 6 in 3..20 by 1"],
  ]],
  directions: ["Directions", [
    ["Sphere"], ["Hemisphere"], ["CosineHemisphere"], ["MalleyHemisphere"],
    ["PhongLobe", "exponent: 50 in 0..200 by 0.5"],
    ["HenyeyGreenstein", "asymmetry: 0.8 in -0.99..0.99"],
    ["VonMisesFisher", "concentration: 10 in 0..200 by 0.5"],
    ["Ggx", "roughness along x: 0.1 in 0.001..1, roughness along y: 0.5 in 0.001..1", together],
    ["GgxVisible", viewed, view], ["GgxVisible.bounded", viewed, view],
    ["Reflected", viewed, (...of) => ({ GgxVisible }) => [new GgxVisible(...view(...of))]],
    ["Cone.fromRadians", "half angle in rad: 0.6 in 0..3.14"],
    ["VisibleSphere", "distance: 2 in 0..10, radius: 1 in 0..10", (d, radius) => [[0, 0, 0], [0, 0.6 * d, 0.8 * d], radius]],
    ["SphericalPatch.fromTurns", "theta from in turns: 0 in 0..0.5, theta to in turns: 0.25 in 0..0.5, phi from in turns: 0 in -1..1, phi to in turns: 0.25 in -1..1"],
    ["SphericalTriangle", place, (x, y, h) => [[x, y, 0], [[1, 0, h], [-0.5, 0.9, h], [-0.5, -0.9, h]]]],
    ["SphericalRectangle", place, (x, y, h) => [[x, y, 0], [-0.5, -0.7, h], [[1, 0, 0], [0, 1.4, 0]]]],
  ]],
  space: ["Space", [
    ["Ball"], ["Rotation"], ["Simplex3"], ["Simplex4"],
    ["Aabb3d", "width: 2 in 0..10, depth: 1 in 0..10, height: 1 in 0..10", (...size) => [[0, 0, 0], size]],
    ["BoxSurface", "width: 2 in 0..10, depth: 1 in 0..10, height: 1 in 0..10", (...size) => [[0, 0, 0], size]],
    ["FrustumSurface", frustum, about], ["FrustumSurface.tube", frustum, about],
    ["CapsuleSurface", "height: 1 in 0..10, radius: 0.5 in 0..5"],
    ["TriangleOn3d", "x: 1 in 0..4, y: 2 in 0..4, z: 3 in 0..4", (x, y, z) => [[[x, 0, 0], [0, y, 0], [0, 0, z]]]],
    ["MultivariateNormal3", "deviation x: 2 in 0..4, deviation y: 1 in 0..4, deviation z: 0.5 in 0..4",
      (x, y, z) => [[0, 0, 0], [[x * x, 0, 0], [0, y * y, 0], [0, 0, z * z]]]],
  ]],
  tables: ["Tables", [
    ["Cdf", weights, together], ["Alias", weights, together], ["SumTree", weights, (...of) => [of.map(Math.floor)]],
    ["Binomial", "trials: 10 in 1..50 by 1, probability: 0.3 in 0..1"],
    ["PiecewiseConstant1d", weights, (...of) => [of, 0, 1]], ["PiecewiseLinear1d", weights, (...of) => [of, 0, 1]],
    ["PiecewiseConstant2d", "clouds: 3 in 0..10 by 0.1, sun: 30 in 0..100 by 0.5", (...of) => [...sky(...of), [0, 1.5], [0, 1]]],
    ["LatLongMap", "clouds: 3 in 0..10 by 0.1, sun: 30 in 0..100 by 0.5", sky],
  ]],
  chains: ["Chains", [
    ["Chain", "step deviation: 0.1 in 0..0.5 by 0.005, large steps: 0.2 in 0..1", (d, cube) => [hills, [0, 0], { normal: [d, d], cube }]],
  ]],
};

const parameter = (text) => {
  const [, label, value, min, max, step = "0.01"] = /^(.+): (\S+) in (\S+?)\.\.(\S+)(?: by (\S+))?$/.exec(text);
  return { label, value: Number(value), min, max, step };
};

// The families with their subjects: each with its class, and with how it is made.
export const families_of = (microwarp) => Object.entries(FAMILIES).map(([name, [label, subjects]]) => ({
  name, label, subjects: subjects.map(([subject, list = "", given = (...values) => values]) => {
    const [of, maker] = subject.split(".");
    const make = (values) => {
      const all = given(...values);
      const parameters = typeof all === "function" ? all(microwarp) : all;
      return maker ? microwarp[of][maker](...parameters) : new microwarp[of](...parameters);
    };
    return { name: subject, of, make, parameters: list ? list.split(", ").map(parameter) : [] };
  }),
}));
