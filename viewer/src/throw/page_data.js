// What the page shows of a fitted log: the data of a free body's page, with the measured directions of L on its sphere.
import { row } from "./linear_fit.js";
import { meanRow } from "./statistics.js";

const SAMPLES = 600;

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
  const ratios = `I1/I3 = ${moments[0].toFixed(3)}, I2/I3 = ${moments[1].toFixed(3)}`;
  const body = { type: "body", traced: 1, shape: "box or ellipsoid of the same inertia", surface: null, ellipsoid: null, changed: true, azimuth: Math.atan2(y, x) };
  return {
    name, key: null, summary: `Free flight from ${first.toPrecision(4)} s to ${last.toPrecision(4)} s of the log, and the exact motion of the fitted body: ${ratios}.`,
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
  const read = log.dialect ? `Read as a log of ${log.dialect}, rates in ${log.rateUnit}.` : `Rates are read in ${log.rateUnit}, as chosen.`;
  const bias = fit.bias.map((value) => value.toFixed(3).replace("-", "−")).join(", ");
  const flight = `${windows.length > 1 ? `${windows.length} free flights are found; this one` : "One free flight is found; it"} lasts ${(window.end - window.start).toPrecision(2)} s: ${window.reason}.`;
  return [
    `${read} ${flight}`,
    `${ratios}; the gyro's bias is ${bias} rad/s, ${rest ? "which a rest confirms" : "and no rest in the log confirms it"}.`,
    ...(fit.drag ? [`Drag slows it: c/I3 = ${fit.drag.map((value) => value.toFixed(4).replace("-", "−")).join(", ")} of the torque −c |ω| ω along the axes. The curves are of the free motion that touches it in the middle of the flight.`] : []),
    misfit ?? `The residuals, ${fit.rms.toPrecision(2)} rad/s rms, are those of the noise, ${start.noise.toPrecision(2)} rad/s: within it the log is the motion of a ${fit.drag ? "rigid body with drag" : "free rigid body"}.`,
    ...(limit === null ? [] : [`Samples at the gyro's limit, ${((limit * 180) / Math.PI).toPrecision(4)} deg/s, are left out; ${throws.reduce((sum, { times }) => sum + times.length, 0)} remain.`]),
  ];
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
