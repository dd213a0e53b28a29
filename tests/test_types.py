"""Annotations of arrays are checked in the tests: wrong shapes and types of number are caught, and none is idle."""

import ast
import importlib
import re
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import array_api_strict
import jax
import jax.numpy as jnp
import numpy as np
import pytest
from jaxtyping import TypeCheckError, install_import_hook

import polhode
import typed
from polhode import rotation, systems
from polhode.analysis import poinsot
from polhode.errors import InvalidInput
from polhode.integrators import _composition as composition

SRC = Path(polhode.__file__).parent
SPECIMEN = '''
from __future__ import annotations

import numpy as np

from polhode.types import Array, ArrayLike, Float64, Real


def three(value) -> Float64[Array, "3"]:
    return value


def length(vectors: Real[ArrayLike, "*batch 3"], returned) -> Float64[Array, "*batch"]:
    return returned


def both(p: Float64[Array, "*#batch 3"], q: Float64[Array, "*#batch 3"], returned) -> Float64[Array, "*batch 3"]:
    return returned
'''


@pytest.fixture
def specimen(tmp_path, monkeypatch):
    """A module of the package whose functions return what they are told to."""
    (tmp_path / "specimen.py").write_text(SPECIMEN)
    monkeypatch.setattr(polhode, "__path__", [*polhode.__path__, str(tmp_path)])
    monkeypatch.setattr(typed, "MOST", 100)  # some tests call a function more often than most do
    with install_import_hook("polhode.specimen", "typed.check"):
        found = importlib.import_module("polhode.specimen")
    yield found
    del sys.modules["polhode.specimen"]


@pytest.fixture
def checked():
    """Skip where the package is imported without checks."""
    if not hasattr(rotation.multiply, "__wrapped__"):
        pytest.skip("annotations are checked where POLHODE_ANNOTATIONS=checked, as CI sets it")


@pytest.mark.parametrize("make", [np.asarray, array_api_strict.asarray, jnp.asarray])
def test_a_wrong_result_is_caught(specimen, make):
    with jax.enable_x64(True):
        assert specimen.three(make([1.0, 2.0, 3.0])).shape == (3,)
        for wrong in ([1.0, 2.0], [[1.0, 2.0, 3.0]], [1, 2, 3], [True, True, True]):
            with pytest.raises(TypeCheckError, match="return value"):
                specimen.three(make(wrong))
        single = array_api_strict.float32 if make is array_api_strict.asarray else np.float32
        with pytest.raises(TypeCheckError, match="return value"):
            specimen.three(make([1.0, 2.0, 3.0], dtype=single))
    with pytest.raises(TypeCheckError):
        specimen.three([1.0, 2.0, 3.0])


@pytest.mark.parametrize("make", [np.asarray, np.ndarray.tolist, jnp.asarray])
def test_the_batch_of_what_is_given_is_the_batch_of_the_result(specimen, make):
    with jax.enable_x64(True):
        given = make(np.ones((5, 4, 3)))
        assert specimen.length(given, np.ones((5, 4))).shape == (5, 4)
        for wrong in ((5,), (4, 5), (5, 4, 1), ()):
            with pytest.raises(TypeCheckError, match="return value"):
                specimen.length(given, np.ones(wrong))


def test_what_a_user_gives_wrongly_is_left_to_the_function(specimen):
    for wrong in (np.ones((5, 2)), [[1.0, 2.0], [3.0]], "three", None, object()):
        assert specimen.length(wrong, np.ones(5)).shape == (5,)
    with pytest.raises(InvalidInput, match="shape"):
        rotation.as_matrix([1.0, 0.0, 0.0])


def test_batches_that_broadcast(specimen):
    one, many = np.ones((7, 1, 3)), np.ones((4, 3))
    assert specimen.both(one, many, np.ones((7, 4, 3))).shape == (7, 4, 3)
    with pytest.raises(TypeCheckError, match="return value"):
        specimen.both(one, many, np.ones((7, 1, 3)))
    with pytest.raises(TypeCheckError, match="parameters"):
        specimen.both(np.ones((5, 3)), many, np.ones((4, 3)))


@pytest.mark.parametrize("kernel", [
    lambda p, q: (p[0], p[1], p[2]),
    lambda p, q: tuple(x[:1] for x in p),
    lambda p, q: tuple(x.astype(np.float32) for x in p),
], ids=["a component too few", "a batch too small", "too few digits"])  # fmt: skip
def test_a_broken_kernel_of_rotations_is_caught(kernel, monkeypatch, checked):
    quaternions = rotation.normalize(np.random.default_rng(0).normal(size=(6, 4)))
    assert rotation.multiply(quaternions, quaternions).shape == (6, 4)
    monkeypatch.setattr(rotation, "product_of_parts", kernel)
    with pytest.raises(TypeCheckError, match=r"return value of polhode\.rotation\.multiply"):
        rotation.multiply(quaternions, quaternions)


def test_a_broken_motion_is_caught(monkeypatch, checked):
    motion = polhode.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5))
    attitude, momentum = motion.state(0.5)
    monkeypatch.setattr(type(motion), "state", lambda self, t: (momentum, attitude))
    for wrong in (motion.attitude, motion.momentum):
        with pytest.raises(TypeCheckError):
            wrong(0.5)


@pytest.mark.parametrize(("module", "name", "wrong", "call"), [
    ("systems.kepler_orbit", "solve_kepler", lambda M, e: M[0],
     lambda: systems.KeplerOrbit(1.0, 0.1).distance_ratio(np.linspace(0.0, 1.0, 5))),
    ("integrators._composition", "STAGES", {2: (1,)}, lambda: composition.stages(2)),
    ("exact.free_body._evaluation", "FORM", SimpleNamespace(
        columns=lambda given: np.zeros(50), states_of=lambda *given: (np.zeros((5, 3)), np.zeros((5, 4)))),
     lambda: polhode.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5)).momentum(np.arange(5.0))),
    ("analysis.poinsot", "as_float64", lambda xp, value, name: xp.asarray(value[:2]),
     lambda: poinsot.ellipsoid_semi_axes((1.0, 2.0, 3.0))),
], ids=["systems", "integrators", "exact", "analysis"])  # fmt: skip
def test_what_is_broken_within_is_caught(module, name, wrong, call, monkeypatch, checked):
    call()
    monkeypatch.setattr(importlib.import_module(f"polhode.{module}"), name, wrong)
    with pytest.raises(TypeCheckError, match=r"return value of polhode\." + module.replace(".", r"\.")):
        call()


def modules():
    for path in sorted(SRC.rglob("*.py")):
        parts = path.relative_to(SRC).parts
        if parts != ("types.py",):
            yield ".".join(("polhode", *path.relative_to(SRC).with_suffix("").parts)).removesuffix(".__init__"), path


def annotations(tree):
    """Yield annotations of arguments and fields, and of results with the names of their functions."""
    for node in tree.body:
        if isinstance(node, ast.ClassDef):
            yield from annotations(node)
        elif isinstance(node, ast.FunctionDef):
            every = [*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs, node.args.vararg, node.args.kwarg]
            yield from ((None, given.annotation) for given in every if given is not None and given.annotation)
            if node.returns:
                yield node.name, node.returns
        elif isinstance(node, ast.AnnAssign):
            yield None, node.annotation


def without_shape(annotation):
    """Whether it names arrays without saying their numbers and shape."""
    inside = {id(node.slice.elts[0]) for node in ast.walk(annotation)
              if isinstance(node, ast.Subscript) and isinstance(node.slice, ast.Tuple)
              and isinstance(shape := node.slice.elts[-1], ast.Constant) and isinstance(shape.value, str)}  # fmt: skip
    return any(isinstance(node, ast.Name) and node.id == "Array" and id(node) not in inside
               for node in ast.walk(annotation))  # fmt: skip


@pytest.mark.long
def test_annotations_can_be_read_at_run_time():
    """jaxtyping takes one that it cannot read for `Any`, without a word."""
    idle = []
    for name, path in modules():
        text = path.read_text("utf-8")
        if "polhode.types" not in text:
            continue
        known = vars(importlib.import_module(name))
        for _, annotation in annotations(ast.parse(text)):
            try:
                eval(ast.unparse(annotation), dict(known))
            except Exception as error:
                if "Array" in ast.unparse(annotation) or not isinstance(error, NameError):
                    idle.append(f"{name}: {ast.unparse(annotation)}: {error}")
    assert not idle


def test_results_of_public_functions_have_shapes():
    plain = [f"{name}.{function}: {ast.unparse(annotation)}" for name, path in modules()
             for function, annotation in annotations(ast.parse(path.read_text("utf-8")))
             if function and not function.startswith("_") and without_shape(annotation)]  # fmt: skip
    assert not plain


def test_the_alias_stands_once():
    paths = [path for path in SRC.rglob("*.py") if re.search(r"^\s*Array = ", path.read_text("utf-8"), re.MULTILINE)]
    assert paths == [SRC / "types.py"]


def test_users_do_not_pay_for_the_checks():
    made = "ph.FreeMotion((1., 2., 3.), momentum=(1., 1., 1.))"
    code = f"import sys, polhode as ph; {made}.state(1.0); print(*sys.modules)"
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120, check=True)
    assert "polhode.types" in found.stdout.split()
    assert not {"jax", "jaxtyping"} & set(found.stdout.split())
