"""Every exercise of the course: its answer by polhode against a second way, its mistakes apart from the answer."""

import json
import math
import re
import shutil
import subprocess
from pathlib import Path

import pytest

from polhode.course.exercises import Chapter, Choice, Exercise, chapter_names, evaluate, read_chapter

COURSE = Path(__file__).parents[2] / "learn"
SEEDS, MANY = 5, 200
PLACE = re.compile(r"\{[A-Za-z]\w*\}")
EXERCISES = [(chapter, one) for chapter in chapter_names() for one in read_chapter(chapter).exercises]
SPECIMEN = {
    "name": "spin", "tier": "beginner", "text": "I = {I} kg m², L = {L} kg m²/s. What is the rate?",
    "numbers": {"I": {"from": 1.0, "to": 3.0, "step": 0.1}, "L": {"one_of": [2.0, 4.0]}},
    "answer": "float(ph.FreeMotion((I, I, I), momentum=(0, 0, L)).angular_velocity(0.0)[2])", "check": "L / I",
    "unit": "rad/s", "solution": "L/I = {answer} rad/s", "mistake": [{"value": "L * I", "hint": "Divide."}],
}  # fmt: skip


def faults_of(exercise, seeds):
    """Return what is wrong with an exercise, a sentence for each seed at which something is."""
    faults = []
    for seed in seeds:
        values = exercise.values(seed)
        answer, check = values["answer"], float(evaluate(exercise.check, values))
        question = exercise.draw(seed)
        known = [answer, *(value for value, _ in question.mistakes)]
        if not all(map(math.isfinite, [*known, check])):
            faults.append(f"{seed}: not finite: {known}, {check}")
        elif abs(answer - check) > 1e-9 * abs(answer):
            faults.append(f"{seed}: polhode says {answer}, the second way {check}")
        elif any(question.respond_to(repr(value)) != hint for value, hint in question.mistakes):
            faults.append(f"{seed}: a mistake is told as something else: {known}")
        elif question.respond_to(repr(answer)) != "Right." or PLACE.search(question.text + question.solution):
            faults.append(f"{seed}: {question}")
    return faults


@pytest.mark.long_cases(
    "the-pattern-ring-rate", "the-pattern-sphere-ring", "the-pattern-orbit-of-matrices", "the-pattern-wake-descent"
)
@pytest.mark.parametrize(("chapter", "exercise"), EXERCISES, ids=lambda v: v if isinstance(v, str) else v.name)
def test_answer_agrees_with_a_second_way_and_mistakes_are_told_apart(chapter, exercise):
    assert faults_of(exercise, range(SEEDS)) == []


@pytest.mark.sweep
@pytest.mark.parametrize(("chapter", "exercise"), EXERCISES, ids=lambda v: v if isinstance(v, str) else v.name)
def test_so_it_is_with_many_numbers(chapter, exercise):
    assert faults_of(exercise, range(SEEDS, MANY)) == []


def test_each_chapter_has_its_exercises():
    assert len(chapter_names()) == 14
    for chapter in map(read_chapter, chapter_names()):
        assert len(chapter.exercises) >= 5, chapter.title
        assert len(chapter.choices) >= 6, chapter.title
        assert {one.tier for one in chapter.exercises} >= {"beginner", "intermediate"}, chapter.title
        assert all(len(one.mistakes) >= 1 for one in chapter.exercises), chapter.title


@pytest.mark.parametrize("broken", [
    {"check": "L * I"},  # a second way that differs
    {"mistake": [{"value": "answer * 1.001", "hint": "Divide."}]},  # a mistake that is right
    {"mistake": [{"value": "L * I", "hint": "A."}, {"value": "L * I * 1.001", "hint": "B."}]},  # two that are one
    {"answer": "L / (I - I)"},
])  # fmt: skip
def test_the_check_sees_a_broken_exercise(broken):
    assert faults_of(Exercise.model_validate(SPECIMEN), range(20)) == []
    try:
        assert faults_of(Exercise.model_validate({**SPECIMEN, **broken}), range(20))
    except ZeroDivisionError:
        assert "answer" in broken


@pytest.mark.parametrize("broken", [
    {"text": "I = {J}?"},
    {"numbers": {"I": {"from": 3.0, "to": 1.0, "step": 0.1}, "L": {"one_of": [2.0]}}},
    {"numbers": {"I": {"from": 3.0}, "L": {"one_of": [2.0]}}},
    {"colour": "red"},
])  # fmt: skip
def test_a_malformed_exercise_is_refused(broken):
    with pytest.raises(ValueError):
        Exercise.model_validate({**SPECIMEN, **broken})


def test_a_choice_has_one_right_option():
    option = {"text": "x", "response": "y", "right": True}
    two = {"name": "a", "tier": "beginner", "text": "?", "option": [option, option]}
    with pytest.raises(ValueError, match="exactly one"):
        Choice.model_validate(two)
    with pytest.raises(ValueError, match="twice"):
        Chapter.model_validate({"title": "t", "exercise": [SPECIMEN, SPECIMEN]})


ANSWERS = ("1", " 1,5 ", "−2", "x", "", "1e3", "nan", "0", "-0.4")


@pytest.mark.skipif(shutil.which("node") is None, reason="needs node")
def test_the_page_responds_as_python_does():
    cases, expected = [], []
    for _, exercise in EXERCISES[::7]:
        question = exercise.draw(3)
        values = [value for value, _ in question.mistakes]
        for typed in (*ANSWERS, repr(question.answer), repr(-question.answer), *map(repr, values)):
            cases.append([typed, question.answer, values, [hint for _, hint in question.mistakes], question.tolerance])
            expected.append(question.respond_to(typed))
    script = (
        f"const {{ respondTo }} = require({json.dumps(str(COURSE / '_static' / 'exercises.js'))});"
        f"console.log(JSON.stringify({json.dumps(cases)}.map((one) => respondTo(...one))))"
    )
    run = subprocess.run(["node", "-e", script], capture_output=True, text=True, check=True)
    assert json.loads(run.stdout) == expected
    assert len(set(expected)) > 5
