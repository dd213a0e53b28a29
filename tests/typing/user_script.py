"""What a user writes in the first week; type checkers in strict mode know every type in it."""

from pathlib import Path
from typing import Any, assert_type

import jax
import numpy as np
from matplotlib.figure import Figure

import polhode as ph
from polhode.integrators import LieMidpoint
from polhode.motion import Trajectory
from polhode.viewer.page import NotebookPage

Array = np.ndarray[Any, Any] | jax.Array
times = np.linspace(0.0, 10.0, 1001)

# a free body
motion = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5))
attitude, momentum = motion.state(1e9)
assert_type(attitude, Array)
assert_type(momentum, Array)
assert_type(momentum.shape, Any | tuple[int, ...])
speed = float(np.linalg.norm(motion.angular_velocity(1.0)))
assert_type(motion.energy, float)  # of one body; the period is None where none is defined
assert_type(motion.period, float | None)
assert_type(motion.along("given").tumbling_periods, tuple[float | None, float | None])
assert_type(motion.regime, str | Array)
assert_type(motion.encircled_axis, int | Array | None)
if motion.period is not None:
    print(f"{motion.period:.3f} s", round(motion.energy, 3))
many = ph.FreeMotion((1.0, 2.0, 3.0), momentum=np.ones((5, 3)))
assert_type(many.energy, float | Array)
assert_type(many.period, float | Array | None)
assert_type(ph.FreeMotion((1.0, 2.0, 3.0), momentum=[[0.3, 1.8, 1.5]]).energy, float | Array)


def turns(motion: ph.FreeMotion) -> None:
    """What takes any motion takes one body's, and says nothing of the rest."""
    assert_type(motion.period, float | Array | None)


turns(motion)
trajectory = motion.sample(times)
assert_type(trajectory, Trajectory)
assert_type(trajectory.times, Array)
assert_type(trajectory.times.shape, Any | tuple[int, ...])
assert_type(trajectory.outcome.event, str | None)
assert_type(len(trajectory), int)
turned = 2.0 * trajectory.times[1:] - trajectory.times[0]
if trajectory.momentum is not None:
    assert_type(trajectory.momentum.ndim, int)
assert_type(motion.plot(), Figure)
assert_type(trajectory.plot(), Figure)
assert_type(motion.show(height=400), NotebookPage)
assert_type(trajectory.save("motion.nc"), Path)

# bodies
corners = np.array([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)])
body = ph.Body.from_mesh(corners, [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]], density=6.0)
assert_type(body, ph.Body)
assert_type(body.mass, float | None)
assert_type(body.principal_moments, Array)
assert_type(body.moments, Array)
both = ph.combine([body, ph.shapes.box(1.0, (0.1, 0.2, 0.3))])
assert_type(ph.FreeMotion.from_body(both, angular_velocity=(0.0, 1.0, 0.01)), ph.FreeMotion[float])
assert_type(ph.FreeMotion.from_body(both, angular_velocity=np.ones((5, 3))), ph.FreeMotion)

# a top
top = ph.LagrangeMotion(moments=(1.0, 1.0, 0.5), mgl=1.0, momentum=(0.0, 0.0, 2.5), attitude=(0.75**0.5, 0.5, 0.0, 0.0))
assert_type(top.rotation_matrix(times), Array)
assert_type(top.energy, float)
assert_type(top.nutation_limits, tuple[float | None, float | None])
assert_type(top.nutation_period, float | None)
assert_type(ph.LagrangeMotion((1.0, 1.0, 0.5), mgl=np.ones(4), momentum=(0.0, 0.0, 2.5)).energy, float | Array)
on_its_point = ph.LagrangeMotion.from_body(ph.shapes.cone(0.1, 0.03, 0.05), pivot=(0.0, 0.0, 0.03), momentum=(0, 0, 1))
assert_type(on_its_point.precession_per_period, float | None)
assert_type(top.regime, str | Array)

# a system
system = ph.systems.FreeRigidBody((1.0, 2.0, 3.0))
followed = ph.simulate(system, [0.3, 1.8, 1.5], times, LieMidpoint, step=0.01)
assert_type(followed, Trajectory)
assert_type(followed.invariants["energy"], Array)
solution = ph.solve(system, [0.3, 1.8, 1.5], times)
assert_type(solution.end_state, Array)
verdict = ph.stability(system, [0.0, 1.0, 0.0])
assert_type(verdict.rate, float)
assert_type(ph.find_equilibria(system, [0.3, 1.8, 1.5]), Array)

# a spec
report = ph.report("examples/t_handle.toml")
assert_type(report.summary, str)
assert_type(report.values(), dict[str, Any])
if report.trajectory is not None:
    assert_type(report.trajectory.times.shape, Any | tuple[int, ...])
assert_type(report.plot(), dict[str, Figure])
assert_type(report.save("motion.nc"), Path)
assert_type(report.show(), NotebookPage)
assert_type(ph.write_page(motion, "motion.html"), Path)
ph.figures.save(motion.plot(), "motion.png")

# measurements
found = ph.fit("one.csv", "other.csv", drag=True)
print(found.summary, found.json(), found.fit)
difference = ph.compare("one.nc", "other.nc")
print(difference.summary)
print(ph.tumble("apophis").values())
print(ph.levels("water.xyz").summary, ph.spectrum("water.xyz").summary, ph.wobble("eopc04.txt").summary)
