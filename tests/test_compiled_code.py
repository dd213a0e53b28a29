"""Copies of modules for Numba and for arrays, and when compiled code is loaded; tests/exact and tests/taylor run it."""

import sys
from types import ModuleType

import pytest

from polhode._base.compiled import kernel_modules
from polhode._base.compiled.copying import copy_modules
from polhode._base.compiled.kernel_modules import LOADING, KernelModules, is_worth

ONE = """
from polhode._base.compiled.copying import called, entry, given
SIZE = 2
@given
def rate(): return 0
@called
def scaled(x): return SIZE * x
@entry
def run(x): return scaled(x) + rate()
"""
OTHER = """
from one import run, scaled
SIZE = 5
def rate(): return 100 * SIZE
def twice(x): return 2 * run(x) + SIZE
"""


@pytest.fixture
def modules(monkeypatch, tmp_path):
    """Return two modules that call each other."""
    made = []
    for name, text in (("one", ONE), ("other", OTHER)):
        module = ModuleType(name)
        monkeypatch.setitem(sys.modules, name, module)
        module.__file__ = str(tmp_path / f"{name}.py")
        exec(text, vars(module))
        made.append(module)
    return made


def as_it_is(function, mark):
    return function


def test_functions_of_copies_call_those_of_copies(modules):
    """Each with the constants of its own module, and the one that is given in place of its stand-in."""
    spaces = copy_modules(modules, as_it_is)
    assert spaces["other"]["twice"](3) == 2 * (2 * 3 + 500) + 5 and spaces["one"]["SIZE"] == 2
    assert modules[1].twice(3) == 2 * (2 * 3 + 0) + 5  # the modules are as they were
    replaced = copy_modules(modules, as_it_is, {"scaled": lambda x: -x})
    assert replaced["other"]["twice"](3) == 2 * (-3 + 500) + 5


def test_joined_modules_have_the_constants_of_the_first_and_the_functions_of_the_last(modules):
    spaces = copy_modules(modules, as_it_is, joined=True)
    assert spaces["one"] is spaces["other"] and spaces["one"]["twice"](3) == 2 * (2 * 3 + 200) + 2
    assert copy_modules(modules[::-1], as_it_is, joined=True)["one"]["twice"](3) == 2 * (5 * 3 + 500) + 5


def test_each_function_is_made_by_its_mark(modules):
    marks = {}
    copy_modules(modules, lambda function, mark: marks.setdefault(function.__name__, mark) and function)
    assert marks == {"scaled": "called", "run": "entry", "rate": "inlined", "twice": "inlined"}


def test_numba_is_not_loaded_where_nothing_is_on_disk(modules, monkeypatch, tmp_path):
    """It was for the closed forms, for a third of a second; only a file of the right name has it asked."""
    asked = []
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))
    kernel = KernelModules("k", "sums", modules, dict, [])

    class Compiled:
        def is_on_disk(self):
            return not asked.append(1)

    monkeypatch.setattr(kernel_modules, "has_images", lambda: False)
    monkeypatch.setattr(KernelModules, "by_numba", {"one": {"run": Compiled()}})
    folder = tmp_path / "one_0"
    folder.mkdir()
    monkeypatch.setattr(KernelModules, "kept_name", "k_1234")
    assert not kernel.is_on_disk("run")
    (folder / "one.run_k_99-5.py311.nbi").touch()
    assert not kernel.is_on_disk("run") and not asked
    (folder / "one.run_k_1234-5.py311.nbi").touch()
    assert kernel.is_on_disk("run") and asked == [1]


@pytest.mark.parametrize(("has_images", "loading"), [(True, LOADING.of_image), (False, LOADING.by_numba)])
def test_a_kernel_is_compiled_or_loaded_when_it_is_worth_it(monkeypatch, has_images, loading):
    monkeypatch.setattr(kernel_modules, "has_images", lambda: has_images)
    for spent, is_on_disk, wanted in (
        (0.99 * loading, True, False), (loading, True, True), (loading, False, False), (4.9, False, False),
        (5.0, False, True),
    ):  # fmt: skip
        assert is_worth(spent, 5.0, lambda is_on_disk=is_on_disk: is_on_disk) is wanted


@pytest.mark.parametrize("has_images", [True, False])
def test_without_numba_nothing_is_compiled_and_images_are_loaded(monkeypatch, has_images):
    monkeypatch.setattr(kernel_modules, "has_images", lambda: has_images)
    monkeypatch.setattr(kernel_modules, "can_compile", lambda: False)
    assert not is_worth(1e9, 5.0, lambda: False)
    assert is_worth(1e9, 5.0, lambda: True) is has_images
