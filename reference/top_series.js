// The Cayley–Klein parameters of a Lagrange top as quotients of theta functions: what is prepared once.
//
// α ∝ θ1(z − iy_a)/θ4(z) and β ∝ θ2(z − iy_b)/θ4(z), each with a phase linear in time (Klein & Sommerfeld, Theorie des
// Kreisels, ch. VI). The full form (m ≤ ½) is trigonometric in z, the complementary form (m > ½) exponential.
import { firstKind } from "./elliptic.js";
import * as dd from "./formulas/arithmetic.js";
import { nomePerParameter } from "./formulas/common.js";
import { complementaryPhase, complementarySums, fullSums } from "./formulas/lagrange_top.js";
import * as setup from "./formulas/lagrange_top_setup.js";
import { climb } from "./top_rates.js";
import { timesPower } from "./words.js";

const NOTHING = [0, 0, 0, 0];

/** Return all that evaluation needs, a `Motion` of formulas/lagrange_top.js; `axial` is L3 as given. */
export function preparedTop(top, points, rates, axial) {
  const at = placesInLattice(top, points, rates);
  const { permanent, separatrix, nutation } = rates;
  const { full, q, theta3 } = at;
  const [first, second] = phaseRates(top, rates).map((rate) => setup.turnsPerTime(rate, top.moments[0], top.rateScale));
  const argumentRate = permanent ? 0 : full ? nutation[0] : rates.halfRoot[0] / (theta3 * theta3);
  const linear = linearRates(rates, at);
  const { third, start, decay } = argumentOf(top, rates, at);
  const motion = {
    full: full ? 1 : 0,
    first: inHalves(first),
    second: inHalves(second),
    third,
    start,
    ...seriesOf(top, points, rates, at),
    nome: [q, ...decay, ...[at.yAlpha, at.yBeta].map((y) => (separatrix || full ? 0 : y / Math.PI)), separatrix ? 0 : 1],
    signs: permanent ? [1, 1] : [rates.signAlpha, rates.signBeta],
    rates: [2 * argumentRate * top.momentumScale, 2 * (linear[0] + linear[1]) * top.momentumScale],
    phases: [1, 0, 1, 0],
    axial,
    reversed: top.reversed,
  };
  return { ...motion, phases: constantPhases(top, sumsAtStart(motion), linear, argumentRate) };
}

/** Return a double-double rate in halves and what these leave of it. */
const inHalves = ([high, low]) => [...dd.halves(high), low];

/** Return A, B, their derivatives and phases at the epoch. */
function sumsAtStart(motion) {
  if (motion.full) return fullSums(motion, [0, 0, 0]);
  const [a, b, c, exponent, factor, other, otherFactor] = complementaryPhase(motion, [0, 0, 0]);
  return complementarySums(motion, a, b, c, Math.exp(exponent) * factor, Math.exp(other) * otherFactor);
}

/** Return the modulus and the places of start and poles: nome of the smaller parameter, y times π/2K of it, x0. */
function placesInLattice(top, points, rates) {
  const { separatrix, permanent, steady } = rates;
  const [G, d, A, B] = [top.G[0], points.d[0], points.A[0], points.B[0]];
  const m = (G * d) / A;
  const m1 = separatrix ? 0 : B / A;
  const full = permanent || (m <= m1 && !separatrix);
  const small = permanent ? 0 : full ? m : m1;
  const q = small * nomePerParameter(small, Math.sqrt(1 - small));
  const theta3 = 1 + 2 * (q + q ** 4 + q ** 9);
  const scale = 1 / (theta3 * theta3);
  const found = { full, q, theta3, yAlpha: 0, yBeta: 0, rAlpha: 0, rBeta: 0, x0: setup.ZERO };
  if (permanent) return found;
  // where the tilt stays the pole is infinitely far: only e^−y = 0 enters
  if (steady) return { ...found, yAlpha: Infinity, yBeta: Infinity };
  const integral = integralsOf(top, points);
  const alpha = separatrix ? Math.atan2(Math.sqrt(points.t1[0]), Math.sqrt(d)) : integral.alpha();
  const beta = separatrix || points.s2[0] === 0 ? 0 : integral.beta();
  const tail = (distance) => (full && q > 0 ? Math.exp(-2 * scale * distance()) : 0);
  return {
    ...found,
    yAlpha: alpha * scale,
    yBeta: beta * scale,
    rAlpha: tail(integral.beyondAlpha), // q e^2y, accurate where y is far out
    rBeta: tail(integral.beyondBeta),
    x0: dd.scale(dd.add(integral.start(), climb(top)), top.p[0] >= 0 ? 1 : -1),
  };
}

/** Return the distances v of α's and β's poles from the real axis, K' − v, and x0, each as a function. */
function integralsOf(top, points) {
  const { G } = top;
  const { A, B, d, s1, s2, t1, t2, Y, zMinus, zPlus, fromLower, fromUpper } = points;
  const over = dd.divide;
  const of = (factor, x, y) => {
    const size = x[0] + y[0];
    return dd.multiply(dd.rootOrZero(factor), size > 0 && Number.isFinite(size) ? firstKind(x, y) : setup.ONE);
  };
  return {
    alpha: () => of(over(t1, t2), over(d, t2), over(dd.multiply(d, zPlus), dd.multiply(A, t2)))[0],
    beta: () => {
      const s1B = dd.multiply(s1, B);
      return of(over(dd.multiply(s2, A), s1B), over(dd.multiply(d, zMinus), s1B), over(d, s1))[0];
    },
    beyondAlpha: () => of(over(A, zPlus), over(dd.multiply(G, t1), zPlus), over(dd.multiply(G, t2), zPlus))[0],
    beyondBeta: () => of(over(zMinus, B), over(dd.multiply(G, s2), B), over(dd.multiply(G, s1), A))[0],
    start: () => of(over(fromLower, d), over(fromUpper, d), over(Y, A)),
  };
}

/** Return rate and start of z/2π (full) or x/2K, and πK/K' in halves. */
function argumentOf(top, rates, at) {
  const { permanent, separatrix, halfRoot, nutation } = rates;
  if (permanent) return { third: [0, 0, 0], start: [0.25, 0], decay: [1, 0] };
  const I1 = top.moments[0];
  if (separatrix) {
    const saddle = dd.divide(dd.scale(halfRoot, top.rateScale), [I1, 0]);
    return { third: inHalves(saddle), start: at.x0, decay: [1, 0] };
  }
  const share = at.full ? 0.5 : 1;
  const [quarter, period] = setup.periods(halfRoot, nutation, at.q);
  const [high, low, rest] = inHalves(period);
  return {
    third: inHalves(dd.scale(setup.halfPeriods(nutation, I1, top.rateScale), share)),
    start: dd.scale(dd.divide(at.x0, quarter), 0.5 * share),
    decay: [high, low + rest],
  };
}

/** Return the linear rates of the phases of α and β by τ, the spin that I3 ≠ I1 adds included. */
function phaseRates(top, rates) {
  const halfSpin = dd.scale(rates.spin, 0.5);
  if (!rates.permanent) return [dd.add(rates.alpha, halfSpin), dd.subtract(rates.beta, halfSpin)];
  const [I1, I3] = top.moments;
  const own = dd.divide(dd.twoProduct(0.5 * top.momentum[2], I1), [I3, 0]);
  return [own, dd.scale(own, -1)];
}

/** Return the derivatives by τ of the phases of α and β that evaluation adds to A and B, spin aside. */
function linearRates(rates, at) {
  if (rates.permanent) return [0, 0];
  const still = at.full || rates.separatrix;
  const carried = (sign, y) => (still ? 0 : sign * y * rates.nutation[0] * (2 / Math.PI));
  return [
    rates.alpha[0] + carried(rates.signAlpha, at.yAlpha),
    rates.beta[0] + carried(rates.signBeta, at.yBeta),
  ];
}

/** Return the coefficients of A and B. */
function seriesOf(top, points, rates, { full, q, theta3, yAlpha, yBeta, rAlpha, rBeta }) {
  // what stays near the vertical moves as the lifted top does, at the given size
  const down = timesPower(1, top.leaves ? 0 : -top.lift);
  const [sizeA, sizeB] = top.upright ? [1, down] : [down, 1];
  const [t, s] = rates.permanent ? [top.t0, top.s0] : [points.t2, points.s1];
  const [rootT, rootS] = [Math.sqrt(0.5 * t[0]) * sizeA, Math.sqrt(0.5 * s[0]) * sizeB];
  if (rates.permanent) {
    // it has one of α, β, or at rest both, as it started: A = |α| sin z and B = i|β| sin z at z = π/2
    return { aSum: [rootT, 0, 0, 0], aGap: NOTHING, bSum: NOTHING, bGap: [rootS, 0, 0, 0], constant: 0 };
  }
  if (full) {
    const [ofAlpha, ofBeta] = setup.fullSizes(rootT, rootS, q, theta3);
    const [aSum, aGap] = setup.fullTerms(ofAlpha, Math.exp(-2 * yAlpha), q, rAlpha, -1);
    const [bSum, bGap] = setup.fullTerms(ofBeta, Math.exp(-2 * yBeta), q, rBeta, 1);
    return { aSum, aGap, bSum, bGap, constant: 0 };
  }
  const [aSum, aGap, bSum, bGap, constant] = setup.complementarySeries(rootT, rootS, q, theta3, yAlpha, yBeta);
  return { aSum, aGap, bSum, bGap, constant };
}

/** Return cos and sin of the phases that turn A and B at the epoch into the given α and β. */
function constantPhases(top, sums, linear, argumentRate) {
  const up = timesPower(1, top.lift);
  const [upA, upB] = top.upright ? [1, up] : [up, 1];
  const [ar, ai, br, bi, dar, dai, dbr, dbi, turnsA, turnsB] = sums;
  const lifted = [upA * ar, upA * ai, upB * br, upB * bi, upA * dar, upA * dai, upB * dbr, upB * dbi, turnsA, turnsB];
  const [x, y, z] = top.momentum;
  const size = x * x + y * y + z * z + top.G[0] || 1;
  return setup.constantPhases(top.quaternion, top.size, top.momentum, size, lifted, linear, argumentRate);
}
