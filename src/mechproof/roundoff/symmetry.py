"""Symmetry: whether steps with arguments negated round as they did, but for signs."""

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
    """What becomes of a value: 1 for what stays, -1 for what is negated."""

    sign: int

    def __add__(self, other: Parity) -> Parity:
        if self != other:
            raise ValueError("a sum of what is negated and what is not")
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
    """Return the parity of a function, as SymPy knows it; ValueError where there is none."""
    dummies = [sp.Dummy(real=True) for _ in parities]
    value = function(*dummies)
    turned = function(*(p.sign * d for p, d in zip(parities, dummies, strict=True)))
    if turned == value:
        return EVEN
    if isinstance(value, sp.Expr) and turned == -value:
        return ODD
    raise ValueError(f"{value} of what is negated")


def _choose(condition: Parity, a: Parity, b: Parity) -> Parity:
    if condition == ODD:
        raise ValueError("a choice by what is negated")
    return a + b


def _turn(above: Parity, ahead: Parity) -> Parity:
    if ahead == ODD:
        raise ValueError("the angle of a point that is turned about another axis")
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
    """Require that arguments negated in a form's domain turn only signs; ValueError if not.

    Then errors at negative angles are as large as at positive ones.
    """
    for given in list_negated(form, names):
        find_parities(straight, given)


def list_negated(form: Form, names: Mapping[sp.Basic, str]) -> Iterator[Mapping[str, Parity]]:
    """List what becomes of arguments by each mirror, and by each angle that is negated."""
    for mirror in form.mirrors:
        yield {n: ODD if s in mirror else EVEN for s, n in names.items()}
    for chart in form.charts:
        if chart.angle is not None:
            yield dict(_list_parities(chart, chart.angle, names))


def _list_parities(
    chart: Chart, angle: sp.Symbol, names: Mapping[sp.Basic, str]
) -> Iterator[tuple[str, Parity]]:
    """List what an angle negated does to arguments; ValueError if that is neither."""
    for symbol, value in chart.arguments.items():
        turned = value.subs(angle, -angle)
        if turned not in (value, -value):
            raise ValueError(f"chart: {value} is neither odd nor even in {angle}")
        yield names[symbol], EVEN if turned == value else ODD


def find_parities(
    straight: StraightLineProgram | Program, given: Mapping[str, Parity]
) -> Mapping[str, Parity]:
    """Return the parities of all results by those of the inputs; ValueError where there is none."""
    try:
        return run_steps(straight, {**dict.fromkeys(CONSTANTS, EVEN), **given}, PARITIES)
    except KeyError as error:
        raise ValueError(f"no parity: {error}") from error
