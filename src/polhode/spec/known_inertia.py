"""Bodies of known moments or a known inertia tensor, about any point, perhaps rounded."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from polhode.bodies._inertia import digits_that_explain, point_inertia, take_rounded
from polhode.bodies.body import Body
from polhode.errors import InvalidInput
from polhode.spec.built import BuiltBody
from polhode.spec.models import BodyTable, PartTable
from polhode.types import Array, Float64


class InertiaLimits(NamedTuple):
    """A number beyond which an inertia tensor is refused."""

    max_asymmetry: float = 1e-9  # of the largest entry; the body refuses more


LIMITS = InertiaLimits()


def build_known(table: BodyTable | PartTable) -> BuiltBody:
    """Return the body of a table with ``inertia`` or ``moments``, about its centre of mass or about ``about``.

    Raises:
        InvalidInput: for a tensor that no body has, with the remedy where rounding explains it.
    """
    center = np.zeros(3) if table.center_of_mass is None else np.asarray(table.center_of_mass)
    moments = table.moments if isinstance(table, BodyTable) else None
    given = np.diag(moments) if moments is not None else np.asarray(table.inertia, dtype=float)
    inertia = given
    if table.about is not None and table.mass is not None:
        # J about a point is J about the centre of mass and m (|d|² 1 − d dᵀ)
        with np.errstate(over="ignore", invalid="ignore"):
            inertia = given - table.mass * point_inertia(center - np.asarray(table.about))
        if not np.isfinite(inertia).all():
            away = ", ".join(f"{x:g}" for x in table.about)
            raise InvalidInput(f"inertia about ({away}) m gives moments beyond the range of numbers. Check its unit.")
        _check_about(table, given, inertia, center)
    largest = np.abs(inertia).max()
    if not np.isfinite(inertia).all() or np.abs(inertia - inertia.T).max() > LIMITS.max_asymmetry * largest:
        return BuiltBody(Body(table.mass, center, inertia))
    inertia = 0.5 * inertia + 0.5 * inertia.T
    if table.rounding is not None:
        near = take_rounded(inertia, table.rounding, given)
        return BuiltBody(Body(table.mass, center, near), _said(inertia, near, table.rounding))
    try:
        return BuiltBody(Body(table.mass, center, inertia))
    except InvalidInput as error:
        digits = digits_that_explain(inertia, given)
        remedy = f' Rounding to {digits} digits explains it: say rounding = "{digits} digits" to take the nearest ones.'
        raise InvalidInput(f"{error}{remedy if digits else ''}") from None


def _check_about(
    table: BodyTable | PartTable, given: Float64[Array, "3 3"], inertia: Float64[Array, "3 3"],
    center: Float64[Array, "3"],
) -> None:
    """Refuse an inertia about a point that is less than that of the mass concentrated at its centre."""
    assert table.about is not None and table.mass is not None
    least, size = (np.linalg.eigvalsh(0.5 * one + 0.5 * one.T) for one in (inertia, given))
    # a little less may be rounding of the typed numbers, which the body's own error covers
    if size[0] > 0.0 and least[0] < -1e-3 * size[2]:
        distance = float(np.linalg.norm(center - np.asarray(table.about)))
        raise InvalidInput(
            f"the inertia about the given point is less than that of the mass alone there, m d² = {table.mass:g} kg × "
            f"({distance:.4g} m)² = {table.mass * distance**2:.4g} kg m². Check mass, center_of_mass and about."
        )


def _said(inertia: Float64[Array, "3 3"], near: Any, digits: int) -> tuple[str, ...]:
    """Return the note on a tensor that was replaced by a near one; nothing where it stays."""
    if near is inertia:
        return ()
    (I1, I2, I3), change = np.linalg.eigvalsh(inertia), np.linalg.norm(near - inertia)
    below = f"have I₁ = {I1:.3g} kg m² below zero"
    miss = below if I1 < 0.0 else f"miss I₁ + I₂ ≥ I₃ by {(I3 - I1 - I2) / I3:.2g} of I₃"
    taken = ", ".join(f"{x:.9g}" for x in np.linalg.eigvalsh(near))
    text = (
        f"the moments of inertia as given {miss}, which rounding to {digits} digits explains; in their place is "
        f"the nearest tensor that a body can have, {change:.2g} kg m² away, with the moments ({taken}) kg m²."
    )
    return (text,)
