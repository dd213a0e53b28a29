"""Rotations and their momenta: T*SO(3), its two trivialisations, momentum maps, and reduction to so(3)*.

A covector at R is a matrix P (…, 3, 3), paired with velocities by ½ tr(PᵀṘ). A trivialisation carries it to the
identity: from the left it is the body momentum L, ⟨P, R hat(ξ)⟩ = L · ξ; from the right the space momentum π,
⟨P, hat(η) R⟩ = π · η; π = R L.
Source: Marsden & Ratiu, *Introduction to Mechanics and Symmetry*, §13.2–13.4, 15.
"""

from __future__ import annotations

from polhode import rotation
from polhode._base.arrays import require_doubles
from polhode.errors import InvalidInput, shown
from polhode.types import Array, ArrayLike, Float64, Real


def left_trivialize(
    attitude: Real[ArrayLike, "*#batch 4"], covector: Real[ArrayLike, "*#batch 3 3"]
) -> Float64[Array, "*batch 3"]:
    """Return the body momentum L (…, 3) of covectors P (…, 3, 3) at attitudes (…, 4)."""
    require_doubles(covector=covector)
    R = rotation.as_matrix(attitude)
    return _antisymmetric_part(_transpose(R) @ covector)


def right_trivialize(
    attitude: Real[ArrayLike, "*#batch 4"], covector: Real[ArrayLike, "*#batch 3 3"]
) -> Float64[Array, "*batch 3"]:
    """Return the space momentum π (…, 3) of covectors P (…, 3, 3) at attitudes (…, 4)."""
    require_doubles(covector=covector)
    R = rotation.as_matrix(attitude)
    return _antisymmetric_part(covector @ _transpose(R))


def lifted_action(
    turn: Real[ArrayLike, "*#batch 4"], attitude: Real[ArrayLike, "*#batch 4"], covector: Real[ArrayLike, "*#batch 3 3"]
) -> tuple[Float64[Array, "... 4"], Float64[Array, "... 3 3"]]:
    """Return the cotangent lift of R → G R: attitude (…, 4) and covector (…, 3, 3) after a turn (…, 4) in space.

    It does not change the body momentum, and turns the space momentum by G.
    """
    require_doubles(covector=covector)
    return rotation.multiply(turn, attitude), rotation.as_matrix(turn) @ covector


def space_momentum(
    attitude: Real[ArrayLike, "*#batch 4"], momentum: Real[ArrayLike, "*#batch 3"]
) -> Float64[Array, "*batch 3"]:
    """Return π = R L (…, 3), the momentum map of turns in space, from body momenta."""
    return rotation.rotate(attitude, momentum)


def body_momentum(
    attitude: Real[ArrayLike, "*#batch 4"], momentum: Real[ArrayLike, "*#batch 3"]
) -> Float64[Array, "*batch 3"]:
    """Return L = Rᵀ π (…, 3), the momentum map of turns in the body, from space momenta."""
    return rotation.rotate(rotation.conjugate(attitude), momentum)


def reduce(
    attitude: Real[ArrayLike, "*#batch 4"], momentum: Real[ArrayLike, "*#batch 3"], side: str = "left"
) -> Float64[Array, "... 3"]:
    """Return the point of so(3)* to which a state in T*SO(3) reduces by symmetry under rotations.

    Args:
        attitude: (…, 4) unit quaternions wxyz, body → space.
        momentum: (…, 3) in space.
        side: "left" for Hamiltonians invariant under rotations in space (the rigid body; minus bracket, gives the
            body momentum), "right" for those invariant under rotations of the body (plus bracket, space momentum).

    Raises:
        InvalidInput: for another side.
    """
    if side == "left":
        return body_momentum(attitude, momentum)
    if side == "right":
        return momentum
    raise InvalidInput(f"`side` must be 'left' or 'right', as the Hamiltonian is invariant; got {shown(side)}.")


def _transpose(matrix: Array) -> Array:
    return matrix.swapaxes(-1, -2)


def _antisymmetric_part(matrix: Array) -> Array:
    # ½ tr((RᵀP)ᵀ hat(ξ)) sees the antisymmetric part of RᵀP alone, hat(L), and ½ tr(hat(L)ᵀ hat(ξ)) = L·ξ
    return rotation.vee(0.5 * (matrix - _transpose(matrix)))
