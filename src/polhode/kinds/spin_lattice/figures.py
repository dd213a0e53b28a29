"""The figures of spins on a lattice."""

from polhode.kinds.spin_lattice.energy_figure import draw_energy
from polhode.kinds.spin_lattice.spins_figure import draw_spins
from polhode.kinds.spin_lattice.waves_figure import draw_waves

FIGURES = {"spins": draw_spins, "energy": draw_energy, "waves": draw_waves}
