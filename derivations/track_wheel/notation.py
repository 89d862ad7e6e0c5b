"""How the modules of the paper write symbols and variables."""

from __future__ import annotations

import sympy as sp

from mechproof.record import LENGTH, Variable

POSITIVE = sp.Interval.open(0, sp.oo)
UNIT_INTERVAL = sp.Interval(-1, 1)


def positive(names: str) -> tuple[sp.Symbol, ...]:
    """Positive symbols."""
    return tuple(sp.symbols(names, positive=True, seq=True))


def real(names: str) -> tuple[sp.Symbol, ...]:
    """Real symbols."""
    return tuple(sp.symbols(names, real=True, seq=True))


def positive_families(names: str) -> tuple[sp.IndexedBase, ...]:
    """Symbols with an index whose members are positive."""
    return tuple(sp.IndexedBase(name, positive=True) for name in names.split())


def lengths(meanings: dict[sp.Symbol | sp.IndexedBase, str]) -> tuple[Variable, ...]:
    """Positive lengths (errors, tolerances, radii)."""
    return tuple(Variable(s, meaning, LENGTH, POSITIVE) for s, meaning in meanings.items())


def coefficients(meanings: dict[sp.Symbol | sp.IndexedBase, str]) -> tuple[Variable, ...]:
    """Positive pure numbers."""
    return tuple(Variable(s, meaning, within=POSITIVE) for s, meaning in meanings.items())


def coordinates(meanings: dict[sp.Symbol, str]) -> tuple[Variable, ...]:
    """Lengths of either sign."""
    return tuple(Variable(s, meaning, LENGTH) for s, meaning in meanings.items())
