// What the page shows: each subject by the name that the module knows it by, with its tiers, parameters, its truth in
// f64, and how its error is counted. How it is drawn is said by `view`; what is stated comes from the module.

import * as line from "../truth/line.mjs";
import * as plane from "../truth/plane.mjs";
import * as directions from "../truth/directions.mjs";
import * as other from "../truth/selections.mjs";
import * as count from "./counting.mjs";

const FLOAT = ["libm", "poly"];
const INTEGER = ["fine", "coarse", "compact"];
const BOTH = [...FLOAT, ...INTEGER];
const EXACT = ["exact"];
const is_float = (tier) => FLOAT.includes(tier);

// A parameter: its name, what it begins as, the range of its slider. The box beside the slider takes any number.
const number = (label, value, min, max, step = 0.01) => ({ label, value, min, max, step });
const weights = (values, most = 10, step = 0.1) => values.map((value, k) => number(`weight ${k}`, value, 0, most, step));
const budget = (value) => number("budget, tries", value, 0, 128, 1);
const none = () => [];

const subject = (name, view, tiers, words, parameters, truth, counting, more = {}) => ({
  name, label: name, view, tiers, words, parameters, truth, counting, plans: true, ...more,
});

const largest = (p) => Math.max(...p.map(Math.abs));
// A power law is drawn finest at the end where its density may be 0 or infinite: the lower one from n = −1 up.
const power_draws = (increasing) => (words, [n]) => (increasing === n >= -1 ? count.deep : count.deep_down)(words);

const on_line = [
  subject("Interval", "line", BOTH, 1, () => [number("from", -3, -10, 10), number("to", 5, -10, 10)],
    ([a, b]) => line.interval(a, b), count.warp("Interval", { scale: largest, integer: count.steps })),
  subject("IntervalDecreasing", "line", FLOAT, 1, () => [number("from", -3, -10, 10), number("to", 5, -10, 10)],
    ([a, b]) => line.interval(a, b, false), count.warp("Interval", { scale: largest }),
    { label: "Interval::decreasing", documented: "Interval" }),
  subject("Power", "line", FLOAT, 1, () => [number("exponent", 2.5, -6, 10), number("from", 0, 0, 10), number("to", 1, 0, 10)],
    ([n, a, b]) => line.power(n, a, b), count.warp("Power"), { uniforms: power_draws(true) }),
  subject("PowerDecreasing", "line", FLOAT, 1, () => [number("exponent", -1, -6, 10), number("from", 1, 0, 10), number("to", 10, 0, 10)],
    ([n, a, b]) => line.power(n, a, b, false), count.warp("Power"),
    { label: "Power::decreasing", documented: "Power", uniforms: power_draws(false) }),
  subject("PowerMax", "line", FLOAT, 4, none, line.power_max, count.warp("PowerMax"), { label: "PowerMax<4>", uniforms: count.deep }),
  subject("Exponential", "line", BOTH, 1, (tier) => [is_float(tier) ? number("rate", 1, 0, 10) : number("mean", 1, 0, 10)],
    ([a], tier) => line.exponential(is_float(tier) ? a : 1 / a),
    count.warp("Exponential", { integer: count.of_length(([mean]) => mean, "of the mean") })),
  subject("ExponentialTail", "line", FLOAT, 1, () => [number("rate", 1, 0, 10)],
    ([rate]) => line.exponential_tail(rate), count.warp("ExponentialTail"), { words: 2, uniforms: count.full }),
  subject("StandardExponential", "line", INTEGER, 1, none, () => line.exponential(1), count.warp("StandardExponential")),
  subject("TruncatedExponential", "line", BOTH, 1,
    (tier) => [is_float(tier) ? number("rate", 2, -20, 20) : number("mean", 0.5, 0, 10), number("length", 3, 0, 10)],
    ([a, length], tier) => line.truncated_exponential(is_float(tier) ? a : 1 / a, length),
    count.warp("TruncatedExponential", { integer: count.of_length(([mean, length]) => Math.min(mean, length), "of mean or length", { words: 1 }) }),
    { uniforms: count.deep }),
  subject("Tent", "line", BOTH, 1, () => [number("radius", 1, 0, 5)],
    ([r]) => line.tent(r), count.warp("Tent", { integer: count.of_length(([r]) => r, "of the radius", { uniforms: count.centred }) }),
    { uniforms: count.folded }),
  subject("Linear", "line", FLOAT, 1, () => [number("density at 0", 1, 0, 10), number("density at 1", 3, 0, 10)],
    ([a, b]) => line.linear(a, b), count.warp("Linear"), { uniforms: count.deep }),
  subject("Normal", "line", FLOAT, 1, () => [number("mean", 0, -10, 10), number("deviation", 1, 0, 5)],
    ([mean, deviation]) => line.normal(mean, deviation),
    count.warp("Normal", { scale: ([mean], [x]) => Math.max(Math.abs(mean), Math.abs(x - mean)) }), { uniforms: count.folded }),
  subject("Inversion", "line", FLOAT, 1, none, line.rising, count.warp("Inversion"), { label: "Inversion, ½ + x", uniforms: count.deep }),
  subject("Transform", "line", FLOAT, 1, none, line.sine, count.warp("Transform"), { label: "Transform, sin x", uniforms: count.deep }),
];

const corner = (value) => number("", value, -4, 4);
const in_plane = [
  subject("Disk", "plane", BOTH, 2, none, plane.disk, count.warp("Disk")),
  subject("DiskConcentric", "plane", FLOAT, 2, none, plane.disk_concentric, count.warp("DiskConcentric")),
  subject("FloatDisk", "plane", INTEGER, 2, none, plane.disk, count.warp("Disk", { further: 6e-8 }), { label: "Float<Disk>", documented: "Float" }),
  subject("Triangle", "plane", BOTH, 2, none, plane.triangle, count.warp("Triangle")),
  subject("TriangleOn", "plane", BOTH, 2,
    () => [0, 0, 4, 0, 1, 3].map((value, k) => ({ ...corner(value), label: `${"ABC"[k >> 1]}, ${"xy"[k & 1]}` })),
    (p) => plane.triangle_on(p), count.warp("TriangleOn", { scale: largest, integer: count.of_extent })),
  subject("NormalPair", "plane", BOTH, 2, () => [number("mean x", 0, -10, 10), number("mean y", 0, -10, 10), number("deviation", 1, 0, 5)],
    ([x, y, deviation]) => plane.normal_pair(x, y, deviation),
    count.warp("NormalPair", { scale: ([x, y, deviation]) => largest([x, y, 5.77 * deviation]), integer: count.of_deviation })),
  subject("StandardNormalPair", "plane", INTEGER, 2, none, () => plane.normal_pair(0, 0, 1),
    count.warp("StandardNormalPair", { integer: count.distance })),
  subject("Aabb", "plane", FLOAT, 2, () => [number("left", -1, -10, 10), number("right", 1, -10, 10), number("bottom", 2, -10, 10), number("top", 2.5, -10, 10)],
    (p) => plane.box(...p), count.warp("Aabb", { scale: largest, variables: (p) => ({ n: 2, m: largest(p) }) })),
  subject("MarginalConditional", "plane", FLOAT, 2, none, plane.below_diagonal, count.warp("MarginalConditional"),
    { uniforms: ([first, second]) => [...count.deep([first]), ...count.grid([second])] }),
];

const over_directions = [
  subject("Sphere", "sphere", BOTH, 2, none, directions.sphere, count.warp("Sphere")),
  subject("Hemisphere", "sphere", BOTH, 2, none, directions.hemisphere, count.warp("Hemisphere")),
  subject("CosineHemisphere", "sphere", BOTH, 2, none, directions.cosine_hemisphere, count.warp("CosineHemisphere")),
  subject("MalleyHemisphere", "sphere", FLOAT, 2, none, directions.malley, count.warp("MalleyHemisphere"), { uniforms: count.open }),
  subject("PhongLobe", "sphere", BOTH, 2, () => [number("exponent", 50, 0, 200, 0.5)], ([n]) => directions.phong(n),
    count.warp("PhongLobe", { variables: ([n]) => ({ w: Math.min(1, Math.sqrt(2 / (n + 1))) }) })),
  subject("Cone", "sphere", BOTH, 2,
    (tier) => [is_float(tier) ? number("half angle, rad", 0.6, 0, 3.14) : number("half angle, turns", 0.1, 0, 0.5, 0.001)],
    ([angle], tier) => directions.cone(is_float(tier) ? angle : angle * 2 * Math.PI),
    count.warp("Cone", { variables: ([turns]) => ({ w: Math.sin(2 * Math.PI * Math.min(turns, 0.25)) }) })),
  subject("SphericalPatch", "sphere", FLOAT, 2,
    () => [number("θ from, turns", 0, 0, 0.5, 0.001), number("θ to, turns", 0.25, 0, 0.5, 0.001), number("φ from, turns", 0, -1, 1, 0.001), number("φ to, turns", 0.25, -1, 1, 0.001)],
    (p) => directions.patch(...p), count.warp("SphericalPatch")),
  subject("Oriented", "sphere", FLOAT, 2, () => [number("normal x", 1, -3, 3), number("normal y", 2, -3, 3), number("normal z", 3, -3, 3)],
    (p) => directions.turned_cosine(p), count.warp("Oriented"), { label: "Oriented cosine" }),
];

const SIX = [3, 1, 0, 5, 2, 4];
const tables = [
  subject("Cdf", "bars", EXACT, 1, () => weights(SIX), other.shares, count.table({ searched: true })),
  subject("Alias", "bars", EXACT, 1, () => weights(SIX), other.shares, count.table({})),
  subject("SelectOnce", "bars", EXACT, 1, () => weights(SIX), other.shares, count.selection({ searched: true }), { label: "select_once", documented: "select_once" }),
  subject("Reservoir", "bars", EXACT, 0, () => weights(SIX), other.shares, count.selection({}), { plans: false }),
  subject("PiecewiseConstant1d", "line", EXACT, 1, () => weights(SIX), (p) => line.histogram(p),
    count.warp("PiecewiseConstant1d", { scale: () => 1 }), { uniforms: count.word }),
  subject("PiecewiseConstant2d", "plane", EXACT, 2, () => [number("clouds", 3, 0, 10, 0.1), number("sun", 30, 0, 100, 0.5)],
    ([clouds, sun]) => plane.picture(other.sky(clouds, sun), 1.5, 1), count.warp("PiecewiseConstant2d", { scale: () => 1.5 }), { uniforms: count.word }),
];

const rejections = [
  subject("DiskRejection", "plane", EXACT, 2, () => [budget(32)], () => other.disk_of_24_bits, count.rejection({})),
  subject("BallRejection", "sphere", EXACT, 3, () => [budget(64)], () => other.ball_of_24_bits, count.rejection({})),
  subject("IntegerDiskRejection", "plane", EXACT, 2, () => [budget(32)], () => other.disk_of_30_bits, count.rejection({}), { label: "fixed::DiskRejection", documented: "fixed::DiskRejection" }),
  subject("IntegerDiskRejection16", "plane", EXACT, 1, () => [budget(32)], () => other.disk_of_16_bits, count.rejection({}), { label: "fixed::DiskRejection16", documented: "fixed::DiskRejection16" }),
  subject("Region", "plane", EXACT, 2, () => [number("inner radius", 0.5, 0, 1), number("outer radius", 1, 0, 1.4), budget(100)],
    ([inner, outer]) => other.ring(inner, outer), count.rejection({ proposal: "Aabb", names: { n: 2, m: 1 } }), { label: "Region, a ring" }),
  subject("Bounded", "plane", FLOAT, 3, () => [number("sharpness", 8, 0, 50, 0.1), number("bound", 3.15, 0, 10), budget(100)],
    ([sharpness, bound]) => other.bump(sharpness, bound), count.rejection({ proposal: "Disk" }), { label: "Bounded, a bump" }),
].map((entry) => ({ ...entry, plans: false }));

const chains = [
  subject("Chain", "plane", FLOAT, 0, () => [number("step, deviation", 0.1, 0, 0.5, 0.005), number("large steps, share", 0.2, 0, 1)],
    other.hills, count.chain, { label: "Chain, three hills", trail: true }),
  subject("IntegerChain", "bars", EXACT, 0, () => weights([9, 1, 0, 30, 4, 12], 40, 1), other.states, count.chain, { label: "Chain of integer weights", documented: "Chain" }),
].map((entry) => ({ ...entry, plans: false }));

export const FAMILIES = [
  { name: "line", label: "Line", subjects: on_line },
  { name: "plane", label: "Plane", subjects: in_plane },
  { name: "directions", label: "Directions", subjects: over_directions },
  { name: "tables", label: "Tables", subjects: tables },
  { name: "rejection", label: "Rejection", subjects: rejections },
  { name: "chains", label: "Chains", subjects: chains },
];

export const TIER_LABELS = {
  libm: "libm", poly: "poly", fine: "fixed, fine", coarse: "fixed, coarse", compact: "fixed, compact", exact: "no tier",
};

// The number that a tier makes of a parameter: the nearest f32, and in the integer tier cut to steps of 2⁻¹⁶ (the
// exponent of a lobe and the angle of a cone to 2⁻³², which an f32 of their size has no more of).
export function realised(entry, tier, value) {
  const single = Math.fround(value);
  if (!INTEGER.includes(tier) || entry.name === "PhongLobe" || entry.name === "Cone") return single;
  return Number.isFinite(single) ? Math.trunc(single * 65536) / 65536 : single;
}
