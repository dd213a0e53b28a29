"""Propellant that leaves a body: its mass, centre of mass and inertia change, and the jet takes momentum along."""

from __future__ import annotations

from collections.abc import Callable
from typing import ClassVar

import jax.numpy as jnp
import numpy as np

from polhode._base.arrays import is_traced, known_numbers_only
from polhode.bodies.body import Body
from polhode.errors import InvalidInput, shown
from polhode.motion._layout import StatePart
from polhode.motion.frame import BodyFrame
from polhode.spacecraft.systems.attachments import Argument, Attitude, Own, Time, Velocity, checked_jumps
from polhode.spacecraft.systems.mounts import AbstractMount
from polhode.systems._checks import checked_number, checked_vector
from polhode.types import Array, ArrayLike, Float64, Real, Self

Flow = Callable[[Float64[Array, "*batch"]], Float64[Array, "*batch"]]


class Propellant(AbstractMount):
    """Propellant in a tank, of which ṁ leaves through a nozzle: L̇ = L × Ω + (r − c) × (F − ṁ w), F = −ṁ u.

    With c the momentary centre of mass, the jet leaves at r with the velocity u against the body, and so with w + u
    about the centre of mass, w = Ω × (r − c). The part −ṁ w is the jet's damping. The contents of the tank turn with
    the body, and keep their shape while their density falls; the momentum of the flow inside against the body is
    neglected, and with it the motion of c in the body, ċ: the flow q = ṁ (r − p) from the tank at p has ċ × q of
    momentum a second more about the moving c, exactly as much as ċ takes from it at the nozzle. The energy of rotation
    changes by −ṁ (|w|² − ½ |w_t|² − ½ Ω·κΩ) and the power of F, with w_t the velocity at the tank and κ the inertia of
    a kilogram in it: half of |w|² leaves with the jet, and the rest brings the propellant from the tank to the nozzle.

    Its state is the remaining mass. The body's mass properties are those with the tank full.

    Args:
        position: (3,) of the tank's contents [m, body axes].
        mass: at the start [kg], positive.
        nozzle: r (3,) [m, body axes].
        flow: ṁ [kg/s]: a number, not negative, or a function of the time (…) [s], batched and written with
            ``jax.numpy``. A motion ends by the event "tank empty" where nothing is left.
        exhaust_velocity: u (3,) [m/s, body axes]; zero, the default, leaves the thrust to torques.
        at: when a flow of constant size begins [s]; by default it always flows.
        lasting: how long it flows [s], positive; given with ``at``.
        inertia: (3, 3) of the full tank's contents about their centre [kg m², body axes]; None for a point.
        jumps: (J,) times [s] at which a function of the time jumps.

    Raises:
        InvalidInput: for values out of range, a burn of more than the tank holds, a body without mass.

    Source: Thomson, *Introduction to Space Dynamics* (1986), §7.6–7.8; Eke, "Dynamics of Variable Mass Systems", NASA
    CR-1998-208246.

    >>> tank = Propellant((0.0, 0.0, 0.2), 5.0, (0.0, 0.0, -1.0), 0.05, at=10.0, lasting=20.0)
    >>> tank.jumps.tolist(), float(tank.outflow(15.0)), float(tank.outflow(31.0))
    ([10.0, 30.0], 0.05, 0.0)
    """

    name: ClassVar[str] = "propellant"
    arguments: ClassVar[dict[str, Argument]] = {
        "position": Argument("m", (3,)),
        "mass": Argument("kg"),
        "nozzle": Argument("m", (3,)),
        "flow": Argument("kg/s"),
        "exhaust_velocity": Argument("m/s", (3,)),
        "at": Argument("s"),
        "lasting": Argument("s"),
        "inertia": Argument("kg*m^2", (3, 3)),
    }

    place: Float64[Array, "3"]
    full: Float64[Array, ""]
    nozzle: Float64[Array, "3"]
    flow: Float64[Array, ""] | Flow
    exhaust_velocity: Float64[Array, "3"]
    window: Float64[Array, "2"] | None
    full_inertia: Float64[Array, "3 3"] | None
    jump_times: Float64[Array, "jumps"]

    @known_numbers_only
    def __init__(
        self, position: Real[ArrayLike, "3"], mass: float, nozzle: Real[ArrayLike, "3"], flow: float | Flow,
        exhaust_velocity: Real[ArrayLike, "3"] = (0.0, 0.0, 0.0), at: float | None = None, lasting: float | None = None,
        inertia: Real[ArrayLike, "3 3"] | None = None, jumps: Real[ArrayLike, "jumps"] = (),
    ) -> None:
        self.place, self.nozzle = checked_vector("position", position), checked_vector("nozzle", nozzle)
        self.full = checked_number("mass", mass, 0.0, unit="kg")
        self.flow = flow if callable(flow) else checked_number("flow", flow, least=0.0, unit="kg/s")
        self.exhaust_velocity = checked_vector("exhaust_velocity", exhaust_velocity)
        self.full_inertia = None if inertia is None else jnp.asarray(Body.from_inertia(inertia).inertia)
        if (at is None) != (lasting is None) or (at is not None and callable(flow)):
            raise InvalidInput("`at` and `lasting` go together, with a `flow` that is a number. Give both, or let the "
                               "function of the time be zero where nothing flows.")
        self.window = None
        if at is not None and lasting is not None and not callable(self.flow):
            begin = checked_number("at", at, unit="s")
            self.window = jnp.stack([begin, begin + checked_number("lasting", lasting, 0.0, unit="s")])
            if not float(self.flow) * lasting < float(self.full):
                raise InvalidInput(
                    f"`flow` times `lasting` must be less than the mass in the tank, {float(self.full):g} kg; got "
                    f"{float(self.flow) * lasting:g} kg. Check {shown(flow)} kg/s and {shown(lasting)} s."
                )
        self.jump_times = checked_jumps(jumps)

    @property
    def inertia_per_mass(self) -> Float64[Array, "3 3"] | None:
        """Inertia of the tank's contents about their centre, over their mass [m²]."""
        return None if self.full_inertia is None else self.full_inertia / self.full

    def bound(self, frame: BodyFrame) -> Self:
        if frame.mass is None:
            raise InvalidInput("a Propellant changes the mass, and so needs that of the whole body. Give the body its "
                               "`mass` beside the moments; in Python that is of the `Body` for "
                               "`RigidBody.from_body`.")
        if not float(self.full) < frame.mass:
            raise InvalidInput(f"the propellant, {float(self.full):g} kg, must be part of the body, whose `mass` is "
                               f"{frame.mass:g} kg. Give the mass of all together.")
        return self

    @property
    def jumps(self) -> Float64[Array, "jumps"]:
        return self.jump_times if self.window is None else jnp.concatenate([self.jump_times, self.window])

    @property
    def names_all_jumps(self) -> bool:
        return not callable(self.flow)

    @property
    def state_parts(self) -> tuple[StatePart, ...]:
        return (StatePart("propellant_mass", 1, "kg", "mass of propellant that is left"),)

    @property
    def conserves_energy(self) -> bool:
        return False

    @property
    def may_run_empty(self) -> bool:
        """Whether it flows until nothing is left."""
        return self.window is None

    def momentum(self, own: Float64[Array, "*batch {self.state_size}"]) -> Float64[Array, "*batch 3"]:
        return jnp.zeros((*own.shape[:-1], 3))

    def outflow(self, t: Real[ArrayLike, "*batch"]) -> Float64[Array, "*batch"]:
        """Return ṁ (…) [kg/s], positive outwards."""
        t = jnp.asarray(t, dtype=float)
        if callable(self.flow):
            return self.flow(t)
        if self.window is None:
            return jnp.broadcast_to(self.flow, t.shape)
        return jnp.where((t >= self.window[0]) & (t < self.window[1]), self.flow, 0.0)

    def state_rate(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Own
    ) -> Float64[Array, "*batch {self.state_size}"]:
        return jnp.broadcast_to(-self.outflow(t)[..., None], own.shape)

    def start(
        self, rate: Real[ArrayLike, "..."], angular_velocity: Float64[Array, "*batch 3"]
    ) -> Float64[Array, "... {self.state_size}"]:
        if is_traced(rate) or np.ndim(rate) or rate != 0.0:  # a traced one is not known to be zero
            raise InvalidInput(f"`rates` has {shown(rate)} for a Propellant, which does not turn. Give None for it.")
        return jnp.broadcast_to(self.full, (*angular_velocity.shape[:-1], 1))
