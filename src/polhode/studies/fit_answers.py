"""Answers that fits of throws and fits of attitudes share."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from polhode.estimation._estimate import Estimate
from polhode.estimation.attitude_fit import AttitudeFit
from polhode.estimation.throw import ThrowFit
from polhode.reports.answer import Answer, Group
from polhode.reports.wording import count_known_digits, uncertain
from polhode.types import Array

ALIKE = 0.5  # correlation of neighbouring residuals, above which a fit does not explain its data


def about_inertia(fit: ThrowFit | AttitudeFit) -> Group:
    if fit.ratios is None:
        return Group("Inertia", [
            Answer("ratios", None),
            Answer("degenerate", fit.degenerate, "", "not determined", "", sentence(fit.degenerate or "")),
            Answer("equal", None),
        ])  # fmt: skip
    intervals = fit.ratios.interval()
    answers = []
    for (name, value, error), (low, high) in zip(each(fit.ratios), intervals.tolist(), strict=True):
        digits = count_known_digits(value, error, 16) + 2
        words = f"{uncertain(value, error)}, 95 %: {low:.{digits}g} to {high:.{digits}g}"
        estimate = {"value": value, "standard_error": error, "interval": [low, high]}
        answers.append(Answer(f"ratios.{name}", estimate, "", name, "interval of 95 %", words))
    return Group("Inertia", [
        *answers, Answer("degenerate", None), Answer("equal", fit.equal, "", "equal within errors"),
    ])  # fmt: skip


def about_moments(moments: Estimate | None) -> list[Group]:
    if moments is None:
        return []
    return [Group("Moments", [
        Answer("moments.value", moments.value.tolist(), "kg m²", "I1, I2, I3", "", f"{in_words(moments)} kg m²"),
        Answer("moments.standard_error", moments.standard_error.tolist(), "kg m²"),
    ])]  # fmt: skip


def about_axes(fit: ThrowFit | AttitudeFit) -> Group:
    axes, turn = fit.axes, fit.axes_error
    named = []
    for k in range(3):
        words = None
        if axes is not None:
            words = ", ".join(f"{x:+.4f}" for x in axes[:, k])
            if turn is not None:  # an axis tilts by the turns about the other two
                tilt = float(np.sqrt(np.sum(np.delete(turn.standard_error, k) ** 2)))
                words += f"  ± {np.degrees(tilt):.2g}°" if tilt < 1.0 else "  (direction not determined)"
        named.append(Answer("", None, "", f"axis {k + 1} along x, y, z", "", words))
    error = None if turn is None else turn.standard_error.tolist()
    return Group("Principal axes in the device", [
        *named,
        Answer("axes", None if axes is None else axes.tolist(), "", "", "principal axes by columns, in device axes"),
        Answer("axes_error", error, "rad", "", "standard deviations of turns about the axes themselves"),
    ])  # fmt: skip


def about_misfit(residuals: Sequence[Array], so: str, remedy: str) -> list[str]:
    """Return a note where neighbouring residuals are alike: then the model does not explain the data."""
    pairs = [(r[:-1], r[1:]) for r in residuals if len(r) > 2]
    alike = sum(float((a * b).sum()) for a, b in pairs) / max(sum(float((a * a).sum()) for a, _ in pairs), 1e-300)
    if alike < ALIKE:
        return []
    said = f"neighbouring residuals are alike (correlation {alike:.2f}): the fitted motion does not explain the data"
    return [f"{said}, and {so}. {remedy}."]


def motion_in_words(regime: str | None) -> str:
    words = {"short-axis": "turning about the axis of the largest moment", "separatrix": "on the separatrix",
             "long-axis": "turning about the axis of the smallest moment", "permanent": "a steady spin"}  # fmt: skip
    return words.get(regime or "", regime or "–")


def each(estimate: Estimate) -> list[tuple[str, float, float]]:
    return list(zip(estimate.names, estimate.value.tolist(), estimate.standard_error.tolist(), strict=True))


def values(estimate: Estimate) -> dict[str, Any]:
    return {"value": estimate.value.tolist(), "standard_error": estimate.standard_error.tolist()}


def in_words(estimate: Estimate) -> str:
    return ", ".join(uncertain(value, error) for _, value, error in each(estimate))


def sentence(text: str) -> str:
    text = text.strip()
    return text[:1].upper() + text[1:] + ("" if text.endswith(".") else ".")
