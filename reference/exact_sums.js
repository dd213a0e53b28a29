// Words of the formulas: sums of floats that are never added up, and so exact [Shewchuk 1997]. A pair is one of two terms.
import { twoProduct, twoSum } from "./formulas/arithmetic.js";

/** Return x + y, with the terms of both. */
export const join = (x, y) => [...x, ...y];

/** Return −x. */
export const negated = (x) => x.map((term) => -term);

/** Return the exact product with a float, with twice as many terms. */
export const multiplyTerms = (x, factor) => x.flatMap((term) => twoProduct(term, factor));

/** Return terms of equal sum, of which the last ones have the leading parts [Ogita, Rump & Oishi 2005]. */
function swept(x, times) {
  const terms = [...x];
  for (; times > 0; times--) {
    for (let k = 1; k < terms.length; k++) {
      const { 0: sum, 1: error } = twoSum(terms[k - 1], terms[k]);
      terms[k - 1] = error;
      terms[k] = sum;
    }
  }
  return terms;
}

/** Return a sum as one of `count` terms at most, largest last, correct to 2^(−53 count) of its size. */
export const compress = (x, count) => (x.length > count ? swept(x, count + 1).slice(-count) : x);

/** Return a sum to double-double accuracy, whatever cancels, up to 2^−265. */
export function distil(x) {
  const terms = swept(x, 5);
  const last = terms.pop();
  return twoSum(last, terms.reduce((rest, term) => rest + term));
}
