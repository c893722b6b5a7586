// Several items of a stream by weight: each gets a time from the module, and the earliest are held.

import { BLOCK, BUFFERS, drawn, integer, put_words, ready, refuse, u32_of, wasm, word_at, wrong } from "./core.js";

// A time has so many words.
const TIME = 4;

// Whether a time comes before another.
const earlier = (time, other) => {
  const both = new Uint32Array(2 * TIME);
  both.set(time);
  both.set(other, TIME);
  put_words(both);
  return wasm.earlier(BUFFERS, 0, 0) > 0;
};

export class WeightedReservoir {
  #places;
  // By time, each as [time, item].
  #held = [];
  constructor(places) {
    this.#places = integer("places", places, 1, BLOCK);
  }
  // Puts an item in its place, if it is early enough.
  #take(time, item) {
    const held = this.#held;
    if (held.length === this.#places && !earlier(time, held[held.length - 1][0])) return false;
    // Behind those of the same time.
    let [from, to] = [0, held.length];
    while (from < to) {
      const middle = from + to >> 1;
      if (earlier(time, held[middle][0])) to = middle;
      else from = middle + 1;
    }
    held.splice(from, 0, [time, item]);
    held.length = Math.min(held.length, this.#places);
    return true;
  }
  get places() {
    return this.#places;
  }
  offer(item, weight, source) {
    u32_of("weight", weight);
    drawn(ready(source, 1, 1));
    if (weight === 0) return false;
    refuse(wasm.earlier(BUFFERS, weight, word_at(0)));
    return this.#take(Uint32Array.from({ length: TIME }, (_, i) => word_at(i)), item);
  }
  merge(other) {
    if (!(other instanceof WeightedReservoir)) throw wrong("a WeightedReservoir", other);
    // It holds what it holds.
    if (other === this) return;
    for (const [time, item] of other.#held) this.#take(time, item);
  }
  items() {
    return this.#held.map(([, item]) => item);
  }
}
