"""The doors by which numbers come in, each with all its places, found from the package itself."""

from __future__ import annotations

import re
import shutil
import tempfile
import warnings
from collections.abc import Callable, Iterator
from functools import cache, partial
from pathlib import Path
from random import Random
from typing import Any, NamedTuple

import numpy as np

from cli.ends import COMMANDS, EXAMPLE, GIVEN, NUMBER, options_of, with_option, write_given
from formats.reader_fuzz import in_text, read_form, specimens
from judged import Outcome, bounded, faults_of, run
from laws.test_precision import ENTRIES
from polhode.errors import InvalidInput, PolhodeError
from polhode.kinds.reading import read_spec
from polhode.spacecraft.formats.mjcf import read_mjcf_robot
from polhode.spacecraft.formats.sdf import read_sdf_inertial
from spacecraft.test_other_programs import CASES, OMEGA, TIMES, lines
from spacecraft.test_robots import MJCF, SDF
from spec.ends import changed, host_of, hosts_of, keys_of
from spec.mutations import EXAMPLES, FILES

PLACE = "0.123456789"
"""A number that no specimen holds; another text is put in its place."""
TRIED = 30
"""Numbers of a file of which three are taken; a third or more of each file's are read."""
READ_SECONDS = 5.0
"""Of the processor, for one reading: a hundred times what the slowest needs."""


class Refused(NamedTuple):
    """The message with which a value was refused."""

    message: str


# ---------------------------------------------------------------- arguments of functions

def put(value: Any, other: Any) -> Any:
    """Return an argument whose first number is replaced."""
    if np.ndim(value) == 0:
        return other
    numbers = np.array(value, dtype=object)
    numbers.flat[0] = other
    return numbers.tolist()


def call_with(entry: str, other: Any) -> Any:
    """Call a public function with another first number; warnings are errors."""
    value, call = ENTRIES[entry]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        try:
            return call(put(value, other))
        except InvalidInput as error:
            return Refused(str(error))


# ---------------------------------------------------------------- specs


def specs_with(kind: str, folder: Path) -> Iterator[tuple[str, Callable[[str], str]]]:
    """Yield the keys of a kind's specs that hold a number, each with the text of a spec for a numeral there."""
    for name in FILES:
        shutil.copy(EXAMPLES / name, folder)
    hosts = hosts_of(kind, folder)
    for key in keys_of(kind):
        if key.form != "number" or (host := host_of(key, hosts, folder)) is None:
            continue
        made = changed(host, key, f"{PLACE} {key.unit}".strip() if key.unit else float(PLACE))
        if made is not None and (text := as_toml(made)).count(PLACE) == 1:
            yield str(key), lambda numeral, text=text: text.replace(PLACE, numeral)


def as_toml(tables: dict[str, Any]) -> str:
    """Return tables as TOML, inner ones in braces."""
    return "".join(f"{name} = {_inline(value)}\n" for name, value in tables.items())


def _inline(value: Any) -> str:
    if isinstance(value, dict):
        return "{" + ", ".join(f'"{name}" = {_inline(item)}' for name, item in value.items()) + "}"
    if isinstance(value, list | tuple):
        return "[" + ", ".join(map(_inline, value)) + "]"
    if isinstance(value, bool):
        return str(value).lower()
    return repr(value) if isinstance(value, int | float) else '"' + str(value).replace("\\", "\\\\") + '"'


def read_spec_of(text: str, folder: Path) -> Refused | None:
    """Read a spec; its own message is returned where it is refused."""
    path = folder / "case.toml"
    path.write_text(text)
    with bounded(READ_SECONDS):
        try:
            read_spec(path)
        except PolhodeError as error:
            return Refused(str(error))
    return None


# ---------------------------------------------------------------- data files


class DataFile(NamedTuple):
    """A file of text that a reader reads.

    Attributes:
        form: of ``polhode.formats``, "" for files that are no motions.
        name: of the file.
        text: of it.
        read: its reader.
        beside: further files in its folder, by name.
    """

    form: str
    name: str
    text: str
    read: Callable[[Path], Any]
    beside: dict[str, str]


@cache
def data_files() -> dict[str, DataFile]:
    """Return one file for each reader of text: of reader_fuzz.py, of other programs, and of robots."""
    found = {}
    with tempfile.TemporaryDirectory() as folder:
        for name, one in specimens(Path(folder) / "whole", []).items():
            if one.damage is in_text:
                found[name] = DataFile(Path(name).suffix[1:], name, one.path.read_text("utf-8"), one.read, {})
    beside = {"time.42": "".join(f"{t:f}\n" for t in TIMES), "wbn.42": lines(OMEGA, form="{:e}", sign=" ")}
    for title, (name, text, form, _) in CASES.items():
        found[title] = DataFile(form, name, text, partial(read_form, form), beside if form == "42" else {})
    found["sdf"] = DataFile("", "arm.sdf", SDF, lambda path: read_sdf_inertial(path, "base"), {})
    found["mjcf"] = DataFile("", "arm.xml", MJCF, lambda path: read_mjcf_robot(path, {}), {})
    return found


WORD = re.compile(r"(?<![\w.+-])[+-]?\d+\.\d+(?:[eE][+-]?\d+)?(?![\w.-])")
"""A number with a point: what a file measures, not its counts and dates."""


def numbers_of(name: str, folder: Path) -> list[tuple[int, int]]:
    """Return where three numbers of a file are that its reader reads: it refuses a word in their place."""
    text = data_files()[name].text
    places = [found.span() for found in WORD.finditer(text)]
    word = '"word"' if name.endswith("gltf") else "word"
    drawn = Random(name).sample(places, min(TRIED, len(places)))
    return [place for place in drawn if read_changed(name, place, word, folder) is not None][:3]


def read_changed(name: str, place: tuple[int, int], numeral: str, folder: Path) -> Refused | None:
    """Read a file with another text at a place; its own message is returned where it is refused."""
    given = data_files()[name]
    for other, text in given.beside.items():
        (folder / other).write_text(text)
    path = folder / given.name
    path.write_text(given.text[: place[0]] + numeral + given.text[place[1] :])
    with bounded(READ_SECONDS):
        try:
            given.read(path)
        except InvalidInput as error:
            return Refused(str(error))
    return None


# ---------------------------------------------------------------- options of commands


def options_with_numbers() -> list[tuple[str, str]]:
    """Return commands with those of their options whose help has an example with a number."""
    return [(command, option.opts[0]) for command in GIVEN for option in options_of(command)
            if (example := EXAMPLE.search(option.help or "")) and NUMBER.search(example[1])]  # fmt: skip


def run_with(command: str, name: str, numeral: str, folder: Path) -> tuple[list[str], Outcome]:
    """Run a command with a numeral in place of an option's first number; return what is wrong, and how it ended."""
    option = next(one for one in options_of(command) if name in one.opts)
    text = NUMBER.sub(lambda _: numeral, EXAMPLE.search(option.help)[1].rstrip(". "), count=1)
    arguments = [command, *with_option(GIVEN[command][0], option, [text])]
    write_given(folder)
    outcome = run(arguments, folder)
    return faults_of(outcome, " ".join(arguments)), outcome


def commands() -> set[str]:
    """Return the names of all commands."""
    return set(COMMANDS)
