// The worker of the tab "In JavaScript": runs code with the npm package. What the code prints and shows goes to the page.

const MOST = 1 << 16;
const entry = new URL("../npm/streaming.js", import.meta.url).href;

const plain = (_, value) => (ArrayBuffer.isView(value) ? Array.from(value) : typeof value === "bigint" ? `${value}n` : value);
const text_of = (value) => (typeof value === "string" ? value : JSON.stringify(value, plain) ?? String(value));
console.log = (...values) => postMessage({ printed: values.map(text_of).join(" ") });

// Shows points of a warp, indices of a table, or with a number in its place points of so many coordinates.
self.show = (points, of) => {
  const dimensions = points instanceof Uint32Array ? 1 : (of.dimensions ?? of);
  if (![1, 2, 3].includes(dimensions)) throw new RangeError("points of 1, 2 or 3 coordinates can be shown");
  const shown = points.slice(0, MOST * dimensions);
  const count = Math.floor(shown.length / dimensions);
  const densities = of.pmf ? Float32Array.from(shown, (index) => of.pmf(index)) : new Float32Array(count);
  of.pdfs?.(shown, densities);
  postMessage({ shown, dimensions, count, densities, indices: points instanceof Uint32Array });
};

onmessage = async ({ data }) => {
  const code = data.replace(/(["'])microwarp\1/g, JSON.stringify(entry));
  try {
    await import(URL.createObjectURL(new Blob([code], { type: "text/javascript" })));
    postMessage({ ended: true });
  } catch (problem) {
    postMessage({ problem: String(problem) });
  }
};
