"""Base classes of attachments of a rigid body: mounts inside it and torques on it, with states of their own."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable
from typing import Any, ClassVar, NamedTuple

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from polhode._base import check
from polhode._base.arrays import in_jax_numpy, is_traced, require_doubles
from polhode._base.arrays.traced_checks import check_traced
from polhode.errors import InvalidInput, PolhodeError, shown
from polhode.motion._layout import StateLayout, StatePart
from polhode.motion.frame import BodyFrame
from polhode.types import Array, ArrayLike, Float64, Real, Self

# arguments of the methods of attachments
Time = Real[ArrayLike, "*#batch"]
Attitude = Float64[Array, "*#batch 4"] | None
Velocity = Float64[Array, "*#batch 3"]
Own = Float64[Array, "*#batch {self.state_size}"]
_right: dict[Hashable, None] = {}


class Argument(NamedTuple):
    """How a spec gives an argument of the constructor of a torque, mount or control law.

    Attributes:
        unit: in SI, as Pint reads it; "" for plain numbers, "text" for one of the ``choices``, "attitude" for one in
            any of the forms that [spin] takes.
        shape: () of one number, (3,) of three, (3, 3) of three rows.
        many: whether it is a list of such, or one of them.
        choices: of a text.
    """

    unit: str = ""
    shape: tuple[int, ...] = ()
    many: bool = False
    choices: tuple[str, ...] = ()


class AbstractAttachment(eqx.Module):
    """A mount or a torque.

    Its methods are batched and written with ``jax.numpy``. They take the time t [s], () or one for each state (…), with
    vectors ``t[..., None]``; the attitude (…, 4), a unit quaternion wxyz, body → space, None where the state carries
    none; Ω (…, 3) [rad/s, body axes]; and its own state (…, n), whose last axis has all its parts in order. Body axes
    are the axes in which the body is given, those of ``RigidBody.from_body``; positions count from their origin.

    Attributes:
        name: as a spec gives it; empty for what only Python makes. Of another package it is its entry point's.
        arguments: how a spec gives the arguments of ``from_table``. Others it takes from other tables of
            the spec, by their names: ``orbit``, a ``KeplerOrbit``, and ``field``, an ``EarthDipoleField``.
        start_arguments: further keys of a mount in a spec, for ``start_of``.
    """

    name: ClassVar[str] = ""
    arguments: ClassVar[dict[str, Argument]] = {}
    start_arguments: ClassVar[dict[str, Argument]] = {}

    @classmethod
    def from_table(cls, *given: Any, **values: Any) -> Self:
        """Return the attachment of a table of a spec; by default its arguments are those of the constructor."""
        return cls(*given, **values)

    def bound(self, frame: BodyFrame) -> Self:
        """Return this bound to a body, with values of the body filled in; itself by default.

        Args:
            frame: the axes of the body, and the mass properties along them with all mounts locked.

        Raises:
            InvalidInput: where it does not fit the body.
        """
        return self

    @property
    def state_parts(self) -> tuple[StatePart, ...]:
        """The parts of its own state; none by default."""
        return ()

    @property
    def state_size(self) -> int:
        """The number n of components of its own state."""
        return sum(part.size for part in self.state_parts)

    def part(self, own: Float64[Array, "*batch n"], name: str) -> Float64[Array, "..."]:
        """Return a part of its own state (…, n) by name: (…) of one component, else (…, size)."""
        return StateLayout(self.state_parts).part(own, name)

    @property
    def jumps(self) -> Float64[Array, "jumps"]:
        """(J,) times [s] at which it starts, ends or jumps; steps end there. None by default."""
        return np.zeros(0)

    @property
    def names_all_jumps(self) -> bool:
        """Whether ``jumps`` are all there are, so that none are searched for; not of a user's function."""
        return False

    @property
    def limited(self) -> bool:
        """Whether it has limits, beyond which it does not deliver the commanded value."""
        return False

    def without_limits(self) -> Self:
        """Return this without limits; itself if it has none."""
        return self

    def load(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Own, stored: Velocity
    ) -> Float64[Array, "*batch"]:
        """Return the largest demand over its limit (…); above one a limit acts. Zero without limits.

        Args:
            t, attitude, angular_velocity, own: as everywhere.
            stored: the momentum inside, L − IΩ (…, 3) [kg m²/s, body axes].
        """
        return jnp.zeros(angular_velocity.shape[:-1])

    @property
    def needs_attitude(self) -> bool:
        """Whether it depends on the attitude; then states must carry it."""
        return False


def checked_jumps(jumps: Real[ArrayLike, "jumps"]) -> Float64[Array, "jumps"]:
    """Return times [s] of jumps as an array (J,).

    Raises:
        InvalidInput: for anything but a list of finite numbers.
    """
    require_doubles(jumps=jumps)
    try:
        times = jnp.asarray(jumps, dtype=float)
    except (TypeError, ValueError):
        times = jnp.zeros(())
    if times.ndim != 1 or not (is_traced(times) or np.isfinite(np.asarray(times)).all()):
        raise InvalidInput(f"`jumps` must be a list of finite times (J,) [s]; got {shown(jumps)}.")
    return times


def checked_attachments(
    name: str, value: Any, kinds: tuple[type[AbstractAttachment], ...], frame: BodyFrame, trial: Callable[..., Any]
) -> tuple[Any, ...]:
    """Return a list of attachments.

    Args:
        name: of the argument.
        value: the user's argument.
        kinds: the classes of which each is derived from one.
        frame: of the body.
        trial: evaluates all methods of an attachment at (attachment, t, attitude, angular_velocity, own), and returns
            the values by the name of the method, each with its shape behind the batch axes, (value, shape).

    Raises:
        InvalidInput: for anything but a list of them, and for one whose methods fail or give wrong shapes.
    """
    copies = 5  # of the trial; no vector has as many components
    remembered = 512  # forms of attachments whose methods have the right shapes
    if not isinstance(value, Iterable):
        raise InvalidInput(f"`{name}` must be a list; got {shown(value)}. Put it in brackets.")
    attachments = []
    for k, attachment in enumerate(value):
        if not isinstance(attachment, kinds):
            check.refuse(name, f"a list of polhode.systems.{name}", attachment,
                         f"Derive your own from {' or '.join(kind.__name__ for kind in kinds)}.")
        attachments.append(attachment.bound(frame))
        form = _form(attachments[-1], trial)
        if form is None or form not in _right:
            for batch in ((), (copies,)):
                _check_shapes(f"{name}[{k}]", attachments[-1], trial, batch)
            if form is not None:
                if len(_right) >= remembered:
                    _right.clear()
                _right[form] = None
    return tuple(attachments)


def _form(attachment: AbstractAttachment, trial: Callable[..., Any]) -> Hashable | None:
    """Return a key that attachments share which differ by their numbers alone; None where it cannot be compared.

    Shapes do not depend on numbers, and each body of a sweep would take a tenth of a second to trace its methods.
    """
    leaves, tree = jax.tree.flatten(attachment)
    form = type(attachment), trial, tree, tuple(map(_without_numbers, leaves))
    try:
        hash(form)
    except TypeError:
        return None
    return form


def _without_numbers(leaf: Any) -> Hashable:
    if not eqx.is_array(leaf):
        return type(leaf), leaf  # a function, or what it may branch on
    return leaf.shape, str(leaf.dtype), b"" if eqx.is_inexact_array(leaf) else np.asarray(leaf).tobytes()


def _check_shapes(name: str, attachment: AbstractAttachment, trial: Any, batch: tuple[int, ...]) -> None:
    kind = type(attachment).__name__
    wanted: dict[str, tuple[int, ...]] = {}

    def values(*arguments: Array) -> dict[str, Array]:
        results = trial(attachment, *arguments)
        wanted.update({method: (*batch, *shape) for method, (_, shape) in results.items()})
        return {method: jnp.asarray(value) for method, (value, _) in results.items()}

    zeros = lambda *shape: jax.ShapeDtypeStruct((*batch, *shape), float)  # noqa: E731
    attitude = zeros(4) if attachment.needs_attitude else None
    arguments = zeros(), attitude, zeros(3), zeros(attachment.state_size)
    try:
        with in_jax_numpy(f"the methods of {kind}"):
            traced, got = jax.make_jaxpr(values, return_shape=True)(*arguments)
            check_traced(f"a method of `{name}`, a {kind},", traced)
    except PolhodeError:
        raise
    except Exception as error:
        raise InvalidInput(
            f"`{name}`, a {kind}, cannot be evaluated with the time of shape {batch}, the attitude "
            f"{None if attitude is None else attitude.shape}, the angular velocity {arguments[2].shape} and its own "
            f"state {arguments[3].shape}: {error}. Write its methods for any batch axes, and let `needs_attitude` be "
            "True where they use the attitude."
        ) from error
    for method, value in got.items():
        if value.shape != wanted[method]:
            raise InvalidInput(
                f"`{name}`, a {kind}, must give `{method}` of shape {wanted[method]} for states of batch shape "
                f"{batch}; got {value.shape}."
            )
