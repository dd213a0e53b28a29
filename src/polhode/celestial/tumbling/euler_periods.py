"""From Euler's period of a rigid Earth to Chandler's: each correction with its cause.

References: M. L. Smith, F. A. Dahlen, Geophys. J. R. astr. Soc. 64 (1981) 223 (formula, fluid core, Love numbers,
oceans, anelasticity); P. M. Mathews, T. A. Herring, B. A. Buffett, J. Geophys. Res. 107 (2002) B4 (dynamical
ellipticity).
"""

from __future__ import annotations

from dataclasses import dataclass

from polhode._base import check
from polhode._base.arrays import known_numbers_only

ELLIPTICITY = 3.273795e-3  # (C − A)/C
SIDEREAL_DAY = 86_164.0989  # s, a turn of the Earth
GRAVITY, RADIUS, ROTATION = 3.986004418e14, 6_378_137.0, 7.292115e-5  # G M [m³/s²], equatorial [m], [rad/s]
J2 = 1.0826359e-3
MANTLE = 0.8866  # equatorial moment without the fluid core, which takes no part in the wobble, over the whole Earth's
ELASTIC, OCEANS, ANELASTIC = 0.298, 0.345, 0.3517  # Love number k: of the solid Earth; with oceans; with anelasticity


@dataclass(frozen=True)
class EulerPeriod:
    """A period of the free wobble, with the effects that it includes.

    Attributes:
        name: short, for tables and keys.
        period: [s].
        cause: of the difference from the period before.
    """

    name: str
    period: float
    cause: str


@known_numbers_only
def euler_chain(
    ellipticity: float = ELLIPTICITY, mantle: float = MANTLE, elastic: float = ELASTIC, oceans: float = OCEANS,
    anelastic: float = ANELASTIC,
) -> tuple[EulerPeriod, ...]:
    """Return the wobble's period for a rigid Earth, then with each correction added in turn.

    A rigid body with (C − A)/C = H turns about its figure once in A/(C − A) = 1/H − 1 of its turns. A body whose figure
    follows the wobble by the Love number k has T/(1 − k/k_s), where k_s = 3G(C − A)/(Ω²R⁵) would let it follow wholly.

    Args:
        ellipticity: dynamical, H = (C − A)/C.
        mantle: equatorial moment without the fluid core over that of the whole Earth, as the core does not follow.
        elastic: Love number k of the solid Earth.
        oceans: Love number with a pole tide of the oceans.
        anelastic: Love number with the pole tide and a mantle softer at the wobble's slow rate than for earthquakes.

    Raises:
        InvalidInput: for numbers without a wobble.

    Example:
        >>> [round(stage.period / 86400.0, 1) for stage in euler_chain()]
        [303.6, 444.9, 394.5, 425.7, 430.6]
    """
    # k_s = 3G (C − A)/(Ω² R⁵) with C − A = J2 M R²
    secular = 3.0 * GRAVITY * J2 / (ROTATION**2 * RADIUS**3)
    ellipticity = check.number("ellipticity", ellipticity, above=0, below=0.5, remedy="The Earth's is 0.00327.")
    mantle = check.number("mantle", mantle, above=0, most=1, remedy="It is a part of the whole, of the Earth 0.8866.")
    rule = f"a Love number from 0 to below {secular:.3f}, at which the figure would follow wholly"
    for name, k in (("elastic", elastic), ("oceans", oceans), ("anelastic", anelastic)):
        check.number(name, k, least=0, below=secular, rule=rule)
    rigid = (1.0 / ellipticity - 1.0) * SIDEREAL_DAY
    yielding = lambda k: rigid / (1.0 - k / secular)  # noqa: E731
    return (
        EulerPeriod("rigid", rigid, "Euler's period of a rigid Earth, by its dynamical ellipticity"),
        EulerPeriod("elastic", yielding(elastic), "the figure follows the wobble elastically, so less of it drives"),
        EulerPeriod("fluid_core", mantle * yielding(elastic), "the fluid core does not take part, so less is moved"),
        EulerPeriod("oceans", mantle * yielding(oceans), "the oceans follow too, as the pole tide"),
        EulerPeriod("anelastic", mantle * yielding(anelastic), "the mantle yields more to slow forces than to fast"),
    )
