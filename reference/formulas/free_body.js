// Printed from src/polhode/exact/free_body/_formulas.py by `python -m printing`: change that, and print again.
//
// The attitude quaternion of a free body as a quotient of theta functions.
//
// Two complex theta functions A and B of the polhode angle make, up to their norm, the quaternion of the frame whose
// third row is the angular momentum (Jacobi 1849; Klein & Sommerfeld, *Theorie des Kreisels*). Both are short series in
// the smaller of the two nomes: the full form (m ≤ ½) is trigonometric in the polhode angle, the complementary form
// (m > ½) exponential. The rest is a constant 4×4 matrix.

import { larger } from "../words.js";
import { halves, phase, sineCosine, whole } from "./arithmetic.js";
import { exponent, reducedArgument } from "./common.js";

/**
 * All that evaluation needs of a body: numbers, or arrays with one for each of many.
 *
 * @typedef {object} Motion
 * @property {number} full whether it takes the full form
 * @property {number[]} first full: rate of the phase of A; complementary: half the precession rate [turns per time]
 * @property {number[]} second full: rate of the phase of B; complementary: rate of u/2K
 * @property {number[]} start full: (z0/4π, 0); complementary: u0/2K, double-double
 * @property {number[]} series full: five coefficients of A and of B; complementary: cos and sin of (2n+1)(y/2 − π/4)
 * @property {number[]} nome complementary: √q1, πK/K' in halves, y/2π, 0 on the separatrix
 * @property {number} parity complementary: half turns of u at the start
 * @property {number[]} toAttitude by rows: quaternion = matrix (4, 4) · spinor / norm
 * @property {number[]} toMomentum by rows: momentum = matrix (3, 3) · (n1, n2, n3)
 */

/** Sum A and B as polynomials in X = cos 2z and Y = sin 2z, where z is the difference of their phases. */
export function fullSums(m, time) {
  const start = m.start[0];
  const { 0: a0, 1: a1, 2: a2, 3: a3, 4: a4, 5: b0, 6: b1, 7: b2, 8: b3, 9: b4 } = m.series;
  const { 0: fa, 1: ra } = phase(m.first, time);
  const { 0: fb, 1: rb } = phase(m.second, time);
  const ta = fa + (ra - start);
  const tb = fb + (rb + start);
  const { 0: sa, 1: ca } = sineCosine(ta - whole(ta));
  const { 0: sb, 1: cb } = sineCosine(tb - whole(tb));
  const cz = ca * cb + sa * sb;
  const sz = sb * ca - cb * sa;
  // cos 2z = 1 − 2 sin² z, sin 2z = 2 sin z cos z
  const s2 = sz + sz;
  const X = 1 - s2 * sz;
  const Y = s2 * cz;
  const pa = a0 + X * (a1 + X * a2);
  const qa = Y * (a3 + X * a4);
  const pb = b0 + X * (b1 + X * b2);
  const qb = Y * (b3 + X * b4);
  return [ca * pa - sa * qa, ca * qa + sa * pa, cb * pb - sb * qb, cb * qb + sb * pb];
}

/** Return turns, side, count of half turns, and exponent and factor of E and of R, which sums A and B. */
export function complementaryPhase(m, time) {
  const { 1: upper, 2: lower, 3: yTurns, 4: periodic } = m.nome;
  const { 0: fraction, 1: rest } = phase(m.first, time);
  let { 0: u, 1: uRest, 2: count } = reducedArgument(m.second, m.start, periodic, time);
  count = m.parity + count;
  count = count - 4 * whole(0.25 * count);
  let turns = fraction - 0.25 * count;
  turns = turns - whole(turns) + (rest - u * yTurns);
  const side = u < 0 ? -1 : 1;
  const f = u * side;
  const g = uRest * side;
  const { 0: e, 1: eFactor } = exponent(f, g, upper, lower);
  const distance = larger(0.5 - f, 0);
  const { 0: r, 1: rFactor } = exponent(distance, (0.5 - distance - f) * periodic - g, upper, lower);
  return [turns, side, count, e, eFactor, r, periodic * rFactor];
}

/** Sum A and B in the growing powers of R = √q1/E and the decaying ones of E = e^−|x|, x = πu/2K'. */
export function complementarySums(m, turns, side, count, e0, R) {
  const { 0: c0, 1: c1, 2: c2, 3: c3, 4: c4, 5: s0, 6: s1, 7: s2, 8: s3, 9: s4 } = m.series;
  const root = m.nome[0];
  const { 0: s, 1: c } = sineCosine(turns - whole(turns));
  const q = root * root;
  const q2 = q * q;
  const g1 = root * R;
  const g2 = g1 * g1 * q;
  const g3 = g2 * g1 * q2;
  const g4 = g3 * g1 * q2 * q;
  const e1 = q * e0 * e0;
  const e2 = q2 * e1 * e0;
  const e3 = q2 * q * e2 * e0;
  const e4 = q2 * q2 * e3 * e0;
  let ar = c4 * (g4 + e4);
  let ai = s4 * (g4 - e4);
  let br = -s4 * (g4 + e4);
  let bi = c4 * (g4 - e4);
  ar = ar + c3 * (g3 + e3);
  ai = ai + s3 * (g3 - e3);
  br = br + s3 * (g3 + e3);
  bi = bi - c3 * (g3 - e3);
  ar = ar + c2 * (g2 + e2);
  ai = ai + s2 * (g2 - e2);
  br = br - s2 * (g2 + e2);
  bi = bi + c2 * (g2 - e2);
  ar = ar + c1 * (g1 + e1);
  ai = ai + s1 * (g1 - e1);
  br = br + s1 * (g1 + e1);
  bi = bi - c1 * (g1 - e1);
  ar = ar + c0 * (1 + e0);
  ai = ai + s0 * (1 - e0);
  br = br - s0 * (1 + e0);
  bi = bi + c0 * (1 - e0);
  ai = ai * side;
  bi = bi * side;
  const odd = 1 - 2 * (count - 2 * Math.floor(0.5 * count));
  return [c * ar - s * ai, c * ai + s * ar, odd * (c * br - s * bi), odd * (c * bi + s * br)];
}

/** Return attitude and momentum. */
export function stateOf(m, spinor) {
  const { 0: a0, 1: a1, 2: b0, 3: b1 } = spinor;
  const aa = a0 * a0 + a1 * a1;
  const bb = b0 * b0 + b1 * b1;
  const x = 1 / (aa + bb);
  const root = Math.sqrt(x);
  const x2 = x + x;
  // the direction of L of a spinor (A, B): 2 Re ĀB, 2 Im ĀB and |A|² − |B|², over |A|² + |B|²
  const n0 = (a0 * b0 + a1 * b1) * x2;
  const n1 = (a0 * b1 - a1 * b0) * x2;
  const n2 = (aa - bb) * x;
  const a = a0 * root;
  const b = a1 * root;
  const c = b0 * root;
  const d = b1 * root;
  const q = m.toAttitude;
  const p = m.toMomentum;
  return [
    q[0] * a + q[1] * b + q[2] * c + q[3] * d,
    q[4] * a + q[5] * b + q[6] * c + q[7] * d,
    q[8] * a + q[9] * b + q[10] * c + q[11] * d,
    q[12] * a + q[13] * b + q[14] * c + q[15] * d,
    p[0] * n0 + p[1] * n1 + p[2] * n2,
    p[3] * n0 + p[4] * n1 + p[5] * n2,
    p[6] * n0 + p[7] * n1 + p[8] * n2,
  ];
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
