// The maps onto the line in f64, from their formulas alone; nothing here has seen the crate's code. Each has
// `sample` of one uniform, `pdf`, and `range`, the part of the line worth looking at.

// What a uniform of 0 counts as where a map is infinite or a density zero there.
const SMALLEST = 2 ** -149;
const open = (u) => (u > 0 ? u : SMALLEST);
const within = (low, high, density) => (x) => (x >= low && x <= high ? density(x) : 0);

export const interval = (a, b, increasing = true) => ({
  sample: ([u]) => [increasing ? a + (b - a) * u : b - (b - a) * u],
  pdf: within(a, b, () => 1 / (b - a)),
  range: [a, b],
});

// Density ∝ xⁿ, carried from the end where x^(n + 1) is larger.
export function power(n, a, b, increasing = true) {
  const m = n + 1;
  const span = Math.log(b / a);
  const place = (u) => {
    if (m === 0) return a * Math.exp(u * span);
    if (m > 0) return b * Math.exp(Math.log1p((1 - u) * Math.expm1(-m * span)) / m);
    return a * Math.exp(Math.log1p(u * Math.expm1(m * span)) / m);
  };
  const density = (x) => {
    if (m === 0) return 1 / (x * span);
    const anchor = m > 0 ? b : a;
    return ((Math.abs(m) / anchor) * (x / anchor) ** n) / -Math.expm1(-Math.abs(m) * span);
  };
  return {
    sample: ([u]) => [increasing ? place(a > 0 ? u : open(u)) : place(1 - u)],
    pdf: within(a, b, density),
    range: [a, b],
  };
}

// The largest of four uniforms.
export const power_max = () => ({
  sample: (u) => [open(Math.max(...u))],
  pdf: within(0, 1, (x) => 4 * x ** 3),
  range: [0, 1],
});

export const exponential = (rate) => ({
  sample: ([u]) => [-Math.log1p(-u) / rate],
  pdf: within(0, Infinity, (x) => rate * Math.exp(-rate * x)),
  range: [0, 7 / rate],
});

export const exponential_tail = (rate) => ({
  ...exponential(rate),
  sample: ([u]) => [-Math.log(open(u)) / rate],
});

export function truncated_exponential(rate, length) {
  const z = rate * length;
  return {
    sample: ([u]) => [rate === 0 ? u * length : -Math.log1p(u * Math.expm1(-z)) / rate],
    pdf: within(0, length, (x) => (rate === 0 ? 1 / length : (rate * Math.exp(-rate * x)) / -Math.expm1(-z))),
    range: [0, length],
  };
}

export const tent = (r) => ({
  sample: ([u]) => [u < 0.5 ? r * Math.expm1(0.5 * Math.log(2 * u)) : -r * Math.expm1(0.5 * Math.log(2 * (1 - u)))],
  pdf: within(-r, r, (x) => (1 - Math.abs(x) / r) / r),
  range: [-r, r],
});

// The root of an increasing function, from a start that is nearly it.
function polished(start, value, slope) {
  let x = start;
  for (let turn = 0; turn < 3; turn += 1) x -= value(x) / slope(x);
  return x;
}

export function linear(a, b) {
  const density = (x) => (2 * (a + (b - a) * x)) / (a + b);
  const cdf = (x) => (x * (2 * a + (b - a) * x)) / (a + b);
  const start = (u) => Math.abs(b - a) > 1e-3 * (a + b)
    ? (Math.sqrt(a * a + u * (b * b - a * a)) - a) / (b - a) : u;
  return {
    sample: ([u]) => [u > 0 ? polished(start(u), (x) => cdf(x) - u, density) : a > 0 ? 0 : SMALLEST],
    pdf: within(0, 1, density),
    range: [0, 1],
  };
}

// erf by a series of positive terms, erfc by its continued fraction.
function erf(x) {
  let [term, sum] = [x, x];
  for (let n = 1; n < 200 && Math.abs(term) > 1e-18 * Math.abs(sum); n += 1) {
    term *= (2 * x * x) / (2 * n + 1);
    sum += term;
  }
  return (2 / Math.sqrt(Math.PI)) * Math.exp(-x * x) * sum;
}
function erfc(x) {
  if (x < 2) return 1 - erf(x);
  let fraction = 0;
  for (let n = 120; n > 0; n -= 1) fraction = n / 2 / (x + fraction);
  return Math.exp(-x * x) / (Math.sqrt(Math.PI) * (x + fraction));
}

// The point below which a standard normal lies with probability u, by Newton's method: on the logarithm in the
// tails, and on the difference from one half between them, so that neither loses digits.
function normal_quantile(u) {
  if (u > 0.5) return -normal_quantile(1 - u);
  const root = Math.SQRT1_2;
  let x;
  if (u > 0.1) {
    x = 0;
    for (let turn = 0; turn < 12; turn += 1) {
      x -= (0.5 * erf(x * root) - (u - 0.5)) * Math.sqrt(2 * Math.PI) * Math.exp((x * x) / 2);
    }
  } else {
    x = -Math.sqrt(-2 * Math.log(u));
    for (let turn = 0; turn < 12; turn += 1) {
      const below = 0.5 * erfc(-x * root);
      const slope = Math.exp((-x * x) / 2) / Math.sqrt(2 * Math.PI) / below;
      x -= Math.log(below / u) / slope;
    }
  }
  return x;
}

export const normal = (mean, std_dev) => ({
  sample: ([u]) => [mean + std_dev * normal_quantile(open(u))],
  pdf: (x) => Math.exp(-(((x - mean) / std_dev) ** 2) / 2) / (std_dev * Math.sqrt(2 * Math.PI)),
  range: [mean - 4 * std_dev, mean + 4 * std_dev],
});

// p(x) = 1/2 + x.
export const rising = () => ({
  sample: ([u]) => [u > 0 ? polished((Math.sqrt(1 + 8 * u) - 1) / 2, (x) => (x * (1 + x)) / 2 - u, (x) => 0.5 + x) : 0],
  pdf: within(0, 1, (x) => 0.5 + x),
  range: [0, 1],
});

// y = sin x of x with density 2x.
export const sine = () => ({
  sample: ([u]) => [Math.sin(Math.sqrt(open(u)))],
  pdf: within(0, Math.sin(1), (y) => (2 * Math.asin(y)) / Math.sqrt(1 - y * y)),
  range: [0, Math.sin(1)],
});

// Cells on [0, 1) with masses in proportion to the weights. Their edges are those that the documentation gives: the
// multiples of 1/n, rounded to f32.
export function histogram(weights) {
  const total = weights.reduce((sum, weight) => sum + weight, 0);
  const edges = [...weights, 0].map((_, index) => Math.fround(index / weights.length));
  const width = (index) => edges[index + 1] - edges[index];
  const cell = (x) => Math.min(edges.findLastIndex((edge) => edge <= x), weights.length - 1);
  return {
    sample: ([u]) => {
      let rest = u * total;
      let index = 0;
      while (index < weights.length - 1 && rest >= weights[index]) rest -= weights[index++];
      return [edges[index] + (rest / weights[index]) * width(index)];
    },
    pdf: within(0, 1, (x) => weights[cell(x)] / total / width(cell(x))),
    range: [0, 1],
  };
}
