// Euler's disk from its start to its end, along the slow motions on which no nutation rings, from one steady motion to the next.
import { Stepped } from "../../../../reference/stepped/index.js";
import { RollingMechanics } from "../../../../reference/stepped/rolling_mechanics.js";
import { slowTiltRate, steadyRates } from "../../../../reference/stepped/rolling_start.js";
import { checkedLaws, couples } from "../../../../reference/stepped/rolling_dissipation.js";

export const [MASS, RADIUS, HALF_THICKNESS, GRAVITY] = [0.4387, 0.0381, 0.00635, 9.80665]; // kg, m, m, m/s²: examples/euler_disk.toml

/** Return the disk of examples/euler_disk.toml with another half thickness [m], a homogeneous cylinder. */
export function diskOf(b) {
  const [m, a] = [MASS, RADIUS];
  return new RollingMechanics({ m, a, b, A: m * (0.25 * a * a + (b * b) / 3), C: 0.5 * m * a * a, g: GRAVITY });
}

/** What takes energy away, by the name in the address. */
export const LOSSES = {
  real: [{ law: "air-layer", viscosity: 1.8e-5 }, { law: "rolling-couple", arm: 1e-5 }],
  rolling: [{ law: "rolling-couple", arm: 1e-5 }],
  friction: [{ law: "viscous-contour-friction", coefficient: 2e-7 }],
  air: [{ law: "air-layer", viscosity: 1.8e-5 }],
}; // prettier-ignore

/** Return the steady rolling at a tilt [rad] whose centre is at rest: rates ω2, ω3 and that of the contact, φ̇ [rad/s]. */
export function steadyAt(disk, tilt) {
  const [w2, w3] = steadyRates(disk, tilt, null, null);
  return { w2, w3, precession: w2 / Math.sin(tilt) };
}

// Gauss and Legendre's nodes and weights of order 10 on (0, 1)
const NODES = [0.04691007703066802, 0.23076534494715845, 0.5, 0.7692346550528415, 0.953089922969332];
const WEIGHTS = [0.11846344252809454, 0.23931433524968324, 0.28444444444444444, 0.23931433524968324, 0.11846344252809454];
const [PIECES, DEEPEST] = [240, 16]; // down to e⁻¹⁶ of the first tilt, where all that follows is a power of the tilt
const FAST = 0.05; // of the tilt, lost in a radian of precession: a disk that sinks faster is no longer on the slow manifold

/**
 * Return the history from steady rolling at a tilt [rad] on: columns tilt [rad], time and time left [s], fall −θ̇, rate of the
 * contact φ̇ and turning of the face [rad/s], and the turns [rad] of contact and face so far.
 *
 * `losses` are laws as a spec has them; the half thickness is in m. The couples change ω2 and ω3, and the tilt follows at the
 * rate that keeps θ̈ at zero, to first order in the losses: the slow manifold of `rollingStart`. It is solved in ln α, where it is smooth to the end. The time
 * left is summed from the end, where it is far smaller than a rounding of the time.
 */
export function historyOf(losses, first, halfThickness = 0) {
  const slow = slowMotion(diskOf(halfThickness), checkedLaws(losses), first);
  const step = depthOf(slow) / PIECES;
  const rows = Array.from({ length: PIECES + 1 }, (_, k) => first * Math.exp(-step * k));
  const at = rows.map((_, k) => slow(step * k));
  const pieces = rows.slice(1).map((_, k) => pieceOf(slow, step * k, step));
  const running = (name) => pieces.reduce((all, piece) => [...all, all.at(-1) + piece[name]], [0]);
  const left = [timeAfter(pieces)];
  for (const { time } of pieces.toReversed()) left.push(left.at(-1) + time);
  left.reverse();
  return {
    tilt: rows, left, end: left[0], time: left.map((x) => left[0] - x), heading: running("heading"), face: running("face"),
    fall: at.map(({ fall }) => fall), rate: at.map(({ precession }) => precession), turning: at.map(({ face }) => face),
  }; // prettier-ignore
}

/** Return the function u → {tilt, fall −θ̇, precession φ̇, face φ̇ + ψ̇} at the tilt first·e⁻ᵘ. */
function slowMotion(disk, laws, first) {
  const at = (u, [logRate, ratio]) => {
    const tilt = first * Math.exp(-u);
    const w2 = Math.exp(logRate);
    const w3 = ratio * w2;
    return { tilt, w2, w3, fall: -slowTiltRate(disk, laws, tilt, w2, w3) };
  };
  const rates = (u, state, out) => {
    const { tilt, w2, w3, fall } = at(u, state);
    const [push2, push3] = disk.accelerations(...couples(disk, laws, tilt, w2, w3));
    const [d2, d3] = disk.transport(tilt, w2, w3);
    const time = tilt / fall; // dt/du
    const [change2, change3] = [time * (push2 - fall * d2), time * (push3 - fall * d3)];
    out[0] = change2 / w2;
    out[1] = (change3 - (w3 / w2) * change2) / w2;
  };
  const { w2, w3 } = steadyAt(disk, first);
  const path = new Stepped({ rates, start: [Math.log(w2), w3 / w2], scale: [1, 1], tolerance: 1e-13 });
  return (u) => {
    const { tilt, w2: rise, w3: spin, fall } = at(u, path.at(u));
    const precession = rise / Math.sin(tilt);
    return { tilt, fall, precession, face: spin + 2 * precession * Math.sin(0.5 * tilt) ** 2 };
  };
}

/** Return the ln of the first tilt over the last, at which the disk leaves the slow manifold. */
function depthOf(slow) {
  for (let u = 0.25; u < DEEPEST; u += 0.25) {
    const { tilt, fall, precession } = slow(u);
    if (fall > FAST * tilt * precession) return u;
  }
  return DEEPEST;
}

/** Return {time, heading, face} that pass while u grows by a step. */
function pieceOf(slow, from, step) {
  const piece = { time: 0, heading: 0, face: 0 };
  NODES.forEach((node, n) => {
    const { tilt, fall, precession, face } = slow(from + step * node);
    const time = (step * WEIGHTS[n] * tilt) / fall;
    piece.time += time;
    piece.heading += time * precession;
    piece.face += time * face;
  });
  return piece;
}

/** Return the time [s] from the last row to the end: a piece takes a power of its tilt, so all that follow are a geometric series. */
function timeAfter(pieces) {
  const [before, last] = pieces.slice(-2).map(({ time }) => time);
  return (last * (last / before)) / (1 - last / before);
}

/** Return {tilt, heading, face, rate} at a time [s], by cubic pieces between the rows, and after the last as powers of the time left. */
export function stateAt(history, t) {
  const { time, rate, tilt, end } = history;
  const at = Math.min(Math.max(t, 0), end);
  const last = time.length - 1;
  if (at >= time[last]) return fallingAt(history, end - at);
  let [low, high] = [0, last];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (time[middle] <= at) low = middle;
    else high = middle;
  }
  const span = time[high] - time[low];
  const u = (at - time[low]) / span;
  const mix = (column) => column[low] + u * (column[high] - column[low]);
  // turns and tilt by their rates at both ends, so that nothing jerks from row to row
  const hermite = ([from, to], [r, s]) => {
    const [p, q] = [2 * u ** 3 - 3 * u ** 2 + 1, u ** 3 - 2 * u ** 2 + u];
    return p * from + q * span * r + (1 - p) * to + (u ** 3 - u ** 2) * span * s;
  };
  const ends = (column) => [column[low], column[high]];
  return {
    tilt: hermite(ends(tilt), ends(history.fall).map((x) => -x)), heading: hermite(ends(history.heading), ends(rate)),
    face: hermite(ends(history.face), ends(history.turning)), rate: mix(rate),
  }; // prettier-ignore
}

/** Return the state in the last moments, so long before the end. */
function fallingAt(history, left) {
  const last = history.tilt.length - 1;
  const n = exponentAt(history, last - 1);
  const share = Math.max(left / history.left[last], 1e-12);
  const gone = (history.left[last] * (1 - share ** (1 - n / 2))) / (1 - n / 2);
  return {
    tilt: history.tilt[last] * share ** n, rate: history.rate[last] * share ** (-n / 2),
    heading: history.heading[last] + history.rate[last] * gone, face: history.face[last] + history.turning[last] * gone,
  }; // prettier-ignore
}

/** Return d ln α/d ln(time left) at a row: n in α ∝ (t₀ − t)ⁿ. */
export function exponentAt(history, row) {
  const { left } = history;
  return Math.log(history.tilt[row + 1] / history.tilt[row - 1]) / Math.log(left[row + 1] / left[row - 1]);
}

/** Return late exponents of a thin disk: of the tilt by the time left, and of the contact's rate by the tilt. */
export function exponentsOf(losses, first) {
  const history = historyOf(LOSSES[losses], first);
  return [exponentAt(history, lateRow(history)), powerOfRate(history)];
}

/** Return a row near the end whose neighbours are still on the slow manifold. */
export const lateRow = ({ tilt }) => tilt.length - 10;

/** Return d ln(rate)/d ln(tilt) between late rows. */
export function powerOfRate({ tilt, rate }) {
  const [i, j] = [0.62, 0.83].map((share) => Math.round(share * PIECES));
  return Math.log(rate[j] / rate[i]) / Math.log(tilt[j] / tilt[i]);
}
