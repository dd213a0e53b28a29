"""The structure factor of moving spins by wave vector and frequency, which is what scattering measures."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from polhode._base.arrays import known_numbers_only
from polhode.errors import InvalidInput
from polhode.fields.spin_lattice.lattice import Lattice
from polhode.types import ArrayLike, Float64, Real


class SampleLimits(NamedTuple):
    """What samples of a run must satisfy for a spectrum.

    Attributes:
        max_step_spread: relative to the whole time; steps of time that differ by more are not equal.
    """

    max_step_spread: float = 1e-9


LIMITS = SampleLimits()


@known_numbers_only
def structure_factor(
    lattice: Lattice,
    times: Real[ArrayLike, "time"],
    states: Real[ArrayLike, "..."],
    wave_vectors: Real[ArrayLike, "count e"],
) -> tuple[Float64[np.ndarray, "frequencies"], Float64[np.ndarray, "count frequencies"]]:
    """Return angular frequencies, ascending, and S(q, ω) (count, frequencies), summed over the three components.

    S = |Σ_r ∫ S(r, t) e^{iωt − iq·r} w dt|²/(2π n ∫w² dt) with Hann's window w, n spins: an estimate whose integral
    over ω is the mean of |Σ S e^{−iq·r}|²/n, weighted by w². A spin wave that goes with e^{i(q·r − ωt)} is a line at ω.
    Frequencies are resolved to about 4π/T and cut at π/Δt; on a periodic lattice take q that fit it.

    Args:
        lattice: where the spins are.
        times: (T,) equally spaced.
        states: (T, L1, L2, L3, b, 3).
        wave_vectors: (count, e) q, Cartesian, in radians per unit of length.

    Raises:
        InvalidInput: for times that are not equally spaced, and states of other shapes.

    Source: Van Hove, Phys. Rev. 95 (1954) 249.
    """
    times, states = np.asarray(times, float), np.asarray(states, float)
    if times.ndim != 1 or len(times) < 4 or np.ptp(np.diff(times)) > LIMITS.max_step_spread * np.ptp(times):
        raise InvalidInput("`times` must be at least four equally spaced times.")
    if states.shape != (len(times), *lattice.shape, lattice.sites, 3):
        wanted = (len(times), *lattice.shape, lattice.sites, 3)
        raise InvalidInput(f"`states` must have shape {wanted}, for the times and the lattice; got {states.shape}.")
    q = np.asarray(wave_vectors, float)
    q = np.pad(q, ((0, 0), (0, 3 - q.shape[-1])))
    places = lattice.positions().reshape(-1, 3)
    phases = np.exp(-1j * places @ q.T)
    modes = np.einsum("tni,nq->tqi", states.reshape(len(times), -1, 3), phases, optimize=True)
    step = (times[-1] - times[0]) / (len(times) - 1)
    # Hann's window at the middles of the steps
    window = np.sin(np.pi * (np.arange(len(times)) + 0.5) / len(times)) ** 2
    # NumPy's inverse transform has e^{+iωt}
    lines = np.fft.ifft(modes * window[:, None, None], axis=0) * len(times) * step
    power = np.sum(np.abs(lines) ** 2, axis=-1) / (2.0 * np.pi * len(places) * step * np.sum(window**2))
    frequencies = 2.0 * np.pi * np.fft.fftfreq(len(times), step)
    return np.fft.fftshift(frequencies), np.fft.fftshift(power.T, axes=1)
