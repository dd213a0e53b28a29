"""What ``print`` shows of an answer: a sentence and a few numbers, and no page of arrays."""

import inspect

import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode.analysis._printing import LIMITS, print_answer, write_numbers
from polhode.analysis.periodic_branches import PeriodicBifurcation, PeriodicBranch

LONGEST = 600  # characters: five lines
BODY = ph.systems.FreeRigidBody((1.0, 2.0, 3.0))
START = [0.3, 1.9, 0.1]
TOP = ph.systems.HeavyTop((1.0, 1.0, 0.5), 1.0, (0.0, 0.0, 1.0))


def axis(number):
    return ph.stability(BODY, np.eye(3)[number])


def family(field):
    return ph.systems.LiePoisson(ph.algebra.SO3(), lambda m: -0.5 * m[2] ** 2 - field * m[0])


def histories():
    motion = ph.FreeMotion((1.0, 2.0, 3.0), momentum=START)
    other = ph.FreeMotion((1.0, 2.0, 3.0), momentum=np.multiply(START, 1.0 + 1e-6))
    return ph.spacecraft.compare(motion, other.sample(np.linspace(0.0, 5.0, 50)))


ANSWERS = {
    "stable": (lambda: axis(2), "Stable: the second variation of", "exponents: 0.333333i, -0.333333i 1/s"),
    "unstable": (lambda: axis(1), "Unstable: the linearised flow", "fastest growth: 0.288675 1/s"),
    "lyapunov": (lambda: ph.analysis.lyapunov(BODY, START, (0.0, 300.0)), "no chaos is seen", "times: from"),
    "section": (lambda: ph.analysis.section(BODY, START, lambda t, L: L[1], (0.0, 99.0)), "crossings up to", "times:"),
    "threshold": (
        lambda: ph.analysis.stability_threshold(lambda spin: ph.stability(TOP, TOP.upright(spin)), 1.0, 6.0),
        "Unstable below and stable above.", "threshold: 4 ± ",
    ),
    "rests": (lambda: ph.analysis.top_stability(TOP, 5.0), "Upright stable, hanging", "hanging: "),
    "branches": (
        lambda: ph.analysis.continue_equilibria(family, (0.0, 2.0), [0.0, 0.0, 1.0]),
        "branches of equilibria and 1 bifurcation.", "bifurcations: pitchfork at 1",
    ),
    "branch": (
        lambda: ph.analysis.continue_equilibria(family, (0.0, 2.0), [0.0, 0.0, 1.0]).branches[0],
        "equilibria: ", "parameter: from 0 to ",
    ),
    "bifurcation": (
        lambda: ph.analysis.continue_equilibria(family, (0.0, 2.0), [0.0, 0.0, 1.0]).bifurcations[0],
        "A pitchfork at 1.", "branches: ",
    ),
    "comparison": (histories, "The rotation between ", "rms: "),
    "alignment": (lambda: histories().alignment, "Aligned, ", "rate of the space axes: "),
    "rotation": (
        lambda: ph.analysis.steady_rotations(ph.systems.Gyrostat((1.0, 2.0, 3.0), (0.0, 0.0, 0.5)), 1.0)[0],
        "A steady rotation, stable, at a minimum", "along: ",
    ),
    "orbit": (lambda: ph.analysis.orbital_equilibria((1.0, 2.0, 2.5), 1e-3)[0], "A rest in the orbit's", "axes in"),
    "spin": (
        lambda: ph.analysis.spinning_equilibria(1.0, 1.5, 1e-3, 3e-3)[0], "rest of a spinning body's axis", "spin: ",
    ),
    "history": (
        lambda: ph.analysis.AttitudeHistory("a.csv", np.arange(2.0), np.eye(4)[:2]),
        "The attitude of a.csv at 2 times, sampled.", "times: from 0 to 1 s",
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", list(ANSWERS))
def test_an_answer_prints_as_a_sentence_and_a_few_numbers(name):
    make, sentence, line = ANSWERS[name]
    answer = make()
    words = str(answer)
    assert sentence in words.splitlines()[0] and words.splitlines()[0].endswith(".")
    assert any(each.startswith(line) or line in each for each in words.splitlines()[1:])
    assert len(words) < LONGEST and "array(" not in words and "(" + type(answer).__name__ not in words
    assert repr(answer).startswith(type(answer).__name__ + "(")  # the data stay there


@pytest.mark.long
def test_periodic_motions_and_enclosures_print_as_sentences():
    def spin(field):
        return ph.systems.FreeRigidBody((1.0, 2.0, 3.0 + field))

    motion = ph.analysis.periodic_motion(BODY, [0.3, 0.2, 1.9], 10.0)
    assert str(motion).startswith("A periodic motion, spectrally stable.\nperiod: ")
    bifurcation = PeriodicBifurcation("fold", 0.5, motion)
    assert str(bifurcation).startswith("A fold at 0.5.\nperiod: ")
    branch = PeriodicBranch(np.array([0.0, 0.5]), (motion, motion), (bifurcation,))
    assert str(branch).splitlines() == [
        "2 periodic motions, none of them unstable.", "parameter: from 0 to 0.5", "bifurcations: fold at 0.5",
    ]  # fmt: skip
    enclosure = ph.certify(BODY, START, [0.0, 1.0])
    assert str(enclosure).startswith("Proved enclosures of the system as it is, at 2 times from 0 to 1 s.\n")
    state = ph.certify(ph.FreeMotion((1.0, 2.0, 3.0), momentum=START)).state(1.0)
    assert str(state).splitlines()[2].startswith("momentum: ") and len(str(state)) < LONGEST


def answers_with_arrays():
    """The public classes of the room whose data hold an array or another answer, by their annotations."""
    for name in ph.analysis.__all__:
        cls = getattr(ph.analysis, name)
        if inspect.isclass(cls) and cls.__module__.startswith("polhode.analysis."):
            fields = inspect.get_annotations(cls).values()
            if any("Array" in str(kind) or "ndarray" in str(kind) or "Stability" in str(kind) for kind in fields):
                yield cls


INPUTS = {"Mechanics"}  # is given, and is no answer


def prints_itself(cls):
    return "__str__" in vars(cls)


def test_no_answer_with_arrays_prints_as_a_page():
    found = list(answers_with_arrays())
    assert len(found) > 12
    assert {cls.__name__ for cls in found if not prints_itself(cls)} == INPUTS


def test_few_numbers_are_shown_of_many():
    assert write_numbers(np.arange(LIMITS.max_numbers)) == "0, 1, 2, 3, 4, 5"
    assert write_numbers(np.arange(LIMITS.max_numbers + 1)) == "0, 1, 2, 3, 4, 5, … (7)"
    assert write_numbers(jnp.asarray([[1.0, 2.0]]), "m") == "1, 2 m"
    assert write_numbers(np.array([0.5, 1.0]), errors=[0.1, 0.25]) == "0.5 ± 0.1, 1 ± 0.25"
    assert print_answer("said", number=None) == "Said."
