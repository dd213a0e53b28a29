"""What ``polhode report`` wrote and printed: again while it is true, with nothing computed, drawn or laid out anew."""

import json
import os
import subprocess
import sys
import warnings
from pathlib import Path

import matplotlib
import pytest
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine

from polhode.cli import entries
from polhode.cli.main import main
from polhode.kinds.base import Spec
from polhode.kinds.free_body import figures
from polhode.kinds.registry import find_kind

BOX = """v 0 0 0\nv 1 0 0\nv 0 2 0\nv 1 2 0\nv 0 0 3\nv 1 0 3\nv 0 2 3\nv 1 2 3
f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n"""
SPEC = """
[body]
mesh = "box.obj"
mesh_unit = "m"
mass = "1 kg"
[spin]
rate = "60 rpm"
about = 2
tilt = "1 deg"
[time]
until = "3 s"
samples = 20
"""
FIGURES = {"components"}
"""Of the free body's, those that are drawn here, as each takes long."""


@pytest.fixture
def case(tmp_path, monkeypatch):
    monkeypatch.setenv(entries.FOLDER, str(tmp_path / "kept"))
    monkeypatch.setenv("MPLCONFIGDIR", str(tmp_path / "settings"))
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(figures, "FIGURES", {name: figures.FIGURES[name] for name in FIGURES})
    (tmp_path / "box.obj").write_text(BOX)
    (tmp_path / "case.toml").write_text(SPEC)
    return tmp_path


class Work:
    """How often reports were computed, and figures laid out and drawn into files, within a context."""

    def __init__(self, monkeypatch):
        self.computed = self.laid_out = self.drawn = 0
        for owner, name, what in ((Spec, "report", "computed"), (ConstrainedLayoutEngine, "execute", "laid_out"),
                                  (Figure, "savefig", "drawn")):  # fmt: skip
            monkeypatch.setattr(owner, name, self._counted(getattr(owner, name), what))

    def _counted(self, function, what):
        def counted(*given, **named):
            setattr(self, what, getattr(self, what) + 1)
            return function(*given, **named)

        return counted

    def __iter__(self):
        return iter((self.computed, self.laid_out, self.drawn))


def report(capsys, *arguments):
    """Return what the command prints on standard output."""
    with pytest.raises(SystemExit) as end:
        main(["report", *arguments])
    out, _ = capsys.readouterr()
    assert not end.value.code
    return out


def counted(capsys, *arguments):
    """Return what the command prints, and how often it computed, laid out and drew."""
    with pytest.MonkeyPatch.context() as patch:
        work = Work(patch)
        return report(capsys, *arguments), tuple(work)


def contents(folder):
    return {path.name: path.read_bytes() for path in sorted(folder.iterdir())}


def test_a_report_that_is_asked_for_again_is_only_written(case, capsys):
    first, work = counted(capsys, "case.toml")
    assert work == (1, len(FIGURES), len(FIGURES))  # each figure is laid out once and drawn once
    files = contents(case / "case")
    assert files.keys() == {"motion.nc", *(f"{name}.png" for name in FIGURES)}
    again, work = counted(capsys, "case.toml")
    assert work == (0, 0, 0) and again == first and contents(case / "case") == files


def test_all_that_is_printed_is_kept_whatever_was_printed_first(case, capsys):
    printed = ((), ("--json",), ("--certificates",))
    kept = {how: report(capsys, "case.toml", *how) for how in printed}
    (first,) = (path for path in (case / "kept").iterdir() if path.suffix == entries.WRITTEN)
    first.unlink()
    new = {how: report(capsys, "case.toml", *how) for how in reversed(printed)}
    assert new == kept and len(set(kept.values())) == len(printed)


@pytest.mark.long
def test_files_go_where_they_are_asked_for(case, capsys):
    said = json.loads(report(capsys, "case.toml", "--json"))
    elsewhere, work = counted(capsys, "case.toml", "--json", "--out", "elsewhere")
    assert work == (0, 0, 0) and contents(case / "elsewhere") == contents(case / "case")
    told = json.loads(elsewhere)
    assert told.pop("files") == [str(Path("elsewhere", Path(file).name)) for file in said.pop("files")] and told == said


@pytest.mark.long
def test_outdated_figures_go(case, capsys):
    report(capsys, "case.toml", "--figure-format", "svg")
    assert "components.svg" in json.loads(report(capsys, "case.toml", "--json"))["removed"][0]
    assert {path.suffix for path in (case / "case").iterdir()} == {".png", ".nc"}
    again, work = counted(capsys, "case.toml", "--figure-format", "svg")
    assert work == (0, 0, 0) and "Removed" in again
    assert {path.suffix for path in (case / "case").iterdir()} == {".svg", ".nc"}


@pytest.mark.long
def test_other_formats_are_drawn_from_the_report_that_is_kept(case, capsys):
    report(capsys, "case.toml")
    assert counted(capsys, "case.toml", "--figure-format", "png,pdf")[1] == (0, len(FIGURES), 2 * len(FIGURES))


@pytest.mark.long
def test_the_page_is_kept_too(case, capsys):
    report(capsys, "case.toml", "--html")
    files = contents(case / "case")
    assert counted(capsys, "case.toml", "--html")[1] == (0, 0, 0) and contents(case / "case") == files
    assert "page.html" in files


def change_spec(case, patch):
    (case / "case.toml").write_text(SPEC.replace("60 rpm", "61 rpm"))


def change_mesh(case, patch):
    (case / "box.obj").write_text(BOX.replace("v 1 2 3", "v 1 2 3.0000000000000004"))


def change_program(case, patch):
    patch.setenv("XLA_FLAGS", "--xla_backend_optimization_level=0")


def change_settings(case, patch):
    (case / "settings").mkdir(exist_ok=True)
    (case / "settings" / "matplotlibrc").write_text("lines.linewidth: 3")


def change_settings_here(case, patch):
    (case / "matplotlibrc").write_text("lines.linewidth: 3")


def change_own_settings(case, patch):
    """Matplotlib's own, which whoever installs it for others may edit."""
    own = case / "matplotlib" / "mpl-data"
    own.mkdir(parents=True, exist_ok=True)
    (own / "matplotlibrc").write_text("lines.linewidth: 3")
    patch.setattr(matplotlib.__spec__, "submodule_search_locations", [str(own.parent)])


def change_precision(case, patch):
    patch.setenv("JAX_ENABLE_X64", "1")


def change_matplotlib(case, patch):
    from polhode.cli import written

    patch.setattr(written.metadata, "version", lambda name: "0")


def damage(case, patch):
    for path in (case / "kept").iterdir():
        path.write_bytes(path.read_bytes()[:-1])


@pytest.mark.long_after(2)
@pytest.mark.parametrize(("change", "computes"), [
    (change_spec, True), (change_settings, False), (change_mesh, True), (change_program, True), (damage, True),
    (change_settings_here, False), (change_matplotlib, False), (change_own_settings, False), (change_precision, True),
])  # fmt: skip
def test_whatever_changes_is_made_again(case, capsys, change, computes):
    report(capsys, "case.toml")
    with pytest.MonkeyPatch.context() as patch:
        change(case, patch)
        assert counted(capsys, "case.toml")[1] == (computes, len(FIGURES), len(FIGURES))
        assert counted(capsys, "case.toml")[1] == (0, 0, 0)


def test_figures_that_other_packages_bring_by_then_are_drawn(case, capsys, add_entry_points):
    report(capsys, "case.toml")
    add_entry_points("polhode.figures", ("free-body.one_more", f"{__name__}:draw_one_more"))
    assert "one_more.png" in report(capsys, "case.toml")
    assert "one_more.png" in report(capsys, "case.toml")


def draw_one_more(report):
    return Figure()


def test_a_warning_is_said_again(case, capsys, add_entry_points):
    add_entry_points("polhode.figures", ("no-kind.spin", f"{__name__}:draw_one_more"))
    for _ in range(2):
        with pytest.raises(SystemExit), warnings.catch_warnings():
            warnings.simplefilter("always")
            main(["report", "case.toml"])
        assert "there is no kind" in capsys.readouterr().err


def say_warnings(capsys):
    with pytest.raises(SystemExit), warnings.catch_warnings():
        warnings.simplefilter("ignore" if sys.warnoptions else "always")
        main(["report", "case.toml"])
    return capsys.readouterr().err


def warn_and_report(original):
    def report(spec):
        warnings.warn("a doubt", stacklevel=2)
        return original(spec)

    return report


def test_a_warning_of_what_is_computed_is_said_again(case, capsys, monkeypatch):
    monkeypatch.setattr(Spec, "report", warn_and_report(Spec.report))
    assert all("a doubt" in say_warnings(capsys) for _ in range(3))


def test_a_warning_that_was_ignored_is_said_where_it_is_not(case, capsys, monkeypatch):
    """As by ``PYTHONWARNINGS=ignore``, under which what is kept is taken again."""
    monkeypatch.setattr(Spec, "report", warn_and_report(Spec.report))
    with monkeypatch.context() as patch:
        patch.setattr(sys, "warnoptions", ["ignore"])
        assert not say_warnings(capsys) and counted(capsys, "case.toml")[1] == (0, 0, 0)
    assert all("a doubt" in say_warnings(capsys) for _ in range(2))


def test_a_file_that_vanishes_meanwhile_is_not_missed(case, capsys, monkeypatch):
    """It has been read; nothing is kept, as whether it was the same is not known."""
    draw = figures.FIGURES["components"]

    def vanish_and_draw(*given, **named):
        (case / "box.obj").unlink(missing_ok=True)
        return draw(*given, **named)

    monkeypatch.setattr(figures, "FIGURES", {"components": vanish_and_draw})
    assert "components.png" in report(capsys, "case.toml")
    assert not list((case / "kept").glob(f"*{entries.WRITTEN}"))


def test_a_report_where_there_is_no_home(case, capsys, without_home):
    first = report(capsys, "case.toml")
    assert counted(capsys, "case.toml") == (first, (0, 0, 0))


def test_a_file_that_changes_meanwhile_is_not_taken_for_the_one_that_was_read(case, capsys):
    original = Spec.report

    def change_and_report(spec):
        (case / "case.toml").write_text(SPEC.replace("60 rpm", "61 rpm"))
        return original(spec)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Spec, "report", change_and_report)
        slow = report(capsys, "case.toml")
    assert report(capsys, "case.toml") != slow


def test_mistakes_are_said_again(case, capsys):
    (case / "case.toml").write_text(SPEC.replace("about = 2", "about = 9"))
    said = []
    for _ in range(2):
        with pytest.raises(SystemExit) as end:
            main(["report", "case.toml"])
        said.append((end.value.code, capsys.readouterr().err))
    assert said[0] == said[1] and said[0][0] == 2
    assert not [path for path in (case / "kept").glob("*")]


@pytest.mark.long
def test_large_ones_are_not_kept(case, capsys, monkeypatch):
    monkeypatch.setattr(entries, "LARGEST", 1000)
    report(capsys, "case.toml")
    assert not (case / "kept").exists()


@pytest.mark.long
@pytest.mark.parametrize("kind", ["spin-orbit", pytest.param("heavy-top", marks=pytest.mark.sweep)])
def test_a_report_that_is_kept_needs_neither_jax_nor_matplotlib_nor_a_kind(tmp_path, kind):
    (tmp_path / "case.toml").write_text(find_kind(kind).example)
    environment = os.environ | {"XDG_CACHE_HOME": str(tmp_path / "c"), entries.FOLDER: str(tmp_path / "kept")}
    code = ("import atexit, sys; atexit.register(lambda: print(*sys.modules, file=sys.stderr));"
            "from polhode.cli.main import main; main()")

    def run():
        command = [sys.executable, "-c", code, "report", "case.toml"]
        done = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True, timeout=300,
                              check=True)  # fmt: skip
        return done.stdout, set(done.stderr.split())

    heavy = {"jax", "numba", "equinox", "matplotlib", "pint", "scipy", "xarray", "h5py", "polhode.kinds",
             "polhode.solving", "polhode.figures", "polhode.integrators", "polhode.systems", "polhode.taylor",
             "polhode.algebra"}  # fmt: skip
    first, loaded = run()
    assert {"jax", "matplotlib", "pint", "polhode.kinds"} <= loaded and "dask" not in loaded
    again, loaded = run()
    assert again == first and not heavy & loaded
