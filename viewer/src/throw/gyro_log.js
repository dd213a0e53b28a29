// Gyro logs of phones and flight controllers from the text of a file: samples in the order of time, in SI.
import { accelerationUnit, detectDialect, findPlaces, IN_RADIANS, RATE_UNITS, TIME_UNITS, timePlace, unitIn } from "./header_words.js";
import { say } from "../say.js";
import { Refusal } from "./refusal.js";
import { median, steps } from "./statistics.js";
import { DELIMITERS, detectDecimal, detectForm, linesOf, nameColumn, readCells, splitCells } from "./table.js";

const MIN_SAMPLES = 8;
const HICCUPS = 3; // samples at a time that was there already, at most
const COARSE = 0.02; // of the samples at a time that was there already: more is a clock that is rounded
const EVEN = 1.1; // of the clock's step, within which its rounding keeps the times of equal steps
const LARGEST = 1e12; // s, rad/s or m/s²: beyond any clock and sensor
const CLOSEST = 1e-9; // s from sample to sample
const FINEST = 1e-10; // s, to which times must be told
const DIGITS = { s: 0, ms: 3, us: 6, ns: 9 };
const PER_SECOND = { s: 1, ms: 1e3, us: 1e6, ns: 1e9 };
export const EXACT_DIGITS = 40; // behind the point, that stamps keep until they are subtracted

/**
 * Return {form, dialect, lines} of a file: `dialect` the app whose header it has, null where its columns must be chosen.
 *
 * @param text of the file
 * @throws Refusal for what is not a table
 */
export function openTable(text) {
  const lines = linesOf(text);
  for (let k = 0; k < Math.min(lines.length, 2000); k++) {
    for (const delimiter of DELIMITERS) {
      const dialect = detectDialect(splitCells(lines[k].text, delimiter) ?? []);
      if (!dialect) continue;
      const below = lines.slice(k);
      if (!below.slice(1).some((line) => /[^ \t;,]/.test(line.text))) throw new Refusal(say("no sample stands below the header in line {line}. Log again.", { line: lines[k].number }));
      return { form: detectForm(below), dialect, lines };
    }
  }
  return { form: detectForm(lines), dialect: null, lines };
}

/** Return {time, timeUnit, gyro, rateUnit, named} that a header tells; null for what it does not, which is to be chosen. */
export function mappingOf({ form, dialect }) {
  const { names } = form;
  if (dialect) {
    const [time, gyro] = [timePlace(names, dialect), findPlaces(names, dialect.gyro)];
    const named = unitsIn(gyro.map((place) => names[place]), RATE_UNITS);
    return { time, timeUnit: unitIn(names[time], TIME_UNITS) ?? dialect.timeUnit, gyro, rateUnit: unitIn(names[gyro[0]], RATE_UNITS) ? named : dialect.rateUnit };
  }
  const times = names.flatMap((name, k) => (unitIn(name, TIME_UNITS) ? [k] : []));
  const rates = names.flatMap((name, k) => (unitIn(name, RATE_UNITS) ? [k] : []));
  const time = times.length === 1 ? times[0] : null;
  const gyro = rates.length === 3 ? rates : null;
  return {
    time, timeUnit: time === null ? null : unitIn(names[time], TIME_UNITS),
    gyro, rateUnit: gyro && unitsIn(gyro.map((place) => names[place]), RATE_UNITS),
  }; // prettier-ignore
}

/** Return the one unit that names end in; null where they end in none or several. */
function unitsIn(names, units) {
  const found = new Set(names.map((name) => unitIn(name, units)).filter(Boolean));
  return found.size === 1 ? [...found][0] : null;
}

/**
 * Return {times, rates, accelerationTimes, acceleration, dialect, rateUnit, notes} of an opened table.
 *
 * Times (n) [s] increase; rates (n, 3) are in rad/s and accelerations (m, 3) in m/s², flat, along the device's axes;
 * without an accelerometer in the same file both of its arrays are null.
 *
 * @param table as `openTable` returns it
 * @param mapping as `mappingOf` returns it, with what was chosen
 * @throws Refusal for numbers that are none, and for what no log holds
 */
export function readLog({ form, dialect, lines }, mapping) {
  if (mapping.time === null || !mapping.gyro || mapping.gyro.includes(null)) {
    throw new Refusal(say("it is not known which columns have the time and the angular velocities: no app that is known writes such a header. Choose them."));
  }
  const used = [mapping.time, ...mapping.gyro];
  const twice = used.find((place, k) => used.indexOf(place) < k);
  if (twice !== undefined) throw new Refusal(say("{column} is chosen twice. Choose another column for each.", { column: nameColumn(form, twice) }));
  if (!(mapping.rateUnit in IN_RADIANS)) throw new Refusal(say("the unit of the angular velocity is not known: the file does not say it. Choose deg/s, rad/s or rpm."));
  if (!(mapping.timeUnit in TIME_UNITS)) throw new Refusal(say("the unit of the time is not known: the file does not say it. Choose it."));
  const notes = [];
  const felt = dialect ? accelerations(form, dialect, notes) : null;
  const { numbers, texts } = readCells(lines, form, [...used, ...(felt ? felt.places : [])], detectDecimal(lines, form));
  const times = secondsOf(numbers[0], texts, mapping.timeUnit);
  const gyro = clean("rates", times, packed(numbers.slice(1, 4), IN_RADIANS[mapping.rateUnit]));
  if (gyro.times.length < MIN_SAMPLES) throw new Refusal(say("a gyro log must have {least} finite samples at different times; this one has {count}. Log for longer.", { least: MIN_SAMPLES, count: gyro.times.length }));
  const other = felt ? clean("accelerations", times, packed(numbers.slice(4, 7), felt.unit)) : null;
  const has = Boolean(other?.times.length);
  return {
    times: gyro.times, rates: gyro.values, accelerationTimes: has ? other.times : null, acceleration: has ? other.values : null,
    dialect: dialect?.name ?? null, rateUnit: mapping.rateUnit, notes: [...notes, ...gyro.notes],
  }; // prettier-ignore
}

function accelerations(form, dialect, notes) {
  for (const names of dialect.acceleration) {
    const places = names.join() === dialect.gyro.join() ? null : findPlaces(form.names, names);
    if (!places) continue;
    const unit = accelerationUnit(form.names[places[0]], dialect);
    if (unit !== null) return { places, unit };
    notes.push(say("Accelerations are left out, as their unit is not known."));
    return null;
  }
  return null;
}

/** Return columns as one flat array of rows, in another unit. */
function packed(columns, unit) {
  const found = new Float64Array(3 * columns[0].length);
  columns.forEach((values, i) => values.forEach((value, k) => {
    found[3 * k + i] = value * unit;
  }));
  return found;
}

/**
 * Return times [s] from stamps, counted from the first where they have too many digits for doubles.
 *
 * A clock that counts nanoseconds since 1970 has nineteen digits, and a double tells 2.4e-7 s apart there: differences are
 * formed of the digits, before anything is rounded.
 */
function secondsOf(stamps, texts, unit) {
  const rounded = stamps.map((value) => (unit === "min" ? 60 * value : value / PER_SECOND[unit]));
  const largest = rounded.reduce((most, value) => (Number.isFinite(value) ? Math.max(most, Math.abs(value)) : most), 0);
  if (largest === 0 || 2 ** (Math.floor(Math.log2(largest)) - 52) <= FINEST) return rounded;
  let begin = null;
  return rounded.map((value, k) => {
    if (!Number.isFinite(value)) return NaN;
    const exact = exactly(texts[k], DIGITS[unit] ?? 0) * (unit === "min" ? 60n : 1n);
    begin ??= exact;
    return Number(exact - begin) / 10 ** EXACT_DIGITS;
  });
}

/** Return a decimal number, divided by a power of ten, as a whole number of its fortieth digits behind the point. */
function exactly(text, shift) {
  const [, sign, whole, part = "", power = "0"] = /^([+-]?)(\d*)\.?(\d*)(?:[eE]([+-]?\d+))?$/.exec(text.trim());
  const zeros = EXACT_DIGITS - part.length + Number(power) - shift;
  const digits = BigInt(whole + part || "0");
  const value = zeros >= 0 ? digits * 10n ** BigInt(zeros) : digits / 10n ** BigInt(-zeros);
  return sign === "-" ? -value : value;
}

/** Return {times, values, notes} without dropped samples, in the order of time, of samples of one time the first. */
function clean(name, times, values) {
  let kept = Array.from(times.keys()).filter((k) => Number.isFinite(times[k]) && [0, 1, 2].every((i) => Number.isFinite(values[3 * k + i])));
  const notes = [];
  if (kept.length < times.length) notes.push(say("{count} lines without finite values are left out.", { count: times.length - kept.length }));
  const taken = (order) => ({
    t: Float64Array.from(order, (k) => times[k]),
    x: Float64Array.from(order.flatMap((k) => [values[3 * k], values[3 * k + 1], values[3 * k + 2]])),
  });
  let { t, x } = taken(kept);
  checkSizes(name, t, x);
  const between = steps(t);
  const apart = between.filter((step) => step !== 0).map(Math.abs);
  const usual = apart.length ? median(apart) : CLOSEST;
  if (usual < CLOSEST) throw new Refusal(say("times of {what} must lie {least} s apart or more; got {got} s. Check which column has the times, and their unit.", { what: say(name), least: CLOSEST, got: usual }));
  if (between.every((step) => step > 0)) return { times: t, values: x, notes };
  if (between.some((step) => step < 0)) notes.push(say("Lines are not in the order of time; they were sorted."));
  kept = kept.sort((i, j) => times[i] - times[j]); // a stable sort
  ({ t, x } = taken(kept));
  const later = (k) => k === 0 || t[k] > t[k - 1];
  const fresh = (k) => later(k) || [0, 1, 2].some((i) => x[3 * k + i] !== x[3 * k - 3 + i]); // no line that came twice
  const all = Array.from(t.keys());
  const spread = all.filter((k) => fresh(k) && !later(k)).length;
  const coarse = spread >= Math.max(HICCUPS, COARSE * t.length);
  const chosen = all.filter(coarse ? fresh : later);
  if (chosen.length < t.length) notes.push(say("{count} samples come at a time that was there already; the first of each is kept.", { count: t.length - chosen.length }));
  if (coarse) notes.push(say("The clock is rounded: {count} samples come at a time that was there already, with other values; they are taken at equal steps.", { count: spread }));
  const found = taken(chosen.map((k) => kept[k]));
  return { times: coarse ? evenly(found.t) : found.t, values: found.x, notes };
}

function checkSizes(name, t, x) {
  for (const [what, numbers] of [["times", t], [name, x]]) {
    const largest = numbers.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
    if (largest > LARGEST) throw new Refusal(say("{what} must be at most {most} in SI units; got {got}. Check which columns they are, and their unit.", { what: say(what), most: LARGEST, got: largest }));
  }
}

/** Return the times of a coarse clock, with samples of one time at equal steps to the next. */
function evenly(t) {
  const firsts = Array.from(t.keys()).filter((k) => k === 0 || t[k] > t[k - 1]);
  const coarse = firsts.length > 1 ? median(steps(firsts.map((k) => t[k]))) : 0;
  const spread = Float64Array.from(t);
  firsts.forEach((first, j) => {
    const behind = firsts[j + 1] ?? t.length;
    const step = Math.min(behind < t.length ? t[behind] - t[first] : coarse, coarse); // not over a gap
    for (let k = first; k < behind; k++) spread[k] = t[first] + ((k - first) / (behind - first)) * step;
  });
  // samples that come evenly, as far as the clock can tell, came evenly
  const n = t.length;
  const middle = 0.5 * (n - 1);
  const mean = t.reduce((sum, value) => sum + value, 0) / n;
  const slope = t.reduce((sum, value, k) => sum + (k - middle) * (value - mean), 0) / ((n * (n * n - 1)) / 12);
  const off = t.map((value, k) => value - (mean + slope * (k - middle)));
  const [low, high] = off.reduce(([a, b], value) => [Math.min(a, value), Math.max(b, value)], [Infinity, -Infinity]);
  return high - low <= EVEN * coarse ? Float64Array.from({ length: n }, (_, k) => t[0] + slope * k) : spread;
}
