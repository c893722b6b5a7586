// The package without its module, for engines that forbid compiling one from bytes: the caller hands over a compiled one.

import { start, wait } from "./core.js";

wait(new Proxy({}, { get: () => { throw new Error("a module is expected first: call init(module)"); } }));

export const init = (module) => {
  const instance = new WebAssembly.Instance(module);
  if (!instance.exports.look_up) throw new TypeError("the module of this package is expected: microwarp.wasm");
  start({ instance }, 2);
};

export * from "./lib.js";
