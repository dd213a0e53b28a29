// A free body as sliders set it: three moments, and how it spins at first.
import { FreeMotion } from "../../../reference/polhode.js";
import { ascending } from "../polhodes.js";
import { clock, exact, worded } from "../numbers.js";

const RPM = Math.PI / 30;
const DEGREE = Math.PI / 180;
const [CONING, FLIPPING, SWINGING] = [45, 60, 20]; // degrees of the cone's half-angle, and of its swing
const DWELLING = 0.995; // modulus from which L dwells at the intermediate axis

/** Return the setting of what Python wrote down: moments, momentum and attitude along the principal axes. */
export function from(model) {
  const { moments, momentum, attitude = [1, 0, 0, 0], epoch = 0 } = model;
  const velocity = momentum.map((value, k) => value / moments[k]);
  const about = velocity.map(Math.abs).reduce((best, value, k, all) => (value > all[best] ? k : best), 0);
  return { moments, velocity, attitude, epoch, about, around: angles(velocity, about).around, momentum };
}

/** Return size, tilt from an axis and azimuth about it, from the next axis cyclically, of an angular velocity. */
function angles(velocity, about) {
  const [along, next, last] = [0, 1, 2].map((k) => velocity[(about + k) % 3]);
  return { rate: Math.hypot(...velocity), tilt: Math.atan2(Math.hypot(next, last), along), around: next || last ? Math.atan2(last, next) : 0 };
}

function velocityOf(about, { rate, tilt, around }) {
  const found = [0, 0, 0];
  found[about] = rate * Math.cos(tilt);
  found[(about + 1) % 3] = rate * Math.sin(tilt) * Math.cos(around);
  found[(about + 2) % 3] = rate * Math.sin(tilt) * Math.sin(around);
  return found;
}

/** Return what the sliders show. */
export function controls(setting) {
  const { moments, velocity, about, around } = setting;
  const { rate, tilt } = angles(velocity, about);
  const slow = rate < 1e-3 * RPM || rate > 1e6 * RPM;
  return [
    ...moments.map((value, k) => ({ key: `body.moments.${k}`, label: `moment of inertia I${"₁₂₃"[k]}`, unit: "kg m²", value, ...allowed(moments, k) })),
    { key: "spin.rate", label: "spin rate |Ω|", unit: slow ? "rad/s" : "rpm", si: slow ? 1 : RPM, value: rate, log: true, low: rate / 20 || 0.1, high: 20 * rate || 100 },
    { key: "spin.about", label: "tilt counted from", value: about, choices: [0, 1, 2].map((k) => [k, `axis ${k + 1}`]) },
    { key: "spin.tilt", label: "tilt of the spin", unit: "°", si: DEGREE, value: tilt, low: 0, high: Math.PI, power: 2 },
    { key: "spin.around", label: `tilted towards (0° is axis ${((about + 1) % 3) + 1})`, unit: "°", si: DEGREE, value: tilt > 0 ? angles(velocity, about).around : around, low: -Math.PI, high: Math.PI },
  ];
}

/** Return the range of one moment, given the two others: no solid body has moments outside of it. */
function allowed(moments, k) {
  const [a, b] = [moments[(k + 1) % 3], moments[(k + 2) % 3]];
  const [least, most] = [Math.abs(a - b), a + b];
  return { low: Math.max(least, 1e-3 * most), high: most, log: true };
}

/** Return the setting after a slider has moved; values in SI. */
export function changed(setting, key, value) {
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

/** Return the setting whose momentum points along a unit vector of the body, as long as before. */
export function withDirection(setting, unit) {
  const size = Math.hypot(...setting.velocity.map((value, k) => value * setting.moments[k]));
  const momentum = unit.map((value) => value * size);
  const velocity = momentum.map((value, k) => value / setting.moments[k]);
  return { ...setting, velocity, momentum, around: angles(velocity, setting.about).around };
}

/** Return the motion. */
export function make({ moments, velocity, momentum, attitude, epoch }) {
  // the momentum that was given is kept to the last bit, as dividing and multiplying would not
  return new FreeMotion({ moments, momentum: momentum ?? velocity.map((value, k) => value * moments[k]), attitude, epoch });
}

/** Return the setting as a spec's tables, in SI. */
export function asSpec({ moments, velocity, attitude }) {
  return { body: { moments }, spin: { angular_velocity: velocity, attitude } };
}

/** Return the setting with what tables of a spec say otherwise, in SI: rate, about (1 to 3) and tilt, or a vector. */
export function withSpec(setting, { body = {}, spin = {} }) {
  let found = { ...setting };
  if (body.moments) found = { ...found, moments: body.moments.map(Number), momentum: null };
  if (spin.attitude) found.attitude = spin.attitude.map(Number);
  if (spin.momentum) {
    const momentum = spin.momentum.map(Number);
    const velocity = momentum.map((value, k) => value / found.moments[k]);
    return { ...found, momentum, velocity, around: angles(velocity, found.about).around };
  }
  if (spin.angular_velocity) {
    const velocity = spin.angular_velocity.map(Number);
    return { ...found, momentum: null, velocity, around: angles(velocity, found.about).around };
  }
  if (["rate", "about", "tilt"].every((name) => spin[name] === undefined)) return found;
  const about = spin.about === undefined ? found.about : Number(spin.about) - 1;
  const old = angles(found.velocity, about);
  // a spec's tilt is towards the next axis
  const now = { rate: Number(spin.rate ?? old.rate), tilt: Number(spin.tilt ?? old.tilt), around: spin.tilt === undefined ? old.around : 0 };
  return { ...found, about, around: now.around, momentum: null, velocity: velocityOf(about, now) };
}

/** Return the spec as a file. */
export function toml({ moments, velocity, attitude }, span) {
  const list = (values, unit) => `[${values.map((value) => `"${exact(value)} ${unit}"`).join(", ")}]`;
  return `[body]
moments = ${list(moments, "kg*m^2")}

[spin]
angular_velocity = ${list(velocity, "rad/s")}
attitude = [${attitude.map(exact).join(", ")}]

[time]
until = "${exact(span)} s"
`;
}

/** Return what is to be said of a motion, as pairs. */
export function facts({ moments, velocity }, solver) {
  const order = ascending(moments);
  const { period, regime } = solver;
  const finite = period !== null && Number.isFinite(period);
  const found = [["what it does", seen(moments, velocity, solver, order)]];
  if (finite) found.push(["period of L in the body", clock(period, period)]);
  if (finite && solver.precessionPerPeriod !== null) {
    found.push(["precession about L", `${worded(solver.precessionPerPeriod / DEGREE, 5)}° per period`]);
  }
  if (Number.isFinite(solver.flipInterval ?? NaN)) found.push(["turns over every", clock(solver.flipInterval, solver.flipInterval)]);
  found.push(["regime", regime]);
  return found;
}

/** Return what a person would see, by the same limits as polhode's reports. */
function seen(moments, velocity, { regime, modulus }, order) {
  if (regime === "rest") return "at rest";
  if (regime === "separatrix") return "runs up to the intermediate axis and stays there";
  if (regime === "permanent" || regime === "spherical") return "spins steadily";
  const [least, most] = leaning(moments, velocity, order);
  const close = Number(least.toPrecision(3)) === Number(most.toPrecision(3));
  const half = close ? arc(most) : `${arc(least)} to ${arc(most)}`;
  if (most < CONING) return `cones, its axis ${half} from L`;
  if (most >= FLIPPING && (most - least >= SWINGING || modulus > DWELLING)) return "turns over and over";
  return `tumbles, its axis ${half} from L`;
}

/** Return an angle [degrees] in the unit of its size. */
function arc(angle) {
  const [size, name] = [[1, "°"], [1 / 60, "′"], [1 / 3600, "″"], [1e-3 / 3600, " mas"]].find(([unit]) => angle >= unit) ?? [1, "°"];
  return `${worded(angle / size, 3)}${name}`;
}

/** Return the least and largest angle [degrees] of the axis that L goes round from L. */
function leaning(moments, velocity, order) {
  const [I1, I2, I3] = order.map((k) => moments[k]);
  const momentum = order.map((k) => velocity[k] * moments[k]);
  const size = Math.hypot(...momentum);
  const [x, y, z] = momentum.map((value) => Math.abs(value) / size);
  const aboutThird = I1 === I3 || I1 * (I3 - I2) * z * z >= I3 * (I2 - I1) * x * x;
  const ratio = aboutThird ? (I1 * (I3 - I2)) / (I2 * (I3 - I1)) : (I3 * (I2 - I1)) / (I2 * (I3 - I1));
  const across = aboutThird ? x : z;
  const narrow = Math.sqrt(across * across + (ratio || 0) * y * y);
  const wide = Math.min(1, ratio > 0 ? narrow / Math.sqrt(ratio) : 1);
  if (I1 === I3) return [0, 0];
  return [Math.asin(Math.min(narrow, wide)), Math.asin(Math.max(narrow, wide))].map((angle) => angle / DEGREE);
}
