from ._conserved_function import ConservedFunction as ConservedFunction
from ._mechanics import Mechanics as Mechanics
from ._mechanics import invariants_along as invariants_along
from .attitude_history import AttitudeHistory as AttitudeHistory
from .cone import axis_angles as axis_angles
from .cone import cone_angles as cone_angles
from .cone import rotation_form as rotation_form
from .cone import velocity_angles as velocity_angles
from .coning import coning_momentum as coning_momentum
from .coning import holding_torque as holding_torque
from .coning import precession_with_fixed_frame as precession_with_fixed_frame
from .continuation import Bifurcation as Bifurcation
from .continuation import Branch as Branch
from .continuation import Continuation as Continuation
from .continuation import continue_equilibria as continue_equilibria
from .dual_spin import DualSpinDamping as DualSpinDamping
from .dual_spin import dual_spin_damping as dual_spin_damping
from .energy_casimir import Stability as Stability
from .equilibria import find_equilibria as find_equilibria
from .floquet import PeriodicMotion as PeriodicMotion
from .floquet import monodromy as monodromy
from .floquet import periodic_motion as periodic_motion
from .free_axes import axis_stability as axis_stability
from .gravity_gradient import OrbitalEquilibrium as OrbitalEquilibrium
from .gravity_gradient import SpinningEquilibrium as SpinningEquilibrium
from .gravity_gradient import orbital_equilibria as orbital_equilibria
from .gravity_gradient import orbiting_body as orbiting_body
from .gravity_gradient import spinning_equilibria as spinning_equilibria
from .gyrostat_rotations import SteadyRotation as SteadyRotation
from .gyrostat_rotations import SymmetricRates as SymmetricRates
from .gyrostat_rotations import angle_from_axis as angle_from_axis
from .gyrostat_rotations import mean_winding_rate as mean_winding_rate
from .gyrostat_rotations import steady_rotations as steady_rotations
from .gyrostat_rotations import symmetric_rates as symmetric_rates
from .lyapunov_exponents import LyapunovExponents as LyapunovExponents
from .lyapunov_exponents import lyapunov as lyapunov
from .manakov_rotations import plane_rotation_exponents as plane_rotation_exponents
from .periodic_branches import continue_periodic as continue_periodic
from .poinsot import (
    Herpolhode as Herpolhode,
)
from .poinsot import (
    ellipsoid_semi_axes as ellipsoid_semi_axes,
)
from .poinsot import (
    herpolhode as herpolhode,
)
from .poinsot import (
    herpolhode_curve as herpolhode_curve,
)
from .polhodes import (
    level_segments as level_segments,
)
from .polhodes import (
    polhode as polhode,
)
from .polhodes import (
    polhode_family as polhode_family,
)
from .polhodes import (
    saddle_energies as saddle_energies,
)
from .polhodes import (
    separatrix as separatrix,
)
from .precession import (
    Precession as Precession,
)
from .precession import (
    body_precession as body_precession,
)
from .precession import (
    rotation_period as rotation_period,
)
from .precession import (
    space_precession as space_precession,
)
from .precession import (
    turn_per_flip as turn_per_flip,
)
from .sections import Section as Section
from .sections import section as section
from .stability import stability as stability
from .thermal import rotational_temperature as rotational_temperature
from .thermal import thermal_momentum as thermal_momentum
from .threshold import Threshold as Threshold
from .threshold import stability_threshold as stability_threshold
from .top_motion import axial_spin as axial_spin
from .top_motion import axis_in_space as axis_in_space
from .top_motion import axis_tilt as axis_tilt
from .top_motion import is_steady_precession as is_steady_precession
from .top_motion import steady_precession_of as steady_precession_of
from .top_motion import top_period as top_period
from .top_rates import TopRates as TopRates
from .top_rates import gyroscopic_rates as gyroscopic_rates
from .top_rates import mean_top_rates as mean_top_rates
from .top_rates import steady_top_rates as steady_top_rates
from .top_rests import TopRests as TopRests
from .top_rests import top_stability as top_stability
from .top_start import steady_precession_at as steady_precession_at
from .top_start import top_velocity as top_velocity
from .twist import racket_twist as racket_twist
