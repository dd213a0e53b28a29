"""Packed states of a body with mounts and torques, and the axes along which these see it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from itertools import chain
from typing import Any, NamedTuple

import equinox as eqx
import jax.numpy as jnp
import numpy as np

from polhode import rotation
from polhode.arrays import known_numbers_only, refuse_single_precision
from polhode.errors import InvalidInput, shown
from polhode.motion._axes import Turn
from polhode.motion._layout import ATTITUDE, MOMENTUM, StateLayout, StatePart
from polhode.systems._symmetric import solve, times
from polhode.systems.base import AbstractSystem, as_finite_state, check_unit_attitude
from polhode.systems.mounts import AbstractMount
from polhode.systems.torques import AbstractTorque
from polhode.types import Array, ArrayLike, Float64, Real


class BodyState(NamedTuple):
    """A packed state taken apart.

    Attributes:
        attitude: (…, 4) or None.
        momentum: L (…, 3) of body and mounts.
        mounts: the own states (…, n) of the mounts, in their order.
        torques: those of the torques.
    """

    attitude: Float64[Array, "*batch 4"] | None
    momentum: Float64[Array, "*batch 3"]
    mounts: tuple[Float64[Array, "*batch n"], ...]
    torques: tuple[Float64[Array, "*batch n"], ...]


class Structure(NamedTuple):
    """The axes in which a body is given, with the mass properties that its moments do not tell.

    Attributes:
        turn: from the given axes to the principal ones.
        center_of_mass: (3,) with all mounts at rest [m, given axes].
        mass: () of all together [kg]; None where it is not known.
    """

    turn: Turn
    center_of_mass: Float64[Array, "3"]
    mass: Float64[Array, ""] | None


class AbstractPackedBody(AbstractSystem):
    """The state of a body with mounts and torques: attitude, momentum, the own states of mounts and of torques.

    Attitude and momentum of a state are those of the principal axes. What is on the body sees them along the given
    axes, so that no mount and no torque need know where the principal ones lie.
    """

    moments: eqx.AbstractVar[Float64[Array, "3"]]
    mounts: eqx.AbstractVar[tuple[AbstractMount, ...]]
    torques: eqx.AbstractVar[tuple[AbstractTorque, ...]]
    structure: eqx.AbstractVar[Structure | None]

    @property
    def given_axes(self) -> Float64[Array, "3 3"] | None:
        """(3, 3) principal axes by columns in the given ones, in which mounts and torques stand; None if the same."""
        return None if self.structure is None else self.structure.turn.matrix

    @property
    def inertia(self) -> Float64[Array, "3"] | Float64[Array, "3 3"]:
        """The inertia of all with the mounts locked at rest [kg m², given axes]: (3,) if diagonal, or (3, 3)."""
        if self.structure is None:
            return self.moments
        axes = self.structure.turn.matrix
        return (axes * self.moments) @ axes.T

    @property
    def carrier(self) -> Float64[Array, "3"] | Float64[Array, "3 3"]:
        """K [kg m², given axes], the inertia of what turns with Ω: (3,) if diagonal, or (3, 3)."""
        turning = [inertia for mount in self.mounts if (inertia := mount.inertia) is not None]
        whole = self.inertia
        return (jnp.diag(whole) if whole.ndim == 1 else whole) - sum(turning) if turning else whole

    @property
    def needs_attitude(self) -> bool:
        """Whether a mount or a torque depends on how the body is turned."""
        return any(attachment.needs_attitude for attachment in chain(self.mounts, self.torques))

    @property
    def own_parts(self) -> tuple[StatePart, ...]:
        """The parts of the state behind the momentum: of the mounts, then of the torques; equal names are counted."""
        parts = [part for attachment in chain(self.mounts, self.torques) for part in attachment.state_parts]
        often, seen = Counter(part.name for part in parts), Counter[str]()
        named = []
        for part in parts:
            seen[part.name] += 1
            named.append(part._replace(name=f"{part.name}_{seen[part.name]}") if often[part.name] > 1 else part)
        return tuple(named)

    # ------------------------------------------------------------------ axes

    def _as_given(self, body: BodyState) -> BodyState:
        """Return a state along principal axes along the given ones; the attachments' own states stand there already."""
        if self.structure is None:
            return body
        back = self.structure.turn.back
        attitude = None if body.attitude is None else back.attitude(body.attitude)
        return body._replace(attitude=attitude, momentum=back.vector(body.momentum))

    def _along_principal(self, vector: Array) -> Array:
        return vector if self.structure is None else self.structure.turn.vector(vector)

    # ------------------------------------------------------------------ packed states

    def pack(
        self, attitude: Real[ArrayLike, "*#batch 4"] | None = None,
        angular_velocity: Real[ArrayLike, "*#batch 3"] | None = None,
        momentum: Real[ArrayLike, "*#batch 3"] | None = None,
        rates: Sequence[Real[ArrayLike, "..."] | None] | None = None,
        actuators: Sequence[Real[ArrayLike, "..."] | None] | None = None,
    ) -> Float64[Array, "... n"]:  # fmt: skip
        """Return packed states (…, n), from what stands along the given axes; for a body from moments, the principal.

        Args:
            attitude: (…, 4) unit quaternion wxyz, given axes → space; left out, the state has none, or the identity
                where a mount or a torque needs it.
            angular_velocity: Ω (…, 3) of the body [rad/s, given axes]; this, ``momentum``, or neither for rest.
            momentum: L (…, 3) of the body with its mounts [kg m²/s, given axes].
            rates: of the mounts relative to the body, one for each mount in their order [rad/s], (…) for a rotor,
                (…, 3) for a slug; None, or the whole left out, is rest in the body.
            actuators: own states (…, n) of the torques, one for each torque in their order; None, or the whole left
                out, is zero.

        Raises:
            InvalidInput: if both velocity and momentum are given, or rates or actuators that do not fit what there is.
        """
        if angular_velocity is not None and momentum is not None:
            raise InvalidInput("give `angular_velocity` or `momentum`, not both.")
        refuse_single_precision(attitude=attitude, angular_velocity=angular_velocity, momentum=momentum)
        values, acting = self._checked_rates(rates), self._checked_actuators(actuators)
        if attitude is None and self.needs_attitude:
            attitude = jnp.array([1.0, 0.0, 0.0, 0.0])
        velocity = jnp.zeros(3) if angular_velocity is None else jnp.asarray(angular_velocity, dtype=float)
        if momentum is not None:
            starts = zip(self.mounts, values, strict=True)
            inside = sum(mount.momentum(mount.start(rate, jnp.zeros(3))) for mount, rate in starts)
            velocity = solve(self._locked_inertia(), jnp.asarray(momentum, dtype=float) - inside)
        own = [mount.start(rate, velocity) for mount, rate in zip(self.mounts, values, strict=True)]
        total = times(self.carrier, velocity)
        for mount, part in zip(self.mounts, own, strict=True):
            total = total + mount.momentum(part)
        front = [] if attitude is None else [rotation.normalize(jnp.asarray(attitude, dtype=float))]
        if self.structure is not None:
            front = [self.structure.turn.attitude(x) for x in front]
        parts = [*front, self._along_principal(total), *own, *acting]
        shape = np.broadcast_shapes(*(part.shape[:-1] for part in parts))
        return jnp.concatenate([jnp.broadcast_to(part, (*shape, part.shape[-1])) for part in parts], axis=-1)

    def _checked_rates(self, rates: Sequence[Array | None] | None) -> list[Array]:
        per_mount = _one_each("rates", rates, "mounts", len(self.mounts))
        for k, (mount, rate) in enumerate(zip(self.mounts, per_mount, strict=True)):
            if rate is not None and not mount.state_size:
                raise InvalidInput(
                    f"`rates[{k}]` is for a {type(mount).__name__}, which has no rate of its own to start with; "
                    f"got {shown(rate)}. Give None for it."
                )
        return [jnp.zeros(()) if rate is None else jnp.asarray(rate, dtype=float) for rate in per_mount]

    def _checked_actuators(self, actuators: Sequence[Array | None] | None) -> list[Array]:
        per_torque = _one_each("actuators", actuators, "torques", len(self.torques))
        own = []
        for k, (torque, part) in enumerate(zip(self.torques, per_torque, strict=True)):
            own.append(jnp.zeros(torque.state_size) if part is None else jnp.asarray(part, dtype=float))
            if own[-1].shape[-1:] != (torque.state_size,):
                raise InvalidInput(
                    f"`actuators[{k}]` must have shape (…, {torque.state_size}), the own state of a "
                    f"{type(torque).__name__}; got {own[-1].shape}."
                )
        return own

    def _locked_inertia(self) -> Array:
        turning, carrier = [x for mount in self.mounts if (x := mount.inertia) is not None], self.carrier
        return (jnp.diag(carrier) if carrier.ndim == 1 else carrier) + sum(turning) if turning else carrier

    def parts(self, state: Real[ArrayLike, "..."]) -> BodyState:
        """Take a packed state apart, along the principal axes.

        Raises:
            InvalidInput: for a wrong last axis.
        """
        refuse_single_precision(state=state)
        sizes = [attachment.state_size for attachment in chain(self.mounts, self.torques)]
        shape, bare = jnp.shape(state), 3 + sum(sizes)
        carries = shape[-1:] == (4 + bare,)
        if not (carries or (shape[-1:] == (bare,) and not self.needs_attitude)):
            shorter = "" if self.needs_attitude else f"(…, {bare}), or "
            raise InvalidInput(
                f"`state` of {type(self).__name__} must have shape {shorter}(…, {4 + bare}) with the attitude in "
                f"front; got {shape}. Make it by `state(attitude, angular_velocity)`."
            )
        ends = np.cumsum([4] * carries + [3, *sizes]).tolist()
        split = [state[..., start:end] for start, end in zip([0, *ends[:-1]], ends, strict=True)]
        attitude = split.pop(0) if carries else None
        momentum, *own = split
        return BodyState(attitude, momentum, tuple(own[: len(self.mounts)]), tuple(own[len(self.mounts) :]))

    @known_numbers_only
    def check_state(self, state: Real[ArrayLike, "*shape"]) -> Float64[Array, "*shape"]:
        """Return states as an array.

        Raises:
            InvalidInput: for wrong shapes, values that are not finite, an attitude that is not a unit quaternion.
        """
        state = as_finite_state(state, float)
        return state if self.parts(state).attitude is None else check_unit_attitude(state)

    def layout(self, state: Float64[Array, "*batch n"]) -> StateLayout:
        front = () if self.parts(state).attitude is None else (ATTITUDE,)
        return StateLayout((*front, MOMENTUM, *self.own_parts))


def _one_each(name: str, values: Any, things: str, count: int) -> list[Array | None]:
    if values is None:
        return [None] * count
    if not isinstance(values, Sequence | np.ndarray) or len(values) != count:
        raise InvalidInput(
            f"`{name}` must be a list with one entry for each of the {count} {things}, None where there is nothing to "
            f"say; got {shown(values)}."
        )
    refuse_single_precision(**{f"{name}[{k}]": value for k, value in enumerate(values)})
    return list(values)
