"""The figures of a free body."""

from polhode.figures.components import draw_components
from polhode.figures.herpolhode import draw_herpolhode
from polhode.figures.inertia_ellipsoid import draw_inertia_ellipsoid
from polhode.figures.momentum_sphere import draw_momentum_sphere

FIGURES = {
    "momentum_sphere": lambda report: draw_momentum_sphere(report.trajectory),
    "inertia_ellipsoid": lambda report: draw_inertia_ellipsoid(report.trajectory),
    "components": lambda report: draw_components(report.trajectory),
    "herpolhode": lambda report: draw_herpolhode(report.trajectory),
}
