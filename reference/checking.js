// What the motions ask of their arguments. A RangeError says which value is wrong, what it must be, and what to do.
import { twoSum } from "./formulas/arithmetic.js";

const UNIT_TOLERANCE = 1e-6; // a quaternion further from unit length is taken for a mistake, not for rounding
const MOST_RADIANS = 1e27; // of a phase, which has 104 bits

const shown = (value) => {
  const text = String(JSON.stringify(value, (_, x) => (typeof x === "number" && !Number.isFinite(x) ? String(x) : x)));
  return text.length > 80 ? `${text.slice(0, 77)}...` : text;
};

/** Return the value; refuse what is not a finite number. */
export function finite(name, value, unit) {
  if (typeof value === "number" && Number.isFinite(value)) return value;
  throw new RangeError(`\`${name}\` must be a finite number; got ${shown(value)}. Give it in ${unit}.`);
}

/** Return an array of `count` finite numbers. */
export function vector(name, value, count, unit) {
  const found = value != null && typeof value === "object" ? Array.from(value) : [];
  if (found.length === count && found.every((x) => typeof x === "number" && Number.isFinite(x))) return found;
  throw new RangeError(`\`${name}\` must be ${count} finite numbers; got ${shown(value)}. Give them in ${unit}.`);
}

export function positiveMoments(value) {
  const moments = vector("moments", value, 3, "kg m²");
  if (moments.every((x) => x > 0)) return moments;
  throw new RangeError(
    `\`moments\` must be positive; got ${shown(moments)} kg m². A body with a zero moment (a thin rod) cannot spin about ` +
      "that axis; check values and units.",
  );
}

export function unitQuaternion(value) {
  const q = vector("attitude", value, 4, "w, x, y, z");
  if (Math.abs(Math.hypot(...q) - 1) < UNIT_TOLERANCE) return q;
  throw new RangeError(
    `\`attitude\` must be a unit quaternion w, x, y, z; got ${shown(q)}. Divide it by its norm, and check that the scalar ` +
      "comes first.",
  );
}

/** Return the time since the epoch, and what is left of it where that is no double; refuse times whose phases have hardly a digit left. */
export function elapsedTime(t, epoch, fastest) {
  finite("t", t, "seconds");
  const [elapsed, rest] = twoSum(t, -epoch);
  if (Math.abs(elapsed) * fastest <= MOST_RADIANS) return [elapsed, rest];
  throw new RangeError(
    `\`t\` less the epoch, times the rate of rotation, must be at most ${MOST_RADIANS} rad, beyond which a phase has hardly a ` +
      `digit left; got ${t} s. Check times and rates.`,
  );
}

/** Refuse a motion whose numbers have left the range of doubles. */
export function checkedRange(columns) {
  if (columns.every(Number.isFinite)) return;
  throw new RangeError("moments, momentum or their ratios leave the range of doubles: choose other units.");
}

/** Return seven numbers as {attitude, momentum}. */
export const asState = ([w, x, y, z, a, b, c]) => ({ attitude: [w, x, y, z], momentum: [a, b, c] });

/** Return a number, or null for what is undefined. */
export const orNull = (x) => (Number.isNaN(x) ? null : x);
