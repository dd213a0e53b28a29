// Printed from src/polhode/exact/lagrange_top/_formulas_rates.py by `python -m printing`: change that, and print again.
//
// The three frequencies of a Lagrange top: nutation, and the mean turns of α and β, by arithmetic–geometric means.
//
// α and β turn by c'/2t and c/2s, whose means over a nutation are complete integrals of the third kind. Each has two
// forms, one for either side of the pole that it looks at, so that nothing cancels. Source: Carlson, SIAM J. Math.
// Anal. 8 (1977) 231; Klein & Sommerfeld, *Theorie des Kreisels*, ch. VI.

import {
  add,
  divide,
  INVERSE_TWO_PI,
  LN2,
  multiply,
  multiplyFloat,
  PI,
  rootOrZero,
  scale,
  subtract,
  twoProduct,
  twoSum,
} from "./arithmetic.js";
import { byTheta, thirdKindMean } from "./common.js";
import { leaves, ONE, ZERO } from "./lagrange_top_reduction.js";

/**
 * Rates by τ = t/I1 in scaled units; all but the signs and flags are double-double.
 *
 * @typedef {object} Frequencies
 * @property {number[]} halfRoot W = ½√A: x = x0 + W τ
 * @property {number[]} nutation ϖ = ½ agm(√A, √B) = πW/2K, zero on the separatrix
 * @property {number[]} alpha linear rates of the phases of α and β apart from their theta quotients
 * @property {number[]} beta
 * @property {number} signAlpha sgn c' and sgn c, +1 for zero
 * @property {number} signBeta
 * @property {number[]} spin ν I1, the spin that I3 ≠ I1 adds, by τ
 * @property {boolean} permanent the momentum stays: sleeping, hanging, rest
 * @property {boolean} separatrix
 * @property {boolean} steady the tilt stays
 */

/**
 * What the means start from, and harmless numbers where there is no period.
 *
 * @typedef {object} Starts
 * @property {number[]} rootA
 * @property {number[]} rootB
 * @property {number[]} alpha p² of the sums of α and β
 * @property {number[]} beta
 * @property {boolean} permanent
 * @property {boolean} separatrix
 */

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

function _firstAlpha(points) {
  return points.ZPlus[0] <= 2 * points.A[0];
}

function _firstBeta(top, points) {
  return multiply(top.G, points.s2)[0] <= points.ZMinus[0];
}

/** Return what the means start from. */
export function startsOf(top, points) {
  const a = top.momentum[2];
  const vertical = top.s0[0] === 0 || top.t0[0] === 0;
  const permanent = top.w2[0] === 0 && (vertical || (top.G[0] === 0 && a === 0));
  const separatrix = !(points.B[0] > 0) && !permanent;
  const idle = permanent || separatrix;
  const one = ONE;
  const alpha = startOfAlpha(_firstAlpha(points), points.A, points.ZPlus, points.t1, points.t2);
  const first = _firstBeta(top, points);
  const beta = startOfBeta(first, top.c, points.A, points.B, points.ZMinus, points.s1, points.s2);
  return {
    rootA: idle ? one : rootOrZero(points.A),
    rootB: idle ? one : rootOrZero(points.B),
    alpha: idle ? one : alpha,
    beta: idle ? one : beta,
    permanent,
    separatrix,
  };
}

/** Return the frequencies of a top as its displacement is scaled, of the mean and the third-kind sums. */
export function frequenciesOf(top, points, start, mean, totalAlpha, totalBeta) {
  const nutation = scale(mean, 0.5);
  const separatrix = start.separatrix;
  const signAlpha = top.cPlus[0] >= 0 ? 1 : -1;
  const signBeta = top.c[0] >= 0 ? 1 : -1;
  const cPlus = scale(top.cPlus, signAlpha);
  const c = scale(top.c, signBeta);
  const first = _firstBeta(top, points);
  let alpha = drift(
    _firstAlpha(points),
    cPlus,
    top.G,
    points.ZPlus,
    points.t1,
    points.t2,
    points.d,
    nutation,
    totalAlpha,
  );
  let beta = drift(first, c, top.G, points.ZMinus, points.s2, points.s1, points.d, nutation, totalBeta);
  alpha = scale(separatrix ? scale(cPlus, 0.25) : alpha, signAlpha);
  beta = scale(separatrix ? ZERO : beta, first ? -signBeta : signBeta);
  const steady = !(points.d[0] > 0 || start.permanent || separatrix);
  return {
    halfRoot: scale(rootOrZero(points.A), 0.5),
    nutation: separatrix ? ZERO : nutation,
    alpha,
    beta,
    signAlpha,
    signBeta,
    spin: spin(top.moments[0], top.moments[1], top.momentum[2]),
    permanent: start.permanent,
    separatrix,
    steady,
  };
}

/** Return the x = W τ after which the displacement of a top that leaves the vertical has the lifted one's size. */
export function climb(top) {
  return multiplyFloat(LN2, leaves(top) ? top.lift : 0);
}

/**
 * Return the frequencies of tops that leave the vertical from those of the lifted ones.
 *
 * The displacement grows and falls as e^{±x}, so K = πW/2ϖ is longer by `climb`. During it α turns by c'/4 and
 * β not at all, so the turns of a nutation that are beyond that stay unchanged and their mean rates shrink as ϖ does.
 */
function _lingering(top, rates) {
  const W = rates.halfRoot;
  const cPlus = scale(top.cPlus, 0.25);
  const one = ONE;
  const pi = PI;
  const lingers = leaves(top);
  const longer = scale(divide(multiply(climb(top), rates.nutation), multiply(pi, W)), 2); // climb/K
  const share = divide(one, add(one, longer));
  const alpha = add(cPlus, multiply(subtract(rates.alpha, cPlus), share));
  return {
    halfRoot: W,
    nutation: lingers ? multiply(rates.nutation, share) : rates.nutation,
    alpha: lingers ? alpha : rates.alpha,
    beta: lingers ? multiply(rates.beta, share) : rates.beta,
    signAlpha: rates.signAlpha,
    signBeta: rates.signBeta,
    spin: rates.spin,
    permanent: rates.permanent,
    separatrix: rates.separatrix,
    steady: rates.steady,
  };
}

/** Return the frequencies of a reduced top. */
export function frequencies(top, points) {
  const start = startsOf(top, points);
  const { 0: mean, 1: totalAlpha } = thirdKindMean(start.rootA, start.rootB, start.alpha);
  const { 1: totalBeta } = thirdKindMean(start.rootA, start.rootB, start.beta);
  return _lingering(top, frequenciesOf(top, points, start, mean, totalAlpha, totalBeta));
}

/** Return the rates of the phases of α and β [turns per time], the spin that I3 ≠ I1 adds included. */
export function phaseRates(top, rates) {
  const half = scale(rates.spin, 0.5);
  const { 0: i1, 1: i3 } = top.moments;
  const own = divide(twoProduct(0.5 * top.momentum[2], i1), [i3, 0]);
  const alpha = rates.permanent ? own : add(rates.alpha, half);
  const beta = rates.permanent ? [-own[0], -own[1]] : subtract(rates.beta, half);
  return [turnsPerTime(alpha, i1, top.rateScale), turnsPerTime(beta, i1, top.rateScale)];
}
