// The maps onto the plane in f64. `outline` is the border of the domain and `box` what of the plane is worth
// looking at: [left, right, bottom, top].

export const turned = (radius, turns) => [radius * Math.cos(2 * Math.PI * turns), radius * Math.sin(2 * Math.PI * turns)];

const circle = Array.from({ length: 181 }, (_, k) => turned(1, k / 180));
const unit_disk = { outline: circle, box: [-1, 1, -1, 1], pdf: ([x, y]) => (x * x + y * y <= 1 + 1e-6 ? 1 / Math.PI : 0) };

export const disk = () => ({ ...unit_disk, sample: ([u, v]) => turned(Math.sqrt(u), v) });

// Squares about the middle of the unit square become circles about the centre.
export function concentric([u, v]) {
  const [a, b] = [2 * u - 1, 2 * v - 1];
  if (a === 0 && b === 0) return [0, 0];
  return Math.abs(a) > Math.abs(b) ? turned(a, b / a / 8) : turned(b, 0.25 - a / b / 8);
}
export const disk_concentric = () => ({ ...unit_disk, sample: concentric });

const barycentric = ([u, v]) => [(1 - u) / (1 + Math.sqrt(u)), Math.sqrt(u) * v, Math.sqrt(u) * (1 - v)];
const CORNERS = [[0.5, Math.sqrt(0.75)], [0, 0], [1, 0]];
const combined = (weights, corners) => [0, 1].map((axis) => weights.reduce((sum, w, k) => sum + w * corners[k][axis], 0));

export const triangle = () => ({
  sample: barycentric,
  pdf: () => 2,
  flat: (weights) => combined(weights, CORNERS),
  outline: [...CORNERS, CORNERS[0]],
  box: [0, 1, 0, Math.sqrt(0.75)],
});

export function triangle_on([ax, ay, bx, by, cx, cy]) {
  const corners = [[ax, ay], [bx, by], [cx, cy]];
  const area = Math.abs((bx - ax) * (cy - ay) - (cx - ax) * (by - ay)) / 2;
  return {
    sample: (u) => combined(barycentric(u), corners),
    pdf: () => 1 / area,
    outline: [...corners, corners[0]],
    box: [Math.min(ax, bx, cx), Math.max(ax, bx, cx), Math.min(ay, by, cy), Math.max(ay, by, cy)],
  };
}

export function normal_pair(mx, my, std_dev) {
  const square = ([x, y]) => ((x - mx) ** 2 + (y - my) ** 2) / (std_dev * std_dev);
  return {
    sample: ([u, v]) => {
      const [x, y] = turned(std_dev * Math.sqrt(-2 * Math.log1p(-u)), v);
      return [mx + x, my + y];
    },
    pdf: (point) => Math.exp(-square(point) / 2) / (2 * Math.PI * std_dev * std_dev),
    outline: circle.map(([x, y]) => [mx + std_dev * x, my + std_dev * y]),
    box: [mx - 3.5 * std_dev, mx + 3.5 * std_dev, my - 3.5 * std_dev, my + 3.5 * std_dev],
  };
}

const rectangle = (left, right, bottom, top) => ({
  outline: [[left, bottom], [right, bottom], [right, top], [left, top], [left, bottom]],
  box: [left, right, bottom, top],
});

export const box = (left, right, bottom, top) => ({
  ...rectangle(left, right, bottom, top),
  sample: ([u, v]) => [left + (right - left) * u, bottom + (top - bottom) * v],
  pdf: () => 1 / ((right - left) * (top - bottom)),
});

// Uniform on 0 ≤ y ≤ x ≤ 1.
export const below_diagonal = () => ({
  sample: ([u, v]) => [Math.sqrt(u), v * Math.sqrt(u)],
  pdf: () => 2,
  outline: [[0, 0], [1, 0], [1, 1], [0, 0]],
  box: [0, 1, 0, 1],
});

// Rows of cells on [0, width] × [0, height], the row by its total, the column within its row. The edges are rounded
// to f32, as the documentation says.
export function picture(rows, width, height) {
  const sums = rows.map((row) => row.reduce((sum, weight) => sum + weight, 0));
  const total = sums.reduce((sum, weight) => sum + weight, 0);
  const edges = (count, length) => Array.from({ length: count + 1 }, (_, k) => Math.fround(Math.fround(k / count) * length));
  const [columns_at, rows_at] = [edges(rows[0].length, width), edges(rows.length, height)];
  const place = (weights, at, all, u) => {
    let rest = u * all;
    let index = 0;
    while (index < weights.length - 1 && rest >= weights[index]) rest -= weights[index++];
    return [index, at[index] + (rest / weights[index]) * (at[index + 1] - at[index])];
  };
  const cell = (at, x) => Math.min(at.findLastIndex((edge) => edge <= x), at.length - 2);
  const span = (at, index) => at[index + 1] - at[index];
  return {
    ...rectangle(0, width, 0, height),
    cells: rows,
    sample: ([u, v]) => {
      const [row, y] = place(sums, rows_at, total, v);
      return [place(rows[row], columns_at, sums[row], u)[1], y];
    },
    pdf: ([x, y]) => {
      const [column, row] = [cell(columns_at, x), cell(rows_at, y)];
      return rows[row][column] / total / (span(columns_at, column) * span(rows_at, row));
    },
  };
}

export const ring = (inner, outer) => ({
  box: [-1, 1, -1, 1],
  outline: circle.map(([x, y]) => [outer * x, outer * y]),
  hole: circle.map(([x, y]) => [inner * x, inner * y]),
});
