// The golden table as the package yields it: for its tests, and for the page in a browser.

export const bits = (numbers) => Array.from(new Uint32Array(Float32Array.from([numbers].flat(Infinity)).buffer));
const floats = (bits) => Array.from(new Float32Array(Uint32Array.from(bits).buffer));
export const hex = (word) => word.toString(16).padStart(8, "0");
// Every NaN is one in the table.
const words = (...numbers) => bits(numbers).map((word) => hex((word & 0x7fffffff) > 0x7f800000 ? 0x7fc00000 : word)).join();

export const made = (microwarp, name, maker, given) => (maker === "new" ? new microwarp[name](...given) : microwarp[name][maker](...given));

// The sixteen lines of a warp: of the table's uniforms, then of draws. A mixture inverts by a further number.
export const lines = ({ Pcg32 }, uniforms, name, warp, ...behind) => Array.from({ length: 16 }, (_, input) => {
  const u = input < uniforms.length ? floats(uniforms[input]).slice(0, warp.uniforms) : [];
  const point = u.length === 0 ? warp.draw(new Pcg32(0x5eed + input, 54)) : warp.sample(u.length === 1 ? u[0] : u);
  return `poly ${name} #${input},${words(point, warp.pdf(point), warp.invert(point, ...behind))}`;
});

// How many cases of the classes there are, and which are not lines of the table.
export const differing = (microwarp, { golden, uniforms }, table) => {
  const due = new Set(table.split("\n"));
  const found = golden.flatMap(([subject, ...of]) => lines(microwarp, uniforms, subject, made(microwarp, ...of)));
  return { cases: found.length, wrong: found.filter((line) => !due.has(line)).map((line) => /^poly (.*?),/.exec(line)[1]) };
};
