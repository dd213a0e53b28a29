// Kepler's orbit: where the attracting centre stands as seen from a body that goes round it.
// E − e sin E = M, r/a = 1 − e cos E, M = n t + M0. Source: Murray & Dermott, Solar System Dynamics, sections 2.3–2.4.
import { finite } from "../checking.js";
import { positive } from "./turning.js";

const NEWTON_STEPS = 6; // from the start below five come within three roundings for any e < 1
const SMALL = 1; // rad up to which E − sin E is summed as a series
const TERMS = 9;

export class KeplerOrbit {
  /**
   * @param mean_motion n [rad/s]
   * @param eccentricity 0 ≤ e < 1
   * @param mean_anomaly_at_start M0 at t = 0 [rad]
   */
  constructor({ mean_motion, eccentricity = 0, mean_anomaly_at_start = 0 }) {
    this.meanMotion = positive("mean_motion", mean_motion, "rad/s");
    this.eccentricity = positive("eccentricity", eccentricity, "1", true);
    if (!(this.eccentricity < 1)) {
      throw new RangeError(`\`eccentricity\` must be below 1; got ${eccentricity}. Only ellipses come round again.`);
    }
    this.meanAnomalyAtStart = finite("mean_anomaly_at_start", mean_anomaly_at_start, "rad");
  }

  /** Return [x, y, r/a] at a time [s]: the unit vector from the centre to the body in the orbit's plane, periapsis on +x. */
  place(t) {
    const mean = this.meanMotion * t + this.meanAnomalyAtStart;
    const e = this.eccentricity;
    const half = 0.5 * solveKepler(mean - 2 * Math.PI * Math.round(mean / (2 * Math.PI)), e);
    const [sine, cosine] = [Math.sin(half), Math.cos(half)];
    const ratio = 1 - e + 2 * e * sine * sine;
    return [(1 - e - 2 * sine * sine) / ratio, (2 * Math.sqrt((1 - e) * (1 + e)) * sine * cosine) / ratio, ratio];
  }
}

/**
 * Return E of M in [−π, π].
 *
 * On [0, π] the equation is convex, so that Newton's steps from above its root never go past it. It is written
 * (1−e) E + e (E − sin E) = M, in which nothing cancels where e is near one and M near zero.
 */
function solveKepler(mean, e) {
  const M = Math.abs(mean);
  let E = Math.min(M + e, M / (1 - e), e > 0 ? Math.cbrt((Math.PI ** 2 * M) / e) : Infinity, Math.PI);
  for (let k = 0; k < NEWTON_STEPS; k++) {
    const slope = 1 - e + 2 * e * Math.sin(0.5 * E) ** 2;
    E -= ((1 - e) * E - M + e * lessSine(E)) / slope;
  }
  E = Math.min(Math.max(E, 0), Math.PI);
  return mean < 0 ? -E : E;
}

/** Return E − sin E to its last digits. */
function lessSine(angle) {
  if (angle >= SMALL) return angle - Math.sin(angle);
  let term = angle ** 3 / 6;
  let sum = 0;
  for (let k = 1; k <= TERMS; k++) {
    sum += term;
    term *= -(angle * angle) / ((2 * k + 2) * (2 * k + 3));
  }
  return sum;
}
