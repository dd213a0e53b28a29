// Canonical form of a free body: sorted axes, short-axis mode, positive third component, and its invariants.
//
// A proper rotation sorts the axes, a mirror in which time runs backward brings long-axis mode to short-axis mode, and a
// half turn about the second axis makes L3 ≥ 0. Source: van Zon & Schofield, J. Comput. Phys. 225 (2007) 145, with the
// cancellations removed.
import * as dd from "./double_double.js";

const TINY_RATIO = 2 ** -900; // of components of L, below which numbers with it are scaled up by LIFT binary places
const LIFT = 100;
const SHARP = 1e-280; // products of double-doubles above it have all their digits

/**
 * Return a body in canonical form; A to G2 are double-double.
 *
 * With V = I1 I2 I3: A = (I2−I1)I3, B = (I3−I2)I1, C = (I3−I1)I2, P = C L1² + B L2², Q = A L2² + C L3² and
 * S = A L1² − B L3² ≤ 0 are V times the textbook quantities, the mirror applied. `moments` ascend with ½ ≤ I3 < 1,
 * `momentum` goes along them with ½ ≤ max |L_i| < 1 (times 2^LIFT if a component is tiny), `canonical` is it after mirror
 * and half turn, and given components are `axes` · canonical ones. `momentumScale` and `rateScale` were taken out.
 */
export function reduced(moments, momentum) {
  const order = [0, 1, 2].sort((i, j) => moments[i] - moments[j] || i - j);
  const [first, second, third] = order;
  const parity = (second - first) * (third - first) * (third - second) > 0 ? 1 : -1;
  const sizes = momentum.map(Math.abs);
  const size = Math.max(...sizes);
  const smallest = Math.min(...sizes.map((x) => (x === 0 ? size : x)));
  const momentExponent = dd.exponentOf(moments[third]);
  const momentumExponent = dd.exponentOf(size) - (smallest < TINY_RATIO * size ? LIFT : 0);
  const I = order.map((k) => dd.timesPowerOfTwo(moments[k], -momentExponent));
  const L = order.map((k) => parity * dd.timesPowerOfTwo(momentum[k], -momentumExponent));
  const [A, B, C, P, Q, G2] = sums(I, L);
  const exponent = dd.exponentOf(Math.max(Math.abs(L[0]), Math.abs(L[2])));
  // near the saddle L1² and L3² would lose their low words, so S is formed with both scaled up
  const lifted = [dd.timesPowerOfTwo(L[0], -exponent), L[1], dd.timesPowerOfTwo(L[2], -exponent)];
  const S = signedDistance(I, lifted, A, B);
  const longAxis = S[0] > 0;
  const minusS = longAxis ? S : dd.negate(S);
  const [l1, l3] = longAxis ? [L[2], L[0]] : [L[0], L[2]];
  const halfTurn = l3 < 0 ? -1 : 1;
  const flips = [halfTurn, 1, halfTurn];
  const places = longAxis ? [third, second, first] : order;
  const near = dd.timesPowerOfTwo(1, exponent);
  const [a, b, p] = longAxis ? [B, A, Q] : [A, B, P];
  return {
    moments: I,
    momentum: L,
    canonical: [l1 * halfTurn, L[1], l3 * halfTurn],
    A: a,
    B: b,
    C,
    P: p,
    Q: longAxis ? P : Q,
    S: dd.scale(dd.scale(minusS, -near), near),
    rootS: dd.scale(dd.sqrt(minusS), near), // accurate where S itself underflows
    rootP: rootOfSum(p[0], C[0], l1, b[0], L[1]),
    V: dd.timesFloat(dd.twoProduct(I[0], I[1]), I[2]),
    G2,
    longAxis,
    axes: [0, 1, 2].map((i) => [0, 1, 2].map((j) => (places[j] === i ? parity * flips[j] : 0))),
    momentumScale: dd.timesPowerOfTwo(1, momentumExponent),
    rateScale: dd.timesPowerOfTwo(1, momentumExponent - momentExponent),
  };
}

/** Return A, B, C, P, Q and |L|² before the mirror, each a sum of terms of one sign. */
function sums(I, L) {
  const A = dd.timesFloat(dd.twoSum(I[1], -I[0]), I[2]);
  const B = dd.timesFloat(dd.twoSum(I[2], -I[1]), I[0]);
  const C = dd.timesFloat(dd.twoSum(I[2], -I[0]), I[1]);
  const [s1, s2, s3] = L.map((x) => dd.twoProduct(x, x));
  const P = dd.add(dd.multiply(C, s1), dd.multiply(B, s2));
  const Q = dd.add(dd.multiply(A, s2), dd.multiply(C, s3));
  return [A, B, C, P, Q, dd.add(dd.add(s1, s2), s3)];
}

/**
 * Return S = A L1² − B L3², correct to its last digit however close to the separatrix.
 *
 * Near it double-double alone would leave nothing of S; there the two products are expanded exactly.
 */
function signedDistance(I, L, A, B) {
  const first = dd.multiply(A, dd.twoProduct(L[0], L[0]));
  const plain = dd.subtract(first, dd.multiply(B, dd.twoProduct(L[2], L[2])));
  if (!(Math.abs(plain[0]) < 1e-2 * first[0])) return plain;
  let gain = dd.twoSum(I[1], -I[0]);
  let loss = dd.twoSum(I[2], -I[1]);
  for (const factor of [I[2], L[0], L[0]]) gain = dd.expansionProduct(gain, factor);
  for (const factor of [-I[0], L[2], L[2]]) loss = dd.expansionProduct(loss, factor);
  return dd.distil([...gain, ...loss]);
}

/** Return √(C x² + B y²), of which the sum is given but may have lost digits, or all, to underflow. */
function rootOfSum(value, C, x, B, y) {
  if (value > SHARP) return Math.sqrt(value);
  const exponent = dd.exponentOf(Math.max(Math.abs(x), Math.abs(y)));
  const [u, v] = [x, y].map((z) => dd.timesPowerOfTwo(z, -exponent));
  return dd.timesPowerOfTwo(Math.sqrt(C * u * u + B * v * v), exponent);
}
