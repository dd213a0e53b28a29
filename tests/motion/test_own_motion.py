"""An exact motion of another package stands on the public base, and its check finds what is wrong with one."""

import importlib
import inspect

import jax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode.errors import InvalidInput
from polhode.motion import AbstractMotion, Quantity
from polhode.testing import LawBroken, check_motion

pytestmark = pytest.mark.usefixtures("plugin")
HALF = 0.5**0.5
GIVEN = {"larmor_rate": 0.7, "momentum": (0.3, -1.2, 2.0), "attitude": (HALF, HALF, 0.0, 0.0), "epoch": 0.5}
SAME = 1e-11


@pytest.fixture
def Ball(plugin):
    return importlib.import_module("charged_ball").ChargedBall


def test_the_motion_of_another_package_obeys_the_laws(Ball):
    check_motion(Ball(2.0, **GIVEN))
    check_motion(Ball(2.0, **GIVEN).along(np.asarray(ph.rotation.as_matrix((HALF, 0.0, HALF, 0.0)))))
    check_motion(Ball(2.0, **GIVEN | {"momentum": (0.0, 0.0, 0.0)}))


def test_without_a_field_it_is_a_free_body(Ball):
    rest = {name: value for name, value in GIVEN.items() if name != "larmor_rate"}
    times = np.linspace(0.0, 30.0, 50)
    for one, other in zip(Ball(2.0, larmor_rate=0.0, **rest).state(times),
                          ph.FreeMotion((2.0, 2.0, 2.0), **rest).state(times), strict=True):  # fmt: skip
        np.testing.assert_allclose(one, other, rtol=0, atol=SAME)


def test_the_momentum_goes_round_the_field(Ball):
    motion = Ball(2.0, **GIVEN)
    L = ph.rotation.rotate(motion.attitude(1.5), motion.momentum(1.5))
    start = ph.rotation.rotate(motion.attitude_at_epoch, motion.momentum_at_epoch)
    turned = np.cos(0.7) * start[:2] + np.sin(0.7) * np.array([-start[1], start[0]])
    np.testing.assert_allclose(L, [*turned, start[2]], rtol=0, atol=SAME)


def test_it_can_do_what_every_motion_can(Ball, tmp_path):
    motion = Ball(2.0, **GIVEN)
    trajectory = motion.sample()
    assert set(trajectory.drift) == {"energy", "momentum_along_the_field"} and max(trajectory.drift.values()) < SAME
    assert trajectory.quantities["energy"].unit == "J"
    assert len(motion.plot().axes) > 1
    assert "<html" in ph.write_page(motion, tmp_path / "ball.html").read_text("utf-8")
    motion.sample(np.linspace(0.0, 5.0, 9)).save(tmp_path / "ball.nc")
    assert ph.compare(str(tmp_path / "ball.nc"), str(tmp_path / "ball.nc")).summary
    many = Ball(2.0, **GIVEN | {"momentum": np.arange(12.0).reshape(4, 3)})
    assert many.state(1.0)[0].shape == (4, 4) and "larmor_rate" in repr(motion)
    with pytest.raises(InvalidInput, match="`larmor_rate` must be finite"):
        Ball(2.0, **GIVEN | {"larmor_rate": np.nan})
    with pytest.raises(InvalidInput, match="batch axes must broadcast"):
        Ball(2.0, **GIVEN | {"larmor_rate": np.ones(2), "momentum": np.ones((3, 3))})


def test_it_has_derivatives(Ball):
    def up(rate):
        moved = Ball(2.0, **GIVEN | {"larmor_rate": rate, "momentum": jnp.array([0.3, -1.2, 2.0])})
        return moved.rotation_matrix(2.0)[2, 1]

    step = 1e-5
    with jax.enable_x64(True):
        slope = (up(jnp.asarray(0.7 + step)) - up(jnp.asarray(0.7 - step))) / (2 * step)
        assert float(jax.grad(up)(jnp.asarray(0.7))) == pytest.approx(float(slope), abs=1e-8)


def bent(Ball, **parts):
    """The motion, with what a specimen bends."""
    return type("Bent", (Ball,), parts)(2.0, **GIVEN)


def too_early(self, elapsed, rest):
    return super(type(self), self).closed_form(elapsed + 0.1, rest)


def too_fast(self, elapsed, rest):
    return super(type(self), self).closed_form(1.1 * elapsed, rest)


def too_long(self, elapsed, rest):
    attitude, momentum = super(type(self), self).closed_form(elapsed, rest)
    return attitude * (1.0 + 0.1 * elapsed[..., None]), momentum


def by_numpy(self, elapsed, rest):
    """What JAX cannot trace."""
    attitude, momentum = super(type(self), self).closed_form(elapsed, rest)
    return np.asarray(attitude), np.asarray(momentum)


def of_other_axes(self, elapsed, rest):
    """By the momentum along the motion's own axes, where the principal ones are meant."""
    attitude, momentum = super(type(self), self).closed_form(elapsed, rest)
    off = self.momentum_at_epoch - self.principal_start[1]
    return attitude, momentum + off


def of_first(self, elapsed, rest):
    """Times of the first body for all."""
    elapsed = elapsed[:1] + 0.0 * elapsed if np.ndim(elapsed) == 1 and self.batch_shape == (2,) else elapsed
    return super(type(self), self).closed_form(elapsed, rest)


@pytest.mark.parametrize(
    ("parts", "law"),
    [
        ({"closed_form": too_early}, "at the epoch is the given"),
        ({"closed_form": too_fast}, "the attitude turns at Ω"),
        ({"closed_form": too_long}, "attitudes are unit quaternions"),
        ({"closed_form": of_first}, "a batch = one body after the other"),
        ({"closed_form": of_other_axes}, "other axes turn the momentum"),
        ({"closed_form": by_numpy}, "JAX arrays in, JAX arrays out"),
        ({"conserved_along": lambda self, q, L, w: {"energy": L[..., 0], "momentum_along_the_field": L[..., 1]}},
         "energy is conserved; it drifts by"),
        ({"quantities": property(lambda self: {"energy": Quantity("J")})}, "`quantities` names what"),
    ],
)  # fmt: skip
def test_what_breaks_a_law_is_found(Ball, parts, law):
    with pytest.raises(LawBroken, match=law):
        check_motion(bent(Ball, **parts))


@pytest.mark.parametrize("thing", [3.0, "word", ph.FreeMotion((1.0, 2.0, 3.0), momentum=np.ones((2, 3)))])
def test_other_things_are_refused(thing, any_type):
    with pytest.raises(InvalidInput, match="one motion in closed form"):
        check_motion(thing)


def test_all_that_a_subclass_must_give_is_public():
    assert all(not name.startswith("_") for name in AbstractMotion.__abstractmethods__)
    assert AbstractMotion.__abstractmethods__ == {
        "closed_form", "conserved_along", "cycle", "fastest_rate", "quantities",
    }  # fmt: skip
    own = inspect.getsource(importlib.import_module("charged_ball"))
    assert "._" not in own.replace("__init__", "") and "import _" not in own


def test_the_own_motions_obey_the_laws():
    check_motion(ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5), epoch=0.2))
    body = ph.shapes.box(1.0, (0.1, 0.2, 0.3)).placed((HALF, HALF, 0.0, 0.0))
    check_motion(ph.FreeMotion.from_body(body, angular_velocity=(1.0, 20.0, 3.0)))
    check_motion(ph.LagrangeMotion((1.0, 1.0, 0.5), mgl=1.0, momentum=(0.1, 0.0, 2.5), attitude=(0.8, 0.6, 0.0, 0.0)))
