"""Verdicts of ``polhode.testing.judge`` on MuJoCo's integrators, with pictures for docs/for_engine_authors.md.

``python benchmarks/judge_engines.py`` needs mujoco (extra bench). It prints the verdicts and writes
docs/images/judged_mujoco_*.png.
"""

from __future__ import annotations

import logging
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

from polhode.testing import judge

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


def main() -> None:
    """Print the verdicts and write the pictures."""
    import mujoco

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
