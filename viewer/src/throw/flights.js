// Where in a log a body flies freely: by its accelerometer, or by its constant angular momentum.
import { momentumStretches, ofOneBody, stretchInside, UNEVEN } from "./momentum_flight.js";
import { biasOf } from "./rests.js";
import { column, median, place, quantile, roundEven, steps } from "./statistics.js";
import { weightlessStretches } from "./weightless_flight.js";

const MIN_SAMPLES = 8;
const SHORTEST = 0.25; // s
const SHORTEST_TOLD = 0.15; // s; what is shorter is not worth a word
const [FINE, FINE_TURN] = [0.004, 0.1]; // s and rad: means over so much show all that is looked for
const MOST_TRIMMED = 0.1; // s at each end of a stretch without weight, where a hand may still turn it
export const LIMIT = 1 - 1e-6; // of the gyro's limit, from which samples are at it

/**
 * Return the windows {start, end, reason} of free flight [s], in the order of time; none where there are none.
 *
 * @param log as `readLog` returns it
 * @param limit size of rates [rad/s] from which samples are at the gyro's limit; null for none
 */
export function freeFlights(log, limit = null) {
  const bias = biasOf(log);
  const { t, rates } = thin(log.times, log.rates.map((value, k) => value - bias[k % 3]));
  const found = log.acceleration ? byWeight(log, t, rates) : byMomentum(t, rates);
  const usable = Array.from(log.times).filter((_, k) => limit === null || [0, 1, 2].every((i) => Math.abs(log.rates[3 * k + i]) < limit * LIMIT));
  return found.filter(({ start, end }) => place(usable, end, true) - place(usable, start) >= MIN_SAMPLES);
}

/** Return means over a few samples where samples come faster than a flight needs them. */
function thin(t, rates) {
  const step = median(steps(t));
  const largest = Float64Array.from(t, (_, k) => Math.max(...[0, 1, 2].map((i) => Math.abs(rates[3 * k + i]))));
  const fastest = quantile(largest, 0.999);
  const many = step > 0 ? Math.trunc(Math.min(FINE, FINE_TURN / Math.max(fastest, 1e-9)) / step) : 1;
  const count = Math.floor(t.length / many);
  if (many < 2 || count < 2 * MIN_SAMPLES) return { t, rates };
  const mean = (values) => Float64Array.from({ length: count }, (_, k) => {
    let sum = 0;
    for (let j = k * many; j < (k + 1) * many; j++) sum += values[j];
    return sum / many;
  });
  const columns = [0, 1, 2].map((i) => mean(column(rates, i)));
  return { t: mean(t), rates: Float64Array.from({ length: 3 * count }, (_, k) => columns[k % 3][Math.floor(k / 3)]) };
}

function byMomentum(t, rates) {
  const long = momentumStretches(t, rates, SHORTEST_TOLD).filter(({ first, last }) => t[last] - t[first] >= SHORTEST);
  const [used] = ofOneBody(t, rates, long);
  return used.map(({ first, last }) => ({ start: t[first], end: t[last], reason: "keeps an angular momentum" }));
}

function byWeight(log, t, rates) {
  const clock = log.accelerationTimes;
  return weightlessStretches(log, SHORTEST_TOLD)
    .map(({ first, last }) => ({ start: clock[first], end: clock[last], reason: "the accelerometer feels no weight" }))
    .filter(({ start, end }) => end - start >= SHORTEST)
    .map((window) => trimmed(t, rates, window));
}

/** Return a window without ends at which a torque acts: a hand that carries no weight may still turn the device. */
function trimmed(t, rates, window) {
  const [begin, behind] = [place(t, window.start), place(t, window.end, true)];
  if (behind - begin < MIN_SAMPLES) return window;
  const found = stretchInside(t.slice(begin, behind), rates.slice(3 * begin, 3 * behind));
  if (!found || found.change > UNEVEN) return window;
  const [start, end] = [t[begin + found.first], t[begin + found.last]];
  if (start - window.start > MOST_TRIMMED || window.end - end > MOST_TRIMMED || end - start < SHORTEST) return window;
  return {
    ...window,
    start: found.first === 0 ? window.start : start,
    end: found.last === behind - begin - 1 ? window.end : end,
  };
}
