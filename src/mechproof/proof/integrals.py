"""Rung: a definite integral has the value that an antiderivative gives.

SymPy only proposes the antiderivative. It counts if its derivative is proved to be the integrand
inside the limits and both are continuous up to them: the fundamental theorem of calculus. Trusting
no finder but checking its findings follows Harrison and Théry (1998), who did so with HOL and
Maple. An improper integral has the value of the limits at its ends, if these are shown, and is cut
at numbers where the integrand is divided by zero; its value may be infinite.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import pairwise
from typing import Any

import sympy as sp

from mechproof.arithmetic import balls
from mechproof.proof.algebra import decide_equal
from mechproof.proof.continuity import find_break
from mechproof.proof.coordinates import parametrise, write_by_sines
from mechproof.proof.counts import has_steps
from mechproof.proof.growth import find_limit
from mechproof.proof.half_angles import is_shown_there
from mechproof.proof.integral_kinds import (
    changes_sign_at_pole,
    cut_at_seams,
    has_pieces,
    integrate_polynomials,
    is_improper,
    is_iterated,
    list_poles,
    may_reach_zero,
    unwind,
)
from mechproof.proof.powers import decide_by_logarithms, write_roots
from mechproof.proof.proposed_antiderivatives import propose
from mechproof.proof.refutation import are_seen_to_differ, points_for
from mechproof.proof.signs import is_nonzero
from mechproof.proof.smooth_limits import find_smooth
from mechproof.proof.verdict import Evidence
from mechproof.proof.witness_text import describe
from mechproof.record import Slack
from mechproof.record.parts import find_bound, find_parts
from mechproof.record.substitution import substitute
from mechproof.statement_domains.domain import Domain

RUNG = "antiderivative"
# Work limit: operations of an integrand that is tried.
_LARGEST = 60
# Points at which improper integrals with letters are evaluated, and the bits of their values.
_FEWEST, _PRECISION = 2, 128
# An integral to infinity converges if its integrand falls faster than 1/x to this power > 1.
_INTEGRATED = sp.Rational(9, 8)
_NO_NUMBERS = (sp.nan, sp.zoo, sp.oo, -sp.oo, sp.AccumBounds)


def decide_by_antiderivative(
    left: sp.Expr, right: sp.Expr, domain: Domain, prove: Callable[..., str | None]
) -> str | None:
    """Return the rungs that prove left = right with the values of integrals, or None."""
    sides = (domain.resolve(left), domain.resolve(right))
    integrals = list_free(*sides)
    if not integrals or are_seen_to_differ(sides, domain):
        return None
    values = {integral: _find_finite(integral, domain) for integral in integrals}
    others = [node for node, value in values.items() if value is None and len(values) > 1]
    turned = {integral: _turn(integral) for integral in others}
    known = {integral: value for integral, value in values.items() if value is not None}
    known |= {integral: other for integral, other in turned.items() if other != integral}
    if not known:
        return None
    rest = prove(*(side.xreplace(known) for side in sides), domain)
    return f"{RUNG}, {rest}" if rest else None


def _turn(integral: sp.Integral) -> sp.Integral:
    """Return an integral or its mirror image, whichever SymPy sorts first."""
    variable, *ends = integral.limits[0]
    if len(integral.limits) > 1 or len(ends) != 2 or any(end.is_infinite for end in ends):
        return integral
    other = integral.function.subs(variable, sp.Add(*ends) - variable)
    return min((integral, sp.Integral(other, *integral.limits)), key=sp.default_sort_key)


def find_counterexample(
    sides: Sequence[sp.Expr],
    domain: Domain,
    settle: Callable[[Sequence[sp.Expr], Domain], tuple[tuple[sp.Expr, ...], list[str]]],
) -> Evidence | None:
    """Return a point at which sides with improper integrals are evaluated and differ, or None."""
    if not any(is_improper(node) and node.free_symbols for node in list_free(*sides)):
        return None
    for point in points_for((*sides,), domain, _FEWEST):
        values, _ = settle([substitute(side, point) for side in sides], domain)
        if any(value.has(sp.Integral) or value.free_symbols for value in values):
            return None
        one, other = (balls.evaluate(value, {}, _PRECISION) for value in values)
        if one.is_finite() and other.is_finite() and not one.overlaps(other):
            return describe("the two sides", (*sides,), (one, other), point, domain)
    return None


def find_improper(integral: sp.Integral, domain: Domain) -> sp.Expr | None:
    """Return the value of an integral that balls do not enclose, as far as it is shown."""
    is_met = is_improper(integral) or is_iterated(integral)
    is_met = is_met or has_pieces(integral.function, integral.variables[0])
    return find_value(integral, domain) if is_met or may_reach_zero(integral, domain) else None


def list_free(*sides: Any) -> list[sp.Integral]:
    """List the integrals none of whose free symbols is bound anywhere in the sides."""
    bound = {symbol for side in sides for symbol in find_bound(side)}
    found = {node for side in sides for node in find_parts(side, sp.Integral)}
    return sorted((node for node in found if not node.free_symbols & bound), key=str)


def _find_finite(integral: sp.Integral, domain: Domain) -> sp.Expr | None:
    value = find_value(integral, domain)
    return None if value is None or value.is_infinite else value


def find_value(integral: sp.Integral, domain: Domain) -> sp.Expr | None:
    """Return the value of an integral, also an infinite one, as far as it is shown."""
    integrand, *inner, (variable, *limits) = integral.args
    if len(limits) != 2 or integrand.count_ops() > _LARGEST or integrand.has(sp.Sum):
        return None
    lower, upper = limits
    if lower == upper:
        return None
    if (lower > upper) == sp.true:
        turned = find_value(sp.Integral(integrand, *inner, (variable, upper, lower)), domain)
        return None if turned is None else -turned
    if is_iterated(integral):
        return _find_iterated(integral, domain)
    if lower == -upper and _is_odd(integrand, variable, upper, domain):
        return sp.S.Zero
    if (unwound := unwind(integral)) != integral:
        return find_value(unwound, domain)
    written = write_roots(integrand, {variable}, domain)
    if has_pieces(written, variable):
        found = _find_by_pieces(sp.Integral(written, *integral.limits), domain)
        if found is not None or written == integrand:
            return found
    elif written != integrand:
        return find_value(sp.Integral(written, *integral.limits), domain)
    pieces = cut_at_poles(integral)
    if any(changes_sign_at_pole(integral, piece.limits[0][2], domain) for piece in pieces[:-1]):
        return None
    found = _add_up([_find_by_antiderivative(piece, domain) for piece in pieces])
    return _find_from_both_ends(integral, domain) if found is None else found


def cut_at_poles(integral: sp.Integral) -> list[sp.Integral]:
    """Cut an integral at the numbers at which its integrand has no value."""
    integrand, (variable, lower, upper) = integral.args
    poles = list_poles(integrand, variable, lower, upper)
    if poles or integrand.has(sp.cot, sp.sec, sp.csc):
        integrand = write_by_sines(integrand)
    return [sp.Integral(integrand, (variable, *ends)) for ends in pairwise([lower, *poles, upper])]


def _add_up(parts: Sequence[sp.Expr | None]) -> sp.Expr | None:
    """Return a sum, possibly infinite; None if it has no value or a part is not known."""
    known = [part for part in parts if part is not None]
    endless = {part for part in known if part.is_infinite}
    if len(known) < len(parts) or len(endless) > 1:
        return None
    return endless.pop() if endless else sp.Add(*known)


def _find_from_both_ends(integral: sp.Integral, domain: Domain) -> sp.Expr | None:
    """Return an integral's value, found from the mean of integrand and mirror image; or None."""
    variable, lower, upper = integral.limits[0]
    if lower.is_infinite or upper.is_infinite:
        return None
    if (value := _find_by_constant_mean(integral, domain)) is not None:
        return value
    place, run = parametrise(variable, lower, upper)
    running = integral.function.subs(variable, place)
    other = integral.function.subs(variable, lower + upper - variable)
    mean = sp.cancel(sp.together(integral.function + other)) / 2
    sizes = [_measure(f, variable) for f in (mean.as_independent(variable)[1], integral.function)]
    if sizes[0] >= sizes[1]:
        return None
    if find_break(running, variable, domain.with_set(variable, run)) is not None:
        return None
    return _find_by_antiderivative(sp.Integral(mean, integral.limits[0]), domain)


def _measure(function: sp.Expr, variable: sp.Symbol) -> int:
    """Count the operations in a function, and how often its variable occurs."""
    return int(function.count_ops()) + [*sp.preorder_traversal(function)].count(variable)


def _find_by_constant_mean(integral: sp.Integral, domain: Domain) -> sp.Expr | None:
    """Return the value if the integrand and its mirror image have a constant sum, else None.

    As neither is negative, both lie between zero and that sum, whatever their parts do at the ends.
    """
    variable, lower, upper = integral.limits[0]
    place, run = parametrise(variable, lower, upper)
    inside = domain.with_set(variable, run.interior)
    running, other = (integral.function.subs(variable, x) for x in (place, lower + upper - place))
    middle = integral.function.subs(variable, (lower + upper) / 2)
    sides = (running + other, 2 * middle)
    if middle.has(*_NO_NUMBERS) or are_seen_to_differ(sides, inside):
        return None
    is_met = is_shown_there(Slack(running, False), inside)
    if not is_met or find_break(running, variable, inside) is not None:
        return None
    if is_shown_there(Slack(sp.tan(variable), True), inside):
        t = sp.Dummy("t", positive=True)
        sides = tuple(x.xreplace({sp.tan(variable): t, sp.cot(variable): 1 / t}) for x in sides)
        inside = inside.with_set(t, sp.Interval.open(0, sp.oo))
    is_constant = decide_equal(*sides, inside) or decide_by_logarithms(*sides, inside)
    return (upper - lower) * middle if is_constant else None


def _find_iterated(integral: sp.Integral, domain: Domain) -> sp.Expr | None:
    """Return the value of an iterated integral whose inner integrals are evaluated first."""
    *inner, (variable, *ends) = integral.limits
    if len(ends) != 2 or _jumps(integral, domain):
        return None
    place, run = parametrise(variable, *ends)
    integrand = sp.Integral(integral.function, *inner) if inner else integral.function
    integrand = substitute(integrand, {variable: place}) * sp.diff(place, variable)
    inside = domain.with_set(variable, run.interior)
    values = {node: _find_finite(node, inside) for node in list_free(integrand)}
    if not values or None in values.values():
        return None
    limits = (variable, run.start, run.end)
    return find_value(sp.Integral(integrand.xreplace(values), limits), domain)


def _jumps(integral: sp.Integral, domain: Domain) -> bool:
    """Return whether the integrand is not shown to be continuous in the outermost variable."""
    if any(len(limit) != 3 for limit in integral.limits):
        return True
    running, inside = integral.function, domain
    for variable, *ends in integral.limits:
        place, run = parametrise(variable, *ends)
        running, inside = running.subs(variable, place), inside.with_set(variable, run.interior)
    return find_break(running, integral.limits[-1][0], inside) is not None


def _is_odd(integrand: sp.Expr, variable: sp.Symbol, end: sp.Expr, domain: Domain) -> bool:
    """Return whether an integrand is odd, and continuous from one end to the opposite one.

    Over the whole line it must also fall faster than the power 9/8 of 1/x, which is integrable.
    """
    is_endless = end.is_infinite is True
    size, upper = (sp.S.One, sp.oo) if is_endless else (end, sp.S.One)
    sides = [integrand.subs(variable, size * variable), integrand.subs(variable, -size * variable)]
    half = domain.with_set(variable, sp.Interval(0, upper))
    if decide_equal(sides[1], -sides[0], half) is None:
        return False
    slow = integrand * variable**_INTEGRATED
    if is_endless and find_limit(slow, variable, sp.oo, -1, domain) != 0:
        return False
    return all(find_break(side, variable, half) is None for side in sides)


def _find_by_antiderivative(integral: sp.Integral, domain: Domain) -> sp.Expr | None:
    """Return the difference of an antiderivative's values, or of its limits, at the ends."""
    for candidate, run in list_antiderivatives(integral, domain):
        low, high = find_ends(candidate, integral.variables[0], run, domain)
        value = None if low is None or high is None else _add_up([high, -low])
        if value is not None:
            return value
    return None


def list_antiderivatives(
    integral: sp.Integral, domain: Domain
) -> Iterator[tuple[sp.Expr, sp.Interval]]:
    """Yield antiderivatives shown to be continuous between the limits, with the variable's range.

    The variable is written by one that runs between numbers.
    """
    integrand, (variable, lower, upper) = integral.args
    place, run = parametrise(variable, lower, upper)
    inside = domain.with_set(variable, run.interior)
    slope = sp.diff(place, variable)
    running = integrand.subs(variable, place)
    if find_break(running, variable, inside) is not None:
        return
    for candidate in propose(integrand, variable, domain):
        moved = candidate.subs(variable, place)
        if _may_divide_by_zero(moved, inside):
            # All other candidates divide by it as well.
            return
        if find_break(moved, variable, inside) is not None:
            continue
        sides = (sp.diff(moved, variable), running * slope, inside)
        if decide_equal(*sides) is not None or decide_by_logarithms(*sides) is not None:
            yield moved, run


def _may_divide_by_zero(candidate: sp.Expr, domain: Domain) -> bool:
    """Return whether a candidate divides by a discrete number that may be zero, as sin(n*x)/n.

    A divisor that varies continuously does no harm: values next to its zero settle the one there.
    """
    below = (
        power.base for power in candidate.atoms(sp.Pow) if power.exp.could_extract_minus_sign()
    )
    return any(has_steps(base, domain) and not is_nonzero(base, domain) for base in below)


def find_ends(
    candidate: sp.Expr, variable: sp.Symbol, run: sp.Interval, domain: Domain
) -> list[sp.Expr | None]:
    """Return the limits of an antiderivative at both ends, None for each that is not shown."""
    return [_find_end(candidate, variable, end, run, domain) for end in (run.start, run.end)]


def _find_end(
    candidate: sp.Expr, variable: sp.Symbol, end: sp.Expr, run: sp.Interval, domain: Domain
) -> sp.Expr | None:
    """Return the limit of an antiderivative at an end, or None if it is not shown."""
    if end.is_finite:
        near = sp.Interval(run.start, run.end, end != run.start, end != run.end)
        value = candidate.subs(variable, end)
        if find_break(candidate, variable, domain.with_set(variable, near)) is None:
            return value
        if not value.has(*_NO_NUMBERS) and not any(p.base == 0 for p in value.atoms(sp.Pow)):
            # The value is finite, so a limit would not help: too little is known of the other
            # letters.
            return None
    limit = find_limit(candidate, variable, end, 1 if end == run.start else -1, domain)
    return find_smooth(candidate, variable, end, domain) if limit is None else limit


def _find_by_pieces(integral: sp.Integral, domain: Domain) -> sp.Expr | None:
    """Return the value of an integrand given by pieces, which are integrated one by one."""
    parts = [_find_finite(part, domain) for part in cut_at_seams(integral, domain)]
    if not parts:
        return integrate_polynomials(integral)
    return None if None in parts else sp.Add(*parts)
