// Directions about +z turned onto a normal, and back.

import { BUFFERS, OUT, numbers, point, put, refuse, wasm } from "./core.js";

export class Frame {
  #normal;
  constructor(normal) {
    this.#normal = numbers(normal, 3);
    this.#turned([0, 0, 1], false);
  }
  #turned(direction, back) {
    put([...this.#normal, ...numbers(direction, 3)], 6);
    refuse(wasm.turn(BUFFERS, back));
    return point(OUT, 3);
  }
  toWorld(direction) {
    return this.#turned(direction, false);
  }
  toLocal(direction) {
    return this.#turned(direction, true);
  }
}
