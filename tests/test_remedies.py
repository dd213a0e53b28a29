"""Every message's remedy can be followed: the catalogue of all texts in the package, read from the source.

The library names arguments of Python, in backticks, and the command its options in place of them. What a text calls an
option is one of the commands that the text can come from, or of one that it names; what it calls a key of a spec is
one; what stands in backticks is a name of the code that says it, or of polhode's.
"""

from __future__ import annotations

import ast
import re
import types
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple, get_args, get_origin

import pytest
import typer
from pydantic import BaseModel

import polhode
from polhode._base import check
from polhode._base.plugins.wings import wing_names, wing_points
from polhode.bodies.body import Body
from polhode.cli.commands import app
from polhode.cli.main import main
from polhode.cli.naming import COLUMNS, OF_KERNELS, argument_names, as_options, run_as
from polhode.errors import InvalidInput
from polhode.kinds.base import AbstractKind
from polhode.kinds.reading import read_spec
from polhode.kinds.registry import find_kind, kind_names
from polhode.spec.models import SpecFile
from polhode.sweeps.plan import SweepTable
from registered import every_command

ROOT = Path(polhode.__file__).parent
EXAMPLE = Path(__file__).parents[1] / "examples" / "t_handle.toml"
OPTION = re.compile(r"(?<![\w-])--[a-z][a-z-]*")
ARGUMENT = re.compile(r"`([a-z_]+)(?:=[^`]+)?`")
WHOLE = re.compile(r"`polhode [^`]*`")
TICKED = re.compile(r"`([^`\n]+)`")
TABLES = ("body", "spin", "time", "system", "export", "sweep")
DOTTED = re.compile(rf"(?<![.\w])({'|'.join(TABLES)})\.([a-z][a-z_0-9]+)")
SWITCH = re.compile(r"\b([a-z_]+) = (?:true|false)\b")
OTHERS = {"--xla": "XLA's own, in an environment variable", "--unit-acceleration": "of Betaflight's blackbox_decode",
          "--inertial-stats": "of Gazebo's gz sdf"}  # fmt: skip
# from which commands the texts of a file come; files of cli/ that are not here are their command's alone
FROM = {
    "cli/columns.py": "import compare fit", "studies/sources.py": "import compare",
    "studies/tables.py": "import compare fit",
    "cli/importing.py": "import", "studies/recorded_spec.py": "import",
    "spectra/line_fit_branch.py": "fit",
    "spectra/line_fit.py": "fit", "studies/fit.py": "fit", "cli/fit.py": "fit", "spectra/command.py": "lines",
    "spectra/study.py": "lines", "cli/publish.py": "fit tumble wobble",
    "cli/destinations.py": "view export import fit wobble lines",
    "formats/column_resolution.py": "import compare fit", "formats/column_meaning.py": "import compare fit",
    "formats/calendar_stamps.py": "import compare fit", "formats/attitude_columns.py": "import compare fit",
    "formats/known_tables.py": "import compare fit", "spacecraft/comparing/_clock_offset.py": "compare",
    "formats/plain_table.py": "import compare fit", "spacecraft/formats/spice_reading.py": "import compare fit",
    "proving/symbolic/command.py": "derive", "proving/verdicts/options.py": "report",
    "spec/places.py": "body",
}  # fmt: skip
DECLARED = ("cli/commands/application.py", "cli/commands/specs.py", "cli/commands/records.py",
            "proving/commands.py", "spectra/options.py", "cli/source_options.py", "cli/column_options.py",
            "cli/fit_options.py",
            "cli/naming.py", "celestial/commands.py", "celestial/tumbling/options.py", "course/commands.py",
            "judging/commands.py", "sweeps/commands.py")
"""Where options are declared, with help that speaks of several commands."""
# words in backticks that are of other packages
FOREIGN = {"np.polyfit", "float", "dask scheduler", "JAX_ENABLE_X64"}


class Text(NamedTuple):
    """A text of the source, with what is put into it left out as …, and where it begins."""

    file: str
    line: int
    words: str


def words_of(node: ast.Constant | ast.JoinedStr) -> str:
    """Return a text as it stands in the source, … for what is put into it."""
    parts = node.values if isinstance(node, ast.JoinedStr) else [node]
    return "".join(part.value if isinstance(part, ast.Constant) else "…" for part in parts)


def names_checked(tree: ast.Module) -> set[int]:
    """Return the texts, by their ``id``, that functions of ``check`` are given as names of arguments."""
    calls = (node for node in ast.walk(tree)
             if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.args)
    return {id(call.args[0]) for call in calls
            if isinstance(call.func.value, ast.Name) and call.func.value.id == "check"}  # fmt: skip


@cache
def catalogue() -> tuple[Text, ...]:
    """Return all texts of the package that are no docstrings; names of arguments that are checked in backticks."""
    found = []
    for path in sorted(ROOT.rglob("*.py")):
        tree = ast.parse(path.read_text("utf-8"))
        inside = {id(part) for node in ast.walk(tree) if isinstance(node, ast.JoinedStr) for part in node.values}
        said = {id(node.value) for node in ast.walk(tree) if isinstance(node, ast.Expr)}
        checked = names_checked(tree)
        for node in ast.walk(tree):
            if id(node) in said or id(node) in inside:
                continue
            if isinstance(node, ast.JoinedStr) or (isinstance(node, ast.Constant) and isinstance(node.value, str)):
                words = check.subject(words_of(node)) if id(node) in checked else words_of(node)
                found.append(Text(path.relative_to(ROOT).as_posix(), node.lineno, words))
    return tuple(found)


def test_names_of_arguments_that_are_checked_are_in_the_catalogue():
    tree = ast.parse('check.number("mass", mass)\ncheck.one_of(f"{x}: kind", kind, ("a", "b"))\nother.number("length")')
    by_id = {id(node): node for node in ast.walk(tree)}
    assert {check.subject(words_of(by_id[one])) for one in names_checked(tree)} == {"`mass`", "…: kind"}


@cache
def commands() -> dict[str, set[str]]:
    """Return the options of each command."""
    group: Any = typer.main.get_command(app)
    own = {option for one in group.params for option in (*one.opts, *one.secondary_opts)}
    every = {name: command.get_params(typer.Context(command)) for name, command in every_command().items()}
    return {name: own | {option for one in params for option in (*one.opts, *one.secondary_opts)}
            for name, params in every.items()}  # fmt: skip


def commands_of(text: Text) -> set[str]:
    """Return the commands that the text can come from, or names."""
    named = {name for name in commands() if f"polhode {name}" in text.words}
    if named:
        return named
    own = commands_by_file(text.file)
    stem = Path(text.file).stem.split("_")[0]
    return {stem} if not own and text.file.startswith("cli/") and stem in commands() else own


def commands_by_file(file: str) -> set[str]:
    """Return the commands that the texts of a file come from, by the table above or the wing that it lies in."""
    wing, points = file.partition("/")[0], wing_points("polhode.commands")
    if file in FROM or wing not in wing_names() or (ROOT / file).with_name("table.py").exists():  # of a kind
        return set(FROM.get(file, "").split())
    own = {name for name in points if points[name].value.startswith(f"polhode.{wing}.")}
    own = {name for name in own if name[:5] == file.split("/")[1][:5]} or own
    fits = any(point.value.startswith(f"polhode.{wing}.") for point in wing_points("polhode.fits").values())
    return own or ({"fit"} if fits else set())


def wrong_options(texts: Iterator[Text] | tuple[Text, ...]) -> list[str]:
    """Return what is wrong with the options that texts name."""
    found = []
    for text in texts:
        for option in sorted(set(OPTION.findall(text.words)) - OTHERS.keys()):
            anywhere = [name for name, options in commands().items() if option in options]
            if not anywhere:
                found.append(f"{text.file}:{text.line}: no command has {option}")
            elif text.file not in DECLARED and any(option not in commands()[name] for name in commands_of(text)):
                found.append(f"{text.file}:{text.line}: {commands_of(text)} do not all have {option}")
            elif text.file not in DECLARED and not commands_of(text):
                found.append(f"{text.file}:{text.line}: say in FROM which commands say this: {text.words!r}")
    return found


@pytest.mark.long
def test_options_that_messages_name_are_there():
    """Of `polhode fit` on a C-kernel the remedy was --sclk, which it has not; a note advised --unit-acceleration."""
    assert wrong_options(catalogue()) == []


@pytest.mark.parametrize("words", ["Choose one with --segment.", "give it with --sclk FILE.tsc.", "Write --offsets."])
def test_the_catalogue_would_notice(words):
    assert wrong_options((Text("spacecraft/formats/spice_reading.py", 1, words),))


# ---------------------------------------------------------------- arguments, which the command calls by its options


@cache
def contexts() -> dict[str, Any]:
    """Return what the command knows of each of its commands as it runs, without options given."""
    return {name: types.SimpleNamespace(command=one, params={}) for name, one in every_command().items()}


def options_outside(texts: Iterator[Text] | tuple[Text, ...]) -> list[str]:
    """Return the options in texts of the library, which speaks to Python too; whole commands may have some."""
    return [f"{text.file}:{text.line}: {option}" for text in texts if not is_of_a_command(text.file)
            for option in OPTION.findall(WHOLE.sub("", text.words)) if option not in OTHERS]  # fmt: skip


def is_of_a_command(file: str) -> bool:
    """Whether a file is the command's, which speaks of options; in a wing it is called so."""
    room, _, rest = file.partition("/")
    return room == "cli" or (room in wing_names() and Path(rest).name in ("command.py", "commands.py", "options.py"))


def test_the_library_speaks_of_arguments():
    assert options_outside(catalogue()) == []
    clocks = Text("spacecraft/comparing/clocks.py", 1, "Say it by --offset.")
    assert options_outside((clocks,)) == [f"{clocks.file}:1: --offset"]


UNHEARD = {"proving/enclosures/_motion_starts.py": "moments", "course/exercises.py": "to",
           "spacecraft/formats/urdf.py": "mass",
           "integrators/_series.py": "order", "rolling/euler_disk/answers.py": "precession",
           "testing/kinds.py": "figures", "spacecraft/systems/moving_parts.py": "mass",
           "judging/fixed_steps.py": "order",
           "sweeps/answers.py": "spec"}  # fmt: skip
"""Names of keys, methods and attributes in texts that do not come from the commands that have such an option."""


def wrong_arguments(texts: Iterator[Text] | tuple[Text, ...]) -> list[str]:
    """Return names in backticks that a command would take for an argument that they are not, or not know as one."""
    found = []
    for text in texts:
        for name in set(ARGUMENT.findall(text.words)) - {COLUMNS, *OF_KERNELS}:
            having = {command for command, context in contexts().items() if name in argument_names(context)}
            if is_of_a_command(text.file) or not having or UNHEARD.get(text.file) == name:
                continue
            own = commands_by_file(text.file)
            if own - having and (text.file in FROM or name not in parameters_in(text.file)):
                found.append(f"{text.file}:{text.line}: {own - having} have no option for `{name}`")
            elif not own and name not in parameters_in(text.file):
                found.append(f"{text.file}:{text.line}: `{name}` would be taken for an option of {having}")
    return found


@cache
def parameters_in(file: str) -> frozenset[str]:
    """Return the names of all arguments of a file's functions."""
    tree = ast.parse((ROOT / file).read_text("utf-8"))
    return frozenset(node.arg for node in ast.walk(tree) if isinstance(node, ast.arg))


def test_the_command_knows_the_arguments_that_messages_name():
    assert wrong_arguments(catalogue()) == []


@pytest.mark.parametrize("case", [("measuring/throws/gyro_logs.py", "Say it by `align_clock=True`."),
                                  ("spec/known_inertia.py", "`about` is far away.")])  # fmt: skip
def test_a_name_that_is_no_argument_would_be_noticed(case):
    file, words = case
    assert len(wrong_arguments((Text(file, 1, words),))) == 1


@pytest.mark.parametrize("case", [
    ("compare", "`align_clock=True`", "--align-clock"), ("compare", '`offset="-68.5s"`', "--offset=-68.5s"),
    ("compare", "`align_clock=False`", "--align-clock"), ("fit", "`columns=[x`", "--mapping"),
    ("compare", "as `offset` says", "as --offset says"), ("compare", "`spec_of`", "`spec_of`"),
    ("fit", '`columns={"time": "t", "time_unit": "s"}` of `polhode.fit`', "--time t --time-unit s"),
    ("fit", "`columns` is", "--mapping is"), ("fit", "`rotor=True` or `rotor=False`", "--rotor or --no-rotor"),
    ("fit", "`sclk` of `polhode.spacecraft.read_ck`", "--sclk of `polhode import` and `polhode compare`"),
    ("fit", "by `windows=[(start, end)]`", "by --window START,END"), ("lines", "`lowest`", "--from"),
    ("tumble", '`precession="27.38 h"`', '--precession "27.38 h"'),
    ("tumble", "`moments=(0.61, 0.965, 1)`", "--moments 0.61 0.965 1"), ("lines", "`dipole=(0, 1)`", "--dipole 0,1"),
])  # fmt: skip
def test_the_command_says_its_options(case):
    command, text, said = case
    assert as_options(text) == text
    with run_as(contexts()[command]):
        assert as_options(text) == said


def test_python_and_the_command_each_get_their_own_words(tmp_path, capsys):
    """Functions of Python asked for --align-clock, --precession and --time."""
    rows = "".join(f"{k},{k + 0.5},0,0\n" for k in range(9))
    (tmp_path / "z.csv").write_text(f"p,q,r,s\n{rows}")
    log = str(tmp_path / "z.csv")
    cases = [
        (lambda: polhode.tumble("foo"), ["tumble", "foo"], "give `precession`, `rotation` and `moments`.",
         "give --precession, --rotation and --moments."),
        (lambda: polhode.fit(log), ["fit", log], '"gyro": "gx,gy,gz", "unit": "deg/s"}` of `polhode.fit`.',
         "like --time t --time-unit s --gyro gx,gy,gz --unit deg/s."),
        (lambda: polhode.compare(log, log), ["compare", log, log], 'like `columns={"time": "t", "time_unit": "s", ',
         "like --time t --time-unit s --quat qw,qx,qy,qz --order wxyz --gyro gx,gy,gz --unit deg/s."),
        (lambda: polhode.wobble(start="1"), ["wobble", "--from", "1"], "`start` must be a day", "--from must be a day"),
    ]  # fmt: skip
    for call, arguments, in_python, on_command_line in cases:
        with pytest.raises(InvalidInput) as refused:
            call()
        assert in_python in str(refused.value) and "--" not in str(refused.value)
        with pytest.raises(SystemExit):
            main(arguments)
        assert on_command_line in (err := capsys.readouterr().err) and "`precession`" not in err


# ---------------------------------------------------------------- keys of a spec


def _models(at: Any) -> Iterator[type[BaseModel]]:
    """Yield the models in an annotation, and in those of their fields."""
    if isinstance(at, type) and issubclass(at, BaseModel):
        yield at
        for field in at.model_fields.values():
            yield from _models(field.annotation)
    elif get_origin(at) is not None or isinstance(at, types.UnionType):
        for part in get_args(at):
            yield from _models(part)


@cache
def keys() -> dict[str, set[str]]:
    """Return the keys of each table of a spec, with those of all kinds in `system`."""
    found = {name: {key for model in _models(field.annotation) for key in model.model_fields}
             for name, field in SpecFile.model_fields.items()}  # fmt: skip
    found["sweep"] = set(SweepTable.model_fields)
    found["system"] = {"kind"}.union(
        *(model.model_fields for name in kind_names() for model in _models(find_kind(name).table))
    )
    return found


@pytest.mark.long
def test_keys_that_messages_name_are_there():
    wrong = []
    every = set().union(*keys().values())
    for text in catalogue():
        for table, key in DOTTED.findall(text.words):
            if table in keys() and key not in keys()[table] and key not in ("toml", "zarr"):
                wrong.append(f"{text.file}:{text.line}: no spec has {table}.{key}")
        for key in SWITCH.findall(text.words):
            if key not in every:
                wrong.append(f"{text.file}:{text.line}: no spec has {key}")
    assert wrong == []


# ---------------------------------------------------------------- names in backticks


@cache
def names_in(file: str) -> frozenset[str]:
    """Return all names that the code of a file uses or makes."""
    found = set()
    for node in ast.walk(ast.parse((ROOT / file).read_text("utf-8"))):
        named = (getattr(node, name, None) for name in ("id", "arg", "attr", "name"))
        found |= {name for name in named if isinstance(name, str)}
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and node.value.isidentifier():
            found.add(node.value)  # names that are looked up
    return frozenset(found)


@cache
def all_names() -> frozenset[str]:
    return frozenset().union(*(names_in(path.relative_to(ROOT).as_posix()) for path in ROOT.rglob("*.py")))


@pytest.mark.long
def test_what_stands_in_backticks_is_a_name():
    every, wrong = set().union(*keys().values()), []
    for text in catalogue():
        for ticked in TICKED.findall(text.words):
            if "…" in ticked or ticked in FOREIGN or OPTION.match(ticked) or text.words.count("`") % 2:
                continue
            if ticked.startswith("polhode "):
                if ticked.split()[1] not in commands():
                    wrong.append(f"{text.file}:{text.line}: no command is called `{ticked}`")
                continue
            near = names_in(text.file) | every
            for name in re.findall(r"[A-Za-z_]\w*", re.sub(r'"[^"]*"|(?<=\.)\w+', "", ticked)):
                if name not in near and name not in all_names() and name not in ("lambda", "True", "False", "if"):
                    wrong.append(f"{text.file}:{text.line}: `{ticked}` names {name}, which nothing is called")
    assert wrong == []


# ---------------------------------------------------------------- remedies that fit where they are said


def test_nobody_who_has_asked_for_repair_is_told_to():
    corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    faces = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
    corners += [[0.2, 0.2, 0.2], [0.3, 0.2, 0.2], [0.2, 0.3, 0.2], [0.2, 0.2, 0.3]]
    inside = [[a + 4, b + 4, c + 4] for a, b, c in faces]
    for wrong in ([*faces[:3], *inside], [[0, 1, 2], *faces[1:]], [face[::-1] for face in faces], [*faces, *inside],
                  [*faces, [0, 0, 1]]):  # fmt: skip
        with pytest.raises(InvalidInput, match=r"(ask for|Ask for|with) repair.*repair = true in a spec, repair=True"):
            Body.from_mesh(corners, wrong, density=1.0)
        try:
            Body.from_mesh(corners, wrong, density=1.0, repair=True)
        except InvalidInput as error:
            assert "ask for repair" not in str(error) and "with repair" not in str(error)


def test_a_spec_that_asks_for_repair_is_not_told_to(tmp_path, capsys):
    corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 1 1\n"
    (tmp_path / "open.obj").write_text(f"{corners}f 1 3 2\nf 1 2 4\nf 5 3 2\nf 5 4 1\n")
    spec = tmp_path / "open.toml"
    for asked, told in ((False, True), (True, False)):
        said = "repair = true\n" if asked else ""
        spec.write_text(f'[body]\nmesh = "open.obj"\nmesh_unit = "m"\ndensity = "1 kg/m^3"\n{said}')
        with pytest.raises(SystemExit):
            main(["body", str(spec)])
        assert ("with repair" in capsys.readouterr().err) == told


def test_a_page_is_offered_only_where_one_can_be_made():
    class Counted(AbstractKind):
        """Of another package: something that moves and has neither an attitude nor panels."""

        name, has_attitude = "counted", False
        _has = staticmethod(lambda name: False)  # no folder, no files

        def report(self, spec):
            raise NotImplementedError("this test asks for next steps only")

    assert not Counted().next_steps(read_spec(EXAMPLE))
