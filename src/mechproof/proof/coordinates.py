"""Coordinates that make signs visible: half-lines, tangents of half angles, named parts."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache
from types import MappingProxyType

import sympy as sp

from mechproof.arithmetic.polynomials import cancel, factor_list, reduce_polynomial, split
from mechproof.record import Slack
from mechproof.record.parts import INVERSES, TURNING, replace_parts
from mechproof.statement_domains.set_values import COUNTS

# Trigonometric functions of an angle as functions of its sine and its cosine.
BY_SINES: Mapping[type[sp.Expr], Callable[[sp.Expr, sp.Expr], sp.Expr]] = MappingProxyType(
    {
        sp.sin: lambda sine, cosine: sine,
        sp.cos: lambda sine, cosine: cosine,
        sp.tan: lambda sine, cosine: sine / cosine,
        sp.cot: lambda sine, cosine: cosine / sine,
        sp.sec: lambda sine, cosine: 1 / cosine,
        sp.csc: lambda sine, cosine: 1 / sine,
    }
)
HYPERBOLIC = (sp.sinh, sp.cosh, sp.tanh, sp.coth, sp.sech, sp.csch)


def write_by_sines(expression: sp.Expr) -> sp.Expr:
    """Write functions of an angle that have poles as quotients of its sine and cosine."""
    return expression.replace(
        lambda node: isinstance(node, sp.tan | sp.cot | sp.sec | sp.csc),
        lambda node: BY_SINES[type(node)](sp.sin(node.args[0]), sp.cos(node.args[0])),
    )


def write_by_exponentials(expression: sp.Expr) -> sp.Expr:
    """Write hyperbolic functions by exponentials."""
    return expression.replace(
        lambda node: isinstance(node, HYPERBOLIC), lambda node: node.rewrite(sp.exp)
    )


@dataclass
class Coordinates:
    """The change of variables and what is known of the new ones."""

    replacement: dict[sp.Basic, sp.Expr]
    positive: set[sp.Basic]
    nonnegative: set[sp.Basic]

    @property
    def half_lines(self) -> set[sp.Basic]:
        """Return the new variables that are non-negative, positive ones among them."""
        return self.positive | self.nonnegative


def parametrise(variable: sp.Symbol, lower: sp.Expr, upper: sp.Expr) -> tuple[sp.Expr, sp.Interval]:
    """Return the variable in terms of one that runs between numbers, and that one's interval."""
    if lower.is_number and upper.is_number:
        return variable, sp.Interval(lower, upper)
    if upper.is_infinite:
        return lower + variable, sp.Interval(0, sp.oo)
    if lower.is_infinite:
        return upper + variable, sp.Interval(-sp.oo, 0)
    return lower + (upper - lower) * variable, sp.Interval(0, 1)


# Returns the same dummy each time, as SymPy caches what it knows about a number.
@lru_cache(maxsize=256)
def _name_number(symbol: sp.Basic, where: sp.Set) -> sp.Dummy:
    return sp.Dummy(f"v_{symbol}", nonnegative=True)


@lru_cache(maxsize=256)
def _name_tangent(angle: sp.Expr) -> sp.Dummy:
    return sp.Dummy("t", real=True)


def replace_by_half_line(symbol: sp.Basic, where: sp.Set, coordinates: Coordinates) -> None:
    """Replace a number of an interval by an expression in a positive or non-negative one."""
    if where in COUNTS and where != sp.S.Integers:
        where = sp.Interval(1 if where == sp.S.Naturals else 0, sp.oo)
    if not isinstance(where, sp.Interval) or where == sp.S.Reals:
        return
    low, high, v = where.start, where.end, _name_number(symbol, where)
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
        # v/(1 + v) never reaches 1, so `high` is checked separately if it belongs to the set.
        coordinates.replacement[symbol] = low + (high - low) * v / (1 + v)


def name_positive(expression: sp.Expr, coordinates: Coordinates) -> sp.Expr:
    """Replace exponentials of real numbers and factorials of counts by positive variables."""
    nodes = sorted(expression.atoms(sp.exp, sp.factorial), key=sp.default_sort_key)
    named = {node: sp.Dummy("exp", positive=True) for node in nodes if node.is_positive}
    coordinates.positive |= set(named.values())
    return expression.subs(named)


def name_absolute_values(expression: sp.Expr, coordinates: Coordinates) -> sp.Expr:
    """Replace moduli by non-negative variables, and their squares by the squares of the insides."""
    if not expression.has(sp.Abs):
        return expression
    # Absolute values are named first: SymPy would look for the sign inside each new one.
    nodes = sorted(expression.atoms(sp.Abs), key=sp.default_sort_key)
    named = {node: sp.Dummy("size", nonnegative=True) for node in nodes}
    expanded = sp.expand(expression.xreplace(named))
    coordinates.nonnegative |= set(named.values())
    numbers = {size: node.args[0].xreplace(named) for node, size in named.items()}
    powers = [p for p in expanded.atoms(sp.Pow) if p.base in numbers and p.exp.is_Integer]
    return expanded.xreplace({p: _square(numbers[p.base], p) for p in powers})


def _square(number: sp.Expr, power: sp.Pow) -> sp.Expr:
    """Write a power of |number| by the square of the number, as far as possible."""
    times, rest = divmod(int(power.exp), 2)
    return number ** (2 * times) * power.base**rest


def name_roots(
    expression: sp.Expr, radicands: Iterable[sp.Expr], is_positive: Callable[[sp.Expr], bool]
) -> tuple[sp.Expr, tuple[sp.Symbol, ...]]:
    """Replace roots of the given positive radicands by variables with known squares.

    Also returns these variables. Roots of quotients and products become those of their factors, so
    that sqrt((1 + e)/(1 - e))*sqrt(1 - e**2) is 1 + e.
    """
    roots: dict[sp.Expr, sp.Symbol] = {}
    values = {radicand: _name_root(radicand, roots, is_positive) for radicand in radicands}
    squares = {root: factor for factor, root in roots.items()}
    named = expression.replace(
        lambda node: node.is_Pow and node.base in values and node.exp.is_Rational,
        lambda node: values[node.base] ** (2 * node.exp),
    )
    named = named.replace(
        lambda node: node.is_Pow and node.base in squares and node.exp.is_Integer,
        lambda node: squares[node.base] ** (node.exp // 2) * node.base ** (node.exp % 2),
    )
    return named, tuple(squares)


def _name_root(
    radicand: sp.Expr, roots: dict[sp.Expr, sp.Symbol], is_positive: Callable[[sp.Expr], bool]
) -> sp.Expr:
    """Return a root as a product of those of its factors, if these are shown to have signs."""

    def name(factor: sp.Expr) -> sp.Symbol:
        return roots.setdefault(factor, sp.Dummy("root", positive=True))

    try:
        (above, numerators), (below, denominators) = map(factor_list, cancel(radicand))
    except sp.PolynomialError:
        return name(radicand)
    powers = [*numerators, *((factor, -n) for factor, n in denominators)]
    turned = [-factor if is_positive(-factor) else factor for factor, _ in powers]
    if len(powers) < 2 or not all(map(is_positive, turned)):
        return name(radicand)
    # The radicand is positive, and so are its factors.
    number = sp.sqrt(abs(above / below))
    return number * sp.Mul(*(name(f) ** n for f, (_, n) in zip(turned, powers, strict=True)))


def free_tangents(expression: sp.Expr) -> sp.Expr:
    """Replace the tangent of an angle by any real number if its sine and cosine do not occur.

    The sine and cosine of twice the angle are written by that number.
    """
    replacement: dict[sp.Basic, sp.Expr] = {}
    for angle in list_angles(expression):
        if expression.has(sp.tan(angle)) and not expression.has(sp.sin(angle), sp.cos(angle)):
            t = sp.Dummy("t", real=True)
            replacement |= {sp.tan(angle): t, **_write_by_tangent(2 * angle, t)}
    return expression.xreplace(replacement)


def _write_by_tangent(angle: sp.Expr, t: sp.Symbol) -> dict[sp.Basic, sp.Expr]:
    """Return the sine and the cosine of an angle by t, the tangent of its half."""
    return {sp.sin(angle): 2 * t / (1 + t**2), sp.cos(angle): (1 - t**2) / (1 + t**2)}


def write_by_half_angles(expression: sp.Expr) -> sp.Expr:
    """Write sines, cosines and tangents of each angle by the tangent of its half."""
    replacement: dict[sp.Basic, sp.Expr] = {}
    for angle in list_angles(expression):
        t = _name_tangent(angle)
        replacement |= {sp.tan(angle): 2 * t / (1 - t**2), **_write_by_tangent(angle, t)}
    return replace_parts(expression, replacement)


def write_by_cosines(expression: sp.Expr) -> tuple[sp.Expr, dict[sp.Symbol, sp.Expr]]:
    """Write even powers of sines by cosines, with sines and cosines as real symbols.

    Also returns the symbols of the cosines, with their angles.
    """
    cosines: dict[sp.Symbol, sp.Expr] = {}
    replacement: dict[sp.Basic, sp.Expr] = {}
    squares: dict[sp.Pow, sp.Expr] = {}
    for angle in list_angles(expression):
        c, s = sp.Dummy("c", real=True), sp.Dummy("s", real=True)
        replacement |= {sp.sin(angle): s, sp.cos(angle): c, sp.tan(angle): s / c}
        squares[s**2] = 1 - c**2
        cosines[c] = angle
    above, below = (_lower(part, squares) for part in split(replace_parts(expression, replacement)))
    return above / below, cosines


def _lower(polynomial: sp.Expr, squares: dict[sp.Pow, sp.Expr]) -> sp.Expr:
    """Write a polynomial with every generator in `squares` to at most its first power."""
    try:
        return reduce_polynomial(polynomial, squares)
    except sp.PolynomialError:
        # The coefficients are not rational.
        for power, square in squares.items():
            polynomial = sp.rem(sp.expand(polynomial), power - square, power.base)
        return polynomial


def list_angles(expression: sp.Expr) -> list[sp.Expr]:
    """List the arguments of sines, cosines and tangents."""
    found = {node.args[0] for node in expression.atoms(*TURNING)}
    return sorted(found, key=sp.default_sort_key)


def list_terms(expression: sp.Expr) -> list[tuple[sp.Expr, sp.Rational]]:
    """Write an expression as a sum of rational multiples of monomials."""
    terms = (t.as_coeff_Mul(rational=True) for t in sp.Add.make_args(sp.expand(expression)))
    return [(monomial, factor) for factor, monomial in terms]


_INVERTED = {**INVERSES, sp.log: (sp.exp, sp.Interval(-sp.oo, sp.oo))}


def list_by_values(slack: Slack) -> Iterator[tuple[Slack, Slack, Slack]]:
    """Yield forms of a slack by what its inverse functions invert: cos E > e for E < arccos e.

    Two slacks follow, each keeping the other number within one end of the function's range. Given
    the first, the slack implies its new form; given the second, the new form implies the slack.
    """
    for term in sp.Add.make_args(slack.value):
        way, inverse = term.as_coeff_Mul()
        if type(inverse) not in _INVERTED or way not in (1, -1):
            continue
        function, values = _INVERTED[type(inverse)]
        other = way * (term - slack.value)
        turn = -way if function == sp.cos else way
        gap = turn * (inverse.args[0] - function(other))
        ends = (other - values.start, values.end - other)
        above, below = (Slack(x, bool(values.left_open)) for x in ends)
        ends = (above, below) if way > 0 else (below, above)
        yield slack._replace(value=gap), *ends
