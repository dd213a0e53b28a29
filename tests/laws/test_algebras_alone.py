"""Every method of every algebra and every function of ``poisson``, alone under jit, vmap, jvp and grad."""

import inspect

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from polhode import algebra as lie
from polhode import poisson
from polhode.errors import InvalidInput
from specimens import ALGEBRAS
from transformed import check_alone

RNG = np.random.default_rng(3)
AT_ONCE = ("bracket", "coadjoint", "exp", "cayley_change")
LEFT_OUT = {"structure_constants": "takes no arrays", "batch_shape": "gives a shape"}
ABSTRACT = {lie.AbstractLieAlgebra, lie.AbstractMatrixAlgebra}
MAKERS = {"from_matrices", "from_structure_constants"}
OF_AN_ALGEBRA = {"centre", "index", "killing_form", "polynomial_casimirs"}


def one_of_each_class():
    found = {}
    for algebra in ALGEBRAS:
        if algebra.dim < 16:
            found.setdefault(type(algebra), algebra)
    return found


def methods():
    """Each function once where it works on real numbers, and once where on complex ones; heirs share it."""
    tested = set()
    for algebra in one_of_each_class().values():
        for name in dir(type(algebra)):
            method = inspect.getattr_static(type(algebra), name)
            if name.startswith("_") or name in LEFT_OUT or not inspect.isfunction(method):
                continue
            one = method, np.issubdtype(algebra.dtype, np.complexfloating)
            if one in tested:
                continue
            tested.add(one)
            slow = [] if isinstance(algebra, lie.SO3) and name in AT_ONCE else [pytest.mark.sweep]
            yield pytest.param(algebra, name, id=f"{algebra.name} {name}", marks=slow)


def test_no_public_class_is_forgotten():
    classes = {getattr(lie, name) for name in lie.__all__ if inspect.isclass(getattr(lie, name))}
    assert classes - ABSTRACT <= set(one_of_each_class())
    functions = {name for name in lie.__all__ if inspect.isfunction(getattr(lie, name))}
    assert functions == MAKERS | OF_AN_ALGEBRA


def argument(algebra, name):
    """Return how an argument is made of real coordinates, by its name."""
    return {
        "x": lambda v: algebra.from_vector(0.3 * v), "y": algebra.from_vector, "mu": algebra.from_dual_vector,
        "g": lambda v: algebra.exp(algebra.from_vector(0.3 * v)),
        "h": lambda v: algebra.exp(algebra.from_vector(0.2 * v)), "vector": lambda v: v,
        "gradient": algebra.from_dual_vector, "value": algebra.from_vector, "matrix": algebra.from_vector,
        "coefficients": lambda v: jnp.concatenate([v[..., :1], v], -1).reshape(*v.shape[:-1], algebra.n, algebra.n),
    }[name]  # fmt: skip


@pytest.mark.parametrize(("algebra", "name"), list(methods()))
def test_method_alone(algebra, name):
    method = getattr(algebra, name)
    makers = [argument(algebra, parameter) for parameter in inspect.signature(method).parameters]
    points = [RNG.normal(size=(3, algebra.dim)) for _ in makers]
    apply = lambda *v: method(*(make(x) for make, x in zip(makers, v, strict=True)))  # noqa: E731
    try:
        apply(*(p[0] for p in points))
    except InvalidInput:
        with pytest.raises(InvalidInput):
            jax.eval_shape(apply, *(p[0] for p in points))
        return
    check_alone(apply, *points)


# ---------------------------------------------------------------------- Poisson geometry

SO3, SU2 = lie.SO3(), lie.SU(2)
REFUSE = {"orbit_dimension", "orbit_tangent", "kks_matrix", "restricted_bracket", "symplectic_area", "liouville_volume"}
QUICK = ("poisson_tensor", "kks_form", "hamiltonian_field", "reduce")
TIMES = np.array([0.0, 0.3, 0.5, 0.9])


def quartic(mu):
    return 0.5 * jnp.dot(mu, mu * jnp.array([1.0, 2.0, 3.0])) + mu[0] ** 4


def along(mu):
    return mu[0] * mu[1]


POINTS, OTHER, THIRD = RNG.normal(size=(3, 3, 3))
TURNS, OTHERS = (x / np.linalg.norm(x, axis=-1, keepdims=True) for x in RNG.normal(size=(2, 3, 4)))
MATRICES = RNG.normal(size=(3, 3, 3))
FUNCTIONS = {
    "bracket": (poisson.bracket(SO3, quartic, along), POINTS),
    "time_derivative": (poisson.time_derivative(SO3, along, quartic), POINTS),
    "hamiltonian_field": (poisson.hamiltonian_field(SO3, quartic), POINTS),
    "differential": (poisson.differential(SO3, quartic), POINTS),
    "poisson_tensor": (lambda mu: poisson.poisson_tensor(SO3, mu), POINTS),
    "kks_form": (lambda mu, x, y: poisson.kks_form(SO3, mu, x, y), POINTS, OTHER, THIRD),
    "left_trivialize": (poisson.left_trivialize, TURNS, MATRICES),
    "right_trivialize": (poisson.right_trivialize, TURNS, MATRICES),
    "lifted_action": (poisson.lifted_action, TURNS, OTHERS, MATRICES),
    "space_momentum": (poisson.space_momentum, TURNS, POINTS),
    "body_momentum": (poisson.body_momentum, TURNS, POINTS),
    "reduce": (poisson.reduce, TURNS, POINTS),
    "reconstruct": (
        lambda L, q: poisson.reconstruct(TIMES, L, lambda x: x / jnp.array([1.0, 2.0, 3.0]), q),
        1.0 + 0.1 * RNG.normal(size=(3, 4, 3)), TURNS,
    ),
    "reconstruct_group": (
        lambda L: poisson.reconstruct_group(SO3, TIMES, L, lambda x: x / jnp.array([1.0, 2.0, 3.0])).elements,
        1.0 + 0.1 * RNG.normal(size=(3, 4, 3)),
    ),
}  # fmt: skip


def test_no_public_function_is_forgotten():
    assert {name for name in poisson.__all__ if name not in ("Reconstruction", "GroupPath")} == set(FUNCTIONS) | REFUSE


@pytest.mark.parametrize("name", [pytest.param(n, marks=[] if n in QUICK else [pytest.mark.sweep])
                                  for n in FUNCTIONS])  # fmt: skip
def test_poisson_function_alone(name):
    function, *points = FUNCTIONS[name]
    check_alone(function, *points, batched=not name.startswith("reconstruct"))
