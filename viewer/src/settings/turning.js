// What all bodies that spin are set by: three moments, and the size and direction of Ω at first.
import { exact } from "../numbers.js";
import { ascending } from "../polhodes.js";
import { say } from "../say.js";

const RPM = Math.PI / 30;
const DEGREE = Math.PI / 180;

/** Return size, tilt from an axis and azimuth about it, from the next axis cyclically, of an angular velocity. */
export function angles(velocity, about) {
  const [along, next, last] = [0, 1, 2].map((k) => velocity[(about + k) % 3]);
  return { rate: Math.hypot(...velocity), tilt: Math.atan2(Math.hypot(next, last), along), around: next || last ? Math.atan2(last, next) : 0 };
}

export function velocityOf(about, { rate, tilt, around }) {
  const found = [0, 0, 0];
  found[about] = rate * Math.cos(tilt);
  found[(about + 1) % 3] = rate * Math.sin(tilt) * Math.cos(around);
  found[(about + 2) % 3] = rate * Math.sin(tilt) * Math.sin(around);
  return found;
}

/** The keys of a spec that all of these take, with how many numbers each has. */
export const SPIN_KEYS = { rate: 1, about: 1, tilt: 1, angular_velocity: 3, momentum: 3, attitude: 4 };

/** Return numbers as a spec writes a list of them. */
export const tomlList = (values, unit) => `[${values.map((value) => `"${exact(value)} ${unit}"`).join(", ")}]`;

/** Return the axis nearest to a vector. */
export const nearestAxis = (vector) => vector.map(Math.abs).reduce((best, value, k, all) => (value > all[best] ? k : best), 0);

/** Return the sliders of the moments. */
export const momentControls = (moments) =>
  moments.map((value, k) => ({ key: `body.moments.${k}`, label: say("moment of inertia I{axis}", { axis: "₁₂₃"[k] }), unit: "kg m²", value, ...allowed(moments, k) }));

/** Return the range of one moment, given the two others: no solid body has moments outside of it. */
function allowed(moments, k) {
  const [a, b] = [moments[(k + 1) % 3], moments[(k + 2) % 3]];
  const [least, most] = [Math.abs(a - b), a + b];
  return { low: Math.max(least, 1e-3 * most), high: most, log: true };
}

/** Return the sliders of the spin. */
export function spinControls({ velocity, about, around }) {
  const { rate, tilt } = angles(velocity, about);
  const slow = rate < 1e-3 * RPM || rate > 1e6 * RPM;
  return [
    { key: "spin.rate", label: "spin rate |Ω|", unit: slow ? "rad/s" : "rpm", si: slow ? 1 : RPM, value: rate, log: true, low: rate / 20 || 0.1, high: 20 * rate || 100 },
    { key: "spin.about", label: "tilt counted from", value: about, choices: [0, 1, 2].map((k) => [k, say("axis {axis}", { axis: k + 1 })]) },
    { key: "spin.tilt", label: "tilt of the spin", unit: "°", si: DEGREE, value: tilt, low: 0, high: Math.PI, power: 2 },
    { key: "spin.around", label: say("tilted towards (0° is axis {axis})", { axis: ((about + 1) % 3) + 1 }), unit: "°", si: DEGREE, value: tilt > 0 ? angles(velocity, about).around : around, low: -Math.PI, high: Math.PI },
  ];
}

/** Return the setting after a slider of moments or spin has moved; values in SI. */
export function turned(setting, key, value) {
  const [, name, index] = key.split(".");
  if (name === "moments") {
    const moments = setting.moments.map((old, k) => (k === Number(index) ? value : old));
    return { ...setting, moments, momentum: null };
  }
  if (name === "about") return { ...setting, about: value, around: angles(setting.velocity, value).around };
  const now = { ...angles(setting.velocity, setting.about) };
  if (!(now.tilt > 0)) now.around = setting.around;
  now[name] = value;
  return { ...setting, velocity: velocityOf(setting.about, now), around: now.around, momentum: null };
}

/** Return the setting with what tables of a spec say of moments and spin, in SI; `inner` is the momentum of what turns inside. */
export function withTables(setting, { body = {}, spin = {} }, inner = [0, 0, 0]) {
  let found = { ...setting };
  if (body.moments) found = { ...found, moments: ofABody(body.moments), momentum: null };
  if (spin.attitude) found.attitude = spin.attitude.map(Number);
  if (spin.momentum) {
    const momentum = spin.momentum.map(Number);
    const velocity = momentum.map((value, k) => (value - inner[k]) / found.moments[k]);
    return { ...found, momentum, velocity, around: angles(velocity, found.about).around };
  }
  if (spin.angular_velocity) {
    const velocity = spin.angular_velocity.map(Number);
    return { ...found, momentum: null, velocity, around: angles(velocity, found.about).around };
  }
  if (["rate", "about", "tilt"].every((name) => spin[name] === undefined)) return found;
  if (spin.about !== undefined && ![1, 2, 3].includes(spin.about)) throw new RangeError(`spin.about must be 1, 2 or 3, a principal axis; got ${spin.about}.`);
  // a spec counts principal axes by ascending moments, and tilts towards the next of them
  const frame = principalFrame(found.moments);
  const about = spin.about === undefined ? frame.findIndex((axis) => axis[found.about] !== 0) : spin.about - 1;
  const old = angles(frame.map((axis) => dot(axis, found.velocity)), about);
  const now = { rate: spin.rate ?? old.rate, tilt: spin.tilt ?? old.tilt, around: spin.tilt === undefined ? old.around : 0 };
  const along = velocityOf(about, now);
  const velocity = [0, 1, 2].map((k) => frame.reduce((sum, axis, j) => sum + axis[k] * along[j], 0));
  const place = frame[about].findIndex((value) => value !== 0);
  return { ...found, about: place, around: angles(velocity, place).around, momentum: null, velocity };
}

const dot = (a, b) => a.reduce((sum, value, k) => sum + value * b[k], 0);

/** Return the principal axes of ascending moments, right-handed, along those in the given order. */
function principalFrame(moments) {
  const order = ascending(moments);
  const odd = (order[1] - order[0]) * (order[2] - order[0]) * (order[2] - order[1]) < 0;
  return order.map((k, j) => [0, 1, 2].map((i) => (i === k ? (odd && j === 2 ? -1 : 1) : 0)));
}

/** Return the moments, or throw for those that no body has. */
function ofABody(moments) {
  const sum = moments[0] + moments[1] + moments[2];
  if (moments.every((value) => value > 0 && 2 * value <= sum * (1 + 1e-9))) return moments;
  throw new RangeError(`Moments must be positive and satisfy I1 + I2 ≥ I3; got ${moments.join(", ")} kg m². No rigid body has these.`);
}

/** Return the momentum at the start: as it was given, to the last bit, or IΩ and what turns inside. */
export const momentumOf = ({ moments, velocity, momentum }, inner = [0, 0, 0]) =>
  momentum ?? velocity.map((value, k) => value * moments[k] + inner[k]);

const [WATCHED, PER_TURN] = [60, 24]; // turns of the body that an axis is watched for, and times in each

/**
 * Return how an axis moves about another, from states that the solver knows: least and largest angle between them [rad],
 * the mean time between its largest angles [s], null if it does not swing, and the mean rate at which it goes round [rad/s].
 *
 * @param solver with state(time) and epoch
 * @param towards returns the axis in space at a state, a unit vector
 * @param up unit vector in space
 */
export function watchAxis(solver, towards, up = [0, 0, 1]) {
  const first = solver.state(solver.epoch);
  const step = (2 * Math.PI) / (Math.hypot(...first.velocity) || 1) / PER_TURN;
  const [across, beside] = crossedBy(up);
  const [leans, rounds] = [[], []]; // angles from `up`, and about it, counted on
  let [round, last] = [0, null];
  const count = WATCHED * PER_TURN;
  for (let k = 0; k <= count; k++) {
    const axis = towards(solver.state(solver.epoch + k * step));
    const [x, y, z] = [across, beside, up].map((one) => dot(one, axis));
    leans.push(Math.atan2(Math.hypot(x, y), z));
    const angle = Math.atan2(y, x);
    if (last !== null) round += Math.atan2(Math.sin(angle - last), Math.cos(angle - last));
    last = angle;
    rounds.push(round);
  }
  const [least, most] = [Math.min(...leans), Math.max(...leans)];
  const tops = maxima(leans);
  const [from, to, nods] = tops.length > 1 ? [tops[0], tops.at(-1), tops.length - 1] : [0, count, null];
  // over whole nods, as it goes round faster and slower in each
  const around = (between(rounds, to) - between(rounds, from)) / ((to - from) * step);
  return { least, most, swing: nods ? ((to - from) * step) / nods : null, around };
}

const between = (values, place) => {
  const k = Math.min(Math.floor(place), values.length - 2);
  return values[k] + (place - k) * (values[k + 1] - values[k]);
};

/** Return where evenly spaced values are at their maxima, by parabolas through three of them. */
function maxima(values) {
  const tops = [];
  for (let k = 1; k + 1 < values.length; k++) {
    const [a, b, c] = [values[k - 1], values[k], values[k + 1]];
    if (b > a && b >= c && a - 2 * b + c < 0) tops.push(k + (0.5 * (a - c)) / (a - 2 * b + c));
  }
  return tops;
}

/** Return two unit vectors that form a right-handed frame with a third. */
function crossedBy([a, b, c]) {
  const other = Math.abs(c) < 0.9 ? [0, 0, 1] : [1, 0, 0];
  const first = [other[1] * c - other[2] * b, other[2] * a - other[0] * c, other[0] * b - other[1] * a];
  const size = Math.hypot(...first);
  const [x, y, z] = first.map((value) => value / size);
  return [[x, y, z], [b * z - c * y, c * x - a * z, a * y - b * x]];
}

/** Return a vector of the body as it stands in space. */
export function toSpace([w, x, y, z], [a, b, c]) {
  const [p, q, r] = [2 * (y * c - z * b), 2 * (z * a - x * c), 2 * (x * b - y * a)];
  return [a + w * p + y * r - z * q, b + w * q + z * p - x * r, c + w * r + x * q - y * p];
}
