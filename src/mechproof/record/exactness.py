"""Exact numbers: what a record of mathematics may hold."""

from __future__ import annotations

from fractions import Fraction
from math import isfinite
from numbers import Real
from typing import Any

import sympy as sp

from mechproof.record.parts import has_parts


class RecordError(ValueError):
    """A record that says something it cannot mean: a fault of the derivation, not of the paper."""


def make_exact(record: object, *names: str) -> None:
    """Turn numbers and matrices of the named fields into SymPy's; refuse what is not exact."""
    for name in names:
        value = getattr(record, name)
        if isinstance(value, sp.MatrixBase):
            value = sp.ImmutableMatrix(value)
        elif isinstance(value, int | Fraction) and not isinstance(value, bool):
            value = sp.Rational(value)
        if not isinstance(value, sp.Expr | sp.MatrixBase):
            where = f"{type(record).__name__}: {name} = {value!r}"
            raise RecordError(f"{where}: allowed are SymPy expressions, integers and fractions")
        if has_parts(value, sp.Float):
            where = f"{type(record).__name__}: {name} = {value}"
            raise RecordError(f"{where}: it has a float; exact is Rational('0.1')")
        object.__setattr__(record, name, value)


def to_number(where: str, value: Any) -> float:
    """Return what is a number of SymPy, too, as a plain one; refuse what is not finite."""
    if isinstance(value, Real | sp.Expr):
        try:
            number = value if isinstance(value, int | float) else float(value)
        except TypeError:
            number = float("nan")
        if isfinite(number):
            return number
    raise RecordError(f"{where} = {value!r}: must be a number")
