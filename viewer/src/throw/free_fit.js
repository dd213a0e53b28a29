// Least squares of the motion on throws of one body: shape, axes, the gyro's bias, the rates of each throw, and drag.
import { FreeMotion } from "../../../reference/polhode.js";
import { fromVector, matrixOf, row } from "./linear_fit.js";
import { determinant, dot, solve } from "./matrices.js";
import { median, place } from "./statistics.js";

const ROBUST = 3; // standard deviations, beyond which residuals count linearly (Huber)
const BIAS_SPREAD = 0.03; // rad/s, of offsets anywhere within ±0.05, as gyros of phones have them
const FLATTER = -0.1; // c of a body flatter than a plate, which noise may pretend
const LEAST_MOMENT = 0.003; // over the largest
const [ROUNDS, MOST_STEPS] = [6, 25];
const STEP = 1e-6; // of a parameter, for derivatives: half the digits
const DRAG_SPREAD = 0.02; // of coefficients over I3; thin plates in air have a drag of 0.01
const TURN = 0.04; // rad, that a body turns in a step of Runge and Kutta's: five such steps are right to 1e-8
const SETTLED = 1e-6; // of the sum of squares, by which a round must lessen it

/**
 * Return {moments, axes, bias, drag, starts, residuals, rms}: the motion that fits throws of one body best.
 *
 * Moments ascend over the largest; axes are the columns of a right-handed matrix (device from principal); bias (3) [rad/s,
 * device axes]; starts are rates [rad/s, principal axes] at each throw's epoch; residuals (n, 3) [rad/s], flat, of each throw.
 * Without drag the motion is the exact free one; drag c is of the torque −c_i |ω| ω_i along the principal axes, over the
 * largest moment, or null. Gains of the gyro are not fitted: what they do shows in the residuals.
 *
 * @param start of the linear method, as `startOf` returns it
 * @param throws each {elapsed (n) [s], rates (n, 3) [rad/s, device axes], zero: index of the sample at the epoch}
 * @param rest {value (3), spread (3)} of the bias [rad/s] where the log shows it at rest, or null
 * @param damped whether drag is fitted
 */
export function fitThrows(start, throws, rest, damped = false) {
  const [x, y] = start.moments;
  const known = rest ?? { value: [0, 0, 0], spread: [BIAS_SPREAD, BIAS_SPREAD, BIAS_SPREAD] };
  let at = {
    shape: [y - x, 0.5 * (x + y - 1)], axes: start.axes, bias: [...known.value], drag: damped ? [0, 0, 0] : null,
    starts: throws.map(({ rates, zero }) => alongAxes(start.axes, row(rates, zero).map((value, i) => value - known.value[i]))),
  }; // prettier-ignore
  // over the middles of long throws first, over which a rough start does not lose a turn
  for (const samples of [100, 500, 2500, Infinity]) {
    if (samples < Infinity && !throws.some(({ elapsed }) => elapsed.length > 2 * samples)) continue;
    at = descend(at, throws.map((one) => middleOf(one, samples)), known);
  }
  return sorted(at, residualsOf(at, throws));
}

function middleOf({ elapsed, rates, zero }, samples) {
  if (!Number.isFinite(samples)) return { elapsed, rates, zero };
  const first = Math.max(zero - samples / 2, 0);
  const behind = Math.min(zero + samples / 2, elapsed.length);
  return { elapsed: elapsed.slice(first, behind), rates: rates.slice(3 * first, 3 * behind), zero: zero - first };
}

const alongAxes = (axes, v) => [0, 1, 2].map((k) => axes[0][k] * v[0] + axes[1][k] * v[1] + axes[2][k] * v[2]);

const momentsOf = ([s, c]) => [0.5 * (1 - s) + c, 0.5 * (1 + s) + c, 1];

/** Return what is measured less what the motion predicts, of each throw, flat; null for moments that no body has. */
function residualsOf({ shape, axes, bias, drag, starts }, throws) {
  const moments = momentsOf(shape);
  if (!(Math.min(...moments) > LEAST_MOMENT)) return null;
  return throws.map(({ elapsed, rates }, k) => {
    const motion = drag ? null : new FreeMotion({ moments, momentum: moments.map((value, i) => value * starts[k][i]) });
    const slowed = drag && dampedRates(moments, drag, starts[k], elapsed);
    const found = new Float64Array(rates.length);
    elapsed.forEach((time, j) => {
      const w = slowed ? slowed[j] : motion.angularVelocity(time);
      for (let i = 0; i < 3; i++) found[3 * j + i] = rates[3 * j + i] - bias[i] - dot(axes[i], w);
    });
    return found;
  });
}

/** Return the rates at times from the epoch, on both sides of it, of a body with drag. */
function dampedRates(moments, drag, start, elapsed) {
  const [I1, I2, I3] = moments;
  const slope = ([x, y, z]) => {
    const size = Math.hypot(x, y, z);
    return [((I2 - I3) * y * z - drag[0] * size * x) / I1, ((I3 - I1) * z * x - drag[1] * size * y) / I2, ((I1 - I2) * x * y - drag[2] * size * z) / I3];
  };
  const found = new Array(elapsed.length);
  const zero = place(elapsed, 0);
  const walk = (from, behind, sense) => {
    let [w, time] = [start, 0];
    for (let k = from; k !== behind; k += sense) {
      const count = Math.max(1, Math.ceil((Math.hypot(...w) * Math.abs(elapsed[k] - time)) / TURN));
      const h = (elapsed[k] - time) / count;
      for (let n = 0; n < count; n++) w = stepped(slope, w, h);
      [found[k], time] = [w, elapsed[k]];
    }
  };
  walk(zero, elapsed.length, 1);
  walk(zero - 1, -1, -1);
  return found;
}

/** Return a state after one step of the classical Runge–Kutta method. */
function stepped(slope, w, h) {
  const along = (rate, part) => w.map((value, i) => value + part * h * rate[i]);
  const a = slope(w);
  const b = slope(along(a, 0.5));
  const c = slope(along(b, 0.5));
  const d = slope(along(c, 1));
  return w.map((value, i) => value + (h / 6) * (a[i] + 2 * b[i] + 2 * c[i] + d[i]));
}

/** Return the parameters moved by a step: shape, turn about the principal axes, bias, the starts, then drag. */
function moved(at, step) {
  const R = matrixOf(fromVector(step.slice(2, 5)));
  const columns = (i) => [0, 1, 2].map((j) => R[j][i]);
  return {
    shape: [Math.min(Math.max(at.shape[0] + step[0], -1), 1), Math.min(Math.max(at.shape[1] + step[1], FLATTER), 2)],
    axes: at.axes.map((line) => [0, 1, 2].map((i) => dot(line, columns(i)))),
    bias: at.bias.map((value, i) => value + step[5 + i]),
    starts: at.starts.map((start, k) => start.map((value, i) => value + step[8 + 3 * k + i])),
    drag: at.drag && at.drag.map((value, i) => value + step[8 + 3 * at.starts.length + i]),
  };
}

/** Return parameters at the least sum of Huber's squares: least squares and the estimate of the noise in turn. */
function descend(first, throws, known) {
  let at = first;
  const begin = residualsOf(at, throws);
  if (!begin) return at;
  let sigma = median(begin.flatMap((part) => Array.from(part, Math.abs))) * 1.5 + 1e-9;
  for (let round = 0; round < ROUNDS; round++) {
    at = leastSquares(at, throws, known, sigma);
    const before = sigma;
    sigma = noiseBy(residualsOf(at, throws), sizeOf(at));
    if (Math.abs(sigma / before - 1) < 0.02) break;
  }
  return at;
}

/** Return how many parameters there are. */
const sizeOf = ({ starts, drag }) => 8 + 3 * starts.length + (drag ? 3 : 0);

/** Return the noise of a sample [rad/s] by residuals, those far out counted as if they were at four times the usual. */
function noiseBy(residuals, lost) {
  const squares = residuals.flatMap((part) => Array.from({ length: part.length / 3 }, (_, k) => dot(row(part, k), row(part, k))));
  const most = 16 * (median(squares) / 2.366 + 1e-300); // the median of the sum of three squares
  const sum = squares.reduce((total, value) => total + Math.min(value, most), 0);
  return Math.max(Math.sqrt(sum / Math.max(3 * squares.length - lost, 1)), 1e-12);
}

/** Return parameters at the least sum of Huber's squares with a given noise, by Levenberg's and Marquardt's way. */
function leastSquares(first, throws, known, sigma) {
  let [at, now, damping] = [first, residualsOf(first, throws), 1e-3];
  for (let step = 0; step < MOST_STEPS; step++) {
    const { normal, right } = linearised(at, throws, now, known, sigma);
    const cost = costOf(now, at, known, sigma);
    let better = null;
    while (!better && damping < 1e12) {
      const change = solve(normal.map((line, k) => line.map((value, j) => (j === k ? value * (1 + damping) + 1e-300 : value))), right);
      const tried = change && moved(at, change);
      const residuals = tried && residualsOf(tried, throws);
      const next = residuals ? costOf(residuals, tried, known, sigma) : Infinity;
      if (next < cost) better = { tried, residuals, next };
      else damping *= 10;
    }
    if (!better) break;
    [at, now] = [better.tried, better.residuals];
    damping = Math.max(damping / 10, 1e-12);
    if (cost - better.next < SETTLED * cost) break;
  }
  return at;
}

function costOf(residuals, { bias, drag }, known, sigma) {
  let sum = bias.reduce((total, value, i) => total + ((value - known.value[i]) / known.spread[i]) ** 2, 0);
  for (const value of drag ?? []) sum += (value / DRAG_SPREAD) ** 2;
  for (const part of residuals) {
    for (const value of part) {
      const z = Math.abs(value / sigma);
      sum += z <= ROBUST ? z * z : ROBUST * (2 * z - ROBUST);
    }
  }
  return sum;
}

/** Return the normal equations of the weighted linear least squares about the parameters. */
function linearised(at, throws, now, known, sigma) {
  const count = sizeOf(at);
  const slopes = Array.from({ length: count }, (_, k) => {
    const size = k < 5 || k >= 8 + 3 * throws.length ? STEP : STEP * Math.max(1, ...at.starts.flat().map(Math.abs));
    const [plus, minus] = [size, -size].map((value) => residualsOf(moved(at, Array.from({ length: count }, (_, j) => (j === k ? value : 0))), throws));
    if (!plus || !minus) return now.map((part) => new Float64Array(part.length));
    return plus.map((part, m) => part.map((value, j) => (minus[m][j] - value) / (2 * size))); // of the prediction
  });
  const normal = Array.from({ length: count }, () => new Array(count).fill(0));
  const right = new Array(count).fill(0);
  now.forEach((part, m) => part.forEach((value, j) => {
    const weight = Math.min(1, (ROBUST * sigma) / Math.max(Math.abs(value), 1e-300)) / sigma ** 2;
    for (let p = 0; p < count; p++) {
      const slope = weight * slopes[p][m][j];
      right[p] += slope * value;
      for (let q = 0; q <= p; q++) normal[p][q] += slope * slopes[q][m][j];
    }
  }));
  for (let p = 0; p < count; p++) for (let q = 0; q < p; q++) normal[q][p] = normal[p][q];
  for (let i = 0; i < 3; i++) {
    normal[5 + i][5 + i] += known.spread[i] ** -2;
    right[5 + i] += (known.value[i] - at.bias[i]) / known.spread[i] ** 2;
  }
  (at.drag ?? []).forEach((value, i) => {
    const k = 8 + 3 * throws.length + i;
    normal[k][k] += DRAG_SPREAD ** -2;
    right[k] -= value / DRAG_SPREAD ** 2;
  });
  return { normal, right };
}

/** Return the fit with its moments in ascending order, and the axes and starts along with them. */
function sorted({ shape, axes, bias, drag, starts }, residuals) {
  const moments = momentsOf(shape);
  const order = [0, 1, 2].sort((i, j) => moments[i] - moments[j]);
  const turned = axes.map((line) => order.map((k) => line[k]));
  const sign = determinant(turned) < 0 ? -1 : 1;
  const largest = moments[order[2]];
  const all = (residuals ?? []).flatMap((part) => [...part]);
  return {
    moments: order.map((k) => moments[k] / largest),
    axes: turned.map(([a, b, c]) => [a, b, sign * c]),
    bias,
    drag: drag && order.map((k) => drag[k] / largest),
    starts: starts.map((start) => order.map((k, i) => (i === 2 ? sign : 1) * start[k])),
    residuals: residuals ?? [],
    rms: Math.sqrt(all.reduce((sum, value) => sum + value * value, 0) / Math.max(all.length, 1)),
  };
}
