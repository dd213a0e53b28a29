"""Levels and their derivatives by each constant: ∂E/∂p = ⟨∂H/∂p⟩, by Hellmann and Feynman.

H is linear in its constants, so its blocks are Σ p (block of p), each of which is computed once.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from polhode.errors import InvalidInput, shown
from polhode.spectra import _wang as wang
from polhode.spectra._operators import TERMS, Term, rigid_terms
from polhode.spectra.rotor import RIGID, Rotor
from polhode.types import Array, Float64, Integer

AXES = ("A", "B", "C")


def check_names(rotor: Rotor, free: Sequence[str]) -> list[str]:
    """Return names of constants that a rotor may have.

    Raises:
        InvalidInput: for others, none, or one twice.
    """
    known = [*AXES, *(TERMS[rotor.reduction] if rotor.reduction and rotor.representation else ())]
    if isinstance(free, str) or len(free) == 0:
        raise InvalidInput(f"`free` must be a list of constants, such as ['A', 'B', 'C']; got {shown(free)}.")
    for name in free:
        if name not in known:
            hint = "" if len(known) > 3 else " Distortion needs a rotor with `reduction` and `representation`."
            raise InvalidInput(f"`free` must have constants among {', '.join(known)}; got {shown(name)}.{hint}")
    if len(set(free)) < len(free):
        raise InvalidInput(f"`free` must have each constant once; got {shown(list(free))}.")
    return list(free)


def get_constant(rotor: Rotor, name: str) -> float:
    """Return a constant [Hz], zero if the rotor does not have it."""
    return float(rotor.constants[AXES.index(name)]) if name in AXES else float(rotor.distortion.get(name, 0.0))


def find_tied(rotor: Rotor, name: str, free: Sequence[str]) -> list[str]:
    """Return the rotational constants tied to a free one: itself, and its equal in a symmetric top if that is not free.

    >>> find_tied(Rotor((9.0, 3.0, 3.0)), "B", ["B"]), find_tied(Rotor((9.0, 3.0, 3.0)), "B", ["B", "C"])
    (['B', 'C'], ['B'])
    """
    return [axis for axis in AXES if axis == name or ({axis, name} <= set(rotor.equal) and axis not in free)]


def once_each(rotor: Rotor, names: Sequence[str]) -> list[str]:
    """Return names of constants without those tied to an earlier one, as C is to B in a symmetric top.

    >>> once_each(Rotor((9.0, 3.0, 3.0)), ["A", "B", "C"]), once_each(Rotor((9.0, 3.0, 3.0)), ["C", "B"])
    (['A', 'B'], ['C'])
    """
    first = next((name for name in names if name in rotor.equal), None)
    return [name for name in names if name not in rotor.equal or name == first]


class _Block(NamedTuple):
    """One block: (p, bands, k, k) lower bands of each constant, those of the rest, and the levels that are asked."""

    of_constants: Float64[Array, "p bands k"]
    rest: Float64[Array, "bands k"]
    rows: Integer[Array, "m"]
    places: Integer[Array, "m"]


class LevelModel:
    """Energies of chosen levels of a rotor as a function of some of its constants.

    Args:
        rotor: its other constants stay.
        names: the constants.
        labels: (n, 3) J, K_a, K_c.
    """

    def __init__(self, rotor: Rotor, names: list[str], labels: Integer[Array, "n 3"]) -> None:
        representation = rotor.representation or RIGID
        together = {name: find_tied(rotor, name, names) if name in AXES else [name] for name in names}
        terms = [[one for each in together[name] for one in _make_terms(rotor, each)] for name in names]
        moved = {each for names in together.values() for each in names}
        rest = [
            (value * part, term)
            for name in (*AXES, *rotor.distortion) if name not in moved
            for value in [get_constant(rotor, name)] for part, term in _make_terms(rotor, name)
        ]
        self.count, self.size, self._blocks = len(labels), len(names), []
        for J in np.unique(labels[:, 0]).tolist():
            for block in wang.blocks(J):
                Ka, Kc = wang.labels(J, block, representation)
                place = {pair: k for k, pair in enumerate(zip(Ka.tolist(), Kc.tolist(), strict=True))}
                wanted = [(k, place[a, c]) for k, (j, a, c) in enumerate(labels.tolist()) if j == J and (a, c) in place]
                if wanted:
                    own = np.stack([_wide(wang.band(some, J, block)) for some in terms])
                    rows, places = np.array(wanted).T
                    self._blocks.append(_Block(own, _wide(wang.band(rest, J, block)), rows, places))

    def __call__(self, values: Float64[Array, "p"]) -> tuple[Float64[Array, "n"], Float64[Array, "n p"]]:
        """Return energies (n,) [Hz] and their derivatives by the constants (n, p)."""
        energy, slope = np.empty(self.count), np.empty((self.count, self.size))
        for block in self._blocks:
            levels, vectors = wang.eigenvectors(block.rest + np.tensordot(values, block.of_constants, 1))
            states = vectors[:, block.places]
            energy[block.rows] = levels[block.places]
            # ψᵀ B ψ of a symmetric band: the diagonal once, each band below it twice
            total = block.of_constants[:, 0] @ states**2
            for n in range(1, min(block.of_constants.shape[1], len(states))):
                total += 2.0 * block.of_constants[:, n, :-n] @ (states[:-n] * states[n:])
            slope[block.rows] = total.T
        return energy, slope


def _make_terms(rotor: Rotor, name: str) -> list[tuple[float, Term]]:
    """Return ∂H/∂p."""
    if name in AXES:
        unit = [float(name == axis) for axis in AXES]
        return rigid_terms((unit[0], unit[1], unit[2]), rotor.representation or RIGID)
    assert rotor.reduction is not None  # a rotor with distortion has one
    return [(1.0, TERMS[rotor.reduction][name])]


def _wide(rows: Float64[Array, "bands k"]) -> Float64[Array, "5 k"]:
    """Return bands with rows for J±⁸, the most that a term has."""
    return np.concatenate([rows, np.zeros((5 - len(rows), rows.shape[1]))])
