"""Functions for languages that have neither them nor a fused multiply-add: by sums and products.

Rests of products are recovered as in NumPy kernels: the function that does so there is traced.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from inspect import signature
from types import MappingProxyType
from typing import Any

from mechproof.kernel_support.error_free import product_rest
from mechproof.programs.elementary.formats import DOUBLE
from mechproof.programs.elementary.function_programs import BODIES, build
from mechproof.programs.operations import KINDS, NEAREST, Rounding
from mechproof.programs.program import Program
from mechproof.programs.trace import TRACED, Value, choose, trace


def fma(a: Value, b: Value, c: Value) -> Value:
    """Return a*b + c, off by barely more than one rounding: by error-free product and sum.

    NaN for an infinite product.
    """
    p = a * b
    s = p + c
    part = s - p
    rest: Value = product_rest(a, b, p)
    return s + (((p - (s - part)) + (c - part)) + rest)


def quotient_rest(a: Value, b: Value, q: Value) -> Value:
    """Return a/b - q, q being the rounded a/b."""
    p = q * b
    return ((a - p) - p.apply("product_rest", q, b, p)) / b


def maximum(a: Value, b: Value) -> Value:
    """Return the larger number, NaN if either is NaN."""
    return choose(a == a, choose(a >= b, a, b), a)


def copysign(a: Value, b: Value) -> Value:
    """Return |a| with the sign of b, which may be a signed zero."""
    size = abs(a)
    return choose((b < 0.0) | (1.0 / b < 0.0), -size, size)


def is_finite(a: Value) -> Value:
    """Return whether a is neither NaN nor infinite."""
    return a.apply("equal", a - a, 0.0)


_FUNCTIONS = (fma, product_rest, quotient_rest, maximum, copysign, is_finite)
PLAIN = MappingProxyType({f.__name__: f for f in _FUNCTIONS})
_MEANT = TRACED.but(number=float)


@cache
def write_plainly(kind: str) -> Program:
    """Return a program for a kind of operation, for languages that do not have it.

    A library function is replaced by its meaning, which would not do for the rest of a rounding.
    Raises NotImplementedError for a kind without a program.
    """
    if kind in PLAIN:
        body = PLAIN[kind]
        return trace(body, tuple(signature(body).parameters))
    if (meaning := _find_meaning(kind)) is not None:
        inputs = tuple(signature(meaning).parameters)[1:]
        return trace(lambda *values: meaning(_MEANT, *values), inputs)
    if kind in BODIES:
        return build(kind, DOUBLE).program
    raise NotImplementedError(f"the language has no {kind}")


def _find_meaning(kind: str) -> Callable[..., Any] | None:
    row = KINDS[kind]
    is_meant = row.rounding is Rounding.LIBRARY or (row.rounding is NEAREST and kind not in BODIES)
    return row.meaning if is_meant else None


def needs_roundings(kind: str) -> bool:
    """Return whether the program of a kind relies on each sum and product being rounded."""
    if kind in PLAIN:
        return kind in ("fma", "product_rest", "quotient_rest")
    return kind in BODIES and _find_meaning(kind) is None
