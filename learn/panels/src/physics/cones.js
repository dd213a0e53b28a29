// The two cones of a body with an axis of symmetry.
import { FreeMotion } from "../../../../reference/polhode.js";
import { turnBetween } from "../lib/meshes.js";

export const EQUATORIAL = 1; // I1 = I2, kg m²
export const NORM = 2; // |L|, kg m²/s

/** Return the motion of a body with I3/I1 = ratio whose axis leans by a tilt [rad] from L; L points up in space. */
export function motionOf(ratio, tilt) {
  const momentum = [NORM * Math.sin(tilt), 0, NORM * Math.cos(tilt)];
  const attitude = turnBetween(momentum, [0, 0, 1]);
  return new FreeMotion({ moments: [EQUATORIAL, EQUATORIAL, ratio * EQUATORIAL], momentum, attitude });
}

/**
 * Return the half-angles [rad] of the cones that Ω describes round the axis and round L, and the rates [rad/s].
 *
 * `precession` is that of the axis round L, `inBody` that of Ω round the axis as the body sees it (positive: with the spin),
 * `own` the body's turn about its axis as seen by one who goes round with the axis, `size` |Ω|. From L = IΩ.
 */
export function conesOf(ratio, tilt) {
  const [across, along] = [(NORM * Math.sin(tilt)) / EQUATORIAL, (NORM * Math.cos(tilt)) / (ratio * EQUATORIAL)];
  const bodyCone = Math.atan2(across, along);
  return {
    bodyCone,
    spaceCone: Math.abs(bodyCone - tilt),
    precession: NORM / EQUATORIAL,
    inBody: (ratio - 1) * along,
    own: (1 - ratio) * along,
    size: Math.hypot(across, along),
  };
}

/** Return the half height over the radius of a homogeneous spheroid with I3/I1 = ratio. */
export const flatness = (ratio) => Math.sqrt(2 / ratio - 1);
