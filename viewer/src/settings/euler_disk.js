// A disk that rolls on a plane, and what slows it, as sliders set it.
import { EulerDisk } from "../../../reference/stepped/index.js";
import { exact, worded } from "../numbers.js";
import { say } from "../say.js";

const DEGREE = Math.PI / 180;
const STEADY = 0.02; // by which the rates at first may differ from those of steady rolling, relative

/** What a spec calls a law's constant, its unit there, and what people call the law. */
const LAWS = {
  "air-layer": ["viscosity", "Pa*s", "viscosity of the air"],
  "boundary-layer": ["coefficient", "W*s^2.5", "loss in the boundary layer"],
  "viscous-contour-friction": ["coefficient", "W*s^2", "viscous friction of the contact"],
  "dry-contour-friction": ["coefficient", "", "dry friction of the contact"],
  "rolling-couple": ["arm", "m", "lever arm of rolling friction"],
  "drilling-friction": ["arm", "m", "lever arm of drilling friction"],
};

export const keys = {
  system: { kind: 0, mass: 1, radius: 1, thickness: 1, gravity: 1, tilt: 1 },
  dissipation: Object.fromEntries(Object.keys(LAWS).map((law) => [law, 1])), // zero leaves a law out
}; // of a spec, with how many numbers each has

/** Return the setting of what Python wrote down; moments are kept as shares of m a². */
export function from({ mass, radius, half_thickness, diametral_moment, axial_moment, gravity, dissipation, start, epoch = 0 }) {
  const uniform = Math.abs(axial_moment - 0.5 * mass * radius ** 2) < 1e-12 * axial_moment &&
    Math.abs(diametral_moment - mass * (0.25 * radius ** 2 + half_thickness ** 2 / 3)) < 1e-12 * diametral_moment; // prettier-ignore
  const shares = uniform ? null : [diametral_moment / (mass * radius ** 2), axial_moment / (mass * radius ** 2)];
  const setting = { mass, radius, half_thickness, shares, gravity, dissipation, tilt: start[0], heading: start[1], face: start[2], start, epoch };
  return { ...setting, moments: momentsOf(setting), steady: rollsSteadily(setting) };
}

const momentsOf = ({ shares, mass, radius, half_thickness }) => {
  const [A, C] = shares ? shares.map((share) => share * mass * radius ** 2) : [mass * (0.25 * radius ** 2 + half_thickness ** 2 / 3), 0.5 * mass * radius ** 2];
  return [A, A, C];
};

const parameters = (setting) => {
  const [A, , C] = momentsOf(setting);
  const { mass, radius, half_thickness, gravity, dissipation } = setting;
  const laws = Object.entries(dissipation).map(([law, value]) => ({ law, [LAWS[law][0]]: value }));
  return { mass, radius, half_thickness, gravity, diametral_moment: A, axial_moment: C, dissipation: laws };
};

/** Return the steady rolling at the setting's tilt with the centre at rest. */
const rolling = (setting) => EulerDisk.rollingStart({ ...parameters(setting), tilt: setting.tilt, heading: setting.heading, face: setting.face });

function rollsSteadily(setting) {
  try {
    const wanted = rolling(setting);
    const scale = Math.hypot(...wanted.slice(6));
    return [6, 7].every((k) => Math.abs(wanted[k] - setting.start[k]) < STEADY * scale);
  } catch {
    return false;
  }
}

export function controls(setting) {
  const { tilt, radius, half_thickness, mass, gravity, dissipation } = setting;
  return [
    { key: "tilt", label: "tilt of the face at first", unit: "°", si: DEGREE, value: tilt, low: Math.min(tilt, DEGREE), high: 80 * DEGREE, log: true },
    { key: "radius", label: "radius", unit: "mm", si: 1e-3, value: radius, low: radius / 5, high: 5 * radius, log: true },
    { key: "thickness", label: "thickness", unit: "mm", si: 1e-3, value: 2 * half_thickness, low: 0, high: radius },
    { key: "mass", label: "mass", unit: "g", si: 1e-3, value: mass, low: mass / 20, high: 20 * mass, log: true },
    { key: "gravity", label: "gravity", unit: "m/s²", value: gravity, low: gravity / 10, high: 3 * gravity, log: true },
    ...Object.entries(dissipation).map(([law, value]) => ({
      key: `law.${law}`, label: LAWS[law][2], unit: LAWS[law][1].replace("*", " ").replace("^2.5", "^(5/2)").replace("^2", "²"), value, low: value / 100, high: 100 * value, log: true,
    })),
  ]; // prettier-ignore
}

export function changed(setting, key, value) {
  const [name, law] = key.split(".");
  if (law) return started({ ...setting, dissipation: { ...setting.dissipation, [law]: value } });
  if (name === "thickness") return started({ ...setting, half_thickness: 0.5 * value });
  return started({ ...setting, [name]: value });
}

/** Return a changed setting with its start, at time zero: steady rolling at the tilt, with the centre at rest. */
function started(setting) {
  const found = { ...setting, steady: true, epoch: 0 };
  return { ...found, start: rolling(found), moments: momentsOf(found) };
}

export const make = (setting) => new EulerDisk({ ...parameters(setting), start: setting.start, epoch: setting.epoch });

export const asSpec = ({ mass, radius, half_thickness, gravity, tilt, dissipation }) => ({
  system: { kind: "euler-disk", mass, radius, thickness: 2 * half_thickness, gravity, tilt },
  dissipation,
});

export function withSpec(setting, { system = {}, dissipation = {} }) {
  const found = { ...setting, dissipation: { ...setting.dissipation, ...dissipation } };
  for (const [law, value] of Object.entries(found.dissipation)) if (value === 0) delete found.dissipation[law];
  for (const key of ["mass", "radius", "gravity", "tilt"]) if (system[key] !== undefined) found[key] = system[key];
  if (system.thickness !== undefined) found.half_thickness = 0.5 * system.thickness;
  return started(found);
}

/** Return the spec of a setting; null of one that does not begin in steady rolling. */
export function toml(setting, span) {
  if (!setting.steady) return null;
  const { mass, radius, half_thickness, shares, gravity, tilt, heading, dissipation } = setting;
  const [A, , C] = momentsOf(setting);
  const moments = shares ? `axial_moment = "${exact(C)} kg*m^2"\ndiametral_moment = "${exact(A)} kg*m^2"\n` : "";
  const laws = Object.entries(dissipation).map(([law, value]) => {
    const [key, unit] = LAWS[law];
    return `{ law = "${law}", ${key} = ${unit ? `"${exact(value)} ${unit}"` : exact(value)} }`;
  });
  return `[system]
kind = "euler-disk"
mass = "${exact(mass)} kg"
radius = "${exact(radius)} m"
thickness = "${exact(2 * half_thickness)} m"
${moments}gravity = "${exact(gravity)} m/s^2"
tilt = "${exact(tilt)} rad"
heading = "${exact(heading)} rad"
dissipation = [${laws.join(", ")}]

[time]
until = "${exact(span)} s"
`;
}

export function facts(setting, solver) {
  const first = solver.state(solver.epoch);
  const around = first.parts[6] / Math.sin(first.tilt);
  const turn = (2 * Math.PI) / Math.abs(around);
  const later = solver.state(solver.epoch + 20 * turn);
  const spent = later.balances.energy ? later.balances.energy.received - first.balances.energy.received : 0;
  const found = [
    ["contact goes round every", `${worded(turn, 4)} s`],
    ["energy at first", `${worded(first.energy, 5)} J`],
    ["energy less losses, change in 20 rounds", worded(Math.abs(later.energy - spent - first.energy) / first.energy, 2)],
  ];
  if (spent) found.push(["lost in 20 rounds", `${worded((-100 * spent) / first.energy, 3)} %`]);
  if (later.ended) found.push(["ends", later.ended === "flat" ? "flat on the table, within 20 rounds" : say("by {event}, within 20 rounds", { event: say(later.ended) })]);
  return found;
}
