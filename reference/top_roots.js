// The turning points of a Lagrange top: the roots u1 ≤ u2 ≤ 1 ≤ u3 of u̇² = (α − βu)(1 − u²) − (b − au)².
//
// One root stands apart from the other two. It is found by Newton's method in double-double, in a variable in which it is
// large; the others follow from it, formulas/lagrange_top_roots.js.
import * as dd from "./formulas/arithmetic.js";
import { cubics, ONE, turningPointsOf } from "./formulas/lagrange_top_roots.js";

const NEWTON_STEPS = 5; // from the float64 root; three do, two more where float64 was poor

/** Return the turning points of a reduced top. */
export function turningPoints(top) {
  const { G, s0, t0, u0, w2, twist, D, F, cPlus } = top;
  const weightless = !(G[0] > 0);
  const safe = weightless ? ONE : G;
  const [p2, c2] = [dd.square(top.p), dd.square(top.c)];
  const [f1, ofY, ofS] = cubics(top.momentum[2], G, dd.divide(ONE, safe), s0, t0, u0, w2, twist, p2, c2, D, F);
  const { root, cosine } = largestRoot(ofY);
  const isUpper = cosine >= 0 || weightless;
  const lone = isUpper ? polished(root, ofY) : polished(largestRoot(ofS).root, ofS);
  return turningPointsOf(isUpper, lone, G, safe, s0, t0, p2, c2, cPlus, F, f1);
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
