// What the page shows. Names, views, tiers and parameters come from the module, and stated bounds from the
// documentation. This file adds what neither knows.

const INTEGER = ["fine", "coarse", "compact"];

// Space seen from a corner, z upwards.
export const corner = ([x, y, z]) => [(y - x) / Math.sqrt(2), (2 * z - x - y) / Math.sqrt(6)];

// By name: a `label`, or where it is `documented`, where that is not the name; `flat`, which places a point of space on
// paper; `trail`, where points follow one another; and `fraction`, the bits behind the point of an integer warp's parameters,
// where they are not 16.
const KNOWN = {
  IntervalDecreasing: { label: "Interval::decreasing" },
  PowerDecreasing: { label: "Power::decreasing" },
  PowerMax: { label: "PowerMax<4>" },
  Inversion: { label: "Inversion, ½ + x" },
  Transform: { label: "Transform, sin x" },
  FloatDisk: { label: "Float<Disk>" },
  Simplex: { label: "Simplex<2>" },
  SimplexOf3: { label: "Simplex<3>", flat: corner },
  BoxSurface: { flat: corner },
  FrustumSurface: { flat: corner },
  FrustumSurfaceTube: { flat: corner, label: "FrustumSurface::tube" },
  CapsuleSurface: { flat: corner },
  PhongLobe: { fraction: 32 },
  Cone: { fraction: 32 },
  Oriented: { label: "Oriented cosine" },
  SelectOnce: { label: "select_once" },
  IntegerDiskRejection: { label: "fixed::DiskRejection", documented: "fixed::DiskRejection" },
  IntegerDiskRejection16: { label: "fixed::DiskRejection16", documented: "fixed::DiskRejection16" },
  Region: { label: "Region, a ring" },
  Bounded: { label: "Bounded, a bump" },
  Chain: { label: "Chain, three hills", trail: true },
  IntegerChain: { label: "Chain of integer weights" },
};

// A parameter's name as a label: `half_angle_in_turns` is "half angle, turns".
const label_of = (name) => name.replaceAll("_", " ").replace(/ in (\w+)$/, ", $1");
const FAMILY_OF = { line: "line", plane: "plane", sphere: "directions" };
const FAMILY_LABELS = {
  line: "Line", plane: "Plane", directions: "Directions", tables: "Tables", rejection: "Rejection", chains: "Chains",
};

// One entry a name, of all that the module tells under it: each tier has its own place and parameters.
function entries_of(told, known) {
  const entries = {};
  for (const { name, type, family, view, words, parameters, tiers, place } of told) {
    entries[name] ??= {
      name, label: name, documented: type, family: family || FAMILY_OF[view], view, words, tiers: [], places: {}, lists: {},
      plans: words > 0 && family !== "rejection",
      ...known[name],
    };
    for (const tier of tiers) {
      entries[name].tiers.push(tier);
      entries[name].places[tier] = place;
      entries[name].lists[tier] = parameters.map(({ label, step = 0.01, ...rest }) => ({ ...rest, label: label_of(label), step }));
    }
  }
  const missing = Object.keys(known).filter((name) => !(name in entries));
  if (missing.length > 0) throw new Error(`the module does not know ${missing.join(", ")}`);
  return Object.values(entries);
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
