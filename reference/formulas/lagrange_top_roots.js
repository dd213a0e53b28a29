// Printed from src/polhode/exact/lagrange_top/_formulas_roots.py by `python -m printing`: change that, and print again.
//
// The turning points of a top: the roots u1 ≤ u2 ≤ 1 ≤ u3 of u̇² = (α − βu)(1 − u²) − (b − au)².
//
// One of the roots is well separated from the other two. It is computed by Newton's method in double-double, in a
// variable in which it is large; the others follow from sums and products of roots without cancellation, whatever
// coincides. Sources: Whittaker, *Analytical Dynamics*, §71–73, for the cubic; Viète for the start.

import { binaryExponent, larger, smaller, timesPower } from "../words.js";
import { add, divide, multiply, multiplyFloat, rootOrZero, scale, square, subtract, twoSquare } from "./arithmetic.js";
import { ONE, ZERO } from "./lagrange_top_reduction.js";

export const SQUARABLE = -400; // binary exponent down to which a square has all its digits
export const BEGIN = 0.8660254; // of cos(⅓ acos x), 0 ≤ x ≤ 1, to 2e-4
export const SLOPE = 0.1642;
export const CURVE = -0.0302;
export const AT_ONCE = 2; // steps of Newton's, of all and of any: two do, three more where the start was poor
export const MOST = 5;
// 2.0 ** (-60); of the last change over the root: what is left is smaller by a float64's precision
export const CONVERGED = 8.673617379884035e-19;

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

/**
 * The cubic whose largest root stands apart from the others.
 *
 * @typedef {object} Apart
 * @property {boolean} upper whether it is that of Y, and the root u3, or that of s, and the root u1
 * @property {Array} cubic
 * @property {number} start near the root
 * @property {number[]} f1
 */

// ---------------------------------------------------------------------- the separate root

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

/** Return b/3, r and cos 3φ of a cubic with real roots, of which 2r cos φ − b/3 is the largest. */
function _byAngle(cubic) {
  // x = 2r cos φ − b/3 with r = √(−P/3) and cos 3φ = −Q/2r³
  const b = cubic[0][0];
  const c = cubic[1][0];
  const d = cubic[2][0];
  const third = b / 3;
  const p = c - b * third;
  const q = 2 * (third * third) * third - third * c + d;
  const r = Math.sqrt(larger(-p / 3, 0 * p));
  return [third, r, r > 0 ? -0.5 * q / (r > 0 ? r * r * r : 1) : 1];
}

/** Return the cubic whose largest root stands apart. */
export function apart(top) {
  const weightless = !(top.G[0] > 0);
  const one = ONE;
  const { 0: f1, 1: ofY, 2: ofS } = cubics(
    top.momentum[2],
    top.G,
    divide(one, weightless ? one : top.G),
    top.s0,
    top.t0,
    top.u0,
    top.w2,
    top.twist,
    square(top.p),
    square(top.c),
    top.D,
    top.F,
  );
  const { 0: third, 1: r, 2: cosine } = _byAngle(ofY);
  const { 0: otherThird, 1: otherR, 2: other } = _byAngle(ofS);
  const upper = cosine >= 0 || weightless;
  let x = upper ? cosine : other;
  x = smaller(larger(x, 0 * x), 1 + 0 * x);
  // cos φ is a root of 4 y³ − 3 y = x
  let y = BEGIN + x * (SLOPE + x * CURVE);
  y = (8 * y * y * y + x) / (12 * y * y - 3);
  y = (8 * y * y * y + x) / (12 * y * y - 3);
  const cubic = [upper ? ofY[0] : ofS[0], upper ? ofY[1] : ofS[1], upper ? ofY[2] : ofS[2]];
  return { upper, cubic, start: 2 * (upper ? r : otherR) * y - (upper ? third : otherThird), f1 };
}

/** Return the root before the first step. */
export function begun(lone) {
  return [[lone.start, 0 * lone.start], lone.start, lone.cubic];
}

/** Return a root after a step of Newton's, whose slope need not be sharp. */
export function nearer(root) {
  const { 0: x, 2: cubic } = root;
  const { 0: b, 1: c, 2: d } = cubic;
  const value = add(multiply(add(multiply(add(x, b), x), c), x), d);
  let change = -value[0] / ((3 * x[0] + 2 * b[0]) * x[0] + c[0]);
  change = change - change === 0 ? change : 0;
  return [add(x, [change, 0 * change]), change, cubic];
}

/** Return whether the last change leaves nothing to be changed. */
export function isFound(root) {
  const { 0: x, 1: change } = root;
  return x[0] > 0 && Math.abs(change) <= CONVERGED * x[0];
}

// ---------------------------------------------------------------------- turning points

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
  const most = scale(add(sum, positive ? total : [-total[0], -total[1]]), 0.5);
  const least = most[0] > 0 ? quotient(product, most) : ZERO;
  return [positive ? most : least, positive ? least : most];
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

/** Return the turning points from the separate root, Y or else s1. */
export function turningPointsOf(top, isUpper, lone, f1) {
  const g = top.G;
  const s0 = top.s0;
  const t0 = top.t0;
  const p2 = square(top.p);
  const c2 = square(top.c);
  const x = _upperRootApart(g, s0, p2, c2, f1, lone);
  const y = _lowerRootApart(g[0] > 0 ? g : ONE, s0, p2, c2, top.F, lone);
  const upper = isUpper ? x[1] : y[1];
  const above = isUpper ? x[7] : y[7];
  const t2 = add(t0, upper);
  const z = add(above, multiply(g, t0));
  return {
    fromLower: isUpper ? x[0] : y[0],
    fromUpper: upper,
    d: isUpper ? x[2] : y[2],
    s1: isUpper ? x[3] : y[3],
    s2: isUpper ? x[4] : y[4],
    t1: quotient(square(top.cPlus), multiply(t2, z)),
    t2,
    A: isUpper ? x[5] : y[5],
    B: isUpper ? x[6] : y[6],
    Y: above,
    ZMinus: isUpper ? x[8] : y[8],
    ZPlus: z,
  };
}

/** Return the turning points of a top. */
export function turningPoints(top) {
  const lone = apart(top);
  let running = begun(lone);
  for (let k = 0; k < MOST; k++) {
    if (k >= AT_ONCE && isFound(running)) break;
    running = nearer(running);
  }
  const { 0: root } = running;
  return turningPointsOf(top, lone.upper, root, lone.f1);
}
