// What the page shows of a fitted log: the data of a free body's page, with the measured directions of L on its sphere.
import { digits } from "../numbers.js";
import { listed, say } from "../say.js";
import { row } from "./linear_fit.js";
import { meanRow } from "./statistics.js";

const SAMPLES = 600;
const ROUGH = 2; // digits of estimates where residuals are not noise, so that nothing is known of their errors

/**
 * Return the data of the page of one throw, as Python writes them for a motion, and `story`: sentences on the fit.
 *
 * @param found as `fitLog` returns it
 * @param log as `readLog` returns it
 * @param name of the file
 * @param which of the throws
 */
export function dataOf(found, log, name, which = 0) {
  const { throws, windows } = found;
  const [fit, one] = [seenFromAbove(found.fit, throws[which]), throws[which]];
  const { moments } = fit;
  const measured = directions(fit, one);
  const [x, y] = meanRow(measured);
  const momentum = fit.starts[which].map((value, k) => value * moments[k]);
  const [first, last] = [one.times[0], one.times.at(-1)];
  const times = Float64Array.from({ length: SAMPLES }, (_, k) => first + ((last - first) * k) / (SAMPLES - 1));
  const rough = found.misfit !== null;
  const ratios = listed([0, 1].map((k) => `I${k + 1}/I3 ${rough ? "≈" : "="} ${inDigits(moments[k], 3, rough)}`));
  const body = { type: "body", traced: 1, shape: "box or ellipsoid of the same inertia", surface: null, ellipsoid: null, changed: true, azimuth: Math.atan2(y, x) };
  return {
    name, key: null, summary: say("Free flight from {begin} s to {end} s of the log, and the exact motion of the fitted body: {ratios}.", { begin: digits(first, 4), end: digits(last, 4), ratios }),
    notes: ["A gyro tells the moments up to a common factor: on this page the largest is 1 kg m².", ...log.notes],
    panels: [
      body,
      { type: "sphere", title: "Momentum sphere", legend: "other polhodes", words: "L in body axes runs along its polhode; dots are the log's samples", measured },
      { type: "poinsot" },
    ],
    drift: {}, scatters: [], plots: [], times: packed(times), joined: true, space: null, up: "L", free: moments,
    energyName: "energy", energyUnit: "J",
    model: { solver: "FreeMotion", moments, momentum, attitude: [1, 0, 0, 0], epoch: one.epoch },
    story: storyOf(found, log, windows[which], ratios),
  }; // prettier-ignore
}

function storyOf({ throws, windows, limit, start, rest, fit, misfit }, log, window, ratios) {
  const read = log.dialect
    ? say("Read as a log of {app}, rates in {unit}.", { app: log.dialect, unit: log.rateUnit })
    : say("Rates are read in {unit}, as chosen.", { unit: log.rateUnit });
  const duration = digits(window.end - window.start, 2);
  const flight = windows.length > 1
    ? say("{count} free flights are found; this one lasts {duration} s: {reason}.", { count: windows.length, duration, reason: say(window.reason) })
    : say("One free flight is found; it lasts {duration} s: {reason}.", { duration, reason: say(window.reason) });
  const rough = misfit !== null;
  const bias = listed(fit.bias.map((value) => inDigits(value, 3, rough)));
  const confirmed = rest
    ? "{ratios}; the gyro's bias is {bias} rad/s, which a rest confirms."
    : "{ratios}; the gyro's bias is {bias} rad/s, and no rest in the log confirms it.";
  const small = fit.drag
    ? "The residuals, {rms} rad/s rms, are those of the noise, {noise} rad/s: within it the log is the motion of a rigid body with drag."
    : "The residuals, {rms} rad/s rms, are those of the noise, {noise} rad/s: within it the log is the motion of a free rigid body.";
  return [
    `${read} ${flight}`,
    say(confirmed, { ratios, bias }),
    ...(fit.drag ? [ofDrag(fit.drag, rough)] : []),
    misfit ?? say(small, { rms: digits(fit.rms, 2), noise: digits(start.noise, 2) }),
    ...(limit === null ? [] : [atLimit(limit, throws)]),
  ];
}

/** Return an estimate in decimals, or in two digits where nothing is known of its error. */
function inDigits(value, decimals, rough) {
  return (rough ? digits(value, ROUGH) : value.toFixed(decimals)).replace("-", "−");
}

function ofDrag(drag, rough) {
  const numbers = listed(drag.map((value) => inDigits(value, 4, rough)));
  const touching = say("The curves are of the free motion that touches it in the middle of the flight.");
  return `${say("Drag slows it: c/I3 = {numbers} of the torque −c |ω| ω along the axes.", { numbers })} ${touching}`;
}

function atLimit(limit, throws) {
  const count = throws.reduce((sum, { times }) => sum + times.length, 0);
  return say("Samples at the gyro's limit, {limit} deg/s, are left out; {count} remain.", { limit: digits((limit * 180) / Math.PI, 4), count });
}

/** Return a fit with its principal axes turned by half turns, so that the samples of L lie at positive L1 and L3. */
function seenFromAbove(fit, one) {
  const mean = meanRow(directions(fit, one));
  const signs = [mean[0] < 0 ? -1 : 1, 1, mean[2] < 0 ? -1 : 1];
  signs[1] = signs[0] * signs[2];
  const turned = (line) => line.map((value, k) => signs[k] * value);
  return { ...fit, axes: fit.axes.map(turned), starts: fit.starts.map(turned) };
}

/** Return the directions (n, 3) of L along the principal axes that a throw's samples have, flat. */
function directions({ moments, axes, bias }, { rates, times }) {
  return Array.from(times, (_, j) => {
    const w = row(rates, j).map((value, i) => value - bias[i]);
    const L = moments.map((moment, k) => moment * (axes[0][k] * w[0] + axes[1][k] * w[1] + axes[2][k] * w[2]));
    const size = Math.hypot(...L) || 1;
    return L.map((value) => value / size);
  }).flat();
}

/** Return an array as pages hold it. */
function packed(values) {
  let text = "";
  for (const byte of new Uint8Array(values.buffer)) text += String.fromCharCode(byte);
  return { kind: "f8", shape: [values.length], data: btoa(text) };
}
