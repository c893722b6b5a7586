// What tables, rejection and chains are held against, in f64: shares of weights, the points that words stand for,
// shares of proposals that are accepted, means.

import { disk, ring as rings } from "./plane.mjs";

export function shares(weights) {
  const total = weights.reduce((sum, weight) => sum + weight, 0);
  return { shares: weights.map((weight) => weight / total) };
}

// Clouds, a sun, a dark column; row by row, as the module lays it out.
export const sky = (c, sun) => [
  [1, c, 1, 0, c, 1],
  [c, c, 1, 0, sun, 1],
  [1, c, c, 0, 1, 1],
  [1, 1, c, 0, c, c],
];

const { outline, box } = disk();
const disk_of = (coordinates) => ({
  outline, box, sample: coordinates, inside: ([x, y]) => x * x + y * y < 1, efficiency: Math.PI / 4, pdf: () => 1 / Math.PI,
});

// Odd multiples of 2⁻²⁴ from the first 24 bits of a word.
const odd_of_24 = (word) => (2 * (word >>> 8) + 1) / 2 ** 24 - 1;
export const disk_of_24_bits = disk_of((words) => words.map(odd_of_24));
export const ball_of_24_bits = {
  sample: (words) => words.map(odd_of_24),
  inside: ([x, y, z]) => x * x + y * y + z * z < 1,
  efficiency: Math.PI / 6,
  pdf: () => 3 / (4 * Math.PI),
};
// The first 30 bits of a word as a signed number h, and 2h + 1 in units of 2⁻³⁰.
export const disk_of_30_bits = disk_of((words) => words.map((word) => (2 * ((word | 0) >> 2) + 1) / 2 ** 30));
// Both halves of one word as signed numbers.
export const disk_of_16_bits = disk_of(([word]) => [(word | 0) >> 16, (word << 16) >> 16].map((h) => (2 * h + 1) / 2 ** 16));

const grid = (word) => (word >>> 8) / 2 ** 24;

export function ring(inner, outer) {
  // Beyond the square's sides the ring is cut off: the area of a disk of radius r within the square.
  const area = (r) => {
    if (r <= 1) return Math.PI * r * r;
    if (r >= Math.SQRT2) return 4;
    const half = Math.sqrt(r * r - 1);
    return 4 * half + r * r * (Math.PI - 4 * Math.acos(1 / r));
  };
  return {
    ...rings(inner, outer),
    sample: (words) => words.map((word) => 2 * grid(word) - 1),
    // The predicate is worked out in f32, at the point itself.
    inside: ([x, y]) => Math.hypot(x, y) >= inner * (1 - 1e-6) && Math.hypot(x, y) <= outer * (1 + 1e-6),
    efficiency: Math.max(0, area(outer) - area(inner)) / 4,
    pdf: () => 1 / 4,
  };
}

// f = 1/(1 + s r²) on the disk, whose integral is π ln(1 + s)/s, below `bound` times 1/π.
export const bump = (sharpness, bound) => ({
  outline,
  box,
  sample: (words) => disk().sample(words.slice(0, 2).map(grid)),
  inside: ([x, y]) => x * x + y * y <= 1 + 1e-6,
  efficiency: (sharpness === 0 ? Math.PI : (Math.PI * Math.log1p(sharpness)) / sharpness) / bound,
  pdf: ([x, y]) => 1 / (1 + sharpness * (x * x + y * y)),
});

// The mean and the variance of the first coordinate under a density of the unit square, by the midpoint rule, which
// of a smooth periodic density is exact to f64.
export function hills() {
  const height = ([x, y]) => {
    const turn = 2 * Math.PI;
    return Math.exp(3 * (Math.cos(turn * (x + y)) + Math.cos(turn * (x - 2 * y)) - 2));
  };
  const cells = 128;
  const sums = [0, 0];
  let mass = 0;
  for (let i = 0; i < cells; i += 1) {
    const x = (i + 0.5) / cells;
    for (let j = 0; j < cells; j += 1) {
      const f = height([x, (j + 0.5) / cells]);
      mass += f;
      sums[0] += f * x;
      sums[1] += f * x * x;
    }
  }
  const mean = sums[0] / mass;
  return {
    pdf: height, mean, variance: sums[1] / mass - mean * mean, unnormalised: true,
    box: [0, 1, 0, 1], outline: [[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]], shade: height,
  };
}

// Likewise of the number of a state under integer weights.
export function states(weights) {
  const whole = weights.map(Math.trunc);
  const { shares: shares_of } = shares(whole);
  const mean = shares_of.reduce((sum, share, state) => sum + share * state, 0);
  const variance = shares_of.reduce((sum, share, state) => sum + share * (state - mean) ** 2, 0);
  return { shares: shares_of, mean, variance, pdf: ([state]) => whole[state], unnormalised: true };
}
