import type { Vector3 } from "./warp.js";

/**
 * A right-handed frame whose third axis is a normal, of any finite length but 0: it turns directions about +z onto that normal, and
 * back. A density is that of the direction turned back. Next to the rim of a domain that may already be outside, so take the density
 * of a sample with the sample.
 */
export declare class Frame {
  /** @throws RangeError for a normal that is not finite, or has no length. */
  constructor(normal: Vector3);
  toWorld(direction: Vector3): [number, number, number];
  toLocal(direction: Vector3): [number, number, number];
}
