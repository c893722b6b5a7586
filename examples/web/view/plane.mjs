// Points of the plane on equal scales, within the outline of their domain; and the uniforms they came from.

import { colours, grain, label, path, prepare, scatter, shade_of, short } from "./canvas.mjs";

export function draw(canvas, { entry, drawn, truth, keep }) {
  const { context, width, height } = prepare(canvas, keep);
  const theme = colours();
  const [left, right, bottom, top] = truth.box;
  const { scale, place } = fitted(truth.box, width, height, entry.words === 2 && entry.plans && width > 600 ? INSET : 0);
  if (!keep) {
    if (truth.cells) shade_cells(context, theme, truth, place);
    if (truth.shade) shade_density(context, theme, truth, place, scale);
  }
  const flat = truth.flat ?? ((point) => point);
  const { size, alpha } = grain(drawn.count);
  scatter(context, drawn.count, theme.ramp, shade_of(entry, drawn),
    (k) => place(flat(drawn.points.subarray(3 * k, 3 * k + 3))), size, alpha);
  context.strokeStyle = theme.rule;
  context.lineWidth = 1;
  for (const border of [truth.outline, truth.hole ?? []]) {
    path(context, border.map(place));
    context.stroke();
  }
  if (keep || truth.flat) return;
  const [west, south] = place([left, bottom]);
  const [east, north] = place([right, top]);
  label(context, short(left), west, south + 16, theme.faint, "left");
  label(context, short(right), east, south + 16, theme.faint, "right");
  label(context, short(bottom), west - 8, south - 5, theme.faint, "right");
  label(context, short(top), west - 8, north + 5, theme.faint, "right");
}

// Equal scales that fill the canvas, beside its upper left corner where the uniforms' square would be in the way.
const MARGIN = 26;
const INSET = 128;
function fitted([left, right, bottom, top], width, height, inset) {
  const within = (from) => {
    const scale = Math.min((width - from - MARGIN) / (right - left), (height - 2 * MARGIN) / (top - bottom));
    const place = ([x, y]) => [
      (from + width - MARGIN) / 2 + (x - (left + right) / 2) * scale,
      height / 2 - (y - (bottom + top) / 2) * scale,
    ];
    return { scale, place };
  };
  const full = within(MARGIN);
  const [west, north] = full.place([left, top]);
  return west - MARGIN < inset && north - MARGIN < inset && inset > 0 ? within(inset + MARGIN) : full;
}

function shade_cells(context, { bars }, { cells, box: [left, right, bottom, top] }, place) {
  const most = Math.max(...cells.flat());
  context.fillStyle = bars;
  cells.forEach((row, j) => row.forEach((weight, i) => {
    const corner = (k, l) => place([left + ((right - left) * k) / row.length, bottom + ((top - bottom) * l) / cells.length]);
    const [[x0, y0], [x1, y1]] = [corner(i, j), corner(i + 1, j + 1)];
    context.globalAlpha = 0.9 * Math.sqrt(weight / most);
    context.fillRect(x0, y1, x1 - x0, y0 - y1);
  }));
  context.globalAlpha = 1;
}

function shade_density(context, { bars }, { shade, box: [left, right, bottom, top] }, place, scale) {
  const cell = 4 / scale;
  context.fillStyle = bars;
  for (let x = left; x < right; x += cell) {
    for (let y = bottom; y < top; y += cell) {
      context.globalAlpha = 0.75 * shade([x + cell / 2, y + cell / 2]);
      const [west, south] = place([x, y]);
      context.fillRect(west, south - 4, 4, 4);
    }
  }
  context.globalAlpha = 1;
}

// The unit square that the same points come from, in the same colours.
export function draw_uniforms(canvas, { entry, drawn, keep }) {
  const { context, width, height } = prepare(canvas, keep);
  const theme = colours();
  const { size, alpha } = grain(drawn.count);
  const edge = Math.min(width, height) - 2;
  const [first, second] = [4 - entry.words, 5 - entry.words];
  scatter(context, drawn.count, theme.ramp, shade_of(entry, drawn),
    (k) => [1 + (drawn.words[4 * k + first] / 2 ** 32) * edge, 1 + (1 - drawn.words[4 * k + second] / 2 ** 32) * edge],
    size * 0.7, alpha);
  context.strokeStyle = theme.rule;
  context.strokeRect(0.5, 0.5, edge + 1, edge + 1);
}
