"""The table [system] of spins on a lattice."""

from __future__ import annotations

from typing import Annotated, ClassVar, NamedTuple

from pydantic import Field, StrictInt

from polhode.spec.fields import Direction, Energy, MagneticField, Plain, PositivePlain, Temperature
from polhode.spec.models import Strict, SystemTable


class SpinLatticeTableLimits(NamedTuple):
    """What the table accepts.

    Attributes:
        max_spins: of the whole lattice.
        max_bonds: in a cell: each is compiled, and hundreds took minutes.
    """

    max_spins: int = 1_000_000
    max_bonds: int = 100


LIMITS = SpinLatticeTableLimits()
Vector = Annotated[list[Plain], Field(min_length=1, max_length=3)]
Count = Annotated[StrictInt, Field(ge=1, le=LIMITS.max_spins)]
Site = Annotated[StrictInt, Field(ge=1, le=1000)]


class BondTable(Strict):
    """H = −J S·S′ − D·(S × S′), once in every cell; sites count from 1."""

    sites: tuple[Site, Site] = (1, 1)
    cell: list[StrictInt] = Field(description="give by how many cells the other end is further, like [1, 0]")
    exchange: Energy | None = None
    chirality: tuple[Energy, Energy, Energy] | None = None
    matrix: tuple[tuple[Energy, Energy, Energy], ...] | None = None


class AxisTable(Strict):
    """H = −K (S · n)²: an easy axis for a positive K, a hard one for a negative."""

    axis: Direction = Field(description="give it like [0, 0, 1]")
    energy: Energy = Field(description='give it like "0.1 meV"')


class SpinLatticeTable(SystemTable):
    """Places of the spins, their interactions, and their start."""

    takes: ClassVar[tuple[str, ...]] = ("time",)
    needs: ClassVar[tuple[str, ...]] = ()
    vectors: Annotated[list[Vector], Field(min_length=1, max_length=3)] = Field(
        description="give one to three vectors of the cell, like [[1, 0], [0, 1]]"
    )
    cells: Annotated[list[Count], Field(min_length=1, max_length=3)] = Field(
        description="give how many there are along each vector, like [32, 32]"
    )
    basis: list[Vector] | None = None
    periodic: bool = True
    spin: PositivePlain = 1.0
    bonds: Annotated[list[BondTable], Field(max_length=LIMITS.max_bonds)] = Field(
        default=[], description='give them like [{ cell = [1], exchange = "1 meV" }], or leave them out'
    )
    anisotropy: AxisTable | None = None
    field: MagneticField | None = None
    g_factor: Plain = 2.0
    dipolar: Energy | None = None
    damping: Annotated[Plain, Field(ge=0.0, le=100.0)] = 0.0
    temperature: Temperature | None = None
    directions: list[Direction] | None = None
    disorder: Annotated[Plain, Field(ge=0.0, le=10.0)] = 0.0
    random: bool = False
    seed: Annotated[StrictInt, Field(ge=0, le=2**31)] = 1
