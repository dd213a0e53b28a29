"""The figures of spins on a lattice."""

from polhode.fields.spin_lattice.energy_figure import draw_energy
from polhode.fields.spin_lattice.spins_figure import draw_spins
from polhode.fields.spin_lattice.waves_figure import draw_waves

FIGURES = {"spins": draw_spins, "energy": draw_energy, "waves": draw_waves}
