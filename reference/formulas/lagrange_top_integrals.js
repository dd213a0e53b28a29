// Printed from src/polhode/exact/lagrange_top/_formulas_integrals.py by `python -m printing`: change that, and print
// again.
//
// The places of a top's poles and of its start, by Carlson's R_F(x, y, 1) = ½ ∫₀^∞ dt / √((t+x)(t+y)(t+1)).
//
// The places of the poles enter amplitudes alone, so float64 does; the start enters phases, and the logarithm that it
// is near the saddle wants some more digits. Source: Carlson, Numer. Algorithms 10 (1995) 13, duplication.

import { larger } from "../words.js";
import { add, divide, multiply, root, rootOrZero, scale } from "./arithmetic.js";
import { ONE, ZERO } from "./lagrange_top_reduction.js";

export const MOST_STEPS = 40;
export const CLOSE = 0.01; // of the spread, whose eighth power is what the closing formula leaves
export const CLOSER = 0.002;

/**
 * Elliptic integrals of the first kind.
 *
 * @typedef {object} Integrals
 * @property {number} vAlpha distances of α's and β's poles from the real axis; infinite where the tilt stays
 * @property {number} vBeta
 * @property {number} wAlpha K' − v, of the full form
 * @property {number} wBeta
 * @property {number[]} x0 distance of the start from the lowest place
 */

// ---------------------------------------------------------------------- R_F(x, y, 1)

/** Return what R_F is more than one over the root of the mean, of relative distances from it (DLMF 19.36.1). */
function _series(x, y) {
  const z = -x - y;
  const second = x * y - z * z;
  const third = x * y * z;
  let higher = second * second * (1 / 24 - second * (5 / 208)) - second * third * (3 / 44);
  higher = higher + third * (3 / 104 * third + 0.0625 * second * second);
  return higher + third * (1 / 14) - 0.1 * second;
}

/** Return the largest distance from the mean over it. */
export function widest(x, y, z) {
  const mean = (x + y + z) / 3;
  return larger(larger(Math.abs(mean - x), Math.abs(mean - y)), Math.abs(mean - z)) / mean;
}

/** Return numbers of equal R_F, nearer to each other (DLMF §19.26(iii)). */
export function duplicated(now) {
  const { 0: x, 1: y, 2: z } = now;
  const a = Math.sqrt(x);
  const b = Math.sqrt(y);
  const c = Math.sqrt(z);
  const more = a * b + b * c + c * a;
  return [0.25 * (x + more), 0.25 * (y + more), 0.25 * (z + more)];
}

/** Return whether the closing formula has all digits of a float. */
export function isClose(now) {
  return widest(now[0], now[1], now[2]) <= CLOSE;
}

/** Return R_F of numbers next to each other, NaN of others. */
export function closed(now) {
  const { 0: x, 1: y, 2: z } = now;
  const mean = (x + y + z) / 3;
  return isClose(now) ? (1 + _series(1 - x / mean, 1 - y / mean)) / Math.sqrt(mean) : NaN;
}

/** Return `duplicated` in double-double. */
export function duplicatedSharply(now) {
  const { 0: x, 1: y, 2: z } = now;
  const a = rootOrZero(x);
  const b = rootOrZero(y);
  const c = root(z);
  const more = add(multiply(a, add(b, c)), multiply(b, c));
  return [scale(add(x, more), 0.25), scale(add(y, more), 0.25), scale(add(z, more), 0.25)];
}

/** Return whether the closing formula has the digits that a phase wants. */
export function isCloser(now) {
  return widest(now[0][0], now[1][0], now[2][0]) <= CLOSER;
}

/** Return `closed` in double-double. */
export function closedSharply(now) {
  const { 0: x, 1: y, 2: z } = now;
  const one = ONE;
  const mean = divide(add(add(x, y), z), [3, 0]);
  const apart = _series(1 - divide(x, mean)[0], 1 - divide(y, mean)[0]);
  return isCloser(now) ? divide(add(one, [apart, 0 * apart]), root(mean)) : [NaN, NaN];
}

// ---------------------------------------------------------------------- what is integrated

/** Return x, y and c of an integral √c R_F(x, y, 1), v of α. */
export function poleOfAlpha(top, points) {
  const d = points.d[0];
  const t2 = points.t2[0];
  return [d / t2, d * points.ZPlus[0] / (points.A[0] * t2), points.t1[0] / t2];
}

/** Return the like of v of β. */
export function poleOfBeta(top, points) {
  const d = points.d[0];
  const s1 = points.s1[0];
  const b = points.B[0];
  return [d * points.ZMinus[0] / (s1 * b), d / s1, points.s2[0] * points.A[0] / (s1 * b)];
}

/** Return the like of K' − v of α. */
export function restOfAlpha(top, points) {
  const g = top.G[0];
  const z = points.ZPlus[0];
  return [g * points.t1[0] / z, g * points.t2[0] / z, points.A[0] / z];
}

/** Return the like of K' − v of β. */
export function restOfBeta(top, points) {
  const g = top.G[0];
  const b = points.B[0];
  return [g * points.s2[0] / b, g * points.s1[0] / points.A[0], points.ZMinus[0] / b];
}

/** Return the like of the start's distance from the lowest place, in double-double. */
export function placeOfStart(points) {
  return [divide(points.fromUpper, points.d), divide(points.Y, points.A), divide(points.fromLower, points.d)];
}

/** Return √c R_F(x, y, 1), or some number where there is none. */
function _integral(idle, terms) {
  const { 0: x, 1: y, 2: c } = terms;
  const total = x + y;
  let good = (idle ? 0 : total) > 0;
  good = good && total < Infinity;
  const start = [good ? x : 1, good ? y : 1, 1 + 0 * x];
  let running = start;
  for (let k = 0; k < MOST_STEPS; k++) {
    if (isClose(running)) break;
    running = duplicated(running);
  }
  return Math.sqrt(c) * closed(running);
}

function _sharpIntegral(idle, terms) {
  const { 0: x, 1: y, 2: c } = terms;
  const total = x[0] + y[0];
  const one = ONE;
  let good = (idle ? 0 : total) > 0;
  good = good && total < Infinity;
  const start = [good ? x : one, good ? y : one, one];
  let running = start;
  for (let k = 0; k < MOST_STEPS; k++) {
    if (isCloser(running)) break;
    running = duplicatedSharply(running);
  }
  return multiply(rootOrZero(c), closedSharply(running));
}

/** Return the integrals of a top. */
export function integralsOf(top, points, rates) {
  const idle = rates.permanent || rates.steady;
  const separatrix = rates.separatrix;
  const d = points.d[0];
  let vAlpha = _integral(idle, poleOfAlpha(top, points));
  let vBeta = _integral(idle, poleOfBeta(top, points));
  vAlpha = separatrix ? Math.atan2(Math.sqrt(points.t1[0]), Math.sqrt(d)) : vAlpha;
  vBeta = separatrix || points.s2[0] === 0 ? 0 : vBeta;
  // where the tilt stays the pole is infinitely far: only e^−y = 0 enters
  const still = rates.steady ? Infinity : 0;
  const x0 = _sharpIntegral(idle, placeOfStart(points));
  return {
    vAlpha: idle ? still : vAlpha,
    vBeta: idle ? still : vBeta,
    wAlpha: _integral(idle, restOfAlpha(top, points)),
    wBeta: _integral(idle, restOfBeta(top, points)),
    x0: idle && d <= 0 ? ZERO : x0,
  };
}
