from . import (
    algebra as algebra,
)
from . import (
    analysis as analysis,
)
from . import (
    errors as errors,
)
from . import (
    estimation as estimation,
)
from . import (
    figures as figures,
)
from . import (
    formats as formats,
)
from . import (
    integrators as integrators,
)
from . import (
    kinds as kinds,
)
from . import (
    motion as motion,
)
from . import (
    poisson as poisson,
)
from . import (
    quantum as quantum,
)
from . import (
    reports as reports,
)
from . import (
    rotation as rotation,
)
from . import (
    special as special,
)
from . import (
    systems as systems,
)
from . import (
    testing as testing,
)
from .analysis.comparison import AttitudeHistory as AttitudeHistory
from .analysis.continuation import continue_equilibria as continue_equilibria
from .analysis.enclosures import certify as certify
from .analysis.equilibria import find_equilibria as find_equilibria
from .analysis.floquet import monodromy as monodromy
from .analysis.floquet import periodic_motion as periodic_motion
from .analysis.lyapunov_exponents import lyapunov as lyapunov
from .analysis.periodic_branches import continue_periodic as continue_periodic
from .analysis.sections import section as section
from .analysis.stability import stability as stability
from .analysis.twist import racket_twist as racket_twist
from .arrays import closed_forms as closed_forms
from .bodies import shapes as shapes
from .bodies.body import Body as Body
from .bodies.body import combine as combine
from .cli.publish import publish as publish
from .errors import FormatError as FormatError
from .errors import InvalidInput as InvalidInput
from .errors import NotConverged as NotConverged
from .exact.free_body import FreeMotion as FreeMotion
from .exact.lagrange_top import LagrangeMotion as LagrangeMotion
from .formats.dataset import as_dataset as as_dataset
from .kinds.page import show as show
from .kinds.page import write_page as write_page
from .kinds.plotting import plot as plot
from .kinds.reading import read_spec as read_spec
from .kinds.reading import report as report
from .motion.frame import BodyFrame as BodyFrame
from .motion.trajectory import Trajectory as Trajectory
from .quantum.rotor import Rotor as Rotor
from .simulation import simulate as simulate
from .solving import Fold as Fold
from .solving import solve as solve
from .studies.compare import compare as compare
from .studies.fit import fit as fit
from .studies.spectrum import levels as levels
from .studies.spectrum import spectrum as spectrum
from .studies.tumble import tumble as tumble
from .studies.wobble import wobble as wobble
from .sweeps.answers import sweep as sweep

__version__: str
