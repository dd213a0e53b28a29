"""The description of a file format: how it is recognised, read and written. Each is a file in ``formats/forms``."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from polhode._base.plugins import FAILURES
from polhode.errors import InvalidInput, PolhodeError, one_line
from polhode.formats.paths import write_whole

if TYPE_CHECKING:
    from polhode.bodies.body import Body
    from polhode.bodies.surface import Surface
    from polhode.formats.labels import AttitudeLabels
    from polhode.kinds.base import Spec
    from polhode.motion._trajectory import Trajectory


class Kernels(NamedTuple):
    """Auxiliary kernels of a C-kernel, None for the file next to it; and whose attitude; None for the only one."""

    sclk: Path | None = None
    fk: Path | None = None
    lsk: Path | None = None
    spice_id: int | None = None


@dataclass(frozen=True)
class Content:
    """Everything that a format can write about one spec or motion.

    Attributes:
        name: of what moves.
        labels: for attitude files; None for those that it was read with, or the usual ones.
        samples: its motion; None where nothing moves.
        part: that part of the motion that is worth watching; None likewise.
        body: its mass properties, or None.
        surface: returns its surface, in the given axes, or None.
        spec: from which formats without a motion are written; None for a motion without one.
        save: writes the data of a report without a motion; None where something moves.
    """

    name: str
    labels: AttitudeLabels | None
    samples: Trajectory | None = None
    part: Trajectory | None = None
    body: Body | None = None
    surface: Callable[[], Surface | None] = field(default=lambda: None)
    spec: Spec | None = None
    save: Callable[[Path], Path] | None = None

    @property
    def trajectory(self) -> Trajectory:
        """The motion.

        Raises:
            InvalidInput: where nothing moves.
        """
        if self.samples is None:
            raise InvalidInput(f"{self.name} has no motion to write. Choose a form for what does not move.")
        return self.samples


@dataclass(frozen=True)
class Form:
    """A form of file, which a module of ``formats/forms``, or an entry point of another package, offers as ``FORM``.

    Importing such a module must be cheap: its functions import what they need.

    Attributes:
        name: by which it is asked for, as in `polhode export --to`.
        title: as people call it: "AEM", "C-kernel".
        ending: of the file's name.
        holds: its content, and with how many digits.
        write: writes the file and returns its path; None for a form that is only read.
        read: returns the trajectory in a file; None for a form that is only written.
        begins: whether a file that begins with these bytes is one; None for a form that is not read.
        of_motion: whether it needs a motion.
        sampled: whether it holds the samples of the report.
        of_attitudes: whether readers interpolate its attitudes, so that a body must not turn far between samples.
        is_own: whether polhode alone writes such files, so that there is nothing to import.
        has_labels: whether it has objects, frames and epochs.
        resolution: of its times [s].
        is_table: whether it is a table whose columns are known by their names, which options of columns may overrule.
        named: whether a file of this name is one, of a form whose content does not show it; None for others.
    """

    name: str
    title: str
    ending: str
    holds: str = ""
    write: Callable[[Content, Path], Path] | None = None
    read: Callable[[Path, Kernels], Trajectory] | None = None
    begins: Callable[[bytes], bool] | None = None
    of_motion: bool = True
    sampled: bool = True
    of_attitudes: bool = False
    is_own: bool = False
    has_labels: bool = False
    resolution: float = 0.0
    is_table: bool = False
    named: Callable[[Path], bool] | None = None

    @property
    def is_ours(self) -> bool:
        """Whether it is this package's; writers and readers of others may raise and return anything."""
        return getattr(self.write or self.read, "__module__", "").startswith("polhode.")

    def save(self, content: Content, path: Path) -> Path:
        """Write the file, whole or not at all, and return its path.

        Raises:
            InvalidInput: for content that the form cannot hold, a path that cannot be written to, and any error of
                another package's writer.
        """
        assert self.write is not None
        if self.is_ours:
            return self.write(content, path)  # which has its own draft, and may write files beside it
        with write_whole(path) as draft:
            try:
                self.write(content, draft)
            except (PolhodeError, OSError):
                raise
            except FAILURES as error:
                what = f"{type(error).__name__}: {one_line(str(error))}"
                raise InvalidInput(f"{path}: the format {self.name} of another package cannot write it ({what}). "
                                   "Update the package.") from error
            if not draft.exists():
                raise InvalidInput(f"{path}: the format {self.name} of another package wrote nothing. Update it.")
        return path
