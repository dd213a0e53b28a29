// Printed from src/polhode/exact/_formulas.py by `python -m printing`: change that, and print again.
//
// Formulas of both motions: arguments in half periods, the nome, the arithmetic–geometric mean.

import { binaryExponent, nearest, smaller, timesPower } from "../words.js";
import {
  add,
  divide,
  fastTwoSum,
  halves,
  multiply,
  phase,
  root,
  scale,
  square,
  subtract,
  twoSum,
} from "./arithmetic.js";

export const CONVERGED = 2e-8; // the closing formulas of the mean leave an error of the fourth power
export const MOST_STEPS = 20;
export const AT_ONCE = 3; // steps of all, before the first is looked at

/** Return the leading part of −(x + rest)(upper + lower), which is exact, and the factor for the rest. */
export function exponent(x, rest, upper, lower) {
  // −(x + rest)(upper + lower) = −high · upper − small, and e^(−small) to second order
  const { 0: high, 1: low } = halves(x);
  const small = high * lower + low * (upper + lower) + rest * upper;
  return [-(high * upper), 1 - small * (1 - 0.5 * small)];
}

/**
 * Return an argument in half periods as a number within ±½ and its rest, and the half periods taken out.
 *
 * On the separatrix, where `periodic` is zero, it runs to infinity and none is taken out.
 */
export function reducedArgument(rate, start, periodic, time) {
  const { 0: fraction, 1: rest, 2: turned } = phase(rate, time);
  const { 0: total, 1: firstError } = twoSum((1 - periodic) * turned, fraction);
  let { 0: u, 1: secondError } = twoSum(total, start[0]);
  let uRest;
  ({ 0: u, 1: uRest } = fastTwoSum(u, rest + (start[1] + (firstError + secondError))));
  const more = periodic * nearest(u);
  return [u - more, uRest, periodic * turned + more];
}

/** Return `elliptic.nome_per_parameter`. */
export function nomePerParameter(parameter, k) {
  const more = 1 + Math.sqrt(k);
  const ratio = 0.5 / ((1 + k) * more * more);
  const e = ratio * parameter;
  const e4 = e * e * (e * e);
  return ratio * (1 + e4 * (2 + e4 * (15 + e4 * (150 + e4 * 1707))));
}

/** Return a period over θ3², of which 1/θ3² is 1 less a small correction. */
export function byTheta(period, nome) {
  const q4 = nome * nome * (nome * nome);
  const e = 2 * (nome + q4 + q4 * q4 * nome);
  return add(period, [-period[0] * (e * (2 + e) / ((1 + e) * (1 + e))), 0]);
}

/**
 * Take a step of the arithmetic–geometric mean and its third-kind sum, in double-double.
 *
 * With ε = (p²−ag)/(p²+ag), Q ← Qε/2 and p ← (p²+ag)/2p; the sum is of all Q, from Q = 1. Arithmetic and square roots
 * alone give complete elliptic integrals of the first and third kind, so that the rates of exact motion carry thirty
 * digits and their phases stay right for any time. Source: Carlson, SIAM J. Math. Anal. 8 (1977) 231.
 */
export function meanStep(a, g, pp, q, total) {
  const ag = multiply(a, g);
  const both = add(pp, ag);
  q = scale(multiply(q, divide(subtract(pp, ag), both)), 0.5);
  return [scale(add(a, g), 0.5), root(ag), scale(divide(square(both), pp), 0.25), q, add(total, q)];
}

/** Return x = (a−g)/(a+g), ε and (a+g)/2; ag is taken as ((a+g)/2)² − ((a−g)/2)², which does not cancel in ε. */
export function meanDistance(a, g, pp) {
  const middle = scale(add(a, g), 0.5);
  const half = 0.5 * (a[0] - g[0] + (a[1] - g[1]));
  const d = subtract(pp, square(middle));
  const e = d[0] + d[1] + half * half;
  return [half / middle[0], e / (2 * middle[0] * middle[0] + e), middle];
}

/** Return the mean and the sum of what `meanDistance` returns, exact where that is below `CONVERGED`. */
export function meanClosed(x, e, middle, q, total) {
  const last = 0.5 * q * e;
  const rest = last + last * (0.25 * (e * e - 0.5 * x * x));
  // agm(1 + x, 1 − x) = 1 − x²/4 + O(x⁴)
  return [add(middle, [-0.25 * middle[0] * x * x, 0]), add(total, [rest, 0])];
}

// ---------------------------------------------------------------------- the mean, from its start to its end

/**
 * Return where the mean of positive a and g begins, with the sum that starts from p², and the exponent taken out.
 *
 * Rates go down to 1e-150, whose fourth powers would underflow. Scaled down, a tiny g would.
 */
export function meanStart(a, g, pp) {
  const power = smaller(binaryExponent(a[0]), 0 * a[0]);
  const up = timesPower(1, -power);
  const one = [1, 0];
  return [[scale(a, up), scale(g, up), scale(scale(pp, up), up), one, one], power];
}

/** Return the mean after a step. */
export function meanNext(state) {
  const { 0: a, 1: g, 2: pp, 3: q, 4: total } = state;
  return meanStep(a, g, pp, q, total);
}

/** Return whether the closing formulas are exact. */
export function meanConverged(state) {
  const { 0: x, 1: e } = meanDistance(state[0], state[1], state[2]);
  return Math.abs(x) < CONVERGED && Math.abs(e) < CONVERGED;
}

/** Return mean and sum, of which the first lacks the exponent taken out. */
export function meanEnd(state) {
  const { 0: x, 1: e, 2: middle } = meanDistance(state[0], state[1], state[2]);
  return meanClosed(x, e, middle, state[3][0], state[4]);
}

/** Return agm(a, g) of positive numbers, and the sum that starts from p² = pp. */
export function thirdKindMean(a, g, pp) {
  const { 0: state, 1: power } = meanStart(a, g, pp);
  let running = state;
  for (let k = 0; k < MOST_STEPS; k++) {
    if (k >= AT_ONCE && meanConverged(running)) break;
    running = meanNext(running);
  }
  const { 0: mean, 1: total } = meanEnd(running);
  return [scale(mean, timesPower(1, power)), total];
}
