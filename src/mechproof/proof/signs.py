"""Rung: the sign of an expression on a domain, proved by a change to positive coordinates.

Every interval becomes a half-line (e in [0, 1) is v/(1 + v) with v >= 0; R2 < R1 is
R1 = R2 + d with d > 0), angles become half-angle tangents, the numerator is factored, and a
factor whose monomials all have one sign has that sign. Sound, not complete: `None` means
"not shown", except for one variable, where Sturm's theorem decides.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import sympy as sp

from mechproof.proof import balls
from mechproof.proof.domain import Domain
from mechproof.proof.normal_form import factorise, split

# Work limit: powers and multiples of angles beyond are not multiplied out.
MOST_MULTIPLIED = 100


def is_workable(expression: sp.Basic) -> bool:
    """Tell whether no whole power is beyond the limit."""
    powers = (p.exp for p in expression.atoms(sp.Pow) if p.exp.is_Integer)
    return all(abs(power) <= MOST_MULTIPLIED for power in powers)


@dataclass(frozen=True)
class Sign:
    """+1 or -1, and whether zero is excluded."""

    direction: int
    strict: bool

    def times(self, other: Sign) -> Sign:
        """Return the sign of a product."""
        return Sign(self.direction * other.direction, self.strict and other.strict)


# Rows of a paper share their radicals and divisors, whose signs are what a proof takes longest for.
@lru_cache(maxsize=4096)
def find_sign(expression: sp.Expr, domain: Domain) -> Sign | None:
    """Return the proved sign of the expression on the domain, or None if it is not shown."""
    expression = domain.resolve(expression)
    try:
        return _find_sign_with_ends(expression, domain)
    except (NotImplementedError, sp.PolynomialError):
        return None


def _find_sign_with_ends(expression: sp.Expr, domain: Domain) -> Sign | None:
    if not expression.free_symbols:
        return _sign_of_number(expression)
    if expression.has(sp.Sum, sp.Integral) or not is_workable(expression):
        return None
    sign = _sign_in_coordinates(expression, domain)
    for symbol, end in _closed_right_ends(expression, domain) if sign else []:
        at_end = _find_sign_with_ends(expression.subs(symbol, end), _fix(domain, symbol, end))
        sign = _weaker(sign, at_end)
    return sign


def _fix(domain: Domain, symbol: sp.Basic, value: sp.Expr) -> Domain:
    where = tuple(relation.subs(symbol, value) for relation in domain.where)
    return Domain(domain.within, where, domain.given)


def _weaker(one: Sign | None, other: Sign | None) -> Sign | None:
    if one is None or other is None or one.direction != other.direction:
        return None
    return Sign(one.direction, one.strict and other.strict)


def _sign_of_number(number: sp.Expr) -> Sign | None:
    if number == 0:
        return Sign(1, False)
    ball = balls.evaluate(number, {}, 256)
    return Sign(1, True) if ball > 0 else Sign(-1, True) if ball < 0 else None


def _closed_right_ends(expression: sp.Expr, domain: Domain) -> list[tuple[sp.Basic, sp.Expr]]:
    """List the ends that the coordinate v/(1 + v) does not reach."""
    sets = {s: domain.set_of(s) for s in _with_related(expression, domain)}
    return [
        (symbol, where.end)
        for symbol, where in sorted(sets.items(), key=lambda item: str(item[0]))
        if isinstance(where, sp.Interval)
        and where.end.is_finite
        and not (where.right_open or where.start.is_infinite)
    ]


@dataclass
class _Coordinates:
    """The change of variables and what is known of the new ones."""

    replacement: dict[sp.Basic, sp.Expr]
    positive: set[sp.Basic]
    nonnegative: set[sp.Basic]


def _sign_in_coordinates(expression: sp.Expr, domain: Domain) -> Sign | None:
    coordinates = _change_coordinates(expression, domain)
    expression = _name_exponentials(expression, coordinates)
    changed = _name_positive_cosines(_free_tangents(expression), coordinates, domain)
    for _ in range(3):
        changed = changed.xreplace(coordinates.replacement)
        if not changed.free_symbols & coordinates.replacement.keys():
            break
    changed = _name_absolute_values(changed, coordinates)
    sign = _sign_by_half_angles(changed, coordinates)
    return sign if sign else _sign_of_quotient(_cosines(changed), coordinates)


def _change_coordinates(expression: sp.Expr, domain: Domain) -> _Coordinates:
    coordinates = _Coordinates({}, set(), set())
    symbols = _with_related(expression, domain)
    for symbol in sorted(symbols, key=str):
        _replace_by_half_line(symbol, domain.set_of(symbol), coordinates)
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


def _replace_by_half_line(symbol: sp.Basic, where: sp.Set, coordinates: _Coordinates) -> None:
    if where in (sp.S.Naturals, sp.S.Naturals0):
        where = sp.Interval(1 if where == sp.S.Naturals else 0, sp.oo)
    if not isinstance(where, sp.Interval) or where == sp.S.Reals:
        return
    low, high, v = where.start, where.end, sp.Dummy(f"v_{symbol}", nonnegative=True)
    low_is_reached = not where.left_open and low.is_finite
    (coordinates.nonnegative if low_is_reached else coordinates.positive).add(v)
    if low.is_infinite:
        coordinates.nonnegative.discard(v)
        (coordinates.positive if where.right_open else coordinates.nonnegative).add(v)
        coordinates.positive -= coordinates.nonnegative
        coordinates.replacement[symbol] = high - v
    elif high.is_infinite:
        coordinates.replacement[symbol] = low + v
    else:
        coordinates.replacement[symbol] = low + (high - low) * v / (1 + v)


def _replace_by_gap(relation: sp.Basic, domain: Domain, coordinates: _Coordinates) -> None:
    """Use small < large, large being a symbol whose own interval starts no higher than small."""
    kinds = (sp.StrictLessThan, sp.LessThan, sp.StrictGreaterThan, sp.GreaterThan)
    if not isinstance(relation, kinds):
        return
    small, large = relation.lts, relation.gts
    strict = isinstance(relation, sp.StrictLessThan | sp.StrictGreaterThan)
    where = domain.set_of(large)
    if not large.is_Symbol or small.has(large) or where.sup != sp.oo:
        return
    if where.inf != -sp.oo and (low := find_sign(small - where.inf, _without(domain))) is None:
        return
    if where.inf != -sp.oo and low is not None and low.direction < 0:
        return
    gap = sp.Dummy(f"gap_{large}", nonnegative=True)
    (coordinates.positive if strict else coordinates.nonnegative).add(gap)
    coordinates.replacement[large] = small + gap


def _without(domain: Domain) -> Domain:
    return Domain(domain.within, (), domain.given)


def _name_exponentials(expression: sp.Expr, coordinates: _Coordinates) -> sp.Expr:
    """Let each exponential of a real number be a positive number."""
    nodes = sorted(expression.atoms(sp.exp), key=sp.default_sort_key)
    named = {node: sp.Dummy("exp", positive=True) for node in nodes if node.args[0].is_real}
    coordinates.positive |= set(named.values())
    return expression.subs(named)


def _name_absolute_values(expression: sp.Expr, coordinates: _Coordinates) -> sp.Expr:
    """Let each absolute value, its squares being squares of the number, be one not negative."""
    if not expression.has(sp.Abs):
        return expression
    expression = sp.expand(expression)
    nodes = sorted(expression.atoms(sp.Abs), key=sp.default_sort_key)
    named = {node: sp.Dummy("size", nonnegative=True) for node in nodes}
    coordinates.nonnegative |= set(named.values())
    return expression.xreplace(named)


def _free_tangents(expression: sp.Expr) -> sp.Expr:
    """Let the tangent of an angle that occurs in no other way be any real number."""
    replacement = {
        sp.tan(angle): sp.Dummy("t", real=True)
        for angle in _angles(expression)
        if not expression.has(sp.sin(angle), sp.cos(angle))
    }
    return expression.xreplace(replacement)


def _name_positive_cosines(
    expression: sp.Expr, coordinates: _Coordinates, domain: Domain
) -> sp.Expr:
    """Let the cosine of an angle proved to lie within a quarter turn be a positive number."""
    for angle in _angles(expression):
        only_cosine = not expression.has(sp.sin(angle), sp.tan(angle))
        if only_cosine and all(_is_positive(sp.pi / 2 + k * angle, domain) for k in (1, -1)):
            c = sp.Dummy("c", positive=True)
            coordinates.positive.add(c)
            expression = expression.subs(sp.cos(angle), c)
    return expression


def _is_positive(expression: sp.Expr, domain: Domain) -> bool:
    if expression.atoms(sp.Function):
        return False
    return find_sign(expression, domain) == Sign(1, True)


def _sign_by_half_angles(expression: sp.Expr, coordinates: _Coordinates) -> Sign | None:
    """Half-angle tangents miss the half turn: a limit keeps the sign there, but may be zero."""
    sign = _sign_of_quotient(_half_angles(expression), coordinates)
    if sign is None or not sign.strict:
        return sign
    for angle in _angles(expression):
        there = expression.subs({sp.sin(angle): 0, sp.cos(angle): -1, sp.tan(angle): 0})
        if there.has(sp.nan, sp.zoo):
            continue
        at_half_turn = _sign_by_half_angles(there, coordinates)
        if at_half_turn is None or not at_half_turn.strict:
            return Sign(sign.direction, False)
    return sign


def _half_angles(expression: sp.Expr) -> sp.Expr:
    """Write sines and cosines of each angle by the tangent of its half."""
    replacement: dict[sp.Basic, sp.Expr] = {}
    for angle in _angles(expression):
        t = sp.Dummy("t", real=True)
        replacement |= {
            sp.sin(angle): 2 * t / (1 + t**2),
            sp.cos(angle): (1 - t**2) / (1 + t**2),
            sp.tan(angle): 2 * t / (1 - t**2),
        }
    return expression.xreplace(replacement)


def _cosines(expression: sp.Expr) -> sp.Expr:
    """Write even powers of sines by cosines; what is left are independent real symbols."""
    result = expression
    for angle in _angles(expression):
        c, s = sp.Dummy("c", real=True), sp.Dummy("s", real=True)
        result = result.subs({sp.sin(angle): s, sp.cos(angle): c, sp.tan(angle): s / c})
        numerator, denominator = split(result)
        relation = s**2 + c**2 - 1
        result = sp.rem(sp.expand(numerator), relation, s) / sp.rem(
            sp.expand(denominator), relation, s
        )
    return result


def _angles(expression: sp.Expr) -> list[sp.Expr]:
    found = {node.args[0] for node in expression.atoms(sp.sin, sp.cos, sp.tan)}
    return sorted(found, key=sp.default_sort_key)


def _sign_of_quotient(expression: sp.Expr, coordinates: _Coordinates) -> Sign | None:
    numerator, denominator = split(expression)
    top = _sign_of_factors(numerator, coordinates)
    bottom = _sign_of_factors(denominator, coordinates)
    return top.times(bottom) if top and bottom and bottom.strict else None


def _sign_of_factors(expression: sp.Expr, coordinates: _Coordinates) -> Sign | None:
    if not expression.free_symbols:
        return _sign_of_number(expression)
    if expression.atoms(sp.Function):
        return None
    expression = _name_positive_powers(expression, coordinates)
    roots = {node: sp.Dummy("root", nonnegative=True) for node in _square_roots(expression)}
    expression = expression.subs(roots)
    if not expression.is_polynomial(*expression.free_symbols):
        return None
    nonnegative = coordinates.nonnegative | set(roots.values())
    return _sign_of_product(expression, coordinates.positive, nonnegative)


def _sign_of_product(
    expression: sp.Expr, positive: set[sp.Basic], nonnegative: set[sp.Basic]
) -> Sign | None:
    constant, factors = factorise(expression)
    sign = _sign_of_number(constant)
    for factor, power in factors:
        one = _sign_of_polynomial(factor, positive, nonnegative)
        if one is None:
            if power % 2:
                return None
            one = Sign(1, False)
        sign = sign.times(one if power % 2 else Sign(1, one.strict)) if sign else None
    return sign


def _name_positive_powers(expression: sp.Expr, coordinates: _Coordinates) -> sp.Expr:
    """Let each power with an exponent that is no number, of a positive base, be positive."""
    powers = [p for p in expression.atoms(sp.Pow) if not p.exp.is_number]
    named = {
        power: sp.Dummy("power", positive=True)
        for power in sorted(powers, key=sp.default_sort_key)
        if _sign_of_quotient(power.base, coordinates) == Sign(1, True)
    }
    coordinates.positive |= set(named.values())
    return expression.xreplace(named)


def _square_roots(expression: sp.Expr) -> list[sp.Expr]:
    powers = [p for p in expression.atoms(sp.Pow) if p.exp == sp.Rational(1, 2)]
    return sorted((p for p in powers if p.free_symbols), key=sp.default_sort_key)


def _sign_of_polynomial(
    factor: sp.Expr, positive: set[sp.Basic], nonnegative: set[sp.Basic]
) -> Sign | None:
    if not factor.free_symbols:
        return _sign_of_number(factor)
    symbols = sorted(factor.free_symbols, key=str)
    polynomial = sp.Poly(factor, *symbols)
    directions, strict = set(), False
    for powers, coefficient in polynomial.terms():
        known = _sign_of_number(coefficient)
        shape = [
            _sign_of_power(s, p, positive, nonnegative)
            for s, p in zip(symbols, powers, strict=True)
        ]
        if known is None or None in shape:
            return _sign_of_mixed_terms(polynomial, positive, nonnegative)
        directions.add(known.direction)
        strict = strict or all(shape)
    if len(directions) > 1:
        return _sign_of_mixed_terms(polynomial, positive, nonnegative)
    return Sign(directions.pop(), strict)


def _sign_of_power(
    symbol: sp.Basic, power: int, positive: set[sp.Basic], nonnegative: set[sp.Basic]
) -> bool | None:
    """Return True for positive, False for not negative, None for any sign."""
    if power == 0 or symbol in positive:
        return True
    return False if symbol in nonnegative or power % 2 == 0 else None


def _sign_of_mixed_terms(
    polynomial: sp.Poly, positive: set[sp.Basic], nonnegative: set[sp.Basic]
) -> Sign | None:
    if len(polynomial.gens) == 1:
        return _sign_by_sturm(polynomial, positive | nonnegative)
    found = (_sign_by_discriminant(polynomial, s, positive, nonnegative) for s in polynomial.gens)
    return next(filter(None, found), None)


def _sign_by_discriminant(
    polynomial: sp.Poly, symbol: sp.Basic, positive: set[sp.Basic], nonnegative: set[sp.Basic]
) -> Sign | None:
    """Return the sign of a*v^2 + b*v + c, v any real number: that of a > 0 if b^2 <= 4*a*c."""
    if polynomial.degree(symbol) != 2:
        return None
    a, b, c = (polynomial.as_expr().coeff(symbol, power) for power in (2, 1, 0))
    leading = _sign_of_product(a, positive, nonnegative)
    gap = _sign_of_product(4 * a * c - b**2, positive, nonnegative)
    if not (leading and leading.strict and gap and gap.direction > 0):
        return None
    return Sign(leading.direction, gap.strict)


def _sign_by_sturm(polynomial: sp.Poly, half_lines: set[sp.Basic]) -> Sign | None:
    """Decide one polynomial in one variable with rational coefficients."""
    if len(polynomial.gens) != 1 or not polynomial.domain.is_QQ | polynomial.domain.is_ZZ:
        return None
    on_half_line = polynomial.gens[0] in half_lines
    if polynomial.count_roots(0 if on_half_line else None, None):
        return None
    return _sign_of_number(polynomial.eval(1))
