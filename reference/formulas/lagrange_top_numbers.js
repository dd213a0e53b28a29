// Printed from src/polhode/exact/lagrange_top/_formulas_numbers.py by `python -m printing`: change that, and print
// again.
//
// The numbers that describe a Lagrange top's motion, of its reduction, turning points and frequencies.

import { add, divide, multiply, multiplyFloat, PI, scale, subtract } from "./arithmetic.js";

/**
 * What a top's motion is like; what is infinite is inf, what is undefined NaN.
 *
 * @typedef {object} Numbers
 * @property {number} regime 0 rest, 1 sleeping, 2 hanging, 3 steady, 4 free, 5 planar, 6 undulating, 7 cusp, 8 loop, 9
 * separatrix
 * @property {number} lowest of the cosine of the tilt from the upward vertical
 * @property {number} highest
 * @property {number} period of the nutation; of a steady top that of its smallest nutations
 * @property {number} precessionPerPeriod azimuth gained by the axis in a period, unreduced
 * @property {number} spinPerPeriod the body's own turn in a period, unreduced
 */

/** Return u from the smaller of 1 − u and 1 + u. */
function _cosine(s, t) {
  const one = [1, 0];
  return s[0] < t[0] ? subtract(one, s)[0] : subtract(t, one)[0];
}

/**
 * Signs of polynomials in the given floats decide; only the steady top needs the computed gap u2 − u1.
 *
 * The azimuth is at rest where p_φ = a u; there |w|² = lean/a, which is positive inside the nutation's range.
 */
function _regime(top, rates) {
  const a = top.momentum[2];
  const c = top.c[0];
  const cPlus = top.cPlus[0];
  const lean = top.lean[0];
  const along = a < 0 ? -lean : lean;
  const within = c * a < 0 && cPlus * a > 0; // the place p_φ/a is a tilt: −1 < p_φ/a < 1
  let code = within && along > 0 ? 8 : 6;
  code = within && along === 0 ? 7 : code;
  code = a === 0 && c === 0 ? 5 : code;
  code = rates.steady ? 3 : code;
  code = rates.separatrix ? 9 : code;
  code = rates.permanent ? (top.s0[0] === 0 ? 1 : 2) : code;
  code = top.G[0] === 0 ? 4 : code;
  return a === 0 && rates.permanent ? 0 : code;
}

function _byKind(rates, permanent, separatrix, periodic) {
  return rates.permanent ? permanent : rates.separatrix ? separatrix : periodic;
}

/** Return the numbers of a top. */
export function numbers(top, points, rates) {
  let lower = _cosine(points.s1, points.t1);
  let upper = _cosine(points.s2, points.t2);
  lower = rates.permanent ? top.u0[0] : lower;
  upper = rates.permanent ? top.u0[0] : upper;
  const pi = PI;
  // α = cos(θ/2) e^{i(φ + ψ)/2}, β = sin(θ/2) e^{i(φ − ψ)/2} up to a constant phase: φ = arg α + arg β,
  // ψ = arg α − arg β. In a period, π/ϖ by τ, each argument gains its linear part, and half a turn by its thetas
  const turnAlpha = add(divide(rates.alpha, rates.nutation), [rates.signAlpha, 0 * rates.signAlpha]);
  const turnBeta = add(divide(rates.beta, rates.nutation), [rates.signBeta, 0 * rates.signBeta]);
  const spin = divide(rates.spin, rates.nutation);
  const precession = multiply(pi, add(turnAlpha, turnBeta))[0];
  let ownTurn = multiply(pi, add(subtract(turnAlpha, turnBeta), spin))[0];
  const period = divide(multiplyFloat(pi, top.moments[0]), scale(rates.nutation, top.rateScale))[0];
  ownTurn = (top.reversed ? -1 : 1) * ownTurn + 0; // never −0
  return {
    regime: _regime(top, rates),
    lowest: top.reversed ? -upper : lower,
    highest: top.reversed ? -lower : upper,
    period: _byKind(rates, NaN, Infinity, period),
    precessionPerPeriod: _byKind(rates, NaN, NaN, precession),
    spinPerPeriod: _byKind(rates, NaN, NaN, ownTurn),
  };
}
