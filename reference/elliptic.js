// Carlson's elliptic integral of the first kind.
import * as dd from "./formulas/arithmetic.js";

const ONE = [1, 0];
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
