"""Time and error of the free body, beside its peers, in one run: ``python benchmarks/free_body.py``.

Times are medians in units of one ``scipy.special.ellipj`` call a state, measured in the same process on one core.
Errors are angles [rad] against the closed form, which the tests hold to 16 eps of an oracle. Orekit needs
``pip install .[bench]`` and a Java runtime; it is left out, and said so, where they are missing.
"""

from __future__ import annotations

import importlib.util
import os
import time

if hasattr(os, "sched_setaffinity"):
    os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
os.environ.setdefault("XLA_FLAGS", "--xla_cpu_multi_thread_eigen=false")

import numpy as np
from scipy.integrate import solve_ivp
from scipy.special import ellipj

import polhode as ph

COUNT, REPEATS = 100_000, 9
MOMENTS = (1.0, 2.0, 3.0)
BODIES = {
    "short-axis, q small (trigonometric)": (0.3, 0.1, 3.0),
    "short-axis (exponential)": (0.3, 1.8, 1.5),
    "long-axis": (0.9, 1.6, 0.3),
    "next to the separatrix": (1e-6, 2.0, 3e-6),
}


def median(function, repeats: int = REPEATS) -> float:
    """Return the median time of a call [s]."""
    taken = []
    for _ in range(repeats):
        start = time.perf_counter()
        function()
        taken.append(time.perf_counter() - start)
    return float(np.median(taken))


def closed_form(rng: np.random.Generator) -> None:
    times = rng.uniform(0.0, 1e6, COUNT)
    unit = median(lambda: ellipj(times, 0.3)) / COUNT
    host = "Numba" if importlib.util.find_spec("numba") else "NumPy"
    print(f"unit: one ellipj call, {unit * 1e9:.0f} ns\n")
    print("one body at many times, attitude and momentum, per state (target 0.6 NumPy, 0.5 JAX)")
    for name, momentum in BODIES.items():
        motion = ph.FreeMotion(MOMENTS, momentum)
        print(f"  {host}  {name:40}{median(lambda m=motion: m.state(times)) / COUNT / unit:8.2f}")
    moments, momenta = rng.uniform(0.5, 3.0, (COUNT, 3)), rng.normal(size=(COUNT, 3))
    print("many bodies at one time each, set-up included, per body (target 7 NumPy, 3 with Numba)")
    whole = median(lambda: ph.FreeMotion(moments, momenta).state(times), 5)
    print(f"  {host}  {'random moments and spins':40}{whole / COUNT / unit:8.2f}")
    once = median(lambda: ph.FreeMotion(MOMENTS, (0.3, 1.8, 1.5)))
    print(f"  NumPy  {'set-up of one body alone':40}{once * 1e3:8.2f} ms")
    with_jax(times, moments, momenta, unit)


def with_jax(times: np.ndarray, moments: np.ndarray, momenta: np.ndarray, unit: float) -> None:
    import jax

    jax.config.update("jax_enable_x64", True)
    put = jax.numpy.asarray
    jax_times = put(times)
    for number, (name, momentum) in enumerate(BODIES.items()):
        start = time.perf_counter()
        motion = ph.FreeMotion(put(MOMENTS), put(momentum))
        jax.block_until_ready(motion.state(jax_times))
        first = time.perf_counter() - start
        per_state = median(lambda m=motion: jax.block_until_ready(m.state(jax_times))) / COUNT / unit
        note = f"   first call {first:.1f} s" if number == 0 else ""
        print(f"  JAX    {name:40}{per_state:8.2f}{note}")

    def many() -> None:
        jax.block_until_ready(ph.FreeMotion(put(moments), put(momenta)).state(jax_times))

    start = time.perf_counter()
    many()
    first = time.perf_counter() - start
    per_body = median(many, 5) / COUNT / unit
    print(f"  JAX    {'many bodies, set-up included':40}{per_body:8.2f}   first call {first:.1f} s")


def angle(attitude: np.ndarray, wanted: np.ndarray) -> float:
    return float(ph.rotation.angle_between(attitude, wanted))


def euler(_: float, y: np.ndarray) -> np.ndarray:
    velocity = y[4:] / np.array(MOMENTS)
    w, x, y_, z = y[:4]
    a, b, c = 0.5 * velocity
    quaternion = (-x * a - y_ * b - z * c, w * a + y_ * c - z * b, w * b + z * a - x * c, w * c + x * b - y_ * a)
    return np.concatenate([quaternion, np.cross(y[4:], velocity)])


def integrators() -> None:
    momentum = BODIES["short-axis (exponential)"]
    motion = ph.FreeMotion(MOMENTS, momentum)
    print("\nerror of attitude [rad], and time per unit of time simulated")
    start = np.concatenate([[1.0, 0, 0, 0], momentum])
    span = 1e3
    begun = time.perf_counter()
    end = solve_ivp(euler, (0.0, span), start, method="DOP853", rtol=1e-12, atol=1e-14).y[:, -1]
    taken = time.perf_counter() - begun
    error = angle(end[:4] / np.linalg.norm(end[:4]), motion.attitude(span))
    print(f"  DOP853 rtol 1e-12        t = 1e+03: {error:.1e}   {taken / span * 1e6:.0f} µs")
    print(f"  DOP853 rtol 1e-12        t = 1e+06: not run, it would take about {1e3 * taken / 60:.0f} minutes")
    dopri8(motion, start)


def dopri8(motion: ph.FreeMotion, start: np.ndarray) -> None:
    import diffrax
    import jax
    import jax.numpy as jnp

    moments = jnp.asarray(MOMENTS)

    def field(t, y, args):
        velocity = y[4:] / moments
        w, x, y_, z = y[:4]
        a, b, c = 0.5 * velocity
        quaternion = jnp.stack(
            [-x * a - y_ * b - z * c, w * a + y_ * c - z * b, w * b + z * a - x * c, w * c + x * b - y_ * a]
        )
        return jnp.concatenate([quaternion, jnp.cross(y[4:], velocity)])

    @jax.jit
    def solve(end):
        controller = diffrax.PIDController(rtol=1e-12, atol=1e-14)
        return diffrax.diffeqsolve(
            diffrax.ODETerm(field), diffrax.Dopri8(), 0.0, end, 0.01, jnp.asarray(start),
            stepsize_controller=controller, max_steps=100_000_000,
        ).ys[-1]  # fmt: skip

    solve(1.0).block_until_ready()
    for span in (1e3, 1e6):
        begun = time.perf_counter()
        end = np.asarray(solve(span))
        taken = time.perf_counter() - begun
        error = angle(end[:4] / np.linalg.norm(end[:4]), motion.attitude(span))
        print(f"  diffrax Dopri8 1e-12     t = {span:.0e}: {error:.1e}   {taken / span * 1e6:.0f} µs")


def orekit() -> None:
    try:
        import jpype
        import orekit_jpype

        orekit_jpype.initVM()
    except Exception as error:  # a missing package or a missing Java runtime
        print(f"\nOrekit is left out: {error}")
        return
    from org.hipparchus.geometry.euclidean.threed import Rotation, Vector3D
    from org.orekit.attitudes import Attitude, Inertia, InertiaAxis, TorqueFree
    from org.orekit.frames import FramesFactory
    from org.orekit.time import AbsoluteDate
    from org.orekit.utils import PVCoordinatesProvider

    momentum = BODIES["short-axis (exponential)"]
    velocity = [m / i for m, i in zip(momentum, MOMENTS, strict=True)]
    frame, epoch = FramesFactory.getGCRF(), AbsoluteDate.ARBITRARY_EPOCH
    axes = (Vector3D.PLUS_I, Vector3D.PLUS_J, Vector3D.PLUS_K)
    inertia = Inertia(*(InertiaAxis(i, axis) for i, axis in zip(MOMENTS, axes, strict=True)))
    start = Attitude(epoch, frame, Rotation.IDENTITY, Vector3D(*velocity), Vector3D.ZERO)
    begun = time.perf_counter()
    model = TorqueFree(start, inertia)
    setup = time.perf_counter() - begun
    provider = jpype.JProxy(PVCoordinatesProvider, dict={"getPVCoordinates": lambda *_: None})
    motion = ph.FreeMotion(MOMENTS, momentum)
    print(f"\nOrekit TorqueFree: set-up of the first body {setup * 1e3:.1f} ms")
    for span in (1e3, 1e6):
        found = model.getAttitude(provider, epoch.shiftedBy(span), frame).getRotation()
        # Orekit rotates the reference frame into the body's: its quaternion is ours up to sign of the vector
        ours = np.array([found.getQ0(), -found.getQ1(), -found.getQ2(), -found.getQ3()])
        other = ours * [1, -1, -1, -1]
        wanted = motion.attitude(span)
        print(f"  t = {span:.0e}: error {min(angle(ours, wanted), angle(other, wanted)):.1e} rad")
    dates = [epoch.shiftedBy(float(t)) for t in range(2000)]

    def loop() -> None:
        for date in dates:
            model.getAttitude(provider, date, frame)

    print(f"  per state through the bridge {median(loop, 5) / len(dates) * 1e6:.1f} µs")


if __name__ == "__main__":
    closed_form(np.random.default_rng(0))
    integrators()
    orekit()
