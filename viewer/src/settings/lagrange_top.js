// A Lagrange top as sliders set it: moments about its point, weight, lean, and the rates of Euler's angles at first.
import { LagrangeMotion } from "../../../reference/polhode.js";
import { clock, exact, perMinute, worded } from "../numbers.js";

const RPM = Math.PI / 30;
const DEGREE = Math.PI / 180;
const GRAVITY = 9.80665; // m/s²
const STEADY = 1e-6; // of cos θ: nods as small as that are not seen
const UPRIGHT = 1e-9; // sine of a lean below which precession and spin cannot be told apart, and all is called spin

export const first = ["lean", "spin", "precession"]; // of the controls, the others are folded
export const keys = {
  system: { kind: 0, moments: 3, mgl: 1, lean: 1 },
  spin: { spin: 1, precession: 1, nutation_rate: 1, lean: 1, momentum: 3, attitude: 4 },
}; // of a spec, with how many numbers each has

/** Return the setting of what Python wrote down. */
export function from({ moments, mgl, momentum, attitude = [1, 0, 0, 0], epoch = 0 }) {
  return { moments, mgl, ...eulerOf(moments, momentum, attitude), momentum, attitude, epoch };
}

/**
 * Return Euler's angles ZXZ and their rates: the node line is e_z × e_3.
 *
 * Ω = φ' e_z + θ' (node) + ψ' e_3. Source: Goldstein, *Classical Mechanics*, §4.9.
 */
function eulerOf(moments, momentum, [w, x, y, z]) {
  const velocity = momentum.map((value, k) => value / moments[k]);
  const up = [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z]; // e_z in the body
  const sine = Math.hypot(up[0], up[1]);
  const lean = 2 * Math.atan2(Math.hypot(x, y), Math.hypot(w, z));
  if (sine < UPRIGHT) return { lean: lean < 1 ? 0 : Math.PI, spin: velocity[2], precession: 0, nutation: 0, phi: 2 * Math.atan2(z, w), psi: 0 };
  const half = Math.atan2(z, w); // half of φ + ψ
  const other = Math.atan2(y, x); // half of φ − ψ
  const precession = (velocity[0] * up[0] + velocity[1] * up[1]) / sine ** 2;
  const nutation = (velocity[0] * up[1] - velocity[1] * up[0]) / sine;
  return { lean, precession, nutation, spin: velocity[2] - precession * Math.cos(lean), phi: half + other, psi: half - other };
}

/** Return the state that the angles and rates say. */
function stateOf({ moments, lean, spin, precession, nutation, phi, psi }) {
  const [c, s] = [Math.cos(0.5 * lean), Math.sin(0.5 * lean)];
  const [plus, minus] = [0.5 * (phi + psi), 0.5 * (phi - psi)];
  const attitude = [c * Math.cos(plus), s * Math.cos(minus), s * Math.sin(minus), c * Math.sin(plus)];
  const velocity = [
    precession * Math.sin(lean) * Math.sin(psi) + nutation * Math.cos(psi),
    precession * Math.sin(lean) * Math.cos(psi) - nutation * Math.sin(psi),
    precession * Math.cos(lean) + spin,
  ];
  return { attitude, momentum: velocity.map((value, k) => value * moments[k]) };
}

export function controls(setting) {
  const { moments, mgl, lean, spin, precession, nutation } = setting;
  const size = Math.max(Math.abs(spin), Math.abs(precession), Math.sqrt(Math.abs(mgl) / moments[0]), 1e-6);
  const both = { unit: "rpm", si: RPM, low: -5 * size, high: 5 * size };
  return [
    { key: "moments.0", label: "moment of inertia across, at the point", unit: "kg m²", value: moments[0], log: true, low: Math.max(moments[0] / 10, 0.5 * moments[2]), high: 10 * moments[0] },
    { key: "moments.2", label: "moment of inertia about the axis", unit: "kg m²", value: moments[2], log: true, low: moments[2] / 10, high: Math.min(10 * moments[2], 2 * moments[0]) },
    { key: "mgl", label: "weight × distance to the centre of mass", unit: "N m", value: mgl, low: 0, high: 5 * Math.abs(mgl) || 1 },
    { key: "lean", label: "lean", unit: "°", si: DEGREE, value: lean, low: 0, high: Math.PI },
    { key: "spin", label: "spin about its axis", value: spin, ...both },
    { key: "precession", label: "precession at the start", value: precession, ...both },
    { key: "nutation", label: "nutation at the start", value: nutation, ...both },
  ];
}

export function changed(setting, key, value) {
  const found = { ...setting };
  if (key === "moments.0") found.moments = [value, value, setting.moments[2]];
  else if (key === "moments.2") found.moments = [setting.moments[0], setting.moments[1], value];
  else found[key] = value;
  return { ...found, ...stateOf(found) };
}

export function make({ moments, mgl, momentum, attitude, epoch }) {
  return new LagrangeMotion({ moments, mgl, momentum, attitude, epoch });
}

export function asSpec({ moments, mgl, attitude, lean, spin, precession, nutation }) {
  return { system: { kind: "lagrange-top", moments, mgl, lean }, spin: { spin, precession, nutation_rate: nutation, attitude } };
}

export function withSpec(setting, { system = {}, spin = {} }) {
  let found = { ...setting };
  if (system.moments) found.moments = system.moments.map(Number);
  if (system.mgl !== undefined) found.mgl = Number(system.mgl);
  if (spin.attitude) {
    const attitude = spin.attitude.map(Number);
    const momentum = (spin.momentum ?? setting.momentum).map(Number);
    found = { ...found, ...eulerOf(found.moments, momentum, attitude), attitude, momentum };
  } else if (spin.momentum) {
    const momentum = spin.momentum.map(Number);
    return { ...found, ...eulerOf(found.moments, momentum, found.attitude), momentum };
  }
  const named = { lean: system.lean ?? spin.lean, spin: spin.spin, precession: spin.precession, nutation: spin.nutation_rate };
  const given = Object.entries(named).filter(([, value]) => value !== undefined);
  if (!given.length && !system.moments) return found;
  for (const [name, value] of given) found[name] = Number(value);
  return { ...found, ...stateOf(found) };
}

/** Return the spec as a file: of the bodies with these moments about the point and this weight, one. */
export function toml(setting, span) {
  const { moments, mgl, attitude, momentum } = setting;
  // what the centre of mass leaves of the moments across must still be a body's
  const most = 0.5 * Math.min(0.5 * moments[0], moments[0] - 0.5 * moments[2]);
  const mass = most > 0 && mgl ? (mgl / GRAVITY) ** 2 / most : 1;
  const arm = mgl / (mass * GRAVITY);
  const across = moments[0] - mass * arm * arm;
  const velocity = momentum.map((value, k) => value / moments[k]);
  return `# a body with these moments about its point, ${worded(moments[0])} and ${worded(moments[2])} kg m², and mgl = ${worded(mgl)} N m
[body]
mass = "${exact(mass)} kg"
moments = ["${exact(across)} kg*m^2", "${exact(across)} kg*m^2", "${exact(moments[2])} kg*m^2"]

[system]
kind = "lagrange-top"
pivot = ["0 m", "0 m", "${exact(-arm)} m"]

[spin]
angular_velocity = [${velocity.map((value) => `"${exact(value)} rad/s"`).join(", ")}]
attitude = [${attitude.map(exact).join(", ")}]

[time]
until = "${exact(span)} s"
`;
}

const SEEN = {
  rest: "at rest",
  sleeping: "stands upright and spins",
  hanging: "hangs and spins",
  steady: "goes round at constant lean",
  free: "no weight: turns freely",
  planar: "swings like a pendulum",
  undulating: "nods while it goes round, always onward",
  cusp: "nods, halting at cusps",
  loop: "nods in loops",
  separatrix: "rises to the vertical and stays there",
};

export function facts({ moments, spin, mgl }, solver) {
  const [low, high] = solver.nutationLimits ?? [0, 1];
  const regime = high - low < STEADY && solver.regime === "undulating" ? "steady" : solver.regime;
  const found = [["what it does", SEEN[regime] ?? regime]];
  const period = solver.nutationPeriod;
  const finite = period !== null && Number.isFinite(period);
  if (finite && regime !== "steady") found.push(["nods every", clock(period, period)]);
  if (finite && solver.precessionPerPeriod !== null && solver.regime !== "planar") {
    found.push(["mean precession", perMinute(solver.precessionPerPeriod / period)]);
  }
  if (spin && mgl) found.push(["a gyroscope's, mgl/I₃ω", perMinute(mgl / (moments[2] * spin))]);
  if (mgl > 0) found.push(["sleeps upright from", perMinute((2 * Math.sqrt(mgl * moments[0])) / moments[2])]);
  return found;
}

