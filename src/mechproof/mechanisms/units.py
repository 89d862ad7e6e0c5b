"""Units of a caller: degrees if asked for, pint quantities if given.

Kernels take only radians and millimetres; everything else is converted here. A plain number in
degrees is multiplied once, so that an angle has a relative error of 1.5 eps.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import degrees as to_degrees
from typing import Any, NamedTuple, TypeVar

import numpy as np

from mechproof.arguments.array_checks import check_flag
from mechproof.arguments.scalars import PLAIN, check_real, refuse, require
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


# The quantity that a unit of the kernels measures.
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
    """The units of one call: results are in the units of the arguments.

    With `degrees`, plain angles are in degrees, and derivatives by an angle are per degree. If an
    argument is a pint quantity, so are results, with angles in the unit of the first angle.

    Raises TypeError if `degrees` is not a bool.
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
            If a quantity has another dimension.
        ValueError
            If a quantity is given together with degrees.

        """
        if isinstance(value, list | tuple) and not PLAIN.issuperset(map(type, value)):
            if any(map(is_quantity, value)):
                return [self.take(f"{name}[{i}]", item, unit) for i, item in enumerate(value)]
        elif is_quantity(value):
            return self._convert(name, value, unit)
        if not (self.degrees and unit.startswith("rad")):
            return value
        return np.radians(as_floats(name, value)[0])

    def set_fields(
        self,
        record: object,
        units: Mapping[str, str],
        check: Callable[[str, Any], Any] = check_real,
    ) -> None:
        """Replace fields of a frozen record by what the `check` makes of them in these units."""
        for name, unit in units.items():
            given = self.take(name, getattr(record, name), unit)
            object.__setattr__(record, name, check(name, given))

    def _convert(self, name: str, value: Any, unit: str) -> Any:
        require(not self.degrees, name, value, "has a unit; leave out degrees")
        wanted = "dimensionless" if unit == "1" else unit
        if not value.is_compatible_with(wanted):
            refuse(name, value, f"must be {MEASURED[unit]} ({unit})", TypeError)
        self._quantity = type(value)
        # pint takes a number without a dimension as an angle in radians.
        if unit == "rad" and self._angle is None and not value.unitless:
            self._angle = value.units
        return value.to(wanted).magnitude

    def give(self, value: Any, unit: str) -> Any:
        """Convert one or several results from a unit of the kernels to the caller's units."""
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
        """Convert the results named in `units` to the caller's units."""
        given = {name: self.give(getattr(found, name), unit) for name, unit in units.items()}
        return found._replace(**given)


def is_quantity(value: Any) -> bool:
    """Return whether a value is a pint quantity; pint need not be installed."""
    return hasattr(value, "_REGISTRY") and hasattr(value, "dimensionality")
