"""``polhode import FILE``: an attitude history of another tool as a dataset."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from polhode import rotation
from polhode.analysis._mechanics import Mechanics, invariants_along
from polhode.cli.column_options import ColumnOptions
from polhode.cli.columns import table_to_import
from polhode.cli.destinations import check_spares
from polhode.cli.publish import publish
from polhode.errors import InvalidInput, one_line
from polhode.formats.form import Kernels
from polhode.formats.form_registry import find_form, forms_that_end
from polhode.formats.labels import AttitudeLabels
from polhode.formats.stamps import in_words
from polhode.motion._layout import ANGULAR_VELOCITY, ATTITUDE, MOMENTUM, StateLayout
from polhode.motion._trajectory import Trajectory
from polhode.motion.frame import BodyFrame
from polhode.reports.answer import Answer, Group
from polhode.reports.report import PlainReport
from polhode.reports.wording import drifts, rate, write_count
from polhode.studies.recorded_spec import tells_spin, write_spec
from polhode.studies.sources import COUNTED_FROM, TABLE, find_begin, is_table, kind_in_words, load_body, read_recorded
from polhode.studies.tables import describe_reading, list_reading_notes

SPEC_ENDING, DATASET_ENDING = ".toml", ".nc"


def run_import(
    path: Path, json: bool, out: Path | None, spec: Path | None, kernels: Kernels, columns: ColumnOptions
) -> None:
    """Read the file, add momentum and energy where a spec gives the moments, write and print the result."""
    from polhode.formats.dataset import write_dataset

    if out is not None:
        check_spares(out, path)
        _check_ending(out)
    table = table_to_import(columns)
    kind, trajectory, labels = read_recorded(path, kernels, table)
    if table is not None and kind != TABLE:
        why = f"is {kind_in_words(kind)}, and the options of columns are for tables"
        raise InvalidInput(f"{path}: {why}. Leave them out.")
    if (form := find_form(kind)) is not None and form.is_own:
        raise InvalidInput(f"{path}: is {kind_in_words(kind)} of polhode's already; there is nothing to import.")
    notes, groups = [], []
    if is_table(kind):
        notes = list_reading_notes(trajectory, one_line(path.name))
        groups = [describe_reading(trajectory, "How the table is read", "read_as")]
    if trajectory.outcome.message:
        notes.append(f"{trajectory.outcome.message}.")
    kept = ""
    if spec is not None:
        trajectory, kept, more = _with_moments(trajectory, spec)
        notes += more
    elif trajectory.frame is not None:
        trajectory = _with_body(trajectory, trajectory.frame, Mechanics(np.asarray(trajectory.frame.inertia)))
        groups.append(_about_body(trajectory))
    groups.append(about_file(trajectory, labels, kept))
    ending = SPEC_ENDING if len(trajectory.times) == 1 and tells_spin(trajectory) else DATASET_ENDING
    written = out or Path(f"{path.stem}_imported{ending}")  # not the name of a dataset exported to this folder
    check_spares(written, path)
    begin = find_begin(path, trajectory)
    header = {"title": path.name if labels is None else labels.object_name or path.name}
    header |= {COUNTED_FROM: in_words(begin)} if begin else {}
    what = "sample" if trajectory.attitude is None else "attitude"
    name = kind_in_words(kind, article=False)
    summary = f"{name[0].upper()}{name[1:]} with {write_count(len(trajectory.times), what)}."
    groups.append(Group("", [Answer("drift", trajectory.drift)]))

    def save(out: Path) -> Path:
        if out.suffix.lower() == SPEC_ENDING:
            return write_spec(trajectory, labels, out, path.name)
        return write_dataset(trajectory, out, header)

    publish(PlainReport(str(path), name, summary, groups, notes, save), json, written)


def _check_ending(out: Path) -> None:
    """Refuse a name whose ending is that of another form, which the file would not have.

    Raises:
        InvalidInput: naming the form.
    """
    ending = out.suffix.lower()
    known = forms_that_end(ending) if ending != DATASET_ENDING else []
    if not known:
        return
    form = next((form for form in known if form.write is not None), known[0])
    text = f"{out}: import writes a dataset, {DATASET_ENDING}, or a spec, {SPEC_ENDING}, and {ending} is the ending of "
    again = f" `polhode export SPEC --to {form.name}` writes such a file of a spec." if form.write else ""
    raise InvalidInput(f"{text}{kind_in_words(form.name)}. Name it {out.with_suffix(DATASET_ENDING).name}.{again}")


def _about_body(trajectory: Trajectory) -> Group:
    """Return the answers about the inertia in a file, and the spin at its first time."""
    frame, momentum = trajectory.frame, trajectory.momentum
    assert frame is not None
    size = None if momentum is None else float(np.linalg.norm(np.asarray(momentum)[0]))
    return Group("Body", [
        Answer("principal_moments", np.asarray(frame.moments), "kg m²", "principal moments"),
        Answer("principal_axes", np.asarray(frame.axes)),
        Answer("mass", frame.mass, "kg", "mass"),
        Answer("momentum_norm", size, "kg m²/s", "|L| at first"),
    ])


def _with_moments(trajectory: Trajectory, spec: Path) -> tuple[Trajectory, str, list[str]]:
    """Return the trajectory along the principal axes of a spec's body, whose invariants it has, and notes."""
    body = load_body(spec)
    if body.frame is None:
        raise InvalidInput(f"{spec}: has no [body], whose moments would be needed. Choose another spec.")
    trajectory = _with_body(trajectory, body.frame, body.mechanics)
    if body.mechanics is None:
        known = "they are known here of free bodies and tops"
        return trajectory, "", [f"momentum and energy are left out: {known}, and {spec} is of the system {body.kind}."]
    if trajectory.momentum is None:
        return trajectory, "", ["the file has no angular velocity, so that there is neither momentum nor energy."]
    if trajectory.attitude is None:
        missing = "energy and vertical momentum" if body.mechanics.weight is not None else "momentum in space"
        return trajectory, "a free body's", [f"without attitudes there is no {missing}."]
    return trajectory, "a free body's" if body.mechanics.weight is None else "a top's", []


def _with_body(trajectory: Trajectory, frame: BodyFrame, mechanics: Mechanics | None) -> Trajectory:
    """Return a trajectory along the principal axes of a body, with momentum and invariants where these follow.

    Args:
        trajectory: along the given axes, read from a file.
        frame: the principal axes; its moments are about the point that the body turns about.
        mechanics: of the body along the given axes; None where momentum is not the moments times the velocity.
    """
    samples, attitude = trajectory, trajectory.attitude
    along_body = samples.with_frame(frame).along("principal")
    if mechanics is None or along_body.angular_velocity is None:
        return _with_states(along_body)
    momentum = along_body.angular_velocity * np.asarray(frame.moments)
    along_body = _with_states(replace(along_body, momentum=momentum))
    if attitude is None and mechanics.weight is not None:
        return along_body  # the weight's torque is along axes that are not known
    still = np.tile((1.0, 0.0, 0.0, 0.0), (len(momentum), 1))  # energy and |L| are the same for any attitude
    invariants, drift = invariants_along(
        still if attitude is None else attitude, np.asarray(samples.angular_velocity), mechanics
    )
    if attitude is None:
        del invariants["momentum_space"], drift["momentum_space"]
    return replace(along_body, invariants=invariants, drift=drift)


def _with_states(trajectory: Trajectory) -> Trajectory:
    """Return the trajectory with states assembled from its parts."""
    named = [(ATTITUDE, trajectory.attitude), (MOMENTUM, trajectory.momentum)]
    parts = [(part, np.asarray(value)) for part, value in named if value is not None]
    parts = parts or [(ANGULAR_VELOCITY, np.asarray(trajectory.angular_velocity))]
    states = np.concatenate([value for _, value in parts], axis=-1)
    return replace(trajectory, states=states, layout=StateLayout(tuple(part for part, _ in parts)))


def _word_frames(labels: AttitudeLabels) -> str | None:
    """Return the frames that a file names, None where it names none."""
    named = ((labels.body_frame, "body"), (labels.reference_frame, "space"))
    return " in ".join(f"{name} ({what})" for name, what in named if name) or None


def about_file(trajectory: Trajectory, labels: AttitudeLabels | None, kept: str) -> Group:
    """Return the answers about a file's content; ``kept`` names whose invariants the drift is of."""
    times = np.asarray(trajectory.times)
    steps, velocity = np.diff(times), trajectory.angular_velocity
    several, largest_turn = len(times) > 1, None
    if several and trajectory.attitude is not None:
        attitude = np.asarray(trajectory.attitude)
        largest_turn = float(rotation.angle_between(attitude[1:], attitude[:-1]).max())
    gap = float(steps.max()) if several else None
    gap_from = float(times[int(np.argmax(steps))]) if several else None
    fastest = None if velocity is None else float(np.linalg.norm(np.asarray(velocity), axis=-1).max())
    named = [] if labels is None else [
        Answer("object", labels.object_name or None, "", "object", "",
               ", ".join(filter(None, (labels.object_name, labels.object_id))) or None),
        Answer("object_id", labels.object_id),
        Answer("reference_frame", labels.reference_frame or None, "", "frames", "", _word_frames(labels)),
        Answer("body_frame", labels.body_frame or None),
        Answer("epoch", labels.epoch, "", "time zero", "", f"{labels.epoch} {labels.time_system}"),
        Answer("time_system", labels.time_system),
    ]
    return Group("Angular velocity" if trajectory.attitude is None else "Attitude history", [
        *named,
        Answer("first", float(times[0]), "s", "span", "", f"{times[0]:.9g} to {times[-1]:.9g} s"),
        Answer("last", float(times[-1]), "s"),
        Answer("samples", len(times), "", "samples", "", str(len(times))),
        Answer("usual_step", float(np.median(steps)) if several else None, "s", "usual step"),
        Answer("largest_gap", gap, "s", "largest gap", "",
               None if gap is None else f"{gap:.8g} s, from {gap_from:.9g} s on"),
        Answer("gap_from", gap_from, "s"),
        Answer("largest_turn", largest_turn, "rad", "largest turn between samples"),
        Answer("has_angular_velocity", velocity is not None),
        Answer("fastest", fastest, "rad/s", "angular velocity", "",
               "none in the file" if fastest is None else f"up to {rate(fastest)}"),
        Answer("", None, "", f"drift of {kept} invariants", "", drifts(trajectory.drift) if kept else None),
    ])
