/**
 * Takes the compiled module `microwarp.wasm` or `microwarp-simd.wasm` of this package, once, before anything is made.
 *
 * @throws TypeError for another module.
 */
export declare function init(module: WebAssembly.Module): void;
export * from "./index.js";
