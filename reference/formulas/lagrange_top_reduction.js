// Printed from src/polhode/exact/lagrange_top/_formulas_reduction.py by `python -m printing`: change that, and print
// again.
//
// The invariants of a Lagrange top, scaled, and accurate however close to each other the regimes come.
//
// With a = L3, w = L1 + i L2, G = 2 mgl I1, τ = t/I1 and the Cayley–Klein parameters α = q0 + i q3, β = q1 + i q2, a
// top of equal moments obeys 2α' = i a α − w̄ β, 2β' = w α − i a β, w' = G ᾱ β; I3 ≠ I1 only adds the constant spin ν =
// L3 (I1 − I3)/(I1 I3) about the axis. Source: Klein & Sommerfeld, *Theorie des Kreisels*, ch. VI.
//
// A centre of mass below the pivot (mgl < 0) is one above it on the reversed axis: a half turn about the first body
// axis.
//
// A top displaced from the vertical by a tiny ε has s or t, c or c', F and |w|² of the order of ε², and squares of
// these underflow. There the motion is linear in the displacement, so the invariants are formed with the displacement
// scaled up by a power of two. `formulasRates` and `formulasSetup` undo this: the scaled top's state is scaled down if
// it stays near the vertical, and the time it takes to leave grows by the logarithm of the scale if it does not.

import { compress, distil, join, multiplyTerms, negated } from "../exact_sums.js";
import { binaryExponent, larger, smaller, timesPower } from "../words.js";
import { divide, scale, twoProduct } from "./arithmetic.js";

export const TINY = -200; // binary exponents: of a displacement that is scaled up, and of what it becomes
export const LIFTED = -150;
export const ONE = [1, 0];
export const ZERO = [0, 0];

/**
 * A top with mgl ≥ 0 and without powers of two.
 *
 * @typedef {object} Scaled
 * @property {number[]} moments I1, I3
 * @property {number[]} momentum
 * @property {number[]} quaternion
 * @property {boolean} reversed whether the axis was reversed
 * @property {number} lift binary exponent of the displacement's scale, 0 for most tops
 * @property {number} exponent binary, taken out of the momentum
 * @property {number} momentumScale powers of two taken out
 * @property {number} rateScale
 * @property {number[]} G
 */

/**
 * A top with mgl ≥ 0, scaled by powers of two; pairs are double-double.
 *
 * u = cos θ, s = 1 − u, t = 1 + u, index 0 at the epoch; dots are derivatives by τ.
 *
 * @typedef {object} Reduction
 * @property {number[]} moments I1, I3
 * @property {number[]} momentum with the displacement scaled up by 2^lift
 * @property {number[]} quaternion not normalised; likewise
 * @property {boolean} reversed whether the axis was reversed
 * @property {number} lift binary exponent of the displacement's scale, 0 for most tops
 * @property {number} momentumScale powers of two taken out
 * @property {number} rateScale
 * @property {number[]} size |q|² as given
 * @property {number[]} G
 * @property {number[]} s0
 * @property {number[]} t0
 * @property {number[]} u0
 * @property {number[]} p u̇ at the epoch
 * @property {number[]} c p_φ − L3
 * @property {number[]} cPlus p_φ + L3
 * @property {number[]} twist p_φ − u L3 at the epoch
 * @property {number[]} F |w|² − G s − a c
 * @property {number[]} D 2G − a² − |w|² + G s
 * @property {number[]} w2 |w|² at the epoch
 * @property {number[]} lean a (|w|² − G s) − G c: its sign against a's tells loops from waves
 */

/** Return whether the axis points up rather than down at the epoch. */
export function isUpright(top) {
  return top.s0[0] < top.t0[0];
}

/** Return whether the displacement was scaled up and grows. */
export function leaves(top) {
  return top.lift > 0 && isUpright(top) && top.D[0] > 0;
}

// ---------------------------------------------------------------------- axis and size

function _largest(x, y) {
  return larger(Math.abs(x), Math.abs(y));
}

/** Turn a top whose centre of mass lies below, and take out powers of two. */
export function scaled(moments, mgl, momentum, attitude) {
  const turned = mgl < 0;
  const side = turned ? -1 : 1;
  let weight = Math.abs(mgl);
  const { 0: w, 1: x, 2: y, 3: z } = attitude;
  let { 0: i1, 2: i3 } = moments;
  const { 0: l1, 1: l2, 2: l3 } = momentum;
  const largest = larger(_largest(l1, l2), Math.abs(l3));
  const ofMoment = binaryExponent(i1);
  const ofMomentum = binaryExponent(largest);
  // the larger of |L| and √(mgl I1), without forming a product that may overflow
  const half = Math.floor(0.5 * (ofMoment + binaryExponent(weight) + 1));
  const ofBoth = largest > 0 ? larger(ofMomentum, half) : half;
  const exponent = weight > 0 ? ofBoth : ofMomentum;
  i1 = timesPower(i1, -ofMoment);
  weight = timesPower(timesPower(weight, ofMoment - exponent), -exponent);
  // a half turn about the first body axis: q → q i
  return {
    moments: [i1, timesPower(i3, -ofMoment)],
    momentum: [timesPower(l1, -exponent), timesPower(side * l2, -exponent), timesPower(side * l3, -exponent)],
    quaternion: [turned ? -x : w, turned ? w : x, turned ? z : y, turned ? -y : z],
    reversed: turned,
    lift: 0 * weight,
    exponent,
    momentumScale: timesPower(1, exponent),
    rateScale: timesPower(1, exponent - ofMoment),
    G: scale(twoProduct(weight, i1), 2),
  };
}

/**
 * Scale a tiny displacement up; the momentum is the given one, which keeps digits that scaling down has lost.
 *
 * Exactly at the threshold of sleeping, 2G = a², where it grows like t and not like e^t, it is dropped: nothing is to
 * show within 1e27 radians, the longest time for which a motion is given.
 */
export function lifted(top, momentum) {
  const { 0: w, 1: x, 2: y, 3: z } = top.quaternion;
  const { 0: l1, 1: l2, 2: l3 } = top.momentum;
  const cosine = _largest(w, z);
  const sine = _largest(x, y);
  const below = cosine < sine;
  const displacement = larger(smaller(cosine, sine), _largest(l1, l2));
  const exponent = binaryExponent(displacement);
  const double = scale(top.G, 2);
  const square = twoProduct(l3, l3);
  const threshold = double[0] === square[0] && double[1] === square[1] && !below;
  const tiny = displacement > 0 && exponent < TINY && top.G[0] > 0;
  const lift = tiny && !threshold ? LIFTED - exponent : 0;
  const kept = tiny && threshold ? 0 : 1;
  const above = below ? 0 : lift;
  const under = below ? lift : 0;
  const side = top.reversed ? -1 : 1;
  const power = lift - top.exponent;
  return {
    moments: top.moments,
    momentum: [kept * timesPower(momentum[0], power), kept * timesPower(side * momentum[1], power), l3],
    quaternion: [timesPower(w, under), kept * timesPower(x, above), kept * timesPower(y, above), timesPower(z, under)],
    reversed: top.reversed,
    lift,
    exponent: top.exponent,
    momentumScale: top.momentumScale,
    rateScale: top.rateScale,
    G: top.G,
  };
}

/** Return the reduction of invariants times |q|²; s and t are half of them, and `inPhase` is −p/2. */
function _overSize(top, size, s, t, u, inPhase, c, cPlus, twist, f, d, w2, lean) {
  return {
    moments: top.moments,
    momentum: top.momentum,
    quaternion: top.quaternion,
    reversed: top.reversed,
    lift: top.lift,
    momentumScale: top.momentumScale,
    rateScale: top.rateScale,
    size,
    G: top.G,
    s0: scale(divide(s, size), 2),
    t0: scale(divide(t, size), 2),
    u0: divide(u, size),
    p: scale(divide(inPhase, size), -2),
    c: divide(c, size),
    cPlus: divide(cPlus, size),
    twist: divide(twist, size),
    F: divide(f, size),
    D: divide(d, size),
    w2,
    lean: divide(lean, size),
  };
}

// ---------------------------------------------------------------------- invariants, as exact sums

/** Return ab + cd. */
function _products(a, b, c, d) {
  return join(twoProduct(a, b), twoProduct(c, d));
}

function _timesPair(x, y) {
  return join(multiplyTerms(x, y[0]), multiplyTerms(x, y[1]));
}

/** Return |q|²: as a pair it would leave F of a planar top only 32 digits of what cancels. */
export function sizeOf(top) {
  const { 0: w, 1: x, 2: y, 3: z } = top.quaternion;
  return compress(join(_products(x, x, y, y), _products(w, w, z, z)), 4);
}

/**
 * Return the reduction of a top; its invariants are polynomials of the given floats over |q|², which is `size`.
 *
 * The polynomials are summed exactly, since near the separatrix c, F and D vanish together and what is left of them
 * decides how long the top lingers upright; double-double alone would leave nothing.
 */
export function exactlyReduced(top, size) {
  const { 0: l1, 1: l2, 2: l3 } = top.momentum;
  const { 0: w, 1: x, 2: y, 3: z } = top.quaternion;
  const s = _products(x, x, y, y);
  const t = _products(w, w, z, z);
  const real = _products(x, w, y, z); // of β̄α
  const imaginary = _products(x, z, -y, w);
  const inPhase = compress(join(multiplyTerms(real, l1), multiplyTerms(imaginary, -l2)), 4); // of β̄αw
  const twist = compress(join(multiplyTerms(real, 2 * l2), multiplyTerms(imaginary, 2 * l1)), 4);
  const c = compress(join(twist, multiplyTerms(s, -2 * l3)), 4);
  const cPlus = compress(join(twist, multiplyTerms(t, 2 * l3)), 4);
  const kinetic = join(_timesPair(size, twoProduct(l1, l1)), _timesPair(size, twoProduct(l2, l2)));
  let fall = scale(top.G, -2);
  fall = join(_timesPair(fall, twoProduct(x, x)), _timesPair(fall, twoProduct(y, y)));
  const energy = compress(join(kinetic, fall), 5);
  const f = compress(join(energy, multiplyTerms(c, -l3)), 5);
  const rest = join(_timesPair(size, scale(top.G, 2)), _timesPair(size, twoProduct(l3, -l3)));
  const d = compress(join(rest, negated(energy)), 5);
  const lean = compress(join(multiplyTerms(energy, l3), _timesPair(c, scale(top.G, -1))), 6);
  return _overSize(
    top,
    distil(size),
    distil(s),
    distil(t),
    distil(join(t, negated(s))),
    distil(inPhase),
    distil(c),
    distil(cPlus),
    distil(twist),
    distil(f),
    distil(d),
    distil(_products(l1, l1, l2, l2)),
    distil(lean),
  );
}

/** Return the reduction of a top, at any scale and however near the vertical. */
export function reduction(moments, mgl, momentum, attitude) {
  const top = scaled(moments, mgl, momentum, attitude);
  return exactlyReduced(lifted(top, momentum), sizeOf(top));
}
