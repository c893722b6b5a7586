import { Source } from "./source.js";
import { GgxVisible } from "./warps.js";
import { Vector2, Vector3, Warp } from "./warp.js";

/**
 * A place on a lamp that is seen from a point. The distance is that of the place itself; it is rounded, and so is the ray, so end a
 * shadow ray a little before the lamp.
 */
export interface LightSample {
  /** From the point to the place, a unit vector in world coordinates. */
  direction: [number, number, number];
  distance: number;
  /** The density of the direction, per steradian. */
  pdf: number;
  /**
   * Where on the lamp: [s, t] of corner + s ex + t ey on a rectangle; on a triangle the barycentric coordinates of the second and the
   * third vertex. Both are from 0 to 1. A sphere has none: [0, 0].
   */
  place: [number, number];
}

/** One way for all lamps: `VisibleSphere`, `SphericalTriangle`, `SphericalRectangle`. */
export interface Lamp {
  /** The place of two uniforms; those outside [0, 1), and NaN, are brought into range. Its direction is that of `Warp.sample`. */
  sampleLight(uniforms: Vector2): LightSample;
  /** The place of two words of a source. */
  drawLight(source: Source): LightSample;
  /** The density of every direction that meets the lamp, per steradian: for one that was drawn by other means. */
  readonly density: number;
}

/**
 * A reflection off a microfacet. Carry its density: computed again from two rounded directions, the normal half way between them loses
 * all its digits at small roughness.
 */
export interface Reflection {
  /** The normal of the microfacet: the half vector of view and direction. */
  normal: [number, number, number];
  /** A unit vector; below the surface where its third number is negative. */
  direction: [number, number, number];
  /** The density of the direction, per steradian. */
  pdf: number;
}

/**
 * Reflections of the view, and masking and shadowing after Smith, with heights that view and light share: for every roughness, and for
 * cosines from 1 to 1e-30.
 */
export interface Gloss {
  /** The reflection of the view off the normal of two uniforms; those outside [0, 1), and NaN, are brought into range. */
  reflect(uniforms: Vector2): Reflection;
  /** The reflection off the normal of two words of a source. */
  drawReflection(source: Source): Reflection;
  /** The density of the direction into which a microfacet of this normal reflects the view, per steradian; 0 for one that is not seen. */
  reflectedPdf(normal: Vector3): number;
  /** G₁ of the view, the visible part of the microfacets that face the viewer, from 0 to 1: right to 5.5e-7. */
  readonly g1: number;
  /**
   * G₂/G₁ of a light direction, from 0 to 1: right to 8.5e-7. Times Fresnel's term it is the weight of a reflection. 0 on and below the
   * horizon.
   */
  unmasked(direction: Vector3): number;
  /** G₂/(4 cos cos) of a light direction: right to 7e-7. Times D and Fresnel's term it is the model. 0 below the horizon. */
  visibility(direction: Vector3): number;
}

/** What a rough surface has beside its normals. */
export interface Surface {
  /** D of a normal, per area of the surface and per steradian: right to 1.1e-6. 0 below the surface. */
  distribution(normal: Vector3): number;
  /** G₁ of a unit vector, the visible part of the microfacets that face it, from 0 to 1: right to 3.5e-7. 0 below the surface. */
  g1(direction: Vector3): number;
}

/**
 * Directions into which GGX microfacets reflect a view, as a warp: it mixes with other lobes in a `Mixture`, which normals do not.
 *
 * **Density**
 * That of `GgxVisible.reflectedPdf`, per steradian. `sampleWithPdf` and `drawWithPdf` take the normal from the sampler. `Warp.pdf` takes
 * it from the rounded direction, which at small roughness holds only a few of its digits: prefer the former.
 *
 * **Domain**
 * - Point: unit vectors about the surface normal +z; some lie below the surface, and have density too.
 * - Uniforms: two, those of `GgxVisible`.
 *
 * **Source**
 * E. Heitz, "Sampling the GGX Distribution of Visible Normals", 2018, <https://jcgt.org/published/0007/04/01/>.
 */
export declare class Reflected extends Warp<[number, number, number], [number, number]> {
  /** @throws TypeError for what is no `GgxVisible`. */
  constructor(normals: GgxVisible);
}
