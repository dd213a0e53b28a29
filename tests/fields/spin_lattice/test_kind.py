"""Reports on spins on lattices: waves and heat in closed form, skyrmions, and what is refused."""

import re

import numpy as np
import pytest

from polhode.errors import InvalidInput
from polhode.fields.spin_lattice.waves_figure import draw_waves
from polhode.kinds.reading import read_spec
from polhode.reports.wording import round_words

MILLI = 1.602176634e-22  # J in a meV
BOHR = 5.7883817982e-2  # meV/T
CHAIN = 'vectors = [[1]]\ncells = [8]\nbonds = [{ cell = [1], exchange = "1 meV" }]'


@pytest.fixture
def spec(tmp_path):
    def make(system, until="0.1 ps", samples=5):
        path = tmp_path / "case.toml"
        time = f'[time]\nuntil = "{until}"\nsamples = {samples}\n'
        path.write_text(f'[system]\nkind = "spin-lattice"\n{system}\n{time}', "utf-8")
        return read_spec(path)

    return make


@pytest.mark.sweep
def test_waves_of_a_ferromagnetic_chain(spec):
    """gμB B + 2KS + 2JS(1 − cos k), in the field's and the axis's own energies; one wave turns at that rate."""
    text = CHAIN + '\nspin = 1.5\nfield = ["0 T", "0 T", "4 T"]\nanisotropy = { axis = [0, 0, 2], energy = "0.1 meV" }'
    report = spec(text + "\ndisorder = 0.001", "0.2 ps", 41).report()
    values = report.as_json_dict()
    gap = 2.0 * BOHR * 4.0 + 2.0 * 0.1 * 1.5
    assert values["waves"]["lowest"] / MILLI == pytest.approx(gap, rel=1e-8)
    assert values["waves"]["highest"] / MILLI == pytest.approx(gap + 4.0 * 1.5, rel=1e-8)
    rotated = np.unwrap(np.angle(report.magnetizations[:, 0] + 1j * report.magnetizations[:, 1]))
    rate = -(rotated[-1] - rotated[0]) / 0.2e-12  # the uniform wave goes round clockwise, S × B
    assert rate * 1.054571817e-34 / MILLI == pytest.approx(gap, rel=1e-4)
    assert values["energy"]["start"] / MILLI == pytest.approx(-(1.5**2) - 0.1 * 1.5**2 - 2 * BOHR * 4 * 1.5, rel=1e-5)
    assert draw_waves(report) is not None
    # pages and datasets say it of all spins, in J; they called the system's own rad/s so, 1e34 times as much
    assert report.trajectory.quantity("energy").unit == "J"
    assert report.trajectory.invariants["energy"][0] / 8 == pytest.approx(values["energy"]["start"], rel=1e-12)


@pytest.mark.long
def test_damping_turns_a_spin_into_the_field(spec):
    """S_z/s = tanh(λBt + artanh cos θ₀) of free spins: their exchange does nothing while all are alike."""
    text = CHAIN + '\nfield = ["0 T", "0 T", "5 T"]\ndamping = 0.3\ndirections = [[1, 0, 0]]'
    report = spec(text, "1 ps", 11).report()
    rate = 2.0 * BOHR * 5.0 * MILLI / 1.054571817e-34
    assert report.magnetizations[-1, 2] == pytest.approx(np.tanh(0.3 * rate * 1e-12), rel=1e-3)
    assert "damping took" in report.summary and report.waves is None


@pytest.mark.sweep
def test_a_paramagnet_in_a_bath(spec):
    """Langevin's function of gμB B S/kT, for spins whose exchange is next to nothing."""
    bonds = 'bonds = [{ cell = [1, 0], exchange = "1e-9 meV" }]'
    text = f'vectors = [[1, 0], [0, 1]]\ncells = [20, 20]\n{bonds}\nfield = ["0 T", "0 T", "10 T"]\ndamping = 0.5'
    report = spec(text + '\ntemperature = "10 K"', "30 ps", 201).report()
    x = 2.0 * BOHR * 10.0 / (0.0861733326 * 10.0)
    wanted = 1.0 / np.tanh(x) - 1.0 / x
    late = report.magnetizations[60:, 2]
    assert late.mean() == pytest.approx(wanted, abs=0.006)
    mean, error = report.thermal
    assert mean / MILLI == pytest.approx(-2.0 * BOHR * 10.0 * wanted, abs=0.01) and 0.0 < error < 0.01 * MILLI
    assert set(report.trajectory.drift) == {"|L|²"}


@pytest.mark.sweep
def test_skyrmions_grow_from_disorder(spec):
    twisted = '{{ cell = {}, exchange = "1 meV", chirality = ["{} meV", "{} meV", "0 meV"] }}'
    arms = ", ".join([twisted.format("[1, 0]", 0.7, 0), twisted.format("[0, 1]", 0, 0.7)])
    text = f'vectors = [[1, 0], [0, 1]]\ncells = [20, 20]\nbonds = [{arms}]\nfield = ["0 T", "0 T", "2.8 T"]'
    text += "\ndamping = 0.5"
    report = spec(text + "\nrandom = true\nseed = 3", "30 ps", 11).report()
    assert report.skyrmions[1] < -2.5 and report.skyrmions[1] == pytest.approx(round(report.skyrmions[1]), abs=1e-9)
    assert any("skyrmions" in note for note in report.notes)


@pytest.mark.long
def test_opposed_neighbours_need_two_sites(spec):
    text = 'vectors = [[2]]\nbasis = [[0], [1]]\ncells = [4]\ndirections = [[0, 0, 1], [0, 0, -1]]\n'
    bonds = '{ sites = [1, 2], cell = [0], exchange = "-1 meV" }, { sites = [2, 1], cell = [1], exchange = "-1 meV" }'
    report = spec(f'{text}bonds = [{bonds}]\nanisotropy = {{ axis = [0, 0, 1], energy = "0.5 meV" }}').report()
    top = 2.0 * np.sqrt((1.0 + 0.5) ** 2)
    assert report.gap[1] / MILLI == pytest.approx(top, rel=1e-8)
    assert report.gap[0] / MILLI == pytest.approx(2.0 * np.sqrt(1.5**2 - 1.0), rel=1e-8)


TURN = 2.0 * BOHR * MILLI / 1.054571817e-34  # rad/s in a tesla
FIELD = '\nfield = ["0 T", "0 T", "1 T"]\ndirections = [[1, 0, 0]]'
ONE = "vectors = [[1]]\ncells = [1]"
FREE = "vectors = [[1, 0], [0, 1]]\ncells = [2, 3]"
PAIR = 'vectors = [[1]]\ncells = [2]\nbonds = [{ cell = [1], exchange = "1 meV" }]'
MANY = 'vectors = [[1, 0], [0, 1]]\ncells = [9, 9]\nbonds = [{ cell = [1, 0], exchange = "1 meV" }]'


def in_a_field(time, damping):
    """Where a spin along x comes to in a field along z: Ṡ = S × B − λ S × (S × B), in closed form."""
    x = TURN * time
    return np.array([np.cos(x), -np.sin(x), np.sinh(damping * x)]) / np.cosh(damping * x)


@pytest.mark.parametrize("damping", [0.0, 0.1])
@pytest.mark.parametrize("system", [ONE, FREE, PAIR])
def test_spins_in_a_field(spec, system, damping):
    """Parallel spins, and spins without exchange, turn like one; two damped ones were off by 2e-3, in six digits."""
    report = spec(f"{system}{FIELD}\ndamping = {damping}", "60 ps", 61).report()
    exact = in_a_field(report.trajectory.times, damping).T
    off = np.abs(report.magnetizations - exact).max()
    assert off < 1e-8 and report.trajectory.error_estimate < 1e-12  # Bohr's magneton above has ten digits
    (words,) = [a.words for a in report.answers[-1].answers if a.name == "magnetization.end"]
    shown = [float(x) for x in words.strip("()").split(", ")]
    assert np.abs(np.array(shown) - exact[-1]).max() < 6e-7
    drift = max(float(np.max(x)) for x in report.trajectory.drift.values())
    assert drift < 1e-12, "an energy that begins at zero is judged by what was received"


def test_many_spins_by_steps_say_so_and_print_what_is_known(spec):
    report = spec(f"{MANY}{FIELD}\ndamping = 0.1", "30 ps", 4).report()
    off = np.abs(report.magnetizations[-1] - in_a_field(30e-12, 0.1)).max()
    said = report.trajectory.error_estimate
    assert 1e-6 < off < 3.0 * said < 100.0 * off
    words = {answer.label: answer.words for answer in report.answers[-1].answers}
    assert "spherical midpoints, order 2" in words["computed by"]
    for shown, exact in zip(words["at the end"].strip("()").split(", "), in_a_field(30e-12, 0.1), strict=True):
        assert abs(float(shown) - exact) < 30.0 * said and len(shown.lstrip("-0.")) <= 5


def test_a_bath_has_no_error_estimate_and_says_so(spec):
    report = spec(f'{ONE}{FIELD}\ndamping = 0.3\ntemperature = "10 K"', "1 ps", 5).report()
    assert report.trajectory.error_estimate is None and "without an error estimate" in report.notes[-1]
    words = {answer.name: answer.words for answer in report.answers[-1].answers}
    assert words["magnetization.end"] == round_words(words["magnetization.end"], None)
    value = report.as_json_dict()["magnetization"]["end"][0]
    assert value != float(words["magnetization.end"].strip("()").split(",")[0]), "JSON has all digits"


def test_a_spin_alone_has_the_waves_of_the_field(spec):
    """gμB B for any wave number."""
    report = spec(f'{ONE}\nfield = ["0 T", "0 T", "4 T"]').report()
    assert np.array(report.gap) / MILLI == pytest.approx(2.0 * BOHR * 4.0, rel=1e-9)
    assert report.summary == "1 spin ends with 100 % of the largest magnetisation; spin waves have 0.46307 meV."
    assert draw_waves(report) is not None


@pytest.mark.parametrize("system", ["cells = [4]", 'cells = [4]\nbonds = [{ cell = [1], exchange = "0 meV" }]'])
def test_nothing_acts(spec, system):
    with pytest.raises(InvalidInput, match="must not all be zero: nothing would act on the spins"):
        spec(f"vectors = [[1]]\n{system}").report()


BONDS = 'bonds = [{ cell = [1], exchange = "1 meV" }]'


@pytest.mark.parametrize(("system", "words"), [
    (f"cells = [4]\n{BONDS}", "give one to three vectors"),
    (f"vectors = [[1]]\ncells = [4, 4]\n{BONDS}", "a number for each of the 1 vectors; got 2"),
    (f"vectors = [[1]]\ncells = [2000000]\n{BONDS}", "cells"),
    ('vectors = [[1]]\ncells = [4]\nbonds = [{ cell = [1] }]', "needs exchange or chirality or both"),
    ('vectors = [[1]]\ncells = [4]\nbonds = [{ cell = [1, 0], exchange = "1 meV" }]', "of the 1 vectors; got 2"),
    ('vectors = [[1]]\ncells = [4]\nbonds = [{ cell = [1], sites = [1, 2], exchange = "1 meV" }]', "from 1 to 1"),
    ('vectors = [[1]]\ncells = [4]\nbonds = [{ cell = [1], exchange = "1 m" }]', "1 meV"),
    (CHAIN + "\nrandom = true\ndisorder = 0.1", "random: goes without"),
    (CHAIN + '\ntemperature = "10 K"', "temperature: needs damping"),
    (CHAIN + '\ndipolar = "0.1 meV"', "dipolar: needs periodic = false"),
    (CHAIN + "\ndirections = [[0, 0, 1], [0, 0, -1]]", "one for each of 1 sites; got 2"),
])  # fmt: skip
def test_what_is_refused(spec, system, words):
    with pytest.raises(InvalidInput, match=re.escape(words)):
        spec(system)
