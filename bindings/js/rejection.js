// Gamma numbers, shares of a whole and angles: by rejection, within a budget of tries.

import { OUT, integer, numbers, point, put, ready } from "./core.js";
import { ask, law_of } from "./laws.js";

// Laws by their kind; of shares it is their number more than the first.
const [GAMMA, VON_MISES, BETA, CHI_SQUARED] = [16, 17, 18, 25];
const [DRAW, PDF, DRAW_LN] = [0, 1, 2];
// The words of a point of a set that a draw can take: those of all tries, of gamma numbers for each number of a point.
const [ANGLE, NUMBER] = [2 * 42, 3 * 16];

const drawn = (law, kind, what, count, source) => {
  const random = ready(source, kind === VON_MISES ? ANGLE : NUMBER * count, 1);
  if (ask(law, kind, what, 1, random) > 0) return point(OUT, count);
  throw new RangeError("a source of random words is expected: within the budget no try was accepted");
};
const pdf = (law, kind, count, at) => {
  put(at, count);
  ask(law, kind, PDF, 1, 0);
  return point(OUT, 1);
};

export class Gamma {
  #law;
  constructor(shape, scale) {
    this.#law = law_of(GAMMA, [shape, scale]);
  }
  static chiSquared(degrees) {
    const law = new Gamma(1, 1);
    law.#law = law_of(CHI_SQUARED, [degrees]);
    return law;
  }
  draw(source) {
    return drawn(this.#law, GAMMA, DRAW, 1, source);
  }
  drawLn(source) {
    return drawn(this.#law, GAMMA, DRAW_LN, 1, source);
  }
  pdf(at) {
    return pdf(this.#law, GAMMA, 1, at);
  }
}

export class VonMises {
  #law;
  constructor(mean, concentration) {
    this.#law = law_of(VON_MISES, [mean, concentration]);
  }
  draw(source) {
    return drawn(this.#law, VON_MISES, DRAW, 1, source);
  }
  pdf(at) {
    return pdf(this.#law, VON_MISES, 1, at);
  }
}

export class Beta {
  #law;
  constructor(a, b) {
    this.#law = law_of(BETA, [a, b]);
  }
  draw(source) {
    return drawn(this.#law, BETA, DRAW, 2, source);
  }
  pdf(shares) {
    return pdf(this.#law, BETA, 2, shares);
  }
}

export class Dirichlet {
  #law;
  #shares;
  constructor(shapes) {
    const count = integer("the number of shapes", shapes?.length, 2, 8);
    this.#law = law_of(GAMMA + count, numbers(shapes, count));
    this.#shares = count;
  }
  get shares() {
    return this.#shares;
  }
  draw(source) {
    return drawn(this.#law, GAMMA + this.#shares, DRAW, this.#shares, source);
  }
  pdf(shares) {
    return pdf(this.#law, GAMMA + this.#shares, this.#shares, shares);
  }
}
