"""Answers that fits of throws and fits of attitudes share."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from polhode.estimation._estimate import Estimate
from polhode.exact.free_body.motion import FreeMotion
from polhode.measuring.attitudes.attitude_fit import AttitudeFit
from polhode.measuring.throws.throw import ThrowFit
from polhode.motion._inputs import name_of
from polhode.reports.answer import Answer, Group
from polhode.reports.wording import count_known_digits, uncertain
from polhode.special._residual_noise import Misfit
from polhode.types import Array, Float64

CAUSES = {"air": "drag of the air", "torque": "a torque that is constant in the body",
          "wheel": "a wheel that turns in the body"}  # fmt: skip


class AnswerThresholds(NamedTuple):
    """Numbers that decide how answers are worded.

    Attributes:
        visible_correlation: of neighbouring residuals, which a reader recognizes in a figure.
        main_axis_share: of L² in the mean along an axis, from which a body turns about this axis and no other.
        max_tilt: rad, standard error of the direction of an axis; a larger one leaves it undetermined.
    """

    visible_correlation: float = 0.3
    main_axis_share: float = 0.5
    max_tilt: float = 1.0


LIMITS = AnswerThresholds()


def about_inertia(fit: ThrowFit | AttitudeFit) -> Group:
    if fit.ratios is None:
        return Group("Inertia", [
            Answer("ratios", None),
            Answer("degenerate", fit.degenerate, "", "not determined", "", sentence(fit.degenerate or "")),
            Answer("equal", None),
        ])
    intervals = fit.ratios.interval()
    answers = []
    for (name, value, error), (low, high) in zip(each(fit.ratios), intervals.tolist(), strict=True):
        words, estimate = uncertain(value, error), {"value": value, "standard_error": None, "interval": None}
        if fit.misfit is None:
            digits = count_known_digits(value, error, 16) + 2
            words += f", 95 %: {low:.{digits}g} to {high:.{digits}g}"
            estimate |= {"standard_error": error, "interval": [low, high]}
        answers.append(Answer(f"ratios.{name}", estimate, "", name, "interval of 95 %", words))
    return Group("Inertia", [
        *answers, Answer("degenerate", None), Answer("equal", fit.equal, "", "equal within errors"),
    ])


def about_moments(moments: Estimate | None) -> list[Group]:
    if moments is None:
        return []
    return [Group("Moments", [
        Answer("moments.value", moments.value.tolist(), "kg m²", "I1, I2, I3", "", f"{in_words(moments)} kg m²"),
        Answer("moments.standard_error", values(moments)["standard_error"], "kg m²"),
    ])]  # fmt: skip


def about_axes(fit: ThrowFit | AttitudeFit) -> Group:
    axes, turn = fit.axes, fit.axes_error
    named = []
    for k in range(3):
        words = None
        if axes is not None:
            words = ", ".join(f"{x:+.4f}" for x in axes[:, k])
            if fit.misfit is not None:
                words = "about " + ", ".join(f"{x:+.2f}" for x in axes[:, k])
            elif turn is not None:  # an axis tilts by the turns about the other two
                tilt = float(np.sqrt(np.sum(np.delete(turn.standard_error, k) ** 2)))
                words += f"  ± {np.degrees(tilt):.2g}°" if tilt < LIMITS.max_tilt else "  (direction not determined)"
        named.append(Answer("", None, "", f"axis {k + 1} along x, y, z", "", words))
    error = None if turn is None or fit.misfit is not None else turn.standard_error.tolist()
    return Group("Principal axes in the device", [
        *named,
        Answer("axes", None if axes is None else axes.tolist(), "", "", "principal axes by columns, in device axes"),
        Answer("axes_error", error, "rad", "", "standard deviations of turns about the axes themselves"),
    ])


def tell_misfit(fit: ThrowFit | AttitudeFit, unit: str) -> str:
    """Return in sentences that the residuals of a fit are no noise, the possible cause, and the consequence."""
    misfit = fit.misfit
    assert misfit is not None and fit.ratios is not None
    test = misfit.test
    shown = f"noise has such frequencies with a probability of {test.probability:.1g}"
    if test.alike > LIMITS.visible_correlation:
        shown = f"neighbouring ones are alike, with a correlation of {test.alike:.2f}"
    said = f"Something else acts on the body, or it is not free: residuals of {fit.rms:.2g} {unit} rms are not noise"
    tried = [CAUSES[name] for name in misfit.tried]
    cause = ""
    if misfit.cause is not None:
        cause = f" {CAUSES[misfit.cause].capitalize()} explains them."
    elif len(tried) > 1:
        cause = f" Neither {' nor '.join(tried)} explains them."
    elif tried:
        cause = f" {tried[0].capitalize()} does not explain them."
    values = ", ".join(f"{name} {uncertain(value, error)}" for name, value, error in each(fit.ratios))
    return f"{said} ({shown}).{cause} The best fit, {values}, is of a wrong model: its error is not known."


def about_misfit(misfit: Misfit | None) -> Answer:
    value = None if misfit is None else {
        "probability": misfit.test.probability, "alike": misfit.test.alike, "tried": list(misfit.tried),
        "cause": misfit.cause,
    }
    return Answer("misfit", value, "", "", "why residuals are not noise, so that nothing has an error; null where they "
                  "are: probability of such residuals, were they noise; correlation of neighbours")


def describe_turning(motion: FreeMotion | None, times: Float64[Array, "n"], equal: str | None) -> str:
    """Return in words the axis about which a body turns: that with more than half of L² in the mean.

    The polhode alone does not show it: one that circles an axis may pass close to the middle one, where it is slowest.

    Args:
        motion: along principal axes in the order of their moments.
        times: of the samples [s].
        equal: "I1 = I2" or "I2 = I3" where these are equal within their errors.

    >>> times = np.linspace(0.0, 3.0, 100)
    >>> describe_turning(FreeMotion((0.2, 0.8, 1.0), angular_velocity=(0.1, 9.0, 0.3)), times, None)
    'turning about the middle axis, over which it flips'
    """
    if motion is None:
        return "–"
    regime = name_of(motion.regime)
    if regime in ("rest", "spherical", "permanent"):
        return {"permanent": "a steady spin"}.get(regime, regime)
    L = np.asarray(motion.momentum(times))
    shares = (L**2).mean(axis=0) / (L**2).sum(axis=1).mean()
    k = int(np.argmax(shares))
    if shares[k] <= LIMITS.main_axis_share:
        return "turning about none of its axes for long"
    if f"I{k + 1}" in (equal or ""):
        return "turning about an axis of two moments that are equal within their errors"
    flips = k == 1 and (L[:, 1] > 0.0).any() and (L[:, 1] < 0.0).any()
    axis = ("the axis of the smallest moment", "the middle axis", "the axis of the largest moment")[k]
    return f"turning about {axis}" + (", over which it flips" if flips else "")


def each(estimate: Estimate) -> list[tuple[str, float, float]]:
    return list(zip(estimate.names, estimate.value.tolist(), estimate.standard_error.tolist(), strict=True))


def values(estimate: Estimate) -> dict[str, Any]:
    known = np.isfinite(estimate.standard_error).all()
    return {"value": estimate.value.tolist(), "standard_error": estimate.standard_error.tolist() if known else None}


def in_words(estimate: Estimate) -> str:
    words = [uncertain(value, error) for _, value, error in each(estimate)]
    return ", ".join(words[:1] + [one.removeprefix("about ") for one in words[1:]])


def sentence(text: str) -> str:
    text = text.strip()
    return text[:1].upper() + text[1:] + ("" if text.endswith(".") else ".")
