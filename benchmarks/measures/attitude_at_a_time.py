"""The attitude of a free body at one time, early and late"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from measure import Row, compared, missing
from scipy.integrate import solve_ivp

import polhode as ph

BODY = "moments 1, 2, 3"  # of the table of hard motions, whose states are exact to 17 digits
TOLERANCE = 1e-12
STEP = 0.01  # s of MuJoCo


def rows(quick: bool) -> Iterator[Row]:
    """Yield ours against each peer at every time that it can reach."""
    (motion,) = (m for m in ph.judging.reference_motions(kind="free body") if m.name == BODY)
    late = 1e3 if quick else 2e5
    chosen = [k for k, t in enumerate(motion.times) if t > 100.0]
    for k in chosen:
        t, exact = float(motion.times[k]), motion.attitudes[k]
        body = ph.FreeMotion(motion.moments, momentum=motion.momentum, attitude=motion.attitude)
        ours, error = (lambda t=t, body=body: body.state(t)), angle(body.attitude(t), exact)
        work = f"t = {t:.4g} (units of I/L)"
        yield from _orekit(work, motion, t, exact, ours, error, quick)
        if t < late:
            for peer in (_dop853, _dopri8, _mujoco):
                yield from peer(work, motion, t, exact, ours, error, quick)


def angle(attitude: Any, exact: Any) -> float:
    return float(ph.rotation.angle_between(np.asarray(attitude) / np.linalg.norm(attitude), exact))


def field(moments: Any, xp: Any) -> Any:
    def slope(t: float, y: Any, args: Any = None) -> Any:
        (w, x, y_, z), L = (y[0], y[1], y[2], y[3]), y[4:]
        a, b, c = 0.5 * L / moments
        turn = [-x * a - y_ * b - z * c, w * a + y_ * c - z * b, w * b + z * a - x * c, w * c + x * b - y_ * a]
        return xp.concatenate([xp.stack(turn), xp.cross(L, L / moments)])

    return slope


def _dop853(work: str, motion: Any, t: float, exact: Any, ours: Any, error: float, quick: bool) -> Iterator[Row]:
    start, slope = np.concatenate([motion.attitude, motion.momentum]), field(motion.moments, np)

    def solved(end: float = t) -> Any:
        return solve_ivp(slope, (0.0, end), start, "DOP853", rtol=TOLERANCE, atol=1e-14).y[:, -1]

    if t > 1e3:
        part = 1e3
        ratio, spread = compared(ours, lambda: solved(part), 3, (1.0, part / t))
        yield Row(work, "SciPy DOP853, 1e-12", error, None, ratio, spread, "time from the first thousand")
        return
    ratio, spread = compared(ours, solved, 1 if quick else 3)
    yield Row(work, "SciPy DOP853, 1e-12", error, angle(solved()[:4], exact), ratio, spread)


def _dopri8(work: str, motion: Any, t: float, exact: Any, ours: Any, error: float, quick: bool) -> Iterator[Row]:
    import diffrax
    import jax
    import jax.numpy as jnp

    slope, start = field(jnp.asarray(motion.moments), jnp), jnp.concatenate([motion.attitude, motion.momentum])

    @jax.jit
    def solved(end: Any) -> Any:
        return diffrax.diffeqsolve(
            diffrax.ODETerm(slope), diffrax.Dopri8(), 0.0, end, 0.01, start, max_steps=100_000_000,
            stepsize_controller=diffrax.PIDController(rtol=TOLERANCE, atol=1e-14), adjoint=diffrax.ForwardMode(),
        ).ys[-1]  # fmt: skip

    ratio, spread = compared(ours, lambda: solved(t).block_until_ready(), 1 if quick else 3)
    yield Row(work, "diffrax Dopri8, 1e-12", error, angle(np.asarray(solved(t))[:4], exact), ratio, spread)


def _mujoco(work: str, motion: Any, t: float, exact: Any, ours: Any, error: float, quick: bool) -> Iterator[Row]:
    peer = f"MuJoCo RK4, step {STEP:g}"
    try:
        import mujoco
    except ImportError:
        yield missing(work, peer, "pip install mujoco")
        return
    steps = round(t / STEP)
    inertia = " ".join(f"{x:.17g}" for x in motion.moments)
    model = mujoco.MjModel.from_xml_string(
        f'<mujoco><option integrator="RK4" timestep="{t / steps:.17g}" gravity="0 0 0"/><worldbody><body>'
        f'<joint type="ball"/><inertial pos="0 0 0" mass="1" diaginertia="{inertia}"/></body></worldbody></mujoco>'
    )
    data = mujoco.MjData(model)

    def solved(count: int = steps) -> Any:
        mujoco.mj_resetData(model, data)
        data.qpos[:], data.qvel[:] = motion.attitude, motion.momentum / motion.moments
        mujoco.mj_step(model, data, nstep=count)
        return data.qpos.copy()

    part = min(steps, 100_000)
    ratio, spread = compared(ours, lambda: solved(part), 3, (1.0, part / steps))
    yield Row(work, peer, error, angle(solved(), exact), ratio, spread)


def _orekit(work: str, motion: Any, t: float, exact: Any, ours: Any, error: float, quick: bool) -> Iterator[Row]:
    remedy = "pip install orekit-jpype, and Java"
    try:
        import jpype
        import orekit_jpype
    except ImportError:
        yield missing(work, "Orekit TorqueFree", remedy)
        return
    try:
        jpype.getDefaultJVMPath()
    except jpype.JVMNotFoundException:
        yield missing(work, "Orekit TorqueFree", remedy)
        return
    orekit_jpype.initVM()
    from org.hipparchus.geometry.euclidean.threed import Rotation, Vector3D
    from org.orekit.attitudes import Attitude, Inertia, InertiaAxis, TorqueFree
    from org.orekit.frames import FramesFactory
    from org.orekit.time import AbsoluteDate
    from org.orekit.utils import PVCoordinatesProvider

    frame, epoch = FramesFactory.getGCRF(), AbsoluteDate.ARBITRARY_EPOCH
    axes = (Vector3D.PLUS_I, Vector3D.PLUS_J, Vector3D.PLUS_K)
    inertia = Inertia(*(InertiaAxis(float(i), axis) for i, axis in zip(motion.moments, axes, strict=True)))
    velocity = Vector3D(*(motion.momentum / motion.moments).tolist())
    model = TorqueFree(Attitude(epoch, frame, Rotation.IDENTITY, velocity, Vector3D.ZERO), inertia)
    provider = jpype.JProxy(PVCoordinatesProvider, dict={"getPVCoordinates": lambda *_: None})
    date = epoch.shiftedBy(t)
    found = model.getAttitude(provider, date, frame).getRotation()
    # Orekit turns the reference frame into the body's; the start is the identity here, and the table's is applied after
    turn = np.array([found.getQ0(), -found.getQ1(), -found.getQ2(), -found.getQ3()])
    off = min(angle(ph.rotation.multiply(motion.attitude, q), exact) for q in (turn, turn * [1, -1, -1, -1]))
    ratio, spread = compared(ours, lambda: model.getAttitude(provider, date, frame), 9 if quick else 51)
    yield Row(work, "Orekit TorqueFree", error, off, ratio, spread, "one state a call, Orekit's through Java's bridge")
