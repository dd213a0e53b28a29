"""A system that is no Lie–Poisson one is judged by the derivatives that it gives of its steady motion."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode.errors import InvalidInput
from polhode.systems import AbstractSystem
from polhode.systems.steady_motion import SteadyMotion

SPEED = 1.5  # of the hoop [rad/s], below and above √(g/l) of the two below


class Hoop(AbstractSystem):
    """A bead on a hoop that turns about its upright diameter: θ̈ = sin θ (n² cos θ − w²), with w² = g/l."""

    weight: float  # w² [1/s²]

    def vector_field(self, t, state):
        angle, rate = state[..., 0], state[..., 1]
        return jnp.stack([rate, jnp.sin(angle) * (SPEED**2 * jnp.cos(angle) - self.weight)], axis=-1)

    def jacobi(self, state):
        angle, rate = state[..., 0], state[..., 1]
        return 0.5 * rate**2 - self.weight * jnp.cos(angle) - 0.5 * SPEED**2 * jnp.sin(angle) ** 2

    def invariants(self, state):
        return {"energy": self.jacobi(state)}


class Judged(Hoop):
    without: tuple[str, ...] = ()

    def steady_motion(self, state):
        x = jnp.asarray(state, dtype=float)
        flow = jax.jacfwd(lambda x: self.vector_field(0.0, x))(x)
        derivatives = (flow, jax.grad(self.jacobi)(x), jax.hessian(self.jacobi)(x))
        return SteadyMotion(*map(np.asarray, derivatives), np.zeros((0, 2)), np.zeros((0, 2, 2)), (),
                            within=("angle",), without=self.without)  # fmt: skip


@pytest.mark.parametrize(("weight", "angle", "square"), [
    # the exponents' square by hand: n² cos 2θ − w² cos θ
    (4.0, 0.0, SPEED**2 - 4.0), (1.0, 0.0, SPEED**2 - 1.0), (1.0, np.arccos(1.0 / SPEED**2), SPEED**-2 - SPEED**2),
    (4.0, np.pi, SPEED**2 + 4.0),
])  # fmt: skip
def test_a_bead_on_a_turning_hoop(weight, angle, square):
    found = ph.stability(Judged(weight), [angle, 0.0])
    assert found.verdict == ("unstable" if square > 0.0 else "stable")
    assert abs(found.spectrum[0] ** 2 - square) < 1e-12 * abs(square)
    assert found.restriction is None


def test_what_need_not_stay_close_restricts_stability_alone():
    assert ph.stability(Judged(4.0, ("heading",)), [0.0, 0.0]).restriction == "in angle, not in heading"
    assert ph.stability(Judged(1.0, ("heading",)), [0.0, 0.0]).restriction is None


def test_a_system_that_gives_none_is_refused():
    with pytest.raises(InvalidInput, match="or one that gives its `steady_motion`; got Hoop"):
        ph.stability(Hoop(4.0), [0.0, 0.0])
    with pytest.raises(InvalidInput, match="integrals of Judged are its own"):
        ph.stability(Judged(4.0), [0.0, 0.0], integrals=[lambda x: x[0]])
