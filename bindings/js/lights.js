// What a renderer needs beside warps: reservoirs of lights, weights of several techniques, roulette. What is asked passes through the
// buffers, by kinds as src/lights.rs has them.

import { BLOCK, BUFFERS, OUT, drawn, index_at, integer, numbers, point, put_words, ready, refuse, u32_of, wasm, word_at, wrong } from "./core.js";

const [RESERVOIR, TECHNIQUES, ROULETTE] = [32, 38, 39];
const [REFUSED, NOT_LINKED] = [32, 31];

// Whether the module says yes.
export const asked = (kind, what, at, count, random) => {
  const answer = wasm.ask(kind, what, at, BUFFERS, count, random);
  if (answer === 0) refuse(NOT_LINKED);
  if (answer > REFUSED) refuse(answer - REFUSED);
  return answer > 1;
};
// Numbers as words, from a place on.
const set = (words, numbers, at) => new Float32Array(words.buffer).set(numbers, at);

// --- reservoirs ------------------------------------------------------------------------------------------

const [NEW, OFFER, ABSORB, CAP, NORMALISE, FIGURES] = [0, 1, 2, 3, 4, 5];
// Words of a reservoir; of two behind each other, and the words of a decision behind two numbers.
const ROOM = 8;

// Does something to a copy in the memory of a state, and perhaps of another behind it.
const done = (what, state, other, words) => {
  const all = new Uint32Array(2 * ROOM + 4);
  all.set(state);
  all.set(other, ROOM);
  all.set(words, 2 * ROOM);
  put_words(all);
  return asked(RESERVOIR, what, 0, 0, 0);
};
const changed = () => Uint32Array.from({ length: ROOM }, (_, i) => word_at(i));

export class LightReservoir {
  #state;
  #item;
  constructor() {
    done(NEW, [], [], []);
    this.#state = changed();
  }
  // Decides by two words, once it is known that nothing is refused.
  #decided(what, other, given, source) {
    const words = new Uint32Array(4);
    set(words, given, 0);
    done(what, this.#state, other, words);
    drawn(ready(source, 2, 1));
    words.set([word_at(0), word_at(1)], 2);
    const taken = done(what, this.#state, other, words);
    this.#state = changed();
    return taken;
  }
  offer(item, target, density, source) {
    const taken = this.#decided(OFFER, [], [target, density].flatMap((number) => numbers(number, 1)), source);
    if (taken) this.#item = item;
    return taken;
  }
  absorb(other, target, source) {
    if (!(other instanceof LightReservoir)) throw wrong("a LightReservoir", other);
    const taken = this.#decided(ABSORB, other.#state, numbers(target, 1), source);
    if (taken) this.#item = other.#item;
    return taken;
  }
  #scaled(what, number) {
    done(what, this.#state, [], [number]);
    this.#state = changed();
    // What is let go of is nobody's any more.
    if (this.target === 0) this.#item = undefined;
  }
  cap(limit) {
    this.#scaled(CAP, u32_of("limit", limit));
  }
  normalise(candidates) {
    this.#scaled(NORMALISE, u32_of("candidates", candidates));
  }
  get item() {
    return this.#item;
  }
  get count() {
    done(FIGURES, this.#state, [], []);
    return index_at();
  }
  get target() {
    done(FIGURES, this.#state, [], []);
    return point(OUT + 1, 1);
  }
  get contribution() {
    done(FIGURES, this.#state, [], []);
    return point(OUT + 2, 1);
  }
}

// --- weights ---------------------------------------------------------------------------------------------

const weight = (what, counts, densities, own) => {
  const n = integer("the number of techniques", counts?.length, 1, BLOCK / 2);
  const words = new Uint32Array(2 * n);
  for (let k = 0; k < n; k += 1) words[k] = u32_of("count", counts[k]);
  set(words, numbers(densities, n), n);
  integer("own", own, 0, n - 1);
  put_words(words);
  asked(TECHNIQUES, what, 0, n, own);
  return point(OUT, 1);
};
export const balanceHeuristic = (counts, densities, own) => weight(0, counts, densities, own);
export const powerHeuristic = (counts, densities, own) => weight(1, counts, densities, own);

export const roulette = (chance, source) => {
  const words = new Uint32Array(2);
  set(words, numbers(chance, 1), 0);
  drawn(ready(source, 1, 1));
  words[1] = word_at(0);
  put_words(words);
  return asked(ROULETTE, 0, 0, 0, 0) ? point(OUT, 1) : undefined;
};
