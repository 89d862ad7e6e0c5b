"""Signs of expressions, by quotients of polynomials in coordinates whose own signs are known.

The numerator is factored, and a factor whose monomials all have one sign has that sign. Sound, not
complete: `None` means "not shown", except for one variable, where Sturm's theorem (1829) decides.
Complete procedures for several variables, such as the cylindrical algebraic decomposition of
Collins (1975), are not tried.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace

import sympy as sp

from mechproof.arithmetic import balls
from mechproof.arithmetic.polynomials import Polynomial, expand, factor_list, read_parts, split
from mechproof.proof.coordinates import (
    Coordinates,
    free_tangents,
    list_angles,
    name_absolute_values,
    name_positive,
    write_by_cosines,
    write_by_half_angles,
)
from mechproof.record.parts import replace_parts

# Points at which a polynomial is tried, and the sizes of their coordinates.
TRIED = 12
SIZES = tuple(map(sp.Rational, ("1/7", "3", "1", "1/3", "11", "2/5", "1/50", "40")))


@dataclass(frozen=True)
class StrictSign:
    """+1 or -1, and whether zero is excluded."""

    direction: int
    strict: bool

    def times(self, other: StrictSign) -> StrictSign:
        """Return the sign of a product."""
        return StrictSign(self.direction * other.direction, self.strict and other.strict)

    def is_above(self, strict: bool) -> bool:
        """Return whether this sign means positive, or non-negative if not `strict`."""
        return self.direction > 0 and (self.strict or not strict)


def sign_of_number(number: sp.Expr) -> StrictSign | None:
    """Return the sign of a number, or None if its ball contains zero."""
    if number.is_Rational:
        return StrictSign(-1 if number < 0 else 1, bool(number))
    ball = balls.evaluate(number, {}, 256)
    return StrictSign(1, True) if ball > 0 else StrictSign(-1, True) if ball < 0 else None


def sign_of_quotient(expression: sp.Expr, coordinates: Coordinates) -> StrictSign | None:
    """Return the sign of a quotient whose divisor is proved to be nonzero, or None."""
    parts = read_parts(expression)
    if parts and all(map(_has_plain_roots, parts)):
        signs = (_sign_of_read(part, coordinates) for part in parts)
    else:
        signs = (_sign_of_factors(part, coordinates) for part in split(expression))
    top = next(signs)
    bottom = next(signs) if top else None
    return top.times(bottom) if top and bottom and bottom.strict else None


def _has_plain_roots(polynomial: Polynomial) -> bool:
    roots = polynomial.roots.values()
    return all(root.free_symbols and not root.has(sp.Function) for root in roots)


def _sign_of_read(polynomial: Polynomial, coordinates: Coordinates) -> StrictSign | None:
    """Return the sign of all monomials or else the sign given by the factors, or None.

    The factors are not sought if the polynomial takes both signs at a few points.
    """
    nonnegative = coordinates.nonnegative | polynomial.roots.keys()
    known = replace(coordinates, nonnegative=nonnegative)
    terms = polynomial.list_terms()
    if not terms:
        return StrictSign(1, False)
    signed = ((powers, StrictSign(1 if number > 0 else -1, True)) for powers, number in terms)
    if sign := _sign_of_terms(polynomial.variables, signed, known):
        return sign
    points = _list_points(polynomial.variables, known.half_lines)
    values = [polynomial.evaluate(point) for point in points]
    if min(values) < 0 < max(values):
        return None
    return _sign_of_factors(polynomial.write(), coordinates)


def _sign_of_factors(expression: sp.Expr, coordinates: Coordinates) -> StrictSign | None:
    if not expression.free_symbols:
        return sign_of_number(expression)
    if expression.atoms(sp.Function):
        return None
    expression = _name_positive_powers(expression, coordinates)
    powers = {p for p in expression.atoms(sp.Pow) if p.exp == sp.S.Half and p.free_symbols}
    found = sorted(powers, key=sp.default_sort_key)
    roots = {node: sp.Dummy("root", nonnegative=True) for node in found}
    expression = expression.subs(roots)
    if not expression.is_polynomial(*expression.free_symbols):
        return None
    nonnegative = coordinates.nonnegative | set(roots.values())
    return _sign_of_product(expression, replace(coordinates, nonnegative=nonnegative))


def _sign_of_product(expression: sp.Expr, coordinates: Coordinates) -> StrictSign | None:
    constant, factors = factor_list(expression)
    sign = sign_of_number(constant)
    for factor, power in factors:
        one = _sign_of_polynomial(factor, coordinates)
        if one is None:
            if power % 2:
                return None
            one = StrictSign(1, False)
        sign = sign.times(one if power % 2 else StrictSign(1, one.strict)) if sign else None
    return sign


def _name_positive_powers(expression: sp.Expr, coordinates: Coordinates) -> sp.Expr:
    """Replace powers of positive bases with non-rational exponents by positive variables."""
    powers = [p for p in expression.atoms(sp.Pow) if not p.exp.is_Rational]
    named = {
        power: sp.Dummy("power", positive=True)
        for power in sorted(powers, key=sp.default_sort_key)
        if sign_of_quotient(power.base, coordinates) == StrictSign(1, True)
    }
    coordinates.positive |= set(named.values())
    return expression.xreplace(named)


def _sign_of_polynomial(factor: sp.Expr, coordinates: Coordinates) -> StrictSign | None:
    if not factor.free_symbols:
        return sign_of_number(factor)
    symbols = sorted(factor.free_symbols, key=str)
    polynomial = sp.Poly(factor, *symbols)
    signed = ((powers, sign_of_number(number)) for powers, number in polynomial.terms())
    sign = _sign_of_terms(symbols, signed, coordinates)
    return sign or _sign_of_mixed_terms(polynomial, coordinates)


def _sign_of_terms(
    variables: Sequence[sp.Basic],
    terms: Iterable[tuple[tuple[int, ...], StrictSign | None]],
    coordinates: Coordinates,
) -> StrictSign | None:
    """Return the common sign of all terms, given their powers and their coefficients' signs."""
    directions, strict = set(), False
    for powers, known in terms:
        shape = [_sign_of_power(*pair, coordinates) for pair in zip(variables, powers, strict=True)]
        if known is None or None in shape:
            return None
        directions.add(known.direction)
        strict = strict or all(shape)
    return StrictSign(directions.pop(), strict) if len(directions) == 1 else None


def _sign_of_power(symbol: sp.Basic, power: int, coordinates: Coordinates) -> bool | None:
    """Return True for positive, False for non-negative, None for any sign."""
    if power == 0 or symbol in coordinates.positive:
        return True
    return False if symbol in coordinates.nonnegative or power % 2 == 0 else None


def _sign_of_mixed_terms(polynomial: sp.Poly, coordinates: Coordinates) -> StrictSign | None:
    if len(polynomial.gens) == 1:
        sign = _sign_by_sturm(polynomial, coordinates.half_lines)
        if sign or polynomial.domain.is_QQ | polynomial.domain.is_ZZ:
            return sign
    found = (_sign_by_discriminant(polynomial, s, coordinates) for s in polynomial.gens)
    return next(filter(None, found), None)


def _sign_by_discriminant(
    polynomial: sp.Poly, symbol: sp.Basic, coordinates: Coordinates
) -> StrictSign | None:
    """Return the sign of a*v^2 + b*v + c for all real v: that of a if b^2 <= 4*a*c, else None."""
    if polynomial.degree(symbol) != 2:
        return None
    written = polynomial.as_expr()
    a, b, c = (written.coeff(symbol, power) for power in (2, 1, 0))
    rest = expand(4 * a * c - b**2)
    if _is_negative_somewhere(rest, coordinates.half_lines):
        return None
    leading = _sign_of_product(a, coordinates)
    gap = _sign_of_product(rest, coordinates) if leading and leading.strict else None
    if not (leading and gap and gap.direction > 0):
        return None
    return StrictSign(leading.direction, gap.strict)


def _is_negative_somewhere(expression: sp.Expr, half_lines: set[sp.Basic]) -> bool:
    """Return whether a polynomial is negative at one of a few points, before it is factored.

    Names that are functions of each other are free numbers here, as in the proof.
    """
    symbols = sorted(expression.free_symbols, key=str)
    for point in _list_points(symbols, half_lines):
        value = balls.evaluate(expression, dict(zip(symbols, point, strict=True)))
        if value.is_finite() and value < 0:
            return True
    return False


def _list_points(
    symbols: Sequence[sp.Basic], half_lines: set[sp.Basic]
) -> Iterator[list[sp.Rational]]:
    """Yield a few points, positive where the symbols run on half-lines."""
    for shift in range(TRIED):
        signs = [1 if s in half_lines else (-1) ** (k + shift) for k, s in enumerate(symbols)]
        sizes = [SIZES[(3 * k + shift) % len(SIZES)] for k in range(len(symbols))]
        yield [sign * size for sign, size in zip(signs, sizes, strict=True)]


def _sign_by_sturm(polynomial: sp.Poly, half_lines: set[sp.Basic]) -> StrictSign | None:
    """Decide the sign of a polynomial in one variable with rational coefficients."""
    if not polynomial.domain.is_QQ | polynomial.domain.is_ZZ:
        return None
    on_half_line = polynomial.gens[0] in half_lines
    # Counts the root 0, too, so that the sign is strict even where the letter may be zero.
    if polynomial.count_roots(0 if on_half_line else None, None):
        return None
    # Without a root the sign at any place is the sign everywhere; 1 lies on the half-line, too.
    return sign_of_number(polynomial.eval(1))


def find_sign_in(coordinates: Coordinates, expression: sp.Expr) -> StrictSign | None:
    """Return the sign of an expression whose letters the coordinates replace, if it shows."""
    expression = name_positive(expression, coordinates)
    changed = free_tangents(expression)
    # Gaps are chained, as in R3 < R2 < R1, so replacements may contain letters to be replaced.
    for _ in range(3):
        changed = replace_parts(changed, coordinates.replacement)
        if not changed.free_symbols & coordinates.replacement.keys():
            break
    radicands = {p.base for p in expression.atoms(sp.Pow) if not p.exp.is_integer}
    if any(_may_hide_sign(base, coordinates) for base in radicands):
        return None
    changed = name_absolute_values(changed, coordinates)
    sign = _sign_by_half_angles(changed, coordinates)
    return sign if sign else sign_of_quotient(write_by_cosines(changed)[0], coordinates)


def _may_hide_sign(radicand: sp.Expr, coordinates: Coordinates) -> bool:
    """Return whether a factor of a radicand may be negative where another one is zero.

    SymPy takes the other factor out of the root, as if the rest had a root there, too.
    """
    factors = sp.Mul.make_args(radicand.xreplace(coordinates.replacement))
    may_vanish = any(factor in coordinates.nonnegative for factor in factors)
    return may_vanish and not all(factor.is_nonnegative for factor in factors)


def _sign_by_half_angles(expression: sp.Expr, coordinates: Coordinates) -> StrictSign | None:
    """Return the sign by half-angle tangents; they miss the half turn, which is checked apart."""
    sign = sign_of_quotient(write_by_half_angles(expression), coordinates)
    if sign is None or not sign.strict:
        return sign
    for angle in list_angles(expression):
        there = expression.subs({sp.sin(angle): 0, sp.cos(angle): -1, sp.tan(angle): 0})
        if there.has(sp.nan, sp.zoo):
            continue
        at_half_turn = _sign_by_half_angles(there, coordinates)
        if at_half_turn is None or not at_half_turn.strict:
            return StrictSign(sign.direction, False)
    return sign
