"""Running: steps in doubles as kernels compute them, in long doubles, and in balls for the truth.

An fma is emulated on every machine by sums rounded to odd (Boldo and Melquiond 2008). Long doubles
are thousands of times as fast as balls but certify nothing: they lead a search, and balls judge
what it finds. In arrays the points are on the last axis, the axes that are summed over before it.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import partial
from types import MappingProxyType
from typing import Any

import numpy as np
import sympy as sp
from flint import arb

from mechproof.arithmetic.ball_functions import COMPARISONS as COMPARED, CONNECTIVES, FUNCTIONS
from mechproof.arithmetic.balls import to_ball
from mechproof.kernel_support import error_free
from mechproof.programs.elementary.function_programs import BODIES
from mechproof.programs.operations import COMPARISONS, KINDS, Arithmetic, Infix
from mechproof.programs.program import CONSTANTS, Operand, Program
from mechproof.roundoff.steps import CONSTANT, StraightLineProgram

Values = dict[str, Any]
ENDLESS = MappingProxyType({"#inf": np.inf})
LONG_DOUBLE = np.longdouble
LONG_BITS = int(np.finfo(LONG_DOUBLE).nmant) + 1
# Long doubles that are only doubles reveal no rounding errors; those of x87 have 64 bits.
IS_LONGER = LONG_BITS >= 64
# Veltkamp's factor, which splits a long double into two halves.
FACTOR = LONG_DOUBLE(2) ** ((LONG_BITS + 1) // 2) + 1


def find_number(operand: Operand) -> Any:
    """Return the number that a constant's operand stands for."""
    if not isinstance(operand, str):
        return operand
    return CONSTANTS[operand] if operand in CONSTANTS else Fraction(operand)


def fma(a: Any, b: Any, c: Any) -> Any:
    """Return a*b + c rounded once, provided that no part leaves the normal range.

    Uses a sum rounded to odd (Boldo and Melquiond 2008).
    """
    product = a * b
    low, lowest = add_exactly(c, error_free.product_rest(a, b, product))
    high, middle = add_exactly(product, low)
    fused = high + add_to_odd(middle, lowest)
    # The rests of infinities are NaN, where the plain sum is right.
    return np.where(np.isfinite(fused), fused, product + c)


def add_exactly(a: Any, b: Any) -> tuple[Any, Any]:
    """Return the rounded sum and what rounding took from it."""
    # Knuth's sum (1969), which works whichever operand is larger.
    total = a + b
    part = total - a
    return total, (a - (total - part)) + (b - part)


def add_to_odd(a: Any, b: Any) -> Any:
    """Return the sum rounded to odd: if it is no double, its neighbour with an odd last bit."""
    total, rest = add_exactly(a, b)
    bits = np.asarray(total).view(np.int64)
    outward = np.where((rest > 0) == (total > 0), 1, -1)
    moved = (rest != 0) & (bits & 1 == 0)
    return np.where(moved, (bits + outward).view(np.float64), total)


# Kinds that are ufuncs of NumPy, which take any format.
UFUNCS: Mapping[str, Callable[..., Any]] = MappingProxyType(
    {
        kind: getattr(np, kind)
        for kind, row in KINDS.items()
        if isinstance(getattr(np, kind, None), np.ufunc) and not isinstance(row.numpy, Infix)
    }
)
ON_ARRAYS = Arithmetic(
    {
        **UFUNCS,
        **{kind: getattr(np, kind) for kind in COMPARISONS},
        "is_finite": np.isfinite,
        "choose": np.where,
        # Computed by their definitions, these rests would be rounded to zero; the body of the
        # second runs on numbers as well as on traces.
        "sum_rest": error_free.sum_rest,
        "total_rest": partial(BODIES["total_rest"][0], None),
        "both": np.logical_and,
        "either": np.logical_or,
        "along_first": lambda a: a[:, np.newaxis],
        "along_last": lambda a: a[np.newaxis],
        "transpose": lambda a: np.swapaxes(a, 0, 1),
        "diagonal": lambda a: np.moveaxis(np.diagonal(a), -1, 0),
    }
)
IN_DOUBLES = ON_ARRAYS.but(
    number=np.float64,
    constant=lambda operand: np.float64(float(find_number(operand))),
    fma=fma,
    product_rest=error_free.product_rest,
    quotient_rest=error_free.quotient_rest,
    small_tangent=error_free.small_tangent,
)
# SymPy's functions for balls and series of balls; None stands for an undecided comparison.
_OF_BALLS: Mapping[Any, Callable[..., Any]] = MappingProxyType(
    {
        **FUNCTIONS,
        **COMPARED,
        **CONNECTIVES,
        sp.sqrt: lambda a: a.sqrt(),
        sp.cbrt: lambda a: a.root(3),
        sp.Pow: operator.pow,
    }
)
IN_BALLS = Arithmetic(
    {
        **{k: _OF_BALLS[row.sympy] for k, row in KINDS.items() if row.sympy in _OF_BALLS},
        "number": arb,
        "is_finite": lambda a: a.is_finite(),
        "choose": lambda test, a, b: arb("nan") if test is None else a if test else b,
        # Balls have their own functions for these two, in which nothing cancels.
        "expm1": arb.expm1,
        "log1p": arb.log1p,
        CONSTANT: lambda operand: to_ball(find_number(operand)),
    }
)


def run(
    straight: StraightLineProgram | Program, given: Mapping[str, Any], arithmetic: Arithmetic
) -> tuple[Any, ...]:
    """Return the outputs at given values of the inputs, computed in an arithmetic."""
    values = run_steps(straight, given, arithmetic)
    return tuple(look_up(values, output, arithmetic) for output in straight.outputs)


def run_steps(
    straight: StraightLineProgram | Program, given: Mapping[str, Any], arithmetic: Arithmetic
) -> Values:
    """Return the values of the inputs and of all steps, computed in an arithmetic."""
    values: Values = {**ENDLESS, **given}
    steps = straight.operations if isinstance(straight, Program) else straight.steps
    for step in steps:
        operands = step.operands
        if step.kind != CONSTANT:
            operands = tuple(look_up(values, operand, arithmetic) for operand in operands)
        values[step.result] = arithmetic[step.kind](*operands)
    return values


def look_up(values: Values, operand: Operand, arithmetic: Arithmetic) -> Any:
    """Return the value of an operand: an input, a step's result or a number."""
    return values[operand] if isinstance(operand, str) else arithmetic.number(operand)


def _split(a: Any) -> tuple[Any, Any]:
    scaled = a * FACTOR
    high = scaled - (scaled - a)
    return high, a - high


def _quadratic_form(x: Any, m: Any) -> Any:
    return np.sum(x[:, np.newaxis] * x * m, axis=(0, 1))


def _product_rest(a: Any, b: Any, p: Any) -> Any:
    (a_high, a_low), (b_high, b_low) = _split(LONG_DOUBLE(1) * a), _split(LONG_DOUBLE(1) * b)
    return ((a_high * b_high - p) + a_high * b_low + a_low * b_high) + a_low * b_low


def _quotient_rest(a: Any, b: Any, q: Any) -> Any:
    p = q * b
    return ((a - p) - _product_rest(q, b, p)) / b


def _first_axes(count: Operand) -> tuple[int, ...]:
    return tuple(range(int(count)))


def _divide(digits: str) -> Any:
    above, _, below = digits.partition("/")
    return LONG_DOUBLE(above) / LONG_DOUBLE(below or "1")


# Digits of the constants; infinity is among the values of every run (`ENDLESS`).
DIGITS_OF = {n: str(sp.N(v, 40)) for n, v in CONSTANTS.items() if v != sp.oo}
IN_EXTENDED = ON_ARRAYS.but(
    number=LONG_DOUBLE,
    # From the digits: a Python integer might become a double on the way.
    constant=lambda operand: _divide(DIGITS_OF.get(operand, str(operand))),
    product_rest=_product_rest,
    quotient_rest=_quotient_rest,
    quadratic_form=_quadratic_form,
    nonnegative_form=_quadratic_form,
    sum=lambda a, count: np.sum(a, axis=_first_axes(count)),
    every=lambda a, count: np.all(a, axis=_first_axes(count)),
)
