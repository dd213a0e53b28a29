// The heavy tops with a third integral: Euler's, Lagrange's, Kovalevskaya's and Goryachev and Chaplygin's.
// Sources: Audin, Spinning Tops, ch. I and VI; Bolsinov & Fomenko, Integrable Hamiltonian Systems, ch. 14.
import { dot } from "./turning.js";

const EQUAL = 1e-12; // relative: moments about a point are sums with rounding
const ON_LEAF = 1e-12; // of |Π| |Γ|: Π·Γ below it is zero but for rounding

/**
 * Return [name, function of (Π, Γ)] of the integral of a top beside energy and vertical momentum, or null if it has none.
 *
 * Whether a motion has Π·Γ = 0, on which Goryachev and Chaplygin's holds alone, is decided at its start: elsewhere it is NaN.
 *
 * With k the axis of symmetry, I3 its moment, μ = mgl/I3, and χ across it: Euler |Π|²; Lagrange Π·χ; Kovalevskaya
 * |(Ω1 + iΩ2)² − μ (γ1 + iγ2)(χ1 + iχ2)|²; Goryachev–Chaplygin Ω3 (Ω1² + Ω2²) − μ (Ω·χ) γ3.
 */
export function thirdIntegral(moments, mgl, axis, start) {
  if (mgl === 0) return ["Euler's |Π|²", (momentum) => dot(momentum, momentum)];
  if (alongSymmetry(moments, axis)) return ["Lagrange's Π·χ", (momentum) => dot(momentum, axis)];
  for (let k = 0; k < 3; k++) {
    const [i, j] = others(k);
    if (!same(moments[i], moments[j]) || Math.abs(axis[k]) > EQUAL) continue;
    const parts = { moments, axis, i, j, k, strength: mgl / moments[k] };
    if (Math.abs(moments[i] / 2 - moments[k]) <= EQUAL * moments[k]) return ["Kovalevskaya's integral", kovalevskaya(parts)];
    if (Math.abs(moments[i] / 4 - moments[k]) <= EQUAL * moments[k]) {
      return ["Goryachev and Chaplygin's integral", onLeaf(...start) ? goryachevChaplygin(parts) : () => NaN];
    }
  }
  return null;
}

const others = (k) => [(k + 1) % 3, (k + 2) % 3];
const same = (a, b) => Math.abs(a - b) <= EQUAL * a;

/** Whether a direction lies along an axis of symmetry: any direction does if all moments are equal. */
function alongSymmetry(moments, axis) {
  const largest = Math.max(...moments);
  if (largest - Math.min(...moments) <= EQUAL * largest) return true;
  return [0, 1, 2].some((k) => {
    const [i, j] = others(k);
    return same(moments[i], moments[j]) && Math.abs(axis[i]) + Math.abs(axis[j]) <= EQUAL;
  });
}

const onLeaf = (momentum, up) => Math.abs(dot(momentum, up)) <= ON_LEAF * Math.hypot(...momentum) * Math.hypot(...up);

function kovalevskaya({ moments, axis, i, j, strength }) {
  return (momentum, up) => {
    const [p, q] = [momentum[i] / moments[i], momentum[j] / moments[j]];
    const real = p * p - q * q - strength * (up[i] * axis[i] - up[j] * axis[j]);
    const imaginary = 2 * p * q - strength * (up[i] * axis[j] + up[j] * axis[i]);
    return real * real + imaginary * imaginary;
  };
}

function goryachevChaplygin({ moments, axis, i, j, k, strength }) {
  return (momentum, up) => {
    const velocity = momentum.map((x, n) => x / moments[n]);
    return velocity[k] * (velocity[i] ** 2 + velocity[j] ** 2) - strength * dot(velocity, axis) * up[k];
  };
}
