// Cones with their apex where the body turns: swept out in space by Ω and by an axis, and in the body by Ω.
import { Group, Vector3 } from "three";
import { fan, line } from "../shapes.js";

const TURN = 2 * Math.PI;
const MOST = 1200; // triangles of a cone
const CLOSE = 0.35; // of the mean step from the first ray to the last within which a cone is closed
const NARROW = 0.02; // rad of its half-angle below which a cone is a line
const CONING = Math.PI / 4; // from L, within which an axis cones and does not tumble

/**
 * Return a cone through the ends of rays, of one turn about an axis only: more would lie on the same cone or cross it.
 *
 * @param rays points [x, y, z, …] that the rays end at
 * @param about unit vector that they go round
 * @return the object, and `halves`: least and largest angle [rad] of its rays from the axis; null of less than a line
 */
export function coneThrough(rays, about, color, opacity = 0.22) {
  const points = firstTurn(rays, about);
  const angles = [];
  for (let k = 0; k < points.length; k += 3) angles.push(new Vector3().fromArray(points, k).angleTo(about));
  const [low, high] = [Math.min(...angles), Math.max(...angles)];
  if (!(high > NARROW) || points.length < 9) return null;
  return { object: new Group().add(fan(points, color, opacity), line(points, color, 1.5)), halves: [low, high] };
}

/** Return the rays of the first turn about an axis, a part of them where they are many; closed if they come round. */
function firstTurn(rays, about) {
  const across = Math.abs(about.z) < 0.9 ? new Vector3(0, 0, 1) : new Vector3(1, 0, 0);
  const first = across.clone().cross(about).normalize();
  const second = about.clone().cross(first);
  const found = [];
  let [turned, last] = [0, null];
  const step = Math.max(1, Math.floor(rays.length / 3 / (20 * MOST)));
  for (let k = 0; k < rays.length && Math.abs(turned) < TURN; k += 3 * step) {
    const ray = new Vector3().fromArray(rays, k);
    const angle = Math.atan2(ray.dot(second), ray.dot(first));
    if (last !== null) turned += Math.atan2(Math.sin(angle - last), Math.cos(angle - last));
    last = angle;
    found.push(...ray.toArray());
  }
  const thinned = thin(found, Math.ceil(found.length / 3 / MOST));
  const gap = new Vector3().fromArray(thinned, 0).distanceTo(new Vector3().fromArray(thinned, thinned.length - 3));
  const mean = meanStep(thinned);
  if (Math.abs(turned) >= TURN - 1e-9 && gap < Math.max(CLOSE, 2) * mean) thinned.push(...thinned.slice(0, 3));
  return thinned;
}

function thin(points, every) {
  if (every <= 1) return points;
  const found = [];
  for (let k = 0; k < points.length; k += 3 * every) found.push(...points.slice(k, k + 3));
  return found;
}

function meanStep(points) {
  let length = 0;
  for (let k = 3; k < points.length; k += 3) length += Math.hypot(...[0, 1, 2].map((j) => points[k + j] - points[k - 3 + j]));
  return length / Math.max(1, points.length / 3 - 1);
}

/** Whether a free body's axis stays near L or its opposite for all of the motion's window, so that its cones are simple. */
export function isConing(motion, axis) {
  if (!motion.free || !motion.momenta) return false;
  for (let k = 0; k < motion.count; k++) {
    const L = new Vector3().fromArray(motion.momenta, 3 * k);
    const away = Math.atan2(L.clone().cross(axis).length(), Math.abs(L.dot(axis)));
    if (!(away < CONING)) return false;
  }
  return true;
}

/** Return the ends of Ω's arrow in space and in the body, and of an axis' in space, at the motion's points. */
export function sweptRays(motion, size, end) {
  const rays = { space: [], body: [], axis: [] };
  for (let k = 0; k < motion.count; k++) {
    const attitude = motion.attitude(k);
    rays.axis.push(...end.clone().applyQuaternion(attitude).applyQuaternion(motion.space).toArray());
    if (!motion.velocities) continue;
    const velocity = new Vector3().fromArray(motion.velocities, 3 * k).multiplyScalar(size);
    rays.body.push(...velocity.toArray());
    rays.space.push(...velocity.applyQuaternion(attitude).applyQuaternion(motion.space).toArray());
  }
  return rays;
}
