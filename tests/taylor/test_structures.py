"""What is traced once for all systems that differ by their numbers: the same programs as each traced alone."""

import equinox as eqx
import jax.numpy as jnp
import numpy as np
import pytest

from polhode import fields, systems
from polhode.taylor import machine
from polhode.taylor.structure import itself, take_structure


class Asking(systems.AbstractSystem):
    """A pull that is written in two ways, by the value of a number."""

    pull: jnp.ndarray = eqx.field(converter=jnp.asarray)

    def vector_field(self, t, state):
        return -state * self.pull if float(self.pull) > 1.0 else -(state**3)

    def invariants(self, state):
        return {}


def tops():
    """Yield tops that differ by numbers, and a state."""
    state = np.array([1.0, 0, 0, 0, 0.5, 1.0, 2.0, 0, 0, 1.0])
    for moment, mgl in ((2.0, 1.0), (2.3, -0.4)):
        yield systems.HeavyTop((1.0, moment, 3.5), mgl, (0.0, 0.6, 0.8)), state
    vortices = [fields.PlaneVortices(np.array([k, -0.7, 0.4])) for k in (1.0, 1.3)]
    yield from ((system, system.pack([[0.0, 0.0], [1.0, 0.2], [-0.3, 0.9]])) for system in vortices)
    yield systems.Kirchhoff(np.eye(6) + 0.1), np.ones(6)
    yield systems.Kirchhoff(1.3 * np.eye(6) + 0.2), np.ones(6)


@pytest.fixture
def traced(monkeypatch):
    """Count what is traced, from nothing."""
    for function in (machine._write_unless_traced, machine._machines):
        function.cache_clear()
    found, own = [], machine.write_jaxpr
    monkeypatch.setattr(machine, "write_jaxpr", lambda *given: found.append(1) or own(*given))
    return found


@pytest.mark.long
def test_systems_that_differ_by_numbers_are_traced_once(traced):
    for system, state in tops():
        machine.build_machine(system, state, None)
    assert len(traced) == 3


def test_programs_are_those_of_each_system_alone(traced, monkeypatch):
    together = [machine.build_machine(system, state, None) for system, state in tops()]
    for function in (machine._write_unless_traced, machine._machines):
        function.cache_clear()
    monkeypatch.setattr(machine, "take_structure", itself)
    for one, (system, state) in zip(together, tops(), strict=True):
        alone = machine.build_machine(system, state, None)
        assert one.names == alone.names
        for ours, theirs in ((one.program, alone.program), (one.integrals, alone.integrals)):
            np.testing.assert_array_equal(ours.whole, theirs.whole)
            np.testing.assert_allclose(ours.number, theirs.number, rtol=4e-16, atol=0.0)


def test_a_system_that_asks_for_its_numbers_is_traced_each_time(traced):
    programs = [machine.build_machine(Asking(pull), np.ones(2), None).program for pull in (0.5, 2.0, 3.0)]
    assert len(traced) == 4  # without numbers once, in vain
    assert [program.products > 0 for program in programs] == [True, False, False]
    assert programs[1].number.tolist() != programs[2].number.tolist()


def test_words_and_forms_are_part_of_the_structure():
    one, other = (systems.HeavyTop((1.0, 2.0, 3.5), mgl, (0.0, 0.6, 0.8)) for mgl in (1.0, 2.0))
    (same, numbers), (too, others) = take_structure(one), take_structure(other)
    assert same == too and hash(same) == hash(too) and not np.array_equal(numbers, others)
    assert take_structure(fields.PlaneVortices(np.ones(3)))[0] != take_structure(fields.PlaneVortices(np.ones(4)))[0]
    assert take_structure(fields.Toda(4))[0] != take_structure(fields.Toda(5))[0]
