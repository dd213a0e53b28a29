// The arithmetic–geometric mean with its third-kind sum, and the nome.
import * as dd from "./double_double.js";

const CONVERGED = 2e-8; // the closing formulas leave an error of the fourth power
const MOST_STEPS = 20;

/** Return (a−g)/(a+g), ε and (a+g)/2; ag is taken as ((a+g)/2)² − ((a−g)/2)², which does not cancel in ε. */
function closing(a, g, pp) {
  const middle = dd.scale(dd.add(a, g), 0.5);
  const half = 0.5 * (a[0] - g[0] + (a[1] - g[1]));
  const d = dd.subtract(pp, dd.square(middle));
  const e = d[0] + d[1] + half * half;
  return { x: half / middle[0], e: e / (2 * middle[0] * middle[0] + e), middle };
}

/**
 * Return agm(a, g) and Σ Q_n with Q_0 = 1, ε = (p²−ag)/(p²+ag), Q_{n+1} = Q_n ε/2 and p ← (p²+ag)/2p.
 *
 * Arithmetic and square roots alone, so that rates carry thirty digits. All in double-double and positive; `pp` is p² at
 * the start. Source: Carlson, SIAM J. Math. Anal. 8 (1977) 231.
 */
export function thirdKindMean(a, g, pp) {
  const exponent = Math.min(dd.exponentOf(a[0]), 0); // fourth powers of rates down to 1e-150 would underflow
  const up = 2 ** exponent;
  const down = 2 ** -exponent;
  [a, g, pp] = [dd.scale(a, down), dd.scale(g, down), dd.scale(dd.scale(pp, down), down)];
  let q = dd.ONE;
  let total = dd.ONE;
  for (let k = 0; k < 3 + MOST_STEPS; k++) {
    const now = closing(a, g, pp);
    if (k >= 3 && Math.abs(now.x) < CONVERGED && Math.abs(now.e) < CONVERGED) break;
    const ag = dd.multiply(a, g);
    const s = dd.add(pp, ag);
    const e = dd.divide(dd.subtract(pp, ag), s);
    q = dd.scale(dd.multiply(q, e), 0.5);
    pp = dd.scale(dd.divide(dd.square(s), pp), 0.25);
    [a, g] = [dd.scale(dd.add(a, g), 0.5), dd.sqrt(ag)];
    total = dd.add(total, q);
  }
  const { x, e, middle } = closing(a, g, pp);
  const last = 0.5 * q[0] * e;
  total = dd.add(total, [last + last * (0.25 * (e * e - 0.5 * x * x)), 0]);
  return { mean: dd.scale(dd.add(middle, [-0.25 * middle[0] * x * x, 0]), up), total };
}

/**
 * Return nome/parameter, with k = √(1 − parameter) given, for parameters in [0, ½].
 *
 * Source: the inversion q = ε + 2ε⁵ + 15ε⁹ + …, ε = (1−√k)/(2(1+√k)) (Whittaker & Watson, 21.8).
 */
export function nomePerParameter(parameter, k) {
  const root = 1 + Math.sqrt(k);
  const ratio = 0.5 / ((1 + k) * root * root);
  const e = ratio * parameter;
  const e4 = e * e * (e * e);
  return ratio * (1 + e4 * (2 + e4 * (15 + e4 * (150 + e4 * 1707))));
}

/** Return θ3(0) − 1 for a nome up to e^−π. */
export const theta3Excess = (q) => 2 * (q + q ** 4 + q ** 9);

const DUPLICATIONS = 20; // nine halve the exponent of the smallest ratio, the rest divide the spread by four

/**
 * Return R_F(x, y, 1) = ½ ∫₀^∞ dt / √((t+x)(t+y)(t+1)) in double-double, for x, y ≥ 0, not both zero.
 *
 * Source: Carlson, Numer. Algorithms 10 (1995) 13, duplication.
 */
export function firstKind(x, y) {
  let [a, b, c] = [x, y, dd.ONE];
  for (let step = 0; step < DUPLICATIONS; step++) {
    const [ra, rb, rc] = [dd.sqrt(a), dd.sqrt(b), dd.sqrt(c)];
    const lambda = dd.add(dd.add(dd.multiply(ra, rb), dd.multiply(rb, rc)), dd.multiply(rc, ra));
    [a, b, c] = [a, b, c].map((v) => dd.scale(dd.add(v, lambda), 0.25));
  }
  const mean = dd.divide(dd.add(dd.add(a, b), c), [3, 0]);
  const [X, Y] = [a, b].map((v) => dd.subtract(dd.ONE, dd.divide(v, mean))[0]);
  const Z = -X - Y;
  const E2 = X * Y - Z * Z;
  const E3 = X * Y * Z;
  const closing = -E2 / 10 + E3 / 14 + (E2 * E2) / 24 - (3 * E2 * E3) / 44;
  return dd.divide(dd.add(dd.ONE, dd.from(closing)), dd.sqrt(mean));
}
