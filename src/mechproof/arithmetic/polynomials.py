"""Polynomials by flint: their normal form, their factors, and the cancelling of quotients.

In the normal form every related generator is below the power given by its relation. The relations
r**n = f are a Groebner basis already, as their leading powers have no common factor (Buchberger's
first criterion), so that substituting them gives the unique normal form. SymPy's expressions are
converted to flint's sparse polynomials over the rationals, and back where needed.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache, reduce
from math import gcd, lcm
from operator import add, mul
from types import MappingProxyType

import sympy as sp
from flint import fmpq, fmpq_mpoly, fmpq_mpoly_ctx
from sympy.core.mul import _keep_coeff as keep_coefficient
from sympy.polys.polyutils import _sort_gens as sort_generators

from mechproof.record.parts import find_free, find_parts, replace_parts


def reduce_polynomial(polynomial: sp.Expr, relations: Mapping[sp.Pow, sp.Expr]) -> sp.Expr:
    """Return the normal form modulo relations, each of which may contain earlier generators.

    Raises `sympy.PolynomialError` for an expression that is not a polynomial over Q.
    """
    ring = _Ring(polynomial, relations=relations)
    return ring.write(ring.lower_all(ring.read(polynomial)))


def expand(polynomial: sp.Expr) -> sp.Expr:
    """Multiply a polynomial out."""
    try:
        return reduce_polynomial(polynomial, {})
    except sp.PolynomialError:
        # The polynomial has other numbers than the rationals.
        return sp.expand(polynomial)


def is_zero(quotient: sp.Expr, relations: Mapping[sp.Pow, sp.Expr]) -> bool:
    """Return whether a quotient's normal form is zero over a denominator that is not.

    Raises `sympy.PolynomialError` for an expression that is not a quotient of polynomials.
    """
    ring = _Ring(quotient, relations=relations)
    above, below = (ring.lower_all(part) for part in ring.read_quotient(quotient))
    return bool(above.is_zero() and not below.is_zero())


# Roots and signs of one proof, and proofs of one paper, have polynomials in common.
@lru_cache(maxsize=1024)
def factor_list(polynomial: sp.Expr) -> tuple[sp.Expr, list[tuple[sp.Expr, int]]]:
    """Factor like SymPy's `factor_list`, in its order and with its signs, but faster.

    Functions count as symbols. Raises `sympy.PolynomialError` if it is not a polynomial.
    """
    try:
        return _factor_product(polynomial)
    except sp.PolynomialError:
        # Over one denominator, it may turn out to have a number as its denominator.
        above, below = sp.together(polynomial).as_numer_denom()
    try:
        number, factors = _factor_product(above)
    except sp.PolynomialError:
        # The polynomial has roots, say, or other numbers than the rationals.
        constant, others = sp.factor_list(polynomial)
        return constant, others
    if not below.is_Rational:
        raise sp.PolynomialError(f"not a polynomial: {polynomial}")
    return number / below, factors


def _factor_product(product: sp.Expr) -> tuple[sp.Expr, list[tuple[sp.Expr, int]]]:
    found: dict[sp.Expr, tuple[sp.Poly, int]] = {}
    number = sp.S.One
    for base, power in (argument.as_base_exp() for argument in sp.Mul.make_args(product)):
        coefficient, factors = _factor_part(base)
        number *= coefficient**power
        for factor, times in factors:
            first, known = found.get(factor.as_expr(), (factor, 0))
            found[factor.as_expr()] = first, known + times * _to_count(power)
    if not (number.is_Rational and number):
        raise sp.PolynomialError(f"zero, or divided by zero: {product}")
    return number, [(f.as_expr(), n) for f, n in sorted(found.values(), key=_sort_key)]


def _to_count(power: sp.Expr) -> int:
    if not (power.is_Integer and power > 0):
        raise sp.PolynomialError(f"not the power of a polynomial: {power}")
    return int(power)


def _factor_part(base: sp.Expr) -> tuple[sp.Expr, list[tuple[sp.Poly, int]]]:
    """Factor an expression that is not a product, with positive leading coefficients."""
    ring = _Ring(base, functions=True)
    value = ring.read(base)
    number, factors = value.factor()
    generators = ring.list_generators(value)
    coefficient, signed = _to_rational(number), []
    for part, power in factors:
        factor = ring.to_poly(part, generators)
        if factor.LC() < 0:
            factor, coefficient = -factor, coefficient * (-1) ** int(power)
        signed.append((factor, int(power)))
    return coefficient, signed


def _sort_key(item: tuple[sp.Poly, int]) -> tuple[object, ...]:
    """Return the key by which SymPy sorts factors."""
    factor, power = item
    written = factor.rep.to_list()
    return len(written), len(factor.gens), power, str(factor.domain), written


def cancel(quotient: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Return numerator and denominator like SymPy's `cancel`, but faster.

    Both have integer coefficients and no common factor; the denominator's leading coefficient is
    positive. Functions count as symbols. Raises `sympy.PolynomialError` for other quotients.
    """
    ring = _Ring(quotient, functions=True)
    try:
        above, below = ring.read_quotient(quotient)
    except sp.PolynomialError:
        # The quotient has roots, say.
        above, below = sp.fraction(sp.cancel(quotient))
        return above, below
    if below.is_zero():
        raise sp.PolynomialError(f"divides by zero: {quotient}")
    common = above.gcd(below)
    (left, above), (right, below) = _take_content(above / common), _take_content(below / common)
    if ring.is_negative(below):
        above, below = -above, -below
    number = left / right
    return number.p * ring.write(above), number.q * ring.write(below)


def factor(quotient: sp.Expr) -> sp.Expr:
    """Cancel and factor a quotient, like SymPy's functions of those names one after the other."""
    (left, above), (right, below) = map(factor_list, cancel(quotient))
    product = sp.Mul(*(f**n for f, n in above), *(f**-n for f, n in below))
    # The number stays in front: SymPy would multiply it into a sum.
    return keep_coefficient(left / right, product)


def _take_content(value: fmpq_mpoly) -> tuple[sp.Rational, fmpq_mpoly]:
    """Return a polynomial as a positive number and a polynomial with coprime integers."""
    coefficients = value.coeffs()
    content = sp.Rational(
        gcd(*(int(c.p) for c in coefficients)), lcm(*(int(c.q) for c in coefficients))
    )
    return content, value / fmpq(content.p, content.q) if content else value


def split(quotient: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Return a quotient's numerator and least common denominator; roots stay as they are."""
    if parts := read_parts(quotient):
        return parts[0].write(), parts[1].write()
    above, below = sp.fraction(sp.together(quotient))
    return above, below


class Polynomial:
    """A polynomial in letters and in names for square roots, its variables in their order."""

    def __init__(self, ring: _Ring, value: fmpq_mpoly, roots: Mapping[sp.Symbol, sp.Pow]) -> None:
        self.variables, self.roots = ring.symbols, roots
        self._ring, self._value = ring, value

    def list_terms(self) -> list[tuple[tuple[int, ...], fmpq]]:
        """List each term's powers of the variables and its coefficient."""
        count = len(self.variables)
        return [(powers[:count], number) for powers, number in self._value.to_dict().items()]

    def evaluate(self, point: Sequence[sp.Rational]) -> fmpq:
        """Return the value at a point, given one number for each variable."""
        return self._value(*(fmpq(int(number.p), int(number.q)) for number in point))

    def write(self) -> sp.Expr:
        """Return it as an expression."""
        return self._ring.write(self._value).xreplace(self.roots)


def read_parts(quotient: sp.Expr) -> tuple[Polynomial, Polynomial] | None:
    """Return numerator and least common denominator as polynomials, or None for other quotients."""
    if quotient.has(sp.pi):
        # SymPy cancels factors next to pi that the ring would keep, such as tangents times cosines.
        return None
    roots = {p: sp.Dummy("root") for p in find_parts(quotient, sp.Pow) if p.exp == sp.S.Half}
    named = replace_parts(quotient, roots | {p**-1: r**-1 for p, r in roots.items()})
    ring = _Ring(named)
    try:
        above, below = ring.read_quotient(named)
    except sp.PolynomialError:
        return None
    back = {r: p for p, r in roots.items()}
    return Polynomial(ring, above, back), Polynomial(ring, below, back)


class _Ring:
    """The polynomials in the symbols of expressions, and in pi, which is transcendental."""

    def __init__(
        self,
        *expressions: sp.Expr,
        relations: Mapping[sp.Pow, sp.Expr] = MappingProxyType({}),
        functions: bool = False,
    ) -> None:
        self.relations = relations
        expressions += (*relations, *relations.values())
        kinds = (type(sp.pi), sp.Function) if functions else (type(sp.pi),)
        symbols = {s for e in expressions for s in (*find_free(e), *find_parts(e, *kinds))}
        if functions:
            powers = {p for e in expressions for p in find_parts(e, sp.Pow)}
            symbols |= {_split_power(p)[0] for p in powers if p.base.is_Add and _is_root(p)}
        # The lexical order makes related generators lead over all those by which they are lowered.
        related = [power.base for power in reversed(relations)]
        others = sorted(symbols - {*related}, key=sp.default_sort_key)
        self.symbols = [*related, *others]
        # A ring of flint's needs at least one generator.
        names = [f"x{n}" for n in range(max(1, len(self.symbols)))]
        self.context = fmpq_mpoly_ctx.get(names, "lex")
        self.generators: dict[sp.Symbol, fmpq_mpoly] = dict(
            zip(self.symbols, self.context.gens(), strict=False)
        )
        # Read once each: a derivative repeats its parts a thousand times.
        self._known: dict[sp.Expr, _Quotient] = {}

    def read(self, node: sp.Expr) -> fmpq_mpoly:
        """Return the polynomial of an expression."""
        if node.is_Rational:
            return self.context.constant(fmpq(int(node.p), int(node.q)))
        if node in self.generators:
            return self.generators[node]
        if isinstance(node, sp.Add | sp.Mul):
            combine = add if node.is_Add else mul
            return reduce(combine, [self.read(argument) for argument in node.args])
        if isinstance(node, sp.Pow) and node.exp.is_Rational and node.exp >= 0:
            base, power = _split_power(node)
            if base != node:
                return self.read(base) ** power
        raise sp.PolynomialError(f"not a polynomial: {node}")

    def read_quotient(self, node: sp.Expr) -> _Quotient:
        """Return numerator and denominator of an expression; the latter may be zero."""
        if node not in self._known:
            self._known[node] = self._read_quotient(node)
        return self._known[node]

    def _read_quotient(self, node: sp.Expr) -> _Quotient:
        one = self.context.constant(1)
        if isinstance(node, sp.Add | sp.Mul):
            combine = _add if node.is_Add else _multiply
            return reduce(combine, [self.read_quotient(argument) for argument in node.args])
        if isinstance(node, sp.Pow) and node.exp.is_Rational:
            base, power = _split_power(node)
            if base != node:
                above, below = (part ** abs(power) for part in self.read_quotient(base))
                return (above, below) if power > 0 else (below, above)
        return self.read(node), one

    def list_generators(self, value: fmpq_mpoly) -> list[sp.Expr]:
        """List the generators that occur, in SymPy's order."""
        degrees = zip(self.symbols, value.degrees(), strict=False)
        return list(sort_generators(symbol for symbol, degree in degrees if degree))

    def to_poly(self, value: fmpq_mpoly, generators: list[sp.Expr]) -> sp.Poly:
        """Return a polynomial of SymPy's in the given generators."""
        order = [self.symbols.index(s) for s in generators]
        terms = value.to_dict().items()
        return sp.Poly.from_dict(
            {tuple(int(powers[n]) for n in order): _to_rational(c) for powers, c in terms},
            *generators,
        )

    def is_negative(self, value: fmpq_mpoly) -> bool:
        """Return whether the leading coefficient is negative, generators in SymPy's order."""
        order = [self.symbols.index(s) for s in self.list_generators(value)]
        terms = value.to_dict()
        return bool(terms[max(terms, key=lambda powers: [powers[n] for n in order])] < 0)

    def lower_all(self, value: fmpq_mpoly) -> fmpq_mpoly:
        """Return the remainder of the division by all relations.

        Later ones come first: they may contain generators of earlier ones.
        """
        for power in reversed(self.relations):
            _, value = divmod(value, self.read(power) - self.read(self.relations[power]))
        return value

    def write(self, value: fmpq_mpoly) -> sp.Expr:
        """Return the expression of a polynomial, expanded."""
        terms = value.to_dict().items()
        return sp.Add(*(self._term(powers, coefficient) for powers, coefficient in terms))

    def _term(self, powers: tuple[int, ...], coefficient: fmpq) -> sp.Expr:
        factors = (s ** int(n) for s, n in zip(self.symbols, powers, strict=False) if n)
        return sp.Mul(_to_rational(coefficient), *factors)


def _split_power(power: sp.Pow) -> tuple[sp.Expr, int]:
    """Write a power as an integer power: of its base, or of a root of the base."""
    exponent = power.exp
    if exponent.is_Integer:
        return power.base, int(exponent)
    if _is_root(power):
        return sp.Pow(power.base, abs(exponent)), int(sp.sign(exponent))
    return power, 1


def _is_root(power: sp.Pow) -> bool:
    """Return whether a power is a root or its reciprocal; SymPy splits other fractional powers."""
    return bool(power.exp.is_Rational and abs(power.exp.p) == 1 and power.exp.q > 1)


def _to_rational(number: fmpq) -> sp.Rational:
    return sp.Rational(int(number.p), int(number.q))


_Quotient = tuple[fmpq_mpoly, fmpq_mpoly]


def _add(one: _Quotient, other: _Quotient) -> _Quotient:
    """Add over the least common denominator."""
    (a, b), (c, d) = one, other
    if b == d:
        return a + c, b
    if b.is_zero() or d.is_zero():
        return a, b * d
    common = b.gcd(d)
    left, right = d / common, b / common
    return a * left + c * right, b * left


def _multiply(one: _Quotient, other: _Quotient) -> _Quotient:
    (a, b), (c, d) = one, other
    return a * c, b * d
