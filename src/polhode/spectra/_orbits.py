"""The classical motion at a rotor's energies: areas of polhodes, periods, and the barrier between the two modes.

H = A J_a² + B J_b² + C J_c² is the free body with moments 1/2A, 1/2B, 1/2C, |L| = G. Below E = BG² polhodes go round
the c axis, above round the a axis. Solid angles and the barrier are complete integrals of the third kind, written by
Jacobi's zeta function. Source: Colwell, Handy & Miller, J. Chem. Phys. 68 (1978) 745; Harter & Patterson, J. Chem.
Phys. 80 (1984) 4241; Whittaker, *Analytical Dynamics*, §69, for the motion.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from polhode.special.carlson import carlson_rd, carlson_rf
from polhode.types import Array, ArrayLike, Float64, Real

Number = Float64[Array, "*batch"]
Three = tuple[float, float, float]


class Orbit(NamedTuple):
    """A polhode's numbers, ħ = 1; each (…).

    Attributes:
        action: S, from 0 at the lowest energy to πG at the highest: half of G times the solid angle of the cap about c,
            or of a hemisphere less the cap about a.
        barrier: θ, positive below the saddle: the action through the forbidden region.
        period: T of L along the body's axes; dS/dE = T/2.
        barrier_period: T', dθ/dE = −T'/2.
        action_correction: S2, of the next order in 1/G.
        barrier_correction: θ2.
    """

    action: Number
    barrier: Number
    period: Number
    barrier_period: Number
    action_correction: Number
    barrier_correction: Number


def orbit(constants: Three, G: Real[ArrayLike, "*#batch"], energy: Number) -> Orbit:
    """Return the numbers of polhodes at energies strictly between C G² and A G².

    At B G², where the period is infinite, they are those of the nearest polhode that doubles can tell from the
    separatrix.

    Args:
        constants: A > B > C.
        G: |L|, of all or of each.
        energy: (…).
    """
    A, B, C = constants
    below = energy < B * G * G
    first, second, whole = 2.0 * (A - B), 2.0 * (B - C), 2.0 * (A - C)
    # P + Q = 2(A − C) G², so that sine² + cosine² = 1 below
    P, Q, S = 2.0 * (energy - C * G * G), 2.0 * (A * G * G - energy), 2.0 * np.abs(energy - B * G * G)
    S = np.maximum(S, np.finfo(float).eps * whole * G * G)
    # above the saddle the axes a and c change places
    p, q = np.where(below, P, Q), np.where(below, Q, P)
    a, b = np.where(below, first, second), np.where(below, second, first)
    m, m1 = a * p / (b * q), whole * S / (b * q)
    rate = np.sqrt(b * q)
    sine, cosine, delta = np.sqrt(q / whole) / G, np.sqrt(p / whole) / G, np.sqrt(p / b) / G
    # K, K' and D = (K − E)/m of both moduli: sums of positive terms
    K, D, other_K, other_D = *_complete(m1), *_complete(m)
    # F and (F − E)/m1 of the angle φ with these sin φ, cos φ and Δ, of parameter m1; Jacobi's Z = E − F E′/K′
    F = sine * carlson_rf(cosine * cosine, delta * delta, 1.0)
    own = sine**3 * carlson_rd(cosine * cosine, delta * delta, 1.0) / 3.0
    zeta = m1 * (F * other_D / other_K - own)
    # the cap's solid angle is 2π(1 − Λ₀), with Heuman's Λ₀ = F/K′ + (2/π) K Z, a complete integral of the third kind
    cap = 2.0 * math.pi * (other_K - F) / other_K - 4.0 * K * zeta
    sign = np.where(below, 1.0, -1.0)
    # m = ap/(bq) with dp/dE = −dq/dE = ±2
    change = sign * 2.0 * whole * G * G * a / (b * q * q)  # of m by E
    slope = -sign * b / rate
    period, other = 4.0 * K / rate, 4.0 * other_K / rate
    # dK/dm = (K − D)/(2m1) and dK′/dm = −(K′ − D′)/(2m), with D = (K − E)/m (DLMF 19.4.1)
    by_energy = 2.0 * (K - D) / m1 * change / rate - period * slope / rate
    other_by_energy = -2.0 * (other_K - other_D) / m * change / rate - other * slope / rate
    u = energy / (G * G)
    # next order: S2 = [(2(A+B+C) − 3u) T − 2G² f′(u) dT/dE]/24 with f = (u−A)(u−B)(u−C), u = E/G²; θ2 likewise from −T′
    of_value = 2.0 * (A + B + C) - 3.0 * u
    of_slope = -2.0 * G * G * ((u - B) * (u - C) + (u - A) * (u - C) + (u - A) * (u - B))
    return Orbit(
        0.5 * G * np.where(below, cap, 2.0 * math.pi - cap),
        sign * 2.0 * G * other_K * zeta, period, other,
        (of_value * period + of_slope * by_energy) / 24.0, -(of_value * other + of_slope * other_by_energy) / 24.0,
    )


def _complete(complement: Number) -> tuple[Number, Number]:
    """Return K and D = (K − E)/m, from 1 − m."""
    return carlson_rf(0.0, complement, 1.0), carlson_rd(0.0, complement, 1.0) / 3.0
