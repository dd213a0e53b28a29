"""Constants of molecules, MHz, as their sources give them, and the test rotor W."""

import numpy as np

from polhode.spectra import DEBYE, Rotor

MHZ = 1e6
WAVE_NUMBER = 29979.2458 * MHZ  # Hz of 1 cm⁻¹


def rotor(constants, distortion=None, *more, **options):
    scaled = {name: value * MHZ for name, value in (distortion or {}).items()}
    return Rotor(np.multiply(constants, MHZ), scaled, *more, **options)


W = Rotor((27.0, 14.0, 9.0), dipole=(0.0, 1.0, 0.0))
WATER = rotor(
    (835840.288, 435351.717, 278138.700),
    {"Delta_J": 37.59422, "Delta_JK": -172.9128, "Delta_K": 973.29052, "delta_J": 15.210402, "delta_K": 41.0502},
    "A", "Ir", dipole=(0.0, 1.857 * DEBYE, 0.0), spin_weights=(1, 3),
)  # fmt: skip
SULFUR_DIOXIDE = rotor(
    (60778.5522, 10318.0722, 8799.7023),
    {"Delta_J": 0.0066610013, "Delta_JK": -0.1169588, "Delta_K": 2.5904328, "delta_J": 0.001701045,
     "delta_K": 0.0253531}, "A", "Ir", dipole=(0.0, 1.633189 * DEBYE, 0.0), spin_weights=(1, 0),
)  # fmt: skip
FORMALDEHYDE = rotor(
    (281970.5780043, 38833.98693032, 34004.24350798),
    {"D_J": 0.07031916985, "D_JK": 1.320969223658, "D_K": 19.39707741178, "d1": -0.01043742519, "d2": -0.002501480214,
     "H_J": -1.4766e-9, "H_JK": 7.120087e-6, "H_KJ": 8.212112e-6, "H_K": 4.319039576e-3, "h1": 3.080347e-8,
     "h2": 4.810725e-8, "h3": 1.591045e-8, "L_JJK": -1.3271e-10, "L_JK": 5.811998e-9},
    "S", "Ir", dipole=(2.331 * DEBYE, 0.0, 0.0), spin_weights=(1, 3), spin_axis="a",
)  # fmt: skip
