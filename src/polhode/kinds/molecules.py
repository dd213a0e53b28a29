"""The quantum rotor that a spec's body is, whatever the spec's kind."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from polhode.bodies.atoms import from_atoms, isotopic_masses
from polhode.errors import InvalidInput
from polhode.formats.molecule import read_molecule
from polhode.kinds.base import Spec, SpecRotor
from polhode.quantum.partition import THERMAL
from polhode.quantum.rotor import Rotor

ROOM_TEMPERATURE = 300.0  # K
RARE = 8.0  # E/kT of the lowest level of a J beyond which lines are weak
FEWEST_J, MOST_J = 10, 60  # of the largest J where a spec does not say it; lines grow as its cube


def is_molecule(spec: Spec) -> bool:
    """Whether a spec's body is told as molecules are, by atoms or by rotational constants."""
    source = spec.source
    return source is not None and (source.molecule is not None or source.rotational_constants is not None)


def rotor_of_body(spec: Spec, **options: Any) -> Rotor:
    """Return the rotor of a spec's body.

    Atoms have the masses that their file gives, otherwise those of the most common isotopes, and not atomic weights:
    a line is one isotopic species'.

    Args:
        spec: with [body].
        options: of ``Rotor``, without constants.

    Raises:
        InvalidInput: for a spec without [body], or a body that is no rotor.
    """
    if spec.body is None or spec.source is None:
        raise InvalidInput(
            'there is no molecule: give molecule = "water.xyz" or rotational_constants under [body], or a spec of '
            "constants."
        )
    if spec.source.rotational_constants is not None:
        return Rotor(tuple(sorted(spec.source.rotational_constants, reverse=True)), **options)
    body = spec.body
    if spec.source.molecule is not None:
        symbols, positions, masses = read_molecule(spec.folder / spec.source.molecule)
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
