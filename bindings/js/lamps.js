// What lamps and rough surfaces have beside what is a warp: places that are seen, reflections, masking.

import { OUT, point, put, ready, wrong } from "./core.js";
import { asked } from "./lights.js";
import { Warp, inside, warp } from "./warp.js";

// As src/lights.rs has them.
const [GLOSS, SURFACE] = [36, 37];
const [DRAW, SAMPLE, DENSITY] = [0, 1, 2];
const [REFLECTED_PDF, G1, UNMASKED, VISIBILITY] = [2, 3, 4, 5];

// The class of a warp with more members, which ask the module by a function.
const extended = (of, kind, members) => {
  const [, number] = of;
  // What is no warp of this class has nothing to be asked.
  const asks = (value, what, random) => {
    const [loaded, its, table] = value instanceof Warp ? inside(value) : [];
    if (table || its !== number) throw wrong(`a ${of[0].split(" ")[0]}`, value);
    asked(kind, what, loaded.address(), 0, random);
  };
  const Class = warp(...of);
  const { constructor, ...all } = Object.getOwnPropertyDescriptors(members(asks).prototype);
  Object.defineProperties(Class.prototype, all);
  return Class;
};
const vector = (at) => point(at, 3);
const figure = (asks, value, what, direction) => {
  put(direction, 3);
  asks(value, what, 0);
  return point(OUT, 1);
};

export const lamp = (kind, ...of) => extended(of, kind, (asks) => {
  const seen = (value, what, random) => {
    asks(value, what, random);
    const [distance, pdf, ...place] = point(OUT + 3, 4);
    return { direction: vector(OUT), distance, pdf, place };
  };
  return class {
    sampleLight(uniforms) {
      put(uniforms, 2);
      return seen(this, SAMPLE, 0);
    }
    drawLight(source) {
      return seen(this, DRAW, ready(source, 2, 1));
    }
    get density() {
      asks(this, DENSITY, 0);
      return point(OUT, 1);
    }
  };
});

export const gloss = (...of) => extended(of, GLOSS, (asks) => {
  const bounce = (value, what, random) => {
    asks(value, what, random);
    return { normal: vector(OUT), direction: vector(OUT + 3), pdf: point(OUT + 6, 1) };
  };
  return class {
    reflect(uniforms) {
      put(uniforms, 2);
      return bounce(this, SAMPLE, 0);
    }
    drawReflection(source) {
      return bounce(this, DRAW, ready(source, 2, 1));
    }
    reflectedPdf(normal) {
      return figure(asks, this, REFLECTED_PDF, normal);
    }
    get g1() {
      return figure(asks, this, G1, [0, 0, 0]);
    }
    unmasked(direction) {
      return figure(asks, this, UNMASKED, direction);
    }
    visibility(direction) {
      return figure(asks, this, VISIBILITY, direction);
    }
  };
});

export const surface = (...of) => extended(of, SURFACE, (asks) => class {
  distribution(normal) {
    return figure(asks, this, 0, normal);
  }
  g1(direction) {
    return figure(asks, this, 1, direction);
  }
});
