"""``polhode import FILE``: an attitude history of another tool as a dataset."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from polhode import rotation
from polhode.analysis.mechanics import Mechanics, invariants_along
from polhode.cli.destinations import check_spares
from polhode.cli.render import as_json, print_report
from polhode.cli.sources import KINDS, KINDS_IN_WORDS, Kernels, body_of, read_recorded
from polhode.errors import InvalidInput
from polhode.formats.labels import AttitudeLabels
from polhode.motion.frame import BodyFrame
from polhode.motion.layout import ATTITUDE, MOMENTUM, StateLayout
from polhode.motion.trajectory import Trajectory
from polhode.reports.answer import Answer, Group, units_of, values_of
from polhode.reports.base import plain
from polhode.reports.wording import counted, drifts, rate


def run_import(path: Path, json: bool, out: Path | None, spec: Path | None, kernels: Kernels) -> None:
    """Read the file, add momentum and energy where the spec tells the moments, and write and print what is there."""
    from polhode.formats.dataset import write_dataset

    kind, trajectory, labels = read_recorded(path, kernels)
    if kind in ("dataset", "csv"):
        raise InvalidInput(f"{path}: is {KINDS_IN_WORDS[kind]} of polhode's already; there is nothing to import.")
    assert labels is not None
    notes, kept = [], "a free body's"
    if trajectory.outcome.message:
        notes.append(f"{trajectory.outcome.message}.")
    if spec is not None:
        body = body_of(spec)
        if body.frame is None:
            raise InvalidInput(f"{spec}: has no [body], whose moments would be needed. Choose another spec.")
        trajectory = along_principal_axes(trajectory, body.frame, body.mechanics)
        if body.mechanics is None:
            notes.append("momentum and energy are left out: they are known here of free bodies and tops, and "
                         f"{spec} is of the system {body.kind}.")  # fmt: skip
        elif trajectory.momentum is None:
            notes.append("the file has no angular velocity, so that there is neither momentum nor energy.")
        elif body.mechanics.weight is not None:
            kept = "a top's"
    found = about_file(trajectory, labels, kept)
    written = out or Path(f"{path.stem}_imported.nc")  # not the name that a dataset exported to the same folder has
    check_spares(written, path)
    write_dataset(trajectory, written, {"title": labels.object_name})
    if json:
        print(as_json(plain({"kind": KINDS[kind], **values_of([found]), "drift": trajectory.drift, "notes": notes,
                             "units": units_of([found]), "files": [str(written)]})))  # fmt: skip
        return
    summary = f"{KINDS[kind]} with {counted(len(trajectory.times), 'attitude')}."
    print_report(str(path), summary, [found], notes, [str(written)])


def along_principal_axes(trajectory: Trajectory, frame: BodyFrame, mechanics: Mechanics | None) -> Trajectory:
    """Return a trajectory of the given axes along the principal ones, with momentum and invariants where these follow.

    Args:
        trajectory: along the given axes, read from a file.
        frame: the principal axes; its moments are about the point that the body turns about.
        mechanics: of the same body along the given axes; None where momentum is not the moments times the velocity.
    """
    axes = np.asarray(frame.axes)
    attitude = rotation.multiply(np.asarray(trajectory.attitude), rotation.from_matrix(axes))
    layout = StateLayout((ATTITUDE,))
    turned = replace(trajectory, attitude=attitude, states=attitude, layout=layout, frame=frame)
    if trajectory.angular_velocity is None:
        return turned
    velocity = np.asarray(trajectory.angular_velocity) @ axes
    turned = replace(turned, angular_velocity=velocity)
    if mechanics is None:
        return turned
    momentum = velocity * np.asarray(frame.moments)
    invariants, drift = invariants_along(trajectory.attitude, np.asarray(trajectory.angular_velocity), mechanics)
    states = np.concatenate([attitude, momentum], axis=-1)
    return replace(
        turned,
        states=states,
        layout=StateLayout((ATTITUDE, MOMENTUM)),
        momentum=momentum,
        invariants=invariants,
        drift=drift,
    )


def about_file(trajectory: Trajectory, labels: AttitudeLabels, kept: str) -> Group:
    """Return what a file holds; ``kept`` says whose invariants the drift is of."""
    times, attitude = np.asarray(trajectory.times), np.asarray(trajectory.attitude)
    steps, velocity = np.diff(times), trajectory.angular_velocity
    turns = rotation.angle_between(attitude[1:], attitude[:-1])
    several = len(times) > 1
    gap = float(steps.max()) if several else None
    gap_from = float(times[int(np.argmax(steps))]) if several else None
    fastest = None if velocity is None else float(np.linalg.norm(np.asarray(velocity), axis=-1).max())
    return Group("Attitude history", [
        Answer("object", labels.object_name, "", "object", "",
               ", ".join(filter(None, (labels.object_name, labels.object_id)))),
        Answer("object_id", labels.object_id),
        Answer("reference_frame", labels.reference_frame, "", "frames", "",
               f"{labels.body_frame} (body) in {labels.reference_frame} (space)"),
        Answer("body_frame", labels.body_frame),
        Answer("epoch", labels.epoch, "", "time zero", "", f"{labels.epoch} {labels.time_system}"),
        Answer("time_system", labels.time_system),
        Answer("first", float(times[0]), "s", "span", "", f"{times[0]:.9g} to {times[-1]:.9g} s"),
        Answer("last", float(times[-1]), "s"),
        Answer("samples", len(times), "", "samples", "", str(len(times))),
        Answer("usual_step", float(np.median(steps)) if several else None, "s", "usual step"),
        Answer("largest_gap", gap, "s", "largest gap", "",
               None if gap is None else f"{gap:.8g} s, from {gap_from:.9g} s on"),
        Answer("gap_from", gap_from, "s"),
        Answer("largest_turn", float(turns.max()) if several else None, "rad", "largest turn between samples"),
        Answer("has_angular_velocity", velocity is not None),
        Answer("fastest", fastest, "rad/s", "angular velocity", "",
               "none in the file" if fastest is None else f"up to {rate(fastest)}"),
        Answer("", None, "", f"drift of {kept} invariants", "", drifts(trajectory.drift)),
    ])  # fmt: skip
