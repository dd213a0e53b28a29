"""Answers can be put into lists and sets: none compares arrays when it is asked whether it equals another."""

import dataclasses
import importlib
import pkgutil

import numpy as np
import pytest

import polhode as ph


def classes_of_arrays():
    for found in pkgutil.walk_packages(ph.__path__, "polhode."):
        module = importlib.import_module(found.name)
        for kind in vars(module).values():
            if isinstance(kind, type) and kind.__module__ == found.name and dataclasses.is_dataclass(kind):
                words = " ".join(map(str, getattr(kind, "__annotations__", {}).values()))
                if "Array" in words or issubclass(kind, ph.reports.Report):
                    yield kind


def compares_by_identity(kind):
    return kind.__eq__ is object.__eq__ and kind.__hash__ is object.__hash__


def test_no_answer_compares_its_arrays():
    import equinox as eqx  # whose modules compare by value, to one truth value

    kinds = [kind for kind in classes_of_arrays() if not issubclass(kind, eqx.Module)]
    wrong = [kind for kind in kinds if dataclasses.fields(kind) and not compares_by_identity(kind)]
    assert len(kinds) > 50 and not wrong, wrong


def test_the_law_sees_a_dataclass_that_compares_by_value():
    @dataclasses.dataclass(frozen=True)
    class Broken:
        values: np.ndarray

    assert not compares_by_identity(Broken)
    with pytest.raises(ValueError, match="truth value"):
        assert Broken(np.zeros(2)) == Broken(np.ones(2))


def test_a_report_and_a_trajectory_are_members_of_a_list():
    trajectory = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5)).sample([0.0, 1.0])
    other = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5)).sample([0.0, 1.0])
    assert trajectory in [other, trajectory] and trajectory != other and len({trajectory, other}) == 2
