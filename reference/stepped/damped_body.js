// A body that loses energy: inside, as a double bracket, or by drag, also on an orbit with gravity's gradient.
import { finite, vector } from "../checking.js";
import { rotateBack } from "../quaternion.js";
import { Stepped } from "./integrate.js";
import { KeplerOrbit } from "./kepler.js";
import { attitudeOf, checkedStart, cross, dot, keptWithoutTorque, momentumOf, positive, renormalize, scalesOf,
  turn } from "./turning.js"; // prettier-ignore

const TOLERANCE = 1e-14; // see heavy_top.js

/**
 * L̇ = L × (Ω + d) + τ, dR/dt = R hat(Ω + d), with d = α L × Ω and τ = −c Ω − k |Ω| Ω + 3 n² (a/r)³ R̂ × I R̂.
 *
 * α alone is polhode's `DoubleBracket`, losses inside that leave L in space; the torques alone are a `TorquedBody` under
 * `LinearDrag`, `QuadraticDrag` and `GravityGradient`. Sources: Bloch, Krishnaprasad, Marsden & Ratiu, Commun. Math. Phys. 175
 * (1996) 1; Hughes, Spacecraft Attitude Dynamics, ch. 8 and 9.
 */
export class DampedBody {
  /**
   * @param moments principal moments [kg m²]
   * @param rate α [s/(kg m²)]
   * @param linear_drag c [N m s], one for all axes or one for each
   * @param quadratic_drag k [N m s²]
   * @param orbit {mean_motion [rad/s], eccentricity, mean_anomaly_at_start [rad] at t = 0}, or null
   * @param momentum L at the epoch [kg m²/s, principal axes]
   * @param attitude unit quaternion w, x, y, z at the epoch, principal axes → space
   * @param epoch time at which these hold [s]
   * @throws RangeError for values that cannot be these
   */
  constructor({ moments, rate = 0, linear_drag = 0, quadratic_drag = 0, orbit = null, momentum, attitude, epoch }) {
    const start = checkedStart({ moments, momentum, attitude, epoch });
    this.moments = start.moments;
    this.epoch = start.epoch;
    this.rate = positive("rate", rate, "s/(kg m²)", true);
    const drag = typeof linear_drag === "number" ? [linear_drag, linear_drag, linear_drag] : linear_drag;
    this.linearDrag = vector("linear_drag", drag, 3, "N m s").map((x) => positive("linear_drag", x, "N m s", true));
    this.quadraticDrag = positive("quadratic_drag", quadratic_drag, "N m s²", true);
    this.orbit = orbit === null ? null : new KeplerOrbit(orbit);
    this.torqued = this.orbit !== null || this.quadraticDrag > 0 || this.linearDrag.some((x) => x > 0);
    this._balanced = this.torqued ? ["kinetic_energy", "|L|²"] : this.rate > 0 ? ["energy"] : [];
    if (this.orbit?.eccentricity === 0) this._balanced.push("jacobi_integral");
    this._motion = new Stepped({
      rates: this._rates(),
      start: [...start.attitude, ...start.momentum, ...this._balanced.map(() => 0)],
      time: this.epoch,
      scale: this._scales(start.momentum),
      tolerance: TOLERANCE,
      project: renormalize,
    });
  }

  _scales(momentum) {
    const largest = Math.max(...this.moments);
    const size = Math.max(Math.hypot(...momentum), this.orbit ? largest * this.orbit.meanMotion : 0) || largest;
    const own = this._balanced.map((name) => (name === "|L|²" ? size * size : (size * size) / largest));
    return scalesOf(size, own);
  }

  _rates() {
    return (t, state, out) => {
      const now = this._at(t, [state[0], state[1], state[2], state[3]], [state[4], state[5], state[6]]);
      const { momentum, velocity, drift, torque } = now;
      const turning = [velocity[0] + drift[0], velocity[1] + drift[1], velocity[2] + drift[2]];
      turn(state, turning[0], turning[1], turning[2], out);
      const change = cross(momentum, turning);
      for (let k = 0; k < 3; k++) out[4 + k] = change[k] + torque[k];
      this._balanced.forEach((name, k) => (out[7 + k] = this._power(name, now)));
    };
  }

  /** Return what acts on the body in a state. */
  _at(t, attitude, momentum) {
    const velocity = [0, 1, 2].map((k) => momentum[k] / this.moments[k]);
    const torqueless = cross(momentum, velocity);
    const drift = torqueless.map((x) => this.rate * x);
    const pull = this.orbit ? this._gravity(t, attitude) : [0, 0, 0];
    const speed = this.quadraticDrag * Math.hypot(velocity[0], velocity[1], velocity[2]);
    const torque = [0, 1, 2].map((k) => pull[k] - (this.linearDrag[k] + speed) * velocity[k]);
    return { attitude, momentum, velocity, torqueless, drift, pull, torque };
  }

  _gravity(t, attitude) {
    const [x, y, ratio] = this.orbit.place(t);
    const centre = rotateBack(attitude, [x, y, 0]);
    const pulled = cross(centre, centre.map((part, k) => this.moments[k] * part)); // prettier-ignore
    const strength = (3 * this.orbit.meanMotion ** 2) / ratio ** 3;
    return pulled.map((part) => strength * part);
  }

  /** Return Ω less the orbit's mean motion [rad/s, body axes]. */
  _relative(attitude, velocity) {
    const normal = rotateBack(attitude, [0, 0, 1]);
    return velocity.map((x, k) => x - this.orbit.meanMotion * normal[k]);
  }

  /** Return the rate at which what is balanced changes. */
  _power(name, { attitude, momentum, velocity, torqueless, drift, pull, torque }) {
    const inside = -dot(drift, torqueless);
    if (name === "|L|²") return 2 * dot(torque, momentum);
    if (name !== "jacobi_integral") return dot(torque, velocity) + inside;
    const other = torque.map((x, k) => x - pull[k]);
    return dot(other, this._relative(attitude, velocity)) + inside - dot(pull, drift);
  }

  /** Return ½ w·Iw + (3/2) n² R̂·IR̂ − ½ n² ẑ·Iẑ [J] with w relative to the orbit's frame, kept on a circular orbit. */
  _jacobiIntegral(t, attitude, velocity) {
    const [x, y] = this.orbit.place(t);
    const [centre, normal] = [rotateBack(attitude, [x, y, 0]), rotateBack(attitude, [0, 0, 1])];
    const relative = this._relative(attitude, velocity);
    const square = this.orbit.meanMotion ** 2;
    const parts = relative.map((w, k) => w * w + square * (3 * centre[k] ** 2 - normal[k] ** 2));
    return 0.5 * dot(this.moments, parts);
  }

  /**
   * Return {attitude, momentum, velocity Ω, energy, invariants, balances, angleToMajorAxis [rad]} at a time [s].
   *
   * A balance is {value, received}: their difference is constant. The angle is from L to the nearest line of largest moment,
   * null without L.
   */
  state(t) {
    const state = this._motion.at(finite("t", t, "seconds"));
    const [attitude, momentum] = [attitudeOf(state), momentumOf(state)];
    const velocity = momentum.map((x, k) => x / this.moments[k]);
    const energy = 0.5 * dot(momentum, velocity);
    const values = { energy, kinetic_energy: energy, "|L|²": dot(momentum, momentum) };
    if (this.orbit) values.jacobi_integral = this._jacobiIntegral(t, attitude, velocity);
    const balances = this._balanced.map((name, k) => [name, { value: values[name], received: state[7 + k] }]);
    const kept = this.torqued ? {} : keptWithoutTorque(attitude, momentum);
    const invariants = this.torqued || this.rate > 0 ? kept : { energy, ...kept };
    return {
      attitude, momentum, velocity, energy, invariants,
      balances: Object.fromEntries(balances),
      angleToMajorAxis: this._angleToMajorAxis(momentum),
    }; // prettier-ignore
  }

  _angleToMajorAxis(momentum) {
    if (!(Math.hypot(...momentum) > 0)) return null;
    const largest = Math.max(...this.moments);
    const along = momentum.map((x, k) => (this.moments[k] === largest ? x : 0));
    return Math.atan2(Math.hypot(...momentum.map((x, k) => x - along[k])), Math.hypot(...along));
  }
}
