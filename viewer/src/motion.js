// The motion as the page holds it: arrays of samples, and the state at any place between two of them.
import { Quaternion, Vector3 } from "three";
import { freeBetween } from "./free.js";

const CLOSE = 0.08; // rad the body turns between points of drawn curves: their lengths then agree to 1e-6
const MANY = 24000; // points of a curve
const KINDS = { f8: Float64Array, f4: Float32Array, u4: Uint32Array, u2: Uint16Array, u1: Uint8Array };

/** Return the typed array of {kind, shape, data}, or null. */
export function unpacked(field) {
  if (!field) return null;
  const text = atob(field.data);
  const bytes = new Uint8Array(text.length);
  for (let k = 0; k < text.length; k++) bytes[k] = text.charCodeAt(k);
  return new KINDS[field.kind](bytes.buffer);
}

export class Motion {
  constructor(data) {
    this.times = unpacked(data.times);
    this.attitudes = unpacked(data.attitude);
    this.momenta = unpacked(data.momentum);
    this.velocities = unpacked(data.velocity);
    this.energies = unpacked(data.energy);
    this.joined = data.joined;
    this.space = new Quaternion(data.space[1], data.space[2], data.space[3], data.space[0]);
    this.count = this.times.length;
    this.fastest = largestNorm(this.velocities);
    this.free = data.free; // principal moments of a body without torques, or null
    this.fine = this.finely();
  }

  /** Return how many pieces of a drawn curve one step between samples needs. */
  finely() {
    if (!this.joined || !this.free || !this.momenta) return 1;
    let longest = 0;
    for (let k = 1; k < this.count; k++) longest = Math.max(longest, this.times[k] - this.times[k - 1]);
    const wanted = Math.ceil((this.fastest * longest) / CLOSE);
    return Math.max(1, Math.min(wanted, Math.floor(MANY / this.count)));
  }

  /** Return the states at the points of drawn curves, `fine` for each step between samples. */
  get states() {
    this.dense ??= Array.from({ length: (this.count - 1) * this.fine + 1 }, (_, k) => this.at(k / this.fine));
    return this.dense;
  }

  get span() {
    return this.times[this.count - 1] - this.times[0];
  }

  /** Return the quaternion, body to space, of one sample. */
  attitude(k) {
    const [w, x, y, z] = this.attitudes.subarray(4 * k, 4 * k + 4);
    return new Quaternion(x, y, z, w);
  }

  /** Return the state at a position in samples, which need not be whole; null for what the motion does not have. */
  at(position) {
    const k = Math.min(Math.floor(position), this.count - 1);
    const part = this.joined && k + 1 < this.count ? position - k : 0;
    const mix = (values) => (part ? values[k] + part * (values[k + 1] - values[k]) : values[k]);
    const vector = (values) => {
      if (!values) return null;
      const here = new Vector3().fromArray(values, 3 * k);
      return part ? here.lerp(new Vector3().fromArray(values, 3 * k + 3), part) : here;
    };
    const state = {
      position: k + part,
      time: mix(this.times),
      attitude: this.attitudes ? this.attitude(k) : null,
      momentum: vector(this.momenta),
      velocity: vector(this.velocities),
      energy: this.energies ? mix(this.energies) : null,
    };
    if (part && this.free && this.momenta) Object.assign(state, this.freely(k, part));
    else if (part && this.attitudes) state.attitude.slerp(this.attitude(k + 1), part);
    return state;
  }

  /** Return attitude, L and Ω of a free body between two samples. */
  freely(k, part) {
    const [here, next] = [k, k + 1].map((j) => ({
      momentum: new Vector3().fromArray(this.momenta, 3 * j),
      attitude: this.attitudes ? this.attitude(j) : null,
    }));
    const found = freeBetween(this.free, here, next, this.times[k + 1] - this.times[k], part);
    const velocity = new Vector3(...this.free.map((moment, j) => found.momentum.getComponent(j) / moment));
    return { ...found, velocity: this.velocities ? velocity : null };
  }

  /** Return the position in samples of a time. */
  positionOf(time) {
    let low = 0;
    let high = this.count - 1;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (this.times[middle] <= time) low = middle;
      else high = middle;
    }
    if (time >= this.times[high]) return high;
    const step = this.times[high] - this.times[low];
    return low + (step > 0 ? Math.max(0, (time - this.times[low]) / step) : 0);
  }
}

function largestNorm(values) {
  let largest = 0;
  for (let k = 0; values && k < values.length; k += 3) {
    largest = Math.max(largest, Math.hypot(values[k], values[k + 1], values[k + 2]));
  }
  return largest;
}
