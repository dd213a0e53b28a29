"""``polhode report SPEC``: the main job."""

from __future__ import annotations

import contextlib
import shutil
import tempfile
from collections.abc import Iterator
from pathlib import Path

from polhode.cli.render import as_json, print_report
from polhode.errors import InvalidInput, NotConverged
from polhode.report.choice import report_of
from polhode.spec.reading import read_spec

FORMS = ("png", "svg", "pdf")


def figure_forms(named: list[str]) -> list[str]:
    """Return the forms of figures asked for, each once; an item may be several with commas between.

    Raises:
        InvalidInput: for forms that figures are not written in.
    """
    forms = [form.strip().lower().removeprefix(".") for item in named for form in item.split(",")]
    if unknown := [form for form in forms if form not in FORMS]:
        raise InvalidInput(f"`--figures` must be of {', '.join(FORMS)}; got {unknown[0]!r}. Leave it out for png.")
    return list(dict.fromkeys(forms)) or ["png"]


def run_report(path: Path, json: bool, out: Path | None, figures: list[str], html: bool = False) -> None:
    """Read the spec, compute, write figures, dataset and, if asked for, the page, and print the answers."""
    forms = figure_forms(figures)
    spec = read_spec(path)
    folder = out or Path(path.stem if path.suffix else f"{path.name}_report")
    try:
        report = report_of(spec)
    except (InvalidInput, NotConverged) as error:
        raise type(error)(f"{path}: {error}") from None
    with _folder_at_once(folder) as draft:
        from polhode.figures.drawing import draw_all
        from polhode.formats.dataset import write_dataset

        files = draw_all(report, draft, *forms)
        files.append(write_dataset(report.trajectory, draft / "motion.nc", {"title": spec.name}, report.frame))
        if html:
            from polhode.viewer import page_of_report

            files.append(page_of_report(report, draft / "page.html", name=spec.name, surface=spec.surface))
        names = [str(folder / file.name) for file in files]
    if json:
        print(as_json({"name": spec.name, **report.as_json_dict(), "files": names}))
    else:
        print_report(spec.name, report.summary, report.sections(), report.notes, names)


@contextlib.contextmanager
def _folder_at_once(folder: Path) -> Iterator[Path]:
    """Yield a draft folder whose files move to their place only when all of them have been written."""
    try:
        if folder.exists() and not folder.is_dir():
            raise InvalidInput(f"{folder}: is a file, so figures cannot go there. Name another folder with --out.")
        folder.parent.mkdir(parents=True, exist_ok=True)
        draft = Path(tempfile.mkdtemp(dir=folder if folder.is_dir() else folder.parent, prefix=".polhode-"))
    except OSError as error:
        why = f"{folder}: cannot be written ({error.strerror}). Name a folder that you may write to with --out."
        raise InvalidInput(why) from None
    from polhode.figures import style

    try:
        yield draft
        taken = [folder / file.name for file in draft.iterdir() if (folder / file.name).is_dir()]
        if taken:
            raise InvalidInput(f"{taken[0]}: is a folder where a file has to go. Name another folder with --out.")
        folder.mkdir(exist_ok=True)
        written = {file.name for file in draft.iterdir()}
        for path in folder.iterdir():  # an earlier run's, of another motion
            if path.name not in written and style.is_ours(path):
                path.unlink()
        for name in written:
            (draft / name).replace(folder / name)
    except OSError as error:
        why = f"{folder}: cannot be written ({error.strerror}). Name a folder that you may write to with --out."
        raise InvalidInput(why) from None
    finally:
        shutil.rmtree(draft, ignore_errors=True)
