"""How the modules of the paper write symbols and variables."""

from __future__ import annotations

from collections.abc import Mapping

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


Symbols = Mapping[sp.Symbol | sp.IndexedBase, tuple[str, ...]]


def lengths(symbols: Symbols) -> tuple[Variable, ...]:
    """Positive lengths (errors, tolerances, radii): the meaning of each, and how it is printed."""
    return tuple(Variable(s, m, LENGTH, POSITIVE, latex=tuple(p)) for s, (m, *p) in symbols.items())


def coefficients(symbols: Symbols) -> tuple[Variable, ...]:
    """Positive pure numbers, in the same way."""
    return tuple(Variable(s, m, within=POSITIVE, latex=tuple(p)) for s, (m, *p) in symbols.items())


def coordinates(symbols: Symbols) -> tuple[Variable, ...]:
    """Lengths of either sign, in the same way."""
    return tuple(Variable(s, m, LENGTH, latex=tuple(p)) for s, (m, *p) in symbols.items())
