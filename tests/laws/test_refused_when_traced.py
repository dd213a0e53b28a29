"""What decides on numbers refuses traced ones with one clear error, and works on known ones within ``jax.jit``."""

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode import algebra, analysis, celestial, fields, measuring, poisson, rolling, spacecraft, spectra, systems
from polhode.analysis import (
    coning,
    dual_spin,
    first_method,
    free_axes,
    gravity_gradient,
    gyrostat_rotations,
    poinsot,
    polhodes,
    top_rates,
)
from polhode.analysis.cone import axis_angles, cone_angles, rotation_form, rotation_forms, velocity_angles
from polhode.analysis.precession import body_precession, fastest_rate, space_precession
from polhode.analysis.twist import racket_twist
from polhode.bodies import surface
from polhode.celestial.spin_orbit import resonances as spin_orbit
from polhode.errors import InvalidInput
from polhode.exact.lagrange_top import steady_precession as tops
from polhode.measuring.pendulum import periods as pendulum_periods
from polhode.motion import frame
from polhode.spacecraft.comparing import alignment, comparison
from polhode.spacecraft.damped_body import energy_sink, nutation_damping
from polhode.systems import body_with_rotor

THREE, FOUR, EYE = np.array([1.0, 2.0, 2.5]), np.array([1.0, 0.0, 0.0, 0.0]), np.eye(3)
SIX, AXIS = np.array([1.0, 2.0, 3.0, 2.0, 3.0, 5.0]), np.array([0.0, 1.0, 0.0])
BODY, SO3 = systems.FreeRigidBody(THREE), algebra.SO3()
TOP, DISK = systems.HeavyTop(THREE, 1.0), rolling.EulerDisk(1.0, 0.1)
SYMMETRIC_TOP = systems.HeavyTop((1.0, 1.0, 0.5), 1.0)
ROTOR, LOSING = systems.Gyrostat(THREE, THREE), systems.DoubleBracket(THREE, 0.1)
SPIN, ROLLING = celestial.SpinOrbit(0.3, 0.1), rolling.EulerDisk(1.0, 0.1).rolling_state(0.3)
SOLID, TIMES, TURNS = ph.Body.from_moments((1.0, 2.0, 2.5)), np.arange(12.0), np.tile(FOUR, (12, 1))
OF_MOTIONS = ("polhode", "herpolhode", "herpolhode_curve", "body_precession", "space_precession", "racket_twist",
              "axis_angles", "cone_angles", "velocity_angles", "rotation_form", "rotation_forms",
              "rotation_period", "turn_per_flip", "precession.fastest_rate", "HeavyTop.from_motion",
              "is_steady_precession", "steady_precession_of")  # fmt: skip
"""Making a motion compiles for half a minute, within another traced function not at all."""
CHAIN = fields.SpinLattice(fields.Lattice([[1.0]], shape=(4,)), bonds=[fields.Bond(0, 0, (1,), 1.0)])
SPINS = np.ones((12, 4, 1, 1, 1, 3))
DAMPED_SPIN = fields.SpinLattice(fields.Lattice([[1.0]]), field=(0.0, 0.1, 1.0), damping=0.5)
VORTICES, PLASMA = fields.SphereVortices(THREE), fields.VlasovPoisson(1.0, 1, 4)
NO_FLOW = np.zeros((4, 4), complex)
ROTATING = systems.Manakov(THREE)
HISTORY = comparison.AttitudeHistory("b", TIMES, TURNS)


def moving(moments):
    return ph.FreeMotion(moments, momentum=(0.3, 1.8, 1.5))


def swinging(momentum):
    return ph.LagrangeMotion((1.0, 1.0, 0.5), mgl=1.0, momentum=momentum)


def scaled(system, factor):
    """A system whose numbers are traced, put into one that is there."""
    return jax.tree.map(lambda value: value * factor, system)


REFUSED = {
    "clean_log": (TIMES, lambda x: measuring.clean_log(x, np.ones((12, 3)))),
    "fit_throw": (TIMES, lambda x: measuring.fit_throw(measuring.GyroLog(x, np.ones((12, 3))), gain_spread=x)),
    "fit_attitude": (TIMES, lambda x: measuring.fit_attitude(x, TURNS)),
    "fit_chandler": (TIMES, lambda x: celestial.fit_chandler(x, x, x)),
    "fit_chandler_process": (TIMES, lambda x: celestial.fit_chandler_process(x, x, x)),
    "fit_chandler_windows": (TIMES, lambda x: celestial.fit_chandler_windows(x, x, x)),
    "pole_spectrum": (TIMES, lambda x: celestial.pole_spectrum(x, x, x)),
    "polar_excitation": (TIMES, lambda x: celestial.polar_excitation(x, x, x, 4e7, 100.0)),
    "euler_chain": (0.003, celestial.euler_chain),
    "moments_from_one": (0.3, lambda x: measuring.moments_from_one(None, 1, x)),
    "fit_tumbling": (THREE, lambda x: celestial.fit_tumbling(1.0, 20.0, x)),
    "least_period_ratios": (THREE, lambda x: celestial.least_period_ratios(x)),
    "equivalent_ellipsoid": (THREE, lambda x: celestial.equivalent_ellipsoid(x)),
    "internal_damping_time": (0.3, lambda x: celestial.internal_damping_time(x, 1.0)),
    "ellipsoid_brightness": (THREE, lambda x: celestial.ellipsoid_brightness(x, [1.0, 0, 0], [0, 1.0, 0])),
    "light_curve": (TIMES, lambda x: celestial.light_curve(MOTION, x, [3, 2, 1], [1.0, 0, 0], [0, 1.0, 0])),
    "light_curve_lines": (THREE, lambda x: celestial.light_curve_lines(MOTION, x, [1.0, 0, 0], [0, 1.0, 0])),
    "moments_from_weight": (AXIS, lambda x: measuring.moments_from_weight(None, None, 1.0, 1.0, x)),
    "FreeRigidBody": (THREE, systems.FreeRigidBody),
    "HeavyTop": (AXIS, lambda x: systems.HeavyTop(THREE, 1.0, x)),
    "HeavyTop.upright": (0.0, TOP.upright),
    "Gyrostat": (THREE, lambda x: systems.Gyrostat(THREE, x)),
    "TorquedGyrostat": (0.3, lambda x: systems.TorquedGyrostat(THREE, AXIS, x, 0.1)),
    "BodyInPotential": (THREE, lambda x: systems.BodyInPotential(x, lambda up: up[2])),
    "BrunBody": (0.3, lambda x: systems.BrunBody(THREE, x)),
    "DoubleBracket": (0.3, lambda x: systems.DoubleBracket(THREE, x)),
    "Kirchhoff": (SIX, systems.Kirchhoff),
    "Manakov": (THREE, systems.Manakov),
    "SphereFluid": (0.3, lambda x: fields.SphereFluid(4, x)),
    "SphereFluid.from_harmonics": (np.zeros((4, 4)), fields.SphereFluid(4).from_harmonics),
    "SphereFluid.random": (THREE, fields.SphereFluid(4).random),
    "SphereFluid.vortex": (AXIS, lambda x: fields.SphereFluid(4).vortex(1.0, x)),
    "SphereFluid.zonal_velocity": (THREE, lambda x: fields.SphereFluid(4).zonal_velocity(NO_FLOW, x)),
    "SphereFluid.on_grid": (THREE, lambda x: fields.SphereFluid(4).on_grid(np.zeros((4, 4), complex), x, x)),
    "SphereMHD": (0.3, lambda x: fields.SphereMHD(4, x)),
    "SphereMHD.from_harmonics": (np.zeros((4, 4)), lambda x: fields.SphereMHD(4).from_harmonics(x, x)),
    "SphereMHD.random": (THREE, lambda x: fields.SphereMHD(4).random(x, x)),
    "SphereMHD.on_grid": (THREE, lambda x: fields.SphereMHD(4).on_grid(np.zeros((2, 4, 4), complex), x, x)),
    "Lattice": (EYE, lambda x: fields.Lattice(x, shape=(2, 2, 2))),
    "SpinLattice": (AXIS, lambda x: fields.SpinLattice(CHAIN.lattice, field=x)),
    "exchange_matrix": (AXIS, lambda x: fields.exchange_matrix(1.0, x)),
    "spin_waves": (AXIS, lambda x: fields.spin_waves(CHAIN, [[0.0, 0.0, 1.0]], x)),
    "structure_factor": (SPINS, lambda x: fields.structure_factor(CHAIN.lattice, TIMES, x, EYE)),
    "skyrmion_number": (np.ones((4, 4, 3)), fields.skyrmion_number),
    "hysteresis_loop": (EYE, lambda x: fields.hysteresis_loop(DAMPED_SPIN, DAMPED_SPIN.aligned(AXIS), x, 1.0, 0.1)),
    "SphereVortices": (THREE, fields.SphereVortices),
    "PlaneVortices": (THREE, fields.PlaneVortices),
    "vortex_turn": (VORTICES.ring(1.0), lambda x: fields.vortex_turn(VORTICES, x)),
    "vortex_stability": (VORTICES.ring(1.0), lambda x: fields.vortex_stability(VORTICES, x)),
    "zonal_growth": (np.zeros((4, 4)), lambda x: fields.zonal_growth(fields.SphereFluid(4), x, 1)),
    "ring_exponents": (1.0, lambda x: fields.ring_exponents(5, x)),
    "polygon_exponents": (1.0, lambda x: fields.polygon_exponents(5, x)),
    "VlasovPoisson": (1.0, lambda x: fields.VlasovPoisson(x, 1, 4)),
    "quiet_start": (0.1, lambda x: fields.quiet_start(PLASMA, np.ones_like, 2, x)),
    "two_stream": (2.0, fields.two_stream),
    "bump_on_tail": (0.1, lambda x: fields.bump_on_tail(x, 4.0, 0.5)),
    "velocity_distribution": (THREE, lambda x: fields.velocity_distribution(fields.MAXWELLIAN, x)),
    "dispersion": (0.3, lambda x: fields.dispersion(fields.MAXWELLIAN, 0.3, x)),
    "fastest_growing_wave": (0.3, lambda x: fields.fastest_growing_wave(fields.MAXWELLIAN, x)),
    "fit_growth": (
        np.linspace(0.0, 30.0, 31),
        lambda x: fields.fit_growth(x, np.full(31, 1e-3), 0.3, fields.PlasmaWave(0.3, 0.0, 0.2, 1.0, 0.0), 30.0),
    ),
    "plasma_wave": (0.3, lambda x: fields.plasma_wave(fields.MAXWELLIAN, x)),
    "plane_rotation_exponents": (np.zeros((3, 3)), lambda x: analysis.plane_rotation_exponents(ROTATING, x)),
    "EulerDisk": (0.1, lambda x: rolling.EulerDisk(1.0, x)),
    "EulerDisk.pack": (FOUR, lambda x: DISK.pack(x, THREE)),
    "EulerDisk.rolling_state": (0.3, DISK.rolling_state),
    "AirLayer": (0.3, rolling.AirLayer),
    "BoundaryLayer": (0.3, rolling.BoundaryLayer),
    "ViscousContourFriction": (0.3, rolling.ViscousContourFriction),
    "DryContourFriction": (0.3, rolling.DryContourFriction),
    "RollingCouple": (0.3, rolling.RollingCouple),
    "DrillingFriction": (0.3, rolling.DrillingFriction),
    "KeplerOrbit": (0.3, lambda x: systems.KeplerOrbit(1.0, x)),
    "KeplerOrbit.from_semi_major_axis": (1.0, lambda x: systems.KeplerOrbit.from_semi_major_axis(x, 1.0, 0.1)),
    "SpinOrbit": (0.3, lambda x: celestial.SpinOrbit(x, 0.1)),
    "LinearDrag": (0.3, spacecraft.LinearDrag),
    "QuadraticDrag": (0.3, spacecraft.QuadraticDrag),
    "GravityGradient": (THREE, lambda x: spacecraft.GravityGradient(systems.KeplerOrbit(1.0, 0.1), x)),
    "LaggedTorque": (0.3, lambda x: spacecraft.LaggedTorque(lambda t, attitude, velocity: velocity, x)),
    "RigidBody": (THREE, spacecraft.RigidBody),
    "Wheel": (0.3, lambda x: spacecraft.Wheel(AXIS, x)),
    "HeldWheel": (0.3, lambda x: spacecraft.HeldWheel(AXIS, 0.1, x)),
    "SphericalSlug": (0.3, lambda x: spacecraft.SphericalSlug(x, 0.1)),
    "EnergySink": (0.3, spacecraft.EnergySink),
    "TorquedBody": (THREE, lambda x: spacecraft.TorquedBody(x, [])),
    "AbstractLiePoissonSystem.check_state": (THREE, BODY.check_state),
    "from_structure_constants": (SO3.structure_constants(), algebra.from_structure_constants),
    "from_matrices": (algebra.SU(2).basis, algebra.from_matrices),
    "Semidirect": (SO3.structure_constants(), lambda x: algebra.Semidirect(SO3, x)),
    "orbit_dimension": (THREE, lambda x: poisson.orbit_dimension(SO3, x)),
    "orbit_tangent": (THREE, lambda x: poisson.orbit_tangent(SO3, x)),
    "kks_matrix": (THREE, lambda x: poisson.kks_matrix(SO3, x)),
    "restricted_bracket": (THREE, lambda x: poisson.restricted_bracket(SO3, x)),
    "symplectic_area": (EYE, poisson.symplectic_area),
    "liouville_volume": (THREE, lambda x: poisson.liouville_volume(SO3, x)),
    "stability": (AXIS, lambda x: ph.stability(BODY, x)),
    "spin_matrices": (1.0, spectra.spin_matrices),
    "coherent_state": (THREE, lambda x: spectra.coherent_state(1, x)),
    "orbit_radius": (1.0, spectra.orbit_radius),
    "evolve": (THREE, lambda x: spectra.evolve(np.eye(2), np.ones(2), x)),
    "spherical_tensor": (1.0, lambda x: spectra.spherical_tensor(x, 0)),
    "symbol": (THREE, lambda x: spectra.symbol(np.eye(2), x)),
    "symbol_coefficients": (EYE, spectra.symbol_coefficients),
    "semiclassical_levels": (THREE[::-1], lambda x: spectra.semiclassical_levels(x, 6)),
    "semiclassical_pairs": (THREE[::-1], lambda x: spectra.semiclassical_pairs(x, 6.5)),
    "doublet_splitting": (60.0, lambda x: spectra.doublet_splitting(THREE[::-1], 6, x)),
    "spectra.rotor.Rotor": (THREE[::-1], spectra.Rotor),
    "spectra.racket.Racket": (THREE[::-1], lambda x: spectra.Racket(x, 3)),
    "Racket.quantum": (THREE, spectra.Racket((3.0, 2.0, 1.0), 3).quantum),
    "Racket.states": (THREE, spectra.Racket((3.0, 2.0, 1.0), 3).states),
    "Racket.classical": (THREE, spectra.Racket((3.0, 2.0, 1.0), 3).classical),
    "Racket.ensemble": (THREE, spectra.Racket((3.0, 2.0, 1.0), 3).ensemble),
    "Rotor.partition_function": (300.0, spectra.Rotor((3.0, 2.0, 1.0)).partition_function),
    "Rotor.lines": (300.0, lambda x: spectra.Rotor((3.0, 2.0, 1.0), dipole=AXIS).lines(1, x)),
    "fit_rotor": (
        1.0,
        lambda x: spectra.fit_rotor(
            spectra.Rotor((3.0, 2.0, 1.0)),
            spectra.MeasuredLines(np.array([[1, 0, 1]]), np.array([[0, 0, 0]]), x * np.ones(1), np.ones(1)),
            ["B"],
        ),
    ),
    "find_equilibria": (AXIS, lambda x: ph.find_equilibria(BODY, x)),
    "planning.plan": (THREE, lambda x: ph.plan(BODY, x, (0.0, 1.0))),
    "simulate": (THREE, lambda x: ph.simulate(BODY, x, (0.0, 1.0))),
    "sections.section": (THREE, lambda x: ph.section(BODY, x, lambda t, point: point[1], (0.0, 1.0))),
    "continue_equilibria": (AXIS, lambda x: ph.analysis.continue_equilibria(lambda a: BODY, (0.0, 1.0), x)),
    "certification.certify": (THREE, lambda x: ph.certify(BODY, x, (0.0, 0.1))),
    "lyapunov_exponents.lyapunov": (THREE, lambda x: ph.analysis.lyapunov(BODY, x, (0.0, 1.0))),
    "monodromy": (THREE, lambda x: ph.analysis.monodromy(BODY, x, (0.0, 1.0))),
    "periodic_motion": (THREE, lambda x: ph.analysis.periodic_motion(BODY, x, 9.0)),
    "continue_periodic": (THREE, lambda x: ph.analysis.continue_periodic(lambda a: BODY, (0.0, 1.0), x, 9.0)),
    "first_method": (EYE, first_method.first_method),
    "steady_rotations": (1.0, lambda x: analysis.steady_rotations(ROTOR, x)),
    "damped_axis_stability": (1.0, lambda x: spacecraft.damped_axis_stability(LOSING, x)),
    "top_stability": (1.0, lambda x: analysis.top_stability(TOP, x)),
    "HeavyTop.leaning": (0.3, TOP.leaning),
    "HeavyTop.from_motion": (THREE, lambda x: systems.HeavyTop.from_motion(swinging(x))),
    "axis_in_space": (FOUR, lambda x: analysis.axis_in_space(TOP, x)),
    "axis_tilt": (FOUR, lambda x: analysis.axis_tilt(TOP, x)),
    "axial_spin": (THREE, lambda x: analysis.axial_spin(TOP, x)),
    "top_period": (THREE, lambda x: analysis.top_period(TOP, x)),
    "is_steady_precession": (THREE, lambda x: analysis.is_steady_precession(swinging(x))),
    "top_velocity": (0.3, lambda x: analysis.top_velocity(TOP, FOUR, x)),
    "steady_precession_at": (0.3, lambda x: analysis.steady_precession_at(SYMMETRIC_TOP, x, 9.0)),
    "thermal_momentum": (THREE, lambda x: analysis.thermal_momentum(x, 300.0)),
    "rotational_temperature": (THREE, analysis.rotational_temperature),
    "Body.from_rotational_constants": (2.0, lambda x: ph.Body.from_rotational_constants(x, 2.0, 1.5)),
    "steady_precession_of": (THREE, lambda x: analysis.steady_precession_of(swinging(x))),
    "EulerDisk.steady_motion": (np.r_[1.0, np.zeros(7)], DISK.steady_motion),
    "EulerDisk.state": (0.3, lambda x: DISK.state(x, 0.0, 1.0, 1.0)),
    "steady_rolling": (0.3, lambda x: rolling.steady_rolling(DISK, x)),
    "fastest_rolling_rate": (ROLLING, lambda x: rolling.fastest_rolling_rate(DISK, x)),
    "rolling_period": (ROLLING, lambda x: rolling.rolling_period(DISK, x)),
    "rolling_path": (ROLLING, lambda x: rolling.rolling_path(DISK, x, 0.1, 5)),
    "rotor_in_body": (0.3, lambda x: systems.rotor_in_body(SOLID, AXIS, x, 1.0, THREE)),
    "find_direction": (THREE, body_with_rotor.find_direction),
    "symmetric_rates": (THREE, lambda x: analysis.symmetric_rates(ROTOR, x)),
    "angle_from_axis": (THREE, lambda x: analysis.angle_from_axis(x, AXIS)),
    "angle_to_major_axis": (THREE, lambda x: spacecraft.angle_to_major_axis(x, THREE)),
    "angle_to_axis": (THREE, lambda x: spacecraft.angle_to_axis(x, 0)),
    "drag_time_constant": (0.3, lambda x: spacecraft.drag_time_constant(1.0, 1.0, x)),
    "settling_time": (THREE, lambda x: spacecraft.settling_time([], x, THREE)),
    "rotation_period": (THREE, lambda x: analysis.rotation_period(moving(x))),
    "turn_per_flip": (THREE, lambda x: analysis.turn_per_flip(moving(x))),
    "precession.fastest_rate": (THREE, lambda x: fastest_rate(moving(x))),
    "axis_stability": (THREE, lambda x: free_axes.axis_stability(x, 1.0)),
    "polhode_family": (THREE, polhodes.polhode_family),
    "separatrix": (THREE, polhodes.separatrix),
    "saddle_energies": (THREE, lambda x: polhodes.saddle_energies(THREE, x, 1.0)),
    "rolling_stability": (ROLLING, lambda x: rolling.rolling_stability(DISK, x)),
    "nutation": (ROLLING, lambda x: rolling.nutation(DISK, x)),
    "spin_down": (ROLLING, lambda x: rolling.spin_down(DISK, x)),
    "adiabatic_end": (0.3, lambda x: rolling.adiabatic_end(DISK, x)),
    "spin_motion": (THREE[:2], lambda x: celestial.spin_motion(SPIN, x)),
    "poincare_section": (THREE[:2], lambda x: spin_orbit.poincare_section(SPIN, x, 2)),
    "tangent_map": (THREE[:2], lambda x: spin_orbit.tangent_map(SPIN, x)),
    "lyapunov_exponent": (THREE[:2], lambda x: spin_orbit.lyapunov_exponent(SPIN, x, 2)),
    "resonance_strength": (0.1, lambda x: spin_orbit.resonance_strength(1.5, x)),
    "overlap_threshold": (0.1, spin_orbit.overlap_threshold),
    "Body": (EYE, lambda x: ph.Body(1.0, (0.0, 0.0, 0.0), x)),
    "from_points": (EYE, lambda x: ph.Body.from_points(THREE, x)),
    "from_mesh": (EYE, lambda x: ph.Body.from_mesh(x, [[0, 1, 2]], mass=1.0)),
    "from_atoms": (EYE[:2], lambda x: ph.Body.from_atoms(["O", "O"], x)),
    "shapes.box": (THREE, lambda x: ph.shapes.box(1.0, x)),
    "shapes.sphere": (1.0, lambda x: ph.shapes.sphere(x, 1.0)),
    "shapes.cylinder": (1.0, lambda x: ph.shapes.cylinder(1.0, x, 1.0)),
    "shapes.ellipsoid": (THREE, lambda x: ph.shapes.ellipsoid(1.0, x)),
    "shapes.cone": (1.0, lambda x: ph.shapes.cone(1.0, x, 1.0)),
    "shapes.disk": (1.0, lambda x: ph.shapes.disk(1.0, x)),
    "shapes.rod": (1.0, lambda x: ph.shapes.rod(1.0, x)),
    "shapes.torus": (0.3, lambda x: ph.shapes.torus(1.0, 1.0, x)),
    "shapes.capsule": (0.3, lambda x: ph.shapes.capsule(1.0, 1.0, x)),
    "shapes.prism": (0.3, lambda x: ph.shapes.prism(1.0, 1.0, 5, x)),
    "shapes.box_shell": (THREE, lambda x: ph.shapes.box_shell(1.0, x)),
    "shapes.cylinder_shell": (0.3, lambda x: ph.shapes.cylinder_shell(1.0, 1.0, 1.0, x)),
    "shapes.sphere_shell": (0.3, lambda x: ph.shapes.sphere_shell(1.0, 1.0, x)),
    "shapes.point": (THREE, lambda x: ph.shapes.point(1.0, x)),
    "from_sheet": (EYE, lambda x: ph.Body.from_sheet(x, [[0, 1, 2]], mass=1.0)),
    "Body.from_moments": (2.0, lambda x: ph.Body.from_moments((x, 2.0, 2.5))),
    "Body.from_inertia": (np.diag([1.0, 2.0, 2.5]), ph.Body.from_inertia),
    "Body.about": (THREE, SOLID.about),
    "Body.placed": (THREE, lambda x: SOLID.placed(EYE, x)),
    "box_of_same_inertia": (THREE, surface.box_of_same_inertia),
    "box_in_place": (THREE, lambda x: surface.box_in_place(frame.BodyFrame(x, EYE, AXIS, 1.0))),
    "fit_alignment": (TURNS, lambda x: alignment.fit_alignment(TIMES, x, TURNS)),
    "mean_quaternion": (TURNS, alignment.mean_quaternion),
    "compare": (TURNS, lambda x: comparison.compare(comparison.AttitudeHistory("a", TIMES, x), HISTORY)),
    "steady_precession": (0.3, lambda x: tops.steady_precession((1.0, 1.0, 0.5), 1.0, x, 5.0)),
    "least_spin_rate": (0.3, lambda x: tops.least_spin_rate((1.0, 1.0, 0.5), 1.0, x)),
    "sleeping_threshold": (1.0, lambda x: tops.sleeping_threshold((1.0, 1.0, 0.5), x)),
    "polhode": (THREE, lambda x: polhodes.polhode(moving(x), 8)),
    "level_segments": (THREE, lambda x: polhodes.level_segments(x, 1.0, 1.0)),
    "herpolhode": (THREE, lambda x: poinsot.herpolhode(moving(x))),
    "herpolhode_curve": (THREE, lambda x: poinsot.herpolhode_curve(moving(x), 4)),
    "body_precession": (THREE, lambda x: body_precession(moving(x))),
    "filament_period": (1.0, lambda x: pendulum_periods.filament_period(x, 1.0, 1.0, 0.2, 0.2)),
    "filament_moment": (1.0, lambda x: pendulum_periods.filament_moment(x, 1.0, 1.0, 0.2, 0.2)),
    "compound_period": (1.0, lambda x: pendulum_periods.compound_period(x, 1.0, 0.2)),
    "compound_moment": (1.0, lambda x: pendulum_periods.compound_moment(x, 1.0, 0.2)),
    "quarter_period": (1.0, pendulum_periods.quarter_period),
    "orbital_equilibria": (THREE, lambda x: gravity_gradient.orbital_equilibria(x, 1.0)),
    "orbiting_body": (THREE, lambda x: gravity_gradient.orbiting_body(x, 1.0)),
    "spinning_equilibria": (1.0, lambda x: gravity_gradient.spinning_equilibria(x, 1.5, 1.0, 2.0)),
    "libration_period": (THREE[:2], lambda x: spin_orbit.libration_period(celestial.SpinOrbit(0.3, 0.0), x)),
    "dual_spin_damping": (THREE[:2], lambda x: dual_spin.dual_spin_damping(2.0, x, (0.0, 1.0), (0.1, 0.1))),
    "nutation_time_constant": (1.0, lambda x: nutation_damping.nutation_time_constant(x, 2.0, 1.0, 0.1)),
    "damper_loss": (1.0, lambda x: nutation_damping.damper_loss(x, 2.0, 1.0, 0.1, 1.0, 1.0, 0.1)),
    "slosh_frequency": (1.0, lambda x: nutation_damping.slosh_frequency(x, 0.1, 0.2)),
    "coning_momentum": (1.0, lambda x: coning.coning_momentum((1.0, 1.0, 1.5), x, None, 2.0)),
    "precession_with_fixed_frame": (1.0, lambda x: coning.precession_with_fixed_frame(2.0, x, 0.1, 1.0, 1.0, 9.0)),
    "holding_torque": (1.0, lambda x: coning.holding_torque(2.0, x, 0.1, 1.0, 1.0, 9.0, 1.0)),
    "flat_spin_time": (THREE, lambda x: energy_sink.flat_spin_time(THREE, x, 0.1)),
    "sink_rate_by_loss": (THREE, lambda x: energy_sink.sink_rate_by_loss(THREE, x, 0.1)),
    "sink_rate_by_time": (1.0, lambda x: energy_sink.sink_rate_by_time(THREE, x, 0.1)),
    "mean_winding_rate": (TURNS, lambda x: gyrostat_rotations.mean_winding_rate(TIMES, x[:, :3], AXIS)),
    "mean_top_rates": (TURNS, lambda x: top_rates.mean_top_rates(TIMES, x[:, :3])),
    "steady_top_rates": (1.0, lambda x: top_rates.steady_top_rates(TOP, x, 0.3)),
    "gyroscopic_rates": (1.0, lambda x: top_rates.gyroscopic_rates(TOP, x)),
    "axis_angles": (THREE, lambda x: axis_angles(moving(x))),
    "cone_angles": (THREE, lambda x: cone_angles(moving(x))),
    "velocity_angles": (THREE, lambda x: velocity_angles(moving(x))),
    "rotation_form": (THREE, lambda x: rotation_form(moving(x))),
    "rotation_forms": (THREE, lambda x: rotation_forms(moving(x))),
    "space_precession": (THREE, lambda x: space_precession(moving(x))),
    "racket_twist": (THREE, lambda x: racket_twist(moving(x))),
    "resonances": (1.0, lambda x: spin_orbit.resonances(scaled(SPIN, x))),
    "critical_rolling_speed": (1.0, lambda x: rolling.critical_rolling_speed(scaled(DISK, x))),
    "critical_spin_rate": (1.0, lambda x: rolling.critical_spin_rate(scaled(DISK, x))),
    "HeavyTop.from_body": (1.0, lambda x: systems.HeavyTop.from_body(SOLID, pivot=(0.0, 0.0, x))),
    "LagrangeMotion.from_body": (
        1.0,
        lambda x: ph.LagrangeMotion.from_body(SOLID, pivot=(0.0, 0.0, x), angular_velocity=THREE),
    ),
    "SpinOrbit.from_body": (0.1, lambda x: celestial.SpinOrbit.from_body(SOLID, x)),
    "HeavyTop.check_state": (SIX, TOP.check_state),
}


@pytest.mark.parametrize("name", REFUSED)
def test_traced_numbers_are_refused(name):
    value, call = REFUSED[name]
    number = lambda x: jax.tree.leaves(call(x)) and 0.0  # noqa: E731
    one = np.asarray(value, dtype=float)
    many, ways = np.stack([one] * 2), {
        "jit": lambda: jax.eval_shape(number, one),
        "vmap": lambda: jax.vmap(number)(many),
        "jvp": lambda: jax.jvp(number, (one,), (one,)),
        "grad": lambda: jax.grad(number)(one),
    }  # fmt: skip
    for transform in ways.values():
        with pytest.raises(InvalidInput, match=r"must be known.* not traced by JAX"):
            jax.eval_shape(transform) if name in OF_MOTIONS else transform()


KNOWN = {
    "stability": lambda: ph.stability(BODY, AXIS).rate,
    "HeavyTop": lambda: systems.HeavyTop(THREE, 1.0, AXIS).energy(SIX),
    "HeavyTop.pack": lambda: TOP.pack(jnp.asarray(FOUR), jnp.asarray(THREE)),
    "KeplerOrbit": lambda: systems.KeplerOrbit(1.0, 0.1).direction(0.3),
    "SpinOrbit": lambda: celestial.SpinOrbit(0.3, 0.1).vector_field(0.3, THREE[:2]),
    "GravityGradient": lambda: spacecraft.GravityGradient(systems.KeplerOrbit(1.0, 0.1), THREE).torque(0.0, FOUR, AXIS),
    "orbit_dimension": lambda: poisson.orbit_dimension(SO3, THREE),
    "killing_form": lambda: algebra.killing_form(algebra.SU(2)),
    "centre": lambda: algebra.centre(algebra.Heisenberg(1)),
    "index": lambda: algebra.index(algebra.SE3()),
    "polynomial_casimirs": lambda: len(algebra.polynomial_casimirs(SO3, 2)),
    "normalize": lambda: ph.rotation.normalize(jnp.asarray(FOUR)),
    "from_matrix": lambda: ph.rotation.from_matrix(EYE_OF_JAX),
    "from_axis_angle": lambda: ph.rotation.from_axis_angle(THREE_OF_JAX, 0.3),
    "shortest_between": lambda: ph.rotation.shortest_between(THREE_OF_JAX, jnp.asarray(AXIS)),
    "poisson_tensor": lambda: poisson.poisson_tensor(SO3, THREE_OF_JAX),
    "contact_point": lambda: poinsot.contact_point(THREE_OF_JAX, 0.5),
    "racket_twist": lambda: racket_twist(MOTION),
    "precession": lambda: body_precession(MOTION).rate + space_precession(MOTION).rate,
    "herpolhode": lambda: poinsot.herpolhode(MOTION).inner_radius,
    "polhode": lambda: polhodes.polhode(MOTION, 8),
    "critical speeds": lambda: rolling.critical_rolling_speed(DISK) + rolling.critical_spin_rate(DISK),
    "resonances": lambda: len(spin_orbit.resonances(SPIN)),
}
EYE_OF_JAX, THREE_OF_JAX = jnp.eye(3), jnp.asarray(THREE)
MOTION = ph.FreeMotion(THREE, momentum=(0.3, 1.8, 1.5))


AT_ONCE = ("HeavyTop", "orbit_dimension", "from_axis_angle", "poisson_tensor", "contact_point")


@pytest.mark.parametrize("name", [pytest.param(n, marks=[] if n in AT_ONCE else [pytest.mark.sweep]) for n in KNOWN])
def test_known_numbers_within_a_traced_function(name):
    """Constants of a traced function are known numbers, though JAX traces what is computed from them."""
    found = jax.jit(lambda x: x + jnp.asarray(KNOWN[name](), dtype=float))(0.0)
    assert np.abs(np.asarray(found) - np.asarray(KNOWN[name]())).max() < 1e-14


def test_derivatives_by_what_a_system_is_made_of():
    """The way round a constructor's refusal: put other numbers into a system that is there."""
    energy = lambda moments: eqx.tree_at(lambda body: body.moments, BODY, moments).energy(THREE)  # noqa: E731
    assert np.allclose(jax.jit(jax.grad(energy))(jnp.asarray(THREE)), -0.5, rtol=1e-15)


def test_an_error_of_its_own_comes_through():
    with pytest.raises(InvalidInput, match="positive"):
        jax.jit(lambda x: systems.FreeRigidBody((-1.0, 2.0, 3.0)).energy(x))(THREE)
