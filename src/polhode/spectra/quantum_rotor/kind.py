"""A molecule as a quantum rotor: its levels and its lines."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, ClassVar

from polhode.kinds.base import AbstractKind, NextStep, Spec
from polhode.spec.models import SystemTable
from polhode.spectra.quantum_rotor.table import QuantumRotorTable

if TYPE_CHECKING:
    from polhode.spectra.spec_rotors import SpecRotor


class QuantumRotorKind(AbstractKind[QuantumRotorTable]):
    """A molecule as a quantum rotor: its levels and its lines."""

    name: ClassVar[str] = "quantum-rotor"
    table: ClassVar[type[SystemTable]] = QuantumRotorTable
    has_motion: ClassVar[bool] = False
    has_attitude: ClassVar[bool] = False
    figure_names: ClassVar[tuple[str, ...]] = (
        "levels", "spectrum", "energy_surface", "momentum_sphere", "racket", "wigner", "racket_wigner",
    )  # fmt: skip

    def rotor(self, spec: Spec) -> SpecRotor:
        """Return the quantum rotor that a spec describes; ``spectra.spec_rotors.rotor_of_spec`` asks for it."""
        from polhode.spectra.quantum_rotor.build import build

        return build(spec)

    def next_steps(self, spec: Spec) -> Sequence[NextStep]:
        rotor = self.rotor(spec).rotor
        steps = [NextStep("levels", "lists the levels")]
        if not rotor.is_linear and rotor.equal != "ABC" and spec.system.j > 0:
            steps.insert(0, NextStep("view", "shows them as polhodes"))
        return [*steps, NextStep("lines", "the lines")] if any(spec.system.dipole) else steps

    def offers(self, spec: Spec) -> Sequence[NextStep]:
        is_molecule = spec.source is not None and spec.source.is_molecule
        return (NextStep("levels", "lists its quantum levels"),) if is_molecule else ()


KIND = QuantumRotorKind()
