"""Tooth numbers and modules of the wheels of a drive, and the length of its pitch curves.

>>> from mechproof.mechanisms.teeth import oval_perimeter, find_teeth
>>> find_teeth(66, 16, internal=True)[0]
Teeth(z1=132, z2=32, module=1.0, R1=66.0, R2=16.0)
>>> print(f"{oval_perimeter(25, 0.2):.6f} mm")
160.131098 mm
"""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from mechproof.arguments.array_checks import check_array
from mechproof.arguments.scalars import check_count, check_items, require
from mechproof.mechanisms.parameters import Given, check_number, check_teeth

Floats = NDArray[np.float64]

# Series I of ISO 54, mm.
MODULES = tuple(
    Fraction(m)
    for m in (
        *("1", "1.25", "1.5", "2", "2.5", "3", "4", "5", "6", "8", "10", "12", "16", "20", "25"),
        *("32", "40", "50"),
    )
)
# The trapezium rule doubles its points up to this number.
MOST_POINTS = 2**20


class Teeth(NamedTuple):
    """Tooth numbers of two cylindrical wheels, their module and their radii (mm)."""

    z1: int
    z2: int
    module: float
    R1: float
    R2: float


class OvalTeeth(NamedTuple):
    """Tooth number of an oval or elliptical wheel, the module and the perimeter that fit it (mm).

    `alike`: both wheels of the pair can be cut alike, with a tooth where the radius is largest; the
    mate then has a gap where its radius is smallest.
    """

    z: int
    module: float
    perimeter: float
    alike: bool


def find_teeth(
    R1: Given,
    R2: Given,
    *,
    internal: bool = False,
    teeth: tuple[int, int] = (12, 200),
    modules: tuple[Given, ...] = MODULES,
) -> tuple[Teeth, ...]:
    """Return all tooth numbers within limits that give two radii exactly, fewest teeth last.

    Parameters
    ----------
    R1, R2 : real number or decimal string
        Radii of the pitch circles (mm), positive; R1 is that of the ring if internal.
    internal : bool
        Whether wheel 2 runs inside wheel 1; then R2 < R1.
    teeth : two integers
        Least and largest number of teeth of either wheel.
    modules : real numbers or decimal strings
        Modules to choose from (mm), by default series I of ISO 54 from 1 to 50.

    Returns
    -------
    tuple of Teeth
        In order of increasing module; empty if no module divides both diameters.

    Raises
    ------
    TypeError, ValueError
        If a parameter is not a number or out of its range; the message names it.

    """
    radii = _check_radii(R1, R2, internal)
    first, last = check_teeth(teeth)
    sizes = check_items("modules", modules, None, "must be numbers")
    known = sorted({Fraction(check_number("modules", module)) for module in sizes})
    for module in known:
        require(module > 0, "modules", module, "must be positive")
    found = []
    for module in known:
        z1, z2 = (2 * radius / module for radius in radii)
        whole = z1.denominator == z2.denominator == 1
        if whole and first <= min(z1, z2) and max(z1, z2) <= last:
            found.append(Teeth(int(z1), int(z2), float(module), *map(float, radii)))
    return tuple(found)


def find_nearest_teeth(
    R1: Given, R2: Given, *, internal: bool = False, teeth: tuple[int, int] = (12, 100)
) -> tuple[Teeth, ...]:
    """Return tooth numbers whose quotient is nearest to R1/R2, each nearer than with fewer teeth.

    Parameters are as in `find_teeth`. The distance of the axes is kept, so the module is not a
    standard one, and the radii follow from the teeth, not from those given.

    Returns
    -------
    tuple of Teeth
        The fewest teeth first, the nearest quotient last. Every pair within the limits was
        compared, in fractions. Of pairs equally near, the one with the fewest teeth is taken.

    """
    wanted_1, wanted_2 = _check_radii(R1, R2, internal)
    first, last = check_teeth(teeth)
    ratio = wanted_1 / wanted_2
    axes = wanted_1 - wanted_2 if internal else wanted_1 + wanted_2
    pairs = [
        (z1 + z2, abs(Fraction(z1, z2) - ratio), z1, z2)
        for z2 in range(first, last + 1)
        for z1 in {min(max(round_(ratio * z2), first), last) for round_ in (math.floor, math.ceil)}
        if z1 > z2 or not internal
    ]
    found: list[Teeth] = []
    nearest: Fraction | None = None
    for _, error, z1, z2 in sorted(pairs):
        if nearest is None or error < nearest:
            nearest = error
            module = 2 * axes / (z1 - z2 if internal else z1 + z2)
            found.append(
                Teeth(z1, z2, float(module), float(module * z1 / 2), float(module * z2 / 2))
            )
    return tuple(found)


def find_oval_teeth(
    a: float, e: float, *, teeth: tuple[int, int] = (12, 100), lobes: int = 2
) -> tuple[OvalTeeth, ...]:
    """Return, for each number of teeth, the module that fits it to the pitch curve.

    Parameters
    ----------
    a : float
        Half the distance of the axes (mm), positive.
    e : float
        Eccentricity, 0 <= e < 1.
    teeth : two integers
        Least and largest number.
    lobes : 2 or 1
        2 for an oval, 1 for an ellipse about its focus.

    """
    count = check_count("lobes", lobes)
    require(count <= 2, "lobes", lobes, "must be 1 or 2")
    first, last = check_teeth(teeth)
    perimeter = float(oval_perimeter(a, e) if count == 2 else ellipse_perimeter(a, e))
    # The largest and the smallest radius are z/(2 lobes) pitches apart: a tooth meets a gap if that
    # is a whole number and a half.
    return tuple(
        OvalTeeth(z, perimeter / (math.pi * z), perimeter, z % (2 * count) == count)
        for z in range(first, last + 1)
    )


def ellipse_perimeter(a: ArrayLike, e: ArrayLike) -> Any:
    """Return the perimeter 4 a E(e) of ellipses with the semi-axis a (mm), 0 <= e < 1.

    NaN outside the domain. Accurate to 4 eps, those of SciPy's complete elliptic integral included.
    """
    from scipy.special import ellipe

    axis, eccentricity = _check_curve(a, e)
    return (4 * axis * ellipe(eccentricity**2))[()]


def oval_perimeter(a: ArrayLike, e: ArrayLike) -> Any:
    """Return the perimeter of ovals r = a (1 - e²)/(1 - e cos(2 theta)) (mm), 0 <= e < 1.

    Parameters
    ----------
    a, e : array_like
        Half the distance of the axes (mm), and the eccentricity. NaN outside the domain.

    Raises
    ------
    ArithmeticError
        If 2**20 points are not enough, as for e above about 1 - 1e-4.

    Notes
    -----
    Uses the trapezium rule, whose error falls exponentially with the number of points because the
    curve is periodic and analytic (Trefethen and Weideman 2014). Points are doubled until the sum
    changes by no more than 4 eps. Held by the tests: within 8 eps of the integral.

    """
    axis, eccentricity = np.broadcast_arrays(*_check_curve(a, e))
    flat = np.array([_measure_oval(float(value)) for value in eccentricity.ravel()])
    return (axis * flat.reshape(eccentricity.shape))[()]


def _measure_oval(e: float) -> float:
    """Return the perimeter over a; the curve is symmetric at the ends of a quarter."""
    if math.isnan(e):
        return math.nan
    before, points = math.inf, 8
    while points <= MOST_POINTS:
        doubled = (np.arange(points) + 0.5) * (math.pi / points)
        # The derivative of the radius by the polar angle is r 2 e sin/(1 - e cos).
        spread = (1 - e) + 2 * e * np.sin(doubled / 2) ** 2
        speed = np.hypot(spread, 2 * e * np.sin(doubled)) / spread**2
        perimeter = (1 - e) * (1 + e) * math.fsum(speed) * (2 * math.pi / points)
        if abs(perimeter - before) <= 4 * np.finfo(float).eps * perimeter:
            return perimeter
        before, points = perimeter, 2 * points
    raise ArithmeticError(f"e = {e!r}: the perimeter needs more than {MOST_POINTS} points")


def _check_curve(a: ArrayLike, e: ArrayLike) -> tuple[Floats, Floats]:
    axis, eccentricity = check_array("a", a), check_array("e", e)
    inside = (eccentricity >= 0) & (eccentricity < 1)
    return np.where(axis > 0, axis, np.nan), np.where(inside, eccentricity, np.nan)


def _check_radii(R1: Given, R2: Given, internal: bool) -> tuple[Fraction, Fraction]:
    radii = Fraction(check_number("R1", R1)), Fraction(check_number("R2", R2))
    for name, radius in zip(("R1", "R2"), radii, strict=True):
        require(radius > 0, name, float(radius), "must be positive")
    require(not internal or radii[1] < radii[0], "R2", R2, f"must be below R1 = {R1!r}")
    return radii
