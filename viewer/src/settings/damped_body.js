// A body that loses energy, inside or by drag, as sliders set it.
import { DampedBody } from "../../../reference/stepped/index.js";
import { ascending } from "../polhodes.js";
import { clock, exact, worded } from "../numbers.js";
import { angles, momentControls, momentumOf, nearestAxis, SPIN_KEYS, spinControls, tomlList, turned, withTables } from "./turning.js";

const TURNS = 2000; // that are looked at for the time to a flat spin
const FLAT = (5 * Math.PI) / 180;

export const first = ["rate", "spin.tilt", "spin.rate"]; // of the controls, the others are folded
export const keys = { body: { moments: 3 }, system: { kind: 0, damping: 1, sink_rate: 1, linear_drag: 1, quadratic_drag: 1 }, spin: SPIN_KEYS }; // of a spec, with how many numbers each has

export function from({ moments, rate = 0, linear_drag = 0, quadratic_drag = 0, momentum, attitude = [1, 0, 0, 0], epoch = 0 }) {
  const velocity = momentum.map((value, k) => value / moments[k]);
  const about = nearestAxis(velocity);
  return { moments, velocity, attitude, epoch, about, around: angles(velocity, about).around, momentum, rate, linear_drag, quadratic_drag };
}

export function controls(setting) {
  const size = 1 / (Math.hypot(...momentumOf(setting)) || 1); // α |L| is a rate in turns
  return [
    { key: "rate", label: "losses inside, α", unit: "s/(kg m²)", value: setting.rate, low: 0, high: 5 * Math.max(setting.rate, 0.02 * size), power: 2 },
    ...momentControls(setting.moments),
    ...spinControls(setting),
  ];
}

export const changed = (setting, key, value) => (key === "rate" ? { ...setting, rate: value } : turned(setting, key, value));

export const make = (setting) => new DampedBody({ ...setting, momentum: momentumOf(setting) });

export const asSpec = ({ moments, rate, linear_drag, quadratic_drag, velocity, attitude }) => ({
  body: { moments },
  system: { kind: "damped-body", sink_rate: rate, linear_drag, quadratic_drag },
  spin: { angular_velocity: velocity, attitude },
});

export function withSpec(setting, tables) {
  const { system = {} } = tables;
  const found = { ...setting };
  for (const [key, name] of [["sink_rate", "rate"], ["linear_drag", "linear_drag"], ["quadratic_drag", "quadratic_drag"]]) {
    if (system[key] !== undefined) found[name] = system[key];
  }
  const made = withTables(found, tables);
  if (system.damping === undefined) return made;
  const size = Math.hypot(...momentumOf(made)); // a spec tells α |L|
  return { ...made, rate: size > 0 ? system.damping / size : 0 };
}

/** Return the spec of a setting; null without losses, or of a body at rest. */
export function toml(setting, span) {
  const { moments, rate, linear_drag, quadratic_drag, velocity, attitude } = setting;
  const size = Math.hypot(...momentumOf(setting));
  const inside = rate > 0 && size > 0 ? `damping = ${exact(rate * size)}\n` : "";
  const linear = linear_drag > 0 ? `linear_drag = "${exact(linear_drag)} N*m*s"\n` : "";
  const quadratic = quadratic_drag > 0 ? `quadratic_drag = "${exact(quadratic_drag)} N*m*s^2"\n` : "";
  if (!inside && !linear && !quadratic) return null;
  return `[body]
moments = ${tomlList(moments, "kg*m^2")}

[system]
kind = "damped-body"
${inside}${linear}${quadratic}
[spin]
angular_velocity = ${tomlList(velocity, "rad/s")}
attitude = [${attitude.map(exact).join(", ")}]

[time]
until = "${exact(span)} s"
`;
}

export function facts({ moments, velocity, rate }, solver) {
  const { energy, momentum } = solver.state(solver.epoch);
  const size = Math.hypot(...momentum);
  if (!(size > 0)) return [["what it does", "at rest"]];
  const [I1, , I3] = ascending(moments).map((k) => moments[k]);
  const found = [["what it does", rate > 0 && I1 < I3 ? "loses energy and ends spinning about its axis of largest moment" : "keeps |L|"]];
  const least = (size * size) / (2 * I3);
  found.push(["energy it can lose inside", `${worded((100 * (energy - least)) / energy, 3)} %`]);
  const flat = rate > 0 ? flatSpin(solver, Math.hypot(...velocity)) : null;
  if (flat !== null) found.push(["within 5° of the flat spin after", clock(flat, flat)]);
  return found;
}

/** Return how long it takes to the flat spin [s]; null if that is not soon. */
export const event = ({ velocity, rate }, solver) => (rate > 0 ? flatSpin(solver, Math.hypot(...velocity)) : null);

/** Return when L is within 5° of the axis of largest moment for good [s after the epoch]; null if not soon. */
function flatSpin(solver, speed) {
  const step = (2 * Math.PI) / speed / 4;
  let since = null;
  for (let k = 0; k < 4 * TURNS; k++) {
    const { angleToMajorAxis } = solver.state(solver.epoch + k * step);
    if (!(angleToMajorAxis < FLAT)) since = null;
    else if ((since ??= k * step) < 0.5 * k * step) return since;
    else if (since === 0) return 0;
  }
  return since;
}
