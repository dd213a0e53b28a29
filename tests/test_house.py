"""The house keeps its promises: examples in the README run, version and changelog agree, files stay small."""

import doctest
import importlib
import re
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest
from markdown_it import MarkdownIt

import polhode as ph

ROOT = Path(__file__).parents[1]
LONGEST = 450


FENCE = re.compile(r"```python\n(.*?)```", re.DOTALL)
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]
PAGES = [page for page in PAGES if FENCE.search(page.read_text("utf-8"))]


def slow_in_the_sweep(cases, slow):
    """Cases for ``parametrize``: those with a name in ``slow``, which integrate for ten seconds or more, as a sweep."""
    names = {getattr(case, "name", case): case for case in cases}
    return [pytest.param(case, id=name, marks=[pytest.mark.sweep] if name in slow else [])
            for name, case in names.items()]  # fmt: skip


@pytest.mark.long_cases("python.md", "euler_disk.md", "symbolic.md", "tops.md")
@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_python_in_the_docs_runs(page):
    exec(compile("\n".join(FENCE.findall(page.read_text("utf-8"))), page.name, "exec"), {})


def modules_with_examples():
    for path in sorted((ROOT / "src").rglob("*.py")):
        if ">>>" in path.read_text("utf-8"):
            yield ".".join(path.relative_to(ROOT / "src").with_suffix("").parts)


SLOW = {
    "polhode.analysis.continuation", "polhode.spacecraft.damped_body.damped_axes", "polhode.analysis.periodic_branches",
    "polhode.rolling.euler_disk.spin_down", "polhode.fields.point_vortices.equilibria",
    "polhode.measuring.attitudes.attitude_fit", "polhode.measuring.scale", "polhode.spectra.figures.racket_figure",
    "polhode.figures.sphere_figure",
    "polhode.poisson.group_reconstruction", "polhode.rolling.euler_disk.system", "polhode.testing.algebras",
    "polhode.testing.kinds", "polhode.testing.systems",
}  # fmt: skip
LONG = [
    f"polhode.{name}" for name in (
        "analysis.gyrostat_rotations", "analysis.lyapunov_exponents", "analysis.threshold", "_base.arrays.elementwise",
        "fields.sphere_fluid.transport_noise", "proving.symbolic.registry",
    )
]  # fmt: skip


@pytest.mark.long_cases(*LONG)
@pytest.mark.parametrize("name", slow_in_the_sweep(modules_with_examples(), SLOW))
def test_examples_in_docstrings(name):
    found = doctest.testmod(importlib.import_module(name))
    assert found.attempted and not found.failed


def anchors(page):
    """Return the anchors that headings of a page get, as GitHub and MyST make them."""
    titles = re.findall(r"^#+ (.+)$", re.sub(r"```.*?```", "", page.read_text("utf-8"), flags=re.DOTALL), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-") for title in titles}


def test_links_in_the_docs_lead_somewhere():
    for page in [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *(ROOT / "docs").glob("*.md")]:
        for target, anchor in re.findall(r"\]\(([^)#:]*)(?:#([^)]*))?\)", page.read_text("utf-8")):
            if drawn := re.fullmatch(r"images/drawn/(\w+)-(\w+)\.png", target):  # as the documents are built
                spec = ph.read_spec(ROOT / "examples" / f"{drawn[1]}.toml")
                assert drawn[2] in spec.kind.figure_names, f"{page.name}: {target}"
            else:
                there = page.parent / target if target else page
                assert there.exists(), f"{page.name}: {target}"
                assert not anchor or anchor in anchors(there), f"{page.name}: {target}#{anchor}"


def emphasised(page):
    """Yield what a page sets in italics, outside of formulas."""
    text = re.sub(r"\$\$.*?\$\$|\$[^$\n]*\$", "x", page.read_text("utf-8"), flags=re.DOTALL)
    for block in MarkdownIt("commonmark").enable("table").parse(text):
        for k, part in enumerate(block.children or ()):
            if part.type == "em_open":
                yield block.children[k + 1].content


def test_stars_of_duals_are_no_emphasis():
    """"se(3)*, a chain of spins on copies of so(3)*" was half in italics; such a star is written with a backslash."""
    pages = [*(ROOT / "docs").glob("*.md"), ROOT / "README.md", ROOT / "CONTRIBUTING.md", ROOT / "CHANGELOG.md"]
    for page in pages:
        for words in emphasised(page):
            assert words[:1] not in tuple(",.;: "), f"{page.name}: {words}"


def test_messages_show_values_shortly():
    """A value in a message goes through `errors.shown`, which shortens and escapes; `!r` writes all of it."""
    allowed = {"__init__.py", "spice_kernels.py", "time_scales.py"}  # names of attributes; digits of kernels
    written = {path.name for path in (ROOT / "src").rglob("*.py") if "!r}" in path.read_text("utf-8")}
    assert written <= allowed


def test_the_readme_is_read_in_five_minutes():
    assert len((ROOT / "README.md").read_text("utf-8").split()) <= 700


def test_the_changelog_begins_with_this_version():
    versions = re.findall(r"^## (\S+)", (ROOT / "CHANGELOG.md").read_text("utf-8"), flags=re.MULTILINE)
    assert versions[0] == ph.__version__


def test_the_version_stands_in_one_place():
    assert tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]["dynamic"] == ["readme", "version"]
    assert f"\nversion: {ph.__version__}\n" in (ROOT / "CITATION.cff").read_text("utf-8")


def test_links_on_the_package_index_are_absolute():
    settings = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))
    text = (ROOT / "README.md").read_text("utf-8")
    for rule in settings["tool"]["hatch"]["metadata"]["hooks"]["fancy-pypi-readme"]["substitutions"]:
        text = re.sub(rule["pattern"], rule["replacement"], text)
    source = settings["project"]["urls"]["Source"]
    places = f"{source}/blob/main/", "https://raw.githubusercontent.com/polhode/polhode/main/"
    targets = re.findall(r"\]\(([^)]+)\)", text)
    assert any(target.startswith(places[1]) for target in targets), "the README has pictures"
    for target in targets:
        assert target.startswith(("https://", "#")), target
        if target.startswith(places):
            assert (ROOT / target.split("/main/", 1)[1].partition("#")[0]).exists(), target


def test_the_source_archive_has_what_its_own_tests_open():
    """Without `CONTRIBUTING.md` and `benchmarks` the tests of an unpacked one could not be collected or failed."""
    packed = set(tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["tool"]["hatch"]["build"]["targets"]
                 ["sdist"]["include"]) | {"pyproject.toml"}  # fmt: skip
    there = {path.name for path in ROOT.iterdir() if not path.name.startswith(".")} - {"build", "dist"}
    texts = [path.read_text("utf-8") for path in (ROOT / "tests").rglob("*.py")]
    opened = {name for text in texts for name in re.findall(r"""(?:parents\[\d\]|ROOT|root) / "([\w.]+)""", text)}
    assert {"src", "examples", "docs", "benchmarks"} <= opened
    assert opened & there <= packed, f"add {opened & there - packed} to the sdist's include"


def test_files_stay_small():
    long = {p.name: n for p in (ROOT / "src").rglob("*.py") if (n := len(p.read_text("utf-8").splitlines())) > LONGEST}
    assert not long


def test_public_names_are_there():
    for name in ph.__all__:
        assert getattr(ph, name) is not None
    with pytest.raises(AttributeError):
        ph.nothing_of_the_kind  # noqa: B018


@pytest.mark.long_cases("report on a free body")
@pytest.mark.parametrize(
    ("code", "heavy"),
    [
        ("import polhode", "jax matplotlib xarray trimesh scipy pydantic sympy"),
        ("from polhode.cli.main import main; main(['report', r'{spec}', '--out', r'{out}'])", "jax equinox diffrax"),
    ],
    ids=["import", "report on a free body"],
)
def test_heavy_packages_are_imported_only_when_needed(code, heavy, tmp_path):
    code = code.format(spec=ROOT / "examples" / "t_handle.toml", out=tmp_path / "out")
    asked = f"import atexit, sys; atexit.register(lambda: print('\\nimported', *sys.modules)); {code}"
    found = subprocess.run([sys.executable, "-c", asked], capture_output=True, text=True, timeout=120, check=False)
    imported = found.stdout.rpartition("\nimported ")[2].split()
    assert "polhode" in imported, found.stderr
    assert not set(heavy.split()) & set(imported)
