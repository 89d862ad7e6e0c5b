"""Symmetry: checks that steps with some arguments negated round alike up to signs."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache, partial

import sympy as sp

from mechproof.programs.operations import KINDS, Arithmetic
from mechproof.programs.program import CONSTANTS, Program
from mechproof.record import Chart, Form
from mechproof.roundoff.running import run_steps
from mechproof.roundoff.steps import CONSTANT, StraightLineProgram


@dataclass(frozen=True)
class Parity:
    """The effect of negated arguments on a value: 1 if it stays the same, -1 if it is negated."""

    sign: int

    def __add__(self, other: Parity) -> Parity:
        if self != other:
            raise ValueError("a sum of an odd and an even term")
        return self

    __sub__ = __add__

    def __mul__(self, other: Parity) -> Parity:
        return Parity(self.sign * other.sign)

    __truediv__ = __mul__

    def __neg__(self) -> Parity:
        return self


EVEN, ODD = Parity(1), Parity(-1)


@cache
def _find_parity(function: Callable[..., sp.Basic], *parities: Parity) -> Parity:
    """Return the parity of a function of given parities, by SymPy; ValueError if it has none."""
    dummies = [sp.Dummy(real=True) for _ in parities]
    value = function(*dummies)
    turned = function(*(p.sign * d for p, d in zip(parities, dummies, strict=True)))
    if turned == value:
        return EVEN
    if isinstance(value, sp.Expr) and turned == -value:
        return ODD
    raise ValueError(f"{value} is neither odd nor even")


def _choose(condition: Parity, a: Parity, b: Parity) -> Parity:
    if condition == ODD:
        raise ValueError("a choice by an odd condition")
    return a + b


def _turn(above: Parity, ahead: Parity) -> Parity:
    if ahead == ODD:
        raise ValueError("the angle of a point whose first coordinate is odd")
    return above


# Rounding to nearest is an odd function, and NumPy's odd functions are odd to the last bit.
PARITIES = Arithmetic(
    {
        **{k: partial(_find_parity, row.sympy) for k, row in KINDS.items() if row.sympy},
        "number": lambda number: EVEN,
        CONSTANT: lambda operand: EVEN,
        "choose": _choose,
        "arctan2": _turn,
    }
)


def check_signs(straight: StraightLineProgram, form: Form, names: Mapping[sp.Basic, str]) -> None:
    """Raise ValueError unless negating arguments, as a form allows, changes only signs of results.

    Then errors at negative angles are as large as at positive ones.
    """
    for given in list_negated(form, names):
        find_parities(straight, given)


def list_negated(form: Form, names: Mapping[sp.Basic, str]) -> Iterator[Mapping[str, Parity]]:
    """Yield the parities of arguments under each mirror of a form and each negated angle."""
    for mirror in form.mirrors:
        yield {n: ODD if s in mirror else EVEN for s, n in names.items()}
    for chart in form.charts:
        if chart.angle is not None:
            yield dict(_list_parities(chart, chart.angle, names))


def _list_parities(
    chart: Chart, angle: sp.Symbol, names: Mapping[sp.Basic, str]
) -> Iterator[tuple[str, Parity]]:
    """Yield arguments with their parities in an angle; ValueError for one neither odd nor even."""
    for symbol, value in chart.arguments.items():
        turned = value.subs(angle, -angle)
        if turned not in (value, -value):
            raise ValueError(f"chart: {value} is neither odd nor even in {angle}")
        yield names[symbol], EVEN if turned == value else ODD


def find_parities(
    straight: StraightLineProgram | Program, given: Mapping[str, Parity]
) -> Mapping[str, Parity]:
    """Return the parities of all results from those of the inputs; ValueError if one has none."""
    try:
        return run_steps(straight, {**dict.fromkeys(CONSTANTS, EVEN), **given}, PARITIES)
    except KeyError as error:
        raise ValueError(f"no parity is known: {error}") from error
