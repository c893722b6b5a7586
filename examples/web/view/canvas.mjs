// What all pictures share: a canvas as sharp as the screen, the colours of the style sheet, scales and scattered points.

// A canvas cleared and scaled so that one unit is one CSS pixel.
export function prepare(canvas, keep = false) {
  const { clientWidth: width, clientHeight: height } = canvas;
  const scale = Math.min(window.devicePixelRatio || 1, 3);
  const [across, down] = [Math.round(width * scale), Math.round(height * scale)];
  if (canvas.width !== across || canvas.height !== down) [canvas.width, canvas.height] = [across, down];
  const context = canvas.getContext("2d");
  context.setTransform(scale, 0, 0, scale, 0, 0);
  if (!keep) context.clearRect(0, 0, width, height);
  return { context, width, height };
}

// The colours of the style sheet, light or dark as the visitor prefers.
export function colours() {
  const style = getComputedStyle(document.documentElement);
  const named = (name) => style.getPropertyValue(`--${name}`).trim();
  const stops = ["ramp-0", "ramp-1", "ramp-2"].map((name) => named(name).split(" ").map(Number));
  return { ink: named("ink"), faint: named("faint"), rule: named("rule"), accent: named("accent"), bars: named("bars"), warn: named("warn"), ramp: ramp(stops) };
}

const SHADES = 32;
function ramp(stops) {
  return Array.from({ length: SHADES }, (_, k) => {
    const t = (k / (SHADES - 1)) * (stops.length - 1);
    const low = Math.min(Math.floor(t), stops.length - 2);
    const mixed = stops[low].map((c, i) => Math.round(c + (stops[low + 1][i] - c) * (t - low)));
    return `rgb(${mixed.join(" ")})`;
  });
}

// Points in their colours, one colour after another; `at` gives a place, or nothing for a point not to be drawn.
export function scatter(context, count, ramp_of, shade, at, size, alpha) {
  const groups = ramp_of.map(() => []);
  for (let k = 0; k < count; k += 1) groups[Math.min(SHADES - 1, Math.floor(shade(k) * SHADES))].push(k);
  context.save();
  context.globalAlpha = alpha;
  groups.forEach((members, index) => {
    context.fillStyle = ramp_of[index];
    for (const k of members) {
      const place = at(k);
      if (place) context.fillRect(place[0] - size / 2, place[1] - size / 2, size, size);
    }
  });
  context.restore();
}

// How large and how opaque a point is drawn, the more there are the less.
export const grain = (count) => ({
  size: count <= 1024 ? 2.6 : count <= 8192 ? 1.8 : 1.2,
  alpha: count <= 4096 ? 0.85 : count <= 16384 ? 0.6 : 0.4,
});

// Some round numbers between two ends.
export function ticks(low, high, about = 5) {
  const rough = (high - low) / about;
  if (!(rough > 0) || !Number.isFinite(rough)) return [];
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((factor) => factor * power).find((candidate) => candidate >= rough);
  const first = Math.ceil(low / step - 1e-9);
  const count = Math.floor(high / step + 1e-9) - first + 1;
  return Array.from({ length: Math.max(0, count) }, (_, k) => Number(((first + k) * step).toPrecision(12)));
}

export const short = (x) => (x !== 0 && (Math.abs(x) >= 1e5 || Math.abs(x) < 1e-3) ? x.toExponential(0) : String(Number(x.toPrecision(4))));

export function path(context, points) {
  context.beginPath();
  points.forEach(([x, y], k) => (k === 0 ? context.moveTo(x, y) : context.lineTo(x, y)));
}

export function label(context, text, x, y, colour, align = "center", baseline = "middle") {
  context.font = "12px system-ui, sans-serif";
  context.fillStyle = colour;
  context.textAlign = align;
  context.textBaseline = baseline;
  context.fillText(text, x, y);
}

// Which colour a point has: that of its first uniform, or of its turn where it has none.
export const shade_of = ({ uniforms, each, count }) => (each > 0 ? (k) => uniforms[each * k] : (k) => k / count);
