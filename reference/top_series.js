// The Cayley–Klein parameters of a Lagrange top as quotients of theta functions: what is prepared once.
//
// α ∝ θ1(z − iy_a)/θ4(z) and β ∝ θ2(z − iy_b)/θ4(z), each with a phase linear in time (Klein & Sommerfeld, Theorie des
// Kreisels, ch. VI). The full form (m ≤ ½) is trigonometric in z, the complementary form (m > ½) exponential.
import * as dd from "./double_double.js";
import { firstKind, nomePerParameter, theta3Excess } from "./elliptic.js";
import { splitRate } from "./phase.js";
import { climb } from "./top_rates.js";
import { startNumerators } from "./top_state.js";

const TERMS = [0, 1, 2, 3]; // of each series: q^16 is below 1e-21

/** Return all that evaluation needs; `axial` is L3 as given. */
export function preparedTop(top, points, rates, axial) {
  const at = placesInLattice(top, points, rates);
  const { permanent, separatrix, nutation } = rates;
  const { full, q, theta3 } = at;
  const [first, second] = phaseRates(top, rates).map((rate) => turnsPerTime(top, rate));
  // what stays near the vertical moves as the lifted top does, at the given size
  const down = dd.timesPowerOfTwo(1, top.leaves ? 0 : -top.lift);
  const size = top.upright ? [1, down] : [down, 1];
  const form = full ? fullSeries : complementarySeries;
  const series = permanent ? permanentSeries(top) : form(points, at, size);
  const argumentRate = permanent ? 0 : full ? nutation[0] : rates.halfRoot[0] / (theta3 * theta3);
  const linear = linearRates(rates, at);
  const bothRates = 2 * (linear[0] + linear[1]);
  const motion = {
    full,
    first: splitRate(first), // of the phase of α [turns per time]
    second: splitRate(second), // of the phase of β
    ...argumentOf(top, rates, at),
    series,
    q,
    poleTurns: [at.yAlpha, at.yBeta].map((y) => (separatrix || full ? 0 : y / Math.PI)),
    periodic: separatrix ? 0 : 1,
    signs: permanent ? [1, 1] : [rates.signAlpha, rates.signBeta],
    gain: [2 * argumentRate * top.momentumScale, bothRates * top.momentumScale], // of w
    axial,
    reversed: top.reversed,
  };
  return { ...motion, phases: constantPhases(top, startNumerators(motion), linear, argumentRate) };
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
  const theta3 = 1 + theta3Excess(q);
  const scale = 1 / (theta3 * theta3);
  const found = { full, q, theta3, yAlpha: 0, yBeta: 0, rAlpha: 0, rBeta: 0, x0: dd.ZERO };
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
    return dd.multiply(dd.sqrt(factor), size > 0 && Number.isFinite(size) ? firstKind(x, y) : dd.ONE);
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
    const saddle = dd.divide(dd.scale(halfRoot, top.rateScale), dd.from(I1));
    return { third: splitRate(saddle), start: at.x0, decay: [1, 0] };
  }
  const share = at.full ? 0.5 : 1;
  const halfPeriods = dd.divide(dd.scale(nutation, top.rateScale), dd.timesFloat(dd.PI, I1));
  const twiceK = dd.divide(dd.multiply(halfRoot, dd.PI), nutation);
  const shrink = theta3Excess(at.q);
  const correction = (shrink * (2 + shrink)) / (at.theta3 * at.theta3);
  const [high, low, rest] = splitRate(dd.add(twiceK, [-twiceK[0] * correction, 0]));
  return {
    third: splitRate(dd.scale(halfPeriods, share)),
    start: dd.scale(dd.divide(at.x0, twiceK), share),
    decay: [high, low + rest],
  };
}

/** Return the linear rates of the phases of α and β by τ, the spin that I3 ≠ I1 adds included. */
function phaseRates(top, rates) {
  const halfSpin = dd.scale(rates.spin, 0.5);
  if (!rates.permanent) return [dd.add(rates.alpha, halfSpin), dd.subtract(rates.beta, halfSpin)];
  const [I1, I3] = top.moments;
  const own = dd.divide(dd.twoProduct(0.5 * top.momentum[2], I1), dd.from(I3));
  return [own, dd.negate(own)];
}

function turnsPerTime(top, rate) {
  const inverse = dd.divide(dd.INVERSE_TWO_PI, dd.from(top.moments[0]));
  return dd.scale(dd.multiply(rate, inverse), top.rateScale);
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

/** A permanent top has one of α, β, or at rest both, as it started: A = |α| sin z and B = i|β| sin z at z = π/2. */
function permanentSeries(top) {
  const none = [0, 0, 0, 0];
  const [t, s] = [top.t0[0], top.s0[0]].map((v) => Math.sqrt(0.5 * v));
  return { aSum: [t, 0, 0, 0], aGap: none, bSum: none, bGap: [s, 0, 0, 0] };
}

/** Return sums and differences of the coefficients of e^{±ikz}, k = 1, 3, 5, 7, in A and in B, at the sizes. */
function fullSeries(points, { q, theta3, yAlpha, yBeta, rAlpha, rBeta }, [sizeA, sizeB]) {
  const theta4 = 1 - 2 * (q - q ** 4 + q ** 9);
  const ofOne = (size, y, r, alternating) => {
    const h = Math.exp(-2 * y);
    const weights = TERMS.map((n) => (n ? (q ** n * r) ** n : 1));
    const total = weights.reduceRight((sum, weight, n) => sum + weight * (1 + h ** (2 * n + 1)), 0);
    const signed = weights.map((weight, n) => (size / total) * (alternating && n % 2 ? -1 : 1) * weight);
    return [1, -1].map((sense) => signed.map((weight, n) => weight * (1 + sense * h ** (2 * n + 1))));
  };
  const [aSum, aGap] = ofOne(sizeA * Math.sqrt(0.5 * points.t2[0]) * theta3, yAlpha, rAlpha, true);
  const [bSum, bGap] = ofOne(sizeB * Math.sqrt(0.5 * points.s1[0]) * theta4, yBeta, rBeta, false);
  return { aSum, aGap, bSum, bGap };
}

/** Return A's factors of sin ky and cos ky, k = 1, 3, 5, 7, B's of cos and sin of 2, 4, 6, 8 y, and its constant. */
function complementarySeries(points, { q, theta3, yAlpha, yBeta }) {
  const theta4 = (y) => 1 - 2 * (q * Math.cos(2 * y) - q ** 4 * Math.cos(4 * y) + q ** 9 * Math.cos(6 * y));
  const ofAlpha = (Math.sqrt(0.5 * points.t2[0]) * theta3) / theta4(yAlpha);
  const ofBeta = (Math.sqrt(0.5 * points.s1[0]) * (1 + q ** 2 + q ** 6 + q ** 12)) / theta4(yBeta);
  const alpha = (wave) => TERMS.map((n) => ofAlpha * (n % 2 ? -1 : 1) * wave((2 * n + 1) * yAlpha));
  const beta = (wave) => TERMS.map((n) => ofBeta * (n % 2 ? 1 : -1) * wave((2 * n + 2) * yBeta));
  return {
    aSine: alpha(Math.sin),
    aCosine: alpha(Math.cos),
    bCosine: beta(Math.cos),
    bSine: beta(Math.sin),
    constant: ofBeta,
  };
}

/**
 * Return cos and sin of the phases that turn A and B at the epoch into the given α and β.
 *
 * Where one of them vanishes its own phase says nothing; its derivative then does, so both are used.
 */
function constantPhases(top, start, linear, argumentRate) {
  const [L1, L2, L3] = top.momentum;
  const root = dd.sqrt(top.size);
  const [w, x, y, z] = top.quaternion.map((v) => dd.divide(dd.from(v), root)[0]);
  // 2α' = i a α − w̄ β, 2β' = w α − i a β
  const given = [
    [w, z],
    [x, y],
  ];
  const slopes = [
    [0.5 * (-L3 * z - (L1 * x + L2 * y)), 0.5 * (L3 * w - (L1 * y - L2 * x))],
    [0.5 * (L1 * w - L2 * z + L3 * y), 0.5 * (L1 * z + L2 * w - L3 * x)],
  ];
  const up = dd.timesPowerOfTwo(1, top.lift);
  const [upA, upB] = top.upright ? [1, up] : [up, 1];
  const [ar, ai, dar, dai] = [0, 1, 4, 5].map((k) => upA * start[k]);
  const [br, bi, dbr, dbi] = [2, 3, 6, 7].map((k) => upB * start[k]);
  const [turnsA, turnsB] = start.slice(8);
  const square = ar * ar + ai * ai + (br * br + bi * bi);
  const norm = Math.sqrt(square);
  const drop = (ar * dar + ai * dai + (br * dbr + bi * dbi)) / square;
  const size = L1 * L1 + L2 * L2 + L3 * L3 + top.G[0] || 1;
  const series = [
    [ar, ai, dar, dai, turnsA],
    [br, bi, dbr, dbi, turnsB],
  ];
  return series.flatMap(([r0, i0, dr, di, turns], k) => {
    const [r, i, rate] = [r0 / norm, i0 / norm, linear[k]];
    const sr = argumentRate * (dr / norm - r * drop) - rate * i;
    const si = argumentRate * (di / norm - i * drop) + rate * r;
    const [[gr, gi], [er, ei]] = [given[k], slopes[k]];
    const real = r * gr + i * gi + (sr * er + si * ei) / size;
    const imaginary = r * gi - i * gr + (sr * ei - si * er) / size;
    const [c, s] = [Math.cos(2 * Math.PI * turns), Math.sin(2 * Math.PI * turns)];
    const [u, v] = [real * c + imaginary * s, imaginary * c - real * s];
    const length = Math.sqrt(u * u + v * v);
    return length > 0 ? [u / length, v / length] : [1, 0];
  });
}
