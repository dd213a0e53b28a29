"""Base classes of systems; the Lie–Poisson equations of motion are written here once."""

from __future__ import annotations

import abc
from collections.abc import Callable
from typing import Any, ClassVar, NamedTuple

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from polhode import rotation
from polhode._base.arrays import known_numbers_only, namespace, require_doubles
from polhode._base.kept import kept_of_object
from polhode.algebra._functions import Function
from polhode.algebra._joint_functions import evaluate_jointly
from polhode.algebra._rotations import check_rotations, parts_of_point, turns_alone
from polhode.algebra.base import AbstractLieAlgebra, HashableModule
from polhode.errors import InvalidInput
from polhode.motion._layout import (
    ATTITUDE,
    ENERGY,
    LINEAR,
    MOMENTUM,
    MOMENTUM_SPACE,
    MOMENTUM_SQUARED,
    Quantity,
    StateLayout,
)
from polhode.systems._checks import as_finite_state, check_on_dual, check_unit_attitude
from polhode.systems.steady_motion import SteadyMotion
from polhode.types import Array, ArrayLike, Double, Float64, Integer, Real

Components = tuple[Double[Array, "*shape"], ...]
Flow = Callable[[Float64[Array, ""], Components], Components]
Event = Callable[[Float64[Array, ""], Double[Array, "..."]], Float64[Array, ""]]


class Parts(NamedTuple):
    """A packed state taken apart: attitude (…, 4) or None, and the point of the dual."""

    attitude: Float64[Array, "*batch 4"] | None
    point: Double[Array, "..."]


class Vectors(NamedTuple):
    """Attitude, momentum and velocity of a body's states, for pictures and files; None where meaningless.

    Attributes:
        attitude: (…, 4) unit quaternions wxyz, body → space.
        momentum: (…, 3) angular momentum [kg m²/s, body axes].
        angular_velocity: (…, 3) [rad/s, body axes].
    """

    attitude: Float64[Array, "*batch 4"] | None = None
    momentum: Float64[Array, "*batch 3"] | None = None
    angular_velocity: Float64[Array, "*batch 3"] | None = None


class Kick(NamedTuple):
    """The flow of a V that depends on position alone, beside one flow of a T of second degree in the momentum.

    {V, {V, {V, T}}} = 0 then leaves fewer conditions of order, and ``Splitting`` takes methods made for that.
    """

    flow: Callable[[Array, Components], Components]

    def __call__(self, time: Array, state: Components) -> Components:
        return self.flow(time, state)


class Round(NamedTuple):
    """One of many flows that are one function of their number, as the rounds in which vortices meet.

    ``Splitting`` then compiles the function once and loops over the numbers; all flows of a system must be rounds of
    the same function then.

    Attributes:
        flow: of number, time and components.
        number: from 0, in the order of the system's flows.
    """

    flow: Callable[[Integer[Array, ""], Array, Components], Components]
    number: int

    def __call__(self, time: Array, state: Components) -> Components:
        return self.flow(jnp.asarray(self.number), time, state)


class Balance(NamedTuple):
    """A quantity that is not conserved, but whose rate of change is known independently of its value.

    Attributes:
        value: (…).
        rate: (…) per second, such as minus the power of friction for the energy.
    """

    value: Float64[Array, "*batch"]
    rate: Float64[Array, "*batch"]


class AbstractSystem(HashableModule):
    """A dynamical system: a state with its rate of change, and conserved quantities.

    Attributes:
        title: its name.
        kind: the kind of spec whose pictures show it, by its name; empty for none.
        has_vertical: whether space has an upward direction, as under gravity.
        count_of_changes: how many small changes of its first part a state carries, which jump where rates do.
    """

    title: ClassVar[str] = "Motion"
    kind: ClassVar[str] = ""
    has_vertical: ClassVar[bool] = False
    count_of_changes = 0

    @abc.abstractmethod
    def vector_field(self, t: Real[ArrayLike, "..."], state: Double[Array, "*shape"]) -> Double[Array, "*shape"]:
        """Return the state's rate of change, batched."""

    @abc.abstractmethod
    def invariants(self, state: Double[Array, "..."]) -> dict[str, Float64[Array, "..."]]:
        """Return the conserved quantities at states, by name."""

    def balances(self, t: Real[ArrayLike, "..."], state: Double[Array, "..."]) -> dict[str, Balance]:
        """Return the quantities whose rate is known, by name; empty where all that is known is conserved.

        ``simulate`` integrates the rates together with the motion and reports by how much the values miss the sum.
        """
        return {}

    def balance_values(
        self, t: Real[ArrayLike, "..."], state: Double[Array, "..."]
    ) -> dict[str, Float64[Array, "..."]]:
        """Return the values of ``balances``; a system whose rates take long to trace may override it."""
        return {name: balance.value for name, balance in self.balances(t, state).items()}

    @property
    def series_of_arrays(self) -> bool:
        """Whether Taylor series of whole arrays move it by default."""
        return False

    @property
    def events(self) -> dict[str, Event]:
        """Events that end the motion, by name: functions of t and one state, positive until their zero."""
        return {}

    @property
    def jumps(self) -> Float64[Array, "jumps"]:
        """(J,) times [s] at which rates of change jump, as where a torque starts or ends; none by default.

        Steps end at them, and no stage of a step looks beyond them. ``simulate`` finds others by trying times, but none
        between which less time passes than between its trials.
        """
        return np.zeros(0)  # of NumPy, as JAX makes an operation of it each time

    @property
    def names_all_jumps(self) -> bool:
        """Whether ``jumps`` are all there are, so that ``simulate`` need not look for more."""
        return False

    def layout(self, state: Double[Array, "..."]) -> StateLayout:
        """Return the layout of packed states like this one."""
        return StateLayout()

    @property
    def free_moments(self) -> Float64[Array, "3"] | None:
        """(3,) principal moments of a body without torques; None for any other system."""
        return None

    @property
    def given_axes(self) -> Float64[Array, "3 3"] | None:
        """(3, 3) principal axes by columns in the body's given ones; None where no others are known."""
        return None

    @property
    def quantities(self) -> dict[str, Quantity]:
        """Unit and meaning of invariants and balances, by name; those that are left out have no unit that is known."""
        return {"energy": ENERGY}

    @property
    def state_axes(self) -> int:
        """How many of a state's last axes are its own."""
        return 1

    @known_numbers_only
    def check_state(self, state: Real[ArrayLike, "*shape"]) -> Double[Array, "*shape"]:
        """Return states to start from as an array.

        Raises:
            InvalidInput: where no motion can start from them.
        """
        return as_finite_state(state, float)

    def scales(self, state: Double[Array, "..."]) -> Float64[Array, "..."]:
        """Return the sizes of the components, to which adaptive steps hold their absolute tolerance.

        An infinite size means none of its own, as for a tangent: its error counts relative to itself.
        """
        largest = jnp.max(jnp.abs(state), initial=0.0)
        return jnp.where(largest > 0, largest, 1.0)

    def invariant_sizes(self, state: Double[Array, "..."]) -> dict[str, Float64[Array, "..."]]:
        """Return sizes of invariants where Σ |x ∂C/∂x| does not give them, as of squares that begin at zero."""
        return {}

    def vectors(self, state: Double[Array, "..."]) -> Vectors:
        """Return attitude, angular momentum and angular velocity at states."""
        return Vectors()

    def steady_motion(self, state: Real[ArrayLike, "..."]) -> SteadyMotion | None:
        """Return what decides on the stability of a motion that is steady at one state.

        None, as by default, where ``stability`` finds it by itself, which it does for Lie–Poisson systems alone.

        Raises:
            InvalidInput: for a state whose motion is not steady.
        """
        return None


class AbstractLiePoissonSystem(AbstractSystem):
    """μ̇ = −sign · ad*_{dH} μ on the dual of ``algebra``.

    A state is a point of the dual (…, *element_shape); where the algebra turns a body, on so(3), se(3) and others that
    say which of their components are ``rotations``, it may have the attitude in front, a unit quaternion wxyz, body →
    space, which then moves with them: dR/dt = R hat(Ω), Ω = dH along these components.
    """

    algebra: eqx.AbstractVar[AbstractLieAlgebra]

    def __check_init__(self) -> None:
        algebra = self.algebra
        if algebra.rotations and not algebra.body_parts:  # an own class may say anything
            check_rotations(algebra.structure_constants(), algebra.rotations)

    @property
    def sign(self) -> int:
        """−1 for left-invariant systems (bodies), +1 for right-invariant ones (fluids)."""
        return -1

    @abc.abstractmethod
    def energy(self, point: Double[Array, "..."]) -> Float64[Array, "..."]:
        """Return H (…) at points of the dual."""

    def velocity(self, point: Real[ArrayLike, "*shape"]) -> Double[Array, "*shape"]:
        """Return dH, an element of the algebra, at points of the dual."""
        algebra = self.algebra
        total = jax.grad(lambda mu: jnp.sum(self.energy(mu)))  # batch axes do not mix, so one gradient serves all
        return algebra.from_gradient(total(jnp.asarray(point, dtype=algebra.dtype)))

    def generator(self, t: Real[ArrayLike, "..."], point: Double[Array, "..."]) -> Double[Array, "..."]:
        """Return ξ with μ̇ = ad*_ξ μ, batched in the point; override it for what depends on time or loses energy."""
        return -self.sign * self.velocity(point)

    @property
    def conserves_energy(self) -> bool:
        """Whether ``generator`` is that of H alone; where it is not, the energy is among ``balances``."""
        return True

    @property
    def flows(self) -> dict[str, Flow]:
        """Exact flows of parts of H, named; empty where none are known.

        A flow takes a time and the state's components along its last axis, and gives their changes. Components instead
        of one array, because XLA on CPU runs scalars of one loop body as one piece of code.
        """
        return {}

    @property
    def extra_invariants(self) -> dict[str, Function]:
        """Conserved functions of the point beside energy and Casimirs; ``JointFunction`` where they share steps."""
        return {}

    def vector_field(self, t: Real[ArrayLike, "..."], state: Double[Array, "*shape"]) -> Double[Array, "*shape"]:
        """Return the state's rate of change as ``generator`` gives it; orbit methods refuse an override of it."""
        attitude, point = self.parts(state)
        generator = self.generator(t, point)
        # μ̇ = ad*_ξ μ, and Ṙ = R hat(ξ) by the same generator, so that R L stays in space
        flow = self.algebra.coadjoint(generator, point)
        if attitude is None:
            return flow
        turning = rotation.quaternion_rate(attitude, self.algebra.of_rotations(generator))
        return jnp.concatenate([turning, flow], axis=-1)

    def invariants(self, state: Double[Array, "..."]) -> dict[str, Float64[Array, "..."]]:
        """Return energy, Casimirs, what else is conserved and, with an attitude, the momentum in space.

        A Casimir that every copy in a ``Power`` has is one entry (…, count).
        """
        attitude, point = self.parts(state)
        values = {"energy": self.energy(point)} if self.conserves_energy else {}
        values |= self.algebra.named_casimirs(point)
        values |= evaluate_jointly(self.extra_invariants, point)
        if attitude is not None:
            values |= self.space_vectors(attitude, point)
        return values

    def space_vectors(
        self, attitude: Float64[Array, "*batch 4"], point: Float64[Array, "*batch n"]
    ) -> dict[str, Float64[Array, "*batch 3"]]:
        """Return the vectors that stay fixed in space, by name."""
        if LINEAR in self.algebra.body_parts:
            return {"linear_space": rotation.rotate(attitude, point[..., 3:])}
        if self.algebra.body_parts or turns_alone(self.algebra.structure_constants(), self.algebra.rotations):
            return {"momentum_space": rotation.rotate(attitude, self.algebra.of_rotations(point))}
        return {}

    def vectors(self, state: Double[Array, "..."]) -> Vectors:
        if not self.carries_attitude:
            return Vectors()
        attitude, point = self.parts(state)
        turning = self.algebra.of_rotations
        return Vectors(attitude, turning(point), turning(self.velocity(point)))

    def scales(self, state: Double[Array, "..."]) -> Float64[Array, "..."]:
        """Return one for the attitude, and for the point its size."""
        attitude, point = self.parts(state)
        largest = jnp.max(jnp.abs(point), initial=0.0)
        scale = jnp.where(largest > 0, largest, 1.0)
        return scale if attitude is None else jnp.concatenate([jnp.ones(4), jnp.full(point.shape[-1], scale)])

    # ------------------------------------------------------------------ packed states

    @property
    def state_axes(self) -> int:
        return len(self.algebra.element_shape)

    @property
    def quantities(self) -> dict[str, Quantity]:
        # of a body, whose states are its momentum in SI; what other algebras mean is their system's to say
        parts = self.algebra.body_parts
        of_body = {"energy": ENERGY} if parts else {}
        if parts == (MOMENTUM,):
            of_body |= {"|L|²": MOMENTUM_SQUARED, "momentum_space": MOMENTUM_SPACE}
        return of_body | {name: Quantity("", name, of_copies=True) for name in self.algebra.casimirs_of_copies}

    def layout(self, state: Double[Array, "..."]) -> StateLayout:
        """Return the attitude, where the state has it, and the point of the dual."""
        front = () if self.parts(state).attitude is None else (ATTITUDE,)
        own = self.algebra.element_shape
        if len(own) != 1:
            return StateLayout(axes=len(own))
        return StateLayout((*front, *(self.algebra.body_parts or parts_of_point(own[0], self.algebra.rotations))))

    @known_numbers_only
    def check_state(self, state: Real[ArrayLike, "*shape"]) -> Double[Array, "*shape"]:
        """Return states as an array of the algebra's kind.

        Raises:
            InvalidInput: for wrong shapes, values that are not finite, an attitude that is not a unit quaternion, and
                matrices that do not lie on the algebra's dual.
        """
        form = _form_of_points(self)
        state = as_finite_state(state, form.dtype)
        if form.packed is not None and state.shape[-1:] == form.packed:
            return check_unit_attitude(state)
        if state.shape[state.ndim - len(form.shape) :] != form.shape:
            self.parts(state)  # refuses it
        return check_on_dual(self.algebra, state) if form.has_rule else state

    @property
    def carries_attitude(self) -> bool:
        """Whether a state may have an attitude in front."""
        return bool(self.algebra.rotations) and self.sign == -1

    def parts(self, state: Real[ArrayLike, "..."]) -> Parts:
        """Take a packed state apart.

        Raises:
            InvalidInput: if its last axes are neither a point's nor, where there is one, attitude and point.
        """
        require_doubles(state=state)
        shape, own = jnp.shape(state), self.algebra.element_shape
        if self.carries_attitude and shape and shape[-1] == 4 + own[0]:
            return Parts(state[..., :4], state[..., 4:])
        if shape[len(shape) - len(own) :] != own:
            longer = f" or (…, {4 + own[0]}) with the attitude in front" if self.carries_attitude else ""
            raise InvalidInput(
                f"`state` of {type(self).__name__} must have shape (…, {', '.join(map(str, own))}){longer}; "
                f"got {shape}."
            )
        return Parts(None, state)


class _FormOfPoints(NamedTuple):
    """What points of a dual are: their shape and type, whether they obey a rule, and the last axis with an attitude."""

    shape: tuple[int, ...]
    dtype: Any
    has_rule: bool
    packed: tuple[int] | None


@kept_of_object
def _form_of_points(system: AbstractLiePoissonSystem) -> _FormOfPoints:
    algebra, own = system.algebra, system.algebra.element_shape
    packed = (4 + own[0],) if system.carries_attitude else None
    return _FormOfPoints(own, np.dtype(algebra.dtype), bool(algebra.element_rule), packed)


def components(state: Double[Array, "*shape n"]) -> Components:
    """Return the components of states along the last axis."""
    return tuple(state[..., k] for k in range(state.shape[-1]))


def join_state(attitude: Float64[Array, "... 4"] | None, point: Double[Array, "..."]) -> Double[Array, "..."]:
    """Return the packed state, or change of one, of attitude and point."""
    return point if attitude is None else namespace(attitude, point).concatenate([attitude, point], axis=-1)


def attitude_change(
    attitude: Float64[Array, "*#batch 4"] | None,
    sine: Float64[Array, "*#batch 3"],
    cosine_less_one: Float64[Array, "*#batch 1"],
) -> Float64[Array, "*batch 4"] | None:
    """Return q p − q for p = (1 + cosine_less_one, sine), without cancellation for small turns.

    Args:
        attitude: (…, 4) or None.
        sine: (…, 3), half the turn's axis times its sine.
        cosine_less_one: (…, 1).
    """
    if attitude is None:
        return None
    return rotation.multiply(attitude, jnp.concatenate([cosine_less_one, sine], axis=-1))
