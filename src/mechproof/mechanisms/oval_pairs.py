"""The pair 4-5 of the mechanism with oval wheels: oval, or cylindrical."""

from __future__ import annotations

from dataclasses import InitVar, asdict, dataclass, field
from decimal import Decimal
from fractions import Fraction
from typing import Any

from mechproof.kernels import oval_planetary as kernels
from mechproof.mechanisms.exact import Given, Number, check_number
from mechproof.mechanisms.published_sizes import check_domain
from mechproof.mechanisms.units import Units


@dataclass(frozen=True)
class OvalPair:
    """Pair 4-5 of congruent ovals.

    Parameters
    ----------
    e : real number or decimal string
        Eccentricity of the generating ellipse, 0 <= e < 1.
    mount : real number or decimal string
        Turn of wheel 6 on its shaft (rad), forward from its place in the paper, where the major
        axes of 5 and 6 are at right angles.
    degrees : bool
        Whether the mount is in degrees; no field.

    """

    e: Given
    mount: Given = Fraction(0)
    degrees: InitVar[bool] = field(default=False, kw_only=True)

    def __post_init__(self, degrees: bool) -> None:
        """Check the parameters and keep them exact where they are."""
        units = Units(degrees)
        e, mount = units.take("e", self.e, "1"), self.mount
        if isinstance(mount, str | Decimal | Fraction | int):
            mount = check_number("mount", mount)
        # No turn at all stays exact.
        if not (isinstance(mount, Fraction) and mount == 0):
            mount = units.take(
                "mount", float(mount) if degrees and isinstance(mount, Fraction) else mount, "rad"
            )
        object.__setattr__(self, "e", check_size("e", e, kernel_name="e1"))
        object.__setattr__(self, "mount", check_number("mount", mount))


@dataclass(frozen=True)
class CylindricalPair:
    """Pair 4-5 of cylindrical wheels.

    Parameters
    ----------
    R4, R5 : real number or decimal string
        Radii of the sun 4 and of the satellite's wheel 5 (mm), positive.

    """

    R4: Given
    R5: Given

    def __post_init__(self) -> None:
        """Check the parameters and keep them exact where they are."""
        for name, radius in asdict(self).items():
            object.__setattr__(self, name, check_size(name, Units().take(name, radius, "mm")))


def check_size(name: str, value: Any, kernel_name: str = "") -> Number:
    """Return the number, exact where it is, after the kernels' conditions on it."""
    number = check_number(name, value)
    called = kernel_name or name
    check_domain(kernels.DOMAIN, {called: number}, {called: (name, value)})
    return number
