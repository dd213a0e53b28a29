// Any body about a fixed point under its weight, as sliders set it.
import { HeavyTop } from "../../../reference/stepped/index.js";
import { clock, degreesBetween, exact, perMinute, worded } from "../numbers.js";
import { kept } from "./gyrostat.js";
import { angles, momentControls, momentumOf, nearestAxis, SPIN_KEYS, spinControls, tomlList, toSpace, turned, watchAxis, withTables } from "./turning.js";

const GRAVITY = 9.80665; // m/s²
const DEGREE = Math.PI / 180;
const ALONG = 1e-5; // by which the cosine to a principal axis may miss one: 0.26°
const NODS = 0.01 * DEGREE; // of lean, below which it is called steady

export const first = ["spin.rate", "spin.tilt", "mgl"]; // of the controls, the others are folded
export const keys = { system: { kind: 0, moments: 3, mgl: 1, axis: 3 }, spin: SPIN_KEYS }; // of a spec, with how many numbers each has

export function from({ moments, mgl, axis, momentum, attitude = [1, 0, 0, 0], epoch = 0 }) {
  const velocity = momentum.map((value, k) => value / moments[k]);
  const about = nearestAxis(velocity);
  return { moments, velocity, attitude, epoch, about, around: angles(velocity, about).around, momentum, mgl, axis };
}

export const controls = (setting) => [
  { key: "mgl", label: "weight × distance to the centre of mass", unit: "N m", value: setting.mgl, low: 0, high: 5 * Math.abs(setting.mgl) || 1 },
  ...momentControls(setting.moments),
  ...spinControls(setting),
];

export const changed = (setting, key, value) => (key === "mgl" ? { ...setting, mgl: value } : turned(setting, key, value));

export const make = (setting) => new HeavyTop({ ...setting, momentum: momentumOf(setting) });

export const asSpec = ({ moments, mgl, axis, velocity, attitude }) => ({
  system: { kind: "heavy-top", moments, mgl, axis },
  spin: { angular_velocity: velocity, attitude },
});

export function withSpec(setting, tables) {
  const { system = {} } = tables;
  const found = { ...setting };
  if (system.mgl !== undefined) found.mgl = Number(system.mgl);
  if (system.axis) found.axis = system.axis.map(Number);
  return withTables(found, system.moments ? { ...tables, body: { moments: system.moments } } : tables);
}

/** Return the spec as a file: of the bodies with these moments about the point and this weight, one. */
export function toml(setting, span) {
  const { moments, mgl, axis, velocity, attitude } = setting;
  const length = Math.hypot(...axis);
  const toCentre = axis.map((value) => value / length);
  // what the centre of mass takes of the second moments of the mass must leave a body's
  const spread = [0, 1, 2].map((k) => 0.5 * (moments[0] + moments[1] + moments[2]) - moments[k]);
  const share = toCentre.reduce((sum, value, k) => sum + (value ? (value * value) / spread[k] : 0), 0);
  if (mgl && !(share > 0 && Number.isFinite(share))) return null;
  const taken = mgl ? 0.5 / share : 0; // m l²
  const arm = mgl ? (taken * GRAVITY) / mgl : 0;
  const mass = mgl ? mgl / (GRAVITY * arm) : 1;
  const inertia = [0, 1, 2].map((i) => [0, 1, 2].map((j) => (i === j ? moments[i] - taken : 0) + taken * toCentre[i] * toCentre[j]));
  return `# a body with the moments ${moments.map((value) => worded(value)).join(", ")} kg m² about its point, and mgl = ${worded(mgl)} N m
[body]
mass = "${exact(mass)} kg"
inertia = [${inertia.map((row) => tomlList(row, "kg*m^2")).join(", ")}]

[system]
kind = "heavy-top"
pivot = ${tomlList(toCentre.map((value) => -arm * value), "m")}

[spin]
angular_velocity = ${tomlList(velocity, "rad/s")}
attitude = [${attitude.map(exact).join(", ")}]

[time]
until = "${exact(span)} s"
`;
}

/** Return how the axis leans, nods and goes round, what a gyroscope's rule says of it, and whether it would stand upright. */
export function facts({ moments, mgl, axis, velocity }, solver) {
  const size = Math.hypot(...axis);
  const unit = axis.map((value) => value / size);
  const { least, most, swing, around } = watchAxis(solver, ({ attitude }) => toSpace(attitude, unit));
  const found = [["axis leans", degreesBetween(least, most)]];
  if (swing !== null && most - least > NODS) found.push(["nutation: nods every", clock(swing, swing)]);
  found.push(["mean precession", perMinute(around)]);
  const k = unit.findIndex((value) => Math.abs(Math.abs(value) - 1) < ALONG);
  if (k >= 0) {
    const spin = velocity[k] * unit[k];
    if (spin && mgl) found.push(["a gyroscope's, mgl/I₃ω", perMinute(mgl / (moments[k] * spin))]);
    found.push(["upright at this spin, to first order", standsUpright(moments, mgl, k, spin) ? "stable: it would sleep" : "unstable: it would fall"]);
  }
  return [...found, ...kept(solver)];
}

/**
 * Whether a top that spins upright about its principal axis k is stable to first order.
 *
 * With the tilt (x, y) in the body I x″ − G ω y′ + ((K − J) ω² − mgl) x = 0 and likewise y, G = I + J − K: I, J are the moments
 * across, K that along. Source: Magnus, *Kreisel* (1971), on the sleeping top with unequal moments.
 */
export function standsUpright(moments, mgl, k, spin) {
  const [I, J, K] = [moments[(k + 1) % 3], moments[(k + 2) % 3], moments[k]];
  const [x, y] = [(K - J) * spin * spin - mgl, (K - I) * spin * spin - mgl];
  const [a, b, c] = [I * J, I * y + J * x + ((I + J - K) * spin) ** 2, x * y];
  return b > 0 && c > 0 && b * b > 4 * a * c;
}
