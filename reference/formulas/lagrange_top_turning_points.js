// Printed from reference/printing/single_top.py by `python -m printing`: change that, and print again.
//
// Turning points of a single top: formulas for printing, where arrays and kernels each have ways of their own.
//
// The separate root is computed by Newton's method in double-double, in a variable in which it is large. Source:
// Viète's formula for its start.

import { larger, smaller } from "../words.js";
import { add, divide, multiply, scale, square, subtract } from "./arithmetic.js";
import { cubics, ONE, turningPointsOf } from "./lagrange_top_roots.js";

export const NEWTON_STEPS = 5; // from the root in single numbers; three do, two more where that was poor
export const BEGIN = 0.8660254; // of cos(⅓ acos x), 0 ≤ x ≤ 1, to 2e-4
export const SLOPE = 0.1642;
export const CURVE = -0.0302;

/** Return the largest root of x³ + bx² + cx + d, whose roots are real, if cos 3φ is not negative; and cos 3φ. */
function _largestRoot(b, c, d) {
  // Viète: x = 2r cos φ − b/3 with r = √(−P/3) and cos 3φ = −Q/2r³
  const third = b / 3;
  const p = c - b * third;
  const q = 2 * (third * third) * third - third * c + d;
  const r = Math.sqrt(larger(-p / 3, 0));
  const cosine = r > 0 ? -0.5 * q / (r * r * r) : 1;
  const x = smaller(larger(cosine, 0), 1);
  // cos φ is a root of 4 y³ − 3 y = x
  let y = BEGIN + x * (SLOPE + x * CURVE);
  y = (8 * y * y * y + x) / (12 * y * y - 3);
  y = (8 * y * y * y + x) / (12 * y * y - 3);
  return [2 * r * y - third, cosine];
}

/** Return a root after a step of Newton's. */
function _nearer(state) {
  const { 0: x, 1: cubic } = state;
  const { 0: b, 1: c, 2: d } = cubic;
  const value = add(multiply(add(multiply(add(x, b), x), c), x), d);
  const slope = add(multiply(add(add(scale(x, 2), x), scale(b, 2)), x), c);
  const change = divide(value, slope);
  const isFinite = change[0] - change[0] === 0;
  return [isFinite ? subtract(x, change) : x, cubic];
}

/** Return the turning points of a top. */
export function turningPoints(top) {
  const weightless = !(top.G[0] > 0);
  const safe = weightless ? ONE : top.G;
  const p2 = square(top.p);
  const c2 = square(top.c);
  const { 0: f1, 1: ofY, 2: ofS } = cubics(
    top.momentum[2],
    top.G,
    divide(ONE, safe),
    top.s0,
    top.t0,
    top.u0,
    top.w2,
    top.twist,
    p2,
    c2,
    top.D,
    top.F,
  );
  const { 0: y, 1: cosine } = _largestRoot(ofY[0][0], ofY[1][0], ofY[2][0]);
  const { 0: s } = _largestRoot(ofS[0][0], ofS[1][0], ofS[2][0]);
  const upper = cosine >= 0 || weightless;
  const cubic = [upper ? ofY[0] : ofS[0], upper ? ofY[1] : ofS[1], upper ? ofY[2] : ofS[2]];
  let running = [[upper ? y : s, 0], cubic];
  for (let k = 0; k < NEWTON_STEPS; k++) {
    running = _nearer(running);
  }
  const { 0: lone } = running;
  return turningPointsOf(upper, lone, top.G, safe, top.s0, top.t0, p2, c2, top.cPlus, top.F, f1);
}
