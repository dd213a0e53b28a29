"""Verdicts of ``polhode.judging.judge`` on MuJoCo's integrators, with pictures for docs/for_engine_authors.md.

``python benchmarks/judge_engines.py`` needs mujoco (extra bench). It prints the verdicts and writes
docs/images/judged_mujoco_*.png.
"""

from __future__ import annotations

import logging
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

from polhode.judging import judge

IMAGES = Path(__file__).parents[1] / "docs" / "images"
INTEGRATORS = ("Euler", "implicitfast", "implicit", "RK4")
DRAWN = ("Euler", "RK4")
STEP = 0.05  # s, which is rad here


def mujoco_step(integrator: str, moments: tuple[float, ...] = (1.0, 2.0, 3.0)) -> Callable[..., Any]:
    """Return a step of MuJoCo for one free body on a ball joint, whose rate is ω along body axes."""
    import mujoco

    model = mujoco.MjModel.from_xml_string(
        f'<mujoco><option integrator="{integrator}" gravity="0 0 0"/><worldbody><body><joint type="ball"/>'
        f'<inertial pos="0 0 0" mass="1" diaginertia="{" ".join(map(str, moments))}"/></body></worldbody></mujoco>'
    )
    data = mujoco.MjData(model)

    def step(q: Any, w: Any, dt: float) -> Any:
        model.opt.timestep, data.time = dt, 1.0
        data.qpos[:], data.qvel[:] = q, w
        mujoco.mj_step(model, data)
        if data.time < 1.0:
            raise OverflowError("MuJoCo has set back a state that left its range")
        return data.qpos.copy(), data.qvel.copy()

    return step


JOINTS = {
    "ball joint, without torque": ('<joint type="ball"/>', 0.0),
    "ball joint, under its weight": ('<joint type="ball"/>', 9.81),
    "two hinges, under their weight": ('<joint axis="1 0 0"/><joint axis="0 1 0"/>', 9.81),
}


def orders(joints: str, gravity: float, steps: tuple[float, ...] = (0.01, 0.005)) -> list[float]:
    """Return RK4's orders in energy, position and velocity after 1 s, against steps of 50 µs."""
    import mujoco
    import numpy as np

    def run(dt: float) -> list[Any]:
        model = mujoco.MjModel.from_xml_string(
            f'<mujoco><option integrator="RK4" gravity="0 0 {-gravity}"><flag energy="enable"/></option><worldbody>'
            f'<body>{joints}<inertial pos="0 0.1 0.3" mass="1" diaginertia="0.1 0.2 0.25"/></body></worldbody></mujoco>'
        )
        data = mujoco.MjData(model)
        model.opt.timestep = dt
        data.qpos[:] = (0.8, 0.6, 0.0, 0.0) if model.nq == 4 else 0.5
        data.qvel[:] = (1.0, 2.0, 5.0) if model.nv == 3 else 1.0
        for _ in range(round(1.0 / dt)):
            mujoco.mj_step(model, data)
        mujoco.mj_forward(model, data)
        return [data.energy.sum(), data.qpos.copy(), data.qvel.copy()]

    exact, *found = (run(dt) for dt in (5e-5, *steps))
    long, short = ([float(np.linalg.norm(one - true)) for one, true in zip(run, exact, strict=True)] for run in found)
    return [float(np.log2(a / b)) for a, b in zip(long, short, strict=True)]


def main() -> None:
    """Print the verdicts and write the pictures."""
    import mujoco

    for name, given in JOINTS.items():
        print(name, ", ".join(f"{order:.2f}" for order in orders(*given)))

    for integrator in INTEGRATORS:
        name = f"MuJoCo {mujoco.__version__}, {integrator}"
        report = judge(mujoco_step(integrator), STEP, variable="angular velocity", name=name)
        print(f"{name}: {report.summary}\n")
        if integrator in DRAWN:
            with tempfile.TemporaryDirectory() as folder:
                (drawn,) = report.draw(folder)
                (IMAGES / f"judged_mujoco_{integrator.lower()}.png").write_bytes(drawn.read_bytes())


if __name__ == "__main__":
    logging.disable()
    main()
