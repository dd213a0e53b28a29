// Printed from src/polhode/exact/free_body/_formulas_setup.py by `python -m printing`: change that, and print again.
//
// From a body to the constants of its motion: the arguments of the theta functions, and the matrices.
//
// The arguments come by descending Landen transformation from tangents and hyperbolic sines that are ratios of the
// invariants, so neither elliptic integrals nor logarithms enter the full form. Source: DLMF §22.7.

import { larger, smaller } from "../words.js";
import {
  add,
  divide,
  fastTwoSum,
  halves,
  INVERSE_TWO_PI,
  multiply,
  PI,
  rootOrZero,
  scale,
  sineCosine,
  square,
  whole,
} from "./arithmetic.js";
import { byTheta, nomePerParameter } from "./common.js";
import { complementaryPhase, complementarySums, fullSums } from "./free_body.js";
import { phaseRates } from "./free_body_rates.js";

// 2.0 ** (-400); a sine above the inverse of the first is scaled by the second
export const HUGE_INVERSE = 3.8725919148493183e-121;
export const HUGE_SCALE = 6.223015277861142e-61; // 2.0 ** (-200)
export const LOG_OF_SCALE = [138.62943611198907, -3.3555121496085278e-15]; // 200 ln 2
export const NINE_ZEROS = [0, 0, 0, 0, 0, 0, 0, 0, 0];
export const SIXTEEN_ZEROS = [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0];

/**
 * What a form takes at the epoch.
 *
 * @typedef {object} Arguments
 * @property {number[]} start
 * @property {number[]} series
 * @property {number[]} nome
 * @property {number} parity
 */

/**
 * What the full form's start is the angle of, and its coefficients.
 *
 * @typedef {object} FullAmplitude
 * @property {number} rise
 * @property {number} run
 * @property {number[]} series
 */

/**
 * What the complementary form's start is made from.
 *
 * @typedef {object} Amplitude
 * @property {number} nome
 * @property {number} tangent of y, the circular amplitude
 * @property {number} sinh of x, the hyperbolic one, times HUGE_SCALE if it is huge
 * @property {boolean} huge
 */

/**
 * The amplitudes, and the hyperbolic sine of x as it is rounded.
 *
 * @typedef {object} Angles
 * @property {number} x
 * @property {number} sinh
 * @property {number} y
 */

/**
 * A body as given, with its reduction and frequencies.
 *
 * @typedef {object} Given
 * @property {number[]} moments
 * @property {number[]} momentum
 * @property {number[]} attitude
 * @property {Reduction} body
 * @property {Frequencies} rates
 */

// ---------------------------------------------------------------------- arguments and series

/** Return x, y, dn, factor, sinh and dc after a step. */
function _landenStep(x, y, dn, factor, sinh, cosine, dc) {
  // descending Landen (DLMF §22.7(i)), κ = (1 − k′)/(1 + k′): (1 − dn)/(1 + dn) = κ sn² of the next step, whose
  // dn² = 1 − κ² sn², and tan am = (1 + κ) tan am/dn of the next step
  const kappa = (x - y) / (x + y);
  const grown = 1 + kappa;
  const nextDn = Math.sqrt(1 - kappa * (1 - dn) / (1 + dn));
  sinh = 2 * sinh / (grown * (cosine + dc));
  const nextDc = Math.sqrt(1 + kappa * (dc - cosine) / (dc + cosine));
  return [0.5 * (x + y), Math.sqrt(x * y), nextDn, factor * (nextDn / grown), sinh, nextDc];
}

/**
 * Follow a circular and a hyperbolic amplitude down five Landen steps from the complementary modulus k.
 *
 * Returns the factor of the tangent of the circular amplitude and the hyperbolic sine of the other; its first step
 * takes sinh · c, c and dc · c so that none of them needs a quotient that may be 0/0.
 */
export function landen(k, dn, sinhTimesCosine, cosine, dc) {
  let factor, sinh, x, y;
  ({ 0: x, 1: y, 2: dn, 3: factor, 4: sinh, 5: dc } = _landenStep(1, k, dn, 1, sinhTimesCosine, cosine, dc));
  ({ 0: x, 1: y, 2: dn, 3: factor, 4: sinh, 5: dc } = _landenStep(x, y, dn, factor, sinh, 1, dc));
  ({ 0: x, 1: y, 2: dn, 3: factor, 4: sinh, 5: dc } = _landenStep(x, y, dn, factor, sinh, 1, dc));
  ({ 0: x, 1: y, 2: dn, 3: factor, 4: sinh, 5: dc } = _landenStep(x, y, dn, factor, sinh, 1, dc));
  ({ 0: x, 1: y, 2: dn, 3: factor, 4: sinh, 5: dc } = _landenStep(x, y, dn, factor, sinh, 1, dc));
  return [factor, sinh];
}

/** Return what the start of the full form, m ≤ ½, is the angle of, and the coefficients of A and B. */
export function fullAmplitude(body) {
  const a = body.A[0];
  const b = body.B[0];
  const c = body.C[0];
  const q = body.Q[0];
  const { 0: x, 1: y, 2: z } = body.canonical;
  const total = b * q;
  const parameter = a * body.P[0] / total;
  const complement = -c * body.S[0] / total;
  const perParameter = nomePerParameter(parameter, Math.sqrt(complement));
  const nome = perParameter * parameter;
  // √(P/Q) sinh, as the hyperbolic sine itself overflows near a stable axis
  const small = body.rootP / Math.sqrt(q);
  const ofB = Math.sqrt(b);
  const ofC = Math.sqrt(c);
  const { 0: factor, 1: scaled } = landen(Math.sqrt(complement), z * Math.sqrt(c / q), ofB, ofB, ofC);
  const grown = scaled + Math.sqrt(small * small + scaled * scaled);
  const g = small / grown;
  const r = a / b * perParameter * grown * grown;
  const g2 = g * g;
  const q2 = nome * nome;
  const r2 = r * r;
  const q3 = q2 * nome;
  const q4 = q2 * q2;
  const q8 = q4 * q4;
  const gg = g2 * g2;
  const up = -nome * g2;
  const down = -q2 * r;
  const up2 = q4 * q2 * gg;
  const down2 = q8 * r2;
  const up3 = -q3 * g2;
  const up4 = q8 * q2 * gg;
  const down4 = q4 * r2;
  return {
    rise: ofB * y * factor,
    run: ofC * x,
    series: [
      1 - (up2 + down2),
      up + down,
      2 * (up2 + down2),
      up - down,
      2 * (up2 - down2),
      g * (1 - (up4 + down4)),
      g * (up3 - r),
      2 * g * (up4 + down4),
      g * (up3 + r),
      2 * g * (up4 - down4),
    ],
  };
}

/** Return z0/4π. */
export function fullStart(rise, run) {
  return Math.atan2(rise, run) * (0.25 / Math.PI);
}

/** Return what the full form takes. */
export function fullArguments(start, series) {
  return { start: [start, 0], series, nome: [0, 0, 0, 0, 0], parity: 0 };
}

function _fullArguments(given) {
  const at = fullAmplitude(given.body);
  return fullArguments(fullStart(at.rise, at.run), at.series);
}

/** Return what the start of the complementary form, m > ½, is made from. */
export function amplitude(body, rates) {
  const b = body.B[0];
  const c = body.C[0];
  const p = body.P[0];
  const q = body.Q[0];
  const { 0: x, 1: y, 2: z } = body.canonical;
  const total = b * q;
  const k = rates.separatrix ? 1 : Math.sqrt(body.A[0] * p / total);
  const parameter = rates.separatrix ? 0 : -c * body.S[0] / total;
  const ofC = Math.sqrt(c);
  // dn, and sinh, cosine and dc of which all but the last are times one number: none needs a quotient that may be 0/0
  const dn = Math.sqrt(p / b) / rates.G[0];
  const along = Math.abs(Math.sqrt(b) * y);
  const cosine = ofC * Math.abs(x);
  const dc = ofC * z * Math.sqrt(p / q);
  // close to the unstable axis the hyperbolic sine and its square leave the range of numbers
  const huge = cosine + dc < HUGE_INVERSE * along;
  const { 0: factor, 1: sinh } = landen(k, dn, huge ? HUGE_SCALE * along : along, cosine, dc);
  return { nome: parameter * nomePerParameter(parameter, k), tangent: Math.sqrt(q / p) * factor, sinh, huge };
}

function _ofHuge(sinh) {
  const x = Math.log(2 * sinh);
  return [x, 0.5 * Math.exp(x)];
}

function _ofOrdinary(sinh) {
  const x = Math.asinh(sinh);
  return [x, Math.sinh(x)];
}

/** Return the amplitudes by elementary functions. */
export function angles(at) {
  const { 0: x, 1: sinh } = at.huge ? _ofHuge(at.sinh) : _ofOrdinary(at.sinh);
  return { x, sinh, y: Math.atan(at.tangent) };
}

/** Return start, harmonics, nome and parity of the complementary form, separatrix included. */
export function complementaryArguments(body, rates, at, angle) {
  const { 0: l1, 1: l2 } = body.canonical;
  const slope = at.huge ? angle.sinh : Math.sqrt(1 + angle.sinh * angle.sinh);
  let x = fastTwoSum(angle.x, (at.sinh - angle.sinh) / slope);
  x = at.huge ? add(x, LOG_OF_SCALE) : x;
  x = scale(x, (l2 < 0) === (l1 < 0) ? 1 : -1);
  let period = halfPeriod(rates.modulusRate, rates.mean, at.nome);
  period = rates.separatrix ? [1, 0] : period;
  const { 0: upper, 1: lower } = halves(period[0]);
  const periodic = rates.separatrix ? 0 : 1;
  return {
    start: divide(x, period),
    series: harmonics(angle.y),
    nome: [Math.sqrt(at.nome), upper, lower + period[1], periodic * angle.y * (0.5 / Math.PI), periodic],
    parity: l1 < 0 ? 1 : 0,
  };
}

function _complementaryArguments(given) {
  const at = amplitude(given.body, given.rates);
  return complementaryArguments(given.body, given.rates, at, angles(at));
}

/** Return πK/K' = 2K/θ3², of √(BQ) and the mean. */
export function halfPeriod(fast, mean, nome) {
  return byTheta(divide(multiply(fast, PI), mean), nome);
}

/** Return cos and sin of (2n+1)(y/2 − π/4), n from 0 to 4, for 0 ≤ y ≤ π/2. */
export function harmonics(y) {
  const angle = (0.5 * y - 0.25 * Math.PI) * (0.5 / Math.PI);
  const { 0: s0, 1: c0 } = sineCosine(angle);
  const { 0: s1, 1: c1 } = sineCosine(3 * angle);
  const { 0: s2, 1: c2 } = sineCosine(5 * angle - whole(5 * angle));
  const { 0: s3, 1: c3 } = sineCosine(7 * angle - whole(7 * angle));
  const { 0: s4, 1: c4 } = sineCosine(9 * angle - whole(9 * angle));
  return [c0, c1, c2, c3, c4, s0, s1, s2, s3, s4];
}

// ---------------------------------------------------------------------- matrices

/** Return the product of quaternions. */
function _turned(given, scalar, x, y, z) {
  const { 0: a, 1: b, 2: c, 3: d } = given;
  return [
    a * scalar - b * x - c * y - d * z,
    a * x + b * scalar + c * z - d * y,
    a * y - b * z + c * scalar + d * x,
    a * z + b * y - c * x + d * scalar,
  ];
}

/** Return the component along a given axis of a vector along axes of this order. */
function _onAxis(k, order, x, y, z) {
  return order[0] === k ? x : order[1] === k ? y : z;
}

function _column(given, order, scalar, x, y, z) {
  return _turned(given, scalar, _onAxis(0, order, x, y, z), _onAxis(1, order, x, y, z), _onAxis(2, order, x, y, z));
}

/** Return the signed permutation whose rows take canonical components to those along the given axes. */
export function axesOf(body) {
  const { 0: i, 1: j, 2: k } = body.order;
  const middle = body.parity;
  const outer = body.parity * body.halfTurn;
  return [
    [i === 0 ? outer : 0, j === 0 ? middle : 0, k === 0 ? outer : 0],
    [i === 1 ? outer : 0, j === 1 ? middle : 0, k === 1 ? outer : 0],
    [i === 2 ? outer : 0, j === 2 ? middle : 0, k === 2 ? outer : 0],
  ];
}

/**
 * Return by rows the matrices from spinor to attitude and from canonical direction to momentum.
 *
 * Args:
 *     body: the reduction.
 *     g: |L|.
 *     attitude: at the epoch.
 *     spinor: likewise.
 */
export function matrices(body, g, attitude, spinor) {
  let { 0: a0, 1: a1, 2: b0, 3: b1 } = spinor;
  const norm = Math.sqrt(a0 * a0 + a1 * a1 + (b0 * b0 + b1 * b1));
  a0 = a0 / norm;
  a1 = a1 / norm;
  b0 = b0 / norm;
  b1 = b1 / norm;
  // (start frame)* (present frame) is linear in the spinor (Re A, Im A, Re B, Im B); the mirror reverses its vector
  const h = body.longAxis ? -body.parity : body.parity;
  const order = body.order;
  const f = h * body.halfTurn;
  const p = _column(attitude, order, a0, -f * b1, h * b0, -f * a1);
  const q = _column(attitude, order, a1, f * b0, h * b1, f * a0);
  const r = _column(attitude, order, b0, -f * a1, -h * a0, f * b1);
  const s = _column(attitude, order, b1, f * a0, -h * a1, -f * b0);
  const size = g * body.momentumScale;
  const { 0: first, 1: second, 2: third } = axesOf(body);
  return [
    [p[0], q[0], r[0], s[0], p[1], q[1], r[1], s[1], p[2], q[2], r[2], s[2], p[3], q[3], r[3], s[3]],
    [
      size * first[0],
      size * first[1],
      size * first[2],
      size * second[0],
      size * second[1],
      size * second[2],
      size * third[0],
      size * third[1],
      size * third[2],
    ],
  ];
}

// ---------------------------------------------------------------------- the whole

/** Return whether the motion takes the full form, m ≤ ½, if it has a period. */
export function isFull(body) {
  return body.A[0] * body.P[0] <= -body.C[0] * body.S[0];
}

function _fullSpinor(m) {
  const zero = 0 * m.start[0];
  return fullSums(m, [zero, zero, zero]);
}

function _complementarySpinor(m) {
  const zero = 0 * m.start[0];
  const { 0: a, 1: b, 2: c, 3: e, 4: factor, 5: other, 6: otherFactor } = complementaryPhase(m, [zero, zero, zero]);
  return complementarySums(m, a, b, c, Math.exp(e) * factor, Math.exp(other) * otherFactor);
}

/** Return the motion of a body whose momentum moves. */
function _moving(given) {
  const body = given.body;
  const rates = given.rates;
  const full = isFull(body) && !rates.separatrix;
  const { 0: first, 1: second } = phaseRates(full, body, rates);
  const at = full ? _fullArguments(given) : _complementaryArguments(given);
  const kind = full ? 1 : 0;
  const m = {
    full: kind,
    first,
    second,
    start: at.start,
    series: at.series,
    nome: at.nome,
    parity: at.parity,
    toAttitude: SIXTEEN_ZEROS,
    toMomentum: NINE_ZEROS,
  };
  const spinor = full ? _fullSpinor(m) : _complementarySpinor(m);
  const { 0: toAttitude, 1: toMomentum } = matrices(body, rates.G[0], given.attitude, spinor);
  return {
    full: kind,
    first,
    second,
    start: at.start,
    series: at.series,
    nome: at.nome,
    parity: at.parity,
    toAttitude,
    toMomentum,
  };
}

/** Return |Ω|/4π, the rate of half the angle of a permanent rotation, in turns. */
function _permanentRate(body) {
  const { 0: i1, 1: i2, 2: i3 } = body.moments;
  const { 0: x, 1: y, 2: z } = body.momentum;
  const none = 0 * body.rootP;
  const u = divide([x, none], [i1, none]);
  const v = divide([y, none], [i2, none]);
  const w = divide([z, none], [i3, none]);
  const size = rootOrZero(add(add(square(u), square(v)), square(w)));
  const rate = scale(scale(multiply(size, INVERSE_TWO_PI), 0.5), body.rateScale);
  const { 0: high, 1: low } = halves(rate[0]);
  return [high, low, rate[1]];
}

/** Return the direction of Ω along the given axes, zero at rest. */
function _rotationAxis(moments, momentum) {
  const { 0: i1, 1: i2, 2: i3 } = moments;
  let { 0: x, 1: y, 2: z } = momentum;
  let largest = larger(larger(Math.abs(x), Math.abs(y)), Math.abs(z));
  largest = largest > 0 ? largest : 1;
  const least = smaller(smaller(i1, i2), i3);
  x = x / largest * (least / i1);
  y = y / largest * (least / i2);
  z = z / largest * (least / i3);
  let size = Math.sqrt(x * x + y * y + z * z);
  size = size > 0 ? size : 1;
  return [x / size, y / size, z / size];
}

/** Return the motion of a body at rest, of a sphere, or in permanent rotation: (A, B) turns, and L stays. */
function _permanent(given) {
  const zero = 0 * given.body.rootP;
  const one = zero + 1;
  const { 0: x, 1: y, 2: z } = _rotationAxis(given.moments, given.momentum);
  const p = _turned(given.attitude, 1, zero, zero, zero);
  const q = _turned(given.attitude, 0, x, y, z);
  const { 0: l1, 1: l2, 2: l3 } = given.momentum;
  return {
    full: one,
    first: _permanentRate(given.body),
    second: [zero, zero, zero],
    start: [zero, zero],
    series: [one, zero, zero, zero, zero, zero, zero, zero, zero, zero],
    nome: [zero, zero, zero, zero, zero],
    parity: zero,
    toAttitude: [p[0], q[0], zero, zero, p[1], q[1], zero, zero, p[2], q[2], zero, zero, p[3], q[3], zero, zero],
    toMomentum: [zero, zero, l1, zero, zero, l2, zero, zero, l3],
  };
}

/** Return the constants of motion of a body. */
export function motionOf(given) {
  return given.rates.constant ? _permanent(given) : _moving(given);
}
