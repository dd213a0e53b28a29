// The motion as the page holds it: arrays of samples, and the state at any place between two of them.
import { Quaternion, Vector3 } from "three";

const KINDS = { f8: Float64Array, f4: Float32Array, u4: Uint32Array, u2: Uint16Array };

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
    let attitude = null;
    if (this.attitudes) {
      attitude = this.attitude(k);
      if (part) attitude.slerp(this.attitude(k + 1), part);
    }
    return {
      position: k + part,
      time: mix(this.times),
      attitude,
      momentum: vector(this.momenta),
      velocity: vector(this.velocities),
      energy: this.energies ? mix(this.energies) : null,
    };
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
