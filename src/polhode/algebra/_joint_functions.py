"""Functions of a point that are computed together, such as the traces of all powers of a matrix."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import NamedTuple

from polhode.algebra._functions import Function
from polhode.types import Array, Double, Float64

Joint = Callable[[Double[Array, "..."]], dict[str, Float64[Array, "..."]]]


class JointFunction(NamedTuple):
    """One of the functions that are computed together.

    Attributes:
        joint: gives the values of all of them at a point, by name; one object for all.
        name: of this one.
        sizes: gives Σ |x ∂C/∂x| of all of them, where their gradients are known; one object for all.
    """

    joint: Joint
    name: str
    sizes: Joint | None = None

    def __call__(self, point: Double[Array, "..."]) -> Float64[Array, "..."]:
        """Return its value (…) at points."""
        return self.joint(point)[self.name]


def evaluate_jointly(
    functions: Mapping[str, Function], point: Double[Array, "..."]
) -> dict[str, Float64[Array, "..."]]:
    """Return the values of functions at points by name; those that are computed together are computed once."""
    computed: dict[int, dict[str, Array]] = {}  # by identity, as methods of systems with arrays have no hash
    values = {}
    for name, function in functions.items():
        if isinstance(function, JointFunction):
            key = id(function.joint)
            if key not in computed:
                computed[key] = function.joint(point)
            values[name] = computed[key][function.name]
        else:
            values[name] = function(point)
    return values


def evaluate_sizes(functions: Mapping[str, Function], point: Double[Array, "..."]) -> dict[str, Float64[Array, "..."]]:
    """Return the sizes Σ |x ∂C/∂x| of those functions at points that say them, by name."""
    known = {name: function._replace(joint=function.sizes) for name, function in functions.items()
             if isinstance(function, JointFunction) and function.sizes is not None}  # fmt: skip
    return evaluate_jointly(known, point)
