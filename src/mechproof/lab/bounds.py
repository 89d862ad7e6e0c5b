"""The proved bound of an approximation over a cell, from its value at the largest corner."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
import sympy as sp

from mechproof.arithmetic.balls import evaluate
from mechproof.lab.sampling.usual_sizes import Sides
from mechproof.lab.subject import Subject
from mechproof.lab.ways import Way
from mechproof.proof.signs import find_sign
from mechproof.statement_domains.domain import Domain


def bound_approximation(subject: Subject, way: Way, cell: Sides) -> float | None:
    """Return what the error stays below on a cell of sizes.

    None without a bound, or for a bound that does not provably rise with every size.
    """
    if way.bound is None:
        return None
    bound = subject.domain.resolve(way.bound)
    sizes = {s: sp.Symbol(f"size_{s}", positive=True) for s in sorted(bound.free_symbols, key=str)}
    if not sizes.keys() <= _corner(subject, cell).keys() or not _rises(bound, subject, sizes):
        return None
    ball = evaluate(bound, {s: _corner(subject, cell)[s] for s in sizes}, 128)
    return float(np.nextafter(float(ball.upper()), np.inf)) if ball.is_finite() else None


def _corner(subject: Subject, cell: Sides) -> dict[sp.Symbol, float]:
    """Give every symbol the largest size its argument has in the cell."""
    return {
        symbol: cell[argument.name][1]
        for argument in subject.quantity.arguments
        if argument.name in cell
        for symbol in argument.symbols
    }


def _rises(bound: sp.Expr, subject: Subject, sizes: dict[sp.Symbol, sp.Symbol]) -> bool:
    """Decide that the bound depends on sizes alone and falls with none of them."""
    sets = {s: subject.domain.set_of(s) for s in sizes}
    signed = [s for s in sizes if sets[s].inf < 0]
    if any(sp.simplify(bound - bound.subs(s, -s)) != 0 for s in signed):
        return False
    positive = sp.Interval.open(0, sp.oo)
    within = tuple((size, sp.Intersection(sets[s], positive)) for s, size in sizes.items())
    return _rises_in_sizes(bound.subs(sizes), within)


@lru_cache(maxsize=256)
def _rises_in_sizes(bound: sp.Expr, within: tuple[tuple[sp.Symbol, sp.Set], ...]) -> bool:
    """Decide that an expression of positive sizes is nonnegative and falls with none of them."""
    if bound.is_Number or bound.is_Symbol:
        return bool(bound.is_nonnegative)
    if isinstance(bound, sp.Add | sp.Mul):
        return all(_rises_in_sizes(part, within) for part in bound.args)
    if isinstance(bound, sp.Pow) and bound.exp.is_positive and bound.exp.is_number:
        return _rises_in_sizes(bound.base, within)
    domain = Domain(dict(within), (), {})
    signs = [find_sign(bound, domain)]
    signs += [find_sign(sp.factor(sp.diff(bound, size)), domain) for size, _ in within]
    return all(sign is not None and sign.direction > 0 for sign in signs)
