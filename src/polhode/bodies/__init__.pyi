from . import shapes as shapes
from .body import Body as Body
from .body import combine as combine
from .surface import Surface as Surface
