"""SymPy's estimates of integrals, sums and products, on which no proof may rest.

To find the sign of a number, SymPy evaluates it, and simplifies accordingly: the root of a square,
a comparison. For an integral it then adds up values at points, and may miss a narrow peak.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from functools import partial
from typing import Any

import sympy as sp
from sympy.core.evalf import evalf_table

_are_refused: ContextVar[bool] = ContextVar("_are_refused", default=False)


@contextmanager
def without_estimates() -> Iterator[None]:
    """Keep SymPy from estimating integrals, sums and products, in this thread only."""
    token = _are_refused.set(True)
    try:
        yield
    finally:
        _are_refused.reset(token)


def _estimate(estimate: Callable[..., Any], *asked: Any) -> Any:
    if _are_refused.get():
        # SymPy itself raises this for what it cannot evaluate.
        raise NotImplementedError
    return estimate(*asked)


# SymPy has one table for all threads: it is changed once and for all.
for _kind in (sp.Integral, sp.Sum, sp.Product):
    evalf_table[_kind] = partial(_estimate, evalf_table[_kind])
