"""Motions as JAX takes them apart: an edited one is one made anew, and its derivatives are the constructor's."""

import copy
import pickle

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode.errors import InvalidInput
from polhode.motion.base import AbstractMotion

jax.config.update("jax_enable_x64", True)

TURNED = np.asarray(ph.rotation.as_matrix([0.8, 0.36, -0.48, 0.0]))
START = {"momentum_at_epoch": (0.3, 1.8, 1.5), "attitude_at_epoch": (0.8, 0.36, -0.48, 0.0), "epoch": 0.4}
BODY = {"moments": (1.0, 2.0, 3.0)} | START
TOP = {"moments": (1.2, 1.2, 0.5), "mgl": 0.9} | START
GIVEN = {
    "body": (ph.FreeMotion, BODY),
    "body along given axes": (ph.FreeMotion, BODY | {"axes": TURNED}),
    "top": (ph.LagrangeMotion, TOP),
    "top along given axes": (ph.LagrangeMotion, TOP | {"axes": TURNED}),
}
OTHERS = {"moments": (1.1, 1.1, 0.6), "mgl": -0.4, "momentum_at_epoch": (-0.2, 1.0, 2.0),
          "attitude_at_epoch": (0.6, 0.0, 0.8, 0.0), "epoch": -0.7, "axes": TURNED.T}  # fmt: skip
SAME = 4e-15  # relative to one: vectors go from given axes to principal ones once more, and back
BY_DIFFERENCES, STEP = 2e-8, 1e-5  # central differences leave h² f‴/6 and rounding over h, some 1e-10 each
TIME = 1.7


def arrays(values):
    return {name: jnp.asarray(value, float) for name, value in values.items()}


def make(name):
    kind, values = GIVEN[name]
    return kind(**arrays(values))


def seven(motion, t=TIME):
    return jnp.concatenate(motion.state(t))


def assert_same(one, other):
    np.testing.assert_allclose(np.asarray(seven(one)), np.asarray(seven(other)), rtol=0, atol=SAME)
    for name in ("energy", "period", "nutation_period", "precession_rate"):
        if hasattr(one, name):
            np.testing.assert_allclose(getattr(one, name), getattr(other, name), rtol=1e-13)


@pytest.mark.parametrize("name", GIVEN)
def test_leaves_are_the_arguments(name):
    _, values = GIVEN[name]
    leaves = {jax.tree_util.keystr(path): x for path, x in jax.tree_util.tree_flatten_with_path(make(name))[0]}
    assert set(leaves) == {f".{key}" for key in values}
    for key, value in values.items():
        np.testing.assert_allclose(leaves[f".{key}"], value, rtol=0, atol=SAME)


@pytest.mark.long_after(8)
@pytest.mark.parametrize("name, field", [(name, field) for name, (_, values) in GIVEN.items() for field in values])
def test_an_edited_leaf_is_a_motion_made_anew(name, field):
    kind, values = GIVEN[name]
    other = jnp.asarray(OTHERS[field], float)
    made = kind(**arrays(values) | {field: other})
    assert_same(eqx.tree_at(lambda m: getattr(m, field), make(name), other), made)
    looked_at = make(name)  # what has been computed once is not kept
    looked_at.state(TIME), looked_at.energy
    assert_same(eqx.tree_at(lambda m: getattr(m, field), looked_at, other), made)
    in_jit = jax.jit(lambda m, x: seven(eqx.tree_at(lambda m: getattr(m, field), m, x)))(make(name), other)
    np.testing.assert_allclose(in_jit, seven(made), rtol=0, atol=SAME)


@pytest.mark.long
@pytest.mark.parametrize("name", GIVEN)
def test_derivatives_by_the_motion_are_those_by_differences(name):
    """The differences are of NumPy's motions, whose derivatives JAX's code has no part in."""
    kind, values = GIVEN[name]
    weights = np.random.default_rng(2).normal(size=7)
    by_motion = jax.grad(lambda m: jnp.dot(weights, seven(m)))(make(name))
    by_arguments = jax.grad(lambda v: jnp.dot(weights, seven(kind(**v))))(arrays(values))
    rng = np.random.default_rng(3)
    for field, value in values.items():
        np.testing.assert_allclose(getattr(by_motion, field), by_arguments[field], rtol=0, atol=1e-13)
        way = rng.normal(size=np.shape(value))
        if field == "moments" and kind is ph.LagrangeMotion:
            way[1] = way[0]  # else no top
        if field == "attitude_at_epoch":  # of unit length
            way = way - np.dot(way, value) * np.asarray(value)
        if field == "axes":  # stay orthonormal: a turn
            way = way - way.T
        ends = []
        for step in (STEP, -STEP):
            changed = np.asarray(value) + step * way
            if field == "attitude_at_epoch":
                changed = changed / np.linalg.norm(changed)
            if field == "axes":
                small = step * np.array([way[2, 1], way[0, 2], way[1, 0]])
                changed = value @ np.asarray(ph.rotation.as_matrix(ph.rotation.from_rotation_vector(small)))
            ends.append(np.dot(weights, np.concatenate(kind(**values | {field: changed}).state(TIME))))
        along = value @ way if field == "axes" else way
        expected = (ends[0] - ends[1]) / (2 * STEP)
        assert abs(np.sum(np.asarray(getattr(by_motion, field)) * along) - expected) < BY_DIFFERENCES, field


def test_descent_on_a_motion_is_descent_on_its_fields():
    target = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.33, 1.98, 1.65)).state(1.0)[1]
    loss = jax.jit(lambda m: jnp.sum((m.state(1.0)[1] - target) ** 2))
    slope = jax.jit(jax.grad(loss))
    motion = ph.FreeMotion(jnp.array([1.0, 2.0, 3.0]), momentum=jnp.array([0.3, 1.8, 1.5]))
    before = loss(motion)
    for _ in range(50):
        motion = jax.tree.map(lambda x, dx: x - 0.05 * dx, motion, slope(motion))
    anew = ph.FreeMotion(motion.moments, momentum=motion.momentum_at_epoch, attitude=motion.attitude_at_epoch,
                         epoch=motion.epoch)  # fmt: skip
    assert loss(motion) < 1e-4 * before
    assert loss(motion) == pytest.approx(float(loss(anew)), rel=1e-6, abs=1e-20)


@pytest.mark.long
@pytest.mark.parametrize("name", GIVEN)
def test_vmap_takes_a_batch_apart(name):
    kind, values = GIVEN[name]
    values = arrays(values)
    momenta = values["momentum_at_epoch"] * jnp.linspace(0.5, 1.5, 4)[:, None]
    batch = kind(**values | {"momentum_at_epoch": momenta})
    expected = jnp.stack([seven(kind(**values | {"momentum_at_epoch": x})) for x in momenta])
    for vmap in (jax.vmap, eqx.filter_vmap):
        np.testing.assert_allclose(vmap(seven)(batch), expected, rtol=0, atol=SAME)
    made = jax.vmap(lambda x: kind(**values | {"momentum_at_epoch": x}))(momenta)
    for each in (made, jax.tree.map(lambda x: x, batch)):
        np.testing.assert_allclose(jnp.concatenate(each.state(TIME), axis=-1), expected, rtol=0, atol=SAME)
        np.testing.assert_allclose(each.angular_velocity(TIME), batch.angular_velocity(TIME), rtol=0, atol=SAME)
        np.testing.assert_allclose(each.sample([0.0, TIME]).states, batch.sample([0.0, TIME]).states, atol=SAME)
    which = jax.tree.map(lambda x: 0, make(name))  # a tree of in_axes
    np.testing.assert_allclose(jax.vmap(seven, in_axes=(which,))(batch), expected, rtol=0, atol=SAME)
    # of one body, but for its momenta
    alone = eqx.tree_at(lambda m: m.momentum_at_epoch, jax.tree.map(lambda x: None, make(name)), 0,
                        is_leaf=lambda x: x is None)  # fmt: skip
    single = eqx.tree_at(lambda m: m.momentum_at_epoch, make(name), momenta)
    np.testing.assert_allclose(jax.vmap(seven, in_axes=(alone,))(single), expected, rtol=0, atol=SAME)


@pytest.mark.parametrize("name", GIVEN)
def test_motions_of_anything_can_be_made(name):
    motion = make(name)
    for thing in (None, object(), True, "word", jax.ShapeDtypeStruct((3,), float)):
        again = jax.tree.map(lambda x, thing=thing: thing, motion)
        assert type(again) is type(motion) and again.moments is thing and again.momentum_at_epoch is thing
    shapes = jax.eval_shape(lambda m: m.along("principal"), motion)
    assert shapes.momentum_at_epoch.shape == (3,)


@pytest.mark.parametrize("name", GIVEN)
def test_what_came_back_from_jax_is_copied_and_pickled(name):
    motion = make(name)
    back = jax.jit(lambda m: m)(motion)
    for each in (back, copy.deepcopy(back), copy.copy(back), pickle.loads(pickle.dumps(back)), back.along("given")):
        assert isinstance(each, AbstractMotion)
        assert_same(each, motion)
    assert hash(back) != hash(motion) and back != motion  # by identity, as of other motions
    turned = motion.along("principal")
    returned = jax.tree.map(lambda x: x, turned).along("given")
    np.testing.assert_allclose(seven(returned), seven(motion), rtol=0, atol=SAME)


def test_motions_of_numpy_go_through_jax_too():
    motion = ph.FreeMotion((1.0, 2.0, 3.0), momentum=np.array([[0.3, 1.8, 1.5], [1.0, 0.2, 0.1]]))
    expected = np.concatenate(motion.state(TIME), axis=-1)
    np.testing.assert_allclose(jax.jit(lambda m: jnp.concatenate(m.state(TIME), -1))(motion), expected, atol=SAME)
    np.testing.assert_allclose(jax.vmap(seven)(motion), expected, rtol=0, atol=SAME)


@pytest.mark.long
def test_bad_fields_are_refused_where_they_are_used():
    motion = make("top")
    for field, bad in (("moments", (1.0, 1.1, 0.5)), ("moments", (-1.0, -1.0, 1.0)),
                       ("momentum_at_epoch", (np.nan, 0.0, 0.0)), ("attitude_at_epoch", (1.0, 1.0, 0.0, 0.0)),
                       ("mgl", np.inf)):  # fmt: skip
        edited = eqx.tree_at(lambda m, field=field: getattr(m, field), motion, jnp.asarray(bad))
        with pytest.raises(InvalidInput, match=field.removesuffix("_at_epoch")):
            edited.state(TIME)
        if field in ("moments", "attitude_at_epoch"):  # the attitude alone does not spoil the momentum
            assert jnp.isnan(jax.jit(lambda m: m.state(TIME)[0])(edited)).all()


def test_a_leaf_may_become_a_number():
    edited = eqx.tree_at(lambda m: (m.mgl, m.epoch), make("top"), (-0.4, 1.0))
    assert_same(edited, ph.LagrangeMotion(**arrays(TOP | {"mgl": -0.4, "epoch": 1.0})))


def test_samples_of_bodies_with_axes_of_their_own_are_refused():
    two = jax.vmap(lambda axes: ph.FreeMotion(**arrays(BODY) | {"axes": axes}))(jnp.stack([jnp.eye(3), TURNED]))
    with pytest.raises(InvalidInput, match="one set of axes"):
        two.sample([0.0, 1.0])
    expected = np.stack([seven(ph.FreeMotion(**BODY, axes=axes)) for axes in (np.eye(3), TURNED)])
    np.testing.assert_allclose(np.concatenate(two.state(TIME), -1), expected, rtol=0, atol=SAME)
