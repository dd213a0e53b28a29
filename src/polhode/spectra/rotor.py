"""A molecule that rotates: its constants, and its levels."""

from __future__ import annotations

import enum
import math
import warnings
from collections.abc import Mapping
from typing import Any, NamedTuple, TypeVar

import numpy as np

from polhode._base import check
from polhode._base.arrays import known_numbers_only, require_doubles
from polhode.bodies.body import Body
from polhode.errors import InvalidInput, shown
from polhode.spectra import _wang as wang
from polhode.spectra._operators import Reduction, Representation, Term, distortion_terms, rigid_terms
from polhode.spectra._partition import THERMAL, check_temperature, partition_sum
from polhode.spectra._strengths import EINSTEIN, INTENSITY, Lines, compute_states, lines_between
from polhode.types import Array, ArrayLike, Bool, Float64, Integer, Real

Kind = TypeVar("Kind", bound=enum.Enum)


class RotorLimits(NamedTuple):
    """Limits of a rotor, and when its constants count as equal.

    Attributes:
        max_j: of levels that are computed.
        spherical_spread: A − C over A, up to which a top is spherical.
        symmetric_difference: of two constants over A − C, up to which a top is symmetric.
        min_runaway: energy below zero over the largest energy, from which levels fall without end; rounding of levels
            about zero is less.
        min_moment: over the largest moment: below it only levels of K_a = 0 are within reach, nor would others be exact
            beside them.
    """

    max_j: int = 10_000
    spherical_spread: float = 1e-13
    symmetric_difference: float = 1e-9
    min_runaway: float = 1e-9
    min_moment: float = 1e-9


LIMITS = RotorLimits()
RIGID = Representation.Ir
PLANCK_OVER_8_PI_SQUARED = 8.392015881190e-36  # kg m² Hz, CODATA 2022: a moment times its constant


class Levels(NamedTuple):
    """Rotational levels, by J, then by energy.

    Attributes:
        J, Ka, Kc: (n,) quantum numbers; of a half-integer J, Ka and Kc count from the lowest pair.
        energy: (n,) E/h [Hz].
        weight: (n,) statistical weight of the nuclear spins; without the 2J + 1 of directions in space.
    """

    J: Integer[Array, "n"]
    Ka: Integer[Array, "n"]
    Kc: Integer[Array, "n"]
    energy: Float64[Array, "n"]
    weight: Float64[Array, "n"]

    @property
    def symmetry(self) -> list[str]:
        """The species of the group D2 of half turns: A, Ba, Bb or Bc, (n,)."""
        names = {(0, 0): "A", (0, 1): "Ba", (1, 1): "Bb", (1, 0): "Bc"}
        return [names[int(a) % 2, int(c) % 2] for a, c in zip(self.Ka, self.Kc, strict=True)]

    def of(self, J: int, Ka: int, Kc: int) -> float:
        """Return the energy of one level [Hz].

        Raises:
            InvalidInput: if it is not among these.
        """
        indices = np.flatnonzero((self.J == J) & (self.Ka == Ka) & (self.Kc == Kc))
        if len(indices) != 1:
            raise InvalidInput(f"the level {J}_{Ka},{Kc} must be among those computed; check J, Ka and Kc, or `j_max`.")
        return float(self.energy[indices[0]])


class Rotor:
    """A rotating molecule: H = A J_a² + B J_b² + C J_c² and Watson's centrifugal distortion.

    Args:
        constants: A ≥ B ≥ C ≥ 0, as E/h [Hz]; A infinite for a linear molecule.
        distortion: constants by name [Hz], such as "Delta_J" in the A reduction, "D_J" in the S reduction.
        reduction: "A" or "S"; needed with distortion.
        representation: "Ir", "Il", "IIr", "IIl", "IIIr" or "IIIl", which principal axes x, y, z are; needed with
            distortion, without meaning otherwise.
        dipole: (3,) permanent dipole moment along a, b, c [C m].
        spin_weights: of levels whose state keeps, and changes, its sign in a half turn about ``spin_axis``.
        spin_axis: "a", "b" or "c", whose half turn exchanges equal nuclei.

    Raises:
        InvalidInput: for constants in another order, negative or not finite, unknown names, or distortion without
            reduction and representation.

    >>> water = Rotor((835840.288e6, 435351.717e6, 278138.700e6))
    >>> levels = water.levels(1)
    >>> [(int(j), int(a), int(c)) for j, a, c in zip(levels.J, levels.Ka, levels.Kc)]
    [(0, 0, 0), (1, 0, 1), (1, 1, 1), (1, 1, 0)]

    Source: Gordy & Cook, *Microwave Molecular Spectra*, ch. 7–8; Watson, in *Vibrational Spectra and Structure* 6
    (1977) 1.
    """

    @known_numbers_only
    def __init__(
        self,
        constants: Real[ArrayLike, "3"],
        distortion: Mapping[str, float] | None = None,
        reduction: str | None = None,
        representation: str | None = None,
        dipole: Real[ArrayLike, "3"] = (0.0, 0.0, 0.0),
        spin_weights: tuple[float, float] = (1.0, 1.0),
        spin_axis: str = "b",
    ) -> None:
        require_doubles(constants=constants, dipole=dipole)
        self.constants = _check_constants(constants)
        self.reduction = _member(Reduction, "reduction", reduction)
        self.representation = _member(Representation, "representation", representation)
        self.distortion = dict(distortion or {})
        own = distortion_terms(self.distortion, self.reduction, self.representation)
        self.is_linear = math.isinf(self.constants[0])
        if self.is_linear and any(term.of_ladder or term.of_Jz for _, term in own):
            raise InvalidInput("a linear molecule (A infinite) must have distortion in J alone, such as D_J.")
        self._terms = [*self._rigid_terms(), *own]
        self.dipole = check.array("dipole", dipole, (3,), "C m", remedy="Give those along a, b and c.")
        self.spin_weights, self.spin_axis = _check_spins(spin_weights, spin_axis)

    @classmethod
    def from_body(cls, body: Body, **options: object) -> Rotor:
        """Return the rigid rotor with a body's principal moments, A = h/8π²I_a; linear where one of them is zero.

        Args:
            body: such as ``ph.Body.from_atoms`` makes.
            options: dipole, spin_weights, spin_axis.
        """
        moments = np.array(body.principal_moments, float)
        if moments[0] <= LIMITS.min_moment * moments[2]:
            moments = np.array([0.0, *[0.5 * (moments[1] + moments[2])] * 2])  # of a line the other two are equal
        with np.errstate(divide="ignore"):
            return cls(tuple(PLANCK_OVER_8_PI_SQUARED / moments), **options)  # type: ignore[arg-type]

    @property
    def kappa(self) -> float | None:
        """Ray's asymmetry (2B − A − C)/(A − C), −1 for prolate, +1 for oblate; None of a spherical top."""
        A, B, C = self.constants
        if self.is_linear:
            return -1.0
        return None if self.equal == "ABC" else (2.0 * B - A - C) / (A - C)

    @property
    def equal(self) -> str:
        """Which constants are equal: "BC" of a prolate top or a linear molecule, "AB", "ABC", or "" of none."""
        return equal_constants(self.constants)

    @property
    def terms(self) -> list[tuple[float, Term]]:
        """The Hamiltonian as numbers [Hz] and operators, in ``representation``, I^r if there is none."""
        return list(self._terms)

    def levels(self, j_max: int, j_min: int = 0) -> Levels:
        """Return all levels with J from j_min to j_max.

        Distortion constants are the first terms of a series: far beyond the J that they were fitted to, levels run
        away.

        Raises:
            InvalidInput: for a J that is not a whole number, negative, or above 10,000.
        """
        first, last = (check_j(name, J) for name, J in (("j_min", j_min), ("j_max", j_max)))
        if first > last:
            raise InvalidInput(f"`j_min` must not be above `j_max`; got {first} and {last}.")
        return join_levels([self.levels_of(J) for J in range(first, last + 1)])

    def levels_of(self, J: int) -> Levels:
        """Return the 2J + 1 levels of one J, ascending as the labels of a rigid rotor do."""
        J = check_j("J", J)
        if self.is_linear:
            j = J * (J + 1.0)
            # E = B J(J+1) − D [J(J+1)]² + …, as K = 0
            energy = sum(value * term.sign * j**term.of_J for value, term in self._terms)
            return self._weigh_levels(np.array([J]), np.array([0]), np.array([J]), np.array([energy]))
        representation = self.representation or RIGID
        blocks = []
        for block in wang.blocks(J):
            energy = wang.energies(wang.band(self._terms, J, block))
            blocks.append((*wang.labels(J, block, representation), energy))
        Ka, Kc, energy = (np.concatenate(parts) for parts in zip(*blocks, strict=True))
        order = np.lexsort((-Kc, Ka))
        return self._weigh_levels(np.full(2 * J + 1, J), Ka[order], Kc[order], energy[order])

    @known_numbers_only
    def partition_function(self, temperature: Real[ArrayLike, "*batch"]) -> Float64[Array, "*batch"]:
        """Return Q = Σ w (2J+1) e^{−E/kT} (…), summed over levels.

        Args:
            temperature: (…) [K].

        Raises:
            InvalidInput: for temperatures that are not positive, or a rotor with C = 0, whose levels never end.
        """
        values = check_temperature(temperature)
        if self.constants[2] == 0.0:
            raise InvalidInput("a rotor with C = 0 has no partition function: infinitely many levels lie below any.")

        def of(J: int) -> tuple[Array, Array]:
            levels = self.levels_of(J)
            return levels.energy, levels.weight

        return partition_sum(of, values, LIMITS.max_j)

    @known_numbers_only
    def lines(self, j_max: int, temperature: float | None = None) -> Lines:
        """Return all absorption lines of the dipole between levels with J up to j_max, by frequency.

        Work and memory grow as j_max³.

        Args:
            j_max: of both levels.
            temperature: [K], for intensities.

        Raises:
            InvalidInput: without a dipole, for a linear molecule's dipole across its axis, or an invalid J or
                temperature.

        >>> from polhode.spectra import DEBYE
        >>> rotor = Rotor((27e9, 14e9, 9e9), dipole=(0.0, DEBYE, 0.0))
        >>> lines = rotor.lines(1)
        >>> (lines.frequency / 1e9).round(6).tolist(), lines.upper.tolist(), lines.lower.tolist()
        ([18.0, 36.0], [[1, 1, 0], [1, 1, 1]], [[1, 0, 1], [0, 0, 0]])
        """
        highest = check_j("j_max", j_max)
        if not self.dipole.any():
            raise InvalidInput("`dipole` must not be zero: a rotor without a dipole has no dipole lines.")
        if self.is_linear:
            return self._weigh_lines(_linear_lines(self, highest), temperature)
        representation = self.representation or RIGID
        parts, low = [], compute_states(self._terms, 0, representation)
        for J in range(highest + 1):
            parts.append(lines_between(low, low, self.dipole, representation))
            if J < highest:
                high = compute_states(self._terms, J + 1, representation)
                parts.append(lines_between(low, high, self.dipole, representation))
                low = high
        return self._weigh_lines(tuple(np.concatenate(x) for x in zip(*parts, strict=True)), temperature)

    def _weigh_lines(self, columns: tuple[Array, ...], temperature: float | None) -> Lines:
        """Return lines by frequency, with intensities by temperature and spin weights."""
        order = np.argsort(columns[2], kind="stable")
        upper, lower, frequency, strength, energy = (x[order] for x in columns)
        weight = self._spin_weight(lower[:, 1], lower[:, 2])
        # A = 64π⁴ν³ Sμ²/(3hc³ (2J′+1)) · 1/(4πε₀)
        einstein = EINSTEIN * frequency**3 * strength / (2 * upper[:, 0] + 1)
        intensity = np.full(len(order), np.nan)
        if temperature is not None:
            kT = THERMAL * float(check_temperature(temperature))
            if (said := warn_of_fallen(lower[:, 0], energy)) is not None:
                warnings.warn(said, stacklevel=4)
            share = np.exp(-np.maximum(energy, 0.0) / kT) * -np.expm1(-frequency / kT)
            share[find_fallen(lower[:, 0], energy)] = 0.0
            intensity = INTENSITY * frequency * weight * strength * share / self.partition_function(temperature)
        return Lines(upper, lower, frequency, strength, energy, weight, intensity, einstein)

    def _rigid_terms(self) -> list[tuple[float, Term]]:
        A, B, C = self.constants
        if math.isinf(A):
            return [(0.5 * (B + C), Term(1.0, 1, 0))]
        return rigid_terms((A, B, C), self.representation or RIGID)

    def _weigh_levels(self, J: Array, Ka: Array, Kc: Array, energy: Array) -> Levels:
        return Levels(J, Ka, Kc, energy, self._spin_weight(Ka, Kc))

    def _spin_weight(self, Ka: Array, Kc: Array) -> Array:
        odd = {"a": Ka, "b": Ka + Kc, "c": Kc}[self.spin_axis] % 2
        return np.where(odd == 1, self.spin_weights[1], self.spin_weights[0])


def equal_constants(constants: tuple[float, float, float]) -> str:
    """Return which of A ≥ B ≥ C are equal, as far as levels in doubles show: "AB", "BC", "ABC" or "".

    >>> [equal_constants(each) for each in ((9.0, 3.0, 3.0), (3.0, 3.0, 3.0), (9.0, 4.0, 3.0), (math.inf, 3.0, 3.0))]
    ['BC', 'ABC', '', 'BC']
    """
    A, B, C = constants
    if math.isinf(A):
        return "BC"
    if A - C <= LIMITS.spherical_spread * A:
        return "ABC"
    if B - C <= LIMITS.symmetric_difference * (A - C):
        return "BC"
    return "AB" if A - B <= LIMITS.symmetric_difference * (A - C) else ""


def warn_of_fallen(J: Integer[Array, "n"], energy: Float64[Array, "n"]) -> str | None:
    """Return a warning about levels below the ground state, which are unphysical; None without any."""
    wrong = find_fallen(J, energy)
    if not wrong.any():
        return None
    return (
        f"from J = {int(J[wrong].min())} on levels lie below the ground state: the distortion constants do not hold "
        "there, or one is in another unit. These J are left out of intensities and populations."
    )


def find_fallen(J: Integer[Array, "n"], energy: Float64[Array, "n"]) -> Bool[Array, "n"]:
    """Mask the unphysical levels: every J from the first that has a level below the ground state, whose energy is 0."""
    below = energy < -LIMITS.min_runaway * np.abs(energy).max(initial=0.0)
    return J >= J[below].min() if below.any() else below


def join_levels(parts: list[Levels]) -> Levels:
    """Return levels concatenated."""
    return Levels(*(np.concatenate(columns) for columns in zip(*parts, strict=True)))


def check_j(name: str, J: int) -> int:
    """Return a whole J.

    Raises:
        InvalidInput: otherwise.
    """
    return check.whole(name, J, 0, LIMITS.max_j)


def _check_constants(constants: Array) -> tuple[float, float, float]:
    try:
        values = np.asarray(constants, float)
    except (TypeError, ValueError):
        raise InvalidInput(f"`constants` must be three numbers A, B, C [Hz]; got {shown(constants)}.") from None
    if values.shape != (3,) or np.isnan(values).any() or not np.isfinite(values[1:]).all() or (values < 0.0).any():
        check.refuse("constants", "three numbers A, B, C [Hz], finite and not negative", constants,
                     "Only A may be infinite, for a linear molecule.")
    A, B, C = (float(x) for x in values)
    if A == 0.0 and B == C > 0.0:  # as codes of quantum chemistry print those of a linear molecule
        raise InvalidInput(f"`constants` must be in the order A ≥ B ≥ C; got 0, {B:g}, {C:g}. A linear molecule "
                           f"has an infinite A: write (inf, {B:g}, {C:g}).")
    if not A >= B >= C:
        raise InvalidInput(
            f"`constants` must be in the order A ≥ B ≥ C; got {A:g}, {B:g}, {C:g}. Write them in this "
            "order."
        )
    if math.isinf(A) and B != C:
        raise InvalidInput(f"a linear molecule (A infinite) must have B = C; got {B:g} and {C:g}.")
    return A, B, C


def _member(kind: type[Kind], name: str, value: Any) -> Kind | None:
    if value is None or isinstance(value, kind):
        return value
    return kind[check.one_of(name, value, kind.__members__)]


def _check_spins(weights: tuple[float, float], axis: str) -> tuple[tuple[float, float], str]:
    even, odd = check.array("spin_weights", weights, (2,), least=0, not_all_zero=True).tolist()
    return (even, odd), check.one_of("spin_axis", axis, ("a", "b", "c"))


def _linear_lines(rotor: Rotor, j_max: int) -> tuple[Array, ...]:
    """Return the lines J → J + 1 of a linear molecule, S = J + 1."""
    if rotor.dipole[1:].any():
        raise InvalidInput(f"the `dipole` of a linear molecule must be along a, its axis; got {shown(rotor.dipole)}.")
    J = np.arange(j_max)
    energy = np.array([rotor.levels_of(int(j)).energy[0] for j in range(j_max + 1)])
    nothing = np.zeros_like(J)
    upper, lower = np.column_stack([J + 1, nothing, J + 1]), np.column_stack([J, nothing, J])
    return upper, lower, np.diff(energy), (J + 1.0) * rotor.dipole[0] ** 2, energy[:-1]
