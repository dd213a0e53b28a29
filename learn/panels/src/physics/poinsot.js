// Poinsot's picture: the inertia ellipsoid xᵀ I x = 1 touches a plane across L at −Ω/√(2E), as on the page.
import { FreeMotion, quaternion } from "../../../../reference/polhode.js";
import { turnBetween } from "../lib/meshes.js";
import { times } from "../lib/vectors.js";
import { MOMENTS, momentumOf } from "./surfaces.js";

export const HALF_AXES = MOMENTS.map((moment) => 1 / Math.sqrt(moment)); // of the ellipsoid

/** Return the motion with this 2E [J] and |L| = 2 kg m²/s; L points up in space. */
export function motionOf(twiceEnergy) {
  const momentum = momentumOf(twiceEnergy);
  return new FreeMotion({ moments: MOMENTS, momentum, attitude: turnBetween(momentum, [0, 0, 1]) });
}

/** Return how far below the centre the plane lies: √(2E)/|L|. */
export const planeDistance = (motion) => Math.sqrt(2 * motion.energy) / motion.momentumNorm;

/** Return the contact at a time [s], in the body and in space. */
export function contactAt(motion, t) {
  const { attitude } = motion.state(t);
  const inBody = times(motion.angularVelocity(t), -1 / Math.sqrt(2 * motion.energy));
  return { attitude, inBody, inSpace: quaternion.rotate(attitude, inBody) };
}

/** Return the least and the greatest distance of the herpolhode from its middle. */
export function herpolhodeRadii(motion) {
  const place = (t) => Math.hypot(...contactAt(motion, t).inSpace.slice(0, 2));
  const ends = [place(0), place(motion.period / 4)]; // the motion starts where the contact turns back
  return [Math.min(...ends), Math.max(...ends)];
}

/** Return the herpolhode's radii and the plane's distance at a 2E [J]. */
export function numbersAt(twiceEnergy) {
  const motion = motionOf(twiceEnergy);
  return { radii: herpolhodeRadii(motion), distance: planeDistance(motion) };
}
