/** An array of anything. */
export type Items = unknown[] | Int8Array | Uint8Array | Uint8ClampedArray | Int16Array | Uint16Array | Int32Array | Uint32Array
  | Float32Array | Float64Array | BigInt64Array | BigUint64Array;

/** Where random words come from. */
export declare abstract class Source {
  /** Fills an array with words of 32 bits; of points, with the words of so many dimensions each. */
  words(words: Uint32Array, dimensions?: number): Uint32Array;
  /** A uniform in [0, 1), of one word, as `uniforms` fills in. */
  uniform(): number;
  /**
   * An integer from 0 to n − 1, of one word: each has ⌊2³²/n⌋ of the 2³² words, or one more.
   *
   * @throws RangeError for an n that is no integer from 1 to 2³².
   */
  below(n: number): number;
  /**
   * An integer from `low` to `high`, both among them, of one word.
   *
   * @throws RangeError where `low` is above `high`, for more than 2³² integers, and for what are none.
   */
  range(low: number, high: number): number;
  /**
   * Whether an event of probability p happens, of one word: ⌈2³²p⌉ of the 2³² words say so, of p as an `f32`. For one in six take
   * `below(6) < 1`.
   *
   * @throws RangeError for a p outside [0, 1], and for NaN.
   */
  chance(p: number): boolean;
  /** Fills an array with uniforms in [0, 1); of points, with so many dimensions each. */
  uniforms(uniforms: Float32Array, dimensions?: number): Float32Array;
  /**
   * Puts the items of an array in a random order, and returns the array. All orders are equally likely. It takes 2 words for up to
   * 12 items, 16 for 52, 612 for 1,000, and of points as many dimensions, from 8,192 on those of the next point.
   *
   * @throws RangeError for more than 2²⁶ items.
   */
  shuffle<A extends Items>(array: A): A;
}

/**
 * The generator PCG32 (PCG XSH RR 64/32). The same seed and stream give the same numbers everywhere, and the same as
 * `rand_pcg::Pcg32` in Rust.
 */
export declare class Pcg32 extends Source {
  /** Without a seed, the generator is seeded from `crypto.getRandomValues`. */
  constructor(seed?: number | bigint, stream?: number | bigint);
  /**
   * One of many generators, of independent words: for worker, thread or pixel `index`. The words of neighbouring seeds or streams
   * of the constructor depend on each other.
   */
  static at(seed: number, index: number): Pcg32;
  /** The state, as two words in hexadecimal: keep it, and go on with `resume`. */
  readonly state: string;
  /**
   * A generator that goes on where another was.
   *
   * @throws RangeError if this is no state.
   */
  static resume(state: string): Pcg32;
}

/** A set of points: each point drawn is the next of the set. */
export declare abstract class Points extends Source {
  /** The index of the next point. */
  index: number;
  /** The dimension from which on words are taken. */
  dimension: number;
  /** The same set from another point on, and from another dimension on. */
  at(index: number, dimension?: number): this;
}

/** Sobol' points of eight dimensions, scrambled by the seed. Best in numbers that are powers of two. */
export declare class Sobol extends Points {
  constructor(seed?: number);
}

/**
 * A Latin hypercube: of `count` points one in each of as many strata of every dimension, in any number of dimensions. Further points
 * are random.
 */
export declare class LatinHypercube extends Points {
  /** @throws RangeError for no points. */
  constructor(count: number, seed?: number);
  readonly count: number;
}

/** Random numbers that are a function of a seed, a pixel, the index of a point and its dimension: there is no state. */
export declare class ByPosition extends Points {
  constructor(seed: number, pixel: number);
}

/**
 * One set of Sobol' points in eight dimensions for all pixels of a picture, in an order by which errors of neighbouring pixels
 * cancel (blue noise), with 2^log2Samples samples a pixel. That must be the number of samples that are taken. Later ones are those
 * of further sets.
 */
export declare class Screen {
  /** @throws RangeError without pixels, for a side above 65536, or where the pixels of a square times the samples are more than 2³². */
  constructor(width: number, height: number, log2Samples: number, seed?: number);
  readonly width: number;
  readonly height: number;
  /**
   * The points of a pixel: its samples, in order.
   *
   * @throws RangeError for a pixel outside of the picture.
   */
  pixel(x: number, y: number): Points;
}

/** Jittered strata: equal intervals of [0, 1), or with `rows` equal cells of the unit square. */
export declare class Strata {
  /** @throws RangeError for no strata, or for more than 2²³ along a side. */
  constructor(columns: number, rows?: number);
  /** The point of stratum `index`, row by row, at a place in [0, 1) or [0, 1)² within it. */
  place(index: number, jitter: number): number;
  place(index: number, jitter: readonly [number, number]): [number, number];
  /** Fills an array with a random point of each stratum, from stratum `from` on; returns the array. */
  uniforms(uniforms: Float32Array, source: Source, from?: number): Float32Array;
}

/** The numbers from 0 to `length` - 1 in the random order of a seed, one by one and back, without a table. */
export declare class Permutation implements Iterable<number> {
  /** @throws RangeError for no numbers. */
  constructor(length: number, seed: number);
  readonly length: number;
  /**
   * The number at a place.
   *
   * @throws RangeError for a place that is not below the length; so too `indexOf`.
   */
  get(place: number): number;
  /** The place of a number. */
  indexOf(number: number): number;
  [Symbol.iterator](): IterableIterator<number>;
}
