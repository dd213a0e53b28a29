// Sums of floats that are exact: what cancels in double-double is added up in these.
import { twoProduct, twoSum } from "./formulas/arithmetic.js";

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
