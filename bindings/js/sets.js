// Sets of points, and strata.

import { IN, OUT, elements, in_blocks, point, put, refuse, wasm, take } from "./core.js";
import { Source } from "./source.js";

class Points extends Source {
  constructor(by_position, seed, pixel) {
    super();
    Object.assign(this, { by_position, seed, pixel, index: 0, dimension: 0 });
  }
  at(index, dimension = 0) {
    return Object.assign(Object.create(Object.getPrototypeOf(this)), this, { index, dimension });
  }
  _words(address, each, count) {
    wasm.points(this.by_position, this.seed, this.pixel, this.index, this.dimension, address, each, count);
    this.index += count;
  }
}
export class Sobol extends Points {
  constructor(seed = 0) {
    super(0, seed, 0);
  }
}
export class ByPosition extends Points {
  constructor(seed, pixel) {
    super(1, seed, pixel);
  }
}

export class Strata {
  constructor(columns, rows = 0) {
    Object.assign(this, { columns, rows, _each: rows ? 2 : 1 });
    this._place(0, 0);
  }
  // Turns uniforms in the memory into those of strata.
  _place(from, count) {
    refuse(wasm.strata(this.columns, this.rows, from, IN * 4, count));
  }
  place(index, jitter) {
    put(IN, jitter, this._each);
    this._place(index, 1);
    return point(IN, this._each);
  }
  uniforms(uniforms, source, from = 0) {
    const each = this._each;
    in_blocks(elements(uniforms, Float32Array, each), source, each, uniforms, each, (n) => {
      wasm.uniforms(IN * 4, n * each, 0);
      this._place(from, n);
      take(OUT, n * each).set(take(IN, n * each));
      from += n;
    });
    return uniforms;
  }
}
