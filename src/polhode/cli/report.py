"""``polhode report SPEC``: how the body moves, in words, figures and files."""

from __future__ import annotations

from pathlib import Path

from polhode.cli.kept import load_or_make_page
from polhode.cli.publish import publish
from polhode.cli.report_options import write_more
from polhode.cli.spec_reports import make_page_report, make_report
from polhode.cli.terminal import spell_command
from polhode.errors import InvalidInput, shown
from polhode.formats.figure_file import is_ours
from polhode.formats.paths import write_together
from polhode.kinds.added_figures import check_kinds_of_figures
from polhode.kinds.reading import read_spec
from polhode.kinds.registry import kind_names, known_figures, next_steps

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
    """Read the spec, compute, write figures, dataset and, if asked for, page and more, and print the answers."""
    formats = read_figure_formats(figure_formats)
    spec = read_spec(path)
    folder = out or Path(path.stem if path.suffix else f"{path.name}_report")
    report = make_page_report(path, spec) if html else make_report(path, spec)
    check_kinds_of_figures(kind_names())
    with write_together(folder) as draft:
        files = report.draw(draft, *formats)
        if report.data_file:
            files.append(report.save(draft / report.data_file))
        if html:
            from polhode.kinds.page import write_page_text

            files.append(write_page_text(load_or_make_page(spec, report), draft / "page.html"))
        more = list(write_more(report))
    names = [*(str(folder / file.name) for file in files), *(name for written, _ in more for name in written)]
    removed = _remove_outdated(folder, [file.name for file in files])
    following = "; ".join(f"{spell_command(step.command, str(path))} {step.gives}" for step in next_steps(spec))
    publish(report, json, written=names, removed=removed, certificates=certificates, following=following,
            remarks=[note for _, notes in more for note in notes])


def _remove_outdated(folder: Path, written: list[str]) -> list[str]:
    """Remove the figures that an earlier report wrote into the folder and this one did not, by their names and content.

    Files of other commands, and renamed ones, stay. Other kinds are imported only where something may have to go.
    """
    if not _has_other_figures(folder, written):
        return []
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


def _has_other_figures(folder: Path, written: list[str]) -> bool:
    """Whether a folder may have figures besides those just written, by the endings of names."""
    endings = {f".{form}" for form in FIGURE_FORMATS}
    try:
        return any(path.suffix.lower() in endings and path.name not in written for path in folder.iterdir())
    except OSError:  # of a folder that one may write into and not list
        return True
