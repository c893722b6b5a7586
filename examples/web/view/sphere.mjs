// Directions, or points of the ball, on a sphere that can be turned with the mouse, a finger or the arrow keys.

import { colours, grain, path, prepare, scatter, shade_of } from "./canvas.mjs";

const START = { yaw: -0.6, pitch: 0.45 };
const turn = { ...START };

// Turning by drag and by keys; calls back when the view has changed. `active` says whether there is a sphere to turn.
export function make_turnable(canvas, active, changed) {
  let from = null;
  const by = (yaw, pitch) => {
    turn.yaw += yaw;
    turn.pitch = Math.min(Math.max(turn.pitch + pitch, -Math.PI / 2), Math.PI / 2);
    changed();
  };
  canvas.addEventListener("pointerdown", (event) => {
    if (!active()) return;
    from = [event.clientX, event.clientY];
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointermove", ({ clientX, clientY }) => {
    if (!from) return;
    by((clientX - from[0]) / 120, (clientY - from[1]) / 120);
    from = [clientX, clientY];
  });
  for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, () => (from = null));
  const keys = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] };
  canvas.addEventListener("keydown", (event) => {
    if (!active()) return;
    if (event.key in keys) by(...keys[event.key]);
    else if (event.key === "Home") by(START.yaw - turn.yaw, START.pitch - turn.pitch);
    else return;
    event.preventDefault();
  });
}

// +z is up. Gives the place on the screen, right and up, and the depth towards the viewer.
function seen([x, y, z]) {
  const [cosine, sine] = [Math.cos(turn.yaw), Math.sin(turn.yaw)];
  const [right, away] = [x * cosine - y * sine, x * sine + y * cosine];
  return [right, z * Math.cos(turn.pitch) + away * Math.sin(turn.pitch), z * Math.sin(turn.pitch) - away * Math.cos(turn.pitch)];
}

export function draw(canvas, { drawn }) {
  const { context, width, height } = prepare(canvas);
  const theme = colours();
  const radius = Math.min(width, height) / 2 - 22;
  const place = ([right, up]) => [width / 2 + right * radius, height / 2 - up * radius];
  context.strokeStyle = theme.rule;
  context.lineWidth = 1;
  context.beginPath();
  context.arc(width / 2, height / 2, radius, 0, 2 * Math.PI);
  context.stroke();
  graticule(context, place, false);
  const { size, alpha } = grain(drawn.count);
  const side = (front) => (k) => {
    const point = seen(drawn.points.subarray(3 * k, 3 * k + 3));
    return point[2] >= 0 === front ? place(point) : null;
  };
  const shade = shade_of(drawn);
  scatter(context, drawn.count, theme.ramp, shade, side(false), size, alpha * 0.22);
  graticule(context, place, true);
  scatter(context, drawn.count, theme.ramp, shade, side(true), size, alpha);
}

// Parallels and meridians, those on the far side fainter.
function graticule(context, place, front) {
  const arcs = [];
  const steps = Array.from({ length: 73 }, (_, k) => (k / 72) * 2 * Math.PI);
  for (let parallel = 1; parallel < 6; parallel += 1) {
    const [sine, cosine] = [Math.sin((parallel * Math.PI) / 6), Math.cos((parallel * Math.PI) / 6)];
    arcs.push(steps.map((phi) => [sine * Math.cos(phi), sine * Math.sin(phi), cosine]));
  }
  for (let meridian = 0; meridian < 6; meridian += 1) {
    const phi = (meridian * Math.PI) / 6;
    arcs.push(steps.map((theta) => [Math.sin(theta) * Math.cos(phi), Math.sin(theta) * Math.sin(phi), Math.cos(theta)]));
  }
  context.save();
  context.globalAlpha = front ? 0.8 : 0.35;
  for (const arc of arcs) {
    let run = [];
    for (const point of [...arc.map(seen), null]) {
      if (point && point[2] >= 0 === front) run.push(place(point));
      else {
        path(context, run);
        context.stroke();
        run = [];
      }
    }
  }
  context.restore();
}
