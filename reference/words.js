// The words of the formulas that JavaScript has not as operators or functions of Math.

/** Return x or, where it is not larger, y. */
export const larger = (x, y) => (x > y ? x : y);

/** Return x or, where it is not smaller, y. */
export const smaller = (x, y) => (x < y ? x : y);

/** Return the nearest whole number, the even one of two. */
export function nearest(x) {
  const up = Math.round(x);
  return (up - x === 0.5 && up % 2 !== 0 ? up - 1 : up) + 0; // never −0
}

const bits = new DataView(new ArrayBuffer(8));

/** Return e with ½ ≤ |x|/2^e < 1; zero for x = 0. */
export function binaryExponent(x) {
  if (x === 0) return 0;
  bits.setFloat64(0, x);
  const e = (bits.getUint32(0) >>> 20) & 0x7ff;
  return e === 0 ? binaryExponent(x * 2 ** 100) - 100 : e - 1022;
}

/** Return 2ⁿ x for a whole number n, also where 2ⁿ itself is no number. */
export function timesPower(x, n) {
  const first = Math.max(-1000, Math.min(1000, n));
  const scaled = x * 2 ** first;
  return n === first ? scaled : timesPower(scaled, n - first);
}
