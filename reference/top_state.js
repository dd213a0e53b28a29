// Attitude and momentum of a prepared Lagrange top at a time.
//
// As |α|² + |β|² = 1 the common denominator of the theta quotients is not needed, and w = 2(ᾱβ̇ − βᾱ̇) needs no derivative
// of it.
import * as dd from "./double_double.js";
import { EPOCH, exponentialDecay, reducedPhase, sineCosine, wrapped } from "./phase.js";

// scratch of evaluation, which is not re-entered: phases, waves, and the numerators A, B, their derivatives by z or x', real
// and imaginary parts, and phases in turns
const [phase, wave, numerators] = [3, 2, 10].map((size) => new Float64Array(size));

/** Return A, B, their derivatives and phases at the epoch. */
export function startNumerators(motion) {
  fillNumerators(motion, EPOCH);
  return [...numerators];
}

function fillNumerators(motion, time) {
  if (motion.full) fillFull(motion, time);
  else fillComplementary(motion, time);
}

function turnsOf(rate, time) {
  reducedPhase(rate, time, phase);
  return phase[0] + phase[1];
}

function fillFull(motion, time) {
  const { aSum, aGap, bSum, bGap } = motion.series;
  sineCosine(wrapped(turnsOf(motion.third, time) + motion.start[0]), wave);
  let s = wave[0];
  let c = wave[1];
  const doubleC = 1 - 2 * s * s;
  const doubleS = 2 * s * c;
  let [ar, ai, br, bi, dar, dai, dbr, dbi] = [0, 0, 0, 0, 0, 0, 0, 0];
  for (let n = 0; n < 4; n++) {
    const k = 2 * n + 1;
    ar += aSum[n] * s;
    ai += aGap[n] * c;
    br += bSum[n] * c;
    bi += bGap[n] * s;
    dar += k * aSum[n] * c;
    dai += k * aGap[n] * s;
    dbr += k * bSum[n] * s;
    dbi += k * bGap[n] * c;
    const next = c * doubleC - s * doubleS;
    s = s * doubleC + c * doubleS;
    c = next;
  }
  const [sa, sb] = motion.signs;
  const turnsA = turnsOf(motion.first, time);
  fill(ar, -sa * ai, br, sb * bi, dar, sa * dai, -dbr, sb * dbi, turnsA, turnsOf(motion.second, time));
}

function fill(ar, ai, br, bi, dar, dai, dbr, dbi, turnsA, turnsB) {
  numerators[0] = ar;
  numerators[1] = ai;
  numerators[2] = br;
  numerators[3] = bi;
  numerators[4] = dar;
  numerators[5] = dai;
  numerators[6] = dbr;
  numerators[7] = dbi;
  numerators[8] = turnsA;
  numerators[9] = turnsB;
}

function fillComplementary(motion, time) {
  const { start, periodic, decay, q, poleTurns, signs } = motion;
  const { aSine, aCosine, bCosine, bSine, constant } = motion.series;
  reducedPhase(motion.third, time, phase);
  // x/2K within half a period as a pair, and the periods taken out; on the separatrix none is
  const [sum, firstError] = dd.twoSum((1 - periodic) * phase[2], phase[0]);
  const [v, secondError] = dd.twoSum(sum, start[0]);
  const [w, rest] = dd.fastTwoSum(v, phase[1] + (start[1] + (firstError + secondError)));
  const more = periodic * Math.round(w);
  const u = w - more;
  const count = periodic * phase[2] + more;
  const half = 0.5 * (count - 2 * Math.floor(0.5 * count));
  const side = u < 0 ? -1 : 1;
  const f = u * side;
  const g = rest * side;
  const e0 = exponentialDecay(f, g, decay[0], decay[1]);
  const distance = Math.max(0.5 - f, 0);
  const R = periodic * exponentialDecay(distance, (0.5 - distance - f) * periodic - g, decay[0], decay[1]);
  const h = e0 * e0;
  const r = R * R;
  let [ar, ai, br, bi, dar, dai, dbr, dbi] = [0, 0, constant, 0, 0, 0, 0, 0];
  // growing terms (qⁿr)ⁿ of A and (qⁿr)ⁿ⁺¹ of B, each the one before times another power of q, and decaying ones
  let weight = 1;
  let hk = h;
  let up = r;
  let down = q * h;
  let qr = q * r;
  let [upBy, downBy] = [q * q * r, q * q * q * h];
  for (let n = 0; n < 4; n++) {
    const [odd, even] = [2 * n + 1, 2 * n + 2];
    const plus = weight * (1 + hk);
    const minus = weight * (1 - hk);
    ar += aSine[n] * plus;
    ai += aCosine[n] * minus;
    dar += odd * aSine[n] * minus;
    dai += odd * aCosine[n] * plus;
    br += bCosine[n] * (up + down);
    bi += bSine[n] * (up - down);
    dbr += even * bCosine[n] * (up - down);
    dbi += even * bSine[n] * (up + down);
    weight *= qr;
    qr *= q * q;
    hk *= h * h;
    up *= upBy;
    upBy *= q * q;
    down *= downBy;
    downBy *= q * q;
  }
  const e = 2 * e0;
  const [sa, sb] = signs;
  const within = u + rest;
  const turnsA = wrapped(turnsOf(motion.first, time) + sa * within * poleTurns[0]) + half;
  const turnsB = wrapped(turnsOf(motion.second, time) + sb * within * poleTurns[1]) + half;
  fill(ar, sa * side * ai, e * br, -sb * side * e * bi, side * dar, sa * dai, side * e * dbr, -sb * e * dbi, turnsA, turnsB);
}

/** Return {attitude, momentum} at a time since the epoch, given in three parts: α = A e^{iφ_a}, β = B e^{iφ_b}, and w. */
export function topStateOf(motion, time) {
  fillNumerators(motion, time);
  const [ar, ai, br, bi] = [numerators[0], numerators[1], numerators[2], numerators[3]];
  const [dar, dai, dbr, dbi] = [numerators[4], numerators[5], numerators[6], numerators[7]];
  const { phases, gain } = motion;
  const x = 1 / (ar * ar + ai * ai + (br * br + bi * bi));
  const root = Math.sqrt(x);
  sineCosine(wrapped(numerators[8]), wave);
  const ca = wave[1] * phases[0] - wave[0] * phases[1];
  const sa = wave[0] * phases[0] + wave[1] * phases[1];
  sineCosine(wrapped(numerators[9]), wave);
  const cb = wave[1] * phases[2] - wave[0] * phases[3];
  const sb = wave[0] * phases[2] + wave[1] * phases[3];
  const aR = (ar * ca - ai * sa) * root;
  const aI = (ar * sa + ai * ca) * root;
  const bR = (br * cb - bi * sb) * root;
  const bI = (br * sb + bi * cb) * root;
  // ĀB' − BĀ' and i ĀB
  const gainR = ar * dbr + ai * dbi - (br * dar + bi * dai);
  const gainI = ar * dbi - ai * dbr - (bi * dar - br * dai);
  const wr = (gain[0] * gainR + gain[1] * (ai * br - ar * bi)) * x;
  const wi = (gain[0] * gainI + gain[1] * (ar * br + ai * bi)) * x;
  const cw = cb * ca + sb * sa;
  const sw = sb * ca - cb * sa;
  const momentum = [wr * cw - wi * sw, motion.reversed * (wr * sw + wi * cw), motion.axial];
  return { attitude: motion.reversed < 0 ? [bR, -aR, -aI, bI] : [aR, bR, bI, aI], momentum };
}
