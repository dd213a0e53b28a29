// Printed from src/polhode/exact/free_body/_formulas_rates.py by `python -m printing`: change that, and print again.
//
// The two frequencies of a free body, by one arithmetic–geometric mean with its third-kind sum.
//
// The polhode angle π u/2K turns at agm(√(BQ), √(−CS)); the frame about the angular momentum turns at the mean
// precession rate ω_p = 2E/G + λ[Z(α|m1) + πα/(2KK')]. Both come from arithmetic and square roots alone, so they run in
// double-double and their phases stay exact for any time. Source: Carlson, SIAM J. Math. Anal. 8 (1977) 231 for the
// third-kind AGM; the choice of starting value keeps its convergence quadratic in every regime.

import {
  add,
  divide,
  halves,
  INVERSE_TWO_PI,
  multiply,
  rootOrZero,
  scale,
  subtract,
  twoProduct,
} from "./arithmetic.js";
import { thirdKindMean } from "./common.js";

/**
 * Rates times V in canonical scaled units, and the regime of the body.
 *
 * @typedef {object} Frequencies
 * @property {number[]} modulusRate λ = √(BQ): u = u0 + λ t
 * @property {number[]} mean agm(√(BQ), √(−CS)) = π λ / 2K; meaningless on the separatrix
 * @property {number[]} precession ω_p
 * @property {number[]} G |L|
 * @property {boolean} constant permanent rotation, sphere or rest: L stays
 * @property {boolean} separatrix
 */

/**
 * What of the frequencies is there before the mean.
 *
 * @typedef {object} Start
 * @property {number[]} modulusRate
 * @property {boolean} constant
 * @property {boolean} separatrix
 */

/**
 * Return the start and √(BQ), √(−CS) and p² for the mean, or ones where there is no period.
 *
 * p² is so chosen that the third-kind sum stays quadratic.
 */
export function startOf(body) {
  const rate = rootOrZero(multiply(body.B, body.Q));
  const slow = multiply(rootOrZero(body.C), body.rootS);
  const third = body.B[0] >= body.A[0];
  let pp = multiply(third ? body.Q : body.B, body.C);
  pp = third ? pp : multiply(pp, body.G2);
  const { 0: x, 2: z } = body.canonical;
  const isConstant = !(rate[0] > 0) || !(body.rootP > 0) || (x === 0 && z === 0);
  const separatrix = !(body.C[0] > 0 && body.rootS[0] > 0) && !isConstant;
  const idle = isConstant || separatrix;
  const one = [1, 0];
  const start = { modulusRate: rate, constant: isConstant, separatrix };
  return [start, idle ? one : rate, idle ? one : slow, idle ? one : pp];
}

/** Return the frequencies, of mean and third-kind sum. */
export function frequenciesOf(body, start, mean, total) {
  const g = rootOrZero(body.G2);
  const third = body.B[0] >= body.A[0];
  const { 0: i1, 1: i2, 2: i3 } = body.moments;
  // a1 V = I2 I3 and a3 V = I1 I2, and with the mirror −I1 I2 and −I2 I3
  const side = body.longAxis ? -1 : 1;
  const outer = twoProduct(side * (body.longAxis === third ? i1 : i3), i2);
  const correction = multiply(third ? body.A : body.P, total);
  const share = third ? scale(correction, -0.5) : scale(divide(correction, body.G2), 0.5);
  const rate = multiply(g, add(outer, share));
  let precession = third ? rate : add(rate, mean);
  // on the separatrix the frame ends up turning at |L|/I2, here times V = I1 I2 I3
  const saddle = multiply(g, twoProduct(side * i1, i3));
  precession = start.separatrix ? saddle : precession;
  return {
    modulusRate: start.modulusRate,
    mean,
    precession,
    G: g,
    constant: start.constant,
    separatrix: start.separatrix,
  };
}

/** Return the frequencies of a reduced body. */
export function frequencies(body) {
  const { 0: start, 1: fast, 2: slow, 3: pp } = startOf(body);
  const { 0: mean, 1: total } = thirdKindMean(fast, slow, pp);
  return frequenciesOf(body, start, mean, total);
}

/** Return `Motion.first` and `Motion.second` [turns per time], in halves, of a body with two frequencies. */
export function phaseRates(full, body, rates) {
  // rates times V become turns: over 2πV
  const inverse = scale(divide(INVERSE_TWO_PI, body.V), body.rateScale);
  const half = scale(multiply(rates.precession, inverse), 0.5);
  const turn = scale(multiply(rates.mean, inverse), 2);
  const quarter = scale(turn, 0.25);
  const saddle = scale(divide(rates.modulusRate, body.V), body.rateScale);
  const first = full ? subtract(half, quarter) : half;
  const second = rates.separatrix ? saddle : full ? add(half, quarter) : turn;
  const { 0: firstHigh, 1: firstLow } = halves(first[0]);
  const { 0: secondHigh, 1: secondLow } = halves(second[0]);
  return [[firstHigh, firstLow, first[1]], [secondHigh, secondLow, second[1]]];
}
