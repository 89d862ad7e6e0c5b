"""Rung: an inequality by the slope of the difference of its sides.

f >= 0 holds on an interval if f >= 0 at a place, or as a limit at an end, from which f grows to
both sides; or at both ends, f being concave; or where the slope is zero, f being convex. The sign
of a slope is shown like that of any other number, or again by its own slope; f is shown to be
continuous, and its slope exists inside.

A non-decreasing function grows strictly if it is analytic and its slope vanishes on no interval:
for an analytic slope, one place at which it is nonzero shows that.

At an end that does not belong to the interval, or at infinity, the limit replaces the value.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import sympy as sp

from mechproof.proof.algebra import decide_equal
from mechproof.proof.continuity import find_break
from mechproof.proof.definedness import has_values
from mechproof.proof.growth import find_limit
from mechproof.proof.half_angles import is_negative_somewhere, is_shown_there
from mechproof.proof.powers import decide_by_logarithms
from mechproof.proof.sign_forms import compare_logarithms, free_logarithms, list_forms
from mechproof.record import Slack
from mechproof.record.parts import has_parts
from mechproof.record.relations import KINKED
from mechproof.statement_domains.domain import Domain
from mechproof.statement_domains.set_values import place as choose_place

RUNG = "monotonicity"
_TRANSCENDENTAL = (
    *(sp.exp, sp.log, sp.sin, sp.cos, sp.tan, sp.asin, sp.acos, sp.atan, sp.erf),
    *(sp.sinh, sp.cosh, sp.tanh, sp.asinh, sp.acosh, sp.atanh),
)
# Work limits: nested derivatives, operations of a number and of its derivative, variables tried.
_MOST_SLOPES = 5
_LARGEST, _LARGEST_SLOPE = 60, 150
_MOST_VARIABLES = 2


def holds_by_slope(slack: Slack, domain: Domain) -> bool:
    """Return whether its slope shows a number positive, or non-negative if not strict."""
    value = domain.resolve(slack.value)
    if has_parts(value, *KINKED, sp.Sum, sp.Product, sp.Integral):
        return False
    return any(
        _holds(number, x, slack.strict, part, _MOST_SLOPES)
        for number, part in list_forms(value, domain)
        for x in _list_variables(number, part)
    )


def _list_variables(value: sp.Expr, domain: Domain) -> list[sp.Symbol]:
    """List the variables of functions that run through intervals and appear in no relation."""
    powers = {p for p in value.atoms(sp.Pow) if not p.exp.is_Rational or p.exp.q > 2}
    nodes = {*value.atoms(*_TRANSCENDENTAL), *powers}
    # A variable in a relation does not run through its set independently of the others.
    coupled = {s for relation in domain.where for s in relation.free_symbols}
    symbols = {s for node in nodes for s in node.free_symbols} - coupled
    runs = sorted((s for s in symbols if isinstance(domain.set_of(s), sp.Interval)), key=str)
    return runs[:_MOST_VARIABLES]


def _holds(f: sp.Expr, x: sp.Symbol, strict: bool, domain: Domain, slopes: int) -> bool:
    if _is_shown(f, strict, domain):
        return True
    if not slopes or not f.has(x) or f.count_ops() > _LARGEST or has_parts(f, *KINKED):
        return False
    if is_negative_somewhere(f, domain):
        return False
    if (written := compare_logarithms(f, domain)) is not None:
        forms = dict.fromkeys([free_logarithms(written, domain), written])
        return any(_holds(form, x, strict, domain, slopes) for form in forms)
    inside, slope = domain.with_set(x, domain.set_of(x).interior), sp.diff(f, x)
    if slope.count_ops() > _LARGEST_SLOPE:
        return False
    slope = free_logarithms(slope, inside)
    ways = _list_ways(f, x, slope, strict, domain)
    if any(all(_grows(f, d * slope, x, s, part, slopes) for d, s, part in way) for way in ways):
        return True
    bend = free_logarithms(sp.diff(f, x, 2), inside)
    return _is_concave(f, bend, x, strict, domain, slopes) or _is_convex(
        f, slope, bend, x, strict, domain, slopes
    )


def _grows(
    f: sp.Expr, slope: sp.Expr, x: sp.Symbol, strict: bool, domain: Domain, slopes: int
) -> bool:
    """Return whether a slope of f is shown non-negative, and zero on no interval if `strict`."""
    is_strict = strict and not _is_zero_nowhere_long(f, slope, x, domain)
    return _holds(slope, x, is_strict, domain, slopes - 1)


def _is_zero_nowhere_long(f: sp.Expr, slope: sp.Expr, x: sp.Symbol, domain: Domain) -> bool:
    """Return whether the slope of an analytic f is shown to vanish on no interval of x.

    It is if it is positive at one place for all parameters.
    """
    middle = choose_place(domain.set_of(x), sp.S.Half, 1)
    # Zeros of an analytic function that is not zero throughout lie apart.
    is_positive_there = _is_shown(slope.subs(x, middle), True, _without(domain, x))
    return is_positive_there and is_analytic_inside(f, x, domain)


def _is_shown(value: sp.Expr, strict: bool, domain: Domain) -> bool:
    if value == sp.oo:
        return True
    value = sp.factor_terms(value)
    if is_shown_there(Slack(value, strict), domain):
        return True
    return not strict and _is_zero(value, domain)


_Way = list[tuple[sp.Integer, bool, Domain]]


def _list_ways(
    f: sp.Expr, x: sp.Symbol, slope: sp.Expr, strict: bool, domain: Domain
) -> Iterator[_Way]:
    """Yield the directed growth needed, part by part, for f to be at least its value at a place."""
    values = domain.set_of(x)
    for place, there in list_values(f, x, slope, domain):
        is_left_out = values.contains(place) != sp.true
        is_above = _is_shown(there, strict, _without(domain, x))
        if not is_above and not (
            strict and is_left_out and _is_shown(there, False, _without(domain, x))
        ):
            continue
        sides = ((sp.Integer(-1), values.start, place), (sp.Integer(1), place, values.end))
        yield [
            (direction, not is_above, domain.with_set(x, sp.Interval.open(low, high)))
            for direction, low, high in sides
            if (low < high) == sp.true
        ]


def _is_concave(
    f: sp.Expr, bend: sp.Expr, x: sp.Symbol, strict: bool, domain: Domain, slopes: int
) -> bool:
    """Return whether f is shown to be concave between two ends at which it is non-negative.

    If such an f is zero in between, it is zero throughout. A second derivative would miss a kink.
    """
    values = domain.set_of(x)
    if not (values.start.is_finite and values.end.is_finite):
        return False
    if find_break(f, x, domain.with_set(x, sp.Interval(values.start, values.end))) is not None:
        return False
    ends = ((values.start, values.left_open), (values.end, values.right_open))
    needs = [(f.subs(x, end), strict and not is_open) for end, is_open in ends]
    if not all(_is_shown(*need, _without(domain, x)) for need in needs):
        return False
    inside = domain.with_set(x, values.interior)
    if not is_analytic_inside(f, x, inside):
        return False
    return _grows(f, -bend, x, strict, inside, min(slopes, 2))


def _is_convex(
    f: sp.Expr,
    slope: sp.Expr,
    bend: sp.Expr,
    x: sp.Symbol,
    strict: bool,
    domain: Domain,
    slopes: int,
) -> bool:
    """Return whether f is shown to be convex, and non-negative where its slope is zero.

    That place may depend on parameters.
    """
    inside = domain.with_set(x, domain.set_of(x).interior)
    values, outer = domain.set_of(x), _without(domain, x)
    for place in list_zeros(slope, x):
        gaps = [place - values.start] if values.start.is_finite else []
        gaps += [values.end - place] if values.end.is_finite else []
        if (
            has_values(place, outer)
            and all(_is_shown(gap, True, outer) for gap in gaps)
            and _is_shown(f.subs(x, place), strict, outer)
            and _is_zero(sp.diff(f, x).subs(x, place), outer)
            and is_analytic_inside(f, x, inside)
            and find_break(f, x, domain) is None
        ):
            return _holds(bend, x, False, inside, min(slopes - 1, 1))
    return False


def _is_zero(value: sp.Expr, domain: Domain) -> bool:
    return any(rung(value, sp.S.Zero, domain) for rung in (decide_equal, decide_by_logarithms))


def _without(domain: Domain, x: sp.Symbol) -> Domain:
    return replace(domain, within={s: v for s, v in domain.within.items() if s != x})


# Work limit: numerator and denominator of an exponent.
_LARGEST_EXPONENT = 50
_PLACES = (sp.S.Zero, sp.S.One, -sp.S.One)


def list_values(
    f: sp.Expr, x: sp.Symbol, slope: sp.Expr, domain: Domain
) -> Iterator[tuple[sp.Expr, sp.Expr]]:
    """Yield places with f's value there, if it is continuous up to them, or else with its limit."""
    values = domain.set_of(x)
    inner = dict.fromkeys([*_PLACES, *list_zeros(slope, x)])
    inside = [p for p in inner if p.is_number and values.interior.contains(p) == sp.true]
    for place in dict.fromkeys([values.start, values.end, *inside]):
        if place.is_finite:
            closed = sp.Union(values, sp.FiniteSet(place))
            if find_break(f, x, domain.with_set(x, closed)) is None:
                yield place, f.subs(x, place)
                continue
        if values.contains(place) == sp.true or find_break(f, x, domain) is not None:
            continue
        limit = find_limit(f, x, place, 1 if place == values.start else -1, domain)
        if limit is not None and limit != -sp.oo:
            yield place, limit


def list_zeros(slope: sp.Expr, x: sp.Symbol) -> Iterator[sp.Expr]:
    """Propose zeros of two-term factors whose terms have a power or an exponential as quotient."""
    for factor in sp.Mul.make_args(sp.factor_terms(slope)):
        terms = sp.Add.make_args(sp.expand(factor))
        if len(terms) != 2 or not factor.has(x):
            continue
        letters = {s: sp.Dummy(s.name, positive=True) for s in factor.free_symbols}
        one, other = (term.xreplace(letters) for term in terms)
        logarithm = sp.expand(sp.expand_log(sp.log(-one / other), force=True))
        for unit in (sp.log(letters[x]), letters[x]):
            rate = logarithm.coeff(unit)
            rest = sp.expand(logarithm - rate * unit)
            if rate != 0 and not rate.has(letters[x]) and not rest.has(letters[x]):
                place = sp.expand(sp.cancel(-rest / rate), log=False)
                place = place if unit == letters[x] else _exponentiate(place)
                if all(_is_small(power.exp) for power in place.atoms(sp.Pow)):
                    yield place.xreplace({letter: s for s, letter in letters.items()})


def _is_small(exponent: sp.Expr) -> bool:
    """Return whether an exponent is not rational, or small enough for SymPy to write out fast."""
    return not exponent.is_Rational or max(abs(exponent.p), exponent.q) <= _LARGEST_EXPONENT


def _exponentiate(logarithm: sp.Expr) -> sp.Expr:
    """Write exp(k*ln b + m*ln c + d) as b**k*c**m*exp(d)."""
    nodes = sorted(logarithm.atoms(sp.log), key=sp.default_sort_key)
    powers = {node: sp.factor(logarithm.coeff(node)) for node in nodes}
    rest = sp.expand(logarithm - sum(node * power for node, power in powers.items()))
    return sp.Mul(sp.exp(rest), *(node.args[0] ** power for node, power in powers.items()))


def is_analytic_inside(f: sp.Expr, x: sp.Symbol, domain: Domain) -> bool:
    """Return whether a function is shown to be analytic in a variable on an open interval."""
    if has_parts(f, *KINKED) or find_break(f, x, domain) is not None:
        return False
    numbers = (number for node in sp.preorder_traversal(f) for number in _list_inner(node, x))
    return all(is_shown_there(Slack(number, True), domain) for number in numbers)


def _list_inner(node: sp.Basic, x: sp.Symbol) -> Iterator[sp.Expr]:
    """Yield what must be positive for a continuous function of an analytic one to be analytic."""
    if not node.has(x):
        return
    if isinstance(node, sp.Pow) and not node.exp.is_integer:
        yield node.base
    elif isinstance(node, sp.asin | sp.acos):
        yield 1 - node.args[0] ** 2
    elif isinstance(node, sp.acosh):
        yield node.args[0] - 1
