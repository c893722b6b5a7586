// Which picture there is of points, and drawing it.

import { framed } from "./frame.mjs";
import * as line from "./line.mjs";
import * as plane from "./plane.mjs";
import * as sphere from "./sphere.mjs";

const PICTURES = { line: line.draw, bars: line.draw_bars, plane: plane.draw, sphere: sphere.draw };

// Space seen from a corner, z upwards.
const corner = ([x, y, z]) => [(y - x) / Math.sqrt(2), (2 * z - x - y) / Math.sqrt(6)];

function view_of({ count, points, dimensions, indices }) {
  if (indices) return "bars";
  if (dimensions !== 3) return dimensions === 1 ? "line" : "plane";
  const length = (k) => Math.hypot(...points.subarray(3 * k, 3 * k + 3));
  return Array.from({ length: count }, (_, k) => length(k)).every((length) => Math.abs(length - 1) < 1e-3) ? "sphere" : "plane";
}

// Points, three numbers each, with their frame, or that of a picture which goes on.
export function pictured(drawn, before) {
  const view = view_of(drawn);
  const frame = before?.frame ?? framed(drawn, view === "plane" && drawn.dimensions > 2 ? corner : undefined);
  const scene = { view, drawn, frame };
  if (view === "line" || view === "bars") scene.tallied = line.tally(before?.tallied, scene);
  return scene;
}

export const draw = (canvas, scene) => PICTURES[scene.view](canvas, scene);
