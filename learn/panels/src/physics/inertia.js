// From mass points to the inertia tensor about their centre and to its principal axes.
const square = (x) => x * x;

/** Return {mass [kg], centre [m]} of points [x, y, z] [m] with masses [kg]. */
export function centreOf(masses, points) {
  const mass = masses.reduce((all, m) => all + m, 0);
  return { mass, centre: [0, 1, 2].map((k) => points.reduce((all, p, n) => all + masses[n] * p[k], 0) / mass) };
}

/** Return J = Σ m (r² 1 − r rᵀ) about the centre of mass [kg m²], as rows. */
export function tensorOf(masses, points) {
  const { centre } = centreOf(masses, points);
  const J = [[0, 0, 0], [0, 0, 0], [0, 0, 0]]; // prettier-ignore
  points.forEach((p, n) => {
    const r = p.map((x, k) => x - centre[k]);
    const all = square(r[0]) + square(r[1]) + square(r[2]);
    for (let i = 0; i < 3; i++) for (let j = 0; j < 3; j++) J[i][j] += masses[n] * ((i === j ? all : 0) - r[i] * r[j]);
  });
  return J;
}

/** Return the eigenvalues of a symmetric matrix in ascending order and its unit eigenvectors, by Jacobi's rotations. */
export function eigen(matrix) {
  const n = matrix.length;
  const A = matrix.map((row) => [...row]);
  const V = A.map((_, i) => A.map((__, j) => (i === j ? 1 : 0)));
  for (let sweep = 0; sweep < 60; sweep++) {
    let off = 0;
    for (let i = 0; i < n; i++) for (let j = i + 1; j < n; j++) off += Math.abs(A[i][j]);
    if (off === 0) break;
    for (let p = 0; p < n; p++) for (let q = p + 1; q < n; q++) rotateAway(A, V, p, q, sweep > 3);
  }
  const order = A.map((_, k) => k).sort((a, b) => A[a][a] - A[b][b]);
  return { values: order.map((k) => A[k][k]), vectors: order.map((k) => V.map((row) => row[k])) };
}

/** Turn the plane of two axes so that the entry between them vanishes: Golub & Van Loan, section 8.5. */
function rotateAway(A, V, p, q, late) {
  const entry = A[p][q];
  if (entry === 0) return;
  if (late && Math.abs(A[p][p]) + Math.abs(entry) === Math.abs(A[p][p]) && Math.abs(A[q][q]) + Math.abs(entry) === Math.abs(A[q][q])) {
    A[p][q] = A[q][p] = 0;
    return;
  }
  const theta = (A[q][q] - A[p][p]) / (2 * entry);
  const t = (theta < 0 ? -1 : 1) / (Math.abs(theta) + Math.sqrt(theta * theta + 1));
  const c = 1 / Math.sqrt(t * t + 1);
  const s = t * c;
  for (let k = 0; k < A.length; k++) {
    const [a, b] = [A[k][p], A[k][q]];
    A[k][p] = c * a - s * b;
    A[k][q] = s * a + c * b;
  }
  for (let k = 0; k < A.length; k++) {
    const [a, b] = [A[p][k], A[q][k]];
    A[p][k] = c * a - s * b;
    A[q][k] = s * a + c * b;
  }
  A[p][q] = A[q][p] = 0;
  for (const row of V) [row[p], row[q]] = [c * row[p] - s * row[q], s * row[p] + c * row[q]];
}

/** Return {mass, centre, tensor, moments, axes} of points; axes are right-handed. */
export function bodyOf(masses, points) {
  const tensor = tensorOf(masses, points);
  const { values, vectors } = eigen(tensor);
  const [a, b, c] = vectors;
  const turned = a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  return { ...centreOf(masses, points), tensor, moments: values, axes: turned < 0 ? [a, b, c.map((x) => -x)] : vectors };
}

/** Return the half-axes [m] of the homogeneous ellipsoid with this mass and these moments; 0 where a flat body has none. */
export function equalEllipsoid(mass, [a, b, c]) {
  return [b + c - a, a + c - b, a + b - c].map((x) => Math.sqrt(Math.max(0, (5 * x) / (2 * mass))));
}
