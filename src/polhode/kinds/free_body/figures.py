"""The figures of a free body."""

from polhode.figures.components_figure import components
from polhode.figures.ellipsoid_figure import inertia_ellipsoid
from polhode.figures.herpolhode_figure import herpolhode
from polhode.figures.sphere_figure import momentum_sphere

FIGURES = {
    "momentum_sphere": lambda report: momentum_sphere(report.trajectory),
    "inertia_ellipsoid": lambda report: inertia_ellipsoid(report.trajectory),
    "components": lambda report: components(report.trajectory),
    "herpolhode": lambda report: herpolhode(report.trajectory),
}

OVERVIEW = ((momentum_sphere, 1), (components, 2))
