// Order statistics and runs, by the rules that NumPy has, so that thresholds decide alike here and there.

/** Return the median of numbers; the mean of the two in the middle of an even count. */
export const median = (values) => quantile(values, 0.5);

/** Return a quantile, linear between neighbours; NaN of nothing. */
export function quantile(values, part) {
  const sorted = Float64Array.from(values).sort();
  if (!sorted.length) return NaN;
  const at = part * (sorted.length - 1);
  const low = Math.floor(at);
  const high = Math.min(low + 1, sorted.length - 1);
  return sorted[low] + (at - low) * (sorted[high] - sorted[low]);
}

/** Return the nearest integer, the even one of two equally near. */
export function roundEven(value) {
  const low = Math.floor(value);
  const rest = value - low;
  if (rest !== 0.5) return Math.round(value);
  return low % 2 === 0 ? low : low + 1;
}

/** Return the steps between neighbours. */
export const steps = (times) => Float64Array.from({ length: Math.max(times.length - 1, 0) }, (_, k) => times[k + 1] - times[k]);

/** Return [first, behind] of each run of true flags. */
export function runs(flags) {
  const found = [];
  for (let k = 0; k < flags.length; k++) {
    if (!flags[k]) continue;
    const first = k;
    while (k < flags.length && flags[k]) k += 1;
    found.push([first, k]);
  }
  return found;
}

/** Return the first index of an ascending array whose value is at least `wanted`, or greater with `after`. */
export function place(sorted, wanted, after = false) {
  let [low, high] = [0, sorted.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (sorted[middle] < wanted || (after && sorted[middle] === wanted)) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** Return the lengths of the rows of an (n, 3) array. */
export function lengths(rows) {
  return Float64Array.from({ length: rows.length / 3 }, (_, k) => Math.hypot(rows[3 * k], rows[3 * k + 1], rows[3 * k + 2]));
}

/** Return one column of an (n, 3) array. */
export const column = (rows, axis) => Float64Array.from({ length: rows.length / 3 }, (_, k) => rows[3 * k + axis]);

/** Return the mean (3) of the rows [first, behind) of an (n, 3) array. */
export function meanRow(rows, first = 0, behind = rows.length / 3) {
  const sum = [0, 0, 0];
  for (let k = first; k < behind; k++) for (let i = 0; i < 3; i++) sum[i] += rows[3 * k + i];
  return sum.map((value) => value / (behind - first));
}

/** Return the noise of a sample from third differences, in which smooth motion vanishes; over all of several arrays. */
export function noiseOf(several, width = 3) {
  const found = [];
  for (const rows of several) {
    for (let k = 0; k + 3 * width < rows.length; k++) {
      found.push(Math.abs(rows[k + 3 * width] - 3 * rows[k + 2 * width] + 3 * rows[k + width] - rows[k]));
    }
  }
  return found.length ? median(found) / (0.6745 * Math.sqrt(20)) : 0;
}
