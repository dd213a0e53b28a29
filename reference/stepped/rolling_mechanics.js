// Newton's and Euler's laws for a disk that rolls on a plane, in the frame of its contact.
//
// e1 is horizontal, e2 leads up the face from the contact, e3 is the disk's axis; s, c stand for sin θ, cos θ. With the moments
// A, C about the centre, half the thickness b and M = [[A+mb², −mab], [−mab, C+ma²]]:
//
//   (A+ma²+mb²) θ̈ = (A+mb²) ω2² c/s + mab ω2² − (C+ma²) ω2ω3 − mab ω2ω3 c/s − mg(ac − bs),
//   M (ω2, ω3)˙ = θ̇ (Cω3 − (A+mb²) ω2 c/s − mab ω2, ma² ω2 + mab ω2 c/s) + (τ2, τ3).
//
// Sources: Routh, Advanced Rigid Dynamics (1905), section 244; Le Saux, Leine & Glocker, J. Nonlinear Sci. 15 (2005) 27.

export class RollingMechanics {
  /** Mass m, radius a, half the thickness b, moments A about a diameter through the centre and C, gravity g; SI units. */
  constructor({ m, a, b, A, C, g }) {
    Object.assign(this, { m, a, b, A, C, g });
  }

  /** Return θ̈ [rad/s²], on which neither θ̇ nor the couples act. */
  tiltAcceleration(theta, w2, w3) {
    const { m, a, b, A, C, g } = this;
    const [s, c] = [Math.sin(theta), Math.cos(theta)];
    const inner = ((A + m * b * b) * w2 * w2 * c) / s + m * a * b * w2 * (w2 - (w3 * c) / s) - (C + m * a * a) * w2 * w3;
    return (inner - m * g * (a * c - b * s)) / (A + m * a * a + m * b * b);
  }

  /** Return the derivatives of θ̈ by θ, ω2 and ω3. */
  tiltDerivatives(theta, w2, w3) {
    const { m, a, b, A, C, g } = this;
    const [s, c] = [Math.sin(theta), Math.cos(theta)];
    const [p, q, r] = [A + m * b * b, C + m * a * a, m * a * b];
    const total = A + m * a * a + m * b * b;
    const byTheta = (r * w2 * w3 - p * w2 * w2) / (s * s) + m * g * (a * s + b * c);
    const byW2 = (2 * p * w2 * c) / s + 2 * r * w2 - (r * w3 * c) / s - q * w3;
    const byW3 = (-r * w2 * c) / s - q * w2;
    return [byTheta / total, byW2 / total, byW3 / total];
  }

  /** Return d(ω2, ω3)/dθ without couples. */
  transport(theta, w2, w3) {
    const { m, a, b, A, C } = this;
    const cot = Math.cos(theta) / Math.sin(theta);
    return this.accelerations(C * w3 - (A + m * b * b) * w2 * cot - m * a * b * w2, m * a * (a + b * cot) * w2);
  }

  /** Return M⁻¹τ, what couples along e2 and e3 do to ω2 and ω3. */
  accelerations(tau2, tau3) {
    const { m, a, b, A, C } = this;
    const [p, q, r] = [A + m * b * b, C + m * a * a, m * a * b];
    const det = A * C + m * a * a * A + m * b * b * C; // pq − r² without cancellation
    return [(q * tau2 + r * tau3) / det, (r * tau2 + p * tau3) / det];
  }

  /** Return kinetic and potential energy [J], above that of the disk lying flat. */
  energy(theta, w1, w2, w3) {
    const { m, a, b, A, C, g } = this;
    const speed = (b * w2 - a * w3) ** 2 + (a * a + b * b) * w1 * w1;
    const height = a * Math.sin(theta) - 2 * b * Math.sin(0.5 * theta) ** 2;
    return 0.5 * (A * (w1 * w1 + w2 * w2) + C * w3 * w3 + m * speed) + m * g * height;
  }

  /** Return N = m [g + (ac − bs) θ̈ − (as + bc) θ̇²] [N], with which the plane pushes. */
  normalForce(theta, w1, w2, w3) {
    const { m, a, b, g } = this;
    const [s, c] = [Math.sin(theta), Math.cos(theta)];
    return m * (g + (a * c - b * s) * this.tiltAcceleration(theta, w2, w3) - (a * s + b * c) * w1 * w1);
  }
}
