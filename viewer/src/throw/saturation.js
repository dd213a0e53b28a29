// Samples at a gyro's limit: a plateau at the end of its range, which rates reach without slowing.
import { column, noiseOf, quantile, runs, steps } from "./statistics.js";

const FEWEST = 3; // samples of a plateau
const KNOWN = [125, 245, 250, 500, 1000, 2000, 4000, 143.4, 286.7, 573.4, 1146.9, 2293.8, 4587.5].map((value) => (value * Math.PI) / 180);
const OFF_RANGE = 0.0012; // of a known range, by which rounding and scale may move it
const BEYOND = 0.03; // of the largest rate: a limit is that of all axes, up to their gains
const PEAKED = 1.5; // samples down to 4 steps below the top, over those at the top; a smooth peak has 2.2 or more
const SLOWED = 3; // samples down to 16 steps over those down to 4, without the top
const SLOW_EDGE = 3; // samples down to 16 steps at each edge; of fewer it cannot be told whether the rate slowed
const SPREAD = 6; // standard deviations of noise that a noisy plateau is wide
const FINEST = 1e-6; // of the largest rate, to which limits come back alike
const [FAR_FROM_ZERO, FAR_BELOW] = [20, 32]; // steps: of the top from zero, and of the lowest from the top
const MOST = 0.8; // of the samples may be at the limit; what never leaves a value is a steady spin

/** Return the size of rates [rad/s] from which samples of (n, 3) are at the gyro's limit; null where no limit shows. */
export function saturation(rates) {
  const kept = []; // not what a clock repeats
  for (let k = 0; k < rates.length; k += 3) {
    if (k === 0 || [0, 1, 2].some((i) => rates[k + i] !== rates[k - 3 + i])) kept.push(rates[k], rates[k + 1], rates[k + 2]);
  }
  const shown = Float64Array.from(kept);
  if (shown.length / 3 < 2 * FEWEST) return null;
  const largest = Math.max(...[0, 1, 2].map((i) => third(column(shown, i).map(Math.abs))));
  const plateaus = plateausOf(shown).filter(({ level }) => level > (1 - BEYOND) * largest);
  const twin = (one) => plateaus.some(({ axis, side }) => axis !== one.axis || side !== one.side);
  const edges = plateaus.filter((one) => isKnown(one.level) || one.runs > 1 || twin(one)).map(({ edge }) => edge);
  return edges.length ? Math.min(...edges) : null;
}

/** Return the third largest value: a spike or two may be higher. */
const third = (values) => Float64Array.from(values).sort().at(-FEWEST);

const isKnown = (level) => KNOWN.some((range) => Math.abs(level / range - 1) < OFF_RANGE);

function plateausOf(rates) {
  const columns = [0, 1, 2].map((i) => column(rates, i));
  const told = columns.map((values) => {
    const apart = steps(Array.from(new Set(values)).sort((a, b) => a - b));
    return { step: apart.length ? quantile(apart, 0.05) : 0, noise: noiseOf([values], 1) };
  });
  const usual = told.map(({ step }) => step).filter((step) => step > 0);
  const found = [];
  columns.forEach((own, axis) => {
    const most = own.reduce((size, value) => Math.max(size, Math.abs(value)), 0);
    const step = Math.max(usual.length ? Math.min(...usual) : 0, FINEST * most);
    const { noise } = told[axis];
    for (const side of [1, -1]) {
      const values = own.map((value) => side * value);
      const top = third(values);
      for (const [level, unit] of [[top, step], [top - 0.5 * SPREAD * noise, SPREAD * noise]]) {
        const count = unit > 0 && level > FAR_FROM_ZERO * unit ? flatRuns(values, level, unit) : 0;
        if (!count) continue;
        found.push({ edge: unit === step ? top : level - unit / 2, level, axis, side, runs: count });
        break;
      }
    }
  });
  return found;
}

/** Return how often values stay within half a unit of the top, 0 unless they reach it without slowing down. */
function flatRuns(values, top, unit) {
  const depth = values.map((value) => (top - value) / unit);
  const atTop = Array.from(depth, (value) => Math.abs(value) < 0.5 + 1e-6);
  const count = atTop.filter(Boolean).length;
  const within = (most) => depth.reduce((sum, value, k) => sum + Number(value < most && !atTop[k] && value > 0), 0);
  const [near, far] = [within(4.5), within(16.5)];
  if (count < FEWEST || near > (PEAKED - 1) * count) return 0;
  const visits = runs(Array.from(depth, (value) => value < 16.5)).filter(([first, behind]) => atTop.slice(first, behind).filter(Boolean).length >= FEWEST).length;
  const tops = values.filter((_, k) => atTop[k]);
  const [low, high] = tops.reduce(([a, b], value) => [Math.min(a, value), Math.max(b, value)], [Infinity, -Infinity]);
  if (isKnown(top) && high - low <= FINEST * top) return Math.max(visits, 1); // a throw may be at the limit from end to end
  const slowed = far < SLOWED * near && far > SLOW_EDGE * 2 * Math.max(visits, 1);
  const deepest = depth.reduce((most, value) => Math.max(most, value), -Infinity);
  return deepest < FAR_BELOW || count > MOST * values.length || slowed ? 0 : visits;
}
