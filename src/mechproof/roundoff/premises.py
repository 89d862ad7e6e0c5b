"""Assumptions: what a bound rests on and no proof here shows."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np

from mechproof.programs.operations import KINDS, Rounding


@dataclass(frozen=True)
class Assumed:
    """By how many ulps of its result a function is off at most, and how that is said."""

    ulps: float
    text: str


FUNCTIONS: Mapping[str, Assumed] = MappingProxyType(
    {
        name: Assumed(1.0, f"np.{name} within 1 ulp")
        for name, row in KINDS.items()
        if row.rounding is Rounding.LIBRARY and hasattr(np, name)
    }
)
# Of every program: the relative error of an operation is bounded in the normal range alone.
NORMAL = "no result overflows or falls below the normal range"
# Of maps of points: no more than so many roundings are met by a product.
SUMS = "np.matmul by products and their sums in any order"
# Of sums over sets.
TERMS = "np.sum by additions in any order"
