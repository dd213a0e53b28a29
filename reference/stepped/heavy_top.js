// The heavy top: any body about a fixed point, under its weight.
import { finite } from "../checking.js";
import { rotateBack } from "../quaternion.js";
import { Stepped } from "./integrate.js";
import { thirdIntegral } from "./top_integrals.js";
import { attitudeOf, checkedStart, direction, dot, momentumOf, renormalize, scalesOf, turn } from "./turning.js";

const TOLERANCE = 1e-14; // energy and momentum then stay to 1e-12 over hundreds of turns, for twice the steps of 1e-12

/**
 * Π̇ = Π × Ω + mgl Γ × χ, dR/dt = R hat(Ω), Ω = I⁻¹Π: Γ = Rᵀe_z is the upward direction along the body's axes, χ that from
 * the fixed point to the centre of mass; space z is up.
 *
 * Source: Marsden & Ratiu, Introduction to Mechanics and Symmetry, section 15.10.
 */
export class HeavyTop {
  /**
   * @param moments principal moments about the fixed point [kg m²]
   * @param mgl weight times the distance from fixed point to centre of mass [N m]
   * @param axis χ, a direction of any length along the principal axes
   * @param momentum Π at the epoch [kg m²/s, principal axes]
   * @param attitude unit quaternion w, x, y, z at the epoch, principal axes → space
   * @param epoch time at which these hold [s]
   * @throws RangeError for values that cannot be these
   */
  constructor({ moments, mgl, axis = [0, 0, 1], momentum, attitude, epoch }) {
    const start = checkedStart({ moments, momentum, attitude, epoch });
    this.moments = start.moments;
    this.epoch = start.epoch;
    this.mgl = finite("mgl", mgl, "N m");
    this.axis = direction("axis", axis);
    const up = rotateBack(start.attitude, [0, 0, 1]);
    this._third = thirdIntegral(this.moments, this.mgl, this.axis, [start.momentum, up]);
    const largest = Math.max(...this.moments);
    const scale = Math.max(Math.hypot(...start.momentum), Math.sqrt(Math.abs(this.mgl) * largest)) || largest;
    this._motion = new Stepped({
      rates: this._rates(),
      start: [...start.attitude, ...start.momentum],
      time: this.epoch,
      scale: scalesOf(scale),
      tolerance: TOLERANCE,
      project: renormalize,
    });
  }

  _rates() {
    const [I, J, K] = this.moments;
    const [a, b, c] = this.axis.map((x) => this.mgl * x);
    return (t, state, out) => {
      const [w, x, y, z] = [state[0], state[1], state[2], state[3]];
      const [p, q, r] = [state[4], state[5], state[6]];
      const [u, v, n] = [p / I, q / J, r / K];
      turn(state, u, v, n, out);
      const [g, h, k] = [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z]; // Γ
      out[4] = q * n - r * v + h * c - k * b;
      out[5] = r * u - p * n + k * a - g * c;
      out[6] = p * v - q * u + g * b - h * a;
    };
  }

  /** Return {attitude, momentum, velocity Ω, energy, invariants} at a time [s]. */
  state(t) {
    const state = this._motion.at(finite("t", t, "seconds"));
    const [attitude, momentum] = [attitudeOf(state), momentumOf(state)];
    const velocity = momentum.map((x, k) => x / this.moments[k]);
    const up = rotateBack(attitude, [0, 0, 1]);
    const energy = 0.5 * dot(momentum, velocity) + this.mgl * dot(up, this.axis);
    const invariants = { energy, "|P|²": dot(up, up), "Π·P": dot(momentum, up) };
    if (this._third) invariants[this._third[0]] = this._third[1](momentum, up);
    return { attitude, momentum, velocity, energy, invariants };
  }
}
