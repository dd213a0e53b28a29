// Where steady rolling starts, and how losses carry it from one steady motion to the next.
import { finite } from "../checking.js";
import { couples } from "./rolling_dissipation.js";

const STEADY = 1e-9; // of the accelerations: rates that miss it by more are no steady motion

/** Return [ω2, ω3] [rad/s] of steady motion at a tilt. */
export function steadyRates(disk, tilt, precession, spin) {
  const { m, a, b, A, C, g } = disk;
  const [s, c] = [Math.sin(tilt), Math.cos(tilt)];
  const weight = m * g * (a * c - b * s);
  let [turning, found] = [precession, spin];
  if (turning === null) {
    turning = Math.sqrt(weight / (A * s * c - (C * s * s * b) / a)); // the centre at rest
    if (!Number.isFinite(turning) || !(turning > 0)) {
      throw new RangeError(`no steady motion has its centre at rest at tilt ${tilt} rad. Give \`precession\`.`);
    }
    found ??= (turning * s * b) / a;
  }
  const w2 = finite("precession", turning, "rad/s") * s;
  found ??= (((A + m * b * b) * c + m * a * b * s) * s * turning ** 2 - weight) / (((C + m * a * a) * s + m * a * b * c) * turning);
  if (!Number.isFinite(found)) throw new RangeError("`spin` must be given where nothing precesses, as in straight rolling.");
  const left = disk.tiltAcceleration(tilt, w2, found);
  if (Math.abs(left) <= STEADY * (g / a + w2 * w2 + found * found)) return [w2, found];
  throw new RangeError(
    `tilt ${tilt} rad, \`precession\` ${turning} and \`spin\` ${found} rad/s are not steady: the tilt would accelerate by ` +
      `${left} rad/s². Give one of the rates only.`,
  );
}

/** Return the θ̇ with which the couples carry a steady motion to steady ones: d(θ̈)/dt = 0, to first order. */
export function slowTiltRate(disk, laws, tilt, w2, w3) {
  if (!laws.length) return 0;
  const [byTheta, byW2, byW3] = disk.tiltDerivatives(tilt, w2, w3);
  const [d2, d3] = disk.transport(tilt, w2, w3);
  const square = -(byTheta + byW2 * d2 + byW3 * d3); // of the nutation's frequency
  if (!(square > 0)) {
    throw new RangeError(`the steady motion at tilt ${tilt} rad is unstable: no slow manifold to start on. Give another tilt.`);
  }
  const [push2, push3] = disk.accelerations(...couples(disk, laws, tilt, w2, w3));
  return (byW2 * push2 + byW3 * push3) / square;
}
