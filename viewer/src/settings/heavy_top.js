// Any body about a fixed point under its weight, as sliders set it.
import { HeavyTop } from "../../../reference/stepped/index.js";
import { kept } from "./gyrostat.js";
import { angles, momentControls, momentumOf, nearestAxis, SPIN_KEYS, spinControls, turned, withTables } from "./turning.js";

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

export const facts = (setting, solver) => kept(solver);
