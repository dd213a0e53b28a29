"""A molecule's levels and lines, and its levels as polhodes."""

from polhode.spectra.figures.energy_surface_figure import energy_surface
from polhode.spectra.figures.level_diagram_figure import level_diagram
from polhode.spectra.figures.quantum_sphere_figure import quantum_sphere
from polhode.spectra.figures.racket_figure import racket_flip
from polhode.spectra.figures.spectrum_figure import spectrum
from polhode.spectra.figures.wigner_figure import LIMITS, level_wigner, racket_wigner

FIGURES = {
    "levels": lambda report: level_diagram(report.rotor, report.J),
    "spectrum": lambda report: None if report.lines is None else spectrum(report.lines),
    "energy_surface": lambda report: None if report.polhodes is None else energy_surface(report.rotor, report.J),
    "momentum_sphere": lambda report: None if report.polhodes is None else quantum_sphere(report.rotor, report.J),
    "racket": lambda report: None if report.racket is None else racket_flip(report.racket),
    "wigner": lambda report: None if report.polhodes is None or report.J > LIMITS.max_j else level_wigner(
        report.rotor, report.J),
    "racket_wigner": lambda report: None if report.racket is None or report.J > LIMITS.max_j else racket_wigner(
        report.racket),
}  # fmt: skip
