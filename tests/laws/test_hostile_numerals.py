"""Numbers that cost minutes, or that Python takes and nobody means, at every door that makes exact numbers of text.

Each door ends soon, by a plain message or a number. `certify` with `attitude = [1.0, 1e-99999999, 0.0, 0.0]` did not:
its file had no bound, which its argument `exact` had.
"""

import pytest
import sympy

import polhode as ph
from judged import run
from polhode._base.rational import read_number
from polhode.errors import PolhodeError
from polhode.proving import LiePoissonBracket, SymbolicSystem
from polhode.spacecraft import read_urdf_inertial
from polhode.spacecraft.comparing.clocks import parse_clocks
from polhode.spec.keys import number_at, with_value
from polhode.spec.models import SpecFile
from polhode.spec.units import parse_exactly, parse_quantity
from polhode.spectra import read_lin, read_par

pytest.importorskip("flint")
NUMERALS = ["1e99999999", "1e-99999999", "0e99999999", "0e-99999999", "1e99999999999999999999", "-1e9999999",
            "1e9_9999_9999", "1E٩٩٩٩٩٩٩٩", "9" * 5000, "1/" + "9" * 5000, "0." + "9" * 5000, "1/0", "nan", "-inf",
            "1e5000", "1e-5000"]  # fmt: skip
MOTION = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 0.2, 1.0))
SO3 = ph.algebra.SO3()
I1 = sympy.Symbol("I1", positive=True)
BODY = SymbolicSystem(LiePoissonBracket(SO3, ["L1", "L2", "L3"], parameters=[I1]), sympy.Symbol("L1") ** 2 / I1)
TABLE = SO3.structure_constants().astype(int).astype(object)


def with_text(text):
    table = TABLE.copy()
    table[0, 1, 2], table[1, 0, 2] = text, f"-{text}"
    return table


SPEC = """
[body]
moments = ["{moment} kg*m^2", "2 kg*m^2", "3 kg*m^2"]
[spin]
momentum = ["0.3 kg*m^2/s", "0.2 kg*m^2/s", "1 kg*m^2/s"]
attitude = [1.0, {attitude}, 0.0, 0.0]
[time]
until = "1 s"
samples = {samples}
"""
FUNCTIONS = {
    "read_number": read_number,
    "exact=": lambda text: ph.certify(MOTION, exact={"momentum": (text, "0.2", "1")}, digits=5),
    "state(t)": lambda text: ph.certify(MOTION, digits=5).state(text),
    "in an enclosure": lambda text: text in ph.certify(MOTION, digits=5).period,
    "parameter of a symbolic system": lambda text: BODY.subs({"I1": text}),
    "symbolic system that runs": lambda text: BODY.to_system({"I1": text}),
    "table of a bracket": lambda text: LiePoissonBracket(with_text(text)),
    "constants of an algebra": lambda text: ph.algebra.from_structure_constants(with_text(text), casimirs=[]),
    "quantity": lambda text: parse_quantity(f"{text} kg", "kg"),
    "exact quantity": lambda text: parse_exactly(f"{text} kg", "kg"),
    "offset of clocks": lambda text: parse_clocks(f"{text} s", False),
    "place in a key": lambda text: number_at(f"spin.momentum.{text}", SpecFile),
    "place in a list": lambda text: with_value({"body": {"moments": ["1 kg*m^2"]}}, f"body.moments.{text}", "2 kg*m^2"),
}


@pytest.mark.parametrize("door", FUNCTIONS)
@pytest.mark.parametrize("text", NUMERALS, ids=lambda x: x[:24])
def test_a_function_takes_it_or_says_why_not(door, text):
    try:
        FUNCTIONS[door](text)
    except (PolhodeError, ValueError) as error:  # readers of a spec raise ValueError for pydantic, in words
        assert len(str(error)) < 500 and "sys." not in str(error) and "Decimal" not in str(error), error


def spec_with(**values):
    return SPEC.format(**({"moment": "1", "attitude": "0.5", "samples": "5"} | values))


def judged_run(text):
    states = '"attitudes": [[1, 0, 0, 0], [1, 0, 0, 0], [1, 0, 0, 0], [1, 0, 0, 0]], "momenta": ' + str([[0, 0, 1]] * 4)
    return ('{"format": "polhode engine states", "version": 1, "engine": "mine", "axes": "body", "runs": [{'
            f'"inertia": [1, 2, {text}], "attitude": [1, 0, 0, 0], "momentum": [0, 0, 1], '
            f'"dt": 0.01, "times": [0.01, 0.02, 0.03, 0.04], {states}}}]}}')


PAR = "top\n 2 1 1 0\ns 1 1 0 99 0 1 1 1 0\n 100 4000.0 1e-3 /B\n 1000 {} 1e-3 /more\n"
LIN = "  1  1  0  0  0  0  0  0  0  0  0  0  4829.66 {}\n"
URDF = ('<robot name="r"><link name="a"><inertial><mass value="{}"/><inertia ixx="1" iyy="2" izz="2.5" ixy="0" ixz="0" '
        'iyz="0"/></inertial></link></robot>')  # fmt: skip
# file, content, command or reader, and a number that it takes
FILES = {
    "moments of a spec, certified": ("b.toml", lambda x: spec_with(moment=x), ["certify", "b.toml"], "2.5"),
    "attitude of a spec, certified": ("b.toml", lambda x: spec_with(attitude=x), ["certify", "b.toml"], "1_0.25"),
    "attitude of a spec, reported": ("b.toml", lambda x: spec_with(attitude=x), ["report", "b.toml"], "0.25"),
    "count in a spec": ("b.toml", lambda x: spec_with(samples=x), ["report", "b.toml"], "7"),
    "time of a state": ("b.toml", lambda x: spec_with(), ["certify", "b.toml", "--at", "{text} s"], "1e3"),
    "count of digits": ("b.toml", lambda x: spec_with(), ["certify", "b.toml", "--digits", "{text}"], "7"),
    "stamp of a table": ("t.csv", lambda x: f"time,qw,qx,qy,qz\n1605400445005000000,1,0,0,0\n{x},1,0,0,0\n",
                         ["import", "t.csv", "--time-unit", "ns", "--time", "time", "--quat", "qw,qx,qy,qz",
                          "--direction", "body-to-space"], "1605400445006000000"),
    "place of an atom": ("m.xyz", "2\n\nO 0 0 0\nC {} 0 1\n".format, ["levels", "m.xyz"], "0.25"),
    "number in JSON": ("runs.json", judged_run, ["judge", "runs.json"], "2.5"),
    "mass of a robot": ("r.urdf", URDF.format, read_urdf_inertial, "0.25"),
    "error of a line": ("m.lin", LIN.format, read_lin, "0.25"),
    "constant of a molecule": ("m.par", PAR.format, read_par, "5000.0"),
}  # fmt: skip


def enter(door, text, folder):
    """Return what a door said about a number, "" where it took it, and its exit code."""
    name, content, way, _ = FILES[door]
    (folder / name).write_text(content(text), "utf-8")
    if callable(way):
        try:
            way(folder / name)
        except PolhodeError as error:
            return str(error), 2
        return "", 0
    ended = run([argument.replace("{text}", text) for argument in way], folder)
    assert not ended.raised and "Traceback" not in ended.error, ended
    return ended.error, ended.code


@pytest.mark.long
@pytest.mark.parametrize("door", FILES)
def test_a_door_takes_an_ordinary_number(door, tmp_path):
    said, code = enter(door, FILES[door][3], tmp_path)
    assert code in (0, 1), said


@pytest.mark.long
@pytest.mark.parametrize("door", FILES)
@pytest.mark.parametrize("text", NUMERALS, ids=lambda x: x[:24])
def test_a_door_takes_it_or_says_why_not(door, text, tmp_path):
    said, code = enter(door, text, tmp_path)
    assert code in (0, 1, 2) and len(said) < 3000 and "sys." not in said and "Decimal" not in said, said
