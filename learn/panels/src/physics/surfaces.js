// Free rotation of one body with a given |L| and energy.
import { FreeMotion } from "../../../../reference/polhode.js";

export const MOMENTS = [1, 2, 3]; // kg m²
export const NORM = 2; // |L|, kg m²/s
export const LEAST = NORM ** 2 / MOMENTS[2]; // 2E, J: L along axis 3
export const MOST = NORM ** 2 / MOMENTS[0]; // L along axis 1
export const CROSSING = NORM ** 2 / MOMENTS[1]; // along axis 2: there the polhodes cross

/** Return the momentum in the plane of axes 1 and 3 that has |L| = NORM and this 2E [J]. */
export function momentumOf(twiceEnergy) {
  const [low, high] = [1 / MOMENTS[2], 1 / MOMENTS[0]];
  const share = Math.min(1, Math.max(0, (twiceEnergy / NORM ** 2 - low) / (high - low)));
  return [NORM * Math.sqrt(share), 0, NORM * Math.sqrt(1 - share)];
}

/** Return {motion, regime, period [s], cap [sr]: the solid angle that the polhode cuts off} for a 2E [J]. */
export function motionAt(twiceEnergy) {
  const motion = new FreeMotion({ moments: MOMENTS, momentum: momentumOf(twiceEnergy) });
  // no float has the square of a component on the separatrix, but the energy asked for is exactly that of it
  if (twiceEnergy === CROSSING) return { motion, regime: "separatrix", period: Infinity, cap: null };
  return { motion, regime: motion.regime, period: motion.period, cap: motion.solidAngle };
}

/** Return points of the polhode through a momentum, closed. */
export function polhode(motion, count) {
  const points = motion.along(count);
  return [...points, points[0]];
}
