"""What is kept is true as long as the code is the same that it came from: of each contributor, in each product."""

import contextlib
import io
import json
import os
import re
import subprocess
import sys
import zipfile
from importlib.metadata import EntryPoint

import pytest

from polhode._base import plugins
from polhode._base.plugins import GROUPS, Plugin, digest_plugins
from polhode._base.plugins.code import digest_code
from polhode.cli.main import main
from registered import forget_entry_points
from sweeping import only
from twins.contributors import BODY, CONTRIBUTORS, forget, install, number_in, set_law
from twins.table import read_tables

CELLS = read_tables()["Contributors and products"].pairs()
"""Panels have no group of entry points: those of others come with their kind."""
BY_DEFAULT = {("polhode.torques", "kept report"), ("polhode.torques", "resumed sweep"), ("polhode.formats", "export"),
              ("polhode.commands", "report"), ("polhode.derivations", "report")}  # fmt: skip


@pytest.fixture(autouse=True)
def forgotten(tmp_path):
    """Leave no package of a test's folder to the tests after it, among which some import others of the same names."""
    yield
    forget(tmp_path)
    sys.path_importer_cache.clear()
    forget_entry_points()


def test_the_table_has_every_group():
    assert GROUPS.keys() == CONTRIBUTORS.keys() == {group for group, _ in CELLS}


class Here:
    """Commands in this process, which imports the packages of others anew before each."""

    def __init__(self, folder, monkeypatch):
        self.folder = folder
        monkeypatch.setenv("POLHODE_REPORTS_CACHE", str(folder / "kept"))
        monkeypatch.syspath_prepend(folder)
        monkeypatch.chdir(folder)
        forget(folder)
        forget_entry_points()

    def __call__(self, *arguments):
        forget(self.folder)
        forget_entry_points()
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err), pytest.raises(SystemExit) as end:
            main(list(arguments))
        return end.value.code or 0, out.getvalue(), err.getvalue()


class Apart(Here):
    """Commands in processes of their own, with all that these keep."""

    def __init__(self, folder, monkeypatch):
        super().__init__(folder, monkeypatch)
        kept = {"XDG_CACHE_HOME": str(folder / "cache"), "PYTHONPATH": str(folder)}
        left = {key: value for key, value in os.environ.items() if not key.startswith(("JAX_", "POLHODE_UNITS"))}
        self.environment = left | kept

    def __call__(self, *arguments):
        done = subprocess.run([sys.executable, "-m", "polhode", *arguments], cwd=self.folder, env=self.environment,
                              capture_output=True, text=True, timeout=600, check=False)  # fmt: skip
        return done.returncode, done.stdout, done.stderr


def report(run, group):
    commands = {"polhode.commands": ("of-others", "times.txt"), "polhode.fits": ("fit", "times.txt"),
                "polhode.report-options": ("report", "spec.toml", "--of-others", "card.md"),
                "polhode.derivations": ("derive", "of-others", "--out", "page.txt"),
                "polhode.figures": ("report", "spec.toml", "--figure-format", "svg")}  # fmt: skip
    command = commands.get(group, ("report", "spec.toml"))
    code, out, err = run(*command, *(["--json"] if command[0] != "derive" else []))
    assert code == 0, err
    if group == "polhode.figures":
        return float(re.findall(r"factor ([\d.]+)", (run.folder / "spec" / "of_others.svg").read_text())[-1])
    if command[-1] in ("card.md", "page.txt"):
        (number,) = re.findall(r"^.*?([\d.]+)$", (run.folder / command[-1]).read_text(), re.MULTILINE)[:1]
        return float(number)
    return number_in(out, group)


def page(run, group):
    code, _, err = run("view", "spec.toml", "--no-open")
    assert code == 0, err
    return (run.folder / "spec.html").read_text("utf-8")


def exported(run, group):
    form = "of-others" if group == "polhode.formats" else "csv"
    code, _, err = run("export", "spec.toml", "--to", form, "--out", "written")
    assert code == 0, err
    (written,) = [path for path in run.folder.glob("written*/*")] or [path for path in run.folder.glob("written*")]
    return written.read_text()


def kept_files(run, ending):
    return {path.name: path.stat().st_ino for path in (run.folder / "kept").glob(f"*{ending}")}


def check_report(run, group):
    """Twice the law, twice the answer."""
    assert report(run, group) == pytest.approx(CONTRIBUTORS[group].value, rel=1e-9)
    set_law(run.folder, 2.0)
    assert report(run, group) == pytest.approx(2.0 * CONTRIBUTORS[group].value, rel=1e-9)


def check_kept_report(run, group):
    """What is kept is taken, until the law changes."""
    first = report(run, group)
    kept = kept_files(run, ".report")
    assert report(run, group) == first and kept_files(run, ".report") == kept and len(kept) == 1
    set_law(run.folder, 2.0)
    assert report(run, group) == pytest.approx(2.0 * first, rel=1e-9)
    set_law(run.folder, 1.0)
    assert report(run, group) == first


def check_page(run, group):
    first = page(run, group)
    set_law(run.folder, 2.0)
    assert page(run, group) != first
    set_law(run.folder, 1.0)
    assert page(run, group) == first


def check_kept_page(run, group):
    first = page(run, group)
    kept = kept_files(run, ".page")
    assert page(run, group) == first and kept_files(run, ".page") == kept and len(kept) == 1
    set_law(run.folder, 2.0)
    assert page(run, group) != first


def check_export(run, group):
    first = exported(run, group)
    set_law(run.folder, 2.0)
    assert exported(run, group) != first


def sweep(run):
    return run("sweep", "spec.toml", "--out", "a.zarr", "--json")


def mean_of(out):
    return json.loads(out)["statistics"][-1]["mean"]


def check_sweep(run, group):
    """A finished sweep of another law is refused; in another folder it is that of the new law."""
    code, out, err = sweep(run)
    assert code == 0, err
    first = mean_of(out)
    assert first > 0.0
    assert sweep(run)[:2] == (0, out)
    set_law(run.folder, 2.0)
    check_refused(run, group)
    (run.folder / "a.zarr").rename(run.folder / "other.zarr")
    assert mean_of(sweep(run)[1]) == pytest.approx(2.0 * first, rel=1e-9)


def check_resumed_sweep(run, group):
    """A sweep with a missing chunk does not go on by another law."""
    code, out, err = sweep(run)
    assert code == 0, err
    (run.folder / "a.zarr" / ".sweep" / "chunks" / "000000001.mark").unlink()
    set_law(run.folder, 2.0)
    check_refused(run, group)
    set_law(run.folder, 1.0)
    assert sweep(run)[:2] == (0, out)


def check_refused(run, group):
    code, out, err = sweep(run)
    who = f"the {GROUPS[group]} of-others of another package ({CONTRIBUTORS[group].point})"
    assert code == 2 and not out and "Traceback" not in err
    assert f"holds another sweep: {who} changed since" in err and "Put it back, choose another folder" in err


CHECKS = {"report": check_report, "kept report": check_kept_report, "page": check_page, "kept page": check_kept_page,
          "export": check_export, "sweep": check_sweep, "resumed sweep": check_resumed_sweep}  # fmt: skip


@pytest.mark.parametrize(("group", "product"), only(BY_DEFAULT, CELLS))
def test_a_law_that_changed(tmp_path, monkeypatch, group, product):
    install(tmp_path, group)
    CHECKS[product](Here(tmp_path, monkeypatch), group)


@pytest.mark.sweep
@pytest.mark.parametrize(("group", "product"), CELLS)
def test_a_law_that_changed_between_processes(tmp_path, monkeypatch, group, product):
    """With compiled functions kept as well, where those of another law must not be taken."""
    install(tmp_path, group)
    CHECKS[product](Apart(tmp_path, monkeypatch), group)


# ---------------------------------------------------------------------- where code lies


def module_file(folder):
    (folder / "part.py").write_text("from law import FACTOR\n")
    (folder / "law.py").write_text("FACTOR = 1\n")
    return "part", folder / "law.py"


def package(folder):
    (folder / "part").mkdir()
    (folder / "part" / "__init__.py").write_text("")
    (folder / "part" / "law.py").write_text("FACTOR = 1\n")
    return "part.sub", folder / "part" / "law.py"


def data_of_package(folder):
    package(folder)
    (folder / "part" / "gains.csv").write_text("1\n")
    return "part", folder / "part" / "gains.csv"


def namespace(folder):
    (folder / "space" / "deep").mkdir(parents=True)
    (folder / "space" / "part.py").write_text("from .deep import law\nfrom space.deep.law import FACTOR\n")
    (folder / "space" / "deep" / "law.py").write_text("FACTOR = 1\n")
    return "space.part", folder / "space" / "deep" / "law.py"


def namespace_by_dots(folder):
    namespace(folder)
    (folder / "space" / "part.py").write_text("if 1:\n    from .deep.law import (\n        FACTOR,  # it\n    )\n")
    return "space.part", folder / "space" / "deep" / "law.py"


def late_import(folder):
    module_file(folder)
    (folder / "part.py").write_text("import os; import law\ndef f():\n    import sys, law as x\n    return x.FACTOR\n")
    return "part", folder / "law.py"


def import_by_call(folder):
    module_file(folder)
    (folder / "part.py").write_text("import importlib\nlaw = importlib.import_module('law')\n")
    return "part", folder / "law.py"


def second_step(folder):
    module_file(folder)
    (folder / "part.py").write_text("import middle\n")
    (folder / "middle.py").write_text("from law import *\n")
    return "part", folder / "law.py"


def edited_where_it_is_installed(folder):
    """As ``pip install -e`` leaves it: a line in a file of paths, which leads elsewhere."""
    elsewhere = folder / "elsewhere"
    elsewhere.mkdir()
    module_file(elsewhere)
    sys.path.insert(0, str(elsewhere))
    return "part", elsewhere / "law.py"


def own_in_site_packages(folder):
    """The second module of a distribution that was installed, and is changed there."""
    place = folder / "site-packages"
    place.mkdir()
    module_file(place)
    sys.path.insert(0, str(place))
    return "part", place / "law.py"


PLACES = (module_file, package, data_of_package, namespace, namespace_by_dots, late_import, import_by_call, second_step,
          edited_where_it_is_installed, own_in_site_packages)  # fmt: skip


@pytest.fixture
def folder(tmp_path, monkeypatch):
    before = list(sys.path)
    monkeypatch.syspath_prepend(tmp_path)
    yield tmp_path
    sys.path[:] = before


@pytest.mark.parametrize("place", PLACES)
def test_wherever_the_code_lies(folder, place):
    module, law = place(folder)
    before = digest_code(module, own={"law"})
    assert digest_code(module, own={"law"}) == before != digest_code("nowhere_at_all")
    content = law.read_text()
    law.write_text(content.replace("1", "2"))
    assert digest_code(module, own={"law"}) != before
    law.write_text(content)
    assert digest_code(module, own={"law"}) == before


def test_code_in_an_archive(folder):
    digests = []
    for factor in (1, 2):
        with zipfile.ZipFile(folder / "all.zip", "w") as archive:
            archive.writestr("part.py", f"FACTOR = {factor}\n")
        sys.path.insert(0, str(folder / "all.zip"))
        digests.append(digest_code("part"))
        sys.path_importer_cache.clear()
    assert digests[0] != digests[1]


def test_what_does_not_take_part_does_not_count(folder):
    """Neither other modules, nor what Python writes beside them, nor where they lie."""
    module, _ = package(folder)
    before = digest_code(module)
    (folder / "stranger.py").write_text("FACTOR = 1\n")
    (folder / "part" / "__pycache__").mkdir()
    (folder / "part" / "__pycache__" / "law.pyc").write_bytes(b"compiled")
    assert digest_code(module) == before
    moved = folder / "moved"
    moved.mkdir()
    (folder / "part").rename(moved / "part")
    sys.path.insert(0, str(moved))
    sys.path_importer_cache.clear()
    assert digest_code(module) == before


def test_a_library_counts_by_its_version(folder, monkeypatch):
    place = folder / "site-packages"
    place.mkdir()
    sys.path.insert(0, str(place))
    (folder / "part.py").write_text("import far_away\n")
    (place / "far_away.py").write_text("A = 1\n")
    about = place / "far_away-1.0.dist-info"
    about.mkdir()
    digests = []
    for version in ("1.0", "1.1"):
        (about / "METADATA").write_text(f"Metadata-Version: 2.1\nName: far-away\nVersion: {version}\n")
        plugins.code.find_version.cache_clear()
        sys.path_importer_cache.clear()
        digests.append(digest_code("part"))
        (place / "far_away.py").write_text("A = 2\n")
        assert digest_code("part") == digests[-1]
    assert digests[0] != digests[1]
    plugins.code.find_version.cache_clear()


def test_code_that_changed_after_it_was_imported(tmp_path, monkeypatch):
    """Which of the two this process runs is not known, so that nothing is kept, and a sweep stops."""
    install(tmp_path, "polhode.torques")
    run = Here(tmp_path, monkeypatch)
    from polhode.spacecraft.rigid_body.named import TORQUES, find_part

    find_part(TORQUES, "of-others")
    plugin = Plugin("polhode.torques", "of-others", CONTRIBUTORS["polhode.torques"].point)
    assert digest_plugins([plugin])[plugin]
    set_law(run.folder, 2.0)
    with pytest.raises(plugins.InvalidInput, match=r"the torque of-others .*, changed after this process had imported"):
        digest_plugins([plugin])


def test_a_name_that_is_put_together_while_it_runs(tmp_path, monkeypatch):
    """Its module is in no text; a kept report knows it as it has been imported by then."""
    install(tmp_path, "polhode.torques")
    part, by_name = tmp_path / "part_of_others.py", "from law_of_others import FACTOR\n"
    text = part.read_text()
    assert text.count(by_name) == 1
    joined = 'import importlib\n\nFACTOR = importlib.import_module("law_of" + "_others").FACTOR\n'
    part.write_text(text.replace(by_name, joined))
    run = Here(tmp_path, monkeypatch)
    before = report(run, "polhode.torques")
    set_law(tmp_path, 2.0)
    assert report(run, "polhode.torques") == pytest.approx(2.0 * before)


def test_a_name_that_another_package_has_taken(add_entry_points):
    group, gone = "polhode.torques", Plugin("polhode.torques", "a", "math:pi")
    add_entry_points(group, ("a", "math:pi"))
    assert digest_plugins([gone])[gone]
    add_entry_points(group, ("a", "cmath:pi"))
    assert digest_plugins([gone]) == {gone: ""}


def test_to_be_listed_is_not_to_take_part(tmp_path, monkeypatch):
    """A sweep is not refused because another package was installed, or changed, that has nothing to do with it."""
    install(tmp_path, "polhode.kinds")
    Here(tmp_path, monkeypatch)
    from polhode.kinds import registry
    from polhode.kinds.reading import read_spec

    (tmp_path / "own.toml").write_text(BODY.replace("ADDED", ""))
    with plugins.record_plugins() as used:
        assert "of-others" in {kind.name for kind in registry._importable()}
        assert read_spec(tmp_path / "own.toml").plugins == () and not used
        assert [one.name for one in read_spec(tmp_path / "spec.toml").plugins] == ["of-others"] and used


def test_modules_of_a_distribution():
    dist = EntryPoint("a", "pytest:main", "none").dist
    assert plugins.code.modules_of(dist) == frozenset()
    assert "pytest" in plugins.code.modules_of(plugins.code.metadata.distribution("pytest"))


def test_kernels_are_kept_by_all_that_is_compiled_into_them(monkeypatch):
    """Numbers of operations are written in a file that no list named: kernels of other numbers were taken."""
    from polhode._base.compiled import kept
    from polhode.taylor import kernel_series, kernels

    for width, modules in kernels.MODULES.items():
        before = kept.digest_compiled(modules)
        assert kept.digest_compiled(modules) == before, width
        with monkeypatch.context() as patch:
            patch.setattr(kernel_series, "CODE", kernel_series.CODE + 1)
            assert kept.digest_compiled(modules) != before
