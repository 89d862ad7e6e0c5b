"""Elementary functions of compiled kernels: their programs -> what Coq is to prove of each.

Of what is left of an angle by quarter turns, or of a small quotient, two theorems: how far
roundings move the program, and, without roundings, how far it is from the function. De Dinechin,
Lauter and Melquiond (2011) divide the proof of a function of CRlibm so, the first part by Gappa.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction

import sympy as sp

from mechproof.coq.rounding_scripts import BoundTheorem, FunctionEnclosure
from mechproof.programs.elementary.formats import DOUBLE
from mechproof.programs.elementary.function_programs import build
from mechproof.roundoff.elementary_errors import (
    ANGLES,
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
    for kind in ANGLES:
        # Two quarter turns more change signs alone, if anything.
        for quarters in range(2):
            number = Whole(Fraction(QUARTERS), Fraction(quarters))
            found = resolve(build(kind, DOUBLE).program, Case(number)).straight
            function = getattr(sp, kind)(rest + quarters * sp.pi / 2)
            straight = replace(found, inputs=(REST,))
            yield _bound(f"{kind}_{quarters}", straight, find_end_of_rests(), function)
    small = resolve(build("small_arctan", DOUBLE).program, Case()).straight
    (name,) = small.inputs
    yield _bound("small_arctan", small, find_end_of_small(), sp.atan(sp.Symbol(name)))


def _bound(
    name: str, straight: StraightLineProgram, high: float, function: sp.Expr
) -> ElementaryCase:
    # Next to a pole nothing is enclosed.
    at_zero = function.xreplace(dict.fromkeys(function.free_symbols, sp.S.Zero))
    enclosure = FunctionEnclosure(function, _OFF) if at_zero.is_finite else None
    return ElementaryCase(
        name, straight, Fraction(high), bound_roundings(straight, high), enclosure
    )
