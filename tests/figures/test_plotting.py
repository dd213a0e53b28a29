"""Pictures from Python: of motions and trajectories, on axes of one's own, in notebooks."""

from dataclasses import replace
from inspect import isabstract

import numpy as np
import pytest
from matplotlib.figure import Figure

import polhode as ph
from polhode.errors import InvalidInput
from polhode.kinds import registry
from polhode.kinds.plotting import plot
from polhode.viewer.panels import keeps_motion_of
from registered import public_classes

FREE = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5))
TOP = ph.LagrangeMotion((1.0, 1.0, 2.0), mgl=3.0, momentum=(1.0, 0.0, 6.0))
TIMES = np.linspace(0.0, 3.0, 40)


def labels(figure):
    return [axes.get_ylabel() for axes in figure.axes], [axes.get_title() for axes in figure.axes]


@pytest.mark.long_cases("moved1")
@pytest.mark.parametrize("moved", [FREE, TOP, FREE.sample(TIMES), TOP.sample(TIMES)])
def test_a_motion_plots_what_its_kind_has_for_it(moved):
    ylabels, titles = labels(moved.plot())
    assert len(ylabels) == 3
    free = moved is FREE or getattr(moved, "motion", None) is FREE
    assert titles[0].startswith("Momentum sphere" if free else "Path of the axis")
    assert ylabels[1].startswith("Ω" if free else "tilt")


class ToldApart(ph.systems.HeavyTop):
    """A top of one's own, such as one that knows where it stands."""


def sources():
    """Return all systems and motions that name a kind."""
    found = [ph.FreeMotion, ph.LagrangeMotion]
    systems = sorted(public_classes(ph.systems, ph.systems.AbstractSystem), key=lambda one: one.__name__)
    found += [one for one in systems if isinstance(one, type) and "kind" in vars(one) and not isabstract(one)]
    return found


def test_every_kind_that_moves_is_named_by_a_system_or_motion():
    named = {one.kind for one in sources()}
    kinds = [registry.find_kind(name) for name in registry.kind_names()]
    moving = {kind.name for kind in kinds if kind.has_motion and type(kind).__module__.startswith("polhode.")}
    assert named == moving


@pytest.mark.parametrize("base", sources(), ids=lambda one: one.__name__)
def test_an_heir_of_what_a_kind_draws_is_drawn_as_that_kind(base):
    heir = type("Heir", (base,), {})
    for one in (base, heir, type("Heir", (heir,), {})):
        kind = registry.kind_of_source(object.__new__(one))
        assert kind is not None and kind is registry.find_kind(base.kind)
    same, other = object.__new__(heir), object.__new__(type("Other", (base,), {"vector_field": None, "state": None}))
    assert keeps_motion_of((base,), same)
    assert not keeps_motion_of((base,), other)  # its page shows samples: the equations may be others


@pytest.mark.long
def test_an_heir_of_a_heavy_top_has_its_pictures():
    given = (1.0, 1.0, 2.0), 3.0, (0.0, 0.0, 1.0)
    start = [1.0, 0.0, 0.0, 0.0, 0.1, 0.2, 5.0, 0.0, 0.0, 1.0]
    moved = ph.simulate(ph.systems.HeavyTop(*given), start, TIMES, estimate_error=False)
    drawn, titles = labels(replace(moved, source=ToldApart(*given)).plot())
    assert (drawn, titles) == labels(moved.plot()) and titles[0].startswith("Path of the axis")


def test_what_no_kind_draws_is_drawn_part_by_part():
    system = ph.systems.FreeRigidBody((1.0, 2.0, 3.0))
    trajectory = ph.simulate(system, FREE.momentum(0.0), TIMES)
    figure = trajectory.plot()
    assert labels(figure)[0] == ["momentum\n[kg m²/s, body]"]
    drawn = np.array([line.get_ydata() for line in figure.axes[0].lines])
    assert drawn == pytest.approx(FREE.momentum(TIMES).T, abs=1e-6)
    assert drawn != pytest.approx(FREE.momentum(TIMES + 0.1).T, abs=1e-6)


@pytest.mark.long_after(3)
@pytest.mark.parametrize(
    ("draw", "moved", "count"),
    [(ph.figures.momentum_sphere, FREE, 1), (ph.figures.inertia_ellipsoid, FREE, 1), (ph.figures.herpolhode, FREE, 1),
     (ph.figures.components, FREE, 2), (ph.figures.axis_locus, TOP, 1), (ph.figures.spinning_top, TOP, 1),
     (ph.figures.top_motion, TOP, 2), (ph.figures.parts, FREE.sample(TIMES), 2)],
)  # fmt: skip
def test_every_figure_is_drawn_on_given_axes(draw, moved, count):
    figure = Figure(figsize=(6, 3))
    panels = list(figure.subplots(1, 3)[:count])
    drawn = draw(moved, axes=panels if count > 1 else panels[0])
    assert drawn is figure and all(axes.has_data() for axes in panels) and not figure.legends
    empty = [axes for axes in figure.axes if axes not in panels]
    assert len(empty) == 3 - count and not any(axes.has_data() for axes in empty)
    with pytest.raises(InvalidInput, match="`axes` must be"):
        draw(moved, axes=3)
    with pytest.raises(InvalidInput, match="`axes` must be"):
        draw(moved, axes=[*panels, panels[0]])


@pytest.mark.long
def test_a_top_of_unknown_shape_says_so():
    assert "shape is not known" in ph.figures.spinning_top(TOP).axes[0].get_title()
    assert ph.figures.spinning_top(ph.LagrangeMotion((1.0, 1.0, 2.0), mgl=0.0, momentum=(1.0, 0.0, 6.0))) is None


def test_notebooks_show_a_figure_without_pyplot():
    assert FREE.plot()._repr_png_()[:8] == b"\x89PNG\r\n\x1a\n"
    assert isinstance(FREE.plot(), Figure)


@pytest.mark.long
@pytest.mark.usefixtures("any_type")
def test_what_cannot_be_drawn_is_refused_in_words():
    several = ph.FreeMotion((1.0, 2.0, 3.0), momentum=np.ones((2, 3)))
    with pytest.raises(InvalidInput, match="of one body"):
        several.plot()
    with pytest.raises(InvalidInput, match="batch of shape"):
        several.sample(TIMES).plot()
    for draw, moved in ((ph.figures.momentum_sphere, TOP), (ph.figures.axis_locus, FREE), (ph.figures.parts, FREE),
                        (ph.spacecraft.comparison, FREE), (plot, "motion.nc"),
                        (ph.figures.axis_locus, FREE.sample(TIMES))):  # fmt: skip
        with pytest.raises(InvalidInput, match=r"must be|the figure is of"):
            draw(moved)
    with pytest.raises(InvalidInput, match="`motion` must be a FreeMotion"):
        ph.analysis.racket_twist(TOP)
    assert ph.analysis.racket_twist(FREE.sample(TIMES)) == ph.analysis.racket_twist(FREE)
