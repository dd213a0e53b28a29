"""Levels from polhodes: uniform quantisation through the separatrix, doublets, and the spacing of levels.

A level is a polhode whose cap holds a whole number of quanta, corrected where the two modes meet and tunnel into each
other. With G = J + ½, action S, barrier θ and ε = −θ/π: S + φ = πK_a ± δ, φ = ε ln|ε| − ε − Im ln Γ(½ + iε), δ =
arctan e^{−πε}. The next order in 1/G corrects S and θ. The part d J(J+1) that all levels of a J share is exact and no
matter of polhodes: the next order takes it out of H and adds it to its energies. Source: Colwell, Handy & Miller, J.
Chem. Phys. 68 (1978) 745; Child, *Semiclassical Mechanics with Molecular Applications*, §3.3; Ford, Hill, Wakano &
Wheeler, Ann. Phys. 7 (1959) 239 for the barrier.
"""

from __future__ import annotations

import math
import warnings
from typing import NamedTuple

import numpy as np
from scipy.optimize import elementwise
from scipy.special import loggamma

from polhode._base.arrays import known_numbers_only, require_doubles
from polhode.errors import InvalidInput, shown
from polhode.spectra._orbits import Three, orbit
from polhode.spectra.rotor import Rotor, check_j, equal_constants
from polhode.types import Array, ArrayLike, Bool, Float64, Integer, Real


class SemiclassicalLimits(NamedTuple):
    """Where the second order holds, and by which formula.

    Attributes:
        min_second_order_j: J from which the second order holds.
        min_room: (B − C) G² or (A − B) G² over A − C: below it order 2 was off by up to .24 (A − C), above by up to
            .02.
        interpolated_share: of the energies from the saddle to the nearer end, within which order 2 is interpolated, as
            its parts diverge.
        series_argument: |ε|/G below which the second order's logarithm is expanded.
    """

    min_second_order_j: int = 5
    min_room: float = 1.0
    interpolated_share: float = 1e-5
    series_argument: float = 0.125


LIMITS = SemiclassicalLimits()


class SemiclassicalLevels(NamedTuple):
    """Levels of one J, by label as those of a rigid rotor ascend; each (2J+1,).

    Attributes:
        Ka, Kc: quantum numbers.
        energy: in the unit of the constants.
        period: of the polhode at this energy, in the inverse unit: next levels of equal symmetry lie 2π/T apart.
    """

    Ka: Integer[Array, "n"]
    Kc: Integer[Array, "n"]
    energy: Float64[Array, "n"]
    period: Float64[Array, "n"]


@known_numbers_only
def semiclassical_levels(constants: Real[ArrayLike, "3"], J: int, order: int = 2) -> SemiclassicalLevels:
    """Return the 2J + 1 levels of an asymmetric rotor by quantised polhodes, ħ = 1.

    Order 1 is the formula as it is published, whose errors are an eighth of the sum of two constants; those of order 2
    fall as 1/J² away from the saddle. Of nearly symmetric rotors, (B − C) J² or (A − B) J² less than A − C, there is no
    room for order 2 near the saddle: a warning says that levels there err by up to a quarter of A − C.

    Args:
        constants: A > B > C, in any unit of energy.
        J: a whole number; order 2 needs J of at least 5.
        order: 1 for the uniform formula, 2 with the next order.

    Raises:
        InvalidInput: for constants of which two are equal, whose levels are known exactly, or an invalid J or
            order.

    >>> levels = semiclassical_levels((27.0, 14.0, 9.0), 10)
    >>> round(float(levels.energy[0]), 4), round(float(Rotor((27.0, 14.0, 9.0)).levels_of(10).energy[0]), 4)
    (1083.7342, 1083.7274)
    """
    checked = _asymmetric(constants)
    J = check_j("J", J)
    if order not in (1, 2) or (order == 2 and J < LIMITS.min_second_order_j):
        raise InvalidInput(
            f"`order` must be 1, or 2 for J of at least {LIMITS.min_second_order_j}; got {shown(order)} at J = {J}. "
            "Take the exact levels of `Rotor` there."
        )
    index = np.arange(2 * J + 1)
    Ka, Kc = (index + 1) // 2, J - index // 2
    energies, period, roomless = quantise(checked, J, order)
    if order == 2:
        _warn_of_no_room(checked, J + 0.5, roomless)
    return SemiclassicalLevels(Ka, Kc, energies, period)


def quantise(
    constants: Three, J: int, order: int
) -> tuple[Float64[Array, "n"], Float64[Array, "n"], int]:
    """Return energies and periods (2J+1,) of levels, and how many have order 1 as order 2 does not apply.

    Args:
        constants: A > B > C.
        J: a whole number.
        order: 1 or 2.
    """
    index = np.arange(2 * J + 1)
    Ka, Kc = (index + 1) // 2, J - index // 2
    # of each pair K_a the lower level has the minus sign
    sign = np.where(Ka + Kc == J, 1.0, -1.0)
    if order == 1:
        energy, _ = _roots(constants, J + 0.5, Ka, sign, 1)
        return energy, orbit(constants, J + 0.5, energy).period, 0
    rest, d = without_casimir(constants)
    energy, roomless = _roots(rest, J + 0.5, Ka, sign, 2)
    return energy + d * J * (J + 1.0), orbit(rest, J + 0.5, energy).period, roomless


def are_above(constants: Three, j_max: int) -> Bool[Array, "levels"]:
    """Return whether levels with J from 1 to ``j_max``, J by J, lie above the saddle of theirs.

    Order 2 where the J has it, else order 1. One search finds the levels of all J, as few take as long as many.

    Args:
        constants: A > B > C, the Casimir's multiple taken out.
        j_max: a whole number.
    """
    numbers = np.arange(1, j_max + 1)
    J = np.repeat(numbers, 2 * numbers + 1)
    index = np.arange(len(J)) - (J * J - 1)  # of the level within its J
    Ka, Kc = (index + 1) // 2, J - index // 2
    sign, G = np.where(Ka + Kc == J, 1.0, -1.0), J + 0.5
    above = np.zeros(len(J), bool)
    for order, own in ((1, J < LIMITS.min_second_order_j), (2, J >= LIMITS.min_second_order_j)):
        if own.any():
            energy, _ = _roots(constants, G[own], Ka[own], sign[own], order)
            above[own] = energy > constants[1] * G[own] * G[own]
    return above


def _warn_of_no_room(constants: Three, G: float, roomless: int) -> None:
    A, B, C = constants
    if roomless or min(A - B, B - C) * G * G < LIMITS.min_room * (A - C):
        warnings.warn(
            f"the rotor A, B, C = {A:.9g}, {B:.9g}, {C:.9g} is so nearly symmetric that order 2 has no room next to "
            f"the saddle of J = {G - 0.5:g}: levels there err by up to {0.25 * (A - C):.3g}. The exact ones are "
            "`Rotor(constants).levels_of(J)`.", stacklevel=4,
        )


def without_casimir(constants: Three) -> tuple[Three, float]:
    """Return A, B, C less d, of which C keeps a thousandth of A − C, and d.

    >>> without_casimir((3.0, 2.0, 1.0))
    ((2.002, 1.002, 0.002), 0.998)
    """
    A, B, C = constants
    rest = 1e-3 * (A - C)
    return (A - C + rest, B - C + rest, rest), C - rest


@known_numbers_only
def semiclassical_pairs(constants: Real[ArrayLike, "3"], s: float, order: int = 2) -> Float64[Array, "pairs"]:
    """Return the s + ½ twofold levels of H = A S_a² + B S_b² + C S_c² for a half-integer spin, ascending.

    Kramers' pairs: S + φ = π(n + ½).

    Args:
        constants: A > B > C.
        s: 1/2, 3/2, …
        order: 1 or 2.

    Raises:
        InvalidInput: for constants of which two are equal, a spin that is not half-integer, or an invalid order.
    """
    checked = _asymmetric(constants)
    if not (s > 0 and 2.0 * s == round(2.0 * s) and round(2.0 * s) % 2 == 1):
        raise InvalidInput(f"`s` must be half an odd number, 1/2, 3/2, …; got {shown(s)}.")
    if order not in (1, 2) or (order == 2 and s < LIMITS.min_second_order_j):
        lowest = LIMITS.min_second_order_j
        raise InvalidInput(f"`order` must be 1, or 2 for s above {lowest}; got {shown(order)} at s = {s:g}.")
    n = np.arange(round(s + 0.5)) + 0.5
    rest, d = without_casimir(checked) if order == 2 else (checked, 0.0)
    energy, roomless = _roots(rest, s + 0.5, n, np.zeros_like(n), order)
    if order == 2:
        _warn_of_no_room(checked, s + 0.5, roomless)
    return energy + d * s * (s + 1.0)


@known_numbers_only
def doublet_splitting(
    constants: Real[ArrayLike, "3"], J: int, energy: Real[ArrayLike, "*batch"]
) -> Float64[Array, "*batch"]:
    """Return the distance (4/T) e^{−|θ+θ2|} of the two levels that tunnelling splits, also far below rounding.

    Exact levels differ by their rounding where the splitting is less than 1e-16 of them; this keeps its digits, to some
    per cent at J = 20 and better above.

    Args:
        constants: A > B > C.
        J: of the levels.
        energy: (…) of the pairs, in the unit of the constants.

    Raises:
        InvalidInput: for constants of which two are equal, or energies outside of those that J has.

    Source: Harter & Patterson, J. Chem. Phys. 80 (1984) 4241.
    """
    checked = _asymmetric(constants)
    G = check_j("J", J) + 0.5
    rest, d = without_casimir(checked)
    values = np.asarray(energy, float) - d * J * (J + 1.0)
    if not ((values > rest[2] * G * G) & (values < rest[0] * G * G)).all():
        low, high = (x * G * G + d * J * (J + 1.0) for x in (rest[2], rest[0]))
        raise InvalidInput(f"`energy` must be one that J has, from {low:.9g} to {high:.9g}; got {shown(energy)}.")
    at = orbit(rest, G, values)
    # the phases of the pair differ by 2δ above the saddle and by π − 2δ below, 2 e^{−|θ|}, over dS/dE = T/2
    return 4.0 / at.period * np.exp(-np.abs(at.barrier + at.barrier_correction))


def phase(
    constants: Three, G: Real[ArrayLike, "*#batch"], energy: Float64[Array, "*batch"], order: int
) -> tuple[Float64[Array, "*batch"], Float64[Array, "*batch"]]:
    """Return S + φ and δ (…) of the quantisation condition."""
    if order == 1:
        at = orbit(constants, G, energy)
        epsilon = -at.barrier / math.pi
        return at.action + _phase_correction(epsilon, 0.0 * epsilon), _tunnelling_phase(epsilon)
    A, B, C = constants
    saddle, width = B * G * G, LIMITS.interpolated_share * min(A - B, B - C) * G * G
    off = (energy - saddle) / width
    near = np.abs(off) < 1.0
    sides = [_second(constants, G, np.where(near, saddle + side * width, energy)) for side in (-1.0, 1.0)]
    share = np.where(near, 0.5 + 0.5 * off, 0.0)
    return tuple((1.0 - share) * one + share * other for one, other in zip(*sides, strict=True))  # type: ignore[return-value]


def _second(constants: Three, G: float | Array, energy: Array) -> tuple[Array, Array]:
    at = orbit(constants, G, energy)
    first, second = -at.barrier / math.pi, -at.barrier_correction / math.pi
    epsilon = first + second
    # c − Im ln Γ of the sum of both orders, whose logarithm is expanded where the first is small
    # Im ln Γ(½ + iε) = ε ln|ε| − ε + 1/(24ε) + …: what Stirling's formula leaves out at first order
    logarithm = np.log(np.abs(first))
    small = first * logarithm - first + second * logarithm + 1.0 / (24.0 * first)
    large = epsilon * np.log(np.abs(epsilon)) - epsilon + 1.0 / (24.0 * epsilon)
    mended = np.where(np.abs(first) < LIMITS.series_argument * G, small, large) - _gamma_phase(epsilon)
    return at.action + at.action_correction + mended, _tunnelling_phase(epsilon)


def _phase_correction(epsilon: Array, at_zero: Array) -> Array:
    """Return φ = ε ln|ε| − ε − Im ln Γ(½ + iε), zero at ε = 0."""
    nonzero = epsilon != 0.0
    safe = np.where(nonzero, epsilon, 1.0)
    return np.where(nonzero, safe * np.log(np.abs(safe)) - safe - _gamma_phase(safe), at_zero)


def _tunnelling_phase(epsilon: Array) -> Array:
    """Return δ = arctan e^{−πε}."""
    with np.errstate(over="ignore"):
        return np.arctan(np.exp(-math.pi * epsilon))


def _gamma_phase(epsilon: Array) -> Array:
    return loggamma(0.5 + 1j * epsilon).imag


def _roots(constants: Three, G: float | Array, quanta: Array, sign: Array, order: int) -> tuple[Array, int]:
    """Return the energies where S + φ − sign δ is π times the quanta (n,), and how many are of order 1 instead of 2.

    |L| = G is that of all levels, or of each (n,).
    """
    A, _, C = constants
    G = np.full(len(quanta), G)
    low, high = C * G * G, A * G * G
    inset_share = 1e-13  # of the range of energies, at whose ends no level is
    inset = inset_share * (high - low)

    def phase_defect(energy: Array, n: Array, sign: Array, G: Array, order: int) -> Array:
        angle, delta = phase(constants, G, energy, order)
        return angle - sign * delta - math.pi * n

    ends = low + inset, high - inset
    first = elementwise.find_root(lambda e, n, s, g: phase_defect(e, n, s, g, 1), ends, args=(quanta, sign, G)).x
    if order == 1:
        return first, 0
    # order 2 lies below order 1, by an eighth of the sum of two constants: the bracket is around that
    spacing = 2.0 * math.pi / orbit(constants, G, first).period
    ends = np.maximum(first - 0.45 * spacing, ends[0]), np.minimum(first + 0.05 * spacing, ends[1])
    second = elementwise.find_root(lambda e, n, s, g: phase_defect(e, n, s, g, 2), ends, args=(quanta, sign, G))
    # nearly symmetric rotors of low J have no room for the expansion next to their saddle
    return np.where(second.success, second.x, first), int((~second.success).sum())


def _asymmetric(constants: Array) -> Three:
    require_doubles(constants=constants)
    A, B, C = Rotor(constants).constants
    if not math.isfinite(A) or equal_constants((A, B, C)):
        raise InvalidInput(
            f"`constants` must be three different ones, A > B > C; got {A:g}, {B:g}, {C:g}. The levels of a symmetric "
            "molecule are known exactly: `Rotor(constants).levels_of(J)`."
        )
    return A, B, C
