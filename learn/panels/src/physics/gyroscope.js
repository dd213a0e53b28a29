// A toy gyroscope on its stand: a Lagrange top that is let go leaning, with a push.
import { LagrangeMotion } from "../../../../reference/polhode.js";
import { quaternion } from "../../../../reference/polhode.js";
import { cross, times } from "../lib/vectors.js";

export const GRAVITY = 9.80665; // m/s²
export const WHEEL = { mass: 0.12, radius: 0.028, arm: 0.035 }; // kg, m, m from the pivot: a brass ring, all of it at its rim
const { mass, radius, arm } = WHEEL;
export const AXIAL = mass * radius ** 2; // I3, kg m²
export const TRANSVERSE = 0.5 * mass * radius ** 2 + mass * arm ** 2; // I1 about the pivot
export const MGL = mass * GRAVITY * arm; // N m

/** Return the slower rate [rad/s] of steady precession at a lean [rad], or for slow spins the rate mgl/L3 of a fast top. */
export function steadyRate(lean, spin) {
  const L3 = AXIAL * spin;
  const under = L3 * L3 - 4 * TRANSVERSE * MGL * Math.cos(lean);
  return under < 0 ? MGL / L3 : (2 * MGL) / (L3 + Math.sqrt(under));
}

/** Return the motion of the top let go at a lean [rad] with a spin ω3 [rad/s], and pushed to so much of its steady rate. */
export function motionOf(lean, spin, push) {
  const rate = push * steadyRate(lean, spin);
  return new LagrangeMotion({
    moments: [TRANSVERSE, TRANSVERSE, AXIAL],
    mgl: MGL,
    momentum: [0, TRANSVERSE * rate * Math.sin(lean), AXIAL * spin],
    attitude: [Math.cos(lean / 2), Math.sin(lean / 2), 0, 0],
  });
}

/** Return, in space, the axis, L [kg m²/s], the weight [N] and its torque about the pivot [N m] at a time [s]. */
export function vectorsAt(motion, t) {
  const { attitude, momentum } = motion.state(t);
  const axis = quaternion.rotate(attitude, [0, 0, 1]);
  const weight = [0, 0, -mass * GRAVITY];
  return { attitude, axis, momentum: quaternion.rotate(attitude, momentum), weight, torque: cross(times(axis, arm), weight) };
}
