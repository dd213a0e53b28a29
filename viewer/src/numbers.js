// Numbers as people read them.
import { decimal, say } from "./say.js";

export const SUPERSCRIPTS = { "-": "⁻", 0: "⁰", 1: "¹", 2: "²", 3: "³", 4: "⁴", 5: "⁵", 6: "⁶", 7: "⁷", 8: "⁸", 9: "⁹" };

/** Return a number with so many digits, powers of ten as such. */
export function worded(value, digits = 6) {
  if (value === 0) return "0";
  if (!Number.isFinite(value)) return "—";
  const size = Math.abs(value);
  if (size >= 1e-3 && size < 1e6) {
    const text = size >= 10 ** digits ? String(Number(value.toPrecision(digits))) : value.toPrecision(digits);
    return decimal(text.replace("-", "−"));
  }
  const [mantissa, power] = value.toExponential(digits - 1).split("e");
  const raised = [...power.replace("+", "")].map((sign) => SUPERSCRIPTS[sign]).join("");
  return decimal(`${mantissa}·10${raised}`.replace("-", "−"));
}

const LONG = [
  [31557600, "yr"],
  [86400, "d"],
  [3600, "h"],
  [60, "min"],
];

const SHORT = [[1, "s"], [1e-3, "ms"], [1e-6, "µs"], [1e-9, "ns"], [1e-12, "ps"], [1e-15, "fs"]];

/** Return the unit [s] and its name that fit the length of a motion; null below femtoseconds. */
export function unitOf(span) {
  return LONG.find(([unit]) => span >= 3 * unit) ?? SHORT.find(([unit]) => span >= 0.3 * unit) ?? null;
}

/** Return a time in the unit that fits the length of the motion. */
export function clock(seconds, span) {
  const [unit, name] = unitOf(span) ?? [null];
  return unit ? `${decimal((seconds / unit).toFixed(decimals(span / unit)))} ${say(name)}` : `${worded(seconds, 4)} s`;
}

/** Return a number with so many digits, without powers of ten. */
export const digits = (value, count) => decimal(value.toPrecision(count));

/** Return the range between two angles [rad] in degrees. */
export const degreesBetween = (least, most) => say("{least} to {most}", { least: inDegrees(least), most: inDegrees(most) });

const inDegrees = (angle) => `${worded((angle * 180) / Math.PI, 4)}°`;

/** Return a rate [rad/s] in turns a minute. */
export const perMinute = (rate, count = 4) => say("{number} rpm", { number: worded((rate * 30) / Math.PI, count) });

const decimals = (span) => Math.max(0, Math.min(4, 4 - Math.ceil(Math.log10(Math.max(span, 1e-9)))));

/** Return a number with all its digits, as specs take it. */
export const exact = (value) => String(value);
