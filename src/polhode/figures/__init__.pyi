from .comparison import draw_comparison as draw_comparison
from .components import draw_components as draw_components
from .herpolhode import draw_herpolhode as draw_herpolhode
from .inertia_ellipsoid import draw_inertia_ellipsoid as draw_inertia_ellipsoid
from .momentum_sphere import draw_momentum_sphere as draw_momentum_sphere
from .style import save as save
