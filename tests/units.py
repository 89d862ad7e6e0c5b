"""Numbers with units from two libraries, pint and astropy."""

from __future__ import annotations

from typing import Any

import astropy.units
import numpy as np
import pint

REGISTRY = pint.UnitRegistry()
LIBRARIES = (
    (REGISTRY.Quantity, REGISTRY.deg),
    (astropy.units.Quantity, astropy.units.deg),
)


def list_other_units(value: Any) -> list[Any]:
    """List a value in seconds, and in units of astropy, bare and in containers."""
    duration = REGISTRY.Quantity(np.asarray(value, float)[()], REGISTRY.second)
    given = astropy.units.Quantity(value, astropy.units.deg)
    return [duration, [duration], ((duration,), (duration,)), given, given / given, [given]]


def list_with_units(value: Any) -> list[Any]:
    """List a value in degrees, bare, dimensionless, and inside a list and tuples."""
    found = []
    for quantity, degree in LIBRARIES:
        given = quantity(np.asarray(value, float)[()], degree)
        found += [given, given / quantity(2.0, degree), [given], ((given,), (given,))]
    return found
