"""Where the roots of a polynomial with rational coefficients are: none, or how far, to the right [Routh]."""

from __future__ import annotations

from flint import acb, ctx, fmpq, fmpq_poly

from polhode._base.rational._matrices import count_roots_beyond


def squarefree(p: fmpq_poly) -> fmpq_poly:
    """Return the polynomial that has each root once."""
    return p // p.gcd(p.derivative()) if p else p


def has_root_to_the_right(p: fmpq_poly) -> bool:
    """Whether a root has a positive real part.

    What p(λ) and p(−λ) share is λᵐ q(λ²), whose roots lie on the imaginary axis exactly where all those of q are real
    and negative. The rest has no root on that axis, and Routh's array tells on which side of it all are.

    >>> [has_root_to_the_right(fmpq_poly(c)) for c in ([1, 0, 2, 0, 1], [-1, 1])]
    [False, True]
    """
    shared = p.gcd(p(fmpq_poly([0, -1])))
    coefficients = shared.coeffs()
    start = next(k for k, c in enumerate(coefficients) if c)
    squares = squarefree(fmpq_poly(coefficients[start::2]))
    # the balls of real roots have no imaginary part, and none contains another root, or zero
    on_axis = sum(root.imag == 0 and root.real < 0 for root in _roots(squares))
    return on_axis < squares.degree() or count_roots_beyond(p // shared, fmpq(0)) != 0


def largest_real_part(p: fmpq_poly) -> float:
    """Return the largest real part of the roots where that is positive, else zero, rounded once."""
    enough, bits = 64, 128  # correct ones, eleven more than a double has
    if p.degree() < 1 or not has_root_to_the_right(p):
        return 0.0
    simple = squarefree(p)
    while True:  # until balls of roots on the axis, or near it, are smaller than the largest real part
        with ctx.workprec(bits):
            largest = max((root.real for root in _roots(simple)), key=lambda x: x.upper())
        if largest.rel_accuracy_bits() >= enough:
            return float(largest.mid())
        bits *= 2


def _roots(p: fmpq_poly) -> list[acb]:
    """Return balls that contain one root each."""
    return [root for root, _ in p.complex_roots()]  # type: ignore[attr-defined]  # it gives pairs, and its stub a ball
