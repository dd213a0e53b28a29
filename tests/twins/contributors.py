"""Packages of others, one for each group of entry points, whose law is a number in a second module of theirs.

Each offers a spec or file that uses it, and its answer is proportional to that number, whatever else polhode keeps.
"""

import json
import shutil
import sys
from pathlib import Path
from typing import NamedTuple

PLUGINS = Path(__file__).parents[1] / "plugin"
HELPER = "law_of_others"  # the second module, beside the first one
SWEEP = """
[sweep]
outputs = ["OUTPUT"]
chunk = 1
[sweep.inputs]
"time.until" = { grid = ["2 s", "2.5 s"] }
"""
BODY = """[system]
kind = "rigid-body"
[body]
moments = ["1 kg*m^2", "1.5 kg*m^2", "2 kg*m^2"]
ADDED
[time]
until = "2 s"
samples = 3
"""
# a constant torque about the third axis: from rest, I3 Ω3 = torque × time
TORQUE = """
import jax.numpy as jnp
from polhode.spacecraft import AbstractTorque
from law_of_others import FACTOR

class Part(AbstractTorque):
    def torque(self, t, attitude, angular_velocity, actuator=None):
        return jnp.zeros_like(angular_velocity).at[..., 2].set(0.1 * FACTOR)
"""
LAW = """
import jax.numpy as jnp
from polhode.spacecraft import AbstractControlLaw
from law_of_others import FACTOR

class Part(AbstractControlLaw):
    def wanted(self, t, attitude, angular_velocity, own):
        return jnp.zeros_like(angular_velocity).at[..., 2].set(0.1 * FACTOR)
"""
# a rotor that always turns: at rest the body's whole momentum is the rotor's
MOUNT = """
import jax.numpy as jnp
from polhode.spacecraft import AbstractMount
from law_of_others import FACTOR

class Part(AbstractMount):
    def momentum(self, own):
        return jnp.zeros((*own.shape[:-1], 3)).at[..., 2].set(0.2 * FACTOR)
"""


class Contributor(NamedTuple):
    """A package of others.

    Attributes:
        added: to a spec of a body, to use it; a whole spec of a kind; "" for none.
        code: of its module; "" for a copy of a package of ``tests/plugin``.
        copied: which one, and the changes of its files that bring in the law: file, old, new.
        name: of the entry point.
        point: its object.
        answer: path in a report's JSON.
        value: of it where the law is 1.
        output: of a sweep.
    """

    added: str = ""
    code: str = ""
    copied: tuple[str, tuple[tuple[str, str, str], ...]] = ("", ())
    name: str = "of-others"
    point: str = "part_of_others:Part"
    answer: tuple[str, ...] = ()
    value: float = 0.0
    output: str = ""


CONTRIBUTORS = {
    "polhode.kinds": Contributor(
        added='[system]\nkind = "of-others"\nlength = "1 m"\nlean = "40 deg"\n[time]\nuntil = "2 s"\nsamples = 3\n',
        copied=("spherical_pendulum", (
            ("answers.py", "import jax.numpy as jnp\n", "import jax.numpy as jnp\nfrom law_of_others import FACTOR\n"),
            ("answers.py", 'Answer("length", float(self.system.length)',
             'Answer("length", FACTOR * float(self.system.length)'),
            ("answers.py", "table.gravity)", "FACTOR * table.gravity)"),
            *((file, '"spherical-pendulum"', '"of-others"') for file in ("__init__.py", "answers.py", "system.py")))),
        point="spherical_pendulum:KIND", answer=("length",), value=1.0, output="length"),
    "polhode.torques": Contributor('[[torque]]\ntype = "of-others"', TORQUE,
                                   answer=("end", "angular_velocity"), value=0.1, output="end.angular_velocity"),
    "polhode.mounts": Contributor('[[mount]]\ntype = "of-others"', MOUNT, answer=("start", "momentum"), value=0.2,
                                  output="start.momentum"),
    "polhode.control": Contributor('[control]\nlaw = "of-others"\nby = "torque"', LAW,
                                   answer=("end", "angular_velocity"), value=0.1, output="end.angular_velocity"),
    "polhode.bodies": Contributor(
        copied=("mass_list", (
            ("__init__.py", "from polhode.bodies import Body\n",
             "from law_of_others import FACTOR\nfrom polhode.bodies import Body\n"),
            ("__init__.py", "np.loadtxt(path, ndmin=2)", "np.loadtxt(path, ndmin=2) * [FACTOR, 1, 1, 1]"))),
        added='[body]\nof-others = "masses.txt"\n[spin]\nmomentum = ["1 J*s", "1 J*s", "1 J*s"]\n'
              '[time]\nuntil = "2 s"\nsamples = 3\n',
        point="mass_list:BODY_FILE", answer=("mass",), value=6.0, output="mass"),
    "polhode.formats": Contributor(
        copied=("quaternion_log", (
            ("__init__.py", "from polhode.formats import Content",
             "from law_of_others import FACTOR\nfrom polhode.formats import Content"),
            ("__init__.py", '"qlog"', '"of-others"'), ("__init__.py", "{time!r} ", "{FACTOR * time!r} "))),
        point="quaternion_log:FORM", value=2.0),
    "polhode.fits": Contributor(
        copied=("swing_timer", (
            ("report.py", "import numpy as np\n", "import numpy as np\nfrom law_of_others import FACTOR\n"),
            ("report.py", "float(period)", "FACTOR * float(period)"), ("branch.py", '".swings"', '".txt"'))),
        point="swing_timer.branch:FIT", answer=("period",), value=2.0),
    "polhode.report-options": Contributor(
        copied=("report_card", (
            ("__init__.py", "from typing import TYPE_CHECKING\n",
             "from typing import TYPE_CHECKING\nfrom law_of_others import FACTOR\n"),
            ("__init__.py", "{report.summary}", "{FACTOR}"))),
        point="report_card:write_card", value=1.0),
    "polhode.derivations": Contributor(
        copied=("symmetric_body", (
            ("__init__.py", "import sympy\n", "import sympy\nfrom law_of_others import FACTOR\n"),
            ("__init__.py", '"The symmetric body"', 'f"A body {FACTOR}"'))),
        point="symmetric_body:derive", value=1.0),
    "polhode.figures": Contributor(
        copied=("spin_rate", (
            ("__init__.py", "import numpy as np\n", "import numpy as np\nfrom law_of_others import FACTOR\n"),
            ("__init__.py", "axes.set_title(report.name)", 'axes.set_title(f"factor {FACTOR}")'))),
        name="rigid-body.of_others", point="spin_rate:draw_spin_rate", value=1.0),
    "polhode.commands": Contributor(
        copied=("swing_timer", (
            ("report.py", "import numpy as np\n", "import numpy as np\nfrom law_of_others import FACTOR\n"),
            ("report.py", "float(period)", "FACTOR * float(period)"))),
        point="swing_timer.command:swings", answer=("period",), value=2.0),
}  # fmt: skip


def install(folder, group):
    """Write a package with its entry point into a folder, and what uses it; its law is 1."""
    it = CONTRIBUTORS[group]
    name, changes = it.copied
    if name:
        shutil.copytree(PLUGINS / name, folder / name, ignore=shutil.ignore_patterns("__pycache__"))
        for file, old, new in changes:
            text = (folder / name / file).read_text()
            assert text.count(old) == 1, (file, old)
            (folder / name / file).write_text(text.replace(old, new))
    else:
        (folder / "part_of_others.py").write_text(it.code)
    about = folder / "of_others-1.0.dist-info"
    about.mkdir()
    (about / "METADATA").write_text("Metadata-Version: 2.1\nName: of-others\nVersion: 1.0\n")
    (about / "entry_points.txt").write_text(f"[{group}]\n{it.name} = {it.point}\n")
    set_law(folder, 1.0)
    whole = it.added if group in ("polhode.kinds", "polhode.bodies") else BODY.replace("ADDED", it.added)
    (folder / "spec.toml").write_text(whole + (SWEEP.replace("OUTPUT", it.output) if it.output else ""))
    (folder / "masses.txt").write_text("1 2 0 0\n1 -2 0 0\n2 0 1 0\n2 0 -1 0\n")  # together 6
    (folder / "times.txt").write_text("0\n1\n2\n3\n")  # of a swing: it lasts 2


def set_law(folder, factor):
    """Change the number, and the size of the file, without which Python would take what it compiled in this second."""
    (folder / f"{HELPER}.py").write_text(f"FACTOR = {factor!r}\n" + "#" * int(100 * factor) + "\n")


def forget(folder):
    """Let this process find the packages of a folder as a new one does."""
    names = {path.stem for path in folder.glob("*.py")} | {path.name for path in folder.iterdir() if path.is_dir()}
    for module in [name for name in sys.modules if name.partition(".")[0] in names]:
        del sys.modules[module]


def number_in(text, group):
    """Return the answer in a report's JSON: a number, or the last component."""
    value = json.loads(text[text.index("{") :])
    for key in CONTRIBUTORS[group].answer:
        value = value[key]
    return value[-1] if isinstance(value, list) else value
