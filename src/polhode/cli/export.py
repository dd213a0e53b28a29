"""``polhode export SPEC --to FORM``: the motion as files for other tools."""

from __future__ import annotations

import difflib
import math
import sys
import warnings
from collections.abc import Sequence
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path

from polhode.cli.destinations import check_spares
from polhode.cli.spec_reports import moving_report_of, report_of
from polhode.errors import FormatError, InvalidInput, one_line, shown
from polhode.formats.dataset import label_attributes
from polhode.kinds.base import Spec
from polhode.kinds.reading import read_spec
from polhode.reports.base import MotionReport, SystemReport

_HERE = "polhode.cli.export"


@dataclass(frozen=True)
class Form:
    """A form of file.

    Attributes:
        home: the module and the function in it that write the file, from report, spec and path; by names, as most
            need packages that others do not.
        ending: of the file's name.
        holds: what is in it, and with how many digits.
        sampled: whether it holds the samples of the report.
        of_motion: whether it needs a motion.
        spectrum: what writes the levels and lines of a kind without motion in its place, if it can.
    """

    home: tuple[str, str]
    ending: str
    holds: str
    sampled: bool = True
    of_motion: bool = True
    spectrum: str = ""

    def writer(self, spec: Spec) -> tuple[str, str]:
        """Return the module and function that write the file of a spec."""
        return (_HERE, self.spectrum) if self.spectrum and not spec.kind.has_motion else self.home


FORMS = {
    "netcdf": Form((_HERE, "export_netcdf"), ".nc", "all that is known, along the principal axes; bit for bit",
                   spectrum="export_spectrum"),
    "zarr": Form((_HERE, "export_zarr"), ".zarr", "all that is known, along the principal axes; bit for bit"),
    "csv": Form((_HERE, "export_csv"), ".csv", "a table along the given axes; every digit"),
    "aem": Form((_HERE, "export_aem"), ".aem",
                "CCSDS AEM 2.0, attitude and angular velocity of the given axes; 16 digits, epochs to a picosecond"),
    "ck": Form((_HERE, "export_ck"), ".bc",
               "SPICE C-kernel of the given axes, with its clock, frame and leap seconds next to it; every digit"),
    "gltf": Form((_HERE, "export_gltf"), ".glb",
                 "glTF 2.0 animation of the body; angles to 1e-7, as it holds single precision", sampled=False),
    "urdf": Form((_HERE, "export_urdf"), ".urdf", "mass, centre of mass and inertia along the given axes; every digit",
                 sampled=False, of_motion=False),
    "cat": Form((_HERE, "export_cat"), ".cat", "rotational lines of a molecule; frequencies to 100 Hz", sampled=False,
                of_motion=False),
    "par": Form((_HERE, "export_par"), ".par", "rotational constants of a molecule; every digit", sampled=False,
                of_motion=False),
}  # fmt: skip


def run_export(path: Path, forms: Sequence[str], out: Path | None) -> None:
    """Compute the motion of a spec once and write it in every form asked for."""
    wanted = list(dict.fromkeys(forms))
    for form in wanted:
        if form not in FORMS:
            near = difflib.get_close_matches(form.lower(), FORMS, n=1)
            hint = f"Did you mean {near[0]}?" if near else "Choose one of these."
            raise InvalidInput(f"--to must be one of {', '.join(FORMS)}; got {shown(form)}. {hint}")
    if out is not None and len(wanted) > 1:
        raise InvalidInput(f"--out names one file, and {len(wanted)} forms are asked for. Leave it out, or write one.")
    if out is not None:
        check_spares(out, path)
    spec = read_spec(path)
    moving = any(FORMS[form].of_motion and FORMS[form].writer(spec) == FORMS[form].home for form in wanted)
    report = moving_report_of(path, spec) if moving else report_of(path, spec)
    for form in wanted:
        module, function = FORMS[form].writer(spec)
        place = out or Path(f"{path.stem}{FORMS[form].ending}")
        try:
            with warnings.catch_warnings(record=True) as caught:
                warnings.simplefilter("always", UserWarning)
                written = getattr(import_module(module), function)(report, spec, place)
        except FormatError:
            raise
        except InvalidInput as error:
            raise InvalidInput(f"{form}: {error}") from None
        for said in dict.fromkeys(str(warning.message) for warning in caught):
            print(f"polhode: {form}: {said}", file=sys.stderr)
        ours = function == FORMS[form].home[1]
        holds = FORMS[form].holds if ours else "levels and lines with their units; bit for bit"
        count = part = ""
        if isinstance(report, MotionReport):
            count = f"{len(report.trajectory.times)} samples, " if FORMS[form].sampled else ""
            part = _shown_part(report) if form == "gltf" else ""
        print(one_line(f"{written}: {count}{holds}{part}"))
        if form in ("aem", "ck") and isinstance(report, MotionReport):
            _warn_of_long_turns(report, form)


def _shown_part(report: MotionReport) -> str:
    """Return which part of the motion an animation shows, if it is not all of it."""
    all_of_it, shown = report.trajectory.times, report.shown.times
    if shown[0] <= all_of_it[0] and shown[-1] >= all_of_it[-1]:
        return ""
    return f"; it shows the motion from {shown[0]:.6g} s to {shown[-1]:.6g} s, of {all_of_it[-1]:.6g} s"


def _warn_of_long_turns(report: MotionReport, form: str) -> None:
    """Say so where the body turns so far between samples that readers, who interpolate, go wrong."""
    from polhode.formats.animation_keys import FARTHEST, farthest_turn

    if (turn := farthest_turn(report.trajectory)) > FARTHEST:
        print(f"polhode: {form}: the body turns by up to {math.degrees(turn):.3g}° between samples; readers who "
              f"interpolate over more than {math.degrees(FARTHEST):.0f}° go wrong. Raise `samples` under [time], or "
              "take a shorter `until`.", file=sys.stderr)  # fmt: skip


def export_netcdf(report: MotionReport, spec: Spec, path: Path) -> Path:
    """Write the report's trajectory as NetCDF."""
    from polhode.formats.dataset import write_dataset

    return write_dataset(report.trajectory, path, _attributes(spec))


def export_zarr(report: MotionReport, spec: Spec, path: Path) -> Path:
    """Write the report's trajectory as a Zarr store."""
    from polhode.formats.dataset import write_zarr

    return write_zarr(report.trajectory, path, _attributes(spec))


def _attributes(spec: Spec) -> dict[str, str]:
    return {"title": spec.name} | label_attributes(spec.labels)


def export_csv(report: MotionReport, spec: Spec, path: Path) -> Path:
    """Write the report's trajectory as a table."""
    from polhode.formats.csv_table import write_csv

    return write_csv(report.trajectory, path)


def export_aem(report: MotionReport, spec: Spec, path: Path) -> Path:
    """Write the report's attitude history as a CCSDS AEM, with angular velocities where there are any."""
    from polhode.formats.aem import write_aem

    rates = None if report.trajectory.angular_velocity is None else "angular velocity"
    return write_aem(report.trajectory, path, spec.labels, rates)


def export_ck(report: MotionReport, spec: Spec, path: Path) -> Path:
    """Write the report's attitude history as a SPICE C-kernel, and the kernels that it needs next to it."""
    from polhode.formats.spice import write_ck

    return write_ck(report.trajectory, path, labels=spec.labels)[0]


def export_gltf(report: MotionReport, spec: Spec, path: Path) -> Path:
    """Write the motion as an animation of the body's surface, or of a box with its inertia."""
    from polhode.formats.gltf import write_gltf

    return write_gltf(report.shown, path, labels=spec.labels, surface=spec.surface)


def export_urdf(report: SystemReport, spec: Spec, path: Path) -> Path:
    """Write the body's mass properties as a robot's link."""
    from polhode.formats.urdf import write_urdf_inertial

    if spec.body is None:
        raise InvalidInput("a URDF link needs a body, and this spec has no [body]. Give one, or choose another form.")
    return write_urdf_inertial(spec.body, path, spec.name)


def export_spectrum(report: SystemReport, spec: Spec, path: Path) -> Path:
    """Write a molecule's levels, and its lines if it has a dipole, as NetCDF."""
    from polhode.formats.rotor_dataset import rotor_attributes, write_spectrum
    from polhode.spec.rotors import check_summable

    asked = spec.kind.rotor(spec)
    lines = None
    if asked.rotor.dipole.any():
        check_summable(asked)
        lines = asked.rotor.lines(asked.j_max, asked.temperature)
    known = rotor_attributes(asked.rotor, spec.name, asked.temperature)
    write_spectrum(path, levels=asked.rotor.levels(asked.j_max), lines=lines, attributes=known)
    return path


def export_cat(report: SystemReport, spec: Spec, path: Path) -> Path:
    """Write a molecule's lines as a catalogue."""
    from polhode.formats.spcat import catalogue_of, write_cat
    from polhode.spec.rotors import check_summable

    asked = spec.kind.rotor(spec)
    if not asked.rotor.dipole.any():
        raise InvalidInput("there is no dipole, and no lines without one. Give it, like "
                           'dipole = ["0 D", "1.857 D", "0 D"].')  # fmt: skip
    check_summable(asked)
    lines = asked.rotor.lines(asked.j_max, asked.temperature)
    write_cat(catalogue_of(lines, degrees=2 if asked.rotor.is_linear else 3), path)
    return path


def export_par(report: SystemReport, spec: Spec, path: Path) -> Path:
    """Write a molecule's constants as the field's programs read them."""
    from polhode.formats.spfit_constants import constant_table, write_par

    write_par(constant_table(spec.kind.rotor(spec).rotor, title=spec.name), path)
    return path
