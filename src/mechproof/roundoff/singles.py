"""Single precision: steps in floats as C computes them, each operation rounded once.

Beyond their largest angle the functions of C's own library are taken; here these are rounded right.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from types import MappingProxyType
from typing import Any

import numpy as np

from mechproof.codegen.elementary.formats import SINGLE
from mechproof.codegen.elementary.functions import BODIES, build
from mechproof.roundoff.fused import add_to_odd
from mechproof.roundoff.running import IN_DOUBLES, Table, run

FORMAT = np.float32


def _fma(a: Any, b: Any, c: Any) -> Any:
    """Return a*b + c rounded once: the product is exact in doubles, the sum rounded to odd."""
    product, rest = np.multiply(a, b, dtype=float), np.asarray(c, float)
    total = product + rest
    return FORMAT(np.where(np.isfinite(total), add_to_odd(product, rest), total))


def _maximum(a: Any, b: Any) -> Any:
    return np.where((a >= b) | np.isnan(a), a, b)


def _power_of_two(n: Any) -> Any:
    return FORMAT(np.exp2(np.asarray(n, float)))


def _in_doubles(function: Callable[[Any], Any]) -> Callable[[Any], Any]:
    return lambda y: FORMAT(function(np.asarray(y, float)))


# What the machine and the library compute, an elementary function beyond its largest angle too.
_MACHINE: Table = MappingProxyType(
    {
        **IN_DOUBLES,
        "number": FORMAT,
        "fma": _fma,
        "maximum": _maximum,
        "power_of_two": _power_of_two,
        **{kind: _in_doubles(getattr(np, kind)) for kind in ("sin", "cos", "tan")},
    }
)


def _compute(kind: str, *operands: Any) -> Any:
    function = build(kind, SINGLE)
    given = dict(zip(function.program.inputs, operands, strict=True))
    (value,) = run(function.program, given, _MACHINE)
    if function.far is None:
        return value
    (beyond,) = run(function.far, given, _MACHINE)
    return np.where(np.abs(operands[0]) <= FORMAT(SINGLE.largest), value, beyond)


IN_SINGLES: Table = MappingProxyType(
    {**_MACHINE, **{kind: partial(_compute, kind) for kind in BODIES}}
)
