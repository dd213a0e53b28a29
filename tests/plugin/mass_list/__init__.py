"""A format of bodies of another package: a mass [kg] and its place x, y, z [m] a line."""

from __future__ import annotations

from pathlib import Path

from polhode.bodies import Body
from polhode.errors import FormatError
from polhode.formats import BodyFile


def read(path: Path, link: str | None, digits: int | None) -> Body:
    """Return all masses together, each a point."""
    import numpy as np

    rows = np.loadtxt(path, ndmin=2)
    if rows.shape[1] != 4 or len(rows) < 3:
        raise FormatError(f"{path}: must have three masses or more, each with x, y, z; got {rows.shape[0]} lines of "
                          f"{rows.shape[1]} numbers. Check the columns.")  # fmt: skip
    mass = rows[:, 0].sum()
    centre = rows[:, 0] @ rows[:, 1:] / mass
    arms = rows[:, 1:] - centre
    products = (rows[:, 0, None] * arms).T @ arms
    return Body(float(mass), centre, np.trace(products) * np.eye(3) - products)


BODY_FILE = BodyFile(read)
