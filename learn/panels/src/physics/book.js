// A hardback book, taken as a homogeneous box, thrown spinning about its middle axis: examples/book.toml.
import { FreeMotion } from "../../../../reference/polhode.js";
import { turnBetween } from "../lib/meshes.js";

export const SIZE = [0.24, 0.16, 0.035]; // m: height, width, thickness, along axes 1, 2, 3
export const MASS = 1.1; // kg

const square = (x) => x * x;
const momentOf = (a, b) => (MASS / 12) * (square(a) + square(b));
export const MOMENTS = [momentOf(SIZE[1], SIZE[2]), momentOf(SIZE[0], SIZE[2]), momentOf(SIZE[0], SIZE[1])]; // kg m²

/** Return the momentum that leans by a tilt [rad] from axis 2 towards axis 3, of the size that spin [rad/s] about axis 2 has. */
export function momentumOf(tilt, spin) {
  const norm = MOMENTS[1] * spin;
  return [0, norm * Math.cos(tilt), norm * Math.sin(tilt)];
}

/** Return the motion; L points up in space. */
export function motionOf(tilt, spin) {
  const momentum = momentumOf(tilt, spin);
  return new FreeMotion({ moments: MOMENTS, momentum, attitude: turnBetween(momentum, [0, 0, 1]) });
}

/** Return the time [s] from one side to the other. */
export const flipTime = (tilt, spin) => new FreeMotion({ moments: MOMENTS, momentum: momentumOf(tilt, spin) }).flipInterval;

/** Return λ [1/s] at which a small tilt grows. */
export function growthRate(spin) {
  const [a, b, c] = MOMENTS;
  return spin * Math.sqrt(((b - a) * (c - b)) / (a * c));
}

/**
 * Return what the time of a flip [s] comes to for small tilts [rad]: (2/λ) ln(4/(κ tilt)), κ² = I2 (I3 − I1)/(I3 (I2 − I1)).
 *
 * The flip takes 2 K(k)/λ with K ≈ ln(4/k'), and k' is κ times the tilt.
 */
export function straightTime(tilt, spin) {
  const [a, b, c] = MOMENTS;
  const kappa = Math.sqrt((b * (c - a)) / (c * (b - a)));
  return (2 / growthRate(spin)) * Math.log(4 / (kappa * tilt));
}

/** Return the time [s] that a tilt ten times smaller adds. */
export const timePerDecade = (spin) => (2 * Math.LN10) / growthRate(spin);
