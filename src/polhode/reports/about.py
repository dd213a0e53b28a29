"""Answers that reports of several kinds give: a body, verdicts, and how good the motion is."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from polhode.bodies.body import Body
from polhode.motion._trajectory import Trajectory
from polhode.reports.answer import Answer, Group, Table
from polhode.reports.wording import distinct, drifts, vector
from polhode.types import Array, Float64

if TYPE_CHECKING:
    from polhode.analysis._conserved_function import ConservedFunction
    from polhode.analysis.energy_casimir import Stability

GIVEN = "  (given axes)"


def about_body(body: Body, of_moments: str = "") -> Group:
    """Return the mass properties.

    Args:
        body: the body described.
        of_moments: a further explanation of the principal moments and axes.
    """
    size = math.sqrt(max(body.principal_moments)) / math.sqrt(body.mass) if body.mass else 0.0
    center, moments = body.center_of_mass, body.principal_moments
    return Group("Body", [
        Answer("mass", body.mass, "kg", "mass"),
        Answer("center_of_mass", center, "m", "centre of mass", "given axes", vector(center, "m", size)),
        Answer("principal_moments", moments, "kg m²", "principal moments", of_moments, distinct(moments, "kg m²")),
        *([Answer("inertial_defect", body.inertial_defect, "kg m²")] if body.inertial_defect > 0.0 else []),
        *_about_inertia(body),
        *about_axes("principal_axes", body.principal_axes, of_moments),
    ])


def _about_inertia(body: Body) -> list[Answer]:
    """Return the inertia about the centre of mass along the given axes; lines only where it is not diagonal."""
    whole = Answer("inertia", body.inertia, "kg m²", "", "about the centre of mass, given axes")
    if not (np.asarray(body.inertia) - np.diag(np.diag(body.inertia))).any():
        return [whole]
    size = float(np.abs(body.inertia).max())
    rows = {f"inertia, row {x}": vector(row, "kg m²", size) + GIVEN for x, row in zip("xyz", body.inertia, strict=True)}
    return [whole, *(Answer("", None, "", label, "", words) for label, words in rows.items())]


def about_place(body: Body, label: str, point: Float64[Array, "3"], direction: Float64[Array, "3"] | None) -> Group:
    """Return the inertia about a point, along the given axes, and the moment about an axis through it.

    Args:
        body: with its mass.
        label: of the place, for people.
        point: (3,) [m, given axes].
        direction: (3,) unit vector of the axis; None for the moments about all three given axes.
    """
    inertia = body.about(point)
    size = float(np.abs(inertia).max())
    rows = {f"inertia, row {x}": vector(row, "kg m²", size) + GIVEN for x, row in zip("xyz", inertia, strict=True)}
    if direction is None:
        moments = np.diag(inertia)
        words = vector(moments, "kg m²", size)
        moments_there = [Answer("about.moments", moments, "kg m²", "moments about x, y, z there", "", words)]
    else:
        moment = float(direction @ inertia @ direction)
        # √(J/m): the distance at which a point of this mass has this moment
        radius = math.sqrt(max(moment, 0.0)) / math.sqrt(body.mass or math.inf)
        moments_there = [
            Answer("about.direction", direction, "", "along", "given axes", vector(direction)),
            Answer("about.moment", moment, "kg m²", "moment about that axis"),
            Answer("about.radius_of_gyration", radius, "m", "radius of gyration"),
        ]
    return Group(f"About {label}", [
        Answer("about.point", point, "m", "through", "given axes", vector(point, "m")),
        *moments_there,
        Answer("about.inertia", inertia, "kg m²", "", "about that point, given axes"),
        *(Answer("", None, "", words, "", row) for words, row in rows.items()),
    ])


def about_axes(name: str, axes: Float64[Array, "3 3"], explanation: str = "") -> list[Answer]:
    """Return axes, which are columns, with a line each."""
    columns = enumerate(zip(*axes.tolist(), strict=True))
    lines = [Answer("", None, "", f"principal axis {k + 1}", "", vector(column) + GIVEN) for k, column in columns]
    said = ", ".join(filter(None, ("columns, in the given frame", explanation)))
    return [Answer(name, axes, "", "", said), *lines]


def motion_error(trajectory: Trajectory) -> float | None:
    """Return the error of quantities computed from a motion's states, as an ``Answer`` has it."""
    if trajectory.motion is not None:  # in closed form
        return 0.0
    return None if trajectory.error_estimate is None else float(trajectory.error_estimate)


def from_motion(trajectory: Trajectory, answers: Iterable[Answer]) -> list[Answer]:
    """Return answers that come from the states of a motion after its start, with the error of these."""
    error = motion_error(trajectory)
    return [answer._replace(error=error) for answer in answers]


def accuracy(trajectory: Trajectory, label: str = "drift") -> list[Answer]:
    """Return how well the motion conserves its invariants, the estimated error of its states, and its plan."""
    error = motion_error(trajectory)
    if error is None:
        words = "none was made; numbers from the motion have three digits at most"
    elif not math.isfinite(error):
        words = "not known: further runs came elsewhere, or failed"
    else:
        words = f"{error:.1e}" if error else None
    return [
        Answer("", None, "", label, "", drifts(trajectory.drift)),
        Answer("", None, "", "state error estimate, relative", "", words),
        Answer("", None, "", "plan", "", None if trajectory.plan is None else str(trajectory.plan)),
    ]


def stability_values(stability: Stability) -> dict[str, Any]:
    """Return a verdict as values by name."""
    return {
        "verdict": stability.verdict,
        "rate": stability.rate,
        "growth": stability.growth,
        "direction": stability.direction,
        "exponents": [[float(x.real), float(x.imag)] for x in stability.spectrum],
        "because": stability.words,
        "certificate": stability.certificate,
        "reason": stability.reason.values,
        "restriction": stability.restriction,
        "missing_casimirs": None if stability.missing is None else vars(stability.missing),
        "function": None if stability.function is None else _function_values(stability.function),
    }


def _function_values(function: ConservedFunction) -> dict[str, Any]:
    """Return a function of conserved quantities as values by name; coefficients by the names of the quantities."""
    pairs = zip(("H", *function.names), function.weights, strict=True)
    squares = np.zeros(len(function.names)) if function.squares is None else function.squares
    lengths = np.ones(len(function.names)) if function.lengths is None else function.lengths
    return {
        "weights": dict(pairs),
        "squares": {
            name: {"weight": square, "length": length * function.unit}
            for name, square, length in zip(function.names, squares, lengths, strict=True) if square
        },
        "signature": dict(zip(("positive", "zero", "negative"), function.signature, strict=True)),
        "margin": function.margin,
        "freedom": function.freedom,
        "point": function.point,
    }  # fmt: skip


def about_stability(name: str, stability: Stability) -> list[Answer]:
    """Return one verdict, without lines of its own."""
    return [
        Answer(f"{name}.{key}", value, "1/s" if key in ("rate", "exponents") else "")
        for key, value in stability_values(stability).items()
    ]


def verdicts(
    name: str, title: str, head: str, cell: Callable[[dict[str, Any]], str], rows: Sequence[dict[str, Any]],
    units: dict[str, str] | None = None, key: str = "", more: dict[str, Callable[[dict[str, Any]], str]] | None = None,
) -> Table:
    """Return a table of verdicts, one row for each subject.

    Args:
        name: in the JSON.
        title: above the table.
        head: heading of the column that names the subject of each verdict.
        cell: that column, from the values of a row.
        rows: the values, those of ``stability_values`` among them.
        units: of the values, that of the rate apart.
        key: value by which the JSON has the rows; empty for a list.
        more: columns next to the first, as ``Table`` has them.
    """
    columns = {head: cell, **(more or {}), "verdict": _verdict, "rate": _rate, "because": lambda row: row["because"]}
    proof = {"certificate": lambda row: row["certificate"]}
    return Table(name, title, columns, rows, {"rate": "1/s", **(units or {})}, key, proofs=proof)


def _verdict(row: dict[str, Any]) -> str:
    return row["verdict"] + (f" ({row['growth']})" if row["growth"] == "linear" else "")


def _rate(row: dict[str, Any]) -> str:
    return f"{row['rate']:.4g} /s" if row["rate"] else "–"


def about_orbital_rests(moments: Float64[Array, "3"], mean_motion: float) -> Table:
    """Return how a body can rest in the frame of its circular orbit, six ways of four attitudes each."""
    from polhode.analysis.gravity_gradient import orbital_equilibria

    rows = [{
        "radius": one.yaw, "velocity": one.roll, "normal": one.pitch, "region": one.region,
        "pitch_period": None if one.pitch_rate is None else 2.0 * math.pi / one.pitch_rate, "growth": one.growth,
        "roll_yaw_rates": None if one.roll_yaw_rates is None else list(one.roll_yaw_rates),
    } for one in orbital_equilibria(moments, mean_motion)]
    columns = {
        "axes": lambda row: f"{row['radius']}, {row['velocity']}, {row['normal']}",
        "region": lambda row: row["region"],
        "pitch": lambda row: "–" if row["pitch_period"] is None else f"{row['pitch_period']:.6g} s",
        "roll and yaw": lambda row: "–" if row["roll_yaw_rates"] is None else " and ".join(
            "free" if rate == 0.0 else f"{2.0 * math.pi / rate:.6g} s" for rate in row["roll_yaw_rates"]),
        "leaves in": lambda row: "–" if not row["growth"] else f"{1.0 / row['growth']:.4g} s",
    }  # fmt: skip
    title = "Rest in the orbit's frame by gravity, axes along radius, velocity and normal, with periods of libration"
    units = {"pitch_period": "s", "roll_yaw_rates": "rad/s", "growth": "1/s"}
    return Table("orbital_rests", title, columns, rows, units)
