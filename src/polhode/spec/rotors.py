"""The quantum rotor that a spec's body is."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from polhode.bodies.atoms import from_atoms, isotopic_masses
from polhode.bodies.body import Body
from polhode.errors import InvalidInput
from polhode.formats.molecule import read_molecule
from polhode.quantum.partition import THERMAL
from polhode.quantum.rotor import Rotor
from polhode.spec.models import BodyTable

ROOM_TEMPERATURE = 300.0  # K
RARE = 8.0  # E/kT of the lowest level of a J beyond which lines are weak
FEWEST_J, MOST_J = 10, 60  # of the largest J where a spec does not say it; lines grow as its cube


class SpecRotor(NamedTuple):
    """The molecule of a spec, as a quantum rotor, and how far it is asked about.

    Attributes:
        rotor: its constants.
        temperature: [K].
        j_max: the largest J of levels and lines.
    """

    rotor: Rotor
    temperature: float
    j_max: int


def rotor_of_body(body: Body | None, source: BodyTable | None, folder: Path, **options: Any) -> Rotor:
    """Return the rotor of a body; paths count from the folder.

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
        return Rotor(tuple(sorted(source.rotational_constants, reverse=True)), **options)
    if source.molecule is not None:
        symbols, positions, masses = read_molecule(folder / source.molecule)
        body = from_atoms(symbols, positions, isotopic_masses(symbols) if masses is None else masses)
    return Rotor.from_body(body, **options)


def asked_of(rotor: Rotor, temperature: float | None = None, j_max: int | None = None) -> SpecRotor:
    """Return a rotor with temperature and largest J, those that are usual where they are not given."""
    found = ROOM_TEMPERATURE if temperature is None else temperature
    return SpecRotor(rotor, found, usual_j(rotor, found) if j_max is None else j_max)


def usual_j(rotor: Rotor, temperature: float) -> int:
    """Return the J beyond which few molecules are at a temperature [K], from 10 to 60."""
    smallest = max(rotor.constants[2], 1e-300)
    wanted = math.sqrt(RARE * THERMAL * temperature / smallest)
    return int(np.clip(math.ceil(min(wanted, MOST_J)), FEWEST_J, MOST_J))
