"""Conditions on parameters under which an expression is positive, or a symmetric matrix definite."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from polhode._base import check
from polhode.errors import InvalidInput, shown
from polhode.proving.symbolic._gate import sympy


def positive_condition(expression: Any, signs: Mapping[Any, int] | None = None) -> Any:
    """Return the condition for an expression of real symbols to be positive, simplified.

    Factors whose sign follows from the symbols' assumptions are left out, even powers become ≠ 0, and the rest is
    written with positive terms on both sides: L² − 4 I m > 0 as L² > 4 I m.

    Args:
        expression: rational in its symbols.
        signs: factors whose sign is given, ±1.

    Returns:
        A relation, a combination of relations, or SymPy's true or false.

    >>> I1, I2 = sympy.symbols("I1 I2", positive=True)
    >>> positive_condition(1 / I2 - 1 / I1)
    I1 > I2
    """
    factors = _odd_factors(expression)
    if factors is None:
        return sympy.false
    sign, odd, even = factors
    conditions = [sympy.Ne(f, 0) for f in even if not f.is_nonzero]
    rest = []
    for factor in odd:
        known = _known_sign(factor, signs or {})
        if known:
            sign *= known
        else:
            rest.append(factor)
    if not rest:
        return sympy.And(*conditions) if sign > 0 else sympy.false
    most_cases = 2  # factors of unknown sign that are written as cases; more stay one product
    if len(rest) == 1:
        conditions.append(_relation(sign * rest[0]))
    elif len(rest) == most_cases:
        first, second = rest
        cases = [sympy.And(_relation(a * first), _relation(a * sign * second)) for a in (1, -1)]
        conditions.append(sympy.Or(*cases))
    else:
        conditions.append(_relation(sign * sympy.Mul(*rest)))
    return sympy.And(*conditions)


def definite_conditions(matrix: Any) -> tuple[Any, Any]:
    """Return the conditions for a symmetric matrix to be positive, and to be negative definite.

    By the leading minors of the blocks into which it falls apart (Sylvester).

    Raises:
        InvalidInput: for a matrix that is not symmetric.
    """
    return _definite(matrix, 1), _definite(matrix, -1)


def definite_for_some(matrix: Any, unknown: Any) -> tuple[Any, Any]:
    """Return the conditions for a symmetric matrix to be positive, and negative, definite for some real unknown.

    Decided where the minors are linear in the unknown, or one concave quadratic, whose largest value must be positive.

    Raises:
        InvalidInput: for minors of another form.
    """
    return _definite(matrix, 1, unknown), _definite(matrix, -1, unknown)


def unstable_condition(characteristic: Any, exponent: Any) -> Any:
    """Return the condition for a Hamiltonian characteristic polynomial to have a root with positive real part.

    But for a power of s it is a polynomial of u = s². A factor p(u) gives no such root if and only if all its u are
    real and not positive: its coefficients and its discriminant are not negative, for degrees up to 3 in u.

    Raises:
        InvalidInput: for a polynomial that is not even, or a factor of a higher degree.
    """
    u = sympy.Dummy("u")
    powers = sympy.Poly(sympy.numer(sympy.together(characteristic)), exponent).terms()
    lowest = min(n for (n,), _ in powers)
    if any((n - lowest) % 2 for (n,), _ in powers):
        check.refuse("the characteristic polynomial", f"even in {exponent} but for a power of it", str(characteristic))
    even = sympy.Add(*(c * u ** ((n - lowest) // 2) for (n,), c in powers))
    cases = []
    for factor, _ in sympy.factor_list(even)[1]:
        poly = sympy.Poly(factor, u)
        if poly.degree() > 3:
            raise InvalidInput(f"factors of degree above 3 in {exponent}² are not decided; got "
                               f"{shown(str(factor.subs(u, exponent**2)))}.")
        if poly.degree():
            cases += [positive_condition(-poly.LC() * c) for c in poly.all_coeffs()[1:]]
        if poly.degree() > 1:
            cases.append(positive_condition(-poly.discriminant()))
    return sympy.Or(*cases)


def _odd_factors(expression: Any) -> tuple[int, list[Any], list[Any]] | None:
    """Return the sign of the constant, factors of odd and of even powers; None for zero."""
    constant, factors = sympy.factor_list(sympy.numer(together := sympy.together(sympy.sympify(expression))))
    below, others = sympy.factor_list(sympy.denom(together))
    number = constant / below
    if number == 0:
        return None
    powers = [*factors, *others]
    odd = [f for f, n in powers if n % 2]
    even = [f for f, n in powers if not n % 2]
    return (1 if number.is_positive else -1), odd, even


def _known_sign(factor: Any, signs: Mapping[Any, int]) -> int:
    if factor.is_positive or factor.is_negative:
        return 1 if factor.is_positive else -1
    for known, sign in signs.items():
        ratio = sympy.cancel(factor / known)
        if ratio.is_number:
            return sign if ratio.is_positive else -sign
    return 0


def _relation(expression: Any) -> Any:
    """Return expression > 0, with positive terms on both sides."""
    terms = sympy.Add.make_args(sympy.expand(expression))
    right = [-t for t in terms if t.could_extract_minus_sign()]
    left = [t for t in terms if not t.could_extract_minus_sign()]
    greater, less = (sympy.factor_terms(sympy.Add(*terms)) for terms in (left, right))
    return sympy.Lt(less, 0) if greater == 0 else sympy.Gt(greater, less)


def _definite(matrix: Any, sign: int, unknown: Any = None) -> Any:
    if sympy.simplify(matrix - matrix.T) != sympy.zeros(*matrix.shape):
        raise InvalidInput("a quadratic form must have a symmetric matrix. Take the mean of it and its transpose.")
    signs: dict[Any, int] = {}
    conditions, open_ones = [], []
    for block in _blocks(sign * matrix):
        for k in range(1, block.rows + 1):
            minor = sympy.factor(block[:k, :k].det())
            if unknown is not None and minor.has(unknown):
                open_ones.append(minor)
                continue
            conditions.append(positive_condition(minor, signs))
            if conditions[-1] == sympy.false:
                return sympy.false
            signs |= _single_sign(minor, signs)
    if open_ones:
        conditions.append(_for_some(open_ones, unknown))
    return sympy.And(*conditions)


def _single_sign(minor: Any, signs: Mapping[Any, int]) -> dict[Any, int]:
    """Return the sign that a positive minor gives its only factor of unknown sign."""
    factors = _odd_factors(minor)
    assert factors is not None
    sign, odd, _ = factors
    unknown = [f for f in odd if not _known_sign(f, signs)]
    for factor in odd:
        sign *= _known_sign(factor, signs) or 1
    return {unknown[0]: sign} if len(unknown) == 1 else {}


def _blocks(matrix: Any) -> Iterable[Any]:
    """Yield the diagonal blocks into which a symmetric matrix falls apart, smallest first."""
    left = list(range(matrix.rows))
    blocks = []
    while left:
        block, front = {left[0]}, [left[0]]
        while front:
            i = front.pop()
            near = {j for j in left if matrix[i, j] != 0} - block
            block |= near
            front += near
        left = [i for i in left if i not in block]
        blocks.append(sorted(block))
    for rows in sorted(blocks, key=len):
        yield matrix.extract(rows, rows)


def _for_some(minors: list[Any], unknown: Any) -> Any:
    """Return the condition for all minors to be positive at some value of the unknown."""
    polys = [sympy.Poly(sympy.numer(sympy.together(m)) * sympy.denom(sympy.together(m)), unknown) for m in minors]
    distinct = []
    for poly in polys:
        ratios = (sympy.cancel(poly.as_expr() / other.as_expr()) for other in distinct)
        if not any(ratio.is_positive for ratio in ratios):
            distinct.append(poly)
    if len(distinct) == 1 and distinct[0].degree() == 2:
        leading = distinct[0].LC()
        if sympy.factor(leading).is_negative:
            return positive_condition(distinct[0].discriminant())
        if sympy.factor(leading).is_positive:
            return sympy.true
    if all(poly.degree() == 1 for poly in distinct):
        slopes = [(sympy.factor(p.coeff_monomial(unknown)), p.coeff_monomial(1)) for p in distinct]
        if all(a.is_positive or a.is_negative for a, _ in slopes):
            above = [-b / a for a, b in slopes if a.is_positive]
            below = [-b / a for a, b in slopes if a.is_negative]
            return sympy.And(*(positive_condition(high - low) for low in above for high in below))
    raise InvalidInput(
        f"whether {shown(', '.join(str(m) for m in minors))} are positive for some {unknown} is not decided here. "
        "Put numbers in place of parameters, or give another conserved function."
    )
