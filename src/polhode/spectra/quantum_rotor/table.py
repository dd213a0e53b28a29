"""The table [system] of a quantum rotor."""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

from pydantic import Field, StrictInt

from polhode.spec.fields import (
    Dipole,
    Plain,
    RacketTilt,
    RotorConstants,
    SpectroscopicConstant,
    Temperature,
    one_of,
)
from polhode.spec.models import Strict, SystemTable

AXES = ("a", "b", "c")
REPRESENTATIONS = ("Ir", "Il", "IIr", "IIl", "IIIr", "IIIl")
WholeJ = Annotated[StrictInt, Field(ge=0, le=200)]
LargestJ = Annotated[StrictInt, Field(ge=0, le=1000)]  # a million levels; lines are counted before they are computed


class RacketTable(Strict):
    """A flip about the middle axis: the coherent state of this J points along b, or beside it.

    Attributes:
        tilt: of L from the b axis.
        towards: which axis.
    """

    tilt: RacketTilt = 0.0
    towards: Annotated[Literal["a", "c"], one_of("a", "c")] = "a"


class QuantumRotorTable(SystemTable):
    """A molecule: constants of its own, or those of [body].

    Attributes:
        constants: A, B, C [Hz]; one of a linear molecule.
        distortion: by name [Hz], of the reduction.
        dipole: along a, b, c [C m].
        spin_weights: of levels that a half turn about ``spin_axis`` leaves, and of those that it turns over.
        j_max: the largest J of levels and lines.
        j: whose levels are compared with classical motion, and drawn.
        racket: a flip to follow, of this j.
    """

    takes: ClassVar[tuple[str, ...]] = ("body",)
    needs: ClassVar[tuple[str, ...]] = ()
    constants: RotorConstants | None = None
    distortion: dict[str, SpectroscopicConstant] = Field(default_factory=dict)
    reduction: Annotated[Literal["A", "S"], one_of("A", "S")] | None = None
    representation: (
        Annotated[Literal["Ir", "Il", "IIr", "IIl", "IIIr", "IIIl"], one_of(*REPRESENTATIONS)] | None
    ) = None
    dipole: Dipole = (0.0, 0.0, 0.0)
    spin_weights: tuple[Plain, Plain] = (1.0, 1.0)
    spin_axis: Annotated[Literal["a", "b", "c"], one_of(*AXES)] = "b"
    temperature: Temperature = 300.0
    j_max: LargestJ | None = None
    j: WholeJ = 10
    racket: RacketTable | None = None
