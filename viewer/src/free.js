// A free body between two samples. L follows a cubic with dL/dt = L × Ω at both ends and stays at its size and energy; the
// attitude follows a cubic with Ω at both ends and keeps L in its place in space. So the ellipsoid touches its plane at
// every moment, and not only at the samples.
import { Quaternion, Vector3 } from "three";

const ROUNDS = 4; // of Newton, which begins 1e-5 away
const FLAT = 1e-13; // where sphere and ellipsoid of L are tangent to each other, size alone is kept

const blend = (a, b, u, v, t) => {
  // the cubic of values a, b and slopes u, v at t = 0 and 1
  const s = 1 - t;
  return a
    .clone()
    .multiplyScalar(s * s * (1 + 2 * t))
    .addScaledVector(b, t * t * (3 - 2 * t))
    .addScaledVector(u, t * s * s)
    .addScaledVector(v, -t * t * s);
};
const mixed = (a, b, t) => a + t * (b - a);

/**
 * Return L (body axes) and the attitude at a part of the step from one state to the next.
 *
 * @param moments principal moments [kg m²]
 * @param here {momentum, attitude} at the step's start; attitude may be null
 * @param next the same at its end
 * @param step its duration [s]
 * @param part from 0 to 1
 */
export function freeBetween(moments, here, next, step, part) {
  const spin = (momentum) => new Vector3(...moments.map((moment, k) => momentum.getComponent(k) / moment));
  const [first, last] = [spin(here.momentum), spin(next.momentum)];
  const slope = (momentum, velocity) => momentum.clone().cross(velocity).multiplyScalar(step);
  const guess = blend(here.momentum, next.momentum, slope(here.momentum, first), slope(next.momentum, last), part);
  const momentum = kept(moments, here.momentum, next.momentum, guess, part);
  if (!here.attitude) return { momentum, attitude: null };
  const attitude = between(here.attitude, next.attitude, first.multiplyScalar(step), last.multiplyScalar(step), part);
  const inSpace = here.momentum.clone().applyQuaternion(here.attitude);
  inSpace.lerp(next.momentum.clone().applyQuaternion(next.attitude), part).normalize();
  const found = momentum.clone().applyQuaternion(attitude).normalize();
  return { momentum, attitude: new Quaternion().setFromUnitVectors(found, inSpace).multiply(attitude) };
}

/** Return the vector near `guess` whose size and energy lie between those of both ends, which are equal but for rounding. */
function kept(moments, a, b, guess, part) {
  const size = mixed(a.length(), b.length(), part);
  if (!(size > 0)) return guess;
  const least = Math.min(...moments);
  const weights = new Vector3(...moments.map((moment) => least / moment));
  const energy = (u) => u.clone().multiply(weights).dot(u);
  const wanted = mixed(energy(a.clone().divideScalar(size)), energy(b.clone().divideScalar(size)), part);
  const u = guess.clone().divideScalar(size);
  for (let round = 0; round < ROUNDS; round++) {
    const w = u.clone().multiply(weights);
    const [uu, uw, ww] = [u.dot(u), u.dot(w), w.dot(w)];
    const flat = uu * ww - uw * uw;
    if (flat < FLAT) return u.normalize().multiplyScalar(size);
    const [misses, lacks] = [0.5 * (1 - uu), 0.5 * (wanted - uw)];
    u.addScaledVector(u.clone(), (misses * ww - lacks * uw) / flat).addScaledVector(w, (lacks * uu - misses * uw) / flat);
  }
  return u.multiplyScalar(size);
}

/** Return the attitude whose rotation vector from the first one, in the body, is a cubic with the given turns as slopes. */
function between(a, b, first, last, part) {
  const turn = a.clone().invert().multiply(b);
  if (turn.w < 0) turn.set(-turn.x, -turn.y, -turn.z, -turn.w);
  const axis = new Vector3(turn.x, turn.y, turn.z);
  const sine = axis.length();
  const angle = 2 * Math.atan2(sine, turn.w);
  const whole = axis.multiplyScalar(sine > 0 ? angle / sine : 2);
  // the vector's rate is the inverse of the rotation's right Jacobian times Ω
  const bend = angle > 1e-3 ? 1 / angle ** 2 - 1 / (2 * angle * Math.tan(angle / 2)) : 1 / 12;
  const across = whole.clone().cross(last);
  const end = last.clone().addScaledVector(across, 0.5).addScaledVector(whole.clone().cross(across), bend);
  const found = blend(new Vector3(), whole, first, end, part);
  const reach = found.length();
  return reach > 0 ? a.clone().multiply(new Quaternion().setFromAxisAngle(found.divideScalar(reach), reach)) : a.clone();
}
