// What the page shows. Names, views, tiers and parameters come from the module, and stated bounds from the
// documentation. This file adds what neither knows: the truth in f64, and how an error is counted against it. A subject
// without a truth is still shown, with its stated bounds and without measured errors.

import * as line from "../truth/line.mjs";
import * as plane from "../truth/plane.mjs";
import * as directions from "../truth/directions.mjs";
import * as other from "../truth/selections.mjs";
import * as count from "./counting.mjs";

const FLOAT = ["libm", "poly"];
const INTEGER = ["fine", "coarse", "compact"];
const is_float = (tier) => FLOAT.includes(tier);

const largest = (p) => Math.max(...p.map(Math.abs));
// A power law is drawn finest at the end where its density may be 0 or infinite: the lower one from n = −1 up.
const power_draws = (increasing) => (words, [n]) => (increasing === n >= -1 ? count.deep : count.deep_down)(words);

// Space seen from a corner, z upwards.
export const corner = ([x, y, z]) => [(y - x) / Math.sqrt(2), (2 * z - x - y) / Math.sqrt(6)];

// By name, in the order of the page: `truth` of parameters and tier; `counting`, where it is not that of a warp without
// a scale; `uniforms` of words, where they are not those of 24 bits; `fraction`, the bits behind the point of an integer
// warp's parameters, where they are not 16; without a truth `flat`, which places a point of space on paper; and a
// `label`, or where it is `documented`, where that is not the name.
const KNOWN = {
  Interval: {
    truth: ([a, b]) => line.interval(a, b),
    counting: count.warp("Interval", { scale: largest, integer: count.steps }),
  },
  IntervalDecreasing: {
    truth: ([a, b]) => line.interval(a, b, false),
    counting: count.warp("Interval", { scale: largest }),
    label: "Interval::decreasing",
  },
  Power: { truth: ([n, a, b]) => line.power(n, a, b), uniforms: power_draws(true) },
  PowerDecreasing: {
    truth: ([n, a, b]) => line.power(n, a, b, false),
    label: "Power::decreasing", uniforms: power_draws(false),
  },
  PowerMax: { truth: line.power_max, label: "PowerMax<4>", uniforms: count.deep },
  Exponential: {
    truth: ([a], tier) => line.exponential(is_float(tier) ? a : 1 / a),
    counting: count.warp("Exponential", { integer: count.of_length(([mean]) => mean, "of the mean") }),
  },
  ExponentialTail: { truth: ([rate]) => line.exponential_tail(rate), uniforms: count.full },
  StandardExponential: { truth: () => line.exponential(1) },
  TruncatedExponential: {
    truth: ([a, length], tier) => line.truncated_exponential(is_float(tier) ? a : 1 / a, length),
    counting: count.warp("TruncatedExponential", { integer: count.of_length(([mean, length]) => Math.min(mean, length), "of mean or length", { words: 1 }) }),
    uniforms: count.deep,
  },
  Tent: {
    truth: ([r]) => line.tent(r),
    counting: count.warp("Tent", { integer: count.of_length(([r]) => r, "of the radius", { uniforms: count.centred }) }),
    uniforms: count.folded,
  },
  Linear: { truth: ([a, b]) => line.linear(a, b), uniforms: count.deep },
  Normal: {
    truth: ([mean, std_dev]) => line.normal(mean, std_dev),
    counting: count.warp("Normal", { scale: ([mean], [x]) => Math.max(Math.abs(mean), Math.abs(x - mean)) }),
    uniforms: count.folded,
  },
  Inversion: { truth: line.rising, label: "Inversion, ½ + x", uniforms: count.deep },
  Transform: { truth: line.sine, label: "Transform, sin x", uniforms: count.deep },
  Disk: { truth: plane.disk },
  DiskConcentric: { truth: plane.disk_concentric },
  FloatDisk: { truth: plane.disk, counting: count.warp("Disk", { further: 6e-8 }), label: "Float<Disk>" },
  Triangle: { truth: plane.triangle },
  TriangleOn: {
    truth: (p) => plane.triangle_on(p),
    counting: count.warp("TriangleOn", { scale: largest, integer: count.of_extent }),
  },
  NormalPair: {
    truth: ([x, y, std_dev]) => plane.normal_pair(x, y, std_dev),
    counting: count.warp("NormalPair", { scale: ([x, y, std_dev]) => largest([x, y, 5.77 * std_dev]), integer: count.of_std_dev }),
  },
  StandardNormalPair: {
    truth: () => plane.normal_pair(0, 0, 1),
    counting: count.warp("StandardNormalPair", { integer: count.distance }),
  },
  Aabb: {
    truth: (p) => plane.box(...p),
    counting: count.warp("Aabb", { scale: largest, variables: (p) => ({ n: 2, m: largest(p) }) }),
  },
  MarginalConditional: {
    truth: plane.below_diagonal,
    uniforms: ([first, second]) => [...count.deep([first]), ...count.grid([second])],
  },
  Simplex: { label: "Simplex<2>" },
  SimplexOf3: { label: "Simplex<3>", flat: corner },
  BoxSurface: { flat: corner },
  FrustumSurface: { flat: corner },
  FrustumSurfaceTube: { flat: corner, label: "FrustumSurface::tube" },
  CapsuleSurface: { flat: corner },
  Sphere: { truth: directions.sphere },
  Hemisphere: { truth: directions.hemisphere },
  CosineHemisphere: { truth: directions.cosine_hemisphere },
  MalleyHemisphere: { truth: directions.malley, uniforms: count.open },
  PhongLobe: {
    truth: ([n]) => directions.phong(n),
    counting: count.warp("PhongLobe", { variables: ([n]) => ({ w: Math.min(1, Math.sqrt(2 / (n + 1))) }) }),
    fraction: 32,
  },
  Cone: {
    truth: ([angle], tier) => directions.cone(is_float(tier) ? angle : angle * 2 * Math.PI),
    counting: count.warp("Cone", { variables: ([turns]) => ({ w: Math.sin(2 * Math.PI * Math.min(turns, 0.25)) }) }),
    fraction: 32,
  },
  SphericalPatch: { truth: (p) => directions.patch(...p) },
  Oriented: { truth: (p) => directions.turned_cosine(p), label: "Oriented cosine" },
  Cdf: { truth: other.shares, counting: count.table({ searched: true }) },
  Alias: { truth: other.shares, counting: count.table({}) },
  SelectOnce: { truth: other.shares, counting: count.selection({ searched: true }), label: "select_once" },
  Reservoir: { truth: other.shares, counting: count.selection({}) },
  PiecewiseConstant1d: {
    truth: (p) => line.histogram(p),
    counting: count.warp("PiecewiseConstant1d", { scale: () => 1 }),
    uniforms: count.word,
  },
  PiecewiseConstant2d: {
    truth: ([clouds, sun]) => plane.picture(other.sky(clouds, sun), 1.5, 1),
    counting: count.warp("PiecewiseConstant2d", { scale: () => 1.5 }),
    uniforms: count.word,
  },
  DiskRejection: { truth: () => other.disk_of_24_bits, counting: count.rejection({}) },
  BallRejection: { truth: () => other.ball_of_24_bits, counting: count.rejection({}) },
  IntegerDiskRejection: {
    truth: () => other.disk_of_30_bits,
    counting: count.rejection({}),
    label: "fixed::DiskRejection", documented: "fixed::DiskRejection",
  },
  IntegerDiskRejection16: {
    truth: () => other.disk_of_16_bits,
    counting: count.rejection({}),
    label: "fixed::DiskRejection16", documented: "fixed::DiskRejection16",
  },
  Region: {
    truth: ([inner, outer]) => other.ring(inner, outer),
    counting: count.rejection({ proposal: "Aabb", names: { n: 2, m: 1 } }),
    label: "Region, a ring",
  },
  Bounded: {
    truth: ([sharpness, bound]) => other.bump(sharpness, bound),
    counting: count.rejection({ proposal: "Disk" }),
    label: "Bounded, a bump",
  },
  Chain: { truth: other.hills, counting: count.chain, label: "Chain, three hills", trail: true },
  IntegerChain: { truth: other.states, counting: count.chain, label: "Chain of integer weights" },
};

// A parameter's name as a label: `half_angle_in_turns` is "half angle, turns".
const label_of = (name) => name.replaceAll("_", " ").replace(/ in (\w+)$/, ", $1");
const FAMILY_OF = { line: "line", plane: "plane", sphere: "directions" };
const FAMILY_LABELS = {
  line: "Line", plane: "Plane", directions: "Directions", tables: "Tables", rejection: "Rejection", chains: "Chains",
};

// One entry a name, of all that the module tells under it: each tier has its own place and parameters. Those known
// here come first, in their order.
function entries_of(told, known) {
  const entries = {};
  for (const { name, type, family, view, words, parameters, tiers, place } of told) {
    entries[name] ??= {
      name, label: name, documented: type, family: family || FAMILY_OF[view], view, words, tiers: [], places: {}, lists: {},
      plans: words > 0 && family !== "rejection",
      counting: known[name]?.truth ? count.warp(type) : count.nothing, ...known[name],
    };
    for (const tier of tiers) {
      entries[name].tiers.push(tier);
      entries[name].places[tier] = place;
      entries[name].lists[tier] = parameters.map(({ label, step = 0.01, ...rest }) => ({ ...rest, label: label_of(label), step }));
    }
  }
  const missing = Object.keys(known).filter((name) => !(name in entries));
  if (missing.length > 0) throw new Error(`the module does not know ${missing.join(", ")}`);
  const rank = ({ name }) => (name in known ? Object.keys(known).indexOf(name) : Infinity);
  return Object.values(entries).sort((a, b) => (rank(a) === rank(b) ? 0 : rank(a) - rank(b)));
}

// The families with their subjects.
export function families_of(told, known = KNOWN) {
  const entries = entries_of(told, known);
  return Object.entries(FAMILY_LABELS).map(([name, label]) => ({ name, label, subjects: entries.filter(({ family }) => family === name) }));
}

export const TIER_LABELS = {
  libm: "libm", poly: "poly", fine: "fixed, fine", coarse: "fixed, coarse", compact: "fixed, compact", exact: "no tier",
};

// The number that a tier makes of a parameter: the nearest f32, and in the integer tier cut to steps of 2⁻¹⁶, or to
// 2⁻³² where a format has them, which an f32 of that size has no more of.
export function realised(entry, tier, value) {
  const single = Math.fround(value);
  if (!INTEGER.includes(tier) || entry.fraction === 32) return single;
  return Number.isFinite(single) ? Math.trunc(single * 65536) / 65536 : single;
}
