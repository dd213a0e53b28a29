// A disk that rolls without slipping on a horizontal plane, thick or thin, until it lies flat: Euler's disk.
import { finite, vector } from "../checking.js";
import { Stepped } from "./integrate.js";
import { checkedLaws, couples } from "./rolling_dissipation.js";
import { LegendreFunction, linearIntegrals } from "./rolling_integrals.js";
import { RollingMechanics } from "./rolling_mechanics.js";
import { slowTiltRate, steadyRates } from "./rolling_start.js";
import { positive } from "./turning.js";

const TOLERANCE = 1e-14; // see heavy_top.js
const FLAT = 1e-6; // rad: the rim of a coin is then lifted by tens of nanometres, less than any table is rough
const NEARLY_FLAT = 1e-3; // rad above which a tilt has the tolerance relative to itself
const STANDARD_GRAVITY = 9.80665; // m/s²

/** Numbers of a state, in their order. */
export const PARTS = ["tilt", "heading", "face", "contact_x", "contact_y", "tilt_rate", "rise_rate", "spin"];

/**
 * Rolling of a disk or a flat cylinder on a plane, without slipping, under any sum of laws of dissipation.
 *
 * State: (θ, φ, χ, X, Y, ω1, ω2, ω3). θ is the angle between the disk's face and the plane, φ the heading of the horizontal
 * diameter, χ = φ + ψ the turn of what is printed on the face, (X, Y) the contact, ω1 = θ̇, ω2 = φ̇ sin θ, ω3 = ψ̇ + φ̇ cos θ along
 * e1 (horizontal), e2 (up the face from the contact) and e3 (the axis). The attitude is Rz(φ) Rx(θ) Rz(ψ).
 *
 * The motion ends where the disk lies flat, leaves the plane or, if thick, stands on its edge; afterwards its state stays that
 * of the end. Sources: O'Reilly, Nonlinear Dyn. 10 (1996) 287; Le Saux, Leine & Glocker, J. Nonlinear Sci. 15 (2005) 27.
 */
export class EulerDisk {
  /**
   * @param mass [kg], `radius` and `half_thickness` [m]; a thin disk has none
   * @param axial_moment C [kg m²]; by default that of a uniform cylinder
   * @param diametral_moment A [kg m²], about a diameter through the centre; by default likewise
   * @param gravity [m/s²]
   * @param dissipation list of laws as in a spec: {law: "air-layer", viscosity [Pa s]}; "boundary-layer" or
   *   "viscous-contour-friction" or "dry-contour-friction" with `coefficient`; "rolling-couple" or "drilling-friction" with `arm`
   * @param start eight numbers, `PARTS`, at the epoch
   * @param epoch time at which they hold [s]
   * @throws RangeError for values that cannot be these
   */
  constructor({ start, epoch = 0, ...parameters }) {
    const { disk, laws } = checkedDisk(parameters);
    const { m, a, b, A, C, g } = disk;
    this.moments = [A, A, C];
    this.onPlane = true; // space has an up of its own
    [this.radius, this.halfThickness] = [a, b];
    this.epoch = finite("epoch", epoch, "seconds");
    this.thin = b === 0;
    [this._disk, this._laws] = [disk, laws];
    this._legendre = this.thin && !laws.length ? new LegendreFunction((m * a * a * C) / (A * (C + m * a * a))) : null;
    const rate = Math.sqrt(g / a);
    this._motion = new Stepped({
      rates: this._rates(),
      start: [...checkedParts(start, this.thin), 0],
      time: this.epoch,
      scale: [NEARLY_FLAT, 1, 1, a, a, rate, rate, rate, m * g * a],
      tolerance: TOLERANCE,
      stops: this._stops(m * g),
    });
  }

  /**
   * Return the `start` of steady rolling at a tilt [rad], or with dissipation its place on the slow manifold, where no nutation
   * rings.
   *
   * @param parameters of the disk, as above
   * @param tilt θ [rad]
   * @param precession φ̇ [rad/s]; by default that at which the centre is at rest
   * @param spin ω3 [rad/s], which follows; needed only where it does not, as in straight rolling, and checked elsewhere
   * @throws RangeError where no such motion is steady and stable
   */
  static rollingStart({ tilt, precession = null, spin = null, heading = 0, face = 0, ...parameters }) {
    const { disk, laws } = checkedDisk(parameters);
    checkTilt(finite("tilt", tilt, "rad"), disk.b === 0);
    const rates = steadyRates(disk, tilt, precession, spin);
    return [tilt, heading, face, 0, 0, slowTiltRate(disk, laws, tilt, ...rates), ...rates];
  }

  _stops(weight) {
    const stops = {
      flat: (t, state) => Math.sin(state[0]) - FLAT,
      "lift-off": (t, state) => this._disk.normalForce(state[0], state[5], state[6], state[7]) / weight,
    };
    return this.thin ? stops : { ...stops, "on edge": (t, state) => Math.cos(state[0]) };
  }

  _rates() {
    const [disk, laws] = [this._disk, this._laws];
    return (t, state, out) => {
      const [theta, phi, w1, w2, w3] = [state[0], state[1], state[5], state[6], state[7]];
      const precession = w2 / Math.sin(theta);
      const along = w3 - precession * Math.cos(theta); // of the rim
      const [tau2, tau3] = couples(disk, laws, theta, w2, w3);
      const [push2, push3] = disk.accelerations(tau2, tau3);
      const [d2, d3] = disk.transport(theta, w2, w3);
      out[0] = w1;
      out[1] = precession;
      out[2] = w3 + 2 * precession * Math.sin(0.5 * theta) ** 2;
      out[3] = -disk.a * along * Math.cos(phi);
      out[4] = -disk.a * along * Math.sin(phi);
      out[5] = disk.tiltAcceleration(theta, w2, w3);
      out[6] = d2 * w1 + push2;
      out[7] = d3 * w1 + push3;
      out[8] = tau2 * w2 + tau3 * w3;
    };
  }

  /** Return {time, event} of the end after the epoch, or null as long as no state was asked for that lies beyond it. */
  get end() {
    return this._motion.end();
  }

  /**
   * Return {attitude, momentum, velocity Ω, energy, invariants, balances, contact [x, y] on the plane, center [x, y, z],
   * normalForce [N], tilt, heading, face [rad], parts (as `start`), ended: null or what ended the motion} at a time [s].
   *
   * Momentum is about the centre. A balance is {value, received}: their difference is constant.
   */
  state(t) {
    const elapsed = finite("t", t, "seconds");
    const [theta, phi, face, x, y, w1, w2, w3, received] = this._motion.at(elapsed);
    const disk = this._disk;
    const [s, c] = [Math.sin(theta), Math.cos(theta)];
    const [ex, ey, b] = [-Math.sin(phi), Math.cos(phi), disk.b];
    const psi = face - phi;
    const velocity = [Math.cos(psi) * w1 + Math.sin(psi) * w2, Math.cos(psi) * w2 - Math.sin(psi) * w1, w3];
    const energy = disk.energy(theta, w1, w2, w3);
    const end = this._motion.end(t >= this.epoch);
    return {
      attitude: attitudeOf(theta, phi, face),
      momentum: velocity.map((rate, k) => this.moments[k] * rate),
      velocity, energy, tilt: theta, heading: phi, face,
      invariants: this._invariants(energy, theta, w2, w3),
      balances: this._laws.length ? { energy: { value: energy, received } } : {},
      contact: [x, y],
      center: [x + ex * (disk.a * c - b * s), y + ey * (disk.a * c - b * s), disk.a * s + b * c],
      normalForce: disk.normalForce(theta, w1, w2, w3),
      parts: [theta, phi, face, x, y, w1, w2, w3],
      ended: end && Math.abs(t - this.epoch) >= Math.abs(end.time - this.epoch) ? end.event : null,
    }; // prettier-ignore
  }

  _invariants(energy, theta, w2, w3) {
    if (this._laws.length) return {};
    if (!this._legendre) return { energy };
    const [first, second] = linearIntegrals(this._legendre, this._disk, theta, w2, w3);
    return { energy, linear_integral_1: first, linear_integral_2: second };
  }
}

/** Return the laws of motion and of dissipation of a disk. */
function checkedDisk({ mass, radius, half_thickness = 0, axial_moment, diametral_moment, gravity = STANDARD_GRAVITY,
  dissipation = [] }) { // prettier-ignore
  const [m, a, g] = [positive("mass", mass, "kg"), positive("radius", radius, "m"), positive("gravity", gravity, "m/s²")];
  const b = positive("half_thickness", half_thickness, "m", true);
  if (b > a) throw new RangeError(`\`half_thickness\` must be at most the radius, ${a} m; got ${b}. Check units.`);
  const C = positive("axial_moment", axial_moment ?? 0.5 * m * a * a, "kg m²");
  const A = positive("diametral_moment", diametral_moment ?? m * (0.25 * a * a + (b * b) / 3), "kg m²");
  if (C > 2 * A * (1 + 1e-12)) {
    throw new RangeError(`\`axial_moment\` must be at most twice \`diametral_moment\`; got ${C} and ${A} kg m². Check units.`);
  }
  return { disk: new RollingMechanics({ m, a, b, A, C, g }), laws: checkedLaws(dissipation) };
}

function checkedParts(start, thin) {
  const state = vector("start", start, PARTS.length, `SI units: ${PARTS.join(", ")}`);
  checkTilt(state[0], thin);
  return state;
}

function checkTilt(tilt, thin) {
  const most = thin ? Math.PI : 0.5 * Math.PI;
  if (tilt > 0 && tilt < most && Math.sin(tilt) > FLAT) return;
  throw new RangeError(
    `the tilt at the start must lie between ${FLAT} rad and ${thin ? "π less that" : "π/2 for a thick disk"}; got ${tilt} ` +
      "rad. A disk that lies flat does not roll: start at a small tilt, such as 0.1.",
  );
}

/** Return Rz(φ) Rx(θ) Rz(χ − φ) as a quaternion. */
function attitudeOf(theta, phi, face) {
  const [s, c] = [Math.sin(0.5 * theta), Math.cos(0.5 * theta)];
  const [half, other] = [0.5 * face, phi - 0.5 * face];
  return [c * Math.cos(half), s * Math.cos(other), s * Math.sin(other), c * Math.sin(half)];
}
