"""Cases: sides given by pieces, or with a symbol of few values, are proved one case at a time.

Each condition is taken to be true and then to be false, each time on the part of the domain where
it is: the splitting of Davis, Logemann and Loveland (1962), on conditions in place of literals.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from typing import Any

import sympy as sp
from sympy.concrete.expr_with_limits import ExprWithLimits
from sympy.core.relational import Relational

from mechproof.proof.canonical_sums import write_out
from mechproof.proof.signs import is_nonnegative, is_positive, is_shown
from mechproof.record.parts import find_bound, find_free, find_parts
from mechproof.record.relations import Slack, find_slack, solve
from mechproof.record.substitution import substitute
from mechproof.statement_domains.domain import Domain
from mechproof.statement_domains.narrowing import leaves_values
from mechproof.statement_domains.set_values import list_closed_ends

Sides = tuple[sp.Expr, sp.Expr]
# Proves both sides equal on a domain; called with the two sides and the domain.
Prove = Callable[..., str | None]
RUNG = "case by case"
# Work limit: moduli and the like in an expression, and arguments of a maximum or minimum.
_MOST_WRITTEN = 5
# Functions that `write_pieces` writes as cases.
IN_PIECES = (sp.Abs, sp.sign, sp.Max, sp.Min)


def decide_by_pieces(sides: Sides, domain: Domain, prove: Prove) -> str | None:
    """Prove sides given by pieces equal, whichever condition holds; None for other sides."""
    condition = min(_list_conditions(sides), key=sp.default_sort_key, default=None)
    if condition is None:
        return None
    # A case that holds at no point of the domain need not be proved.
    cases = {True: condition, False: condition.negated}
    met = {holds: narrow(domain, case) for holds, case in cases.items()}
    return _join(
        prove(*_pin([assume(side, condition, holds=holds) for side in sides], part))
        for holds, part in met.items()
        if part is not None and not _always(cases[not holds], domain)
    )


def _always(condition: Relational, domain: Domain) -> bool:
    """Return whether a condition on more than one letter is shown to hold by signs."""
    slack = find_slack(condition)
    if slack is None or len(slack.value.free_symbols) < 2:
        return False
    return is_shown(slack, domain)


def _pin(sides: Sequence[sp.Expr], domain: Domain) -> tuple[Any, ...]:
    """Put in a symbol's value if two relations of the domain fix it, as where pieces meet."""
    *others, last = map(find_slack, domain.where or (sp.true,))
    met = (one for one in others if last and one and _are_opposite(one, last, domain))
    for slack in met:
        for symbol in sorted(slack.value.free_symbols, key=str):
            slope = slack.value.coeff(symbol)
            rest = sp.expand(slack.value - slope * symbol)
            if slope.is_number and slope != 0 and not rest.has(symbol):
                return put_in(sides, domain, {symbol: -rest / slope})
    return (*sides, domain)


def _are_opposite(one: Slack, other: Slack, domain: Domain) -> bool:
    """Return whether one slack is non-strict and a negative multiple of the other."""
    if one.strict or not one.value.free_symbols <= other.value.free_symbols:
        return False
    return one.value == -other.value or is_positive(-sp.cancel(other.value / one.value), domain)


def decide_from_zero(sides: Sides, domain: Domain, prove: Prove) -> str | None:
    """Prove sums up to a count equal where it is zero, and from 1 on; None for other sides."""
    sums = {total for side in sides for total in find_parts(side, sp.Sum, sp.Product)}
    free = {symbol for total in sums for symbol in total.free_symbols}
    counts = [symbol for symbol in free if domain.set_of(symbol) == sp.S.Naturals0]
    if not counts:
        return None
    count = min(counts, key=str)
    later = sp.Symbol(count.name, integer=True, positive=True)
    *at_zero, zero = put_in(sides, domain, {count: sp.S.Zero})
    *from_one, part = put_in(sides, domain, {count: later})
    part = replace(part, within={**part.within, later: sp.S.Naturals})
    cases = ((*map(write_out, at_zero), zero), (*from_one, part))
    return _join(prove(*case) for case in cases)


def decide_from_last(sides: Sides, domain: Domain, prove: Prove) -> str | None:
    """Prove sums that begin at a letter equal by their numbers of terms; None for other sides."""
    sums = {total for side in sides for total in find_parts(side, sp.Sum, sp.Product)}
    if not sums:
        return None
    ends = {limits[1:] for total in sums for limits in total.limits if limits[1].free_symbols}
    known = ((low, high) for low, high in ends if high.is_Symbol and not low.has(high))
    for low, high in sorted(known, key=str):
        if low.is_integer and is_nonnegative(high - low, domain):
            gap = sp.Dummy("gap", integer=True, nonnegative=True)
            value = {high: low + gap}
            part = fix(domain, value).with_set(gap, sp.S.Naturals0)
            return prove(*(_begin_at_zero(substitute(s, value)) for s in sides), part)
    moved = [_begin_at_zero(side) for side in sides]
    return None if moved == [*sides] else prove(*moved, domain)


def _begin_at_zero(side: sp.Expr) -> sp.Expr:
    """Rewrite sums that begin at a letter so that their index counts from zero."""

    def move(total: ExprWithLimits) -> sp.Expr:
        index, low, high = total.limits[0]
        if len(total.limits) > 1 or not low.free_symbols:
            return total
        term = substitute(total.function, {index: low + index})
        return total.func(term, (index, 0, sp.expand(high - low)))

    return side.replace(lambda node: isinstance(node, sp.Sum | sp.Product), move)


def decide_from_zero_end(sides: Sides, domain: Domain, prove: Prove) -> str | None:
    """Prove sides equal where a letter is zero, an end of its range, and where it is not.

    The letter is in the base of a symbolic power, or a factor in a maximum or minimum. None without
    such a letter.
    """
    bases = {p.base for side in sides for p in side.atoms(sp.Pow) if p.exp.free_symbols}
    compared = {x for side in sides for one in side.atoms(sp.Max, sp.Min) for x in one.args}
    free = {symbol for base in bases for symbol in base.free_symbols}
    free |= {factor for one in compared if one.is_Mul for factor in one.args if factor.is_Symbol}
    tied = {symbol for relation in domain.where for symbol in relation.free_symbols}
    ended = [s for s in free - tied if 0 in list_closed_ends(domain.set_of(s))]
    if not ended:
        return None
    symbol = min(ended, key=str)
    elsewhere = domain.with_set(symbol, domain.set_of(symbol) - sp.FiniteSet(0))
    cases = (put_in(sides, domain, {symbol: sp.S.Zero}), (*sides, elsewhere))
    return _join(prove(*case) for case in cases)


def write_pieces(expression: sp.Expr, poles: Collection[sp.Expr] = ()) -> sp.Expr:
    """Write moduli, signs, maxima and minima by pieces, unless there are too many of them.

    Nothing is written where a symbol is bound, either, as a condition might depend on it. The sign
    of a number in `poles` gets no piece for zero.
    """
    nodes = expression.atoms(*IN_PIECES)
    if len(nodes) > _MOST_WRITTEN or any(len(node.args) > _MOST_WRITTEN for node in nodes):
        return expression
    if expression.has(ExprWithLimits):
        return expression
    return expression.replace(
        lambda node: isinstance(node, IN_PIECES), lambda node: _write_pieces(node, poles)
    )


def list_poles(sides: Iterable[sp.Expr]) -> set[sp.Expr]:
    """List the divisors, and the numbers whose moduli are divisors."""
    bases = {p.base for side in sides for p in side.atoms(sp.Pow) if p.exp.is_negative}
    return bases | {base.args[0] for base in bases if isinstance(base, sp.Abs)}


def _write_pieces(node: sp.Expr, poles: Collection[sp.Expr]) -> sp.Expr:
    """Write one function by pieces; the point where they meet may belong to either."""
    if isinstance(node, sp.sign):
        (number,) = node.args
        if number.is_Mul and number not in poles:
            signs = sp.Mul(*map(sp.sign, number.args))
            return signs.replace(sp.sign, lambda factor: _write_pieces(sp.sign(factor), poles))
        if number.could_extract_minus_sign():
            return -_write_pieces(sp.sign(-number), poles)
        above = 1 if number in poles else sp.Piecewise((0, sp.Le(number, 0)), (1, True))
        return _choose(number, above, sp.S.NegativeOne)
    if isinstance(node, sp.Abs):
        return _choose(node.args[0], node.args[0], -node.args[0])
    first, *others = node.args
    for other in others:
        sides = (first, other) if isinstance(node, sp.Max) else (other, first)
        first = _choose(first - other, *sides)
    return first


def _choose(difference: sp.Expr, above: sp.Expr, below: sp.Expr) -> sp.Expr:
    """Return cases in a canonical form: `above` where the difference is positive, else `below`."""
    if difference.could_extract_minus_sign():
        difference, above, below = -difference, below, above
    alone = [s for s in sorted(difference.free_symbols, key=str) if difference.coeff(s) == 1]
    least = alone[0] - difference if alone else sp.S.Zero
    condition = sp.Ge(alone[0] if alone else difference, least)
    return sp.Piecewise((above, condition), (below, True))


def decide_by_values(sides: Sides, domain: Domain, prove: Prove) -> str | None:
    """Prove sides equal for each value of a symbol with a finite set; None if there is none."""
    symbols = {symbol for side in sides for symbol in side.free_symbols} & domain.within.keys()
    listed = [s for s in symbols if isinstance(domain.set_of(s), sp.FiniteSet)]
    if not listed:
        return None
    symbol = min(listed, key=str)
    values = domain.set_of(symbol).args
    return _join(prove(*put_in(sides, domain, {symbol: value})) for value in values)


def narrow(domain: Domain, relation: Relational) -> Domain | None:
    """Return the part of a domain on which a relation holds, or None if it is empty.

    A relation that is not solved for a symbol is added to the part's relations; an equation that is
    not solved narrows nothing. A part that is returned may still have no point.
    """
    relation = domain.resolve(relation)
    if relation == sp.false:
        return None
    symbols = relation.free_symbols
    if len(symbols) == 1 and symbols <= domain.within.keys():
        (symbol,) = symbols
        # SymPy raises a TypeError where it mistakes a set of conditions for a set of points.
        with suppress(NotImplementedError, TypeError):
            narrowed = domain.set_of(symbol).intersect(solve(relation, symbol))
            if narrowed == sp.S.EmptySet or _excludes(domain, symbol, narrowed):
                return None
            if isinstance(narrowed, sp.Interval | sp.FiniteSet):
                return _refuse_empty(replace(domain, within={**domain.within, symbol: narrowed}))
    if isinstance(relation, sp.Eq) or not isinstance(relation, Relational):
        return domain
    return _refuse_empty(replace(domain, where=(*domain.where, relation)))


def _refuse_empty(domain: Domain) -> Domain | None:
    """Return a domain, or None if its relations leave no value for some letter."""
    sets = {symbol: domain.set_of(symbol) for one in domain.where for symbol in find_free(one)}
    return domain if leaves_values(sets, domain.where, {}) else None


def _excludes(domain: Domain, symbol: sp.Basic, values: sp.Set) -> bool:
    """Return whether a symbol has only one value left, and a relation of the domain excludes it."""
    if not (isinstance(values, sp.FiniteSet) and len(values) == 1):
        return False
    (value,) = values
    return any(relation.subs(symbol, value) == sp.false for relation in domain.where)


def _list_conditions(sides: Sides) -> set[Relational]:
    """Collect the conditions of pieces whose symbols are free throughout the sides.

    Conditions that contain pieces are collected later, once those pieces are decided.
    """
    pieces = {piece for side in sides for piece in side.atoms(sp.Piecewise)}
    free = {symbol for side in sides for symbol in side.free_symbols}
    bound = {symbol for side in sides for symbol in find_bound(side)}
    conditions = {c for piece in pieces for _, cond in piece.args for c in cond.atoms(Relational)}
    plain = (c for c in conditions if not c.has(sp.Piecewise))
    return {c.canonical for c in plain if c.free_symbols <= free - bound}


def assume(side: sp.Expr, condition: Relational, *, holds: bool) -> sp.Expr:
    """Return a side with a condition and its negation decided, and |v| with the sign it implies."""
    known = {
        relation: sp.sympify(truth)
        for stated, truth in ((condition, holds), (condition.negated, not holds))
        for relation in side.atoms(Relational)
        if relation.canonical == stated.canonical
    }
    slack = find_slack(condition)
    if slack is None:
        return side.xreplace(known)
    size = {sp.Abs(slack.value): slack.value if holds else -slack.value}
    return side.xreplace(known).xreplace(size)


def put_in(
    sides: Sequence[sp.Expr], domain: Domain, value: Mapping[sp.Basic, sp.Expr]
) -> tuple[Any, ...]:
    """Return sides with values put in for symbols, and the domain restricted to these values."""
    return *(substitute(side, value) for side in sides), fix(domain, value)


def fix(domain: Domain, value: Mapping[sp.Basic, sp.Expr]) -> Domain:
    """Return the part of a domain on which symbols have given values."""
    within = {symbol: values for symbol, values in domain.within.items() if symbol not in value}
    where = tuple(substitute(relation, value) for relation in domain.where)
    return replace(domain, within=within, where=where, given={**domain.given, **value})


def _join(rungs: Iterable[str | None]) -> str | None:
    """Return the names of all cases' rungs, or None if one case is not proved."""
    found = {RUNG: None}
    for rung in rungs:
        if rung is None:
            return None
        found |= dict.fromkeys(rung.split(", "))
    return ", ".join(found)
