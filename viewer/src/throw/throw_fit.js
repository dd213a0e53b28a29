// From a gyro log to the fitted body, its exact motion, and how far the log is from it.
import { freeFlights, LIMIT } from "./flights.js";
import { fitThrows } from "./free_fit.js";
import { digits } from "../numbers.js";
import { row, startOf } from "./linear_fit.js";
import { decimal, say } from "../say.js";
import { Refusal } from "./refusal.js";
import { restStretches } from "./rests.js";
import { saturation } from "./saturation.js";
import { meanRow, median } from "./statistics.js";

const MIN_SAMPLES = 8;
const MISFIT = 1.4; // times the noise of the samples: larger residuals are not noise
const OUTLYING = 2; // times the noise, that residuals are rms where a few samples do not belong to the flight
const ALIKE = 0.3; // correlation of neighbouring residuals, from which a motion does not explain the data
const UNEXPLAINED = 0.2; // of the rates, that residuals may be
const BETTER = 0.9; // of the residuals without drag, that are left with it
const DRIFT = 0.003; // rad/s, by which a bias in flight differs from that at rest

/** Return {limit, windows, throws}: the free flights of a log, without the samples at the gyro's limit. */
export function throwsOf(log) {
  const limit = saturation(log.rates);
  const windows = freeFlights(log, limit);
  if (!windows.length) {
    throw new Refusal(say("no free flight was found in the log: no stretch of a quarter of a second keeps an angular momentum, or feels no weight. Throw it with a spin of a turn a second or more, and log from before the throw until after the catch."));
  }
  return { limit, windows, throws: windows.map((window) => cut(log, window, limit)) };
}

/** Return the usable samples of a window: {times, elapsed, rates, zero, epoch}, the epoch near the middle. */
function cut({ times, rates }, { start, end }, limit) {
  const used = Array.from(times.keys()).filter((k) => times[k] >= start && times[k] <= end
    && (limit === null || row(rates, k).every((value) => Math.abs(value) < limit * LIMIT)));
  if (used.length < MIN_SAMPLES) throw new Refusal(say("a throw must have {least} samples that are not at the gyro's limit; got {count}. Throw more slowly.", { least: MIN_SAMPLES, count: used.length }));
  const zero = Math.floor(used.length / 2);
  const epoch = times[used[zero]];
  return {
    times: Float64Array.from(used, (k) => times[k]),
    elapsed: Float64Array.from(used, (k) => times[k] - epoch),
    rates: Float64Array.from(used.flatMap((k) => row(rates, k))),
    zero, epoch,
  }; // prettier-ignore
}

/** Return {value, spread} of the bias [rad/s] by the rests outside of the flights; null without one. */
export function restBias(log, windows) {
  const rests = restStretches(log)
    .map(([first, last]) => ({ start: log.times[first], end: log.times[last], mean: meanRow(log.rates, first, last + 1) }))
    .filter((rest) => !windows.some(({ start, end }) => rest.start < end && rest.end > start));
  const total = rests.reduce((sum, { start, end }) => sum + end - start, 0);
  if (!(total > 0)) return null;
  const mean = (of) => [0, 1, 2].map((i) => rests.reduce((sum, rest) => sum + ((rest.end - rest.start) / total) * of(rest, i), 0));
  const value = mean((rest, i) => rest.mean[i]);
  const apart = mean((rest, i) => (rest.mean[i] - value[i]) ** 2);
  return { value, spread: apart.map((square) => Math.hypot(DRIFT, Math.sqrt(square))) };
}

/**
 * Return {throws, windows, limit, start, rest, fit, misfit} of a log.
 *
 * `start` is that of the linear method, `fit` the least squares from it, with drag where the log shows it; `misfit` is a
 * sentence that says where the log is not that motion within its noise, null where it is.
 *
 * @throws Refusal where no flight is found, or the flights do not determine the inertia
 */
export function fitLog(log) {
  const { limit, windows, throws } = throwsOf(log);
  const start = startOf(throws);
  if (start.degenerate) throw new Refusal(start.degenerate);
  const rest = restBias(log, windows);
  const free = fitThrows(start, throws, rest);
  // drag is asked for only where the free motion does not explain the log, and kept where it explains clearly more
  const slowed = misfitOf(free, start.noise) && fitThrows(start, throws, rest, true);
  const fit = slowed && slowed.rms < BETTER * free.rms ? slowed : free;
  const squares = throws.flatMap(({ rates }) => Array.from(rates, (value) => value * value));
  const size = Math.sqrt(squares.reduce((sum, value) => sum + value, 0) / squares.length);
  if (!(fit.rms < UNEXPLAINED * size)) {
    throw new Refusal(say("no free motion of a rigid body explains the log: the residuals, {residuals} rad/s, are not small beside the rates, {rates} rad/s. Check columns and units, or log a free flight.", { residuals: digits(fit.rms, 2), rates: digits(size, 2) }));
  }
  return { throws, windows, limit, start, rest, fit, misfit: misfitOf(fit, start.noise) };
}

function misfitOf({ residuals, rms, drag }, noise) {
  const sizes = residuals.flatMap((part) => Array.from(part, Math.abs));
  const [above, total] = [median(sizes) / 0.6745, sizes.reduce((sum, value) => sum + value * value, 0)];
  const products = residuals.reduce((sum, part) => sum + part.slice(3).reduce((one, value, k) => one + value * part[k], 0), 0);
  const alike = products / Math.max(total, 1e-300);
  const times = (ratio) => (ratio < 100 ? digits(ratio, 2) : ratio.toFixed(0));
  let why = null;
  if (above > MISFIT * noise) why = say("{times} times the noise of a sample", { times: times(above / noise) });
  else if (alike > ALIKE) why = say("alike from sample to sample (correlation {correlation})", { correlation: decimal(alike.toFixed(2)) });
  else if (rms > OUTLYING * noise) why = say("larger than the noise at a few samples, up to {most} rad/s", { most: digits(Math.max(...sizes), 2) });
  if (!why) return null;
  const numbers = { rms: digits(rms, 2), noise: digits(noise, 2), why };
  const said = drag
    ? "The log is not the motion of a rigid body with drag within its noise: the residuals ({rms} rad/s rms, noise {noise} rad/s) are {why}."
    : "The log is not a free rigid body's motion within its noise: the residuals ({rms} rad/s rms, noise {noise} rad/s) are {why}.";
  return `${say(said, numbers)} ${say("A gyro's gains, a clock that jitters or a catch within the window do that; polhode fit fits gains too, and gives errors.")}`;
}
