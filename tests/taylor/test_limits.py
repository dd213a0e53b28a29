"""Both sides of the thresholds that refuse a series, or decide how one is made."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode.errors import InvalidInput, NotConverged
from polhode.integrators import Taylor, _series
from polhode.taylor import advancing, expressions, kernels, machine, sides, switching, tracing
from polhode.taylor.expressions import Untraceable
from polhode.taylor.machine import build_machine
from taylor.test_branches import wedge
from taylor.test_coefficients import OwnField


class Summed(OwnField):
    def invariants(self, state):
        return {"sum": jnp.sum(state)}


def halved(t, y):
    return -0.5 * y


@pytest.mark.parametrize(("power", "fits"), [(31.5, True), (-32.0, True), (32.5, False), (0.25, False)])
def test_powers_with_twice_as_many_digits(power, fits):
    build = lambda: build_machine(OwnField(lambda t, y: y**power), np.ones(1), None, extended=True)  # noqa: E731
    if fits:
        assert build().exact is not None
    else:
        with pytest.raises(Untraceable, match=r"only halves of whole numbers up to 32 have a recurrence"):
            build()


def test_gradients_are_projected_up_to_a_number_of_them():
    most = machine.LIMITS.max_gradient_numbers
    names = [build_machine(Summed(halved), np.ones(size), None).names for size in (most, most + 1)]
    assert names == [("sum",), ()]


def test_jumps_are_one_within_a_rounding():
    gap = machine.LIMITS.time_rounding
    assert [len(machine._instants((1.0, 1.0 + k * gap))) for k in (0.9, 1.1)] == [1, machine.LIMITS.instants]


def test_loops_and_linear_operations_are_written_out_up_to_a_size(monkeypatch):
    monkeypatch.setattr(tracing, "LIMITS", tracing.TracingLimits(max_rounds=5, max_linear_size=3))
    looped = lambda rounds: OwnField(  # noqa: E731
        lambda t, y: jax.lax.fori_loop(0, rounds, lambda k, x: 0.5 * x * x, y))  # fmt: skip
    build_machine(looped(5), np.ones(1), None)
    with pytest.raises(Untraceable, match="a loop of 6 rounds"):
        build_machine(looped(6), np.ones(1), None)
    build_machine(OwnField(lambda t, y: jnp.cumsum(y)), np.ones(3), None)
    with pytest.raises(Untraceable, match="`cumsum` of 4 numbers"):
        build_machine(OwnField(lambda t, y: jnp.cumsum(y)), np.ones(4), None)


def test_a_copy_is_at_a_border_or_beyond_it_within_roundings():
    tape = expressions.Tape(1, None, np.zeros(0))
    difference = tape.state()[0] - 1.0  # at the border its terms are of size two
    met = sides.Sides((), np.array([2.0]))
    assert met.is_positive(difference)
    branches, size = sides.Branches(tape, [tape.constant(1.0)], met), 2.0
    there = lambda part: np.array([[1.0 + size * part]])  # noqa: E731
    limits = sides.LIMITS
    assert branches.touches_border(there(0.99 * limits.max_at_border))
    assert not branches.touches_border(there(1.01 * limits.max_at_border))
    assert branches.hold(there(-0.99 * limits.max_beyond_border))
    assert not branches.hold(there(-1.01 * limits.max_beyond_border))


def test_differences_are_multiples_within_roundings():
    tape = expressions.Tape(2, None, np.zeros(0))
    x, y = tape.state()
    ratios = [sides.ratio(2.0 * x + (2.0 + 2.0 * part) * y, x + y)
              for part in (0.9 * sides.LIMITS.ratio_rounding, 1.5 * sides.LIMITS.ratio_rounding)]  # fmt: skip
    assert ratios == [2.0, 0.0]


def test_borders_are_crossed_so_often_and_no_more(monkeypatch):
    """From the top of an arc of length 3, corners come at 1.5 s, 4.5 s, 7.5 s and 10.5 s."""
    monkeypatch.setattr(switching, "LIMITS", switching.LIMITS._replace(max_crossings=3))
    run = lambda last: ph.simulate(wedge(), [1.125, 0.0, 1.0], [0.0, last], Taylor, estimate_error=False)  # noqa: E731
    assert np.isfinite(run(9.0).states).all()
    with pytest.raises(InvalidInput, match="whose borders it crosses too often"):
        run(12.0)


def test_steps_are_taken_up_to_a_number(monkeypatch):
    system, start, times = OwnField(halved), np.array([1.0]), [0.0, 50.0]
    needed = ph.simulate(system, start, times, Taylor, estimate_error=False).statistics["steps"]
    for most, fits in ((needed + 1, True), (needed, False)):
        limits = advancing.LIMITS._replace(max_steps=most)
        monkeypatch.setattr(advancing, "LIMITS", limits)
        monkeypatch.setattr(_series, "ADVANCING", limits)
        if fits:
            ph.simulate(system, start, times, Taylor, estimate_error=False)
        else:
            with pytest.raises(NotConverged, match="steps did not reach the last time"):
                ph.simulate(system, start, times, Taylor, estimate_error=False)


class Named(OwnField):
    def invariants(self, state):
        return {"wide": jnp.sum(state**1.5), "other": jnp.sum(state**2.5)}


def test_what_does_not_fit_is_what_the_system_names_last(monkeypatch):
    """The tape needs two powers for the first quantity, two for its gradient, and two more for the other quantity."""
    for most, names in ((6, ("other", "wide")), (5, ("wide",)), (4, ("wide",)), (3, ())):
        with monkeypatch.context() as patch:
            patch.setattr(expressions, "LIMITS", expressions.TapeLimits(max_nodes=most))
            anew = lambda t, y: -0.5 * y  # noqa: E731  # so that no machine made before is taken
            assert sorted(set(build_machine(Named(anew), np.ones(2), None).names)) == sorted(names)
    most = machine.LIMITS.max_gradient_numbers // 2
    names = [build_machine(Named(halved), np.ones(size), None).names for size in (most, most + 1)]
    assert names == [("other", "wide"), ("wide",)]


def test_code_is_written_for_what_is_conserved_up_to_a_length(monkeypatch):
    use, operations = kernels.Kernel(1, True, None, None, 1), build_machine(Summed(halved), np.ones(3), None)
    monkeypatch.setattr(kernels._Spent, "by_program", {operations.program.form: 1e9})
    for most, written in ((operations.integrals.length, True), (operations.integrals.length - 1, False)):
        monkeypatch.setattr(kernels, "LIMITS", kernels.LIMITS._replace(max_integral_operations=most))
        code, values = kernels.write_code(use, operations.program, operations.integrals)
        assert code is not None and (values is not None) is written


def test_code_of_what_is_conserved_waits_for_as_long_as_it_takes(monkeypatch):
    use, operations = kernels.Kernel(1, True, None, None, 1), build_machine(Summed(halved), np.ones(3), None)
    longer = operations.integrals
    least = kernels.LIMITS.min_seconds_of_operation * longer.length
    monkeypatch.setitem(operations.program.__dict__, "length", 0)  # so that its own code is due in any case
    for seconds, written in ((least, True), (0.99 * least, False)):
        monkeypatch.setattr(kernels._Spent, "by_program", {operations.program.form: seconds})
        code, values = kernels.write_code(use, operations.program, longer)
        assert code is not None and (values is not None) is written
