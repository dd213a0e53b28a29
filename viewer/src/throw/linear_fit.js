// The inertia J of a body from the angular velocities of its free flights: R J ω is constant in space, linear in J.
import { digits } from "../numbers.js";
import { listed, say } from "../say.js";
import { cross, dot, eigenSymmetric, singularValues } from "./matrices.js";
import { lengths, median, noiseOf, steps } from "./statistics.js";

const ROOT = Math.SQRT2;
export const OFF_DIAGONAL = [[0, 1], [0, 2], [1, 2]];
const FLATTEST = 0.02; // of (I1 + I2 − I3)/2I3, to stay within what a body can be
const MIN_TURN = 0.5; // rad: of less nothing can be said
const MOST_TURN = 2; // rad from sample to sample, between which the motion cannot be followed
const [FASTEST, ROUND] = [75, 0.6]; // rad/s; I1/I3: rates too large make a body round
const STEADY = 5; // degrees: rates that stay so near one direction are those of a steady spin
const DEGREE = Math.PI / 180;

/** Return the product of quaternions w, x, y, z by Hamilton's rule. */
export const product = ([a, b, c, d], [w, x, y, z]) => [
  a * w - b * x - c * y - d * z,
  a * x + b * w + c * z - d * y,
  a * y - b * z + c * w + d * x,
  a * z + b * y - c * x + d * w,
];

/** Return the quaternion w, x, y, z of a rotation vector [rad]. */
export function fromVector(vector) {
  const angle = Math.hypot(...vector);
  const scale = angle < 1e-3 ? 0.5 - (angle * angle) / 48 : Math.sin(0.5 * angle) / angle;
  return [Math.cos(0.5 * angle), ...vector.map((value) => scale * value)];
}

/** Return the matrix (rows) of a quaternion w, x, y, z. */
export function matrixOf([w, x, y, z]) {
  return [
    [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
    [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
    [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
  ];
}

/**
 * Return the attitudes (device → space) that rates integrate to, from the unit quaternion on.
 *
 * Each step is the Magnus expansion of rates that are linear in time between samples: ½h(ω₀ + ω₁) + h²/12 ω₀ × ω₁.
 */
export function integrateRates(times, rates) {
  const found = [[1, 0, 0, 0]];
  for (let k = 1; k < times.length; k++) {
    const h = times[k] - times[k - 1];
    const [a, b] = [row(rates, k - 1), row(rates, k)];
    const bend = cross(a, b);
    const q = product(found[k - 1], fromVector(a.map((value, i) => 0.5 * h * (value + b[i]) + ((h * h) / 12) * bend[i])));
    const size = Math.hypot(...q);
    found.push(q.map((value) => value / size));
  }
  return found;
}

export const row = (rows, k) => [rows[3 * k], rows[3 * k + 1], rows[3 * k + 2]];

/** Return the maps (n, 3, 6), flat, from J11, J22, J33, √2 J12, √2 J13, √2 J23 to the momentum R J ω in space. */
export function momentumMaps(attitudes, rates) {
  const n = attitudes.length;
  const maps = new Float64Array(18 * n);
  for (let k = 0; k < n; k++) {
    const R = matrixOf(attitudes[k]);
    const w = row(rates, k);
    for (let i = 0; i < 3; i++) {
      const at = 18 * k + 6 * i;
      for (let j = 0; j < 3; j++) maps[at + j] = R[i][j] * w[j];
      OFF_DIAGONAL.forEach(([p, q], m) => {
        maps[at + 3 + m] = (R[i][p] * w[q] + R[i][q] * w[p]) / ROOT;
      });
    }
  }
  return maps;
}

/** Return the symmetric matrix of six entries, those off the diagonal times √2. */
export function inertiaMatrix(entries) {
  const J = [0, 1, 2].map((i) => [0, 1, 2].map((j) => (i === j ? entries[i] : 0)));
  OFF_DIAGONAL.forEach(([i, j], m) => {
    J[i][j] = J[j][i] = entries[3 + m] / ROOT;
  });
  return J;
}

/**
 * Return {moments, axes, singularValues}: moments ascending over the largest, axes as columns of a right-handed matrix.
 *
 * Σ |R J ω − its mean|² over all throws is least, at |J| = 1, along the last right singular vector.
 *
 * @param throws of one body, each {elapsed (n) [s], rates (n, 3) [rad/s, device axes]}
 */
export function linearInertia(throws) {
  const total = throws.reduce((sum, one) => sum + one.elapsed.length, 0);
  const columns = Array.from({ length: 6 }, () => new Float64Array(3 * total));
  let at = 0;
  for (const { elapsed, rates } of throws) {
    const n = elapsed.length;
    const maps = momentumMaps(integrateRates(elapsed, rates), rates);
    const means = meanMap(maps, 0, n);
    for (let k = 0; k < n; k++) {
      for (let i = 0; i < 3; i++, at++) for (let j = 0; j < 6; j++) columns[j][at] = maps[18 * k + 6 * i + j] - means[6 * i + j];
    }
  }
  const { values, vectors } = singularValues(columns);
  const J = inertiaMatrix(vectors[5]);
  const sign = Math.sign(J[0][0] + J[1][1] + J[2][2]) || 1;
  const found = eigenSymmetric(J.map((line) => line.map((value) => sign * value)));
  const [first, second] = found.vectors;
  const columnsOfAxes = [first, second, cross(first, second)];
  const axes = [0, 1, 2].map((i) => columnsOfAxes.map((axis) => axis[i]));
  return { moments: possibleMoments(found.values), axes, singularValues: values };
}

/** Return the mean (3, 6) of the maps [first, behind), flat. */
export function meanMap(maps, first, behind) {
  const found = new Float64Array(18);
  for (let k = first; k < behind; k++) for (let i = 0; i < 18; i++) found[i] += maps[18 * k + i];
  return found.map((value) => value / (behind - first));
}

/** Return moments over the largest, ascending, moved to satisfy the triangle inequality. */
export function possibleMoments(moments) {
  // of a flat body's, (b + c, a + c, a + b) with a ≥ b ≥ c ≥ 0 the spreads of mass along the axes
  const half = 0.5 * (moments[0] + moments[1] + moments[2]);
  const largest = Math.max(half - moments[0], 1e-300);
  const b = Math.max(half - moments[1], 0.02 * largest);
  const c = Math.max(half - moments[2], FLATTEST * largest);
  const ordered = [b + c, largest + c, largest + b].sort((x, y) => x - y);
  return ordered.map((value) => value / ordered[2]);
}

/**
 * Return the start of a fit: {moments, axes, singularValues, noise, degenerate}.
 *
 * `noise` is that of a sample [rad/s]; `degenerate` says why the throws do not determine the inertia, null where they do.
 *
 * @param throws of one body, as `linearInertia` takes them
 */
export function startOf(throws) {
  const found = linearInertia(throws);
  const noise = noiseOf(throws.map(({ rates }) => rates));
  const samples = throws.reduce((sum, { elapsed }) => sum + elapsed.length, 0);
  // noise of σ makes each singular value about σ √n; biases and drag make them larger, so the misfit is judged again
  const floor = 6 * noise * Math.sqrt(samples);
  const turns = throws.map(({ elapsed, rates }) => {
    const speeds = lengths(rates);
    return steps(elapsed).map((step, k) => step * speeds[k + 1]);
  });
  const turned = Math.max(...turns.map((one) => one.reduce((sum, value) => sum + value, 0)));
  const between = Math.max(...turns.map(median));
  const typical = Math.max(...throws.map(({ rates }) => median(lengths(rates))));
  let degenerate = null;
  if (between > MOST_TURN) {
    degenerate = say("The rates say that the body turns by {angle} rad from sample to sample, too far to be followed: the rates are of another unit, like deg/s, or the times are.", { angle: digits(between, 3) });
  } else if (typical > FASTEST && found.moments[0] > ROUND) {
    degenerate = say("The rates, about {rates} rad/s, are beyond what gyros can tell, and make the body nearly a sphere. Both happen where rates in deg/s are read as rad/s: choose their unit.", { rates: digits(typical, 3) });
  } else if (turned < MIN_TURN) {
    degenerate = say("The body turned by {angle} rad only: nothing can be said of its inertia.", { angle: digits(turned, 2) });
  } else if (found.singularValues[4] < floor) degenerate = explainUndetermined(throws);
  return { ...found, noise, degenerate };
}

/** Return why throws do not determine the inertia. */
function explainUndetermined(throws) {
  const told = throws.map(({ rates }) => {
    const speeds = lengths(rates);
    const n = speeds.length;
    const mean = [0, 1, 2].map((i) => speeds.reduce((sum, _, k) => sum + rates[3 * k + i], 0) / n);
    const size = Math.hypot(...mean);
    const away = Math.max(...speeds.map((speed, k) => {
      const cosine = dot(row(rates, k), mean) / Math.max(speed * size, 1e-300);
      return Math.acos(Math.min(1, Math.max(-1, cosine))) / DEGREE;
    }));
    return { away, speed: speeds.reduce((sum, value) => sum + value, 0) / n, toward: mean.map((value) => value / Math.max(size, 1e-300)) };
  });
  const { away, speed, toward } = told.reduce((best, one) => (one.away > best.away ? one : best));
  const axis = `(${listed(toward.map((value) => value.toFixed(2)))})`;
  if (away < STEADY) {
    return say("The rates ({rates} rad/s) stay within {angle}° of one direction of the device, {axis}: the body spins about a principal axis, or is a sphere; either way the log does not determine the moments. Throw it with a tumble, best about its middle axis.", { rates: digits(speed, 3), angle: digits(away, 2), axis });
  }
  return say("Within the noise, bodies of quite different moments fit the rates ({rates} rad/s, up to {angle}° from {axis}). Throw it longer or faster, with a tumble about its middle axis.", { rates: digits(speed, 3), angle: away.toFixed(0), axis });
}
