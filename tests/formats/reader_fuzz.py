"""Files of every reader, damaged at random, read one after another in a process of their own.

``python reader_fuzz.py SEED COUNT FOLDER SPECIMEN…`` reads COUNT damaged copies of each specimen and prints in JSON
what was neither read nor refused in one message. A case that hangs or kills the process is the one in FOLDER/case.
"""

from __future__ import annotations

import json
import random
import re
import resource
import shutil
import signal
import struct
import sys
import traceback
import warnings
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

import polhode as ph
from polhode import formats, spacecraft, spectra
from polhode.errors import InvalidInput
from polhode.formats.form import Kernels
from polhode.spectra import DEBYE, MeasuredLines, Rotor
from polhode.studies.sources import read_recorded

CPU_SECONDS, WALL_SECONDS = 10, 300  # a case may take; the second is for what waits
MORE_MEMORY = 10**9  # bytes that a case may add to the process
LONGEST_MESSAGE = 3000  # characters
EXAMPLES = Path(__file__).parents[2] / "examples"
MOTION = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 0.4, 0.5))
LABELS = formats.AttitudeLabels("BOX", epoch="2026-03-01T12:00:00.5", time_system="TAI", spice_id=-777)
NUMBERS = ("0", "-1", "1e300", "-1e300", "1e400", "1e-400", "nan", "inf", "2_5", "１", "0x10", "999999999999",
           "4294967295", "-2147483649", "9" * 400, "1e", "", "½", "1,5", "--1", "9" * 5000, "1e-310", "2")  # fmt: skip
WORDS = ("\0", "\x1b[31m", "\ud7ff", "é" * 50, "A" * 20_000, "<!DOCTYPE a>", "&lol;", "../../etc/passwd", "{", "]",
         '"', "=", "META_START", "DATA_STOP", "\\begindata", "end_header", "endsolid", "f -9 1 2", "VEC1 0 0 0",
         ",,,,")  # fmt: skip
JSON = (None, True, -1, 0, 2**31, 2**70, 1e300, "", "x", "|O", "<f8", "<U9", [], {}, [1, 2], {"id": "pickle"},
        {"id": "zlib"}, [0], [10**12], [[[]]], "NaN",
        float("nan"), {"id": "blosc", "cname": "zstd", "clevel": 99, "shuffle": 9})  # fmt: skip


class Specimen(NamedTuple):
    """A file or folder, how to damage it, and how to read it."""

    path: Path
    damage: Callable[[random.Random, Path], None]
    read: Callable[[Path], Any]


# ---------------------------------------------------------------- damage


def spot(chance: random.Random, length: int) -> tuple[int, int]:
    """Return begin and end of a short stretch."""
    begin = chance.randrange(length + 1)
    return begin, min(length, begin + int(2 ** chance.uniform(0, 9)))


def in_bytes(chance: random.Random, path: Path) -> None:
    content = bytearray(path.read_bytes())
    for _ in range(chance.choice((1, 1, 1, 2, 5))):
        a, b = spot(chance, len(content))
        form = chance.choice("<>")
        values = (struct.pack(f"{form}i", chance.choice((-1, 0, 1, 2**31 - 1, -(2**31), 1000, 65536))),
                  struct.pack(f"{form}d", chance.choice((np.nan, np.inf, 1e308, -1.0, 0.0, 2.0**31, 1e-308))),
                  struct.pack(f"{form}h", chance.choice((-1, 0, 32767, 256))))  # fmt: skip
        patch = chance.choice(values)
        aligned = a - a % len(patch)
        ways: list[Callable[[], bytes | bytearray]] = [
            lambda a=a, c=content: c[:a],
            lambda a=a, b=b, c=content: c[:a] + c[b:],
            lambda a=a, b=b, c=content: c[:b] + c[a:],
            lambda a=a, b=b, c=content: c[:a] + bytes(b - a) + c[b:],
            lambda a=a, b=b, c=content: c[:a] + chance.randbytes(b - a) + c[b:],
            lambda a=a, b=b, c=content: c[:a] + chance.randbytes(b - a) + c[a:],
            lambda p=patch, a=aligned, c=content: c[:a] + p + c[a + len(p) :],
            lambda a=a, c=content: c[:a] + bytes([c[a] ^ 1 << chance.randrange(8)]) + c[a + 1 :] if a < len(c) else c,
        ]
        content = bytearray(chance.choice([*ways, *ways[-2:] * 4])())
    path.write_bytes(content)


def in_text(chance: random.Random, path: Path) -> None:
    if chance.random() < 0.2:
        return in_bytes(chance, path)
    text = path.read_bytes().decode("utf-8", "surrogateescape")
    for _ in range(chance.choice((1, 1, 1, 2, 5))):
        lines = text.splitlines(keepends=True)
        k, j = (chance.randrange(len(lines)) if lines else 0 for _ in "kj")
        words = list(re.finditer(r"[^\s,\"'=<>]+", text))
        numbers = [word for word in words if re.fullmatch(r"[-+.\deE]+", word[0])]
        ways: list[Callable[[], str]] = [
            lambda lines=lines, k=k: "".join(lines[:k] + lines[k + 1 :]),
            lambda lines=lines, k=k, j=j: "".join(lines[:k] + lines[j : j + 3] + lines[k:]),
            lambda lines=lines, k=k: "".join(lines[:k]),
            lambda text=text: text.replace("\n", chance.choice(("\r", "\r\n", "\n\n", " ", "\f"))),
            lambda text=text: text.rstrip(),
        ]
        for found, choices in ((numbers, NUMBERS), (words, WORDS), (words, NUMBERS)):
            if found:
                word = chance.choice(found)
                ways += 3 * [lambda word=word, choices=choices, text=text:
                             text[: word.start()] + chance.choice(choices) + text[word.end() :]]  # fmt: skip
        text = chance.choice(ways)()
    path.write_bytes(text.encode(chance.choice((*("utf-8",) * 9, "utf-16")), "surrogateescape"))


def changed_json(chance: random.Random, value: Any) -> Any:
    """Return JSON of which one part is something else."""
    inside: list[Any] = list(value.items()) if isinstance(value, dict) else []
    if isinstance(value, list):
        inside = list(enumerate(value))
    if not inside or chance.random() < 0.25:
        return chance.choice(JSON)
    key, part = chance.choice(inside)
    copy = value.copy()
    if chance.random() < 0.15:
        del copy[key]
    else:
        copy[key] = changed_json(chance, part)
    return copy


def in_store(chance: random.Random, folder: Path) -> None:
    files = sorted(path for path in folder.rglob("*") if path.is_file())
    way = chance.random()
    if way < 0.6:
        path = chance.choice([file for file in files if file.name in (".zarray", ".zattrs")])
        path.write_text(json.dumps(changed_json(chance, json.loads(path.read_text()))))
    elif way < 0.65:
        chance.choice(files).unlink()
    else:
        in_bytes(chance, chance.choice(files))


def in_hdf5(chance: random.Random, path: Path) -> None:
    import h5py

    if chance.random() < 0.6:
        return in_bytes(chance, path)
    with h5py.File(path, "a") as file:
        name = chance.choice(sorted(file))
        variable = file[name]
        way = chance.randrange(6)
        if way == 0:
            del file[name]
        elif way == 1 and variable.shape and variable.dtype.kind == "f":
            variable[tuple(chance.randrange(n) for n in variable.shape)] = chance.choice((np.nan, np.inf, 1e300, -5.0))
        elif way == 2:
            shape = chance.choice(((), (0,), (1,), (3,), (20,), (20, 3), (2, 20, 4), (10**12,)))
            kind = chance.choice(("f8", "i4", "u1", "S3", "c16", h5py.string_dtype(), "f2", "?"))
            del file[name]
            file.create_dataset(name, shape, kind, chunks=(1000,) if shape == (10**12,) else None)
        elif way in (3, 4):
            place = chance.choice((variable, file))
            key = chance.choice([*place.attrs, "role", "drift", "place", "_FillValue", "scale_factor", "units", "axis"])
            wanted = chance.choice((1, 1e300, np.nan, "x", "state", "", np.zeros(3), np.array(["a", "b"], dtype=object),
                                    np.zeros(0), b"\xff", np.int64(-1), h5py.Empty("f8"), True))  # fmt: skip
            place.attrs[key] = wanted
        else:
            file[name + "x"] = chance.choice((h5py.SoftLink("/a"), h5py.ExternalLink("/dev/zero", "/a"), np.zeros(3)))
    return None


def in_kernels(chance: random.Random, path: Path) -> None:
    beside = path.with_suffix(chance.choice((".bc", ".bc", ".bc", ".tsc", ".tsc", ".tf", ".tls")))
    if beside == path:
        words = len(path.read_bytes()) // 8
        in_bytes(chance, path)
        content = path.read_bytes()
        if chance.random() < 0.5 and len(content) // 8 == words:  # where pointers and counts are
            place = chance.choice((1024 + 8 * chance.randrange(8), 76 + 4 * chance.randrange(3),
                                   8 * (words - 1 - chance.randrange(260))))  # fmt: skip
            number = struct.pack("<d", chance.choice((0.0, 1.0, 2.0, 3.0, -1.0, 1e9, 1e300, np.nan, 4.5)))
            pair = struct.pack("<ii", chance.choice((0, 1, 5, 6, 400, -9)), chance.choice((1, 2, 3, 99999)))
            value = chance.choice((number, pair))
            path.write_bytes(content[:place] + value + content[place + 8 :])
    else:
        in_text(chance, beside)


# ---------------------------------------------------------------- what has to come


def check_trajectory(found: Any) -> None:
    count = len(found.times)
    for values in (found.times, found.attitude, found.momentum, found.angular_velocity):
        assert values is None or np.isfinite(values).all(), "not finite"
    for values in (found.attitude, found.momentum, found.angular_velocity):
        assert values is None or values.shape[-2] == count, "of another length than its times"
    assert found.attitude is None or np.abs(np.linalg.norm(found.attitude, axis=-1) - 1).max(initial=0.0) < 1e-5


def read_trajectory(read: Callable[[Path], Any]) -> Callable[[Path], None]:
    return lambda path: check_trajectory(read(path))


def read_body(path: Path) -> None:
    body = spacecraft.read_urdf_inertial(path)
    assert np.isfinite([body.mass, *body.center_of_mass, *body.principal_moments, *body.principal_axes.ravel()]).all()


def read_mesh(path: Path) -> None:
    for repair in (False, True):
        vertices, faces = formats.read_mesh(path, 1e-3, repair)
        assert np.isfinite(vertices).all() and faces.min() >= 0 and faces.max() < len(vertices)
        try:
            assert np.isfinite(ph.Body.from_mesh(vertices, faces, mass=1.0).inertia).all()
        except InvalidInput:  # of the body, which has no path
            pass


def read_molecule(path: Path) -> None:
    symbols, positions, masses = formats.read_molecule(path)
    assert len(symbols) == len(positions) and np.isfinite(positions).all()
    try:
        assert np.isfinite(ph.Body.from_atoms(symbols, positions, masses).inertia).all()
    except InvalidInput:
        pass


def read_catalogue(path: Path) -> None:
    found = spectra.read_cat(path)
    assert np.isfinite([found.frequency, found.error, found.log_intensity, found.lower_energy]).all()
    assert len(found.frequency) == len(found.upper) == len(found.lower) == len(found.text or ())


def read_lines(path: Path) -> None:
    found = spectra.read_lin(path)
    assert np.isfinite([found.value, found.error, found.weight]).all() and found.upper.shape == found.lower.shape


def read_constants(path: Path) -> None:
    found = spectra.read_par(path)
    assert np.isfinite([found.value, found.error]).all() and len(found.code) == len(found.label)


PDB = "".join(f"ATOM  {k:5d}  {s}   HOH A   1    {x:8.3f}{0:8.3f}{1:8.3f}  1.00  0.00           {s}\n"
              for k, (s, x) in enumerate((("O", 0.0), ("H", 0.7), ("H", -0.7)), 1)) + "END\n"  # fmt: skip
MOL = "a\n\n\n  2  1  0  0  0  0  0  0  0  0999 V2000\n" + "".join(
    f"    0.0000    0.0000{z:10.4f} H   0  0\n" for z in (0.0, 0.74)) + "  1  2  1  0\nM  END\n"  # fmt: skip
ROTOR = Rotor((27e9, 14e9, 9e9), {"D_J": 1e3, "d1": -20.0}, "S", "Ir", dipole=(0.0, DEBYE, 0.0))
EXTXYZ = '2\nProperties=species:S:1:pos:R:3:masses:R:1 energy=-1.5 pbc="F F F"\nH 0 0 0 2.014\nH 0 0 0.74 1.008\n'


def specimens(folder: Path, names: list[str]) -> dict[str, Specimen]:
    """Write files of every reader by our own writers and trimesh's, and return those named, or all."""
    import trimesh

    folder.mkdir()
    motion = MOTION.sample(np.linspace(0.0, 5.0, 20))
    frame = ph.shapes.box(2.0, (1.0, 2.0, 3.0)).frame
    box = trimesh.creation.box((1.0, 2.0, 3.0))
    for name, options in {"a.stl": {}, "ascii.stl": {"file_type": "stl_ascii"}, "a.obj": {}, "a.ply": {},
                          "ascii.ply": {"encoding": "ascii"}, "a.off": {}, "a.glb": {}}.items():  # fmt: skip
        box.export(folder / name, **options)
    (folder / "a.gltf").write_text(embedded(box))
    for name, text in {"a.pdb": PDB, "a.mol": MOL, "ext.xyz": EXTXYZ}.items():
        (folder / name).write_text(text)
    shutil.copy(EXAMPLES / "water.xyz", folder / "water.xyz")
    spacecraft.write_urdf_inertial(ph.shapes.box(12.0, (1.0, 2.0, 3.0)), folder / "a.urdf", principal=True)
    spacecraft.write_aem(motion, folder / "a.aem", LABELS, rates="angular velocity")
    formats.write_csv(motion, folder / "a.csv")
    for name, text in messages(motion).items():
        (folder / name).write_text(text)
    lines = ROTOR.lines(3, 300.0)
    spectra.write_cat(spectra.catalogue_of(lines), folder / "a.cat")
    seen = MeasuredLines(lines.upper, lines.lower, lines.frequency, np.full(len(lines.frequency), 1e4))
    spectra.write_lin(spectra.line_list(seen), folder / "a.lin")
    spectra.write_par(spectra.constant_table(ROTOR), folder / "a.par")
    shutil.copy(folder / "a.csv", folder / "columns.csv")
    motion = replace(motion, frame=frame)
    formats.write_dataset(motion, folder / "a.nc")
    formats.write_zarr(motion, folder / "a.zarr")
    spacecraft.write_ck(motion, folder / "a.bc", labels=LABELS)
    binary = {name: Specimen(folder / name, in_bytes, read_mesh) for name in ("a.stl", "a.ply", "a.glb")}
    texts = {name: Specimen(folder / name, in_text, read_mesh)
             for name in ("ascii.stl", "ascii.ply", "a.obj", "a.off", "a.gltf")}  # fmt: skip
    molecules = {name: Specimen(folder / name, in_text, read_molecule)
                 for name in ("water.xyz", "ext.xyz", "a.pdb", "a.mol")}  # fmt: skip
    found = binary | texts | molecules | {
        "a.urdf": Specimen(folder / "a.urdf", in_text, read_body),
        "a.aem": Specimen(folder / "a.aem", in_text, read_trajectory(spacecraft.read_aem)),
        "a.cat": Specimen(folder / "a.cat", in_text, read_catalogue),
        "a.lin": Specimen(folder / "a.lin", in_text, read_lines),
        "a.par": Specimen(folder / "a.par", in_text, read_constants),
        "a.csv": Specimen(folder / "a.csv", in_text, read_trajectory(formats.read_csv)),
        "columns.csv": Specimen(folder / "columns.csv", in_text, read_trajectory(read_table)),
        "a.nc": Specimen(folder / "a.nc", in_hdf5, read_trajectory(formats.read_dataset)),
        "a.zarr": Specimen(folder / "a.zarr", in_store, read_trajectory(formats.read_dataset)),
        "a.bc": Specimen(folder / "a.bc", in_kernels, read_trajectory(spacecraft.read_ck)),
    }  # fmt: skip
    for name in messages(motion):
        form = "aem" if name.endswith("xml") else "csv" if name == "dates.csv" else name.partition(".")[2]
        read = read_dates if form == "csv" else partial(read_form, form)
        found[name] = Specimen(folder / name, in_text, read_trajectory(read))
    return {name: found[name] for name in names or found}


def read_form(form: str, path: Path) -> Any:
    """Return what the reader of a form makes of a file, checked as ``compare`` and ``import`` have it checked."""
    return read_recorded(path, Kernels(), kind=form)[1]


def read_dates(path: Path) -> Any:
    """Return a table of dates, matrices and counts."""
    words = {"time": 1, "matrix": tuple(range(2, 11)), "direction": "body-to-space", "gyro": (11, 12, 13)}
    return formats.read_columns(path, formats.ColumnMapping(**words, scale="131 LSB/(deg/s)"))


def messages(motion: Any) -> dict[str, str]:
    """Return small files in the shapes of other programs, by name."""
    rows = [f"{t:.6f} {' '.join(f'{x:.9f}' for x in q[[1, 2, 3, 0]])}"
            for t, q in zip(motion.times, motion.attitude, strict=True)]  # fmt: skip
    stk = ["stk.v.11.0", "BEGIN Attitude", f"NumberOfAttitudePoints {len(rows)}", "ScenarioEpoch 1 Jun 2002 12:00:00.0",
           "CoordinateAxes J2000", "AttitudeTimeQuaternions", *rows, "END Attitude"]  # fmt: skip
    header = ["ORIGINATOR = X", "OBJECT_NAME = BOX", "OBJECT_ID = 1", "TIME_SYSTEM = UTC"]
    frames = ["REF_FRAME_A = EME2000", "REF_FRAME_B = SC_BODY_1"]
    inertia = ["IXX = 1 [kg*m**2]", "IYY = 2 [kg*m**2]", "IZZ = 2.5 [kg*m**2]", "IXY = 0.1 [kg*m**2]"]
    apm = ["CCSDS_APM_VERS = 2.0", *header, "EPOCH = 2026-03-01T12:00:00", "SPIN_START", *frames, "SPIN_ALPHA = 10",
           "SPIN_DELTA = 20 [deg]", "SPIN_ANGLE = 30", "SPIN_ANGLE_VEL = 4 [deg/s]", "NUTATION = 1",
           "NUTATION_PER = 70 [s]", "NUTATION_PHASE = 5", "SPIN_STOP", "INERTIA_START", *inertia,
           "INERTIA_STOP"]  # fmt: skip
    acm = ["CCSDS_ACM_VERS = 2.0", "META_START", *header, "EPOCH_TZERO = 2026-03-01T12:00:00", "META_STOP", "ATT_START",
           *frames, "ATT_TYPE = QUATERNION", "RATE_TYPE = NONE", *rows, "ATT_STOP", "PHYS_START", *inertia,
           "PHYS_STOP"]  # fmt: skip
    states = "".join(
        f"<attitudeState><quaternionEphemeris><EPOCH>2026-03-01T12:00:{float(t):09.6f}</EPOCH><quaternion>"
        f"<Q1>{x}</Q1><Q2>{y}</Q2><Q3>{z}</Q3><QC>{w}</QC></quaternion></quaternionEphemeris></attitudeState>\n"
        for t, x, y, z, w in (row.split() for row in rows)
    )  # fmt: skip
    tags = {"OBJECT_NAME": "BOX", "OBJECT_ID": "1", "REF_FRAME_A": "EME2000", "REF_FRAME_B": "SC_BODY_1",
            "TIME_SYSTEM": "UTC", "START_TIME": "2026-03-01T12:00:00", "STOP_TIME": "2026-03-01T12:00:09",
            "ATTITUDE_TYPE": "QUATERNION"}  # fmt: skip
    head = "\n".join(f"<{name}>{value}</{name}>" for name, value in tags.items())
    xml = (f'<aem id="CCSDS_AEM_VERS" version="2.0">\n<body><segment><metadata>{head}</metadata><data>\n{states}</data>'
           "</segment></body></aem>")  # fmt: skip
    matrices = ph.rotation.as_matrix(motion.attitude).reshape(-1, 9)
    dates = [f"2026-03-01T12:00:{t:09.6f}Z,{','.join(f'{x:.9f}' for x in row)},{k},-3,17"
             for k, (t, row) in enumerate(zip(motion.times, matrices, strict=True))]  # fmt: skip
    names = ",".join(["t", *(f"R{i}{j}" for i in "123" for j in "123"), "gx", "gy", "gz"])
    texts = {"a.stk": stk, "a.apm": apm, "a.acm": acm, "new.xml": [xml], "dates.csv": [names, *dates]}
    return {name: "\n".join(text) + "\n" for name, text in texts.items()}


def read_table(path: Path) -> Any:
    """Return what a mapping makes of a table."""
    rates = [f"omega_{axis} [rad s-1]" for axis in "123"]
    return formats.read_columns(path, formats.ColumnMapping("time", quat="q_w,q_x,q_y,q_z", gyro=rates))


def embedded(mesh: Any) -> str:
    """Return a mesh as glTF in one file."""
    import base64

    files = mesh.scene().export(file_type="gltf")
    scene = json.loads(files["model.gltf"])
    for buffer in scene["buffers"]:
        buffer["uri"] = "data:application/octet-stream;base64," + base64.b64encode(files[buffer["uri"]]).decode()
    return json.dumps(scene, indent=1)


def complaint(specimen: Specimen, path: Path) -> str | None:
    """Read one file and say what is wrong with how that ended, or nothing."""
    with warnings.catch_warnings(record=True) as warned:
        warnings.simplefilter("always")
        # one changed digit moves a date past the installed table, which is rightly said
        warnings.filterwarnings("ignore", message="leap seconds are known until")
        signal.setitimer(signal.ITIMER_PROF, CPU_SECONDS)
        signal.setitimer(signal.ITIMER_REAL, WALL_SECONDS)
        before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024
        try:
            specimen.read(path)
        except InvalidInput as error:
            text = str(error)
            if str(path.parent) not in text or len(text) > LONGEST_MESSAGE or not text.replace("\n", "").isprintable():
                return f"message {text[:500]!r}"
        except BaseException:
            return traceback.format_exc()[-1500:]
        finally:
            signal.setitimer(signal.ITIMER_PROF, 0)
            signal.setitimer(signal.ITIMER_REAL, 0)
        more = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024 - before
    if more > MORE_MEMORY:
        return f"took {more / 1e6:.0f} MB"
    return f"warned {warned[0].message} in {warned[0].filename}:{warned[0].lineno}" if warned else None


def main(seed: int, count: int, folder: Path, names: list[str]) -> None:
    """Read all, and print what was wrong."""
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    wrong, ends = [], {}
    for name, specimen in specimens(folder / "whole", names).items():
        warm = folder / "warm"
        copied(specimen.path, warm)
        assert complaint(specimen, warm / specimen.path.name) is None, name
        for case in range(count):
            place = folder / "case"
            copied(specimen.path, place)
            path = place / specimen.path.name
            specimen.damage(random.Random(f"{name} {seed} {case}"), path)
            (folder / "at").write_text(f"{name} {seed} {case}")
            if (said := complaint(specimen, path)) is not None:
                wrong.append(f"{name} {seed} {case}: {said}")
        ends[name] = count
    print(json.dumps({"read": ends, "wrong": wrong}))


def copied(specimen: Path, place: Path) -> None:
    """Put a fresh copy of a specimen, and of the kernels beside it, into an empty folder."""
    shutil.rmtree(place, ignore_errors=True)
    place.mkdir()
    for path in [specimen] if specimen.suffix != ".bc" else specimen.parent.glob("a.[bt]*"):
        (shutil.copytree if path.is_dir() else shutil.copy)(path, place / path.name)


if __name__ == "__main__":
    main(int(sys.argv[1]), int(sys.argv[2]), Path(sys.argv[3]), sys.argv[4:])
