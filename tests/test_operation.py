"""The laws of a function of JAX with derivatives of its own, each of which a broken specimen fails."""

from dataclasses import replace

import jax
import jax.numpy as jnp
import mpmath
import numpy as np
import pytest

from polhode._base.arrays import Elementwise
from polhode._base.arrays.operation import Operation, along, first_order_only, transposed
from polhode.errors import InvalidInput

POINTS = np.array([[0.7, 0.3], [1.9, 0.5], [-0.4, 0.2]])
CLOSE = 1e-14
"""Relative to the largest number: some roundings of sines."""
TWICE = 1e-9
"""Relative: second derivatives by differences of order eight, or through a loop that ends at roundings."""


@pytest.fixture(autouse=True)
def doubles():
    with jax.enable_x64(True):
        yield


# ---------------------------------------------------------------------- E of Kepler's equation, by a loop


def kepler(x):
    """Return E − e sin E = M of x = (M, e), by steps until nothing changes."""

    def improve(carried):
        E, _ = carried
        better = E - (E - x[1] * jnp.sin(E) - x[0]) / (1.0 - x[1] * jnp.cos(E))
        return better, jnp.abs(better - E) > 1e-15

    E = jax.lax.while_loop(lambda now: now[1], improve, (x[0] + x[1] * jnp.sin(x[0]), True))[0]
    # one step from the root has the root's derivatives, first and second ones after another of these
    for _ in range(2):
        E = E - (E - x[1] * jnp.sin(E) - x[0]) / (1.0 - x[1] * jnp.cos(E))
    return jnp.stack([E])


def kepler_back(at, results, weights):
    """dE = (dM + sin E de)/(1 − e cos E), transposed."""
    (x,), E = at.arguments, results[0]
    return [weights[0] * jnp.stack([jnp.ones_like(E), jnp.sin(E)]) / (1.0 - x[1] * jnp.cos(E))]


def kepler_exactly(x):
    return [mpmath.findroot(lambda E: E - x[1] * mpmath.sin(E) - x[0], x[0])]


def without_eccentricity(at, results, weights):
    """A transpose that has forgotten a part."""
    return [x * jnp.array([1.0, 0.0]) for x in kepler_back(at, results, weights)]


def too_far(at, results, changes):
    return [(1.0 + 1e-12) * dx for dx in along(kepler)(at, results, changes)]


def at_a_fixed_point(at, results, changes):
    """A derivative that does not depend on where it is taken."""
    return along(kepler)(replace(at, arrays=jax.lax.stop_gradient(at.arrays)), results, changes)


def over_loop(**more):
    parts = {"evaluate": kepler, "forward": along(kepler), "back": kepler_back, "second": "forward"}
    return Operation("kepler", **{**parts, **more})


# ---------------------------------------------------------------------- a function of NumPy


def wave(x, t):
    x, t = np.broadcast_arrays(x, np.asarray(t)[..., None])
    a, t = x[..., 0], t[..., 0]
    return np.stack([a * np.sin(a * t), np.cos(t) / (2.0 + a)], axis=-1), (a > t).astype(int)


def wave_and_columns(x, t):
    values = wave(x, t)
    a, t = np.broadcast_arrays(x[..., 0], t)
    of_first = np.stack([np.sin(a * t) + a * t * np.cos(a * t), a * a * np.cos(a * t)], axis=-1)
    of_second = np.stack([-np.cos(t) / (2.0 + a) ** 2, -np.sin(t) / (2.0 + a)], axis=-1)
    return values, np.stack([of_first, of_second], axis=-2)


def wave_ahead(x, t, dx, dt):
    changes = np.concatenate(np.broadcast_arrays(dx, dt[..., None]), axis=-1)
    return (np.einsum("...mn,...n->...m", wave_and_columns(x, t)[1], changes),)


def wave_back(x, t, weights):
    cotangents = np.einsum("...mn,...m->...n", wave_and_columns(x, t)[1], weights)
    return cotangents[..., :1], cotangents[..., 1]


def wave_exactly(x):
    return [x[0] * mpmath.sin(x[0] * x[1]), mpmath.cos(x[1]) / (2 + x[0])]


def mixed(x, t):
    """Values that depend on the other copies of a batch."""
    first, second = wave(x, t)
    return first - (first.mean(axis=0) if first.ndim > 1 else 0.0), second


def on_host(values=wave, jacobian=wave_and_columns, **more):
    called = Elementwise("wave", values, ((1,), ()), (((2,), float), ((), int)), jacobian, on_host=True, **more)
    return lambda x: called(x[:1], x[1])[0]


WAYS = {"forward": wave_ahead, "back": wave_back}
SOUND = {
    "a loop and a transpose": (over_loop(), kepler_exactly),
    "a loop and JAX's transpose": (over_loop(back=transposed(lambda x: kepler_counted(x))), kepler_exactly),
    "NumPy and a Jacobian": (on_host(), wave_exactly),
    "NumPy and products": (on_host(**WAYS), wave_exactly),
}
BROKEN = {
    "forward": (over_loop(forward=too_far), kepler_exactly),
    "transpose": (over_loop(back=without_eccentricity), kepler_exactly),
    "values": (over_loop(evaluate=lambda x: 1.000001 * kepler(x)), kepler_exactly),
    "batch": (on_host(mixed), wave_exactly),
    "second": (over_loop(forward=at_a_fixed_point), kepler_exactly),
}


def kepler_counted(x):
    """The same by a loop that JAX transposes."""
    step = lambda _, E: E - (E - x[1] * jnp.sin(E) - x[0]) / (1.0 - x[1] * jnp.cos(E))  # noqa: E731
    return jnp.stack([jax.lax.fori_loop(0, 12, step, x[0])])


def exact_slopes(exactly, point, weights):
    """Return values, first derivatives, and second ones of the weighed values, by differences in sixty digits."""
    with mpmath.workdps(60):
        x, tiny = [mpmath.mpf(float(v)) for v in point], mpmath.mpf(10) ** -15
        at = lambda *moves: exactly([v + tiny * sum(m[k] for m in moves) for k, v in enumerate(x)])  # noqa: E731
        units = [[int(j == k) for j in range(len(x))] for k in range(len(x))]
        back = [[-c for c in unit] for unit in units]
        first = [[(at(units[k])[m] - at(back[k])[m]) / (2 * tiny) for k in range(len(x))] for m in range(len(at()))]
        weigh = lambda values: sum(float(w) * v for w, v in zip(weights, values, strict=True))  # noqa: E731
        second = [[(weigh(at(units[j], units[k])) - weigh(at(units[j], back[k])) - weigh(at(back[j], units[k]))
                    + weigh(at(back[j], back[k]))) / (4 * tiny**2) for k in range(len(x))] for j in range(len(x))]
        return np.array(at(), float), np.array(first, float), np.array(second, float)


def broken_laws(function, exactly):
    """Return the laws that a function (n,) → (m,) breaks."""
    point = jnp.asarray(POINTS[0])
    weights = np.linspace(0.4, 1.1, len(exactly(POINTS[0])))
    total = lambda x: jnp.sum(function(x) * weights)  # noqa: E731
    values, slopes, second = exact_slopes(exactly, POINTS[0], weights)
    broken = set()

    def check(law, found, wanted, tolerance=CLOSE):
        if not np.abs(np.asarray(found) - wanted).max() <= tolerance * np.abs(wanted).max():
            broken.add(law)

    check("values", function(point), values)
    check("values", jax.jit(function)(point), values)
    ahead, gradient = jax.jacfwd(function), jax.grad(total)
    check("forward", ahead(point), slopes)
    check("forward", jax.jit(ahead)(point), slopes)
    pushed = jax.linearize(function, point)[1]
    check("forward", pushed(POINTS[1]), slopes @ POINTS[1])
    found = np.asarray(ahead(point))
    check("transpose", gradient(point), weights @ found)
    check("transpose", jax.jit(jax.jacrev(function))(point), found)
    check("transpose", jax.linear_transpose(pushed, point)(jnp.asarray(weights))[0], weights @ found)
    many = jnp.asarray(POINTS)
    check("batch", jax.vmap(function)(many), np.stack([function(x) for x in many]))
    alone = np.stack([gradient(x) for x in many])
    check("batch", jax.jit(jax.vmap(gradient))(many), alone)
    check("batch", jax.jit(jax.grad(lambda x: jnp.sum(jax.vmap(total, in_axes=1)(x))))(many.T), alone.T)
    moved = jax.vmap(lambda x, dx: jax.jvp(function, (x,), (dx,))[1])(many, many[::-1])
    check("batch", moved, np.stack([jax.jvp(function, (x,), (dx,))[1] for x, dx in zip(many, many[::-1], strict=True)]))
    shared = lambda dx: jax.vmap(pushed)(dx)  # noqa: E731
    check("batch", jax.linear_transpose(shared, many)(jnp.tile(weights, (3, 1)))[0], np.tile(gradient(point), (3, 1)))
    check("second", jax.jit(jax.hessian(total))(point), second, TWICE)
    check("second", jax.jit(jax.jacfwd(jax.jacfwd(total)))(point), second, TWICE)
    return broken


@pytest.mark.parametrize("name", SOUND)
def test_values_derivatives_and_batches_are_right(name):
    assert broken_laws(*SOUND[name]) == set()


@pytest.mark.parametrize("law", BROKEN)
def test_each_law_has_a_specimen_that_breaks_it(law):
    assert law in broken_laws(*BROKEN[law])


# ---------------------------------------------------------------------- nests, constants, shared arguments


def test_arguments_are_nests_of_which_only_moving_arrays_are_asked_for():
    asked = []

    def scale(system, x):
        return {"value": system["factor"] * x ** system["power"], "count": jnp.asarray(x.size)}

    def back(at, results, weights):
        asked.append(at.which)
        return transposed(scale)(at, results, weights)

    operation = Operation("scale", scale, along(scale), back)
    system, x = {"factor": jnp.asarray(3.0), "power": 2, "note": "squares"}, jnp.array([1.0, 2.0])
    slopes = jax.jit(jax.grad(lambda x: jnp.sum(operation(system, x)["value"])))(x)
    assert slopes.tolist() == [6.0, 12.0] and set(asked) == {(1,)}
    with_factor = lambda f, x: jnp.sum(operation({**system, "factor": f}, x)["value"])  # noqa: E731
    assert float(jax.grad(with_factor)(jnp.asarray(3.0), x)) == 5.0
    each = jax.vmap(with_factor, in_axes=(None, 0))
    shared = jax.grad(lambda f: jnp.sum(each(f, jnp.stack([x, 2.0 * x]))))
    assert float(shared(jnp.asarray(3.0))) == 25.0  # the copies add up what they share
    value, change = jax.jvp(lambda x: operation(system, x), (x,), (x,))
    assert int(value["count"]) == 2 and change["count"].dtype == jax.dtypes.float0


def test_numpy_arrays_need_no_operation():
    called = Elementwise("wave", wave, ((1,), ()), (((2,), float), ((), int)))
    values = called(POINTS[:, :1], POINTS[:, 1])
    assert all(type(x) is np.ndarray for x in values) and (values[0] == wave(POINTS[:, :1], POINTS[:, 1])[0]).all()


# ---------------------------------------------------------------------- what is refused


def third(function):
    return jax.jacfwd(jax.jacfwd(jax.jacfwd(function)))


@pytest.mark.parametrize(("function", "derivative", "message"), [
    (Operation("f", kepler), jax.jacfwd, "`f` has no derivatives; take differences of its values"),
    (on_host(jacobian=None), jax.jacrev, "`wave` has no derivatives"),
    (lambda x: first_order_only(x, "f"), jax.jacfwd, "`f` has first derivatives only; take second ones"),
    (over_loop(second="none"), jax.hessian, "`kepler` has first derivatives only; take second ones"),
    (on_host(), third, "`wave` has first and second derivatives only; take third ones by differences"),
    (on_host(**WAYS), third, "`wave` has first and second derivatives only; take third ones by differences"),
    (over_loop(), lambda f: jax.jacrev(jax.jacfwd(f)), "`the derivative of kepler` loops .* forward derivatives only"),
])  # fmt: skip
def test_a_derivative_that_there_is_not_is_refused(function, derivative, message):
    with pytest.raises(InvalidInput, match=message):
        jax.eval_shape(derivative(function), jnp.asarray(POINTS[0]))
    assert np.isfinite(jax.vmap(function)(jnp.asarray(POINTS))).all()  # but not its values


def test_second_derivatives_of_numpy_go_by_either_mode():
    for ways in ({}, WAYS):
        total = lambda x: jnp.sum(on_host(**ways)(x))  # noqa: B023, E731
        back, ahead = jax.jacrev(jax.grad(total)), jax.jacfwd(jax.jacfwd(total))
        assert np.abs(back(jnp.asarray(POINTS[0])) - ahead(jnp.asarray(POINTS[0]))).max() < TWICE
