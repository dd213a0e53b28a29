"""Wigner functions of levels and of a racket, as they are drawn."""

import numpy as np
import pytest

import polhode as ph
from polhode.errors import InvalidInput
from polhode.spectra import Racket, coherent_state, level_wigner, racket_wigner, symbol
from polhode.spectra.figures.wigner_figure import _on_pixels, wigner_on_side

W = (27.0, 14.0, 9.0)


def test_a_hemisphere_has_the_values_of_the_symbol():
    """Against `symbol` at single directions, of a state without symmetries; both sides together integrate to one."""
    J, state = 3, coherent_state(3, (0.3, -0.5, 0.8)) + 0.4j * coherent_state(3, (1.0, 0.2, -0.1))
    state = state / np.linalg.norm(state)
    total = 0.0
    for side in (1.0, -1.0):
        values = wigner_on_side(state, side, J)
        polar, azimuth = (np.linspace(0.0, end, n) for end, n in zip((np.pi / 2, 2 * np.pi), values.shape, strict=True))
        for i, k in ((0, 0), (11, 40), (30, 150), (47, 77)):
            along = np.sin(polar[i]) * np.array([np.cos(azimuth[k]), np.sin(azimuth[k])])
            expected = symbol(np.outer(state, state.conj()), (*along, side * np.cos(polar[i]))).real
            assert values[i, k] == pytest.approx(expected, abs=1e-12)
        total += np.trapezoid(np.trapezoid(values, azimuth, axis=1) * np.sin(polar), polar)
    assert total * (2 * J + 1) / (4.0 * np.pi) == pytest.approx(1.0, abs=2e-4)


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_pixels_of_the_map_have_the_values_of_the_symbol(side):
    """Against `symbol` in the direction of the pixel by Lambert's map, c across (reversed below), a up, b out."""
    J, state = 3, coherent_state(3, (0.3, -0.5, 0.8)) + 0.4j * coherent_state(3, (1.0, 0.2, -0.1))
    state = state / np.linalg.norm(state)
    pixels = _on_pixels(wigner_on_side(state, side, J), side)
    n = len(pixels)
    for i, k in ((n // 2, n // 3), (n // 3, n // 2), (n // 5, 2 * n // 3), (3 * n // 5, n - 5)):
        x, y = np.sqrt(2.0) * (2.0 * np.array([k, i]) + 1.0 - n) / n
        out2 = x * x + y * y
        shrink = np.sqrt(1.0 - 0.25 * out2)
        where = side * x * shrink, y * shrink, side * (1.0 - 0.5 * out2)
        assert pixels[i, k] == pytest.approx(symbol(np.outer(state, state.conj()), where).real, abs=2e-3)


def test_levels_stand_on_their_polhodes():
    """The lowest level is about c, the highest about a, and the curve is that of the energy."""
    figure = level_wigner(ph.spectra.Rotor(W), 6)
    names = [panel.get_title() for panel in figure.axes]
    assert names[0] == "$6_{0,6}$" and names[-1] == "$6_{6,0}$"
    for panel, above in ((figure.axes[0], False), (figure.axes[-1], True)):
        drawn = panel.images[0].get_array()
        largest = np.array(np.unravel_index(np.argmax(drawn), drawn.shape)) - 0.5 * (len(drawn) - 1)
        assert np.argmax(np.abs(largest)) == int(not above)  # rows go up, along a; columns to the right, along c
        assert len(panel.collections) == 1


def test_a_racket_goes_to_the_other_side():
    figure = racket_wigner(Racket(W, 8, 0.3))
    whole = [panel.images[0].get_array().max() for panel in figure.axes]
    assert whole[0] > 10.0 * whole[5] and whole[8] > 1.5 * whole[3]


def test_what_is_not_drawn():
    with pytest.raises(InvalidInput, match="`J` must be at most 60"):
        level_wigner(ph.spectra.Rotor(W), 61)
    with pytest.raises(InvalidInput, match="three different constants"):
        level_wigner(ph.spectra.Rotor((27.0, 9.0, 9.0)), 3)
