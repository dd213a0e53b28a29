// The arithmetic–geometric mean with its third-kind sum, and Carlson's R_F.
import * as dd from "./formulas/arithmetic.js";
import { meanClosed, meanDistance, meanStep } from "./formulas/common.js";
import { binaryExponent } from "./words.js";

const CONVERGED = 2e-8; // the closing formulas leave an error of the fourth power
const MOST_STEPS = 20;
const ONE = [1, 0];

/**
 * Return agm(a, g) and Σ Q_n with Q_0 = 1, ε = (p²−ag)/(p²+ag), Q_{n+1} = Q_n ε/2 and p ← (p²+ag)/2p.
 *
 * Arithmetic and square roots alone, so that rates carry thirty digits. All in double-double and positive; `pp` is p² at
 * the start. Source: Carlson, SIAM J. Math. Anal. 8 (1977) 231.
 */
export function thirdKindMean(a, g, pp) {
  const exponent = Math.min(binaryExponent(a[0]), 0); // fourth powers of rates down to 1e-150 would underflow
  const up = 2 ** exponent;
  const down = 2 ** -exponent;
  let state = [dd.scale(a, down), dd.scale(g, down), dd.scale(dd.scale(pp, down), down), ONE, ONE];
  for (let k = 0; k < 3 + MOST_STEPS; k++) {
    const [x, e] = meanDistance(...state.slice(0, 3));
    if (k >= 3 && Math.abs(x) < CONVERGED && Math.abs(e) < CONVERGED) break;
    state = meanStep(...state);
  }
  const [mean, total] = meanClosed(...meanDistance(...state.slice(0, 3)), state[3][0], state[4]);
  return { mean: dd.scale(mean, up), total };
}

const DUPLICATIONS = 20; // nine halve the exponent of the smallest ratio, the rest divide the spread by four

/**
 * Return R_F(x, y, 1) = ½ ∫₀^∞ dt / √((t+x)(t+y)(t+1)) in double-double, for x, y ≥ 0, not both zero.
 *
 * Source: Carlson, Numer. Algorithms 10 (1995) 13, duplication.
 */
export function firstKind(x, y) {
  let [a, b, c] = [x, y, ONE];
  for (let step = 0; step < DUPLICATIONS; step++) {
    const [ra, rb, rc] = [dd.rootOrZero(a), dd.rootOrZero(b), dd.rootOrZero(c)];
    const lambda = dd.add(dd.add(dd.multiply(ra, rb), dd.multiply(rb, rc)), dd.multiply(rc, ra));
    [a, b, c] = [a, b, c].map((v) => dd.scale(dd.add(v, lambda), 0.25));
  }
  const mean = dd.divide(dd.add(dd.add(a, b), c), [3, 0]);
  const [X, Y] = [a, b].map((v) => dd.subtract(ONE, dd.divide(v, mean))[0]);
  const Z = -X - Y;
  const E2 = X * Y - Z * Z;
  const E3 = X * Y * Z;
  const closing = -E2 / 10 + E3 / 14 + (E2 * E2) / 24 - (3 * E2 * E3) / 44;
  return dd.divide(dd.add(ONE, [closing, 0]), dd.rootOrZero(mean));
}
