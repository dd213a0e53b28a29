// Where in a log the device lies still, so that its gyro shows its bias alone.
import { column, lengths, meanRow, median, place, roundEven, runs, steps } from "./statistics.js";

const SHORTEST = 0.3; // s
const MEAN_OVER = 0.1; // s: means over it keep the noise small and show a hand's tremor
const WANDER = 0.015; // rad/s, by which means over MEAN_OVER may differ within a stretch
const LARGEST_BIAS = 0.35; // rad/s, its length: what one stretch may show alone
const LARGEST_OF_AN_AXIS = 0.6; // rad/s: so slow may a body turn too
const HANDLED = 1; // rad/s, by which the rates leave the bias between two rests
const BIASES_APART = 0.03; // rad/s
const GRAVITY = [8.8, 10.8]; // m/s², as accelerometers that are a few percent off feel it
const TILT = 0.3; // m/s², by which what is felt may change within SHORTEST

/** Return [first, last] sample of the stretches in which the device lies still, in the order of time. */
export function restStretches({ times, rates, accelerationTimes, acceleration }) {
  const { means, size } = meansOver(times, rates);
  const wander = WANDER + 0.5 * stepBetweenValues(rates);
  const still = steady(means, size, wander);
  const gaps = steps(times);
  times.forEach((_, k) => {
    if ((gaps[k - 1] ?? 0) >= SHORTEST || (gaps[k] ?? 0) >= SHORTEST) still[k] = false;
  });
  if (acceleration) {
    const weighed = weightIsConstant(accelerationTimes, acceleration, times);
    still.forEach((flag, k) => {
      still[k] = flag && weighed[k];
    });
  }
  const small = lengths(means).map((size_) => size_ < LARGEST_BIAS);
  let found = alike(stretchesOf(still.map((flag, k) => flag && Boolean(small[k])), times), times, rates);
  if (found.length) return found;
  const slow = (k) => [0, 1, 2].every((i) => Math.abs(means[3 * k + i]) < LARGEST_OF_AN_AXIS);
  found = alike(stretchesOf(still.map((flag, k) => flag && slow(k)), times), times, rates);
  return acceleration || isHandledBetween(found, rates) ? found : [];
}

/** Return the mean rates [rad/s] while the device lies still, zero where it never does. */
export function biasOf(log) {
  const still = restStretches(log);
  const sum = [0, 0, 0];
  let count = 0;
  for (const [first, last] of still) {
    const mean = meanRow(log.rates, first, last + 1);
    const n = last + 1 - first;
    for (let i = 0; i < 3; i++) sum[i] += mean[i] * n;
    count += n;
  }
  return count ? sum.map((value) => value / count) : sum;
}

/** Return the stretches whose mean is near that of the longest. */
function alike(stretches, t, rates) {
  if (!stretches.length) return [];
  const means = stretches.map(([i, j]) => meanRow(rates, i, j + 1));
  let longest = 0;
  stretches.forEach(([i, j], k) => {
    if (t[j] - t[i] > t[stretches[longest][1]] - t[stretches[longest][0]]) longest = k;
  });
  return stretches.filter((_, k) => Math.hypot(...means[k].map((value, i) => value - means[longest][i])) < BIASES_APART);
}

/** Whether the device was moved between two of the stretches, and shows the same rates before and after. */
function isHandledBetween(stretches, rates) {
  if (stretches.length < 2) return false;
  const bias = meanRow(rates, stretches[0][0], stretches[0][1] + 1);
  return stretches.slice(1).some(([next], k) => {
    for (let j = stretches[k][1]; j < next; j++) if (Math.hypot(...bias.map((value, i) => rates[3 * j + i] - value)) > HANDLED) return true;
    return false;
  });
}

/** Return means over MEAN_OVER, which at the ends go on as the last sample, and over how many samples SHORTEST is. */
function meansOver(t, rows) {
  const step = median(steps(t));
  const wide = Math.max(1, roundEven(MEAN_OVER / step));
  const n = t.length;
  const before = Math.floor(wide / 2);
  const means = new Float64Array(rows.length);
  for (let i = 0; i < 3; i++) {
    for (let k = 0; k < n; k++) {
      let sum = 0;
      for (let j = k - before; j < k - before + wide; j++) sum += rows[3 * Math.min(Math.max(j, 0), n - 1) + i];
      means[3 * k + i] = sum / wide;
    }
  }
  return { means, size: Math.max(2, roundEven(SHORTEST / step)) };
}

/** Return the usual step between the values that a gyro rounds to [rad/s]; zero where it hardly rounds. */
function stepBetweenValues(rates) {
  const values = [...new Set(Array.from(rates.slice(0, 60000), (value) => roundEven(value * 1e9) / 1e9))].sort((a, b) => a - b);
  return values.length > 1 ? median(steps(values)) : 0;
}

/** Return which samples belong to a stretch of so many in which no component wanders. */
function steady(means, size, wander) {
  const n = means.length / 3;
  const before = Math.floor(size / 2);
  const whole = new Array(n).fill(true);
  for (let i = 0; i < 3; i++) {
    const values = column(means, i);
    for (let k = 0; k < n; k++) {
      if (!whole[k]) continue;
      if (k < before || k >= n - Math.floor((size - 1) / 2)) {
        whole[k] = false; // stretches that reach beyond the log
        continue;
      }
      let [low, high] = [Infinity, -Infinity];
      for (let j = k - before; j < k - before + size; j++) {
        low = Math.min(low, values[j]);
        high = Math.max(high, values[j]);
      }
      whole[k] = high - low < wander;
    }
  }
  const found = new Array(n).fill(false);
  for (let k = 0; k < n; k++) if (whole[k]) for (let j = k - before; j < k - before + size; j++) found[j] = true;
  return found;
}

function weightIsConstant(clock, felt, t) {
  if (clock.length < 2) return Array.from(t, () => false);
  const { means, size } = meansOver(clock, felt);
  const weight = lengths(means);
  const calm = steady(means, size, TILT).map((flag, k) => flag && weight[k] > GRAVITY[0] && weight[k] < GRAVITY[1]);
  return Array.from(t, (time) => {
    if (time < clock[0] || time > clock.at(-1)) return false;
    const k = Math.min(Math.max(place(clock, time, true) - 1, 0), clock.length - 2);
    const part = (time - clock[k]) / (clock[k + 1] - clock[k]);
    return (1 - part) * Number(calm[k]) + part * Number(calm[k + 1]) > 0.5;
  });
}

/** Return the first and last sample of each long enough run, whose ends a mean has spread over are cut off. */
function stretchesOf(still, t) {
  const found = [];
  for (const [first, behind] of runs(still)) {
    const start = first === 0 ? 0 : place(t, t[first] + MEAN_OVER / 2);
    const last = behind === t.length ? behind - 1 : place(t, t[behind - 1] - MEAN_OVER / 2, true) - 1;
    if (last > start && t[last] - t[start] >= SHORTEST - MEAN_OVER) found.push([start, last]);
  }
  return found;
}
