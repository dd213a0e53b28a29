"""The picture of core, application and wings is that of the import contracts, and changes with them."""

import importlib.util
import re
from copy import deepcopy
from itertools import chain
from pathlib import Path
from xml.etree import ElementTree

import pytest

ROOT = Path(__file__).parents[1]
SPEC = importlib.util.spec_from_file_location("core_and_wings", ROOT / "docs" / "core_and_wings.py")
assert SPEC and SPEC.loader
picture = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(picture)
DRAWN = picture.PICTURE.read_text("utf-8")
SVG = "{http://www.w3.org/2000/svg}"


def contract_of(contracts, kind):
    (one,) = (contract for contract in contracts if contract["type"] == kind)
    return one


def changed_contracts(layer=None, listed="wings", name="orreries"):
    """Return the contracts with one more room: in a layer, and in a list of the contract of wings."""
    contracts = deepcopy(picture.read_contracts())
    layers = contract_of(contracts, "layers")["layers"]
    if layer is not None:
        layers[layer] += f" | {name}"
    if listed:
        contract_of(contracts, "wings")[listed].append(name)
    return contracts


def test_the_committed_picture_is_drawn_from_the_contracts():
    assert picture.draw(picture.read_contracts()) == DRAWN, "run `python docs/core_and_wings.py`, and look at it"


@pytest.mark.parametrize(("layer", "listed"), [(0, "wings"), (2, "application"), (-1, None)])
def test_one_more_room_changes_the_picture(layer, listed):
    drawn = picture.draw(changed_contracts(layer, listed))
    assert drawn != DRAWN and ">orreries</text>" in drawn


@pytest.mark.parametrize(("layer", "listed", "rule"), [
    (None, "wings", "needs a layer"), (None, "application", "needs a layer"), (0, None, "must be above"),
    (-1, "wings", "must be above"), (0, "application", "must be above"),
])  # fmt: skip
def test_contracts_that_contradict_each_other_are_not_drawn(layer, listed, rule):
    with pytest.raises(ValueError, match=rule):
        picture.draw(changed_contracts(layer, listed))


def test_the_picture_has_each_room_in_its_row():
    """Read from the file as a reader sees it: the rows from above are the layers, but that wings may fill two."""
    contracts, rows = picture.read_contracts(), {}
    for text in ElementTree.fromstring(DRAWN).iter(f"{SVG}text"):
        if text.get("class") == "room":
            rows.setdefault(float(text.get("y")), []).append(text.text)
    seen = [rows[y] for y in sorted(rows)]
    layers = [layer.split(" | ") for layer in contract_of(contracts, "layers")["layers"]]
    wings = len(seen) - len(layers) + 1
    assert [*chain(*seen[:wings])] == layers[0] and seen[wings:] == layers[1:]


def test_no_name_leaves_its_box():
    root = ElementTree.fromstring(changed := picture.draw(changed_contracts(0, "wings", "gravitational_waves")))
    boxes = [box for box in root.iter(f"{SVG}rect") if box.get("class").startswith("box")]
    names = [text.text for text in root.iter(f"{SVG}text") if text.get("class") == "room"]
    assert len(boxes) == len(names) and "gravitational_waves" in changed
    for box, name in zip(boxes, names, strict=True):
        assert float(box.get("width")) >= picture.LETTER * len(name)


def test_the_picture_is_said_to_those_who_hear_it():
    root = ElementTree.fromstring(DRAWN)
    title, words = (root.find(f"{SVG}{name}") for name in ("title", "desc"))
    assert root.get("role") == "img" and root.get("aria-labelledby") == title.get("id") and title.text
    assert root.get("aria-describedby") == words.get("id")
    layers = contract_of(picture.read_contracts(), "layers")["layers"]
    assert set(re.findall(r"\w+", " ".join(layers))) <= set(re.findall(r"\w+", words.text))
