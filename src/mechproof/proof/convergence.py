"""Integrals, sums and limits without a value, for which any printed value is wrong.

An integral does not converge if its integrand is at least like 1/x at a pole or an end, or if an
antiderivative is infinite there or has no limit, whatever its signs; a sum does not if its terms do
not tend to zero.

Conditions on letters that would give a value are proposed from the forms that converge: powers at
zero and at infinity, exponentials, geometric series, the rows of the table of integrals; sums run
upwards. The rungs then prove the sides equal under these conditions.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import reduce
from itertools import chain
from typing import Any

import sympy as sp

from mechproof.arithmetic import balls
from mechproof.proof.cases import narrow
from mechproof.proof.coordinates import write_by_sines
from mechproof.proof.count_zeros import list_failing
from mechproof.proof.definedness import describe, list_unshown, narrow_to
from mechproof.proof.endless_sums import read_endless
from mechproof.proof.exact_values import write_value
from mechproof.proof.growth import find_limit, is_defined_near
from mechproof.proof.integral_kinds import find_residue, is_improper, is_iterated
from mechproof.proof.integrals import cut_at_poles, find_ends, list_antiderivatives
from mechproof.proof.known_integrals import list_needed as list_of_table
from mechproof.proof.refutation import BALLS, FEW, points_for
from mechproof.proof.signs import is_nonzero, is_positive, is_shown
from mechproof.proof.value_points import complete, has_value
from mechproof.proof.verdict import Answer, Verdict
from mechproof.record import RecordError, Slack, list_needs, list_partial
from mechproof.record.parts import ENDLESS, find_parts, has_parts
from mechproof.record.substitution import substitute
from mechproof.statement_domains.domain import Domain, Point

RUNG = "divergence"
_NAMES = {sp.Integral: "the integral", sp.Sum: "the sum", sp.Limit: "the limit"}
# Letters that often mean whole numbers even if nothing says so.
_WHOLE = (*"ijklmnN",)
# Angles at which an oscillating expression is evaluated, to see whether its limits differ.
_ANGLES = tuple(sp.pi * k / 4 for k in range(8))

# Places between the limits, as shares of their distance, at which an integrand is evaluated.
_SHARES = tuple(sp.Rational(k, 64) for k in (1, 8, 32, 56, 63))
_ALL = Domain({}, (), {})


def describe_divergence(sides: tuple[Any, Any], domain: Domain) -> str:
    """Report why a side has no value although the other is a number; "" if that is not shown."""
    endless = [side for side in sides if has_parts(side, *ENDLESS)]
    has_others = any(side.has(sp.oo, sp.nan, sp.zoo) for side in sides if side not in endless)
    if len(endless) != 1 or has_others or not isinstance(endless[0], sp.Expr):
        return ""
    nodes = find_parts(endless[0], *ENDLESS)
    node = min(nodes, key=sp.default_sort_key)
    if len(nodes) > 1 or not _is_term(node, endless[0], domain):
        return ""
    claimed = next(s for s in sides if s is not endless[0]) - endless[0].xreplace({node: sp.S.Zero})
    parts = _list_parts(node, claimed, domain) if isinstance(node, sp.Integral) else [domain]
    told = [_RULES[type(node)](node, part) for part in parts]
    return f"{_NAMES[type(node)]} does not converge: {told[0]}" if told and all(told) else ""


def _list_parts(integral: sp.Integral, claimed: sp.Expr, domain: Domain) -> list[Domain]:
    """List the parts of the domain where one limit is above the other, and where it is below.

    Between equal limits an integral is zero: unless another value is claimed there, the domain
    stays whole.
    """
    low, high = integral.limits[0][1:] if len(integral.limits[0]) == 3 else (sp.S.Zero, sp.oo)
    length = high - low
    letters = [s for s in sorted(length.free_symbols, key=str) if sp.diff(length, s).is_number]
    if not letters or is_nonzero(length, domain):
        return [domain]
    there = claimed.subs(letters[0], sp.cancel(letters[0] - length / sp.diff(length, letters[0])))
    if not (there.has(sp.zoo, sp.nan, sp.oo) or is_nonzero(there, domain)):
        return [domain]
    parts = (narrow(domain, relation) for relation in (length > 0, length < 0))
    return [part for part in parts if part is not None]


def lack_values_alike(sides: Sequence[sp.Expr], domain: Domain) -> bool:
    """Return whether at each point tried both sides have values or both are shown to have none."""
    if any(has_parts(side, sp.Sum, sp.Product, sp.Limit) for side in sides):
        return False
    # On the edge of a condition an integral may have its limit as its value.
    needs = [Slack(need.value, False) for side in sides for need in list_unshown(side, domain)]
    failing = (complete(sides, at, domain) for at in list_failing(needs, domain))
    points = chain(points_for((*sides,), domain, FEW), chain.from_iterable(failing))
    return all(_are_alike(sides, point) for point in points)


def _are_alike(sides: Sequence[sp.Expr], point: Point) -> bool:
    """Return whether at one point both sides have values, or both are shown to have none."""
    lack = [_has_none(substitute(s, point)) for s in sides]
    has_values = [not lacks and has_value(s, point) for s, lacks in zip(sides, lack, strict=True)]
    pairs = zip(sides, lack, strict=True)
    one_lacks = (lacks or not has_parts(side, sp.Integral) for side, lacks in pairs)
    return all(has_values) or (not any(has_values) and all(one_lacks))


def _has_none(side: sp.Expr) -> bool:
    """Return whether a number contains an integral that is shown to have no value."""
    nodes = find_parts(side, sp.Integral)
    return any(_lacks_integrand(one) or _describe_integral(one, _ALL) for one in nodes)


def _lacks_integrand(integral: sp.Integral) -> bool:
    """Return whether a root, a logarithm or the like has no real value between the limits."""
    variable, *limits = integral.limits[0]
    if is_iterated(integral) or not all(limit.is_finite for limit in limits):
        return False
    needs = [need.value for part in list_partial(integral.function) for need in list_needs(part)]
    places = [limits[0] + share * (limits[1] - limits[0]) for share in _SHARES]
    numbers = (balls.evaluate(n.subs(variable, place), {}) for n in needs for place in places)
    return any(number.is_finite() and number < 0 for number in numbers)


def _is_term(node: sp.Expr, side: sp.Expr, domain: Domain) -> bool:
    """Return whether a side is a nonzero multiple of a node, plus terms without it."""
    name = sp.Dummy("value")
    factor = sp.diff(side.xreplace({node: name}), name)
    return not factor.has(name) and is_nonzero(factor, domain)


def _describe_integral(integral: sp.Integral, domain: Domain) -> str:
    if is_iterated(integral) or len(integral.limits[0]) < 3:
        return ""
    variable, low, high = integral.limits[0]
    if (low > high) == sp.true or is_positive(low - high, domain):
        integral = sp.Integral(integral.function, (variable, high, low))
    if not is_improper(integral):
        return ""
    if not (low.is_infinite or high.is_infinite or is_nonzero(high - low, domain)):
        return ""
    pieces = cut_at_poles(integral)
    return next(filter(None, (_describe_piece(piece, domain) for piece in pieces)), "")


def _describe_piece(piece: sp.Integral, domain: Domain) -> str:
    """Report at which end an integrand is like 1/x, or an antiderivative diverges or oscillates."""
    variable, *limits = piece.limits[0]
    for place, side in zip(limits, (1, -1), strict=True):
        if find_residue(piece.function, variable, place, side, domain) is not None:
            x = sp.Symbol(variable.name.strip("_"))
            slow = 1 / (x if place.is_infinite else x - place)
            where = f"as {x} tends to {write_value(place)}"
            return f"its integrand is at least a multiple of {slow} {where}"
    for candidate, run in list_antiderivatives(piece, domain):
        values = find_ends(candidate, variable, run, domain)
        for place, end, value in zip(limits, (run.start, run.end), values, strict=True):
            where = f"as {variable.name.strip('_')} tends to {write_value(place)}"
            if value is not None and value.is_infinite:
                return f"an antiderivative tends to {write_value(value)} {where}"
            if end.is_infinite and _swings(candidate, variable, end, domain):
                return f"an antiderivative has no limit {where}"
    return ""


def _describe_sum(total: sp.Sum, domain: Domain) -> str:
    """Report that the moduli of the terms do not tend to zero, or return ""."""
    if (read := read_endless(total)) is None:
        return ""
    term, k, _ = read
    size = sp.Mul(*(_write_size(factor, domain) for factor in sp.Mul.make_args(term)))
    limit = find_limit(size, k, sp.oo, -1, domain)
    comes_to_zero = limit is None or not (limit.is_infinite or is_nonzero(limit, domain))
    return "" if comes_to_zero else "its terms do not tend to zero"


def _write_size(factor: sp.Expr, domain: Domain) -> sp.Expr:
    """Write a power of a negative number as the power of its modulus."""
    base, exponent = factor.as_base_exp()
    return (-base) ** exponent if is_positive(-base, domain) else factor


def _describe_limit(limit: sp.Limit, domain: Domain) -> str:
    body, variable, point, _ = limit.args
    name = variable.name.strip("_")
    is_met = point.is_infinite and not variable.is_integer and name not in _WHOLE
    swings = is_met and _swings(body, variable, point, domain)
    return "it tends to different numbers along different sequences" if swings else ""


def _swings(body: sp.Expr, variable: sp.Symbol, point: sp.Expr, domain: Domain) -> bool:
    """Return whether limits differ along sequences on which an angle is constant up to whole turns.

    The angle is a polynomial, and all sines and cosines are of rational multiples of it.
    """
    body = write_by_sines(body)
    if not is_defined_near(body, variable, point, -1, domain):
        return False
    waves = [node for node in body.atoms(sp.sin, sp.cos) if node.has(variable)]
    if not waves or not all(node.args[0].is_polynomial(variable) for node in waves):
        return False
    angle = waves[0].args[0]
    ratios = {node: sp.cancel(node.args[0] / angle) for node in waves}
    is_met = all(ratio.is_Rational for ratio in ratios.values())
    turns = find_limit(angle, variable, point, -1, domain)
    if not is_met or turns is None or not turns.is_infinite:
        return False
    whole = reduce(sp.ilcm, (ratio.q for ratio in ratios.values()))
    at = ({n: n.func(whole * ratio * a) for n, ratio in ratios.items()} for a in _ANGLES)
    found = [find_limit(substitute(body, one), variable, point, -1, domain) for one in at]
    limits = [one for one in found if one is not None and one.is_extended_real is not False]
    return any(_differ(limits[0], other, domain) for other in limits[1:])


def _differ(one: sp.Expr, other: sp.Expr, domain: Domain) -> bool:
    if one.is_infinite or other.is_infinite:
        return bool(one != other)
    return is_nonzero(one - other, domain)


_RULES: Mapping[type[sp.Expr], Callable[[Any, Domain], str]] = {
    sp.Integral: _describe_integral,
    sp.Sum: _describe_sum,
    sp.Limit: _describe_limit,
    sp.Product: lambda node, domain: "",
}

# Work limit: sets of conditions that are tried.
_MOST_TRIED = 3
_Decide = Callable[[Any, Any, Domain], Answer]


def find_condition(sides: tuple[Any, Any], domain: Domain, decide: _Decide) -> Answer | None:
    """Answer under a condition for which the sides are proved equal, or refuted; else None."""
    for needs in _list_tried(sides, domain):
        # A part of the domain that has no points decides nothing.
        with suppress(RecordError, NotImplementedError):
            part = narrow_to(domain, needs)
            answer = decide(*sides, part) if part is not None else None
            if answer is not None and (found := _report(answer, needs)):
                return found
    return None


def _report(answer: Answer, needs: Sequence[Slack]) -> Answer | None:
    if answer.verdict is Verdict.REFUTED and answer.rung.endswith(BALLS):
        return answer
    if answer.verdict is not Verdict.PROVED:
        return None
    where = " and ".join(map(_write, needs))
    reason = f"both sides agree where {where}, which is not stated"
    return replace(answer, verdict=Verdict.UNDECIDED, reason=reason)


def _write(need: Slack) -> str:
    """Write a condition as a bound on a single letter if it is linear in one."""
    number, strict = need
    letters = sorted(number.free_symbols, key=str)
    slope = sp.diff(number, letters[0])
    if not slope.is_number or len(sp.Add.make_args(number)) > 2:
        return describe(need)
    bound = sp.cancel(letters[0] - number / slope)
    sign = ">" if slope > 0 else "<"
    return f"{letters[0]} {sign}{'' if strict else '='} {bound}"


def _list_tried(sides: Sequence[Any], domain: Domain) -> list[list[Slack]]:
    nodes = {node for side in sides for node in find_parts(domain.resolve(side), *_RULES)}
    nodes = {node for node in nodes if node.free_symbols}
    ordered = sorted(nodes, key=sp.default_sort_key)
    letters = {s for node in ordered for s in node.free_symbols if not s.is_integer}
    positive = [Slack(s, True) for s in sorted(letters, key=str)]
    proposed = [_join(ordered, _list_by_form), _join(ordered, list_of_table), positive]
    open_ones = (list(dict.fromkeys(n for n in p if not is_shown(n, domain))) for p in proposed)
    return list({frozenset(needs): needs for needs in open_ones if needs}.values())[:_MOST_TRIED]


def _join(nodes: Sequence[Any], find: Callable[[Any], Iterator[Slack]]) -> list[Slack]:
    return [need for node in nodes for need in find(node)]


def _list_by_form(node: Any) -> Iterator[Slack]:
    """Yield conditions of convergence, read from the exponents of powers and exponentials."""
    if isinstance(node, sp.Sum):
        _, low, high = node.limits[0]
        if low.free_symbols and high.is_finite is not False:
            yield Slack(high - low, False)
        if (read := read_endless(node)) is not None:
            yield from _list_at_infinity(*read[:2], sp.oo)
    elif isinstance(node, sp.Limit):
        yield from _list_at_infinity(*node.args[:3])
    elif len(node.limits) == 1:
        variable, *ends = node.limits[0]
        powers = [p.exp for p in node.function.atoms(sp.Pow) if p.base == variable]
        for end in ends:
            yield from _list_at_infinity(node.function, variable, end)
            signs = {sp.S.Zero: 1, sp.oo: -1}
            yield from (Slack(signs[end] * (1 + p), True) for p in powers if end in signs)


def _list_at_infinity(function: sp.Expr, x: sp.Symbol, end: sp.Expr) -> Iterator[Slack]:
    if not end.is_infinite:
        return
    for node in sorted(function.atoms(sp.exp), key=sp.default_sort_key):
        if node.has(x) and node.args[0].is_polynomial(x):
            exponent = sp.Poly(node.args[0].subs(x, sp.sign(end) * x), x)
            yield Slack(-exponent.LC(), True)
    for power in sorted(function.atoms(sp.Pow), key=sp.default_sort_key):
        if power.exp.has(x) and power.exp.is_polynomial(x) and not power.base.has(x):
            yield from (Slack(1 - power.base, True), Slack(1 + power.base, True))
