"""A sampled motion: plain arrays with their meaning, units, invariants and drift."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any, Literal, cast

import numpy as np

from polhode._base import check
from polhode._base.arrays import namespace
from polhode.errors import InvalidInput, shown
from polhode.motion._axes import Turn, chosen_axes
from polhode.motion._layout import Quantity, StateLayout, StatePart
from polhode.motion._outcome import Ends, Outcome
from polhode.motion._plan import MotionPlan
from polhode.motion.exact import ExactMotion
from polhode.motion.frame import BodyFrame
from polhode.motion.plotting import Plotted
from polhode.types import Array, ArrayLike, ArrayOrFloat, Double, Float64, Integer, Real

if TYPE_CHECKING:
    from polhode.motion.base import AbstractMotion

NAMES = 17  # columns of the names of what there is, and more where one is longer
_SAMPLED = ("states", "attitude", "momentum", "angular_velocity")
_BY_NAME = ("invariants", "balances", "received", "observed")
_AS_VECTORS = ("attitude", "momentum", "angular_velocity")  # parts of states that a trajectory has under these names


@dataclass(frozen=True, eq=False, repr=False)
class Trajectory(Plotted):
    """Sampled motion of one body or system, or a batch of them; plain arrays, SI units.

    Attributes:
        times: (T,) [s].
        states: packed states (batch…, T, …), as ``layout`` says.
        layout: of a state's parts.
        attitude: (batch…, T, 4) unit quaternions wxyz, body → space; None where meaningless.
        momentum: (batch…, T, 3) [kg m²/s, body axes]; None where meaningless.
        angular_velocity: (batch…, T, 3) [rad/s, body axes]; None where meaningless.
        invariants: name → values along the motion, (batch…, T); (batch…, T, 3) of a vector; (batch…, T, count) of what
            each copy in a ``Power`` has, as ``quantities`` says.
        balances: name → quantities that change at a known rate, along the motion, (batch…, T).
        received: name → the integral of that rate from the first time, (batch…, T); dissipated energy is its negative.
        drift: name → largest deviation of that invariant from its first sample, or of that balance from its first
            sample and what it received since, relative to its size or that of its terms, (batch…); (batch…, count)
            of what each copy has.
        observed: name → what else a report follows along the motion, (batch…, T) or (batch…, T, count), as the rates
            of wheels.
        quantities: what invariants, balances and the observed are, by name; those without an entry have no unit that
            is known.
        outcome: how the motion came to its end.
        source: what made it: the exact motion, the system, or a ``Recording`` of a file with its labels.
        statistics: how many steps and iterations of implicit steps it took.
        error_estimate: estimated largest error of the states, relative to the size of attitude and momentum, (batch…);
            infinite where it is not known, None where it was not asked for or the motion is exact.
        frame: the body's principal axes in the given ones, and its mass properties; None where these are not known.
        axes: (3, 3) principal axes by columns in those that attitude, momentum and angular velocity are along; None
            where these are the principal axes themselves, or where no others are known. ``along`` turns to others.
        given_axes: (3, 3) principal axes by columns in the given ones, for samples without a frame; else None.
        memory: what is needed, with the last state, to continue the run bit for bit: the arrays that the method
            carries along, for ``simulate``; None unless asked for.
        plan: how the samples were computed, and why that way; None for samples from other programs' files.
        ends: how each copy of an integrated batch came to its end, and when; None otherwise.

    >>> import polhode as ph
    >>> motion = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5)).sample([0.0, 0.5, 1.0, 1.5])
    >>> len(motion), len(motion.between(0.5, 1.0)), motion.part("momentum").shape
    (4, 2, (4, 3))
    """

    times: Float64[Array, "time"]
    states: Double[Array, "..."]
    layout: StateLayout = field(default_factory=StateLayout)
    attitude: Float64[Array, "*batch time 4"] | None = None
    momentum: Float64[Array, "*batch time 3"] | None = None
    angular_velocity: Float64[Array, "*batch time 3"] | None = None
    invariants: dict[str, Float64[Array, "..."]] = field(default_factory=dict)
    balances: dict[str, Float64[Array, "*batch time"]] = field(default_factory=dict)
    received: dict[str, Float64[Array, "*batch time"]] = field(default_factory=dict)
    drift: dict[str, Float64[ArrayOrFloat, "..."]] = field(default_factory=dict)
    observed: dict[str, Float64[Array, "..."]] = field(default_factory=dict)
    quantities: dict[str, Quantity] = field(default_factory=dict)
    outcome: Outcome = field(default_factory=Outcome)
    source: Any = None
    statistics: dict[str, int] = field(default_factory=dict)
    error_estimate: Float64[ArrayOrFloat, "*batch"] | None = None
    plan: MotionPlan | None = None
    ends: Ends | None = None
    memory: tuple[Array, ...] | None = None
    frame: BodyFrame | None = None
    axes: Float64[Array, "3 3"] | None = None
    given_axes: Float64[Array, "3 3"] | None = None

    def __len__(self) -> int:
        return len(self.times)

    @property
    def batch_shape(self) -> tuple[int, ...]:
        """The shape of the copies, () for one."""
        return tuple(np.shape(self.states)[: np.ndim(self.states) - 1 - self.layout.axes])

    @property
    def motion(self) -> AbstractMotion | None:
        """The exact motion of the samples, which gives the motion between them; None where there is none."""
        return cast("AbstractMotion", self.source) if isinstance(self.source, ExactMotion) else None

    def quantity(self, name: str) -> Quantity:
        """Return the unit and meaning of an invariant, a balance or what is observed; no unit where none is known.

        Raises:
            InvalidInput: for a name that the trajectory does not have.
        """
        if name not in (known := [*self.invariants, *self.balances, *self.observed]):
            raise InvalidInput(f"no quantity {shown(name)}; the trajectory has {', '.join(known) or 'none'}. "
                               "Choose one of these.")
        return self.quantities.get(name) or Quantity("", name.replace("_", " "))

    def part(self, name: str) -> Double[Array, "..."]:
        """Return a part of the states by name, (batch…, T) of one component, else (batch…, T, size).

        Raises:
            InvalidInput: for a part that the states do not have.
        """
        try:
            return self.layout.part(self.states, name)
        except KeyError as error:
            raise InvalidInput(f"{error.args[0]}. Choose one of these.") from None

    def further_parts(self) -> list[tuple[StatePart, Double[Array, "..."]]]:
        """Return what states have besides attitude, momentum and angular velocity, along the present axes.

        Empty for states whose components have no names, such as a point of a dual.
        """
        if self.layout.names in ((), ("point",)):
            return []
        back = None if self.axes is None or self.motion is not None else Turn.to(self.axes).back
        found = []
        for part in self.layout.parts:
            if part.name not in _AS_VECTORS:
                values = self.layout.part(self.states, part.name)
                if back is not None and part.frame == "body":  # a system's states stay along the principal axes
                    values = back.vector(values)
                found.append((part, values))
        return found

    def resample(self, times: ArrayLike) -> Trajectory:
        """Return the exact motion of the samples at other times [s], along the same axes.

        Raises:
            InvalidInput: where the samples are not of an exact motion.
        """
        if self.motion is None:
            raise InvalidInput("the samples are not of an exact motion, so that the motion between them is not known. "
                               "Integrate to the times that you need.")
        return replace(self.motion.sample(times), frame=self.frame)

    def along(self, axes: str | Real[ArrayLike, "3 3"]) -> Trajectory:
        """Return the same samples with attitude, momentum and angular velocity along other axes of the body.

        States of a system that was integrated stay as the system has them.

        Args:
            axes: "principal", "given", or axes by columns in the given ones. Where the body is not known, the present
                axes are both.

        Raises:
            InvalidInput: for axes that are none of these.

        >>> import polhode as ph
        >>> body = ph.shapes.box(1.0, (0.1, 0.2, 0.3))  # whose moments descend along x, y, z
        >>> samples = ph.FreeMotion.from_body(body, angular_velocity=(1.0, 0.0, 0.0)).sample([0.0, 1.0])
        >>> samples.angular_velocity[0].tolist(), samples.along("principal").angular_velocity[0].tolist()
        ([1.0, 0.0, 0.0], [0.0, 0.0, -1.0])
        """
        given_axes = self.given_axes if self.frame is None else np.asarray(self.frame.axes)
        given_axes = self.axes if given_axes is None else given_axes
        return self.turn_to(chosen_axes(axes, given_axes))

    def with_frame(self, frame: BodyFrame, along: Literal["given", "principal"] = "given") -> Trajectory:
        """Return the same samples as those of a body, which files of other programs do not say.

        Args:
            frame: of the body, ``Body.frame``; in place of the one that the samples have, if any.
            along: which of the body's axes the samples are along: "given", those in which its mesh, points or inertia
                are given, or "principal".

        Raises:
            InvalidInput: for other words, and for an exact motion along given axes, whose moments say these.

        >>> import numpy as np
        >>> import polhode as ph
        >>> turning = np.array([[0.0, 0.0, 2.0], [0.0, 0.0, 2.0]])
        >>> read = ph.Trajectory(np.array([0.0, 1.0]), turning, angular_velocity=turning)
        >>> box = ph.shapes.box(1.0, (0.1, 0.2, 0.3))  # whose moments descend along x, y, z
        >>> read.with_frame(box.frame).along("principal").angular_velocity[0].tolist()
        [2.0, 0.0, 0.0]
        """
        if along not in ("given", "principal"):
            raise InvalidInput(f'`along` must be "given" or "principal", the axes of the samples; got {shown(along)}.')
        if self.motion is not None and (along == "given" or self.axes is not None):
            remedy = "Make the motion by `from_body`." if self.axes is not None else (
                'Make it by `from_body`, or, if its moments are the body\'s, give along="principal".')
            raise InvalidInput(f"the samples are of an exact motion, whose body is known. {remedy}")
        samples = self if self.frame is None else self.along(along)
        return replace(samples, frame=frame, axes=np.asarray(frame.axes) if along == "given" else None, given_axes=None)

    def turn_to(self, axes: Float64[Array, "3 3"] | None) -> Trajectory:
        """Return the same samples along axes in which the columns of ``axes`` are the principal ones."""
        own = self.axes
        if own is axes or (axes is not None and own is not None and np.array_equal(axes, own)):
            return self
        if own is None:
            if axes is None:
                return self
            # samples stand along the principal axes, whose columns in the new ones are ``axes``
            turn = Turn.to(axes).back
        else:  # by the principal axes, as quaternions that went another way may have the other sign
            turn = Turn.to(own) if axes is None else Turn.to(own).then(Turn.to(axes).back)
        velocity, momentum = (None if x is None else turn.vector(x) for x in (self.angular_velocity, self.momentum))
        attitude = None if self.attitude is None else turn.attitude(self.attitude)
        turned = replace(self, attitude=attitude, momentum=momentum, angular_velocity=velocity, axes=axes)
        if self.motion is None or attitude is None or momentum is None:
            return turned
        states = namespace(attitude, momentum).concat([attitude, momentum], axis=-1)
        return replace(turned, states=states, source=self.motion._standing(axes))

    def between(self, start: float, end: float) -> Trajectory:
        """Return the samples from one time to another, both included [s]; drifts stay those of the whole motion.

        Raises:
            InvalidInput: where no sample lies between.
        """
        times = np.asarray(self.times)
        inside = (times >= min(start, end)) & (times <= max(start, end))
        if not inside.any():
            raise InvalidInput(
                f"no sample lies between {start:g} s and {end:g} s; they run from {times[0]:g} s to {times[-1]:g} s. "
                "Choose times within."
            )
        return self.select(np.flatnonzero(inside))

    def select(self, rows: Integer[Array, "rows"] | slice) -> Trajectory:
        """Return the samples of these indices along the time axis, in their order.

        Raises:
            InvalidInput: for a single index, or one that there is not.
        """
        if not isinstance(rows, slice):
            rows, count = np.asarray(rows), len(self.times)
            if rows.ndim != 1 or not np.all((rows == rows.astype(int)) & (rows >= -count) & (rows < count)):
                check.refuse("rows", f"a slice or a list of indices of the {count} samples", rows.tolist())
        axis = len(self.batch_shape)
        at = (slice(None),) * axis + (rows,)
        values: dict[str, Any] = {name: getattr(self, name) for name in _SAMPLED}
        cut = {name: None if value is None else np.asarray(value)[at] for name, value in values.items()}
        named = {name: {key: np.asarray(value)[at] for key, value in getattr(self, name).items()} for name in _BY_NAME}
        return replace(self, times=np.asarray(self.times)[rows], **cut, **named)

    def __repr__(self) -> str:
        lines = self._lines()
        width = max(NAMES, 2 + max(len(name) for name, _ in lines))
        return "\n".join(f"{name:<{width}}{words}" for name, words in lines)

    def _repr_html_(self) -> str:
        from html import escape

        rows = (f"<tr><th>{escape(name)}</th><td>{escape(words)}</td></tr>" for name, words in self._lines())
        return f"<table>{''.join(rows)}</table>"

    def _lines(self) -> list[tuple[str, str]]:
        """Return a description, one line for each part."""
        times, batch = np.asarray(self.times), self.batch_shape
        span = f", {times[0]:g} s to {times[-1]:g} s" if len(times) else ""
        origin = "" if self.source is None else f" of {type(self.source).__name__}"
        copies = f", batch of shape {batch}" if batch else ""
        lines = [("Trajectory", f"{len(times)} samples{span}{origin}{copies}")]
        parts = ", ".join(f"{part.name} ({part.size})" for part in self.layout.parts)
        own = np.shape(self.states)[np.ndim(self.states) - self.layout.axes :]
        lines.append(("states", parts or f"shape {own}"))
        for name in _SAMPLED[1:]:
            value = getattr(self, name)
            if value is not None and len(times) and not batch:
                first = ", ".join(f"{float(x):.6g}" for x in np.asarray(value)[0])
                lines.append((name.replace("_", " "), f"({first}) at first"))
        kept = self.invariants | self.balances
        for name in list(kept)[:6]:
            moved = self.drift.get(name)
            said = "" if moved is None else f"drift {float(np.max(moved)):.1e}"
            lines.append((name.replace("_", " "), said or "kept"))
        if len(kept) > 6:
            lines.append(("", f"and {len(kept) - 6} more"))
        if self.error_estimate is not None:
            lines.append(("state error", f"about {float(np.max(self.error_estimate)):.1e}"))
        if self.statistics:
            lines.append(("steps", ", ".join(f"{value} {key}" for key, value in self.statistics.items())))
        if self.plan is not None:
            lines.append(("plan", str(self.plan)))
        lines.append(("outcome", str(self.outcome)))
        return lines
