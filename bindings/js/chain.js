// Metropolis chains with a target in JavaScript: the module proposes and decides, the target is called between.

import { IN, OUT, numbers, point, put, refuse, wasm, words_at } from "./core.js";

const OUTCOMES = ["rejected", "accepted", "refused"];

export class Chain {
  // The places in the memory: step, widths, state, words.
  constructor(target, start, { normal, box, cube }) {
    const dimensions = typeof start === "number" ? 1 : start.length;
    this._target = target;
    this._head = [normal ? 1 : 0, cube === undefined ? 0 : 1];
    this._large = cube ?? 0;
    this._widths = numbers(normal ?? box, dimensions);
    this._words = dimensions + 1 + this._head[1];
    this.state = point_of(numbers(start, dimensions));
    this._propose(new Uint32Array(this._words));
    this.density = Math.fround(target(this.state));
    this._settle(this.density, 0);
    this.reset();
  }
  reset() {
    return Object.assign(this, { steps: 0, accepted: 0, refused: 0 });
  }
  get acceptanceRate() {
    return this.steps > 0 ? this.accepted / this.steps : undefined;
  }
  step(source) {
    const words = new Uint32Array(this._words);
    source._words(OUT * 4, this._words, 1);
    words.set(words_at(OUT, this._words));
    const { state: from, density: fromDensity } = this;
    const proposed = this._propose(words);
    const proposedDensity = Math.fround(this._target(proposed));
    const outcome = this._settle(proposedDensity, words[this._words - 1]);
    const acceptance = point(OUT, 1);
    this.steps += 1;
    if (outcome === 1) {
      this.accepted += 1;
      this.state = proposed;
      this.density = proposedDensity;
    } else if (outcome === 2) this.refused += 1;
    return { from, fromDensity, proposed, proposedDensity, acceptance, outcome: OUTCOMES[outcome] };
  }
  save() {
    const { state, density, steps, accepted, refused } = this;
    return { state, density, steps, accepted, refused };
  }
  resume(saved) {
    return Object.assign(this, saved);
  }

  // What a step proposes: the step lies in front of the widths, the words and the state behind them.
  _propose(words) {
    const dimensions = this._widths.length;
    words_at(IN, 2).set(this._head);
    put(IN + 2, this._large, 1);
    put(IN + 3, this._widths, dimensions);
    const [at, state] = [IN + 3 + dimensions, IN + 3 + dimensions + this._words];
    words_at(at, this._words).set(words);
    put(state, this.state, dimensions);
    refuse(wasm.propose(IN * 4, (IN + 3) * 4, at * 4, state * 4, dimensions));
    return point(state, dimensions);
  }
  _settle(proposed, word) {
    const outcome = wasm.settle(this.density, proposed, word, OUT * 4);
    // A start without a density is what a table of nothing is.
    if (outcome === 3) throw new RangeError("the target must be positive and finite at the start");
    return outcome;
  }
}

const point_of = (numbers) => (numbers.length === 1 ? Math.fround(numbers[0]) : numbers.map(Math.fround));
