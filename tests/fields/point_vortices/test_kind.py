"""Reports on point vortices: numbers in closed form, words, figures, and what is refused."""

import json
import math
from dataclasses import replace

import numpy as np
import pytest

from polhode.errors import InvalidInput
from polhode.kinds.reading import read_spec

SHORT = '[time]\nuntil = "1 s"\nsamples = 20\n'


@pytest.fixture
def spec(tmp_path):
    def make(system, time=SHORT):
        path = tmp_path / "case.toml"
        path.write_text(f'[system]\nkind = "point-vortices"\n{system}\n{time}', "utf-8")
        return read_spec(path)

    return make


def strengths(*values):
    return "strengths = " + json.dumps([f"{x} m^2/s" for x in values])


@pytest.mark.sweep
def test_a_ring_on_a_sphere_of_any_size(spec):
    """Γ(n − 1) cos θ/(4π R² sin² θ), and its growth from the closed form of Boatto and Cabral."""
    result = spec(strengths(8, 8, 8, 8, 8) + '\nring_latitude = "32.7042204869 deg"\nsphere_radius = "2 m"').report()
    values = result.as_json_dict()
    angle = math.radians(90.0 - 32.7042204869)
    assert values["turn"]["rate"] == pytest.approx(2.0 * math.cos(angle) / (math.pi * math.sin(angle) ** 2), rel=1e-12)
    assert values["stability"]["verdict"] == "unstable"
    assert values["stability"]["rate"] == pytest.approx(2.0 * 0.2511457117, rel=1e-8)
    assert values["moment_of_vorticity"][2] == pytest.approx(5 * 8 * 2 * math.cos(angle), rel=1e-12)
    assert f"double in {math.log(2.0) / 0.5022914234:.4g} s" in result.summary
    assert values["closest"]["distance"] == pytest.approx(4.0 * math.sin(angle) * math.sin(math.pi / 5.0), rel=1e-9)


@pytest.mark.long
def test_a_pair_goes_round_its_centre(spec):
    rotated = '\npositions = [["3 m", "0.5 m"], ["4 m", "-0.5 m"]]'
    result = spec(strengths(1, 2) + rotated).report()
    values = result.as_json_dict()
    assert values["turn"]["rate"] == pytest.approx(3.0 / (4.0 * math.pi), rel=1e-12)
    np.testing.assert_allclose(values["center_of_vorticity"], [11 / 3, -1 / 6], rtol=1e-12)
    np.testing.assert_allclose(values["turn"]["center"], values["center_of_vorticity"], rtol=1e-12)
    assert "proved stable" in result.summary


@pytest.mark.long
def test_opposite_vortices_move_straight(spec):
    result = spec(strengths(3, -3) + '\npositions = [["0 m", "1 m"], ["0 m", "-1 m"]]').report()
    values = result.as_json_dict()
    np.testing.assert_allclose(values["turn"]["velocity"], [3.0 / (4.0 * math.pi), 0.0], atol=1e-15)
    assert values["center_of_vorticity"] is None and "move straight" in result.summary
    np.testing.assert_allclose(result.positions[-1, 0], [3.0 / (4.0 * math.pi), 1.0], atol=1e-12)


@pytest.mark.long
@pytest.mark.parametrize(("middle", "verdict"), [(0.4, "unstable"), (0.6, "stable")])
def test_eight_need_half_a_ninth(spec, middle, verdict):
    """(n² − 8n + 8)/16 is 1/2 for n = 8: Cabral & Schmidt, SIAM J. Math. Anal. 31 (2000) 231."""
    angles = np.arange(8) * math.pi / 4.0
    places = [[f"{x:.17g} m", f"{y:.17g} m"] for x, y in [(0, 0), *zip(np.cos(angles), np.sin(angles), strict=True)]]
    result = spec(strengths(middle, *[1] * 8) + f"\npositions = {json.dumps(places)}").report()
    assert result.verdict.verdict == verdict


@pytest.mark.long
def test_figures_of_each_surface(spec, tmp_path):
    for k, places in enumerate(('ring_radius = "1 m"', 'coordinates = [["80 deg", "0 deg"], ["-60 deg", "45 deg"]]')):
        (tmp_path / str(k)).mkdir()
        drawn = spec(f"{strengths(1, -2)}\n{places}").report().draw(tmp_path / str(k))
        assert [path.stem for path in drawn] == ["tracks", "streamlines"]


@pytest.mark.parametrize(("system", "words"), [
    (strengths(1, 1), "needs exactly one of positions, ring_radius, coordinates and ring_latitude"),
    (strengths(1, 1) + '\nring_radius = "1 m"\nring_latitude = "5 deg"', "got ring_radius and ring_latitude"),
    (strengths(1, 1) + '\nring_radius = "1 m"\nsphere_radius = "2 m"', "sphere_radius: goes with coordinates or"),
    (strengths(1, 1) + '\npositions = [["0 m", "0 m"]]', "got 1 for the 2 strengths"),
    (strengths(1, 0) + '\nring_radius = "1 m"', "must not be zero"),
    (strengths(1) + '\nring_radius = "1 m"', "strengths"),
    (strengths(1, 1) + '\npositions = [["0 m"], ["1 m", "2 m"]]', "positions"),
])  # fmt: skip
def test_what_is_refused(spec, system, words):
    with pytest.raises(InvalidInput, match=words):
        spec(system)


@pytest.mark.sweep
def test_poles_and_the_equator_rest(spec):
    """What rounding leaves of their turn is none, and both are proved stable."""
    for places in ('ring_latitude = "0 deg"', 'coordinates = [["90 deg", "0 deg"], ["-90 deg", "0 deg"]]'):
        strong = strengths(1, 1) if "coordinates" in places else strengths(1, 1, 1)
        result = spec(f"{strong}\n{places}").report()
        assert result.turn.rate == 0.0 and result.summary.endswith("rest, which is proved stable.")


@pytest.mark.long
def test_a_report_without_a_verdict(spec):
    read = spec(strengths(1e-90, 1) + '\nring_radius = "1 m"', '[time]\nuntil = "1 s"\nsamples = 3\n')
    tiny = read.system.model_copy(update={"strengths": [1e-200, 1.0]})  # weaker than a spec may say
    result = replace(read, system=tiny).report()
    assert result.turn is not None and result.verdict is None and any("no verdict" in note for note in result.notes)


def test_two_at_one_place(spec):
    with pytest.raises(InvalidInput, match="at one"):
        spec(strengths(1, 1) + '\npositions = [["0 m", "0 m"], ["0 m", "0 m"]]').report()
