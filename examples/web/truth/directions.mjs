// The maps onto directions in f64: the polar part as sine and cosine, each in a form that keeps its digits.

import { concentric, turned } from "./plane.mjs";

const TURN = 2 * Math.PI;
const direction = (sine, cosine, azimuth) => [...turned(sine, azimuth), cosine];

export const sphere = () => ({
  sample: ([u, v]) => direction(2 * Math.sqrt(u * (1 - u)), 1 - 2 * u, v),
  pdf: () => 1 / (2 * TURN),
});

export const hemisphere = () => ({
  sample: ([u, v]) => direction(Math.sqrt((1 - u) * (1 + u)), u, v),
  pdf: () => 1 / TURN,
});

export const cosine_hemisphere = () => ({
  sample: ([u, v]) => direction(Math.sqrt(u), Math.sqrt(1 - u), v),
  pdf: ([, , z]) => z / Math.PI,
});

// A point of the concentric disk, lifted.
export const malley = () => ({
  sample: (u) => {
    const [x, y] = concentric(u);
    const r = Math.max(...u.map((c) => Math.abs(2 * c - 1)));
    return [x, y, Math.sqrt((1 - r) * (1 + r))];
  },
  pdf: ([, , z]) => z / Math.PI,
});

export const phong = (n) => ({
  sample: ([u, v]) => {
    const log = Math.log1p(-u) / (n + 1);
    return direction(Math.sqrt(-Math.expm1(2 * log)), Math.exp(log), v);
  },
  // Near the axis z has lost the digits that x and y still hold: 1 − cos θ is read from them.
  pdf: ([x, y, z]) => ((n + 1) / TURN) * (z > 0.5 ? Math.exp(n * Math.log1p(-(x * x + y * y) / (1 + z))) : z ** n),
});

export function cone(radians) {
  const k = 2 * Math.sin(radians / 2) ** 2;
  return {
    sample: ([u, v]) => direction(Math.sqrt(u * k * (2 - u * k)), 1 - u * k, v),
    pdf: () => 1 / (TURN * k),
  };
}

// Between two polar angles and two azimuths, in turns.
export function patch(theta0, theta1, phi0, phi1) {
  const [low, high] = [theta0, theta1].map((theta) => 2 * Math.sin(Math.PI * theta) ** 2);
  const south = 2 * Math.cos(Math.PI * theta1) ** 2;
  return {
    sample: ([u, v]) => {
      const down = low + u * (high - low);
      const up = south + (1 - u) * (high - low);
      return direction(Math.sqrt(down * up), 1 - down, phi0 + v * (phi1 - phi0));
    },
    pdf: () => 1 / ((high - low) * (phi1 - phi0) * TURN),
  };
}

// The cosine hemisphere about a normal, in the frame that Duff and others give (2017).
export function turned_cosine(normal) {
  const length = Math.hypot(...normal);
  const [x, y, z] = normal.map((c) => c / length);
  const sign = z < 0 || Object.is(z, -0) ? -1 : 1;
  const a = -1 / (sign + z);
  const axes = [
    [1 + sign * x * x * a, sign * x * y * a, -sign * x],
    [x * y * a, sign + y * y * a, -y],
    [x, y, z],
  ];
  const inner = cosine_hemisphere();
  return {
    sample: (u) => {
      const local = inner.sample(u);
      return [0, 1, 2].map((axis) => local.reduce((sum, c, k) => sum + c * axes[k][axis], 0));
    },
    pdf: (w) => Math.max(0, w[0] * x + w[1] * y + w[2] * z) / Math.PI,
  };
}
