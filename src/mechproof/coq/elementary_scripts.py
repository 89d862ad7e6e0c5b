"""Elementary functions of compiled kernels: their programs -> what Coq is to prove of each.

Of what is left of an angle by quarter turns, or of a small quotient, two theorems: how far
roundings move the program, and, without roundings, how far it is from the function. De Dinechin,
Lauter and Melquiond (2011) divide the proof of a function of CRlibm so, the first part by Gappa.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from types import MappingProxyType

import sympy as sp

from mechproof.coq.rounding_scripts import BoundTheorem, FunctionEnclosure
from mechproof.programs.elementary.formats import DOUBLE
from mechproof.programs.elementary.function_programs import build
from mechproof.roundoff.elementary_errors import (
    QUARTERS,
    bound_roundings,
    find_end_of_rests,
    find_end_of_small,
)
from mechproof.roundoff.specialisation import REST, Case, Whole, resolve
from mechproof.roundoff.steps import StraightLineProgram

_EPS = Fraction(1, 2**52)
# Smaller inputs are left out: there a product may be below the least normal double.
_LEAST = Fraction(1, 2**300)
# By which the programs miss their functions at most: a quarter of eps.
_OFF = _EPS / 4
# Of an even number of quarter turns, and of one more; of a cotangent there is no enclosure at zero.
_FUNCTIONS: Mapping[str, tuple[Callable[[sp.Expr], sp.Expr] | None, ...]] = MappingProxyType(
    {
        "sin": (sp.sin, sp.cos),
        "cos": (sp.cos, lambda rest: -sp.sin(rest)),
        "tan": (sp.tan, None),
    }
)


@dataclass(frozen=True)
class ElementaryCase:
    """What a program computes in a case: the bound of its roundings, in eps of its value."""

    name: str
    straight: StraightLineProgram
    high: Fraction
    bound: float
    enclosure: FunctionEnclosure | None

    def state(self, bound: Fraction) -> BoundTheorem:
        """State that roundings move it by so many eps of its value at most."""
        (name,) = self.straight.inputs
        ranges = {name: (_LEAST, self.high)}
        return BoundTheorem(self.straight, ranges, bound * _EPS, relative=True)


def list_elementary() -> Iterator[ElementaryCase]:
    """Yield the cases of sine, cosine, tangent and small arctangent."""
    rest = sp.Symbol(REST)
    for kind, functions in _FUNCTIONS.items():
        for quarters, function in enumerate(functions):
            number = Whole(Fraction(QUARTERS), Fraction(quarters))
            found = resolve(build(kind, DOUBLE).program, Case(number)).straight
            straight = replace(found, inputs=(REST,))
            enclosed = FunctionEnclosure(function(rest), _OFF) if function else None
            yield _bound(f"{kind}_{quarters}", straight, find_end_of_rests(), enclosed)
    small = resolve(build("small_arctan", DOUBLE).program, Case()).straight
    (name,) = small.inputs
    enclosed = FunctionEnclosure(sp.atan(sp.Symbol(name)), _OFF)
    yield _bound("small_arctan", small, find_end_of_small(), enclosed)


def _bound(
    name: str, straight: StraightLineProgram, high: float, enclosure: FunctionEnclosure | None
) -> ElementaryCase:
    return ElementaryCase(
        name, straight, Fraction(high), bound_roundings(straight, high), enclosure
    )
