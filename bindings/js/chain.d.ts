import { Source } from "./source.js";

/** How a chain moves: a width for each coordinate, of a normal step or of a uniform one in a box. */
export type Step<State> = ({ normal: Readonly<State> } | { box: Readonly<State> }) & {
  /** For states in the unit cube, whose opposite faces meet: the probability of a step to a uniform point of it. */
  cube?: number;
  /**
   * Whether the target returns the natural logarithm of the density, up to a summand; −Infinity stands for a density of 0.
   * The densities that the chain reports are logarithms then.
   */
  logDensity?: boolean;
};

/** What a step did. */
export interface Transition<State> {
  from: State;
  fromDensity: number;
  proposed: State;
  proposedDensity: number;
  /** The probability with which the proposal was to be accepted. Record both states, weighted with it and the rest. */
  acceptance: number;
  /** A proposal is refused where its density is negative, NaN or infinite, or its logarithm NaN or Infinity. */
  outcome: "accepted" | "rejected" | "refused";
}

export interface Saved<State> {
  state: State;
  density: number;
  steps: number;
  accepted: number;
  refused: number;
}

/** A Metropolis chain: states in proportion to a target that is known only up to a factor. */
export interface Chain<State extends number | number[]> {
  readonly state: State;
  readonly density: number;
  readonly steps: number;
  readonly accepted: number;
  readonly refused: number;
  /** The share of accepted steps, once there are any. */
  readonly acceptanceRate: number | undefined;
  step(source: Source): Transition<State>;
  /** Sets the counts to 0, after the steps of a burn-in. */
  reset(): this;
  /** What `resume` needs to go on. */
  save(): Saved<State>;
  resume(saved: Saved<State>): this;
}

/** Makes chains, whose states are numbers or arrays; an array written out has its length in its type. */
export declare const Chain: {
  /** @throws RangeError for widths that are refused, or a density that is not positive and finite at the start. */
  new <State extends number = number>(
    target: (state: number) => number,
    start: State,
    step: Step<number>,
  ): Chain<number>;
  new <State extends number[] | [number]>(
    target: (state: State) => number,
    start: State,
    step: Step<State>,
  ): Chain<State>;
  readonly prototype: Chain<number | number[]>;
};
