from . import shapes as shapes
from .atoms import from_atoms as from_atoms
from .body import Body as Body
from .body import combine as combine
from .mesh import from_mesh as from_mesh
from .points import from_points as from_points
from .surface import Surface as Surface
