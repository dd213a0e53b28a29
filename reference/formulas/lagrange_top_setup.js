// Printed from src/polhode/exact/lagrange_top/_formulas_setup.py by `python -m printing`: change that, and print again.
//
// From a top's invariants to the constants of its motion: turning points, rates, theta series and phases.
//
// The invariants are those of `reduction`; pairs are double-double. The turning points are the roots u1 ≤ u2 ≤ 1 ≤ u3
// of u̇² = (α − βu)(1 − u²) − (b − au)². One of them is well separated from the other two, which follow from sums and
// products of roots without cancellation, whatever coincides. Source: Whittaker, *Analytical Dynamics*, §71–73, for the
// cubic.

import {
  divide,
  INVERSE_TWO_PI,
  multiply,
  multiplyFloat,
  PI,
  root,
  scale,
  sineCosine,
  subtract,
  twoSum,
  whole,
} from "./arithmetic.js";
import { byTheta } from "./common.js";

export const ONE = [1, 0];
export const ZERO = [0, 0];

// ---------------------------------------------------------------------- rates

/** Return p² at the start of the sum of α; `first` says that it takes the form that starts from Z. */
export function startOfAlpha(first, a, zPlus, t1, t2) {
  return first ? zPlus : divide(multiply(a, t2), first ? ONE : t1);
}

/** Return p² of the sum of β. Where c = 0 the factor of the sum vanishes, and p² must only not be zero. */
export function startOfBeta(first, c, a, b, zMinus, s1, s2) {
  const other = divide(multiply(s1, b), first ? ONE : s2);
  return first ? (c[0] === 0 ? a : zMinus) : other;
}

/** Return cG/(4Z) Σ in the first form, |c|/(2 near) [1 − d/(2 far) Σ] − ϖ in the second. */
export function drift(first, c, g, z, near, far, d, nutation, total) {
  const idle = c[0] === 0;
  const ratio = divide(first ? multiply(c, g) : c, idle ? ONE : first ? z : near);
  const share = subtract(ONE, scale(multiply(divide(d, far), total), 0.5));
  return first ? scale(multiply(ratio, total), 0.25) : subtract(multiply(scale(ratio, 0.5), share), nutation);
}

/** Return ν I1, the spin that I3 ≠ I1 adds, by τ. */
export function spin(i1, i3, axial) {
  return divide(multiplyFloat(twoSum(i1, -i3), axial), [i3, 0]);
}

/** Return a rate by τ as turns per time. */
export function turnsPerTime(rate, i1, rateScale) {
  const inverse = divide(INVERSE_TWO_PI, [i1, 0]);
  return multiply(rate, scale(inverse, rateScale));
}

/** Return the rate of x/2K [half periods per time]. */
export function halfPeriods(nutation, i1, rateScale) {
  return divide(scale(nutation, rateScale), multiplyFloat(PI, i1));
}

/** Return K and πK/K', of the nome of the smaller parameter. */
export function periods(halfRoot, nutation, nome) {
  const quarter = divide(scale(multiply(halfRoot, PI), 0.5), nutation);
  return [quarter, byTheta(scale(quarter, 2), nome)];
}

// ---------------------------------------------------------------------- series

/** Return sums and differences of the coefficients of e^{±ikz}, k = 1, 3, 5, 7. */
export function fullTerms(size, h, q, r, alternating) {
  let w1 = q * r;
  let w2 = q * q * r;
  let w3 = q * q * q * r;
  w2 = w2 * w2;
  w3 = w3 * w3 * w3;
  const h3 = h * h * h;
  const h5 = h3 * h * h;
  const h7 = h3 * h3 * h;
  size = size / (w3 * (1 + h7) + w2 * (1 + h5) + w1 * (1 + h3) + (1 + h));
  w1 = alternating * size * w1;
  w2 = size * w2;
  w3 = alternating * size * w3;
  return [
    [size * (1 + h), w1 * (1 + h3), w2 * (1 + h5), w3 * (1 + h7)],
    [size * (1 - h), w1 * (1 - h3), w2 * (1 - h5), w3 * (1 - h7)],
  ];
}

/** Return √t θ3 and √s θ4. */
export function fullSizes(rootT, rootS, q, theta3) {
  const q4 = q * q * (q * q);
  return [rootT * theta3, rootS * (1 - 2 * (q - q4 + q4 * q4 * q))];
}

/** Return cos ky and sin ky for k = 1 to 4 of 0 ≤ y ≤ π. */
function _multiples(y) {
  const { 0: s1, 1: c1 } = sineCosine(y * (0.5 / Math.PI));
  const s2 = 2 * s1 * c1;
  const c2 = 1 - 2 * s1 * s1;
  return [[c1, c2, c2 * c1 - s2 * s1, 1 - 2 * s2 * s2], [s1, s2, s2 * c1 + c2 * s1, 2 * s2 * c2]];
}

/** Return A's factors of sin ky and cos ky, k = 1, 3, 5, 7, B's of cos and sin of 2, 4, 6, 8 y, and its constant. */
export function complementarySeries(rootT, rootS, q, theta3, yAlpha, yBeta) {
  const q2 = q * q;
  const q4 = q2 * q2;
  const q6 = q2 * q2 * q2;
  const q9 = q6 * q2 * q;
  let { 0: c, 1: s } = _multiples(yAlpha);
  let theta4 = 1 - 2 * (q * c[1] - q4 * c[3] + q9 * (2 * c[2] * c[2] - 1));
  let size = rootT * theta3 / theta4;
  const c5 = c[3] * c[0] - s[3] * s[0];
  const s5 = s[3] * c[0] + c[3] * s[0];
  const c7 = c[3] * c[2] - s[3] * s[2];
  const s7 = s[3] * c[2] + c[3] * s[2];
  const aSine = [size * s[0], -size * s[2], size * s5, -size * s7];
  const aCosine = [size * c[0], -size * c[2], size * c5, -size * c7];
  ({ 0: c, 1: s } = _multiples(2 * yBeta));
  theta4 = 1 - 2 * (q * c[0] - q4 * c[1] + q9 * c[2]);
  size = rootS * (1 + q2 + q6 + q6 * q6) / theta4;
  return [
    aSine,
    aCosine,
    [-size * c[0], size * c[1], -size * c[2], size * c[3]],
    [-size * s[0], size * s[1], -size * s[2], size * s[3]],
    size,
  ];
}

// ---------------------------------------------------------------------- phases

/**
 * Return cos and sin of the phase that turns A or B at the epoch into the given α or β.
 *
 * Where one of them vanishes its own phase says nothing; its derivative then does, so both are used.
 */
function _constantPhase(r, i, dr, di, turns, rate, component, slope, norm, drop, turn, size) {
  r = r / norm;
  i = i / norm;
  const sr = turn * (dr / norm - r * drop) - rate * i;
  const si = turn * (di / norm - i * drop) + rate * r;
  const { 0: gr, 1: gi } = component;
  const { 0: er, 1: ei } = slope;
  let real = r * gr + i * gi + (sr * er + si * ei) / size;
  let imaginary = r * gi - i * gr + (sr * ei - si * er) / size;
  const { 0: s, 1: c } = sineCosine(turns - whole(turns));
  ({ 0: real, 1: imaginary } = [real * c + imaginary * s, imaginary * c - real * s]);
  const length = Math.sqrt(real * real + imaginary * imaginary);
  const some = length > 0;
  const safe = some ? length : 1;
  return [some ? real / safe : 1, some ? imaginary / safe : 0];
}

/**
 * Return cos and sin of the phases that turn A and B at the epoch into the given α and β.
 *
 * Args:
 *     quaternion, norm2: at the epoch, and its |q|².
 *     momentum: at the epoch.
 *     size: |L|² + G, by which derivatives count.
 *     sums: at the epoch.
 *     linear: derivatives by τ of the phases that evaluation adds to A and B.
 *     turn: dz/dτ or dx'/dτ.
 */
export function constantPhases(quaternion, norm2, momentum, size, sums, linear, turn) {
  const { 0: x, 1: y, 2: z } = momentum;
  const length = root(norm2);
  const q0 = divide([quaternion[0], 0], length)[0];
  const q1 = divide([quaternion[1], 0], length)[0];
  const q2 = divide([quaternion[2], 0], length)[0];
  const q3 = divide([quaternion[3], 0], length)[0];
  // 2α' = i a α − w̄ β, 2β' = w α − i a β
  const a = [0.5 * (-z * q3 - (x * q1 + y * q2)), 0.5 * (z * q0 - (x * q2 - y * q1))];
  const b = [0.5 * (x * q0 - y * q3 + z * q2), 0.5 * (x * q3 + y * q0 - z * q1)];
  const { 0: ar, 1: ai, 2: br, 3: bi, 4: dar, 5: dai, 6: dbr, 7: dbi, 8: turnsA, 9: turnsB } = sums;
  const length2 = ar * ar + ai * ai + (br * br + bi * bi);
  const norm = Math.sqrt(length2);
  const drop = (ar * dar + ai * dai + (br * dbr + bi * dbi)) / length2;
  const { 0: c0, 1: s0 } = _constantPhase(ar, ai, dar, dai, turnsA, linear[0], [q0, q3], a, norm, drop, turn, size);
  const { 0: c1, 1: s1 } = _constantPhase(br, bi, dbr, dbi, turnsB, linear[1], [q1, q2], b, norm, drop, turn, size);
  return [c0, s0, c1, s1];
}
