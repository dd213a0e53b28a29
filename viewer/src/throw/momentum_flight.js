// Free flights in the log of a gyro alone: where one inertia J keeps R J ω constant.
import { integrateRates, inertiaMatrix, meanMap, momentumMaps } from "./linear_fit.js";
import { eigenSymmetric } from "./matrices.js";
import { lengths, median, roundEven, runs, steps } from "./statistics.js";

const SPANS = [0.3, 0.6, 1.2, 2.4]; // s, over which stretches are judged; the slower the turning, the longer
const TURN = 2; // rad, of which a span holds at least so much
const SLOWEST = 1; // rad/s: slower turning says nothing of inertia
export const UNEVEN = 0.03; // change of angular momentum relative to its size, within a span
const TORQUE = [0.3, 1]; // 1/s, of the angular momentum: drag and a bias give some tenths, hands several
const OWN_TORQUE = 3; // times the usual one within the span: more is another motion
const HOP = 0.07; // s, over which a noisy gyro's torque is judged at most
const MOST_ROUNDS = 4;
const PLANE = 12; // inertias that are asked in a plane of them
const STRIDES = 6; // spans begin so often within the length of one
const MOST_AT_ONCE = 20000; // samples
const BROKEN = 0.1; // s: longer steps between samples end a stretch

/** Return the stretches {first, last, change, turn} with constant angular momentum, in the order of time. */
export function momentumStretches(t, rates, shortest) {
  const found = [];
  for (const [first, last] of turningParts(t, lengths(rates))) {
    for (let begin = first; begin <= last; begin += MOST_AT_ONCE / 2) {
      const end = Math.min(begin + MOST_AT_ONCE, last + 1);
      if (t[end - 1] - t[begin] >= shortest) found.push(...stretchesWithin(t.slice(begin, end), rates.slice(3 * begin, 3 * end), shortest, begin));
      if (end > last) break;
    }
  }
  return apart(found);
}

/** Return the stretch without torque that holds the middle half of some samples; null where there is none. */
export function stretchInside(t, rates) {
  const maps = momentumMaps(integrateRates(t, rates), rates);
  const quarter = Math.floor(t.length / 4);
  const [begin, end] = [quarter, t.length - quarter];
  const grown = grow(t, maps, begin, end, fitInertia(maps, begin, end).inertia);
  if (!grown || grown.first > begin || grown.last < end - 1) return null;
  return { ...grown, change: changeOf(maps, grown.first, grown.last + 1, grown.inertia) };
}

/**
 * Return [those, others] of the stretches: those that one inertia explains together, which turn furthest.
 *
 * Handling may keep some momentum constant for a moment, with an inertia that fits nowhere else.
 */
export function ofOneBody(t, rates, stretches) {
  const spreads = stretches.map(({ first, last, change }) => {
    const part = rates.slice(3 * first, 3 * last + 3);
    const maps = momentumMaps(integrateRates(t.slice(first, last + 1), part), part);
    return { ...spreadOf(maps, 0, last + 1 - first), change };
  });
  const order = stretches.map((_, k) => k).sort((i, j) => stretches[j].turn - stretches[i].turn);
  const groups = [];
  for (const k of order) {
    const home = groups.find((group) => agree([...group, k].map((j) => spreads[j])));
    if (home) home.push(k);
    else groups.push([k]);
  }
  let [best, most] = [[], -Infinity];
  for (const group of groups) {
    const turn = group.reduce((sum, k) => sum + stretches[k].turn, 0);
    if (turn > most) [best, most] = [group, turn];
  }
  return [stretches.filter((_, k) => best.includes(k)), stretches.filter((_, k) => !best.includes(k))];
}

/** Return the mean (3, 6) of maps, flat, and the matrix (6, 6) of their spread about it. */
function spreadOf(maps, first, behind) {
  const mean = meanMap(maps, first, behind);
  const squares = new Float64Array(36);
  for (let k = first; k < behind; k++) addSquares(squares, maps, k);
  return { mean, spread: about(mean, squares.map((value) => value / (behind - first))) };
}

function addSquares(squares, maps, k) {
  for (let i = 0; i < 3; i++) {
    const at = 18 * k + 6 * i;
    for (let p = 0; p < 6; p++) for (let q = 0; q < 6; q++) squares[6 * p + q] += maps[at + p] * maps[at + q];
  }
}

/** Return the matrix of squares (6, 6) about a mean (3, 6). */
function about(mean, squares) {
  return [0, 1, 2, 3, 4, 5].map((p) => [0, 1, 2, 3, 4, 5].map((q) =>
    squares[6 * p + q] - mean[p] * mean[q] - mean[6 + p] * mean[6 + q] - mean[12 + p] * mean[12 + q]));
}

const applied = (map, at, inertia) => {
  let sum = 0;
  for (let j = 0; j < 6; j++) sum += map[at + j] * inertia[j];
  return sum;
};

const momentumBy = (mean, inertia) => Math.hypot(applied(mean, 0, inertia), applied(mean, 6, inertia), applied(mean, 12, inertia));

/** Whether with one inertia the momentum of every stretch is constant within the tolerance. */
function agree(spreads) {
  const sizes = spreads.map(({ spread }) => Math.max(spread.reduce((sum, line, k) => sum + line[k], 0), 1e-300));
  const total = spreads[0].spread.map((line, p) => line.map((_, q) => spreads.reduce((sum, one, k) => sum + one.spread[p][q] / sizes[k], 0)));
  const inertia = eigenSymmetric(total).vectors[0];
  return spreads.every(({ mean, spread, change }) => {
    const square = spread.reduce((sum, line, p) => sum + inertia[p] * line.reduce((part, value, q) => part + value * inertia[q], 0), 0);
    return Math.sqrt(Math.max(square, 0)) / Math.max(momentumBy(mean, inertia), 1e-12) < Math.max(UNEVEN, 3 * change);
  });
}

/** Return the inertia with the most constant momentum over maps, and the momentum's relative change. */
const fitInertia = (maps, first, behind) => bestInertia(spreadOf(maps, first, behind));

/** Return {inertia, change}; a physical inertia is preferred where it does well too, else the change is infinite. */
function bestInertia({ mean, spread }) {
  const { values, vectors } = eigenSymmetric(spread);
  // a short or steady turn leaves a plane of inertias: those in it are asked, the best of all first
  let best = null;
  for (let k = 0; k < PLANE; k++) {
    const [c, s] = [Math.cos((Math.PI / PLANE) * k), Math.sin((Math.PI / PLANE) * k)];
    const inertia = vectors[0].map((value, i) => c * value + s * vectors[1][i]);
    const square = c * c * values[0] + s * s * values[1];
    const possible = isPossible(inertia);
    const change = possible ? Math.sqrt(Math.max(square, 0)) / Math.max(momentumBy(mean, inertia), 1e-12) : Infinity;
    if (!best || change < best.change) best = { inertia, change };
    if (k === 0 && possible) break;
  }
  return best;
}

/** Whether an inertia is physical, within the tolerance for a biased gyro. */
function isPossible(entries) {
  const J = inertiaMatrix(entries);
  const sign = Math.sign(J[0][0] + J[1][1] + J[2][2]);
  const { values } = eigenSymmetric(J.map((line) => line.map((value) => sign * value)));
  return values[0] > 0.03 * values[2] && values[0] + values[1] > 0.8 * values[2];
}

/** Return how much an inertia's momentum changes, root mean square, relative to its size. */
function changeOf(maps, first, behind, inertia) {
  const mean = meanMap(maps, first, behind);
  const middle = [0, 6, 12].map((at) => applied(mean, at, inertia));
  let sum = 0;
  for (let k = first; k < behind; k++) for (let i = 0; i < 3; i++) sum += (applied(maps, 18 * k + 6 * i, inertia) - middle[i]) ** 2;
  return Math.sqrt(sum / (behind - first)) / Math.max(Math.hypot(...middle), 1e-12);
}

/** Return the first and last sample of the parts of a log in which the device turns at all. */
function turningParts(t, speeds) {
  const n = t.length;
  const fast = Array.from(speeds, (speed) => speed > SLOWEST);
  // moments of slowness shorter than five samples are closed; beyond the ends nothing turns
  const near = fast.map((_, k) => fast.slice(Math.max(k - 2, 0), k + 3).some(Boolean));
  const closed = fast.map((flag, k) => flag || (k >= 2 && k + 2 < n && near.slice(k - 2, k + 3).every(Boolean)));
  const between = steps(t);
  const most = Math.max(BROKEN, 5 * median(between));
  const found = [];
  for (let k = 0; k < n; k++) {
    if (!closed[k]) continue;
    if (k > 0 && closed[k - 1] && between[k - 1] < most) found.at(-1)[1] = k;
    else found.push([k, k]);
  }
  return found;
}

function stretchesWithin(t, rates, shortest, offset) {
  const maps = momentumMaps(integrateRates(t, rates), rates);
  const speeds = lengths(rates);
  const angle = new Float64Array(t.length);
  for (let k = 1; k < t.length; k++) angle[k] = angle[k - 1] + 0.5 * (speeds[k] + speeds[k - 1]) * (t[k] - t[k - 1]);
  const taken = new Uint8Array(t.length);
  const found = [];
  for (const { begin, end, inertia } of seeds(t, maps, angle)) {
    let count = 0;
    for (let k = begin; k < end; k++) count += taken[k];
    if (count / (end - begin) > 0.5) continue;
    const grown = grow(t, maps, begin, end, inertia);
    if (!grown || t[grown.last] - t[grown.first] < shortest) continue;
    const { first, last } = grown;
    taken.fill(1, first, last + 1);
    found.push({ first: first + offset, last: last + offset, change: changeOf(maps, first, last + 1, grown.inertia), turn: angle[last] - angle[first] });
  }
  return found;
}

/** Return spans {begin, end, inertia} with constant momentum for some physical inertia; the best come first. */
function seeds(t, maps, angle) {
  const found = [];
  const n = t.length;
  const step = median(steps(t));
  const sums = cumulated(maps);
  for (const wanted of new Set(SPANS.map((span) => Math.max(6, roundEven(span / step))))) {
    const size = wanted > n && !found.length && n >= 6 ? n : wanted;
    const begins = [];
    for (let k = 0; k <= n - size; k += Math.max(1, Math.floor(size / STRIDES))) if (angle[k + size - 1] - angle[k] >= TURN) begins.push(k);
    const fits = begins.map((begin) => bestInertia(meanBetween(sums, begin, size)));
    // the best of each neighbourhood; one inertia of a hand's may be of no use a little further
    for (const part of split(begins.length, Math.max(1, Math.floor(begins.length / STRIDES)))) {
      let best = part[0];
      for (const k of part) if (fits[k].change < fits[best].change) best = k;
      if (best !== undefined && fits[best].change < UNEVEN) found.push({ begin: begins[best], end: begins[best] + size, ...fits[best] });
    }
  }
  return found.sort((a, b) => a.change - b.change);
}

/** Return the sums of the first k maps and of their squares, for k from 0 on. */
function cumulated(maps) {
  const n = maps.length / 18;
  const [total, squares] = [new Float64Array(18 * (n + 1)), new Float64Array(36 * (n + 1))];
  for (let k = 0; k < n; k++) {
    for (let i = 0; i < 18; i++) total[18 * (k + 1) + i] = total[18 * k + i] + maps[18 * k + i];
    const one = new Float64Array(36);
    addSquares(one, maps, k);
    for (let i = 0; i < 36; i++) squares[36 * (k + 1) + i] = squares[36 * k + i] + one[i];
  }
  return { total, squares };
}

function meanBetween({ total, squares }, begin, size) {
  const end = begin + size;
  const mean = Float64Array.from({ length: 18 }, (_, i) => (total[18 * end + i] - total[18 * begin + i]) / size);
  const square = Float64Array.from({ length: 36 }, (_, i) => (squares[36 * end + i] - squares[36 * begin + i]) / size);
  return { mean, spread: about(mean, square) };
}

/** Return the numbers from 0 to `count` in so many parts, the first of them longer by one where it does not divide. */
function split(count, parts) {
  const [each, more] = [Math.floor(count / parts), count % parts];
  let at = 0;
  return Array.from({ length: parts }, (_, k) => Array.from({ length: each + (k < more ? 1 : 0) }, () => at++));
}

/** Return {first, last, inertia} of the stretch around a span in which no torque acts; null for none. */
function grow(t, maps, begin, end, inertia) {
  let [first, last] = [begin, end - 1];
  let found = inertia;
  for (let round = 0; round < MOST_ROUNDS; round++) {
    const momentum = Float64Array.from({ length: 3 * t.length }, (_, k) => applied(maps, 6 * k, found));
    const calm = quiet(t, momentum, first, last);
    const middle = longest(runs(calm.slice(first, last + 1)));
    if (!middle) return null;
    let [low, high] = [first + middle[0], first + middle[1] - 1];
    while (low > 0 && calm[low - 1]) low -= 1;
    while (high < t.length - 1 && calm[high + 1]) high += 1;
    if (high - low < 6) return null;
    const fit = fitInertia(maps, low, high + 1);
    found = fit.inertia;
    if (!Number.isFinite(fit.change)) return null;
    if (low === first && high === last) break;
    [first, last] = [low, high];
  }
  return { first, last, inertia: found };
}

function longest(found) {
  let best = null;
  for (const run of found) if (!best || run[1] - run[0] > best[1] - best[0]) best = run;
  return best;
}

/** Return at which samples no torque acts beyond what the noise and the usual torque of a stretch explain. */
function quiet(t, momentum, first, last) {
  const n = t.length;
  const size = lengths(momentum).map((value) => Math.max(value, 1e-12));
  const moved = (i, j) => Math.hypot(momentum[3 * j] - momentum[3 * i], momentum[3 * j + 1] - momentum[3 * i + 1], momentum[3 * j + 2] - momentum[3 * i + 2]);
  const noise = median(Float64Array.from({ length: last - first }, (_, k) => moved(first + k, first + k + 1) / size[first + k]));
  const step = median(steps(t));
  const hop = Math.min(Math.max(1, roundEven(HOP / step)), Math.max(1, Math.ceil((4 * noise) / (TORQUE[0] * step))));
  const torque = Float64Array.from({ length: Math.max(n - hop, 0) }, (_, k) => moved(k, k + hop) / (t[k + hop] - t[k]) / Math.min(size[k + hop], size[k]));
  const usual = median(torque.slice(first, Math.max(last - hop + 1, first + 1)));
  const most = Math.min(Math.max(TORQUE[0], OWN_TORQUE * usual), TORQUE[1]);
  const calm = Array.from(torque, (value) => value < most);
  for (const [begin, behind] of runs(calm.map((flag) => !flag))) {
    // a spike spoils the hops that touch it, and the momentum is the same behind it
    const after = Math.min(behind + hop - 1, n - 1);
    if (after - begin <= 2 * hop + 2 && moved(begin, after) / size[begin] < TORQUE[0] * (t[after] - t[begin]) + 2 * noise) calm.fill(true, begin, behind);
  }
  const found = new Array(n).fill(false);
  calm.forEach((flag, k) => {
    if (flag) found.fill(true, k, k + hop + 1);
  });
  return found;
}

/** Return stretches that do not overlap, the longest of those that do. */
function apart(stretches) {
  const kept = [];
  for (const one of [...stretches].sort((a, b) => a.first - a.last - (b.first - b.last))) {
    if (kept.every((other) => one.last < other.first || one.first > other.last)) kept.push(one);
  }
  return kept.sort((a, b) => a.first - b.first);
}
