// The Lagrange top in closed form, at any time.
import { asState, checkedRange, elapsedTime, finite, orNull, positiveMoments, unitQuaternion, vector } from "./checking.js";
import { stateAt } from "./formulas/lagrange_top.js";
import { integralsOf } from "./formulas/lagrange_top_integrals.js";
import { numbers } from "./formulas/lagrange_top_numbers.js";
import { frequencies } from "./formulas/lagrange_top_rates.js";
import { reduction } from "./formulas/lagrange_top_reduction.js";
import { turningPoints } from "./formulas/lagrange_top_roots.js";
import { arguments_ as lattice, motionOf } from "./formulas/lagrange_top_setup.js";
import { normalize, rotate } from "./quaternion.js";

const REGIMES = [
  "rest", "sleeping", "hanging", "steady", "free", "planar", "undulating", "cusp", "loop", "separatrix",
]; // prettier-ignore

/**
 * A heavy symmetric top: H = ½ L·I⁻¹L + mgl cos θ, dL/dt = L × Ω + mgl Γ × e3, dR/dt = R hat(Ω).
 *
 * θ is the tilt of the body's third axis from the vertical, space z, up; Γ = Rᵀe_z. The Cayley–Klein parameters are
 * quotients of theta functions, regular also where Euler angles are not: no step, no drift, the same error at any time, from
 * the sleeping top to the spherical pendulum. Source: Klein & Sommerfeld, Theorie des Kreisels, ch. IV and VI.
 *
 * - `energy` [J], zero potential where the axis is level; `verticalMomentum`, `axialMomentum` [kg m²/s]
 * - `regime` "rest", "sleeping", "hanging", "steady", "free", "planar", "undulating", "cusp", "loop" or "separatrix"
 * - `nutationLimits` [least, most] cos θ; `nutationPeriod` T [s], of a steady top that of its smallest nutations
 * - `precessionPerPeriod` azimuth gained by the axis in T, `spinPerPeriod` the body's own turn in T [rad], both unreduced;
 *   `precessionRate`, `spinRate` these over T
 *
 * What is infinite is Infinity, what is undefined is null.
 */
export class LagrangeMotion {
  /**
   * @param moments (I1, I1, I3) about the pivot [kg m²], positive, the first two equal
   * @param mgl weight times the distance from pivot to centre of mass [N m], negative where that lies below
   * @param momentum angular momentum at the epoch [kg m²/s, body axes]
   * @param attitude unit quaternion w, x, y, z at the epoch, body → space; q/|q| is meant, exactly
   * @param epoch time at which these hold [s]
   * @throws RangeError for values that cannot be these
   */
  constructor({ moments, mgl, momentum, attitude = [1, 0, 0, 0], epoch = 0 }) {
    this.moments = positiveMoments(moments);
    if (this.moments[0] !== this.moments[1]) {
      throw new RangeError(
        `\`moments\` must be (I1, I1, I3), the first two equal; got ${JSON.stringify(this.moments)} kg m². Give one of them ` +
          "twice if they differ by rounding, and put the axis of symmetry third.",
      );
    }
    this.mgl = finite("mgl", mgl, "N m");
    this.momentumAtEpoch = vector("momentum", momentum, 3, "kg m²/s");
    this.attitudeAtEpoch = unitQuaternion(attitude);
    this.epoch = finite("epoch", epoch, "seconds");
    const L = this.momentumAtEpoch;
    const top = reduction(this.moments, this.mgl, L, this.attitudeAtEpoch);
    const points = turningPoints(top);
    const rates = frequencies(top, points);
    const turning = Math.max(...L.map((x, k) => Math.abs(x / this.moments[k])));
    this._fastest = turning + Math.sqrt(Math.abs(this.mgl) / this.moments[0]);
    const at = lattice(top, points, rates, integralsOf(top, points, rates));
    this._motion = motionOf({ top, points, rates, at, axial: L[2] });
    const { first, second, third, start, rates: ofMomentum, phases } = this._motion;
    checkedRange([this._fastest, ...first, ...second, ...third, ...start, ...ofMomentum, ...phases]);
    const [w, x, y, z] = this.attitudeAtEpoch;
    const [up, down] = [w * w + z * z, x * x + y * y];
    const kinetic = 0.5 * L.reduce((sum, value, k) => sum + (value / this.moments[k]) * value, 0);
    this.energy = kinetic + (this.mgl * (up - down)) / (up + down);
    this.verticalMomentum = rotate(normalize(this.attitudeAtEpoch), L)[2];
    this.axialMomentum = L[2];
    Object.assign(this, numbersOf(top, points, rates));
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
}

/** Return the numbers of the motion; what is undefined is null. */
function numbersOf(top, points, rates) {
  const found = numbers(top, points, rates);
  return {
    regime: REGIMES[found.regime],
    nutationLimits: [found.lowest, found.highest],
    nutationPeriod: orNull(found.period),
    precessionPerPeriod: orNull(found.precessionPerPeriod),
    spinPerPeriod: orNull(found.spinPerPeriod),
    precessionRate: orNull(found.precessionPerPeriod / found.period),
    spinRate: orNull(found.spinPerPeriod / found.period),
  };
}
