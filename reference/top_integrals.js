// The places of a top's poles and of its start in the lattice of periods.
import { firstKind } from "./elliptic.js";
import * as dd from "./formulas/arithmetic.js";
import { ONE, ZERO } from "./formulas/lagrange_top_roots.js";

/** Return these places, the `Integrals` of formulas/lagrange_top_setup.js; what is not used is zero. */
export function integralsOf(top, points, rates) {
  const { G } = top;
  const { A, B, d, s1, s2, t1, t2, Y, ZMinus, ZPlus, fromLower, fromUpper } = points;
  if (rates.permanent) return { vAlpha: 0, vBeta: 0, wAlpha: 0, wBeta: 0, x0: ZERO };
  // where the tilt stays the pole is infinitely far: only e^−y = 0 enters
  if (rates.steady) return { vAlpha: Infinity, vBeta: Infinity, wAlpha: 0, wBeta: 0, x0: ZERO };
  const over = dd.divide;
  const of = (factor, x, y) => {
    const size = x[0] + y[0];
    return dd.multiply(dd.rootOrZero(factor), size > 0 && Number.isFinite(size) ? firstKind(x, y) : ONE);
  };
  const s1B = dd.multiply(s1, B);
  const alpha = of(over(t1, t2), over(d, t2), over(dd.multiply(d, ZPlus), dd.multiply(A, t2)))[0];
  const beta = of(over(dd.multiply(s2, A), s1B), over(dd.multiply(d, ZMinus), s1B), over(d, s1))[0];
  return {
    vAlpha: rates.separatrix ? Math.atan2(Math.sqrt(t1[0]), Math.sqrt(d[0])) : alpha,
    vBeta: rates.separatrix || s2[0] === 0 ? 0 : beta,
    wAlpha: of(over(A, ZPlus), over(dd.multiply(G, t1), ZPlus), over(dd.multiply(G, t2), ZPlus))[0],
    wBeta: of(over(ZMinus, B), over(dd.multiply(G, s2), B), over(dd.multiply(G, s1), A))[0],
    x0: of(over(fromLower, d), over(fromUpper, d), over(Y, A)),
  };
}
