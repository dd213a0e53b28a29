// Printed from src/polhode/exact/lagrange_top/_formulas.py by `python -m printing`: change that, and print again.
//
// The Cayley–Klein parameters of a Lagrange top as quotients of theta functions.
//
// α ∝ θ1(z − iy_a)/θ4(z) and β ∝ θ2(z − iy_b)/θ4(z), each with a phase linear in time (Klein & Sommerfeld, *Theorie des
// Kreisels*, ch. VI). The full form (m ≤ ½) is trigonometric in z, the complementary form (m > ½) exponential. As
// |α|² + |β|² = 1 the common denominator is not needed, and w = 2(ᾱβ̇ − βᾱ̇) needs no derivative of it.

import { larger } from "../words.js";
import { halves, phase, sineCosine, whole } from "./arithmetic.js";
import { exponent, reducedArgument } from "./common.js";

/**
 * All that evaluation needs of a top: numbers, or arrays with one for each of many.
 *
 * Each series has four terms: q^16 is below 1e-21.
 *
 * @typedef {object} Motion
 * @property {number} full whether it takes the full form
 * @property {number[]} first of the phase of α [turns per time]
 * @property {number[]} second of the phase of β
 * @property {number[]} third full: of z/2π; complementary: of x/2K
 * @property {number[]} start the same at the epoch, double-double
 * @property {number[]} aSum full: sums of the terms e^{±ikz} in A; complementary: their factors of sin ky, k = 1, 3, 5,
 * 7
 * @property {number[]} aGap full: differences; complementary: factors of cos ky
 * @property {number[]} bSum full: as of A; complementary: factors of cos ky, k = 2, 4, 6, 8
 * @property {number[]} bGap full: as of A; complementary: factors of sin ky
 * @property {number} constant complementary: the constant term of B
 * @property {number[]} nome complementary: q, πK/K' in halves, y_a/π, y_b/π, whether periodic
 * @property {number[]} signs of c' and c
 * @property {number[]} rates of w: twice dz/dt or dx'/dt, twice the sum of the linear rates [momentum]
 * @property {number[]} phases cos, sin of the constant phases of α and β
 * @property {number} axial L3
 * @property {number} reversed −1 where the axis was turned round
 */

/** Sum the products, smallest first. */
function _dot(x, y) {
  const { 0: a, 1: b, 2: c, 3: d } = x;
  const { 0: e, 1: f, 2: g, 3: h } = y;
  return d * h + c * g + b * f + a * e;
}

/** Sum the products times 1, 3, 5 and 7, which a derivative brings. */
function _odd(x, y) {
  const { 0: a, 1: b, 2: c, 3: d } = x;
  const { 0: e, 1: f, 2: g, 3: h } = y;
  return d * (7 * h) + c * (5 * g) + b * (3 * f) + a * e;
}

/** Sum the products times 2, 4, 6 and 8. */
function _even(x, y) {
  const { 0: a, 1: b, 2: c, 3: d } = x;
  const { 0: e, 1: f, 2: g, 3: h } = y;
  return d * (8 * h) + c * (6 * g) + b * (4 * f) + a * (2 * e);
}

function _turns(rate, time) {
  const { 0: fraction, 1: rest } = phase(rate, time);
  return fraction + rest;
}

/** Sum A, B and their derivatives by z. */
export function fullSums(m, time) {
  const { 0: sa, 1: sb } = m.signs;
  const { 0: fraction, 1: rest } = phase(m.third, time);
  const z = fraction + (rest + m.start[0]);
  const { 0: s1, 1: c1 } = sineCosine(z - whole(z));
  const c = 1 - 2 * s1 * s1;
  const s = 2 * s1 * c1;
  const c3 = c1 * c - s1 * s;
  const s3 = s1 * c + c1 * s;
  const c5 = c3 * c - s3 * s;
  const s5 = s3 * c + c3 * s;
  const c7 = c5 * c - s5 * s;
  const s7 = s5 * c + c5 * s;
  const cosines = [c1, c3, c5, c7];
  const sines = [s1, s3, s5, s7];
  return [
    _dot(m.aSum, sines),
    -sa * _dot(m.aGap, cosines),
    _dot(m.bSum, cosines),
    sb * _dot(m.bGap, sines),
    _odd(m.aSum, cosines),
    sa * _odd(m.aGap, sines),
    -_odd(m.bSum, sines),
    sb * _odd(m.bGap, cosines),
    _turns(m.first, time),
    _turns(m.second, time),
  ];
}

/** Return side, both phases in turns, and exponent and factor of E and of R, which sum A and B. */
export function complementaryPhase(m, time) {
  const { 1: upper, 2: lower, 3: yaTurns, 4: ybTurns, 5: periodic } = m.nome;
  const { 0: sa, 1: sb } = m.signs;
  const { 0: u, 1: uRest, 2: count } = reducedArgument(m.third, m.start, periodic, time);
  const side = u < 0 ? -1 : 1;
  const f = u * side;
  const g = uRest * side;
  const { 0: e, 1: eFactor } = exponent(f, g, upper, lower);
  const distance = larger(0.5 - f, 0);
  const { 0: r, 1: rFactor } = exponent(distance, (0.5 - distance - f) * periodic - g, upper, lower);
  const half = 0.5 * (count - 2 * Math.floor(0.5 * count));
  const within = u + uRest;
  let turnsA = _turns(m.first, time) + sa * within * yaTurns;
  let turnsB = _turns(m.second, time) + sb * within * ybTurns;
  turnsA = turnsA - whole(turnsA) + half;
  turnsB = turnsB - whole(turnsB) + half;
  return [side, turnsA, turnsB, e, eFactor, r, periodic * rFactor];
}

/** Sum A, B and their derivatives by x' in the decaying powers of E = e^−|x'| and the growing ones of R = √q/E. */
export function complementarySums(m, side, turnsA, turnsB, e0, R) {
  const q = m.nome[0];
  const { 0: sa, 1: sb } = m.signs;
  const h = e0 * e0;
  const r = R * R;
  const h2 = h * h;
  const h3 = h * h2;
  const h5 = h3 * h2;
  const h7 = h5 * h2;
  const q2 = q * q;
  const q3 = q2 * q;
  const w1 = q * r;
  const w2 = q2 * r;
  const w3 = q3 * r;
  const p1 = q * h;
  const p2 = q2 * h;
  const p3 = q3 * h;
  const p4 = q2 * q2 * h;
  const v2 = w2 * w2;
  let v3 = w3 * w3;
  const u1 = w1 * w1;
  const u2 = v2 * w2;
  const u3 = v3 * v3;
  const d2 = p2 * p2;
  const d3 = p3 * p3 * p3;
  const d4 = p4 * p4 * (p4 * p4);
  v3 = v3 * w3;
  const sums = [1 + h, w1 * (1 + h3), v2 * (1 + h5), v3 * (1 + h7)];
  const gaps = [1 - h, w1 * (1 - h3), v2 * (1 - h5), v3 * (1 - h7)];
  const up = [r + p1, u1 + d2, u2 + d3, u3 + d4];
  const down = [r - p1, u1 - d2, u2 - d3, u3 - d4];
  const e = 2 * e0;
  return [
    _dot(m.aSum, sums),
    sa * side * _dot(m.aGap, gaps),
    e * (m.constant + _dot(m.bSum, up)),
    -sb * side * e * _dot(m.bGap, down),
    side * _odd(m.aSum, gaps),
    sa * _odd(m.aGap, sums),
    side * e * _even(m.bSum, down),
    -sb * e * _even(m.bGap, up),
    turnsA,
    turnsB,
  ];
}

/** Return attitude and momentum: α = A e^{iφ_a}, β = B e^{iφ_b} over their norm, and w. */
export function stateOf(m, sums) {
  const { 0: ar, 1: ai, 2: br, 3: bi, 4: dar, 5: dai, 6: dbr, 7: dbi, 8: turnsA, 9: turnsB } = sums;
  const { 0: byArgument, 1: byPhase } = m.rates;
  const { 0: c0, 1: s0, 2: c1, 3: s1 } = m.phases;
  let x = 1 / (ar * ar + ai * ai + (br * br + bi * bi));
  const root = Math.sqrt(x);
  let { 0: s, 1: c } = sineCosine(turnsA - whole(turnsA));
  const ca = c * c0 - s * s0;
  const sa = s * c0 + c * s0;
  ({ 0: s, 1: c } = sineCosine(turnsB - whole(turnsB)));
  const cb = c * c1 - s * s1;
  const sb = s * c1 + c * s1;
  const arT = (ar * ca - ai * sa) * root;
  const aiT = (ar * sa + ai * ca) * root;
  const brT = (br * cb - bi * sb) * root;
  const biT = (br * sb + bi * cb) * root;
  // ĀB' − BĀ' and i ĀB
  const gainR = ar * dbr + ai * dbi - (br * dar + bi * dai);
  const gainI = ar * dbi - ai * dbr - (bi * dar - br * dai);
  const turnR = ai * br - ar * bi;
  const turnI = ar * br + ai * bi;
  const wr = (byArgument * gainR + byPhase * turnR) * x;
  const wi = (byArgument * gainI + byPhase * turnI) * x;
  const cw = cb * ca + sb * sa;
  const sw = sb * ca - cb * sa;
  const side = m.reversed;
  const turned = side < 0;
  const { 0: w, 1: z } = turned ? [brT, biT] : [arT, aiT];
  let y;
  ({ 0: x, 1: y } = turned ? [arT, aiT] : [brT, biT]);
  return [w, side * x, side * y, z, wr * cw - wi * sw, side * (wr * sw + wi * cw), m.axial];
}

/** Return attitude and momentum of a motion at a time, given in two parts. */
export function stateAt(m, time, rest) {
  const { 0: high, 1: low } = halves(time);
  if (m.full !== 0) return stateOf(m, fullSums(m, [high, low, rest]));
  const { 0: a, 1: b, 2: c, 3: exponent, 4: factor, 5: other, 6: otherFactor } = complementaryPhase(
    m,
    [high, low, rest],
  );
  const e0 = Math.exp(exponent) * factor;
  const R = Math.exp(other) * otherFactor;
  return stateOf(m, complementarySums(m, a, b, c, e0, R));
}
