"""Laws of a Lie algebra and its dual, at random elements."""

from __future__ import annotations

from functools import partial
from typing import NamedTuple

import jax
import jax.numpy as jnp
import numpy as np

from polhode.algebra.base import AbstractLieAlgebra
from polhode.errors import InvalidInput
from polhode.poisson.brackets import bracket
from polhode.testing.laws import Laws, hold, hold_all
from polhode.types import Array


class AlgebraLimits(NamedTuple):
    """A tolerance of these checks."""

    rounding: float = 1e-12  # relative; some dozens of roundings


LIMITS = AlgebraLimits()


def check_algebra(algebra: AbstractLieAlgebra, seed: int = 0) -> None:
    """Check antisymmetry, Jacobi's identity, duality, coordinates, batches, Casimirs, and the group's action.

    Raises:
        LawBroken: naming the first law that fails.

    >>> from polhode.algebra import SO3
    >>> check_algebra(SO3())
    """
    points, small = 4, 0.1
    rng = np.random.default_rng(seed)
    x, y, z = (algebra.from_vector(jnp.asarray(rng.normal(size=(points, algebra.dim)))) for _ in range(3))
    mu = algebra.from_dual_vector(jnp.asarray(rng.normal(size=(points, algebra.dim))))
    weights = jnp.asarray(rng.normal(size=(3, algebra.dim)))
    hold_all(partial(_structure, algebra), LIMITS.rounding, x, y, z, mu)
    hold("one name a Casimir", len(algebra.casimir_names), algebra.casimirs(mu).shape[-1], 0.0)
    by_name, batch = algebra.named_casimirs(mu), algebra.batch_shape(mu)
    copied = {name for name, value in by_name.items() if jnp.ndim(value) > len(batch)}
    hold("Casimirs of which each copy has one", len(copied ^ {*algebra.casimirs_of_copies}), 0, 0.0)
    named = [jnp.reshape(value, (*batch, -1)) for value in by_name.values()]
    together = jnp.concatenate([algebra.casimirs(mu)[..., :0], *named], axis=-1)
    hold("Casimirs by name are the Casimirs", jnp.sort(together), jnp.sort(algebra.casimirs(mu)), LIMITS.rounding)
    hold_all(partial(_group, algebra), LIMITS.rounding, small * x, small * y, mu)
    hold_all(partial(_bracket_of_functions, algebra), LIMITS.rounding, weights, mu)


def _structure(algebra: AbstractLieAlgebra, x: Array, y: Array, z: Array, mu: Array) -> Laws:
    both = algebra.bracket
    laws = {
        "coordinates: from_vector undoes to_vector": (algebra.from_vector(algebra.to_vector(x)), x),
        "dual coordinates": (algebra.from_dual_vector(algebra.to_dual_vector(mu)), mu),
        "pairing is that of coordinates": (
            algebra.pairing(mu, x), jnp.sum(algebra.to_dual_vector(mu) * algebra.to_vector(x), axis=-1)
        ),
        "antisymmetry [x, y] = −[y, x]": (both(x, y), -both(y, x)),
        "bilinearity": (both(2.0 * x + z, y), 2.0 * both(x, y) + both(z, y)),
        "Jacobi's identity": (both(x, both(y, z)) + both(y, both(z, x)), -both(z, both(x, y))),
        "duality ⟨ad*_x μ, y⟩ = ⟨μ, [x, y]⟩": (
            algebra.pairing(algebra.coadjoint(x, mu), y), algebra.pairing(mu, both(x, y))
        ),
    }  # fmt: skip
    for name, function in {"bracket": both, "coadjoint": algebra.coadjoint}.items():
        one_by_one = jnp.stack([function(a, b) for a, b in zip(x, mu, strict=True)])
        laws[f"{name}: batch = loop"] = function(x, mu), one_by_one
    change = jax.jvp(algebra.casimirs, (mu,), (algebra.coadjoint(x, mu),))[1]
    laws["Casimirs are constant along ad*_x μ"] = change, jnp.zeros_like(change)
    return laws


def _group(algebra: AbstractLieAlgebra, x: Array, y: Array, mu: Array) -> Laws:
    moved = mu + algebra.exp_change(x, mu)
    rate = jax.jvp(lambda t: algebra.exp_change(t * x, mu), (0.0,), (1.0,))[1]
    laws = {
        "exp_change is Ad*_{exp x} μ − μ": (moved, algebra.coadjoint_action(algebra.exp(x), mu)),
        "Ad*_{gh} = Ad*_h Ad*_g": (
            algebra.coadjoint_action(algebra.compose(algebra.exp(x), algebra.exp(y)), mu),
            moved + algebra.exp_change(y, moved),
        ),
        "exp x exp x = exp 2x": (moved + algebra.exp_change(x, moved), mu + algebra.exp_change(2.0 * x, mu)),
        "Ad* keeps the Casimirs": (algebra.casimirs(moved), algebra.casimirs(mu)),
        "Ad*_{exp tx} begins as ad*_x": (rate, algebra.coadjoint(x, mu)),
    }
    try:
        changed = mu + algebra.cayley_change(x, mu)
    except InvalidInput:
        return laws
    laws["cayley_change is Ad*_{cay x} μ − μ"] = changed, algebra.coadjoint_action(algebra.cayley(x), mu)
    laws["Cayley's map keeps the Casimirs"] = algebra.casimirs(changed), algebra.casimirs(mu)
    return laws


def _bracket_of_functions(algebra: AbstractLieAlgebra, weights: Array, mu: Array) -> Laws:
    coordinate = [lambda m, w=w: jnp.sum(w * algebra.to_dual_vector(m)) for w in weights]

    def F(m: Array) -> Array:
        return jnp.sin(coordinate[0](m))

    def G(m: Array) -> Array:
        return coordinate[1](m) ** 2

    def K(m: Array) -> Array:
        return coordinate[2](m)

    of = partial(bracket, algebra)
    product = of(F, lambda m: G(m) * K(m))(mu)
    G_there, K_there = (jax.vmap(f)(mu) for f in (G, K))
    forward = of(F, G)(mu)
    first_two = of(F, of(G, K))(mu) + of(G, of(K, F))(mu)
    return {
        "Leibniz' rule": (product, forward * K_there + G_there * of(F, K)(mu)),
        "{F, G} = −{G, F}": (forward, -of(G, F)(mu)),
        "Jacobi's identity of functions": (first_two, -of(K, of(F, G))(mu)),
        "the plus bracket is the minus bracket reversed": (of(F, G, 1)(mu), -forward),
    }
