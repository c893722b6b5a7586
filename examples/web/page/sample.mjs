// Points and densities of what the package makes, and what its typings say of a class.

export const MOST = 1 << 16;
export const SOURCES = ["random", "stratified", "low-discrepancy"];
// What may be stratified: as many strata as points, as nearly square as a power of two allows.
const strata = ({ Strata }, each, count) => {
  const rows = 2 ** Math.floor(Math.log2(count) / 2);
  return each === 1 ? new Strata(count) : new Strata(count / rows, rows);
};
export const is_offered = (source, each) => source === "random" || (source === "stratified" ? each === 1 || each === 2 : each > 0);

function uniforms_of(microwarp, { source, each, count, seed }) {
  const [uniforms, rng] = [new Float32Array(each * count), new microwarp.Pcg32(seed)];
  if (source === "stratified") return strata(microwarp, each, count).uniforms(uniforms, rng);
  return (source === "random" ? rng : new microwarp.Sobol(seed)).uniforms(uniforms, each);
}

// Three numbers a point, for the views.
export function spread(points, dimensions) {
  const spread = new Float64Array((3 * points.length) / dimensions);
  for (let k = 0; 3 * k < spread.length; k += 1) spread.set(points.slice(dimensions * k, dimensions * k + Math.min(dimensions, 3)), 3 * k);
  return spread;
}

// Of a warp, by uniforms of a source; of what else the package makes, by a generator.
export function sample(microwarp, made, { source, count, seed }) {
  const densities = new Float32Array(count);
  if (made instanceof microwarp.Warp) {
    const { uniforms: each, dimensions } = made;
    const uniforms = uniforms_of(microwarp, { source, each, count, seed });
    const points = microwarp.mapWithPdf(made, uniforms, new Float32Array(dimensions * count), densities);
    return { count, points: spread(points, dimensions), densities, uniforms, each, dimensions };
  }
  const [rng, points] = [new microwarp.Pcg32(seed), []];
  for (let k = 0; k < count; k += 1) {
    const point = made.step ? (made.step(rng), made.state) : made.draw(rng);
    densities[k] = made.step ? made.density : made.pmf ? made.pmf(point) : made.pdf(point);
    points.push(point);
  }
  const dimensions = [points[0]].flat().length;
  return { count, points: spread(points.flat(), dimensions), densities, each: 0, dimensions, indices: Boolean(made.pmf) };
}

// Nanoseconds a point: the quickest of several runs, each of at least so many milliseconds, which a browser's clock can tell.
const LONG_ENOUGH = 5;
export function nanoseconds(microwarp, made) {
  const [rng, points] = [new microwarp.Pcg32(1), new Float32Array((made.dimensions ?? 0) << 14)];
  const run = made.dimensions ? () => made.fill(points, rng) : () => sample(microwarp, made, { count: 1 << 14, seed: 1 });
  const clocked = (times) => {
    const began = performance.now();
    for (let k = 0; k < times; k += 1) run();
    return performance.now() - began;
  };
  let times = 1;
  while (clocked(times) < LONG_ENOUGH) times *= 2;
  return (Math.min(...Array.from({ length: 5 }, () => clocked(times))) * 1e6) / (times << 14);
}

const TYPINGS = ["warps", "table", "tree", "counts", "rejection", "mixture", "lamps", "chain"];
const CLASS = /\/\*\*((?:(?!\*\/)[^])*)\*\/\s*export (?:declare )?(?:abstract )?(?:class|interface) (\w+)/g;

// By class: the first sentence, and the rows of the table of errors in the documentation.
export async function documented(folder) {
  const texts = await Promise.all(TYPINGS.map(async (name) => (await fetch(`${folder}/${name}.d.ts`)).text()));
  return Object.fromEntries(Array.from(texts.join("\n").matchAll(CLASS), ([, doc, name]) => {
    const lines = doc.split("\n").map((line) => line.replace(/^\s*\* ?/, ""));
    const [summary] = /^.*?\.(?= |$)/.exec(lines.join(" ").trim().replaceAll("`", "")) ?? [""];
    const rows = lines.filter((line) => line.startsWith("| ")).slice(1).map((line) => line.split("|").slice(1, 4).map((cell) => cell.trim()));
    return [name, { summary, bounds: rows }];
  }));
}
