"""``polhode report SPEC``: how the body moves, in words, figures and files."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from polhode.cli.publish import publish
from polhode.cli.report_options import is_asked_for_more
from polhode.cli.terminal import spell_command
from polhode.cli.written import Asked, write_again
from polhode.errors import InvalidInput, shown
from polhode.formats.figure_file import is_ours

FIGURE_FORMATS = ("png", "svg", "pdf")


def read_figure_formats(named: list[str]) -> list[str]:
    """Return the formats of figures asked for, each once; an item may be several with commas between.

    Raises:
        InvalidInput: for formats that figures are not written in.
    """
    formats = [name.strip().lower().removeprefix(".") for item in named for name in item.split(",")]
    if unknown := [name for name in formats if name not in FIGURE_FORMATS]:
        known = ", ".join(FIGURE_FORMATS)
        got = shown(unknown[0])
        raise InvalidInput(f"`--figure-format` must be one or more of {known}; got {got}. Leave it out for png.")
    return list(dict.fromkeys(formats)) or ["png"]


def run_report(
    path: Path, json: bool, out: Path | None, figure_formats: list[str], html: bool = False, certificates: bool = False,
) -> None:
    """Write figures, dataset and, if asked for, page and more, and print the answers.

    What was written when the same was asked before is written again; what wings and other packages write besides needs
    the report itself.
    """
    asked = Asked(path, read_figure_formats(figure_formats), html)
    folder = out or Path(path.stem if path.suffix else f"{path.name}_report")
    written = None if is_asked_for_more() else write_again(asked, folder)
    if written is None:
        from polhode.cli.new_report import write_new

        written = write_new(asked, folder)
    names = [*(str(folder / name) for name in written.files), *(name for files, _ in written.more for name in files)]
    removed = _remove_outdated(folder, written.files)
    following = "; ".join(f"{spell_command(command, str(path))} {gives}" for command, gives in written.following)
    publish(written.report, json, written=names, removed=removed, certificates=certificates, following=following,
            remarks=[note for _, notes in written.more for note in notes])


def _remove_outdated(folder: Path, written: Sequence[str]) -> list[str]:
    """Remove the figures that an earlier report wrote into the folder and this one did not, by their names and content.

    Files of other commands, and renamed ones, stay. Other kinds are imported only where something may have to go.
    """
    if not _has_other_figures(folder, written):
        return []
    from polhode.kinds.registry import known_figures

    known = {f"{name}.{form}" for name in known_figures() for form in FIGURE_FORMATS}
    outdated = sorted(folder / name for name in known - set(written))
    removed = []
    for path in outdated:
        try:
            if is_ours(path):
                path.unlink()
                removed.append(str(path))
        except OSError as error:
            why = f"{path}: is of an earlier report and cannot be removed ({error.strerror}). Remove it yourself."
            raise InvalidInput(why) from None
    return removed


def _has_other_figures(folder: Path, written: Sequence[str]) -> bool:
    """Whether a folder may have figures besides those just written, by the endings of names."""
    endings = {f".{form}" for form in FIGURE_FORMATS}
    try:
        return any(path.suffix.lower() in endings and path.name not in written for path in folder.iterdir())
    except OSError:  # of a folder that one may write into and not list
        return True
