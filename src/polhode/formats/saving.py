"""A motion as a file, in the format that the ending of its name says."""

from __future__ import annotations

from pathlib import Path

from polhode._base import check
from polhode.errors import InvalidInput, shown
from polhode.formats.form import Content, Form
from polhode.formats.form_registry import forms_that_end, writable_forms
from polhode.formats.paths import as_path
from polhode.motion._trajectory import Trajectory
from polhode.motion.exact import ExactMotion


def write_motion(motion: ExactMotion | Trajectory, path: str | Path) -> Path:
    """Write a motion into a file that appears whole or not at all, and return its path.

    Args:
        motion: a trajectory of one body or system, or an exact motion of one body, of which ``sample()`` is written.
        path: ends in .nc or .zarr (datasets with all quantities, along the principal axes), .csv (a table along the
            given axes), .aem (CCSDS attitude), .bc (SPICE C-kernel), .glb (glTF animation), or as another package's
            format does.

    Raises:
        InvalidInput: for another ending, a motion that the format cannot hold, or a path that cannot be written.

    >>> import polhode as ph, tempfile
    >>> motion = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5))
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     len(ph.formats.read_csv(write_motion(motion, f"{folder}/motion.csv")))
    2000
    """
    check.instance("motion", motion, (ExactMotion, Trajectory), "a motion or a trajectory")
    place = as_path("path", path)
    trajectory = motion if isinstance(motion, Trajectory) else motion.sample()
    title = getattr(trajectory.source, "title", "")
    return write_content(Content(title or "motion", None, trajectory), place)


def write_content(content: Content, path: Path) -> Path:
    """Write a motion in the format of the path's ending, and return the path.

    Raises:
        InvalidInput: as ``write_motion`` does.
    """
    fitting = [form for form in forms_that_end(path.suffix.lower()) if form.write is not None and _is_of_motions(form)]
    if not fitting:
        endings = sorted({form.ending for form in writable_forms().values() if _is_of_motions(form)})
        raise InvalidInput(f"{path}: must end in {', '.join(endings)}, the formats of motions; "
                           f"got {shown(path.suffix)}. Rename it.")
    return fitting[-1].save(content, path)


def _is_of_motions(form: Form) -> bool:
    return form.of_motion or form.sampled
