"""SymPy's estimates of integrals, sums and products, which no proof may rest on.

To find the sign of a number SymPy evaluates it, and simplifies by that: the root of a square, a
comparison. Of an integral it then adds up values at points and may miss a narrow peak.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any, NoReturn

import sympy as sp
from sympy.core.evalf import evalf_table

_ESTIMATED = (sp.Integral, sp.Sum, sp.Product)


@contextmanager
def without_estimates() -> Iterator[None]:
    """Let SymPy find no number for an integral, a sum or a product."""
    kept = {kind: evalf_table[kind] for kind in _ESTIMATED}
    evalf_table.update(dict.fromkeys(_ESTIMATED, _refuse))
    try:
        yield
    finally:
        evalf_table.update(kept)


def _refuse(*asked: Any) -> NoReturn:
    """Answer as SymPy does for what it cannot evaluate."""
    raise NotImplementedError
