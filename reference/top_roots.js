// The turning points of a Lagrange top: the roots u1 ≤ u2 ≤ 1 ≤ u3 of u̇² = (α − βu)(1 − u²) − (b − au)².
//
// One root stands apart from the other two. It is found by Newton's method in double-double, in a variable in which it is
// large; the others follow from sums and products of roots without cancellation, whatever coincides. Source: Whittaker,
// Analytical Dynamics, §71–73, for the cubic.
import * as dd from "./formulas/arithmetic.js";
import { binaryExponent, timesPower } from "./words.js";

const SQUARABLE = -400; // binary exponent down to which a square has all its digits
const NEWTON_STEPS = 5; // from the float64 root; three do, two more where float64 was poor

/**
 * Return the turning points of a reduced top, each distance a number of its own in double-double.
 *
 * fromLower = u0 − u1, fromUpper = u2 − u0, d = u2 − u1, s = 1 − u, t = 1 + u, A = G(u3 − u1), B = G(u3 − u2),
 * Y = G(u3 − u0), zMinus = G(u3 − 1), zPlus = G(u3 + 1).
 */
export function turningPoints(top) {
  const { G } = top;
  const p2 = dd.square(top.p);
  const c2 = dd.square(top.c);
  const a = [top.momentum[2], 0];
  let f1 = dd.subtract(dd.scale(dd.multiply(a, top.twist), 2), dd.multiply(G, dd.multiply(top.s0, top.t0)));
  f1 = dd.subtract(f1, dd.scale(dd.multiply(top.u0, top.w2), 2));
  const f2 = dd.subtract(dd.subtract(dd.scale(dd.multiply(G, top.u0), 2), top.w2), dd.square(a));
  const ofY = [f2, dd.multiply(G, f1), dd.multiply(dd.square(G), p2)];
  const { root, cosine } = largestRoot(ofY);
  let points;
  if (cosine >= 0 || !(G[0] > 0)) {
    points = upperRootApart(top, p2, c2, f1, polished(root, ofY));
  } else {
    const ofS = [dd.scale(dd.divide(top.D, G), -1), dd.scale(dd.divide(top.F, G), -2), dd.divide(c2, G)];
    points = lowerRootApart(top, p2, c2, polished(largestRoot(ofS).root, ofS));
  }
  const t2 = dd.add(top.t0, points.fromUpper);
  const zPlus = dd.add(points.Y, dd.multiply(G, top.t0));
  return { ...points, t2, zPlus, t1: quotient(dd.square(top.cPlus), dd.multiply(t2, zPlus)) };
}

/** Return the largest root of x³ + bx² + cx + d, whose roots are real, and cos 3φ of Viète's formula, in floats. */
function largestRoot([[b], [c], [d]]) {
  const P = c - (b * b) / 3;
  const Q = (2 * b ** 3) / 27 - (b * c) / 3 + d;
  const r = Math.sqrt(Math.max(-P / 3, 0));
  const cosine = r > 0 ? Math.min(Math.max((-0.5 * Q) / r ** 3, -1), 1) : 1;
  return { root: 2 * r * Math.cos(Math.acos(cosine) / 3) - b / 3, cosine };
}

function polished(start, [b, c, d]) {
  let x = [start, 0];
  for (let step = 0; step < NEWTON_STEPS; step++) {
    const value = dd.add(dd.multiply(dd.add(dd.multiply(dd.add(x, b), x), c), x), d);
    const slope = dd.add(dd.multiply(dd.add(dd.add(dd.scale(x, 2), x), dd.scale(b, 2)), x), c);
    const change = dd.divide(value, slope);
    if (Number.isFinite(change[0])) x = dd.subtract(x, change);
  }
  return x;
}

/** Return x / y, and zero for x = 0 whatever y. */
const quotient = (x, y) => (x[0] === 0 ? x : dd.divide(x, y));

/** Return x + y = √((x − y)² + 4xy), also where the square underflows. */
function difference(sum, product) {
  const exponent = binaryExponent(sum[0]);
  const alone = product[0] === 0 || binaryExponent(product[0]) < 2 * exponent;
  const small = sum[0] !== 0 && exponent < SQUARABLE && alone ? -exponent : 0;
  const up = timesPower(1, small);
  const raised = dd.scale(dd.scale(product, up), up);
  const root = dd.rootOrZero(dd.add(dd.square(dd.scale(sum, up)), dd.scale(raised, 4)));
  return dd.scale(root, timesPower(1, -small));
}

/** Return x ≥ 0 and y ≥ 0 from x − y, x + y and x y. */
function largerAndSmaller(sum, difference, product) {
  const positive = sum[0] >= 0;
  const larger = dd.scale(dd.add(difference, positive ? sum : dd.scale(sum, -1)), 0.5);
  const smaller = larger[0] > 0 ? quotient(product, larger) : [0, 0];
  return positive ? [larger, smaller] : [smaller, larger];
}

/** From Y = G(u3 − u0): with v = u − u0, v1 + v2 = (f1 + Gp²/Y)/Y and v1 v2 = −p²/Y. */
function upperRootApart(top, p2, c2, f1, Y) {
  const { G } = top;
  const product = quotient(p2, Y);
  const sum = quotient(dd.add(f1, dd.multiply(G, product)), Y);
  const d = difference(sum, product);
  const [fromUpper, fromLower] = largerAndSmaller(sum, d, product);
  const s1 = dd.add(top.s0, fromLower);
  let s2 = dd.subtract(top.s0, fromUpper);
  let zMinus = dd.subtract(Y, dd.multiply(G, top.s0));
  // s1 s2 Z = c²; of s2 and Z only the larger is an accurate difference
  if (zMinus[0] >= dd.multiply(G, s2)[0]) s2 = quotient(c2, dd.multiply(s1, zMinus));
  else zMinus = quotient(c2, dd.multiply(s1, s2));
  const A = dd.add(Y, dd.multiply(G, fromLower));
  const B = dd.subtract(Y, dd.multiply(G, fromUpper));
  return { fromLower, fromUpper, d, s1, s2, A, B, Y, zMinus };
}

/** From s1 = 1 − u1: s2 + s3 = (c²/s1 − 2F)/(G s1) and s2 s3 = −c²/(G s1). */
function lowerRootApart(top, p2, c2, s1) {
  const { G } = top;
  const Gs1 = dd.multiply(G, s1);
  const product = quotient(c2, Gs1);
  const sum = dd.divide(dd.add(dd.scale(top.F, -2), quotient(c2, s1)), Gs1);
  const gap = difference(sum, product);
  const [s2, minusS3] = largerAndSmaller(sum, gap, product);
  const zMinus = dd.multiply(G, minusS3);
  const Y = dd.add(dd.multiply(G, top.s0), zMinus);
  const other = quotient(p2, Y);
  let fromUpper = dd.subtract(top.s0, s2);
  let fromLower = dd.subtract(s1, top.s0);
  if (fromUpper[0] >= fromLower[0]) fromLower = quotient(other, fromUpper);
  else fromUpper = quotient(other, fromLower);
  const A = dd.multiply(G, dd.add(s1, minusS3));
  return { fromLower, fromUpper, d: dd.subtract(s1, s2), s1, s2, A, B: dd.multiply(G, gap), Y, zMinus };
}
