"""``polhode.certify``: proved enclosures of any motion, in closed form or of a system's equations."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, overload

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.analysis._exact_arithmetic import check_digits, import_flint
from polhode.errors import InvalidInput, shown
from polhode.exact.free_body import FreeMotion
from polhode.exact.lagrange_top import LagrangeMotion
from polhode.motion.base import AbstractMotion
from polhode.proving.enclosures._motion_starts import MotionStart, exact_start
from polhode.proving.enclosures.motion_enclosures import FreeEnclosure, MotionEnclosure, TopEnclosure
from polhode.types import ArrayLike, Real

if TYPE_CHECKING:
    from polhode.proving.enclosures.enclosure import Enclosure
    from polhode.systems.base import AbstractSystem


def _enclose_free(start: MotionStart, digits: int) -> MotionEnclosure:
    from polhode.proving.enclosures._free_body_balls import enclose_free_motion

    return enclose_free_motion(start, digits)


def _enclose_top(start: MotionStart, digits: int) -> MotionEnclosure:
    from polhode.proving.enclosures._lagrange_top_balls import enclose_top_motion

    return enclose_top_motion(start, digits)


IN_CLOSED_FORM: dict[type, Callable[[MotionStart, int], MotionEnclosure]] = {
    FreeMotion: _enclose_free, LagrangeMotion: _enclose_top,
}  # fmt: skip


@overload
def certify(
    system: FreeMotion, *, digits: int | None = None, exact: Mapping[str, Any] | None = None
) -> FreeEnclosure: ...
@overload
def certify(
    system: LagrangeMotion, *, digits: int | None = None, exact: Mapping[str, Any] | None = None
) -> TopEnclosure: ...
@overload
def certify(
    system: AbstractMotion, *, digits: int | None = None, exact: Mapping[str, Any] | None = None
) -> MotionEnclosure: ...
@overload
def certify(
    system: AbstractSystem, state: Real[ArrayLike, "..."], times: Real[ArrayLike, "time"], radius: float | None = None,
    other: AbstractSystem | None = None, state_radii: Real[ArrayLike, "..."] | None = None,
) -> Enclosure: ...
@known_numbers_only
def certify(
    system: Any, state: Any = None, times: Any = None, radius: float | None = None, other: Any = None,
    state_radii: Any = None, *, digits: int | None = None, exact: Mapping[str, Any] | None = None,
) -> Any:
    """Return proved enclosures of a motion from an exact start: no rounding, truncation or growth is left out.

    **A motion in closed form** (``FreeMotion``, ``LagrangeMotion``): ``certify(motion, digits=25)``. Its numbers are
    taken as exact, its regime is decided in rational arithmetic, and period, precession, geometric phase, action and
    the state at any time are balls of elliptic functions with as many digits as are asked for, in about a millisecond.
    ``exact`` has numbers that doubles only approximate, such as the decimals that they were read from.

    **A system**: ``certify(system, state, times)``. Each step is a Taylor series in ball arithmetic. The remainder is
    bounded by Cauchy's estimate, from a disc of complex times over which the motion is proved to stay in a box. The
    growth of roundings is bounded by a logarithmic norm of the rates' derivative over the box. As that bound grows
    exponentially, for chaotic motions and for others, the arithmetic has so many more digits: the work grows as the
    square of the time and more. Numbers that are only given within limits are enclosed too: with a second system all
    systems whose numbers lie between both, each number by itself, and with radii all starts that far from the state.
    Their effect is bounded by that norm, so that the enclosure is several times wider than the true spread, and more
    so over long times.

    Args:
        system: one motion in closed form; or a system, whose rates must be made of products, powers and
            elementary functions.
        state: of a system: one, packed as ``simulate`` takes it: the doubles are taken as exact numbers.
        times: of a system: (T,) [s], in one direction; the first is the start's.
        radius: of a system: the wanted one, relative to the largest number of the start, 1e-15 if left out; the
            rounding of the states to doubles is added, and the effect of numbers within limits.
        other: a system of the same form, with other real numbers in its fields.
        state_radii: of the state's shape or one number: by how much the start may be off; of complex states, each of
            real and imaginary part.
        digits: of a motion: decimals of each enclosure, 25 if left out, at most 10000; of numbers relative to
            themselves, of attitudes to 1, of momenta to |L|.
        exact: of a motion: exact numbers by the names of its arguments (moments, momentum or angular_velocity,
            attitude, epoch, mgl), SI, along the principal axes: decimals in quotes, Fractions, whole numbers.

    Returns:
        An ``Enclosure`` of a system's states; a ``FreeEnclosure`` or ``TopEnclosure`` of a motion.

    Raises:
        InvalidInput: for a batch, for arguments of a system with a motion or the other way round, and for exact numbers
            that are not those of the motion. Of systems: for times out of order, jumps or events between the times,
            rates that have no Taylor series or branch on what moves, as absolute values do, another system of which
            more than real numbers differs, or numbers that the rates look at, as the eccentricity of an orbit.
        NotConverged: if the motion of a system runs into a singularity, or needs more digits than are reasonable.

    >>> import polhode as ph
    >>> motion = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 0.2, 1.0))
    >>> proved = ph.certify(motion, exact={"momentum": ("0.3", "0.2", "1")})
    >>> proved.regime, proved.period, proved.verdicts["axis 2"]
    ('short-axis', <20.20493473808199798897005 ± 1e-24>, 'unstable')
    >>> print(proved.state("1e9").momentum[0])
    -0.02645628433507978115750543 ± 4e-27
    >>> proof = ph.certify(ph.systems.FreeRigidBody((1.0, 2.0, 3.0)), [0.3, 0.2, 1.0], [0.0, 5.0])
    >>> bool(abs(proof.states[-1] - motion.momentum(5.0)).max() < 3e-15) and proof.exact
    True

    Source: of closed forms, DLMF §19 and §22 in the balls of Johansson, IEEE Trans. Comput. 66 (2017) 1281; of systems,
    Moore, *Methods and Applications of Interval Analysis*, ch. 8; Dahlquist's logarithmic norm, Hairer, Nørsett &
    Wanner, *Solving Ordinary Differential Equations I*, §I.10; Cauchy's estimate in a disc, as in the majorants of
    Warne et al., Math. Comput. 75 (2006) 1249.
    """
    enclose = IN_CLOSED_FORM.get(type(system))
    of_systems = {"state": state, "times": times, "radius": radius, "other": other, "state_radii": state_radii}
    of_motions = {"digits": digits, "exact": exact}
    if enclose is not None:
        _refuse(of_systems, f"a system's; a {type(system).__name__} has its own start, and `state(t)` of the result "
                            "takes any time")
        import_flint()
        digits = check_digits(25 if digits is None else digits)
        return enclose(exact_start(system, exact), digits)
    if isinstance(system, AbstractMotion):
        classes = ", ".join(kind.__name__ for kind in IN_CLOSED_FORM)
        raise InvalidInput(f"`system` must be a system, or a motion in closed form of a class that has enclosures, "
                           f"{classes}; got {shown(system)}.")
    _refuse(of_motions, "a motion's in closed form; of a system give `radius`")
    from polhode.systems.base import AbstractSystem

    check.instance("system", system, AbstractSystem, "a system, or a motion in closed form")
    if state is None or times is None:
        raise InvalidInput(f"`state` and `times` must be given for a system, here {shown(type(system).__name__)}: "
                           "only a motion in closed form has its own start.")
    from polhode.proving.enclosures.enclosure import enclose_by_series

    return enclose_by_series(system, state, times, 1e-15 if radius is None else radius, other, state_radii)


def _refuse(given: Mapping[str, Any], whose: str) -> None:
    if wrong := [name for name, value in given.items() if value is not None]:
        raise InvalidInput(f"`{wrong[0]}` is {whose}. Leave it out; got {shown(given[wrong[0]])}.")
