// States of what turns: [w, x, y, z, then the momentum along the body's axes, then what a system has of its own].
import { finite, positiveMoments, unitQuaternion, vector } from "../checking.js";
import { normalize, rotate } from "../quaternion.js";

export const [ATTITUDE, MOMENTUM] = [0, 4]; // where they begin

/** Return what every body starts with, checked: moments, momentum, attitude, epoch. */
export function checkedStart({ moments, momentum, attitude = [1, 0, 0, 0], epoch = 0 }) {
  return {
    moments: positiveMoments(moments),
    momentum: vector("momentum", momentum, 3, "kg m²/s"),
    attitude: normalize(unitQuaternion(attitude)),
    epoch: finite("epoch", epoch, "seconds"),
  };
}

/** Return a unit vector along a direction of any length. */
export function direction(name, value) {
  const given = vector(name, value, 3, "any unit: only the direction counts");
  const largest = Math.max(...given.map(Math.abs));
  if (largest > 0) {
    const scaled = given.map((x) => x / largest);
    const size = Math.hypot(...scaled);
    return scaled.map((x) => x / size);
  }
  throw new RangeError(`\`${name}\` must have a direction; got [0, 0, 0]. Give three numbers that are not all 0.`);
}

/** Return a finite number that is positive, or with `zero` not negative. */
export function positive(name, value, unit, zero = false) {
  if (finite(name, value, unit) > 0 || (zero && value === 0)) return value;
  const rule = zero ? "not be negative" : "be positive";
  throw new RangeError(`\`${name}\` must ${rule}; got ${value}. Check its size, sign and unit, ${unit}.`);
}

/** Write dq/dt = ½ q (0, ω), with ω along the body's axes. */
export function turn(state, x, y, z, out) {
  const [w, a, b, c] = [state[0], state[1], state[2], state[3]]; // by number: arrays of floats are slow to iterate
  out[0] = -0.5 * (a * x + b * y + c * z);
  out[1] = 0.5 * (w * x + b * z - c * y);
  out[2] = 0.5 * (w * y + c * x - a * z);
  out[3] = 0.5 * (w * z + a * y - b * x);
}

/** Give the quaternion of a state its unit length back. */
export function renormalize(state) {
  const size = Math.sqrt(state[0] ** 2 + state[1] ** 2 + state[2] ** 2 + state[3] ** 2);
  for (let k = 0; k < 4; k++) state[k] /= size;
}

export const attitudeOf = (state) => Array.from(state.subarray(0, 4));
export const momentumOf = (state) => Array.from(state.subarray(4, 7));
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

/** Return what a body keeps on which no torque acts, but for its energy: |L|² and the momentum in space. */
export const keptWithoutTorque = (attitude, momentum) => ({
  "|L|²": dot(momentum, momentum),
  momentum_space: rotate(attitude, momentum),
});

/** Return the scales of a body's state: one for the attitude, and for momenta their size. */
export const scalesOf = (momentum, own = []) => [1, 1, 1, 1, momentum, momentum, momentum, ...own];
