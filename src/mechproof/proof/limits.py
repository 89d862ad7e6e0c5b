"""Evaluate limits.

Functions that are smooth around the point come first (`smooth_limits`); others are examined on each
side that is meant and on which they have values, by how fast their parts grow (`growth`). Any other
limit stays as it is, neither proved nor refuted.
"""

from __future__ import annotations

from typing import Any

import sympy as sp

from mechproof.proof.algebra import decide_equal
from mechproof.proof.continuity import find_break
from mechproof.proof.coordinates import write_by_sines
from mechproof.proof.exact_values import write_value
from mechproof.proof.growth import find_limit, is_defined_near
from mechproof.proof.induction import sum_up
from mechproof.proof.integral_kinds import list_zeros_between
from mechproof.proof.signs import find_sign, is_nonzero, is_positive
from mechproof.proof.smooth_limits import find_smooth
from mechproof.record import DerivativeWhere, ValueWhere, list_partial
from mechproof.record.parts import find_parts
from mechproof.record.substitution import put_found
from mechproof.statement_domains.domain import Domain
from mechproof.statement_domains.preparation import take_values

FROM_SIDES = "limits from both sides"
# Work limit: zeros larger than this are not looked for.
_FAR = sp.Integer(10) ** 9


def settle_limits(expression: Any, domain: Domain) -> Any:
    """Replace limits by their values, as far as these are shown.

    An infinite limit is replaced only where it stands alone, not inside a formula.
    """
    limits = sorted(find_parts(expression, sp.Limit), key=sp.default_sort_key)
    return put_found(expression, {limit: _find_value(limit, domain) for limit in limits})


def _find_value(limit: sp.Limit, domain: Domain) -> sp.Expr | None:
    body, variable, point, direction = limit.args
    body = sum_up(body, variable, domain) if point == sp.oo else body
    # Real, as n is replaced by 1/n: sin(pi/n) would become sin(pi*n), which SymPy evaluates to 0.
    running = sp.Dummy(variable.name, real=True)
    run = write_by_sines(body.xreplace({variable: running}))
    value = find_smooth(run, running, point, domain)
    if value is None and variable.is_integer and point == sp.oo:
        count = sp.Dummy(variable.name, integer=True, positive=True)
        value = _find_of_sequence(body.xreplace({variable: count}), count, domain)
    if value is None:
        value = _find_from_sides(run, running, point, str(direction), domain)
    found = () if value is not None else _list_by_parity(limit, domain)
    return found[0] if found and all(decide_equal(found[0], x, domain) for x in found) else value


def _list_by_parity(limit: sp.Limit, domain: Domain) -> tuple[sp.Expr, ...]:
    """List a sequence's limits for even and for odd n if it has powers of -1; () if not shown."""
    body, n, point, direction = limit.args
    turns = [p for p in body.atoms(sp.Pow) if p.base == -1 and p.exp.has(n)]
    is_met = turns and n.is_integer and point == sp.oo
    if not is_met or not all(turn.exp.is_polynomial(n) for turn in turns):
        return ()
    parts = [_turn_whole(body.subs(n, 2 * n + r)) for r in (0, 1)]
    values = [_find_value(sp.Limit(part, n, point, direction), domain) for part in parts]
    found = [value for value in values if value is not None and value.is_finite]
    return tuple(found) if len(found) == len(values) else ()


def _find_of_sequence(body: sp.Expr, n: sp.Symbol, domain: Domain) -> sp.Expr | None:
    """Return an infinite sum or product for one up to n, or 0 if quotients tend to less than 1.

    The sign of a sequence that tends to 0 may alternate. The n-th root of a sequence tends to the
    limit of the sequence's quotients (Cauchy, Cours d'analyse, 1821).
    """
    steady, moving = body.as_independent(n, as_Add=True)
    if steady != 0:
        value = _find_of_sequence(moving, n, domain)
        return None if value is None else steady + value
    factor, total = body.as_independent(sp.Sum, as_Add=False)
    if isinstance(total, sp.Sum):
        body = total.func(factor * total.function, *total.limits)
    if isinstance(body, sp.Sum | sp.Product) and len(body.limits) == 1:
        k, first, last = body.limits[0]
        if (last - n).has(n) or first.has(n):
            return None
        if not body.function.has(n):
            return body.func(body.function, (k, first, sp.oo))
        return _find_riemann(body, n, domain) if isinstance(body, sp.Sum) else None
    if body.is_positive and any(power.exp.has(1 / n) for power in body.atoms(sp.Pow)):
        root = _find_limit_of_quotients(sp.powdenest(body**n), n, domain)
        if root is not None:
            return root
    sizes = [f for f in sp.Mul.make_args(body) if f.as_base_exp()[0] != -1]
    size = sp.Mul(*sizes)
    if size != body and find_limit(size, n, sp.oo, -1, domain) == 0:
        return sp.S.Zero
    parts = [part for part in list_partial(size) if part.has(n)]
    ends = [factorial.args[0] for factorial in size.atoms(sp.factorial) if factorial.has(n)]
    if not all(is_defined_near(part, n, sp.oo, -1, domain) for part in parts) or not all(
        find_limit(end, n, sp.oo, -1, domain) == sp.oo for end in ends
    ):
        return None
    limit = _find_limit_of_quotients(size, n, domain)
    is_less = limit is not None and limit.is_finite and is_positive(1 - limit**2, domain)
    return sp.S.Zero if is_less else None


def _find_limit_of_quotients(size: sp.Expr, n: sp.Symbol, domain: Domain) -> sp.Expr | None:
    quotient = sp.powsimp(sp.combsimp(size.subs(n, n + 1) / size))
    return find_limit(quotient, n, sp.oo, -1, domain)


def _find_riemann(total: sp.Sum, n: sp.Symbol, domain: Domain) -> sp.Expr | None:
    """Return the integral from 0 to 1 of f, continuous there, for the sum of f(k/n)/n; or None."""
    k, first, last = total.limits[0]
    x = sp.Dummy("x", real=True)
    between, whole = sp.symbols("x n", cls=sp.Dummy, positive=True)
    term = total.function.subs(k, n * between).subs(n, whole)
    f = sp.simplify(whole * term).subs(between, x)
    inside = domain.with_set(x, sp.Interval(0, 1))
    if f.has(whole) or first not in (0, 1) or last - n not in (0, -1) or find_break(f, x, inside):
        return None
    return sp.Integral(f, (x, 0, 1))


def _turn_whole(body: sp.Expr) -> sp.Expr:
    """Return a body with even terms dropped from the exponents of -1."""

    def is_odd(term: sp.Expr) -> bool:
        return not (term / 2).is_integer

    return body.replace(
        lambda node: isinstance(node, sp.Pow) and node.base == -1,
        lambda turn: (-1) ** sp.Add(*filter(is_odd, sp.Add.make_args(sp.expand(turn.exp)))),
    )


def _find_from_sides(
    body: sp.Expr, variable: sp.Symbol, point: sp.Expr, direction: str, domain: Domain
) -> sp.Expr | None:
    """Return the one limit that is shown from every side that is meant and has values, or None."""
    found = _list_from_sides(body, variable, point, direction, domain)
    if not found:
        return None
    first, *others = found
    if first.is_infinite:
        return first if {*others} <= {first} else None
    return first if all(decide_equal(first, other, domain) for other in others) else None


def _list_from_sides(
    body: sp.Expr, variable: sp.Symbol, point: sp.Expr, direction: str, domain: Domain
) -> list[sp.Expr]:
    """List the limits from the sides that are meant and have values; none if one is not shown."""
    meant = [1, -1] if direction == "+-" and point.is_finite else [-1 if direction == "-" else 1]
    sides = [side for side in meant if _may_come(variable, point, side, domain)]
    defined = {side: is_defined_near(body, variable, point, side, domain) for side in sides}
    if None in defined.values():
        return []
    found = [find_limit(body, variable, point, side, domain) for side in sides if defined[side]]
    return [limit for limit in found if limit is not None] if None not in found else []


def _may_come(variable: sp.Symbol, point: sp.Expr, side: int, domain: Domain) -> bool:
    """Return whether a variable may have values on a side of a point.

    What the domain says of the letter printed for the variable also binds the variable.
    """
    name = variable.name.removesuffix("_")
    letters = {*domain.within, *(s for relation in domain.where for s in relation.free_symbols)}
    signs = (find_sign(side * (s - point), domain) for s in letters if str(s) == name)
    return bool(point.is_infinite) or not any(sign and sign.direction < 0 for sign in signs)


def describe_missing_limit(sides: tuple[Any, Any], domain: Domain) -> str:
    """Report why one side is a limit that does not exist, or "" if that is not shown."""
    alone = [side for side in sides if isinstance(side, sp.Limit)]
    told = _describe_unlike(alone[0], domain) if len(alone) == 1 else ""
    return f"{told}: there is no limit" if told else ""


def _describe_unlike(limit: sp.Limit, domain: Domain) -> str:
    """Report the limits from both sides if they differ and at least one is finite, else ""."""
    body, variable, point, direction = limit.args
    if by_parity := _list_by_parity(limit, domain):
        even, odd = map(write_value, by_parity)
        shown = f"the limit for even {variable} is {even}, for odd {odd}"
        return shown if is_nonzero(by_parity[0] - by_parity[1], domain) else ""
    found = _list_from_sides(write_by_sines(body), variable, point, str(direction), domain)
    if len(found) < 2 or all(one.is_infinite for one in found):
        return ""
    above, below = found
    is_unlike = above.is_infinite or below.is_infinite or is_nonzero(above - below, domain)
    shown = f"the limit from above is {write_value(above)}, from below {write_value(below)}"
    return shown if is_unlike else ""


def describe_jump(sides: tuple[Any, Any], domain: Domain) -> str:
    """Report a jump of a differentiated expression at a zero of a sign's or modulus's argument."""
    derived = {node for side in sides for node in find_parts(side, DerivativeWhere)}
    needed = {value for node in derived for value in node.args[1].atoms(ValueWhere)}
    limits = (
        sp.Limit(take_values(value), x, zero, "+-")
        for value in sorted(needed, key=sp.default_sort_key)
        for x in value.args[1].free_symbols
        for zero in list_zeros_between(1 / value.args[1], x, -_FAR, _FAR)
    )
    return next(filter(None, (_describe_unlike(limit, domain) for limit in limits)), "")
