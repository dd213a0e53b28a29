// The Wigner function of a spin on a grid of the sphere, quickly enough to be drawn as the spin moves.
//
// W(n) = ⟨ψ|U Δ U†|ψ⟩ with U = e^{−iφS_z} e^{−iθS_y} and Δ diagonal. On a circle of latitude that is
// Σ_q e^{iqφ} Σ_m ψ*_m K_{m,m−q}(θ) ψ_{m−q}, K = d Δ dᵀ, and K is made once. Index 0 is m = J, as in Python.

/** Return d^J(θ) = exp(−iθS_y), row by row; each half of spin is one more step, of which none cancels. */
export function rotationMatrix(J, theta) {
  const [c, s] = [Math.cos(0.5 * theta), Math.sin(0.5 * theta)];
  let last = Float64Array.of(1);
  for (let N = 1; N <= 2 * J; N++) {
    const found = new Float64Array((N + 1) * (N + 1));
    for (let i = 0; i <= N; i++) {
      for (let k = 0; k <= N; k++) {
        let sum = 0;
        if (i < N && k < N) sum += c * Math.sqrt((N - i) * (N - k)) * last[i * N + k];
        if (i < N && k > 0) sum -= s * Math.sqrt((N - i) * k) * last[i * N + k - 1];
        if (i > 0 && k < N) sum += s * Math.sqrt(i * (N - k)) * last[(i - 1) * N + k];
        if (i > 0 && k > 0) sum += c * Math.sqrt(i * k) * last[(i - 1) * N + k - 1];
        found[i * (N + 1) + k] = sum / N;
      }
    }
    last = found;
  }
  return last;
}

/** Return K(θ) = d Δ dᵀ by diagonals: those of q = 0, then of q = 1, … */
function kernelAt(J, theta, kernel) {
  const n = 2 * J + 1;
  const d = rotationMatrix(J, theta);
  const weighed = d.map((value, index) => value * kernel[index % n]);
  const found = new Float64Array((n * (n + 1)) / 2);
  let place = 0;
  for (let q = 0; q < n; q++) {
    for (let i = 0; i + q < n; i++) {
      let sum = 0;
      for (let m = 0; m < n; m++) sum += weighed[i * n + m] * d[(i + q) * n + m];
      found[place++] = sum;
    }
  }
  return found;
}

/** Wigner functions on rows of the polar angle (i + ½)π/rows and columns of the azimuth (j + ½)2π/columns. */
export class WignerMap {
  /**
   * @param J of the spin, a whole number
   * @param kernel Δ_m (2J+1), Wigner functions of |m⟩ at the pole
   * @param rows of the grid; there are twice as many columns
   */
  constructor(J, kernel, rows) {
    [this.J, this.rows, this.columns] = [J, rows, 2 * rows];
    const n = 2 * J + 1;
    this.kernels = Array.from({ length: rows }, (_, i) => kernelAt(J, ((i + 0.5) * Math.PI) / rows, kernel));
    const azimuth = (j) => ((j + 0.5) * 2 * Math.PI) / this.columns;
    this.cosines = Array.from({ length: n }, (_, q) => Float64Array.from({ length: this.columns }, (_, j) => Math.cos(q * azimuth(j))));
    this.sines = Array.from({ length: n }, (_, q) => Float64Array.from({ length: this.columns }, (_, j) => Math.sin(q * azimuth(j))));
  }

  /** Return the Wigner function of a state {re, im}, row by row. */
  of({ re, im }) {
    const { rows, columns } = this;
    const n = 2 * this.J + 1;
    const [real, imaginary] = [new Float64Array((n * (n + 1)) / 2), new Float64Array((n * (n + 1)) / 2)];
    let place = 0;
    for (let q = 0; q < n; q++) {
      // ψ*_m ψ_{m−q}, twice for q and −q together
      for (let i = 0; i + q < n; i++, place++) {
        const twice = q ? 2 : 1;
        real[place] = twice * (re[i] * re[i + q] + im[i] * im[i + q]);
        imaginary[place] = twice * (re[i] * im[i + q] - im[i] * re[i + q]);
      }
    }
    const found = new Float32Array(rows * columns);
    const row = new Float64Array(columns);
    for (let r = 0; r < rows; r++) {
      const kernel = this.kernels[r];
      row.fill(0);
      let at = 0;
      for (let q = 0; q < n; q++) {
        let [x, y] = [0, 0];
        for (let i = 0; i + q < n; i++, at++) {
          x += kernel[at] * real[at];
          y += kernel[at] * imaginary[at];
        }
        // e^{iφ(m″ − m′)} of m″ = m′ − q
        const [cosine, sine] = [this.cosines[q], this.sines[q]];
        for (let j = 0; j < columns; j++) row[j] += x * cosine[j] + y * sine[j];
      }
      found.set(row, r * columns);
    }
    return found;
  }
}
