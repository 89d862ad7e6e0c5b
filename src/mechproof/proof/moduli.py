"""Rungs of inequalities between moduli: by the signs of what is in them, and by a mean value.

|u| is the largest of t*u, -1 <= t <= 1: a sum of moduli is no less than others if for each choice
of signs of these, factors t are found with which both are the same. And |f(x) - f(y)| is no more
than the largest slope of f times |x - y|.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable
from itertools import product

import sympy as sp

from mechproof.proof.continuity import find_break
from mechproof.record import Slack
from mechproof.statement_domains.domain import Domain

SIGNS = "signs of moduli"
MEAN_VALUE = "mean value theorem"
# Work limit: so many moduli are subtracted.
_MOST_SUBTRACTED = 4


def holds_by_signs(slack: Slack, domain: Domain) -> bool:
    """Tell whether moduli are no less than others and a number, whatever the signs are.

    Powers stay as they are: high ones have too many terms.
    """
    rest, factors = _read(domain.resolve(slack.value))
    above = {node: c for node, c in factors.items() if c > 0}
    below = {node: c for node, c in factors.items() if c < 0}
    is_met = above and len(below) <= _MOST_SUBTRACTED and not rest.has(sp.Abs)
    if slack.strict or not is_met:
        return False
    signs = product((1, -1), repeat=len(below))
    parts = [c * node.args[0] for node, c in below.items()]
    sums = (rest + sp.Add(*map(sp.Mul, some, parts)) for some in signs)
    return all(_is_reached([c * node.args[0] for node, c in above.items()], x) for x in sums)


def _read(value: sp.Expr) -> tuple[sp.Expr, dict[sp.Abs, sp.Expr]]:
    """Return the moduli with numbers before them, and what else is added."""
    terms = sp.expand_mul(value).as_coefficients_dict()
    factors = {node: c for node, c in terms.items() if isinstance(node, sp.Abs)}
    return sp.Add(*(c * term for term, c in terms.items() if term not in factors)), factors


def _is_reached(parts: list[sp.Expr], subtracted: sp.Expr) -> bool:
    """Tell whether the sum of t*u and what is subtracted is a number from 0 on, for some t."""
    shares = [sp.Dummy("t", real=True) for _ in parts]
    equations: dict[sp.Expr, sp.Expr] = defaultdict(lambda: sp.S.Zero)
    for share, part in zip((sp.S.One, *shares), (subtracted, *parts), strict=True):
        for term, number in sp.expand_mul(part).as_coefficients_dict().items():
            equations[term] += number * share
    least = equations.pop(sp.S.One, sp.S.Zero)
    solved = next(iter(sp.linsolve([*equations.values()], shares)), None)
    if solved is None:
        return False
    free = dict.fromkeys(shares, sp.S.Zero)
    chosen = dict(zip(shares, (share.xreplace(free) for share in solved), strict=True))
    is_within = all(abs(share) <= 1 for share in chosen.values())
    return is_within and bool(least.xreplace(chosen) >= 0)


def holds_by_mean_value(
    slack: Slack, domain: Domain, show: Callable[[Slack, Domain], str | None]
) -> bool:
    """Tell whether a multiple of |x - y| is no less than |f(x) - f(y)|, by the slope of f."""
    rest, factors = _read(domain.resolve(slack.value))
    if slack.strict or rest != 0 or sorted(map(sp.sign, factors.values())) != [-1, 1]:
        return False
    (length, scale), (gap, factor) = sorted(factors.items(), key=lambda item: -item[1])
    x, *others = sorted(length.free_symbols, key=str)
    if len(others) != 1 or (slope := sp.diff(length.args[0], x)) not in (1, -1):
        return False
    (y,), c = others, sp.Dummy("c", real=True)
    f, where = gap.args[0], domain.set_of(x)
    is_met = (
        sp.expand_mul(length.args[0] - slope * (x - y)) == 0
        and sp.expand_mul(f + f.xreplace({x: y, y: x})) == 0
        and not sp.diff(f, x).has(y)
        and isinstance(where, sp.Interval)
        and where == domain.set_of(y)
    )
    if not is_met:
        return False
    steep, inner = sp.diff(f, x).xreplace({x: c}), domain.with_set(c, where.interior)
    return find_break(f.xreplace({x: c}), c, domain.with_set(c, where)) is None and all(
        show(Slack(scale + sign * factor * steep, False), inner) for sign in (1, -1)
    )
