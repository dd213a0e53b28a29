// Small dense matrices as arrays of rows: eigenvalues, singular values and linear systems, by Jacobi's rotations.

const SWEEPS = 60;

/**
 * Return {values, vectors} of a symmetric matrix, values ascending; vectors[k] is the unit vector of values[k].
 *
 * Cyclic Jacobi: the error is that of rounding, relative to the largest value. Source: Golub & Van Loan, Matrix
 * Computations, 8.5.
 */
export function eigenSymmetric(matrix) {
  const n = matrix.length;
  const a = matrix.map((row) => Float64Array.from(row));
  const v = matrix.map((_, i) => Float64Array.from({ length: n }, (_, j) => (i === j ? 1 : 0)));
  for (let sweep = 0; sweep < SWEEPS; sweep++) {
    let changed = false;
    for (let p = 0; p < n - 1; p++) {
      for (let q = p + 1; q < n; q++) {
        const off = a[p][q];
        if (Math.abs(off) <= 1e-17 * Math.sqrt(Math.abs(a[p][p] * a[q][q])) || Math.abs(off) < 1e-300) continue;
        changed = true;
        const [c, s] = rotation(a[p][p], off, a[q][q]);
        for (let k = 0; k < n; k++) [a[k][p], a[k][q]] = [c * a[k][p] - s * a[k][q], s * a[k][p] + c * a[k][q]];
        for (let k = 0; k < n; k++) [a[p][k], a[q][k]] = [c * a[p][k] - s * a[q][k], s * a[p][k] + c * a[q][k]];
        a[p][q] = a[q][p] = 0;
        for (let k = 0; k < n; k++) [v[k][p], v[k][q]] = [c * v[k][p] - s * v[k][q], s * v[k][p] + c * v[k][q]];
      }
    }
    if (!changed) break;
  }
  const order = a.map((_, k) => k).sort((i, j) => a[i][i] - a[j][j]);
  return { values: order.map((k) => a[k][k]), vectors: order.map((k) => v.map((row) => row[k])) };
}

/** Return cosine and sine of the rotation that makes (x, y; y, z) diagonal, the smaller of the two. */
function rotation(x, y, z) {
  const theta = (z - x) / (2 * y);
  const t = (theta < 0 ? -1 : 1) / (Math.abs(theta) + Math.hypot(theta, 1));
  const c = 1 / Math.hypot(t, 1);
  return [c, t * c];
}

/**
 * Return {values, vectors} of the singular values of a tall matrix, descending, and the right singular vectors.
 *
 * Rotations of columns until all are at right angles (Hestenes): small singular values keep their digits, which those
 * from the matrix of squares lose.
 *
 * @param columns of the matrix, each a Float64Array; they are overwritten
 */
export function singularValues(columns) {
  const n = columns.length;
  const v = columns.map((_, i) => Float64Array.from({ length: n }, (_, j) => (i === j ? 1 : 0))); // v[k]: column k
  for (let sweep = 0; sweep < SWEEPS; sweep++) {
    let changed = false;
    for (let p = 0; p < n - 1; p++) {
      for (let q = p + 1; q < n; q++) {
        const [x, y] = [columns[p], columns[q]];
        const [xx, xy, yy] = [dot(x, x), dot(x, y), dot(y, y)];
        if (Math.abs(xy) <= 1e-16 * Math.sqrt(xx * yy) || xy === 0) continue;
        changed = true;
        const [c, s] = rotation(xx, xy, yy);
        turn(x, y, c, s);
        turn(v[p], v[q], c, s);
      }
    }
    if (!changed) break;
  }
  const sizes = columns.map((one) => Math.sqrt(dot(one, one)));
  const order = sizes.map((_, k) => k).sort((i, j) => sizes[j] - sizes[i]);
  return { values: order.map((k) => sizes[k]), vectors: order.map((k) => Array.from(v[k])) };
}

function turn(x, y, c, s) {
  for (let k = 0; k < x.length; k++) {
    const [a, b] = [x[k], y[k]];
    x[k] = c * a - s * b;
    y[k] = s * a + c * b;
  }
}

export function dot(x, y) {
  let sum = 0;
  for (let k = 0; k < x.length; k++) sum += x[k] * y[k];
  return sum;
}

/** Return x with A x = b, by elimination with pivots; null where A is singular. */
export function solve(matrix, right) {
  const n = right.length;
  const rows = matrix.map((row, k) => [...row, right[k]]);
  for (let k = 0; k < n; k++) {
    let best = k;
    for (let i = k + 1; i < n; i++) if (Math.abs(rows[i][k]) > Math.abs(rows[best][k])) best = i;
    [rows[k], rows[best]] = [rows[best], rows[k]];
    if (rows[k][k] === 0 || !Number.isFinite(rows[k][k])) return null;
    for (let i = k + 1; i < n; i++) {
      const part = rows[i][k] / rows[k][k];
      for (let j = k; j <= n; j++) rows[i][j] -= part * rows[k][j];
    }
  }
  const found = new Array(n);
  for (let k = n - 1; k >= 0; k--) {
    let sum = rows[k][n];
    for (let j = k + 1; j < n; j++) sum -= rows[k][j] * found[j];
    found[k] = sum / rows[k][k];
  }
  return found;
}

export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

export const determinant = ([a, b, c]) => dot(a, cross(b, c));
