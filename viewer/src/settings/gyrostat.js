// A body with a rotor inside that turns at a constant rate, or freely, as sliders set it.
import { Gyrostat } from "../../../reference/stepped/index.js";
import { clock, degreesBetween, exact, perMinute, worded } from "../numbers.js";
import { say } from "../say.js";
import { angles, momentControls, momentumOf, nearestAxis, SPIN_KEYS, spinControls, tomlList, toSpace, turned, watchAxis, withTables } from "./turning.js";

const RPM = Math.PI / 30;
const DEGREE = Math.PI / 180;

export const first = ["rate", "rotor", "spin.tilt", "spin.rate"]; // of the controls, the others are folded
export const keys = {
  body: { moments: 3 },
  system: { kind: 0, rotor_axis: 3, rotor_moment: 1, rotor_rate: 1, rotor_drive: 0, rotor_momentum: 1 },
  spin: SPIN_KEYS,
}; // of a spec, with how many numbers each has; the rotor's momentum is for those who know no more of it

/** Return the setting of what Python wrote down; `rotor` is the momentum h of the rotor along the principal axes. */
export function from({ moments, rotor, rotor_moment = null, rotor_drive = "constant-rate", momentum, attitude = [1, 0, 0, 0], epoch = 0 }) {
  const velocity = momentum.map((value, k) => (value - rotor[k]) / moments[k]);
  const about = nearestAxis(velocity);
  const size = Math.hypot(...rotor);
  const axis = size > 0 ? rotor.map((value) => value / size) : [0, 0, 1];
  const around = angles(velocity, about).around;
  return { moments, velocity, attitude, epoch, about, around, momentum, axis, spin: size, moment: rotor_moment, drive: rotor_drive };
}

const ALONG = 1e-9; // by which a rotor's axis may miss a principal one
const NAMES = { momentum_space: "L in space" };
const inner = ({ axis, spin }) => axis.map((value) => value * spin);

/** Return by how much less than h/J the rotor turns against the body [rad/s]: a free one's h is its whole momentum. */
const carried = ({ axis, drive, velocity }) => (drive === "free" ? axis.reduce((sum, value, k) => sum + value * velocity[k], 0) : 0);
const rateOf = (setting) => setting.spin / setting.moment - carried(setting);
const withRate = (setting, rate) => ({ ...setting, spin: setting.moment * (rate + carried(setting)), momentum: null });

export function controls(setting) {
  const most = Math.max(Math.abs(setting.spin), Math.hypot(...momentumOf(setting, inner(setting)))) || 1;
  const rotor =
    setting.moment === null
      ? { key: "rotor", label: "momentum of the rotor", unit: "kg m²/s", value: setting.spin, low: -2 * most, high: 2 * most }
      : { key: "rate", label: "rotor speed against the body", unit: "rpm", si: RPM, value: rateOf(setting), low: (-2 * most) / setting.moment, high: (2 * most) / setting.moment };
  return [rotor, ...momentControls(setting.moments), ...spinControls(setting)];
}

export function changed(setting, key, value) {
  if (key === "rotor") return { ...setting, spin: value, momentum: null };
  if (key === "rate") return withRate(setting, value);
  return turned(setting, key, value);
}

export const make = (setting) =>
  new Gyrostat({
    moments: setting.moments,
    rotor: inner(setting),
    rotor_moment: setting.moment,
    rotor_drive: setting.drive,
    axis: setting.axis,
    momentum: momentumOf(setting, inner(setting)),
    attitude: setting.attitude,
    epoch: setting.epoch,
  });

export const asSpec = (setting) => ({
  body: { moments: setting.moments },
  system:
    setting.moment === null
      ? { kind: "gyrostat", rotor_axis: setting.axis, rotor_momentum: setting.spin }
      : { kind: "gyrostat", rotor_axis: setting.axis, rotor_moment: setting.moment, rotor_rate: rateOf(setting), rotor_drive: setting.drive },
  spin: { angular_velocity: setting.velocity, attitude: setting.attitude },
});

export function withSpec(setting, tables) {
  const { system = {} } = tables;
  let found = { ...setting };
  if (system.rotor_axis) {
    const size = Math.hypot(...system.rotor_axis);
    if (!(size > 0)) throw new RangeError("system.rotor_axis must have a direction; got zeros.");
    Object.assign(found, { axis: system.rotor_axis.map((value) => value / size), momentum: null });
  }
  const given = [system.rotor_rate, system.rotor_moment, system.rotor_drive].some((value) => value !== undefined);
  const rate = system.rotor_rate ?? (found.moment === null ? null : rateOf(found));
  if (system.rotor_moment !== undefined) Object.assign(found, { moment: system.rotor_moment, momentum: null });
  if (system.rotor_drive !== undefined) Object.assign(found, { drive: system.rotor_drive, momentum: null });
  if (system.rotor_momentum !== undefined) Object.assign(found, { spin: system.rotor_momentum, momentum: null });
  if (given && found.moment === null) throw new RangeError("system.rotor_rate needs system.rotor_moment, the rotor's own moment of inertia.");
  const momentum = given ? tables.spin?.momentum : null;
  if (momentum) found.spin = spinWith(found, rate, tables.body?.moments ?? found.moments, momentum);
  found = withTables(found, tables, inner(found));
  return given && !momentum && rate !== null ? withRate(found, rate) : found;
}

/** Return the rotor's h at a rate, of a body whose whole momentum is L: of a free rotor h = J (σ + a·Ω), Ω = I⁻¹(L − h a). */
function spinWith({ axis, moment, drive }, rate, moments, momentum) {
  if (drive !== "free") return moment * rate;
  const along = (vector) => axis.reduce((sum, value, k) => sum + (value * vector[k]) / moments[k], 0);
  return (moment * (rate + along(momentum))) / (1 + moment * along(axis));
}

/** Return the spec of a setting, if a spec can say it: a free rotor's axis must be a principal one of the body. */
export function toml(setting, span) {
  const { axis, moment, drive, velocity, attitude } = setting;
  const along = axis.findIndex((value) => Math.abs(value) === 1);
  if (moment === null || (drive === "free" && along < 0)) return null;
  const moments = setting.moments.map((value, k) => (drive === "free" && k === along ? value + moment : value));
  return `[body]
moments = ${tomlList(moments, "kg*m^2")}

[system]
kind = "gyrostat"
rotor_axis = [${axis.map(exact).join(", ")}]
rotor_moment = "${exact(moment)} kg*m^2"
rotor_rate = "${exact(rateOf(setting))} rad/s"
rotor_drive = "${drive}"

[spin]
angular_velocity = ${tomlList(velocity, "rad/s")}
attitude = [${attitude.map(exact).join(", ")}]

[time]
until = "${exact(span)} s"
`;
}

const JUDGED = {
  minimum: "stable, also with losses in the body: least energy",
  maximum: "stable until losses act: most energy",
  saddle: "unstable: a saddle of the energy",
};

/** Return how the rotor's axis moves about L, whether a spin about it is stable, and how L goes round it in the body. */
export function facts(setting, solver) {
  const first = solver.state(solver.epoch);
  const size = Math.hypot(...first.momentum);
  const L = toSpace(first.attitude, first.momentum).map((value) => value / (size || 1));
  const found = [];
  if (size > 0) {
    const { least, most, around } = watchAxis(solver, ({ attitude }) => toSpace(attitude, setting.axis), L);
    found.push(["rotor's axis leans from L", degreesBetween(least, most)]);
    found.push(["precession of the rotor's axis about L", perMinute(around)]);
    const spin = spinAboutRotor(setting, size);
    if (spin) {
      found.push(["a spin about the rotor's axis", JUDGED[spin.extremum]]);
      if (spin.nutation) found.push(["nutation: L goes round it in the body every", clock((2 * Math.PI) / spin.nutation, (2 * Math.PI) / spin.nutation)]);
    }
  }
  return [...found, ...kept(solver)];
}

/**
 * Return what the energy is at L along the rotor's principal axis, and how fast L goes round near it [rad/s]; null for others.
 *
 * With L = l e, Ω = (l − h)/K and small parts x, y across: x′ = (Ω − l/J) y, y′ = (l/I − Ω) x, and the energy on the sphere
 * changes by ½ (1/I − Ω/l) x² + ½ (1/J − Ω/l) y².
 */
export function spinAboutRotor({ moments, axis, spin: h }, size) {
  const k = axis.findIndex((value) => Math.abs(Math.abs(value) - 1) < ALONG);
  if (k < 0) return null;
  const rate = (size - h) / moments[k];
  const [x, y] = [1, 2].map((j) => size / moments[(k + j) % 3] - rate);
  return { extremum: x * y <= 0 ? "saddle" : x > 0 ? "minimum" : "maximum", nutation: x * y > 0 ? Math.sqrt(x * y) : null };
}

/** Return by how much what is conserved has changed until some turns later. */
export function kept(solver) {
  const first = solver.state(solver.epoch);
  const speed = Math.hypot(...first.velocity) || 1;
  const later = solver.state(solver.epoch + (40 * Math.PI) / speed);
  return Object.entries(first.invariants).map(([name, value]) => {
    const [a, b] = [[value].flat(), [later.invariants[name]].flat()];
    const size = Math.hypot(...a) || 1;
    return [say("{quantity}, change in 20 turns", { quantity: say(NAMES[name] ?? name) }), worded(Math.hypot(...a.map((x, k) => x - b[k])) / size, 2)];
  });
}
