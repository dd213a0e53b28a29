"""From the tables of a spec to a body and its spin."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from pathlib import Path

import numpy as np
from pydantic import ValidationError

from polhode import rotation
from polhode.bodies._inertia import MassProperties
from polhode.bodies.body import Body
from polhode.errors import FormatError, InvalidInput
from polhode.spec.body_files import read_body_file
from polhode.spec.built import BuiltBody
from polhode.spec.mistakes import as_message, list_mistakes
from polhode.spec.models import BodyTable, SpinTable
from polhode.spec.parsing import read_tables
from polhode.spec.rules import find_broken_body_rules
from polhode.special._circular import cosine_and_sine
from polhode.types import Array, Float64


def build_body(table: BodyTable, folder: Path, file: Path | None = None) -> BuiltBody:
    """Return the body; paths count from the folder.

    Args:
        table: of the body.
        folder: of its spec.
        file: the spec itself, where it is known, so that no spec can be part of itself.

    Raises:
        InvalidInput: for values that no body has.
        FormatError: for files of another format.
    """
    return _Files().build(table, folder, () if file is None else (file.resolve(),))


def build_part_of(table: BodyTable, number: int, folder: Path) -> Body | MassProperties:
    """Return the mass properties of one part alone, in its place; of a cut, those of the removed material.

    Raises:
        InvalidInput, FormatError: as ``build_body`` does.
    """
    from polhode.spec.assembly import build_part

    files, part = _Files(), (table.part or [])[number]
    density = table.density or 1.0  # of a cut that leaves it to the others, whose centre of mass does not depend on it
    return build_part(part, density, folder, lambda path: files.read(path, ())).properties


def read_body_table(path: Path) -> BodyTable:
    """Return the table [body] of a spec, of which nothing else is read.

    Raises:
        InvalidInput: naming the file and every mistake in that table.
        FormatError: if the file is not TOML.
    """
    tables = read_tables(path)
    body = tables.get("body")
    if not isinstance(body, dict):
        raise InvalidInput(f"{path}: has no [body], so that it cannot be part of another one")
    mistakes, table = list(find_broken_body_rules(body)), None
    try:
        table = BodyTable.model_validate(body)
    except ValidationError as error:
        mistakes += list_mistakes(error, BodyTable, ("body",))
    if table is None or mistakes:
        raise InvalidInput(*as_message(path, mistakes))
    return table


class _Files:
    """The specs that a body is made of, each read and built once."""

    def __init__(self) -> None:
        self.built: dict[Path, BuiltBody] = {}

    def build(self, table: BodyTable, folder: Path, above: tuple[Path, ...]) -> BuiltBody:
        """Return the body; ``above`` are the specs that it is part of, and its own."""
        if table.part is not None:
            from polhode.spec.assembly import build_assembly

            return build_assembly(table.part, table.density, folder, lambda path: self.read(path, above))
        if table.mesh is not None:
            from polhode.formats.mesh import body_of_mesh, load_mesh

            read = load_mesh(folder / table.mesh, table.mesh_unit, table.repair)
            with _of_file("mesh", table.mesh):
                body = body_of_mesh(read, table.mass, table.density, several=table.several, repaired=table.repair)
            return BuiltBody(body, tuple(f"mesh {table.mesh}: {note}" for note in read.notes))
        if table.moments is not None or table.inertia is not None:
            from polhode.spec.known_inertia import build_known

            return build_known(table)
        return BuiltBody(_of_molecule_or_file(table, folder))

    def read(self, path: Path, above: tuple[Path, ...]) -> BuiltBody:
        place = path.resolve()
        if place in above:
            chain = " → ".join(one.name for one in (*above[above.index(place) :], place))
            raise InvalidInput(f"is part of itself: {chain}. Leave one of these parts out")
        if place not in self.built:
            table = read_body_table(path)
            try:
                self.built[place] = self.build(table, path.parent, (*above, place))
            except InvalidInput as error:
                kind = FormatError if isinstance(error, FormatError) else InvalidInput
                raise kind(f"{path}: {error}") from None
        return self.built[place]


def _of_molecule_or_file(table: BodyTable, folder: Path) -> Body:
    if table.rotational_constants is not None:
        try:
            return Body.from_rotational_constants(
                *table.rotational_constants, mass=table.mass, effective=table.allow_vibration
            )
        except InvalidInput as error:
            remedy = " Constants of a flat molecule that vibrates may: set allow_vibration = true to take them."
            raise InvalidInput(f"{error}{'' if table.allow_vibration else remedy}") from None
    if table.molecule is not None:
        from polhode.formats.molecule import read_molecule

        atoms = read_molecule(folder / table.molecule)
        with _of_file("molecule", table.molecule):
            return Body.from_atoms(*atoms)
    if table.file is not None:
        key, name = table.file
        return read_body_file(key, folder / name, table.link, table.joints, table.rounding)
    raise AssertionError("the rules let a body have one source")


@contextlib.contextmanager
def _of_file(kind: str, name: str) -> Iterator[None]:
    try:
        yield
    except InvalidInput as error:
        raise InvalidInput(f"{kind} {name}: {error}") from None


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
        from polhode.analysis.thermal import thermal_momentum

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
    direction[..., index], direction[..., (index + 1) % 3] = cosine_and_sine(tilt)
    direction = direction if isinstance(about, int) else _components(direction, axes)
    return compute_momentum(moments, rate[..., None] * direction), attitude


def build_coning(
    table: SpinTable, moments: Float64[Array, "3"], axes: Float64[Array, "3 3"]
) -> tuple[Float64[Array, "3"], Float64[Array, "4"]]:
    """Return momentum (3,) along, and attitude (4,) of, the principal axes of a symmetric body that cones steadily.

    Raises:
        InvalidInput: for another body, and for rates that no coning has.
    """
    from polhode.analysis.coning import coning_momentum

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
                           "numbers. Check the rate and its unit.")
    return momentum
