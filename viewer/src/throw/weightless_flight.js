// Free flights by the accelerometer, which then feels only its rotation about the centre of mass.
import { row } from "./linear_fit.js";
import { cross, determinant, solve } from "./matrices.js";
import { median, place, roundEven, runs, steps } from "./statistics.js";

const SPAN = 0.3; // s, over which a stretch is judged
const LEVER_ARM = 0.05; // m, how far from the centre of mass an accelerometer is expected to sit
const LONGEST_ARM = 0.35; // m
const FELT = 3; // m/s², what a free accelerometer may feel beyond its own turning; one that is held feels 9.8
const [LEAST_FELT, OWN_FELT] = [1, 4]; // m/s², and times what is usual in the stretch: more at its ends is a hand
const GAP = 0.02; // s, of a spike

/**
 * Return the stretches {first, last} of the accelerometer without weight, in the order of time.
 *
 * In flight an accelerometer at place r feels ω × (ω × r) + ω̇ × r. One r is fitted for the whole log, within what a
 * hand-held device has.
 */
export function weightlessStretches(log, shortest) {
  const [t, felt] = [log.accelerationTimes, log.acceleration];
  const step = t.length > 1 ? median(steps(t)) : SPAN;
  const size = Math.max(3, roundEven(SPAN / step));
  if (t.length < size) return [];
  const lever = leversOf(log);
  const at = placeOf(log, lever, size);
  if (!at) return [];
  const beyond = Float64Array.from(t, (_, k) => Math.hypot(...lever[k].map((line, i) => felt[3 * k + i] - line[0] * at[0] - line[1] * at[1] - line[2] * at[2])));
  const free = Array.from(t, (time, k) => beyond[k] < FELT && time >= log.times[0] && time <= log.times.at(-1));
  const found = [];
  for (const [begin, behind] of joined(runs(free), Math.max(2, roundEven(GAP / step)))) {
    const limit = Math.max(LEAST_FELT, OWN_FELT * median(beyond.slice(begin, behind)));
    let [first, last] = [begin, behind - 1];
    while (beyond[first] >= limit) first += 1;
    while (beyond[last] >= limit) last -= 1;
    if (t[last] - t[first] >= shortest) found.push({ first, last });
  }
  return found;
}

/** Return runs over gaps of so many false flags. */
function joined(found, gap) {
  const kept = [];
  for (const [first, behind] of found) {
    if (kept.length && first - kept.at(-1)[1] <= gap) kept.at(-1)[1] = behind;
    else kept.push([first, behind]);
  }
  return kept;
}

/** Return the maps (n, 3, 3) from a place to what an accelerometer there feels of turning. */
function leversOf(log) {
  const slopes = gradient(log.times, log.rates);
  return Array.from(log.accelerationTimes, (time) => {
    const [rate, turning] = [log.rates, slopes].map((rows) => interpolated(log.times, rows, time));
    const columns = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map((unit) => {
      const [inward, along] = [cross(rate, cross(rate, unit)), cross(turning, unit)];
      return inward.map((value, i) => value + along[i]);
    });
    return [0, 1, 2].map((i) => columns.map((one) => one[i]));
  });
}

/** Return the slopes of rows over uneven times: of the parabola through three neighbours, at the ends of the line. */
function gradient(t, rows) {
  const found = new Float64Array(rows.length);
  const last = t.length - 1;
  for (let k = 0; k <= last; k++) {
    for (let i = 0; i < 3; i++) {
      const value = (j) => rows[3 * j + i];
      if (k === 0 || k === last) {
        const j = k === 0 ? 0 : last - 1;
        found[3 * k + i] = (value(j + 1) - value(j)) / (t[j + 1] - t[j]);
        continue;
      }
      const [a, b] = [t[k] - t[k - 1], t[k + 1] - t[k]];
      found[3 * k + i] = (a * a * value(k + 1) + (b * b - a * a) * value(k) - b * b * value(k - 1)) / (a * b * (a + b));
    }
  }
  return found;
}

function interpolated(t, rows, time) {
  if (time <= t[0]) return row(rows, 0);
  if (time >= t.at(-1)) return row(rows, t.length - 1);
  const k = place(t, time, true) - 1;
  const part = (time - t[k]) / (t[k + 1] - t[k]);
  const next = row(rows, k + 1);
  return row(rows, k).map((value, i) => value + part * (next[i] - value));
}

/** Return the place of the accelerometer that explains a calm span best; null where no span is calm. */
function placeOf(log, lever, size) {
  const [t, felt] = [log.accelerationTimes, log.acceleration];
  const spans = [];
  for (let begin = 0; begin + size <= t.length; begin += Math.max(1, Math.floor(size / 8))) {
    if (t[begin] < log.times[0] || t[begin + size - 1] > log.times.at(-1)) continue;
    // least squares of f = L r; a small penalty on r holds it where the turning does not tell it
    const normal = [0, 1, 2].map((i) => [0, 1, 2].map((j) => (i === j ? 1e-3 / LEVER_ARM ** 2 : 0)));
    const right = [0, 0, 0];
    let square = 0;
    for (let k = begin; k < begin + size; k++) {
      const f = row(felt, k);
      for (let m = 0; m < 3; m++) {
        square += (f[m] * f[m]) / size;
        for (let i = 0; i < 3; i++) {
          right[i] += (lever[k][m][i] * f[m]) / size;
          for (let j = 0; j < 3; j++) normal[i][j] += (lever[k][m][i] * lever[k][m][j]) / size;
        }
      }
    }
    const at = solve(normal, right);
    // at the minimum, where N r = b, the mean of |f − L r|² and the penalty together are ⟨f²⟩ − r·b
    const left = at && square - at.reduce((sum, value, i) => sum + value * right[i], 0);
    if (at && left < FELT ** 2 && Math.hypot(...at) < LONGEST_ARM) spans.push({ tells: determinant(normal), left, at });
  }
  if (!spans.length) return null;
  const most = Math.max(...spans.map(({ tells }) => tells));
  const telling = spans.filter(({ tells }) => tells >= 0.1 * most); // of those whose turning tells enough of it
  return telling.reduce((best, one) => (one.left < best.left ? one : best)).at;
}
