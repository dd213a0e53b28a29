// Units in the names of columns, and the headers of known apps. What neither a name nor an app says is never guessed.
export const TIME_UNITS = {
  s: ["sec", "secs", "second", "seconds"],
  ms: ["msec", "millisecond", "milliseconds"],
  us: ["usec", "µs", "μs", "microsecond", "microseconds"],
  ns: ["nsec", "nanosecond", "nanoseconds"],
  min: ["mins", "minute", "minutes"],
};
export const ANGLE_UNITS = { deg: ["°", "degs", "degree", "degrees"], rad: ["rads", "radian", "radians"] };
export const RATE_UNITS = {
  "deg/s": ["°/s", "deg/sec", "degree/s", "degrees/s", "degrees/sec", "dps", "deg s-1", "deg s^-1", "deg_s", "deg_per_s", "deg_per_sec"],
  "rad/s": ["rad/sec", "radian/s", "radians/s", "radians/sec", "rad s-1", "rad s^-1", "rad_s", "rad_per_s", "rad_per_sec"],
  rpm: ["rev/min", "r/min"],
};
export const IN_RADIANS = { "deg/s": Math.PI / 180, "rad/s": 1, rpm: Math.PI / 30 };
const ACCELERATION_UNITS = { "m/s²": 1, "m/s^2": 1, "m/s2": 1, "m/s/s": 1, g: 9.80665 };
const BRACKETED = /^(.*?)\s*[[(]([^\])]*)[\])]\s*$/;

/** Return the unit that a word means; null for none. */
export function findUnit(word, units) {
  const plain = word.trim().toLowerCase().split(/\s+/).join(" ");
  return Object.keys(units).find((unit) => unit === plain || units[unit].includes(plain)) ?? null;
}

/** Return the name of a column without a unit in brackets. */
export function bareName(name) {
  const found = BRACKETED.exec(name);
  return found?.[1] ? found[1] : name.trim();
}

/** Return the unit that a column's name ends in: in brackets, or behind an underscore; null for none. */
export function unitIn(name, units) {
  const found = BRACKETED.exec(name);
  if (found) return findUnit(found[2], units);
  const words = name.trim().toLowerCase().split("_");
  for (let k = Math.min(4, words.length - 1); k > 0; k--) {
    const unit = findUnit(words.slice(-k).join("_"), units); // the longest first
    if (unit) return unit;
  }
  return null;
}

const axes = (words, letters = "xyz") => [...letters].map((letter) => words.replace("{}", letter));

/**
 * How apps name their columns: `time` (the first that is there), its unit and that of the rates where the names do not say
 * it, `gyro` along x, y, z, and `acceleration`, which includes gravity. `perUnit` is m/s² of a unit without a name, or null.
 */
export const DIALECTS = [
  { name: "AndroSensor", time: ["time since start in ms"], timeUnit: "ms", gyro: axes("gyroscope {}"), rateUnit: "rad/s", acceleration: [axes("accelerometer {}")], perUnit: 1 },
  { name: "phyphox", time: ["time"], timeUnit: "s", gyro: axes("gyroscope {}"), rateUnit: "rad/s", acceleration: [axes("acceleration {}"), axes("accelerometer {}")], perUnit: 1 },
  { name: "Sensor Logger", time: ["seconds_elapsed"], timeUnit: "s", gyro: axes("{}"), rateUnit: "rad/s", acceleration: [axes("{}")], perUnit: 1 },
  { name: "Sensor Logger, all in one file", time: ["seconds_elapsed"], timeUnit: "s", gyro: axes("gyroscope_{}"), rateUnit: "rad/s", acceleration: [axes("totalacceleration_{}")], perUnit: 1 },
  { name: "Betaflight", time: ["time"], timeUnit: "us", gyro: axes("gyroadc[{}]", "012"), rateUnit: "deg/s", acceleration: [axes("accsmooth[{}]", "012")], perUnit: null },
];

/** Return the places of the columns of these names, from 0; null where one is missing or comes twice. */
export function findPlaces(names, wanted) {
  const found = wanted.map((name) => names.flatMap((one, k) =>
    (one.trim().toLowerCase() === name || bareName(one).trim().toLowerCase() === name ? [k] : [])));
  return found.every((places) => places.length === 1) ? found.map(([k]) => k) : null;
}

/** Return the place of the column of times, from 0; null for none. */
export function timePlace(names, dialect) {
  for (const name of dialect.time) {
    const found = findPlaces(names, [name]);
    if (found) return found[0];
  }
  return null;
}

/** Return the app that writes such a header; null for an unknown one. */
export const detectDialect = (names) =>
  DIALECTS.find((each) => findPlaces(names, each.gyro) && timePlace(names, each) !== null) ?? null;

/** Return a unit of acceleration in m/s², by the name of a column or by the app; null where neither says it. */
export function accelerationUnit(name, dialect) {
  const ending = name.includes("(") ? name.trim().slice(name.trim().lastIndexOf("(") + 1).replace(/[) ]+$/, "").toLowerCase() : "";
  return ACCELERATION_UNITS[ending] ?? dialect.perUnit;
}
