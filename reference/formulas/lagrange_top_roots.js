// Printed from src/polhode/exact/lagrange_top/_formulas_roots.py by `python -m printing`: change that, and print again.
//
// The invariants of a top, and its turning points: the roots u1 ≤ u2 ≤ 1 ≤ u3 of u̇² = (α − βu)(1 − u²) − (b − au)².
//
// The invariants are those of `reduction`; pairs are double-double. One of the roots is well separated from the other
// two, which follow from sums and products of roots without cancellation, whatever coincides. Source: Whittaker,
// *Analytical Dynamics*, §71–73, for the cubic.

import { binaryExponent, timesPower } from "../words.js";
import { add, divide, multiply, multiplyFloat, rootOrZero, scale, square, subtract, twoSquare } from "./arithmetic.js";

export const SQUARABLE = -400; // binary exponent down to which a square has all its digits
export const ONE = [1, 0];
export const ZERO = [0, 0];

/**
 * A top with mgl ≥ 0, scaled by powers of two; pairs are double-double.
 *
 * u = cos θ, s = 1 − u, t = 1 + u, index 0 at the epoch; dots are derivatives by τ.
 *
 * @typedef {object} Reduction
 * @property {number[]} moments I1, I3
 * @property {number[]} momentum with the displacement scaled up by 2^lift
 * @property {number[]} quaternion not normalised; likewise
 * @property {boolean} reversed whether the axis was reversed
 * @property {number} lift binary exponent of the displacement's scale, 0 for most tops
 * @property {number} momentumScale powers of two taken out
 * @property {number} rateScale
 * @property {number[]} size |q|² as given
 * @property {number[]} G
 * @property {number[]} s0
 * @property {number[]} t0
 * @property {number[]} u0
 * @property {number[]} p u̇ at the epoch
 * @property {number[]} c p_φ − L3
 * @property {number[]} cPlus p_φ + L3
 * @property {number[]} twist p_φ − u L3 at the epoch
 * @property {number[]} F |w|² − G s − a c
 * @property {number[]} D 2G − a² − |w|² + G s
 * @property {number[]} w2 |w|² at the epoch
 * @property {number[]} lean a (|w|² − G s) − G c: its sign against a's tells loops from waves
 */

/** Return whether the axis points up rather than down at the epoch. */
export function isUpright(top) {
  return top.s0[0] < top.t0[0];
}

/** Return whether the displacement was scaled up and grows. */
export function leaves(top) {
  return top.lift > 0 && isUpright(top) && top.D[0] > 0;
}

/**
 * Distances between the roots, the poles u = ±1 and the start u0, each as a number of its own.
 *
 * @typedef {object} TurningPoints
 * @property {number[]} fromLower u0 − u1
 * @property {number[]} fromUpper u2 − u0
 * @property {number[]} d u2 − u1
 * @property {number[]} s1 1 − u1
 * @property {number[]} s2 1 − u2
 * @property {number[]} t1 1 + u1
 * @property {number[]} t2 1 + u2
 * @property {number[]} A G (u3 − u1)
 * @property {number[]} B G (u3 − u2)
 * @property {number[]} Y G (u3 − u0)
 * @property {number[]} ZMinus G (u3 − 1)
 * @property {number[]} ZPlus G (u3 + 1)
 */

// ---------------------------------------------------------------------- turning points

/** Return f1, and the cubics x³ + bx² + cx + d of Y = G (u3 − u0) and of s = 1 − u1; `inverse` is 1/G. */
export function cubics(axial, g, inverse, s0, t0, u0, w2, twist, p2, c2, d, f) {
  // with v = u − u0 and the |w|² of the start, u̇² = (1 − u²)(|w|² − G v) − (b − a u)² = p² + f1 v + f2 v² + G v³,
  // and with s = 1 − u it is −(G s³ − D s² − 2F s + c²)
  let f1 = subtract(scale(multiplyFloat(twist, axial), 2), multiply(g, multiply(s0, t0)));
  f1 = subtract(f1, scale(multiply(u0, w2), 2));
  const f2 = subtract(subtract(scale(multiply(g, u0), 2), w2), twoSquare(axial));
  d = multiply(d, inverse);
  f = multiply(f, inverse);
  return [f1, [f2, multiply(g, f1), multiply(square(g), p2)], [[-d[0], -d[1]], scale(f, -2), multiply(c2, inverse)]];
}

/** Return x / y, and zero for x = 0 whatever y. */
export function quotient(x, y) {
  const zero = x[0] === 0;
  return zero ? x : divide(x, zero ? ONE : y);
}

/** Return x + y = √((x − y)² + 4 x y), also where the square underflows. */
export function difference(total, product) {
  const exponent = binaryExponent(total[0]);
  const alone = product[0] === 0 || binaryExponent(product[0]) < 2 * exponent;
  const power = total[0] !== 0 && exponent < SQUARABLE && alone ? -exponent : 0;
  const up = timesPower(1, power);
  const raised = scale(scale(product, up), up);
  return scale(rootOrZero(add(square(scale(total, up)), scale(raised, 4))), timesPower(1, -power));
}

/** Return x ≥ 0 and y ≥ 0 from x − y, x + y and x y. */
function _largerAndSmaller(total, sum, product) {
  const positive = total[0] >= 0;
  const larger = scale(add(sum, positive ? total : [-total[0], -total[1]]), 0.5);
  const smaller = larger[0] > 0 ? quotient(product, larger) : ZERO;
  return [positive ? larger : smaller, positive ? smaller : larger];
}

/** From Y = G (u3 − u0): with v = u − u0, v1 + v2 = (f1 + G p²/Y)/Y and v1 v2 = −p²/Y. */
function _upperRootApart(g, s0, p2, c2, f1, y) {
  const product = quotient(p2, y);
  const total = quotient(add(f1, multiply(g, product)), y);
  const gap = difference(total, product);
  const { 0: upper, 1: lower } = _largerAndSmaller(total, gap, product);
  const s1 = add(s0, lower);
  let s2 = subtract(s0, upper);
  let z = subtract(y, multiply(g, s0));
  // s1 s2 Z = c²; of s2 and Z only the larger is an accurate difference
  const take = z[0] >= multiply(g, s2)[0];
  const other = quotient(c2, multiply(s1, take ? z : s2));
  s2 = take ? other : s2;
  z = take ? z : other;
  return [lower, upper, gap, s1, s2, add(y, multiply(g, lower)), subtract(y, multiply(g, upper)), y, z];
}

/** From s1 = 1 − u1: s2 + s3 = (c²/s1 − 2F)/(G s1) and s2 s3 = −c²/(G s1). */
function _lowerRootApart(g, s0, p2, c2, f, s1) {
  const gs = multiply(g, s1);
  const product = quotient(c2, gs);
  const total = divide(add(scale(f, -2), quotient(c2, s1)), gs);
  const between = difference(total, product);
  const { 0: s2, 1: minusS3 } = _largerAndSmaller(total, between, product);
  const z = multiply(g, minusS3);
  const y = add(multiply(g, s0), z);
  let upper = subtract(s0, s2);
  let lower = subtract(s1, s0);
  const take = upper[0] >= lower[0];
  const other = quotient(quotient(p2, y), take ? upper : lower);
  upper = take ? upper : other;
  lower = take ? other : lower;
  return [lower, upper, subtract(s1, s2), s1, s2, multiply(g, add(s1, minusS3)), multiply(g, between), y, z];
}

/** Return the turning points from the separate root, Y or else s1; `safe` is G, where it is positive. */
export function turningPointsOf(isUpper, loneRoot, g, safe, s0, t0, p2, c2, cPlus, f, f1) {
  const x = _upperRootApart(g, s0, p2, c2, f1, loneRoot);
  const y = _lowerRootApart(safe, s0, p2, c2, f, loneRoot);
  const upper = isUpper ? x[1] : y[1];
  const apart = isUpper ? x[7] : y[7];
  const t2 = add(t0, upper);
  const z = add(apart, multiply(g, t0));
  return {
    fromLower: isUpper ? x[0] : y[0],
    fromUpper: upper,
    d: isUpper ? x[2] : y[2],
    s1: isUpper ? x[3] : y[3],
    s2: isUpper ? x[4] : y[4],
    t1: quotient(square(cPlus), multiply(t2, z)),
    t2,
    A: isUpper ? x[5] : y[5],
    B: isUpper ? x[6] : y[6],
    Y: apart,
    ZMinus: isUpper ? x[8] : y[8],
    ZPlus: z,
  };
}
