// A quantum rotor of one J: states of its spin, whose x, y, z are c, a, b, and what is expected of L in them.
import { unpacked } from "../motion.js";

const TURN = 2 * Math.PI;

/** The levels of one J, and states made of them. */
export class Spin {
  /**
   * @param J a whole number
   * @param energies E/h [Hz] of the levels
   * @param vectors {kind, shape, data} of the levels' states, by columns, from m = J down
   * @param kernel Wigner functions of |m⟩ at the pole
   */
  constructor({ J, energies, vectors, kernel }) {
    this.J = J;
    this.size = 2 * J + 1;
    this.energies = energies;
    this.middle = energies.reduce((sum, value) => sum + value, 0) / this.size;
    this.vectors = unpacked(vectors);
    this.kernel = kernel;
  }

  /** Return the state of a level. */
  level(k) {
    return { re: Float64Array.from({ length: this.size }, (_, i) => this.vectors[i * this.size + k]), im: new Float64Array(this.size) };
  }

  /** Return the coherent state about a direction along a, b, c. */
  coherent([a, b, c]) {
    const { J, size } = this;
    const [theta, phi] = [Math.atan2(Math.hypot(a, c), b), Math.atan2(a, c)];
    const [cosine, sine] = [Math.log(Math.cos(0.5 * theta)), Math.log(Math.sin(0.5 * theta))];
    const [re, im] = [new Float64Array(size), new Float64Array(size)];
    let choose = 0; // ln of the binomial coefficient
    for (let i = 0; i < size; i++) {
      const [up, m] = [2 * J - i, J - i];
      const log = 0.5 * choose + (up ? up * cosine : 0) + (i ? i * sine : 0);
      re[i] = Math.exp(log) * Math.cos(m * phi);
      im[i] = -Math.exp(log) * Math.sin(m * phi);
      choose += Math.log((2 * J - i) / (i + 1));
    }
    return { re, im };
  }

  /** Return the parts of a state along the levels. */
  parts({ re, im }) {
    const { size, vectors } = this;
    const [x, y] = [new Float64Array(size), new Float64Array(size)];
    for (let i = 0; i < size; i++) {
      for (let k = 0; k < size; k++) {
        x[k] += vectors[i * size + k] * re[i];
        y[k] += vectors[i * size + k] * im[i];
      }
    }
    return { x, y };
  }

  /**
   * Return the state at a time, from its parts along the levels.
   *
   * Components of L along the body obey the minus bracket and those of a spin the plus bracket, so the spin's time counts
   * back.
   */
  at({ x, y }, time) {
    const { size, vectors } = this;
    const [re, im] = [new Float64Array(size), new Float64Array(size)];
    for (let k = 0; k < size; k++) {
      if (x[k] === 0 && y[k] === 0) continue;
      const turns = (this.energies[k] - this.middle) * time;
      const angle = TURN * (turns - Math.round(turns));
      const [cosine, sine] = [Math.cos(angle), Math.sin(angle)];
      const [u, v] = [cosine * x[k] - sine * y[k], sine * x[k] + cosine * y[k]];
      for (let i = 0; i < size; i++) {
        re[i] += vectors[i * size + k] * u;
        im[i] += vectors[i * size + k] * v;
      }
    }
    return { re, im };
  }

  /** Return ⟨L⟩/J along a, b, c. */
  mean({ re, im }) {
    const { J, size } = this;
    let [a, b, c] = [0, 0, 0];
    for (let i = 0; i < size; i++) {
      b += (J - i) * (re[i] * re[i] + im[i] * im[i]);
      if (i + 1 === size) continue;
      // ⟨S_+⟩ = Σ √((J−m)(J+m+1)) ψ*_{m+1} ψ_m with m + 1 = J − i
      const raised = Math.sqrt((i + 1) * (2 * J - i));
      c += raised * (re[i] * re[i + 1] + im[i] * im[i + 1]);
      a += raised * (re[i] * im[i + 1] - im[i] * re[i + 1]);
    }
    return [a / J, b / J, c / J];
  }
}
