"""Laws of a Lie algebra and its dual, at random elements."""

from __future__ import annotations

from typing import Any

import jax
import jax.numpy as jnp
import numpy as np

from polhode.algebra.base import AbstractLieAlgebra
from polhode.errors import InvalidInput
from polhode.poisson.brackets import bracket
from polhode.testing.laws import hold

Array = Any
EXACT = 1e-12  # relative; some dozens of roundings
POINTS = 4
SMALL = 0.1


def check_algebra(algebra: AbstractLieAlgebra, seed: int = 0) -> None:
    """Check antisymmetry, Jacobi's identity, duality, coordinates, batches, Casimirs, and the group's action.

    Raises:
        LawBroken: naming the first law that fails.

    >>> from polhode.algebra import SO3
    >>> check_algebra(SO3())
    """
    rng = np.random.default_rng(seed)
    x, y, z = (algebra.from_vector(jnp.asarray(rng.normal(size=(POINTS, algebra.dim)))) for _ in range(3))
    mu = algebra.from_dual_vector(jnp.asarray(rng.normal(size=(POINTS, algebra.dim))))
    both = algebra.bracket
    hold("coordinates: from_vector undoes to_vector", algebra.from_vector(algebra.to_vector(x)), x, EXACT)
    hold("dual coordinates", algebra.from_dual_vector(algebra.to_dual_vector(mu)), mu, EXACT)
    pairs = jnp.sum(algebra.to_dual_vector(mu) * algebra.to_vector(x), axis=-1)
    hold("pairing is that of coordinates", algebra.pairing(mu, x), pairs, EXACT)
    hold("antisymmetry [x, y] = −[y, x]", both(x, y), -both(y, x), EXACT)
    hold("bilinearity", both(2.0 * x + z, y), 2.0 * both(x, y) + both(z, y), EXACT)
    hold("Jacobi's identity", both(x, both(y, z)) + both(y, both(z, x)), -both(z, both(x, y)), EXACT)
    paired = algebra.pairing(algebra.coadjoint(x, mu), y), algebra.pairing(mu, both(x, y))
    hold("duality ⟨ad*_x μ, y⟩ = ⟨μ, [x, y]⟩", *paired, EXACT)
    for name, function in {"bracket": both, "coadjoint": algebra.coadjoint}.items():
        one_by_one = jnp.stack([function(a, b) for a, b in zip(x, mu, strict=True)])
        hold(f"{name}: batch = loop", function(x, mu), one_by_one, EXACT)
    _check_casimirs(algebra, x, mu)
    _check_group(algebra, SMALL * x, mu)
    _check_bracket_of_functions(algebra, rng, mu)


def _check_casimirs(algebra: AbstractLieAlgebra, x: Array, mu: Array) -> None:
    values = algebra.casimirs(mu)
    hold("one name a Casimir", len(algebra.casimir_names), values.shape[-1], 0.0)
    change = jax.jvp(algebra.casimirs, (mu,), (algebra.coadjoint(x, mu),))[1]
    hold("Casimirs are constant along ad*_x μ", change, jnp.zeros_like(change), EXACT)


def _check_group(algebra: AbstractLieAlgebra, x: Array, mu: Array) -> None:
    moved = mu + algebra.exp_change(x, mu)
    hold("exp_change is Ad*_{exp x} μ − μ", moved, algebra.coadjoint_action(algebra.exp(x), mu), EXACT)
    twice = moved + algebra.exp_change(x, moved)
    hold("exp x exp x = exp 2x", twice, mu + algebra.exp_change(2.0 * x, mu), EXACT)
    hold("Ad* keeps the Casimirs", algebra.casimirs(moved), algebra.casimirs(mu), EXACT)
    rate = jax.jvp(lambda t: algebra.exp_change(t * x, mu), (0.0,), (1.0,))[1]
    hold("Ad*_{exp tx} begins as ad*_x", rate, algebra.coadjoint(x, mu), EXACT)
    try:
        turned = mu + algebra.cayley_change(x, mu)
    except InvalidInput:
        return
    hold("cayley_change is Ad*_{cay x} μ − μ", turned, algebra.coadjoint_action(algebra.cayley(x), mu), EXACT)
    hold("Cayley's map keeps the Casimirs", algebra.casimirs(turned), algebra.casimirs(mu), EXACT)


def _check_bracket_of_functions(algebra: AbstractLieAlgebra, rng: np.random.Generator, mu: Array) -> None:
    weights = jnp.asarray(rng.normal(size=(3, algebra.dim)))
    coordinate = [lambda m, w=w: jnp.sum(w * algebra.to_dual_vector(m)) for w in weights]

    def F(m: Array) -> Array:
        return jnp.sin(coordinate[0](m))

    def G(m: Array) -> Array:
        return coordinate[1](m) ** 2

    def K(m: Array) -> Array:
        return coordinate[2](m)

    for sign in (-1, 1):
        def of(a: Any, b: Any, sign: int = sign) -> Any:
            return bracket(algebra, a, b, sign)

        product = of(F, lambda m: G(m) * K(m))(mu)
        values = [jax.vmap(f)(mu) for f in (G, K)]
        hold("Leibniz' rule", product, of(F, G)(mu) * values[1] + values[0] * of(F, K)(mu), EXACT)
        hold("{F, G} = −{G, F}", of(F, G)(mu), -of(G, F)(mu), EXACT)
        first_two = of(F, of(G, K))(mu) + of(G, of(K, F))(mu)
        hold("Jacobi's identity of functions", first_two, -of(K, of(F, G))(mu), EXACT)
