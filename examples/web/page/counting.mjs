// How errors are counted, each in its stated unit. Each function takes the drawn points and the truth, and returns the
// readings of the page:
//   error     { max, rms, unit, stated, at }: the largest, and where; `stated` is the bound, or null
//   density   the same for the reported density
//   residuals [place, error], one a point
//   further   [{ label, value, note, fault }]

import { evaluate } from "./formula.mjs";

// The spacing of f32 at the magnitude of an exact value.
const view = new DataView(new ArrayBuffer(8));
function ulp(x) {
  view.setFloat64(0, Math.abs(x));
  const exponent = (view.getUint16(0) >> 4) - 1023;
  return 2 ** (Math.min(Math.max(exponent, -126), 127) - 23);
}

const FLOAT = ["libm", "poly"];
const COLUMN = { libm: 0, poly: 1, exact: 0, fine: 0, coarse: 1, compact: 2 };

// Uniforms out of the words a point was drawn with, each exact in f64.
export const grid = (words) => words.map((w) => (w >>> 8) / 2 ** 24);
export const word = (words) => words.map((w) => w / 2 ** 32);
// The middle of a word, of 2⁹ words, and of 2⁹ but near 0 of one.
export const centred = (words) => words.map((w) => (2 * w + 1) / 2 ** 33);
export const open = (words) => words.map((w) => (2 * (w >>> 9) + 1) / 2 ** 24);
export const deep = (words) => words.map((w) => (w < 2 ** 23 ? centred : open)([w])[0]);
// The same with the words near 1 as fine as those near 0 are there.
export const deep_down = (words) => deep(words.map((w) => ~w >>> 0)).map((t) => 1 - t);
// The middle of a word, its distance from the nearer end rounded to the 24 digits of an f32.
export const folded = (words) => words.map((w) => {
  const upper = w >= 2 ** 31;
  const tail = Math.fround(2 * (upper ? ~w >>> 0 : w) + 1) / 2 ** 33;
  return upper ? 1 - tail : tail;
});
// 64 bits, cut to the 24 digits of an f32; 0 counts as the middle of its cell.
export function full([high, low]) {
  const digits = (BigInt(high) << 32n) | BigInt(low);
  const excess = Math.max(0, digits.toString(2).length - 24);
  return [Number((digits >> BigInt(excess)) << BigInt(excess)) / 2 ** 64 || 2 ** -65];
}

const far = (got, exact) => Math.hypot(...exact.map((x, k) => got[k] - x));
const widest = (got, exact) => Math.max(...exact.map((x, k) => Math.abs(got[k] - x)));

// The integer tier: errors below one step of a parameter's format, 2⁻¹⁶, do not count.
const STEP = 2 ** -16;
export const steps = { unit: "steps of 2⁻¹⁶", bound: 1, of: (got, exact) => widest(got, exact) / STEP };
export const distance = { unit: "of distance", of: far };
export const of_length = (length, unit, { words = 0, uniforms } = {}) => ({
  unit,
  uniforms,
  // A word of the uniform more or less moves a sample by that over the density.
  of: (got, exact, { p, truth }) => Math.max(0, widest(got, exact) - STEP - (words && (words * 2 ** -32) / truth.pdf(exact[0]))) / length(p),
});
export const of_extent = {
  unit: "of the extent",
  of: (got, exact, { truth: { box: [left, right, bottom, top] } }) => Math.max(
    ...[right - left, top - bottom].map((extent, k) => Math.max(0, Math.abs(got[k] - exact[k]) - STEP / 2) / extent)),
};
export const of_std_dev = {
  unit: "of the standard deviation",
  of: (got, exact, { p }) => Math.hypot(...exact.map((x, k) => Math.max(0, Math.abs(got[k] - x) - STEP / 2))) / p[2],
};

// The row of a table of the documentation: what it is in, and the bound of the tier for these values of its names.
function row(stated, family, type, quantity, tier, names) {
  const found = Object.entries(stated[family]?.[type] ?? {}).find(([name]) => name === quantity || name.startsWith(`${quantity},`));
  return found ? { unit: found[0].slice(quantity.length + 2), bound: evaluate(found[1][COLUMN[tier]], names) } : null;
}

// `scale` is the length that the unit names, of the parameters and of the exact point.
function float_error(type, scale, names, { tier, p, stated }) {
  const { unit, bound } = row(stated, "float", type, "sample", tier, names);
  const of_scale = (got, exact) => widest(got, exact) / ulp(scale(p, exact));
  const of = {
    "ulp": (got, exact) => widest(got, exact) / ulp(exact[0]),
    "ulp of the scale": of_scale,
    "ulp of location or distance": of_scale,
    "of the size": (got, exact) => far(got, exact) / (scale ? scale(p, exact) : 1),
  }[unit];
  if (!of) throw new Error(`${type}: a unit that is not known here: ${unit}`);
  return { unit, bound, of };
}

function integer_error(type, integer, names, further, { tier, stated }) {
  const { unit = "in a coordinate", of = widest } = integer ?? {};
  const bound = integer?.bound ?? row(stated, "integer", type, "sample", tier, names).bound + further;
  return { unit, bound, of };
}

// The largest, the root of the mean square, and where the largest was.
class Largest {
  constructor() {
    this.max = 0;
    this.squares = 0;
    this.count = 0;
    this.at = null;
  }

  // Written so that NaN counts as the largest error and remains.
  take(error, at) {
    this.count += 1;
    this.squares += error * error;
    if (!(error <= this.max) && !Number.isNaN(this.max)) {
      this.max = error;
      this.at = at;
    }
  }

  reading(unit, stated) {
    return { max: this.max, rms: Math.sqrt(this.squares / this.count), unit, stated, at: this.at };
  }
}

const points = function* ({ count, points: places, words, densities }, taken) {
  for (let k = 0; k < count; k += 1) {
    yield { k, point: places.subarray(3 * k, 3 * k + 3), words: Array.from(words.subarray(4 * k + 4 - taken, 4 * k + 4)), density: densities[k] };
  }
};

const argument = (entry, point) => (entry.view === "line" ? point[0] : point);

// Without a truth: the stated bounds and the reported densities.
export const nothing = (drawn, { entry: { documented }, tier, stated }) => {
  const densities = drawn.densities.subarray(0, drawn.count);
  const family = tier in COLUMN && !FLOAT.includes(tier) && tier !== "exact" ? "integer" : "float";
  const rows = Object.entries(stated[family]?.[documented] ?? {});
  const short = (x) => Number(x.toPrecision(3));
  return {
    error: null, density: null, residuals: [], signed: false,
    further: [
      { label: "Largest error", value: "–", note: "there is no f64 truth on this page" },
      ...rows.map(([quantity, cells]) => ({ label: `Stated, ${quantity}`, value: cells[COLUMN[tier]], note: "by the documentation" })),
      { label: "Density", value: `${short(densities.reduce((a, b) => Math.min(a, b)))} to ${short(densities.reduce((a, b) => Math.max(a, b)))}`, note: "as reported at the points" },
    ],
  };
};

// A warp: its points against the exact map of the very uniforms they were drawn with. `variables` gives the names in
// its stated bounds their values.
export const warp = (type, { scale, integer, further = 0, variables = () => ({}) } = {}) => (drawn, context) => {
  const { entry, tier, p, truth, stated } = context;
  const in_floats = FLOAT.includes(tier) || tier === "exact";
  const names = variables(p);
  const { unit, bound, of } = in_floats ? float_error(type, scale, names, context) : integer_error(type, integer, names, further, context);
  const uniforms = (in_floats ? entry.uniforms : integer?.uniforms) ?? (in_floats ? grid : word);
  const [error, density] = [new Largest(), new Largest()];
  const residuals = [];
  for (const { k, point, words, density: reported } of points(drawn, entry.words)) {
    const u = uniforms(words, p);
    const exact = truth.sample(u);
    const off = of(point, exact, context);
    error.take(off, k);
    residuals.push([u[0], entry.view === "line" && point[0] < exact[0] ? -off : off]);
    const due = truth.pdf(argument(entry, point));
    density.take(in_floats ? Math.abs(reported - due) / due : Math.abs(reported - due), k);
  }
  const pdf = in_floats ? row(stated, "float", type, "pdf", tier, names) : null;
  return {
    error: error.reading(unit, bound),
    density: density.reading(in_floats ? "relative" : "absolute", pdf?.bound ?? null),
    residuals, signed: entry.view === "line", further: [],
  };
};

// Of so many draws, how far each count is from its expectation, in standard deviations.
function frequencies({ count, points: places }, shares) {
  const counts = shares.map(() => 0);
  for (let k = 0; k < count; k += 1) counts[places[3 * k]] += 1;
  const off = counts.map((n, i) => {
    const spread = Math.sqrt(count * shares[i] * (1 - shares[i]));
    return spread > 0 ? Math.abs(n - count * shares[i]) / spread : n === count * shares[i] ? 0 : Infinity;
  });
  return { label: "Counts off by at most", value: `${Math.max(...off).toFixed(2)} σ`, note: "of what the shares give", fault: !(Math.max(...off) < 6) };
}

// By how many words of 2³² a word lies outside the share that is exactly that of the entry it selected.
function misplaced(word_drawn, index, shares) {
  const below = shares.slice(0, index).reduce((sum, share) => sum + share, 0) * 2 ** 32;
  return Math.max(0, below - word_drawn, word_drawn + 1 - (below + shares[index] * 2 ** 32));
}

// A table: the words it gives each entry against exact shares, and the words that selected against its ends.
export const table = ({ searched }) => (drawn, { entry, truth: { shares } }) => {
  const [error, density] = [new Largest(), new Largest()];
  const residuals = [];
  shares.forEach((share, index) => error.take(Math.abs(drawn.report[index] - share * 2 ** 32), index));
  for (const { k, point: [index], words: [w], density: pmf } of points(drawn, entry.words)) {
    if (searched) {
      const off = misplaced(w, index, shares);
      error.take(off, k);
      residuals.push([w / 2 ** 32, off]);
    }
    density.take(Math.abs(pmf - drawn.report[index] / 2 ** 32) / (drawn.report[index] / 2 ** 32), k);
  }
  return {
    // An end is at the words of all entries before it, so that it is off by less than a word, and a word has a width.
    error: error.reading("words of 2³²", 1),
    density: density.reading("relative", 2 ** -24),
    residuals, signed: false, further: [frequencies(drawn, shares)],
  };
};

// A selection without a table: the probability it reports, which is correctly rounded.
export const selection = ({ searched }) => (drawn, { truth: { shares } }) => {
  const [error, outside] = [new Largest(), new Largest()];
  const residuals = [];
  for (const { k, point: [index], words: [w], density: pmf } of points(drawn, 1)) {
    const off = Math.abs(pmf - shares[index]) / shares[index];
    error.take(off, k);
    residuals.push([w / 2 ** 32, off]);
    outside.take(searched ? misplaced(w, index, shares) : 0, k);
  }
  const further = [frequencies(drawn, shares)];
  if (searched) {
    further.push({ label: "Words outside their share", value: outside.max.toFixed(2), note: "of 2³²; below 1 is stated", fault: !(outside.max < 1) });
  }
  return { error: error.reading("of the pmf", 2 ** -24), density: null, residuals, signed: false, further };
};

// Rejection: points against what the words of the accepted try stand for, and the share that was accepted.
export const rejection = ({ proposal, names }) => (drawn, context) => {
  const { entry, tier, truth, stated } = context;
  const error = new Largest();
  const residuals = [];
  let outside = 0;
  for (const { k, point, words } of points(drawn, entry.words)) {
    const off = far(point, truth.sample(words));
    error.take(off, k);
    residuals.push([words[0] / 2 ** 32, off]);
    outside += truth.inside(point) ? 0 : 1;
  }
  const [accepted, tries] = drawn.report;
  const [share, due] = [accepted / tries, truth.efficiency];
  const off = due < 1 ? Math.abs(share - due) / Math.sqrt((due * (1 - due)) / tries) : 0;
  return {
    error: error.reading(proposal ? "of the size" : "exact", proposal ? row(stated, "float", proposal, "sample", tier, names).bound : 0),
    density: null, residuals, signed: false,
    further: [
      { label: "Accepted", value: `${(100 * share).toFixed(1)} %`, note: `in theory ${(100 * due).toFixed(1)} %, ${off.toFixed(1)} σ off`, fault: !(off < 6) },
      { label: "Outside the domain", value: String(outside), note: "points", fault: outside > 0 },
    ],
  };
};

// A chain: the mean of a coordinate in standard errors of that mean, by the chain's own autocorrelation time.
export const chain = (drawn, { truth }) => {
  const density = new Largest();
  let sum = 0;
  for (const { k, point, density: reported } of points(drawn, 0)) {
    sum += point[0];
    density.take(Math.abs(reported - truth.pdf(point)) / truth.pdf(point), k);
  }
  const [acceptance, time] = drawn.report;
  const deviation = Math.sqrt((truth.variance * time) / drawn.count);
  const off = Math.abs(sum / drawn.count - truth.mean);
  // With a single state of positive weight nothing can be off; without a known time nothing can be tested.
  const max = off === 0 ? 0 : time > 0 ? off / deviation : NaN;
  const error = { label: "Error of the mean", max, rms: null, unit: "σ of the mean", stated: Number.isNaN(max) ? null : 5, at: null };
  return {
    error, density: density.reading("relative", null), residuals: [], signed: false,
    further: [
      { label: "Accepted", value: `${(100 * acceptance).toFixed(1)} %`, note: "of the proposals" },
      { label: "Autocorrelation time", value: time > 0 ? time.toFixed(1) : "–", note: time > 0 ? "steps" : "longer than 256 steps" },
    ],
  };
};
