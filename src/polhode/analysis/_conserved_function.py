"""The conserved function that proves a verdict, as data and in words."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from polhode.types import Array, Double, Float64


@dataclass(frozen=True, eq=False)
class ConservedFunction:
    """F = w₀ H + Σ w_k C_k + Σ s_k ((C_k − C_k⁰)/ℓ_k)², critical at an equilibrium, and its second variation there.

    The C_k are Casimirs and integrals, C_k⁰ their values at the equilibrium. ``str`` writes F down.

    Attributes:
        names: of the C_k.
        weights: (1 + k,) w; w₀ is one, or zero where the energy takes no part.
        curvatures: (d,) eigenvalues of D²F without its squares on the tangent space of the leaf, in scaled coordinates
            and relative to the largest term of D²F.
        zero: size of those that count as zero.
        freedom: how many of the w the equilibrium leaves free; they are chosen so that F becomes definite, if any do.
        squares: (k,) s, which make F definite across leaves as well; zeros where that is not needed or not proved.
        lengths: (k,) ℓ, changes of the C_k over a unit of the scaled coordinates.
        unit: of the state; H and the C_k are given in its square.
        point: the equilibrium, where it is known.
    """

    names: tuple[str, ...]
    weights: Float64[Array, "all"]
    curvatures: Float64[Array, "d"]
    zero: float
    freedom: int = 0
    squares: Float64[Array, "k"] | None = None
    lengths: Float64[Array, "k"] | None = None
    unit: float = 1.0
    point: Double[Array, "..."] | None = None

    @property
    def signature(self) -> tuple[int, int, int]:
        """How many curvatures are positive, zero and negative."""
        positive, negative = int((self.curvatures > self.zero).sum()), int((self.curvatures < -self.zero).sum())
        return positive, self.curvatures.size - positive - negative, negative

    @property
    def margin(self) -> float:
        """The smallest curvature, by size; infinite on a leaf that is a point."""
        return float(np.abs(self.curvatures).min(initial=np.inf))

    @property
    def has_squares(self) -> bool:
        """Whether squares take part."""
        return self.squares is not None and bool(np.any(self.squares))

    def rename(self, names: Mapping[str, str]) -> ConservedFunction:
        """Return the same function with other names of the C_k."""
        return replace(self, names=tuple(names.get(name, name) for name in self.names))

    def __str__(self) -> str:
        text = "H" if self.weights[0] else ""
        for weight, name in zip(self.weights[1:], self.names, strict=True):
            if weight:
                text += f" {'+' if weight >= 0 else '−'} {abs(weight):.6g} {add_brackets(name)}"
        # with no energy, a single one needs no weight of one
        text = re.sub(r"^(− )?1 (?=\S+$)", r"\1", text.removeprefix(" + ").strip())
        if self.squares is not None and self.lengths is not None:
            for square, length, name in zip(self.squares, self.lengths, self.names, strict=True):
                if square:
                    text += f" {'+' if square > 0 else '−'} {_square(abs(square), length, name, self.unit)}"
        return text


def add_brackets(name: str) -> str:
    """Return a function's name as a factor: a sum in brackets."""
    return f"({name})" if name.startswith("−") or any(f" {sign} " in name for sign in "+−") else name


def _square(weight: float, length: float, name: str, unit: float) -> str:
    """Return weight (C − C⁰)²/(length · unit)² in words, with what is squared apart where it would overflow."""
    if unit != 1.0:
        weight, length = weight / length**2, unit
    if 1e-140 < length < 1e140:
        return f"{weight / length**2:.6g} Δ({name})²"
    return f"{weight:.6g} (Δ({name})/{length:.6g})²"
