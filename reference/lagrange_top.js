// The Lagrange top in closed form, at any time.
import { asState, checkedRange, elapsedTime, finite, positiveMoments, unitQuaternion, vector } from "./checking.js";
import * as dd from "./formulas/arithmetic.js";
import { stateAt } from "./formulas/lagrange_top.js";
import { frequencies } from "./formulas/lagrange_top_rates.js";
import { arguments_ as lattice, motionOf } from "./formulas/lagrange_top_setup.js";
import { normalize, rotate } from "./quaternion.js";
import { integralsOf } from "./top_integrals.js";
import { reducedTop } from "./top_reduction.js";
import { turningPoints } from "./top_roots.js";

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
    const top = reducedTop(this.moments, this.mgl, L, this.attitudeAtEpoch);
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
  const { permanent, separatrix, nutation } = rates;
  const [lower, upper] = permanent
    ? [top.u0[0], top.u0[0]]
    : [cosineFrom(points.s1, points.t1), cosineFrom(points.s2, points.t2)];
  const found = {
    regime: regimeOf(top, rates),
    nutationLimits: top.reversed ? [-upper, -lower] : [lower, upper],
    nutationPeriod: separatrix ? Infinity : null,
    precessionPerPeriod: null,
    spinPerPeriod: null,
    precessionRate: null,
    spinRate: null,
  };
  if (permanent || separatrix) return found;
  const alpha = dd.add(dd.divide(rates.alpha, nutation), [rates.signAlpha, 0]);
  const beta = dd.add(dd.divide(rates.beta, nutation), [rates.signBeta, 0]);
  const spin = dd.divide(rates.spin, nutation);
  const precession = dd.multiply(dd.PI, dd.add(alpha, beta))[0];
  const ownTurn = (top.reversed ? -1 : 1) * dd.multiply(dd.PI, dd.add(dd.subtract(alpha, beta), spin))[0];
  const period = dd.divide(dd.multiplyFloat(dd.PI, top.moments[0]), dd.scale(nutation, top.rateScale))[0];
  return {
    ...found,
    nutationPeriod: period,
    precessionPerPeriod: precession,
    spinPerPeriod: ownTurn,
    precessionRate: precession / period,
    spinRate: ownTurn / period,
  };
}

/** Return u from the smaller of 1 − u and 1 + u. */
const cosineFrom = (s, t) => (s[0] < t[0] ? dd.subtract([1, 0], s)[0] : dd.subtract(t, [1, 0])[0]);

/**
 * Signs of polynomials in the given floats decide; only the steady top needs the computed gap u2 − u1.
 *
 * The azimuth stands still where p_φ = a u; there |w|² = lean/a, which is positive inside the nutation's range.
 */
function regimeOf(top, rates) {
  const [a, c, cPlus, lean] = [top.momentum[2], top.c[0], top.cPlus[0], top.lean[0]];
  if (rates.permanent && a === 0) return "rest";
  if (top.G[0] === 0) return "free";
  if (rates.permanent) return top.s0[0] === 0 ? "sleeping" : "hanging";
  if (rates.separatrix) return "separatrix";
  if (rates.steady) return "steady";
  if (a === 0 && c === 0) return "planar";
  const along = a < 0 ? -lean : lean;
  const within = c * a < 0 && cPlus * a > 0; // the place p_φ/a is a tilt: −1 < p_φ/a < 1
  if (within && along === 0) return "cusp";
  return within && along > 0 ? "loop" : "undulating";
}
