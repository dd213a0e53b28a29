// Polynomials of L₁, L₂, L₃ as lists of [coefficient, [powers]]: enough to differentiate, multiply and word them exactly.

/** Return the sum of terms with equal powers put together; what cancels is left out. */
export function collected(terms) {
  const found = new Map();
  for (const [coefficient, powers] of terms) {
    const key = powers.join();
    found.set(key, [(found.get(key)?.[0] ?? 0) + coefficient, powers]);
  }
  const kept = [...found.values()].filter(([coefficient]) => Math.abs(coefficient) > 1e-14);
  return kept.sort((a, b) => b[1].reduce((all, x, k) => all || x - a[1][k], 0) * -1).reverse();
}

export const product = (p, q) => collected(p.flatMap(([a, m]) => q.map(([b, n]) => [a * b, m.map((x, k) => x + n[k])])));
export const scaled = (p, factor) => p.map(([a, m]) => [a * factor, m]);

/** Return ∂p/∂L_k. */
export const derivative = (p, k) =>
  p.filter(([, m]) => m[k] > 0).map(([a, m]) => [a * m[k], m.map((x, j) => (j === k ? x - 1 : x))]);

/** Return the value at L; squares and products are multiplied out, as this runs at every pixel. */
export function valueOf(p, L) {
  let all = 0;
  for (let n = 0; n < p.length; n++) {
    const m = p[n][1];
    let term = p[n][0];
    for (let k = 0; k < 3; k++) {
      for (let power = m[k]; power > 0; power--) term *= L[k];
    }
    all += term;
  }
  return all;
}

/** Return the gradient at L. */
export const gradientAt = (p, L) => [0, 1, 2].map((k) => valueOf(derivative(p, k), L));

const FRACTIONS = [[1, 6, "⅙"], [1, 3, "⅓"], [1, 2, "½"], [1, 4, "¼"], [2, 3, "⅔"], [3, 4, "¾"], [3, 2, "3/2"], [4, 3, "4/3"]]; // prettier-ignore

function factorWords(size) {
  const found = FRACTIONS.find(([a, b]) => Math.abs(size - a / b) < 1e-12);
  return found ? found[2] : String(Number(size.toPrecision(4)));
}

/** Return a polynomial in words, such as "−½L₁L₂". */
export function worded(p) {
  if (!p.length) return "0";
  return p.map(([a, m], n) => {
    const letters = m.map((power, k) => (power ? `L${"₁₂₃"[k]}${power > 1 ? "²³⁴"[power - 2] : ""}` : "")).join("");
    const size = Math.abs(Math.abs(a) - 1) < 1e-14 && letters ? "" : factorWords(Math.abs(a));
    const sign = a < 0 ? "−" : n ? "+" : "";
    return `${n && sign ? ` ${sign} ` : sign}${size}${letters}`;
  }).join(""); // prettier-ignore
}
