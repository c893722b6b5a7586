// The light of a scene as colours of a screen. A range sensor's echo is a distance instead: near is yellow, far is blue.

// Film that saturates slowly, and the exponent of a screen.
const tone = (light) => 255 * (1 - Math.exp(-1.5 * light)) ** (1 / 2.2);

const exposed = (gain) => (light) => light.map((x) => tone(gain * x));

// Half of the mean way, weighed by what comes back, in metres.
const FARTHEST = 11;
const STOPS = [[255, 240, 160], [244, 150, 66], [186, 58, 92], [72, 40, 116], [14, 16, 44]];
function ranged([light, way]) {
  const range = light > 0 ? (0.5 * way) / light : 0;
  const place = Math.min(Math.max(range / FARTHEST, 0), 1) * (STOPS.length - 1);
  const before = Math.min(Math.floor(place), STOPS.length - 2);
  return STOPS[before].map((stop, k) => stop + (place - before) * (STOPS[before + 1][k] - stop));
}

const DEVELOPED = { sensor: ranged, slivers: exposed(0.8) };

// Draws rows of a picture, the first of them `from` from the top.
export function expose(canvas, { scene, width, from, light }) {
  const develop = DEVELOPED[scene] ?? exposed(1);
  const rows = new ImageData(width, light.length / 3 / width);
  for (let k = 0; 3 * k < light.length; k += 1) rows.data.set([...develop(Array.from(light.subarray(3 * k, 3 * k + 3))), 255], 4 * k);
  canvas.getContext("2d").putImageData(rows, 0, from);
}
