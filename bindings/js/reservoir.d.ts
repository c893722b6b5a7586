import { Source } from "./source.js";

/**
 * Up to `places` items of a stream of any length, drawn one after the other without replacement, each by its weight among those that
 * are left. Items are anything; weights are integers below 2³², and an item of weight 0 is never held.
 */
export declare class WeightedReservoir<T = unknown> {
  /** @throws RangeError for no places, or more than 8,192. */
  constructor(places: number);
  readonly places: number;
  /** Offers an item, by one word of the source whatever its weight; true where it is held now. */
  offer(item: T, weight: number, source: Source): boolean;
  /** Adds what the reservoir of another part of the stream holds. This one is then the one of the whole stream. */
  merge(other: WeightedReservoir<T>): void;
  /** The items that are held, in the order in which they would be drawn. */
  items(): T[];
}
