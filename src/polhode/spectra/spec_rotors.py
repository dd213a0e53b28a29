"""The quantum rotor of a spec's body."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from polhode.bodies.atoms import isotopic_masses
from polhode.bodies.body import Body
from polhode.errors import InvalidInput
from polhode.formats.form import Content
from polhode.formats.molecule import read_molecule
from polhode.spec.models import BodyTable
from polhode.spectra._partition import LIMITS as SUM_LIMITS
from polhode.spectra._partition import THERMAL
from polhode.spectra._strengths import DEBYE, Lines
from polhode.spectra.rotor import Levels, Rotor
from polhode.types import Array, Float64

if TYPE_CHECKING:
    from polhode.kinds.base import Spec


class SpecRotorLimits(NamedTuple):
    """Limits of what a spec may request.

    Attributes:
        max_displacement: m, of an atom from where the symmetry puts it: a hundredth of an ångström.
        max_lines: of a list, which takes some gigabytes.
        max_summed_j: of a partition function, whose time grows as its cube: some seconds.
        min_constant: Hz, of a molecule; of the heaviest some kHz.
        max_constant: Hz and debye, beyond any molecule; intensities have cubes of frequencies.
    """

    max_displacement: float = 1e-12
    max_lines: int = 13_000_000
    max_summed_j: int = 600
    min_constant: float = 1.0
    max_constant: float = 1e20


LIMITS = SpecRotorLimits()


class SpecRotor(NamedTuple):
    """The molecule of a spec as a quantum rotor, with temperature and largest J.

    Attributes:
        rotor: its constants.
        temperature: [K].
        j_max: the largest J of levels and lines.
        notes: for the report.
    """

    rotor: Rotor
    temperature: float
    j_max: int
    notes: tuple[str, ...] = ()


class Molecule(NamedTuple):
    """A molecule as a quantum rotor, and what is asked about it; lines are None without a dipole."""

    rotor: Rotor
    temperature: float
    levels: Callable[[], Levels]
    lines: Callable[[], Lines | None]


class Atoms(NamedTuple):
    """The atoms of a molecule: symbols, masses (n,) and positions (n, 3) along its principal axes a, b, c [m]."""

    symbols: list[str]
    masses: Float64[Array, "n"]
    positions: Float64[Array, "n 3"]


def rotor_of_body(
    body: Body | None, source: BodyTable | None, folder: Path, **options: Any
) -> tuple[Rotor, Atoms | None]:
    """Return the rotor of a body, and its atoms if it is a molecule of a file; paths count from the folder.

    Atoms have the masses that their file gives, otherwise those of the most common isotopes, and not atomic weights:
    a line is one isotopic species'.

    Args:
        body: of a spec with [body].
        source: that table.
        folder: that paths count from.
        options: of ``Rotor``, without constants.

    Raises:
        InvalidInput: for a spec without [body], or a body that is no rotor.
    """
    if body is None or source is None:
        raise InvalidInput(
            'there is no molecule: give molecule = "water.xyz" or rotational_constants under [body], or a spec of '
            "constants."
        )
    if source.rotational_constants is not None:
        return Rotor(tuple(sorted(source.rotational_constants, reverse=True)), **options), None
    atoms = None
    if source.molecule is not None:
        symbols, positions, masses = read_molecule(folder / source.molecule)
        masses = isotopic_masses(symbols) if masses is None else masses
        body = Body.from_atoms(symbols, positions, masses)
        atoms = Atoms(symbols, masses, (positions - body.center_of_mass) @ body.principal_axes)
    rotor = Rotor.from_body(body, **options)
    if atoms is None and rotor.constants[1] < LIMITS.min_constant:
        raise InvalidInput(
            f"the body is not a molecule: its rotational constant B would be {rotor.constants[1]:.2g} Hz. Give "
            "molecule or rotational_constants under [body]; other bodies move classically, see `polhode report`."
        )
    return rotor, atoms


def doubts_of_weights(rotor: Rotor, atoms: Atoms | None) -> tuple[str, ...]:
    """Return why a half turn about ``spin_axis`` does not exchange equal nuclei, if spin weights need that.

    It must leave the dipole unchanged, and map each atom to an equal one.
    """
    even, odd = rotor.spin_weights
    if even == odd:
        return ()
    axis = rotor.spin_axis
    k = "abc".index(axis)
    across = [name for j, name in enumerate("abc") if j != k and rotor.dipole[j]]
    why = None
    if across:
        why = f"it would turn the dipole over along {' and '.join(across)}"
    elif rotor.is_linear and axis == "a":
        why = "a half turn about its own axis exchanges no nuclei of a linear molecule"
    elif atoms is not None and (rotor.is_linear or axis.upper() not in rotor.equal) and not _has_half_turn(atoms, k):
        why = "it puts atoms where none of their kind is"
    if why is None:
        return ()
    said = (
        f"the weights {even:g} and {odd:g} are of levels even and odd under a half turn about {axis}, which is no "
        f"symmetry of this molecule: {why}. Check `spin_axis`, or leave `spin_weights` out."
    )
    return (said,)


def _has_half_turn(atoms: Atoms, axis: int) -> bool:
    """Return whether a half turn about a principal axis maps each atom to one of its kind."""
    rotated = -atoms.positions
    rotated[:, axis] *= -1.0
    apart = np.linalg.norm(rotated[:, None] - atoms.positions, axis=-1)
    same = np.equal.outer(atoms.symbols, atoms.symbols) & np.isclose(atoms.masses[:, None], atoms.masses, rtol=1e-6)
    return bool(np.where(same, apart, np.inf).min(axis=1).max() < LIMITS.max_displacement)


def complete_rotor(
    rotor: Rotor, temperature: float | None = None, j_max: int | None = None, notes: tuple[str, ...] = ()
) -> SpecRotor:
    """Return a rotor with temperature and largest J, or their defaults."""
    room_temperature = 300.0  # K
    kelvins = room_temperature if temperature is None else temperature
    return SpecRotor(rotor, kelvins, usual_j(rotor, kelvins) if j_max is None else j_max, notes)


def rotor_of_spec(spec: Spec) -> SpecRotor:
    """Return the quantum rotor that a spec describes; a kind with constants of its own has a method ``rotor`` for them.

    Raises:
        InvalidInput: for a spec without [body], or a body that is no rotor.
    """
    own = getattr(spec.kind, "rotor", None)
    return complete_rotor(rotor_of_body(spec.body, spec.source, spec.folder)[0]) if own is None else own(spec)


def molecule_to_write(content: Content) -> Molecule:
    """Return the molecule of a format's content.

    Raises:
        InvalidInput: for content that is no molecule.
    """
    if content.spec is None:
        raise InvalidInput(f"{content.name} is not a molecule with rotational constants. Choose another form.")
    asked = rotor_of_spec(content.spec)
    levels = partial(asked.rotor.levels, asked.j_max)
    return Molecule(asked.rotor, asked.temperature, levels, partial(_lines, asked))


def _lines(asked: SpecRotor) -> Lines | None:
    if not asked.rotor.dipole.any():
        return None
    check_summable(asked)
    return asked.rotor.lines(asked.j_max, asked.temperature)


def check_summable(asked: SpecRotor) -> None:
    """Refuse molecules with too many populated levels, or too large numbers, at this temperature.

    Raises:
        InvalidInput: with the limits.
    """
    rotor, temperature, j_max, _ = asked
    _check_countable(rotor, j_max)
    smallest = rotor.constants[2]
    largest = max(rotor.constants[1], 0.0 if rotor.is_linear else rotor.constants[0])
    largest = max(largest, *map(abs, rotor.distortion.values())) if rotor.distortion else largest
    if largest > LIMITS.max_constant or np.abs(rotor.dipole).max() > LIMITS.max_constant * DEBYE:
        raise InvalidInput(
            f"constants must be below {LIMITS.max_constant:g} Hz, and a dipole below {LIMITS.max_constant:g} D. "
            "Check units."
        )
    with np.errstate(over="ignore"):
        most = math.sqrt(min(SUM_LIMITS.negligible_energy * THERMAL * temperature / max(smallest, 1e-300), 1e300))
    if most > LIMITS.max_summed_j:
        raise InvalidInput(
            f"at {temperature:g} K levels up to J = {most:.3g} count, and sums go to {LIMITS.max_summed_j}. Give a "
            "lower temperature; a body so large or hot turns as a classical one."
        )


def _check_countable(rotor: Rotor, j_max: int) -> None:
    """Refuse more lines than memory holds: J³/2 for each component of the dipole."""
    components = 1 if rotor.is_linear else np.count_nonzero(rotor.dipole)
    each = j_max if rotor.is_linear else 0.5 * j_max**3
    if components * each > LIMITS.max_lines:
        highest = math.floor((2.0 * LIMITS.max_lines / components) ** (1.0 / 3.0))
        raise InvalidInput(
            f"to J = {j_max} there are about {components * each / 1e6:.3g} million lines, and at most "
            f"{LIMITS.max_lines / 1e6:g} million are computed. Lower `j_max` to {highest}, or ask for levels alone, by "
            "`polhode levels` or without a dipole."
        )


def usual_j(rotor: Rotor, temperature: float) -> int:
    """Return the J beyond which few molecules are at a temperature [K], from 10 to 60."""
    smallest = max(rotor.constants[2], 1e-300)
    rare_energy = 8.0  # E/kT of the lowest level of a J, beyond which lines are weak
    wanted = math.sqrt(rare_energy * THERMAL * temperature / smallest)
    fewest, most = 10, 60  # lines grow as the cube of J
    return int(np.clip(math.ceil(min(wanted, most)), fewest, most))
