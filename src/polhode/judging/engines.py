"""The errors of an engine over the hard motions of the table."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from polhode.errors import InvalidInput, shown
from polhode.exact.free_body import FreeMotion
from polhode.exact.lagrange_top import LagrangeMotion
from polhode.judging.motion_table import MODERATE, ReferenceMotion, reference_motions
from polhode.rotation import angle_between, normalize
from polhode.types import Array, Float64

Engine = Callable[[ReferenceMotion], tuple[Any, Any]]


@dataclass(frozen=True, eq=False)
class MotionErrors:
    """The errors of an engine in one motion; NaN counts as infinite.

    Attributes:
        motion: the motion.
        attitude: (T,) angle between the attitudes [rad].
        momentum: (T,) largest error of an entry of L, relative to the largest |L| of the motion.
        energy: (T,) departure from the energy at time 0, relative to |Ω| |L| + |mgl|, the largest of the motion.
        length: (T,) of the quaternion less 1.
        rounding: (T,) angle [rad] by which the exact motion moves when its given numbers are rounded to the engine's
            type of number; no engine of that type can be expected to do better. Zero for float64.
    """

    motion: ReferenceMotion
    attitude: Float64[Array, "time"]
    momentum: Float64[Array, "time"]
    energy: Float64[Array, "time"]
    length: Float64[Array, "time"]
    rounding: Float64[Array, "time"]


class FamilyErrors(NamedTuple):
    """The worst of a family: errors as in ``MotionErrors``, attitudes at moderate times and at long ones apart."""

    motions: int
    attitude: float
    attitude_long: float
    rounding: float
    momentum: float
    energy: float
    length: float


@dataclass(frozen=True, eq=False)
class EngineComparison:
    """The result of a comparison: errors motion by motion, printed as a table of the worst of each family.

    Attributes:
        motions: errors of each motion.
        precision: the type of number that the engine returned, the coarsest if there were several.
    """

    motions: tuple[MotionErrors, ...]
    precision: np.dtype

    @property
    def eps(self) -> float:
        """The engine's rounding unit, distance from 1 to the next number."""
        return float(np.finfo(self.precision).eps)

    @property
    def families(self) -> dict[str, FamilyErrors]:
        """The worst of each family, by its name."""
        names = dict.fromkeys(errors.motion.family for errors in self.motions)
        return {name: _worst([e for e in self.motions if e.motion.family == name]) for name in names}

    @property
    def worst(self) -> FamilyErrors:
        """The worst of all motions."""
        return _worst(self.motions)

    def __str__(self) -> str:
        head = f"{self.precision}, eps = {self.eps:.3g}; worst of each family, angles in rad, others relative"
        titles = ("attitude", "in eps", "at long times", "by rounding", "momentum", "energy", "length")
        lines = [head, f"{'family':20}{'motions':>8}" + "".join(f"{title:>15}" for title in titles)]
        for name, errors in {**self.families, "all": self.worst}.items():
            sizes = (errors.attitude, errors.attitude / self.eps, *errors[2:])
            lines.append(f"{name:20}{errors.motions:8}" + "".join(f"{_write_size(x):>15}" for x in sizes))
        return "\n".join(lines)


def compare_engine(engine: Engine, motions: Sequence[ReferenceMotion] | None = None) -> EngineComparison:
    """Compare an engine with the exact states of hard motions.

    Args:
        engine: takes a ``ReferenceMotion``, of which it may read everything but the answers, and returns attitudes
            (T, 4) and momenta (T, 3) at ``motion.times``, as arrays of float64, float32 or float16.
        motions: of ``reference_motions``; by default all of them, at moderate times.

    Raises:
        InvalidInput: for no motions, and for answers of a wrong shape or type of number.

    >>> import polhode as ph
    >>> def engine(motion):
    ...     return ph.FreeMotion(motion.moments, momentum=motion.momentum, attitude=motion.attitude).state(motion.times)
    >>> comparison = compare_engine(engine, reference_motions(kind="free body"))
    >>> comparison.worst.motions > 100, max(comparison.worst[1:]) < 1e-14
    (True, True)
    """
    motions = reference_motions(up_to=MODERATE) if motions is None else motions
    if not len(motions):
        raise InvalidInput("`motions` must be motions of the table; got none. Take them from reference_motions().")
    answers = [_check_answer(engine(motion), motion) for motion in motions]
    precision = max((np.result_type(*answer) for answer in answers), key=lambda dtype: np.finfo(dtype).eps)
    pairs = zip(motions, answers, strict=True)
    return EngineComparison(tuple(_errors(motion, *answer, precision) for motion, answer in pairs), precision)


def _check_answer(answer: Any, motion: ReferenceMotion) -> tuple[np.ndarray, np.ndarray]:
    if not (isinstance(answer, tuple | list) and len(answer) == 2):
        raise InvalidInput(f"`engine` must return attitudes and momenta, two arrays; got {shown(answer)}.")
    attitudes, momenta = map(np.asarray, answer)
    for name, values, wanted in (("attitudes", attitudes, motion.attitudes), ("momenta", momenta, motion.momenta)):
        if values.shape != wanted.shape or not np.issubdtype(values.dtype, np.floating):
            raise InvalidInput(f"`engine` must return {name} of shape {wanted.shape} in floating point; "
                               f"got {values.dtype} of shape {values.shape} for the motion {motion.name}.")
    return attitudes, momenta


def _errors(
    motion: ReferenceMotion, attitudes: np.ndarray, momenta: np.ndarray, precision: np.dtype
) -> MotionErrors:
    q, L = attitudes.astype(np.float64), momenta.astype(np.float64)
    sizes = np.linalg.norm(motion.momenta, axis=-1)
    speeds = np.linalg.norm(motion.momenta / motion.moments, axis=-1)
    with np.errstate(over="ignore", invalid="ignore"):
        at_start = _energy(motion, np.asarray(motion.attitude)[None], np.asarray(motion.momentum)[None])
        energies = _energy(motion, q, L) - at_start
        return MotionErrors(
            motion,
            _size(angle_between(q, motion.attitudes)),
            _size(np.max(np.abs(L - motion.momenta), axis=-1) / (sizes.max() or 1.0)),
            _size(energies / ((speeds.max() * sizes.max() + abs(motion.mgl)) or 1.0)),
            _size(np.linalg.norm(q, axis=-1) - 1.0),
            _estimate_rounding(motion, precision),
        )


def _energy(motion: ReferenceMotion, q: np.ndarray, L: np.ndarray) -> np.ndarray:
    w, x, y, z = np.moveaxis(q, -1, 0)
    height = (w * w + z * z - x * x - y * y) / (w * w + x * x + y * y + z * z)
    return np.sum(L * (L / motion.moments), axis=-1) / 2.0 + motion.mgl * height


def _size(values: Array) -> np.ndarray:
    return np.where(np.isfinite(values), np.abs(values), np.inf)


def _estimate_rounding(motion: ReferenceMotion, precision: np.dtype) -> np.ndarray:
    if precision == np.float64:
        return np.zeros(motion.times.shape)

    def round_to(values: Any) -> np.ndarray:
        return np.asarray(values).astype(precision).astype(np.float64)

    with np.errstate(over="ignore", under="ignore"):
        moments, momentum, attitude, mgl = map(round_to, (motion.moments, motion.momentum, motion.attitude, motion.mgl))
    lost = not momentum.any() and motion.momentum.any()
    if lost or not (np.isfinite(moments).all() and (moments > 0.0).all() and np.isfinite(momentum).all()):
        return np.full(motion.times.shape, np.inf)
    start = normalize(attitude)
    if motion.kind == "free body":
        moved = FreeMotion(moments, momentum=momentum, attitude=start)
    else:
        moved = LagrangeMotion(moments, mgl=mgl, momentum=momentum, attitude=start)
    return np.asarray(angle_between(moved.attitude(motion.times), motion.attitudes))


def _worst(errors: Sequence[MotionErrors]) -> FamilyErrors:
    def largest(name: str, reach: bool | None = None) -> float:
        of_all = [getattr(e, name)[slice(None) if reach is None else e.motion.moderate == reach] for e in errors]
        return float(np.max(np.concatenate(of_all), initial=0.0))

    return FamilyErrors(len(errors), largest("attitude", True), largest("attitude", False), largest("rounding"),
                        largest("momentum"), largest("energy"), largest("length"))


def _write_size(value: float) -> str:
    return "-" if value == 0.0 else f"{value:.2g}"
