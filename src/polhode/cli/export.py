"""``polhode export SPEC --to FORM``: the motion as files for other tools."""

from __future__ import annotations

import difflib
import math
import sys
import warnings
from collections.abc import Sequence
from pathlib import Path

from polhode.cli.destinations import check_spares
from polhode.cli.render import as_json
from polhode.cli.spec_reports import make_motion_report, make_report
from polhode.errors import FormatError, InvalidInput, one_line, shown
from polhode.formats.form import Content, Form
from polhode.formats.form_registry import check_importable, find_form, writable_names
from polhode.formats.paths import write_all_or_none
from polhode.kinds.base import Spec
from polhode.kinds.reading import read_spec
from polhode.motion._trajectory import Trajectory
from polhode.reports.base import MotionReport, SystemReport


def run_export(path: Path, names: Sequence[str], out: Path | None, json: bool = False) -> None:
    """Compute the motion of a spec once and write it in every form asked for, in all of them or in none."""
    wanted = [_form(name) for name in dict.fromkeys(names)]
    if out is not None and len(wanted) > 1:
        raise InvalidInput(f"--out names one file, and {len(wanted)} forms are asked for. Leave it out, or write one.")
    if out is not None:
        check_spares(out, path)
    spec = read_spec(path)
    moving = any(form.of_motion or (form.sampled and spec.kind.has_motion) for form in wanted)
    report = make_motion_report(path, spec) if moving else make_report(path, spec)
    content = gather_content(spec, report)
    if out is not None:
        written = [_write(wanted[0], content, out)]
    else:
        with write_all_or_none(Path()):
            written = [_write(form, content, Path(f"{path.stem}{form.ending}")) for form in wanted]
    for form in wanted:
        if form.of_attitudes and content.samples is not None:
            _warn_of_long_turns(content.samples, form.name)
    if json:
        print(as_json({**report.as_json_dict(), "files": [str(place) for place in written]}))
        return
    for form, place in zip(wanted, written, strict=True):
        print(one_line(f"{place}: {_describe_file(form, content)}"))


def _form(name: str) -> Form:
    form = find_form(name)
    if form is None or form.write is None:
        known = writable_names()
        check_importable(name)
        near = difflib.get_close_matches(name.lower(), known, n=1)
        hint = f"Did you mean {near[0]}?" if near else "Choose one of these."
        raise InvalidInput(f"--to must be one of {', '.join(known)}; got {shown(name)}. {hint}")
    return form


def gather_content(spec: Spec, report: SystemReport) -> Content:
    """Return the content that a spec and its report offer for files."""
    moving = report if isinstance(report, MotionReport) else None
    return Content(
        spec.name, spec.labels, None if moving is None else moving.trajectory, None if moving is None else moving.shown,
        spec.body, lambda: spec.surface, spec, report.save if moving is None else None,
    )


def _write(form: Form, content: Content, place: Path) -> Path:
    """Write one file; warnings of its writer go to standard error."""
    try:
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always", UserWarning)
            written = form.save(content, place)
    except FormatError:
        raise
    except InvalidInput as error:
        raise InvalidInput(f"{form.name}: {error}") from None
    for said in dict.fromkeys(str(warning.message) for warning in caught):
        print(f"polhode: {form.name}: {said}", file=sys.stderr)
    return written


def _describe_file(form: Form, content: Content) -> str:
    """Return a description of the file, and of the part of the motion that it shows, if not all."""
    whole, part = content.samples, content.part
    if whole is None or part is None or form.sampled:
        count = f"{len(whole.times)} samples, " if whole is not None and form.sampled else ""
        return f"{count}{form.holds}"
    all_of_it = part.times[0] <= whole.times[0] and part.times[-1] >= whole.times[-1]
    if all_of_it or not form.of_motion:
        return form.holds
    times = f"{part.times[0]:.6g} s to {part.times[-1]:.6g} s, of {whole.times[-1]:.6g} s"
    return f"{form.holds}; it shows the motion from {times}"


def _warn_of_long_turns(trajectory: Trajectory, form: str) -> None:
    """Warn where the body turns too far between samples for readers that interpolate."""
    from polhode.formats.animation_keys import LIMITS, farthest_turn

    if (turn := farthest_turn(trajectory)) > LIMITS.max_turn:
        print(f"polhode: {form}: the body turns by up to {math.degrees(turn):.3g}° between samples; readers who "
              f"interpolate over more than {math.degrees(LIMITS.max_turn):.0f}° go wrong. Raise `samples` under "
              "[time], or take a shorter `until`.", file=sys.stderr)
