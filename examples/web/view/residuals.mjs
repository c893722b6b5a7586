// The error of every point over its first uniform, between the bounds that are stated.

import { colours, path, prepare } from "./canvas.mjs";

export function draw(canvas, { judged }) {
  const { context, width, height } = prepare(canvas);
  const theme = colours();
  const { residuals, signed, error } = judged;
  const most = Math.max(error.stated ?? 0, error.max) * 1.08 || 1;
  const [top, bottom] = [6, height - 6];
  const up = (y) => (signed ? (top + bottom) / 2 - (y / most) * ((bottom - top) / 2) : bottom - (y / most) * (bottom - top));
  context.strokeStyle = theme.rule;
  context.lineWidth = 1;
  path(context, [[0, up(0)], [width, up(0)]]);
  context.stroke();
  context.fillStyle = theme.accent;
  context.globalAlpha = residuals.length > 8192 ? 0.25 : 0.5;
  for (const [u, off] of residuals) context.fillRect(u * width, up(off) - 0.75, 1.5, 1.5);
  context.globalAlpha = 1;
  if (error.stated === null || error.stated === 0) return;
  context.setLineDash([4, 4]);
  context.strokeStyle = theme.faint;
  for (const bound of signed ? [error.stated, -error.stated] : [error.stated]) {
    path(context, [[0, up(bound)], [width, up(bound)]]);
    context.stroke();
  }
  context.setLineDash([]);
}
