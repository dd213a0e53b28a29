// Printed from src/polhode/exact/_kernel_arithmetic.py, src/polhode/special/_doubledouble.py by `python -m printing`:
// change that, and print again.
//
// Double-double arithmetic, sines of turns, and phases reduced to a fraction of a turn.
//
// Sources: Dekker, Numer. Math. 18 (1971) 224; Hida, Li & Bailey, ARITH-15 (2001).

export const ROUNDING = 6755399441055744; // 1.5 · 2⁵²: added and taken away again, it leaves the nearest whole number
export const SPLITTING = 134217729; // 2²⁷ + 1
// of the power series of sin 2πx and cos 2πx
export const S0 = 6.283185307179586;
export const S1 = -41.341702240399755;
export const S2 = 81.60524927607504;
export const S3 = -76.70585975306136;
export const S4 = 42.058693944897634;
export const S5 = -15.094642576822984;
export const S6 = 3.8199525848482803;
export const S7 = -0.7181223017785001;
export const S8 = 0.10422916220813978;
export const C0 = 1;
export const C1 = -19.739208802178716;
export const C2 = 64.93939402266828;
export const C3 = -85.45681720669371;
export const C4 = 60.24464137187664;
export const C5 = -26.426256783374388;
export const C6 = 7.903536371318465;
export const C7 = -1.7143907110886711;
export const C8 = 0.282005968455791;
export const C9 = -0.03638284114254564;

// ---------------------------------------------------------------------- what `compiledArithmetic` has in other forms

/** Return the product and its exact error, as long as that does not underflow [Dekker–Veltkamp]. */
export function twoProduct(a, b) {
  const p = a * b;
  const t = SPLITTING * a;
  const u = SPLITTING * b;
  const ah = t - (t - a);
  const bh = u - (u - b);
  const al = a - ah;
  const bl = b - bh;
  return [p, ah * bh - p + ah * bl + al * bh + al * bl];
}

// ---------------------------------------------------------------------- whole numbers, circular functions, phases

export function whole(x) {
  return x + ROUNDING - ROUNDING;
}

/** Return sin 2πx and cos 2πx, |x| ≤ ½. */
export function sineCosine(x) {
  const quarter = whole(4 * x);
  const r = x - 0.25 * quarter;
  const z = r * r;
  const s = r * (S0 + z * (S1 + z * (S2 + z * (S3 + z * (S4 + z * (S5 + z * (S6 + z * (S7 + z * S8))))))));
  const c = C0 + z * (C1 + z * (C2 + z * (C3 + z * (C4 + z * (C5 + z * (C6 + z * (C7 + z * (C8 + z * C9))))))));
  const n = quarter - 4 * Math.floor(0.25 * quarter);
  const odd = n === 1 || n === 3;
  const { 0: a, 1: b } = odd ? [c, s] : [s, c];
  return [n >= 2 ? -a : a, n === 1 || n === 2 ? -b : b];
}

export function halves(x) {
  const t = SPLITTING * x;
  const high = t - (t - x);
  return [high, x - high];
}

/** Return `circular.reduced_phase`. */
export function phase(rate, time) {
  const { 0: upper, 1: lower, 2: least } = rate;
  const { 0: high, 1: low, 2: rest } = time;
  const a = upper * high;
  const b = upper * low;
  const c = lower * high;
  const na = whole(a);
  const nb = whole(b);
  const nc = whole(c);
  const d = lower * low + least * (high + low) + (upper + lower) * rest;
  const { 0: middle, 1: middleError } = twoSum(b - nb, c - nc);
  const { 0: fraction, 1: error } = twoSum(a - na, middle);
  const more = whole(fraction);
  return [fraction - more, error + (middleError + d), na + (nb + nc) + more];
}

// ---------------------------------------------------------------------- double-double numbers

export function twoSum(a, b) {
  const s = a + b;
  const t = s - a;
  return [s, a - (s - t) + (b - t)];
}

export function twoSquare(a) {
  return twoProduct(a, a);
}

export function fastTwoSum(a, b) {
  const s = a + b;
  return [s, b - (s - a)];
}

export function add(x, y) {
  const { 0: s, 1: e } = twoSum(x[0], y[0]);
  return fastTwoSum(s, e + (x[1] + y[1]));
}

export function subtract(x, y) {
  return add(x, [-y[0], -y[1]]);
}

export function multiply(x, y) {
  const { 0: p, 1: e } = twoProduct(x[0], y[0]);
  return fastTwoSum(p, e + (x[0] * y[1] + x[1] * y[0]));
}

export function multiplyFloat(x, factor) {
  const { 0: p, 1: e } = twoProduct(x[0], factor);
  return fastTwoSum(p, e + x[1] * factor);
}

export function square(x) {
  const { 0: p, 1: e } = twoProduct(x[0], x[0]);
  return fastTwoSum(p, e + 2 * x[0] * x[1]);
}

export function scale(x, powerOfTwo) {
  return [x[0] * powerOfTwo, x[1] * powerOfTwo];
}

export function divide(x, y) {
  const q = x[0] / y[0];
  const { 0: p, 1: e } = twoProduct(q, y[0]);
  const r = x[0] - p - e + (x[1] - q * y[1]);
  return fastTwoSum(q, r / y[0]);
}

/** Return √x of a positive number. */
export function root(x) {
  const s = Math.sqrt(x[0]);
  const { 0: p, 1: e } = twoProduct(s, s);
  return fastTwoSum(s, (x[0] - p - e + x[1]) / (s + s));
}

/** Return √x, zero for x = 0. */
export function rootOrZero(x) {
  const zero = x[0] === 0;
  return zero ? [0, 0] : root(zero ? [1, 0] : x);
}

export const PI = [3.141592653589793, 1.2246467991473532e-16];
export const INVERSE_TWO_PI = [0.15915494309189535, -9.839338337591243e-18];
export const LN2 = [0.6931471805599453, 2.3190468138462996e-17];
