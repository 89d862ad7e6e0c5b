"""Rung: the sign of an expression on a domain, proved by a change to positive coordinates.

Every interval becomes a half-line (e in [0, 1) is v/(1 + v) with v >= 0; R2 < R1 is
R1 = R2 + d with d > 0) and angles become half-angle tangents, which leaves the sign of a quotient
of polynomials (`polynomial_signs`). Sound, not complete: `None` means "not shown".

Writing a larger number as a smaller one plus a gap is the successive difference substitution of
Yang (2005), who repeats it for every order of the symbols; here the domain states the order. That a
polynomial without a minus sign is positive on a half-line is Pólya's certificate (1928), without
his multiplier: a polynomial that shows no sign at once is not multiplied until it does.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import lru_cache
from math import prod

import sympy as sp
from sympy.concrete.expr_with_limits import ExprWithLimits

from mechproof.arithmetic.polynomials import cancel
from mechproof.proof.coordinates import (
    Coordinates,
    list_by_values,
    name_roots,
    replace_by_half_line,
    write_by_cosines,
)
from mechproof.proof.polynomial_signs import StrictSign, find_sign_in, sign_of_number
from mechproof.record.parts import find_free, find_parts, find_roots, has_parts
from mechproof.record.relations import Slack, find_slack
from mechproof.statement_domains.domain import Domain

# Work limit: larger powers and multiples of angles are not multiplied out.
MOST_MULTIPLIED = 100
# Work limit: most operations of an expression that is factored.
_MOST_FACTORED = 60


def is_workable(expression: sp.Basic) -> bool:
    """Return whether no whole power exceeds the limit."""
    powers = (p.exp for p in find_parts(expression, sp.Pow) if p.exp.is_Integer)
    return all(abs(power) <= MOST_MULTIPLIED for power in powers)


# The rows of a paper share radicals and divisors, whose signs take most of the time of a proof.
@lru_cache(maxsize=4096)
def find_sign(expression: sp.Expr, domain: Domain) -> StrictSign | None:
    """Return the proved sign of the expression on the domain, or None if it is not shown."""
    expression = domain.resolve(expression)
    if isinstance(expression, sp.log) and is_positive(expression.args[0], domain):
        return find_sign(expression.args[0] - 1, domain)
    try:
        sign = _find_sign_with_ends(expression, domain)
    except (NotImplementedError, sp.PolynomialError):
        sign = None
    if sign is not None and sign.strict:
        return sign
    return (
        _find_sign_with_roots(expression, domain)
        or _find_sign_in_box(expression, domain)
        or _find_sign_by_relations(expression, domain)
        or sign
    )


def _find_sign_with_roots(expression: sp.Expr, domain: Domain) -> StrictSign | None:
    """Return the sign with square roots of positive numbers replaced by positive variables."""
    roots = sorted({root.base for root in find_roots(expression)}, key=sp.default_sort_key)
    known = [base for base in roots if base.free_symbols and is_positive(base, domain)]
    if not known:
        return None
    named, numbers = name_roots(expression, known, lambda factor: is_positive(factor, domain))
    sets = dict.fromkeys(numbers, sp.Interval.open(0, sp.oo))
    return find_sign(named, replace(domain, within={**domain.within, **sets}))


def _find_sign_in_box(expression: sp.Expr, domain: Domain) -> StrictSign | None:
    """Return the sign with cosines as numbers in [-1, 1], if no sines remain."""
    if not expression.has(sp.sin, sp.cos) or expression.has(ExprWithLimits):
        return None
    if not is_workable(expression):
        return None
    if _is_strict(sign := _find_sign_at_ends(expression, domain)):
        return sign
    try:
        written, cosines = write_by_cosines(expression)
    except (NotImplementedError, sp.PolynomialError):
        return sign
    if not written.free_symbols <= expression.free_symbols | cosines.keys():
        return sign
    above, below = sp.fraction(written)
    within = dict(domain.within)
    for cosine, angle in cosines.items():
        least = 0 if _is_acute(angle, domain) else -1
        if all(part.subs(cosine, -cosine).expand() == part.expand() for part in (above, below)):
            square = sp.Dummy("q", nonnegative=True)
            above, below = (p.expand().subs(cosine, sp.sqrt(square)) for p in (above, below))
            within[square] = sp.Interval(0, 1, left_open=least == 0)
        else:
            within[cosine] = sp.Interval(least, 1, left_open=least == 0)
    return find_sign(above / below, replace(domain, within=within)) or sign


def _find_sign_at_ends(expression: sp.Expr, domain: Domain) -> StrictSign | None:
    """Return the sign of an expression linear in its one sine or cosine, from its range's ends."""
    wave, *others = expression.atoms(sp.sin, sp.cos)
    named = expression.xreplace({wave: (size := sp.Dummy("c", real=True))})
    others += [s for s in wave.free_symbols if s in named.free_symbols]
    if others or not (named.is_polynomial(size) and sp.degree(named, size) == 1):
        return None
    least = 0 if _is_nonnegative_wave(wave, domain) else -1
    return _weaker(*(find_sign(named.subs(size, end), domain) for end in (least, 1)))


def _is_nonnegative_wave(wave: sp.Function, domain: Domain) -> bool:
    """Return whether an angle is proved to lie where its sine or cosine is not negative."""
    angle = wave.args[0]
    if angle.atoms(sp.Function):
        return False
    middle = sp.S.Zero if isinstance(wave, sp.cos) else sp.pi / 2
    return all(is_nonnegative(sp.pi / 2 + k * (angle - middle), domain) for k in (1, -1))


def _find_sign_by_relations(expression: sp.Expr, domain: Domain) -> StrictSign | None:
    """Return the sign of a product some of whose factors have signs given by relations."""
    said = [slack for slack in map(find_slack, domain.where) if slack]
    if not (said and expression.count_ops() <= _MOST_FACTORED and is_workable(expression)):
        return None
    said = [Slack(domain.resolve(value), strict) for value, strict in said]
    # Drop the relations: with them, these signs would be asked for again without end.
    free = replace(domain, where=())
    said += [
        value
        for slack in said
        for value, end, _ in list_by_values(slack)
        if end.value.is_infinite or is_shown(end, free)
    ]
    said = [_leave_known_factors(slack, _leave_out(slack, free)) for slack in said]
    said = [slack for slack in said if slack.value.free_symbols <= expression.free_symbols]
    if not (said and _is_quotient(expression)):
        return None
    if whole := _find_stated_sign(expression, said):
        return whole
    met: list[StrictSign] = []

    def find(base: sp.Expr) -> StrictSign | None:
        if one := _find_stated_sign(base, said):
            met.append(one)
        return one or (find_sign(base, domain) if base != expression else None)

    factors = sp.Mul.make_args(factored := sp.factor(expression))
    bases = (base for factor in factors for base in (factor, factor.as_base_exp()[0]))
    # Of three factors, the product of two may be stated although none is alone.
    if len(factors) < 3 and not any(_find_stated_sign(base, said) for base in bases):
        return None
    sign = multiply_signs(factored, find)
    return sign if met else None


def _leave_out(slack: Slack, domain: Domain) -> Domain:
    """Return the domain without the letters that a slack lacks, which are often new each time."""
    letters = find_free(slack.value)
    kept = {s: v for s, v in domain.within.items() if s in letters or not s.is_Symbol}
    return replace(domain, within=kept)


def multiply_signs(
    product: sp.Expr, find: Callable[[sp.Expr], StrictSign | None]
) -> StrictSign | None:
    """Return the sign of a product from those of its factors, or None if one is not shown.

    Factors whose signs are not shown one by one are tried once more as one product.
    """
    sign, unshown = StrictSign(1, True), sp.S.One
    factors = sp.Mul.make_args(product)
    for factor in factors:
        base, power = factor.as_base_exp()
        if not power.is_Rational:
            base, power = factor, sp.S.One
        found = find(base)
        if found is None:
            unshown *= factor
        elif not (found.strict or power > 0):
            return None
        else:
            # A root, too, takes its sign from its radicand alone.
            sign = sign.times(found if power % 2 == 1 else StrictSign(1, found.strict))
    if unshown == 1:
        return sign
    is_less = 1 < len(sp.Mul.make_args(unshown)) < len(factors)
    found = find(unshown) if is_less else None
    return sign.times(found) if found else None


@lru_cache(maxsize=256)
def _leave_known_factors(slack: Slack, domain: Domain) -> Slack:
    """Divide a relation's slack by those of its factors whose strict signs are known."""
    value = slack.value
    if value.count_ops() > _MOST_FACTORED or not (is_workable(value) and _is_quotient(value)):
        return slack
    factors = sp.Mul.make_args(sp.factor(value))
    known = {factor: find_sign(factor, domain) for factor in factors if len(factors) > 1}
    signs = [sign for sign in known.values() if sign and sign.strict]
    left = [f for f in factors if not ((sign := known.get(f)) and sign.strict)]
    return Slack(prod(sign.direction for sign in signs) * sp.Mul(*left), slack.strict)


def _is_quotient(expression: sp.Expr) -> bool:
    """Return whether an expression is a quotient of polynomials in letters and functions."""
    functions = find_parts(expression, sp.Function)
    named = expression.xreplace({function: sp.Dummy() for function in functions})
    return bool(named.is_rational_function())


def _find_stated_sign(number: sp.Expr, said: Sequence[Slack]) -> StrictSign | None:
    """Return the sign of a number that is a multiple of a slack given by a relation."""
    for value, strict in said:
        above, below = cancel(number / value)
        if above.is_number and below.is_number and above != 0:
            return StrictSign(1 if above / below > 0 else -1, strict)
    return None


def is_positive(expression: sp.Expr, domain: Domain) -> bool:
    """Return whether an expression is proved to be positive on the domain."""
    sign = find_sign(expression, domain)
    has_direction = sign is not None and sign.direction > 0
    return has_direction and (_is_strict(sign) or _is_stated_nonzero(expression, domain))


def is_nonnegative(expression: sp.Expr, domain: Domain) -> bool:
    """Return whether an expression is proved to be non-negative on the domain."""
    sign = find_sign(expression, domain)
    return sign is not None and sign.direction > 0


def is_nonzero(expression: sp.Expr, domain: Domain) -> bool:
    """Return whether an expression is proved, by its sign or a relation, to have no zero."""
    return _is_strict(find_sign(expression, domain)) or _is_stated_nonzero(expression, domain)


def _is_stated_nonzero(expression: sp.Expr, domain: Domain) -> bool:
    """Return whether each factor has a strict sign or is stated to be nonzero."""
    said = [r.lhs - r.rhs for r in domain.where if isinstance(r, sp.Unequality)]
    if not said or expression.count_ops() > _MOST_FACTORED:
        return False
    bases = [f.as_base_exp()[0] for f in sp.Mul.make_args(sp.factor(domain.resolve(expression)))]
    return all(_is_stated(base, said) or _is_strict(find_sign(base, domain)) for base in bases)


def _is_stated(base: sp.Expr, said: Sequence[sp.Expr]) -> bool:
    """Return whether a number is a multiple of one that is stated to be nonzero."""
    ratios = (sp.cancel(base / number) for number in said)
    return any(ratio.is_number and ratio != 0 for ratio in ratios)


def _is_strict(sign: StrictSign | None) -> bool:
    return sign is not None and sign.strict


def is_within_quarter_turn(angle: sp.Expr, domain: Domain) -> bool:
    """Return whether an angle is proved to lie strictly between -pi/2 and pi/2."""
    return all(is_positive(sp.pi / 2 + k * angle, domain) for k in (1, -1))


def is_shown(slack: Slack, domain: Domain) -> bool:
    """Return whether a slack is proved: positive if it is strict, else non-negative."""
    return (is_positive if slack.strict else is_nonnegative)(slack.value, domain)


def _find_sign_with_ends(expression: sp.Expr, domain: Domain) -> StrictSign | None:
    if not expression.free_symbols:
        return sign_of_number(expression)
    if has_parts(expression, sp.Sum, sp.Integral) or not is_workable(expression):
        return None
    sign = find_sign_in(_change_coordinates(expression, domain), expression)
    for symbol, end in _closed_right_ends(expression, domain) if sign else []:
        there = replace(domain, where=tuple(r.subs(symbol, end) for r in domain.where))
        at_end = _find_sign_with_ends(expression.subs(symbol, end), there)
        sign = _weaker(sign, at_end)
    return sign


def _weaker(one: StrictSign | None, other: StrictSign | None) -> StrictSign | None:
    if one is None or other is None or one.direction != other.direction:
        return None
    return StrictSign(one.direction, one.strict and other.strict)


def _closed_right_ends(expression: sp.Expr, domain: Domain) -> list[tuple[sp.Basic, sp.Expr]]:
    """List the closed right ends, which the coordinate v/(1 + v) does not reach."""
    sets = {s: domain.set_of(s) for s in _with_related(expression, domain)}
    return [
        (symbol, where.end)
        for symbol, where in sorted(sets.items(), key=lambda item: str(item[0]))
        if isinstance(where, sp.Interval)
        and where.end.is_finite
        and not (where.right_open or where.start.is_infinite)
    ]


def _change_coordinates(expression: sp.Expr, domain: Domain) -> Coordinates:
    coordinates = Coordinates({}, set(), set())
    symbols = _with_related(expression, domain)
    for symbol in sorted(symbols, key=str):
        replace_by_half_line(symbol, domain.set_of(symbol), coordinates)
    for relation in domain.where:
        if relation.free_symbols <= symbols:
            _replace_by_gap(relation, domain, coordinates)
    return coordinates


def _with_related(expression: sp.Expr, domain: Domain) -> set[sp.Basic]:
    symbols = set(expression.free_symbols)
    for relation in domain.where:
        if relation.free_symbols & symbols:
            symbols |= relation.free_symbols
    return symbols


def _replace_by_gap(relation: sp.Basic, domain: Domain, coordinates: Coordinates) -> None:
    """Write a letter as its bound and a gap, if its own interval is unbounded on that side.

    At its other end the bound must be at least as narrow as the interval.
    """
    slack = find_slack(relation)
    if slack is None:
        return
    for letter in dict.fromkeys((relation.gts, *sorted(relation.free_symbols, key=str))):
        rate = slack.value.coeff(letter) if letter.is_Symbol else sp.S.Zero
        if not rate.is_nonzero:
            continue
        bound, way, where = letter - slack.value / rate, sp.sign(rate), domain.set_of(letter)
        near, far = (where.inf, where.sup) if way == 1 else (where.sup, where.inf)
        # A letter bounded on that side keeps its own coordinate: a gap would lose the bound.
        if bound.has(letter) or far != way * sp.oo:
            continue
        # Without the relations, which would ask for this sign again.
        sign = (
            find_sign(way * (bound - near), replace(domain, where=())) if near.is_finite else None
        )
        if near.is_infinite or (sign is not None and sign.direction > 0):
            gap = sp.Dummy(f"gap_{letter}", nonnegative=True)
            (coordinates.positive if slack.strict else coordinates.nonnegative).add(gap)
            coordinates.replacement[letter] = bound + way * gap
            return


def _is_acute(angle: sp.Expr, domain: Domain) -> bool:
    return not angle.atoms(sp.Function) and is_within_quarter_turn(angle, domain)
