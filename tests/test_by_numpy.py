"""What NumPy does in place of JAX with numbers: operation by operation, and whole functions as steps."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode.algebra  # noqa: F401, switches JAX to 64 bits
from polhode._base.arrays.by_numpy import BY_NUMPY
from polhode._base.arrays.steps import Steps
from polhode._base.jaxprs import Listing, NoRule, split_scan

A = np.random.default_rng(0).uniform(0.2, 1.5, (2, 3, 4))
B = np.random.default_rng(1).uniform(0.2, 1.5, (2, 3, 4))
WHOLE = np.array([7, -7, 5])
PLACES = np.array([2, 0, 1, 9])  # one of them beyond
OPERATIONS = {
    "div": (lambda a, b: a / b, A, B),
    "div of whole numbers": (lambda a: jax.lax.div(a, jnp.array([2, 2, -3])), WHOLE),
    "integer_pow": (lambda a: a**-3, A),
    "square": (jnp.square, A),
    "sqrt": (jnp.sqrt, A),
    "sin": (jnp.sin, A),
    "cos": (jnp.cos, A),
    "abs": (jnp.abs, A - 1.0),
    "max": (jnp.maximum, A, B),
    "min": (jnp.minimum, A, B),
    "reduce_max": (lambda a: jnp.max(a, axis=(0, 2)), A),
    "reduce_sum": (lambda a: jnp.sum(a, axis=1), A),
    "dot_general": (lambda a, b: jnp.einsum("kij,klj->kil", a, b), A, B),
    "dot_general of vectors": (jnp.dot, A[0, 0], B[0, 0]),
    "dot_general of matrices": (jnp.matmul, A[0], B[0].T),
    "eq": (lambda a, b: a == b, A, B),
    "ne": (lambda a, b: a != b, A, B),
    "le": (lambda a, b: a <= b, A, B),
    "gt": (lambda a, b: a > b, A, B),
    "and": (lambda a: (a > 0.3) & (a < 1.0), A),
    "or": (lambda a: (a < 0.3) | (a > 1.0), A),
    "not": (lambda a: ~(a < 0.3), A),
    "iota": (lambda a: a + jax.lax.broadcasted_iota(float, (2, 3, 4), 1), A),
    "add": (lambda a, b: a + b, A, B),
    "add_any": (jax.grad(lambda a: jnp.sum(a**3) + jnp.sum(jnp.sin(a))), A),
    "sub": (lambda a, b: a - b, A, B),
    "mul": (lambda a, b: a * b, A, B),
    "neg": (lambda a: -a, A),
    "lt": (lambda a, b: a < b, A, B),
    "ge": (lambda a, b: a >= b, A, B),
    "xor": (lambda a: (a > 0.3) ^ (a < 1.0), A),
    "tan": (jnp.tan, A), "asin": (jnp.arcsin, A / 2.0), "acos": (jnp.arccos, A / 2.0), "atan": (jnp.arctan, A),
    "atan2": (jnp.arctan2, A - 0.7, B - 0.7), "sinh": (jnp.sinh, A), "cosh": (jnp.cosh, A), "tanh": (jnp.tanh, A),
    "exp": (jnp.exp, A), "exp2": (jnp.exp2, A), "expm1": (jnp.expm1, A), "log": (jnp.log, A), "log1p": (jnp.log1p, A),
    "cbrt": (jnp.cbrt, A - 0.7), "rsqrt": (jax.lax.rsqrt, A), "pow": (lambda a, b: a**b, A, B),
    "floor": (jnp.floor, 9.0 * (A - 0.7)), "ceil": (jnp.ceil, 9.0 * (A - 0.7)),
    "round": (jnp.round, np.array([0.5, 1.5, -2.5, 0.49999999999999994, 2.6])),
    "round away": (lambda a: jax.lax.round(a, jax.lax.RoundingMethod.AWAY_FROM_ZERO),
                   np.array([0.5, 1.5, -2.5, 0.49999999999999994, -0.0, 1e17])),
    "is_finite": (jnp.isfinite, np.array([1.0, np.inf, np.nan])),
    "sign": (jnp.sign, np.array([-0.0, 0.0, -2.0, 3.0, np.nan])),
    "rem": (jax.lax.rem, 9.0 * (A - 0.7), B),
    "rem of whole numbers": (lambda a: jax.lax.rem(a, jnp.array([2, 2, -3])), WHOLE),
    "clamp": (lambda a: jax.lax.clamp(0.4, a, 1.1), A),
    "complex": (jax.lax.complex, A, B),
    "real": (lambda a, b: jnp.real((a + 1j * b) ** 2), A, B),
    "imag": (lambda a, b: jnp.imag((a + 1j * b) ** 2), A, B),
    "conj": (lambda a, b: jnp.conj(a + 1j * b), A, B),
    "reduce_min": (lambda a: jnp.min(a, axis=1), A), "reduce_prod": (lambda a: jnp.prod(a, axis=(0, 1)), A),
    "reduce_and": (lambda a: jnp.all(a > 0.3, axis=0), A), "reduce_or": (lambda a: jnp.any(a > 1.4, axis=2), A),
    "argmax": (lambda a: jnp.argmax(a, axis=1), A), "argmin": (lambda a: jnp.argmin(a, axis=2), A),
    "cumsum": (lambda a: jnp.cumsum(a, axis=1), A),
    "cumsum from the end": (lambda a: jax.lax.cumsum(a, axis=2, reverse=True), A),
    "shift_left": (lambda a: a << 3, WHOLE), "shift_right_arithmetic": (lambda a: a >> 1, WHOLE),
    "bitcast_convert_type": (lambda a: jax.lax.bitcast_convert_type(a, jnp.int64), A[0, 0, 0]),
    "stop_gradient": (jax.lax.stop_gradient, A), "copy": (jnp.copy, A),
    "rev": (lambda a: a[::-1], A), "expand_dims": (lambda a: jax.lax.expand_dims(a, (1,)), A),
    "reshape": (lambda a: a.reshape(6, 4), A), "squeeze": (lambda a: a[:, :1][:, 0], A),
    "transpose": (lambda a: jnp.transpose(a, (2, 0, 1)), A),
    "broadcast_in_dim": (lambda a: jnp.broadcast_to(a, (5, 2, 3, 4)), A),
    "pad": (lambda a: jnp.pad(a, ((0, 0), (1, 2), (3, 0))), A),
    "pad between and less": (lambda a: jax.lax.pad(a, 7.0, ((-1, 2, 1), (2, -1, 0), (1, -2, 3))), A),
    "pad what is empty": (lambda a: jnp.pad(a[:, :0], ((0, 0), (1, 2), (0, 1))), A),
    "tile": (lambda a: jnp.tile(a, (2, 1, 3)), A),
    "gather": (lambda a: a[np.array([[1, 0], [0, 1]]), :, np.array([3, -1])], A),
    "gather of windows": (lambda a: jax.vmap(lambda k: jax.lax.dynamic_slice(a, (0, k, k), (2, 2, 3)))(PLACES), A),
    "gather that fills": (lambda a: jnp.asarray(a).at[:, PLACES - 1].get(mode="fill", wrap_negative_indices=False), A),
    "gather of copies": (lambda a: jnp.take_along_axis(a, np.argsort(A, axis=2), axis=2), A),
    "gather whole numbers": (lambda a: jnp.asarray(a).at[PLACES].get(mode="fill"), WHOLE),
    "scatter": (lambda a, b: jnp.asarray(a).at[:, np.array([2, 0])].set(b[:, :2]), A, B),
    "scatter of one number": (lambda a: jnp.asarray(a).at[jnp.argmax(a)].set(7), WHOLE),
    "scatter that clips": (lambda a: jnp.asarray(a).at[:, PLACES].set(7.0, mode="clip"), A),
    "scatter-add": (lambda a, b: jnp.asarray(a).at[np.array([1, 1]), :, np.array([2, 2])].add(b[:, :, 0]), A, B),
    "scatter_add": (lambda a: jnp.asarray(a).at[:, PLACES].add(2.0, mode="drop"), A),
    "scatter-add of a derivative": (jax.grad(lambda a: jnp.sum(a[:, PLACES % 3] ** 3)), A),
    "dynamic_slice": (lambda a: jax.lax.dynamic_slice(a, (0, jnp.argmax(a[0, :, 0]), 5), (1, 2, 2)), A),
    "dynamic_update_slice": (lambda a, b: jax.lax.dynamic_update_slice(a, b[:1, :2], (-1, 2, 0)), A, B),
    "slice": (lambda a: a[:, 1:, ::2], A), "concatenate": (lambda a, b: jnp.concatenate([a, b], axis=1), A, B),
    "convert_element_type": (lambda a: a.astype(int), 9.0 * A),
    "select_n": (lambda a, b: jnp.where(a > b, a, b), A, B),
    "select_n of three": (lambda a: jax.lax.select_n(jnp.array([2, 0, 1]), a, a + 1, a + 2), WHOLE),
    "split": (lambda a: jnp.concatenate(jnp.split(a, [1, 3], axis=2)[::-1], axis=2), A),
    "scan": (lambda a: jax.lax.scan(lambda s, x: (s + x, s * x), jnp.zeros(()), a[0, 0])[1], A),
    "scan from the end": (
        lambda a: jax.lax.scan(lambda s, x: (s + x, s * x), jnp.ones(()), a[0, 0], reverse=True)[1], A),
    "while": (lambda a: jax.lax.while_loop(lambda s: jnp.sum(s) < 100.0, lambda s: 1.5 * s + a, a), A),
    "cond": (lambda a: jax.lax.cond(jnp.sum(a) > 1e3, lambda: a, lambda: 2.0 * a), A),
    "switch": (lambda a: jax.lax.switch(a[0] - 5, [lambda: 1.0 * a, lambda: 2.0 * a, lambda: 3.0 * a]), WHOLE),
    "unstack": (lambda a: sum(x * k for k, x in enumerate(jnp.unstack(a, axis=1))), A),
    "a rule of its own": (lambda a: jax.nn.relu(a - 0.7), A),
    "a call within": (lambda a: jnp.linalg.norm(a, axis=-1), A),
    "stack": (lambda a, b: jnp.stack([a, b], axis=-1), A, B),
}


CLOSE = 5e-16  # of a result, that libraries of functions may differ by


@pytest.mark.parametrize("name", OPERATIONS)
def test_numbers_are_those_of_jax(name):
    function, *arguments = OPERATIONS[name]
    steps, wanted = Steps(Listing(jax.make_jaxpr(function)(*arguments))), np.asarray(function(*arguments))
    [value] = steps(arguments)
    assert value.dtype == wanted.dtype and value.shape == wanted.shape
    np.testing.assert_allclose(value, wanted, rtol=CLOSE if wanted.dtype.kind in "fc" else 0.0)
    assert (np.signbit(value.real) == np.signbit(wanted.real)).all() or np.isnan(wanted).any()


def test_all_operations_are_tried():
    assert set(BY_NUMPY) <= set(OPERATIONS)


MATRIX = np.random.default_rng(2).uniform(0.2, 1.5, (37, 50))
ROWS = {
    "a norm": lambda x: jnp.linalg.norm(x),
    "a long sum": lambda x: jnp.sum(jnp.tile(x, 40) ** 2),
    "a product with a matrix": lambda x: jnp.asarray(MATRIX) @ jnp.tile(x, 10),
    "a product of two": lambda x: jnp.outer(x, x) @ jnp.outer(x, x[::-1]),
    "functions": lambda x: jnp.exp(jnp.sin(x)) / jnp.cosh(x) + jnp.arctan2(x, x[::-1]) ** 1.7,
    "a mean of rows": lambda x: jnp.mean(x[:, None] * x, axis=0),
}


@pytest.mark.parametrize("name", ROWS)
def test_a_row_has_the_same_bits_whatever_stands_beside_it(name):
    rows = np.random.default_rng(3).uniform(0.2, 1.5, (1001, 5))
    of_many = jax.vmap(ROWS[name])
    compute = lambda x: Steps(Listing(jax.make_jaxpr(of_many)(x)))([x])[0]  # noqa: E731
    together = compute(rows)
    for k in (1, 2, 7):
        np.testing.assert_array_equal(compute(rows[:k]), together[:k])
    np.testing.assert_array_equal(compute(rows[500:503]), together[500:503])


def test_a_column_has_the_same_bits_whatever_stands_beside_it():
    columns = np.random.default_rng(3).uniform(0.2, 1.5, (50, 1001))
    of_many = jax.vmap(jnp.sum, in_axes=1)
    compute = lambda x: Steps(Listing(jax.make_jaxpr(of_many)(x)))([x])[0]  # noqa: E731
    np.testing.assert_array_equal([compute(columns[:, k : k + 1])[0] for k in range(20)], compute(columns)[:20])


@pytest.mark.parametrize("function", [
    jnp.sort, lambda a: jax.lax.reduce(a, 0.0, lambda s, x: 2.0 * s + x, (0,)),
    lambda a: jax.lax.fori_loop(0, 10**6, lambda k, s: jnp.cos(s), a),
    lambda a: jax.lax.scan(lambda s, x: (jnp.cos(s + x), None), a[0, 0, 0], jnp.ones(10**5))[0],
])  # fmt: skip
def test_what_numpy_lacks_or_takes_long_for_has_no_steps(function):
    try:
        steps = Steps(Listing(jax.make_jaxpr(function)(A)))
    except NoRule:
        return
    pytest.fail(f"{steps.count} steps")


def test_both_ways_in_which_jax_describes_a_loop_are_read():
    """JAX 0.11 gives a tree of the arguments where releases before gave two numbers."""

    class Tree:
        def unpack(self):
            return (None, None), (None,), (None, None, None)

    closed = jax.make_jaxpr(lambda x, a, b: jax.lax.scan(lambda c, y: (c * a + b * y, c), x[0], x))(A[0, 0], 0.5, 2.0)
    (loop,) = (equation for equation in closed.jaxpr.eqns if equation.primitive.name == "scan")
    assert split_scan(loop.params) == split_scan({"ft_in": Tree()}) == (2, 1)


def test_what_nobody_needs_is_left_out():
    assert Steps(Listing(jax.make_jaxpr(lambda a: (jnp.sin(a), jnp.cos(a) * 2.0 + a)[1])(A))).count == 3
