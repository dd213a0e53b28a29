// A molecule of one J as its page sets it: one of its levels, or L as sharp as it can be in a direction that is dragged.
import { FreeMotion } from "../../../reference/polhode.js";
import { clock, worded } from "../numbers.js";
import { cloudAbout, unitOf } from "../quantum/cloud.js";
import { Spin } from "../quantum/spin.js";
import { WignerMap } from "../quantum/wigner.js";

const DEGREE = Math.PI / 180;
const SHARP = -1; // in place of the number of a level
const MEMBERS = 400; // of the cloud of classical bodies
const PLOTTED = 500; // times at which the curves are computed
const [ROWS, FINEST] = [[64, 192], 6]; // of the map of a Wigner function, and of these a wave

export const dragged = true;

export const first = ["state.level", "state.lean", "state.towards"]; // of the controls, the others are folded
export const keys = { state: { level: 1, direction: 3 } };

/** Return the setting of what Python wrote down: constants, levels with a point of the polhode of each, the state. */
export function from(model) {
  const spin = model.vectors ? new Spin(model) : null;
  return { ...model, spin, rotor: { map: null }, level: model.level ?? SHARP, first: model.direction };
}

export function controls({ spin, levels, level, direction }) {
  const choices = levels.map(({ name }, k) => [k, name]);
  const state = { key: "state.level", label: spin ? "state" : "level", value: level, choices: spin ? [[SHARP, "L as sharp as it can be"], ...choices] : choices };
  if (level !== SHARP) return [state];
  const { lean, towards } = anglesOf(direction);
  return [
    state,
    { key: "state.lean", label: "L leans from the b axis by", unit: "°", si: DEGREE, value: lean, low: 0, high: Math.PI },
    { key: "state.towards", label: "towards (0° is a, 90° is c)", unit: "°", si: DEGREE, value: towards, low: -Math.PI, high: Math.PI },
  ];
}

const anglesOf = ([a, b, c]) => ({ lean: Math.atan2(Math.hypot(a, c), b), towards: a || c ? Math.atan2(c, a) : 0 });

/** Return the setting after a choice or a slider, values in SI. */
export function changed(setting, key, value) {
  if (key === "state.level") return atLevel(setting, value);
  const { lean, towards } = { ...anglesOf(setting.direction), towards: setting.towards ?? anglesOf(setting.direction).towards, [key.split(".")[1]]: value };
  const direction = [Math.sin(lean) * Math.cos(towards), Math.cos(lean), Math.sin(lean) * Math.sin(towards)];
  return { ...setting, direction, towards, level: SHARP };
}

/** Return the setting at a level, its L where the polhode crosses the plane of a and c, or as near to a unit vector as it comes. */
function atLevel(setting, value) {
  const level = Number(value);
  if (level === SHARP && setting.spin) return { ...setting, level };
  if (!Number.isInteger(level) || !setting.levels[level]) throw new RangeError(`state.level must be a whole number from 0 to ${setting.levels.length - 1}; got ${value}.`);
  return { ...setting, level, direction: setting.levels[level].start };
}

/** Return the setting of what was dragged to: a direction of L, or the level whose polhode is nearest. */
export function withDirection(setting, unit) {
  if (setting.level === SHARP) return { ...setting, direction: unit, towards: null };
  const energy = (u) => u.reduce((sum, part, k) => sum + setting.constants[k] * part * part, 0);
  const wanted = energy(unit);
  const apart = setting.levels.map(({ start }) => Math.abs(energy(start) - wanted));
  const level = apart.indexOf(Math.min(...apart));
  return { ...setting, level, direction: onPolhode(setting.constants, setting.levels[level].start, unit) };
}

/** Return the point of the polhode through `start`, or of its mirror image, that lies at the angle of a unit vector. */
function onPolhode([A, B, C], start, unit) {
  const energy = A * start[0] ** 2 + C * start[2] ** 2; // `start` lies in the plane of a and c
  const above = energy > B;
  const [long, short] = above ? [0, 2] : [2, 0];
  const middle = Math.sqrt((above ? A - energy : energy - C) / (above ? A - B : B - C));
  const narrow = Math.abs(start[short]);
  if (!(narrow > 0) || !Number.isFinite(middle)) return start;
  const angle = Math.atan2(unit[1] / middle, unit[short] / narrow);
  const found = [0, 0, 0];
  [found[short], found[1]] = [narrow * Math.cos(angle), Math.min(1, middle) * Math.sin(angle)];
  found[long] = (unit[long] < 0 ? -1 : 1) * Math.sqrt(Math.max(0, 1 - found[short] ** 2 - found[1] ** 2));
  return unitOf(found);
}

/** The classical body, its L along the direction at first, and the quantum one beside it. */
export class QuantumMotion extends FreeMotion {
  constructor({ moments, constants, momentumSize, attitude, direction, level, levels, spin, rotor, J }) {
    super({ moments, momentum: direction.map((part) => part * momentumSize), attitude, epoch: 0 });
    [this.constants, this.spin, this.J, this.rotor] = [constants, spin, J, rotor];
    this.level = level === SHARP ? null : level;
    this.ladder = levels;
    this.direction = direction;
    this.parts = this.level === null ? spin.parts(spin.coherent(direction)) : null;
    this.wanted = this.level === null ? this.flipping() : null;
  }

  /** How long a window should be [s]: two times that a body takes to leave the middle axis and come back, or periods. */
  flipping() {
    const [A, B, C] = this.constants;
    const rate = 4 * Math.PI * (this.J + 0.5) * Math.sqrt((A - B) * (B - C));
    const period = Number.isFinite(this.period ?? NaN) ? this.period : Infinity;
    const found = Math.min(3 * period, (2 * (2 * Math.log(this.J) + 8)) / rate);
    return Number.isFinite(found) ? found : null;
  }

  /** Return the state of the spin at a time; of a level the same at all times. */
  spinAt(time) {
    return this.parts ? this.spin.at(this.parts, time) : this.spin.level(this.level);
  }

  /** Return the map that Wigner functions are drawn on, made when it is first asked for. */
  get map() {
    const rows = Math.min(ROWS[1], Math.max(ROWS[0], FINEST * this.J));
    this.rotor.map ??= new WignerMap(this.J, this.spin.kernel, rows);
    return this.rotor.map;
  }

  /** Classical bodies spread as the coherent state is; none of a level, which is spread over its polhodes. */
  get cloud() {
    this.members ??= this.parts ? cloudAbout(this.constants, this.J, this.direction, MEMBERS) : [];
    return this.members;
  }

  /** Return what is drawn over time in place of what other bodies have; null for a level, whose ⟨L⟩ is zero. */
  plots(times) {
    if (!this.parts) return null;
    const step = Math.max(1, Math.ceil(times.length / PLOTTED));
    const some = times.filter((_, k) => k % step === 0 || k === times.length - 1);
    const size = Math.hypot(...this.state(0).momentum);
    const quantum = some.map((time) => this.spin.mean(this.spinAt(time)));
    const one = some.map((time) => this.state(time).momentum[1] / size);
    const many = some.map((time) => this.meanOfCloud(time)[1]);
    const series = (name, values) => ({ name, times: some, values });
    return [
      {
        title: "L along the b axis, in |L|", unit: "",
        series: [
          { ...series("quantum ⟨L⟩", quantum.map((mean) => mean[1])), role: "motion" },
          { ...series("one classical body", one), role: "classical" },
          { ...series("mean of classical bodies", many), role: "ensemble" },
        ],
      },
      { title: "quantum ⟨L⟩ along the axes, in J", unit: "", along: true, series: ["a", "b", "c"].map((name, k) => series(name, quantum.map((mean) => mean[k]))) },
    ];
  }

  /** Return the mean of the cloud's L along a, b, c, in J. */
  meanOfCloud(time) {
    const sum = [0, 0, 0];
    for (const member of this.cloud) member.at(time).forEach((part, k) => (sum[k] += part));
    return sum.map((part) => (part / this.cloud.length) * ((this.J + 0.5) / this.J));
  }
}

export const make = (setting) => new QuantumMotion(setting);

export const asSpec = ({ level, direction }) => ({ state: level === SHARP ? { direction } : { level } });

/** Return the setting with what tables say otherwise: a level by its number, or a direction of L along a, b, c. */
export function withSpec(setting, { state = {} }) {
  if (state.direction) {
    if (!setting.spin) throw new RangeError(`state.direction asks for a state of a spin, which the page has up to J = ${setting.largestJ}. Set state.level.`);
    if (!(Math.hypot(...state.direction) > 0)) throw new RangeError("state.direction must not be zero.");
    return { ...setting, level: SHARP, direction: unitOf(state.direction), towards: null };
  }
  return state.level === undefined ? setting : atLevel(setting, state.level);
}

/** Return what is to be said of a state, as pairs. */
export function facts({ level, levels, constants, J, said, direction, first }, solver) {
  if (level !== SHARP) return levels[level].said;
  const energy = (J + 0.5) ** 2 * direction.reduce((sum, part, k) => sum + constants[k] * part * part, 0);
  const found = [["classical energy E/hc", `${worded(energy / 29979245800, 7)} cm⁻¹`]];
  const { period } = solver;
  if (period !== null && Number.isFinite(period)) found.push(["classical L goes round its polhode in", clock(period, period)]);
  return direction === first ? [...found, ...said] : found;
}
