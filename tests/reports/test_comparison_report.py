"""What a comparison says where there is next to nothing to say."""

from dataclasses import replace

import numpy as np

from polhode import FreeMotion, rotation
from polhode.spacecraft.comparing.comparison import AttitudeHistory, compare
from polhode.spacecraft.comparing.report import ComparisonReport

MOTION = FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5))
TIMES = np.linspace(0.0, 10.0, 50)
HISTORY = AttitudeHistory("samples", TIMES, MOTION.attitude(TIMES))


def lines(turn):
    turned = rotation.multiply(rotation.from_rotation_vector((0.0, 0.0, turn)), HISTORY.attitude)
    report = ComparisonReport(compare(replace(HISTORY, attitude=turned), HISTORY), "")
    return dict(next(group for group in report.answers if group.title == "Angle between them").lines), report


def test_digits_of_rounding_are_not_shown():
    still, report = lines(0.0)
    noise = next(key for key in still if key.startswith("noise"))  # of samples this far apart: an upper bound
    assert 0.0 < float(still.pop(noise).split()[0]) < 1e-7
    assert set(still.values()) <= {"0", "less than 3e-16 rad"} and "to rounding" in report.summary
    tiny, report = lines(1e-18)
    assert "e-18" not in " ".join(tiny.values()) and "3.0e-16 rad: to rounding" in report.summary
    seen, report = lines(1e-9)
    assert seen["largest"].startswith("1.0000") and "growth, best line" in seen
    assert "Best fit" in report.answers[3].title
    assert all("Best fit" not in section.title for section in lines(1e-13)[1].answers)


def test_one_common_time_says_nothing_of_others():
    one = AttitudeHistory("one", TIMES[:1], HISTORY.attitude[:1])
    same = ComparisonReport(compare(one, HISTORY), "")
    assert "at the only time they have in common" in same.summary and "rounding" not in same.summary
    turned = rotation.multiply(rotation.from_rotation_vector((0.0, 0.0, 0.1)), HISTORY.attitude)
    other = ComparisonReport(compare(one, replace(HISTORY, attitude=turned)), "")
    assert other.summary.startswith("They differ by") and "only time" in other.summary
    assert all("Best fit" not in section.title for section in other.answers)
