// Classical bodies that start spread as a coherent state is, each by Jacobi's functions; nine digits are plenty for a picture.
const TURN = 2 * Math.PI;
const GOLDEN = 0.5 * (Math.sqrt(5) - 1);
const NEAREST = 1 - 1e-15; // the separatrix itself is not closed
const CONVERGED = 1e-12;

/** Return sn, cn and dn by descending Landen transformations. Source: DLMF 22.20(ii). */
export function jacobi(u, m) {
  let [a, b] = [1, Math.sqrt(1 - m)];
  const ratios = [];
  while (a - b > CONVERGED * a) {
    const [mean, half] = [0.5 * (a + b), 0.5 * (a - b)];
    b = Math.sqrt(a * b);
    a = mean;
    ratios.push(half / mean);
  }
  let angle = 2 ** ratios.length * a * u;
  for (const ratio of ratios.reverse()) angle = 0.5 * (angle + Math.asin(ratio * Math.sin(angle)));
  const sn = Math.sin(angle);
  return [sn, Math.cos(angle), Math.sqrt(1 - m * sn * sn)];
}

/** Return F(φ|m) by descending Landen transformations. Source: DLMF 19.8(ii). */
export function firstKind(angle, m) {
  let [a, b, phi, power] = [1, Math.sqrt(1 - m), angle, 1];
  while (a - b > CONVERGED * a) {
    const turns = Math.round(phi / Math.PI) * Math.PI; // of which the tangent knows nothing
    phi += Math.atan((b / a) * Math.tan(phi - turns)) + turns;
    [a, b, power] = [0.5 * (a + b), Math.sqrt(a * b), 2 * power];
  }
  return phi / (power * a);
}

/** The direction of L of one body along a, b, c as a function of time. */
export class Member {
  /**
   * @param constants A ≥ B ≥ C as E/h [Hz]
   * @param size of L [ħ]
   * @param unit direction of L at time zero
   */
  constructor([A, B, C], size, unit) {
    const [a, b, c] = unit;
    this.unit = unit;
    this.aboveSaddle = (A - B) * a * a > (B - C) * c * c;
    // distances of the energy from both ends, as sums of terms of one sign
    const fromC = (A - C) * a * a + (B - C) * b * b;
    const fromA = (A - B) * b * b + (A - C) * c * c;
    if (!(fromA > 0) || !(fromC > 0)) {
      this.rate = 0; // on the a or c axis, where L rests
      return;
    }
    const [near, far] = this.aboveSaddle ? [fromC, fromA] : [fromA, fromC];
    const [inner, outer] = this.aboveSaddle ? [A - B, B - C] : [B - C, A - B];
    this.m = Math.min(NEAREST, (outer * far) / (inner * near));
    this.rate = 2 * TURN * size * Math.sqrt(inner * near);
    const along = this.aboveSaddle ? a : c;
    this.sign = along < 0 ? -1 : 1;
    this.long = this.sign * Math.sqrt(near / (A - C));
    this.middle = this.sign * Math.sqrt(far / inner);
    this.short = Math.sqrt(far / (A - C));
    this.phase = firstKind(Math.atan2(b / this.middle, (this.aboveSaddle ? c : a) / this.short), this.m);
  }

  at(time) {
    if (!this.rate) return this.unit;
    const [sn, cn, dn] = jacobi(this.rate * time + this.phase, this.m);
    const [long, middle, short] = [this.long * dn, this.middle * sn, this.short * cn];
    return this.aboveSaddle ? [long, middle, short] : [short, middle, long];
  }
}

/** Return bodies spread as the coherent state of a spin J about a direction: a spiral, of density ((1 + cos θ)/2)^{4J}. */
export function cloudAbout(constants, J, direction, count) {
  const first = Math.abs(direction[0]) < 0.6 ? [1, 0, 0] : [0, 0, 1];
  const across = unitOf(cross(direction, first));
  const third = cross(direction, across);
  return Array.from({ length: count }, (_, k) => {
    const share = ((k + 0.5) / count) ** (1 / (4 * J + 1));
    const polar = 2 * Math.asin(Math.sqrt(1 - share));
    const around = TURN * ((k * GOLDEN) % 1);
    const [x, y, z] = [Math.sin(polar) * Math.cos(around), Math.sin(polar) * Math.sin(around), Math.cos(polar)];
    return new Member(constants, J + 0.5, unitOf(direction.map((value, j) => x * across[j] + y * third[j] + z * value)));
  });
}

export const cross = (u, v) => [0, 1, 2].map((k) => u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3]);
export const unitOf = (v) => v.map((value) => value / Math.hypot(...v));
