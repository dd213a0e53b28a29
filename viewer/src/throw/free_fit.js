// Least squares of the exact free motion on throws of one body: shape, axes, the gyro's bias, and the rates of each throw.
import { FreeMotion } from "../../../reference/polhode.js";
import { fromVector, matrixOf, row } from "./linear_fit.js";
import { determinant, dot, solve } from "./matrices.js";
import { median } from "./statistics.js";

const ROBUST = 3; // standard deviations, beyond which residuals count linearly (Huber)
const BIAS_SPREAD = 0.03; // rad/s, of offsets anywhere within ±0.05, as gyros of phones have them
const FLATTER = -0.1; // c of a body flatter than a plate, which noise may pretend
const LEAST_MOMENT = 0.003; // over the largest
const [ROUNDS, MOST_STEPS] = [6, 25];
const STEP = 1e-6; // of a parameter, for derivatives: half the digits
const SETTLED = 1e-6; // of the sum of squares, by which a round must lessen it

/**
 * Return {moments, axes, bias, starts, residuals, rms}: the free motion that fits throws of one body best.
 *
 * Moments ascend over the largest; axes are the columns of a right-handed matrix (device from principal); bias (3) [rad/s,
 * device axes]; starts are rates [rad/s, principal axes] at each throw's epoch; residuals (n, 3) [rad/s], flat, of each throw.
 * Neither drag nor gains of the gyro are fitted: what they do shows in the residuals.
 *
 * @param start of the linear method, as `startOf` returns it
 * @param throws each {elapsed (n) [s], rates (n, 3) [rad/s, device axes], zero: index of the sample at the epoch}
 * @param rest {value (3), spread (3)} of the bias [rad/s] where the log shows it at rest, or null
 */
export function fitFree(start, throws, rest) {
  const [x, y] = start.moments;
  const known = rest ?? { value: [0, 0, 0], spread: [BIAS_SPREAD, BIAS_SPREAD, BIAS_SPREAD] };
  let at = {
    shape: [y - x, 0.5 * (x + y - 1)], axes: start.axes, bias: [...known.value],
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
function residualsOf({ shape, axes, bias, starts }, throws) {
  const moments = momentsOf(shape);
  if (!(Math.min(...moments) > LEAST_MOMENT)) return null;
  return throws.map(({ elapsed, rates }, k) => {
    const motion = new FreeMotion({ moments, momentum: moments.map((value, i) => value * starts[k][i]) });
    const found = new Float64Array(rates.length);
    elapsed.forEach((time, j) => {
      const w = motion.angularVelocity(time);
      for (let i = 0; i < 3; i++) found[3 * j + i] = rates[3 * j + i] - bias[i] - dot(axes[i], w);
    });
    return found;
  });
}

/** Return the parameters moved by a step: shape, turn about the principal axes, bias, then the starts. */
function moved(at, step) {
  const R = matrixOf(fromVector(step.slice(2, 5)));
  const columns = (i) => [0, 1, 2].map((j) => R[j][i]);
  return {
    shape: [Math.min(Math.max(at.shape[0] + step[0], -1), 1), Math.min(Math.max(at.shape[1] + step[1], FLATTER), 2)],
    axes: at.axes.map((line) => [0, 1, 2].map((i) => dot(line, columns(i)))),
    bias: at.bias.map((value, i) => value + step[5 + i]),
    starts: at.starts.map((start, k) => start.map((value, i) => value + step[8 + 3 * k + i])),
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
    sigma = noiseBy(residualsOf(at, throws), 8 + 3 * throws.length);
    if (Math.abs(sigma / before - 1) < 0.02) break;
  }
  return at;
}

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

function costOf(residuals, { bias }, known, sigma) {
  let sum = bias.reduce((total, value, i) => total + ((value - known.value[i]) / known.spread[i]) ** 2, 0);
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
  const count = 8 + 3 * throws.length;
  const slopes = Array.from({ length: count }, (_, k) => {
    const size = k < 5 ? STEP : STEP * Math.max(1, ...at.starts.flat().map(Math.abs));
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
  return { normal, right };
}

/** Return the fit with its moments in ascending order, and the axes and starts along with them. */
function sorted({ shape, axes, bias, starts }, residuals) {
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
    starts: starts.map((start) => order.map((k, i) => (i === 2 ? sign : 1) * start[k])),
    residuals: residuals ?? [],
    rms: Math.sqrt(all.reduce((sum, value) => sum + value * value, 0) / Math.max(all.length, 1)),
  };
}
