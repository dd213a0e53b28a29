// Printed from reference/printing/single_top.py by `python -m printing`: change that, and print again.
//
// Roots and integrals of a single top: formulas for printing, where arrays and kernels each have ways of their own.
//
// The separate root is computed by Newton's method in double-double, in a variable in which it is large. Sources:
// Viète's formula for its start; Carlson, Numer. Algorithms 10 (1995) 13, for the integrals.

import { larger, smaller } from "../words.js";
import { add, divide, multiply, root, rootOrZero, scale, square, subtract } from "./arithmetic.js";
import { cubics, ONE, turningPointsOf, ZERO } from "./lagrange_top_roots.js";

export const NEWTON_STEPS = 5; // from the root in single numbers; three do, two more where that was poor
export const DUPLICATIONS = 20; // nine halve the exponent of the smallest ratio, the others divide the spread by four
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

// ---------------------------------------------------------------------- integrals of the first kind

function _duplicated(state) {
  const { 0: a, 1: b, 2: c } = state;
  const u = rootOrZero(a);
  const v = rootOrZero(b);
  const w = rootOrZero(c);
  const more = add(add(multiply(u, v), multiply(v, w)), multiply(w, u));
  return [scale(add(a, more), 0.25), scale(add(b, more), 0.25), scale(add(c, more), 0.25)];
}

/** Return R_F(x, y, 1) for x, y ≥ 0, not both zero. */
export function firstKind(x, y) {
  let running = [x, y, ONE];
  for (let k = 0; k < DUPLICATIONS; k++) {
    running = _duplicated(running);
  }
  const { 0: a, 1: b, 2: c } = running;
  // DLMF 19.36.1 in X = 1 − a/mean, …, with X + Y + Z = 0. After the steps |X| < 1e-7 even where x = 0 and y = 1e-300,
  // so that order 5 is enough, and the correction, below 1e-15, needs no second number
  const mean = divide(add(add(a, b), c), [3, 0]);
  const X = subtract(ONE, divide(a, mean))[0];
  const Y = subtract(ONE, divide(b, mean))[0];
  const Z = -X - Y;
  const E2 = X * Y - Z * Z;
  const E3 = X * Y * Z;
  const closing = -E2 / 10 + E3 / 14 + E2 * E2 / 24 - 3 * E2 * E3 / 44;
  return divide(add(ONE, [closing, 0]), root(mean));
}

/** Return √factor R_F(x, y, 1), and √factor where the integral is not used. */
function _integral(idle, factor, x, y) {
  const total = x[0] + y[0];
  const bad = idle || !(total > 0) || !(total - total === 0);
  return multiply(rootOrZero(factor), firstKind(bad ? ONE : x, bad ? ONE : y));
}

/** Return the distances of α's and β's poles from the real axis, what they leave of K', and that of the start. */
export function integrals(top, points, rates) {
  const g = top.G;
  const d = points.d;
  const a = points.A;
  const b = points.B;
  const zPlus = points.ZPlus;
  const zMinus = points.ZMinus;
  const s1 = points.s1;
  const s2 = points.s2;
  const t1 = points.t1;
  const t2 = points.t2;
  const idle = rates.permanent || rates.steady;
  let vAlpha = _integral(idle, divide(t1, t2), divide(d, t2), divide(multiply(d, zPlus), multiply(a, t2)))[0];
  const s1b = multiply(s1, b);
  let vBeta = _integral(idle, divide(multiply(s2, a), s1b), divide(multiply(d, zMinus), s1b), divide(d, s1))[0];
  const wAlpha = _integral(idle, divide(a, zPlus), divide(multiply(g, t1), zPlus), divide(multiply(g, t2), zPlus));
  const wBeta = _integral(idle, divide(zMinus, b), divide(multiply(g, s2), b), divide(multiply(g, s1), a));
  const x0 = _integral(idle, divide(points.fromLower, d), divide(points.fromUpper, d), divide(points.Y, a));
  vAlpha = rates.separatrix ? Math.atan2(Math.sqrt(t1[0]), Math.sqrt(d[0])) : vAlpha;
  vBeta = rates.separatrix || s2[0] === 0 ? 0 : vBeta;
  // where the tilt stays the pole is infinitely far
  vAlpha = rates.steady ? Infinity : rates.permanent ? 0 : vAlpha;
  vBeta = rates.steady ? Infinity : rates.permanent ? 0 : vBeta;
  return { vAlpha, vBeta, wAlpha: wAlpha[0], wBeta: wBeta[0], x0: idle && !(d[0] > 0) ? ZERO : x0 };
}
