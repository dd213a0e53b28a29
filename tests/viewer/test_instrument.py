"""What is set on a page is the motion that Python computes for it; links and specs bring it back."""

from dataclasses import replace

import numpy as np
import pytest

import polhode as ph
from polhode.kinds.page import write_page
from polhode.kinds.reading import read_spec

pytestmark = pytest.mark.browser
SAME = 1e-9
"""Of states on the page and in Python, at times up to some hundred turns."""
STEPPED_SAME = 1e-7
"""Of states that both sides reach by steps."""
DRIFT = 1e-12
"""Of |L| and the energy over ten minutes."""
MOTION = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.1, 2.0, 0.1))
TIMES = np.array([0.0, 0.7, 13.0, 250.0, -40.0])
BOTH = "times => times.map(t => window.polhode.state(t))"


@pytest.fixture(scope="module")
def book(tmp_path_factory):
    path = tmp_path_factory.mktemp("book") / "book.html"
    return write_page(MOTION.sample(np.linspace(0.0, 30.0, 601)), path, name="a book", summary="As it was given.")


def drawn(page, times=TIMES):
    found = page.tab.evaluate(BOTH, list(times))
    return np.array([one["attitude"] for one in found]), np.array([one["momentum"] for one in found])


def computed(settings, times=TIMES):
    moments = np.array(settings["body"]["moments"])
    velocity = np.array(settings["spin"]["angular_velocity"])
    return ph.FreeMotion(moments, momentum=moments * velocity, attitude=settings["spin"]["attitude"]).state(times)


def miss(page, settings):
    """Return by how much the page's states differ from Python's for these settings."""
    attitude, momentum = drawn(page)
    wanted, wanted_momentum = computed(settings)
    apart = np.minimum(np.abs(attitude - wanted).max(-1), np.abs(attitude + wanted).max(-1)).max()
    return max(apart, np.abs(momentum - wanted_momentum).max() / np.linalg.norm(wanted_momentum[0]))


def settings_of(page):
    return page.tab.evaluate("window.polhode.settings()")


def test_the_motion_that_was_given_is_solved(book, opened):
    page = opened(book)
    attitude, momentum = drawn(page)
    wanted, wanted_momentum = MOTION.state(TIMES)
    assert attitude == pytest.approx(wanted, abs=SAME) and momentum == pytest.approx(wanted_momentum, abs=SAME)
    assert attitude != pytest.approx(MOTION.state(TIMES + 1e-6)[0], abs=SAME)


def test_a_slider_changes_the_motion_to_what_python_computes(book, opened):
    page = opened(book)
    page.unfold()
    before = settings_of(page)
    for key in ("body-moments-1", "spin-rate", "spin-tilt", "spin-around"):
        page.tab.locator(f".control:has(#set-{key}) input[type=range]").fill("640")
        after = settings_of(page)
        assert after != before and miss(page, after) < SAME < miss(page, before), key
        assert page.tab.locator("#summary").text_content() == "Set on this page."
        page.tab.locator("#reset").click()
        assert settings_of(page) == before and page.tab.locator("#summary").text_content() == "As it was given."
    assert not page.complaints


def test_numbers_are_typed_in_the_unit_that_stands_beside_them(book, opened):
    page = opened(book)
    page.unfold()
    for key, text, wanted in (("spin-rate", "30", np.pi), ("body-moments-0", "1.5", 1.5)):
        page.tab.locator(f"#set-{key}").fill(text)
        page.tab.keyboard.press("Enter")
        settings = settings_of(page)
        rate = np.linalg.norm(settings["spin"]["angular_velocity"])
        got = rate if key == "spin-rate" else settings["body"]["moments"][0]
        assert got == pytest.approx(wanted, rel=1e-12)
    for text in ("", "fast", "0.5", "-2", "9"):  # I₁ below |I₃ − I₂|, negative, above I₂ + I₃
        page.tab.locator("#set-body-moments-0").fill(text)
        page.tab.keyboard.press("Enter")
        assert settings_of(page)["body"]["moments"][0] == 1.5
    assert "1 to 5 kg m²" in page.tab.locator("#set-body-moments-0").evaluate("field => field.validationMessage")


def test_tables_of_a_spec_are_taken_and_refused_whole(book, opened):
    page = opened(book)
    assert page.tab.evaluate("window.polhode.set({body: {moments: [2, 3, 4]}, spin: {rate: 5, about: 1, tilt: 0.3}})")
    settings = settings_of(page)
    assert settings["body"]["moments"] == [2, 3, 4] and miss(page, settings) < SAME
    assert settings["spin"]["angular_velocity"] == pytest.approx([5 * np.cos(0.3), 5 * np.sin(0.3), 0.0], rel=1e-14)
    for wrong in ("{body: {moments: [1, -2, 3]}}", "{spin: {angular_velocity: [1, 2]}}", "{spin: {rate: NaN}}", "null",
                  "[1]", "'x'", "{spin: null}", "{body: {moments: 'abc'}}", "{spin: {about: 7}}", "{spin: {rates: 1}}",
                  "{sping: {rate: 1}}", "{spin: {rate: 1e308}}", "{spin: {attitude: [0, 0, 0, 0]}}"):  # fmt: skip
        assert page.tab.evaluate(f"window.polhode.set({wrong})") is False
        assert settings_of(page) == settings and page.tab.locator("#refused").text_content()
    assert page.tab.evaluate("window.polhode.set({spin: {momentum: [0, 0, 0]}})")
    assert "at rest" in page.tab.locator("#facts").text_content() and not page.complaints


def test_a_link_brings_the_motion_back(book, opened):
    page = opened(book)
    page.tab.evaluate("window.polhode.set({spin: {rate: 4.5, tilt: 0.01}})")
    page.until("location.hash.includes('angular_velocity')")
    address = page.tab.evaluate("location.href")
    assert "#body.moments=1,2,3&spin.angular_velocity=" in address
    other = opened(book, f"{address.removeprefix(book.as_uri())}&t=3.5")
    assert settings_of(other) == settings_of(page) and drawn(other)[0].tolist() == drawn(page)[0].tolist()
    assert other.tab.evaluate("window.polhode.shown().time") == 3.5
    for nonsense in ("#%E0%A4%A", "#body.moments=1,x,3", "#a=b&=&.=&spin.rate=", "#body.moments=-1,2,3"):
        other.tab.goto("about:blank")
        other.tab.goto(book.as_uri() + nonsense)
        other.until("window.polhode && window.polhode.firstPicture")
        assert settings_of(other)["body"]["moments"] == [1, 2, 3]
    assert not other.complaints


def test_the_spec_of_what_is_set_gives_the_same_motion(book, opened, tmp_path):
    page = opened(book)
    page.tab.evaluate("window.polhode.set({body: {moments: [2, 3, 4]}, spin: {rate: 5, about: 1, tilt: 0.3}})")
    spec = tmp_path / "set.toml"
    spec.write_text(page.tab.evaluate("window.polhode.spec()"))
    motion = read_spec(spec).report().trajectory.motion
    attitude, momentum = drawn(page)
    assert np.asarray(motion.attitude(TIMES)) == pytest.approx(attitude, abs=SAME)
    assert np.asarray(motion.momentum(TIMES)) == pytest.approx(momentum, abs=SAME)
    page.unfold()
    page.tab.locator("#spec").click()
    assert page.tab.locator("#copied").input_value() == spec.read_text()


def test_play_goes_on_for_ever_without_drift(book, opened):
    page = opened(book)
    last = page.tab.evaluate("window.polhode.times[window.polhode.count - 1]")
    page.tab.evaluate("time => window.polhode.goTo(time)", last - 0.01)
    page.tab.locator("#play").click()
    page.until(f"window.polhode.shown().time > {last + 0.5}")
    page.tab.locator("#play").click()
    now = page.tab.evaluate("window.polhode.shown().time")
    assert page.tab.evaluate("window.polhode.times[0]") < now < page.tab.evaluate("window.polhode.times.at(-1)")
    page.tab.evaluate("window.polhode.goTo(600)")
    assert page.tab.evaluate("window.polhode.shown().time") == 600.0
    _, momentum = drawn(page, np.linspace(0.0, 600.0, 301))
    size, energy = np.linalg.norm(momentum, axis=1), 0.5 * np.sum(momentum**2 / MOTION.moments, axis=1)
    assert np.ptp(size) < DRIFT * size[0] and np.ptp(energy) < DRIFT * energy[0]
    page.tab.keyboard.press("Home")
    assert page.tab.evaluate("window.polhode.shown().time") == 0.0 and not page.complaints


def test_the_point_on_the_sphere_is_dragged_to_another_polhode(book, opened):
    page = opened(book)
    page.enlarge("sphere")
    box = page.tab.locator(".large canvas").bounding_box()
    page.tab.evaluate("window.polhode.set({spin: {momentum: [1.2, 1.2, 1.2]}})")
    page.seek(0)
    x, y, _ = page.measure("sphere")["seen"]
    place = box["x"] + 0.5 * (1 + x) * box["width"], box["y"] + 0.5 * (1 - y) * box["height"]
    azimuth = page.tab.evaluate("window.polhode.view.azimuth")
    page.tab.mouse.move(*place)
    page.tab.mouse.down()
    page.tab.mouse.move(place[0] + 25, place[1] - 40, steps=5)
    page.tab.mouse.up()
    settings = settings_of(page)
    momentum = np.array(settings["body"]["moments"]) * settings["spin"]["angular_velocity"]
    assert np.linalg.norm(momentum) == pytest.approx(1.2 * np.sqrt(3.0), rel=1e-12)
    assert np.abs(momentum - 1.2).max() > 0.1 and miss(page, settings) < SAME
    assert page.tab.evaluate("window.polhode.view.azimuth") == azimuth
    x, y, _ = page.measure("sphere")["seen"]
    end = box["x"] + 0.5 * (1 + x) * box["width"], box["y"] + 0.5 * (1 - y) * box["height"]
    assert np.hypot(end[0] - place[0] - 25, end[1] - place[1] + 40) < 1.5  # pixels
    assert not page.complaints


def test_a_box_is_set_by_its_edges(opened, tmp_path):
    box = ph.shapes.box(2.0, (0.3, 0.2, 0.1))
    motion = ph.FreeMotion(box.principal_moments, momentum=box.principal_moments * np.array([0.1, 2.0, 0.1]))
    path = write_page(replace(motion.sample(np.linspace(0.0, 9.0, 91)), frame=box.frame), tmp_path / "box.html")
    page = opened(path)
    page.unfold()
    page.tab.locator("#set-by").select_option("1")
    shown = [float(page.tab.locator(f"#set-{name}").input_value()) for name in ("mass", "edge-0", "edge-1", "edge-2")]
    assert shown == pytest.approx([2.0, 30.0, 20.0, 10.0], rel=1e-6)  # kg and cm, along the axes of ascending moments
    page.tab.locator("#set-edge-2").fill("15")
    page.tab.keyboard.press("Enter")
    settings = settings_of(page)
    wanted = ph.shapes.box(2.0, (0.3, 0.2, 0.15)).inertia
    assert settings["body"]["moments"] == pytest.approx(np.diag(wanted), rel=1e-12)
    assert miss(page, settings) < SAME and not page.complaints


SEEN = {"rest": "at rest", "steady": "spins steadily", "coning": "cones", "tumbling": "tumbles",
        "flipping": "turns over and over"}  # fmt: skip


def test_the_page_says_what_a_report_says(book, opened):
    page, random = opened(book), np.random.default_rng(5)
    forms = set()
    for _ in range(40):
        moments = np.sort(random.uniform(1.0, 3.0, 3))
        moments[2] = min(moments[2], moments[:2].sum())
        velocity = random.normal(size=3) * random.choice([0.05, 1.0, 6.0], size=3)
        moments = random.permutation(moments).tolist()
        tables = {"body": {"moments": moments}, "spin": {"angular_velocity": velocity.tolist()}}
        assert page.tab.evaluate("tables => window.polhode.set(tables)", tables)
        motion = ph.FreeMotion(moments, momentum=np.array(moments) * velocity)
        form = ph.analysis.rotation_form(motion)
        forms.add(form)
        assert page.tab.locator("#facts dd").first.text_content().startswith(SEEN[form]), (tables, form)
    assert forms == {"coning", "tumbling", "flipping"}


def test_angles_and_rates_are_plotted_over_time(book, opened):
    page = opened(book)
    velocity, angles = page.tab.evaluate("window.polhode.plots()")
    sampled = MOTION.angular_velocity(np.linspace(0.0, 30.0, 601))
    assert np.array(velocity["ranges"]) == pytest.approx(np.array([sampled.min(0), sampled.max(0)]).T, abs=1e-3)
    assert np.array(angles["ranges"]) == pytest.approx(np.degrees(ph.analysis.axis_angles(MOTION)), abs=0.05)
    plot = page.tab.locator("#plots canvas").first
    plot.click(position={"x": 0.5 * (plot.bounding_box()["width"] + 62 - 12), "y": 50})
    assert page.tab.evaluate("window.polhode.shown().time") == pytest.approx(15.0, abs=0.1)
    page.tab.evaluate("window.polhode.set({spin: {rate: 2, about: 3, tilt: 1e-5}})")
    *_, small = page.tab.evaluate("window.polhode.plots()")
    wide = ph.analysis.cone_angles(ph.FreeMotion((1.0, 2.0, 3.0), momentum=(2e-5, 0.0, 6.0)))
    assert float(small["across"].removesuffix("″")) == pytest.approx(np.degrees(2.0 * wide[1]) * 3600.0, rel=0.01)
    assert not page.complaints


def top_of(settings, times=TIMES):
    """Return the Lagrange motion of Euler's angles and rates, by SciPy's own composition of rotations."""
    from scipy.spatial.transform import Rotation

    system, spin = settings["system"], settings["spin"]
    attitude = Rotation.from_quat(np.roll(spin["attitude"], -1))
    phi, lean, _ = attitude.as_euler("ZXZ")
    assert abs(lean) == pytest.approx(system["lean"], abs=1e-12)
    node, up = Rotation.from_euler("Z", phi).apply([1.0, 0.0, 0.0]), np.array([0.0, 0.0, 1.0])
    in_space = spin["precession"] * up + spin["nutation_rate"] * node + spin["spin"] * attitude.apply(up)
    momentum = np.array(system["moments"]) * attitude.inv().apply(in_space)
    return ph.LagrangeMotion(system["moments"], mgl=system["mgl"], momentum=momentum, attitude=spin["attitude"]).state(
        times
    )


@pytest.fixture(scope="module")
def toy(tmp_path_factory):
    azimuth, lean = ph.rotation.from_axis_angle((0, 0, 1), 0.3), ph.rotation.from_axis_angle((1, 0, 0), 0.5)
    motion = ph.LagrangeMotion(
        (1.0, 1.0, 0.5), mgl=2.0, momentum=(0.2, 0.3, 2.5), attitude=ph.rotation.multiply(azimuth, lean)
    )
    return write_page(motion.sample(np.linspace(0.0, 20.0, 401)), tmp_path_factory.mktemp("toy") / "toy.html")


def test_tops_are_set_by_lean_spin_and_precession(toy, opened):
    page = opened(toy)
    page.unfold()
    before, times = settings_of(page), TIMES[:3]
    for key in (None, "mgl", "lean", "spin", "precession", "nutation", "moments-0", "moments-2"):
        if key:
            page.tab.locator(f".control:has(#set-{key}) input[type=range]").fill("700")
        settings = settings_of(page)
        assert (settings != before) == (key is not None)
        attitude, momentum = drawn(page, times)
        wanted, wanted_momentum = top_of(settings, times)
        assert attitude == pytest.approx(wanted, abs=SAME), key
        assert momentum == pytest.approx(wanted_momentum, abs=SAME), key
        assert attitude != pytest.approx(top_of(settings, times + 1e-6)[0], abs=SAME)
        page.tab.locator("#reset").click()
        assert settings_of(page) == before
    assert not page.complaints


def test_the_spec_of_a_top_gives_the_same_motion(toy, opened, tmp_path):
    page = opened(toy)
    tables = "{system: {lean: 0.7, mgl: 1.5}, spin: {spin: 6, precession: 0.4, nutation_rate: 0}}"
    page.tab.evaluate(f"window.polhode.set({tables})")
    spec = tmp_path / "set.toml"
    spec.write_text(page.tab.evaluate("window.polhode.spec()"))
    motion = read_spec(spec).report().trajectory.motion
    attitude, momentum = drawn(page, TIMES[:3])
    assert np.asarray(motion.attitude(TIMES[:3])) == pytest.approx(attitude, abs=SAME)
    assert np.asarray(motion.momentum(TIMES[:3])) == pytest.approx(momentum, abs=SAME)
    before = page.measure("axis")["limits"]
    page.tab.evaluate("window.polhode.set({system: {lean: 1.2}})")
    limits = sorted(page.measure("axis")["limits"])
    assert limits != sorted(before) and limits[0] < np.cos(1.2) < limits[1] + 1e-12
    page.tab.evaluate("window.polhode.set({spin: {precession: 0, spin: 40}, system: {lean: 0}})")
    assert "stands upright" in page.tab.locator("#facts").text_content() and not page.complaints


@pytest.mark.parametrize("drive", ["constant-rate", "free"])
def test_a_rotor_is_seen_turning_and_set_by_its_speed(drive, opened, tmp_path):
    """Its angle is the integral of its rate against the body; the spec that is copied gives the same motion again."""
    spec = tmp_path / "rotor.toml"
    spec.write_text(
        '[body]\nmoments = ["2 kg*m^2", "3 kg*m^2", "4 kg*m^2"]\n[system]\nkind = "gyrostat"\nrotor_axis = [0, 0, 1]\n'
        f'rotor_moment = "0.5 kg*m^2"\nrotor_rate = "60 rpm"\nrotor_drive = "{drive}"\n'
        '[spin]\nangular_velocity = ["1 rad/s", "0.2 rad/s", "0.5 rad/s"]\n[time]\nuntil = "8 s"\n'
    )
    page = opened(write_page(read_spec(spec), tmp_path / "rotor.html"))
    assert "60.00 rpm against the body" in page.tab.locator("body").text_content()
    page.tab.evaluate("window.polhode.set({system: {rotor_rate: 3}})")
    again = tmp_path / "again.toml"
    again.write_text(page.tab.evaluate("window.polhode.spec()"))
    system = read_spec(again).system
    assert (system.rotor_rate, system.rotor_moment, system.rotor_drive) == (pytest.approx(3.0, rel=1e-14), 0.5, drive)
    found = read_spec(again).report()
    assert miss_of(found.trajectory, page) < STEPPED_SAME
    page.seek(0)
    first = page.measure("body")["rotor"]
    page.seek(30)
    second, time = page.measure("body")["rotor"], page.times()[30]
    rates = np.interp(np.linspace(0.0, time, 400), found.trajectory.times, found.rotor_rate)
    turned = 0.5 * np.trapezoid(rates, np.linspace(0.0, time, 400))
    ratio = rotation_between(first[:4], second[:4])
    assert abs(np.cos(turned)) == pytest.approx(ratio, abs=1e-4) and abs(np.sin(turned)) > 1e-2
    assert second[4] == pytest.approx(rates[-1], abs=1e-3)
    page.tab.evaluate("window.polhode.set({system: {rotor_rate: 0}})")
    assert not page.complaints


def test_a_disk_is_set_and_rolls_as_polhode_says(opened, tmp_path):
    spec = tmp_path / "coin.toml"
    spec.write_text(
        '[system]\nkind = "euler-disk"\nmass = "30 g"\nradius = "20 mm"\nthickness = "3 mm"\ntilt = "20 deg"\n'
        'dissipation = [{ law = "rolling-couple", arm = "20 um" },\n'
        '  { law = "dry-contour-friction", coefficient = 1e-4 }]\n'
        '[time]\nuntil = "0.3 s"\nsamples = 300\n'
    )
    page = opened(write_page(read_spec(spec).report().trajectory, tmp_path / "coin.html"))
    page.tab.evaluate("window.polhode.set({system: {tilt: 0.25, radius: 0.03}, dissipation: {'rolling-couple': 1e-5}})")
    settings = settings_of(page)
    assert settings["dissipation"] == {"rolling-couple": 1e-5, "dry-contour-friction": 1e-4}
    again = tmp_path / "again.toml"
    again.write_text(page.tab.evaluate("window.polhode.spec()"))
    found = replace(read_spec(again), until=0.5, samples=500).report().trajectory
    assert miss_of(found, page) < STEPPED_SAME
    page.seek(50)
    coin, contact = page.measure("disk")["coin"], page.measure("disk")["point"]
    time = page.times()[50]
    states = ph.simulate(found.source, found.states[0], [0.0, time]).states[-1]
    assert contact[:2] == pytest.approx(states[3:5] / 0.03, abs=1e-6)
    assert coin[12:15] == pytest.approx(np.asarray(found.source.center(states)) / 0.03, abs=1e-6)
    for wrong in ("{system: {tilt: 2}}", "{dissipation: {'air-layer': -1}}", "{dissipation: {glue: 1}}"):
        assert page.tab.evaluate(f"window.polhode.set({wrong})") is False and settings_of(page) == settings
    page.tab.evaluate("window.polhode.goTo(1e4)")  # long after it has come to lie flat
    assert "flat" in page.tab.locator("#facts").text_content() or page.tab.evaluate("window.polhode.state(1e4)")
    assert not page.complaints


def rotation_between(one, two):
    """Cosine of half the angle between two quaternions of unit length."""
    return abs(float(np.dot(one, two)))


def miss_of(trajectory, page):
    """How far the page's states are from the samples, at three of them."""
    rows = [0, len(trajectory) // 3, len(trajectory) // 2]
    found = drawn(page, [float(trajectory.times[k]) for k in rows])
    wanted = trajectory.attitude[rows], trajectory.momentum[rows]
    sign = np.sign(np.sum(np.asarray(found[0]) * wanted[0], axis=1, keepdims=True))
    return max(np.abs(sign * found[0] - wanted[0]).max(), np.abs(found[1] - wanted[1]).max())


def test_axes_are_counted_as_in_a_spec_whatever_the_order_of_the_moments(book, opened, tmp_path):
    page = opened(book)
    for moments in ((3, 1, 2), (1, 3, 2), (2, 1, 3), (3, 2, 1), (1, 2, 3)):
        for about in (1, 2, 3):
            tables = f"{{body: {{moments: {list(moments)}}}, spin: {{rate: 2, about: {about}, tilt: 0.3}}}}"
            assert page.tab.evaluate(f"window.polhode.set({tables})")
            spec = tmp_path / "ordered.toml"
            spec.write_text(f'[body]\nmoments = {[f"{x} kg*m^2" for x in moments]}\n'
                            f'[spin]\nrate = "2 rad/s"\nabout = {about}\ntilt = "0.3 rad"\n')  # fmt: skip
            wanted = read_spec(spec).report().motion
            axes = ph.Body.from_moments(tuple(map(float, moments))).principal_axes
            found = settings_of(page)["spin"]["angular_velocity"]
            velocity = np.asarray(wanted.momentum_at_epoch) / np.asarray(wanted.moments)
            assert found == pytest.approx(axes @ velocity, abs=1e-14), (moments, about)
    before = settings_of(page)
    assert page.tab.evaluate("window.polhode.set({body: {moments: [1, 2, 5]}})") is False
    assert "No rigid body has these" in page.tab.locator("#refused").text_content() and settings_of(page) == before


def test_what_is_typed_wrong_is_said_and_marked(book, opened):
    page = opened(book)
    before = settings_of(page)
    field = page.tab.locator("#set-spin-rate")
    for typed in ("abc", "0", "-5", ""):
        field.fill(typed)
        field.press("Enter")
        assert field.get_attribute("aria-invalid") == "true" and page.tab.locator("#refused").text_content(), typed
        assert settings_of(page) == before
        field.fill("7")
        field.press("Enter")
        assert field.get_attribute("aria-invalid") is None and settings_of(page) != before
        page.tab.locator("#reset").click()
        assert settings_of(page) == before and not page.tab.locator("#refused").text_content()


def test_a_top_at_rest_upright_or_hanging_is_drawn(toy, opened):
    page = opened(toy)
    for lean in (0.0, np.pi):
        tables = f"{{system: {{lean: {lean}}}, spin: {{spin: 0, precession: 0, nutation_rate: 0}}}}"
        assert page.tab.evaluate(f"window.polhode.set({tables})")
        page.seek(100)
    assert not page.complaints
