// The attitude of a free body as a quotient of theta functions: what is prepared once, and evaluated at any time.
//
// Two complex theta functions A and B of the polhode angle make, up to their norm, the quaternion of the frame whose third
// row is the angular momentum (Jacobi 1849; Klein & Sommerfeld, Theorie des Kreisels). Both are short series in the smaller
// of two nomes: the full form (m ≤ ½) is trigonometric in the polhode angle, the complementary form exponential.
import * as dd from "./double_double.js";
import { nomePerParameter, theta3Excess } from "./elliptic.js";
import { EPOCH, exponentialDecay, reducedPhase, sineCosine, splitRate, wrapped } from "./phase.js";
import { multiply } from "./quaternion.js";

const HUGE = [2 ** -400, 2 ** -200]; // a hyperbolic sine above the inverse of the first is scaled by the second
const LOG_OF_SCALE = [138.62943611198907, -3.3555121496085278e-15]; // 200 ln 2

// scratch of evaluation, which is not re-entered: phases, and the spinor Re A, Im A, Re B, Im B
const [one, two, wave, spinor] = [3, 3, 2, 4].map((size) => new Float64Array(size));

/**
 * Return all that evaluation needs.
 *
 * @param body what `reduced` gives
 * @param rates what `ratesOf` gives
 * @param given {moments, momentum, attitude} as the caller has them
 */
export function prepared(body, rates, given) {
  const { constant, separatrix } = rates;
  const m = body.A[0] * body.P[0];
  const m1 = -body.C[0] * body.S[0];
  const full = constant || (m <= m1 && !separatrix);
  const inverse = dd.scale(dd.divide(dd.INVERSE_TWO_PI, body.V), body.rateScale);
  const halfPrecession = dd.scale(dd.multiply(rates.precession, inverse), 0.5);
  const turnRate = dd.scale(dd.multiply(rates.mean, inverse), 2);
  const quarter = dd.scale(turnRate, 0.25);
  const saddleRate = dd.scale(dd.divide(rates.modulus, body.V), body.rateScale);
  let first = full ? dd.subtract(halfPrecession, quarter) : halfPrecession;
  let second = full ? dd.add(halfPrecession, quarter) : separatrix ? saddleRate : turnRate;
  if (constant) [first, second] = [permanentRate(body), dd.ZERO];
  const series = constant ? permanentSeries() : full ? fullSeries(body, m, m1) : complementarySeries(body, rates, m, m1);
  const motion = { ...series, full, first: splitRate(first), second: splitRate(second) };
  return { ...motion, ...matrices(motion, body, rates, given) };
}

/** Return |Ω|/4π, the rate of half the angle of a permanent rotation, in turns. */
function permanentRate(body) {
  const [x, y, z] = body.momentum.map((L, k) => dd.square(dd.divide(dd.from(L), dd.from(body.moments[k]))));
  const rate = dd.multiply(dd.sqrt(dd.add(dd.add(x, y), z)), dd.INVERSE_TWO_PI);
  return dd.scale(rate, 0.5 * body.rateScale);
}

const permanentSeries = () => ({ start: 0, a: [1, 0, 0, 0, 0], b: [0, 0, 0, 0, 0] });

/**
 * Follow a circular and a hyperbolic amplitude down five Landen steps from the complementary modulus k.
 *
 * Returns the factor of the tangent of the circular amplitude and the hyperbolic sine of the other. The first step takes
 * sinh · c, c and dc · c, so that none of them needs a quotient that may be 0/0.
 */
function landen(k, dn, sinhTimesCosine, cosine, dc) {
  let [x, y, factor, sinh] = [1, k, 1, sinhTimesCosine];
  for (let step = 0; step < 5; step++) {
    const kappa = (x - y) / (x + y);
    [x, y] = [0.5 * (x + y), Math.sqrt(x * y)];
    const grown = 1 + kappa;
    const next = Math.sqrt(1 - (kappa * (1 - dn)) / (1 + dn));
    factor *= next / grown;
    sinh = (2 * sinh) / (grown * (cosine + dc));
    dc = Math.sqrt(1 + (kappa * (dc - cosine)) / (dc + cosine));
    [cosine, dn] = [1, next];
  }
  return [factor, sinh];
}

/** Return start and coefficients of A and B of the form for m ≤ ½. */
function fullSeries(body, m, m1) {
  const [A, B, C, Q] = [body.A[0], body.B[0], body.C[0], body.Q[0]];
  const [l1, l2, l3] = body.canonical;
  const total = B * Q;
  const overM = nomePerParameter(m / total, Math.sqrt(m1 / total));
  const q = overM * (m / total);
  // √(P/Q) sinh, as the hyperbolic sine itself overflows near a stable axis
  const small = body.rootP / Math.sqrt(Q);
  const [factor, scaled] = landen(Math.sqrt(m1 / total), l3 * Math.sqrt(C / Q), Math.sqrt(B), Math.sqrt(B), Math.sqrt(C));
  const grown = scaled + Math.sqrt(small * small + scaled * scaled);
  const g = small / grown;
  const r = (A / B) * overM * grown * grown;
  const start = Math.atan2(Math.sqrt(B) * l2 * factor, Math.sqrt(C) * l1) * (0.25 / Math.PI);
  const g2 = g * g;
  const q2 = q * q;
  const q4 = q2 * q2;
  const q8 = q4 * q4;
  let [up, down] = [-q * g2, -q2 * r];
  let [up2, down2] = [q4 * q2 * g2 * g2, q8 * r * r];
  let both = up2 + down2;
  const a = [1 - both, up + down, 2 * both, up - down, 2 * (up2 - down2)];
  [up, up2, down2] = [-q2 * q * g2, q8 * q2 * g2 * g2, q4 * r * r];
  both = up2 + down2;
  const b = [g * (1 - both), g * (up - r), 2 * g * both, g * (up + r), 2 * g * (up2 - down2)];
  return { start, a, b };
}

/** Return start, harmonics, nome and parity of the form for m > ½, separatrix included. */
function complementarySeries(body, rates, m, m1) {
  const [B, C, P, Q, G] = [body.B[0], body.C[0], body.P[0], body.Q[0], rates.G[0]];
  const [l1, l2, l3] = body.canonical;
  const { separatrix } = rates;
  const k = separatrix ? 1 : Math.sqrt(m / (B * Q));
  const small = separatrix ? 0 : m1 / (B * Q);
  const q = small * nomePerParameter(small, k);
  const cosine = Math.sqrt(C) * Math.abs(l1);
  const dc = Math.sqrt(C) * l3 * Math.sqrt(P / Q);
  const along = Math.abs(Math.sqrt(B) * l2);
  // close to the unstable axis the hyperbolic sine and its square leave the range of numbers
  const huge = cosine + dc < HUGE[0] * along;
  const [factor, sinh] = landen(k, Math.sqrt(P / B) / G, huge ? HUGE[1] * along : along, cosine, dc);
  const y = Math.atan(Math.sqrt(Q / P) * factor);
  const argument = huge ? Math.log(2 * sinh) : Math.asinh(sinh);
  const back = huge ? 0.5 * Math.exp(argument) : Math.sinh(argument);
  let x = dd.fastTwoSum(argument, (sinh - back) / (huge ? back : Math.sqrt(1 + back * back)));
  if (huge) x = dd.add(x, LOG_OF_SCALE);
  x = dd.scale(x, l2 < 0 !== l1 < 0 ? -1 : 1);
  // πK/K' = 2K/θ3², and 1/θ3² is 1 less the small correction
  let period = dd.ONE;
  if (!separatrix) {
    const e = theta3Excess(q);
    period = dd.divide(dd.multiply(rates.modulus, dd.PI), rates.mean);
    period = dd.add(period, [-period[0] * ((e * (2 + e)) / ((1 + e) * (1 + e))), 0]);
  }
  const angles = [0, 1, 2, 3, 4].map((n) => (2 * n + 1) * (0.5 * y - 0.25 * Math.PI));
  const [high, low, rest] = splitRate(period);
  return {
    start: dd.divide(x, period), // u0/2K
    cosines: angles.map(Math.cos),
    sines: angles.map(Math.sin),
    rootNome: Math.sqrt(q),
    decay: [high, low + rest], // πK/K' in halves
    yTurns: separatrix ? 0 : y * (0.5 / Math.PI),
    periodic: separatrix ? 0 : 1,
    parity: l1 < 0 ? 1 : 0, // half turns of u at the start
  };
}

/** Return the matrices, flat by rows, from spinor to attitude and from canonical direction to momentum in the given axes. */
function matrices(motion, body, rates, { moments, momentum, attitude }) {
  const { constant } = rates;
  fillSpinor(motion, EPOCH);
  const size = Math.sqrt(spinor.reduce((sum, x) => sum + x * x, 0));
  const [a0, a1, b0, b1] = spinor.map((x) => x / size);
  // rows of (start frame)* (present frame) as functions of the spinor
  const relative = [
    [a0, a1, b0, b1],
    [-b1, b0, -a1, a0],
    [b0, b1, -a0, -a1],
    [-a1, a0, b1, -b0],
  ];
  const mirror = body.longAxis ? -1 : 1;
  const axis = rotationAxis(moments, momentum);
  const columns = [0, 1, 2, 3].map((k) => {
    if (constant) return multiply(attitude, [k === 0 ? 1 : 0, ...axis.map((x) => (k === 1 ? x : 0))]);
    const vector = body.axes.map((row) => mirror * row.reduce((sum, x, j) => sum + x * relative[1 + j][k], 0));
    return multiply(attitude, [relative[0][k], ...vector]);
  });
  const scale = rates.G[0] * body.momentumScale;
  const toMomentum = constant ? momentum.flatMap((x) => [0, 0, x]) : body.axes.flat().map((x) => scale * x);
  return { toAttitude: [0, 1, 2, 3].flatMap((i) => columns.map((column) => column[i])), toMomentum };
}

/** Return the direction of Ω along the given axes, zero at rest. */
function rotationAxis(moments, momentum) {
  const largest = Math.max(...momentum.map(Math.abs));
  if (!(largest > 0)) return [0, 0, 0];
  const least = Math.min(...moments);
  const omega = momentum.map((x, k) => (x / largest) * (least / moments[k]));
  const size = Math.sqrt(omega.reduce((sum, x) => sum + x * x, 0));
  return omega.map((x) => (size > 0 ? x / size : 0));
}

/** Put A and B at a time since the epoch, given in three parts, into the scratch spinor. */
function fillSpinor(motion, time) {
  if (motion.full) fillFull(motion, time);
  else fillComplementary(motion, time);
}

/** Sum A and B as polynomials in X = cos 2z and Y = sin 2z, where z is the difference of their phases. */
function fillFull(motion, time) {
  const { a, b, start } = motion;
  reducedPhase(motion.first, time, one);
  reducedPhase(motion.second, time, two);
  sineCosine(wrapped(one[0] + (one[1] - start)), wave);
  const sa = wave[0];
  const ca = wave[1];
  sineCosine(wrapped(two[0] + (two[1] + start)), wave);
  const sb = wave[0];
  const cb = wave[1];
  const cz = ca * cb + sa * sb;
  const sz = sb * ca - cb * sa;
  const s2 = sz + sz;
  const X = 1 - s2 * sz;
  const Y = s2 * cz;
  const pa = a[0] + X * (a[1] + X * a[2]);
  const qa = Y * (a[3] + X * a[4]);
  const pb = b[0] + X * (b[1] + X * b[2]);
  const qb = Y * (b[3] + X * b[4]);
  spinor[0] = ca * pa - sa * qa;
  spinor[1] = ca * qa + sa * pa;
  spinor[2] = cb * pb - sb * qb;
  spinor[3] = cb * qb + sb * pb;
}

/** Sum A and B in the growing powers of R = √q1 e^|x| and the decaying ones of E = e^−|x|, x = πu/2K'. */
function fillComplementary(motion, time) {
  const { start, periodic, decay, cosines, sines, rootNome } = motion;
  reducedPhase(motion.first, time, one);
  reducedPhase(motion.second, time, two);
  // on the separatrix u runs to infinity: no period is taken out
  const free = (1 - periodic) * two[2];
  const [sum, firstError] = dd.twoSum(free, two[0]);
  const [v, secondError] = dd.twoSum(sum, start[0]);
  const [w, rest] = dd.fastTwoSum(v, two[1] + (start[1] + (firstError + secondError)));
  const more = periodic * Math.round(w);
  const u = w - more;
  let count = motion.parity + (periodic * two[2] + more);
  count -= 4 * Math.round(0.25 * count);
  const turns = wrapped(one[0] - 0.25 * count) + (one[1] - u * motion.yTurns);
  const side = u < 0 ? -1 : 1;
  const f = u * side;
  const g = rest * side;
  const e0 = exponentialDecay(f, g, decay[0], decay[1]);
  const distance = Math.max(0.5 - f, 0);
  const R = periodic * exponentialDecay(distance, (0.5 - distance - f) * periodic - g, decay[0], decay[1]);
  sineCosine(wrapped(turns), wave);
  const q = rootNome * rootNome;
  const q2 = q * q;
  // terms of both kinds, n = 0 … 4, sum and difference times cosine and sine of (2n+1)(y/2 − π/4)
  let grow = 1;
  let fall = e0;
  let growBy = rootNome * R; // q^{n²/2}ρⁿ and q^{n(n+1)/2}E^{n+1}: from term to term another factor q
  let fallBy = q * e0;
  let [ar, ai, br, bi, sign] = [0, 0, 0, 0, -1];
  for (let n = 0; n < 5; n++) {
    const plus = grow + fall;
    const minus = grow - fall;
    ar += cosines[n] * plus;
    ai += sines[n] * minus;
    br += sign * sines[n] * plus;
    bi -= sign * cosines[n] * minus;
    grow *= growBy;
    fall *= fallBy;
    growBy *= q;
    fallBy *= q;
    sign = -sign;
  }
  ai *= side;
  bi *= side;
  const odd = 1 - 2 * (count - 2 * Math.floor(0.5 * count));
  const s = wave[0];
  const c = wave[1];
  spinor[0] = c * ar - s * ai;
  spinor[1] = c * ai + s * ar;
  spinor[2] = odd * (c * br - s * bi);
  spinor[3] = odd * (c * bi + s * br);
}

/** Return {attitude, momentum} at a time since the epoch, given in three parts. */
export function stateOf(motion, time) {
  fillSpinor(motion, time);
  const [a0, a1, b0, b1] = [spinor[0], spinor[1], spinor[2], spinor[3]];
  const aa = a0 * a0 + a1 * a1;
  const bb = b0 * b0 + b1 * b1;
  const x = 1 / (aa + bb);
  const root = Math.sqrt(x);
  const n1 = (a0 * b0 + a1 * b1) * (x + x);
  const n2 = (a0 * b1 - a1 * b0) * (x + x);
  const n3 = (aa - bb) * x;
  const [A, M] = [motion.toAttitude, motion.toMomentum];
  const [s0, s1, s2, s3] = [a0 * root, a1 * root, b0 * root, b1 * root];
  const row4 = (k) => A[k] * s0 + A[k + 1] * s1 + A[k + 2] * s2 + A[k + 3] * s3;
  const row3 = (k) => M[k] * n1 + M[k + 1] * n2 + M[k + 2] * n3;
  return { attitude: [row4(0), row4(4), row4(8), row4(12)], momentum: [row3(0), row3(3), row3(6)] };
}
