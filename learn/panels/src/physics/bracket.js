// The Lie–Poisson bracket on so(3)*: {F, G} = ± L · (∇F × ∇G), with the minus sign for bodies and the plus sign for spins.
import { Stepped } from "../../../../reference/stepped/index.js";
import { collected, derivative, product, scaled, valueOf, worded } from "./polynomials.js";

const TOLERANCE = 1e-14;

/** Functions of L that can be chosen, as polynomials; units of L and its square. */
export const FUNCTIONS = {
  L1: [[1, [1, 0, 0]]],
  L2: [[1, [0, 1, 0]]],
  L3: [[1, [0, 0, 1]]],
  body: [[1 / 2, [2, 0, 0]], [1 / 4, [0, 2, 0]], [1 / 6, [0, 0, 2]]], // ½ L·I⁻¹L with I = 1, 2, 3
  twist: [[1 / 2, [0, 0, 2]]],
  saddle: [[1, [1, 1, 0]]],
  tilted: [[1 / 2, [2, 0, 0]], [1, [0, 0, 1]]],
  casimir: [[1 / 2, [2, 0, 0]], [1 / 2, [0, 2, 0]], [1 / 2, [0, 0, 2]]], // ½ |L|²
}; // prettier-ignore

/** Return {F, G} as a polynomial; `sign` −1 or 1. */
export function bracketOf(F, G, sign) {
  const letter = [0, 1, 2].map((k) => [[1, [0, 1, 2].map((j) => (j === k ? 1 : 0))]]);
  const terms = [0, 1, 2].flatMap((k) => {
    const [i, j] = [(k + 1) % 3, (k + 2) % 3];
    const across = [...product(derivative(F, i), derivative(G, j)), ...scaled(product(derivative(F, j), derivative(G, i)), -1)];
    return product(letter[k], collected(across));
  });
  return collected(scaled(terms, sign));
}

/** Return the function L → dL/dt = ± ∇H × L, which is {L, H}. */
export function fieldOf(H, sign) {
  const [p, q, r] = [0, 1, 2].map((k) => scaled(derivative(H, k), sign));
  return (L) => {
    const [a, b, c] = [valueOf(p, L), valueOf(q, L), valueOf(r, L)];
    return [b * L[2] - c * L[1], c * L[0] - a * L[2], a * L[1] - b * L[0]];
  };
}

/** Return the flow of H from L by steps of order 8, each to 1e-14. */
export function flowFrom(H, L, sign) {
  const field = fieldOf(H, sign);
  const rates = (t, state, out) => field(state).forEach((x, k) => (out[k] = x));
  return new Stepped({ rates, start: L, scale: [1, 1, 1], tolerance: TOLERANCE });
}

/** Return F and its rate along the flow at a time, the rate by differences of F alone, of order 6. */
export function rateAlong(F, flow, t, step = 0.02) {
  const at = (k) => valueOf(F, flow.at(t + k * step));
  const rate = (45 * (at(1) - at(-1)) - 9 * (at(2) - at(-2)) + at(3) - at(-3)) / (60 * step);
  return { value: at(0), rate };
}

/** Return a start on the sphere of this radius at a height from −1 to 1 and a longitude [rad]. */
export function startAt(radius, height, longitude) {
  const level = radius * Math.sqrt(1 - height * height);
  return [level * Math.cos(longitude), level * Math.sin(longitude), radius * height];
}

/** Return {F, G} of two functions by their names, in words. */
export const bracketInWords = (F, G, sign) => worded(bracketOf(FUNCTIONS[F], FUNCTIONS[G], sign));

/** Return what `rateAlong` gives at times along the flow of H, the functions by their names. */
export function rateOf(F, H, L, sign, times) {
  const flow = flowFrom(FUNCTIONS[H], L, sign);
  return times.map((t) => rateAlong(FUNCTIONS[F], flow, t));
}
