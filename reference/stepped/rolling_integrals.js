// The linear integrals of a thin rolling disk: c1, c2 of ω3 = c1 P_ν(cos θ) + c2 P_ν(−cos θ), ν(ν+1) = −κ = −ma²C/[A(C+ma²)].
// Sources: Appell, Rend. Circ. Mat. Palermo 14 (1900) 1; Korteweg, ibid. 14 (1900) 7; NIST DLMF 14.3.1, 15.2.1, 15.8.10.

const TERMS = 64; // of series in x ≤ ½, whose terms fall as xⁿ/n: the rest is below 1e-19 of the sum
const EULER = 0.5772156649015329;

/**
 * P_ν(cos θ) of a degree ν that may be complex, but whose ν(ν+1) = −κ is real.
 *
 * The series of ₂F₁(−ν, ν+1; 1; x), x = (1 − cos θ)/2, has real terms. Beyond x = ½ it is continued in 1 − x, where it has a
 * logarithm and the coefficients near · (2ψ(n+1) − ψ(n−ν) − ψ(n+ν+1)).
 */
export class LegendreFunction {
  constructor(kappa) {
    const pairs = digammaPairs(kappa);
    [this.near, this.far] = [[1], []];
    let whole = -EULER; // ψ(n + 1)
    for (let n = 0; n < TERMS; n++) {
      this.far.push(this.near[n] * (2 * whole - pairs[n]));
      this.near.push((this.near[n] * (n * (n + 1) + kappa)) / (n + 1) ** 2);
      whole += 1 / (n + 1);
    }
    this.near.pop();
    const square = 0.25 - kappa; // of ν + ½, so that sin π(ν+1) = cos π√square
    const root = Math.PI * Math.sqrt(Math.abs(square));
    this.sine = (square < 0 ? Math.cosh(root) : Math.cos(root)) / Math.PI; // sin(π(ν+1))/π
  }

  /** Return [P_ν(cos θ), its derivative by θ] at 0 ≤ θ < π. */
  values(theta) {
    const x = Math.sin(0.5 * theta) ** 2;
    const slope = 0.5 * Math.sin(theta); // dx/dθ = −dy/dθ
    if (x <= 0.5) {
      const [value, change] = series(this.near, x);
      return [value, slope * change];
    }
    const y = Math.cos(0.5 * theta) ** 2;
    const log = Math.log(y);
    const [withLog, changeWithLog] = series(this.near, y);
    const [rest, change] = series(this.far, y);
    return [this.sine * (rest - log * withLog), -slope * this.sine * (change - log * changeWithLog - withLog / y)];
  }
}

/** Return [c1, c2] [rad/s] of a state of a thin disk. */
export function linearIntegrals(legendre, { m, a, C }, theta, w2, w3) {
  const [p, dp] = legendre.values(theta);
  const [q, dq] = legendre.values(Math.PI - theta);
  const slope = (m * a * a * w2) / (C + m * a * a);
  const wronskian = (-2 * legendre.sine) / Math.sin(theta); // p·(dq/dθ) − q·(dp/dθ) with dq/dθ = −q′(π − θ)
  return [(-dq * w3 - q * slope) / wronskian, (p * slope - dp * w3) / wronskian];
}

/**
 * Return ψ(n−ν) + ψ(n+ν+1) for n = 0, 1, … as real numbers.
 *
 * With ν = −½ + σ they are ψ(n+½−σ) + ψ(n+½+σ), σ² = ¼ − κ. Far out ψ(½+z) = ln z + 1/24z² − 7/960z⁴ + 31/8064z⁶ − …; from there
 * down by ψ(1+z) = ψ(z) + 1/z.
 */
function digammaPairs(kappa) {
  const square = 0.25 - kappa; // σ²
  const pairs = new Array(TERMS + 1);
  const z = TERMS; // of (z ± σ)²: real part and, if σ is imaginary, imaginary part
  const [real, imaginary] = square >= 0 ? [Math.sqrt(square), 0] : [0, Math.sqrt(-square)];
  pairs[TERMS] = [1, -1].reduce((sum, side) => {
    const [size, angle] = [Math.hypot(z + side * real, imaginary), Math.atan2(side * imaginary, z + side * real)];
    const power = (k) => Math.cos(k * angle) / size ** k; // Re z⁻ᵏ
    return sum + Math.log(size) + power(2) / 24 - (7 * power(4)) / 960 + (31 * power(6)) / 8064 - (127 * power(8)) / 30720;
  }, 0);
  for (let n = TERMS - 1; n >= 0; n--) pairs[n] = pairs[n + 1] - (2 * n + 1) / (n * (n + 1) + kappa);
  return pairs;
}

/** Return a power series and its derivative. */
function series(coefficients, x) {
  let [value, slope] = [0, 0];
  for (let n = coefficients.length - 1; n >= 0; n--) {
    slope = value + x * slope;
    value = coefficients[n] + x * value;
  }
  return [value, slope];
}
