"""``polhode import FILE``: an attitude history of another tool as a dataset."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from polhode import rotation
from polhode.analysis.mechanics import Mechanics, invariants_along
from polhode.bodies.frame import BodyFrame
from polhode.cli.destinations import check_spares
from polhode.cli.render import as_json, print_report
from polhode.cli.sources import KINDS, KINDS_IN_WORDS, Kernels, body_of, read_recorded
from polhode.errors import InvalidInput
from polhode.formats.labels import AttitudeLabels
from polhode.motion.layout import ATTITUDE, MOMENTUM, StateLayout
from polhode.motion.trajectory import Trajectory
from polhode.reports.base import Section, plain
from polhode.reports.wording import angle, counted, drifts, number, rate

Array = Any


def run_import(path: Path, json: bool, out: Path | None, spec: Path | None, kernels: Kernels) -> None:
    """Read the file, add momentum and energy where the spec tells the moments, and write and print what is there."""
    from polhode.formats.dataset import write_dataset

    kind, trajectory, labels = read_recorded(path, kernels)
    if kind in ("dataset", "csv"):
        raise InvalidInput(f"{path}: is {KINDS_IN_WORDS[kind]} of polhode's already; there is nothing to import.")
    assert labels is not None
    notes, frame, kept = [], None, "a free body's"
    if trajectory.outcome.message:
        notes.append(f"{trajectory.outcome.message}.")
    if spec is not None:
        body = body_of(spec)
        if (frame := body.frame) is None:
            raise InvalidInput(f"{spec}: has no [body], whose moments would be needed. Choose another spec.")
        trajectory = along_principal_axes(trajectory, frame, body.mechanics)
        if body.mechanics is None:
            notes.append("momentum and energy are left out: they are known here of free bodies and tops, and "
                         f"{spec} is of the system {body.kind}.")  # fmt: skip
        elif trajectory.momentum is None:
            notes.append("the file has no angular velocity, so that there is neither momentum nor energy.")
        elif body.mechanics.weight is not None:
            kept = "a top's"
    values = summary_values(trajectory, labels)
    written = out or Path(f"{path.stem}_imported.nc")  # not the name that a dataset exported beside it has
    check_spares(written, path)
    write_dataset(trajectory, written, {"title": labels.object_name}, frame)
    if json:
        print(as_json(plain({"kind": KINDS[kind], **values, "drift": trajectory.drift, "notes": notes,
                             "files": [str(written)]})))  # fmt: skip
        return
    sections = [Section("Attitude history", _lines(values, trajectory, kept))]
    summary = f"{KINDS[kind]} with {counted(values['samples'], 'attitude')}."
    print_report(str(path), summary, sections, notes, [str(written)])


def along_principal_axes(trajectory: Trajectory, frame: BodyFrame, mechanics: Mechanics | None) -> Trajectory:
    """Return a trajectory of the given axes along the principal ones, with momentum and invariants where these follow.

    Args:
        trajectory: along the given axes, read from a file.
        frame: the principal axes; its moments are about the point that the body turns about.
        mechanics: of the same body along the given axes; None where momentum is not the moments times the velocity.
    """
    axes = np.asarray(frame.axes)
    attitude = rotation.multiply(np.asarray(trajectory.attitude), rotation.from_matrix(axes))
    turned = replace(trajectory, attitude=attitude, states=attitude, layout=StateLayout((ATTITUDE,)))
    if trajectory.angular_velocity is None:
        return turned
    velocity = np.asarray(trajectory.angular_velocity) @ axes
    turned = replace(turned, angular_velocity=velocity)
    if mechanics is None:
        return turned
    momentum = velocity * np.asarray(frame.moments)
    invariants, drift = invariants_along(trajectory.attitude, np.asarray(trajectory.angular_velocity), mechanics)
    states = np.concatenate([attitude, momentum], axis=-1)
    return replace(turned, states=states, layout=StateLayout((ATTITUDE, MOMENTUM)), momentum=momentum,
                   invariants=invariants, drift=drift)


def summary_values(trajectory: Trajectory, labels: AttitudeLabels) -> dict[str, Any]:
    """Return what a file holds by name, SI."""
    times, attitude = np.asarray(trajectory.times), np.asarray(trajectory.attitude)
    steps, velocity = np.diff(times), trajectory.angular_velocity
    turns = rotation.angle_between(attitude[1:], attitude[:-1])
    several = len(times) > 1
    return {
        "object": labels.object_name, "object_id": labels.object_id, "reference_frame": labels.reference_frame,
        "body_frame": labels.body_frame, "epoch": labels.epoch, "time_system": labels.time_system,
        "first": times[0], "last": times[-1], "samples": len(times),
        "usual_step": np.median(steps) if several else None,
        "largest_gap": steps.max() if several else None,
        "gap_from": times[int(np.argmax(steps))] if several else None,
        "largest_turn": turns.max() if several else None,
        "has_angular_velocity": velocity is not None,
        "fastest": None if velocity is None else np.linalg.norm(np.asarray(velocity), axis=-1).max(),
    }  # fmt: skip


def _lines(values: dict[str, Any], trajectory: Trajectory, kept: str) -> list[tuple[str, str | None]]:
    gap = values["largest_gap"]
    return [
        ("object", ", ".join(filter(None, (values["object"], values["object_id"])))),
        ("frames", f"{values['body_frame']} (body) in {values['reference_frame']} (space)"),
        ("time zero", f"{values['epoch']} {values['time_system']}"),
        ("span", f"{values['first']:.9g} to {values['last']:.9g} s"),
        ("samples", str(values["samples"])),
        ("usual step", number(values["usual_step"], "s")),
        ("largest gap", None if gap is None else f"{gap:.8g} s, from {values['gap_from']:.9g} s on"),
        ("largest turn between samples", angle(values["largest_turn"])),
        ("angular velocity", "none in the file" if values["fastest"] is None else f"up to {rate(values['fastest'])}"),
        (f"drift of {kept} invariants", drifts(trajectory.drift) or None),
    ]
