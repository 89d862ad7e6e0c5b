"""Units of a caller: degrees where he says so, quantities of pint where he gives one.

Kernels take radians and millimetres and no other; here alone is anything else converted. A plain
number in degrees is multiplied once, so that an angle is off by 1.5 eps of itself.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import degrees as to_degrees
from typing import Any, NamedTuple, TypeVar

import numpy as np

from mechproof.arguments.array_checks import check_flag
from mechproof.arguments.scalars import PLAIN, refuse, require
from mechproof.kernel_support.arrays import as_floats

# The fields that are angles, and their unit.
PLACES = {"at_maximum": "rad", "at_minimum": "rad", "period": "rad"}


class Extremes(NamedTuple):
    """Largest and smallest value of a periodic quantity and the angles where they occur (rad).

    Each recurs with `period`: at_maximum + m*period, at_minimum + m*period. `maximum` and
    `minimum` have the unit of the quantity.
    """

    maximum: float
    at_maximum: float
    minimum: float
    at_minimum: float
    period: float


# What a unit of the kernels measures.
MEASURED = {
    "rad": "an angle",
    "rad/s": "an angular speed",
    "rad/s**2": "an angular acceleration",
    "rad/s**3": "an angular jerk",
    "mm": "a length",
    "s": "a time",
    "1": "a pure number",
}
Tuple = TypeVar("Tuple", bound=NamedTuple)


class Units:
    """The units of one call: what is taken in them is given back in them.

    `degrees` says that plain angles are in degrees; a derivative by an angle is then by a degree.
    Beside a quantity of pint results are quantities, too, angles in the unit of the first angle.

    Raises TypeError where `degrees` is no truth value.
    """

    def __init__(self, degrees: bool = False) -> None:
        self.degrees = degrees if degrees is False else check_flag("degrees", degrees)
        self._quantity: Any = None
        self._angle: Any = None

    def take(self, name: str, value: Any, unit: str) -> Any:
        """Return an argument in a unit of the kernels.

        Raises
        ------
        TypeError
            For a quantity of another dimension.
        ValueError
            For a quantity where degrees are said, too.

        """
        if isinstance(value, list | tuple) and not PLAIN.issuperset(map(type, value)):
            if any(map(is_quantity, value)):
                return [self.take(f"{name}[{i}]", item, unit) for i, item in enumerate(value)]
        elif is_quantity(value):
            return self._convert(name, value, unit)
        if not (self.degrees and unit.startswith("rad")):
            return value
        return np.radians(as_floats(name, value)[0])

    def _convert(self, name: str, value: Any, unit: str) -> Any:
        require(not self.degrees, name, value, "has a unit; leave out degrees beside it")
        wanted = "dimensionless" if unit == "1" else unit
        if not value.is_compatible_with(wanted):
            refuse(name, value, f"must be {MEASURED[unit]} ({unit})", TypeError)
        self._quantity = type(value)
        # A number without a dimension is an angle in radians to pint.
        if unit == "rad" and self._angle is None and not value.unitless:
            self._angle = value.units
        return value.to(wanted).magnitude

    def give(self, value: Any, unit: str) -> Any:
        """Return a result, or several, that is in a unit of the kernels in the caller's units."""
        if isinstance(value, tuple):
            return tuple(self.give(item, unit) for item in value)
        if self._quantity is not None:
            found = self._quantity(value, "dimensionless" if unit == "1" else unit)
            if self._angle is not None and "rad" in unit:
                found = found.to(unit.replace("rad", f"({self._angle})"))
            return found
        if not self.degrees or "rad" not in unit:
            return value
        if unit.startswith("rad"):
            return to_degrees(value) if type(value) is float else np.degrees(value)
        return np.radians(np.radians(value)) if unit == "1/rad**2" else np.radians(value)

    def give_fields(self, found: Tuple, units: Mapping[str, str]) -> Tuple:
        """Return several results by their names, those that `units` names in the caller's units."""
        given = {name: self.give(getattr(found, name), unit) for name, unit in units.items()}
        return found._replace(**given)


def is_quantity(value: Any) -> bool:
    """Say whether a value is a quantity of pint, which need not be installed."""
    return hasattr(value, "_REGISTRY") and hasattr(value, "dimensionality")
