"""Components of an algebra that are an so(3): they turn a body, whose attitude then goes with the motion."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from polhode.errors import InvalidInput, shown
from polhode.motion._layout import MOMENTUM, StatePart
from polhode.types import Array, Float64

LEVI_CIVITA = np.zeros((3, 3, 3))
for _i in range(3):
    LEVI_CIVITA[_i, _i - 2, _i - 1], LEVI_CIVITA[_i, _i - 1, _i - 2] = 1.0, -1.0


def check_rotations(constants: Float64[Array, "dim dim dim"], rotations: Sequence[int]) -> tuple[int, ...]:
    """Return the components that are an so(3) as a tuple.

    Args:
        constants: of the algebra, [e_i, e_j] = Σ_k c_ijk e_k.
        rotations: three components one behind the other, like (3, 4, 5); none for no attitude.

    Raises:
        InvalidInput: for other components, and where their brackets are not [e_i, e_j] = ε_ijk e_k; the first that is
            not is named.
    """
    c = np.asarray(constants)
    try:
        named = tuple(int(k) for k in rotations)
        fits = not named or (named == tuple(range(named[0], named[0] + 3)) and 0 <= named[0] <= len(c) - 3)
        fits = fits and named == tuple(rotations)
    except (TypeError, ValueError):
        fits, named = False, ()
    if not fits:
        raise InvalidInput(f"`rotations` must be three components one behind the other, from (0, 1, 2) on, of the "
                           f"{len(c)} that the algebra has; got {shown(rotations)}.")
    if not named:
        return ()
    place = slice(named[0], named[0] + 3)
    wanted = np.zeros((3, 3, len(c)))
    wanted[:, :, place] = LEVI_CIVITA
    # exactly: what is an so(3) up to a factor has another angular velocity
    if wrong := np.argwhere(c[place, place] != wanted).tolist():
        i, j, _ = (int(k) for k in wrong[0])
        said = [f"{x:g} e_{k}" for k, x in enumerate(c[place, place][i, j]) if x]
        i, j, first = i + named[0], j + named[0], named[0]
        raise InvalidInput(
            f"`rotations` must be components whose brackets are those of so(3), [e_{first}, e_{first + 1}] = "
            f"e_{first + 2} and so on; here [e_{i}, e_{j}] = {' + '.join(said) or '0'}, counted from 0. Name "
            "others, or change the basis."
        )
    return named


def parts_of_point(size: int, rotations: tuple[int, ...]) -> tuple[StatePart, ...]:
    """Return the parts of a point of the dual: the momentum of an so(3) in it, and what is before and behind."""
    if not rotations:
        return (StatePart("point", size),)
    beside = "components of the point beside the angular momentum"
    before = StatePart("point_before", rotations[0], "", beside)
    behind = StatePart("point_behind", size - rotations[2] - 1, "", beside)
    return tuple(part for part in (before, MOMENTUM, behind) if part.size)


def turns_alone(constants: Float64[Array, "dim dim dim"], rotations: tuple[int, ...]) -> bool:
    """Return whether all other components commute with the so(3), so that nothing but Ω turns its momentum."""
    others = np.setdiff1d(np.arange(len(constants)), rotations)
    return not np.asarray(constants)[np.ix_(others, np.array(rotations))].any()


def others_are_an_ideal(constants: Float64[Array, "dim dim dim"], rotations: tuple[int, ...]) -> bool:
    """Return whether brackets with the other components have no part in the so(3), which is a quotient then.

    The attitude is then the image of the group element; else it is a frame that turns with Ω beside it.
    """
    others = np.setdiff1d(np.arange(len(constants)), rotations)
    return not np.asarray(constants)[others][:, :, list(rotations)].any()
