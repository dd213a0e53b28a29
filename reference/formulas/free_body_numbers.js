// Printed from src/polhode/exact/free_body/_formulas_numbers.py by `python -m printing`: change that, and print again.
//
// The numbers that describe a free body's motion, of its reduction and its two frequencies.

import { add, divide, multiply, PI, scale, subtract, twoProduct } from "./arithmetic.js";

export const SMALL_CAP = 1e-14; // below it the leading term of the cap's area is as exact as the difference it replaces

/**
 * What a free body's motion is like; what is infinite is inf, what is undefined NaN, and −1 of the axis.
 *
 * @typedef {object} Numbers
 * @property {number} regime 0 rest, 1 spherical, 2 permanent, 3 symmetric, 4 short axis, 5 long axis, 6 separatrix
 * @property {number} encircledAxis index of the given axis that the polhode goes round
 * @property {number} modulus
 * @property {number} period after which the momentum is back along the body's axes
 * @property {number} precessionRate mean rate at which the encircled axis turns about the momentum
 * @property {number} precessionPerPeriod
 * @property {number} solidAngle of the cap that the polhode cuts off about the encircled axis
 */

function _regime(body, rates) {
  const { 0: i1, 1: i2, 2: i3 } = body.moments;
  const { 0: x, 1: y, 2: z } = body.momentum;
  let code = body.longAxis ? 5 : 4;
  code = i1 === i2 || i2 === i3 ? 3 : code;
  code = rates.separatrix ? 6 : code;
  code = rates.constant ? 2 : code;
  code = i1 === i3 ? 1 : code;
  return x === 0 && y === 0 && z === 0 ? 0 : code;
}

/** Return Ω = 2π − (ω_p − 2E/|L|) T, in double-double, as small caps cancel. */
function _solidAngle(body, rates, perPeriod, scaledPeriod, twoPi) {
  const { 0: i1, 1: i2, 2: i3 } = body.moments;
  const b = body.B[0];
  const c = body.C[0];
  const p = body.P[0];
  const q = body.Q[0];
  const g2 = body.G2[0];
  const twiceEnergy = add(body.P, multiply(twoProduct(body.longAxis ? -i3 : i1, i2), body.G2));
  const dynamic = multiply(divide(twiceEnergy, rates.G), scaledPeriod);
  const angle = subtract(twoPi, subtract(perPeriod, dynamic));
  // a small cap is the ellipse C L1² + B L2² = P, of area πP/√(BC), over |L|²
  const cap = Math.PI * p / (Math.sqrt(b * c) * g2);
  // a symmetric body's period has no bound near its equator, and the difference no digit left
  const roundCap = 2 * Math.PI * (p / (c * g2)) / (1 + Math.sqrt(q / (c * g2)));
  return body.A[0] === 0 ? roundCap : p / (b * g2) < SMALL_CAP ? cap : angle[0];
}

function _byKind(rates, permanent, separatrix, periodic) {
  return rates.constant ? permanent : rates.separatrix ? separatrix : periodic;
}

/** Return the numbers of a body. */
export function numbers(body, rates) {
  const twoPi = scale(PI, 2);
  const scaledPeriod = divide(twoPi, rates.mean); // T/V
  const perPeriod = multiply(rates.precession, scaledPeriod); // ω_p T
  const period = divide(multiply(scaledPeriod, body.V), [body.rateScale, 0 * body.rateScale]);
  const rate = scale(divide(rates.precession, body.V), body.rateScale);
  const sense = body.longAxis ? -1 : 1;
  // k² = AP/(BQ)
  const modulus = Math.sqrt(body.A[0] / body.B[0]) * (body.rootP / Math.sqrt(body.Q[0]));
  const solidAngle = _solidAngle(body, rates, perPeriod, scaledPeriod, twoPi);
  return {
    regime: _regime(body, rates),
    encircledAxis: _byKind(rates, -1, -1, body.order[2]),
    modulus: _byKind(rates, NaN, 1, modulus),
    period: _byKind(rates, NaN, Infinity, period[0]),
    precessionRate: rates.constant ? NaN : sense * rate[0],
    precessionPerPeriod: _byKind(rates, NaN, Infinity, sense * perPeriod[0]),
    solidAngle: _byKind(rates, NaN, NaN, solidAngle),
  };
}
