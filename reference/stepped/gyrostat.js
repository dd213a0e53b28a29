// Gyrostats: a body with a rotor inside that keeps its momentum, or that a motor turns.
import { finite, vector } from "../checking.js";
import { Stepped } from "./integrate.js";
import { attitudeOf, checkedStart, direction, dot, keptWithoutTorque, momentumOf, positive, renormalize, scalesOf,
  turn } from "./turning.js"; // prettier-ignore

const TOLERANCE = 1e-14; // see heavy_top.js

/**
 * Π̇ = Π × Ω, dR/dt = R hat(Ω), Ω = I⁻¹(Π − h): the rotor's momentum h is fixed in the body.
 *
 * Π is the whole momentum. Of a rotor driven at a constant rate h is the momentum relative to the body, and I are the moments
 * of both together; of one that turns freely h is its whole axial momentum, and I are the moments less its own along its axis.
 * The energy is the carrier's. Source: Hughes, Spacecraft Attitude Dynamics, section 3.4.
 */
export class Gyrostat {
  /**
   * @param moments principal moments I [kg m²]
   * @param rotor h [kg m²/s, principal axes]
   * @param rotor_moment of the rotor about its axis [kg m²], for its rate; null where it is not known
   * @param rotor_drive "constant-rate" or "free", which says what the rate is
   * @param axis of the rotor, a direction; by default that of h
   * @param momentum Π at the epoch [kg m²/s, principal axes]
   * @param attitude unit quaternion w, x, y, z at the epoch, principal axes → space
   * @param epoch time at which these hold [s]
   * @throws RangeError for values that cannot be these
   */
  constructor({ moments, rotor, rotor_moment = null, rotor_drive = "constant-rate", axis = null, momentum, attitude, epoch }) {
    const start = checkedStart({ moments, momentum, attitude, epoch });
    this.moments = start.moments;
    this.epoch = start.epoch;
    this.rotor = vector("rotor", rotor, 3, "kg m²/s");
    this.rotorMoment = rotor_moment === null ? null : positive("rotor_moment", rotor_moment, "kg m²");
    if (!["constant-rate", "free"].includes(rotor_drive)) {
      throw new RangeError(`\`rotor_drive\` must be "constant-rate" or "free"; got ${JSON.stringify(rotor_drive)}.`);
    }
    this.free = rotor_drive === "free";
    const turns = Math.hypot(...this.rotor) > 0;
    this.axis = axis === null ? turns && direction("rotor", this.rotor) : direction("axis", axis);
    const scale = Math.max(Math.hypot(...start.momentum), Math.hypot(...this.rotor)) || Math.max(...this.moments);
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
    const [a, b, c] = this.rotor;
    return (t, state, out) => {
      const [p, q, r] = [state[4], state[5], state[6]];
      const [u, v, n] = [(p - a) / I, (q - b) / J, (r - c) / K];
      turn(state, u, v, n, out);
      out[4] = q * n - r * v;
      out[5] = r * u - p * n;
      out[6] = p * v - q * u;
    };
  }

  /** Return {attitude, momentum, velocity Ω, energy, invariants, rotorRate [rad/s] or null} at a time [s]. */
  state(t) {
    const state = this._motion.at(finite("t", t, "seconds"));
    const [attitude, momentum] = [attitudeOf(state), momentumOf(state)];
    const carried = momentum.map((x, k) => x - this.rotor[k]);
    const velocity = carried.map((x, k) => x / this.moments[k]);
    const energy = 0.5 * dot(carried, velocity);
    const invariants = { energy, ...keptWithoutTorque(attitude, momentum) };
    return { attitude, momentum, velocity, energy, invariants, rotorRate: this.rotorRate(velocity) };
  }

  /** Return how fast the rotor turns relative to the body [rad/s] while the body turns by Ω; null where it is not known. */
  rotorRate(velocity) {
    if (this.rotorMoment === null || !this.axis) return null;
    return dot(this.rotor, this.axis) / this.rotorMoment - (this.free ? dot(velocity, this.axis) : 0);
  }
}

/**
 * A gyrostat whose motor turns the rotor with a constant torque u: Π̇ = Π × Ω, ḣ = u, Ω = I⁻¹(Π − h a).
 *
 * h is the rotor's whole momentum along its axis a, I the moments less the rotor's own along it. The energy
 * ½ (Π − ha)·I⁻¹(Π − ha) + h²/2J receives u (h/J − Ω·a). Source: Hughes, Spacecraft Attitude Dynamics, ch. 6.
 */
export class TorquedGyrostat {
  /**
   * @param moments I [kg m²]
   * @param axis a, a direction along the principal axes
   * @param rotor_moment J of the rotor about its axis [kg m²]
   * @param torque u of the motor on the rotor [N m]
   * @param rotor_momentum h at the epoch [kg m²/s]
   * @param momentum Π at the epoch [kg m²/s, principal axes]
   * @param attitude unit quaternion w, x, y, z at the epoch, principal axes → space
   * @param epoch time at which these hold [s]
   * @throws RangeError for values that cannot be these
   */
  constructor({ moments, axis, rotor_moment, torque, rotor_momentum, momentum, attitude, epoch }) {
    const start = checkedStart({ moments, momentum, attitude, epoch });
    this.moments = start.moments;
    this.epoch = start.epoch;
    this.axis = direction("axis", axis);
    this.rotorMoment = positive("rotor_moment", rotor_moment, "kg m²");
    this.torque = finite("torque", torque, "N m");
    const h = finite("rotor_momentum", rotor_momentum, "kg m²/s");
    const turning = Math.sqrt(Math.abs(this.torque) * this.rotorMoment); // what a turn under the motor gives
    const scale = Math.max(Math.hypot(...start.momentum), Math.abs(h), turning) || Math.max(...this.moments);
    this._motion = new Stepped({
      rates: this._rates(),
      start: [...start.attitude, ...start.momentum, h, 0],
      time: this.epoch,
      scale: scalesOf(scale, [scale, (scale * scale) / this.rotorMoment]),
      tolerance: TOLERANCE,
      project: renormalize,
    });
  }

  _rates() {
    const [I, J, K] = this.moments;
    const [a, b, c] = this.axis;
    const [torque, moment] = [this.torque, this.rotorMoment];
    return (t, state, out) => {
      const [p, q, r, h] = [state[4], state[5], state[6], state[7]];
      const [u, v, n] = [(p - h * a) / I, (q - h * b) / J, (r - h * c) / K];
      turn(state, u, v, n, out);
      out[4] = q * n - r * v;
      out[5] = r * u - p * n;
      out[6] = p * v - q * u;
      out[7] = torque;
      out[8] = torque * (h / moment - (u * a + v * b + n * c));
    };
  }

  /**
   * Return {attitude, momentum, velocity Ω, energy, invariants, balances, rotorRate [rad/s], rotorMomentum} at a time [s].
   *
   * A balance is {value, received}: their difference is constant.
   */
  state(t) {
    const state = this._motion.at(finite("t", t, "seconds"));
    const [attitude, momentum] = [attitudeOf(state), momentumOf(state)];
    const rotorMomentum = state[7];
    const carried = momentum.map((x, k) => x - rotorMomentum * this.axis[k]);
    const velocity = carried.map((x, k) => x / this.moments[k]);
    const energy = 0.5 * (dot(carried, velocity) + rotorMomentum ** 2 / this.rotorMoment);
    return {
      attitude, momentum, velocity, energy, rotorMomentum,
      invariants: keptWithoutTorque(attitude, momentum),
      balances: { energy: { value: energy, received: state[8] } },
      rotorRate: rotorMomentum / this.rotorMoment - dot(velocity, this.axis),
    }; // prettier-ignore
  }
}
