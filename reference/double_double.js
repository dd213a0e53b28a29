// Double-double arithmetic: a number is a pair [high, low], an unevaluated sum with about 32 digits.
// Sources: Dekker, Numer. Math. 18 (1971) 224; Hida, Li & Bailey, ARITH-15 (2001).

export const PI = [Math.PI, 1.2246467991473532e-16];
export const INVERSE_TWO_PI = [0.15915494309189535, -9.839338337591243e-18];
export const LN2 = [0.6931471805599453, 2.3190468138462996e-17];
export const ZERO = [0, 0];
export const ONE = [1, 0];

const SPLITTER = 134217729; // 2²⁷ + 1 [Veltkamp]

/** Return the upper half of a double, of at most 26 bits; a − upper(a) is exact and as short. */
export function upper(a) {
  const c = SPLITTER * a;
  return c - (c - a);
}

/** Return a + b and its exact error [Knuth]. */
export function twoSum(a, b) {
  const s = a + b;
  const t = s - a;
  return [s, a - (s - t) + (b - t)];
}

/** Return a + b and its exact error, for |a| ≥ |b| [Dekker]. */
export function fastTwoSum(a, b) {
  const s = a + b;
  return [s, b - (s - a)];
}

/** Return a b and its exact error, barring overflow and underflow [Dekker, Veltkamp]. */
export function twoProduct(a, b) {
  const ah = upper(a);
  const al = a - ah;
  const bh = upper(b);
  const bl = b - bh;
  const p = a * b;
  return [p, ah * bh - p + ah * bl + al * bh + al * bl];
}

export const from = (a) => [a, 0];
export const negate = (x) => [-x[0], -x[1]];

export function add(x, y) {
  const [s, e] = twoSum(x[0], y[0]);
  return fastTwoSum(s, e + (x[1] + y[1]));
}

export const subtract = (x, y) => add(x, negate(y));

export function multiply(x, y) {
  const [p, e] = twoProduct(x[0], y[0]);
  return fastTwoSum(p, e + (x[0] * y[1] + x[1] * y[0]));
}

export const timesFloat = (x, factor) => multiply(x, [factor, 0]);
export const square = (x) => multiply(x, x);

/** Return x times an exact power of two, or 0 or ±1. */
export const scale = (x, power) => [x[0] * power, x[1] * power];

export function divide(x, y) {
  const q = x[0] / y[0];
  const [p, e] = twoProduct(q, y[0]);
  const r = x[0] - p - e + (x[1] - q * y[1]);
  return fastTwoSum(q, r / y[0]);
}

/** Return √x; zero for x = 0. */
export function sqrt(x) {
  const s = Math.sqrt(x[0]);
  const [p, e] = twoProduct(s, s);
  const r = x[0] - p - e + x[1];
  return fastTwoSum(s, r / (s > 0 ? s + s : 1));
}

/** Return the exact product of a sum of floats and a float, as a sum with twice as many terms [Shewchuk 1997]. */
export const expansionProduct = (terms, factor) => terms.flatMap((term) => twoProduct(term, factor));

/** Return the exact product of two sums of floats as a sum of floats. */
export const expansionTimesExpansion = (x, y) => y.flatMap((factor) => expansionProduct(x, factor));

/** Move a sum's leading part to its end; the sum stays exactly what it was [Ogita, Rump & Oishi 2005]. */
function swept(terms) {
  const out = [];
  let running = terms[0];
  for (let k = 1; k < terms.length; k++) {
    const [s, e] = twoSum(running, terms[k]);
    running = s;
    out.push(e);
  }
  out.push(running);
  return out;
}

/** Return the sum of floats to double-double accuracy, whatever cancels, up to 2^(−53 passes). */
export function distil(terms, passes = 5) {
  let x = terms;
  for (let k = 0; k < passes; k++) x = swept(x);
  let rest = x[0];
  for (let k = 1; k < x.length - 1; k++) rest += x[k];
  return twoSum(x[x.length - 1], rest);
}

/** Return a sum of floats as one of `count`, largest last, correct to 2^(−53 count) of its size. */
export function compress(terms, count = 4) {
  if (terms.length <= count) return terms;
  let x = terms;
  for (let k = 0; k <= count; k++) x = swept(x);
  return x.slice(-count);
}

const bits = new DataView(new ArrayBuffer(8));

/** Return e with |x| = m 2^e, ½ ≤ m < 1; zero for x = 0. */
export function exponentOf(x) {
  if (x === 0) return 0;
  bits.setFloat64(0, x);
  const e = (bits.getUint32(0) >>> 20) & 0x7ff;
  return e === 0 ? exponentOf(x * 2 ** 100) - 100 : e - 1022;
}

/** Return x 2^e, also where 2^e itself is no number. */
export function timesPowerOfTwo(x, e) {
  const first = Math.max(-1000, Math.min(1000, e));
  const scaled = x * 2 ** first;
  return e === first ? scaled : timesPowerOfTwo(scaled, e - first);
}
