// A body with a rotor inside that turns at a constant rate, as sliders set it.
import { Gyrostat } from "../../../reference/stepped/index.js";
import { worded } from "../numbers.js";
import { angles, momentControls, momentumOf, nearestAxis, SPIN_KEYS, spinControls, turned, withTables } from "./turning.js";

export const keys = { body: { moments: 3 }, system: { kind: 0, rotor_momentum: 1, rotor_axis: 3 }, spin: SPIN_KEYS }; // of a spec, with how many numbers each has

/** Return the setting of what Python wrote down; `rotor` is the momentum h of the rotor along the principal axes. */
export function from({ moments, rotor, momentum, attitude = [1, 0, 0, 0], epoch = 0 }) {
  const velocity = momentum.map((value, k) => (value - rotor[k]) / moments[k]);
  const about = nearestAxis(velocity);
  const size = Math.hypot(...rotor);
  const axis = size > 0 ? rotor.map((value) => value / size) : [0, 0, 1];
  return { moments, velocity, attitude, epoch, about, around: angles(velocity, about).around, momentum, axis, spin: size };
}

const NAMES = { momentum_space: "L in space" };
const inner = ({ axis, spin }) => axis.map((value) => value * spin);

export function controls(setting) {
  const most = Math.max(Math.abs(setting.spin), Math.hypot(...momentumOf(setting, inner(setting)))) || 1;
  return [
    { key: "rotor", label: "momentum of the rotor", unit: "kg m²/s", value: setting.spin, low: -2 * most, high: 2 * most },
    ...momentControls(setting.moments),
    ...spinControls(setting),
  ];
}

export const changed = (setting, key, value) =>
  key === "rotor" ? { ...setting, spin: value, momentum: null } : turned(setting, key, value);

export const make = (setting) =>
  new Gyrostat({
    moments: setting.moments,
    rotor: inner(setting),
    momentum: momentumOf(setting, inner(setting)),
    attitude: setting.attitude,
    epoch: setting.epoch,
  });

export const asSpec = (setting) => ({
  body: { moments: setting.moments },
  system: { kind: "gyrostat", rotor_momentum: setting.spin, rotor_axis: setting.axis },
  spin: { angular_velocity: setting.velocity, attitude: setting.attitude },
});

export function withSpec(setting, tables) {
  const { system = {} } = tables;
  const found = { ...setting };
  if (system.rotor_axis) {
    const size = Math.hypot(...system.rotor_axis);
    if (!(size > 0)) throw new RangeError("system.rotor_axis must have a direction; got zeros.");
    Object.assign(found, { axis: system.rotor_axis.map((value) => value / size), momentum: null });
  }
  if (system.rotor_momentum !== undefined) Object.assign(found, { spin: Number(system.rotor_momentum), momentum: null });
  return withTables(found, tables, inner(found));
}

export const facts = (setting, solver) => kept(solver);

/** Return by how much what is conserved has changed until some turns later. */
export function kept(solver) {
  const first = solver.state(solver.epoch);
  const speed = Math.hypot(...first.velocity) || 1;
  const later = solver.state(solver.epoch + (40 * Math.PI) / speed);
  return Object.entries(first.invariants).map(([name, value]) => {
    const [a, b] = [[value].flat(), [later.invariants[name]].flat()];
    const size = Math.hypot(...a) || 1;
    return [`${NAMES[name] ?? name}, change in 20 turns`, worded(Math.hypot(...a.map((x, k) => x - b[k])) / size, 2)];
  });
}
