// Laws that are no warps: made by their kind, and asked.

import { BUFFERS, numbers, wasm, written } from "./core.js";

// A law that is no warp, by its kind, its parameters and the integers among them; there is room for any, as src/laws.rs has it.
export const law_of = (kind, parameters, ...integers) => {
  const flat = parameters.flatMap((parameter) => numbers(parameter, 1));
  while (flat.length < 2) flat.push(0);
  return written(272, [], flat, (to, from) => wasm.law(to, kind, from, ...integers));
};
// Asks it for `count` numbers.
export const ask = (law, kind, what, count, random) => wasm.ask(kind, what, law.address(), BUFFERS, count, random);
