// A histogram of points on the line with their density over it; and, for tables, bars with the shares.

import { colours, label, path, prepare, short, ticks } from "./canvas.mjs";

const BINS = 72;
const MARGIN = { left: 14, right: 14, top: 16, bottom: 34 };

// Counts points into a tally that goes on from picture to picture while the page runs.
export function tally(previous, { view, drawn, frame }) {
  const bars = view === "bars";
  const [low, high] = bars ? [-0.5, frame.shares.length - 0.5] : frame.range;
  const bins = bars ? frame.shares.length : BINS;
  const same = previous && previous.low === low && previous.high === high && previous.counts.length === bins;
  const { counts, total } = same ? previous : { counts: new Array(bins).fill(0), total: 0 };
  for (let k = 0; k < drawn.count; k += 1) {
    const bin = Math.floor(((drawn.points[3 * k] - low) / (high - low)) * bins);
    // The upper end, where a rounded point may lie, belongs to the last.
    const last = drawn.points[3 * k] === high ? bins - 1 : bin;
    if (last >= 0 && last < bins) counts[last] += 1;
  }
  return { low, high, counts, total: total + drawn.count };
}

export function draw(canvas, { frame, tallied: { low, high, counts, total } }) {
  const { context, width, height } = prepare(canvas);
  const theme = colours();
  const across = (x) => MARGIN.left + ((x - low) / (high - low)) * (width - MARGIN.left - MARGIN.right);
  const bin = (high - low) / counts.length;
  const densities = counts.map((n) => n / total / bin);
  const curve = Array.from({ length: 481 }, (_, k) => low + ((high - low) * k) / 480).map((x) => [x, frame.pdf(x)]);
  // A density may be infinite at an end; the bars always fit.
  const inner = curve.slice(4, -4).map(([, y]) => y);
  const top = 1.08 * Math.max(...densities, Math.min(Math.max(...inner), 1.5 * Math.max(...densities)));
  const up = (y) => height - MARGIN.bottom - (Math.min(y, 1.02 * top) / top) * (height - MARGIN.bottom - MARGIN.top);
  context.fillStyle = theme.bars;
  densities.forEach((density, k) => {
    const [left, right] = [across(low + k * bin), across(low + (k + 1) * bin)];
    context.fillRect(left + 0.5, up(density), Math.max(right - left - 1, 0.5), up(0) - up(density));
  });
  context.save();
  context.beginPath();
  context.rect(0, MARGIN.top - 2, width, height);
  context.clip();
  path(context, curve.map(([x, y]) => [across(x), up(y)]));
  context.strokeStyle = theme.accent;
  context.lineWidth = 2;
  context.lineJoin = "round";
  context.stroke();
  context.restore();
  axis(context, theme, across, ticks(low, high, width < 480 ? 5 : 9), up(0), [MARGIN.left, width - MARGIN.right], short);
}

export function draw_bars(canvas, { frame: { shares }, tallied: { counts, total } }) {
  const { context, width, height } = prepare(canvas);
  const theme = colours();
  const slot = (width - MARGIN.left - MARGIN.right) / counts.length;
  const top = 1.12 * Math.max(...shares, ...counts.map((n) => n / total));
  const up = (y) => height - MARGIN.bottom - (y / top) * (height - MARGIN.bottom - MARGIN.top);
  counts.forEach((n, k) => {
    const middle = MARGIN.left + (k + 0.5) * slot;
    context.fillStyle = theme.bars;
    context.fillRect(middle - slot * 0.32, up(n / total), slot * 0.64, up(0) - up(n / total));
    context.fillStyle = theme.accent;
    context.fillRect(middle - slot * 0.4, up(shares[k]) - 1, slot * 0.8, 2);
    label(context, `${(100 * n / total).toFixed(1)} %`, middle, Math.min(up(n / total), up(shares[k])) - 10, theme.faint);
  });
  const middles = counts.map((_, k) => k);
  axis(context, theme, (k) => MARGIN.left + (k + 0.5) * slot, middles, up(0), [MARGIN.left, width - MARGIN.right], String);
}

function axis(context, theme, across, at, base, [left, right], text) {
  context.strokeStyle = theme.rule;
  context.lineWidth = 1;
  path(context, [[left, base + 0.5], [right, base + 0.5]]);
  context.stroke();
  for (const x of at) {
    path(context, [[across(x), base], [across(x), base + 5]]);
    context.stroke();
    label(context, text(x), across(x), base + 18, theme.faint);
  }
}
