"""Every public function, constructor and method of the numerical rooms is in a table of those tested alone.

What is public is found by walking the package; inner modules have an underscore, and none is in the reference.
"""

import functools
import importlib
import inspect
import pkgutil
import re
from pathlib import Path

import equinox as eqx
import pytest

import polhode
from polhode._base.plugins.wings import wing_names

REFERENCE = sorted((Path(__file__).parents[2] / "docs" / "reference").glob("*.md"))
TAKE_FILES_AND_WORDS = {"cli", "course", "figures", "formats", "kinds", "reports", "spec", "studies", "sweeps",
                        "viewer", "errors"}
INNER_ROOMS = {"taylor"}
WORDS_OF_WINGS = ("proving.symbolic", "spacecraft.formats", "spacecraft.rigid_body.history",
                  "spacecraft.rigid_body.named")  # fmt: skip
"""Modules without arrays of their own that do not import the application: expressions, keywords, names, answers."""
OF_THE_APPLICATION = re.compile(r"^ *from polhode\.(cli|figures|formats|kinds|reports|spec|studies|viewer)\b"
                                r"|^import tomllib|^from pathlib", re.MULTILINE)  # fmt: skip


def is_inner(module):
    """Whether a module only serves others."""
    return module.partition(".")[0] in INNER_ROOMS or any(part.startswith("_") for part in module.split("."))


def public_modules():
    for found in pkgutil.walk_packages(polhode.__path__, "polhode."):
        module = found.name.removeprefix("polhode.")
        if not takes_files_and_words(module) and not is_inner(module):
            yield module, importlib.import_module(found.name)


@functools.cache
def takes_files_and_words(module):
    """Whether a module has no arrays or is of the application: in a wing what imports it, and what imports that."""
    room = module.partition(".")[0]
    if module.startswith(WORDS_OF_WINGS):
        return True
    file = Path(polhode.__path__[0], *module.split(".")).with_suffix(".py")
    if room in TAKE_FILES_AND_WORDS or room not in wing_names() or not file.exists():
        return room in TAKE_FILES_AND_WORDS
    text = file.read_text("utf-8")
    beside = set(re.findall(rf"^ *from polhode\.({room}\.[\w.]+) import", text, re.MULTILINE)) - {module}
    return bool(OF_THE_APPLICATION.search(text)) or any(map(takes_files_and_words, beside))


def own(module):
    for name, thing in vars(module).items():
        if not name.startswith("_") and getattr(thing, "__module__", None) == module.__name__:
            yield name, thing


def public_names():
    """Yield room.module.function, room.module.Class and room.module.Class.method."""
    for place, module in public_modules():
        for name, thing in own(module):
            if inspect.isclass(thing):
                if not is_record(thing) and not inspect.isabstract(thing):
                    yield f"{place}.{name}"
                for method, value in vars(thing).items():
                    if not method.startswith("_") and isinstance(value, function_kinds()):
                        yield f"{place}.{name}.{method}"
            elif callable(thing):
                yield f"{place}.{name}"


def function_kinds():
    return type(own), classmethod, staticmethod, type(eqx.Module.__dict__.get("__hash__"))


def is_record(kind):
    """Whether a class only holds what it is given."""
    return issubclass(kind, tuple) or not any(("__init__" in vars(k) and not _made(k)) or "__check_init__" in vars(k)
                                              for k in kind.__mro__[:-1] if k.__module__.startswith("polhode."))


def _made(kind):
    return not hasattr(vars(kind)["__init__"], "__code__") or vars(kind)["__init__"].__module__ != kind.__module__


def suffixes(table):
    return lambda name: any(name.endswith("." + key) or name == key for key in table)


def of_classes(kinds):
    """Return the methods of classes, under the names of the classes that define them."""
    found = set()
    for kind in kinds:
        for owner in kind.__mro__:
            place = owner.__module__.removeprefix("polhode.") + "." + owner.__name__
            found |= {place} | {f"{place}.{name}" for name in vars(owner)}
    return found


NO_ARRAYS = {
    "AbstractLieAlgebra.batch_shape", "AbstractLieAlgebra.structure_constants", "has_cayley", "has_cayley_terms",
    "is_compact",
    "from_scipy", "testing.algebras.check_algebra", "testing.kinds.check_kind", "testing.motions.check_motion",
    "testing.systems.check_system",
    "judging.motion_table.reference_motions", "judging.motion_table.parse_motions", "judging.engines.compare_engine",
    "FixedStepCase", "FixedStepResults", "fixed_step_cases", "run_fixed_steps",
    "ReferenceMotion", "MotionErrors", "EngineComparison", "Comparison", "align_clocks", "SpinDown", "Resonance",
    "AttitudeHistory",
    "bodies.surface.Paint", "bodies.surface.Surface", "Surface.along", "Surface.coarsened", "surface.join_surfaces",
    "combine", "overlap_asphericity", "stability_threshold", "Levels.of", "rotor.join_levels", "Rotor.from_body",
    "Rotor.levels", "Rotor.levels_of", "fitting.RotorFit", "RotorFit.worst", "RotorFit.predict",
    "analysis.threshold.Threshold", "fields.vlasov_poisson.waves.PlasmaWave",
    "enclosed_numbers.EnclosedNumber", "MotionEnclosure", "MotionEnclosure.state", "FreeEnclosure", "TopEnclosure",
    "rotor_misfit", "damped_motion.time_constant", "predicted_exponents",
    "SpinMotion.predictable_time", "SpinMotion.regular_exponent", "DiskPath.part",
    "Lattice.positions",
    "check_by_z3", "GyroLog", "measuring.throws.flight.free_flights", "measuring.throws.flight.Window", "FittedThrow",
    "ModelScore", "ThrowFit", "measuring.throws.flight.find_flights", "measuring.throws.rest.rest_stretches",
    "measuring.pendulum.fitting.fit_pendulum", "OrbitalEquilibrium", "OrbitalEquilibrium.libration_period",
    "SpinningEquilibrium", "NearestRest",
    "AttitudeFit", "Tumbling", "TumblingInterval",
    "ChandlerFit", "ChandlerFit.term", "ChandlerFit.amplitude", "ChandlerProcess", "ChandlerWindows",
    "PoleSpectrum", "PolarExcitation", "EulerPeriod",
    "analysis.certificate.Subject", "Certificate.as_rational",
    "rational_brackets",
    "RationalCertificate", "RationalCertificate.find_faults", "RationalCertificate.check",
    "RationalCertificate.as_json", "RationalCertificate.json", "find_certificate",
    "surfaces.Plates",
    "control_margins.has_linear_loop", "control_margins.linearize_loop", "control_margins.loop_margins",
    "gravity_gradient.nearest_rest", "gravity_gradient.escape_energy",
    "turns.first_turns", "turns.last_turns", "turns.resample_until_end",
}  # fmt: skip
"""Functions of objects, words and whole numbers, and records of known answers."""
CALLED_BY_OTHERS = {
    "analysis.cone.many_axis_angles", "analysis.cone.many_velocity_angles", "analysis.free_axes.leaving_rates",
    "analysis.poinsot.herpolhodes", "analysis.top_start.euler_velocity", "analysis.top_start.lean_sine",
    "exact.lagrange_top.steady_precession.precession_roots",
    "exact.lagrange_top.steady_precession.sleeping_thresholds", "spectra.semiclassics.are_above",
    "systems.heavy_top.lean_from_upright",
    "measuring.throws.gyro_log.check_sizes", "algebra.base.HashableModule", "algebra.casimirs.check_monomials",
    "algebra.casimirs.rational_brackets", "algebra.casimirs.invariant_polynomials", "algebra.constants.check_constants",
    "algebra.matrix.adjoint", "algebra.matrix.traceless", "algebra.matrix.check_size",
    "algebra.so3.half_angle_factors", "algebra.so3.scaled_norm", "analysis.gyrostat_rotations.symmetry_axis",
    "systems.body_with_rotor.clean_direction", "rolling.euler_disk.system.rolling_parts",
    "proving.enclosures.enclosure.enclose_by_series", "analysis.energy_casimir.Stability",
    "analysis.energy_casimir.energy_casimir", "analysis.stability.judge_steady_motion",
    "certificates.rational.require_rational", "rolling.euler_disk.dissipation.slow_push",
    "analysis.energy_casimir.steady_drift", "analysis.energy_casimir.growing_direction",
    "bodies.atoms.explain_symbol", "celestial.spin_orbit.motion.steps_for",
    "celestial.spin_orbit.resonances.make_kicks", "celestial.spin_orbit.resonances.scale_start",
    "celestial.spin_orbit.resonances.steps_per_orbit",
    "celestial.spin_orbit.resonances.follow_neighbours",
    "analysis.stability.scaled_field", "bodies.atoms.atomic_masses", "bodies.atoms.isotopic_masses",
    "bodies.atoms.is_element", "bodies.atoms.mass_properties", "bodies.body.check_is_body", "bodies.surface.cuboid",
    "bodies.surface.places", "bodies.surface.weld_corners", "spectra.semiclassics.phase",
    "spectra.semiclassics.quantise", "spectra.semiclassics.without_casimir", "spectra.rotor.equal_constants",
    "spectra.rotor.warn_of_fallen", "spectra.rotor.find_fallen", "solving.restore_memory",
    "spectra.symbols.pole_values", "spectra.symbols.sum_harmonics", "spectra.spin.raising_elements",
    "spectra.spin.unit_vectors", "spectra.rotor.check_j", "integrators.probing.depends_on_time",
    "integrators.probing.jumps_along", "integrators.probing.jumps_between", "integrators.probing.name_jumps",
    "integrators.probing.find_undeclared_jumps", "spacecraft.systems.attachments.checked_jumps",
    "integrators.base.explicit", "integrators.base.step_count", "poisson.brackets.as_points",
    "poisson.reconstruction.hermite", "systems.trajectories.make_trajectory", "planning.Request.of_copies",
    "planning.Request.name_copies",
    "planning.without_warnings", "planning.check_request", "planning.check_every", "planning.prepare",
    "planning.prepare_without_series", "measuring.throws.flight.check_windows",
    "systems.base.components",
    "fields.point_vortices.system.rounds_of_pairs", "fields.spin_lattice.system.add_damping",
    "systems.base.join_state", "systems.base.attitude_change", "spacecraft.systems.attachments.checked_attachments",
    "spacecraft.systems.moving_parts.checked_mounts", "spacecraft.systems.hinged_part.rotate_about",
    "spacecraft.systems.hinged_part.turn_tensor", "spacecraft.torques.base.checked_torques",
    "spacecraft.torques.base.torque_of", "spacecraft.torques.base.in_body",
    "spacecraft.torques.surfaces.make_plates", "spacecraft.systems.control_laws.checked_gain",
    "spacecraft.systems.control_laws.checked_law", "spacecraft.systems.control_laws.target_at",
    "systems.free_rigid_body.axis_flow", "systems.free_rigid_body.axis_flows",
    "systems.free_rigid_body.checked_moments", "systems.kepler_orbit.ratio_from_eccentric",
    "systems.kepler_orbit.true_from_eccentric", "systems.kepler_orbit.solve_kepler",
    "rolling.euler_disk.dissipation.couples", "testing.laws.hold", "testing.laws.hold_all",
}  # fmt: skip
"""Inner functions of public modules: no ``__all__`` has them, and what is tested alone calls them."""


def tables():
    """Return which names are covered, by the tables of the other files."""
    load = importlib.import_module
    turns, algebras, moving = (load(f"laws.test_{name}") for name in
                               ("transformations", "algebras_alone", "systems_alone"))  # fmt: skip
    steps, refused, motions = load("laws.test_steps_alone"), load("laws.test_refused_when_traced"), load(
        "exact.test_outputs_alone")  # fmt: skip
    values = load("laws.test_values_of_analysis")
    exactly = of_classes(map(type, [*algebras.one_of_each_class().values(), *moving.SPECIMENS, *steps.SOLVERS]))
    exactly |= {p.values[0] for p in turns.public_functions()} | set(turns.LEFT_OUT) | CALLED_BY_OTHERS
    exactly |= of_classes(motions.KINDS.values())
    by_ending = [*refused.REFUSED, *algebras.FUNCTIONS, *algebras.MAKERS, *algebras.OF_AN_ALGEBRA]
    by_ending += [*values.VALUES, *NO_ARRAYS]
    by_ending += ["poisson.orbits." + name for name in algebras.REFUSE]
    return exactly, by_ending


def test_every_public_name_is_in_a_table():
    exactly, by_ending = tables()
    covered = suffixes(by_ending)
    missing = [name for name in public_names() if name not in exactly and not covered(name)]
    assert not missing, f"not tested alone, nor said why not: {missing}"


def test_a_forgotten_function_would_be_named(monkeypatch):
    module = importlib.import_module("polhode.analysis.poinsot")

    def forgotten(x):
        return x

    forgotten.__module__ = module.__name__
    monkeypatch.setattr(module, "forgotten", forgotten, raising=False)
    with pytest.raises(AssertionError, match=r"analysis\.poinsot\.forgotten"):
        test_every_public_name_is_in_a_table()


def test_tables_name_what_is_there():
    names = set(public_names())
    found = lambda key: any(n == key or n.endswith("." + key) for n in names)  # noqa: E731
    missing = [key for key in [*NO_ARRAYS, *CALLED_BY_OTHERS] if not found(key)]
    assert not missing, f"no such public function: {missing}"


def test_what_the_reference_shows_is_not_called_inner():
    shown = [line.split("polhode.")[1].strip() for page in REFERENCE
             for line in page.read_text(encoding="utf-8").splitlines()
             if line.startswith(".. automodule:: polhode.")]  # fmt: skip
    assert len(shown) > 50
    assert not [module for module in shown if "." in module and is_inner(module)]
