from ._legendre import LegendreFunction as LegendreFunction
from ._legendre import legendre_function as legendre_function
from .carlson import (
    carlson_rc as carlson_rc,
)
from .carlson import (
    carlson_rd as carlson_rd,
)
from .carlson import (
    carlson_rf as carlson_rf,
)
from .carlson import (
    carlson_rj as carlson_rj,
)
from .elliptic import (
    amplitude as amplitude,
)
from .elliptic import (
    complete_k as complete_k,
)
from .elliptic import (
    incomplete_e as incomplete_e,
)
from .elliptic import (
    incomplete_f as incomplete_f,
)
from .elliptic import (
    incomplete_pi as incomplete_pi,
)
from .elliptic import (
    jacobi as jacobi,
)
from .elliptic import (
    nome as nome,
)
from .theta import theta1 as theta1
from .theta import theta2 as theta2
from .theta import theta3 as theta3
from .theta import theta4 as theta4
