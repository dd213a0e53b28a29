// A motion that the page solves itself, exactly, at any time: it looks like samples, but goes on for ever.
import { Quaternion, Vector3 } from "three";
import { FreeMotion } from "../../reference/polhode.js";

const CLOSE = 0.08; // rad the body turns between points of drawn curves: their lengths then agree to 1e-6
const TURNS = 8; // of the body in a window, where nothing else says how long it is
const [FEWEST, MOST] = [400, 3000]; // points in a window
const CURVE = 24000; // points of a drawn curve
const FINEST = 16 * Number.EPSILON; // of a time: points nearer than that have hardly times of their own
const KEPT = 0.5; // of a window that stays when the next begins, so that traces do not vanish all at once

const quaternion = ([w, x, y, z]) => new Quaternion(x, y, z, w);

export class SolvedMotion {
  /**
   * @param solver with moments, epoch, state(t) → {attitude, momentum}, and what it conserves
   * @param times of the window's points [s], even; without them a window that shows some turns
   * @param space quaternion (w, x, y, z) that turns space for the picture; by default L, or z under gravity, points up
   */
  constructor(solver, times = null, space = null) {
    this.solver = solver;
    this.moments = solver.moments;
    this.free = solver instanceof FreeMotion ? solver.moments : null; // principal moments of a body without torques
    this.hasUp = solver.mgl !== undefined || Boolean(solver.onPlane);
    this.endless = true;
    this.joined = true;
    this.times = times?.length ? times : this.window(solver.epoch);
    this.count = this.times.length;
    this.space = space ? quaternion(space) : this.upright();
    this.fill();
    // pieces of a drawn curve from one point of the window to the next
    this.fine = Math.max(1, Math.min(Math.ceil((this.fastest * this.span) / (CLOSE * (this.count - 1 || 1))), Math.floor(CURVE / this.count)));
  }

  /** Return the times of a window that begins here. */
  window(start) {
    // a top that hangs still would swing, if it were pushed, at its own rate
    const swing = this.solver.mgl ? 0.1 * Math.sqrt(Math.abs(this.solver.mgl) / Math.max(...this.moments)) : 0;
    const speed = Math.max(this.speedAt(start), swing) || 1;
    const span = this.solver.wanted ?? windowOf(this.solver, speed);
    if (!(span > 0 && Number.isFinite(span * speed))) leaves();
    const count = Math.max(FEWEST, Math.min(MOST, Math.ceil((span * speed) / CLOSE) + 1));
    return Float64Array.from({ length: count }, (_, k) => start + (span * k) / (count - 1));
  }

  speedAt(time) {
    return Math.hypot(...this.solved(time).velocity);
  }

  /** Return the turn of space after which L points up, or z where there is gravity. */
  upright() {
    if (this.hasUp) return new Quaternion();
    const { attitude, momentum } = this.solver.state(this.solver.epoch);
    const inSpace = new Vector3(...momentum).applyQuaternion(quaternion(attitude));
    return inSpace.length() > 0 ? new Quaternion().setFromUnitVectors(inSpace.normalize(), new Vector3(0, 0, 1)) : new Quaternion();
  }

  /** Solve at every point of the window. */
  fill() {
    this.attitudes = new Float64Array(4 * this.count);
    this.momenta = new Float64Array(3 * this.count);
    this.velocities = new Float64Array(3 * this.count);
    this.energies = new Float64Array(this.count);
    this.fastest = 0;
    let largest = 0; // |L|
    this.dense = null;
    for (let k = 0; k < this.count; k++) {
      const { attitude, momentum, velocity, energy } = this.solved(this.times[k]);
      this.attitudes.set(attitude, 4 * k);
      this.momenta.set(momentum, 3 * k);
      this.velocities.set(velocity, 3 * k);
      this.fastest = Math.max(this.fastest, Math.hypot(...velocity));
      this.energies[k] = energy;
      largest = Math.max(largest, Math.hypot(...momentum));
    }
    if (!hasSquare(largest) || !hasSquare(this.fastest)) leaves();
    for (const values of [this.times, this.attitudes, this.momenta, this.velocities, this.energies]) if (!values.every(Number.isFinite)) leaves();
  }

  /** Return what the solver says of a time, with Ω and the energy, which steppers say themselves. */
  solved(time) {
    const found = this.solver.state(time);
    if (found.velocity) return found;
    const velocity = found.momentum.map((value, k) => value / this.moments[k]);
    const turning = 0.5 * found.momentum.reduce((sum, value, k) => sum + value * velocity[k], 0);
    const [w, x, y, z] = found.attitude;
    return { ...found, velocity, energy: this.hasUp ? turning + this.solver.mgl * (w * w - x * x - y * y + z * z) : turning };
  }

  /** Return the states at the points of drawn curves. */
  get states() {
    this.dense ??= Array.from({ length: (this.count - 1) * this.fine + 1 }, (_, k) => this.at(k / this.fine));
    return this.dense;
  }

  get span() {
    return this.times[this.count - 1] - this.times[0];
  }

  attitude(k) {
    return quaternion(this.attitudes.subarray(4 * k, 4 * k + 4));
  }

  /** Return the state at a position in points, solved there if it lies between two of them. */
  at(position) {
    const k = Math.min(Math.floor(position), this.count - 1);
    const part = k + 1 < this.count ? position - k : 0;
    const time = part ? this.times[k] + part * (this.times[k + 1] - this.times[k]) : this.times[k];
    return { position: k + part, ...this.solvedAt(time) };
  }

  /** Return the state at any time. */
  solvedAt(time) {
    const { attitude, momentum, velocity, energy } = this.solved(time);
    return {
      time,
      attitude: quaternion(attitude),
      momentum: new Vector3(...momentum),
      velocity: new Vector3(...velocity),
      energy,
    };
  }

  /** Return the position in points of a time inside the window. */
  positionOf(time) {
    const part = this.span > 0 ? (time - this.times[0]) / this.span : 0;
    return Math.min(this.count - 1, Math.max(0, part * (this.count - 1)));
  }

  /** Return the same motion in a window that a time lies in, a part of the present one still in it where that can be. */
  around(time) {
    const [first, last] = [this.times[0], this.times[this.count - 1]];
    if (time >= first && time <= last) return this;
    const start = time > last && time < last + (1 - KEPT) * this.span ? last - KEPT * this.span : time - KEPT * this.span;
    const step = this.span / (this.count - 1);
    if (!(step >= FINEST * Math.max(Math.abs(start), Math.abs(time)))) {
      throw new RangeError(`t must be within ${(step / FINEST).toPrecision(1)} s, beyond which the points of this picture, ${step.toPrecision(2)} s apart, have hardly times of their own; got ${time}. Give a nearer time.`);
    }
    const times = this.times.map((_, k) => start + k * step);
    const { w, x, y, z } = this.space;
    return new SolvedMotion(this.solver, times, [w, x, y, z]);
  }
}

/** Whether a size is zero, or its square, which pictures divide by, a normal double. */
const hasSquare = (size) => size === 0 || (size * size > Number.MIN_VALUE / Number.EPSILON && Number.isFinite(size * size));

function leaves() {
  throw new RangeError("A number leaves double precision on the way to the picture. Give numbers, in SI units, that are nearer to one.");
}

/** Return how long a window should be [s]: some turns, and at least two periods of what the axis does. */
function windowOf(solver, speed) {
  const turns = (TURNS * 2 * Math.PI) / speed;
  const period = solver.period ?? solver.nutationPeriod ?? null;
  return period !== null && Number.isFinite(period) ? Math.max(turns, Math.min(2.2 * period, 12 * turns)) : turns;
}
