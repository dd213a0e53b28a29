// A rotor inside a body, seen turning.
import { CylinderGeometry, Group, Mesh, MeshLambertMaterial, Quaternion, Vector3 } from "three";
import { unpacked } from "./motion.js";
import { line } from "./shapes.js";

const [RADIUS, THICKNESS, REACH] = [0.45, 0.14, 1.2]; // of a body of size one; its axle reaches out of it
const SECTORS = 6; // of two shades, which show how it turns
const SHADE = 0.45; // of every other one
const UP = new Vector3(0, 1, 0); // along which three.js builds cylinders

/**
 * Return the wheel of a rotor as `object`, `turn(now)` that sets its angle, and `rate(now)` against the body [rad/s].
 *
 * @param motion samples, or what the page solves itself, whose solver then knows the rotor
 * @param data axis (3) along the body's, and rates at the samples, or null
 */
export function rotorOf(motion, data, theme) {
  const axis = new Vector3(...(motion.solver?.axis || data.axis)).normalize();
  const wheel = new Group();
  for (let k = 0; k < SECTORS; k++) {
    const part = new CylinderGeometry(RADIUS, RADIUS, THICKNESS, 12, 1, false, (2 * Math.PI * k) / SECTORS, (2 * Math.PI) / SECTORS);
    const material = new MeshLambertMaterial({ color: theme.rotor });
    if (k % 2) material.color.multiplyScalar(SHADE);
    wheel.add(new Mesh(part, material));
  }
  const lies = new Quaternion().setFromUnitVectors(UP, axis);
  const axle = axis.clone().multiplyScalar(REACH).toArray();
  const object = new Group().add(wheel, line([...axle.map((x) => -x), ...axle], theme.rotor, 2));
  const rates = ratesOf(motion, data);
  const angles = rates && integrated(motion.times, rates);
  const at = (values, { position }) => {
    const k = Math.min(Math.floor(position), values.length - 2);
    return k < 0 ? values[0] : values[k] + (position - k) * (values[k + 1] - values[k]);
  };
  const turn = (now) => {
    const angle = angles ? at(angles, now) : 0;
    wheel.quaternion.copy(lies).multiply(new Quaternion().setFromAxisAngle(UP, angle));
  };
  return { object, turn, rate: (now) => (rates ? at(rates, now) : null) };
}

function ratesOf(motion, data) {
  const solver = motion.solver;
  if (!solver?.rotorRate) return unpacked(data.rates);
  if (solver.rotorMoment === null) return null;
  const velocity = (k) => [0, 1, 2].map((j) => motion.velocities[3 * k + j]);
  return Float64Array.from({ length: motion.count }, (_, k) => solver.rotorRate(velocity(k)) ?? 0);
}

/** Return the angle at each of the times, from rates there. */
function integrated(times, rates) {
  const found = new Float64Array(rates.length);
  for (let k = 1; k < rates.length; k++) found[k] = found[k - 1] + 0.5 * (rates[k] + rates[k - 1]) * (times[k] - times[k - 1]);
  return found;
}
