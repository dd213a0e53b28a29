"""Makes phone_throw.csv: a SYNTHETIC log of a phone that is tossed, as phyphox would export it; nothing is measured.

The moments are those of a box of 150 g, 147 × 71 × 7.8 mm; the flight is exact free motion, the gyro has a bias and
noise, and the accelerometer sits off the centre of mass.
"""

from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation

import polhode as ph

RATE, NOISE, FELT_NOISE = 100.0, 2e-3, 0.05  # Hz, rad/s, m/s²
START, END = 1.2, 1.9  # s, free flight
BIAS = np.array([0.02, -0.015, 0.008])  # rad/s
PLACE = np.array([0.02, 0.05, 0.002])  # m, the accelerometer from the centre of mass
SIZE, MASS = np.array([0.071, 0.147, 0.0078]), 0.15  # m along the device's x, y, z; kg
TILT = Rotation.from_rotvec([0.03, -0.02, 0.05])  # of the principal axes: a phone is not a uniform box


def main() -> None:
    """Write the log next to this script."""
    random = np.random.default_rng(20)
    t = np.arange(0.0, 3.0, 1.0 / RATE)
    moments = MASS / 12 * (np.sum(SIZE**2) - SIZE**2)
    motion = ph.FreeMotion(moments, angular_velocity=(9.0, 1.0, 1.2), epoch=START)
    flight = (t >= START) & (t <= END)
    body = motion.angular_velocity(np.clip(t, START, END))
    # in the hand the phone rests, is swung up within 0.2 s, and is caught within 0.2 s
    swing = np.clip(np.minimum((t - START + 0.2) / 0.2, (END + 0.2 - t) / 0.2), 0.0, 1.0)
    rates = TILT.apply(body * (swing**2 * (3 - 2 * swing))[:, None])
    turning = np.gradient(rates, t, axis=0)
    lever = np.cross(rates, np.cross(rates, PLACE)) + np.cross(turning, PLACE)
    held = np.where(flight[:, None], 0.0, [0.0, 0.0, 9.81]) + 6.0 * ((swing > 0) & ~flight)[:, None]
    felt = held + lever + FELT_NOISE * random.normal(size=lever.shape)
    gyro = rates + BIAS + NOISE * random.normal(size=rates.shape)
    names = ["Time (s)", *(f"Gyroscope {x} (rad/s)" for x in "xyz"), *(f"Acceleration {x} (m/s^2)" for x in "xyz")]
    lines = ["# SYNTHETIC, made by phone_throw.py: nothing here was measured", ",".join(f'"{x}"' for x in names)]
    lines += [",".join(f"{x:.6g}" for x in row) for row in np.column_stack([t, gyro, felt])]
    Path(__file__).with_name("phone_throw.csv").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
