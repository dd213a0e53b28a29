"""A gyro log on the page: dropped or chosen, asked about, fitted and drawn over the exact motion, or refused."""

import json
import re

import numpy as np
import pytest

from polhode.kinds import playground
from polhode.measuring.throws.gyro_logs import read_gyro_log
from polhode.measuring.throws.throw import fit_throw
from viewer.test_throw import BAD, BODIES, EXAMPLE, LOGS, ROOT


@pytest.fixture(scope="module")
def playground_page(tmp_path_factory):
    examples = {"smartphone": ROOT / "examples" / "smartphone.toml"}
    with pytest.MonkeyPatch.context() as patch:
        few = [one for one in playground.presets() if one["example"] in examples]
        patch.setattr(playground, "presets", lambda: few)
        return playground.write_playground(tmp_path_factory.mktemp("logs") / "playground.html", examples)


def choose(page, path):
    page.tab.locator("#log input[type=file]").set_input_files(str(path))


@pytest.mark.browser
@pytest.mark.parametrize("options", [{}, {"viewport": {"width": 390, "height": 780}}], ids=["desktop", "phone"])
def test_a_log_is_drawn_along_the_exact_motion(playground_page, opened, options):
    page = opened(playground_page, **options)
    choose(page, EXAMPLE)
    page.until("document.getElementById('name').textContent === 'phone_throw.csv'")
    found = page.measure("sphere")
    measured = np.reshape(found["measured"], (-1, 3))
    assert len(measured) == 70 and np.allclose(np.linalg.norm(measured, axis=1), 1.0)
    settings = page.tab.evaluate("window.polhode.settings()")
    moments = np.array(settings["body"]["moments"])
    curve = np.reshape(found["path"], (-1, 3))
    away = np.arccos(np.clip((measured @ curve.T).max(axis=1), -1, 1))
    assert np.median(away) < 1e-3 and away.max() < 5e-3  # 2e-3 rad/s of noise beside 9 rad/s
    # at the log's own times the motion is where the samples are
    read = read_gyro_log(EXAMPLE).log
    inside = read.times[(read.times >= 1.2 - 1e-9) & (read.times <= 1.89 + 1e-9)]
    states = [page.tab.evaluate("t => window.polhode.state(t).momentum", float(t)) for t in inside]
    states = np.array(states) / np.linalg.norm(states, axis=1)[:, None]
    assert np.linalg.norm(states - measured, axis=1).max() < 5e-3
    wanted = fit_throw(read, drag=False, gain=False).ratios.value
    assert moments[2] == 1.0 and moments[:2] == pytest.approx(wanted, abs=1e-3)
    story = page.tab.locator("#story").text_content()
    assert "phyphox" in story and "accelerometer feels no weight" in story and "noise" in story
    page.tab.locator("#theme").click()
    page.tab.locator("#presets button").first.click()
    assert page.measure("sphere")["measured"] is None
    assert page.tab.evaluate("document.documentElement.scrollWidth <= window.innerWidth")
    assert not page.complaints and all(url.startswith(("file:", "data:", "blob:")) for url in page.requests)


@pytest.mark.browser
def test_a_dropped_file_is_taken_and_columns_are_asked_for(playground_page, opened):
    page = opened(playground_page)
    text, _ = LOGS["own_table"]()
    page.tab.evaluate("""text => {
      const data = new DataTransfer();
      data.items.add(new File([text], "board.txt"));
      for (const type of ["dragover", "drop"])
        window.dispatchEvent(new DragEvent(type, { dataTransfer: data, cancelable: true, bubbles: true }));
    }""", text)  # fmt: skip
    page.until("!document.getElementById('log-columns').hidden")
    assert "Choose what the columns are" in page.tab.locator("#log-said").text_content()
    fields = page.tab.locator("#log-columns select")
    for k, value in enumerate(("0", "ns", "1", "2", "3")):
        fields.nth(k).select_option(value)
    page.tab.locator("#log-columns button").click()  # a unit is missing: the browser asks for it
    assert page.tab.locator("#name").text_content() != "board.txt"
    fields.nth(5).select_option("deg/s")
    page.tab.locator("#log-columns button").click()
    page.until("document.getElementById('name').textContent === 'board.txt'")
    moments = page.tab.evaluate("window.polhode.settings().body.moments")
    assert moments == pytest.approx(BODIES["book"], abs=0.01)
    assert not page.complaints


@pytest.mark.browser
def test_a_log_is_told_in_the_readers_language(playground_page, opened, tmp_path):
    page = opened(playground_page, locale="de-DE")
    assert page.tab.locator("#log button").first.text_content() == "Gyro-Aufzeichnung öffnen…"
    path = tmp_path / "empty.csv"
    path.write_text("")
    choose(page, path)
    page.until("document.getElementById('log-said').textContent.endsWith('je Zeile.')")
    choose(page, EXAMPLE)
    page.until("document.getElementById('name').textContent === 'phone_throw.csv'")
    story = page.tab.locator("#story").text_content()
    assert "Beschleunigungsmesser" in story and re.search(r"I1/I3 = 0,\d{3}; I2/I3", story) and "Rauschens" in story
    page.tab.locator("#language").select_option("es")  # the log is read again
    page.until("document.querySelector('#story').textContent.includes('acelerómetro')")
    assert page.tab.locator("#name").text_content() == "phone_throw.csv" and not page.complaints


@pytest.mark.browser
def test_a_bad_file_leaves_the_page_as_it_was(playground_page, opened, tmp_path):
    page = opened(playground_page)
    before = page.tab.locator("#name").text_content()
    for name, (text, words) in BAD.items():
        path = tmp_path / f"{name}.csv"
        path.write_bytes(text.encode("latin-1"))
        if name in ("unknown columns", "no unit"):
            continue  # they are asked for
        choose(page, path)
        said = "document.getElementById('log-said').textContent"
        page.until(f"{said}.startsWith({json.dumps(path.name)}) && !{said}.endsWith('fitting…')")
        said = page.tab.locator("#log-said").text_content()
        assert words in said, (name, said)
    zipped = tmp_path / "log.zip"
    zipped.write_bytes(b"PK\x03\x04 and more")
    choose(page, zipped)
    page.until("document.getElementById('log-said').textContent.includes('zip archive')")
    assert page.tab.locator("#name").text_content() == before and not page.complaints
