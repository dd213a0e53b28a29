// Printed from src/polhode/exact/lagrange_top/_formulas_setup.py by `python -m printing`: change that, and print again.
//
// From a top's frequencies and the places of its poles to the constants of its motion: theta series and phases.

import { timesPower } from "../words.js";
import { add, divide, halves, root, scale, sineCosine, whole } from "./arithmetic.js";
import { nomePerParameter } from "./common.js";
import { complementaryPhase, complementarySums, fullSums } from "./lagrange_top.js";
import { climb, halfPeriods, periods, phaseRates } from "./lagrange_top_rates.js";
import { isUpright, leaves, ONE, ZERO } from "./lagrange_top_reduction.js";

export const NO_TERMS = [0, 0, 0, 0];

/**
 * The modulus and the places of start and poles in the lattice.
 *
 * @typedef {object} Arguments
 * @property {boolean} full
 * @property {number} q nome of the smaller parameter
 * @property {number} theta3
 * @property {number} yAlpha imaginary distance of the poles, times π/2K (full) or π/2K'
 * @property {number} yBeta
 * @property {number} wAlpha full: the like of K' − v
 * @property {number} wBeta
 * @property {number[]} x0
 */

/**
 * A reduced top with all that its motion is made from.
 *
 * @typedef {object} Given
 * @property {Reduction} top
 * @property {TurningPoints} points
 * @property {Frequencies} rates
 * @property {Arguments} at
 * @property {number} axial L3 as given
 */

/**
 * What of a `Motion` depends on rates and places.
 *
 * @typedef {object} Timing
 * @property {Array} rates its first to start
 * @property {Array} places its nome to rates
 * @property {number[]} linear derivatives by τ of the phases of α and β that evaluation adds to A and B, spin aside
 * @property {number} turn dz/dτ or dx'/dτ
 */

/** Return whether the motion takes the full form, m ≤ ½, if it nutates. */
export function isFull(top, points) {
  // m = (A − B)/A = G (u2 − u1)/A and 1 − m = B/A
  return top.G[0] * points.d[0] <= points.B[0];
}

/** Return modulus and places, of the integrals. */
export function arguments_(top, points, rates, integrals) {
  const m = top.G[0] * points.d[0] / points.A[0];
  const m1 = rates.separatrix ? 0 : points.B[0] / points.A[0];
  const full = rates.permanent || (isFull(top, points) && !rates.separatrix);
  const small = rates.permanent ? 0 : full ? m : m1;
  const q = small * nomePerParameter(small, Math.sqrt(1 - small));
  const q4 = q * q * (q * q);
  const theta3 = 1 + 2 * (q + q4 + q4 * q4 * q);
  const by = 1 / (theta3 * theta3); // π/2K of the smaller quarter period (DLMF 22.2.2)
  const x0 = scale(add(integrals.x0, climb(top)), top.p[0] >= 0 ? 1 : -1);
  return {
    full,
    q,
    theta3,
    yAlpha: integrals.vAlpha * by,
    yBeta: integrals.vBeta * by,
    wAlpha: integrals.wAlpha * by,
    wBeta: integrals.wBeta * by,
    x0,
  };
}

// ---------------------------------------------------------------------- series

/** Return sums and differences of the coefficients of e^{±ikz}, k = 1, 3, 5, 7. */
export function fullTerms(size, h, q, r, alternating) {
  let w1 = q * r;
  let w2 = q * q * r;
  let w3 = q * q * q * r;
  w2 = w2 * w2;
  w3 = w3 * w3 * w3;
  const h3 = h * h * h;
  const h5 = h3 * h * h;
  const h7 = h3 * h3 * h;
  size = size / (w3 * (1 + h7) + w2 * (1 + h5) + w1 * (1 + h3) + (1 + h));
  w1 = alternating * size * w1;
  w2 = size * w2;
  w3 = alternating * size * w3;
  return [
    [size * (1 + h), w1 * (1 + h3), w2 * (1 + h5), w3 * (1 + h7)],
    [size * (1 - h), w1 * (1 - h3), w2 * (1 - h5), w3 * (1 - h7)],
  ];
}

/** Return √t θ3 and √s θ4. */
export function fullSizes(rootT, rootS, q, theta3) {
  const q4 = q * q * (q * q);
  return [rootT * theta3, rootS * (1 - 2 * (q - q4 + q4 * q4 * q))];
}

/** Return cos ky and sin ky for k = 1 to 4 of 0 ≤ y ≤ π. */
function _multiples(y) {
  const { 0: s1, 1: c1 } = sineCosine(y * (0.5 / Math.PI));
  const s2 = 2 * s1 * c1;
  const c2 = 1 - 2 * s1 * s1;
  return [[c1, c2, c2 * c1 - s2 * s1, 1 - 2 * s2 * s2], [s1, s2, s2 * c1 + c2 * s1, 2 * s2 * c2]];
}

/** Return A's factors of sin ky and cos ky, k = 1, 3, 5, 7, B's of cos and sin of 2, 4, 6, 8 y, and its constant. */
export function complementarySeries(rootT, rootS, q, theta3, yAlpha, yBeta) {
  const q2 = q * q;
  const q4 = q2 * q2;
  const q6 = q2 * q2 * q2;
  const q9 = q6 * q2 * q;
  let { 0: c, 1: s } = _multiples(yAlpha);
  let theta4 = 1 - 2 * (q * c[1] - q4 * c[3] + q9 * (2 * c[2] * c[2] - 1));
  let size = rootT * theta3 / theta4;
  const c5 = c[3] * c[0] - s[3] * s[0];
  const s5 = s[3] * c[0] + c[3] * s[0];
  const c7 = c[3] * c[2] - s[3] * s[2];
  const s7 = s[3] * c[2] + c[3] * s[2];
  const aSine = [size * s[0], -size * s[2], size * s5, -size * s7];
  const aCosine = [size * c[0], -size * c[2], size * c5, -size * c7];
  ({ 0: c, 1: s } = _multiples(2 * yBeta));
  theta4 = 1 - 2 * (q * c[0] - q4 * c[1] + q9 * c[2]);
  size = rootS * (1 + q2 + q6 + q6 * q6) / theta4;
  return [
    aSine,
    aCosine,
    [-size * c[0], size * c[1], -size * c[2], size * c[3]],
    [-size * s[0], size * s[1], -size * s[2], size * s[3]],
    size,
  ];
}

/** Return √(t/2) and √(s/2) at the given size of the displacement, where that stays as small. */
function _sizes(top, t, s) {
  const down = timesPower(1, -(leaves(top) ? 0 : top.lift));
  const upright = isUpright(top);
  const rootT = Math.sqrt(0.5 * t[0]);
  const rootS = Math.sqrt(0.5 * s[0]);
  return [rootT * (upright ? 1 : down), rootS * (upright ? down : 1)];
}

/** Return q e^{2y}, accurate where y is far out, and e^{−2y}, of α and of β. */
export function tails(at) {
  return [Math.exp(-2 * at.wAlpha), Math.exp(-2 * at.yAlpha), Math.exp(-2 * at.wBeta), Math.exp(-2 * at.yBeta)];
}

/** Return sums and differences of the coefficients of e^{±ikz}, k = 1, 3, 5, 7, in A and in B. */
export function fullSeries(top, points, at, tail) {
  const { 0: rootT, 1: rootS } = _sizes(top, points.t2, points.s1);
  const { 0: ofAlpha, 1: ofBeta } = fullSizes(rootT, rootS, at.q, at.theta3);
  const some = at.q > 0;
  const { 0: aSum, 1: aGap } = fullTerms(ofAlpha, tail[1], at.q, some ? tail[0] : 0, -1);
  const { 0: bSum, 1: bGap } = fullTerms(ofBeta, tail[3], at.q, some ? tail[2] : 0, 1);
  return [aSum, aGap, bSum, bGap, 0];
}

function _full(given) {
  return fullSeries(given.top, given.points, given.at, tails(given.at));
}

/** Return the series of a permanent top, which has one of α, β, or at rest both, as it started. */
function _standing(given) {
  // A = |α| sin z and B = i |β| sin z at z = π/2
  const { 0: rootT, 1: rootS } = _sizes(given.top, given.top.t0, given.top.s0);
  return [[rootT, 0, 0, 0], NO_TERMS, NO_TERMS, [rootS, 0, 0, 0], 0];
}

function _ofFullForm(given) {
  return given.rates.permanent ? _standing(given) : _full(given);
}

/** Return the series of the complementary form. */
export function complementary(top, points, at) {
  const { 0: rootT, 1: rootS } = _sizes(top, points.t2, points.s1);
  return complementarySeries(rootT, rootS, at.q, at.theta3, at.yAlpha, at.yBeta);
}

function _ofComplementaryForm(given) {
  return complementary(given.top, given.points, given.at);
}

// ---------------------------------------------------------------------- phases

/**
 * Return cos and sin of the phase that turns A or B at the epoch into the given α or β.
 *
 * Where one of them vanishes its own phase says nothing; its derivative then does, so both are used.
 */
function _constantPhase(r, i, dr, di, turns, rate, component, slope, norm, drop, turn, size) {
  r = r / norm;
  i = i / norm;
  const sr = turn * (dr / norm - r * drop) - rate * i;
  const si = turn * (di / norm - i * drop) + rate * r;
  const { 0: gr, 1: gi } = component;
  const { 0: er, 1: ei } = slope;
  let real = r * gr + i * gi + (sr * er + si * ei) / size;
  let imaginary = r * gi - i * gr + (sr * ei - si * er) / size;
  const { 0: s, 1: c } = sineCosine(turns - whole(turns));
  ({ 0: real, 1: imaginary } = [real * c + imaginary * s, imaginary * c - real * s]);
  const length = Math.sqrt(real * real + imaginary * imaginary);
  const some = length > 0;
  const safe = some ? length : 1;
  return [some ? real / safe : 1, some ? imaginary / safe : 0];
}

/**
 * Return cos and sin of the phases that turn A and B at the epoch into the given α and β.
 *
 * Args:
 *     quaternion, norm2: at the epoch, and its |q|².
 *     momentum: at the epoch.
 *     size: |L|² + G, by which derivatives count.
 *     sums: at the epoch.
 *     linear: derivatives by τ of the phases that evaluation adds to A and B.
 *     turn: dz/dτ or dx'/dτ.
 */
export function constantPhases(quaternion, norm2, momentum, size, sums, linear, turn) {
  const { 0: x, 1: y, 2: z } = momentum;
  const length = root(norm2);
  const q0 = divide([quaternion[0], 0], length)[0];
  const q1 = divide([quaternion[1], 0], length)[0];
  const q2 = divide([quaternion[2], 0], length)[0];
  const q3 = divide([quaternion[3], 0], length)[0];
  // 2α' = i a α − w̄ β, 2β' = w α − i a β
  const a = [0.5 * (-z * q3 - (x * q1 + y * q2)), 0.5 * (z * q0 - (x * q2 - y * q1))];
  const b = [0.5 * (x * q0 - y * q3 + z * q2), 0.5 * (x * q3 + y * q0 - z * q1)];
  const { 0: ar, 1: ai, 2: br, 3: bi, 4: dar, 5: dai, 6: dbr, 7: dbi, 8: turnsA, 9: turnsB } = sums;
  const length2 = ar * ar + ai * ai + (br * br + bi * bi);
  const norm = Math.sqrt(length2);
  const drop = (ar * dar + ai * dai + (br * dbr + bi * dbi)) / length2;
  const { 0: c0, 1: s0 } = _constantPhase(ar, ai, dar, dai, turnsA, linear[0], [q0, q3], a, norm, drop, turn, size);
  const { 0: c1, 1: s1 } = _constantPhase(br, bi, dbr, dbi, turnsB, linear[1], [q1, q2], b, norm, drop, turn, size);
  return [c0, s0, c1, s1];
}

/** Return the constant phases, of the sums at the epoch. */
export function phasesOf(top, timing, sums) {
  const { 0: ar, 1: ai, 2: br, 3: bi, 4: dar, 5: dai, 6: dbr, 7: dbi, 8: turnsA, 9: turnsB } = sums;
  const up = timesPower(1, top.lift);
  const upright = isUpright(top);
  const a = upright ? 1 : up;
  const b = upright ? up : 1;
  const { 0: x, 1: y, 2: z } = top.momentum;
  const size = x * x + y * y + (z * z + top.G[0]);
  const lifted = [ar * a, ai * a, br * b, bi * b, dar * a, dai * a, dbr * b, dbi * b, turnsA, turnsB];
  return constantPhases(
    top.quaternion,
    top.size,
    top.momentum,
    size > 0 ? size : 1,
    lifted,
    timing.linear,
    timing.turn,
  );
}

// ---------------------------------------------------------------------- the whole

function _inHalves(rate) {
  const { 0: high, 1: low } = halves(rate[0]);
  return [high, low, rate[1]];
}

/** Return what of the motion depends on rates and places. */
export function timingOf(top, rates, at) {
  const { 0: i1 } = top.moments;
  const permanent = rates.permanent;
  const separatrix = rates.separatrix;
  const full = at.full;
  const { 0: alpha, 1: beta } = phaseRates(top, rates);
  const half = halfPeriods(rates.nutation, i1, top.rateScale);
  const saddle = divide(scale(rates.halfRoot, top.rateScale), [i1, 0]);
  const third = permanent ? ZERO : full ? scale(half, 0.5) : separatrix ? saddle : half;
  let { 0: quarter, 1: period } = periods(rates.halfRoot, rates.nutation, at.q);
  const fraction = scale(divide(at.x0, quarter), 0.5);
  let start = full ? scale(fraction, 0.5) : separatrix ? at.x0 : fraction;
  start = permanent ? [0.25, 0] : start;
  period = separatrix ? ONE : period;
  const { 0: upper, 1: lower } = halves(period[0]);
  const ya = full || separatrix ? 0 : at.yAlpha;
  const yb = full || separatrix ? 0 : at.yBeta;
  const carried = rates.nutation[0] * (2 / Math.PI);
  const sa = rates.signAlpha;
  const sb = rates.signBeta;
  let turn = full ? rates.nutation[0] : rates.halfRoot[0] / (at.theta3 * at.theta3);
  const linearA = permanent ? 0 : rates.alpha[0] + sa * ya * carried;
  const linearB = permanent ? 0 : rates.beta[0] + sb * yb * carried;
  turn = permanent ? 0 : turn;
  const size = top.momentumScale;
  return {
    rates: [_inHalves(alpha), _inHalves(beta), _inHalves(third), start],
    places: [
      [at.q, upper, lower + period[1], ya / Math.PI, yb / Math.PI, separatrix ? 0 : 1],
      [permanent ? 1 : sa, permanent ? 1 : sb],
      [2 * turn * size, 2 * (linearA + linearB) * size],
    ],
    linear: [linearA, linearB],
    turn,
  };
}

function _motion(given, timing, series, phases) {
  const { 0: first, 1: second, 2: third, 3: start } = timing.rates;
  const { 0: nome, 1: signs, 2: rates } = timing.places;
  const { 0: aSum, 1: aGap, 2: bSum, 3: bGap, 4: constant } = series;
  return {
    full: given.at.full ? 1 : 0,
    first,
    second,
    third,
    start,
    aSum,
    aGap,
    bSum,
    bGap,
    constant,
    nome,
    signs,
    rates,
    phases,
    axial: given.axial,
    reversed: given.top.reversed ? -1 : 1,
  };
}

/** Return the motion of a top whose constant phases are none. */
export function motionWithoutPhases(given) {
  const timing = timingOf(given.top, given.rates, given.at);
  const series = given.at.full ? _ofFullForm(given) : _ofComplementaryForm(given);
  return [_motion(given, timing, series, [1, 0, 1, 0]), timing];
}

function _fullStart(m) {
  const zero = 0 * m.start[0];
  return fullSums(m, [zero, zero, zero]);
}

function _complementaryStart(m) {
  const zero = 0 * m.start[0];
  const { 0: a, 1: b, 2: c, 3: e, 4: factor, 5: other, 6: otherFactor } = complementaryPhase(m, [zero, zero, zero]);
  return complementarySums(m, a, b, c, Math.exp(e) * factor, Math.exp(other) * otherFactor);
}

/** Return the motion, which begins at the given attitude. */
export function motionWithPhases(given, motion, timing) {
  const sums = given.at.full ? _fullStart(motion) : _complementaryStart(motion);
  const series = [motion.aSum, motion.aGap, motion.bSum, motion.bGap, motion.constant];
  return _motion(given, timing, series, phasesOf(given.top, timing, sums));
}

/** Return the constants of motion of a top. */
export function motionOf(given) {
  const { 0: motion, 1: timing } = motionWithoutPhases(given);
  return motionWithPhases(given, motion, timing);
}
