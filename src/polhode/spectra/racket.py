"""The tennis racket as a quantum body: a flip about the middle axis, its collapse and its revivals.

A coherent state points along the middle axis b, or somewhat beside it. Classical L exactly on b stays there for ever;
the quantum state has a width, and turns over after a time that grows as ln J. With z = b the Hamiltonian joins K and
K ± 2 only: K = J, J − 2, … and K = J − 1, J − 3, … are two tridiagonal chains, and any time takes one
diagonalisation. Source: Harter & Patterson, J. Chem. Phys. 80 (1984) 4241, for levels at the saddle; Robinett, Phys.
Rep. 392 (2004) 1, for revivals.
"""

from __future__ import annotations

import math
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from scipy.linalg import eigh_tridiagonal
from scipy.optimize import brentq, minimize_scalar

from polhode._base import check
from polhode._base.arrays import known_numbers_only, require_doubles
from polhode.errors import InvalidInput
from polhode.exact.free_body import FreeMotion
from polhode.spectra._operators import Representation, matrix_elements, rigid_terms
from polhode.spectra._orbits import orbit
from polhode.spectra.rotor import Rotor, equal_constants
from polhode.spectra.spin import coherent_state
from polhode.types import Array, ArrayLike, Complex128, Float64, Real

MIDDLE_IS_Z = Representation.IIr  # x, y, z = c, a, b
SIDES = ("a", "c")


class RacketLimits(NamedTuple):
    """Limits of a racket flip.

    Attributes:
        max_j: of a flip; chains of this one take some seconds.
    """

    max_j: int = 4000


LIMITS = RacketLimits()
STEEPEST = math.radians(85.0)  # on another axis L rests, without a period
GOLDEN = 0.5 * (math.sqrt(5.0) - 1.0)


class Chain(NamedTuple):
    """The part of a state in K = J, J − 2, … or in K = J − 1, J − 3, …, (n,).

    Attributes:
        K: (n,).
        energy: (n,) E/h [Hz], less a constant common to both parts.
        vectors: (n, n) states by columns.
        weights: (n,) of these in the state at the start.
    """

    K: Float64[Array, "n"]
    energy: Float64[Array, "n"]
    vectors: Float64[Array, "n n"]
    weights: Complex128[Array, "n"]


class Reversal(NamedTuple):
    """The first reversal of a quantum body, ().

    Attributes:
        time: [s].
        along: ⟨L_b⟩/J there.
    """

    time: float
    along: float


class Racket:
    """A quantum body that starts with L about its middle axis b, and the classical ones to compare it with.

    Args:
        constants: A > B > C, as E/h [Hz].
        J: of its levels, from 1 to 4,000.
        tilt: of L from b [rad], from 0 to 85°.
        towards: "a" or "c".

    Attributes:
        rate: at which a classical body leaves the b axis [1/s], 4π(J + ½)√((A − B)(B − C)).

    Raises:
        InvalidInput: for constants of which two are equal, or values outside of these.

    >>> racket = Racket((27.0, 14.0, 9.0), 25)
    >>> racket.quantum(np.array([0.0, 2.24849012, 5.545]) / racket.rate).round(3).tolist()
    [1.0, 0.5, -0.793]
    """

    @known_numbers_only
    def __init__(self, constants: Real[ArrayLike, "3"], J: int, tilt: float = 0.0, towards: str = "a") -> None:
        require_doubles(constants=constants)
        A, B, C = Rotor(constants).constants
        if not (math.isfinite(A) and C > 0.0) or equal_constants((A, B, C)):
            raise InvalidInput(
                f"`constants` must be three different ones, A > B > C > 0; got {A:g}, {B:g}, {C:g}. A symmetric body "
                "has no middle axis."
            )
        self.constants, self.J = (A, B, C), check.whole("J", J, 1, LIMITS.max_j)
        self.tilt = check.number("tilt", tilt, "rad", least=0, most=STEEPEST, rule=f"from 0 to {STEEPEST:.4f}, 85°,")
        self.towards = check.one_of("towards", towards, SIDES)
        self._G = self.J + 0.5
        # L̇ = L × Ω about the middle axis: growth at |L| √((1/I_a − 1/I_b)(1/I_b − 1/I_c)), with 1/I = 4πA, … and
        # |L| = G
        self.rate = 4.0 * math.pi * self._G * math.sqrt((A - B) * (B - C))

    @property
    def direction(self) -> Float64[Array, "3"]:
        """Of L at the start, along a, b, c."""
        side = math.sin(self.tilt)
        a, c = (side, 0.0) if self.towards == "a" else (0.0, side)
        return np.array([a, math.cos(self.tilt), c])

    @cached_property
    def period(self) -> float:
        """Of classical L from this start, round its polhode [s]; infinite on the b axis."""
        if self._on_saddle:
            return math.inf
        return float(orbit(self.constants, self._G, np.array(self._energy)).period) / (2.0 * math.pi)

    @cached_property
    def revival_time(self) -> float | None:
        """T_rev = 2/|d²ν/dn²| [s], ν = E/h over the quanta n of one ladder; None on the b axis, where levels bunch.

        After it the waves that make up the state are in phase again, as far as levels are a parabola in n.
        """
        if self._on_saddle:
            return None
        A, _, C = self.constants
        share = 1e-5  # of the range of energies, over which the slope of a period is computed
        step = share * (A - C) * self._G**2
        low, high = orbit(self.constants, self._G, self._energy + np.array([-step, step])).period
        slope, period = (high - low) / (2.0 * step), 0.5 * (high + low)
        # dE/dn = 2π/T, so that d²E/dn² = −4π² (dT/dE)/T³, with ħ = 1 and energies in Hz
        return 2.0 / float(abs(4.0 * math.pi**2 * slope / period**3))

    @known_numbers_only
    def quantum(self, times: Real[ArrayLike, "time"]) -> Float64[Array, "time"]:
        """Return ⟨L_b⟩/J (T,) of the coherent state.

        Args:
            times: (T,) [s] from the start.

        Raises:
            InvalidInput: for times that are not finite.
        """
        t = _check_times(times)
        mean = np.zeros(len(t))
        for chain in self._chains:
            # phases as parts of a turn, since energies in Hz may be large
            phases = np.exp(-2j * math.pi * np.remainder(np.multiply.outer(t, chain.energy), 1.0))
            mean += np.abs((phases * chain.weights) @ chain.vectors.T) ** 2 @ chain.K
        return mean / self.J

    @known_numbers_only
    def states(self, times: Real[ArrayLike, "time"]) -> Complex128[Array, "time n"]:
        """Return the state (T, 2J+1), as a spin whose x, y, z are c, a, b and whose symbols move as classical L does.

        The components of L along the body obey the minus bracket, those of a spin the plus bracket: an H of squares
        turns the spin the other way round, so that the spin's time counts back here.

        Args:
            times: (T,) [s] from the start.

        Raises:
            InvalidInput: for times that are not finite.
        """
        t = _check_times(times)
        states = np.zeros((len(t), 2 * self.J + 1), complex)
        for chain in self._chains:
            phases = np.exp(2j * math.pi * np.remainder(np.multiply.outer(t, chain.energy), 1.0))
            states[:, np.round(self.J - chain.K).astype(int)] = (phases * chain.weights) @ chain.vectors.T
        return states

    @cached_property
    def half_time(self) -> float | None:
        """When ⟨L_b⟩ has fallen to J/2 for the first time [s]; None where it starts below, or turns back before."""
        times = self._scanned
        below = np.flatnonzero(self.quantum(times) < 0.5)
        if not len(below) or below[0] == 0:
            return None
        low, high = times[below[0] - 1], times[below[0]]
        return float(brentq(lambda time: self._at(time) - 0.5, low, high, xtol=1e-14 * high))  # type: ignore[arg-type]

    @cached_property
    def first_reversal(self) -> Reversal | None:
        """The first minimum of ⟨L_b⟩; None where there is none in a classical period and the time of the flip."""
        times = self._scanned
        along = self.quantum(times)
        turns = np.flatnonzero((along[1:-1] < along[:-2]) & (along[1:-1] <= along[2:])) + 1
        if not len(turns):
            return None
        ends = (times[turns[0] - 1], times[turns[0] + 1])
        minimum: Any = minimize_scalar(self._at, bounds=ends, method="bounded", options={"xatol": 1e-9 * ends[1]})
        return Reversal(float(minimum.x), float(minimum.fun))

    def _at(self, time: float) -> float:
        return float(self.quantum(np.array([time]))[0])

    @cached_property
    def _scanned(self) -> Float64[Array, "time"]:
        """Times (T,) in which a body turns over: a period, or ln J + 2.3 over the rate and more, on the saddle."""
        scanned = 600  # times among which the first reversal lies
        return np.linspace(0.0, min(self.period, (2.0 * math.log(self.J) + 8.0) / self.rate), scanned)

    @cached_property
    def _chains(self) -> list[Chain]:
        terms = rigid_terms(self.constants, MIDDLE_IS_Z)
        a, b, c = self.direction
        start, chains = coherent_state(self.J, (c, a, b)), []
        # one constant for both chains, whose phases against each other move ⟨L_a⟩ and ⟨L_c⟩
        middle = matrix_elements(terms, self.J, np.arange(self.J, -self.J - 1, -1.0), 0).mean()
        for first in (0, 1):
            psi = start[first::2]  # index 0 is K = J
            if np.abs(psi).max() > 0.0:
                K = np.arange(self.J - first, -self.J - 1, -2.0)
                diagonal = matrix_elements(terms, self.J, K, 0)
                energy, vectors = _diagonalise(diagonal - middle, matrix_elements(terms, self.J, K[1:], 1))
                chains.append(Chain(K, energy, vectors, vectors.T @ psi))
        return chains

    @known_numbers_only
    def classical(self, times: Real[ArrayLike, "time"]) -> Float64[Array, "time"]:
        """Return L_b/|L| (T,) of the classical body that starts with L along ``direction``.

        Args:
            times: (T,) [s] from the start.

        Raises:
            InvalidInput: for times that are not finite.
        """
        return self._simulate(self.direction[None], _check_times(times))[0]

    @known_numbers_only
    def ensemble(self, times: Real[ArrayLike, "time"], members: int = 2000) -> Float64[Array, "time"]:
        """Return the mean of L_b/J (T,) over classical bodies that start spread as the coherent state is.

        Their |L| is J + ½ and their density ((1 + cos θ)/2)^{4J} about ``direction``, which gives them its mean L and
        its widths. They are a spiral of points, so that the result is reproducible; it is good to about
        1/√members once the cloud is wound up.

        Args:
            times: (T,) [s] from the start.
            members: how many bodies.

        Raises:
            InvalidInput: for times that are not finite, or fewer than ten members.
        """
        index = np.arange(check.whole("members", members, 10))
        t = _check_times(times)
        # x = (1 + cos θ)/2 has density ∝ x^4J on the sphere, so that x^(4J+1) is uniform, and ⟨cos θ⟩ = J/(J + ½): the
        # mean of L is J
        share = ((index + 0.5) / members) ** (1.0 / (4.0 * self.J + 1.0))
        around, polar = 2.0 * math.pi * np.remainder(index * GOLDEN, 1.0), 2.0 * np.arcsin(np.sqrt(1.0 - share))
        middle = self.direction
        third = np.array([1.0, 0.0, 0.0]) if self.towards == "c" else np.array([0.0, 0.0, 1.0])
        second = np.cross(third, middle)
        beside = np.outer(np.cos(around), second) + np.outer(np.sin(around), third)
        units = np.cos(polar)[:, None] * middle + np.sin(polar)[:, None] * beside
        return self._simulate(units, t).mean(axis=0) * self._G / self.J

    @property
    def _energy(self) -> float:
        """E/h of classical L [Hz]."""
        return float(np.dot(self.constants, self.direction**2)) * self._G**2

    @property
    def _on_saddle(self) -> bool:
        A, B, C = self.constants
        return abs(self._energy / self._G**2 - B) < 1e-12 * (A - C)

    def _simulate(self, units: Float64[Array, "n 3"], times: Float64[Array, "time"]) -> Float64[Array, "n time"]:
        """Return L_b/|L| (n, T) of free bodies, whose energies E/ħ are 2π times the constants times L²."""
        moments = 1.0 / (4.0 * math.pi * np.array(self.constants))
        motion: Any = FreeMotion(moments, momentum=(self._G * units)[:, None, :])
        return np.asarray(motion.momentum(times))[..., 1] / self._G


def _diagonalise(diagonal: Array, beside: Array) -> tuple[Array, Array]:
    if len(diagonal) == 1:
        return diagonal, np.ones((1, 1))
    eigensystem: Any = eigh_tridiagonal(diagonal, beside)
    return eigensystem


def _check_times(times: Any) -> Array:
    return check.array("times", times, ("T",), "s")
