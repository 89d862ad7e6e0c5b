"""Where an accuracy bound is stated for certain, and the bound of an approximation over a cell."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from typing import Any

import numpy as np
import sympy as sp

from mechproof.arithmetic import balls
from mechproof.arithmetic.balls import evaluate
from mechproof.lab.oracle import PRECISIONS, count_points, give_balls, list_values
from mechproof.lab.sampling.usual_sizes import Sides
from mechproof.lab.subject import Subject
from mechproof.lab.ways import Arguments, Array, Way, list_columns
from mechproof.proof.signs import find_sign
from mechproof.record.relations import is_comparison
from mechproof.statement_domains.domain import Domain


def mark_accuracy_domain(subject: Subject, arguments: Arguments) -> Array:
    """Mark the points where all relations of the bound hold; undecided ones are not among them.

    What is computed, a difference near zero, is decided by balls: the rounding of doubles would
    decide it at the very points that the relation is to keep out. A relation on elements holds
    where it holds for all of them.
    """
    accuracy = subject.quantity.accuracy
    relations = accuracy.within if accuracy else ()
    computed = [r for r in relations if not is_comparison(subject.domain.resolve(r))]
    held = np.ones(count_points(subject, arguments), bool)
    for relation in relations:
        if relation not in computed:
            held &= _compare(subject, relation, arguments)
    for index, values in enumerate(list_values(subject, arguments)) if computed else ():
        held[index] &= all(_is_true(subject, relation, values) for relation in computed)
    return held


def _is_true(subject: Subject, relation: sp.Basic, values: Mapping[sp.Basic, Any]) -> bool:
    for bits in PRECISIONS:
        known = give_balls(relation, subject.domain.given, values, bits)
        found = balls.truth(relation, known, bits)
        if found is not None:
            return found
    return False


def _compare(subject: Subject, relation: sp.Basic, arguments: Arguments) -> Array:
    """Decide a relation in doubles."""
    symbols = subject.quantity.symbols
    plain = {s: sp.Symbol(str(s)) for s in symbols if isinstance(s, sp.IndexedBase)}
    elements = {item: plain[item.base] for item in relation.atoms(sp.Indexed)}
    test = sp.lambdify([plain.get(s, s) for s in symbols], relation.xreplace(elements), "numpy")
    columns = list_columns(subject.quantity, arguments)
    if not plain:
        # SymPy's code for "or" joins its parts into one array.
        columns = list(np.broadcast_arrays(*columns))
    with np.errstate(all="ignore"):
        found: Array = np.asarray(test(*columns), bool)
    return np.asarray(found.all(axis=-1)) if elements else found


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
