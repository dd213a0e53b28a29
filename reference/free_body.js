// The free rigid body in closed form, at any time.
import { asState, checkedRange, elapsedTime, finite, orNull, positiveMoments, unitQuaternion, vector } from "./checking.js";
import { stateAt } from "./formulas/free_body.js";
import { numbers } from "./formulas/free_body_numbers.js";
import { frequencies } from "./formulas/free_body_rates.js";
import { reduction } from "./formulas/free_body_reduction.js";
import { axesOf, motionOf } from "./formulas/free_body_setup.js";
import { normalize } from "./quaternion.js";

const REGIMES = ["rest", "spherical", "permanent", "symmetric", "short-axis", "long-axis", "separatrix"];

/**
 * Torque-free motion of a rigid body: dL/dt = L × Ω, L = IΩ, dR/dt = R hat(Ω).
 *
 * The attitude is a quotient of theta functions whose phases are kept in double-double: no step, no drift, the same error
 * at any time. All components are along the principal axes, in the order of `moments`; everything is in SI units.
 * Sources: Jacobi 1849; van Zon & Schofield, J. Comput. Phys. 225 (2007) 145.
 *
 * - `energy` ½ Σ L²/I [J], `momentumNorm` |L| [kg m²/s]
 * - `regime` "rest", "spherical", "permanent", "symmetric", "short-axis", "long-axis" or "separatrix"
 * - `encircledAxis` index of the axis that the polhode goes round, or null
 * - `period` T [s] after which L is back along the body's axes
 * - `precessionRate` mean rate [rad/s] at which the encircled axis turns about L; `precessionPerPeriod` that times T [rad]
 * - `flipInterval` T/2 [s] from one reversal along the intermediate axis to the next; null for a symmetric body
 * - `solidAngle` [sr] of the cap that the polhode cuts off about the encircled axis
 *
 * What is infinite is Infinity, such as the period on the separatrix; what is undefined is null.
 */
export class FreeMotion {
  /**
   * @param moments three principal moments [kg m²], positive, in any order
   * @param momentum angular momentum at the epoch [kg m²/s, body axes]
   * @param attitude unit quaternion w, x, y, z at the epoch, body → space
   * @param epoch time at which these hold [s]
   * @throws RangeError for values that cannot be these
   */
  constructor({ moments, momentum, attitude = [1, 0, 0, 0], epoch = 0 }) {
    this.moments = positiveMoments(moments);
    this.momentumAtEpoch = vector("momentum", momentum, 3, "kg m²/s");
    this.attitudeAtEpoch = normalize(unitQuaternion(attitude));
    this.epoch = finite("epoch", epoch, "seconds");
    const given = { moments: this.moments, momentum: this.momentumAtEpoch, attitude: this.attitudeAtEpoch };
    const body = reduction(given.moments, given.momentum);
    const rates = frequencies(body);
    this._fastest = Math.max(...given.momentum.map((x, k) => Math.abs(x / given.moments[k])));
    this._motion = motionOf({ ...given, body, rates });
    const { first, second, toAttitude, toMomentum } = this._motion;
    checkedRange([this._fastest, ...first, ...second, ...toAttitude, ...toMomentum]);
    this._curve = { body, rates };
    this.energy = 0.5 * given.momentum.reduce((sum, x, k) => sum + (x / given.moments[k]) * x, 0);
    this.momentumNorm = Math.hypot(...given.momentum);
    Object.assign(this, numbersOf(body, rates));
  }

  /** Return {attitude: [w, x, y, z], momentum: [x, y, z]} at a time [s]. */
  state(t) {
    const [elapsed, rest] = elapsedTime(t, this.epoch, this._fastest);
    return asState(stateAt(this._motion, elapsed, rest));
  }

  /** Return Ω [rad/s, body axes] at a time [s]. */
  angularVelocity(t) {
    const L = this.state(t).momentum;
    return [L[0] / this.moments[0], L[1] / this.moments[1], L[2] / this.moments[2]];
  }

  /**
   * Return `count` momenta [kg m²/s, body axes] along the polhode, from the one at the epoch on in the sense of the motion.
   *
   * They are evenly spread in the elliptic amplitude, not in time, so that the curve is smooth near the unstable axis too;
   * it closes after the last. On the separatrix they go from one end to the other, at rest all are one point.
   */
  along(count) {
    const { body, rates } = this._curve;
    const L = this.momentumAtEpoch;
    if (rates.constant) return Array.from({ length: count }, () => [...L]);
    const [A, B, C, P, Q] = [body.A, body.B, body.C, body.P, body.Q].map((x) => x[0]);
    const total = B * Q;
    const [m, m1] = rates.separatrix ? [1, 0] : [(A * P) / total, (-C * body.S[0]) / total];
    const [l1, l2] = body.canonical;
    const axes = axesOf(body);
    const rootP = body.rootP;
    const start = Math.atan2(Math.sqrt(B) * l2, Math.sqrt(C) * l1);
    const side = rates.separatrix && l1 < 0 ? -1 : 1;
    return Array.from({ length: count }, (_, k) => {
      const turn = rates.separatrix ? Math.PI * (k / Math.max(count - 1, 1) - 0.5) : start + (2 * Math.PI * k) / count;
      const c = side * Math.cos(turn);
      const s = side * Math.sin(turn);
      const point = [
        (rootP / Math.sqrt(C)) * c,
        (rootP / Math.sqrt(B)) * s,
        Math.sqrt(Q / C) * Math.sqrt(m1 + m * c * c),
      ];
      return axes.map((row) => body.momentumScale * (row[0] * point[0] + row[1] * point[1] + row[2] * point[2]));
    });
  }
}

/** Return the numbers of the motion; what is undefined is null. */
function numbersOf(body, rates) {
  const found = numbers(body, rates);
  const regime = REGIMES[found.regime];
  return {
    regime,
    encircledAxis: found.encircledAxis < 0 ? null : found.encircledAxis,
    modulus: orNull(found.modulus),
    period: orNull(found.period),
    precessionRate: orNull(found.precessionRate),
    precessionPerPeriod: orNull(found.precessionPerPeriod),
    flipInterval: regime === "symmetric" ? null : orNull(0.5 * found.period),
    solidAngle: orNull(found.solidAngle),
  };
}
