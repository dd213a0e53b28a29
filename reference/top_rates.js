// The three frequencies of a Lagrange top: nutation, and the mean turns of α and β, by arithmetic–geometric means.
//
// α and β turn by c'/2t and c/2s, whose means over a nutation are complete integrals of the third kind. Each has two forms,
// one for either side of the pole that it looks at, so that nothing cancels. Sources: Carlson, SIAM J. Math. Anal. 8 (1977)
// 231; Klein & Sommerfeld, Theorie des Kreisels, ch. VI.
import { thirdKindMean } from "./elliptic.js";
import * as dd from "./formulas/arithmetic.js";
import { drift, ONE, spin, startOfAlpha, startOfBeta, ZERO } from "./formulas/lagrange_top_setup.js";

/**
 * Return the rates by τ = t/I1 in scaled units, double-double.
 *
 * `halfRoot` is W = ½√A, `nutation` ϖ = ½ agm(√A, √B) = πW/2K, `alpha` and `beta` the linear rates of their phases apart
 * from the theta quotients, `spin` what I3 ≠ I1 adds. `permanent`: the momentum stays; `steady`: the tilt stays.
 */
export function topRates(top, points) {
  const a = top.momentum[2];
  const upright = top.s0[0] === 0 || top.t0[0] === 0;
  const permanent = top.w2[0] === 0 && (upright || (top.G[0] === 0 && a === 0));
  const separatrix = !(points.B[0] > 0) && !permanent;
  const signAlpha = top.cPlus[0] >= 0 ? 1 : -1;
  const signBeta = top.c[0] >= 0 ? 1 : -1;
  const cPlus = dd.scale(top.cPlus, signAlpha);
  const [I1, I3] = top.moments;
  const rootA = dd.rootOrZero(points.A);
  const signs = { signAlpha, signBeta, spin: spin(I1, I3, a) };
  const found = { halfRoot: dd.scale(rootA, 0.5), ...signs, permanent, separatrix, steady: false };
  if (permanent) return { ...found, nutation: ZERO, alpha: ZERO, beta: ZERO };
  if (separatrix) return { ...found, nutation: ZERO, alpha: dd.scale(cPlus, 0.25 * signAlpha), beta: ZERO };
  const drifts = bothDrifts(top, points, rootA, cPlus, dd.scale(top.c, signBeta));
  const own = {
    nutation: drifts.nutation,
    alpha: dd.scale(drifts.alpha, signAlpha),
    beta: dd.scale(drifts.beta, signBeta),
  };
  return { ...found, ...(top.leaves ? lingering(top, found.halfRoot, own) : own), steady: !(points.d[0] > 0) };
}

/** Return the x = Wτ that a top which leaves the vertical needs until its displacement is as large as the lifted one. */
export const climb = (top) => (top.leaves ? dd.multiplyFloat(dd.LN2, top.lift) : ZERO);

/**
 * Return the rates of a top that leaves the vertical from those of the lifted one.
 *
 * The displacement grows and falls as e^{±x}, so K = πW/2ϖ is longer by `climb`. During it α turns by c'/4 and β not at
 * all, so the turns of a nutation that are beyond that stay the same and their mean rates shrink as ϖ does.
 */
function lingering(top, W, { nutation, alpha, beta }) {
  const own = dd.scale(top.cPlus, 0.25);
  const longer = dd.scale(dd.divide(dd.multiply(climb(top), nutation), dd.multiply(dd.PI, W)), 2); // climb/K
  const share = dd.divide(ONE, dd.add(ONE, longer));
  return {
    nutation: dd.multiply(nutation, share),
    alpha: dd.add(own, dd.multiply(dd.subtract(alpha, own), share)),
    beta: dd.multiply(beta, share),
  };
}

function bothDrifts(top, points, rootA, cPlus, c) {
  const { G } = top;
  const { A, B, s1, s2, t1, t2, d, zMinus, zPlus } = points;
  const rootB = dd.rootOrZero(B);
  const firstAlpha = zPlus[0] <= 2 * A[0];
  const firstBeta = dd.multiply(G, s2)[0] <= zMinus[0];
  const ofAlpha = thirdKindMean(rootA, rootB, startOfAlpha(firstAlpha, A, zPlus, t1, t2));
  const ofBeta = thirdKindMean(rootA, rootB, startOfBeta(firstBeta, c, A, B, zMinus, s1, s2));
  const nutation = dd.scale(ofAlpha.mean, 0.5);
  const alpha = drift(firstAlpha, cPlus, G, zPlus, t1, t2, d, nutation, ofAlpha.total);
  const beta = drift(firstBeta, c, G, zMinus, s2, s1, d, nutation, ofBeta.total);
  return { nutation, alpha, beta: firstBeta ? dd.scale(beta, -1) : beta };
}
