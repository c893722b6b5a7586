// Points of the plane on equal scales; and the uniforms they came from.

import { colours, grain, label, prepare, scatter, shade_of, short } from "./canvas.mjs";

export function draw(canvas, { drawn, frame, keep }) {
  const { context, width, height } = prepare(canvas, keep);
  const theme = colours();
  const [left, right, bottom, top] = frame.box;
  const place = fitted(frame.box, width, height, drawn.each === 2 && width > 600 ? INSET : 0);
  const flat = frame.flat ?? ((point) => point);
  const { size, alpha } = grain(drawn.count);
  scatter(context, drawn.count, theme.ramp, shade_of(drawn),
    (k) => place(flat(drawn.points.subarray(3 * k, 3 * k + 3))), size, alpha);
  if (keep || frame.flat) return;
  const [west, south] = place([left, bottom]);
  const [east, north] = place([right, top]);
  const rough = (x) => short(Number(x.toPrecision(2)));
  label(context, rough(left), west, south + 16, theme.faint, "left");
  label(context, rough(right), east, south + 16, theme.faint, "right");
  label(context, rough(bottom), west - 8, south - 5, theme.faint, "right");
  label(context, rough(top), west - 8, north + 5, theme.faint, "right");
}

// Equal scales that fill the canvas, beside its upper left corner where the uniforms' square would be in the way.
const MARGIN = 26;
const INSET = 128;
function fitted([left, right, bottom, top], width, height, inset) {
  const within = (from) => {
    const scale = Math.min((width - from - MARGIN) / (right - left), (height - 2 * MARGIN) / (top - bottom));
    return ([x, y]) => [
      (from + width - MARGIN) / 2 + (x - (left + right) / 2) * scale,
      height / 2 - (y - (bottom + top) / 2) * scale,
    ];
  };
  const full = within(MARGIN);
  const [west, north] = full([left, top]);
  return west - MARGIN < inset && north - MARGIN < inset && inset > 0 ? within(inset + MARGIN) : full;
}

// The unit square that the same points come from, in the same colours.
export function draw_uniforms(canvas, { drawn }) {
  const { context, width, height } = prepare(canvas);
  const theme = colours();
  const { size, alpha } = grain(drawn.count);
  const edge = Math.min(width, height) - 2;
  scatter(context, drawn.count, theme.ramp, shade_of(drawn),
    (k) => [1 + drawn.uniforms[2 * k] * edge, 1 + (1 - drawn.uniforms[2 * k + 1]) * edge],
    size * 0.7, alpha);
  context.strokeStyle = theme.rule;
  context.strokeRect(0.5, 0.5, edge + 1, edge + 1);
}
