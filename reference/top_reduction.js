// The invariants of a Lagrange top, scaled, and accurate however close to each other the regimes come.
//
// With a = L3, w = L1 + i L2, G = 2 mgl I1, τ = t/I1 and the Cayley–Klein parameters α = q0 + i q3, β = q1 + i q2, a top of
// equal moments obeys 2α' = i a α − w̄ β, 2β' = w α − i a β, w' = G ᾱ β; I3 ≠ I1 only adds the constant spin
// ν = L3 (I1 − I3)/(I1 I3) about the axis. Source: Klein & Sommerfeld, Theorie des Kreisels, ch. VI.
import { compress, distil, expansionTimesExpansion } from "./expansions.js";
import * as dd from "./formulas/arithmetic.js";
import { binaryExponent, timesPower } from "./words.js";

const [TINY, LIFTED] = [-200, -150]; // binary exponents: of a displacement that is scaled up, and of what it becomes

/**
 * Return a top with mgl ≥ 0, scaled by powers of two: a `Reduction` of formulas/lagrange_top_roots.js.
 *
 * A centre of mass below the pivot is one above it on the reversed axis: a half turn about the first body axis.
 *
 * A top displaced from the vertical by a tiny ε has s or t, c or c', F and |w|² of the order of ε², and squares of these
 * underflow. There the motion is linear in the displacement, so the invariants, `momentum` and `quaternion` have the
 * displacement scaled up by 2^lift. Rates and series undo this: the scaled top's state is scaled down if it stays near the
 * vertical, and the time it takes to leave grows by the logarithm of the scale if it does not.
 */
export function reducedTop(moments, mgl, momentum, attitude) {
  const reversed = mgl < 0;
  const quaternion = reversed ? [-attitude[1], attitude[0], attitude[3], -attitude[2]] : [...attitude];
  const [w, x, y, z] = quaternion;
  const sign = reversed ? -1 : 1;
  const momentExponent = binaryExponent(moments[0]);
  const momentumExponent = exponentOfMomentum(moments[0], Math.abs(mgl), momentum);
  const [I1, I3] = [moments[0], moments[2]].map((v) => timesPower(v, -momentExponent));
  const given = [momentum[0], sign * momentum[1], sign * momentum[2]];
  const L = given.map((v) => timesPower(v, -momentumExponent));
  const weight = timesPower(timesPower(Math.abs(mgl), momentExponent - momentumExponent), -momentumExponent);
  const G = dd.scale(dd.twoProduct(weight, I1), 2);
  const size = compress([...sumOfSquares(x, y), ...sumOfSquares(w, z)]);
  const { below, lift, kept } = liftOf(G, L, quaternion);
  const raised = [0, 1].map((k) => kept * timesPower(given[k], lift - momentumExponent));
  const liftedMomentum = [...raised, L[2]];
  const [above, under] = below ? [0, lift] : [lift, 0];
  const [p, q] = [x, y].map((v) => kept * timesPower(v, above));
  const liftedQuaternion = [timesPower(w, under), p, q, timesPower(z, under)];
  return {
    moments: [I1, I3],
    momentum: liftedMomentum,
    quaternion: liftedQuaternion,
    reversed,
    lift,
    momentumScale: timesPower(1, momentumExponent),
    rateScale: timesPower(1, momentumExponent - momentExponent),
    ...invariants(G, size, liftedMomentum, liftedQuaternion),
  };
}

const sumOfSquares = (x, y) => compress([...dd.twoProduct(x, x), ...dd.twoProduct(y, y)]);

/**
 * Return whether the axis points down, the exponent by which a tiny displacement is scaled up, and 0 to drop it, or 1.
 *
 * It is dropped exactly at the threshold of sleeping, 2G = a², where it grows like t and not like e^t: nothing is to be
 * seen of it within 1e27 radians, the longest time that a motion is asked for.
 */
function liftOf(G, [L1, L2, L3], [w, x, y, z]) {
  const largest = (u, v) => Math.max(Math.abs(u), Math.abs(v));
  const [cosine, sine] = [largest(w, z), largest(x, y)];
  const below = cosine < sine;
  const displacement = Math.max(Math.min(cosine, sine), largest(L1, L2));
  const exponent = binaryExponent(displacement);
  const [double, square] = [dd.scale(G, 2), dd.twoProduct(L3, L3)];
  const threshold = !below && double[0] === square[0] && double[1] === square[1];
  const tiny = displacement > 0 && exponent < TINY && G[0] > 0;
  return { below, lift: tiny && !threshold ? LIFTED - exponent : 0, kept: tiny && threshold ? 0 : 1 };
}

/** Return the exponent of the larger of |L| and √(mgl I1), without forming a product that may overflow. */
function exponentOfMomentum(I1, weight, momentum) {
  const largest = Math.max(...momentum.map(Math.abs));
  const exponent = binaryExponent(largest);
  if (!(weight > 0)) return exponent;
  const half = Math.floor((binaryExponent(I1) + binaryExponent(weight) + 1) / 2);
  return largest > 0 ? Math.max(exponent, half) : half;
}

/**
 * Return the invariants: polynomials of the given floats over |q|².
 *
 * They are summed as expansions, since near the separatrix c, F and D vanish together and what is left of them decides how
 * long the top lingers upright; double-double alone would leave nothing.
 */
function invariants(G, size, [L1, L2, L3], [w, x, y, z]) {
  const of = dd.twoProduct;
  const product = expansionTimesExpansion;
  const short = compress;
  const negated = (terms) => terms.map((v) => -v);
  const S = sumOfSquares(x, y);
  const T = sumOfSquares(w, z);
  const real = short([...of(x, w), ...of(y, z)]); // β̄α
  const imaginary = short([...of(x, z), ...of(-y, w)]);
  const inPhase = short([...product(real, [L1]), ...product(imaginary, [-L2])]); // β̄αw
  const twist = short([...product(real, [L2]), ...product(imaginary, [L1])].map((v) => 2 * v));
  const c = short([...twist, ...product(S, [-2 * L3])]);
  const cPlus = short([...twist, ...product(T, [2 * L3])]);
  const w2 = [...of(L1, L1), ...of(L2, L2)];
  const energy = short([...product(size, w2), ...product(G.map((g) => -2 * g), S)], 5);
  const F = short([...energy, ...product(c, [-L3])], 5);
  const rest = [...G.map((g) => 2 * g), ...of(L3, -L3)];
  const D = short([...product(size, rest), ...negated(energy)], 5);
  const lean = short([...product(energy, [L3]), ...product(negated(G), c)], 6);
  const n = distil(size);
  const over = (terms) => dd.divide(distil(terms), n);
  return {
    size: n, // |q|²
    G,
    s0: dd.scale(over(S), 2),
    t0: dd.scale(over(T), 2),
    u0: over([...T, ...negated(S)]),
    p: dd.scale(over(inPhase), -2),
    c: over(c),
    cPlus: over(cPlus),
    twist: over(twist),
    F: over(F),
    D: over(D),
    w2: distil(w2),
    lean: over(lean),
  };
}
