// A small tilt from a principal axis: what the linear equations say, and the exact motion.
import { FreeMotion } from "../../../../reference/polhode.js";

export const MOMENTS = [1, 2, 3]; // kg m²
export const SPIN = 2; // rad/s that |L| gives about the axis

/** Return the axes across, in cyclic order. */
export const across = (axis) => [(axis + 1) % 3, (axis + 2) % 3];

/** Return the exact motion whose L leans by a tilt [rad] from axis 0, 1 or 2 towards the next one. */
export function motionOf(axis, tilt) {
  const norm = MOMENTS[axis] * SPIN;
  const momentum = [0, 0, 0];
  momentum[axis] = norm * Math.cos(tilt);
  momentum[across(axis)[0]] = norm * Math.sin(tilt);
  return new FreeMotion({ moments: MOMENTS, momentum });
}

/**
 * Return the rates [1/s] p, q of the linear equations a' = p b, b' = q a for the components across the axis.
 *
 * From dL/dt = L × IΩ: with axes (k, i, j) cyclic, L_i' = (1/I_k − 1/I_j) L_k L_j and L_j' = (1/I_i − 1/I_k) L_k L_i.
 */
export function linearRates(axis) {
  const [i, j] = across(axis);
  const norm = MOMENTS[axis] * SPIN;
  return [(1 / MOMENTS[axis] - 1 / MOMENTS[j]) * norm, (1 / MOMENTS[i] - 1 / MOMENTS[axis]) * norm];
}

/** Return {stable, rate}: the circling rate [rad/s] about a stable axis, the growth rate [1/s] about the unstable one. */
export function exponentOf(axis) {
  const [p, q] = linearRates(axis);
  return { stable: p * q < 0, rate: Math.sqrt(Math.abs(p * q)) };
}

/** Return (L_i, L_j)/|L| by the linear equations at a time [s]. */
export function linearAt(axis, tilt, t) {
  const [, q] = linearRates(axis);
  const { stable, rate } = exponentOf(axis);
  const start = Math.sin(tilt);
  return stable
    ? [start * Math.cos(rate * t), ((start * q) / rate) * Math.sin(rate * t)]
    : [start * Math.cosh(rate * t), ((start * q) / rate) * Math.sinh(rate * t)];
}

/** Return (L_i, L_j, L_k)/|L| of the exact motion at a time [s]. */
export function exactAt(motion, axis, t) {
  const { momentum } = motion.state(t);
  const [i, j] = across(axis);
  return [i, j, axis].map((k) => momentum[k] / motion.momentumNorm);
}

/** Return the angle [rad] of L from the axis, from 0 to π. */
export function tiltAt(motion, axis, t) {
  const [a, b, along] = exactAt(motion, axis, t);
  return Math.atan2(Math.hypot(a, b), along);
}

/** Return the exact tilt [rad] at a time [s] after a start with a tilt [rad]. */
export const tiltOf = (axis, tilt, t) => tiltAt(motionOf(axis, tilt), axis, t);
