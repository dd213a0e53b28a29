"""A steady motion's derivatives, by which its stability is judged where no algebra gives them."""

from __future__ import annotations

from typing import NamedTuple

from polhode.types import Array, Float64


class SteadyMotion(NamedTuple):
    """A system's equations to first order, its energy and further conserved functions to second, at a steady motion.

    The coordinates are those whose neighbours are to stay close. Conserved functions take the part of Casimirs: a
    function of them and the energy whose second variation is definite on their level proves stability.

    Attributes:
        linearization: (n, n) derivative of the rates of change [1/s].
        energy_gradient: (n,) dE.
        energy_hessian: (n, n) D²E.
        gradients: (k, n) dJ of each further conserved function.
        hessians: (k, n, n) D²J.
        names: of these functions.
        legend: what the names stand for, where it is not usual.
        within: what the coordinates are, in words.
        without: what else the state holds, and need not stay close.
    """

    linearization: Float64[Array, "n n"]
    energy_gradient: Float64[Array, "n"]
    energy_hessian: Float64[Array, "n n"]
    gradients: Float64[Array, "k n"]
    hessians: Float64[Array, "k n n"]
    names: tuple[str, ...]
    legend: str = ""
    within: tuple[str, ...] = ()
    without: tuple[str, ...] = ()
