"""From the spec of a molecule to its rotor."""

from __future__ import annotations

import math

from polhode.kinds.base import Spec
from polhode.spectra.quantum_rotor.table import QuantumRotorTable
from polhode.spectra.rotor import Rotor
from polhode.spectra.spec_rotors import SpecRotor, complete_rotor, doubts_of_weights, rotor_of_body


def build(spec: Spec[QuantumRotorTable]) -> SpecRotor:
    """Return the molecule of a spec, its temperature, and the largest J of its levels.

    Raises:
        InvalidInput: for constants that no rotor has.
    """
    table = spec.system
    options = {
        "distortion": table.distortion, "reduction": table.reduction, "representation": table.representation,
        "dipole": table.dipole, "spin_weights": table.spin_weights, "spin_axis": table.spin_axis,
    }  # fmt: skip
    constants = table.constants
    atoms = None
    if constants is None:
        rotor, atoms = rotor_of_body(spec.body, spec.source, spec.folder, **options)
    else:
        rotor = Rotor((math.inf, constants[0], constants[0]) if len(constants) == 1 else constants, **options)
    return complete_rotor(rotor, table.temperature, table.j_max, doubts_of_weights(rotor, atoms))
