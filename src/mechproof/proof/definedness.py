"""Where an expression has a value: conditions for one that are not shown on a domain."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import reduce
from typing import Any, NamedTuple

import sympy as sp
from sympy.concrete.expr_with_limits import ExprWithLimits

from mechproof.proof.algebra import decide_equal
from mechproof.proof.canonical_sums import canonicalise
from mechproof.proof.cases import narrow
from mechproof.proof.coordinates import parametrise
from mechproof.proof.count_zeros import knows_zeros, list_solutions
from mechproof.proof.half_angles import is_shown_there
from mechproof.proof.signs import find_sign, is_nonzero, is_positive, is_shown
from mechproof.record import (
    DerivativeWhere,
    Slack,
    ValueWhere,
    list_divisors,
    list_needs,
    list_partial,
)
from mechproof.record.parts import find_bound
from mechproof.statement_domains.domain import Domain


class InnerNeed(NamedTuple):
    """A condition for a sum's term or an integrand to have values; innermost variable first."""

    need: Slack
    limits: tuple[sp.Tuple, ...]

    def describe(self) -> str:
        """Write it as a relation with the ranges of its variables."""
        runs = (f"{v} from {low} to {high}" for v, low, high in self.limits)
        return f"{describe(self.need)} for {' and '.join(runs)}"


def list_unshown_inside(expression: sp.Basic, domain: Domain) -> list[InnerNeed]:
    """List the unproved conditions for terms of sums and integrands to have values."""
    resolved = domain.resolve(expression)
    found = dict.fromkeys(_list_inside(resolved, ()) if resolved.has(ExprWithLimits) else ())
    return [one for one in found if not _is_shown_inside(one, domain)]


def _list_inside(expression: sp.Basic, limits: tuple[sp.Tuple, ...]) -> Iterator[InnerNeed]:
    for node in list_partial(expression):
        if isinstance(node, ExprWithLimits) and all(len(run) == 3 for run in node.limits):
            counted = node if isinstance(node, sp.Integral) else _count(node)
            inner = (*counted.limits, *limits)
            yield from _list_inside(counted.function, inner)
            yield from (InnerNeed(need, inner) for need in _list_poles(counted))
        elif limits:
            yield from (InnerNeed(need, limits) for need in list_needs(node))


def _list_poles(node: ExprWithLimits) -> Iterator[Slack]:
    """Yield what must be positive for a sum's terms to have no pole at a whole number.

    These are the squares of divisors in whole letters. Zeros in other letters lie at isolated
    points; factorials are judged elsewhere.
    """
    own, inner = {index for index, *_ in node.limits}, find_bound(node.function)
    for divisor in list_divisors(node.function):
        letters = divisor.free_symbols
        is_whole = all(letter.is_integer for letter in letters)
        is_factorial = isinstance(divisor, sp.factorial | sp.binomial | sp.gamma)
        if is_whole and not is_factorial and letters & own and not letters & inner:
            yield Slack(divisor**2, True)


def _count(node: ExprWithLimits) -> ExprWithLimits:
    """Return a sum or a product with its indices declared as whole numbers."""
    told = {
        index: {"nonnegative": True} if low.is_nonnegative else {} for index, low, _ in node.limits
    }
    indices = {index: sp.Symbol(index.name, integer=True, **facts) for index, facts in told.items()}
    limits = [run.xreplace(indices) for run in node.limits]
    return node.func(node.function.xreplace(indices), *limits)


def _is_shown_inside(one: InnerNeed, domain: Domain) -> bool:
    """Return whether a condition holds wherever the variables run, also between whole numbers."""
    number, strict = one.need
    if _has_no_root(*one):
        return True
    for variable, *ends in one.limits:
        low, high = ends[::-1] if (ends[0] > ends[1]) == sp.true else ends
        run = sp.Dummy(variable.name, real=True)
        place, inside = parametrise(run, low, high)
        # An integrand need not have a value at the limits of integration.
        inside = inside if variable.is_integer else inside.interior
        if low == high:
            place, inside = low, sp.S.Reals
        number, domain = number.subs(variable, place), domain.with_set(run, inside)
    return _is_shown(Slack(number, strict), domain)


def _has_no_root(need: Slack, limits: Sequence[sp.Tuple]) -> bool:
    """Return whether all zeros of a square in an index are known, and the index takes none."""
    base, power = need.value.as_base_exp()
    for index, low, high in limits:
        is_of_index = power == 2 and index.is_integer and base.free_symbols == {index}
        if is_of_index and knows_zeros(base, index):
            roots = (root for root in list_solutions(base, index) if root.is_integer)
            return all((root < low) == sp.true or (root > high) == sp.true for root in roots)
    return False


def put_in(side: Any, domain: Domain) -> Any:
    """Put in the given values of symbols; keep the conditions of parts that then cancel.

    Raises `NotImplementedError` where a root, a logarithm or the like then has no real value.
    """
    value = domain.resolve(side)
    if value == side:
        return value
    partial = list_partial(side)
    # All at once, as some of them contain others.
    parts = dict(zip(partial, domain.resolve(sp.Tuple(*partial)), strict=True))
    for part, found in parts.items():
        if found.is_extended_real is False or found.has(sp.nan, sp.zoo):
            raise NotImplementedError(f"{part} has no real value for the given values of letters")
    lost = [x for x in parts.values() if x in list_partial(x) and not value.has(x)]
    if isinstance(value, sp.MatrixBase):
        return value.applyfunc(lambda entry: reduce(ValueWhere, lost, entry))
    return reduce(ValueWhere, lost, value)


def list_unshown(expression: sp.Basic, domain: Domain) -> list[Slack]:
    """List the unproved conditions for roots, logarithms and so on to have values."""
    parts = list_partial(domain.resolve(expression))
    needs = dict.fromkeys(need for node in parts for need in list_needs(node))
    return [need for need in needs if not _is_shown(need, domain)]


def has_values(expression: sp.Basic, domain: Domain) -> bool:
    """Return whether an expression is shown to have a value throughout the domain."""
    return (
        all(map(list_needs, list_partial(expression)))
        and not list_unshown(expression, domain)
        and all(is_nonzero(number, domain) for number in list_divisors(expression))
    )


def list_necessary(expression: sp.Basic) -> list[Slack]:
    """List the conditions without which roots, logarithms and so on have no values at all.

    Powers with symbols in the exponent are left out: of a negative number, such a power has values
    wherever its exponent is whole.
    """
    parts = list_partial(expression)
    nodes = (part for part in parts if not (isinstance(part, sp.Pow) and part.exp.free_symbols))
    return list(dict.fromkeys(need for node in nodes for need in list_needs(node)))


def list_needed(expression: sp.Basic) -> list[Slack]:
    """List the conditions for differentiated functions to have values all around a place."""
    nodes = sorted(expression.atoms(DerivativeWhere), key=sp.default_sort_key)
    needs = (need.value for node in nodes for need in list_necessary(node.args[1]))
    return [Slack(value, True) for value in dict.fromkeys(needs)]


def narrow_to(domain: Domain, needs: Sequence[Slack]) -> Domain | None:
    """Return the part of a domain on which the conditions hold, or None if there is none."""
    for number, strict in needs:
        factors = sp.Mul.make_args(sp.factor(number))
        rest = sp.Mul(*(factor for factor in factors if not is_positive(factor, domain)))
        relation = sp.Gt(rest, 0) if strict else sp.Ge(rest, 0)
        if relation == sp.true:
            continue
        part = narrow(domain, relation)
        if part is None:
            return None
        domain = part
    return domain


def describe(need: Slack) -> str:
    """Write a condition as a relation."""
    number, strict = need
    return f"{number} {'>' if strict else '>='} 0"


def need_the_same(sides: Sequence[sp.Basic], needs: Sequence[list[Slack]], domain: Domain) -> bool:
    """Return whether all sides are proved to have values at the same points.

    They are if their conditions are proved equal. Sums, integrals and cases, whose parts are not
    examined, give False.
    """
    parts = (node for side in sides for node in list_partial(domain.resolve(side)))
    if not all(map(list_needs, parts)):
        return False
    first, *others = ([n for n in own if n.strict or (n.value, True) not in own] for own in needs)
    return all(_covers(o, first, domain) and _covers(first, o, domain) for o in others)


def _covers(needs: list[Slack], others: list[Slack], domain: Domain) -> bool:
    """Return whether each of the others is one of the needs."""
    return all(any(_is_one(need, other, domain) for need in needs) for other in others)


def _is_one(need: Slack, other: Slack, domain: Domain) -> bool:
    (number, strict), (against, is_strict) = need, other
    if strict is not is_strict:
        return False
    return number == against or decide_equal(number, against, domain) is not None


def _is_shown(need: Slack, domain: Domain) -> bool:
    number, strict = need
    if not strict and number.has(sp.Sum) and find_sign(number, domain) is None:
        return _adds_squares(number, domain)
    # In more than one variable half angles take too long for what they prove.
    return (is_shown_there if len(number.free_symbols) == 1 else is_shown)(need, domain)


def _adds_squares(number: sp.Expr, domain: Domain) -> bool:
    """Return whether all terms of a number, those of its sums included, are non-negative."""
    terms = canonicalise(number, domain)
    squares = {
        s: sp.Dummy("squares", nonnegative=True)
        for s in terms.atoms(sp.Sum)
        if s.function.is_nonnegative
    }
    return bool(terms.xreplace(squares).is_nonnegative)
