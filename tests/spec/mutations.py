"""Specs changed at random: keys dropped, doubled and renamed, values of other types, sizes, units and scripts."""

import datetime
import json
import math
import re
import tomllib
from pathlib import Path
from typing import get_args

from hypothesis import strategies as st
from pydantic import BaseModel

from polhode.kinds.registry import find_kind, kind_names
from polhode.spec.body_files import body_file_keys
from polhode.spec.models import SpecFile

EXAMPLES = Path(__file__).parents[2] / "examples"
FILES = ("t_handle.stl", "water.xyz")
EXTRA = {
    "inertia": """
body.inertia = [["3 J*s^2", "1 J*s^2", "0 J*s^2"], ["1 J*s^2", "3 J*s^2", "0 J*s^2"], ["0 J*s^2", "0 J*s^2", "3 J*s^2"]]
body.mass = "2 kg"
body.about = ["1 m", "0 m", "0 m"]
body.center_of_mass = ["1 m", "0 m", "0.1 m"]
[spin]
momentum = ["1 J*s", "2 J*s", "0 J*s"]
attitude = [0.5, 0.5, 0.5, 0.5]
[time]
until = "10 s"
[export]
object_name = "BOX"
epoch = 2026-03-01T12:00:00+01:00
spice_id = -999
""",
    "shapes": """
[body]
part = [
  {shape = "torus", mass = "1 kg", major_radius = "2 m", minor_radius = "1 m"},
  {shape = "ellipsoid", mass = "1 kg", semi_axes = ["1 m", "2 m", "3 m"], axis = "-y"},
  {shape = "sphere", mass = "1 kg", radius = "2 m", inner_radius = "1 m", at = ["1 m", "0 m", "0 m"]},
  {shape = "rod", mass = "1 kg", length = "2 m"},
]
[spin]
rate = "2 rad/s"
about = "x"
tilt = "90 deg"
""",
    "assembly": """
[body]
density = "2700 kg/m^3"
[[body.part]]
name = "plate"
shape = "cylinder"
radius = "5 cm"
height = "1 cm"
[[body.part]]
shape = "prism"
sides = 6
radius = "1 cm"
height = "1 cm"
cut = true
[[body.part]]
mass = "1 kg"
inertia = [["3 J*s^2", "0 J*s^2", "0 J*s^2"], ["0 J*s^2", "3 J*s^2", "0 J*s^2"], ["0 J*s^2", "0 J*s^2", "3 J*s^2"]]
about = ["1 cm", "0 cm", "0 cm"]
center_of_mass = ["0 cm", "0 cm", "0 cm"]
attitude = [0.5, 0.5, 0.5, 0.5]
rounding = "6 digits"
[[body.part]]
mesh = "t_handle.stl"
mesh_unit = "mm"
thickness = "1 mm"
at = ["1 m", "0 m", "0 m"]
[[body.part]]
shape = "box"
size = ["1 m", "2 m", "3 m"]
thickness = "1 mm"
density = "2 kg/m^3"
attitude = {axis = [1, 0, 1], angle = "20 deg"}
[[body.part]]
shape = "prism"
outline = [["0 m", "0 m"], ["1 m", "0 m"], ["0 m", "1 m"]]
height = "1 m"
[spin]
rate = "2 rad/s"
about = "z"
""",
    "rounded": """
[body]
moments = ["1.23456e-5 kg*m^2", "2.34567e-5 kg*m^2", "3.58024e-5 kg*m^2"]
rounding = "6 digits"
mass = "1 kg"
center_of_mass = ["1 m", "0 m", "0 m"]
[spin]
rate = "1 rev/s"
about = 3
tilt = "5 deg"
""",
    "vibrating": """
[body]
rotational_constants = ["27.8806 1/cm", "435.348 GHz", "9.2778 1/cm"]
allow_vibration = true
[spin]
temperature = "26.85 degC"
""",
    "coning": """
[body]
moments = ["3 kg*m^2", "3 kg*m^2", "5 kg*m^2"]
[spin]
nutation = "0.6 rad"
precession = "2 rad/s"
""",
    "precessing": """
[system]
kind = "lagrange-top"
pivot = ["0 m", "0 m", "-1 m"]
[body]
moments = ["1 kg*m^2", "1 kg*m^2", "1.5 kg*m^2"]
mass = "1 kg"
[spin]
spin = "20 rad/s"
precession = "slow"
attitude = {axis = [0, 0, 1], angle = "20 deg"}
""",
    "disk": """
[system]
kind = "euler-disk"
mass = "1 kg"
radius = "1 m"
tilt = "50 deg"
heading = "9 deg"
precession = "1 rad/s"
spin = "2 rad/s"
tilt_rate = "0.1 rad/s"
gravity = "1.62 m/s^2"
axial_moment = "0.5 kg*m^2"
center_velocity = ["0 m/s", "1 m/s", "0 m/s"]
dissipation = [
  {law = "boundary-layer", coefficient = "2e-9 W*s^2.5"},
  {law = "dry-contour-friction", coefficient = 1e-4},
]
[time]
until = "1 s"
""",
    "drag on an orbit": """
[system]
kind = "damped-body"
quadratic_drag = "1e-3 N*m*s^2"
orbital_period = "10 s"
eccentricity = 0.1
[body]
moments = ["1 kg*m^2", "2 kg*m^2", "2.5 kg*m^2"]
[spin]
angular_velocity = ["1 rad/s", "0.1 rad/s", "0 rad/s"]
[time]
until = "20 s"
""",
    "nodding": """
[system]
kind = "heavy-top"
pivot = ["0 m", "0 m", "-1 m"]
lean = "20 deg"
[body]
moments = ["1 kg*m^2", "1.2 kg*m^2", "1.5 kg*m^2"]
mass = "1 kg"
[spin]
spin = "20 rad/s"
precession = "1 rad/s"
nutation_rate = "0.1 rad/s"
[time]
until = "1 s"
""",
    "wave of both": """
[system]
kind = "sphere-mhd"
resolution = 8
alfven_wave = {degree = 3, order = 2, vorticity = "1 rad/s", turning = "0.1 rad/s", field = "0.5 rad/s"}
[time]
until = "1 s"
""",
    "coupled by matrices": """
[system]
kind = "spin-lattice"
vectors = [[1.0]]
cells = [4]
bonds = [{cell = [1], matrix = [["1 meV", "0 meV", "0 meV"], ["0 meV", "1 meV", "0 meV"], ["0 meV", "0 meV", "2 meV"]]}]
dipolar = "0.1 meV"
periodic = false
random = true
[time]
until = "1 ps"
""",
    "moon of a planet": """
[system]
kind = "spin-orbit"
eccentricity = 0.05
semi_major_axis = "4e8 m"
gravitational_parameter = "4e14 m^3/s^2"
asphericity = 0.2
section_orbits = 2
[time]
until = "30 d"
""",
    "craft on an orbit": """
[system]
kind = "rigid-body"
[body]
moments = ["1 kg*m^2", "2 kg*m^2", "2.5 kg*m^2"]
[spin]
angular_velocity = ["0.1 rad/s", "0.02 rad/s", "0 rad/s"]
[orbit]
semi_major_axis = "7e6 m"
gravitational_parameter = "4e14 m^3/s^2"
eccentricity = 0.1
inclination = "51 deg"
node = "10 deg"
periapsis = "20 deg"
mean_anomaly = "5 deg"
greenwich = "3 deg"
[[wheel]]
axis = [1, 0, 0]
moment = "1e-3 kg*m^2"
rate = "10 rad/s"
torque = "1e-4 N*m"
friction = "1e-6 N*m*s"
[[torque]]
type = "gravity-gradient"
[time]
until = "20 s"
samples = 5
""",
    "craft that points": """
[system]
kind = "rigid-body"
[body]
moments = ["1 kg*m^2", "2 kg*m^2", "2.5 kg*m^2"]
[spin]
angular_velocity = ["0.01 rad/s", "0.02 rad/s", "0 rad/s"]
[orbit]
period = "90 min"
[control]
law = "quaternion-pd"
target = "nadir"
bandwidth = "0.1 rad/s"
by = "torque"
limit = "0.1 N*m"
within = "1 deg"
[time]
until = "20 s"
samples = 5
""",
}  # fmt: skip
NUMBERS = [
    "0", "-0.0", "1", "-1", "3", "1e-300", "1e-160", "1e-20", "1e-6", "1e6", "1e20", "1e160", "1e300", "1e308",
    "1e-308", "5e-324", "1e999", "nan", "-inf", "12345678901234567890", ".5", "1_0", "0x1", "٣", "", "1 1", "1e",
    "−1", "1,5", "0.1",
]  # fmt: skip
UNITS = [
    "", "kg", "g", "m", "mm", "s", "day", "year", "rad", "deg", "rpm", "rad/s", "deg/s", "Hz", "1/s", "kg*m^2",
    "g*cm²", "J*s", "u*angstrom^2", "kg*m^2/s", "m/s^2", "N*m", "N*m*s", "Pa*s", "W*s^2.5", "lightyear",
    "m^(9^9^9)", "m^99", "degC", "dB", "%", "kg\0", "\x1b[31mkg", "Mpc", "yottagram", "[length]", "kg//m", "K",
    "blorp", "1", "rad rad/s", "count",
]  # fmt: skip
QUANTITY = re.compile(r"([-+]?[.\d][-+.\deE]*)\s*(.*)", re.DOTALL)
KINDS = sorted(name for name in kind_names() if type(find_kind(name)).__module__.startswith("polhode."))
IN_AN_ATTITUDE = ["sequence", "angles"]


def keys_of(model):
    """Yield the keys of a table, and those of the tables in it."""
    for name, field in model.model_fields.items():
        yield name
        inner = [field.annotation]
        while inner:
            one = inner.pop()
            inner += get_args(one)
            if isinstance(one, type) and issubclass(one, BaseModel):
                yield from keys_of(one)


OF_KINDS = {key for name in KINDS for key in keys_of(find_kind(name).table)}
KEYS = sorted({"system", *IN_AN_ATTITUDE, *keys_of(SpecFile), *body_file_keys(), *OF_KINDS})
STRANGE_KEYS = ["", " ", "a.b", "\x1b[2J", "[red]", "ключ", "k" * 3000, '"', "\u202e", "__class__", "0"]
VALUES = [
    True, False, 0, 1, -1, 2, 3, 10**400, -(10**30), 0.0, -0.0, 1e308, 5e-324, math.inf, -math.inf, math.nan, 0.5,
    1e-9, "", " ", "x", "\0", "\x1b[31mred\x1b[0m", "[red]", "[/]", "\u202eabc", "😀" * 9, "a" * 5000, "given",
    "principal", "free", "2", "y", "box", "cylinder", "t_handle.stl", "water.xyz", "/dev/zero", "/dev/stdin", "..",
    "../" * 2000, "a\nb",
    [], [[]], [1], [1, 2, 3], [0, 0, 0], [1e308, 1e308, 1e308], [1e-300, 0, 0], [1, 0, 0, 0],
    [1e-300, 1e-300, 0, 1e-300], ["1 m"] * 3, ["1 kg*m^2"] * 3, ["1e-300 kg*m^2"] * 3, ["1e300 kg*m^2"] * 3,
    [["1 kg*m^2"] * 3] * 3, "slow", "steady", [{}], {}, {"a": {}}, {"kind": "euler-disk"},
    datetime.date(1, 1, 1), datetime.time(1, 2), datetime.datetime(9999, 12, 31, 23, 59, 59), datetime.datetime(
        1, 1, 1, tzinfo=datetime.timezone(datetime.timedelta(hours=14))), datetime.datetime(
        9999, 12, 31, tzinfo=datetime.timezone(datetime.timedelta(hours=-14))),
]  # fmt: skip
TEXT = [
    "\0", "\x1b[31m", "\ufeff", "=", "[", "]", "{", "}", '"', "'", "\n", "\r", ",", ".", "#", "\\", "é", "\u2028",
    "[[a]]\n", "a = 1\n", "[body]\n", "[system]\n", '"""', "9" * 5000, "[" * 3000, "\udcff", "2026-01-01", "inf",
    "- ",
]  # fmt: skip
HOW = [
    "scale", "scale", "scale", "scale", "number", "number", "number", "plain", "plain", "unit", "unit", "value",
    "value", "drop", "rename", "insert", "swap", "wrap", "shorten", "double", "kind", "text", "cut",
]  # fmt: skip
CHANGE = st.tuples(st.sampled_from(HOW), st.integers(0, 10**6), st.integers(0, 10**6), st.integers(0, 10**6))


def bases():
    """Return the examples and the rest of what specs may hold, as tables."""
    texts = {path.stem: path.read_text("utf-8") for path in sorted(EXAMPLES.glob("*.toml"))} | EXTRA
    found = {name: tomllib.loads(text) for name, text in texts.items()}
    for tables in found.values():  # short, so that many go into a second
        kind = tables.get("system", {}).get("kind")
        if kind != "euler-disk" and (kind is None or "time" in find_kind(kind).table.takes):
            tables.setdefault("time", {})["samples"] = 12
    return found


def toml_of(value):
    """Return a value as TOML writes it in one line; bytes that are no text stay what they are."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, int):
        return hex(value) if value > 2**64 else str(value)
    if isinstance(value, float):
        return str(value)
    if isinstance(value, dict):
        return "{" + ", ".join(f"{toml_of(key)} = {toml_of(item)}" for key, item in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(toml_of, value)) + "]"
    return value.isoformat()


def spec_of(tables):
    """Return tables as the text of a spec, a line for each key of the first two levels."""
    lines = [f"{toml_of(key)} = {toml_of(value)}" for key, value in tables.items() if not isinstance(value, dict)]
    for key, value in tables.items():
        if isinstance(value, dict):
            lines += [f"[{toml_of(key)}]", *(f"{toml_of(k)} = {toml_of(v)}" for k, v in value.items())]
    return "\n".join(lines) + "\n"


def mutated(tables, changes):
    """Return the text of tables after changes, each (how, where, what, what else)."""
    tables = {"": tables}
    tables = json_copy(tables)
    for change in changes:
        if change[0] not in ("text", "cut"):
            _change(tables, *change)
    root = tables[""]
    text = spec_of(root) if isinstance(root, dict) else toml_of(root)
    for how, where, what, _ in changes:
        at = where % (len(text) + 1)
        if how == "text":
            text = text[:at] + TEXT[what % len(TEXT)] + text[at:]
        elif how == "cut":
            text = text[:at] + text[at + what % 40 :]
    return text


def json_copy(value):
    """Return a copy of nested tables and lists."""
    if isinstance(value, dict):
        return {key: json_copy(item) for key, item in value.items()}
    return [json_copy(item) for item in value] if isinstance(value, list) else value


def _slots(value):
    """Yield every place that holds a value, as (container, key), below the first."""
    for key in list(value) if isinstance(value, dict) else range(len(value)):
        yield value, key
        if isinstance(value[key], dict | list):
            yield from _slots(value[key])


def _change(tables, how, where, what, more):
    slots = list(_slots(tables))
    quantities = [(c, k) for c, k in slots if isinstance(c[k], str) and QUANTITY.fullmatch(c[k])]
    if how in ("number", "unit") and quantities:
        container, key = quantities[where % len(quantities)]
        number, unit = QUANTITY.fullmatch(container[key]).groups()
        if how == "unit":
            unit = UNITS[what % len(UNITS)]
        elif more % 2:
            number = NUMBERS[what % len(NUMBERS)]
        else:
            number = f"{_float(number) * 10.0 ** (what % 41 - 20):.6g}"
        container[key] = f"{number} {unit}"
        return
    plain = [(c, k) for c, k in slots if type(c[k]) in (int, float)]
    if how == "scale" and quantities:  # all of one unit alike, so that the body may stay a body
        chosen = quantities[where % len(quantities)]
        unit = QUANTITY.fullmatch(chosen[0][chosen[1]])[2]
        for container, key in quantities:
            number, own = QUANTITY.fullmatch(container[key]).groups()
            if own == unit:
                power = what % 321 - 160 if more % 3 else what % 31 - 15
                container[key] = f"{_float(number) * 10.0**power:.9g} {unit}"
        return
    if how == "plain" and plain:
        container, key = plain[where % len(plain)]
        scaled = min(max(container[key], -1e99), 1e99) * 10.0 ** (what % 41 - 20)
        container[key] = scaled if more % 2 else _float(NUMBERS[what % len(NUMBERS)])
        return
    container, key = slots[where % len(slots)]
    if how == "kind":
        if isinstance(tables[""], dict):
            tables[""].setdefault("system", {})
            if isinstance(tables[""]["system"], dict):
                tables[""]["system"]["kind"] = KINDS[what % len(KINDS)]
    elif how == "swap":
        other, place = slots[what % len(slots)]
        if not _inside(container[key], other) and not _inside(other[place], container):
            container[key], other[place] = other[place], container[key]
    elif how == "drop" and key != "":
        del container[key]
    elif how == "rename" and isinstance(container, dict) and key != "":
        container[_key(what)] = container.pop(key)
    elif how == "insert" and isinstance(container[key], dict):
        container[key][_key(what)] = json_copy(VALUES[more % len(VALUES)])
    elif how == "insert" and isinstance(container, dict) and key != "":
        container[_key(what)] = json_copy(VALUES[more % len(VALUES)])
    elif how == "wrap" and key != "":
        container[key] = [container[key]] if what % 2 else {_key(more): container[key]}
    elif how == "shorten" and isinstance(container[key], list | str):
        container[key] = container[key][: what % 4]
    elif how == "double" and isinstance(container[key], list | str):
        container[key] = container[key] * 2
    elif key != "":
        container[key] = json_copy(VALUES[what % len(VALUES)])


def _inside(value, container):
    return value is container or (
        isinstance(value, dict | list)
        and any(_inside(item, container) for item in (value.values() if isinstance(value, dict) else value))
    )


def _key(number):
    known = KEYS + STRANGE_KEYS
    return known[number % len(known)]


def _float(text):
    try:
        return float(text)
    except ValueError:
        return 1.0
