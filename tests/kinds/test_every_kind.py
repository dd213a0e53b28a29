"""What holds of every kind: those in the folder, and one that another package brings."""

import ast
import json
import math
import re
import subprocess
import sys
import threading
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import jaxtyping
import pytest

from polhode.cli.main import main
from polhode.errors import InvalidInput
from polhode.kinds import AbstractKind, Answer, Group, Spec, SpecMotion, reading, registry
from polhode.kinds.page import write_page
from polhode.kinds.reading import read_spec
from polhode.kinds.registry import find_kind
from polhode.testing import LawBroken, check_kind
from polhode.testing.kinds import _check_digits
from sweeping import only

OWN = tuple(registry._own())
OTHERS = ("spherical-pendulum",)
AT_ONCE = ("free-body", "heavy-top", "quantum-rotor", *OTHERS)
"""In closed form, integrated, without a motion, and of another package; the others in the sweep."""
pytestmark = pytest.mark.usefixtures("plugin")


@pytest.fixture(scope="module", params=only(AT_ONCE, [*OWN, *OTHERS]))
def kind(request, plugin):
    return find_kind(request.param)


@pytest.fixture(scope="module")
def spec(kind, tmp_path_factory):
    path = tmp_path_factory.mktemp(kind.name) / "example.toml"
    path.write_text(kind.example, "utf-8")
    return read_spec(path)


@pytest.fixture(scope="module")
def report(spec):
    return spec.report()


@pytest.mark.long_after(1)
def test_a_kind_is_as_it_must_be(kind):
    check_kind(kind)
    if kind.name in OWN:
        assert f"{type(kind).__module__}:KIND" == registry._own()[kind.name].value


@pytest.mark.long
def test_a_kind_without_pictures_is_right_and_has_no_page(monkeypatch, plugin):
    kind = find_kind("spherical-pendulum")
    monkeypatch.setattr(type(kind), "panel", lambda self: None)
    assert not kind.has_pictures
    check_kind(kind)
    with pytest.raises(InvalidInput, match=r"spherical-pendulum has no attitude, and its kind no panel"):
        kind.check_page()
    monkeypatch.setattr(type(kind), "check_page", lambda self: None)
    with pytest.raises(LawBroken, match="neither attitude nor panel refuses a page"):
        check_kind(kind)


def test_ten_kinds_have_answers_without_motion():
    assert len([name for name in OWN if find_kind(name)._find("answers", "answers_without_motion")]) == 10


def test_a_kind_that_derives_from_another_has_its_files(monkeypatch):
    monkeypatch.setattr(jaxtyping.config, "jaxtyping_disable", True)
    heir = type("Heir", (type(find_kind("gyrostat")),), {"__module__": "elsewhere"})()
    assert heir.figures() is find_kind("gyrostat").figures() and heir.panel() is find_kind("gyrostat").panel()
    alone = type("Alone", (AbstractKind,), {"__module__": "elsewhere", "name": "alone"})()
    assert not alone.figures() and alone.panel() is None
    with pytest.raises(NotImplementedError, match=r"the kind alone needs `make_report` in answers\.py"):
        alone.report(None)


def bent_report(report, **bent):
    """A report that is another but for what a specimen bends."""
    found = object.__new__(type("BentReport", (type(report),), bent))
    found.__dict__.update(report.__dict__)
    return found


def bent_kind(kind, **bent):
    """A kind that is another but for what a specimen bends, found by the same name."""
    return type("BentKind", (type(kind),), {"__module__": type(kind).__module__, **bent})()


@pytest.mark.long_cases(
    "free-body-bent6-`has_attitude` says whether", "spin-orbit-bent9-none makes",
    "heavy-top-bent8-`motion` gives the motion of the report, to the bit",
)  # fmt: skip
@pytest.mark.parametrize(
    ("name", "bent", "words"),
    [
        ("free-body", {"name": "Free_Body"}, "a name is words with hyphens"),
        ("free-body", {"table": int}, "`table` is a class derived from SystemTable"),
        ("free-body", {"figures": lambda self: None}, "`figures` returns a mapping"),
        ("free-body", {"panel": lambda self: 3}, "`panel` returns a KindPanel or None"),
        ("free-body", {"__module__": "__main__"}, "a kind is a folder"),
        ("free-body", {"figure_names": ("sphere",)}, "`figures` has the names of `figure_names`"),
        ("free-body", {"has_attitude": False}, "`has_attitude` says whether"),
        ("free-body", {"answers_without_motion": lambda self, spec: [Group("", [Answer("energy", 1.0)])]},
         "what takes no motion is what the report says; energy differs"),
        ("heavy-top", {"motion": lambda self, spec: SpecMotion(spec.report().trajectory.select(slice(9)), None)},
         "`motion` gives the motion of the report, to the bit"),
        ("spin-orbit", {"_scripts": lambda self: ()}, "none makes"),
    ],
)  # fmt: skip
def test_a_kind_that_breaks_a_law_is_found(name, bent, words, monkeypatch):
    kind = bent_kind(find_kind(name), **bent)
    for module in (reading, registry):
        monkeypatch.setattr(module, "find_kind", lambda _: kind)
    with pytest.raises(LawBroken, match=words):
        check_kind(kind)


@pytest.mark.parametrize(
    ("bent", "words"),
    [
        ({"summary": "It turns"}, "the summary is of sentences"),
        ({"notes": ["the period is nan s."]}, "no line says nan"),
        ({"kind": "heavy-top"}, "the report's `kind` is the kind's name"),
        ({"iterate_answers": lambda self: iter(self.answers[1:])}, "yields what `answers` says"),
        ({"units": lambda self: {"speed": "m/s"}}, "there is none called speed"),
        ({"json": lambda self: '{"kind": "free-body", "units": {}}'}, "some answers have units"),
    ],
)
def test_a_report_that_breaks_a_law_is_found(bent, words, monkeypatch):
    kind = find_kind("free-body")
    monkeypatch.setattr(Spec, "report", lambda spec, real=Spec.report: bent_report(real(spec), **bent))
    with pytest.raises(LawBroken, match=words):
        check_kind(kind)


def with_a_field(value):
    """A report that has one field more."""
    return lambda spec, real=Spec.report: vars(report := real(spec)).update(extra=value) or report


class Closed:
    """What is pickled but not read again: its constructor takes more than pickle knows."""

    def __reduce__(self):
        return Closed, ("more",)


@pytest.mark.parametrize(
    ("value", "words"),
    [
        ({"turned": (1.0, lambda t: t)}, r"`report.extra\['turned'\]\[1\]`, <function.*cannot: .*at the top of one"),
        (SimpleNamespace(lock=threading.Lock()), r"`report.extra.lock`, <unlocked.*: cannot pickle '_thread.lock'"),
        (Answer("a", (n for n in ())), r"`report.extra.value`, <generator.*cannot: cannot pickle 'generator'"),
        (Closed(), "can be read again after it is pickled; it raises TypeError"),
    ],
)
def test_what_of_a_report_cannot_be_pickled_is_said_in_words(value, words, monkeypatch):
    monkeypatch.setattr(Spec, "report", with_a_field(value))
    with pytest.raises(LawBroken, match=words):
        check_kind(find_kind("free-body"))


def ends_with_a_number(error=0.0, summary="It turns."):
    """Parts of a report on a motion by steps that ends with a number, and says so."""
    return {
        "answers": property(lambda self: [Group("Motion", [
            Answer("end", float(self.trajectory.momentum[-1, 0]), "", "at the end", error=error)])]),
        "summary": property(lambda self: summary.format(float(self.trajectory.momentum[-1, 0]))),
    }  # fmt: skip


@pytest.mark.parametrize(
    ("bent", "words"),
    [
        (ends_with_a_number(), "has the motion's error, by `from_motion`; end has not"),
        (ends_with_a_number(None, "It ends at {:.6g}."), "a summary has no digits beyond the motion's error"),
    ],
)
def test_digits_beyond_the_error_of_a_motion_are_found(bent, words, tmp_path):
    (tmp_path / "top.toml").write_text(find_kind("heavy-top").example, "utf-8")
    report = read_spec(tmp_path / "top.toml").report()
    _check_digits(report)
    with pytest.raises(LawBroken, match=re.escape(words)):
        _check_digits(bent_report(report, **bent))
    unknown = replace(report, trajectory=replace(report.trajectory, error_estimate=None))
    with pytest.raises(LawBroken, match="a motion by steps has an error estimate, or a note says"):
        _check_digits(unknown)
    _check_digits(bent_report(unknown, notes=["without an error estimate: a specimen."]))


def weakened(source):
    """Return whether a file of a kind lets `simulate` take another method than by default, or make no estimate."""
    calls = [node for node in ast.walk(ast.parse(source)) if isinstance(node, ast.Call)]
    calls = [call for call in calls if isinstance(call.func, ast.Name) and call.func.id == "simulate"]
    given = [{word.arg for word in call.keywords} for call in calls]
    return any(len(call.args) > 3 or keys & {"method", "estimate_error", "tolerance"}
               for call, keys in zip(calls, given, strict=True))  # fmt: skip


def says_how(source):
    return 'Answer("method"' in source and "*accuracy(" in source


def test_a_kind_that_chooses_the_method_says_so():
    """Damped spins went by midpoint steps of .2 rad in silence, and were right to two digits of the six printed."""
    home = Path(registry.__file__).parents[1]
    inside = (path for table in home.glob("*/*/table.py") for path in table.parent.glob("*.py"))
    files = [path for path in inside if weakened(path.read_text("utf-8"))]
    assert {path.parent.name for path in files} >= {"spin_lattice", "sphere_fluid", "vlasov_poisson"}
    silent = [path for path in files if path.name != "panel.py" and not says_how(path.read_text("utf-8"))]
    assert not silent, "give the report Answer('method', …), or leave method and estimate to `simulate`"
    for specimen in ("simulate(a, b, c, Splitting)", "simulate(a, b, c, estimate_error=False)"):
        assert weakened(specimen) and not says_how(specimen)
    assert not weakened("simulate(a, b, c, step=table.step, progress=watch)")


def test_what_is_no_kind_is_refused(monkeypatch):
    monkeypatch.setattr(jaxtyping.config, "jaxtyping_disable", True)
    with pytest.raises(InvalidInput, match="`kind` must be an object of a subclass of AbstractKind"):
        check_kind("free-body")


@pytest.mark.long
def test_no_kind_is_named_outside_its_folder():
    """Nothing else in the package knows one, but the systems that say which they are of: a third party's is as good."""
    home = Path(registry.__file__).parents[1]
    for name in OWN:
        own = Path(sys.modules[type(find_kind(name)).__module__].__file__).parent
        named = re.compile(rf"""["']{name}["']""")
        others = [path for path in home.rglob("*.py") if not path.is_relative_to(own)]
        says_so = f'    kind: ClassVar[str] = "{name}"\n'
        assert not [str(path) for path in others if named.search(path.read_text("utf-8").replace(says_so, ""))], name


def test_remedies_name_a_kind_that_is_there(monkeypatch):
    assert registry.other_kind("top", in_closed_form=True).in_closed_form
    assert registry.other_kind("", in_closed_form=True) is None
    assert registry.other_kind("moon", in_closed_form=False) is None
    assert [find_kind(name).is_default for name in OWN].count(True) == 1
    monkeypatch.setattr(registry, "kind_names", lambda: [])
    assert registry.other_kind("top", in_closed_form=True) is None


@pytest.mark.long
def test_importing_the_registry_imports_no_kind():
    code = (
        "import sys, polhode.kinds.registry as r; names = r.kind_names();"
        "print([m for m in sys.modules if m.startswith('polhode.kinds.') and '.' in m[14:]], len(names),"
        " [m for m in ('jax', 'matplotlib', 'xarray') if m in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=120)
    assert done.stdout.split("] ")[0] == "[" and done.stdout.endswith(f"{len(OWN)} []\n"), done.stdout


def test_a_kind_that_cannot_be_imported_is_named(monkeypatch):
    class Broken:
        group, name, value = registry.GROUP, "broken", "broken_package:KIND"

        def load(self):
            raise ImportError("no such thing")

    monkeypatch.setattr(registry, "_others", lambda: {"broken": Broken()})
    with pytest.raises(InvalidInput, match=r"broken.*broken_package:KIND.*no such thing"):
        find_kind("broken")
    monkeypatch.setattr(Broken, "load", lambda self: object())
    with pytest.raises(InvalidInput, match="is not an AbstractKind"):
        find_kind("broken")


# ---------------------------------------------------------------------- the pendulum of the other package


def test_the_pendulum_by_its_command(tmp_path, monkeypatch, capsys):
    """A conical pendulum, ω² = g/(l cos θ), keeps its height."""
    monkeypatch.chdir(tmp_path)
    rate = math.sqrt(9.80665 / math.cos(math.radians(40.0)))
    text = find_kind("spherical-pendulum").example.replace("2 rad/s", f"{rate!r} rad/s")
    (tmp_path / "cone.toml").write_text(text, "utf-8")
    with pytest.raises(SystemExit, match="0"):
        main(["report", "cone.toml", "--json"])
    values = json.loads(capsys.readouterr().out)
    assert values["highest"] - values["lowest"] < 1e-9 and values["files"][0].endswith("path.png")
    assert abs(values["highest"] + math.cos(math.radians(40.0))) < 1e-9


def test_the_pendulum_s_own_rule(tmp_path):
    (tmp_path / "still.toml").write_text('[system]\nkind = "spherical-pendulum"\nlength = "1 m"\n', "utf-8")
    with pytest.raises(InvalidInput, match=r"system: needs lean, like"):
        read_spec(tmp_path / "still.toml")


@pytest.mark.long_cases("quantum-rotor")
def test_without_a_motion_what_needs_one_is_refused(kind, spec, report, tmp_path):
    """In words, before anything is computed or written; nothing else is. A page may show what does not move."""
    path = tmp_path / "case.toml"
    path.write_text(kind.example, "utf-8")
    if kind.has_motion:
        assert kind.next_steps(spec)[0].command == "view"
        return
    assert write_page(spec, tmp_path / "page.html").stat().st_size > 500_000
    (tmp_path / "page.html").unlink()
    with pytest.raises(InvalidInput, match="has no motion in time"):
        spec.motion()
    for command in (["export", "--to", "csv"], ["export", "--to", "gltf"]):
        with pytest.raises(SystemExit, match="2"):
            main([*command, str(path)])
    assert [file.name for file in tmp_path.iterdir()] == ["case.toml"] and not report.as_json_dict().get("drift")


def test_a_misspelt_kind_is_one_mistake_with_a_hint(tmp_path):
    spec = tmp_path / "case.toml"
    spec.write_text('[system]\nkind = "euler-dsk"\n')
    with pytest.raises(InvalidInput) as refused:
        read_spec(spec)
    assert "1 mistake" in str(refused.value) and str(refused.value).endswith("did you mean euler-disk?")
