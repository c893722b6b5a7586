// The code that the tab "In JavaScript" offers: each runs as it stands, and is there to be changed.

export const SNIPPETS = {
  normals: ["Normals", `import { Normal, Pcg32 } from "microwarp";

const noise = new Normal(20, 0.5);
show(noise.fill(new Float32Array(10000), new Pcg32(42)), noise);

console.log("density at 20:", noise.pdf(20));
console.log("share below 21:", noise.invert(21));
`],
  lens: ["Points of a lens", `import { Disk, Pcg32, Sobol } from "microwarp";

const lens = new Disk();
const even = new Sobol(7); // or new Pcg32(), which is random
show(lens.fill(new Float32Array(2 * 1024), even), lens);
`],
  lamp: ["Towards a lamp", `import { SphericalRectangle, Strata, Pcg32 } from "microwarp";

// Directions to a rectangle, evenly over what is seen of it.
const lamp = new SphericalRectangle([0, 0, 0], [-0.5, -0.7, 1], [[1, 0, 0], [0, 1.4, 0]]);
const uniforms = new Strata(64, 64).uniforms(new Float32Array(2 * 4096), new Pcg32(1));
show(lamp.map(uniforms, new Float32Array(3 * 4096)), lamp);

console.log("density of the first:", lamp.pdf(lamp.sample([uniforms[0], uniforms[1]])));
`],
  die: ["A loaded die", `import { Alias, Pcg32 } from "microwarp";

const die = new Alias([1, 1, 1, 1, 1, 3]);
show(die.fill(new Uint32Array(10000), new Pcg32(42)), die);

console.log("probability of the last:", die.pmf(5));
`],
  sky: ["A sky", `import { LatLongMap, Pcg32 } from "microwarp";

// Rows from the pole +z; in one pixel there is a sun.
const sky = new LatLongMap([1, 1, 1, 1, 2, 2, 2, 90, 0, 0, 0, 0], [4, 3]);
show(sky.fill(new Float32Array(3 * 4096), new Pcg32(42)), sky);
`],
  chain: ["A chain", `import { Chain, Pcg32 } from "microwarp";

const rng = new Pcg32(7);
const target = ([x, y]) => Math.exp(-x * x - (y - x * x) ** 2);
const chain = new Chain(target, [0, 0], { normal: [0.7, 0.7] });
const states = new Float32Array(2 * 8192);
for (let i = 0; i < states.length; i += 2) {
  chain.step(rng);
  states.set(chain.state, i);
}
show(states, 2);

console.log("accepted:", chain.acceptanceRate);
`],
};
