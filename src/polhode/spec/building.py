"""From the tables of a spec to a body and its spin."""

from __future__ import annotations

import contextlib
import math
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from polhode import rotation
from polhode.analysis.coning import coning_momentum
from polhode.analysis.thermal import thermal_momentum
from polhode.bodies import shapes
from polhode.bodies.body import Body, combine
from polhode.errors import InvalidInput
from polhode.formats.mesh import read_mesh
from polhode.formats.molecule import read_molecule
from polhode.formats.urdf import read_urdf_inertial
from polhode.spec.models import SHAPE_KEYS, BodyTable, PartTable, SpinTable
from polhode.types import Array, Float64

TURNS = {"z": np.eye(3), "x": np.eye(3)[[2, 0, 1]], "y": np.eye(3)[[1, 2, 0]]}
TURNS |= {f"-{axis}": turn * [1.0, -1.0, -1.0] for axis, turn in TURNS.items()}


def build_body(table: BodyTable, folder: Path) -> Body:
    """Return the body; paths count from the folder.

    Raises:
        InvalidInput: for values that no body has.
        FormatError: for files that are not what they should be.
    """
    if table.mesh is not None:
        vertices, faces = read_mesh(folder / table.mesh, table.mesh_unit or 1.0, table.repair)
        with _of_file("mesh", table.mesh):
            return Body.from_mesh(
                vertices, faces, mass=table.mass, density=table.density, several=table.several, repair=table.repair
            )
    if table.moments is not None:
        return Body.from_moments(*table.moments, mass=table.mass)
    if table.inertia is not None:
        return Body(table.mass, (0.0, 0.0, 0.0), table.inertia)
    if table.rotational_constants is not None:
        try:
            return Body.from_rotational_constants(
                *table.rotational_constants, mass=table.mass, effective=table.allow_vibration
            )
        except InvalidInput as error:
            remedy = " Constants of a flat molecule that vibrates may: set allow_vibration = true to take them."
            raise InvalidInput(f"{error}{'' if table.allow_vibration else remedy}") from None
    if table.molecule is not None:
        atoms = read_molecule(folder / table.molecule)
        with _of_file("molecule", table.molecule):
            return Body.from_atoms(*atoms)
    if table.urdf is not None:
        return read_urdf_inertial(folder / table.urdf, table.link)
    return combine([build_part(part) for part in table.parts or []])


@contextlib.contextmanager
def _of_file(kind: str, name: str) -> Iterator[None]:
    try:
        yield
    except InvalidInput as error:
        raise InvalidInput(f"{kind} {name}: {error}") from None


def build_part(table: PartTable) -> Body:
    """Return one homogeneous part in its place.

    Raises:
        InvalidInput: for measures that do not fit each other.
    """
    measures = {name: getattr(table, name) for name in SHAPE_KEYS[table.shape]}
    if table.inner_radius is not None:
        measures["inner_radius"] = table.inner_radius
    return getattr(shapes, table.shape)(table.mass, **measures).placed(TURNS[table.axis], table.at)


def build_spin(
    table: SpinTable | None, moments: Float64[Array, "*#body 3"], axes: Float64[Array, "*#body 3 3"]
) -> tuple[Float64[Array, "*spin 3"], Float64[Array, "*turn 4"]]:
    """Return momentum (…, 3) along and attitude (…, 4) of principal axes (…, 3, 3) with their moments (…, 3).

    Fields of the table may be arrays too, of as many spins (N,) as there are, vectors (N, 3): a momentum is not finite
    where the numbers of one among many are beyond their range.

    Raises:
        InvalidInput: for a momentum beyond the range of numbers.
    """
    start = (1.0, 0.0, 0.0, 0.0) if table is None else table.attitude
    attitude = rotation.multiply(rotation.normalize(start), rotation.from_matrix(axes))
    if table is not None and table.temperature is not None:
        return thermal_momentum(moments, table.temperature), attitude
    ways = () if table is None else (table.momentum, table.angular_velocity, table.rate)
    if table is None or all(way is None for way in ways):
        return np.zeros(3), attitude
    if table.momentum is not None or table.angular_velocity is not None:
        vector = np.asarray(table.momentum if table.momentum is not None else table.angular_velocity, dtype=float)
        vector = vector if table.frame == "principal" else _components(vector, axes)
        return vector if table.momentum is not None else compute_momentum(moments, vector), attitude
    about = table.about
    index = about - 1 if isinstance(about, int) else "xyz".index(str(about))
    rate, tilt = np.broadcast_arrays(np.asarray(table.rate, dtype=float), np.asarray(table.tilt, dtype=float))
    direction = np.zeros((*rate.shape, 3))
    direction[..., index], direction[..., (index + 1) % 3] = _cosine_and_sine(tilt)
    direction = direction if isinstance(about, int) else _components(direction, axes)
    return compute_momentum(moments, rate[..., None] * direction), attitude


def build_coning(
    table: SpinTable, moments: Float64[Array, "3"], axes: Float64[Array, "3 3"]
) -> tuple[Float64[Array, "3"], Float64[Array, "4"]]:
    """Return momentum (3,) along, and attitude (4,) of, the principal axes of a symmetric body that cones steadily.

    Raises:
        InvalidInput: for another body, and for rates that no coning has.
    """
    precession = None if table.precession is None else float(table.precession)
    attitude = rotation.multiply(rotation.normalize(table.attitude), rotation.from_matrix(axes))
    return coning_momentum(moments, table.nutation, table.spin, precession), attitude


def _components(vector: Array, axes: Array) -> Array:
    """Return vectors (…, 3) along axes by columns (…, 3, 3)."""
    return (vector[..., None, :] @ axes)[..., 0, :]


def compute_momentum(
    moments: Float64[Array, "*#batch 3"], velocity: Float64[Array, "*#batch 3"]
) -> Float64[Array, "*batch 3"]:
    """Return the momentum (…, 3) of an angular velocity (…, 3) along the principal axes.

    Raises:
        InvalidInput: where it is beyond the range of numbers; one among many is not finite then.
    """
    with np.errstate(over="ignore", under="ignore"):
        momentum = moments * velocity
    if momentum.ndim == 1 and not np.isfinite(momentum).all():
        rates = ", ".join(f"{x:.3g}" for x in velocity)
        raise InvalidInput(f"the spin ({rates}) rad/s along the principal axes gives a momentum beyond the range of "
                           "numbers. Check the rate and its unit.")  # fmt: skip
    return momentum


def _cosine_and_sine(angle: Array) -> tuple[Array, Array]:
    """Return both, exact for whole quarter turns, whose angle itself is not."""
    quarters = angle / (0.5 * math.pi)
    nearest = np.round(quarters)
    whole = (nearest != 0.0) & (np.abs(quarters - nearest) <= 4.0 * np.finfo(float).eps * np.abs(quarters))
    k = (nearest % 4.0).astype(int)
    cosine, sine = np.array([1.0, 0.0, -1.0, 0.0])[k], np.array([0.0, 1.0, 0.0, -1.0])[k]
    return np.where(whole, cosine, np.cos(angle)), np.where(whole, sine, np.sin(angle))
