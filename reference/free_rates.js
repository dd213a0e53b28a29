// The two frequencies of a free body: that of the polhode and that of the frame about the angular momentum.
import * as dd from "./double_double.js";
import { thirdKindMean } from "./elliptic.js";

/**
 * Return the rates of a reduced body, times V, in scaled units.
 *
 * `modulus` is λ = √(BQ), `mean` agm(√(BQ), √(−CS)) = πλ/2K, `precession` ω_p, `G` |L|. `constant` says that L stays;
 * both that and `separatrix` have no mean.
 */
export function ratesOf(body) {
  const { A, B, C, P, Q, G2, moments, canonical, longAxis, rootS } = body;
  const BQ = dd.multiply(B, Q);
  const [l1, , l3] = canonical;
  const constant = !(BQ[0] > 0) || !(body.rootP > 0) || (l1 === 0 && l3 === 0);
  const separatrix = !(C[0] > 0 && rootS[0] > 0) && !constant;
  const G = dd.sqrt(G2);
  const modulus = dd.sqrt(BQ);
  const found = { modulus, mean: dd.ONE, precession: dd.ZERO, G, constant, separatrix };
  if (constant) return found;
  const [I1, I2, I3] = moments;
  const sign = longAxis ? -1 : 1;
  if (separatrix) return { ...found, precession: dd.multiply(G, dd.twoProduct(sign * I1, I3)) };
  // of two forms the one whose sum converges fast
  const thirdAxis = B[0] >= A[0];
  const start = thirdAxis ? dd.multiply(Q, C) : dd.multiply(dd.multiply(B, C), G2);
  const { mean, total } = thirdKindMean(modulus, dd.multiply(dd.sqrt(C), rootS), start);
  const outer = dd.twoProduct(sign * (longAxis === thirdAxis ? I1 : I3), I2);
  const correction = dd.multiply(thirdAxis ? A : P, total);
  const share = thirdAxis ? dd.scale(correction, -0.5) : dd.scale(dd.divide(correction, G2), 0.5);
  const precession = dd.multiply(G, dd.add(outer, share));
  return { ...found, mean, precession: thirdAxis ? precession : dd.add(precession, mean) };
}
