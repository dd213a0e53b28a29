"""The walker of jaxprs: what it writes out, what depends on what, and that no other file looks into a jaxpr."""

import re
from pathlib import Path

import jax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode
import polhode.algebra
from polhode._base.arrays.by_numpy import by_numbers
from polhode._base.jaxprs import Listing, NoRule, depends_on, numbers_within, types_within

SOURCES = Path(polhode.__file__).parent
PARTS = re.compile(r"\.(eqns|invars|outvars|constvars|jaxpr|primitive)\b")
WALKERS = ["_base/jaxprs.py"]


def looking_in(texts):
    """Return the files that read the parts of a jaxpr."""
    return [name for name, text in texts.items() if PARTS.search(text)]


def test_one_file_alone_looks_into_jaxprs():
    texts = {path.relative_to(SOURCES).as_posix(): path.read_text("utf-8") for path in SOURCES.rglob("*.py")}
    assert looking_in(texts) == WALKERS
    assert looking_in({"a.py": "for e in closed.jaxpr.eqns:", "b.py": "jax.make_jaxpr(f)(x)"}) == ["a.py"]


@jax.custom_jvp
def doubled(x):
    return 2.0 * x


doubled.defjvp(lambda primals, tangents: (2.0 * primals[0], 2.0 * tangents[0]))


@jax.custom_vjp
def tripled(x):
    return 3.0 * x


tripled.defvjp(lambda x: (3.0 * x, None), lambda _, weights: (3.0 * weights,))
CALLED = {"jit": jax.jit(jnp.sin), "nested": jax.jit(lambda x: jax.jit(jnp.sin)(x) * 2.0), "derivative": doubled,
          "derivative of the reverse mode": tripled, "checkpoint": jax.checkpoint(jnp.sin)}  # fmt: skip
X = np.array([0.3, -1.2, 0.8])


def listed(function, *arguments):
    return Listing(jax.make_jaxpr(function)(*arguments))


@pytest.mark.parametrize("name", CALLED)
def test_what_is_called_is_written_out(name):
    listing = listed(lambda x: CALLED[name](x) + x[0], X)
    assert not {entry.name for entry in listing.entries} & {"jit", "custom_jvp_call", "custom_vjp_call", "checkpoint"}
    assert all(entry.within is None for entry in listing.entries)
    [value] = listing.run([X], by_numbers)
    np.testing.assert_allclose(value, CALLED[name](X) + X[0], rtol=1e-15)


def test_a_function_with_a_rule_of_its_own_is_kept_whole():
    closed = jax.make_jaxpr(lambda x: jax.jit(jnp.sinc)(x) * 2.0)(X)
    whole = Listing(closed, frozenset({"sinc"}))
    assert [entry.name for entry in whole.entries] == ["sinc", "mul"]
    assert len(Listing(closed).entries) > 2
    [value] = whole.entries[0].within.body.run([X], by_numbers)
    np.testing.assert_allclose(value, np.sinc(X), rtol=1e-15)


def test_outputs_bring_what_they_need_alone():
    listing = listed(lambda x: (jnp.sin(x), jax.jit(lambda y: (jnp.cos(y), jnp.tan(y)))(x)[0]), X)
    assert [entry.name for entry in listing.only([0]).entries] == ["sin"]
    assert [entry.name for entry in listing.only([1]).entries] == ["cos"]
    assert [entry.name for entry in listing.only().entries] == ["sin", "cos"]


def test_what_has_no_rule_is_named():
    (entry,) = listed(jax.lax.erf, X).entries
    with pytest.raises(NoRule, match="`erf` of numbers"):
        entry.rule({"sin": np.sin}, "numbers")
    assert entry.rule({"erf": np.sin}, "numbers") is np.sin


T = 0.5


def swapped(t, y):
    """The time comes to what is returned after two rounds, and no sooner."""
    return jax.lax.fori_loop(0, 5, lambda k, c: (t, c[0], c[1]), (y, y, y))[2]


DEPENDS = {
    "itself": (lambda t, y: (t, y), True),
    "a product with zero": (lambda t, y: y + 0.0 * t, True),
    "not at all": (lambda t, y: 2.0 * y, False),
    "what is thrown away": (lambda t, y: (jnp.sin(t), y)[1], False),
    "a call that ignores it": (lambda t, y: jax.jit(lambda t, y: 2.0 * y)(t, y), False),
    "one of two results of a call": (lambda t, y: jax.jit(lambda t, y: (2.0 * y, t * y))(t, y)[0], False),
    "carried in a loop": (lambda t, y: jax.lax.scan(lambda c, x: (c + x * t, c), 0.0, jnp.ones(3))[0], True),
    "carried beside": (lambda t, y: jax.lax.scan(lambda c, x: ((c[0], c[1] + x), c[0]), (t, y), jnp.ones(3))[0][1],
                       False),
    "stacked": (lambda t, y: jax.lax.scan(lambda c, x: ((c[0], c[1] + x), c[0]), (t, y), jnp.ones(3))[1], True),
    "after rounds": (swapped, True),
    "how often": (lambda t, y: jax.lax.while_loop(lambda c: c[0] < t, lambda c: (c[0] + 0.1, c[1] * 2.0), (0.0, y))[1],
                  True),
    "which branch": (lambda t, y: jax.lax.cond(t > 0.3, lambda: y, lambda: 2.0 * y), True),
    "in a branch": (lambda t, y: jax.lax.cond(y > 0.3, lambda: y * t, lambda: y), True),
    "in no branch": (lambda t, y: jax.lax.cond(y > 0.3, lambda t: y, lambda t: 2.0 * y, t), False),
}  # fmt: skip


@pytest.mark.parametrize("name", DEPENDS)
def test_what_depends_on_an_argument(name):
    function, does = DEPENDS[name]
    assert depends_on(jax.make_jaxpr(function)(T, 0.7), 0) is does
    one, other = (np.concatenate([np.ravel(x) for x in jax.tree.leaves(function(t, 0.7))]) for t in (T, 0.2))
    assert (one != other).any() == (does and name != "a product with zero")


def test_numbers_and_types_are_seen_wherever_they_are():
    inside = lambda c: jnp.asarray(np.array([5.0, 6.0]), jnp.float32) * c  # noqa: E731
    closed = jax.make_jaxpr(lambda y: jax.lax.cond(y[0] > 7.0, lambda: inside(y[1].astype(jnp.float32)),
                                                   lambda: jnp.zeros(2, jnp.float32)))(X)  # fmt: skip
    seen = {x for number in numbers_within(closed) for x in np.ravel(np.asarray(number)).tolist()}
    assert {5.0, 6.0, 7.0} <= seen and {"float32", "float64"} <= set(types_within(closed))
