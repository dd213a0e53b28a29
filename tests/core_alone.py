"""What polhode does by its required libraries alone, and what it says where others are needed.

``python tests/core_alone.py`` is for a Python that has no others, as in CI; ``--hide`` hides them from any Python,
and ``--hide-one matplotlib`` one alone.
"""

import contextlib
import io
import re
import sys
from importlib import import_module, metadata
from pathlib import Path

import numpy as np

import polhode as ph
from polhode._base.extras import LIBRARIES
from polhode.cli.main import main
from polhode.errors import InvalidInput

REQUIRED = {"polhode", "numpy", "array_api_compat", "lazy_loader"}
FASTER = ("numba", "llvmlite")  # which only save time
CLOSE = 16 * np.finfo(float).eps  # as the pages on accuracy promise of any one; NumPy's last bits are not Python's
CORNERS, FACES = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]]), [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]


class Hidden:
    """Finder of what is not to be found."""

    def __init__(self, modules=(*LIBRARIES, *FASTER)):
        self.modules = modules

    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] in self.modules:
            raise ModuleNotFoundError(f"No module named {name!r}", name=name)


def body_in_motion():
    return ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5))


def compare(many, singles):
    """Attitude and momentum of many at once are those of each by itself."""
    for part, alone in zip(many, zip(*singles, strict=True), strict=True):
        assert np.abs(part[: len(alone)] - alone).max() < CLOSE * max(1.0, np.abs(alone).max())


def check_free_bodies():
    momenta = np.random.default_rng(1).normal(size=(3000, 3))
    one = body_in_motion()
    compare(ph.FreeMotion((1.0, 2.0, 3.0), momentum=momenta).state(100.0),
            [ph.FreeMotion((1.0, 2.0, 3.0), momentum=momentum).state(100.0) for momentum in momenta[:40]])  # fmt: skip
    times = np.linspace(0.0, 1e3, 5000)
    compare(one.state(times), [one.state(time) for time in times[:40]])
    assert one.regime == "short-axis" and one.period > 0.0
    assert max(one.sample(times).drift.values()) < 1e-14


def check_tops():
    momenta = np.random.default_rng(2).normal(size=(1000, 3))
    top = lambda momentum: ph.LagrangeMotion((1.0, 1.0, 0.5), mgl=1.0, momentum=momentum)  # noqa: E731
    compare(top(momenta).state(3.0), [top(momentum).state(3.0) for momentum in momenta[:40]])
    one = top(momenta[0])
    assert one.nutation_period > 0.0 and one.regime
    one.sample(np.linspace(0.0, 10.0, 1000))


def check_bodies():
    parts = [ph.shapes.box(1.0, (1.0, 2.0, 3.0)), ph.shapes.torus(1.0, 1.0, 0.2).placed((1, 0, 0, 0), (1, 0, 0))]
    body = ph.combine(parts)
    assert body.mass == 2.0 and body.principal_axes.shape == (3, 3)
    assert ph.FreeMotion.from_body(body, angular_velocity=(0.01, 12.0, 0.0)).state(1.0)[0].shape == (4,)
    ph.Body.from_points(np.ones(4), CORNERS)
    ph.Body.from_atoms(["O", "H", "H"], 1e-10 * CORNERS[:3])
    ph.Body.from_sheet(CORNERS, FACES, mass=1.0)
    turn = ph.rotation.from_axis_angle((0.0, 0.0, 1.0), 0.5)
    assert np.allclose(ph.rotation.from_matrix(ph.rotation.as_matrix(turn)), turn)
    assert ph.special.jacobi(1.0, 0.3)


DOORS = {
    "JAX": (lambda: import_module("polhode.systems"), lambda: ph.systems, lambda: ph.algebra.SO3(), lambda: ph.poisson,
            lambda: ph.simulate, lambda: ph.solve, lambda: ph.stability, lambda: ph.integrators.Splitting,
            lambda: ph.spacecraft.Wheel),
    "SciPy": (lambda: ph.Body.from_mesh(CORNERS, FACES, density=6.0), lambda: ph.rotation.as_scipy((1.0, 0, 0, 0)),
              lambda: ph.special.legendre_function(2.0),
              lambda: ph.Body.from_mesh(CORNERS, FACES, density=6.0, repair=True)),
    "python-flint": (lambda: ph.certify(body_in_motion()),),
    ".*": (lambda: ph.as_dataset, lambda: ph.report, lambda: ph.read_spec, lambda: ph.write_page, lambda: ph.fit,
           lambda: ph.sweep, lambda: ph.tumble, lambda: ph.figures.momentum_sphere, lambda: ph.formats.read_mesh,
           lambda: body_in_motion().plot(), lambda: body_in_motion().show(), lambda: body_in_motion().save("it.nc"),
           lambda: main(["report", "case.toml"]), lambda: main(["--help"])),
}  # fmt: skip
"""What must be refused, by the library that the refusal names first."""
LOG = Path(__file__).parents[1] / "examples" / "phone_throw.csv"
DOORS_OF_ONE = {
    "matplotlib": (lambda: body_in_motion().plot(), lambda: body_in_motion().sample((0.0, 1.0)).plot(),
                   lambda: ph.report(LOG.with_name("top.toml")).plot(),
                   lambda: ph.report(LOG.with_name("top.toml")).figure("axis_path"),
                   lambda: ph.report(LOG.with_name("top.toml")).draw(".")),
    "scipy": (lambda: ph.fit(LOG),),
    "pint": (lambda: ph.read_spec(LOG.with_name("top.toml")), lambda: ph.report(LOG.with_name("top.toml"))),
    "platformdirs": (lambda: ph.read_spec(LOG.with_name("top.toml")),),
    "pydantic": (lambda: ph.fit(LOG),),
}  # fmt: skip
"""What must be refused where one library alone is missing."""
EXTRA = {"JAX": "jax", "python-flint": "jax", ".*": "app"}


def refusal(call):
    """Return what is said where a call is refused: an error of ours that is one of imports too, or the command's."""
    told = io.StringIO()
    try:
        with contextlib.redirect_stderr(told):
            call()
    except InvalidInput as error:
        assert isinstance(error, ImportError)
        return str(error)
    except SystemExit as end:
        assert end.code == 2
        return told.getvalue().strip()
    raise AssertionError("it is not refused")


def check_doors(strict, doors=DOORS):
    """Each is refused by one sentence that names the library, and the extra unless polhode itself is not installed."""
    for library, calls in doors.items():
        for call in calls:
            said = refusal(call)
            remedy = r'which is not installed\. Run `.+ -m pip install "(.+)"`\.'
            found = re.fullmatch(rf".* needs? {library}, {remedy}", said)
            assert found, said
            if strict and library in EXTRA:
                assert found[1] == f"polhode[{EXTRA[library]}]", said


def run(hide):
    before = set(sys.modules)
    if hide:
        sys.meta_path.insert(0, Hidden())
    for name in (*LIBRARIES, *FASTER):
        try:
            import_module(name)
        except ImportError:
            continue
        raise AssertionError(f"{name} is installed; give --hide")
    check_free_bodies()
    check_tops()
    check_bodies()
    check_doors(strict=not hide)
    loaded = {name.partition(".")[0] for name in set(sys.modules) - before}
    others = loaded & set(metadata.packages_distributions()) - REQUIRED
    assert not others, f"loaded besides: {sorted(others)}"


def run_without(module):
    """Hide one library alone."""
    sys.meta_path.insert(0, Hidden((module,)))
    check_doors(False, {LIBRARIES[module].name: DOORS_OF_ONE[module]})


if __name__ == "__main__":
    if "--hide-one" in sys.argv:
        run_without(sys.argv[-1])
        sys.exit()
    run("--hide" in sys.argv)
    print("the core works by itself")
