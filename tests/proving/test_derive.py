"""``polhode derive``: the list, the forms, the file, and mistakes."""

import sys
from pathlib import Path

import pytest

from polhode._base.plugins import find_entry_points
from polhode.cli.main import main
from polhode.proving.symbolic import registry
from polhode.proving.symbolic.derivation import DerivationBroken
from polhode.proving.symbolic.registry import derivation_names
from registered import forget_entry_points


def run(arguments, capsys):
    with pytest.raises(SystemExit) as stopped:
        main(arguments)
    out, err = capsys.readouterr()
    return stopped.value.code or 0, out, err


def test_all_are_listed(capsys):
    code, out, _ = run(["derive"], capsys)
    assert code == 0 and all(f"{name} " in out for name in derivation_names())
    assert "Next: polhode derive clebsch" in out


@pytest.mark.long
def test_a_page_is_printed_or_written(capsys, tmp_path, monkeypatch):
    code, out, err = run(["derive", "clebsch"], capsys)
    assert code == 0 and not err and out.startswith("Clebsch's case\n==============\n") and "✓" in out
    page = registry.derive("clebsch")
    monkeypatch.setattr(registry, "derive", lambda name: page)
    assert run(["derive", "clebsch", "--to", "markdown"], capsys)[1].startswith("# Clebsch's case")
    begin = {".md": "# Clebsch", ".tex": r"\documentclass", ".html": "<!DOCTYPE", ".txt": "Clebsch"}
    for ending, begins in begin.items():
        path = tmp_path / f"page{ending}"
        code, out, _ = run(["derive", "clebsch", "--out", str(path)], capsys)
        assert code == 0 and out == f"Written: {path}\n" and path.read_text("utf-8").startswith(begins)


@pytest.mark.long_cases("arguments4-page.html")
@pytest.mark.parametrize(("arguments", "message"), [
    (["clebsh"], "Did you mean clebsch?"),
    (["clebsch", "--to", "pdf"], '--to must be one of "text", "markdown", "latex", "html"'),
    (["clebsch", "--out", "page.pdf"], "--out must end with .txt, .md, .tex, .html"),
    (["--to", "html"], "name it"),
    (["clebsch", "--out", "/no/such/folder/page.html"], "page.html"),
])  # fmt: skip
def test_mistakes_are_named(arguments, message, capsys):
    code, out, err = run(["derive", *arguments], capsys)
    assert code == 2 and not out and message in err and err.startswith("polhode: ")


def test_a_step_that_fails_is_an_error(capsys, monkeypatch):
    from polhode.proving.symbolic.derivations import clebsch

    monkeypatch.setattr(clebsch, "inertia", lambda a, theta: [1.0, 2.0, 3.0, 4.0, 5.0, 6.0])
    code, out, err = run(["derive", "clebsch"], capsys)
    assert code == 2 and not out and "the numerical system differs from what is stated" in err


def test_without_sympy_the_command_says_what_to_install(capsys, monkeypatch):
    monkeypatch.setitem(sys.modules, "sympy", None)
    for name in [name for name in sys.modules if name.startswith("polhode.proving.symbolic")]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.delitem(sys.modules, "polhode.proving.symbolic.command", raising=False)
    code, out, err = run(["derive", "clebsch"], capsys)
    assert code == 2 and not out and "need SymPy, which is not installed. Run `" in err


def fail():
    raise ZeroDivisionError("x")


def leave():
    sys.exit(0)


def break_off():
    raise DerivationBroken("step 1 does not hold")


@pytest.mark.parametrize(("value", "words"), [
    (f"{__name__}:fail", "fails (ZeroDivisionError: x). Update or remove it."),
    (f"{__name__}:leave", "fails (SystemExit: 0). Update or remove it."),
    ("math:sin", "fails (TypeError: math.sin() takes exactly one argument"),
    ("math:pi", "must be a function that returns a Page; got 3.14159"), ("math:hypot", "that returns a Page; got 0.0"),
    ("nowhere:derive", "cannot be imported: No module named 'nowhere'. Update or remove it."),
])  # fmt: skip
def test_one_of_others_that_is_none_is_named(add_entry_points, capsys, value, words):
    add_entry_points(registry.GROUP, ("odd", value))
    code, out, err = run(["derive", "odd"], capsys)
    assert code == 2 and not out and f"the derivation odd of another package, {value}" in err and words in err
    code, out, _ = run(["derive"], capsys)  # the list is whole
    assert code == 0 and "clebsch " in out and "\nodd" in out


def test_the_errors_of_polhode_in_one_of_others_stay(add_entry_points):
    add_entry_points(registry.GROUP, ("odd", f"{__name__}:break_off"))
    with pytest.raises(DerivationBroken, match=r"^step 1 does not hold$"):
        registry.derive("odd")


def test_a_name_that_polhode_has_is_its_own(add_entry_points):
    add_entry_points(registry.GROUP, ("clebsch", "math:pi"))
    with pytest.warns(UserWarning, match="the derivation clebsch of another package, math:pi, is ignored"):
        assert derivation_names().count("clebsch") == 1


@pytest.mark.long
def test_one_of_another_package_is_derived(capsys, monkeypatch):
    monkeypatch.syspath_prepend(str(Path(__file__).parents[1] / "plugin"))
    forget_entry_points()
    code, out, _ = run(["derive", "symmetric-body"], capsys)
    assert code == 0 and out.startswith("The symmetric body\n") and "L₃" in out
    assert "symmetric-body    A body with two equal moments" in run(["derive"], capsys)[1]


@pytest.fixture
def two_packages(tmp_path, monkeypatch):
    """Let packages b and a bring one derivation, and return what puts the folder of either first on the path."""
    for name in "ba":
        info = tmp_path / name / f"{name}_package-1.0.dist-info"
        info.mkdir(parents=True)
        (info / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {name}-package\nVersion: 1.0\n")
        (info / "entry_points.txt").write_text(f"[{registry.GROUP}]\nodd = {name}_module:derive\n")

    def put(order):
        for name in reversed(order):
            monkeypatch.syspath_prepend(tmp_path / name)
        forget_entry_points()

    yield put
    forget_entry_points()


@pytest.mark.parametrize("order", ["ab", "ba"])
def test_of_two_packages_with_one_name_the_first_by_the_alphabet_is_taken(two_packages, order):
    two_packages(order)
    words = (r"^two packages bring the derivation odd: a_module:derive of a-package, which is taken, and "
             r"b_module:derive of b-package, which is ignored\. Rename or remove one\.$")  # fmt: skip
    with pytest.warns(UserWarning, match=words) as said:
        for _ in range(2):
            assert find_entry_points(registry.GROUP, ())["odd"].value == "a_module:derive"
    assert len(said) == 1
