// Printed from src/polhode/exact/free_body/_formulas_reduction.py by `python -m printing`: change that, and print
// again.
//
// Canonical reduction of a free body: sorted axes, short-axis mode, positive third component, and its invariants.
//
// Every body is brought to moments I1 ≤ I2 ≤ I3 with 2E I2 ≤ |L|² and L3 ≥ 0 by a proper rotation that sorts, a
// mirror in which time runs backward (long-axis mode), and a half turn about the second axis. One set of formulas then
// serves all. Source: van Zon & Schofield, J. Comput. Phys. 225 (2007) 145, with the cancellations removed.

import { distil, join, multiplyTerms } from "../exact_sums.js";
import { binaryExponent, larger, smaller, timesPower } from "../words.js";
import {
  add,
  multiply,
  multiplyFloat,
  rootOrZero,
  scale,
  subtract,
  twoProduct,
  twoSquare,
  twoSum,
} from "./arithmetic.js";

// 2.0 ** (-900); of components of L, below which numbers with it are scaled up by LIFT binary places
export const TINY_RATIO = 1.1830521861667747e-271;
export const LIFT = 100;
export const SHARP = 1e-280; // products of double-doubles above it have all their digits
export const NEAR = 0.01; // of the terms of S: what is left below it is summed exactly

/**
 * A body with sorted axes and without powers of two.
 *
 * @typedef {object} Scaled
 * @property {number[]} moments ascending, ½ ≤ I3 < 1
 * @property {number[]} momentum along the sorted axes, ½ ≤ max |L_i| < 1, times 2^LIFT if a component is tiny
 * @property {number[]} order which of the given axes they are
 * @property {number} parity −1 if sorting is no proper rotation; the momentum then has the other sign
 * @property {number} momentumScale powers of two taken out
 * @property {number} rateScale
 */

/**
 * Invariants before the mirror, each a sum of terms of one sign.
 *
 * @typedef {object} Sums
 * @property {number[]} A
 * @property {number[]} B
 * @property {number[]} C
 * @property {number[]} P
 * @property {number[]} Q
 * @property {number[]} G2
 */

/**
 * A body in canonical form; all pairs are double-double.
 *
 * With V = I1 I2 I3: A = (I2−I1)I3, B = (I3−I2)I1, C = (I3−I1)I2, P = C L1² + B L2², Q = A L2² + C L3² and
 * S = A L1² − B L3² ≤ 0 are V times the textbook quantities, which avoids all divisions; the mirror has been applied.
 *
 * @typedef {object} Reduction
 * @property {number[]} moments those of `Scaled`
 * @property {number[]} momentum
 * @property {number[]} canonical momentum after mirror and half turn, third component ≥ 0
 * @property {number[]} A
 * @property {number[]} B
 * @property {number[]} C
 * @property {number[]} P
 * @property {number[]} Q
 * @property {number[]} S
 * @property {number[]} rootS √−S, accurate where S itself underflows
 * @property {number} rootP √P, likewise
 * @property {number[]} V
 * @property {number[]} G2 |L|²
 * @property {boolean} longAxis whether the mirror was applied
 * @property {number[]} order which of the given axes the canonical ones are
 * @property {number} parity that of `Scaled`
 * @property {number} halfTurn −1 where the half turn about the second axis was applied
 * @property {number} momentumScale powers of two taken out
 * @property {number} rateScale
 */

// ---------------------------------------------------------------------- order and size

function _inOrder(one, other, parity) {
  const swap = other[0] < one[0];
  return [
    [swap ? other[0] : one[0], swap ? other[1] : one[1], swap ? other[2] : one[2]],
    [swap ? one[0] : other[0], swap ? one[1] : other[1], swap ? one[2] : other[2]],
    swap ? -parity : parity,
  ];
}

function _size(x, size) {
  return x === 0 ? size : Math.abs(x);
}

/** Sort the axes by their moments, and take out powers of two. */
export function scaled(moments, momentum) {
  let { 0: x, 1: y, 2: parity } = _inOrder([moments[0], momentum[0], 0], [moments[1], momentum[1], 1], 1);
  let z;
  ({ 0: y, 1: z, 2: parity } = _inOrder(y, [moments[2], momentum[2], 2], parity));
  ({ 0: x, 1: y, 2: parity } = _inOrder(x, y, parity));
  const size = larger(larger(Math.abs(x[1]), Math.abs(y[1])), Math.abs(z[1]));
  // a component down to the smallest number keeps its digits in what is formed of it
  const smallest = smaller(smaller(_size(x[1], size), _size(y[1], size)), _size(z[1], size));
  const ofMomentum = binaryExponent(size) - (smallest < TINY_RATIO * size ? LIFT : 0);
  const ofMoments = binaryExponent(z[0]);
  return {
    moments: [timesPower(x[0], -ofMoments), timesPower(y[0], -ofMoments), timesPower(z[0], -ofMoments)],
    momentum: [
      parity * timesPower(x[1], -ofMomentum),
      parity * timesPower(y[1], -ofMomentum),
      parity * timesPower(z[1], -ofMomentum),
    ],
    order: [x[2], y[2], z[2]],
    parity,
    momentumScale: timesPower(1, ofMomentum),
    rateScale: timesPower(1, ofMomentum - ofMoments),
  };
}

// ---------------------------------------------------------------------- invariants

/** Return the invariants but S. */
export function sumsOf(body) {
  const { 0: i1, 1: i2, 2: i3 } = body.moments;
  const { 0: x, 1: y, 2: z } = body.momentum;
  const a = multiplyFloat(twoSum(i2, -i1), i3);
  const b = multiplyFloat(twoSum(i3, -i2), i1);
  const c = multiplyFloat(twoSum(i3, -i1), i2);
  const s1 = twoSquare(x);
  const s2 = twoSquare(y);
  const s3 = twoSquare(z);
  const p = add(multiply(c, s1), multiply(b, s2));
  const q = add(multiply(a, s2), multiply(c, s3));
  return { A: a, B: b, C: c, P: p, Q: q, G2: add(add(s1, s2), s3) };
}

function _exponentNearSaddle(body) {
  return binaryExponent(larger(Math.abs(body.momentum[0]), Math.abs(body.momentum[2])));
}

/** Return the moments, and L1 and L3 scaled up: near the saddle their squares would lose their low words. */
export function termsOfDistance(body) {
  const exponent = _exponentNearSaddle(body);
  const { 0: x, 2: z } = body.momentum;
  return [body.moments, timesPower(x, -exponent), timesPower(z, -exponent)];
}

/** Return A x² − B z² in double-double, and whether so much cancels that it is to be summed exactly. */
export function plainDistance(a, b, x, z) {
  const first = multiply(a, twoSquare(x));
  const distance = subtract(first, multiply(b, twoSquare(z)));
  return [distance, Math.abs(distance[0]) < NEAR * first[0]];
}

/** Return the product of a gap, a moment and x². */
function _ofSquare(gap, moment, x) {
  return multiplyTerms(multiplyTerms(multiplyTerms(gap, moment), x), x);
}

/** Return S = (I2 − I1) I3 x² − (I3 − I2) I1 z², correct to its last digit however close to the separatrix. */
export function exactDistance(moments, x, z) {
  const { 0: i1, 1: i2, 2: i3 } = moments;
  return distil(join(_ofSquare(twoSum(i2, -i1), i3, x), _ofSquare(twoSum(i3, -i2), -i1, z)));
}

function _exact(values) {
  const { 0: moments, 1: x, 2: z } = values[0];
  return exactDistance(moments, x, z);
}

function _plain(values) {
  return values[1];
}

/** Return A L1² − B L3², with both components scaled up. */
export function signedDistance(body, sums) {
  const terms = termsOfDistance(body);
  const { 0: plain, 1: near } = plainDistance(sums.A, sums.B, terms[1], terms[2]);
  return near ? _exact([terms, plain]) : _plain([terms, plain]);
}

// ---------------------------------------------------------------------- mirror and half turn

/** Return √(C x² + B y²), of which the sum is given but may have lost digits, or all, to underflow. */
function _rootOfSum(value, c, x, b, y) {
  const exponent = binaryExponent(larger(Math.abs(x), Math.abs(y)));
  x = timesPower(x, -exponent);
  y = timesPower(y, -exponent);
  return value > SHARP ? Math.sqrt(value) : timesPower(Math.sqrt(c * x * x + b * y * y), exponent);
}

/** Apply mirror and half turn; the distance is that of `signedDistance`. */
export function reduced(body, sums, distance) {
  const longAxis = distance[0] > 0;
  const a = longAxis ? sums.B : sums.A;
  const b = longAxis ? sums.A : sums.B;
  const p = longAxis ? sums.Q : sums.P;
  const q = longAxis ? sums.P : sums.Q;
  let { 0: x, 1: y, 2: z } = body.momentum;
  ({ 0: x, 1: z } = [longAxis ? z : x, longAxis ? x : z]);
  const halfTurn = z < 0 ? -1 : 1;
  const { 0: i1, 1: i2, 2: i3 } = body.moments;
  const side = longAxis ? 1 : -1;
  const near = timesPower(1, _exponentNearSaddle(body));
  const minusS = scale(distance, side);
  const { 0: first, 1: second, 2: third } = body.order;
  return {
    moments: body.moments,
    momentum: body.momentum,
    canonical: [x * halfTurn, y, z * halfTurn],
    A: a,
    B: b,
    C: sums.C,
    P: p,
    Q: q,
    S: scale(scale(minusS, -near), near),
    rootS: scale(rootOrZero(minusS), near),
    rootP: _rootOfSum(p[0], sums.C[0], x, b[0], y),
    V: multiplyFloat(twoProduct(i1, i2), i3),
    G2: sums.G2,
    longAxis,
    order: [longAxis ? third : first, second, longAxis ? first : third],
    parity: body.parity,
    halfTurn,
    momentumScale: body.momentumScale,
    rateScale: body.rateScale,
  };
}

/** Return the canonical form of a body, in any order and at any scale. */
export function reduction(moments, momentum) {
  const body = scaled(moments, momentum);
  const sums = sumsOf(body);
  return reduced(body, sums, signedDistance(body, sums));
}
