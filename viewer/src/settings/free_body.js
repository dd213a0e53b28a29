// A free body as sliders set it: three moments, and how it spins at first.
import { FreeMotion } from "../../../reference/polhode.js";
import { clock, exact, worded } from "../numbers.js";
import { say } from "../say.js";
import { ascending } from "../polhodes.js";
import { angles, momentControls, momentumOf, nearestAxis, SPIN_KEYS, spinControls, tomlList, turned, withTables } from "./turning.js";

const DEGREE = Math.PI / 180;
const [CONING, FLIPPING, SWINGING] = [45, 60, 20]; // degrees of the cone's half-angle, and of its swing
const FLIPS = "turns over and over"; // alone has a time of turning over
const DWELLING = 0.995; // modulus from which L dwells at the intermediate axis

export const dragged = true; // the momentum's point can be dragged on its sphere

export const first = ["spin.tilt", "spin.rate", "spin.about"]; // of the controls, the others are folded
export const keys = { body: { moments: 3 }, spin: SPIN_KEYS }; // of a spec, with how many numbers each has

/** Return the setting of what Python wrote down: moments, momentum and attitude along the principal axes. */
export function from({ moments, momentum, attitude = [1, 0, 0, 0], epoch = 0, mass }) {
  const velocity = momentum.map((value, k) => value / moments[k]);
  const about = nearestAxis(velocity);
  return { moments, velocity, attitude, epoch, about, around: angles(velocity, about).around, momentum, mass: mass ?? 1 };
}

/** Return what the sliders show: the moments, or the edges of the homogeneous box that has them. */
export function controls(setting) {
  const edges = edgesOf(setting);
  const by = edges ? [{ key: "by", label: "set the body by", value: setting.by ?? 0, choices: [[0, "its moments"], [1, "the edges of a box"]] }] : [];
  return [...by, ...(edges && setting.by ? boxControls(setting, edges) : momentControls(setting.moments)), ...spinControls(setting)];
}

function boxControls({ mass = 1 }, edges) {
  const most = Math.max(...edges);
  const [unit, si] = [["km", 1e3], ["m", 1], ["cm", 1e-2], ["mm", 1e-3], ["µm", 1e-6], ["nm", 1e-9]].find(([, size]) => most >= size) ?? ["m", 1];
  return [
    { key: "mass", label: "mass of the box", unit: "kg", value: mass, log: true, low: mass / 20, high: 20 * mass },
    ...edges.map((value, k) => ({ key: `edge.${k}`, label: say("edge along axis {axis}", { axis: k + 1 }), unit, si, value, log: true, low: Math.max(value, 1e-3 * most) / 10, high: 10 * Math.max(value, 1e-3 * most) })),
  ];
}

/** Return the edges [m] of the box with these moments; null where no box has them. I_k = m (b² + c²)/12 */
function edgesOf({ moments, mass = 1 }) {
  const sum = moments[0] + moments[1] + moments[2];
  const squares = moments.map((moment) => (6 / mass) * (sum - 2 * moment));
  return squares.every((square) => square >= 0 && Number.isFinite(square)) ? squares.map(Math.sqrt) : null;
}

/** Return the setting after a slider has moved; values in SI. */
export function changed(setting, key, value) {
  const [name, index] = key.split(".");
  if (name === "by") return { ...setting, by: value };
  if (name !== "edge" && name !== "mass") return turned(setting, key, value);
  const edges = edgesOf(setting);
  const mass = name === "mass" ? value : setting.mass ?? 1;
  if (name === "edge") edges[Number(index)] = value;
  const squares = edges.map((edge) => edge * edge);
  const moments = [0, 1, 2].map((k) => (mass / 12) * (squares[(k + 1) % 3] + squares[(k + 2) % 3]));
  return { ...setting, mass, moments, momentum: null };
}

/** Return the setting whose momentum points along a unit vector of the body, as long as before. */
export function withDirection(setting, unit) {
  const size = Math.hypot(...setting.velocity.map((value, k) => value * setting.moments[k]));
  const momentum = unit.map((value) => value * size);
  const velocity = momentum.map((value, k) => value / setting.moments[k]);
  return { ...setting, velocity, momentum, around: angles(velocity, setting.about).around };
}

/** Return the motion. */
export const make = (setting) =>
  new FreeMotion({ moments: setting.moments, momentum: momentumOf(setting), attitude: setting.attitude, epoch: setting.epoch });

/** Return the setting as a spec's tables, in SI. */
export function asSpec({ moments, velocity, attitude }) {
  return { body: { moments }, spin: { angular_velocity: velocity, attitude } };
}

/** Return the setting with what tables of a spec say otherwise, in SI: rate, about (1 to 3) and tilt, or a vector. */
export const withSpec = (setting, tables) => withTables(setting, tables);

/** Return the spec as a file. */
export function toml({ moments, velocity, attitude }, span) {
  return `[body]
moments = ${tomlList(moments, "kg*m^2")}

[spin]
angular_velocity = ${tomlList(velocity, "rad/s")}
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
  const form = seen(moments, velocity, solver, order);
  const found = [["what it does", form]];
  if (finite) found.push(["period of L in the body", clock(period, period)]);
  if (finite && solver.precessionPerPeriod !== null) {
    found.push(["precession about L", say("{angle} per period", { angle: `${worded(solver.precessionPerPeriod / DEGREE, 5)}°` })]);
  }
  if (form === FLIPS && Number.isFinite(solver.flipInterval ?? NaN)) found.push(["turns over every", clock(solver.flipInterval, solver.flipInterval)]);
  found.push(["regime", regime]);
  return found;
}

/** Return how long it takes until the body has turned over, or its axis has gone round L in the body [s]; null of a steady turn. */
export function event({ moments, velocity }, solver) {
  const { period, flipInterval } = solver;
  if (period === null || !Number.isFinite(period)) return null;
  return seen(moments, velocity, solver, ascending(moments)) === FLIPS ? flipInterval : period;
}

/** Return what a person would see, by the same limits as polhode's reports. */
function seen(moments, velocity, { regime, modulus }, order) {
  if (regime === "rest") return "at rest";
  if (regime === "separatrix") return "runs up to the intermediate axis and stays there";
  if (regime === "permanent" || regime === "spherical") return "spins steadily";
  const [least, most] = leaning(moments, velocity, order);
  const close = Number(least.toPrecision(3)) === Number(most.toPrecision(3));
  const half = close ? arc(most) : say("{least} to {most}", { least: arc(least), most: arc(most) });
  if (most < CONING) return say("cones, its axis {angle} from L", { angle: half });
  if (most >= FLIPPING && (most - least >= SWINGING || modulus > DWELLING)) return FLIPS;
  return say("tumbles, its axis {angle} from L", { angle: half });
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
