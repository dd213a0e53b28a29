"""Polar motion as it might be: lines in red noise, or a damped wobble that white excitation keeps going."""

import numpy as np
from scipy.signal import lfilter

DAY, YEAR, MAS = 86400.0, 365.2422 * 86400.0, np.pi / 648e6
PERIOD, AMPLITUDE, ANNUAL = 433.0 * DAY, 120.0 * MAS, 90.0 * MAS
RATE, SEASON = 2 * np.pi / PERIOD, 2 * np.pi / YEAR
STEP = 10.0 * DAY


def white(rng, count):
    return rng.normal(size=count) + 1j * rng.normal(size=count)


def seasons(times):
    return ANNUAL * np.exp(1j * SEASON * times) + 5 * MAS * np.exp(-1j * SEASON * times) + (50 - 300j) * MAS


def red_noise(rng, count, size=20 * MAS, memory=100 * DAY):
    keep = np.exp(-STEP / memory)
    return size * np.sqrt(1 - keep**2) * lfilter([1], [1, -keep], white(rng, count + 300))[300:]


def lines(rng, years=25.0, noise=20 * MAS):
    times = STEP * np.arange(int(years * YEAR / STEP))
    m = seasons(times) + AMPLITUDE * np.exp(1j * (RATE * times + 1.0)) + red_noise(rng, len(times), noise)
    return times, m.real, -m.imag


def kicked(rng, years=64.0, quality=100.0, noise=10 * MAS):
    times = STEP * np.arange(int(years * YEAR / STEP))
    turn = np.exp(1j * RATE * (1 + 0.5j / quality) * STEP)
    before = int(4 * quality * PERIOD / STEP)
    size = AMPLITUDE * np.sqrt(0.5 * (1 - abs(turn) ** 2))
    m = lfilter([1], [1, -turn], size * white(rng, before + len(times)))[before:]
    m = m + seasons(times) + noise * white(rng, len(times))
    return times, m.real, -m.imag
