// Levels of an asymmetric rotor, and the polhodes whose caps hold a half-integer number of quanta. Units: ħ = 1, energies and
// rotational constants in the same unit.
import { FreeMotion } from "../../../../reference/polhode.js";
import { eigen } from "./inertia.js";

export const [A, C] = [27, 9]; // the largest and the least rotational constant
const [TOLERANCE, MOST_TRIES] = [1e-14, 80]; // of the energy's range: where the search for an orbit ends; then it gives what it has

/** Return the classical |L| that gives the right number of states, J + ½. */
export const radiusOf = (J) => J + 0.5;

/** Return the matrix of H = A J_a² + B J_b² + C J_c² between the states K = −J…J along axis a. */
export function hamiltonian(B, J) {
  const [mean, difference, j] = [0.5 * (B + C), 0.25 * (B - C), J * (J + 1)];
  const H = Array.from({ length: 2 * J + 1 }, () => new Array(2 * J + 1).fill(0));
  for (let K = -J; K <= J; K++) {
    H[K + J][K + J] = mean * j + (A - mean) * K * K;
    if (K + 2 > J) continue;
    const raising = Math.sqrt((j - K * (K + 1)) * (j - (K + 1) * (K + 2)));
    H[K + J][K + 2 + J] = H[K + 2 + J][K + J] = difference * raising;
  }
  return H;
}

/** Return the 2J + 1 levels in ascending order. */
export function levelsOf(B, J) {
  const H = hamiltonian(B, J);
  // even and odd K do not mix
  const part = (odd) => H.filter((_, k) => (k & 1) === odd).map((row) => row.filter((_, k) => (k & 1) === odd));
  return [0, 1].flatMap((odd) => (J === 0 && odd ? [] : eigen(part(odd)).values)).sort((a, b) => a - b);
}

/** Return a momentum of length G and this energy, in the plane of axes a and c. */
export function momentumAt(energy, G) {
  const share = Math.min(1, Math.max(0, (energy / (G * G) - C) / (A - C)));
  return [G * Math.sqrt(share), 0, G * Math.sqrt(1 - share)];
}

/** Return the classical rotor's motion at an energy. */
export const motionAt = (energy, B, G) => new FreeMotion({ moments: [0.5 / A, 0.5 / B, 0.5 / C], momentum: momentumAt(energy, G) });

/** Return how many quanta the caps about axis c and about axis a hold where the polhodes cross. */
export function quantaOfCaps(B, G) {
  // between the two great circles through axis b, whose planes lean from axis c by an angle with tan² = (B − C)/(A − B)
  const lean = Math.atan(Math.sqrt((B - C) / (A - B)));
  const about = (angle) => (G * 4 * angle) / (2 * Math.PI);
  return { c: about(lean), a: about(0.5 * Math.PI - lean) };
}

/**
 * Return the energy of the polhode about an axis, "c" or "a", whose cap holds so many quanta.
 *
 * Newton's steps with dq/dE = ± T/2π, T the period, between bounds that halve where a step would leave them.
 */
export function energyOfQuanta(quanta, axis, B, J) {
  const G = radiusOf(J);
  const sense = axis === "c" ? 1 : -1;
  let [low, high] = axis === "c" ? [C * G * G, B * G * G] : [B * G * G, A * G * G];
  const range = high - low;
  let energy = 0.5 * (low + high);
  for (let tries = 0; tries < MOST_TRIES; tries++) {
    const motion = motionAt(energy, B, G);
    const missing = quanta - (G * motion.solidAngle) / (2 * Math.PI);
    if (missing * sense > 0) low = energy;
    else high = energy;
    const next = energy + (sense * missing * 2 * Math.PI) / motion.period;
    const step = (next > low && next < high ? next : 0.5 * (low + high)) - energy;
    energy += step;
    if (Math.abs(step) < TOLERANCE * range || high - low < TOLERANCE * range) break;
  }
  return energy;
}

/**
 * Return, for each level in ascending order, {energy, axis, quanta, orbit}: its polhode's axis, the quanta n + ½ in the cap and
 * the energy of that orbit, or null where no orbit of its pair has room beside the crossing.
 */
export function pairedLevels(B, J) {
  const room = quantaOfCaps(B, radiusOf(J));
  const known = new Map();
  const orbit = (quanta, axis) => {
    const key = `${quanta}${axis}`;
    if (!known.has(key)) known.set(key, energyOfQuanta(quanta, axis, B, J));
    return known.get(key);
  };
  return levelsOf(B, J).map((energy, i) => {
    const [low, high] = [Math.floor(i / 2) + 0.5, Math.floor((2 * J - i) / 2) + 0.5];
    if (low < room.c) return { energy, axis: "c", quanta: low, orbit: orbit(low, "c") };
    if (high < room.a) return { energy, axis: "a", quanta: high, orbit: orbit(high, "a") };
    return { energy, axis: null, quanta: null, orbit: null };
  });
}
