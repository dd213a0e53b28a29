"""Branches on what moves: motions past corners and jumps of their rates, against closed forms and other integrators."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

import polhode as ph
from polhode.algebra import Heisenberg
from polhode.errors import InvalidInput, NotConverged
from polhode.integrators import Taylor
from polhode.motion import Status
from polhode.spacecraft import RigidBody, SolarPressure, Wheel
from polhode.systems import LiePoisson
from polhode.taylor import machine, sides, switching
from polhode.taylor.expressions import Untraceable
from taylor.test_coefficients import OwnField

SAME = 1e-12


def wedge():
    """H = p²/2 + |q|: parabolas, one after the other."""
    return LiePoisson(Heisenberg(1), lambda m: 0.5 * m[1] ** 2 + jnp.abs(m[0]))


def in_wedge(t, p0=1.5):
    """From q = 0 with p0: q = p0 s − s²/2 for 2 p0, then the same with the other sign."""
    arc, s = np.divmod(t, 2.0 * p0)
    side = np.where(arc % 2, -1.0, 1.0)
    return side * (p0 * s - 0.5 * s * s), side * (p0 - s)


@pytest.mark.parametrize("backward", [False, True])
def test_a_wedge_is_passed_to_rounding(backward):
    """Also from its corner, where the direction tells the side; also backward, where it is the other one."""
    times = np.linspace(0.0, 100.0, 41) * (-1.0 if backward else 1.0)
    run = ph.simulate(wedge(), [0.0, 1.5, 1.0], times)
    q, p = in_wedge(np.abs(times))
    p = -p if backward else p
    turned = np.sign(run.states[1, 0] * q[1])  # which way t runs is a matter of the algebra's sign
    assert np.abs(run.states[:, 0] - turned * q).max() < SAME
    assert np.abs(np.abs(run.states[:, 1]) - np.abs(p)).max() < SAME
    assert run.error_estimate < 1e-11 and run.drift["energy"] < 1e-14


def test_a_batch_is_its_copies_to_the_bit_though_they_are_on_different_sides():
    starts = np.array([[0.3, 1.5, 1.0], [-0.3, 1.5, 1.0], [-2.0, 0.1, 1.0], [0.0, -0.7, 1.0], [1.0, 0.0, 1.0]])
    times = np.linspace(0.0, 30.0, 7)
    together = ph.simulate(wedge(), starts, times, estimate_error=False)
    for start, states in zip(starts, together.states, strict=True):
        np.testing.assert_array_equal(ph.simulate(wedge(), start, times, estimate_error=False).states, states)


def motor(t, attitude, velocity, rate):
    return jnp.clip(-2.0 * rate, -0.5, 0.5)


def test_a_program_is_written_once_for_the_sides_that_runs_share(monkeypatch):
    """Those for the error begin a rounding away, where the sides are the same."""
    written = []
    write = machine._make_machine
    monkeypatch.setattr(machine, "_make_machine", lambda *given: written.append(given[5]) or write(*given))
    system = LiePoisson(Heisenberg(1), lambda m: 0.5 * m[1] ** 2 + 1.7 * jnp.abs(m[0]))
    run = ph.simulate(system, [3.0, 1.5, 1.0], [0.0, 1.0])
    assert run.error_estimate < SAME and len(written) == 1
    ph.simulate(system, [3.0, 1.5, 1.0], [0.0, 10.0])  # to the other side, which is known from there on
    ph.simulate(system, [-0.2, 1.5, 1.0], [0.0, 10.0])
    assert len(written) == 2


def test_a_limit_is_reached_and_left():
    """A wheel that a limited motor stops: even at first, and by an exponential from 0.25 rad/s on."""
    body = RigidBody((1e9, 1e9, 1e9), [Wheel((0, 0, 1), 2.0, motor)])
    run = ph.simulate(body, body.pack((1, 0, 0, 0), (0, 0, 0), rates=[10.0]), [0.0, 20.0, 39.0, 41.0, 60.0])
    wanted = [10.0, 5.0, 0.25, 0.25 * np.exp(-2.0), 0.25 * np.exp(-21.0)]
    assert run.states[:, 7] / 2.0 == pytest.approx(wanted, rel=1e-8, abs=1e-7)  # the body turns by 1e-9 of it


def plates(t, y, moments, axes, areas, places, sun, pressure):
    """Newton–Euler equations of a body with black plates, of which those with an area see the Sun."""
    q, w = y[:4], y[4:]
    u = Rotation.from_quat(q[[1, 2, 3, 0]]).inv().apply(sun)
    force = -pressure * (areas * (axes @ u))[:, None] * u
    torque = np.cross(places, force).sum(axis=0)
    turning = 0.5 * np.array([-q[1:] @ w, *(q[0] * w + np.cross(q[1:], w))])
    return np.append(turning, (np.cross(moments * w, w) + torque) / moments)


@pytest.mark.sweep
def test_sunlight_on_a_box_beside_a_general_integrator_that_stops_at_its_edges():
    moments, edges, center = np.array([0.1, 0.2, 0.25]), np.array([0.1, 0.2, 0.3]), np.array([0.03, 0.01, -0.02])
    sun, start = np.array([1.0, 0.3, 0.1]), np.array([1.0, 0, 0, 0, 0.001, 0.002, 0.0005])
    sun /= np.linalg.norm(sun)
    body = RigidBody(moments, torques=[SolarPressure(sun, box=edges, center=center, pressure=4.5e-3)])
    run = ph.simulate(body, body.pack(start[:4], start[4:]), [0.0, 1500.0])
    axes, t, y = np.repeat(np.eye(3), 2, axis=0) * np.tile([1.0, -1.0], 3)[:, None], 0.0, start
    places, areas = center + axes * edges / 2, np.repeat(edges.prod() / edges, 2)
    cosines = lambda y: axes @ Rotation.from_quat(y[[1, 2, 3, 0]]).inv().apply(sun)  # noqa: E731
    lit, edges_passed = cosines(y) > 0, 0
    while t < 1500.0:
        events = []
        for k in range(0, 6, 2):
            events.append(lambda t, y, *_, k=k: cosines(y)[k])
            events[-1].terminal = True
            events[-1].direction = -1.0 if lit[k] else 1.0
        arguments = moments, axes, areas * lit, places, sun, 4.5e-3
        part = solve_ivp(plates, (t, 1500.0), y, "DOP853", rtol=2.3e-14, atol=1e-16, max_step=5.0, events=events,
                         args=arguments)  # fmt: skip
        t, y = part.t[-1], part.y[:, -1]
        for k in range(0, 6, 2):
            if len(part.t_events[k // 2]):
                lit[k : k + 2] = ~lit[k : k + 2]
                edges_passed += 1
    wanted = moments * y[4:]
    apart = np.abs(run.momentum[-1] - wanted).max() / np.abs(wanted).max()
    assert edges_passed > 5 and apart < SAME and 0.1 * apart < run.error_estimate < 1e-11


def test_a_border_that_is_reached_to_rounding_and_never_crossed():
    """A wheel that comes exponentially to its largest rate, and stays there: what is watched stays at zero."""
    body = RigidBody((1.0, 2.0, 2.5), [Wheel((0, 0, 1), 0.1, 0.05, max_rate=5.0)])
    run = ph.simulate(body, body.pack(rates=[1.0], attitude=(1.0, 0.0, 0.0, 0.0)), [0.0, 40.0], estimate_error=False)
    assert run.part("rotor_momentum")[-1] / 0.1 - run.angular_velocity[-1, 2] == pytest.approx(5.0, rel=1e-13)


def friction(t, attitude, velocity, rate):
    return -0.5 * jnp.sign(rate)


def test_what_comes_to_rest_at_a_border_is_refused():
    """A wheel with dry friction stands still, though both sides lead to each other: no series says how."""
    body = RigidBody((1e9, 1e9, 1e9), [Wheel((0, 0, 1), 2.0, friction)])
    start = body.pack((1, 0, 0, 0), (0, 0, 0), rates=[10.0])
    with pytest.raises(InvalidInput, match=r"lead back to each other|along whose border"):
        ph.simulate(body, start, [0.0, 50.0], method=ph.integrators.Taylor())


@pytest.mark.sweep
def test_what_comes_to_rest_is_said_and_what_moves_beside_it_goes_on():
    """Two wheels come to rest, at 40 and 16 s, where steps shrink to nothing; the others move as they do alone."""
    body = RigidBody((1e9, 1e9, 1e9), [Wheel((0, 0, 1), 2.0, friction)])
    starts = np.stack([body.pack((1, 0, 0, 0), (0, 0, 0), rates=[rate]) for rate in (10.0, 20.0, 4.0, 18.0)])
    times = np.linspace(0.0, 50.0, 6)
    run = ph.simulate(body, starts.reshape(2, 2, -1), times, throw=False)
    assert run.ends.status.tolist() == [[Status.NOT_CONVERGED, Status.COMPLETED]] * 2
    rates = run.part("rotor_momentum") / 2.0
    for k, rate in enumerate((20.0, 18.0)):
        alone = ph.simulate(body, starts[2 * k + 1], times)
        np.testing.assert_array_equal(alone.states, run.states[k, 1])
        assert alone.error_estimate == run.error_estimate[k, 1] < SAME
        assert rates[k, 1] == pytest.approx(rate - 0.25 * times, abs=1e-7)  # the body turns by 1e-9 of it
    assert not np.isfinite(run.error_estimate[:, 0]).any() and not np.isfinite(rates[:, 0, -1]).any()
    assert rates[0, 0, :4] == pytest.approx(10.0 - 0.25 * times[:4], abs=1e-7)
    with pytest.raises(NotConverged, match="comes to rest at a jump"):
        ph.simulate(body, starts[0], times)
    with pytest.raises(InvalidInput, match=r"lead back to each other|along whose border"):
        ph.simulate(body, starts, times, method=ph.integrators.Taylor)


@pytest.mark.long_cases("rising-1", "either-2")
@pytest.mark.parametrize("direction, per_arc", [("rising", 1), ("falling", 1), ("either", 2)])
def test_sections_go_past_corners(direction, per_arc):
    """q = 1 is crossed twice on each arc of one side, 300 times and more, so that room for them is made on the way."""
    found = ph.section(wedge(), [0.0, 1.5, 1.0], lambda t, m: m[0] - 1.0, (0.0, 999.0), direction)
    # q = p₀ s − s²/2 = 1 at s = p₀ ∓ √(p₀² − 2), on every other arc of 2 p₀; the algebra's sign tells on which
    arcs = 6.0 * np.arange(170)[:, None] + 1.5 + np.array([-0.5, 0.5])
    first = 0.0 if ph.simulate(wedge(), [0.0, 1.5, 1.0], [0.0, 0.1]).states[-1, 0] > 0.0 else 3.0
    wanted = (arcs + first)[:, {"rising": [0], "falling": [1], "either": [0, 1]}[direction]].ravel()
    wanted = wanted[wanted < 999.0]
    assert len(wanted) > 160 * per_arc
    assert found.times == pytest.approx(wanted, abs=1e-11)
    assert np.abs(found.states[:, 0] - 1.0).max() < 1e-13
    few = ph.section(wedge(), [0.0, 1.5, 1.0], lambda t, m: m[0] - 1.0, (0.0, 999.0), direction, most=5)
    np.testing.assert_array_equal(few.times, found.times[:5])


def test_sections_of_surfaces_with_corners():
    """|q| = 1 on every arc."""
    found = ph.section(wedge(), [0.0, 1.5, 1.0], lambda t, m: jnp.abs(m[0]) - 1.0, (0.0, 300.0))
    assert found.times == pytest.approx(3.0 * np.arange(100) + 1.0, abs=1e-12)


def test_a_border_that_is_not_minded_is_seen(monkeypatch):
    monkeypatch.setattr(switching, "settle", lambda of, y, signs, *others: list(signs))
    with pytest.raises(InvalidInput, match="whose border it has crossed undetected"):
        ph.simulate(wedge(), [0.3, 1.5, 1.0], [0.0, 10.0], method=ph.integrators.Taylor())


def test_sides_that_never_agree_are_refused():
    class Never:
        def sides_of(self, y, *others):
            return [(not self.signs[0],)] * len(y)

        def __init__(self, signs):
            self.signs = signs

    with pytest.raises(Untraceable, match="lead back to each other"):
        sides.settle(Never, np.zeros((2, 1)), [(True,), (False,)], np.array([-1, 0]), 1.0, np.ones(2))


def test_a_limited_bump_is_not_stepped_over():
    """Of the limits, one side's number was compared with the other as if they depended on the time: other steps."""
    field = lambda t, y: jnp.stack([1.0 + 0.0 * y[0], jnp.clip(1.0 - jnp.abs(y[0] - 500.0), 0.0, 1.0)])  # noqa: E731
    found = ph.simulate(OwnField(field), [0.0, 0.0], [0.0, 1000.0])
    assert found.states[-1].tolist() == [1000.0, 1.0]


def test_a_node_that_is_infinite_ends_the_series_at_once():
    """cosh² of 500 is no number, and shorter units of time were tried for ever."""
    field = lambda t, y: jnp.stack([1.0 + 0.0 * y[0], 1.0 / jnp.cosh(y[0] - 500.0) ** 2])  # noqa: E731
    with pytest.raises(NotConverged):
        ph.simulate(OwnField(field), [0.0, 0.0], [0.0, 1000.0], Taylor)


CORNERS = {  # of H beside p²/2: what jax.grad makes of it asks for its side several times, or in other words
    "an abs in a product": lambda q: jnp.abs(q) * (1.0 + q**2),
    "its square beside it": lambda q: jnp.abs(q) + 0.5 * jnp.abs(q) ** 2,
    "within a root": lambda q: jnp.sqrt(jnp.abs(q) + 0.01),
    "the greater": lambda q: jnp.maximum(q, -2.0 * q),
    "two corners in one place": lambda q: jnp.abs(q) + jnp.abs(q + q**3),
    "a step": lambda q: jnp.heaviside(q, 0.5) * q + q**2,
    "a limit": lambda q: q * jnp.clip(q, -0.3, 0.4),
}


def by_dop853(potential, start, t, corners):
    """A motion by SciPy, which begins anew at each corner, where it is put beside the border."""
    slope = jax.jit(jax.grad(potential))
    y, now, end = np.array(start, float), 0.0, t
    for c in range(200):
        events = [lambda s, y, c=c: y[0] - c for c in corners]
        for event in events:
            event.terminal = True
        run = solve_ivp(lambda s, y: (y[1], -float(slope(y[0]))), (now, end), y, method="DOP853", rtol=1e-13,
                        atol=1e-14, events=events)  # fmt: skip
        now, y = run.t[-1], run.y[:, -1]
        if run.status != 1:
            return y
        y = y + 1e-11 * np.array([y[1], -float(slope(y[0] + 1e-9 * y[1]))])
        now += 1e-11
    raise AssertionError("too many corners")


@pytest.mark.long_after(3)
@pytest.mark.parametrize("name", CORNERS)
def test_corners_are_passed_in_whatever_words_they_are(name):
    potential, corners = CORNERS[name], (-0.3, 0.4) if name == "a limit" else (0.0,)
    system = LiePoisson(Heisenberg(1), lambda m: 0.5 * m[1] ** 2 + potential(m[0]))
    run = ph.simulate(system, [1.0, 0.3, 1.0], [0.0, 10.0])
    # along which way t runs is a matter of the algebra's sign
    rates = np.asarray(system.vector_field(0.0, jnp.array([1.0, 0.3, 1.0])))
    forth = np.sign(rates[0] * 0.3)
    wanted = by_dop853(potential, (1.0, 0.3 * forth), 10.0, corners)
    assert np.abs(run.states[-1][:2] - wanted * (1.0, forth)).max() < 1e-8
    assert run.error_estimate < 1e-11 and run.drift["energy"] < 1e-13 and run.statistics["steps"] < 200


def test_neighbours_part_at_a_corner_as_they_do_beside_it():
    """The derivative of a map past corners, by differences of motions and not by their tangents."""
    system = LiePoisson(Heisenberg(1), lambda m: 0.5 * m[1] ** 2 + jnp.abs(m[0]) * (1.0 + m[0] ** 2))
    matrix, start, step = ph.analysis.monodromy(system, [1.0, 0.3, 1.0], (0.0, 10.0)), np.array([1.0, 0.3, 1.0]), 1e-5
    for k in range(2):
        off = step * np.eye(3)[k]
        ends = [ph.simulate(system, start + side * off, [0.0, 10.0]).states[-1] for side in (-1.0, 1.0)]
        np.testing.assert_allclose(matrix[:2, k], ((ends[1] - ends[0]) / (2.0 * step))[:2], atol=1e-7, rtol=1e-7)
    assert not ph.analysis.lyapunov(system, start, (0.0, 300.0)).is_chaotic  # with one degree of freedom


def test_what_stays_equal_is_no_crossing():
    system = LiePoisson(Heisenberg(1), lambda m: 0.5 * m[1] ** 2 + jnp.where(m[0] == 0.0, 0.0, m[0] ** 2))
    assert (ph.simulate(system, [0.0, 0.0, 1.0], [0.0, 5.0]).states[-1] == [0.0, 0.0, 1.0]).all()


def test_no_derivative_is_given_past_where_a_motion_rests():
    body = RigidBody((1.0, 2.0, 2.5), [Wheel((0, 0, 1), 0.1, friction)])
    start = body.pack(rates=[1.0], attitude=(1.0, 0.0, 0.0, 0.0))
    with pytest.raises(InvalidInput, match="the derivative of the motion of RigidBody is not known"):
        ph.analysis.monodromy(body, start, (0.0, 5.0))
