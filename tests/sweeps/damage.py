"""Ways to damage the store of a sweep: each takes its folder and a random generator, and may say what it did."""

import hashlib
import json
import os
import re
import shutil
import socket
import tempfile
from pathlib import Path

SEALED = re.compile(rb"[0-9a-f]{64}\n")
DEEP = "[" * 20000 + "]" * 20000
HOSTILE = ("null", "[]", "{}", "0", "-1", "NaN", "Infinity", "1e999", "1" + "0" * 5000, '"\\ud800"', "true", "[1, 2]",
           '"../../../../etc/passwd"', '{"a": ' * 3000 + "1" + "}" * 3000, DEEP, '"\\u0000"', "", "\x00", "{", '"x"',
           "-9223372036854775809", "1e-400", '[["", {}]]', "9" * 30)  # fmt: skip
CODECS = ("null", '{"id": "pickle"}', '{"id": "zlib", "level": 1}', '{"id": "zstd"}', '"blosc"', '{"id": 7}', "{}",
          '{"id": "blosc", "cname": "none"}', '{"id": "../x"}', '{"id": "lz4"}')  # fmt: skip
OF_ARRAYS = {
    "shape": ("[7]", "[]", "[-1]", "[1e9]", "[9223372036854775807]", '["150"]', "[149]", "[151]", "[0]", "[150, 1]"),
    "chunks": ("[7]", "[0]", "[]", "[-40]", "[41]", "[9223372036854775807]"),
    "dtype": ('"|O"', '"<f4"', '">f8"', '"<U1"', '"<U999999999"', '[["a", "<f8"]]', '"<i8"', '"junk"', '"<M8[s]"'),
    "fill_value": ("0", '"0"', '"Infinity"', "null", "[]", '"x"', "1e300"), "compressor": CODECS,
    "filters": ("[]", '[{"id": "pickle"}]', '[{"id": "delta", "dtype": "<f8"}]', "7"),
    "order": ('"F"', '"Z"', "7"), "zarr_format": ("3", "1", '"2"', "null"), "dimension_separator": ('"/"', '"x"', "7"),
}  # fmt: skip


class NothingThere(Exception):
    """The store has nothing that could be damaged so."""


def files(store, part=""):
    """Return the files of a store whose path has this in it, in a settled order."""
    return [path for path in sorted(store.rglob("*")) if path.is_file() and part in str(path.relative_to(store))]


def pick(rng, items):
    if not len(items):
        raise NothingThere
    return items[int(rng.integers(len(items)))]


def any_file(store, rng):
    """Return a file; marks, the plan and metadata as often as data."""
    part = pick(rng, ("/chunks/", "plan", ".z", "", ""))
    return pick(rng, files(store, part) or files(store))


# ---------------------------------------------------------------------- bytes


def truncate(store, rng):
    path = any_file(store, rng)
    os.truncate(path, int(rng.integers(path.stat().st_size + 1)))


def flip_bit(store, rng):
    path = any_file(store, rng)
    content = bytearray(path.read_bytes())
    if content:
        content[int(rng.integers(len(content)))] ^= 1 << int(rng.integers(8))
    path.write_bytes(content)


def spoil_head(store, rng):
    path = any_file(store, rng)
    content = path.read_bytes()
    path.write_bytes(rng.bytes(min(16, len(content))) + content[16:])


def junk(store, rng):
    any_file(store, rng).write_bytes(rng.bytes(int(rng.integers(200))))


def append(store, rng):
    path = any_file(store, rng)
    path.write_bytes(path.read_bytes() + pick(rng, (b"\0", b"x" * 1000, path.read_bytes())))


# ---------------------------------------------------------------------- files


def lose(store, rng):
    any_file(store, rng).unlink()


def swap(store, rng):
    a = any_file(store, rng)
    b = pick(rng, [path for path in files(store) if path.suffix == a.suffix and path != a] or files(store))
    first, second = a.read_bytes(), b.read_bytes()
    a.write_bytes(second)
    b.write_bytes(first)


def swap_chunks(store, rng):
    """Swap two chunks of an array, or two marks."""
    a = pick(rng, [path for path in files(store) if re.match(r"\d+\b", path.name) and path.parent.name != "time"])
    b = pick(rng, [path for path in files(a.parent) if path != a and re.match(r"\d+\b", path.name)])
    first, second = a.read_bytes(), b.read_bytes()
    a.write_bytes(second)
    b.write_bytes(first)


def second_mark(store, rng):
    path = pick(rng, files(store, "/chunks/"))
    number = int(path.stem)
    names = (f"{number}", f"{number:012d}", f"{number:08d}", f"{number + 50:09d}", "９", "٣", f"{10**30}", "-1", "",
             "x", f" {number:09d}", f"+{number}")  # fmt: skip
    shutil.copy(path, path.with_name(f"{pick(rng, names)}{path.suffix}"))


def rename(store, rng):
    path = any_file(store, rng)
    path.rename(path.with_name(pick(rng, (path.name + "~", "1", "junk", ".zattrs", "zarr.json"))))


def pipe(store, rng):
    path = any_file(store, rng)
    path.unlink()
    os.mkfifo(path)


def pipe_for_chunk(store, rng):
    path = pick(rng, [path for path in files(store) if re.match(r"\d+\b", path.name)])
    path.unlink()
    os.mkfifo(path)


def link(store, rng):
    path = any_file(store, rng)
    aside = Path(tempfile.mkdtemp(dir=store.parent)) / "aside"
    path.rename(aside)
    path.symlink_to(pick(rng, (aside, "/dev/zero", "/nowhere", path, "/dev/stdin", "..", "/etc/passwd")))


def folder_for_file(store, rng):
    path = any_file(store, rng)
    path.unlink()
    path.mkdir()
    if rng.random() < 0.5:
        (path / "0").write_bytes(b"")


def file_for_folder(store, rng):
    path = pick(rng, [path for path in sorted(store.rglob("*")) if path.is_dir()])
    shutil.rmtree(path)
    path.write_bytes(rng.bytes(9))


def link_for_folder(store, rng):
    path = pick(rng, [path for path in sorted(store.rglob("*")) if path.is_dir()])
    aside = Path(tempfile.mkdtemp(dir=store.parent)) / "aside"
    path.rename(aside)
    path.symlink_to(pick(rng, (aside, "/dev", "/nowhere", path)))


def lose_folder(store, rng):
    shutil.rmtree(pick(rng, [path for path in sorted(store.rglob("*")) if path.is_dir()]))


def rename_folder(store, rng):
    path = pick(rng, [path for path in sorted(store.rglob("*")) if path.is_dir()])
    path.rename(path.with_name(pick(rng, ("other", "form~", ".partial"))))


def huge(store, rng):
    os.truncate(any_file(store, rng), int(pick(rng, (3 * 10**9, 2**40))))


def sockets(store, rng):
    path = any_file(store, rng)
    path.unlink()
    place = Path.cwd()
    os.chdir(path.parent)  # names of sockets have some hundred characters at most
    try:
        with socket.socket(socket.AF_UNIX) as made:
            made.bind(path.name)
    finally:
        os.chdir(place)


def strangers(store, rng):
    """Put something in that no sweep wrote."""
    place = pick(rng, [store, *(path for path in sorted(store.rglob("*")) if path.is_dir())])
    name = pick(rng, (".DS_Store", "x.partial", "zarr.json", "99", "5.0.0", ".000000001.json.9", "junk.json", "..."))
    if rng.random() < 0.3:
        os.mkfifo(place / name)
    elif rng.random() < 0.3:
        (place / name).mkdir(exist_ok=True)
    else:
        (place / name).write_bytes(rng.bytes(7))


# ---------------------------------------------------------------------- what is written in them


def hostile_document(store, rng):
    part = pick(rng, ("/chunks/", "plan.json", ".zarray", ".zmetadata", ".zattrs", ".zgroup"))
    path = pick(rng, files(store, part))
    path.write_text(pick(rng, HOSTILE), "utf-8", errors="surrogatepass")


def hostile_plan(store, rng):
    path = store / ".sweep" / "plan.json"
    found = json.loads(path.read_text())
    key = pick(rng, [*found, "other"])
    _write(path, found | {key: _Raw(pick(rng, HOSTILE))})


def hostile_mark(store, rng):
    """Change a value within a mark, whose seal no longer fits."""
    path = pick(rng, files(store, "/chunks/"))
    seal, found = _mark(path)
    _write(path, _changed(found, rng), seal)


def forged_mark(store, rng):
    """Change a value within a mark and seal it anew, as somebody may who knows how."""
    path = pick(rng, files(store, "/chunks/"))
    seal, found = _mark(path)
    _write(path, _changed(found, rng), seal and b"new")


def negative_counts(store, rng):
    path = pick(rng, files(store, "/chunks/"))
    seal, found = _mark(path)
    text = re.sub(r'"count": \d+', f'"count": {pick(rng, (-5, 0, 10**9, 1.5, 10**400))}', json.dumps(found))
    path.write_bytes(_sealed(text.encode(), seal and b"new"))


def hostile_array(store, rng):
    path = pick(rng, files(store, ".zarray"))
    found = json.loads(path.read_text())
    key = pick(rng, list(OF_ARRAYS))
    _write(path, found | {key: _Raw(pick(rng, OF_ARRAYS[key]))})


def hostile_metadata(store, rng):
    path = store / ".zmetadata"
    found = json.loads(path.read_text())
    names = [name for name in found["metadata"] if name.endswith(".zarray")]
    if not names:
        path.write_text("{}")
        return
    key = pick(rng, list(OF_ARRAYS))
    found["metadata"][pick(rng, names)][key] = _Raw(pick(rng, OF_ARRAYS[key]))
    _write(path, found)


def _mark(path):
    content = path.read_bytes()
    seal = SEALED.match(content)
    return (seal.group() if seal else b""), json.loads(content[seal.end() if seal else 0 :])


def _sealed(content, seal):
    """Return a mark's bytes with its old seal, or a new one; without where marks have none."""
    new = hashlib.sha256(content).hexdigest().encode() + b"\n"
    return (new if seal == b"new" else seal) + content


class _Raw(str):
    """What goes into JSON as it is."""


def _write(path, value, seal=b""):
    raws = []

    def held(one):
        if isinstance(one, _Raw):
            raws.append(str(one))
            return f"@raw{len(raws) - 1}@"
        if isinstance(one, dict):
            return {key: held(item) for key, item in one.items()}
        return [held(item) for item in one] if isinstance(one, list) else one

    text = json.dumps(held(value))
    for k, raw in enumerate(raws):
        text = text.replace(f'"@raw{k}@"', raw)
    path.write_bytes(_sealed(text.encode("utf-8", errors="surrogatepass"), seal))


def _changed(value, rng):
    """Return JSON with one value in it replaced, lost, or with another beside it."""
    if isinstance(value, dict) and value and rng.random() < 0.85:
        key = pick(rng, list(value))
        how = rng.random()
        if how < 0.1:
            return {name: item for name, item in value.items() if name != key}
        if how < 0.2:
            return {**value, "other": _Raw(pick(rng, HOSTILE))}
        return {**value, key: _changed(value[key], rng)}
    if isinstance(value, list) and value and rng.random() < 0.85:
        k = int(rng.integers(len(value)))
        return [*value[:k], _changed(value[k], rng), *value[k + 1 :]]
    if isinstance(value, int | float) and rng.random() < 0.5:
        return pick(rng, (value + 1, -value - 1, value * 2, value / 2, 1e308))
    return _Raw(pick(rng, HOSTILE))


WAYS = (truncate, flip_bit, spoil_head, junk, append, lose, swap, swap_chunks, second_mark, rename, pipe,
        pipe_for_chunk, link, folder_for_file, file_for_folder, link_for_folder, lose_folder, rename_folder, huge,
        sockets, strangers, hostile_document, hostile_plan, hostile_mark, forged_mark, negative_counts, hostile_array,
        hostile_metadata)  # fmt: skip
