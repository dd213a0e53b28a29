// The arrows of a body's picture: L and Ω from where it turns, a top's weight from its centre of mass, and the torque.
import { Vector3 } from "three";
import { arrow } from "../shapes.js";
import { isOn, switched } from "../switches.js";

const LONGEST = 1.36; // of L and of the largest Ω
const [HANGING, TURNING] = [0.6, 0.85]; // lengths of a weight, and of its largest torque
const DOWN = new Vector3(0, 0, -1);

/**
 * Return the arrows of a motion as `objects`, `entries` of the legend, `show(now)` and `labels()`.
 *
 * @param weight where a top's centre of mass is drawn, in body axes and the picture's unit; null of what has no weight
 */
export function vectorsOf(motion, weight, theme) {
  const most = largest(motion.momenta);
  const found = [];
  const add = (text, words, color, thickness, lengthOf, label = 1.1) => found.push({ entry: switched(text, color, words), text, arrow: arrow(color, thickness), lengthOf, label, from: null });
  if (motion.momenta) add("L", "L", theme.momentum, 0.02, (now) => inSpace(motion, now.momentum, now, LONGEST / most), 1.08);
  if (motion.velocities) add("Ω", "Ω", theme.velocity, 0.017, (now) => inSpace(motion, now.velocity, now, LONGEST / motion.fastest), 1.16);
  if (weight) {
    const arm = new Vector3(...weight);
    const place = (now) => arm.clone().applyQuaternion(now.attitude).applyQuaternion(motion.space);
    const length = arm.length();
    add("mg", "weight mg", theme.weight, 0.017, () => DOWN.clone().multiplyScalar(HANGING));
    found.at(-1).from = place;
    add("τ", "torque of the weight, dL/dt", theme.torque, 0.017, (now) => place(now).cross(DOWN).multiplyScalar(TURNING / length));
  }
  const show = (now) => {
    for (const one of found) {
      const vector = one.lengthOf(now);
      const length = isOn(one.entry) && Number.isFinite(vector.lengthSq()) ? vector.length() : 0;
      if (length > 0) one.arrow.point(vector, length);
      else one.arrow.visible = false;
      if (one.from) one.arrow.position.copy(one.from(now));
    }
  };
  const labels = () =>
    found
      .filter((one) => one.arrow.visible)
      .map((one) => ({ text: one.text, color: one.entry.color, place: one.arrow.userData.tip.clone().multiplyScalar(one.label).add(one.arrow.position) }));
  const probe = () => Object.fromEntries(found.map((one) => [one.text, one.arrow.visible ? { tip: one.arrow.userData.tip.toArray(), from: one.arrow.position.toArray() } : null]));
  return { objects: found.map((one) => one.arrow), entries: found.map((one) => one.entry), show, labels, probe };
}

/** Return a vector of the body as it stands in the picture. */
const inSpace = (motion, vector, now, scale) => vector.clone().applyQuaternion(now.attitude).applyQuaternion(motion.space).multiplyScalar(Number.isFinite(scale) ? scale : 0);

/** Return the length of Ω's arrow for each rad/s, so that a cone's rim runs through its tip. */
export const lengthPerRate = (motion) => (motion.fastest ? LONGEST / motion.fastest : 0);

function largest(values) {
  let found = 0;
  for (let k = 0; values && k < values.length; k += 3) found = Math.max(found, Math.hypot(values[k], values[k + 1], values[k + 2]));
  return found;
}
